"""Steady collector: a tilt fixed for good (Ky et al., configuration 4)."""

from armillary import Chain, Derivation, X, Y, Z, atan2, cos, sin, vector

derivation = d = Derivation(
    "steady",
    title="Steady collector",
    paper="ky",
    summary="A collector at a fixed tilt, the quasi-steady mount that is never touched again. It "
    "has no freedom, so there is no velocity and no Jacobian to derive: what matters is where it "
    "faces, and how far the sun stands off.",
)

tilt = d.parameter.angle("tilt", "tilt of the collector, leaning north", latex="I")
L_0 = d.parameter.length("L_0", "height of the column, up to the tilt")
L_1 = d.parameter.length("L_1", "post beyond the tilt")
L_2 = d.parameter.length("L_2", "arm that carries the collector")
enu = d.unit_vector("enu", "unit vector to the sun", latex=r"\mathbf{c}")

chain = (
    Chain("ground")
    .translate(Z, L_0)
    .rotate(X, -tilt)
    .translate(Z, L_1)
    .translate(Y, L_2, frame="collector")
)

M = d.define(
    "M",
    chain.pose("ground", "collector"),
    because="The pose is that of the quasi-steady mount with its angle held.",
    meaning="pose of the collector in East-North-Up axes at the foot of the column",
    printed="20",
)
normal = d.define(
    "normal",
    chain.rotation("ground", "collector").column(2),
    because="The collector looks along its third axis.",
    meaning="unit vector that the collector faces",
    latex=r"\mathbf{n}",
)
incidence = d.define(
    "incidence",
    atan2(normal.cross(enu).norm(), normal.dot(enu)),
    because="Sine over cosine of the angle between two directions keeps its digits where either "
    "alone would lose them.",
    meaning="angle between the sun and the collector's normal, in [0, pi]",
    latex=r"\theta",
)
d.identity(
    "the incidence is that of the text-book: the sun leaning in the meridian against the tilt",
    normal.dot(enu),
    enu.z * cos(tilt) + enu.y * sin(tilt),
)
d.identity(
    "the arm points north, and dips as the collector leans north",
    M.rotation.column(1),
    vector(0, cos(tilt), -sin(tilt)),
)
d.identity(
    "the post lifts the collector, and the arm lowers it as it leans north",
    M.position.z,
    L_0 + L_1 * cos(tilt) - L_2 * sin(tilt),
)
d.identity(
    "post and arm stand at right angles, so Pythagoras tells the distance from the column's head",
    (M.position - vector(0, 0, L_0)).dot(M.position - vector(0, 0, L_0)),
    L_1 * L_1 + L_2 * L_2,
)

d.kernel("pose", inputs=[], outputs=[M], summary="Pose of the collector.")
d.kernel("normal", inputs=[], outputs=[normal], summary="Direction that the collector faces.")
d.kernel(
    "incidence",
    inputs=[enu],
    outputs=[incidence],
    summary="Angle between the sun and the collector's normal.",
)

d.assume(
    "Inferred: the paper does not say where its axes point. That x is east, y north and z up, "
    "and which axis faces the sun, is our reading."
)
d.assume(
    "Inferred: the paper prints no equation for the fixed collector. Ours is its (20) with an "
    "angle that does not change."
)
d.assume("The collector is fixed: nothing of it moves.")
d.picture(
    chain,
    at={"tilt": -0.6, "L_0": 1.0, "L_1": 0.6, "L_2": 0.5},
    caption="The fixed collector, leaning south.",
)
