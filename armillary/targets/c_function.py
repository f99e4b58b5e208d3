"""The body of one C function: loads, guards, arithmetic, statuses, stores."""

from __future__ import annotations

from collections.abc import Iterator

from armillary.algebra.index import Index
from armillary.derivation.quantity import AnyQuantity
from armillary.derivation.statements import Kernel
from armillary.derivation.status import Status
from armillary.program.guards import index_of_parts
from armillary.program.program import Field, Program
from armillary.program.stages import READY
from armillary.targets.body import Body, unused, write_body
from armillary.targets.c_guards import Test, form_line, guard_loops, refusal
from armillary.targets.c_language import WIDTH, C
from armillary.targets.language import Assignment


def function_body(program: Program, language: C, mark: str = "") -> list[str]:
    """The lines between a function's braces.

    Inputs are read before anything is written, so that a call in place is legal; only arrays that
    run over an index are read where they are used.

    Args:
        mark: of a set-up and its step, what a context that is ready bears.
    """
    return _Function(program, language, mark).write()


def must_not_overlap(program: Program) -> bool:
    """Whether a kernel may still read an input when it has written a result."""
    states = {q.name for q in program.kernel.states}
    return any(index_of_parts(q) and q.name not in states for q in _read(program))


def state_argument(kernel: Kernel) -> str:
    """The name of the pointer to a controller's state."""
    return unused("s", {*kernel.argument_names(), *(o.name for o in kernel.outputs)})


def _is_late(program: Program) -> bool:
    """Whether results are written only when the status is known, or no state is read any more."""
    return bool(program.kernel.stateful) or any(status < 0 for status, _ in program.cases)


def _read(program: Program) -> list[AnyQuantity]:
    """What is read, to compute with or to guard it."""
    used, kernel = program.inputs_used(), program.kernel
    guarded = {g.name for g in program.guards}
    fields = [q for q in kernel.parameters if q.name in used]
    return [*fields, *(q for q in kernel.inputs if q.name in used or q.name in guarded)]


