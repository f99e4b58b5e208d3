"""Salgado Conrado et al.: the aim of the abstract, and the rows of the nomenclature."""

from armillary import (
    Chain,
    Paper,
    X,
    Y,
    Z,
    cos,
    elementary,
    matrix,
    sin,
    time_derivative,
    vector,
)

paper = p = Paper(
    "salgado2014",
    title="Dynamic model of a parabolic trough solar concentrator with a water displacement "
    "mechanism",
)
trough = p.use("water_trough")

p.assume(
    "The figures are lost. The axes are those of the text: z is the axis of the trough, i of (2) "
    "is level, and j is up, as the weights of (2) have it. Counterclockwise is the positive sense "
    "about z, and container 1 stands on the side of negative x."
)
p.assume(
    "The caption of Fig. 1 gives the label 1 to Container 2 and the label 2 to Container 1. The "
    "text and the nomenclature are read by the containers' names. By the labels the water of the "
    "principle would run the other way, and the trough would turn clockwise."
)
p.assume(
    "The file ends after the words that announce (3). What is printed and can be judged are (1), "
    "(2), the principle, and the nomenclature."
)
p.assume(
    "The sentence before (1) and (2) calls a the acceleration of the centre of mass of the whole, "
    "but the a of (2) stands beside M, a row that says mass and no more, where (1) has m. M and a "
    "are read of the concentrator and of all that moves, F_1 and F_2 as weights of the water and "
    "as the forces that the nomenclature calls them."
)
p.assume(
    "r_f is the diameter that the nomenclature calls it, although r is the letter of a radius: as "
    "a radius it would double every moment of friction."
)

theta, omega, q, rho, g = (trough.quantity(name) for name in ("theta", "omega", "q", "rho", "g"))
M, l, lam, m_t, r_A, r_B = (
    trough.quantity(name) for name in ("M", "l", "lam", "m_t", "r_A", "r_B")
)

# ---- The aim ----

turn = p.angle("turn", "any rotation of the trough about its axis", latex=r"R'")
_axis = (
    Chain("enu")
    .rotate(Z, -trough.quantity("axis_azimuth"))
    .rotate(X, -trough.quantity("axis_tilt"))
    .rotate(Y, turn, frame="trough")
)
normal = p.define(
    "normal",
    _axis.rotation("trough", "enu").transpose().column(Z),
    because="The trough faces along the third axis of a frame that lies on its axis and turns.",
    meaning="normal of the trough at any rotation, east, north and up",
    latex=r"\mathbf{n}",
)
p.between(
    "incidence",
    "capable of minimize the angle of incidence (angle between the sun's rays irradiated on a "
    "surface and the line normal to this surface)",
    cos(trough["incidence"]) - normal.dot(trough.quantity("enu")),
    0,
    None,
    words="the cosine of the incidence that the rotation of a single axis leaves, less that at any "
    "other rotation,",
)

# ---- What the symbols stand for ----

turned = p.define(
    "turned",
    elementary(Z, theta),
    because="The axis z stands still.",
    meaning="rotation of the trough",
    latex="R",
)
r_c = p.define(
    "r_c",
    turned @ (l * vector(cos(lam), sin(lam), 0)),
    because="At the distance l from O.",
    meaning="centre of mass of the concentrator",
    latex=r"\mathbf{r}_c",
)
a_c = p.define(
    "a_c",
    time_derivative(time_derivative(r_c)),
    because="The acceleration that stands beside M in (2).",
    meaning="acceleration of the concentrator's centre of mass",
    latex=r"\mathbf{a}",
)
m_T = p.define(
    "m_T",
    trough["m_1"] + trough["m_2"] + m_t,
    because="In both containers and the tube.",
    meaning="mass of all water",
    latex=r"m_\mathrm{T}",
)

# ---- The rows ----

ROWS = (
    ("a", "acceleration [m²/s]", a_c, "m^2/s"),
    ("A", "area [m²]", matrix([trough.quantity("A_1"), trough.quantity("A_2")]), "m^2"),
    ("F_A", "force on the bearing A [N]", trough["F_A"], "N"),
    ("F_B", "force on the bearing B [N]", trough["F_B"], "N"),
    ("F_1", "force on container 1 [N]", trough["F_1"], "N"),
    ("F_2", "force on container 2 [N]", trough["F_2"], "N"),
    ("g", "acceleration of gravity [m/s²]", g, "m/s^2"),
    ("h_10", "initial level of water [m]", trough.quantity("h_10"), "m"),
    ("h_1", "level of water [m]", trough["h_1"], "m"),
    ("l", "length of the center of mass of the solar concentrator and the origin “O” [m]", l, "m"),
    ("M", "mass [kg]", M, "kg"),
    ("M_FA", "frictional moment on the bearing A [N m²]", trough["M_FA"], "N m^2"),
    ("M_FB", "frictional moment on the bearing B [N m²]", trough["M_FB"], "N m^2"),
    ("m_T", "total mass of the water [kg]", m_T, "kg"),
    ("q_i", "water flow [m³/s]", q, "m^3/s"),
    ("r_A", "the distance between F_A and the origin “O” [m]", r_A, "m"),
    ("r_B", "the distance between F_B and the origin “O” [m]", r_B, "m"),
    ("r_f", "bearing diameter [m]", trough.quantity("r_f"), "m"),
    ("alpha", "angular acceleration [rad/s²]", trough.quantity("alpha"), "rad/s^2"),
    ("mu", "friction coefficient", trough.quantity("mu"), "1"),
    ("theta", "angle of Inclination of the solar concentrator [Degree]", theta, "deg"),
    ("rho", "density of water [kg/m³]", rho, "kg/m^3"),
    ("omega", "ω = Ω angular velocity [rad/s]", omega, "rad/s"),
    ("I_zz", "I_xx, I_yy, I_zz moment of inertia x, y, z of the system [N m²]",
     matrix([trough.quantity("I_xx"), trough.quantity("I_yy"), trough["inertia"]]), "N m^2"),
)  # fmt: skip
for symbol, row, value, unit in ROWS:
    p.in_unit(f"unit {symbol}", row, value, unit)

p.unchecked(
    "unit t",
    "time [s]",
    "It stands in no equation that is left, and in none of the trough's page, where rates stand "
    "for it: a second would be compared with nothing.",
)
p.unchecked(
    "degrees",
    "theta in degrees, omega in rad/s",
    "Nothing that is left says that omega is the rate of theta. On the trough's page it is, with "
    "both in radians; a rate of theta in degrees would be 180/pi times as large.",
)
p.unchecked(
    "unit d_rec",
    "outer diameter of receiver [m]",
    "The receiver belongs to what is lost: it stands in no equation of the file and not in the "
    "mechanics of the trough.",
)
p.unchecked(
    "no row",
    "m of (1), h_20 and h_2, the places of the containers, and the tube",
    "The nomenclature has the mass M but not the m of (1), one initial level and one level for two "
    "containers, two areas as one A, and neither the containers' arms nor anything of the tube. "
    "They are named here as in the derivation.",
)
