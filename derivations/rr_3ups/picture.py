"""What the page shows first: column, platform, the three legs, and the sun."""

from math import radians

from armillary import Axes, Frame, Plate, Ray, Rod, Scene, X, Y, Z, elementary, number, vector

from .legs import UP, P, R_m, b
from .symbols import h_0, leg, zeta


def _each(name, values):
    """A parameter of the legs, as the picture names its three values."""
    return {f"{name}_{k}": value for k, value in enumerate(values, 1)}


# Table 1 of the paper, in mid-morning.
POSE = {
    "alpha": -0.9, "beta": 0.85, "h_0": 0.6,
    **_each("r", (0.3, 0.3, 0.3)),
    **_each("phi", map(radians, (-150.0, -30.0, 90.0))),
    **_each("R", (0.6, 0.6, 0.4)),
    **_each("theta", map(radians, (-150.0, -30.0, 90.0))),
    **_each("h", (0.6, 0.6, 0.0)),
    **_each("zeta", map(radians, (0.0, 0.0, -90.0))),
}  # fmt: skip
_AXIS, _SIZE, _FAR = 0.12, 0.16, 0.5
_o = h_0 * UP
_foot = vector(b.x, b.y, number(0))
_level = Axes(*(vector(*(int(k == j) for j in range(3))) for k in (X, Y, Z)))
_turned = Axes(*(R_m.column(k) for k in (X, Y, Z)))

scene = Scene(
    (
        Plate(_foot, over=leg, kind="ground"),
        Rod(_foot, b),
        Rod(vector(0, 0, 0), _o),
        Rod(b, P),
        Plate(P, over=leg),
        Ray(b, elementary(Y, zeta) @ UP, length=_AXIS),
        Ray(_o, R_m.column(Z), length=_FAR, sun=True),
        Frame("O", vector(0, 0, 0), _level, size=_SIZE),
        Frame("o", _o, _turned, size=_SIZE),
    )
)
