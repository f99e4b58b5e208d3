"""Platforms against NumPy: random legs, like and unlike, on revolute and on universal joints."""

import numpy as np
import pytest

from armillary import (
    Chain,
    Derivation,
    Leg,
    Platform,
    Pose,
    Wrench,
    X,
    Y,
    Z,
    cos,
    degrees,
    number,
    sin,
    stack_wrenches,
    total,
    unit,
    vector,
    virtual_work,
)
from armillary.algebra.misuse import MisuseError
from tests.programs import program_of, value_of

ANGLES, PLACES = ("a", "b", "c"), ("x", "y", "z")
STEP = 1e-6
POINT = {"a": 0.3, "b": -0.5, "c": 0.7, "x": 0.1, "y": -0.2, "z": 2.3}
SPEED = {"a": 0.4, "b": 0.2, "c": -0.6, "x": -0.3, "y": 0.5, "z": 0.1}
BASES = np.array([[1.0, 0.2, -0.1], [-0.7, 1.1, 0.0], [-0.4, -1.3, 0.2], [0.9, -0.8, 0.1]])
JOINTS = np.array([[0.4, 0.1, 0.2], [-0.3, 0.5, 0.0], [-0.2, -0.6, -0.1], [0.5, -0.3, 0.3]])
HINGES = np.array([[0.3, 1.0, 0.0], [1.0, 0.5, 0.1], [-0.8, 0.4, 0.0], [0.1, 0.9, 0.3]])
HINGES = HINGES / np.linalg.norm(HINGES, axis=1, keepdims=True)


@pytest.fixture
def body():
    """A record, the quantities of a body that moves in all six ways, its chain."""
    d = Derivation("body", title="Body")
    angles = [d.angle(name, "angle") for name in ANGLES]
    places = [d.scalar(name, "place") for name in PLACES]
    for q in (*angles, *places):
        q.rate()
    chain = (
        Chain("base").translate(X, places[0]).translate(Y, places[1]).translate(Z, places[2])
        .rotate(Z, angles[0]).rotate(Y, angles[1]).rotate(X, angles[2], frame="top")
    )  # fmt: skip
    return d, [*angles, *places], chain


def exact(row):
    return vector(*(float(x) for x in row))


def unlike(hinged):
    """Four legs, on revolute joints or on universal ones."""
    # Its components as written are not of length 1 to 50 digits.
    axes = [unit(exact(axis)) if hinged else None for axis in HINGES]
    return tuple(
        Leg(exact(b), exact(s), axis) for b, s, axis in zip(BASES, JOINTS, axes, strict=True)
    )


def pose_of(point):
    """Rotation and position in NumPy."""

    def turn(axis, angle):
        found, (i, j) = np.eye(3), ((axis + 1) % 3, (axis + 2) % 3)
        found[i, i] = found[j, j] = np.cos(angle)
        found[i, j], found[j, i] = -np.sin(angle), np.sin(angle)
        return found

    turned = turn(2, point["a"]) @ turn(1, point["b"]) @ turn(0, point["c"])
    return turned, np.array([point[name] for name in PLACES])


def legs_of(point):
    """Vectors along the legs, (4, 3)."""
    R, p = pose_of(point)
    return p + JOINTS @ R.T - BASES


def along(function, point=POINT, speed=SPEED):
    """Rate of a function of the pose, by a central difference."""
    ahead, behind = (
        function({name: point[name] + s * STEP * speed[name] for name in point}) for s in (1, -1)
    )
    return (ahead - behind) / (2 * STEP)


def answers(body, outputs):
    d, quantities, _ = body
    program = program_of(d, [*quantities, *(q.rate() for q in quantities)], outputs)
    point = {**POINT, **{f"{name}_dot": s for name, s in SPEED.items()}}
    return {name: np.array(value_of(program, point, name)) for name in outputs}


def platform_of(body, hinged):
    _, _, chain = body
    return Platform(chain.pose("base", "top"), unlike(hinged)), chain.twist("top")


