"""The hour angle from the clock."""

from armillary import PI, Rate, wrap
from armillary.derivation.units import SECOND

from .symbols import d

solar_day = d.constant("solar_day", 86400, "length of the mean solar day", unit=SECOND, latex="T")
utc = d.time("utc", "time of the day, UTC", range=(0.0, 86400.0), latex=r"t_\mathrm{UTC}")
longitude = d.angle("longitude", "longitude, positive east", rate=Rate.MOUNT, latex=r"\lambda")
equation_of_time = d.time(
    "equation_of_time",
    "apparent minus mean solar time",
    rate=Rate.DAY,
    range=(-1000.0, 1000.0),
    latex="E",
)

hour_angle_of_clock = d.define(
    "hour_angle_of_clock",
    wrap(2 * PI * (utc + equation_of_time) / solar_day + longitude - PI),
    because="Mean time plus the equation of time is the sundial's time; it turns once a day, runs "
    "ahead by the longitude, and counts from noon instead of midnight.",
    meaning="hour angle from the clock, in [-pi, pi]",
    latex=r"\omega_t",
)
