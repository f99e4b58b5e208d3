"""The dish that the facets act: its surface, its attitude, and how it faces the sun."""

from armillary import (
    PI,
    Chain,
    X,
    Y,
    Z,
    atan2,
    atan2_or_zero,
    cos,
    elementary,
    hypot,
    number,
    sin,
    unit,
    vector,
)

from .symbols import (
    D,
    alpha,
    beta,
    d,
    dist,
    enu,
    f,
    phi,
    theta_rim,
    z_O,
    zenith_tolerance,
)

# ---- the surface ----

_half = theta_rim / 2
f_rim = d.define(
    "f_rim",
    D * cos(_half) / (4 * sin(_half)),
    because="At the focus the rim is seen at the edge angle from the axis; the rim's distance from "
    "the focus is its distance from the directrix, which gives f by D. The half angle spares the "
    "print's 1 + cos, which cancels for an edge behind the focus.",
    meaning="focal length of a dish of diameter D and edge angle theta_rim",
    latex="f_D",
)
_sine, _cosine = 2 * sin(_half) * cos(_half), cos(_half) ** 2 - sin(_half) ** 2
d.identity("it is what the print says", f_rim, D * (1 + _cosine) / (4 * _sine))
d.identity(
    "the rim lies on the paraboloid, and at the edge angle from the axis",
    (D / 2) * _cosine,
    (f_rim - (D / 2) * (D / 2) / (4 * f_rim)) * _sine,
)

M_O = d.define(
    "M_O",
    vector(dist * cos(phi), dist * sin(phi), dist * dist / (4 * f)),
    because="The facet stands for the dish at the azimuth phi and the distance d from the axis.",
    meaning="the facet's point on the dish, dish axes, from the vertex",
    printed="2",
    latex=r"\mathbf{M}_\mathrm{O}",
)
on_dish = d.define(
    "on_dish",
    M_O.x * M_O.x + M_O.y * M_O.y - 4 * f * M_O.z,
    because="The dish is a paraboloid about the z axis with its vertex in the origin.",
    meaning="what vanishes for a point of the dish, here for the facet's",
    printed="1",
    latex="F",
)
d.identity("the facet's point lies on the dish", on_dish, number(0))
gradient = d.define(
    "gradient",
    vector(2 * M_O.x, 2 * M_O.y, -4 * f),
    because="The gradient of what vanishes on the dish is square to it.",
    meaning="gradient at the facet's point; it points out of the dish",
    printed="4",
    latex=r"\nabla F",
)
slope_length = d.define(
    "slope_length",
    hypot(dist, 2 * f),
    because="The normal (-d, 0, 2 f) before it is made of length 1, in the plane through the axis.",
    meaning="distance along the normal from the facet's point to the axis",
    printed="6",
    latex=r"\overline{GM}",
)
z_G = d.define(
    "z_G",
    M_O.z + 2 * f,
    because="Along the normal (-d, 0, 2 f) the axis is reached after one of its lengths.",
    meaning="height above the vertex at which the normal of the facet's point meets the axis",
    printed="5",
    latex="z_G",
)
eta = d.define(
    "eta",
    atan2(dist, 2 * f),
    because="The normals of vertex and point meet on the axis, 2 f above the height of the point: "
    "there the angle between them has the sides d and 2 f.",
    meaning="angle between the normals of the dish at its vertex and at the facet's point",
    printed="7",
    latex=r"\eta",
)
n_O = d.define(
    "n_O",
    vector(-dist * cos(phi), -dist * sin(phi), 2 * f) / slope_length,
    because="The gradient turned to the side of the focus, of length 1.",
    meaning="unit normal of the dish at the facet's point, dish axes",
    latex=r"\mathbf{n}_\mathrm{O}",
)
d.identity("the normal runs against the gradient", n_O * (2 * slope_length), -gradient)

# ---- its attitude ----

