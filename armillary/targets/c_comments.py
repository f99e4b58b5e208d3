"""What the comments of a C header say of arguments and results."""

from __future__ import annotations

from collections.abc import Sequence
from math import prod

from armillary.derivation.quantity import AnyQuantity, Kind, Rate, Role
from armillary.derivation.statements import Kernel, Output
from armillary.derivation.status import Status
from armillary.program.cost import Cost
from armillary.program.guards import index_of_parts
from armillary.program.program import Program
from armillary.program.stages import READY, Stages
from armillary.targets.c_function import must_not_overlap, state_argument
from armillary.targets.c_language import filled

_RATES = {Rate.MOUNT: "held by the mount", Rate.DAY: "each day", Rate.TICK: "each tick"}


def function_comment(program: Program, cost: Cost, others: Sequence[str] = ()) -> list[str]:
    """The Doxygen comment of a kernel; `others` are functions to see too."""
    kernel = program.kernel
    used = program.inputs_used()
    ignored = [q.name for q in kernel.parameters if q.name not in used]
    text = [f"@brief {_summary(kernel)}.", "", f"Cost: {cost}."]
    if kernel.stage == "setup":
        text += [_SETUP]
        text += [_REPEATED] if any(case.status > 0 for case in kernel.cases) else []
    elif must_not_overlap(program):
        text += ["Inputs are read while results are written: they must not overlap."]
    if kernel.parameters:
        text.append("@param[in] p parameters" + _ignored(kernel, ignored))
    if kernel.stage == "step":
        text.append(f"@param[in] ctx what {kernel.whole}_setup left; refused if it is not ready")
    states = {q.name for q in kernel.states}
    if kernel.stateful == "update":
        text.append(
            f"@param[in,out] {state_argument(kernel)} state of the {_words(kernel.controller)}; "
            "untouched where the status is negative"
        )
    for q in kernel.inputs:
        if q.name not in states:
            text.append(f"@param[in] {q.name} {q.facts.meaning}, {facts(q)}; {_rate(q)}")
    text += [
        f"@param[out] {kernel.result_argument(o.name)} {_result_facts(o)}"
        for o in kernel.outputs
        if o.name not in states
    ]
    if kernel.stage == "setup":
        told = "not ready where the status is negative, whatever it held before"
        text.append(f"@param[out] ctx what {kernel.whole}_step reads; {told}")
    if kernel.stateful == "init":
        text.append(
            f"@param[out] {state_argument(kernel)} state of the {_words(kernel.controller)}"
        )
    statuses = [Status.OK, *(c.status for c in kernel.cases)]
    if program.guards or kernel.stage == "step":
        # A step refuses a context that is not ready like a number beyond its limits.
        statuses += [Status.NOT_FINITE, Status.OUT_OF_RANGE]
    names = ", ".join(f"ARMILLARY_{s.name}" for s in dict.fromkeys(statuses))
    text.append(f"@return {names}")
    for case in kernel.cases:
        text.append(f"  {case.status.name}: {case.because}")
    if kernel.stage == "step":
        text.append("  OUT_OF_RANGE: ctx is not ready, or an argument is beyond its limits")
    return _doxygen([*text, *(f"@see {name}" for name in others)])


_SETUP = (
    "Run it again when a parameter or an argument here has changed, and not in an interrupt of a "
    "step on the same ctx."
)
_REPEATED = "A status above 0 leaves a ctx that is ready; its steps repeat the status."


def context_comment(stages: Stages) -> list[str]:
    """The Doxygen comment of what a set-up hands over."""
    whole, count = stages.setup.kernel.whole, sum(prod(f.shape) for f in stages.fields)
    named = dict.fromkeys(i for made in stages.fields for i in made.identifiers)
    size = f"{count} number{'' if count == 1 else 's'}"
    text = [f"@brief What {whole}_setup hands to {whole}_step: {size}."]
    text.append(
        "Its fields may change from version to version: do not store or send it, and set it up "
        "again after recompiling. No argument and no result may lie in it."
    )
    text.append(
        f"{READY} is 0 from the beginning of {whole}_setup and a mark from its end, if it did not "
        f"refuse. Without the mark {whole}_step answers ARMILLARY_OUT_OF_RANGE and writes nothing: "
        "a machine does not go on with a mount that was never told, or that was told wrong."
    )
    if named:
        text.append(f"It holds {', '.join(named)}.")
    return _doxygen(text)


def field_text(quantity: AnyQuantity) -> str:
    """What a field of a struct is, and its rate where that is not the mount's."""
    meaning = quantity.facts.meaning
    text = f"{meaning[:1].upper()}{meaning[1:]}, {facts(quantity)}"
    moves = quantity.facts.role is Role.PARAMETER and quantity.facts.rate is not Rate.MOUNT
    return comment(f"{text}; {_rate(quantity)}." if moves else f"{text}.")


def _rate(quantity: AnyQuantity) -> str:
    """How often a quantity changes."""
    return _RATES[quantity.facts.rate]


def _summary(kernel: Kernel) -> str:
    summary = (kernel.summary or kernel.name.replace("_", " ")).rstrip(".")
    if kernel.stage == "setup":
        return f"Set-up of {kernel.whole}: all of it that changes with the mount only"
    return f"Step of {kernel.whole}. {summary}" if kernel.stage else summary


def _doxygen(text: list[str]) -> list[str]:
    lines = ["/**"]
    for line in text:
        wrapped = filled(comment(line), "", "    ", 94) or [""]
        lines += [f" * {w}".rstrip() for w in wrapped]
    return [*lines, " */"]


def comment(text: str) -> str:
    """Text that neither ends nor opens a comment."""
    return text.replace("*/", "* /").replace("/*", "/ *")


def _result_facts(output: Output) -> str:
    """Meaning, shape, unit and id of a result."""
    definition = output.definition
    text = (definition.meaning if definition else "") or output.name
    if output.indices:
        text += f", for each {' and '.join(_words(index.name) for index in output.indices)}"
    if len(output.shape) > 1:
        text += f", {' by '.join(map(str, output.shape))}, row-major"
    if output.unit and str(output.unit) != "1":
        text += f", {output.unit}"
    return text + (f" ({definition.identifier})" if definition else "")


def _ignored(kernel: Kernel, ignored: list[str]) -> str:
    if not ignored:
        return ""
    if len(ignored) == len(kernel.parameters):
        return "; none of them is read"
    return f"; not read: {', '.join(ignored)}"


def facts(quantity: AnyQuantity) -> str:
    """Unit, bounds and range of a quantity."""
    low, high = quantity.facts.limits
    if quantity.facts.kind is Kind.UNIT_VECTOR:
        return "unit vector; refused when its square is off by more than 1e-3"
    if quantity.facts.kind is Kind.ROTATION:
        return (
            "rotation matrix, 3 by 3, row-major; refused when a column's square or the dot product "
            "of two columns is off by more than 1e-3, or its determinant is negative"
        )
    worked = quantity.facts.range
    unit = str(quantity.unit)
    index = index_of_parts(quantity)
    each = f"for each {_words(index.name)}, " if index else ""
    return (
        f"{each}{'' if unit == '1' else unit + ', '}refused outside [{low:g}, {high:g}], "
        f"working range [{worked[0]:g}, {worked[1]:g}]"
    )


def _words(name: str) -> str:
    return name.replace("_", " ")
