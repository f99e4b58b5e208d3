"""The facet on its three hinged rods: what is given to it, and what its hinges make of the rest."""

from armillary import (
    PI,
    Axes,
    Chain,
    Leg,
    Matrix,
    Place,
    Platform,
    Pose,
    X,
    Y,
    Z,
    cos,
    elementary,
    matrix,
    number,
    sin,
    tilted,
    total,
    vector,
    where,
)

from .dish import R_D, M_dish, n_O, slope_length
from .symbols import (
    alpha,
    beta,
    d,
    dist,
    f,
    face_down_tolerance,
    leg,
    phi,
    r_b,
    r_m,
    tau,
    theta,
    z_O,
)

# ---- axes of the base ----

H_T_P = d.define(
    "H_T_P",
    Pose(
        elementary(Z, phi) @ elementary(Z, -PI), vector(dist * cos(phi), dist * sin(phi), number(0))
    ),
    because="The base stands below the facet's point of a level dish; its x axis looks at the "
    "dish's axis.",
    meaning="pose of the facet's base, {P}, in {H}",
    printed="9",
    latex="{}^{H}T_{P}",
)


def half_turn(v):
    """A vector of {P} in axes that look away from the dish's axis, and back."""
    return elementary(Z, PI) @ v


def from_base(v):
    """Components in {H} of a vector given in {P}."""
    return H_T_P.rotation @ v


def to_base(v):
    """Components in {P} of a vector given in {H}."""
    return H_T_P.rotation.transpose() @ v


# ---- what is given: normal and height ----

psi = d.define(
    "psi",
    alpha - phi,
    because="Seen from its base, each facet is the same but for where the sun stands.",
    meaning="azimuth of the dish's axis from that of the facet",
    latex=r"\psi",
)
seen = Chain("facet").rotate(Z, psi).rotate(Y, beta).rotate(Z, -psi, frame="dish")
_R = seen.rotation("facet", "dish")
n_P = d.define(
    "n_P",
    half_turn(_R @ (vector(-dist, 0, 2 * f) / slope_length)),
    because="The facet's normal is that of the dish at its point: two freedoms.",
    meaning="unit normal of the facet, {P}",
    latex=r"\mathbf{n}",
)
d.identity("it is the normal of the dish, turned with it", from_base(n_P), R_D @ n_O)
arm_D = d.define(
    "arm_D",
    half_turn(_R @ vector(dist, 0, dist * dist / (4 * f))),
    because="The dish's point turns with the dish.",
    meaning="from the vertex to the facet's point of the dish, {P}",
    latex=r"\mathbf{r}_D",
)
D_P = d.define(
    "D_P",
    arm_D + vector(dist, 0, z_O),
    because="In {P} the dish's vertex stands at d along the x axis, at the height z_O.",
    meaning="the facet's point of the dish, {P}",
    latex=r"\mathbf{D}_P",
)
d.identity("it is the point that the dish carries", H_T_P.position + from_base(D_P), M_dish)
z_M = d.define(
    "z_M",
    D_P.z,
    because="The facet's point is as high as the dish's: the third freedom.",
    meaning="height of the facet's point above the ground",
    latex="z_M",
)
face_down = d.define(
    "face_down",
    ~(1 + n_P.z > face_down_tolerance),
    because="A facet that hangs face down is tilted about no one axis.",
    meaning="whether the facet hangs face down",
)
lean = d.define(
    "lean",
    where(face_down, number(1), 1 + n_P.z),
    because="This is divided by.",
    meaning="1 + n_z, twice the squared cosine of half the tilt",
    latex=r"\lambda",
)

# ---- what the hinges make of it: no torsion ----
# The lemma is told with the attitude of the dish, which is any tilt, and a torsion after it.

u = d.define(
    "u",
    vector(cos(theta), sin(theta), number(0)),
    because="Joint i of the base and of the platform stand at one azimuth, a third of a turn "
    "apart.",
    meaning="unit vector to joint i: of the base in {P}, of the platform in {M}",
    latex=r"\mathbf{u}",
)
t = d.define(
    "t",
    vector(-sin(theta), cos(theta), number(0)),
    because="The hinge of a rod lies across the way to its joint, so that the rod keeps to the "
    "upright plane through the base's centre.",
    meaning="axis of the hinge of rod i, {P}",
    latex=r"\mathbf{t}",
)
twisted = d.define(
    "twisted",
    total(t.dot((R_D @ elementary(Z, tau)) @ u), over=leg),
    because="Each S-joint is in the plane of its hinge: t.(M + r_m R u) = 0. The three hinge axes "
    "add up to nothing, so the sum of the three conditions does not know where M is; it knows "
    "the attitude alone, here a tilt with a torsion tau.",
    meaning="sum of the three plane conditions over r_m",
    latex=r"\Sigma",
)
d.identity(
    "the sum is 3/2 (1 + n_z) sin(tau): the hinges allow no torsion",
    twisted,
    number("1.5") * (1 + R_D.column(Z).z) * sin(tau),
)

