"""The record of the heliostat, and the quantities that its parts share."""

from armillary import Derivation, Rate
from armillary.derivation.units import METRE

derivation = d = Derivation(
    "heliostat",
    title="Heliostat",
    paper="musabekov2018",
    summary="A mirror on two axes throws the sunlight on a receiver that stands still. Its normal "
    "must halve the angle between sun and receiver. The azimuth axis leans a little from the "
    "vertical, by theta and psi, and the elevation axis on top is a little off the level, by chi. "
    "Solved exactly: where the normal points for given drive angles, which drive angles point it "
    "where it is wanted, where no drive angles do, and what each error does to the beam.",
)

sun = d.use("sun")
latitude, declination = sun.quantity("latitude"), sun.quantity("declination")
hour_angle = sun.quantity("hour_angle")

# ---- errors of the axes, the same for every call ----

_SLIGHT = {"range": (-0.3, 0.3)}
theta = d.parameter.angle(
    "theta", "lean of the azimuth axis to the north", latex=r"\theta", **_SLIGHT
)
psi = d.parameter.angle("psi", "lean of the azimuth axis to the east", latex=r"\psi", **_SLIGHT)
chi = d.parameter.angle(
    "chi",
    "inclination of the elevation axis to the plane across the azimuth axis, its left end down",
    limits=(-1.5, 1.5),
    latex=r"\chi",
    **_SLIGHT,
)
alpha_0 = d.parameter.angle(
    "alpha_0", "reading of the azimuth encoder at alpha = 0", latex=r"\alpha_0"
)
beta_0 = d.parameter.angle(
    "beta_0", "reading of the elevation encoder at beta = 0", latex=r"\beta_0"
)
collimation = d.parameter.angle(
    "collimation",
    "angle from the first axis of the mirror's frame to the true normal, to the left",
    limits=(-1.5, 1.5),
    latex=r"\kappa",
    **_SLIGHT,
)

# ---- directions and angles ----

alpha = d.angle(
    "alpha", "azimuth drive angle: from south to west, clockwise from above", latex=r"\alpha"
)
beta = d.angle("beta", "elevation drive angle: positive raises the normal", latex=r"\beta")
c = d.unit_vector("c", "unit vector to the sun", latex=r"\mathbf{c}")
c_dot = c.rate("c_dot", "rate of the unit vector to the sun")
b = d.unit_vector(
    "b",
    "unit vector from the mirror to the receiver; the sun's own direction for direct tracking",
    rate=Rate.MOUNT,
    latex=r"\mathbf{b}",
)
n = d.unit_vector("n", "unit normal of the mirror", latex=r"\mathbf{n}")
alpha_reading = d.angle(
    "alpha_reading", "reading of the azimuth encoder", latex=r"\alpha_\mathrm{r}"
)
beta_reading = d.angle(
    "beta_reading", "reading of the elevation encoder", latex=r"\beta_\mathrm{r}"
)
azimuth = d.angle(
    "azimuth", "azimuth of the normal from north, clockwise", range=(-3.2, 6.3), latex="A"
)
elevation = d.angle(
    "elevation",
    "elevation of the normal above the horizon",
    limits=(-3.15, 3.15),
    range=(-1.5, 1.5),
    latex="E",
)
_FIELD = {"unit": METRE, "rate": Rate.MOUNT, "range": (-1000.0, 1000.0)}
position = d.vector("position", "where the mirror stands", latex=r"\mathbf{p}", **_FIELD)
aim_point = d.vector("aim_point", "point of the receiver to be lit", latex=r"\mathbf{q}", **_FIELD)

# ---- tolerances ----

edge_tolerance = d.constant(
    "edge_tolerance",
    "1e-6",
    "cosine of beta below which the azimuth drive runs away",
    latex=r"\tau",
)
opposite_tolerance = d.constant(
    "opposite_tolerance",
    "1e-6",
    "length of b + c below which the receiver stands opposite the sun",
    latex=r"\tau_m",
)
grazing_tolerance = d.constant(
    "grazing_tolerance",
    "1e-6",
    "cosine between the beam and the way to the receiver below which it does not get there",
    latex=r"\tau_r",
)
nearest_distance = d.constant(
    "nearest_distance",
    "1e-6",
    "distance below which the aim point is taken to lie on the mirror",
    unit=METRE,
    latex=r"\tau_d",
)
