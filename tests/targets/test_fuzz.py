"""No input makes a kernel break its contract: random bits, limits, infinities, in place."""

import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import pytest

from tests.targets.compilers import needs
from tests.targets.fuzz.driver import driver_source

pytestmark = [pytest.mark.tool, pytest.mark.slow]
SANITIZERS = "-fsanitize=address,undefined,float-divide-by-zero,float-cast-overflow"
# Half of the calls and more lie in the working range; what is refused must not be the rule.
LEAST_ACCEPTED = 0.6
LEAST_ANSWERED = 0.15


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
    assert len(report) == 2 * len(printed.compiled)
    for name, (called, accepted, answered) in report.items():
        assert called == calls, name
        assert accepted >= LEAST_ACCEPTED * calls, f"{name}: {accepted} of {calls} accepted"
        assert answered >= LEAST_ANSWERED * calls, f"{name}: {answered} of {calls} answered"


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


@needs("gcc")
@pytest.mark.parametrize(("right", "wrong", "why"), BREAKAGES.values(), ids=BREAKAGES)
def test_the_harness_notices(printed, tmp_path, right, wrong, why):
    folder = tmp_path / "broken"
    shutil.copytree(printed.c, folder / "c" / "src" / printed.target.folder)
    broken = replace(printed, folder=folder)
    path = broken.c / "stress_vectors_f64.c"
    text = path.read_text()
    assert right in text
    path.write_text(text.replace(right, wrong))
    with pytest.raises(AssertionError, match=why):
        fuzz(broken, tmp_path, "gcc", ["-O1"], 20_000, [("stress", "vectors")])
