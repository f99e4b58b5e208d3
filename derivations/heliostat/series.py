"""The laws for small misalignments, to first and second order together in theta, psi and chi."""

from fractions import Fraction

from armillary import (
    Status,
    atan2,
    cos,
    hypot,
    sin,
    truncate,
    vector,
    where,
)

from .drive import azimuth_point, closed_form, elevation_point
from .frames import H_R_I, I_R_L, local
from .optics import m, opposed
from .symbols import alpha, beta, chi, d, edge_tolerance, psi, theta

SMALL = (theta, psi, chi)

I_R_L_first = truncate(I_R_L, 1, SMALL)
H_R_I_first = truncate(H_R_I, 1, SMALL)
I_R_L_1 = d.define(
    "I_R_L_1",
    I_R_L_first.value,
    because="To first order a small rotation adds the cross product with its angles. The print "
    "keeps theta psi, which is of second order, and leaves out others of that order.",
    meaning="rotation of local components into those of the azimuth axis, to first order",
    latex=r"{}_I\mathbf{R}_L^{(1)}",
)
H_R_I_1 = d.define(
    "H_R_I_1",
    H_R_I_first.value,
    because="The inclination is small, the drive angles are not.",
    meaning="rotation of components of the azimuth axis into the mirror's, to first order",
    latex=r"{}_H\mathbf{R}_I^{(1)}",
)

# ---- the drive with ideal axes ----

m_L = d.define(
    "m_L",
    local(m),
    because="South, east and up.",
    meaning="sum of the directions to receiver and sun, in local axes",
    latex=r"\mathbf{m}_L",
)
overhead = d.define(
    "overhead",
    ~(m_L.x * m_L.x + m_L.y * m_L.y > edge_tolerance * edge_tolerance * m.dot(m)),
    because="With ideal axes the azimuth is free at the zenith only.",
    meaning="whether the wanted normal is at the zenith or the nadir",
)
level = d.define(
    "level",
    hypot(m_L.x, m_L.y),
    because="How far the sum reaches out.",
    meaning="horizontal length of m",
    latex=r"\rho_L",
)
inverse_level = d.define(
    "inverse_level",
    where(overhead, 0, 1 / where(overhead, 1, level)),
    because="Corrections are divided by it; at the zenith, where they diverge, they are left out.",
    meaning="1 over the horizontal length of m, 0 at the zenith",
    latex=r"\rho_L^{-1}",
)
south_ideal = d.define(
    "south_ideal",
    where(overhead, 1, m_L.x),
    because="At the zenith every azimuth will do, and 0 is taken.",
    meaning="southern part of m, 1 at the zenith",
    latex="x_0",
)
east_ideal = d.define(
    "east_ideal",
    where(overhead, 0, m_L.y),
    because="At the zenith every azimuth will do, and 0 is taken.",
    meaning="eastern part of m, 0 at the zenith",
    latex="y_0",
)
level_ideal = d.define(
    "level_ideal",
    where(opposed, 1, level),
    because="Without a normal there is no height either.",
    meaning="horizontal length of m, 1 where there is no normal",
    latex=r"\rho_0",
)
alpha_ideal = d.define(
    "alpha_ideal",
    atan2(-east_ideal, south_ideal),
    because="With ideal axes the azimuth drive turns from south to west as the normal does.",
    meaning="azimuth drive angle if the axes were ideal",
    latex=r"\alpha^{(0)}",
)
beta_ideal = d.define(
    "beta_ideal",
    atan2(m_L.z, level_ideal),
    because="With ideal axes the elevation drive stands at the normal's elevation.",
    meaning="elevation drive angle if the axes were ideal",
    latex=r"\beta^{(0)}",
)

# ---- the laws ----


class Law:
    """The corrections of both drives, in the words of the sky.

    Attributes:
        tangent: of the normal's elevation.
        to: how far the axis leans towards the normal's azimuth.
        aside: how far it leans across, a quarter turn on.
    """

    def __init__(self, tangent, to, aside):
        self.tangent, self.to, self.aside = tangent, to, aside

    def first(self):
        """What is linear in the misalignments."""
        return self.tangent * (chi + self.aside), self.to

    def second(self):
        """What is of second order in them."""
        square = self.tangent * self.tangent
        across = chi * (1 + square) + self.aside * (square + Fraction(1, 2))
        turn = self.to * across - theta * psi / 2
        return turn, self.tangent * (chi * chi - self.aside * self.aside) / 2


