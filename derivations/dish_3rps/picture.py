"""What the page shows first: the dish that is not there, and the four facets that act it."""

from armillary import Axes, Frame, Plate, Ray, Rod, Scene, Trace, X, Y, Z, substitute, vector

from .dish import H_T_O, R_D, M_dish, c_dish
from .facet import H_T_P, M, from_base, tilt, u
from .rates import r_S
from .symbols import dist, leg, phi, phi_N, r_b

POSE = {
    "alpha": -1.2, "beta": 0.55, "z_O": 2.0, "d": 1.0, "f": 1.6, "r_b": 0.2, "r_m": 0.34,
    "phi": 0.0,
}  # fmt: skip
WAY = 3.1415926


def _of_each(value):
    """For each of the four facets."""
    return substitute(value, {phi: phi_N})


_feet = _of_each(H_T_P.position + from_base(r_b * u))
_joints = _of_each(M + r_S)
_level = Axes(*(vector(*(int(k == j) for j in range(3))) for k in (X, Y, Z)))
_base = Axes(*(H_T_P.rotation.column(k) for k in (X, Y, Z)))
_facet = Axes(*(from_base(tilt.column(k)) for k in (X, Y, Z)))
_SIZE = 0.34

scene = Scene(
    (
        Trace(_of_each(M_dish), dist, 0.0, 1.3),
        Trace(M_dish, phi, -WAY, WAY),
        Plate(_feet, over=leg, kind="ground"),
        Rod(_feet, _joints),
        Plate(_joints, over=leg),
        Ray(H_T_O.position, c_dish, length=1.6, sun=True),
        Frame("H", vector(0, 0, 0), _level, size=_SIZE),
        Frame("O", H_T_O.position, Axes(*(R_D.column(k) for k in (X, Y, Z))), size=_SIZE),
        Frame("P", H_T_P.position, _base, size=_SIZE),
        Frame("M", M, _facet, size=_SIZE),
    )
)