dish = (
    Chain("ground")
    .translate(Z, z_O)
    .rotate(Z, alpha)
    .rotate(Y, beta)
    .rotate(Z, -alpha, frame="dish")
    .rotate(Z, phi)
    .translate(X, dist)
    .translate(Z, dist * dist / (4 * f), frame="point")
    .rotate(Z, -PI)
    .rotate(Y, eta, frame="mirror")
)
H_T_O = d.define(
    "H_T_O",
    dish.pose("ground", "dish"),
    because="The dish leans from the zenith by beta towards the azimuth alpha, and turns back by "
    "alpha about its own axis: it tilts about a level axis, without torsion.",
    meaning="pose of the dish that the facets act, in {H}: East-North-Up axes on the ground below "
    "its vertex",
    printed="11",
    latex="{}^{H}T_{O}",
)
R_D = H_T_O.rotation
c_dish = d.define(
    "c_dish",
    R_D.column(Z),
    because="The dish's axis is to point to the sun.",
    meaning="unit vector along the dish's axis, {H}",
    latex=r"\mathbf{c}_\mathrm{O}",
)
d.identity(
    "its axis leans by beta towards alpha",
    c_dish,
    vector(cos(alpha) * sin(beta), sin(alpha) * sin(beta), cos(beta)),
)
Omega_O = d.define(
    "Omega_O",
    dish.angular_velocity("dish"),
    because="Three turns, the last one back with the rate of the first.",
    meaning="angular velocity of the dish that the facets act, {H}",
    printed="25",
    latex=r"\boldsymbol{\Omega}_\mathrm{O}",
)
M_dish = d.define(
    "M_dish",
    dish.pose("ground", "point").position,
    because="The point of the dish at the facet, carried along.",
    meaning="the facet's point of the dish, {H}; the facet itself has only its height",
    latex=r"\mathbf{M}_\mathrm{dish}",
)
O_T_M = d.define(
    "O_T_M",
    dish.pose("dish", "mirror"),
    because="Axes of a facet cut out of the dish: z along the normal, x from the facet's point "
    "downhill to the dish's axis.",
    meaning="pose of a facet that the dish would carry, dish axes",
    printed="8",
    latex="{}^{O}T_{M}",
)
d.identity("its z axis is the normal of the dish", O_T_M.rotation.column(Z), n_O)
d.identity("its origin is the facet's point", O_T_M.position, M_O)
carried = d.define(
    "carried",
    dish.pose("ground", "mirror"),
    because="The dish would carry the facet like this; a 3-RPS platform cannot follow.",
    meaning="pose of a facet that the dish would carry, {H}",
    printed="13",
    latex="{}^{H}T_{OM}",
)

# ---- facing the sun ----

horizontal = d.define(
    "horizontal",
    hypot(enu.x, enu.y),
    because="The shadow of a unit pole that points to the sun has this length.",
    meaning="length of the horizontal part of the sun's direction",
    latex=r"\rho_c",
)
at_zenith = d.define(
    "at_zenith",
    horizontal < zenith_tolerance,
    because="With the sun overhead, or underfoot, the dish leans towards no azimuth.",
    meaning="whether alpha is free",
)
alpha_aim = d.define(
    "alpha_aim",
    atan2_or_zero(enu.y, enu.x, at_zenith),
    because="The dish leans towards the sun's azimuth, counted from the east to the north: 90 "
    "degrees less the azimuth that is counted from the north. It is 0 where it is free.",
    meaning="azimuth of the dish's axis that faces the sun, in [-pi, pi]",
    printed="16",
    latex=r"\alpha_c",
)
beta_aim = d.define(
    "beta_aim",
    atan2(horizontal, enu.z),
    because="It leans as far as the sun is from the zenith.",
    meaning="angle from the zenith to the dish's axis that faces the sun, in [0, pi]",
    latex=r"\beta_c",
)
_faced = elementary(Z, atan2(enu.y, enu.x)) @ elementary(Y, beta_aim)
d.identity("away from the zenith the dish's axis is on the sun", _faced.column(Z), unit(enu))
