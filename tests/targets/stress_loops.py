"""Derivations with loops, iterations and states that are hard to print."""

import sympy

from armillary import (
    PI,
    Derivation,
    Kind,
    Matrix,
    Status,
    absolute,
    any_of,
    at,
    cos,
    sin,
    solve,
    sqrt,
    substitute,
    total,
    vector,
    where,
)
from armillary.derivation.units import RADIAN

SIZE = Kind.NON_NEGATIVE
BECAUSE = "it is asked for"
THIRD = 2 * sympy.pi / 3


def loops() -> Derivation:
    """Arrays of every kind, as inputs and as parameters, in loops in loops."""
    d = Derivation("loops", title="Loops")
    leg, facet = d.index("leg", 3), d.index("facet", 2)
    theta = d.constant("theta", (0, THIRD, -THIRD), "azimuth of a leg", unit=RADIAN, per=leg)
    side = d.constant("side", (1, -1), "side of a facet", per=facet)
    x = d.scalar("x", "a number", range=(0.5, 1.5))
    turn = d.angle("turn", "an angle", range=(-3.0, 3.0))
    l = d.scalar("l", "a length for each leg", per=leg, kind=SIZE, range=(0.0, 2.0))
    v = d.vector("v", "a vector for each leg", per=leg, range=(-2.0, 2.0))
    w = d.vector("w", "a vector", range=(-2.0, 2.0))
    R = d.parameter.scalar("R", "a size for each leg", per=leg, kind=SIZE, range=(0.1, 1.0))
    S = d.parameter.vector("S", "a vector for each leg", per=leg)
    h = d.parameter.scalar("h", "a number for each facet", per=facet, range=(-1.0, 1.0))
    d.parameter.scalar("unread", "a number for each facet that nothing reads", per=facet)

    wave = d.define("wave", sin(turn) * cos(theta) + x * sin(theta), because=BECAUSE)
    reach = d.define("reach", l * l + R * R + wave * wave, because=BECAUSE)
    rod = d.define("rod", sqrt(reach), because=BECAUSE)
    whole = d.define("whole", total(rod, over=leg), because=BECAUSE)
    extended = d.define("extended", any_of(l > x, over=leg), because=BECAUSE)
    d.kernel("rods", inputs=[l, x, turn], outputs={"rod": rod, "whole": whole})
    d.kernel(
        "shares",
        inputs=[x, turn, l],
        outputs={"share": rod / whole, "first": at(rod, leg, 0), "l": where(l > x, rod, -rod)},
        cases=[(Status.LIMIT, extended, "one is long")],
    )
    arm = d.define("arm", v.cross(w) + S * x, because=BECAUSE)
    d.kernel(
        "arms",
        inputs=[v, w, x],
        outputs={
            "arm": arm,
            "sum": total(arm, over=leg),
            "last": at(v, leg, 2),
            "rows": Matrix(((arm.x, x, arm.dot(v)),)),
        },
    )
    tilt = d.define("tilt", cos(turn + theta) * h + side * x, because=BECAUSE)
    row = total(tilt * tilt, over=leg)
    d.kernel(
        "grid",
        inputs=[x, turn],
        outputs={
            "tilt": tilt,
            "row": row,
            "column": total(tilt / (2 + row), over=facet),
            "all": total(row, over=facet),
        },
    )
    d.kernel("still", inputs=[], outputs={"R": R, "S": S, "h": h * 2, "theta": theta})
    d.kernel("ignored", inputs=[l, v], outputs={"k": vector(0, 1, 2)})
    return d


