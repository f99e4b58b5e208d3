"""How fast the drives move, and how they answer to every small error."""

from armillary import Matrix, X, Y, absolute, cos, elementary, hypot, partial, sin, vector, where
from armillary.algebra.vector import Basis

from .drive import aim, azimuth_point
from .frames import H_R_I, I_R_L, chain, local, normal
from .symbols import alpha, beta, c_dot, chi, d, psi, theta

# ---- the drives' own sines and cosines ----

inverse_Q = d.define(
    "inverse_Q",
    where(aim.steep, 0, aim.Q) / where(aim.steep, 1, aim.square),
    because="Speeds of the azimuth drive are divided by cos(beta): Q over its square. At the edge "
    "no speed is defined: 0 holds the axis.",
    meaning="1 / (cos(beta) cos(chi) |m|), 0 at the edge",
    latex=r"Q^{-1}",
)
inverse_across = d.define(
    "inverse_across",
    1 / where(aim.free, 1, cos(chi) * aim.across),
    because="Both sides of the azimuth's triangle stand over the length cos(chi) rho^2: no sine "
    "need be taken of an angle that was an arc tangent.",
    meaning="1 / (cos(chi) rho^2), 1 where the azimuth is free",
    latex=r"\mu",
)
sin_alpha = d.define(
    "sin_alpha",
    azimuth_point[0] * inverse_across,
    because="One side over the length.",
    meaning="sine of alpha",
    latex=r"\sin\alpha_{bc}",
)
cos_alpha = d.define(
    "cos_alpha",
    azimuth_point[1] * inverse_across,
    because="The other side over the length.",
    meaning="cosine of alpha",
    latex=r"\cos\alpha_{bc}",
)
tan_beta = d.define(
    "tan_beta",
    aim.v.z * inverse_Q,
    because="One side of the elevation's triangle over the other.",
    meaning="tangent of beta, 0 at the edge",
    latex=r"\tan\beta_{bc}",
)
inverse_size = d.define(
    "inverse_size",
    1 / (cos(chi) * where(aim.null, 1, aim.size)),
    because="Both sides of the elevation's triangle stand over the length cos(chi) |m|.",
    meaning="1 / (cos(chi) |m|^2)",
    latex=r"\nu",
)


def cradle(v, sine, cosine):
    """A vector of the azimuth axis's frame, carried through azimuth drive and inclination."""
    swung = vector(cosine * v.x - sine * v.y, sine * v.x + cosine * v.y, v.z)
    return elementary(X, chi) @ swung


# ---- rates ----

c_dot_cradle = d.define(
    "c_dot_cradle",
    cradle(I_R_L @ local(c_dot), sin_alpha, cos_alpha),
    because="The beam is held and the sun moves, so m moves as the sun does; seen from the frame "
    "that the elevation drive turns in.",
    meaning="rate of m in the frame of the elevation axis",
    latex=r"\dot{\mathbf{m}}_K",
)
alpha_dot = d.define(
    "alpha_dot",
    -c_dot_cradle.y * inverse_Q,
    because="Only the azimuth drive moves the normal along the elevation axis, by cos(beta) "
    "cos(chi) per unit of its speed.",
    meaning="rate of the azimuth drive",
    latex=r"\dot\alpha_{bc}",
)
beta_dot = d.define(
    "beta_dot",
    sin(chi) * alpha_dot + (aim.Q * c_dot_cradle.z - aim.v.z * c_dot_cradle.x) * inverse_size,
    because="The elevation drive raises the normal as m asks, and undoes what the azimuth drive "
    "turns about the inclined elevation axis.",
    meaning="rate of the elevation drive",
    latex=r"\dot\beta_{bc}",
)

# ---- the answer to small turns of the base and of the elevation axis ----

# The axes that theta, psi and chi turn about: two in the frame of the azimuth axis, the third is
# the first axis of the cradle itself.
NORTHWARD, EASTWARD = vector(0, cos(psi), sin(psi)), Basis(0)


def answer(axis, tangent):
    """Motion of the drives that undoes a unit turn about an axis of the cradle."""
    turn = (tangent * axis.x - axis.z) / cos(chi)
    return turn, sin(chi) * turn - axis.y


def answers(sine, cosine, tangent):
    """The same for the axes of theta, psi and chi: a pair each."""
    axes = (cradle(NORTHWARD, sine, cosine), cradle(EASTWARD, sine, cosine), Basis(0))
    return tuple(answer(axis, tangent) for axis in axes)


