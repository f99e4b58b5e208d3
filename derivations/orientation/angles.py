"""The angles of a given attitude."""

from armillary import X, Y, Z, atan2, cos, hypot, sin, vector, where

from .products import R_tilt_torsion, R_zxz, R_zyx, R_zyz, level_axis
from .symbols import R, a, b, c, d, tolerance


def nodes(rotation):
    """Square to both third axes: where the planes of base and body cross. Length sin(b)."""
    return vector(-rotation.entry(Y, Z), rotation.entry(X, Z), 0)


def level_of_zyx(rotation):
    """Square to the vertical and to the body's first axis, level. Length cos(b)."""
    return vector(-rotation.entry(Y, X), rotation.entry(X, X), 0)


d.identity(
    "the line of nodes of ZXZ lies at the first angle",
    nodes(R_zxz),
    sin(b) * vector(cos(a), sin(a), 0),
)
d.identity(
    "and its shadows on the body's first two axes tell the third angle",
    vector(nodes(R_zxz).dot(R_zxz.column(X)), nodes(R_zxz).dot(R_zxz.column(Y)), 0),
    sin(b) * vector(cos(c), -sin(c), 0),
)
d.identity(
    "that of ZYZ lies a quarter turn further",
    nodes(R_zyz),
    sin(b) * level_axis,
)
d.identity(
    "and its shadows tell the third angle of ZYZ",
    vector(nodes(R_zyz).dot(R_zyz.column(Y)), nodes(R_zyz).dot(R_zyz.column(X)), 0),
    sin(b) * vector(cos(c), sin(c), 0),
)
d.identity(
    "the level axis of ZYX lies a quarter turn from the first angle",
    level_of_zyx(R_zyx),
    cos(b) * level_axis,
)
d.identity(
    "and its shadows on the body's last two axes tell the third angle",
    vector(level_of_zyx(R_zyx).dot(R_zyx.column(Y)), level_of_zyx(R_zyx).dot(R_zyx.column(Z)), 0),
    cos(b) * vector(cos(c), -sin(c), 0),
)
d.identity(
    "the torsion stands in the entries of the attitude at every tilt but a half turn",
    vector(
        R_tilt_torsion.entry(X, X) + R_tilt_torsion.entry(Y, Y),
        R_tilt_torsion.entry(Y, X) - R_tilt_torsion.entry(X, Y),
        0,
    ),
    (1 + cos(b)) * vector(cos(c), sin(c), 0),
)

