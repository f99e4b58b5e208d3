"""The C around the kernels: each called over a batch, with an array for each argument."""

from collections.abc import Iterator
from math import prod
from typing import Any

from ._signatures import PRECISIONS, PREFIX, SYSTEMS

TYPES = {"f32": "float", "f64": "double"}


def batch_source() -> str:
    """C that calls each kernel over a batch; a step of 0 repeats one value.

    Where the status is negative the results are NaN, but a state that is kept in place is left as
    it was.
    """
    lines = _includes()
    for system, name, facts, precision in _each():
        lines += _function(system, name, facts, precision)
    return "\n".join(lines) + "\n"


def stages_source() -> str:
    """C that runs each set-up, and each step over a batch.

    What a set-up leaves is passed on without its type, and a function tells its size.
    """
    lines = _includes()
    for system, name, facts, precision in _each():
        if "stages" in facts:
            lines += _setup(system, name, facts["stages"]["setup"], precision)
            lines += _function(system, name, facts["stages"]["step"], precision, "_step")
    return "\n".join(lines) + "\n"


def stages_files() -> set[str]:
    """The files that set-ups and steps are in."""
    return {f"{s}_{name}_step_{p}.c" for s, name, facts, p in _each() if "stages" in facts}


def _each() -> Iterator[tuple[str, str, Any, str]]:
    for system, facts in SYSTEMS.items():
        for name, kernel in facts["kernels"].items():
            for precision in PRECISIONS:
                yield system, name, kernel, precision


def _includes() -> list[str]:
    lines = ["#include <float.h>", "#include <math.h>", "#include <stddef.h>"]
    return [*lines, *(f'#include "{system}.h"' for system in SYSTEMS)]


def _function(system: str, name: str, facts: Any, precision: str, stage: str = "") -> list[str]:
    kind = TYPES[precision]
    symbol = f"{system}_{name}{stage}_{precision}"
    given = "const void *ctx, " if stage else ""
    head = f"void batch_{symbol}({given}size_t n, const {kind} *const *in, const size_t *step,"
    rest = f"                    {kind} *const *out, signed char *status)"
    lines = [head, f"{rest};", head, rest, "{", "  (void)in; (void)step; (void)out;"]
    lines += ["  for (size_t i = 0; i < n; i++) {"]
    states = dict(facts.get("states", []))
    call = []
    if SYSTEMS[system]["parameters"] and (facts["reads"] or not stage):
        lines += _parameters(system, facts, precision)
        call.append("&p")
    if stage:
        call.append(f"(const {PREFIX}{system}_{name}_ctx_{precision} *)ctx")
    if states:
        lines.append(f"    {PREFIX}{system}_{facts['controller']}_state_{precision} state = {{0}};")
    if facts.get("stateful") == "update":
        call.append("&state")
    for k, (q, shape) in enumerate(facts["inputs"]):
        where = f"in[{k}] + (i * step[{k}])"
        if q in states:
            lines += _copied("state", q, shape, where)
        else:
            call.append(where if shape else f"*({where})")
    for k, (q, shape) in enumerate(facts["results"]):
        if q not in states:
            call.append(f"out[{k}] + (i * {prod(shape)})")
    if facts.get("stateful") == "init":
        call.append("&state")
    lines.append(f"    const int answer = {PREFIX}{symbol}({', '.join(call)});")
    lines += _answer(facts, states)
    return [*lines, "    status[i] = (signed char)answer;", "  }", "}"]


def _setup(system: str, name: str, facts: Any, precision: str) -> list[str]:
    """The set-up of one mount, and the size of what it leaves."""
    kind, symbol = TYPES[precision], f"{system}_{name}_setup_{precision}"
    context = f"{PREFIX}{system}_{name}_ctx_{precision}"
    size, head = (
        f"size_t size_{symbol}(void)",
        f"int one_{symbol}(const {kind} *const *in, void *ctx)",
    )
    lines = [f"{size};", f"{size} {{ return sizeof({context}); }}", f"{head};", head, "{"]
    lines += ["  (void)in;"]
    call = []
    if SYSTEMS[system]["parameters"]:
        lines += _parameters(system, facts, precision, batch=False)
        call.append("&p")
    call += [f"in[{k}]" if shape else f"*in[{k}]" for k, (_, shape) in enumerate(facts["inputs"])]
    call.append(f"({context} *)ctx")
    return [*lines, f"  return {PREFIX}{symbol}({', '.join(call)});", "}"]


def _parameters(system: str, facts: Any, precision: str, batch: bool = True) -> list[str]:
    lines = [f"    {PREFIX}{system}_params_{precision} p = {{0}};"]
    shapes = dict(SYSTEMS[system]["parameters"])
    for k, field in enumerate(facts["reads"], len(facts["inputs"])):
        where = f"in[{k}] + (i * step[{k}])" if batch else f"in[{k}]"
        lines += _copied("p", field, shapes[field], where)
    return lines


def _copied(struct: str, field: str, shape: tuple[int, ...], where: str) -> list[str]:
    """A field of a struct, taken from an array."""
    if not shape:
        return [f"    {struct}.{field} = ({where})[0];"]
    return [f"    {struct}.{field}[{c}] = ({where})[{c}];" for c in range(prod(shape))]


def _answer(facts: Any, states: dict[str, Any]) -> list[str]:
    """NaN for results that were not written, and the new state for those that were."""
    places = {q: k for k, (q, _) in enumerate(facts["inputs"])}
    clear, keep = [], []
    for k, (q, shape) in enumerate(facts["results"]):
        size = prod(shape)
        filled = f"for (int k = 0; k < {size}; k++) {{ out[{k}][(i * {size}) + k] = NAN; }}"
        if q in states and q in places:
            filled = f"if (out[{k}] != in[{places[q]}]) {{ {filled} }}"
        clear.append(f"      {filled}")
        for c in range(size if q in states else 0):
            field = f"state.{q}[{c}]" if shape else f"state.{q}"
            keep.append(f"      out[{k}][(i * {size}) + {c}] = {field};")
    lines = ["    if (answer < 0) {", *clear, "    }"]
    return [*lines[:-1], "    } else {", *keep, "    }"] if keep else lines
