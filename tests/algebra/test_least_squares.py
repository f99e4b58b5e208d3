"""More residuals than unknowns: Gauss and Newton's steps."""

import numpy as np
import pytest

from armillary import Derivation, Matrix, cos, sin, solve, substitute, total
from armillary.algebra.misuse import MisuseError
from armillary.derivation.units import METRE
from armillary.program.arithmetic import Reals
from armillary.program.compile import compile_kernel
from armillary.verify import exact

PLACES = np.array([-1.0, 0.5, 2.0, 3.0])


@pytest.fixture
def d():
    return Derivation("fits", title="Fits")


def run(d, row):
    (kernel,) = d.kernels.values()
    program = compile_kernel(kernel).program
    found = exact.run(program, row, Reals()).results
    book = {o.name: exact.text_book(o.value, o.indices) for o in kernel.outputs}
    for name, function in book.items():
        assert exact.worst(exact.flat(found[name]), function(row)) < 1e-40
    return {n: np.array(exact.flat(value), dtype=float) for n, value in found.items()}


def test_a_linear_fit_takes_one_step(d):
    part = d.index("part", 4)
    y = d.scalar("y", "measured", per=part)
    place = d.constant("place", ("-1", "0.5", "2", "3"), "where", per=part)
    a, b = d.unknown("a", "slope"), d.unknown("b", "offset")
    slope, offset = solve(a * place + b - y, {a: 0, b: 5}, name="fit", steps=1, over=part)
    d.kernel("k", inputs=[y], outputs={"slope": slope, "offset": offset})
    given = [0.3, -1.0, 2.5, 0.75]
    found = run(d, {"y": given})
    wanted = np.polyfit(PLACES, given, 1)
    assert [found["slope"][0], found["offset"][0]] == pytest.approx(wanted, abs=1e-14)


def circle(d, steps):
    """Angle and radius of an arc that passes three directions best."""
    part = d.index("part", 3)
    y = d.scalar("y", "measured", unit=METRE, per=part)
    way = d.constant("way", (0, 1, 2), "direction", per=part)
    t, r = d.unknown("t", "angle"), d.unknown("r", "radius", unit=METRE)
    size = total(y * y, over=part) / total(y, over=part)
    residual = r * cos(t - way) + r * sin(2 * t) / 5 - y
    found = solve(residual, {t: 1, r: size}, name="arc", steps=steps, over=part)
    left = substitute(residual, dict(zip((t, r), found, strict=True)))
    d.kernel("k", inputs=[y], outputs={"pair": Matrix((found,)), "left": left})


def model(t, r):
    return r * np.cos(t - np.arange(3)) + r * np.sin(2 * t) / 5


def test_residuals_that_can_vanish_do(d):
    circle(d, steps=7)
    found = run(d, {"y": model(0.9, 1.5).tolist()})
    assert found["pair"] == pytest.approx([0.9, 1.5], abs=1e-14)
    assert abs(found["left"]).max() < 1e-14


def test_residuals_that_cannot_are_least(d):
    optimize = pytest.importorskip("scipy.optimize")
    circle(d, steps=20)
    y = np.add(model(0.9, 1.5), [0.05, -0.1, 0.05])
    found = run(d, {"y": y.tolist()})
    wanted = optimize.least_squares(
        lambda x: model(*x) - y, [1, 1.5], xtol=1e-15, ftol=1e-15, gtol=1e-15
    )
    assert found["pair"] == pytest.approx(wanted.x, abs=1e-7)
    assert np.linalg.norm(found["left"]) == pytest.approx(np.linalg.norm(wanted.fun), abs=1e-12)
    assert np.linalg.norm(found["left"]) > 0.05


def test_one_unknown_of_a_constant_slope(d):
    part = d.index("part", 4)
    y = d.scalar("y", "measured", per=part)
    x = d.unknown("x", "mean")
    (mean,) = solve(x - y, {x: 0}, name="mean", steps=2, over=part)
    d.kernel("k", inputs=[y], outputs={"m": mean})
    assert run(d, {"y": [1.0, 2.0, 4.0, 9.0]})["m"] == pytest.approx([4.0])


def test_wrong_uses_are_told(d):
    part, other = d.index("part", 2), d.index("other", 4)
    y = d.scalar("y", "measured", per=part)
    a, b, c = (d.unknown(n, "wanted") for n in "abc")
    start = {a: 0, b: 0, c: 0}
    with pytest.raises(MisuseError, match="2 residuals for 3 unknowns"):
        solve(a * y + b * y * y + c, start, name="s", over=part)
    with pytest.raises(MisuseError, match="makes least what is not per other; give one residual"):
        solve(a * y, {a: 0}, name="s", over=other)
    with pytest.raises(MisuseError, match="what is not per part"):
        solve([a * y, b * y], {a: 0, b: 0}, name="s", over=part)
    with pytest.raises(MisuseError, match="solve has 0 unknowns"):
        solve(y, {}, name="s", over=part)
