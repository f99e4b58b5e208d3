"""What the encoders read, and the same law in the words of telescope pointing."""

from armillary import (
    PI,
    Status,
    X,
    Y,
    Z,
    atan2,
    cos,
    elementary,
    sin,
    truncate,
    vector,
    where,
)

from .drive import again, closed_form, reach
from .frames import I_R_L
from .symbols import (
    alpha,
    alpha_0,
    alpha_reading,
    azimuth,
    beta,
    beta_0,
    beta_reading,
    chi,
    collimation,
    d,
    edge_tolerance,
    elevation,
    psi,
    theta,
)

RUNS_AWAY = (
    "the cosine of the elevation drive is below 1e-6: the azimuth drive runs away; on its own axis "
    "0 is returned for it, not the angle that was given"
)


def posed(turn, raise_, offset=0):
    """The normal in the azimuth axis's frame, `offset` from the mirror's first axis."""
    body = vector(cos(offset), sin(offset), 0) if offset != 0 else vector(1, 0, 0)
    return elementary(Z, -turn) @ (elementary(X, -chi) @ (elementary(Y, -raise_) @ body))


# ---- readings ----

u = d.define(
    "u",
    posed(alpha + alpha_0, beta),
    because="Where the normal is to point, with the zero of the azimuth encoder turned in: then "
    "the answer is the reading itself, within [-pi, pi].",
    meaning="unit normal that is wanted, in the azimuth axis's frame turned by its encoder's zero",
    latex=r"\mathbf{u}",
)
_for_readings = again("u", r"\kappa", of="u")
aim_u = reach(u, _for_readings, offset=collimation, unit=True)
Q_reading = d.define(
    "Q_reading",
    where(cos(beta) < 0, -aim_u.Q, aim_u.Q),
    because="The closed form of the drive once more, with sin(kappa) added to W: the true normal "
    "stands off sideways by itself. The mirror stays on the branch that beta is on.",
    meaning="cosine of the elevation drive times cos(chi) cos(kappa)",
    latex=r"Q_{\pm\kappa}",
)
_azimuth_u, (_rise_u, _) = aim_u.points(Q_reading, _for_readings)
alpha_encoder = d.define(
    "alpha_encoder",
    atan2(*_azimuth_u),
    because="The azimuth drive carries (X, Y) to (Q, W).",
    meaning="reading of the azimuth encoder",
    latex=r"\alpha_\mathrm{r}",
)
beta_encoder = d.define(
    "beta_encoder",
    atan2(
        _rise_u * cos(beta_0) + Q_reading * sin(beta_0),
        Q_reading * cos(beta_0) - _rise_u * sin(beta_0),
    ),
    because="The elevation drive's sine and cosine, turned on by the zero of its encoder.",
    meaning="reading of the elevation encoder",
    latex=r"\beta_\mathrm{r}",
)
reading_cases = [
    (Status.UNREACHABLE, aim_u.blind, "the true normal cannot be brought there"),
    (
        Status.SINGULAR,
        aim_u.steep,
        RUNS_AWAY,
    ),
]

u_read = d.define(
    "u_read",
    posed(alpha_reading - alpha_0, beta_reading - beta_0, collimation),
    because="Readings less their zeros are the drives' angles; the true normal is off the first "
    "axis of the mirror by the collimation.",
    meaning="true unit normal for given readings, in the azimuth axis's frame",
    latex=r"\mathbf{u}_\mathrm{r}",
)
_for_decoding = again("read", r"\mathrm{d}", of="u")
aim_read = reach(u_read, _for_decoding, unit=True)
Q_decoded = d.define(
    "Q_decoded",
    where(cos(beta_reading - beta_0) < 0, -aim_read.Q, aim_read.Q),
    because="The mirror stays on the branch that the reading is on.",
    meaning="cosine of the elevation drive times cos(chi)",
    latex=r"Q_{\pm\mathrm{d}}",
)
decoded = aim_read.angles(Q_decoded, _for_decoding)
alpha_decoded = d.define(
    "alpha_decoded",
    decoded[0],
    because="The drive angle that would point a mirror without collimation error there.",
    meaning="azimuth drive angle from the readings",
    latex=r"\alpha_\mathrm{d}",
)
beta_decoded = d.define(
    "beta_decoded",
    decoded[1],
    because="The drive angle that goes with it.",
    meaning="elevation drive angle from the readings",
    latex=r"\beta_\mathrm{d}",
)
decoding_cases = [
    (Status.UNREACHABLE, aim_read.blind, "no drive angles without collimation error do the same"),
    (
        Status.SINGULAR,
        aim_read.steep,
        RUNS_AWAY,
    ),
]

