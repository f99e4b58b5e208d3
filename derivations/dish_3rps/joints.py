"""Angles of the passive joints, and how fast the hinges turn."""

from armillary import atan2, vector, where

from .facet import n_P, u
from .rates import h_dot, reach_dot
from .rods import h, l_rod, length, reach
from .symbols import d, rod_tolerance

p_R = d.define(
    "p_R",
    atan2(reach, where(l_rod > rod_tolerance, h, rod_tolerance)),
    because="The rod leans in the plane of its hinge.",
    meaning="angle of hinge i: of the rod from the vertical, outward positive",
    latex="p",
)
p_dot = d.define(
    "p_dot",
    (h * reach_dot - reach * h_dot) / (length * length),
    because="Differentiate that angle.",
    meaning="rate of hinge i",
    latex=r"\dot{p}",
)
_BS = vector(reach * u.x, reach * u.y, h)  # what BS is, by the closed form
s = d.define(
    "s",
    atan2(_BS.cross(n_P).norm(), _BS.dot(n_P)),
    because="The cone of an S-joint is fixed in the facet, about its normal.",
    meaning="angle of S-joint i: between rod and normal, in [0, pi]",
    latex="s",
)
