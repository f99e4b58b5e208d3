"""Loops built by hand, in C: the evaluator's values in both precisions, and what is printed."""

import ctypes
import re
from dataclasses import replace

import numpy as np
import pytest

from armillary.program.arithmetic import Reals
from armillary.program.cost import cost
from armillary.program.evaluate import evaluate
from armillary.program.program import results_length
from armillary.targets.c import CKernel, CTarget, header_file, source_file, status_header
from tests.loops import POINT, PROGRAMS, Hand, at_random, leg, lengths, program_of, turn, x
from tests.programs import exact
from tests.targets.compilers import WARNINGS, needs, run

TARGET = CTarget("armillary", "", ("f32", "f64"), "0.1.0")
SANITIZERS = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-static-libasan"]
KINDS = {"f32": (np.float32, ctypes.c_float), "f64": (np.float64, ctypes.c_double)}
NAMES = [*PROGRAMS, *(f"random_{seed}" for seed in range(20))]


def named(name):
    """A program under a kernel name of its own."""
    program = at_random(int(name[7:])) if name.startswith("random_") else PROGRAMS[name]()
    return replace(program, kernel=replace(program.kernel, name=name))


def written(folder, programs):
    """The sources of some programs as one system."""
    made = [CKernel(p, cost(p)) for p in programs]
    (folder / "armillary_status.h").write_text(status_header("0.1.0"))
    (folder / "hand.h").write_text(header_file("hand", "By hand", (), made, TARGET, "0x1UL"))
    for one in made:
        for precision in KINDS:
            path = folder / f"{one.program.kernel.name}_{precision}.c"
            path.write_text(source_file(one, TARGET, precision, "0x1UL"))
    return sorted(folder.glob("*.c"))


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    folder = tmp_path_factory.mktemp("hand")
    sources = written(folder, [named(name) for name in NAMES])
    made = folder / "hand.so"
    flags = ["-std=c99", "-O2", *WARNINGS, "-ffp-contract=off", "-shared", "-fPIC"]
    run("gcc", *flags, f"-I{folder}", *sources, "-lm", "-o", made)
    return ctypes.CDLL(str(made))


def called(library, program, precision):
    """Status and results of a program at the point."""
    dtype, kind = KINDS[precision]
    arguments = []
    for q in program.kernel.inputs:
        value = POINT[q.name]
        one = np.array(value, dtype).ctypes.data_as(ctypes.c_void_p) if q.shape else kind(value)
        arguments.append(one)
    results = {r.name: np.full(results_length(r), np.nan, dtype) for r in program.results}
    arguments += [a.ctypes.data_as(ctypes.c_void_p) for a in results.values()]
    status = getattr(library, f"hand_{program.kernel.name}_{precision}")(*arguments)
    return status, results


@needs("gcc")
@pytest.mark.tool
@pytest.mark.parametrize("precision", KINDS)
@pytest.mark.parametrize("name", NAMES)
def test_c_computes_the_same(library, name, precision):
    program = named(name)
    dtype, _ = KINDS[precision]
    point = {n: np.array(v, dtype).tolist() for n, v in POINT.items()}
    wanted = evaluate(program, exact(point), Reals())
    status, found = called(library, program, precision)
    assert status == wanted.status
    for result, numbers in wanted.results.items():
        flat = numbers if isinstance(numbers, list) else [numbers]
        bound = 3e3 * float(np.finfo(dtype).eps) * max(1.0, *(abs(float(n)) for n in flat))
        worst = max(abs(float(n - float(a))) for n, a in zip(flat, found[result], strict=True))
        assert worst <= bound, result


@needs("gcc")
@pytest.mark.tool
def test_a_negative_status_writes_nothing(library):
    program = named("conditions")
    found = {}
    for far in (11.0, 1.0):
        values = {**POINT, "l": [9.0, far, 9.0]}
        arguments = [
            np.array(values[q.name]).ctypes.data_as(ctypes.c_void_p)
            if q.shape
            else ctypes.c_double(values[q.name])
            for q in program.kernel.inputs
        ]
        kept, shift = np.full(3, 7.0), np.full(1, 7.0)
        arguments += [a.ctypes.data_as(ctypes.c_void_p) for a in (kept, shift)]
        found[far] = (library.hand_conditions_f64(*arguments), [*kept, *shift])
    assert found[11.0] == (-3, [7.0] * 4)
    assert found[1.0][0] == 0
    assert 7.0 not in found[1.0][1]


