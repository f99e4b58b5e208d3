"""Writes the C program that calls every printed kernel with random inputs."""

from pathlib import Path

import numpy as np

from armillary.derivation.quantity import Kind
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
        kernel, parameters = facts["kernels"][name], facts["parameters"]
        written, row = _kernel(printed, system, name, kernel, parameters, precision)
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


def _kernel(printed, system, name, facts, parameters, precision):
    real, dtype = _REAL[precision][0], _REAL[precision][4]
    record = printed.records[system].kernels[name]
    known = {q.name: q for q in (*record.inputs, *record.parameters)}
    symbol = f"{printed.target.c_prefix}{system}_{name}_{precision}"
    sizes = dict(parameters)
    read = [*facts["inputs"], *((q, sizes[q]) for q in facts["reads"])]
    place, setting, arguments = 0, [], []
    for k, (q, size) in enumerate(read):
        if k < len(facts["inputs"]):
            arguments.append(f"in + {place}" if size > 1 else f"in[{place}]")
        else:
            setting.append(f"  memcpy(&p.{q}, in + {place}, {size} * sizeof *in);")
        place += size
    if parameters:
        # What is not read is NaN, so that reading it would show.
        struct = f"{printed.target.c_prefix}{system}_params_{precision}"
        setting = [f"  {struct} p;", "  memset(&p, 0xFF, sizeof p);", *setting]
        arguments.insert(0, "&p")
    outputs = 0
    for _, shape in facts["results"]:
        arguments.append(f"out + {outputs}")
        outputs += int(np.prod(shape, dtype=int))
    assert max(place, outputs) < MOST, f"{symbol} is larger than the harness's arrays"
    table = [_quantity(known[q], size, dtype) for q, size in read]
    lines = [
        f"static int call_{symbol}(const {real} *in, {real} *out)",
        "{",
        "  (void)in;",
        *setting,
        f"  return {symbol}({', '.join(arguments)});",
        "}",
    ]
    if table:
        lines += [f"static const struct quantity of_{symbol}[] = {{", *table, "};"]
    allowed = _allowed(record, guarded=bool(read))
    of = f"of_{symbol}" if table else "NULL"
    row = f'  {{"{symbol}", {of}, {len(table)}, {place}, {outputs}, {allowed}u, call_{symbol}}},'
    return lines, row


def _allowed(kernel, guarded):
    """The statuses that a kernel declares, as bits."""
    statuses = {0, *(int(c.status) for c in kernel.cases)} | set(GUARDS if guarded else ())
    return sum(1 << (s + 8) for s in statuses)


def _quantity(quantity, size, dtype):
    unit = int(quantity.facts.kind in (Kind.UNIT_VECTOR, Kind.ROTATION))
    bounds = [*quantity.facts.limits, *quantity.facts.range]
    numbers = ", ".join(f"(REAL){float(dtype(x)).hex()}" for x in bounds)
    return f'  {{"{quantity.name}", {size}, {unit}, {numbers}}},'
