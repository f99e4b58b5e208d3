"""Derivations that are hard to print: every kind of argument, status and awkward name."""

from armillary import (
    PI,
    Chain,
    Derivation,
    Kind,
    Matrix,
    Status,
    X,
    Y,
    Z,
    absolute,
    atan2,
    cos,
    elementary,
    hypot,
    sin,
    sqrt,
    unit,
    vector,
    where,
)
from tests.targets import stress_loops

LONG = "angle_of_the_second_axis_of_the_collector_seen_from_below"
BECAUSE = "it is asked for"


def stress() -> Derivation:
    """Vectors, unit vectors and limits of every form, as inputs and as parameters."""
    d = Derivation("stress", title='Kernels that are "hard" to print; 10 \\mu m, 5 °, /* even */')
    c = d.unit_vector("c", "a direction")
    v = d.vector("v", "a vector, \\bar v in print, not */ an end", limits=(-1e6, 1e6))
    warm = d.scalar("warm", "a temperature", limits=(-273.15, 200.0), range=(-40.0, 60.0))
    strict = d.scalar("strict", "a number apart from 0", limits=(2.0, 5.0), range=(2.5, 4.5))
    below = d.scalar("below", "a negative number", limits=(-5.0, -1.0), range=(-4.0, -2.0))
    turn = d.angle("turn", "an angle")
    mount = d.parameter.unit_vector("mount", "a direction that stays")
    S_t = d.parameter.vector("S_t", "a vector that stays", limits=(-10.0, 10.0))
    L_0 = d.parameter.length("L_0", "a length")
    S_2 = d.define("S_2", S_t * 2, because=BECAUSE)
    d.parameter.length("unread", "a length that nothing reads")

    d.kernel(
        "vectors",
        inputs=[c, v, turn],
        outputs={"R": elementary(Z, turn) @ elementary(X, PI / 7), "w": c.cross(v) + mount},
        summary='Outputs """quoted""" with \\alpha and a full stop.',
    )
    d.kernel("carry", inputs=[turn, v], outputs={"w": elementary(Z, turn) @ (v + S_2)})
    d.kernel("lengths", inputs=[v], outputs={"n": unit(v + vector(0, 0, 3e6)), "r": sqrt(v.dot(v))})
    d.kernel(
        "bounds",
        inputs=[warm, strict, below],
        outputs={"a": warm / strict, "b": sqrt(strict) / below, "e": absolute(below) * (L_0 * L_0)},
    )
    d.kernel("numbers", inputs=[], outputs={"k": vector(1, PI, "0.1"), "zero": sin(0)})
    d.kernel("still", inputs=[], outputs={"k": S_t * L_0})
    d.kernel("ignored", inputs=[c], outputs={"k": vector(0, -1, 2)})
    return d


def answers() -> Derivation:
    """Statuses of both signs that may hold at once, and a division behind each."""
    d = Derivation("answers", title="Statuses")
    x = d.scalar("x", "a number", limits=(-4.0, 4.0), range=(-1.5, 1.5))
    y = d.scalar("y", "a number", limits=(-4.0, 4.0), range=(-1.5, 1.5))
    rest = d.define("rest", 1 - x * x - y * y, because=BECAUSE)
    inside = d.define("inside", rest > 0, because=BECAUSE, meaning="in the circle")
    far = d.define("far", x > 1, because=BECAUSE)
    farther = d.define("farther", y > 1, because=BECAUSE)
    at_origin = d.define("at_origin", hypot(x, y) < "0.001", because=BECAUSE)
    root = d.define("root", sqrt(where(inside, rest, 0)), because=BECAUSE)
    azimuth = d.define(
        "azimuth", atan2(where(at_origin, 0, x), where(at_origin, 1, y)), because=BECAUSE
    )
    d.kernel(
        "both_signs",
        inputs=[x, y],
        outputs={"root": root, "a": azimuth},
        cases=[
            (Status.NOT_CONVERGED, farther, "y is too large"),
            (Status.UNREACHABLE, far, "x is too large"),
            (Status.CLAMPED, ~inside, "on the rim"),
            (Status.SINGULAR, at_origin, "the angle is free"),
            (Status.LIMIT, (x < 0) & (y < 0), "in the third quarter"),
        ],
    )
    d.kernel("signs", inputs=[x, y], outputs={"a": atan2(where(inside, -x, x), y), "minus": -x})
    return d


