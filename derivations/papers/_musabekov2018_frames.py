"""Musabekov et al.: the error angles, the reflection, and the transitions (1) to (9)."""

from armillary import (
    PI,
    Paper,
    X,
    Y,
    Z,
    atan2,
    cos,
    elementary,
    matrix,
    sin,
    sqrt,
)

paper = p = Paper(
    "musabekov2018",
    title="Equation and algorithm of the mirror concentrating system movement",
)

sun = p.use("sun")
heliostat = p.use("heliostat")
theta, psi, chi = (heliostat.quantity(name) for name in ("theta", "psi", "chi"))
alpha, beta = heliostat.quantity("alpha"), heliostat.quantity("beta")
b, c = heliostat.quantity("b"), heliostat.quantity("c")
phi, delta = sun.quantity("latitude"), sun.quantity("declination")
lam = p.define(
    "lam",
    sun.quantity("hour_angle"),
    because="the paper's name of the hour angle",
    latex=r"\lambda",
)

p.assume(
    "The figures are lost. The axes are those of the text, south, east and up; the order of the "
    "turns is the one that (6) fits to first order and (8) at chi = 0."
)
p.assume("Clockwise is as seen from the tip of the axis; at the initial moment alpha = beta = 0.")
p.assume(
    "Width and longitude of the sun are its latitude from the ecliptic and its longitude along "
    "it; the symbol that the text calls the width is lost, and read as lambda."
)
p.assume(
    "Indices and glyphs that the scan leaves doubtful, in (11), (13) and (16) to (18), are read in "
    "each way that is judged below."
)
p.assume("The equation (1) that (20) is said to give at chi = 0 is the paper's own.")

# ---- Introduction ----

p.unchecked(
    "1",
    "error of the azimuth",
    "It names the difference of two angles; how large it is, is not stated.",
)
p.unchecked(
    "2",
    "error of the zenith angle",
    "It names the difference of two angles; how large it is, is not stated.",
)

M = p.define(
    "M",
    sqrt(2 * (1 + b.dot(c))),
    because="the paper's name of the divisor in (3) and (12)",
    latex="M",
)
p.equation(
    "3",
    words="normal of the mirror",
    claims=heliostat["wanted"],
    printed=(b + c) / sqrt(2 * (1 + b.dot(c))),
)


def elevation_axis(alpha, beta):
    """The axis of the elevation drive in the frame of the azimuth axis, for two drive angles."""
    return (elementary(Y, beta) @ elementary(X, chi) @ elementary(Z, alpha)).transpose().column(1)


reachable = ~heliostat["blind"] & ~heliostat["opposed"]
front = elevation_axis(heliostat["alpha_drive"], heliostat["beta_drive"])
back = elevation_axis(heliostat["alpha_back"], heliostat["beta_back"])
p.between(
    "unique position",
    "If the vectors b and c are given, then from (3) is uniquely determined by the position of "
    "the vector n or the MCS position in space",
    value=atan2(front.cross(back).norm(), front.dot(back)),
    low=0,
    high=0,
    words="the angle between the elevation axes of the two poses that have this normal",
)

# ---- Transitions ----

p.unchecked(
    "4",
    "order of the transitions",
    "It lists the frames and the angles between them; the transitions are (5) to (9).",
)

to_local = matrix(
    (sin(phi), 0, -cos(phi)),
    (0, 1, 0),
    (cos(phi), 0, sin(phi)),
)
to_equatorial = matrix(
    (sin(phi), 0, cos(phi)),
    (0, 1, 0),
    (-cos(phi), 0, sin(phi)),
)
p.equation(
    "5",
    words="direct transition from the equatorial to the local frame",
    claims=heliostat["L_R_E"],
    printed=to_local,
)
p.equation(
    "5'",
    words="reverse transition from the local to the equatorial frame",
    claims=heliostat["L_R_E"].transpose(),
    printed=to_equatorial,
)
p.equation(
    "clockwise gamma",
    words="direct transition (5), its angle gamma = 90 deg - phi turning clockwise",
    quote="There is assumed that a positive reference angle is clockwise",
    claims=elementary(Y, -(PI / 2 - phi)).transpose(),
    printed=to_local,
)

to_axes = matrix(
    (1, 0, theta),
    (theta * psi, 1, -psi),
    (-theta, psi, 1),
)
from_axes = matrix(
    (1, theta * psi, -theta),
    (0, 1, sin(psi)),
    (theta, -psi, 1),
)
p.equation(
    "6",
    words="direct transition from the local frame to that of the azimuth axis",
    claims=heliostat["I_R_L"],
    printed=to_axes,
    small=(theta, psi),
)
p.equation(
    "7",
    words="reverse transition from the frame of the azimuth axis to the local one",
    claims=heliostat["I_R_L"].transpose(),
    printed=from_axes,
    small=(theta, psi),
)
# The rows are labelled X, Y, Z and the columns xi, eta, zeta, as in (6).
p.equation(
    "7'",
    words="the same table, read by the labels of its rows and columns",
    claims=heliostat["I_R_L"],
    printed=from_axes,
    small=(theta, psi),
)

to_mirror = matrix(
    (cos(alpha) * cos(beta), -sin(alpha) * cos(beta), sin(beta) * cos(chi)),
    (sin(alpha) * cos(chi), cos(alpha) * cos(chi), -sin(chi)),
    (-cos(alpha) * sin(beta), sin(alpha) * sin(beta), cos(beta) * cos(chi)),
)
from_mirror = matrix(
    (cos(alpha) * cos(beta), sin(alpha) * cos(chi), -cos(alpha) * sin(beta)),
    (-sin(alpha) * cos(beta), cos(alpha) * cos(chi), sin(alpha) * sin(beta)),
    (sin(beta) * cos(chi), -sin(chi), cos(beta) * cos(chi)),
)
p.equation(
    "8",
    words="direct transition from the frame of the azimuth axis to the mirror",
    claims=heliostat["H_R_I"],
    printed=to_mirror,
    small=(chi,),
)
p.equation(
    "9",
    words="reverse transition from the mirror to the frame of the azimuth axis",
    claims=heliostat["H_R_I"].transpose(),
    printed=from_mirror,
    small=(chi,),
)
p.equation(
    "clockwise",
    words="direct transition (8) at chi = 0, its angles alpha and beta turning clockwise",
    quote="There is assumed that a positive reference angle is clockwise",
    claims=(elementary(Z, -alpha) @ elementary(Y, -beta)).transpose(),
    printed=matrix(
        (cos(alpha) * cos(beta), -sin(alpha) * cos(beta), sin(beta)),
        (sin(alpha), cos(alpha), 0),
        (-cos(alpha) * sin(beta), sin(alpha) * sin(beta), cos(beta)),
    ),
)
p.equation(
    "initial moment",
    words="transition from the frame of the azimuth axis to the mirror at alpha = beta = 0",
    quote="In the initial moment of time, CS_H and CS_I are the same",
    claims=elementary(X, chi),
    printed=matrix((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    small=(chi,),
)
p.word(
    "singular",
    "all these matrices are singular",
    "singular",
    of={
        "(5)": to_local,
        "(6)": to_axes,
        "(7)": from_axes,
        "(8)": to_mirror,
        "(9)": from_mirror,
    },
)
p.word(
    "transposition",
    "the reverse transition is realized by simple rotation matrix elements around the diagonal of "
    "its left diagonal",
    "orthogonal",
    of={"(5)": to_local, "(6)": to_axes, "(8)": to_mirror},
)