J = d.define(
    "J",
    Matrix(tuple(zip(*answers(sin_alpha, cos_alpha, tan_beta), strict=True))),
    because="The normal must not move when an axis slips, so the drives undo the slip: each column "
    "is the axis of the slip, seen from the elevation axis. Across that axis only the azimuth "
    "drive can answer, which takes 1 / cos(beta): it runs away at the edge, where 0 is returned "
    "for it. An error of m grows in J by at most 1 / cos(beta)^2.",
    meaning="derivatives of (alpha, beta) by (theta, psi, chi), a row a drive",
    latex=r"\mathbf{J}",
)
for _name, _axis, (_turn, _tilt) in zip(
    ("theta", "psi", "chi"),
    (H_R_I @ NORTHWARD, H_R_I @ EASTWARD, elementary(Y, beta) @ Basis(0)),
    answers(sin(alpha), cos(alpha), sin(beta) / cos(beta)),
    strict=True,
):
    _driven = _turn * (H_R_I @ Basis(2)) + _tilt * Basis(1)
    d.identity(
        f"the drives' answer to {_name} leaves the normal where it is",
        vector(0, _axis.y, _axis.z),
        vector(0, -_driven.y, -_driven.z),
    )

# ---- the answer to an error of the directions ----

across_axis = d.define(
    "across_axis",
    vector(cos(chi) * sin_alpha, cos(chi) * cos_alpha, -sin(chi)),
    because="The elevation axis is the second axis of the mirror, carried back through the drives.",
    meaning="elevation axis in the frame of the azimuth axis",
    latex=r"\mathbf{y}_I",
)
upward = d.define(
    "upward",
    inverse_size * aim.v.cross(across_axis) * cos(chi),
    because="The third axis of the mirror is the normal crossed with the second; over the length "
    "of m once more, because m is that much longer than the normal.",
    meaning="third axis of the mirror over the length of m",
    latex=r"\mathbf{z}_I",
)
alpha_by_m = d.define(
    "alpha_by_m",
    chain.rotation("enu", "axes") @ (-inverse_Q * across_axis),
    because="What moves m along the elevation axis is followed by the azimuth drive.",
    meaning="derivatives of alpha by the components of m",
    latex=r"\mathbf{g}_\alpha",
)
beta_by_m = d.define(
    "beta_by_m",
    sin(chi) * alpha_by_m + chain.rotation("enu", "axes") @ upward,
    because="What raises m is followed by the elevation drive, which also undoes what the azimuth "
    "drive turns about its axis.",
    meaning="derivatives of beta by the components of m",
    latex=r"\mathbf{g}_\beta",
)
response = d.define(
    "response",
    Matrix(
        (
            (alpha_by_m.x, alpha_by_m.y, alpha_by_m.z),
            (beta_by_m.x, beta_by_m.y, beta_by_m.z),
        )
    ),
    because="m is the plain sum of b and c, so an error of either is an error of m. Errors of "
    "encoders, gears and the law of motion add to the drive angles themselves.",
    meaning="derivatives of (alpha, beta) by the east, north and up components of b, and of c",
    latex=r"\mathbf{J}_m",
)

# ---- what an error does to the normal ----


def slip(axis):
    """How far a unit turn about an axis of the mirror's frame moves the normal."""
    return hypot(axis.y, axis.z)


e_theta = d.define(
    "e_theta",
    slip(H_R_I @ NORTHWARD),
    because="A turn moves the normal by the sine of the angle between axis and normal.",
    meaning="shift of the normal per unit of theta, drives held",
    latex=r"e_\theta",
)
e_psi = d.define(
    "e_psi",
    slip(H_R_I @ EASTWARD),
    because="The same for the other lean.",
    meaning="shift of the normal per unit of psi, drives held",
    latex=r"e_\psi",
)
e_chi = d.define(
    "e_chi",
    absolute(sin(beta)),
    because="The axis of chi is square to the elevation axis and beta away from the normal: a low "
    "normal does not feel it.",
    meaning="shift of the normal per unit of chi, drives held",
    latex=r"e_\chi",
)
for _shift, _error in ((e_theta, theta), (e_psi, psi), (e_chi, chi)):
    d.identity(
        f"the normal moves by this much per unit of {_error.name}",
        _shift * _shift,
        partial(normal, _error).dot(partial(normal, _error)),
    )
