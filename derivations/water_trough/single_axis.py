"""Tracking law of any single axis, with backtracking on a slope."""

from armillary import (
    PI,
    Chain,
    Kind,
    Rate,
    X,
    Y,
    Z,
    absolute,
    arccos,
    atan2,
    cos,
    elementary,
    hypot,
    sin,
    vector,
    where,
)  # fmt: skip

from .symbols import d, theta

_FIXED = {"rate": Rate.MOUNT}
enu = d.unit_vector("enu", "unit vector to the sun", latex=r"\mathbf{c}")
axis_azimuth = d.angle(
    "axis_azimuth",
    "azimuth of the direction towards which the axis slopes down, clockwise from north",
    range=(0.0, 6.3), latex=r"A", **_FIXED,
)  # fmt: skip
axis_tilt = d.angle(
    "axis_tilt", "tilt of the axis against the level", range=(0.0, 1.5), latex=r"\beta_a", **_FIXED
)
axis_tolerance = d.constant(
    "axis_tolerance",
    "1e-6",
    "part of the sun's direction across the axis below which its rotation is taken as free",
    latex=r"\tau_a",
)
_axis = Chain("enu").rotate(Z, -axis_azimuth).rotate(X, -axis_tilt, frame="axis")
sun = d.define(
    "sun",
    _axis.rotation("axis", "enu") @ enu,
    because="The axis points down the slope; x is across it and level, z is what a trough faces "
    "that is not turned.",
    meaning="unit vector to the sun, frame of the axis: y along it",
    latex=r"\mathbf{c}_a",
)
across = d.define(
    "across",
    hypot(sun.x, sun.z),
    because="Only this part of the direction can be followed.",
    meaning="part of the sun's direction across the axis",
)
along_axis = d.define(
    "along_axis",
    across < axis_tolerance,
    because="Seen along the axis the sun has no side.",
    meaning="whether the sun stands in the line of the axis",
)
down = d.define(
    "down",
    enu.z < 0,
    because="The centre of the sun, without refraction.",
    meaning="whether the sun is below the horizon",
)
ideal = d.define(
    "ideal",
    where(along_axis, 0, atan2(where(along_axis, 0, sun.x), where(along_axis, 1, sun.z))),
    because="The trough turns about y, right-handed, until it faces the sun as well as it can.",
    meaning="rotation of the axis at which the trough faces the sun, in [-pi, pi]",
    latex="R",
)


def incidence_at(rotation):
    """The angle between sun and normal at a rotation."""
    c, s_ = cos(rotation), sin(rotation)
    left = hypot(sun.x * c - sun.z * s_, sun.y)
    return atan2(left, sun.x * s_ + sun.z * c)


incidence = d.define(
    "incidence",
    atan2(absolute(sun.y), across),
    because="What is left is the sun's own angle to the plane across the axis.",
    meaning="angle between the sun and the trough's normal, in [0, pi/2]",
    latex=r"\theta_i",
)
d.identity(
    "at its rotation the trough faces the sun but for the part along the axis",
    elementary(Y, -atan2(sun.x, sun.z)) @ sun,
    vector(0, sun.y, across),
)
mounted = elementary(X, PI / 2) @ elementary(Y, PI)
d.identity(
    "in the axis' frame the trough's xi is -x, its eta z and its own axis y",
    mounted @ enu,
    vector(-enu.x, enu.z, enu.y),
)
d.identity(
    "so mounted, theta of the trough is the rotation of the axis",
    mounted @ elementary(Z, theta),
    elementary(Y, theta) @ mounted,
)

# ---- backtracking ----

gcr = d.parameter.scalar(
    "gcr",
    "ground cover ratio: width of a collector over the level distance of two axes, on a slope too",
    kind=Kind.NON_NEGATIVE, limits=(1e-3, 1e3), range=(0.1, 0.9), latex="G",
)  # fmt: skip
cross_axis_tilt = d.parameter.angle(
    "cross_axis_tilt",
    "slope across the axes, in the plane that they are normal to: positive where the ground falls "
    "towards x, which is to the right of one who looks down the axis",
    limits=(-1.57, 1.57), range=(-0.3, 0.3), latex=r"\beta_c",
)  # fmt: skip
_STROKE = {"limits": (-3.2, 3.2)}
rotation_min = d.parameter.angle(
    "rotation_min", "least rotation", range=(-1.6, 0.0), latex=r"R_\mathrm{min}", **_STROKE
)
rotation_max = d.parameter.angle(
    "rotation_max", "greatest rotation", range=(0.0, 1.6), latex=r"R_\mathrm{max}", **_STROKE
)
crossed = d.define(
    "crossed",
    rotation_max < rotation_min,
    because="A range whose ends are exchanged is a mistake.",
    meaning="whether the limits of the rotation exclude each other",
)
_cover = gcr * cos(cross_axis_tilt)
shadow = d.define(
    "shadow",
    absolute(cos(ideal - cross_axis_tilt)) / _cover,
    because="On the slope two axes are farther apart than on the level. Seen along the sun's rays, "
    "they stand apart by this many widths of a collector. The size is taken, as the sun may stand "
    "below the rows' plane.",
    meaning="apparent distance of two axes over the width of a collector",
    latex="D",
)
shaded = d.define(
    "shaded",
    (shadow < 1) & ~along_axis,
    because="Closer than a width, a row stands in the shadow of the next. From along the axis no "
    "sun shines on it.",
    meaning="whether rows would shade each other",
)
back = d.define(
    "back",
    ideal - where(shaded, where(ideal < 0, -1, 1) * arccos(where(shaded, shadow, 1)), 0),
    because="Turned back by the angle whose cosine is that distance, a row just clears the next.",
    meaning="rotation at which no row shades the next, without limits",
    latex="R_b",
)
rotation = d.define(
    "rotation",
    where(back < rotation_min, rotation_min, where(back > rotation_max, rotation_max, back)),
    because="The stroke ends where it ends.",
    meaning="rotation that the trough is given",
    latex=r"R_\mathrm{lim}",
)
beyond = d.define(
    "beyond",
    ~(~(back < rotation_min) & ~(back > rotation_max)),
    because="A limit was met.",
    meaning="whether the rotation was cut at a limit",
)
incidence_back = d.define(
    "incidence_back",
    incidence_at(rotation),
    because="Sine over cosine of the angle between sun and normal.",
    meaning="angle between the sun and the trough's normal, in [0, pi]",
    latex=r"\theta_b",
)
