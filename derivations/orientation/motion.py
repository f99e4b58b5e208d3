"""Angular velocity by the rates of the angles, and where the way back is lost."""

from armillary import Matrix, cos, sin, vector

from .products import tilt_torsion, zxz, zyx, zyz
from .symbols import a, b, c, d


def rate_map(chain):
    """Columns: the body's angular velocity while one angle runs at unit speed."""
    return Matrix(chain.jacobian("body", (a, b, c)).rows[3:])


def determinant(matrix):
    """The volume that the columns span."""
    first, second, third = (matrix.column_vector(j) for j in range(3))
    return first.dot(second.cross(third))


Omega_zxz = d.define(
    "Omega_zxz",
    zxz.angular_velocity("body"),
    because="Each angle turns the body about its own axis, as the turns before have carried it.",
    meaning="angular velocity of the body in base axes, vee(Rdot R^T)",
    latex=r"\boldsymbol{\Omega}_{\mathrm{ZXZ}}",
)
Omega_zyz = d.define(
    "Omega_zyz",
    zyz.angular_velocity("body"),
    because="The same sum, with the second axis of ZYZ.",
    meaning="angular velocity of the body in base axes, vee(Rdot R^T)",
    latex=r"\boldsymbol{\Omega}_{\mathrm{ZYZ}}",
)
Omega_zyx = d.define(
    "Omega_zyx",
    zyx.angular_velocity("body"),
    because="The same sum, with the third axis of ZYX.",
    meaning="angular velocity of the body in base axes, vee(Rdot R^T)",
    latex=r"\boldsymbol{\Omega}_{\mathrm{ZYX}}",
)
Omega_tilt_torsion = d.define(
    "Omega_tilt_torsion",
    tilt_torsion.angular_velocity("body"),
    because="The same sum. The first angle turns forth about the vertical and back about the "
    "leaning axis.",
    meaning="angular velocity of the body in base axes, vee(Rdot R^T)",
    latex=r"\boldsymbol{\Omega}_{\mathrm{TT}}",
)

E_zxz = d.define(
    "E_zxz",
    rate_map(zxz),
    because="Its columns are the three axes in base components.",
    meaning="rate map of ZXZ: angular velocity from the rates of the angles",
    latex=r"E_{\mathrm{ZXZ}}",
)
E_zyz = d.define(
    "E_zyz",
    rate_map(zyz),
    because="Its columns are the three axes in base components.",
    meaning="rate map of ZYZ",
    latex=r"E_{\mathrm{ZYZ}}",
)
E_zyx = d.define(
    "E_zyx",
    rate_map(zyx),
    because="Its columns are the three axes in base components.",
    meaning="rate map of ZYX",
    latex=r"E_{\mathrm{ZYX}}",
)
E_tilt_torsion = d.define(
    "E_tilt_torsion",
    rate_map(tilt_torsion),
    because="The first column is the difference of the vertical and the leaning axis.",
    meaning="rate map of tilt and torsion",
    latex=r"E_{\mathrm{TT}}",
)

d.identity(
    "the rate map of ZXZ is singular where the second angle brings the third axis back to the "
    "first: its determinant is the sine",
    determinant(E_zxz),
    -sin(b),
)
d.identity("so is that of ZYZ", determinant(E_zyz), -sin(b))
d.identity("that of ZYX is singular a quarter turn away", determinant(E_zyx), -cos(b))
d.identity("that of tilt and torsion where ZYZ is", determinant(E_tilt_torsion), -sin(b))
d.identity(
    "without tilt its direction moves nothing: the first column shrinks with the tilt",
    E_tilt_torsion.column_vector(0).dot(E_tilt_torsion.column_vector(0)),
    2 - 2 * cos(b),
)
d.identity(
    "the torsion moves the body at every tilt: it turns about the leaning axis",
    E_tilt_torsion.column_vector(2),
    vector(cos(a) * sin(b), sin(a) * sin(b), cos(b)),
)
