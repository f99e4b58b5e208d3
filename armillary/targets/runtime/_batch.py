"""The C around the kernels: each called over a batch, with an array for each argument."""

from math import prod
from typing import Any

from ._signatures import PRECISIONS, PREFIX, SYSTEMS

TYPES = {"f32": "float", "f64": "double"}


def batch_source() -> str:
    """C that calls each kernel over a batch; a step of 0 repeats one value.

    Where the status is negative the results are NaN, but a state that is kept in place is left as
    it was.
    """
    lines = ["#include <float.h>", "#include <math.h>", "#include <stddef.h>"]
    lines += [f'#include "{system}.h"' for system in SYSTEMS]
    for system, facts in SYSTEMS.items():
        for name in facts["kernels"]:
            for precision in PRECISIONS:
                lines += _function(system, name, precision)
    return "\n".join(lines) + "\n"


def _function(system: str, name: str, precision: str) -> list[str]:
    facts = SYSTEMS[system]["kernels"][name]
    kind = TYPES[precision]
    symbol = f"{system}_{name}_{precision}"
    head = f"void batch_{symbol}(size_t n, const {kind} *const *in, const size_t *step,"
    rest = f"                    {kind} *const *out, signed char *status)"
    lines = [head, f"{rest};", head, rest, "{", "  (void)in; (void)step; (void)out;"]
    lines += ["  for (size_t i = 0; i < n; i++) {"]
    states = dict(facts.get("states", []))
    call = []
    if SYSTEMS[system]["parameters"]:
        lines += _parameters(system, facts, precision)
        call.append("&p")
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


def _parameters(system: str, facts: Any, precision: str) -> list[str]:
    lines = [f"    {PREFIX}{system}_params_{precision} p = {{0}};"]
    shapes = dict(SYSTEMS[system]["parameters"])
    for k, field in enumerate(facts["reads"], len(facts["inputs"])):
        lines += _copied("p", field, shapes[field], f"in[{k}] + (i * step[{k}])")
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
