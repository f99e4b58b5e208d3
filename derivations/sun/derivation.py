"""The sun: its direction as a chain of rotations, its angles and rates, and simple almanacs.

Each part stands in a file of its own; their order here is their order on the page.
"""

from armillary import Status, Z

from .symbols import d, declination, hour_angle, hour_angle_rate, latitude
from .direction import (
    at_zenith,
    azimuth_of_sun,
    azimuth_rate,
    elevation_of_sun,
    elevation_rate,
    enu,
    sky,
)
from .clock import equation_of_time, hour_angle_of_clock, longitude, utc
from .almanac import (
    day,
    declination_cooper,
    declination_cosine,
    declination_spencer,
    equation_of_time_spencer,
)
from .horizon import stays_down, stays_up, sunrise, sunset
from .air import elevation, elevation_apparent, pressure, temperature

derivation = d
place = [latitude, declination, hour_angle]
free_azimuth = (
    Status.SINGULAR,
    at_zenith,
    "the sun is within 1e-6 of the zenith or the nadir: its azimuth is free",
)

d.kernel("direction", inputs=place, outputs=[enu], summary="Unit vector to the sun.")
d.kernel(
    "angles",
    inputs=place,
    outputs={"elevation": elevation_of_sun, "azimuth": azimuth_of_sun},
    cases=[free_azimuth],
    summary="Elevation, in [-pi/2, pi/2], and azimuth, in [0, 2 pi), of the sun.",
)
d.kernel(
    "rates",
    inputs=[*place, hour_angle_rate],
    outputs=[elevation_rate, azimuth_rate],
    cases=[free_azimuth],
    summary="Rates of elevation and azimuth while the hour angle runs.",
)
d.kernel(
    "hour_angle",
    inputs=[utc, longitude, equation_of_time],
    outputs={"hour_angle": hour_angle_of_clock},
    summary="Hour angle of the sun from the clock, in [-pi, pi].",
)
d.kernel(
    "cooper",
    inputs=[day],
    outputs={"declination": declination_cooper},
    summary="Declination by Cooper's sine.",
)
d.kernel(
    "cosine",
    inputs=[day],
    outputs={"declination": declination_cosine},
    summary="Declination by the cosine from the winter solstice.",
)
d.kernel(
    "spencer",
    inputs=[day],
    outputs={
        "declination": declination_spencer,
        "equation_of_time": equation_of_time_spencer,
    },
    summary="Declination and equation of time by Spencer's series.",
)
d.kernel(
    "day_limits",
    inputs=[latitude, declination],
    outputs={"rise": sunrise, "set": sunset},
    cases=[
        (Status.BELOW_HORIZON, stays_down, "polar night: rise and set are both 0"),
        (Status.CLAMPED, stays_up, "polar day: rise is -pi and set is pi"),
    ],
    summary="Hour angles of the sun's centre on the unrefracted horizon. The day runs from rise "
    "to set; past the pole rise is the larger, and the day runs through pi.",
)
d.kernel(
    "refraction",
    inputs=[elevation, pressure, temperature],
    outputs={"elevation": elevation_apparent},
    summary="Elevation as seen through the air. Below -0.0145 rad the sun is left where it is: "
    "the refraction, 0.0108 rad there, ends with a jump.",
)

d.assume("The earth turns about a fixed axis, and the sun is so far that its rays are parallel.")
d.assume("Directions are geometric: only the kernel refraction bends the rays.")
d.picture(
    sky(hour_angle),
    at={"latitude": 0.7, "hour_angle": 0.8, "declination": 0.35},
    sun=Z,
    caption="The sun in the sky of 40 degrees north, on a summer afternoon. The circle is its way "
    "in the course of a day about the celestial pole.",
)
