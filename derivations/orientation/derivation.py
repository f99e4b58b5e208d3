"""Orientation triples: three angles for an attitude, and the way back (Ky et al., their names).

Each part stands in a file of its own; their order here is their order on the page.
"""

from armillary import Status, X, Z

from .symbols import R, Omega, a, a_dot, b, b_dot, c, c_dot, d, turns
from .products import R_tilt_torsion, R_zxz, R_zyx, R_zyz
from .motion import Omega_tilt_torsion, Omega_zxz, Omega_zyx, Omega_zyz
from . import lebian  # noqa: F401 - its definitions have their place on the page
from .angles import (
    a_zxz,
    a_zyx,
    a_zyz,
    b_euler,
    b_zyx,
    c_tilt_torsion,
    c_zxz,
    c_zyx,
    c_zyz,
    upright,
    vertical,
)
from .rates import (
    a_dot_zxz,
    a_dot_zyx,
    a_dot_zyz,
    b_upright,
    b_vertical,
    c_dot_tilt_torsion,
    c_dot_zxz,
    c_dot_zyx,
    c_dot_zyz,
    w,
)

derivation = d
HALF_FREE = (
    "within 1e-6 there is no tilt: its direction is free and set to 0, the torsion is not; or the "
    "tilt is half a turn, where the attitude tells only the torsion less twice the direction"
)
ON_AXIS = (
    "within 1e-6 the third axes of base and body are one line: the first angle is free and set to 0"
)
STILL = (
    "sin(b) is within 1e-6 of 0: the first angle is held, and part of the angular velocity cannot "
    "be had"
)
angles, rates = (a, b, c), (a_dot, b_dot, c_dot)
TRIPLES = {
    "zxz": ("ZXZ triple", R_zxz, Omega_zxz),
    "zyz": ("ZYZ triple", R_zyz, Omega_zyz),
    "zyx": ("ZYX triple: yaw, pitch and roll", R_zyx, Omega_zyx),
    "tilt_torsion": ("tilt and torsion", R_tilt_torsion, Omega_tilt_torsion),
}
for triple, (words, matrix, velocity) in TRIPLES.items():
    d.kernel(
        f"matrix_{triple}",
        inputs=angles,
        outputs={"R": matrix},
        summary=f"Attitude by the {words}.",
    )
    d.kernel(
        f"velocity_{triple}",
        inputs=[*angles, *rates],
        outputs={"Omega": velocity},
        summary=f"Angular velocity in base axes, vee(Rdot R^T), by the rates of the {words}.",
    )

d.kernel(
    "angles_zxz",
    inputs=[R],
    outputs={"a": a_zxz, "b": b_euler, "c": c_zxz},
    cases=[(Status.SINGULAR, upright, ON_AXIS)],
    summary="Angles of the ZXZ triple of an attitude, with b in [0, pi].",
)
d.kernel(
    "angles_zyz",
    inputs=[R],
    outputs={"a": a_zyz, "b": b_euler, "c": c_zyz},
    cases=[(Status.SINGULAR, upright, ON_AXIS)],
    summary="Angles of the ZYZ triple of an attitude, with b in [0, pi].",
)
d.kernel(
    "angles_zyx",
    inputs=[R],
    outputs={"a": a_zyx, "b": b_zyx, "c": c_zyx},
    cases=[
        (
            Status.SINGULAR,
            vertical,
            "within 1e-6 the body's first axis is upright: the first angle is free and set to 0",
        )
    ],
    summary="Yaw, pitch and roll of an attitude, with b in [-pi/2, pi/2].",
)
d.kernel(
    "angles_tilt_torsion",
    inputs=[R],
    outputs={"a": a_zyz, "b": b_euler, "c": c_tilt_torsion},
    cases=[(Status.SINGULAR, upright, HALF_FREE)],
    summary="Direction of the tilt, tilt and torsion of an attitude, with b in [0, pi].",
)
RATES = {
    "zxz": ((a_dot_zxz, w.x, c_dot_zxz), b_upright, STILL),
    "zyz": ((a_dot_zyz, w.y, c_dot_zyz), b_upright, STILL),
    "zyx": (
        (a_dot_zyx, w.y, c_dot_zyx),
        b_vertical,
        STILL.replace("sin", "cos"),
    ),
    "tilt_torsion": ((a_dot_zyz, w.y, c_dot_tilt_torsion), b_upright, STILL),
}
for triple, (found, singular, because) in RATES.items():
    d.kernel(
        f"rates_{triple}",
        inputs=[*angles, Omega],
        outputs=dict(zip(("a_dot", "b_dot", "c_dot"), found, strict=True)),
        cases=[(Status.SINGULAR, singular, because)],
        summary=f"Rates of the angles of the {TRIPLES[triple][0]}, by the angular velocity in base "
        "axes.",
    )

d.assume("The turns are about the body's own axes, each as the turns before it have carried it.")
d.assume(
    "Angular velocity is that of the body against the base, in base axes: vee(Rdot R^T). In body "
    "axes it is the transposed attitude times that."
)
d.assume(
    "Within the tolerance of a singular set the free angle is 0, and the attitude comes back to "
    "that tolerance; on the set itself, and outside the tolerance, it comes back to rounding."
)
d.picture(
    turns((Z, a), (X, b), (Z, c)).translate(Z, 1, frame="tip"),
    at={"a": -0.9, "b": 0.8, "c": 1.2},
    caption="The ZXZ triple: a turn about the vertical, a lean about the line of nodes, and a turn "
    "about the leaning axis, drawn with a rod along that axis.",
)
