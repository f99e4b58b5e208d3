"""Inputs that are drawn as expressions: values, places about them, and where there are none."""

from dataclasses import replace

import pytest

from armillary import Derivation, Matrix, cos, near, sin, sqrt, vector
from armillary.derivation.errors import DerivationError
from armillary.derivation.units import METRE
from armillary.program.arithmetic import Reals
from armillary.program.drawing import Drawing
from armillary.program.sample import sample_points
from armillary.verify.points import awkward_points, illegal_points, random_points, rows_of


def circle(change=lambda drawn, r, t: {}):
    """Points on a circle, and a guess of the angle: a kernel that gives back what it takes."""
    d = Derivation("circle", title="Circle")
    leg, way = d.index("leg", 3), d.index("way", 2)
    t = d.angle("t", "angle", range=(0.0, 1.0))
    r = d.parameter.length("r", "radius", limits=(0.0, 2.0), range=(1.0, 2.0))
    x = d.scalar("x", "parts", unit=METRE, per=leg, limits=(-3.0, 3.0), range=(-3.0, -2.5))
    pos = d.vector("pos", "position", unit=METRE, range=(5.0, 6.0))
    g = d.scalar("g", "guess", per=way, range=(0.0, 4.0))
    part = d.constant("part", (0, 1, 2), "place of a part", per=leg)
    drawn = {
        "x": r * cos(t + part),
        "pos": vector(r * cos(t), r * sin(t), 0 * r),
        "g": near(Matrix(((t, 2 * t),)), by=0.5),
    }
    drawn.update(change(drawn, r, t))
    d.kernel(
        "k",
        inputs=[x, pos, g],
        outputs={"square": x * x, "q": pos * 2, "h": g, "s": r * r},
        drawn={x: drawn["x"], pos: drawn["pos"], g: drawn["g"]},
    )
    return d.kernels["k"]


ROW = {"t": 0.5, "r": 2.0, "x": [-3.0] * 3, "pos": [5.0] * 3, "g": [0.0, 3.0]}


def at(kernel):
    found = Drawing(kernel).at(ROW, Reals())
    return {name: [float(x) for x in value] for name, value in found.items()}


def test_what_is_drawn_has_the_value_of_its_expression():
    found = at(circle())
    assert found["x"] == pytest.approx([1.7551651237807455, 0.1414744033354058, -1.602287231093867])
    assert found["pos"] == pytest.approx([1.7551651237807455, 0.958851077208406, 0.0])


def test_near_an_expression_the_place_in_the_range_counts():
    # Of 0 to 4, 0 is the lower end and 3 the middle of the upper half.
    assert at(circle())["g"] == [0.5 - 0.5, 1.0 + 0.25]
    assert at(circle(lambda drawn, r, t: {"g": drawn["g"].value}))["g"] == [0.5, 1.0]


def test_quantities_that_the_kernel_does_not_take_are_known():
    assert [q.name for q in Drawing(circle()).others] == ["t"]
    plain = Drawing(replace(circle(), drawn=()))
    assert plain.others == ()
    assert plain.at(ROW, Reals()) == {}


def test_sample_points_are_drawn():
    reals = Reals()
    for point in sample_points(circle(), 4):
        r, t = point["r"], point["t"]
        assert abs(point["pos"][0] ** 2 + point["pos"][1] ** 2 - r * r) < 1e-45
        assert abs(point["x"][1] - r * reals.cos(t + 1)) < 1e-45
        assert 0 < abs(point["g"][0] - t) <= 0.5


def on_the_circle(row):
    return abs(row["pos"][0] ** 2 + row["pos"][1] ** 2 - row["r"] ** 2) < 1e-12


def test_random_points_are_drawn_and_the_rest_stays():
    kernel = circle()
    points = random_points(kernel, 20, seed=1)
    assert sorted(points) == ["g", "pos", "r", "x"]
    assert all(map(on_the_circle, rows_of(points)))
    plain = random_points(replace(kernel, drawn=()), 20, seed=1)
    assert (points["r"] == plain["r"]).all()
    assert not any(map(on_the_circle, rows_of(plain)))
    assert points["g"].std() > 0.1


def test_awkward_points_are_drawn_by_the_awkward_values():
    rows = list(rows_of(awkward_points(circle())))
    spoilt = [row for row in rows if not on_the_circle(row)]
    assert {row["r"] for row in rows if on_the_circle(row)} >= {0.0, 1.0, 2.0}
    assert len(spoilt) < len(rows)
    assert all(max(map(abs, row["pos"])) >= 5 or not any(row["pos"]) for row in spoilt)


def test_illegal_points_keep_their_faults():
    kernel = circle()
    drawn = list(rows_of(illegal_points(kernel)))
    plain = list(rows_of(illegal_points(replace(kernel, drawn=()))))
    assert len(drawn) == len(plain)
    r = [row["r"] for row in drawn]
    assert 1e30 in r
    assert any(x != x for x in r)
    assert any(1e30 in row["pos"] for row in drawn)


@pytest.mark.parametrize(
    ("change", "why"),
    [
        (lambda drawn, r, t: {"pos": vector(sqrt(-r * r), r, r)}, "what pos .*has no real value"),
        (lambda drawn, r, t: {"pos": vector(r / (t - t), r, r)}, "has no real value"),
        (lambda drawn, r, t: {"x": drawn["x"] * 2}, "what x .*lies beyond its limits"),
    ],
    ids=["a root of something negative", "a division by 0", "beyond the limits"],
)
def test_a_point_without_a_value_is_told(change, why):
    kernel = circle(change)
    with pytest.raises(DerivationError, match=f"test_drawing.py:.*{why}(.|\n)*mend: narrow range="):
        Drawing(kernel).at(ROW, Reals())
