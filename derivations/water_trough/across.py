"""The trough in three dimensions: what a container off the plane of symmetry would ask for.

The plane z = 0 need not be one of symmetry here. Where it is, one freedom is enough.
"""

from armillary import Matrix, Rate, Z, cos, elementary, sin, substitute, time_derivative, vector
from armillary.derivation.units import METRE, NEWTON, NEWTON_METRE

from .balance import AXIS, F_A, F_B, F_all
from .motion import needed
from .symbols import (
    AREA,
    FIRST,
    SECOND_MOMENT,
    d,
    g,
    omega,
    q,
    r_A,
    r_B,
    rho,
    theta,
    x_1,
    x_2,
    y_1,
    y_2,
)  # fmt: skip
from .water import Gamma, S, h_1, h_2, inertia, m_1, m_2


def off(name, meaning, unit, latex, usual):
    """Something that symmetry makes 0."""
    return d.scalar(
        name, meaning, unit=unit, latex=latex, limits=(-1e5, 1e5), range=usual, rate=Rate.MOUNT
    )


z_1 = off("z_1", "place of container 1 along the axis", METRE, "z_1", (-0.3, 0.3))
z_2 = off("z_2", "place of container 2 along the axis", METRE, "z_2", (-0.3, 0.3))
S_z = off("S_z", "first moment along z of all but the containers' water", FIRST, "S_z", (-5.0, 5.0))
D_xi = off(
    "D_xi", "product of inertia of xi and z of all but the containers' water", SECOND_MOMENT,
    r"D_\xi", (-2.0, 2.0),
)  # fmt: skip
D_eta = off("D_eta", "the same of eta and z", SECOND_MOMENT, r"D_\eta", (-2.0, 2.0))
G_xi = off(
    "G_xi", "integral of eta d(z) - z d(eta) along the tube from container 2 to 1", AREA,
    r"\Gamma_\xi", (-0.3, 0.3),
)  # fmt: skip
G_eta = off("G_eta", "integral of z d(xi) - xi d(z) along it", AREA, r"\Gamma_\eta", (-0.3, 0.3))
OFFSETS = [z_1, z_2, S_z, D_xi, D_eta, G_xi, G_eta]
_MOMENT = {"unit": SECOND_MOMENT, "limits": (0.0, 1e6), "range": (1.0, 50.0)}
I_xx = d.scalar("I_xx", "moment of inertia of all mass about xi", latex="I_{xx}", **_MOMENT)
I_yy = d.scalar("I_yy", "moment of inertia of all mass about eta", latex="I_{yy}", **_MOMENT)
I_xy = d.scalar(
    "I_xy", "product of inertia of all mass of xi and eta", unit=SECOND_MOMENT,
    limits=(-1e6, 1e6), range=(-5.0, 5.0), latex="I_{xy}",
)  # fmt: skip

S_all = d.define(
    "S_all",
    vector(S.x, S.y, S_z + m_1 * z_1 + m_2 * z_2),
    because="The containers may stand at different places along the axis.",
    meaning="first mass moment with its part along the axis",
    unit=FIRST,
    latex=r"\mathbf{S}^{*}",
)
I_xz = d.define(
    "I_xz",
    D_xi + m_1 * x_1 * z_1 + m_2 * x_2 * z_2,
    because="Each column of water adds its mass at its centre.",
    meaning="product of inertia of all mass of xi and z",
    unit=SECOND_MOMENT,
    latex="I_{xz}",
)
I_yz = d.define(
    "I_yz",
    D_eta + m_1 * (y_1 + h_1 / 2) * z_1 + m_2 * (y_2 + h_2 / 2) * z_2,
    because="The same along eta, where the centre of a column is at half of its height.",
    meaning="product of inertia of all mass of eta and z",
    unit=SECOND_MOMENT,
    latex="I_{yz}",
)
_spin = omega * AXIS
spinning = d.define(
    "spinning",
    omega * vector(-I_xz, -I_yz, inertia),
    because="The third column of the tensor of inertia, times the angular velocity.",
    meaning="moment of momentum about O of the turn",
    latex=r"\mathbf{J}\boldsymbol{\omega}",
)
d.identity(
    "about z neither I_xx nor I_yy enters",
    vector(
        vector(I_xx, -I_xy, -I_xz).dot(_spin),
        vector(-I_xy, I_yy, -I_yz).dot(_spin),
        vector(-I_xz, -I_yz, inertia).dot(_spin),
    ),
    spinning,
)
flowing = d.define(
    "flowing",
    (rho * q) * vector(G_xi - z_1 * h_1 + z_2 * h_2, G_eta, Gamma),
    because="The flow's arm, now with all three components.",
    meaning="moment of momentum about O of the flow",
    latex=r"\mathbf{L}_q",
)
_up = vector(sin(theta), cos(theta), 0)
M_O = d.define(
    "M_O",
    time_derivative(spinning + flowing) + _spin.cross(spinning + flowing) + S_all.cross(g * _up),
    because="Newton and Euler: the rate of the moment of momentum, in a frame that turns, is the "
    "moment of what acts. The weight's own moment is taken off.",
    meaning="moment about O that must act from outside, besides the weight",
    unit=NEWTON_METRE,
    latex=r"\mathbf{M}_O",
)
d.identity(
    "its part about the axis is what Lagrange's equation needs, symmetric or not",
    M_O.dot(AXIS),
    needed,
)
F_z = d.define(
    "F_z",
    time_derivative(time_derivative(S_all.z)),
    because="Only water that is moved along the axis takes a force along it.",
    meaning="force along the axis that must act from outside",
    unit=NEWTON,
    latex="F_z",
)
M_across = d.define(
    "M_across",
    vector(M_O.y, -M_O.x, 0),
    because="A pair of opposite forces on the bearings gives the moment across the axis.",
    meaning="moment across the axis, turned by a right angle about it",
    unit=NEWTON_METRE,
    latex=r"\mathbf{M}_\perp",
)


def bearing(name, arm, sign):
    """The force of a bearing, level and upward, with the pair that the moment takes."""
    world = elementary(Z, theta) @ ((arm * F_all + sign * M_across) / (r_A + r_B))
    return d.define(
        f"{name}_off",
        Matrix(((world.x, world.y),)),
        because="Both forces together, and their moment about O, are known: two vectors for two.",
        meaning=f"force of bearing {name[-1]} on the trough without symmetry, level and upward",
        unit=NEWTON,
        latex=rf"\mathbf{{F}}_{name[-1]}^{{*}}",
    )


F_A_off, F_B_off = bearing("F_A", r_B, 1), bearing("F_B", r_A, -1)


def _of(matrix):
    return vector(*matrix.rows[0], 0)


d.identity(
    "the two forces give that moment about O",
    (r_A * AXIS).cross(_of(F_A_off)) - (r_B * AXIS).cross(_of(F_B_off)),
    elementary(Z, theta) @ vector(M_O.x, M_O.y, 0),
)
SYMMETRIC = dict.fromkeys(OFFSETS, 0)
d.identity(
    "with the plane z = 0 one of symmetry no moment across the axis is left",
    substitute(M_across, SYMMETRIC),
    vector(0, 0, 0),
)
d.identity("and no force along it", substitute(F_z, SYMMETRIC), 0 * F_all.x)
for _name, _off, _split in (("A", F_A_off, F_A), ("B", F_B_off, F_B)):
    d.identity(
        f"and bearing {_name} has its share of the force by the distances alone",
        substitute(_of(_off), SYMMETRIC),
        _of(_split),
    )
