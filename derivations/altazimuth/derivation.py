"""Altazimuth tracker: a vertical axis carries a horizontal one (Ky et al., configuration 1)."""

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

# ---- pose and motion ----

motion = define_motion(
    d,
    chain,
    "collector",
    (gamma, upsilon),
    foot="the foot of the column",
    printed={"M": "14", "Omega_space": "16", "v_spatial": "9", "V_space": "8"},
    because={
        "M": "The pose of the collector is the product of its joints from the ground up. The post "
        "comes before the tilt, so only the arm swings with the cradle."
    },
)
M = motion.M
head = vector(0, 0, L_0 + L_1)
tilt_axis = vector(cos(gamma), -sin(gamma), 0)

d.identity(
    "the collector faces the turntable's azimuth, as far from the zenith as the cradle is tilted",
    M.rotation.column(2),
    vector(sin(gamma) * sin(upsilon), cos(gamma) * sin(upsilon), cos(upsilon)),
)
d.identity(
    "the tilt axis stays level, a quarter turn clockwise from that azimuth",
    M.rotation.column(0),
    tilt_axis,
)
d.identity(
    "tilting lowers the end of the arm from the height of the post's head",
    M.position.z,
    L_0 + L_1 - L_2 * sin(upsilon),
)
d.identity(
    "the end of the arm keeps the arm's length from the post's head",
    (M.position - head).dot(M.position - head),
    L_2 * L_2,
)
d.identity(
    "the vertical axis passes through the foot, so only the tilt moves the point there",
    motion.v_spatial,
    upsilon.rate() * tilt_axis.cross(head),
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
    atan2_or_zero(enu.x, enu.y, at_zenith),
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
    "aim",
    inputs=[enu],
    outputs={"gamma": gamma_aim, "upsilon": upsilon_aim},
    cases=[(Status.SINGULAR, at_zenith, "the sun is at the zenith: the azimuth is free")],
    summary="Drive angles that put the collector's third axis on the sun.",
)

d.assume(
    "Inferred: the paper does not say where its axes point. That x is east, y north and z up, "
    "and which axis faces the sun, is our reading."
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
