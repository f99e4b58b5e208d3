"""Altazimuth tracker: a vertical axis carries a horizontal one (Ky et al., configuration 1)."""

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
    "altazimuth",
    title="Altazimuth tracker",
    paper="ky",
    summary="A turntable on a column turns about the vertical; a cradle on the turntable tilts "
    "about a horizontal axis and carries the collector. The two angles are the sun's azimuth and "
    "its distance from the zenith.",
)

gamma = d.angle("gamma", "azimuth drive angle, clockwise seen from above", rate=Rate.TICK)
upsilon = d.angle("upsilon", "tilt of the collector from the zenith", rate=Rate.TICK)
L_0 = d.parameter.length("L_0", "height of the column")
L_1 = d.parameter.length("L_1", "post on the turntable, up to the horizontal axis")
L_2 = d.parameter.length("L_2", "arm of the cradle that carries the collector")
enu = d.unit_vector("enu", "unit vector to the sun", latex=r"\mathbf{c}")

# ---- the chain ----


def mount(gamma, upsilon):
    """The joints of (14) from the ground up; the transposes there turn clockwise."""
    return (
        Chain("ground")
        .translate(Z, L_0)
        .rotate(Z, -gamma, frame="turntable")
        .translate(Z, L_1)
        .rotate(X, -upsilon, frame="cradle")
        .translate(Y, L_2, frame="collector")
    )


chain = mount(gamma, upsilon)
gamma_dot, upsilon_dot = gamma.rate(), upsilon.rate()

M = d.define(
    "M",
    chain.pose("ground", "collector"),
    because="The pose of the collector is the product of its joints from the ground up. The post "
    "comes before the tilt, so only the arm swings with the cradle.",
    meaning="pose of the collector in East-North-Up axes at the foot of the column",
    printed="14",
)

# ---- motion ----

Omega_space = d.define(
    "Omega_space",
    chain.angular_velocity("collector"),
    because="Angular velocities add, each about its axis as the joints before it have turned it.",
    meaning="angular velocity of the collector in East-North-Up axes",
    printed="16",
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
    chain.jacobian("collector", (gamma, upsilon)),
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
    "the vertical axis passes through the foot, so only the tilt moves the point there",
    v_spatial,
    upsilon_dot * (M.rotation @ vector(1, 0, 0)).cross(vector(0, 0, L_0 + L_1)),
)
d.identity(
    "the columns of the Jacobian, each at its drive's speed, add up to the velocity",
    J.column_vector(0) * gamma_dot + J.column_vector(1) * upsilon_dot,
    v_origin,
)

# ---- aiming ----

zenith_tolerance = d.constant(
    "zenith_tolerance",
    "1e-6",
    "horizontal length of the sun's direction below which the azimuth is taken as free",
    latex=r"\tau",
)
horizontal = d.define(
    "horizontal",
    hypot(enu.x, enu.y),
    because="The shadow of a unit pole that points to the sun has this length.",
    meaning="length of the direction's horizontal part",
    latex=r"\rho",
)
at_zenith = d.define(
    "at_zenith",
    horizontal < zenith_tolerance,
    because="With the sun overhead every azimuth puts the collector on it.",
    meaning="whether the azimuth is free",
)
gamma_aim = d.define(
    "gamma_aim",
    atan2(where(at_zenith, 0, enu.x), where(at_zenith, 1, enu.y)),
    because="The cradle leans towards where the turntable points, so the turntable turns to the "
    "sun's azimuth: 0 where it is free.",
    meaning="azimuth drive angle that faces the sun",
    latex=r"\gamma_c",
)
upsilon_aim = d.define(
    "upsilon_aim",
    atan2(horizontal, enu.z),
    because="The cradle leans from the zenith by the sun's distance from it; of the two ways to "
    "reach a direction, this one never leans backwards.",
    meaning="tilt that faces the sun, in [0, pi]",
    latex=r"\upsilon_c",
)
d.identity(
    "away from the zenith the collector's third axis is on the sun",
    mount(atan2(enu.x, enu.y), upsilon_aim).rotation("ground", "collector").column(2),
    unit(enu),
)

# ---- kernels ----

d.kernel(
    "pose",
    inputs=[gamma, upsilon],
    outputs=[M],
    summary="Pose of the collector.",
)
d.kernel(
    "velocity",
    inputs=[gamma, upsilon, gamma_dot, upsilon_dot],
    outputs=[Omega_space, Omega_body, v_origin, v_spatial, V_space],
    summary="Motion of the collector while the drives run.",
)
d.kernel(
    "jacobian",
    inputs=[gamma, upsilon],
    outputs=[J],
    summary="Motion of the collector per unit speed of each drive.",
)
d.kernel(
    "aim",
    inputs=[enu],
    outputs={"gamma": gamma_aim, "upsilon": upsilon_aim},
    cases=[(Status.SINGULAR, at_zenith, "the sun is at the zenith: the azimuth is free")],
    summary="Drive angles that put the collector's third axis on the sun.",
)

d.assume("Column, turntable, cradle and collector are rigid, and the joints turn without play.")
d.assume("The azimuth axis is vertical, the tilt axis horizontal, and the two meet.")
d.picture(
    chain,
    at={"gamma": 1.35, "upsilon": 0.9, "L_0": 1.2, "L_1": 0.5, "L_2": 0.5},
    sun=Z,
    caption="The mount at an azimuth of 77 degrees, tilted 52 degrees from the zenith. "
    "Both angles turn clockwise; the collector's z axis is put on the sun.",
)
