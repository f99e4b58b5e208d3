"""This project's rows: legs are a loop, and K4 does not keep anybody waiting."""

import re
import time

import pytest

from benchmarks.ours import forces, legs
from benchmarks.printed import Printed
from benchmarks.table import SETUP, STEP, WHOLE

SECONDS = 20  # of processor time


def body(source, name):
    """The text between a function's braces."""
    return re.search(rf"\nint {name}\([^;{{]*\)\s*\{{(.*?)\n\}}", source, re.DOTALL)[1]


@pytest.mark.slow
@pytest.mark.parametrize(("make", "roots"), [(legs, 1), (forces, 2)])
def test_legs_are_a_loop_and_made_in_time(make, roots):
    started = time.process_time()
    asked = make()
    printed = Printed(asked)
    source = printed.source
    assert time.process_time() - started < SECONDS
    assert printed.stages == (WHOLE, SETUP, STEP)
    for stage in ("", "_step"):
        text = body(source, f"rr_3ups_{asked.kernel}{stage}_f64")
        assert text.count("sqrt(") == roots  # unrolled it would be three times as often


@pytest.mark.slow
def test_a_call_fills_what_the_kernel_reads():
    printed = Printed(legs())
    assert "p.h_0 = in[4];" in printed.call(WHOLE)
    assert "in + 5, in + 14, out + 0, out + 3, out + 6, out + 12" in printed.call(WHOLE)
    setup, step = printed.call(SETUP), printed.call(STEP)
    assert setup.index("_setup_f64(&p, in + 5, in + 14, &ctx)") < setup.index("kept = ")
    assert setup.rstrip().endswith("= kept;")
    assert step.index("_setup_f64(") < step.index("Tally()") < step.index("_step_f64(&ctx, in[0]")
