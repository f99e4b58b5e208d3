"""The rates of the angles by the angular velocity."""

from armillary import Z, absolute, cos, elementary, sin, where

from .symbols import Omega, a, b, d, tolerance

w = d.define(
    "w",
    elementary(Z, -a) @ Omega,
    because="All four begin with a turn about z. Seen from behind it, the second axis is one of "
    "the frame's own.",
    meaning="angular velocity in axes that have turned by the first angle",
    latex=r"\mathbf{w}",
)
b_upright = d.define(
    "b_upright",
    absolute(sin(b)) < tolerance,
    because="There the first and the third axis are one line, and an angular velocity square to "
    "both lines of turning cannot be had.",
    meaning="whether the rates of ZXZ, ZYZ and tilt and torsion are singular",
)
sine_or_one = where(b_upright, 1, sin(b))
c_dot_zxz = d.define(
    "c_dot_zxz",
    where(b_upright, w.z * cos(b), -w.y / sine_or_one),
    because="Only the third axis leaves the plane of the vertical and the line of nodes. Where it "
    "does not, the first angle rests and the third carries what both would.",
    meaning="rate of the third angle of ZXZ",
    latex=r"\dot{c}_{\mathrm{ZXZ}}",
)
a_dot_zxz = d.define(
    "a_dot_zxz",
    where(b_upright, 0, w.z - c_dot_zxz * cos(b)),
    because="What the third angle does not turn about the vertical, the first one does.",
    meaning="rate of the first angle of ZXZ",
    latex=r"\dot{a}_{\mathrm{ZXZ}}",
)
c_dot_zyz = d.define(
    "c_dot_zyz",
    where(b_upright, w.z * cos(b), w.x / sine_or_one),
    because="As for ZXZ, with the second axis along y.",
    meaning="rate of the third angle of ZYZ",
    latex=r"\dot{c}_{\mathrm{ZYZ}}",
)
a_dot_zyz = d.define(
    "a_dot_zyz",
    where(b_upright, 0, w.z - c_dot_zyz * cos(b)),
    because="The rest of the turn about the vertical; it is the rate of the tilt's direction too.",
    meaning="rate of the first angle of ZYZ and of the direction of the tilt",
    latex=r"\dot{a}_{\mathrm{ZYZ}}",
)
half_cosine = where(b_upright, 1, cos(b / 2))
c_dot_tilt_torsion = d.define(
    "c_dot_tilt_torsion",
    where(b_upright, w.z * cos(b), w.z + w.x * (sin(b / 2) / half_cosine)),
    because="The sum of both rates of ZYZ: the tangent of half the tilt is all that is left of two "
    "quotients that grow without bound near rest, so the torsion is regular there.",
    meaning="rate of the torsion",
    latex=r"\dot{c}_{\mathrm{TT}}",
)
b_vertical = d.define(
    "b_vertical",
    absolute(cos(b)) < tolerance,
    because="There yaw and roll turn about one line.",
    meaning="whether the rates of ZYX are singular",
)
c_dot_zyx = d.define(
    "c_dot_zyx",
    where(b_vertical, -w.z * sin(b), w.x / where(b_vertical, 1, cos(b))),
    because="Only the third axis has a part along the turned x axis. Where it has none, the first "
    "angle rests.",
    meaning="rate of the third angle of ZYX",
    latex=r"\dot{c}_{\mathrm{ZYX}}",
)
a_dot_zyx = d.define(
    "a_dot_zyx",
    where(b_vertical, 0, w.z + c_dot_zyx * sin(b)),
    because="What the roll does not turn about the vertical, the yaw does.",
    meaning="rate of the first angle of ZYX",
    latex=r"\dot{a}_{\mathrm{ZYX}}",
)
