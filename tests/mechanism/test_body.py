"""Bodies in motion, against SymPy's Euler-Lagrange equations and NumPy."""

import numpy as np
import sympy
from sympy.physics.mechanics import Point, ReferenceFrame, RigidBody, inertia

from armillary import Body, number, vector
from tests.programs import answers

MASS, INERTIA = 2.5, (0.7, 1.9, 1.1)
SPIN, SPIN_RATE = np.array([0.6, -1.2, 0.9]), np.array([-0.4, 0.3, 1.5])
VELOCITY = np.array([0.2, 1.4, -0.8])


def exact(values):
    return vector(*(number(float(value)) for value in values))


def body():
    return Body(number(MASS), exact(INERTIA))


def test_the_moment_is_the_rate_of_the_angular_momentum():
    """In SymPy's frames, with an angular velocity that changes as given."""
    time = sympy.Symbol("t")
    speeds = [
        sympy.Float(w, 30) + sympy.Float(a, 30) * time for w, a in zip(SPIN, SPIN_RATE, strict=True)
    ]
    base, own = ReferenceFrame("N"), ReferenceFrame("B")
    own.set_ang_vel(base, speeds[0] * own.x + speeds[1] * own.y + speeds[2] * own.z)
    centre = Point("C")
    centre.set_vel(base, sum(v * e for v, e in zip(VELOCITY, own, strict=True)))
    rigid = RigidBody("b", centre, own, MASS, (inertia(own, *INERTIA), centre))
    momentum = rigid.angular_momentum(centre, base)
    wanted = momentum.dt(base).to_matrix(own).subs(time, 0)
    energy = rigid.kinetic_energy(base).subs(time, 0)

    moving = body()
    found = answers(
        momentum=moving.angular_momentum(exact(SPIN)),
        moment=moving.moment(exact(SPIN), exact(SPIN_RATE)),
        energy=moving.kinetic_energy(exact(VELOCITY), exact(SPIN)),
    )
    np.testing.assert_allclose(
        found["momentum"], np.array(momentum.to_matrix(own).subs(time, 0), float).ravel(), 1e-14
    )
    np.testing.assert_allclose(found["moment"], np.array(wanted, dtype=float).ravel(), 1e-13)
    np.testing.assert_allclose(found["energy"], float(energy), 1e-14)


def test_what_it_asks_for_is_a_wrench_about_its_centre():
    moving = body()
    demand = moving.demand(exact(VELOCITY), exact(SPIN), exact(SPIN_RATE))
    found = answers(
        force=demand.force, moment=demand.moment, alone=moving.moment(exact(SPIN), exact(SPIN_RATE))
    )
    np.testing.assert_allclose(found["force"], MASS * VELOCITY, 1e-15)
    np.testing.assert_array_equal(found["moment"], found["alone"])
    assert np.linalg.norm(found["moment"]) > 1