# -- what is printed ------------------------------------------------------------------------------


def body(folder, name, precision="f64"):
    """The text of a function, without its guards."""
    written(folder, [named(name)])
    text = (folder / f"{name}_{precision}.c").read_text()
    return text[text.index("\n  if (status == ARMILLARY_OK) {") :]


def test_a_table_is_an_automatic_array(tmp_path):
    text = body(tmp_path, "tables", "f32")
    assert "const float leg_constants[3] = {1.0f, 0.5f, -0.33333334f};" in text
    assert "static" not in text
    assert "for (int leg = 0; leg < 3; ++leg) {" in text
    assert re.search(r"q\[leg\] = ", text)


def test_sums_start_at_zero_beside_their_loop(tmp_path):
    text = body(tmp_path, "sums")
    facets, legs = text.index("for (int facet"), text.index("for (int leg")
    outer, inner = re.search(r"double \w+\[3\] = \{0.0\};", text), text.index("double t3 = 0.0;")
    assert outer.start() < facets < inner < legs


def test_what_is_carried_is_assigned_at_the_end_of_a_turn(tmp_path):
    text = body(tmp_path, "exchange")
    turn_end = text[text.index("for (int turn") : text.index("ends[0]")].splitlines()[-6:-1]
    assigned = [line.split(" = ")[0].strip() for line in turn_end if " = " in line]
    assert assigned[-4:] == ["first", "second", "third", "sign"]
    # `first` becomes what `second` was before it changes.
    assert re.search(r"const double (\w+) = second;.*first = \1;", text, re.S)


def test_results_are_stored_where_they_are_made(tmp_path):
    assert "m[(9 * facet) + (3 * leg) + 2] = " in body(tmp_path, "vectors_of_legs")
    assert "n[(4 * leg) + (2 * facet)] = " in body(tmp_path, "vectors_of_legs")


def test_results_wait_for_a_status_that_may_be_negative(tmp_path):
    text = body(tmp_path, "conditions")
    late = text[text.index("if (status >= 0) {") :]
    assert re.search(r"for \(int leg = 0; leg < 3; \+\+leg\) \{\s+kept\[leg\] = \w+\[leg\];", late)
    assert "kept[leg]" not in text[: text.index("if (status >= 0) {")]


def test_loop_variables_step_aside(tmp_path):
    b = Hand()
    z = b.phi(b.x, turn, "leg")
    b.carry(z, b.sin(b.add(z, b.sum(b.multiply(b.l, z), leg))))
    b.label(b.carried[z], ("turn",), "hand-turn")
    program = program_of(
        b, {"leg_value": ([b.element(b.carried[z], turn, 4)], [])}, inputs=(x, lengths)
    )
    written(tmp_path, [replace(program, kernel=replace(program.kernel, name="aside"))])
    text = (tmp_path / "aside_f64.c").read_text()
    declared = re.findall(r"(?:int|double) (\w+) =", text[text.index("++leg") :])
    names = [n for n in declared if n != "leg"]
    assert len(set(names)) == len(names)
    if needs("gcc").args[0] is False:
        run("gcc", "-std=c99", *WARNINGS, "-c", tmp_path / "aside_f64.c", "-o", tmp_path / "x.o")


def test_the_header_tells_who_must_not_overlap(tmp_path):
    b = Hand()
    plain = program_of(b, {"r": ([b.sum(b.sin(b.multiply(b.x, b.values(leg, 1, 2, 3))), leg)], [])},
                       inputs=(x,))  # fmt: skip
    plain = replace(plain, kernel=replace(plain.kernel, name="plain"))
    written(tmp_path, [plain, named("tables")])
    header = " ".join((tmp_path / "hand.h").read_text().replace("\n *", " ").split())
    assert "except where a function says that they must not." in header
    warning = "Inputs are read while results are written: they must not overlap."
    assert header.count(warning) == 2  # one in each precision
    assert header.index(warning) > header.index("int hand_plain_f32(")
    written(tmp_path, [plain])
    header = (tmp_path / "hand.h").read_text()
    assert "so they\n * may overlap.\n" in header
    assert "must not" not in header
