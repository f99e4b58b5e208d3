"""Refraction: how far the air lifts the sun."""

from armillary import Kind, Rate, cos, degrees, sin, where
from armillary.derivation.units import KELVIN, PASCAL, RADIAN

from .symbols import d

elevation = d.angle(
    "elevation",
    "elevation of the sun above the horizon, without refraction",
    limits=(-1.6, 1.6),
    range=(-0.0145, 1.5708),
    latex="e",
)
pressure = d.scalar(
    "pressure",
    "air pressure at the site",
    unit=PASCAL,
    rate=Rate.DAY,
    kind=Kind.NON_NEGATIVE,
    range=(50e3, 110e3),
    latex="P",
)
temperature = d.scalar(
    "temperature",
    "absolute temperature of the air",
    unit=KELVIN,
    rate=Rate.DAY,
    kind=Kind.NON_NEGATIVE,
    limits=(100.0, 1000.0),
    range=(220.0, 330.0),
    latex=r"\vartheta",
)
pressure_0 = d.constant("pressure_0", 101000, "pressure of the formula", unit=PASCAL, latex="P_0")
temperature_0 = d.constant(
    "temperature_0", 283, "temperature of the formula", unit=KELVIN, latex=r"\vartheta_0"
)
below = d.define(
    "below",
    elevation < -degrees("0.83337"),
    because="The sun's radius is 0.26667 degrees and refraction at the horizon 0.5667 degrees: "
    "lower than both together not even the upper limb is seen. The NREL algorithm stops here, and "
    "so do we.",
    meaning="whether the whole disc is below the horizon",
)
seen = d.define(
    "seen",
    where(below, 0, elevation),
    because="The formula is evaluated only where it holds.",
    meaning="elevation that is refracted",
)
lifted = d.define(
    "lifted",
    seen + degrees("10.3") / (seen / degrees(1) + 5.11),
    because="Saemundsson's argument, which keeps the cotangent finite at the horizon.",
    meaning="argument of the cotangent",
    latex="w",
)
refraction = d.define(
    "refraction",
    degrees("0.017")
    * (pressure / pressure_0)
    * temperature_0
    * cos(lifted)
    / (temperature * sin(lifted)),
    because="Refraction follows the cotangent of the elevation and the density of the air: 1.02 "
    "arc minutes at 45 degrees, 1010 hPa and 10 degrees Celsius.",
    meaning="how far refraction lifts the sun",
    unit=RADIAN,
    latex="R",
)
elevation_apparent = d.define(
    "elevation_apparent",
    elevation + where(below, 0, refraction),
    because="Refraction lifts the sun; a sun wholly below the horizon is left where it is.",
    meaning="elevation as seen through the air",
    latex="e_a",
)
