"""Polar tracker: a true equatorial mount, hour axis along the earth's axis."""

from armillary import (
    PI,
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
    wrap,
)

derivation = d = Derivation(
    "polar",
    title="Polar tracker",
    paper="ky",
    summary="The mount that the paper's equatorial tracker sets out to be: a fixed tilt lays the "
    "first drive along the earth's axis, where it runs at the steady speed of the hour angle, and "
    "a second drive on top follows the declination.",
)

epsilon = d.angle(
    "epsilon", "hour drive, clockwise seen from the tip of the polar axis", rate=Rate.TICK
)
D = d.angle("D", "declination drive", rate=Rate.TICK)
L_0 = d.parameter.length("L_0", "height of the column, up to the fixed tilt")
L_1 = d.parameter.length("L_1", "post along the polar axis")
L_2 = d.parameter.length("L_2", "arm that carries the collector")
incl = d.parameter.angle(
    "incl", "fixed tilt of the polar axis from the zenith, leaning north", latex="I"
)
enu = d.unit_vector("enu", "unit vector to the sun", latex=r"\mathbf{c}")
sun = d.use("sun")
latitude, declination = sun.quantity("latitude"), sun.quantity("declination")
hour_angle = sun.quantity("hour_angle")

# ---- the chain ----


def mount(incl, epsilon, D):
    """Fixed tilt, hour axis and declination axis from the ground up, all turning clockwise."""
    return (
        Chain("ground")
        .translate(Z, L_0)
        .rotate(X, -incl)
        .translate(Z, L_1, frame="polar")
        .rotate(Z, -epsilon, frame="hour")
        .rotate(X, -D, frame="cradle")
        .translate(Y, L_2, frame="collector")
    )


chain = mount(incl, epsilon, D)

# ---- pose and motion ----

motion = define_motion(
    d,
    chain,
    "collector",
    (epsilon, D),
    foot="the foot of the column",
    printed={"v_spatial": "9", "V_space": "8"},
)
M = motion.M
pole = vector(0, sin(incl), cos(incl))
head = vector(0, L_1 * sin(incl), L_0 + L_1 * cos(incl))

d.identity(
    "the hour axis leans north by the fixed tilt",
    chain.rotation("ground", "hour").column(2),
    pole,
)
d.identity(
    "the declination drive takes the second axis below the plane across the hour axis",
    M.rotation.column(1).dot(pole),
    -sin(D),
)
d.identity(
    "the hour drive takes what is left of it in that plane eastward",
    M.rotation.column(1).x,
    cos(D) * sin(epsilon),
)
d.identity(
    "the declination axis stays in that plane, and leaves the east as the hour drive turns",
    M.rotation.column(0),
    vector(cos(epsilon), -sin(epsilon) * cos(incl), sin(epsilon) * sin(incl)),
)
d.identity(
    "the post lifts the collector; the arm lowers it as it points north or the drive lowers it",
    M.position.z,
    head.z - L_2 * (cos(epsilon) * cos(D) * sin(incl) + sin(D) * cos(incl)),
)
d.identity(
    "the end of the arm keeps the arm's length from the head of the post",
    (M.position - head).dot(M.position - head),
    L_2 * L_2,
)
d.identity(
    "both drives turn about the head of the post, so the point at the foot moves about it",
    motion.v_spatial,
    head.cross(motion.Omega_space),
)

# ---- aiming ----

axis_tolerance = d.constant(
    "axis_tolerance",
    "1e-6",
    "distance of the sun's direction from the polar axis below which the hour drive is free",
    latex=r"\tau",
)
polar_sun = d.define(
    "polar_sun",
    chain.rotation("polar", "ground") @ enu,
    because="Seen from the polar axis, the fixed tilt is undone.",
    meaning="direction to the sun in the axes of the fixed tilt",
    latex=r"\mathbf{c}_p",
)


def offset_from_axis(seen):
    """Length of a direction's part across the polar axis."""
    return hypot(seen.x, seen.y)


across = d.define(
    "across",
    offset_from_axis(polar_sun),
    because="This is how far the direction stands off the polar axis.",
    meaning="length of the direction's part across the polar axis",
    latex=r"\rho",
)
on_axis = d.define(
    "on_axis",
    across < axis_tolerance,
    because="With the sun on the polar axis every hour angle puts the collector on it. The real "
    "sun comes there only where the fixed tilt is far from the pole.",
    meaning="whether the hour drive is free",
)
epsilon_aim = d.define(
    "epsilon_aim",
    atan2_or_zero(polar_sun.x, polar_sun.y, on_axis),
    because="The collector's second axis starts at the second axis of the fixed tilt and turns "
    "clockwise with the hour drive: 0 where the drive is free.",
    meaning="hour drive that faces the sun",
    latex=r"\epsilon_c",
)
D_aim = d.define(
    "D_aim",
    atan2(-polar_sun.z, across),
    because="A positive declination drive lowers the second axis away from the polar axis's tip. "
    "Of the two ways to reach a direction, this one has cos(D) >= 0.",
    meaning="declination drive that faces the sun, in [-pi/2, pi/2]",
    latex="D_c",
)
d.identity(
    "away from the polar axis the collector's second axis is on the sun",
    mount(incl, atan2(polar_sun.x, polar_sun.y), D_aim).rotation("ground", "collector").column(1),
    unit(enu),
)

# ---- setting ----

incl_set = d.define(
    "incl_set",
    PI / 2 - latitude,
    because="The pole stands as high as the latitude, so the axis leans from the zenith by the "
    "rest of a right angle.",
    meaning="fixed tilt that lays the hour axis along the earth's axis",
    latex=r"I_\varphi",
)
epsilon_set = d.define(
    "epsilon_set",
    wrap(hour_angle + PI),
    because="The hour axis turns with the sun; at noon the collector's second axis must look "
    "south, half a turn from where it starts.",
    meaning="hour drive that follows the hour angle, in [-pi, pi]",
    latex=r"\epsilon_\omega",
)
D_set = d.define(
    "D_set",
    -declination,
    because="The declination drive lowers the collector where the declination raises the sun.",
    meaning="declination drive that follows the declination",
    latex=r"D_\delta",
)
d.identity(
    "at the setting the collector's second axis is on the sun",
    mount(incl_set, hour_angle + PI, D_set).rotation("ground", "collector").column(1),
    sun["enu"],
)

# ---- kernels ----

d.kernel(
    "aim",
    inputs=[enu],
    outputs={"epsilon": epsilon_aim, "D": D_aim},
    cases=[(Status.SINGULAR, on_axis, "the sun is on the polar axis: the hour drive is free")],
    summary="Drive angles that put the collector's second axis on the sun, on the branch "
    "cos(D) >= 0.",
)
d.kernel(
    "setting",
    inputs=[latitude, declination, hour_angle],
    outputs={"incl": incl_set, "epsilon": epsilon_set, "D": D_set},
    summary="Fixed tilt and drive angles of a mount at a latitude, straight from the sun's own "
    "angles.",
)

d.assume("Column, posts and collector are rigid, and the joints turn without play.")
d.assume("The fixed tilt lays the hour axis along the earth's axis, in the meridian.")
d.picture(
    chain,
    at={"incl": 0.75, "epsilon": 3.9, "D": -0.3, "L_0": 1.0, "L_1": 0.6, "L_2": 0.5},
    sun=Y,
    caption="The mount at 47 degrees north on a summer afternoon. The hour axis points to the "
    "celestial pole; the collector's y axis is on the sun.",
)
