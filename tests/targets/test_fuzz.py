"""No input makes a kernel break its contract: random bits, limits, infinities, in place."""

import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import pytest

from armillary.derivation.status import Status
from tests.targets.compilers import needs
from tests.targets.fuzz.driver import driver_source

pytestmark = [pytest.mark.tool, pytest.mark.slow]
SANITIZERS = "-fsanitize=address,undefined,float-divide-by-zero,float-cast-overflow"
# Half of the calls and more lie in the working range; what is refused must not be the rule.
LEAST_ACCEPTED = 0.6
LEAST_ANSWERED = 0.15
# Of what is searched for: numbers taken at random seldom fit together, unless they are drawn so.
LEAST_FOUND = 0.05


def fuzz(printed, folder, compiler, flags, calls, kernels=None):
    """Build and run both precisions at once; the report by kernel."""
    kernels = kernels or list(printed.compiled)

    def one(precision):
        source = folder / f"fuzz_{precision}.c"
        source.write_text(driver_source(printed, precision, kernels))
        program = source.with_suffix("")
        command = [compiler, "-std=c11", "-D_GNU_SOURCE", *flags, f"-I{printed.c}"]
        command += ["-o", program, source, "-lm"]
        built = subprocess.run(command, capture_output=True, text=True, check=False)
        assert built.returncode == 0, built.stderr
        ran = subprocess.run([program, str(calls)], capture_output=True, text=True, check=False)
        assert ran.returncode == 0, ran.stdout[-2000:] + ran.stderr[-4000:]
        return [line.split() for line in ran.stdout.splitlines()]

    with ThreadPoolExecutor() as pool:
        reports = list(pool.map(one, printed.target.precisions))
    return {name: tuple(map(int, numbers)) for report in reports for name, *numbers in report}


def hold(printed, report, calls):
    assert len(report) == 2 * (len(printed.compiled) + len(printed.stages))
    known = {f"{system}_{kernel}": made for (system, kernel), made in printed.compiled.items()}
    known |= {f"{s}_{k}_step": printed.compiled[s, k] for s, k in printed.stages}
    for name, (called, accepted, answered) in report.items():
        kernel = known[name.rpartition("_")[0]].program.kernel
        searches = any(case.status is Status.NOT_CONVERGED for case in kernel.cases)
        least = LEAST_FOUND if searches and not kernel.drawn else LEAST_ANSWERED
        assert called == calls, name
        assert accepted >= LEAST_ACCEPTED * calls, f"{name}: {accepted} of {calls} accepted"
        assert answered >= least * calls, f"{name}: {answered} of {calls} answered"


@needs("gcc")
def test_a_million_calls_of_every_kernel(printed, tmp_path):
    hold(printed, fuzz(printed, tmp_path, "gcc", ["-O2", "-ffp-contract=off"], 10**6), 10**6)


@pytest.mark.parametrize("compiler", [pytest.param(c, marks=needs(c)) for c in ("gcc", "clang")])
def test_sanitizers_find_nothing(printed, tmp_path, compiler):
    flags = ["-O1", "-g", SANITIZERS, "-fno-sanitize-recover=all"]
    hold(printed, fuzz(printed, tmp_path, compiler, flags, 10**5), 10**5)


BREAKAGES = {
    "a limit that moved": ("fabs(turn) <= 1000.0", "fabs(turn) <= 1100.0", "another refusal"),
    "a guard less": ("!(fabs(v_y) <= 1.0e6) ||", "", "another refusal"),
    "a square untested": ("fabs(c_excess) <= 0.001", "fabs(c_excess) <= 0.002", "another refusal"),
    "a refusal too many": ("fabs(turn) <= 1000.0", "fabs(turn) <= 900.0", "a legal input"),
    "another status": ("int status = ARMILLARY_OK", "int status = 4", "undeclared status"),
    "a store too early": ("  int status", "  w[0] = 0.0; int status", "should be left alone"),
    "a store too few": ("    w[2] =", "    if (v_x > 0.0) w[2] =", "was not written"),
    "a late read": ("const double v_x = v[0];", "\n#define v_x v[0]\n", "results in place"),
    "a division by zero": ("w[2] = (", "w[2] = 1.0 / v_x + (", "is not finite"),
}


ROTATION_BREAKAGES = {
    "a long axis": ("fabs(R_square_2) <= 0.001", "fabs(R_square_2) <= 0.5", "another refusal"),
    "a shear": ("fabs(R_dot_12) <= 0.001", "fabs(R_dot_12) <= 0.01", "another refusal"),
    "a mirror": ("fabs(R_determinant) <= 1.0", "fabs(R_determinant) <= 3.0", "another refusal"),
    "a small error": ("fabs(R_dot_13) <= 0.001", "fabs(R_dot_13) <= 1.0e-6", "a legal input"),
    "another entry": ("R_13 = R[2]", "R_13 = R[3]", "another refusal|a legal input"),
}