def names() -> Derivation:
    """Names that the printed code itself might want."""
    d = Derivation("names", title="Names")
    t1 = d.scalar("t1", "a number")
    turn = d.angle("turn", "an angle")
    long = d.angle(LONG, "an angle with a long name")
    S = d.parameter.vector("S", "a vector whose components want names")
    v = d.vector("v", "a vector")
    step = d.parameter.length("step", "an offset")
    S_x = d.define("S_x", t1 * S.x + 1, because=BECAUSE)
    v_y = d.define("v_y", S_x * v.y, because=BECAUSE)
    squared = d.define("Any", v_y * v_y + t1, because=BECAUSE)
    hypotenuse = d.define("hypot", sqrt(squared * squared + 1), because=BECAUSE)
    tanh = d.define("tanh", hypotenuse * sin(turn * t1), because=BECAUSE)
    all_result = d.define("AllResult", tanh / hypotenuse + tanh, because=BECAUSE)
    chain = Chain("ground")
    for k in range(4):
        chain = chain.rotate((X, Y, Z)[k % 3], long + k * turn).translate(Z, step)
    longer = d.define(
        f"{LONG}_as_a_vector",
        chain.translate(Y, step, frame="tip").pose("ground", "tip").position,
        because=BECAUSE,
    )
    d.kernel(
        "all",
        inputs=[t1, turn, long, v],
        outputs={
            "out": S_x + v_y * squared + all_result,
            f"{LONG}_again": longer,
            f"{LONG}_squared": (long + turn) * (long - turn) * cos(long + turn) * S.y * S.z * tanh,
        },
    )
    d.kernel(
        "same",
        inputs=[v],
        outputs={"v": v + S, "S": v.x, "step": step * v.z, "v_out": v.y * S.x, "S_y": S.y},
        summary="Results named like inputs, parameters and their components.",
    )
    return d


def bare() -> Derivation:
    """No parameters; one input."""
    d = Derivation("bare", title="One number")
    x = d.scalar("x", "a number", kind=Kind.NON_NEGATIVE)
    d.kernel("root", inputs=[x], outputs={"r": sqrt(x)})
    d.kernel("one_by_one", inputs=[x], outputs={"m": Matrix(((x * x,),))})
    return d


def attitudes() -> Derivation:
    """Rotations by their entries, as an input and as a parameter, straight and transposed."""
    d = Derivation("attitudes", title="Attitudes")
    R = d.rotation("R", "an attitude")
    Q = d.parameter.rotation("Q", "an attitude that stays")
    d.parameter.rotation("unread", "an attitude that nothing reads")
    turn = d.angle("turn", "an angle")
    v = d.vector("v", "a vector")
    w = d.define("w", R.transpose() @ elementary(Y, turn) @ Q @ v, because=BECAUSE)
    d.kernel(
        "carried",
        inputs=[v, R, turn],
        outputs={"w": w, "R": R @ Q.transpose() @ elementary(X, turn), "back": R @ w},
        summary="A result named like a rotation that is an input.",
    )
    d.kernel("parts", inputs=[R], outputs={"e": R.entry(X, Z), "c": R.column(Y), "t": Q.matrix()})
    d.kernel("unused", inputs=[R], outputs={"one": R.column(Z).dot(vector(0, 0, 1)) * 0 + 1})
    return d


SYSTEMS = {make.__name__: make for make in (stress, answers, names, bare, attitudes)}
SYSTEMS |= stress_loops.SYSTEMS
