"""A product of the paper that is named as a triple and is none."""

from armillary import Y, Z, elementary, number

from .motion import determinant, rate_map
from .symbols import a, attitude, b, c, d, turns

lebian = turns((Z, a), (Y, b), (Y, c))
R_lebian = d.define(
    "R_lebian",
    attitude(lebian),
    because="The paper's third triple, ZXX Lebian, is printed as a turn about z, one about the "
    "turned y, and one about the y that this brings: the same axis again.",
    meaning="attitude by the product that the paper names Lebian",
    latex=r"R_{\mathrm{L}}",
)
E_lebian = d.define(
    "E_lebian",
    rate_map(lebian),
    because="Its columns are the three axes in base components; the last two are one axis.",
    meaning="rate map of the Lebian product",
    latex=r"E_{\mathrm{L}}",
)
d.identity(
    "two turns about one axis are one turn: the product reaches a set of attitudes with two "
    "freedoms only",
    R_lebian,
    elementary(Z, a) @ elementary(Y, b + c),
)
d.identity(
    "the body's second axis stays level, whatever the angles", R_lebian.entry(Z, Y), number(0)
)
d.identity(
    "the second and the third angle turn it alike",
    E_lebian.column_vector(1),
    E_lebian.column_vector(2),
)
d.identity(
    "so its rate map is singular at every attitude: no angles give back an angular velocity, and "
    "it is no orientation triple",
    determinant(E_lebian),
    number(0),
)
