"""Legs on universal joints, against SymPy: two turns and a slide as functions of the time."""

import numpy as np
import pytest
import sympy

from armillary import (
    UniversalLeg,
    Wrench,
    leg_axes,
    number,
    second_axis,
    unit,
    vector,
)
from tests.programs import answers

time = sympy.Symbol("t")
GAMMA = 0.4 + 0.9 * time - 0.35 * time**2
PSI = -0.7 + 0.6 * time + 0.8 * time**2
LENGTH = 1.3 - 0.5 * time + 0.45 * time**2
TOLERANCE = {"rtol": 1e-13, "atol": 1e-13}


def frame():
    """The leg's axes in the base, columns x, y, z."""
    c, s = sympy.cos, sympy.sin
    first = sympy.Matrix([[c(GAMMA), -s(GAMMA), 0], [s(GAMMA), c(GAMMA), 0], [0, 0, 1]])
    return first * sympy.Matrix([[1, 0, 0], [0, c(PSI), -s(PSI)], [0, s(PSI), c(PSI)]])


def now(expression):
    return np.array(expression.subs(time, 0).evalf(30).tolist(), dtype=float).squeeze()


def vee(skew):
    return sympy.Matrix([skew[2, 1], skew[0, 2], skew[1, 0]])


@pytest.fixture(scope="module")
def true():
    """What the mechanism does at this moment, vectors in leg axes."""
    R = frame()
    end = R[:, 1] * LENGTH
    omega = vee(R.diff(time) * R.T)
    vectors = {
        "v": end.diff(time),
        "a": end.diff(time, 2),
        "turning": R[:, 1].diff(time),
        "turning_rate": R[:, 1].diff(time, 2),
        "omega": omega,
        "omega_dot": omega.diff(time),
    }
    return {name: now(R.T * value) for name, value in vectors.items()} | {"R": now(R)}


def exact(values):
    return vector(*(number(float(value)) for value in values))


def leg_of(tangent=True):
    psi = float(PSI.subs(time, 0))
    return UniversalLeg(number(1.3), number(float(np.tan(psi))) if tangent else None)


def motion(true, leg):
    turning = leg.turning(exact(true["v"]))
    rate = leg.turning_rate(exact(true["v"]), exact(true["a"]), turning)
    spin, spin_rate = leg.spin(turning), leg.spin_rate(turning, rate)
    return answers(
        turning=turning,
        turning_rate=rate,
        omega=leg.angular_velocity(turning, spin),
        omega_dot=leg.angular_acceleration(turning, rate, spin, spin_rate),
    )


def test_a_leg_turns_and_accelerates_as_its_two_axes_make_it(true):
    found = motion(true, leg_of())
    for name, value in found.items():
        np.testing.assert_allclose(value, true[name], err_msg=name, **TOLERANCE)
    assert abs(true["omega"][1]) > 0.3  # it does spin


def test_a_leg_without_spin_keeps_its_direction_and_nothing_more(true):
    found = motion(true, leg_of(tangent=False))
    along = np.array([0.0, 1.0, 0.0])
    np.testing.assert_allclose(found["turning"], true["turning"], **TOLERANCE)
    np.testing.assert_allclose(np.cross(along, true["turning"]), found["omega"], **TOLERANCE)
    np.testing.assert_allclose(
        np.cross(along, true["turning_rate"]), found["omega_dot"], **TOLERANCE
    )


def test_its_axes_follow_from_its_direction(true):
    R = true["R"]
    direction = unit(exact(R[:, 1]))
    second = second_axis(direction, vector(0, 0, 1))
    axes = leg_axes(direction, second / second.norm())
    found = answers(x=axes.x, y=axes.y, z=axes.z)
    for column, name in enumerate("xyz"):
        np.testing.assert_allclose(found[name], R[:, column], **TOLERANCE)


@pytest.mark.parametrize("spins", [True, False])
def test_the_force_at_its_end_does_the_work_of_what_is_asked(true, spins):
    """Along each rate of the two angles and the length, in turn."""
    moment, force = np.array([0.3, -1.1, 0.8]), np.array([0.0, 2.5, 0.0])
    leg = leg_of(tangent=spins)
    asked = answers(f=leg.asked(Wrench(exact(moment), exact(force))))["f"]
    psi, length = float(PSI.subs(time, 0)), 1.3
    sine, cosine = np.sin(psi), np.cos(psi)
    first = np.array([0.0, sine, cosine])
    if not spins:  # what spins it is left out of the work
        first[1] = 0.0
    ways = [
        (np.array([-length * cosine, 0, 0]), first, 0.0),
        (np.array([0, 0, length]), np.array([1.0, 0, 0]), 0.0),
        (np.array([0, 1.0, 0]), np.zeros(3), 1.0),
    ]
    for end, turn, slide in ways:
        assert asked @ end == pytest.approx(moment @ turn + force[1] * slide, abs=1e-13)