_tilt = tilted(n_P, lean)
a_x = d.define(
    "a_x",
    _tilt.x,
    because="The x axis of {P}, tilted by the shortest way: what of it is square to the normal and "
    "to the vertical stays as it is.",
    meaning="x axis of the facet, {P}",
    latex=r"\mathbf{a}_x",
)
a_y = d.define(
    "a_y",
    _tilt.y,
    because="And the y axis.",
    meaning="y axis of the facet, {P}",
    latex=r"\mathbf{a}_y",
)
tilt = Axes(a_x, a_y, n_P)
n_any = R_D.column(Z)  # any normal at all: alpha and beta take every value
_any = tilted(n_any)
for _axis, _name in ((X, "x"), (Y, "y")):
    d.identity(
        f"a tilt without torsion follows from its normal alone: its {_name} axis",
        _any.column(_axis),
        R_D.column(_axis),
    )

# ---- and where the facet stands ----


def aside(n, lean):
    """Where the hinges put the point of a facet with the normal n, {P}."""
    return r_m * (n.y * n.y - n.x * n.x) / (2 * lean), r_m * n.x * n.y / lean


_aside = aside(n_P, lean)
x_M = d.define(
    "x_M",
    _aside[0],
    because="The difference of the conditions of rods 2 and 3 leaves x alone: as the facet tilts, "
    "its S-joints draw in, and it must step aside to keep them in their planes.",
    meaning="parasitic motion of the facet's point along the x axis of {P}",
    printed="14",
    latex="x_M",
)
y_M = d.define(
    "y_M",
    _aside[1],
    because="The plane of the first hinge is y = 0.",
    meaning="parasitic motion of the facet's point along the y axis of {P}",
    printed="15",
    latex="y_M",
)
M_P = d.define(
    "M_P",
    vector(x_M, y_M, z_M),
    because="Two that the hinges decide, and the height that is given.",
    meaning="the facet's point, {P}",
    latex=r"\mathbf{M}_P",
)
H_R_M = d.define(
    "H_R_M",
    Axes(*map(from_base, tilt.columns)).matrix(),
    because="The tilt, from the base's axes to East-North-Up.",
    meaning="rotation of the facet: its axes in {H}; x looks at the dish's axis, z is the normal",
    latex="{}^{H}R_{M}",
)
M = d.define(
    "M",
    H_T_P.position + from_base(M_P),
    because="The base stands at the facet's azimuth.",
    meaning="the facet's point, {H}",
    latex=r"\mathbf{M}",
)
H_T_M = d.define(
    "H_T_M",
    Matrix(
        (
            *((*row, part) for row, part in zip(H_R_M.rows, (M.x, M.y, M.z), strict=True)),
            matrix((0, 0, 0, 1)).rows[0],
        )
    ),
    because="Rotation beside point, as the print has it.",
    meaning="pose of the facet, {H}: its rotation beside the position of its point in m",
    printed="12",
    latex="{}^{H}T_{M}",
)
off_P = d.define(
    "off_P",
    vector(x_M - D_P.x, y_M - D_P.y, 0),
    because="The dish would carry its point further than the rods let it.",
    meaning="from the dish's point to the facet's, {P}",
    latex=r"\Delta_P",
)
off_dish = d.define(
    "off_dish",
    from_base(off_P),
    because="The same in East-North-Up.",
    meaning="from the dish's point to the facet's, {H}",
    latex=r"\Delta\mathbf{M}",
)

# ---- the platform ----

rod = Leg(base_joint=r_b * u, platform_joint=vector(r_m * u.x, r_m * u.y, 0), plane=t)
platform = Platform(Place(tilt, M_P), (rod,))


any_platform = Platform(Place(_any, vector(*aside(n_any, 1 + n_any.z), z_O)), (rod,))
d.identity(
    "each S-joint is in the plane of its hinge, whatever the normal",
    any_platform.leg.plane_residual,
    number(0),
)
