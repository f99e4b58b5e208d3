"""The frames of the paper, from the earth to the mirror, and the normal for given drive angles.

E is equatorial: x to the south on the meridian, y east, z to the celestial pole. L is local: south,
east, up. I carries the azimuth axis as its z, H is fixed to the mirror with the normal as its x.
"""

from armillary import PI, Chain, X, Y, Z, cos, sin, vector

from .symbols import alpha, beta, chi, d, declination, hour_angle, latitude, psi, sun, theta


def stand(chain, post=0, arm=0):
    """The joints from the local frame to the mirror, each turning inward as the paper says.

    A post and an arm only serve to draw it: directions do not feel them.
    """
    return (
        chain.rotate(Y, -theta)
        .rotate(X, -psi, frame="axes")
        .translate(Z, post)
        .rotate(Z, -alpha)
        .rotate(X, -chi)
        .rotate(Y, -beta)
        .translate(X, arm, frame="mirror")
    )


# East, north and up from south, east and up: a quarter turn, which costs nothing.
chain = stand(Chain("enu").rotate(Z, -PI / 2, frame="local"))
earth = Chain("local").rotate(Y, -PI / 2).rotate(Y, latitude, frame="equatorial")


def local(enu):
    """A vector in the paper's axes: south, east, up."""
    return chain.rotation("local", "enu") @ enu


L_R_E = d.define(
    "L_R_E",
    earth.rotation("local", "equatorial"),
    because="The pole stands as high as the latitude, so the equatorial frame is the local one "
    "turned about the east by the complement of the latitude.",
    meaning="rotation of equatorial components into local ones",
    printed="5",
    latex=r"{}_L\mathbf{R}_E",
)
I_R_L = d.define(
    "I_R_L",
    chain.rotation("axes", "local"),
    because="The azimuth axis leans to the north by theta and then to the east by psi.",
    meaning="rotation of local components into those of the azimuth axis",
    printed="6",
    latex=r"{}_I\mathbf{R}_L",
)
H_R_I = d.define(
    "H_R_I",
    chain.rotation("mirror", "axes"),
    because="The azimuth drive turns by alpha, the elevation axis is inclined by chi, the "
    "elevation drive raises by beta.",
    meaning="rotation of components of the azimuth axis into the mirror's",
    printed="8",
    latex=r"{}_H\mathbf{R}_I",
)

c_E = d.define(
    "c_E",
    vector(
        cos(hour_angle) * cos(declination),
        -sin(hour_angle) * cos(declination),
        sin(declination),
    ),
    because="The hour angle turns the sun westward about the pole, the declination lifts it from "
    "the equator.",
    meaning="direction to the sun in equatorial axes",
    printed="10",
    latex=r"\mathbf{c}_E",
)
c_L = d.define(
    "c_L",
    L_R_E @ c_E,
    because="The same direction, seen from the ground.",
    meaning="direction to the sun in local axes",
    printed="11'",
    latex=r"\mathbf{c}_L",
)
normal_I = d.define(
    "normal_I",
    chain.rotation("axes", "mirror").column(0),
    because="The normal is the first axis of the mirror's frame, carried back through both drives. "
    "The print leaves out what the inclined axis adds across.",
    meaning="unit normal in the frame of the azimuth axis",
    printed="14",
    latex=r"\mathbf{n}^*_I",
)
normal = d.define(
    "normal",
    chain.rotation("enu", "mirror").column(0),
    because="Back through the leaning axis too, and a quarter turn to east, north and up.",
    meaning="unit normal of the mirror for given drive angles",
    latex=r"\mathbf{n}_{\alpha\beta}",
)

d.identity("seen from the ground this is the sun's direction", c_L, local(sun["enu"]))
d.identity(
    "the azimuth axis leans to the north by theta and to the east by psi",
    chain.rotation("local", "axes").column(2),
    vector(-sin(theta) * cos(psi), sin(psi), cos(theta) * cos(psi)),
)
d.identity(
    "the elevation axis is inclined by chi to the plane across the azimuth axis",
    chain.rotation("axes", "mirror").column(1).z,
    -sin(chi),
)
d.identity(
    "an inclined elevation axis carries the normal sideways as it rises",
    normal_I,
    vector(
        cos(alpha) * cos(beta) + sin(alpha) * sin(beta) * sin(chi),
        cos(alpha) * sin(beta) * sin(chi) - sin(alpha) * cos(beta),
        sin(beta) * cos(chi),
    ),
)