def iterations() -> Derivation:
    """Newton in a loop, around a loop, and beside another; some that do not converge."""
    d = Derivation("iterations", title="Iterations")
    leg, facet = d.index("leg", 3), d.index("facet", 2)
    theta = d.constant("theta", (0, THIRD, -THIRD), "azimuth of a leg", unit=RADIAN, per=leg)
    l = d.scalar("l", "length of each leg", per=leg, kind=SIZE, range=(1.8, 2.2))
    start = d.scalar("start", "a height to start from", range=(1.5, 2.0))
    mean = d.angle("mean", "mean anomaly", range=(-3.0, 3.0))
    R = d.parameter.scalar("R", "radius", kind=SIZE, range=(0.4, 0.6))
    e = d.parameter.scalar("e", "eccentricity of each facet", per=facet, range=(0.0, 0.4),
                           limits=(0.0, 0.9))  # fmt: skip
    x, y, z = (d.unknown(n, f"component {n}") for n in "xyz")
    foot_x, foot_y = R * cos(theta), R * sin(theta)
    residual = (x - foot_x) * (x - foot_x) + (y - foot_y) * (y - foot_y) + z * z - l * l
    found = solve(residual, {x: 0 * start, y: 0 * start, z: start}, steps=7, name="newton",
                  within={z: (0 * start + "0.1", 0 * start + 9)})  # fmt: skip
    left = substitute(residual, dict(zip((x, y, z), found, strict=True)))
    lost = d.define("lost", any_of(~(absolute(left) < "1e-4"), over=leg), because=BECAUSE)
    d.kernel(
        "forward",
        inputs=[l, start],
        outputs={"x": found[0], "y": found[1], "z": found[2], "left": left},
        cases=[(Status.NOT_CONVERGED, lost, "the legs do not meet")],
    )
    E = d.unknown("E", "eccentric anomaly", unit=RADIAN)
    (anomaly,) = solve(E - e * sin(E) - mean, {E: mean}, steps=6, name="kepler")
    d.kernel(
        "kepler",
        inputs=[mean],
        outputs={
            "E": anomaly,
            "spread": total(sin(anomaly), over=facet),
            "legs": cos(anomaly + theta),
        },
    )
    u = d.unknown("u", "a number")
    (root,) = solve(u * u - (2 + cos(mean)), {u: 1}, steps=5, name="root")
    d.kernel("root", inputs=[mean], outputs={"u": root})
    return d


def keepers() -> Derivation:
    """Controllers: one without parameters, one of every leg, one that may refuse."""
    d = Derivation("keepers", title="What is kept")
    leg = d.index("leg", 3)
    given = d.scalar("given", "a number", range=(-1.0, 1.0))
    each = d.scalar("each", "a number for each leg", per=leg, range=(-1.0, 1.0))
    gain = d.parameter.scalar("gain", "a factor", range=(0.1, 0.5))
    last, sum_so_far = d.state.scalar("last", "the last one"), d.state.scalar("so_far", "the sum")
    several = d.state.scalar("several", "a number of each leg", per=leg)
    fall = d.define("fall", (last - given) * gain, because=BECAUSE)
    d.controller(
        "simple",
        inputs=[given],
        outputs={"fall": fall},
        states={last: given, sum_so_far: sum_so_far + fall},
        start={last: given, sum_so_far: 0},
        start_inputs=[given],
    )
    moved = several + (each - several) * gain
    d.controller(
        "array",
        inputs=[each],
        outputs={"whole": total(moved, over=leg), "moved": moved - each},
        states={several: moved, last: total(several, over=leg)},
        start={several: each * 2, last: 0},
        start_inputs=[each],
        cases=[
            (Status.UNREACHABLE, any_of(each > several + 1, over=leg), "too far"),
            (Status.LIMIT, last > 1, "large"),
        ],
    )
    one, other = (d.state.scalar(n, "a number of each leg", per=leg) for n in ("one", "other"))
    d.controller(
        "exchange",
        inputs=[each],
        outputs={"before": one, "first": at(other, leg, 0)},
        states={one: other, other: at(one, leg, 0) + each},
        start={one: each, other: 2 * each},
        start_inputs=[each],
    )
    turned = d.state.angle("s", "a state named like the pointer to it")
    wave = sin(turned) * PI
    d.controller(
        "named", inputs=[given], outputs={"wave": wave}, states={turned: given}, start={turned: 1}
    )
    return d


SYSTEMS = {make.__name__: make for make in (loops, iterations, keepers)}
