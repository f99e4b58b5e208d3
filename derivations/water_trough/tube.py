"""Moments of a tube of straight parts, so that nobody needs to integrate along it."""

from armillary import sqrt
from armillary.derivation.units import KILOGRAM, METRE

from .symbols import AREA, FIRST, SECOND_MOMENT, a_t, d, rho

_CORNER = {"unit": METRE, "limits": (-100.0, 100.0)}


def corner(name, meaning, usual, latex):
    """A coordinate of an end of a part."""
    return d.scalar(name, meaning, range=usual, latex=latex, **_CORNER)


xi_a = corner("xi_a", "where a straight part of the tube begins, along xi", (0.0, 1.0), r"\xi_a")
eta_a = corner("eta_a", "where it begins, along eta", (-0.5, 0.1), r"\eta_a")
xi_b = corner("xi_b", "where it ends, on the way to container 1, along xi", (-1.0, 0.0), r"\xi_b")
eta_b = corner("eta_b", "where it ends, along eta", (-0.5, 0.1), r"\eta_b")
ENDS = [xi_a, eta_a, xi_b, eta_b]

L_part = d.define(
    "L_part",
    sqrt((xi_b - xi_a) * (xi_b - xi_a) + (eta_b - eta_a) * (eta_b - eta_a)),
    because="A straight part. What is said of a part adds up along the tube, to its length L_t "
    "and its moments.",
    meaning="length of a straight part of the tube",
    unit=METRE,
    latex=r"\delta L",
)
m_part = d.define(
    "m_part",
    rho * a_t * L_part,
    because="The tube is full.",
    meaning="mass of its water",
    unit=KILOGRAM,
    latex=r"\delta m",
)
S_xi_part, S_eta_part = (
    d.define(
        f"S_{axis}_part",
        m_part * (a + b) / 2,
        because="Its centre is half way.",
        meaning=f"first moment of its water along {axis}",
        unit=FIRST,
        latex=rf"\delta S_\{axis}",
    )
    for axis, a, b in (("xi", xi_a, xi_b), ("eta", eta_a, eta_b))
)
I_part = d.define(
    "I_part",
    m_part
    * (xi_a * xi_a + xi_a * xi_b + xi_b * xi_b + eta_a * eta_a + eta_a * eta_b + eta_b * eta_b)
    / 3,
    because="The mean of the square of what changes evenly from a to b is (a^2 + a b + b^2)/3.",
    meaning="second moment of its water about the axis",
    unit=SECOND_MOMENT,
    latex=r"\delta I",
)
Gamma_part = d.define(
    "Gamma_part",
    xi_a * eta_b - eta_a * xi_b,
    because="Twice the triangle of the axis and both ends.",
    meaning="twice the area that it sweeps about the axis",
    unit=AREA,
    latex=r"\delta\Gamma",
)
