"""Equatorial tracker: a tilting cradle carries a roll axis (Ky et al., configuration 2)."""

from armillary import (
    Chain,
    Derivation,
    Rate,
    Status,
    Twist,
    X,
    Y,
    Z,
    atan2,
    hypot,
    unit,
    vector,
    where,
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
incl_dot, epsilon_dot = incl.rate(), epsilon.rate()

M = d.define(
    "M",
    chain.pose("ground", "collector"),
    because="The pose of the collector is the product of its joints from the ground up.",
    meaning="pose of the collector in East-North-Up axes at the foot of the column",
    printed="17",
)

# ---- motion ----

Omega_space = d.define(
    "Omega_space",
    chain.angular_velocity("collector"),
    because="Angular velocities add, each about its axis as the joints before it have turned it.",
    meaning="angular velocity of the collector in East-North-Up axes",
    printed="19",
)
Omega_body = d.define(
    "Omega_body",
    chain.body_angular_velocity("collector"),
    because="The same sum, each axis carried inward to the collector instead of out to the ground.",
    meaning="angular velocity of the collector in its own axes",
)
v_origin = d.define(
    "v_origin",
    chain.velocity("collector"),
    because="Each joint moves the collector's origin by its axis crossed with the arm from the "
    "axis to that origin.",
    meaning="velocity of the collector's origin",
)
v_spatial = d.define(
    "v_spatial",
    chain.spatial_velocity("collector"),
    because="Each joint moves the foot of the column, taken along as a point of the collector, by "
    "its axis crossed with the arm from the axis to the foot.",
    meaning="velocity of the collector's point that passes the foot of the column",
    printed="9",
)
V_space = d.define(
    "V_space",
    Twist(Omega_space, v_spatial),
    because="The rate of the pose times its inverse is the skew matrix of the angular velocity "
    "beside the velocity of the point at the foot.",
    meaning="velocity matrix of the collector",
    printed="8",
)
J = d.define(
    "J",
    chain.jacobian("collector", (incl, epsilon)),
    because="Column by column, the motion of the collector while one drive runs at unit speed.",
    meaning="Jacobian: velocity of the collector's origin over its angular velocity",
)

d.identity("both angular velocities are one vector", Omega_space, M.rotation @ Omega_body)
d.identity(
    "the origin's velocity is that of the point at the foot and the turn about it",
    v_origin,
    v_spatial + Omega_space.cross(M.position),
)
d.identity(
    "both axes meet above the foot, so the point there moves about the tilt axis's height",
    v_spatial,
    vector(0, 0, L_0).cross(Omega_space),
)
d.identity(
    "the columns of the Jacobian, each at its drive's speed, add up to the velocity",
    J.column_vector(0) * incl_dot + J.column_vector(1) * epsilon_dot,
    v_origin,
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
    atan2(where(on_axis, 0, -enu.z), where(on_axis, 1, enu.y)),
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
    "pose",
    inputs=[incl, epsilon],
    outputs=[M],
    summary="Pose of the collector.",
)
d.kernel(
    "velocity",
    inputs=[incl, epsilon, incl_dot, epsilon_dot],
    outputs=[Omega_space, Omega_body, v_origin, v_spatial, V_space],
    summary="Motion of the collector while the drives run.",
)
d.kernel(
    "jacobian",
    inputs=[incl, epsilon],
    outputs=[J],
    summary="Motion of the collector per unit speed of each drive.",
)
d.kernel(
    "aim",
    inputs=[enu],
    outputs={"incl": incl_aim, "epsilon": epsilon_aim},
    cases=[(Status.SINGULAR, on_axis, "the sun is on the tilt axis: the tilt is free")],
    summary="Drive angles that put the collector's second axis on the sun, on the branch "
    "cos(epsilon) >= 0.",
)

d.assume("Column, posts and collector are rigid, and the joints turn without play.")
d.picture(
    chain,
    at={"incl": -0.45, "epsilon": 0.7, "L_0": 1.0, "L_1": 0.6, "L_2": 0.5},
    sun=Y,
    caption="The mount leaning south and rolled by 40 degrees: a tilt carries a roll, and the "
    "collector's y axis is put on the sun.",
)
