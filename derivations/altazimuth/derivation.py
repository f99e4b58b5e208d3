"""Altazimuth tracker: a vertical axis carries a horizontal one (Ky et al., configuration 1)."""

from armillary import Chain, Derivation, Rate, Status, X, Y, Z, atan2, hypot, where

derivation = d = Derivation("altazimuth", title="Altazimuth tracker", paper="ky")

gamma = d.angle("gamma", "azimuth drive angle, clockwise seen from above", rate=Rate.TICK)
upsilon = d.angle("upsilon", "tilt of the collector from the zenith", rate=Rate.TICK)
L_0 = d.parameter.length("L_0", "height of the column")
L_1 = d.parameter.length("L_1", "post on the turntable")
L_2 = d.parameter.length("L_2", "arm that carries the collector")

mount = (
    Chain("ground")
    .translate(Z, L_0)
    .rotate(Z, -gamma, frame="turntable")
    .translate(Z, L_1)
    .rotate(X, -upsilon, frame="cradle")
    .translate(Y, L_2, frame="collector")
)

M = d.define("M", mount.pose("ground", "collector"), because="compose the joints from the ground up", printed="14")
gamma_dot, upsilon_dot = gamma.rate(), upsilon.rate()
Omega = d.define("Omega_space", mount.angular_velocity("collector"), because="each axis, carried by the joints before it", printed="16")
v = d.define("v_origin", mount.velocity("collector"), because="differentiate the origin of the collector frame")
J = d.define("J", mount.jacobian("collector", (gamma, upsilon)), because="columns")

d.kernel("pose", inputs=[gamma, upsilon], outputs=[M])
d.kernel("velocity", inputs=[gamma, upsilon, gamma_dot, upsilon_dot], outputs=[Omega, v])
d.kernel("jacobian", inputs=[gamma, upsilon], outputs=[J])
d.kernel("both", inputs=[gamma, upsilon], outputs=[M, J])