def test_lengths_and_their_rates(body):
    platform, twist = platform_of(body, hinged=False)
    outputs = {}
    for k, leg in enumerate(platform.placed):
        outputs |= {f"l{k}": leg.length, f"rate{k}": leg.extension_rate(twist),
                    f"e{k}": leg.direction, f"v{k}": leg.joint_velocity(twist)}  # fmt: skip
    found = answers(body, outputs)
    wanted = legs_of(POINT)
    lengths = np.linalg.norm(wanted, axis=1)
    speeds = along(lambda p: np.linalg.norm(legs_of(p), axis=1))
    for k in range(4):
        np.testing.assert_allclose(found[f"l{k}"], lengths[k], rtol=1e-14)
        np.testing.assert_allclose(found[f"e{k}"], wanted[k] / lengths[k], rtol=1e-14)
        np.testing.assert_allclose(found[f"rate{k}"], speeds[k], atol=1e-9)
        np.testing.assert_allclose(found[f"v{k}"], along(legs_of)[k], atol=1e-9)


def test_rows_are_a_jacobian(body):
    """What the rows make of the twist is the rate, of the lengths and of the planes' distances."""
    platform, twist = platform_of(body, hinged=True)
    lengths = stack_wrenches(*(leg.row for leg in platform.placed))
    planes = stack_wrenches(*(leg.plane_row for leg in platform.placed))
    outputs = {"J": lengths, "P": planes, "w": twist.angular, "v": twist.linear}
    outputs |= {f"off{k}": leg.plane_residual for k, leg in enumerate(platform.placed)}
    found = answers(body, outputs)
    motion = np.concatenate([found["v"], found["w"]])
    np.testing.assert_allclose(
        found["J"].reshape(4, 6) @ motion,
        along(lambda p: np.linalg.norm(legs_of(p), axis=1)), atol=1e-9,
    )  # fmt: skip

    def off(point):
        return np.sum(HINGES * legs_of(point), axis=1)

    np.testing.assert_allclose([found[f"off{k}"] for k in range(4)], off(POINT), atol=1e-14)
    np.testing.assert_allclose(found["P"].reshape(4, 6) @ motion, along(off), atol=1e-9)


def test_a_leg_turns_about_its_hinge(body):
    """Legs in the planes of their hinges: the angle in the plane, by a central difference."""
    _, _, chain = body
    across = np.cross(legs_of(POINT), [0.2, -0.4, 1.0])
    hinges = across / np.linalg.norm(across, axis=1, keepdims=True)
    ups = np.cross(hinges, legs_of(POINT))  # square to leg and hinge

    def angle(point):
        vectors = legs_of(point)
        return np.arctan2(np.sum(ups * vectors, axis=1) / np.linalg.norm(ups, axis=1),
                          np.sum(legs_of(POINT) * vectors, axis=1)
                          / np.linalg.norm(legs_of(POINT), axis=1))  # fmt: skip

    legs = [
        Leg(exact(b), exact(s), unit(exact(t)))
        for b, s, t in zip(BASES, JOINTS, hinges, strict=True)
    ]
    platform, twist = Platform(chain.pose("base", "top"), tuple(legs)), chain.twist("top")
    outputs = {f"t{k}": leg.turn_rate(twist) for k, leg in enumerate(platform.placed)}
    outputs |= {f"w{k}": leg.angular_velocity(twist) for k, leg in enumerate(platform.placed)}
    found, wanted = answers(body, outputs), along(angle)
    assert np.abs(wanted).min() > 0.01
    for k in range(4):
        np.testing.assert_allclose(found[f"t{k}"], wanted[k], atol=1e-9)
        np.testing.assert_allclose(found[f"w{k}"], wanted[k] * hinges[k], atol=1e-9)