# ---- telescope pointing terms ----


def read(n_L, length):
    """Azimuth from north and elevation that the encoders read for a multiple of the normal."""
    turn, raise_ = closed_form(I_R_L @ n_L, sin(collimation) * length)
    return turn + alpha_0 + PI, raise_ + beta_0


IA = d.define(
    "IA",
    alpha_0,
    because="The zero of the azimuth encoder; azimuth from north is alpha plus half a turn.",
    meaning="index error in azimuth",
    latex=r"\mathrm{IA}",
)
IE = d.define(
    "IE",
    beta_0,
    because="The zero of the elevation encoder.",
    meaning="index error in elevation",
    latex=r"\mathrm{IE}",
)
CA = d.define(
    "CA",
    collimation,
    because="A normal that stands off to the left must be turned on, to the right, the further the "
    "higher it points.",
    meaning="collimation error",
    latex=r"\mathrm{CA}",
)
NPAE = d.define(
    "NPAE",
    chi,
    because="An elevation axis that is not square to the azimuth axis carries the normal aside as "
    "it rises.",
    meaning="non-perpendicularity of azimuth and elevation axis",
    latex=r"\mathrm{NPAE}",
)
AN = d.define(
    "AN",
    theta,
    because="theta leans the axis to the north.",
    meaning="lean of the azimuth axis to the north",
    latex=r"\mathrm{AN}",
)
AW = d.define(
    "AW",
    -psi,
    because="psi leans the axis to the east, AW to the west.",
    meaning="lean of the azimuth axis to the west",
    latex=r"\mathrm{AW}",
)
at_zenith = d.define(
    "at_zenith",
    ~(cos(elevation) * cos(elevation) > edge_tolerance * edge_tolerance),
    because="At the zenith the tangent of the elevation has no value.",
    meaning="whether the normal is within 1e-6 of the zenith or the nadir",
)
secant = d.define(
    "secant",
    where(at_zenith, 0, 1 / where(at_zenith, 1, cos(elevation))),
    because="A sideways error moves the azimuth by this much; at the zenith no correction is made.",
    meaning="1 / cos(E), 0 at the zenith",
    latex=r"s_E",
)
delta_azimuth = d.define(
    "delta_azimuth",
    IA + secant * (CA + sin(elevation) * (NPAE + AN * sin(azimuth) + AW * cos(azimuth))),
    because="Reading minus azimuth of the normal, to first order: IA + CA / cos E + NPAE tan E + "
    "(AN sin A + AW cos A) tan E.",
    meaning="reading of the azimuth minus the azimuth, to first order",
    latex=r"\Delta A",
)
delta_elevation = d.define(
    "delta_elevation",
    IE + AN * cos(azimuth) - AW * sin(azimuth),
    because="Reading minus elevation of the normal, to first order: IE + AN cos A - AW sin A.",
    meaning="reading of the elevation minus the elevation, to first order",
    latex=r"\Delta E",
)

# South, east and up of the normal, over its horizontal length.
_toward = vector(-cos(azimuth), sin(azimuth), sin(elevation) / cos(elevation))
_errors = (alpha_0, beta_0, collimation, chi, theta, psi)
_turn, _rise = (truncate(angle, 1, _errors).terms[1] for angle in read(_toward, 1 / cos(elevation)))
d.identity(
    "in azimuth this is the first order of what drive and encoder do exactly",
    _turn * cos(elevation),
    IA * cos(elevation) + CA + sin(elevation) * (NPAE + AN * sin(azimuth) + AW * cos(azimuth)),
)
d.identity("and so it is in elevation", _rise, delta_elevation)