lean = d.define(
    "lean",
    hypot(R.entry(X, Z), R.entry(Y, Z)),
    because="A unit vector that leans by b casts a level shadow of this length.",
    meaning="sine of the angle between the third axes of base and body",
    latex=r"\rho",
)
upright = d.define(
    "upright",
    lean < tolerance,
    because="Where the third axes are one line, turns about either do the same: only their sum, or "
    "their difference, is told by the attitude.",
    meaning="whether the first angle of ZXZ, ZYZ and tilt and torsion is free",
)
b_euler = d.define(
    "b_euler",
    atan2(lean, R.entry(Z, Z)),
    because="Both the sine and the cosine are used, so that no digit is lost near rest, where the "
    "arc cosine of an entry loses half of them.",
    meaning="angle between the third axes of base and body, in [0, pi]",
    latex="b_R",
)
N_zxz = d.define(
    "N_zxz",
    vector(where(upright, 1, -R.entry(Y, Z)), where(upright, 0, R.entry(X, Z)), 0),
    because="The line of nodes is square to both third axes. Where they are one line it is laid "
    "along the base's x axis, which makes the first angle 0.",
    meaning="along the line of nodes, which is the second axis of ZXZ",
    latex=r"\mathbf{n}_{\mathrm{ZXZ}}",
)
a_zxz = d.define(
    "a_zxz",
    atan2(N_zxz.y, N_zxz.x),
    because="The first turn brings the x axis onto the line of nodes.",
    meaning="first angle of ZXZ, in [-pi, pi]",
    latex=r"a_{\mathrm{ZXZ}}",
)
c_zxz = d.define(
    "c_zxz",
    atan2(-N_zxz.dot(R.column(Y)), N_zxz.dot(R.column(X))),
    because="The third turn brings the x axis from the line of nodes to the body's first axis. "
    "Measured from the line that was taken, it carries the whole turn where the first is free.",
    meaning="third angle of ZXZ, in [-pi, pi]",
    latex=r"c_{\mathrm{ZXZ}}",
)
N_zyz = d.define(
    "N_zyz",
    vector(where(upright, 0, -R.entry(Y, Z)), where(upright, 1, R.entry(X, Z)), 0),
    because="The same line; where the third axes are one it is laid along the base's y axis.",
    meaning="along the line of nodes, which is the second axis of ZYZ",
    latex=r"\mathbf{n}_{\mathrm{ZYZ}}",
)
a_zyz = d.define(
    "a_zyz",
    atan2(-N_zyz.x, N_zyz.y),
    because="The first turn brings the y axis onto the line of nodes. For tilt and torsion it is "
    "the direction of the tilt.",
    meaning="first angle of ZYZ and direction of the tilt, in [-pi, pi]",
    latex=r"a_{\mathrm{ZYZ}}",
)
cosine_zyz = d.define(
    "cosine_zyz",
    N_zyz.dot(R.column(Y)),
    because="The line of nodes is the body's second axis before the third turn.",
    meaning="length of the line of nodes times the cosine of the third angle",
    latex=r"u_{\mathrm{ZYZ}}",
)
sine_zyz = d.define(
    "sine_zyz",
    N_zyz.dot(R.column(X)),
    because="The third turn takes the first axis towards it.",
    meaning="length of the line of nodes times the sine of the third angle",
    latex=r"w_{\mathrm{ZYZ}}",
)
c_zyz = d.define(
    "c_zyz",
    atan2(sine_zyz, cosine_zyz),
    because="The common length drops out.",
    meaning="third angle of ZYZ, in [-pi, pi]",
    latex=r"c_{\mathrm{ZYZ}}",
)
above = d.define(
    "above",
    R.entry(Z, Z) > 0,
    because="Up to a quarter turn of tilt the entries tell the torsion by themselves.",
    meaning="whether the tilt is less than a quarter turn",
)
c_tilt_torsion = d.define(
    "c_tilt_torsion",
    atan2(
        where(above, R.entry(Y, X) - R.entry(X, Y), N_zyz.y * sine_zyz - N_zyz.x * cosine_zyz),
        where(above, R.entry(X, X) + R.entry(Y, Y), N_zyz.y * cosine_zyz + N_zyz.x * sine_zyz),
    ),
    because="With less than a quarter turn of tilt these sums of entries are the torsion's sine "
    "and cosine times a factor between 1 and 2, so it is not singular at rest, where the direction "
    "of the tilt is. Beyond, that factor goes to 0, and the torsion is the sum of the first and "
    "the third angle of ZYZ, formed from their sines and cosines so that it lies in one turn.",
    meaning="torsion, in [-pi, pi]",
    latex=r"c_{\mathrm{TT}}",
)

steep = d.define(
    "steep",
    hypot(R.entry(X, X), R.entry(Y, X)),
    because="The body's first axis dips by b and casts a level shadow of this length.",
    meaning="cosine of the pitch",
    latex=r"\kappa",
)
vertical = d.define(
    "vertical",
    steep < tolerance,
    because="With the first axis upright, yaw and roll turn about one line.",
    meaning="whether the first angle of ZYX is free",
)
N_zyx = d.define(
    "N_zyx",
    vector(where(vertical, 0, -R.entry(Y, X)), where(vertical, 1, R.entry(X, X)), 0),
    because="The second axis of ZYX is level and square to the body's first axis; where that is "
    "upright it is laid along the base's y axis.",
    meaning="along the second axis of ZYX",
    latex=r"\mathbf{n}_{\mathrm{ZYX}}",
)
a_zyx = d.define(
    "a_zyx",
    atan2(-N_zyx.x, N_zyx.y),
    because="The first turn brings the y axis there.",
    meaning="first angle of ZYX, in [-pi, pi]",
    latex=r"a_{\mathrm{ZYX}}",
)
b_zyx = d.define(
    "b_zyx",
    atan2(-R.entry(Z, X), steep),
    because="A positive pitch dips the first axis.",
    meaning="second angle of ZYX, in [-pi/2, pi/2]",
    latex=r"b_{\mathrm{ZYX}}",
)
c_zyx = d.define(
    "c_zyx",
    atan2(-N_zyx.dot(R.column(Z)), N_zyx.dot(R.column(Y))),
    because="The third turn takes the body's second axis from that line.",
    meaning="third angle of ZYX, in [-pi, pi]",
    latex=r"c_{\mathrm{ZYX}}",
)
