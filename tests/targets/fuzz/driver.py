"""Writes the C program that calls every printed kernel with random inputs."""

from math import prod
from pathlib import Path

import numpy as np

from armillary.derivation.quantity import Kind
from armillary.targets.c_function import must_not_overlap
from tests.targets.conftest import Printed

HARNESS = Path(__file__).parent
_REAL = {
    "f32": ("float", "nextafterf", "FLT_MAX", "1.40129846e-45f", np.float32),
    "f64": ("double", "nextafter", "DBL_MAX", "4.9406564584124654e-324", np.float64),
}
GUARDS = (-1, -2)
MOST = 250


def driver_source(printed: Printed, precision: str, kernels: list[tuple[str, str]]) -> str:
    """One translation unit: kernels in one precision, a table of them, and a main."""
    real, step, largest, smallest, _ = _REAL[precision]
    lines = [
        f"#define REAL {real}",
        f"#define NEXT {step}",
        f"#define LARGEST {largest}",
        f"#define SMALLEST {smallest}",
        f'#include "{HARNESS / "harness.h"}"',
        *(f'#include "{system}_{name}_{precision}.c"' for system, name in kernels),
    ]
    rows = []
    systems = printed.module("_signatures").SYSTEMS
    for system, name in kernels:
        facts = systems[system]
        written, row = _kernel(printed, system, name, facts, precision)
        lines += written
        rows.append(row)
    lines += ["static const struct kernel KERNELS[] = {", *rows, "};"]
    lines += [
        "int main(int argc, char **argv)",
        "{",
        f'  return run_all(KERNELS, {len(rows)}, argc > 1 ? argv[1] : "1000");',
        "}",
    ]
    return "\n".join(lines) + "\n"


def _kernel(printed, system, name, facts, precision):
    real, dtype = _REAL[precision][0], _REAL[precision][4]
    program = printed.compiled[system, name].program
    record, kernel = program.kernel, facts["kernels"][name]
    known = {q.name: q for q in (*record.inputs, *record.parameters)}
    symbol = f"{printed.target.c_prefix}{system}_{name}_{precision}"
    shapes, states = dict(facts["parameters"]), dict(kernel.get("states", []))
    read = [*kernel["inputs"], *((q, shapes[q]) for q in kernel["reads"])]
    place, setting, arguments, answer = 0, [], [], []
    for k, (q, shape) in enumerate(read):
        given = k < len(kernel["inputs"])
        if given and q not in states:
            arguments.append(f"in + {place}" if shape else f"in[{place}]")
        else:
            struct = "state" if given else "p"
            setting.append(f"  memcpy(&{struct}.{q}, in + {place}, {prod(shape)} * sizeof *in);")
        place += prod(shape)
    outputs = 0
    for q, shape in kernel["results"]:
        if q in states:
            answer.append(f"  memcpy(out + {outputs}, &state.{q}, {prod(shape)} * sizeof *out);")
        else:
            arguments.append(f"out + {outputs}")
        outputs += prod(shape)
    if states:
        first = kernel["stateful"] == "update"
        struct = f"{printed.target.c_prefix}{system}_{kernel['controller']}_state_{precision}"
        setting = [f"  {struct} state, before;", "  memset(&state, 0xFF, sizeof state);", *setting]
        setting.append("  memcpy(&before, &state, sizeof state);")
        arguments.insert(0 if first else len(arguments), "&state")
    if facts["parameters"]:
        # What is not read is NaN, so that reading it would show.
        struct = f"{printed.target.c_prefix}{system}_params_{precision}"
        setting = [f"  {struct} p;", "  memset(&p, 0xFF, sizeof p);", *setting]
        arguments.insert(0, "&p")
    assert max(place, outputs) < MOST, f"{symbol} is larger than the harness's arrays"
    table = [_quantity(known[q], prod(shape), dtype) for q, shape in read]
    lines = [
        f"static int call_{symbol}(const {real} *in, {real} *out)",
        "{",
        "  (void)in;",
        *setting,
        f"  const int status = {symbol}({', '.join(arguments)});",
        *(_kept(answer) if states else []),
        "  return status;",
        "}",
    ]
    if table:
        lines += [f"static const struct quantity of_{symbol}[] = {{", *table, "};"]
    allowed = _allowed(record, guarded=bool(read))
    of = f"of_{symbol}" if table else "NULL"
    apart = int(must_not_overlap(program))
    row = f'  {{"{symbol}", {of}, {len(table)}, {place}, {outputs}, {apart}, '
    return lines, f"{row}{allowed}u, call_{symbol}}},"


def _kept(answer):
    """A state is written if the other results are; 99 is a status that no kernel declares."""
    return [
        "  if (status < 0) {",
        "    return memcmp(&before, &state, sizeof state) == 0 ? status : 99;",
        "  }",
        *answer,
    ]


def _allowed(kernel, guarded):
    """The statuses that a kernel declares, as bits."""
    statuses = {0, *(int(c.status) for c in kernel.cases)} | set(GUARDS if guarded else ())
    return sum(1 << (s + 8) for s in statuses)


def _quantity(quantity, size, dtype):
    unit = int(quantity.facts.kind in (Kind.UNIT_VECTOR, Kind.ROTATION))
    bounds = [*quantity.facts.limits, *quantity.facts.range]
    numbers = ", ".join(f"(REAL){float(dtype(x)).hex()}" for x in bounds)
    return f'  {{"{quantity.name}", {size}, {unit}, {numbers}}},'