def leaning(south, east):
    """How the azimuth axis leans towards a direction and across it."""
    return psi * east - theta * south, theta * east + psi * south


tangent = d.define(
    "tangent",
    m_L.z * inverse_level,
    because="Everything sideways is magnified by it.",
    meaning="tangent of the normal's elevation, 0 at the zenith",
    latex="t",
)
_to, _aside = leaning(m_L.x * inverse_level, m_L.y * inverse_level)
lean_to = d.define(
    "lean_to",
    _to,
    because="An axis that leans towards the normal takes it down; the elevation drive raises it "
    "by as much.",
    meaning="lean of the azimuth axis towards the azimuth of the normal",
    latex="p",
)
lean_aside = d.define(
    "lean_aside",
    _aside,
    because="An axis that leans across carries the normal aside as it rises.",
    meaning="lean of the azimuth axis across the azimuth of the normal",
    latex="w",
)
law = Law(tangent, lean_to, lean_aside)
(alpha_1, beta_1), (alpha_2, beta_2) = law.first(), law.second()

alpha_first = d.define(
    "alpha_first",
    alpha_ideal + alpha_1,
    because="Inclination and lean aside move the azimuth by the tangent of the elevation, which "
    "diverges at the zenith.",
    meaning="azimuth drive angle to first order; not brought back into [-pi, pi]",
    latex=r"\alpha^{(1)}",
)
beta_first = d.define(
    "beta_first",
    beta_ideal + beta_1,
    because="The lean towards the normal is all that the elevation needs; chi does not matter to "
    "this order.",
    meaning="elevation drive angle to first order",
    latex=r"\beta^{(1)}",
)
alpha_second = d.define(
    "alpha_second",
    alpha_first + where(overhead, 0, alpha_2),
    because="All products of two errors are kept, and none of three. The last of them tells which "
    "lean comes first.",
    meaning="azimuth drive angle to second order; not brought back into [-pi, pi]",
    latex=r"\alpha^{(2)}",
)
beta_second = d.define(
    "beta_second",
    beta_first + beta_2,
    because="Here chi appears: an inclined axis loses height, which the elevation makes up for, "
    "and a lean aside gains some.",
    meaning="elevation drive angle to second order",
    latex=r"\beta^{(2)}",
)


# A direction whose ideal drive angles are alpha and beta; its length does not matter.
_height = sin(beta) / cos(beta)
_direction = vector(cos(alpha), -sin(alpha), _height)
_plain = Law(_height, *leaning(cos(alpha), -sin(alpha)))
_expanded = [truncate(angle, 2, SMALL) for angle in closed_form(I_R_L @ _direction)]
for _order, _terms in ((1, _plain.first()), (2, _plain.second())):
    for _angle, _series, _term in zip(("azimuth", "elevation"), _expanded, _terms, strict=True):
        d.identity(
            f"these are all the terms of order {_order} of the exact {_angle}",
            _series.terms[_order],
            _term,
        )

# ---- the error angles of (1) and (2) ----


def difference(first, second):
    """The angle of one point less that of another, in [-pi, pi]."""
    (y, x), (w, u) = first, second
    return atan2(y * u - x * w, x * u + y * w)


Delta_A = d.define(
    "Delta_A",
    difference((-east_ideal, south_ideal), azimuth_point),
    because="Calculated angle, with the axes taken as ideal, minus valid angle: the angle between "
    "the two points whose angles these are, so that no whole turn comes in.",
    meaning="error of the azimuth drive if the axes are taken as ideal, in [-pi, pi]",
    printed="1",
    latex=r"\Delta_A",
)
Delta_h = d.define(
    "Delta_h",
    difference((m_L.z, level_ideal), elevation_point),
    because="The same about the second axis, counted upward. The paper calls the angle zenithal, "
    "as it calls the axis; it does not say from where it counts.",
    meaning="error of the elevation drive if the axes are taken as ideal, in [-pi, pi]",
    printed="2",
    latex=r"\Delta_h",
)

law_cases = [
    (Status.UNREACHABLE, opposed, "b = -c within 1e-6: no normal is singled out"),
    (
        Status.SINGULAR,
        overhead,
        "the normal is within 1e-6 of the zenith or the nadir: alpha is 0, nothing is corrected",
    ),
]
