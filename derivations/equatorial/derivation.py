"""Equatorial tracker: a tilting cradle carries a roll axis (Ky et al., configuration 2)."""

from armillary import (
    Chain,
    Derivation,
    Rate,
    Status,
    X,
    Y,
    Z,
    atan2,
    atan2_or_zero,
    cos,
    define_motion,
    hypot,
    sin,
    unit,
    vector,
)

derivation = d = Derivation(
    "equatorial",
    title="Equatorial tracker",
    paper="ky",
    summary="A cradle on a column tilts about the east-west axis, and the collector rolls on the "
    "cradle. The paper gives the tilt to the declination and the roll to the hour angle; but a "
    "roll axis that tilts with the declination does not stay along the earth's axis, so the drives "
    "of this chain do not follow those two angles. As a tilt-roll tracker it still reaches every "
    "direction. The mount that the name promises is the polar tracker.",
)

incl = d.angle("incl", "tilt of the cradle, leaning north", rate=Rate.TICK, latex="I")
epsilon = d.angle(
    "epsilon", "roll of the collector, clockwise seen from the tip of the post", rate=Rate.TICK
)
L_0 = d.parameter.length("L_0", "height of the column, up to the tilt axis")
L_1 = d.parameter.length("L_1", "post on the cradle")
L_2 = d.parameter.length("L_2", "arm that carries the collector")
enu = d.unit_vector("enu", "unit vector to the sun", latex=r"\mathbf{c}")

# ---- the chain ----


def mount(incl, epsilon):
    """The joints of (17) from the ground up; the transposes there turn clockwise."""
    return (
        Chain("ground")
        .translate(Z, L_0)
        .rotate(X, -incl, frame="cradle")
        .translate(Z, L_1)
        .rotate(Z, -epsilon, frame="roll")
        .translate(Y, L_2, frame="collector")
    )


chain = mount(incl, epsilon)

# ---- pose and motion ----

motion = define_motion(
    d,
    chain,
    "collector",
    (incl, epsilon),
    foot="the foot of the column",
    printed={"M": "17", "Omega_space": "19", "v_spatial": "9", "V_space": "8"},
)
M = motion.M
head = vector(0, 0, L_0)

d.identity(
    "the roll axis leans north by the tilt, whatever the roll",
    M.rotation.column(2),
    vector(0, sin(incl), cos(incl)),
)
d.identity(
    "the roll takes the second axis out of the meridian, eastward; there a tilt lowers it",
    M.rotation.column(1),
    vector(sin(epsilon), cos(epsilon) * cos(incl), -cos(epsilon) * sin(incl)),
)
d.identity(
    "the post lifts the collector, and the arm lowers it as far as it points north",
    M.position.z,
    L_0 + L_1 * cos(incl) - L_2 * cos(epsilon) * sin(incl),
)
d.identity(
    "post and arm stand at right angles, so Pythagoras tells the distance from the tilt axis",
    (M.position - head).dot(M.position - head),
    L_1 * L_1 + L_2 * L_2,
)
d.identity(
    "both axes meet above the foot, so the point there moves about the tilt axis's height",
    motion.v_spatial,
    head.cross(motion.Omega_space),
)

# ---- aiming ----

axis_tolerance = d.constant(
    "axis_tolerance",
    "1e-6",
    "distance of the sun's direction from the tilt axis below which the tilt is taken as free",
    latex=r"\tau",
)
meridional = d.define(
    "meridional",
    hypot(enu.y, enu.z),
    because="The tilt axis runs east-west; this is how far the direction stands off it.",
    meaning="length of the direction's part in the meridian",
    latex=r"\rho",
)
on_axis = d.define(
    "on_axis",
    meridional < axis_tolerance,
    because="With the sun due east or west on the horizon every tilt puts the collector on it.",
    meaning="whether the tilt is free",
)
incl_aim = d.define(
    "incl_aim",
    atan2_or_zero(-enu.z, enu.y, on_axis),
    because="At roll 0 the second axis lies in the meridian, and tilting the cradle north lowers "
    "it; the tilt brings it to the sun's place there, 0 where it is free.",
    meaning="tilt that faces the sun",
    latex="I_c",
)
epsilon_aim = d.define(
    "epsilon_aim",
    atan2(enu.x, meridional),
    because="The roll then takes the second axis east by the sun's distance from the meridian. "
    "Of the two ways to reach a direction, this one has cos(epsilon) >= 0.",
    meaning="roll that faces the sun, in [-pi/2, pi/2]",
    latex=r"\epsilon_c",
)
d.identity(
    "away from the tilt axis the collector's second axis is on the sun",
    mount(atan2(-enu.z, enu.y), epsilon_aim).rotation("ground", "collector").column(1),
    unit(enu),
)

# ---- kernels ----

d.kernel(
    "aim",
    inputs=[enu],
    outputs={"incl": incl_aim, "epsilon": epsilon_aim},
    cases=[(Status.SINGULAR, on_axis, "the sun is on the tilt axis: the tilt is free")],
    summary="Drive angles that put the collector's second axis on the sun, on the branch "
    "cos(epsilon) >= 0.",
)

d.assume(
    "Inferred: the paper does not say where its axes point. That x is east, y north and z up, "
    "and which axis faces the sun, is our reading."
)
d.assume("Column, posts and collector are rigid, and the joints turn without play.")
d.picture(
    chain,
    at={"incl": -0.45, "epsilon": 0.7, "L_0": 1.0, "L_1": 0.6, "L_2": 0.5},
    sun=Y,
    caption="The mount leaning south and rolled by 40 degrees: a tilt carries a roll, and the "
    "collector's y axis is put on the sun.",
)