class _Function:
    def __init__(self, program: Program, language: C, mark: str) -> None:
        self.program, self.c, self.kernel = program, language, program.kernel
        self.mark = mark
        kernel = program.kernel
        self.states = {q.name for q in kernel.states}
        self.state = state_argument(kernel) if kernel.stateful else ""
        taken = {*kernel.argument_names(), "p", "status", self.state}
        taken |= {"ctx", *(f.name for f in program.fields)}
        self.taken = taken | {kernel.result_argument(o.name) for o in kernel.outputs}
        self.read = _read(program)
        self.places = {q.name: self.place(q) for q in (*kernel.inputs, *kernel.parameters)}

    def place(self, q: AnyQuantity) -> str:
        """Where the caller keeps a quantity."""
        if q in self.kernel.parameters:
            return f"p->{q.name}"
        return f"{self.state}->{q.name}" if q.name in self.states else q.name

    def write(self) -> list[str]:
        tests, forms = self.tests()
        lines = [f"ctx->{READY} = 0;"] if self.kernel.stage == "setup" else []
        lines += [line for q in self.read for line in self.load(q)]
        lines += [line for made in self.program.fields for line in self.handed(made)]
        lines += forms
        lines += [f"int status = {self.status()};"]
        kernel, used = self.kernel, self.program.inputs_used()
        if kernel.parameters and not any(q.name in used for q in kernel.parameters):
            lines += ["(void)p;"]
        loops = guard_loops(self.read, self.program.guards, self.places, self.variables(), self.c)
        if loops:
            lines += ["", *loops]
        lines = [f"  {line}" if line else "" for line in lines]
        refused = bool(loops) or self.kernel.stage == "step"
        if not tests and not refused:
            return [*lines, *(f"  {line}" for line in self.computation()), "  return status;"]
        if tests:
            slow = refusal(tests, 2, first=not refused)
            lines += ["", *(f"  {line}" for line in slow)]
        if refused:
            lines += ["  }"] if tests else []
            lines += ["  if (status == ARMILLARY_OK) {"]
        else:
            lines += ["  } else {"]
        lines += [f"    {line}" for line in self.computation()]
        return [*lines, "  }", "  return status;"]

    def status(self) -> str:
        """The status before any test; that of a step whose context is not ready is the lowest."""
        if self.kernel.stage != "step":
            return "ARMILLARY_OK"
        return f"(ctx->{READY} == {self.mark}) ? ARMILLARY_OK : ARMILLARY_OUT_OF_RANGE"

    def variables(self) -> dict[Index, str]:
        """The loop variables of the guards."""
        found = [index_of_parts(q) for q in self.read]
        return {i: unused(i.name, self.taken) for i in found if i is not None}

    def tests(self) -> tuple[list[Test], list[str]]:
        """The tests of what runs over no index, and the lines of the forms among them."""
        parts = {q.name: q.parts for q in self.read if not index_of_parts(q)}
        tests, lines = [], []
        for guard in self.program.guards:
            if guard.name not in parts:
                continue
            local = parts[guard.name][guard.index or 0]
            if guard.form is not None:
                local = unused(f"{guard.name}_{guard.form.label}", self.taken)
                self.taken.add(local)
                lines += form_line(local, guard.form, parts[guard.name], self.c)
            tests.append(Test(guard, local, self.c))
        return tests, lines

    def load(self, q: AnyQuantity) -> list[str]:
        """A quantity as constants of the function, where it is not one already."""
        place = self.places[q.name]
        if index_of_parts(q) or (place == q.name and not q.shape):
            return []
        if not q.shape:
            return [f"const {self.c.type} {q.name} = {place};"]
        return [f"const {self.c.type} {part} = {place}[{k}];" for k, part in enumerate(q.parts)]

    def handed(self, made: Field) -> list[str]:
        """A number that the set-up handed over; its arrays are read where they are used."""
        if made.index is not None:
            return []
        return [f"const {'int' if made.condition else self.c.type} {made.name} = ctx->{made.name};"]

    def computation(self) -> Iterator[str]:
        """The lines behind the guards."""
        program, kernel, room = self.program, self.kernel, WIDTH - 6
        stored = {r.name: self.result(r.name) for r in program.results if r.indices}
        arrays = [q for q in kernel.states if index_of_parts(q) and q in kernel.inputs]
        used = program.inputs_used()
        copies = {q.name: q.name for q in arrays if q.name in used}
        yield from self.copied(copies)
        body = write_body(
            program,
            self.c,
            frozenset(self.taken),
            arrays=self.places | copies | {f.name: f"ctx->{f.name}" for f in program.fields},
            stored=stored,
            late=_is_late(program),
        )
        yield from self.c.lines(body.statements, room)
        order = sorted(body.cases, key=lambda case: (case[0] < 0, abs(case[0])))
        for status, condition in order:
            yield from (f"if ({condition}) {{", f"  status = ARMILLARY_{Status(status).name};", "}")
        stores = self.stores(body, room)
        if self.kernel.stage == "setup":
            stores += [f"ctx->{READY} = {self.mark};"]
        if any(status < 0 for status, _ in body.cases):
            yield from ("if (status >= 0) {", *(f"  {line}" for line in stores), "}")
        else:
            yield from stores

    def copied(self, copies: dict[str, str]) -> Iterator[str]:
        """States that run over an index, as they were before any of them is written."""
        for index, variable in self.variables().items():
            states = [q for q in self.read if q.name in copies and index_of_parts(q) == index]
            for q in states:
                yield f"{self.c.type} {copies[q.name]}[{index.size}];"
            if states:
                yield f"for (int {variable} = 0; {variable} < {index.size}; ++{variable}) {{"
                for q in states:
                    place = f"[{variable}]"
                    yield f"  {copies[q.name]}{place} = {self.places[q.name]}{place};"
                yield "}"

    def result(self, name: str) -> str:
        """Where the caller wants a result."""
        if self.kernel.stage == "setup":
            return f"ctx->{name}"
        if self.kernel.stateful and name in self.states:
            return f"{self.state}->{name}"
        return self.kernel.result_argument(name)

    def stores(self, body: Body, room: int) -> list[str]:
        """What is written when everything is computed."""
        lines: list[str] = []
        for result, entries in zip(self.program.results, body.results, strict=True):
            for k, text in enumerate(entries):
                name = self.result(result.name)
                pointed = result.shape or "->" in name
                place = f"{name}[{k}]" if result.shape else name if pointed else f"*{name}"
                lines += self.c.lines([Assignment(place, text)], room)
        return [*lines, *self.c.lines(body.stores, room - 2)]