def test_a_leg_on_a_universal_joint_does_not_spin(body):
    """It turns square to itself, as its end says."""
    platform, twist = platform_of(body, hinged=False)
    found = answers(
        body, {f"w{k}": leg.angular_velocity(twist) for k, leg in enumerate(platform.placed)}
    )
    vectors, speeds = legs_of(POINT), along(legs_of)
    for k in range(4):
        spin = found[f"w{k}"]
        assert abs(spin @ vectors[k]) < 1e-12
        stretch = (vectors[k] @ speeds[k]) / (vectors[k] @ vectors[k])
        turned = np.cross(spin, vectors[k]) + stretch * vectors[k]
        np.testing.assert_allclose(turned, speeds[k], atol=1e-9)


def test_loops_close_at_the_true_lengths_alone(body):
    platform, _ = platform_of(body, hinged=False)
    true = [leg.length for leg in platform.placed]
    closed, open_ = platform.loop_closure(true), platform.loop_closure([1.01 * l for l in true])
    found = answers(body, {f"c{k}": c for k, c in enumerate((*closed, *open_))})
    assert all(abs(found[f"c{k}"]) < 1e-13 for k in range(4))
    lengths = np.linalg.norm(legs_of(POINT), axis=1)
    np.testing.assert_allclose(
        [found[f"c{k}"] for k in range(4, 8)], lengths**2 * (1 - 1.01**2), rtol=1e-12
    )


def test_work_of_legs_and_load_is_that_of_their_forces(body):
    """Unit forces along the legs and a load: each does its force times the way of its point."""
    platform, twist = platform_of(body, hinged=False)
    load = Wrench(vector(3, -1, 2), vector(-5, 4, 1))
    found = answers(body, {
        "work": virtual_work([*((leg.row, twist) for leg in platform.placed), (load, twist)]),
        "w": twist.angular,
    })  # fmt: skip
    rates = along(lambda p: np.linalg.norm(legs_of(p), axis=1))
    moved = np.array([SPEED[name] for name in PLACES])
    wanted = rates.sum() + moved @ [-5, 4, 1] + found["w"] @ [3, -1, 2]
    np.testing.assert_allclose(found["work"], wanted, atol=1e-9)


def test_like_legs_are_one_leg_for_each_part(body):
    """A leg of per-part points answers for each part what three legs one by one do."""
    d, _, chain = body
    index = d.index("leg", 3)
    azimuths = (0, degrees(120), degrees(-120))
    theta = d.constant("theta", azimuths, "azimuth", per=index)

    def leg(azimuth):
        u = vector(cos(azimuth), sin(azimuth), 0)
        return Leg(1.5 * u, 0.6 * u, vector(-sin(azimuth), cos(azimuth), 0))

    pose, twist = chain.pose("base", "top"), chain.twist("top")
    like, each = Platform(pose, (leg(theta),)), Platform(pose, tuple(map(leg, azimuths_of())))
    found = answers(body, {
        "l": like.leg.length, "rate": like.leg.extension_rate(twist),
        "sum": total(like.leg.plane_residual, over=index),
        **{f"l{k}": one.length for k, one in enumerate(each.placed)},
        **{f"rate{k}": one.extension_rate(twist) for k, one in enumerate(each.placed)},
        **{f"off{k}": one.plane_residual for k, one in enumerate(each.placed)},
    })  # fmt: skip
    for name in ("l", "rate"):
        np.testing.assert_allclose(found[name], [found[f"{name}{k}"] for k in range(3)], rtol=1e-13)
    np.testing.assert_allclose(found["sum"], sum(found[f"off{k}"] for k in range(3)), atol=1e-13)
    assert len(set(np.round(found["l"], 6))) == 3


def azimuths_of():
    return (number(0), degrees(120), degrees(-120))


def test_what_a_platform_cannot_answer_is_told():
    pose = Pose(Chain("a").rotate(Z, 0, frame="b").rotation("a", "b"), vector(0, 0, 1))
    platform = Platform(pose, unlike(hinged=False))
    with pytest.raises(MisuseError, match="4 unlike legs"):
        _ = platform.leg
    with pytest.raises(MisuseError, match="universal joint"):
        _ = platform.placed[0].plane_residual
    with pytest.raises(ValueError, match="shorter"):
        platform.loop_closure([platform.placed[0].length])
