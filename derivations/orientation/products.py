"""The four triples as products of turns, and how they hang together."""

from armillary import PI, X, Y, Z, cos, elementary, sin, vector

from .symbols import a, attitude, b, c, d, turns

zxz = turns((Z, a), (X, b), (Z, c))
zyz = turns((Z, a), (Y, b), (Z, c))
zyx = turns((Z, a), (Y, b), (X, c))
tilt_torsion = turns((Z, a), (Y, b), (Z, c - a))

R_zxz = d.define(
    "R_zxz",
    attitude(zxz),
    because="Turn about z, about the turned x, about the z that this brings. The paper prints this "
    "product beside the words ZYZ Euler or tilt and torsion; it is neither.",
    meaning="attitude by the ZXZ triple",
    latex=r"R_{\mathrm{ZXZ}}",
)
R_zyz = d.define(
    "R_zyz",
    attitude(zyz),
    because="The same with y for x: the Euler angles of robot wrists.",
    meaning="attitude by the ZYZ triple",
    latex=r"R_{\mathrm{ZYZ}}",
)
R_zyx = d.define(
    "R_zyx",
    attitude(zyx),
    because="Yaw, pitch and roll: three different axes, so its singular set is a quarter turn away "
    "from rest instead of at rest.",
    meaning="attitude by the ZYX triple",
    latex=r"R_{\mathrm{ZYX}}",
)
R_tilt_torsion = d.define(
    "R_tilt_torsion",
    attitude(tilt_torsion),
    because="Lean by b towards the direction a, and turn by c about the leaning axis: the last "
    "turn first undoes the turn that only chose the direction.",
    meaning="attitude by tilt and torsion",
    latex=r"R_{\mathrm{TT}}",
)

d.identity(
    "ZXZ is ZYZ with the first angle a quarter turn less and the third a quarter turn more",
    R_zxz,
    elementary(Z, a - PI / 2) @ elementary(Y, b) @ elementary(Z, c + PI / 2),
)
d.identity(
    "so at equal angles the ZXZ body leans a quarter turn behind the one of ZYZ and of tilt and "
    "torsion, and the product printed for both is neither",
    R_zxz.column(Z),
    elementary(Z, -PI / 2) @ R_tilt_torsion.column(Z),
)
d.identity(
    "tilt and torsion lean as ZYZ does",
    R_tilt_torsion.column(Z),
    R_zyz.column(Z),
)
tilt_alone = elementary(Z, a) @ elementary(Y, b) @ elementary(Z, -a)
level_axis = vector(-sin(a), cos(a), 0)
d.identity(
    "the tilt is one turn, about a level axis square to its direction",
    tilt_alone @ level_axis,
    level_axis,
)
d.identity(
    "tilt and torsion is that turn after the torsion",
    R_tilt_torsion,
    tilt_alone @ elementary(Z, c),
)
