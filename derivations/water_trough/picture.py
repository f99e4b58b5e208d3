"""What the page shows first: the trough, its containers and its bearings."""

from armillary import Axes, Frame, Rod, Scene, X, Y, Z, elementary, vector

from .symbols import h_max, r_A, r_B, theta, w, x_1, x_2, y_1, y_2
from .water import h_1, h_2

POSE = {
    "theta": 0.35, "s": 0.0012, "A_1": 0.06, "A_2": 0.06, "w": 0.2, "x_1": -0.6, "y_1": -0.1,
    "x_2": 0.6, "y_2": -0.1, "h_10": 0.08, "h_20": 0.08, "h_max": 0.2, "r_A": 0.7, "r_B": 0.7,
}  # fmt: skip
_turn = elementary(Z, theta)


def _at(x, y, z=0):
    return _turn @ vector(x, y, z)


def _walls(x, y):
    """A container: floor and two walls, as rods."""
    left, right = x - w / 2, x + w / 2
    return (
        Rod(_at(left, y), _at(right, y)),
        Rod(_at(left, y), _at(left, y + h_max)),
        Rod(_at(right, y), _at(right, y + h_max)),
    )


scene = Scene(
    (
        Rod(vector(0, 0, -r_B), vector(0, 0, r_A), "axis"),
        *_walls(x_1, y_1),
        *_walls(x_2, y_2),
        Rod(_at(x_1 - w / 2, y_1 + h_1), _at(x_1 + w / 2, y_1 + h_1), "water 1"),
        Rod(_at(x_2 - w / 2, y_2 + h_2), _at(x_2 + w / 2, y_2 + h_2), "water 2"),
        Rod(_at(x_1, y_1), _at(x_2, y_2), "tube"),
        Frame("O", vector(0, 0, 0), Axes(*(_turn.column(k) for k in (X, Y, Z))), size=0.3),
    )
)
