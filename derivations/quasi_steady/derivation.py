"""Quasi-steady tracker: one tilt follows the declination (Ky et al., configuration 3)."""

from armillary import Chain, Derivation, Rate, X, Y, Z, cos, define_motion, sin, vector

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

# ---- pose and motion ----

motion = define_motion(
    d,
    chain,
    "collector",
    (incl,),
    foot="the foot of the column",
    printed={"M": "20", "Omega_space": "22", "v_spatial": "9", "V_space": "8"},
    because={
        "Omega_space": "The collector turns about the east-west axis, and a positive tilt is "
        "clockwise.",
        "Omega_body": "The axis is fixed in the collector as it is in the ground.",
        "J": "The motion of the collector while the tilt runs at unit speed.",
    },
)
M = motion.M
head = vector(0, 0, L_0)

d.identity(
    "the collector's third axis leans north by the tilt",
    M.rotation.column(2),
    vector(0, sin(incl), cos(incl)),
)
d.identity("its first axis stays on the east", M.rotation.column(0), vector(1, 0, 0))
d.identity(
    "the post lifts the collector, and the arm lowers it as it leans north",
    M.position.z,
    L_0 + L_1 * cos(incl) - L_2 * sin(incl),
)
d.identity(
    "post and arm stand at right angles, so Pythagoras tells the distance from the tilt axis",
    (M.position - head).dot(M.position - head),
    L_1 * L_1 + L_2 * L_2,
)
d.identity(
    "the point at the foot moves about the tilt axis's height",
    motion.v_spatial,
    head.cross(motion.Omega_space),
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
    "aim",
    inputs=[latitude, declination],
    outputs={"incl": incl_aim},
    summary="Tilt that puts the collector's third axis on the sun at apparent noon.",
)

d.assume(
    "Inferred: the paper does not say where its axes point. That x is east, y north and z up, "
    "and which axis faces the sun, is our reading."
)
d.assume("Column, post and collector are rigid, and the joint turns without play.")
d.picture(
    chain,
    at={"incl": -0.5, "L_0": 1.0, "L_1": 0.6, "L_2": 0.5},
    sun=Z,
    caption="The collector leans south, to the noon sun of a northern site. A positive angle "
    "would lean it north.",
)
