"""The record of the sun, and the angles that its parts share."""

from armillary import Derivation, Rate

derivation = d = Derivation(
    "sun",
    title="The sun",
    paper="ky",
    summary="Seen from the ground, the sun is carried round the earth's axis by the hour angle, "
    "lifted off the equator by the declination, and the whole is tilted by the latitude: a chain "
    "of three rotations. Everything else here follows from that chain, except the almanacs, which "
    "say what the declination is and how far the sundial differs from the clock.",
)

latitude = d.angle(
    "latitude",
    "geodetic latitude, positive north",
    rate=Rate.MOUNT,
    range=(-1.5708, 1.5708),
    latex=r"\varphi",
)
declination = d.angle(
    "declination",
    "declination of the sun, positive north",
    rate=Rate.DAY,
    range=(-0.4102, 0.4102),
    latex=r"\delta",
)
hour_angle = d.angle(
    "hour_angle",
    "hour angle of the sun, 0 at apparent noon and positive in the afternoon",
    rate=Rate.TICK,
    latex=r"\omega",
)
hour_angle_rate = hour_angle.rate("hour_angle_rate", "rate of the hour angle")