LOOP_BREAKAGES = {
    "a limit that moved": (
        "fabs(p->S[3 * leg]) <= 1000.0",
        "fabs(p->S[3 * leg]) <= 1e4",
        "refusal",
    ),
    "a leg unguarded": (
        "leg < 3; ++leg) {\n    if",
        "leg < 2; ++leg) {\n    if",
        "another refusal",
    ),
    "a leg unwritten": (
        "leg < 3; ++leg) {\n      ",
        "leg < 2; ++leg) {\n      ",
        "was not written",
    ),
    "a leg too many": ("rows[(3 * leg) + 2]", "rows[9] = 0.0; rows[(3 * leg) + 2]", "left alone"),
}
STATE_BREAKAGES = {
    "a state too early": ("  int status", "  s->last = 0.0; int status", "status 99"),
    "a state unguarded": ("fabs(last) <= 1000.0", "fabs(gain) <= 1000.0", "another refusal"),
}
NOT_READY = "ARMILLARY_OK : ARMILLARY_OUT_OF_RANGE"
STAGE_BREAKAGES = {
    "any context": (NOT_READY, "ARMILLARY_OK : ARMILLARY_OK", "status 97"),
    "a mark of ones": ("(ctx->ready ==", "(ctx->ready == ~0UL || ctx->ready ==", "status 97"),
    "a store in a refusal": ("int status = (ctx", "w[2] = 0.0; int status = (ctx", "status 97"),
    "another refusal": (NOT_READY, "ARMILLARY_OK : ARMILLARY_UNREACHABLE", "status 97"),
    "a mark that stays": ("  ctx->ready = 0;\n", "", "status 99"),
    "a mark of nothing": ("ctx->ready = 0;", "ctx->ready = 1;", "status 99"),
    "a mark that is another": ("ctx->ready = 0x", "ctx->ready = 1 + 0x", "a legal input"),
    "a field ahead of a refusal": ("ctx->ready = 0;", "ctx->ready = ctx->S_2_x = 0;", "status 99"),
}


@needs("gcc")
@pytest.mark.parametrize(("right", "wrong", "why"), LOOP_BREAKAGES.values(), ids=LOOP_BREAKAGES)
def test_the_harness_notices_what_is_wrong_in_a_loop(printed, tmp_path, right, wrong, why):
    notices(printed, tmp_path, ("loops", "arms"), right, wrong, why)


@needs("gcc")
@pytest.mark.parametrize(("right", "wrong", "why"), STATE_BREAKAGES.values(), ids=STATE_BREAKAGES)
def test_the_harness_notices_what_is_wrong_with_a_state(printed, tmp_path, right, wrong, why):
    notices(printed, tmp_path, ("keepers", "array_update"), right, wrong, why)


@needs("gcc")
@pytest.mark.parametrize(("right", "wrong", "why"), STAGE_BREAKAGES.values(), ids=STAGE_BREAKAGES)
def test_the_harness_notices_what_is_wrong_with_a_context(printed, tmp_path, right, wrong, why):
    notices(printed, tmp_path, ("stress", "carry"), right, wrong, why, "_step")


@needs("gcc")
@pytest.mark.parametrize(("right", "wrong", "why"), BREAKAGES.values(), ids=BREAKAGES)
def test_the_harness_notices(printed, tmp_path, right, wrong, why):
    notices(printed, tmp_path, ("stress", "vectors"), right, wrong, why)


@needs("gcc")
@pytest.mark.parametrize(
    ("right", "wrong", "why"), ROTATION_BREAKAGES.values(), ids=ROTATION_BREAKAGES
)
def test_the_harness_notices_what_is_no_rotation(printed, tmp_path, right, wrong, why):
    notices(printed, tmp_path, ("attitudes", "parts"), right, wrong, why)


def notices(printed, tmp_path, kernel, right, wrong, why, stage=""):
    """Break one line of a kernel, or of its stages, and see it found."""
    printed.module("_signatures")  # from there: what is broken has no Python
    folder = tmp_path / "broken"
    shutil.copytree(printed.c, folder / "c" / "src" / printed.target.folder)
    broken = replace(printed, folder=folder)
    path = broken.c / f"{'_'.join(kernel)}{stage}_f64.c"
    text = path.read_text()
    assert right in text
    # A step is included after it, and may have the same names.
    path.write_text(text.replace(right, wrong) + "\n#undef v_x\n")
    with pytest.raises(AssertionError, match=why):
        fuzz(broken, tmp_path, "gcc", ["-O1"], 20_000, [kernel])
