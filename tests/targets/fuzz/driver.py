"""Writes the C program that calls every printed kernel with random inputs."""

from math import prod
from pathlib import Path

import numpy as np

from armillary.derivation.quantity import Kind
from armillary.targets.c_function import must_not_overlap
from armillary.verify.points import random_points
from tests.targets.conftest import Printed

HARNESS = Path(__file__).parent
_REAL = {
    "f32": ("float", "nextafterf", "FLT_MAX", "1.40129846e-45f", np.float32),
    "f64": ("double", "nextafter", "DBL_MAX", "4.9406564584124654e-324", np.float64),
}
GUARDS = (-1, -2)
MOST = 250
FITTING = 200
MOUNTS = 8  # of those, to set up with where one must be accepted


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
        if (system, name) in printed.stages:
            lines.append(f'#include "{system}_{name}_step_{precision}.c"')
            written, row = stages_row(printed, system, name, facts, precision)
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
    table = [_quantity(known[q], prod(shape), dtype) for q, shape in read]
    fitting = _fitting(record, read, dtype)
    return _with_row(lines, symbol, table, place, outputs, program, fitting)


def _fitting(kernel, read, dtype):
    """Inputs that fit together, a row of C a point, where the kernel says what they are."""
    if not kernel.drawn:
        return []
    points = random_points(kernel, FITTING, seed=9)
    rows = np.concatenate([points[q].reshape(FITTING, -1) for q, _ in read], axis=1)
    return ["  " + ", ".join(f"(REAL){float(x).hex()}" for x in row) + ","
            for row in rows.astype(dtype)]  # fmt: skip


def _with_row(lines, symbol, table, place, outputs, program, fitting):
    """Lines with the tables of a function's quantities and of inputs that fit, and its row."""
    if table:
        lines = [*lines, f"static const struct quantity of_{symbol}[] = {{", *table, "};"]
    if fitting:
        lines = [*lines, f"static const REAL drawn_{symbol}[] = {{", *fitting, "};"]
    drawn = f"drawn_{symbol}" if fitting else "NULL"
    allowed = _allowed(program.kernel, guarded=bool(table))
    of = f"of_{symbol}" if table else "NULL"
    apart = int(must_not_overlap(program))
    row = f'  {{"{symbol}", {of}, {len(table)}, {place}, {outputs}, {apart}, '
    return lines, f"{row}{allowed}u, call_{symbol}, {drawn}, {len(fitting)}}},"


