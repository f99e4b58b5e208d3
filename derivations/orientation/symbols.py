"""The record of the triples, and what its parts share."""

from armillary import Chain, Derivation, Rate

d = Derivation(
    "orientation",
    title="Orientation triples",
    paper="ky",
    summary="Three turns about the body's own axes reach every attitude. Each triple of angles "
    "loses one freedom at its singular set, and no triple is without one; they differ in where it "
    "lies. Here are four triples both ways, with their angular velocities, and a product of the "
    "paper that is no triple.",
)

a = d.angle("a", "first angle; of tilt and torsion the direction of the tilt", rate=Rate.TICK)
b = d.angle("b", "second angle; of tilt and torsion the tilt", rate=Rate.TICK)
c = d.angle("c", "third angle; of tilt and torsion the torsion", rate=Rate.TICK)
R = d.rotation("R", "attitude: its columns are the body's axes in the base")
a_dot, b_dot, c_dot = a.rate(), b.rate(), c.rate()
Omega = d.vector("Omega", "angular velocity of the body in base axes", unit=a_dot.unit)
tolerance = d.constant(
    "tolerance",
    "1e-6",
    "sine of the distance from the singular set below which an angle is taken as free",
    latex=r"\tau",
)


def turns(*steps):
    """A body that turns about its own axes, one after the other."""
    chain = Chain("base")
    for k, (axis, angle) in enumerate(steps, 1):
        chain = chain.rotate(axis, angle, frame="body" if k == len(steps) else None)
    return chain


def attitude(chain):
    """The rotation of the body."""
    return chain.rotation("base", "body")
