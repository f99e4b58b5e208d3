"""Quasi-steady tracker: one tilt follows the declination (Ky et al., configuration 3)."""

from armillary import Chain, Derivation, Rate, Twist, X, Y, Z, vector

derivation = d = Derivation(
    "quasi_steady",
    title="Quasi-steady tracker",
    paper="ky",
    summary="One east-west axis, set by hand every few days, keeps the collector facing the noon "
    "sun while the declination drifts through the year.",
)

incl = d.angle("incl", "tilt of the collector, leaning north", rate=Rate.DAY, latex="I")
L_0 = d.parameter.length("L_0", "height of the column, up to the tilt axis")
L_1 = d.parameter.length("L_1", "post on the tilt axis")
L_2 = d.parameter.length("L_2", "arm that carries the collector")
sun = d.use("sun")
latitude, declination = sun.quantity("latitude"), sun.quantity("declination")

# ---- the chain ----


def mount(incl):
    """The joints of (20) from the ground up; the transpose there turns clockwise."""
    return (
        Chain("ground")
        .translate(Z, L_0)
        .rotate(X, -incl)
        .translate(Z, L_1)
        .translate(Y, L_2, frame="collector")
    )


chain = mount(incl)
incl_dot = incl.rate()

M = d.define(
    "M",
    chain.pose("ground", "collector"),
    because="The pose of the collector is the product of its joints from the ground up.",
    meaning="pose of the collector in East-North-Up axes at the foot of the column",
    printed="20",
)

# ---- motion ----

Omega_space = d.define(
    "Omega_space",
    chain.angular_velocity("collector"),
    because="The collector turns about the east-west axis, and a positive tilt is clockwise.",
    meaning="angular velocity of the collector in East-North-Up axes",
    printed="22",
)
Omega_body = d.define(
    "Omega_body",
    chain.body_angular_velocity("collector"),
    because="The axis is fixed in the collector as it is in the ground.",
    meaning="angular velocity of the collector in its own axes",
)
v_origin = d.define(
    "v_origin",
    chain.velocity("collector"),
    because="The joint moves the collector's origin by its axis crossed with the arm from the "
    "axis to that origin.",
    meaning="velocity of the collector's origin",
)
v_spatial = d.define(
    "v_spatial",
    chain.spatial_velocity("collector"),
    because="The joint moves the foot of the column, taken along as a point of the collector, by "
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
    chain.jacobian("collector", (incl,)),
    because="The motion of the collector while the tilt runs at unit speed.",
    meaning="Jacobian: velocity of the collector's origin over its angular velocity",
)

d.identity("both angular velocities are one vector", Omega_space, M.rotation @ Omega_body)
d.identity(
    "the origin's velocity is that of the point at the foot and the turn about it",
    v_origin,
    v_spatial + Omega_space.cross(M.position),
)
d.identity(
    "the point at the foot moves about the tilt axis's height",
    v_spatial,
    vector(0, 0, L_0).cross(Omega_space),
)
d.identity(
    "the column of the Jacobian, at the tilt's speed, is the velocity",
    J.column_vector(0) * incl_dot,
    v_origin,
)

# ---- aiming ----

incl_aim = d.define(
    "incl_aim",
    declination - latitude,
    because="At noon the sun stands as far south of the zenith as the latitude exceeds the "
    "declination, and a positive tilt leans north. The difference is not wrapped: it stays within "
    "2 rad for every latitude on earth.",
    meaning="tilt that faces the noon sun",
    latex="I_c",
)
d.identity(
    "the collector's third axis is on the noon sun",
    mount(incl_aim).rotation("ground", "collector").column(2),
    sun["enu_at_noon"],
)

# ---- kernels ----

d.kernel(
    "pose",
    inputs=[incl],
    outputs=[M],
    summary="Pose of the collector.",
)
d.kernel(
    "velocity",
    inputs=[incl, incl_dot],
    outputs=[Omega_space, Omega_body, v_origin, v_spatial, V_space],
    summary="Motion of the collector while the tilt runs.",
)
d.kernel(
    "jacobian",
    inputs=[incl],
    outputs=[J],
    summary="Motion of the collector per unit speed of the tilt.",
)
d.kernel(
    "aim",
    inputs=[latitude, declination],
    outputs={"incl": incl_aim},
    summary="Tilt that puts the collector's third axis on the sun at apparent noon.",
)

d.assume("Column, post and collector are rigid, and the joint turns without play.")
d.picture(
    chain,
    at={"incl": -0.5, "L_0": 1.0, "L_1": 0.6, "L_2": 0.5},
    sun=Z,
    caption="The collector leans south, to the noon sun of a northern site. A positive angle "
    "would lean it north.",
)