def stages_row(printed, system, name, facts, precision):
    """A set-up and a step, called as one function that refuses what either refuses.

    Where the set-up refuses, the step answers from the context of a legal mount, into nothing: of
    what it says only its refusal counts. A context that is not ready must be refused, whether it
    was never set up or no longer is: 97 where it is not, 99 where more of it was touched.
    """
    real, dtype = _REAL[precision][0], _REAL[precision][4]
    program, kernel = printed.compiled[system, name].program, facts["kernels"][name]
    record, shapes = program.kernel, dict(facts["parameters"])
    known = {q.name: q for q in (*record.inputs, *record.parameters)}
    read = [*kernel["inputs"], *((q, shapes[q]) for q in kernel["reads"])]
    places, place = {}, 0
    for q, shape in read:
        places[q], place = (place, shape), place + prod(shape)
    outputs = sum(prod(shape) for _, shape in kernel["results"])
    whole = f"{printed.target.c_prefix}{system}_{name}"
    symbol, context = f"{whole}_step_{precision}", f"{whole}_ctx_{precision}"
    struct = f"{printed.target.c_prefix}{system}_params_{precision}" if shapes else ""
    setup, step = kernel["stages"]["setup"], kernel["stages"]["step"]
    fitting = _fitting(record, read, dtype)
    legal = [", ".join(_legal(known[q], prod(s), places[q][0]) for q, s in read) or "0"]
    if fitting:  # the middles of the ranges need not fit together
        legal = [row.strip(" ,") for row in fitting[:MOUNTS]]
    lines = [
        *_stage(f"{whole}_setup_{precision}", setup, struct, places, real, f"{context} *ctx"),
        *_stage(symbol, step, struct, places, real, f"const {context} *ctx", kernel["results"]),
        *_refused(symbol, real, context, outputs),
        f"static int call_{symbol}(const {real} *in, {real} *out)",
        "{",
        f"  static const {real} legal[][{max(place, 1)}] = {{",
        *(f"    {{{row}}}," for row in legal),
        "  };",
        "  size_t mount = 0;",
        f"  {context} ctx, before;",
        "  memset(&ctx, 0, sizeof ctx);",
        f"  if (!refused_{symbol}(in, &ctx)) {{ return 97; }}",
        "  memset(&ctx, 0xFF, sizeof ctx);",
        f"  if (!refused_{symbol}(in, &ctx)) {{ return 97; }}",
        "  memcpy(&before, &ctx, sizeof ctx);",
        "  before.ready = 0;",
        f"  const int first = run_{whole}_setup_{precision}(in, &ctx, NULL);",
        f"  if (first >= 0) {{ return run_{symbol}(in, &ctx, out); }}",
        "  if (memcmp(&before, &ctx, sizeof ctx) != 0) { return 99; }",
        f"  while (run_{whole}_setup_{precision}(legal[mount], &ctx, NULL) < 0) {{",
        f"    if (++mount == {len(legal)}) {{ return 98; }}",
        "  }",
        f"  {real} nowhere[{max(outputs, 1)}];",
        f"  const int second = run_{symbol}(in, &ctx, nowhere);",
        f"  if (run_{whole}_setup_{precision}(in, &ctx, NULL) != first) {{ return 96; }}",
        f"  if (!refused_{symbol}(in, &ctx)) {{ return 97; }}",
        "  if (second != -1 && second != -2) { return first; }",
        "  return second < first || first < -2 ? second : first;",
        "}",
    ]
    table = [_quantity(known[q], prod(shape), dtype) for q, shape in read]
    apart = printed.stages[system, name].step
    lines, row = _with_row(lines, symbol, table, place, outputs, program, fitting)
    assert must_not_overlap(apart) <= must_not_overlap(program)
    return lines, row


def _stage(symbol, facts, struct, places, real, context, results=()):
    """A function that takes a stage's arguments from where the whole kernel has them."""
    arguments = [
        f"in + {p}" if s else f"in[{p}]" for p, s in (places[q] for q, _ in facts["inputs"])
    ]
    made, place = ["  (void)in; (void)out;"], 0
    is_setup = not context.startswith("const")
    if struct and (is_setup or facts["reads"]):
        made += [f"  {struct} p;", "  memset(&p, 0xFF, sizeof p);"]
        for q in facts["reads"]:
            at, shape = places[q]
            made.append(f"  memcpy(&p.{q}, in + {at}, {prod(shape)} * sizeof *in);")
    for _, shape in results:
        arguments.append(f"out + {place}")
        place += prod(shape)
    arguments = [*arguments, "ctx"] if is_setup else ["ctx", *arguments]
    if len(made) > 1:
        arguments.insert(0, "&p")
    head = f"static int run_{symbol}(const {real} *in, {context}, {real} *out)"
    return [head, "{", *made, f"  return {symbol}({', '.join(arguments)});", "}"]


def _refused(symbol, real, context, outputs):
    """A function that tells whether a step refuses a context and leaves the outputs alone."""
    size = max(outputs, 1)
    return [
        f"static int refused_{symbol}(const {real} *in, const {context} *ctx)",
        "{",
        f"  {real} out[{size}], before[{size}];",
        "  memset(out, CANARY, sizeof out);",
        "  memset(before, CANARY, sizeof before);",
        f"  return run_{symbol}(in, ctx, out) == -2 && memcmp(before, out, sizeof out) == 0;",
        "}",
    ]


def _legal(quantity, size, place):
    """A value that is accepted; no two are alike, so that no two points coincide."""
    if quantity.facts.kind is Kind.UNIT_VECTOR:
        return "(REAL)0.48, (REAL)0.6, (REAL)0.64"
    if quantity.facts.kind is Kind.ROTATION:
        return "1, 0, 0, 0, 1, 0, 0, 0, 1"
    low, high = map(float, quantity.facts.range)
    parts = [0.4 + 0.2 * ((place + k) * 0.618 % 1) for k in range(size)]
    return ", ".join(f"(REAL){(low + (high - low) * part).hex()}" for part in parts)


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
