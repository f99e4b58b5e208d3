"""Altazimuth tracker: a vertical axis carries a horizontal one (Ky et al., configuration 1)."""

from armillary import (
    Chain,
    Derivation,
    Rate,
    Status,
    Twist,
    X,
    Y,
    Z,
    atan2,
    hypot,
    unit,
    vector,
    where,
)

derivation = d = Derivation(
    "altazimuth",
    title="Altazimuth tracker",
    paper="ky",
    summary="A turntable on a column turns about the vertical; a cradle on the turntable tilts "
    "about a horizontal axis and carries the collector. The two angles are the sun's azimuth and "
    "its distance from the zenith.",
)

gamma = d.angle("gamma", "azimuth drive angle, clockwise seen from above", rate=Rate.TICK)
upsilon = d.angle("upsilon", "tilt of the collector from the zenith", rate=Rate.TICK)
L_0 = d.parameter.length("L_0", "height of the column")
L_1 = d.parameter.length("L_1", "post on the turntable, up to the horizontal axis")
L_2 = d.parameter.length("L_2", "arm of the cradle that carries the collector")
enu = d.unit_vector("enu", "unit vector to the sun", latex=r"\mathbf{c}")

# ---- the chain ----


def mount(gamma, upsilon):
    """The chain (14); the drive angles turn clockwise, as its transposes say.

    (14) puts the post before the tilt, so the arm alone swings with the cradle.
    """
    return (
        Chain("ground")
        .translate(Z, L_0)
        .rotate(Z, -gamma, frame="turntable")
        .translate(Z, L_1)
        .rotate(X, -upsilon, frame="cradle")
        .translate(Y, L_2, frame="collector")
    )


chain = mount(gamma, upsilon)
gamma_dot, upsilon_dot = gamma.rate(), upsilon.rate()

M = d.define(
    "M",
    chain.pose("ground", "collector"),
    because="The pose of the collector is the product of its joints from the ground up.",
    meaning="pose of the collector in east-north-up axes at the foot of the column",
    printed="14",
)

# ---- motion ----

Omega_space = d.define(
    "Omega_space",
    chain.angular_velocity("collector"),
    because="Angular velocities add, each about its axis as the joints before it have turned it.",
    meaning="angular velocity of the collector, east-north-up axes",
    printed="16",
)
Omega_body = d.define(
    "Omega_body",
    chain.body_angular_velocity("collector"),
    because="The same sum, each axis carried inward to the collector instead of out to the ground.",
    meaning="angular velocity of the collector, its own axes",
)
v_origin = d.define(
    "v_origin",
    chain.velocity("collector"),
    because="Each joint moves the collector's origin by its axis crossed with the arm from the "
    "axis to the origin.",
    meaning="velocity of the collector's origin",
)
v_spatial = d.define(
    "v_spatial",
    v_origin - Omega_space.cross(M.position),
    because="The point of the body that passes the foot of the column lies one position vector "
    "back from the collector's origin.",
    meaning="velocity of the body point that passes the foot of the column",
    printed="9",
)
V_space = d.define(
    "V_space",
    Twist(Omega_space, v_spatial),
    because="The velocity matrix is the rate of the pose times its inverse: the skew matrix of the "
    "angular velocity beside the velocity at the foot.",
    meaning="velocity matrix",
    printed="8",
)
J = d.define(
    "J",
    chain.jacobian("collector", (gamma, upsilon)),
    because="Column by column, the motion of the collector while one drive runs at unit speed.",
    meaning="Jacobian: velocity of the collector's origin over its angular velocity",
)

d.identity(
    "both angular velocities are one vector", Omega_space, M.rotation @ Omega_body
)
d.identity(
    "the point at the foot moves as the horizontal axis carries it: the vertical axis passes there",
    v_spatial,
    upsilon_dot * (M.rotation @ vector(1, 0, 0)).cross(vector(0, 0, L_0 + L_1)),
)
d.kernel("velocity", inputs=[gamma, upsilon, gamma_dot, upsilon_dot], outputs=[Omega_space, Omega_body, v_origin, v_spatial, V_space])
from armillary.algebra import vector as v
from armillary.algebra.derivative import Differentiator, of_time
from armillary.algebra.rotation import rotate
from armillary.mechanism.chain import Turn
def spatial(chain, frame):
    diff = Differentiator(of_time)
    spin = vel = v.NULL
    for step in reversed(chain.steps[:chain.position_of(frame)]):
        if isinstance(step, Turn):
            spin = v.add_vectors(v.scale(diff.scalar(step.angle), v.Basis(step.axis)), rotate(step.rotation, spin))
            vel = rotate(step.rotation, vel)
        else:
            vel = v.add_vectors(vel, v.add_vectors(v.cross(step.offset, spin), diff.vector(step.offset)))
    return vel
vs = d.define("vs", spatial(chain, "collector"), because="x")
d.identity("vs", vs, v_spatial)
d.kernel("velocity2", inputs=[gamma, upsilon, gamma_dot, upsilon_dot], outputs={"Omega_space":Omega_space, "Omega_body":Omega_body, "v_origin":v_origin, "v_spatial":vs, "V_space":Twist(Omega_space, vs)})
d.kernel("velocity3", inputs=[gamma, upsilon, gamma_dot, upsilon_dot], outputs=[Omega_space, Omega_body, v_origin])
d.kernel("velocity4", inputs=[gamma, upsilon, gamma_dot, upsilon_dot], outputs=[vs])
