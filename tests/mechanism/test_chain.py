"""Chains against pinocchio, and against products of SymPy matrices."""

import numpy as np
import pytest
import sympy
from hypothesis import given

from armillary import Chain, Derivation, X, Y, Z, vector
from armillary.algebra.explicit import Explicit, elementary_matrix, reduce_trigonometry, symbol
from armillary.algebra.vector import VectorSymbol
from armillary.program.compile import compile_kernel
from armillary.program.lower import strategies
from tests.mechanism.chains import JOINTS, chain_of, mechanism_of
from tests.programs import kernel_of, program_of, value_of

SPEEDS = np.array([0.3, -0.7, 0.5, 1.1, -0.2, 0.9])
PLACES = np.array([[0.4, -1.2, 2.0, 0.7, -0.3, 1.9], [3.0, 0.1, -0.5, 1.3, 2.2, -2.7]])


def near(found, wanted):
    wanted = np.asarray(wanted).ravel()
    assert np.max(np.abs(np.asarray(found) - wanted)) <= 1e-13 * max(1.0, np.max(np.abs(wanted)))


@given(JOINTS)
def test_random_chains_against_pinocchio(joints):
    pytest.importorskip("pinocchio")
    d, chain, variables = chain_of(joints)
    rates = [q.rate() for q in variables]
    tip = f"f{len(joints) - 1}"
    kernel = kernel_of(d, [*variables, *rates], {
        "M": chain.pose("base", tip),
        "J": chain.jacobian(tip, variables),
        "w": chain.angular_velocity(tip),
        "v": chain.velocity(tip),
        "body": chain.body_angular_velocity(tip),
        "spatial": chain.spatial_velocity(tip),
    })  # fmt: skip
    program = compile_kernel(kernel).program
    mechanism = mechanism_of(joints)
    for place in PLACES:
        q, speed = place[: len(joints)], SPEEDS[: len(joints)]
        point = {v.name: float(x) for v, x in zip(variables, q, strict=True)}
        point |= {r.name: float(x) for r, x in zip(rates, speed, strict=True)}
        near(value_of(program, point, "M"), mechanism.pose(q))
        near(value_of(program, point, "J"), mechanism.jacobian(q))
        motion = mechanism.velocity(q, speed)
        near(value_of(program, point, "v"), motion[:3])
        near(value_of(program, point, "w"), motion[3:])
        at_base = motion[:3] + np.cross(motion[3:], -mechanism.pose(q)[:3, 3])
        near(value_of(program, point, "spatial"), at_base)
        near(value_of(program, point, "body"), mechanism.body_velocity(q, speed)[3:])


@given(JOINTS)
def test_the_laws_of_every_chain(joints):
    """What holds for any chain is proved here, once: as an identity of one it could not fail."""
    d, chain, variables = chain_of(joints)
    rates = [q.rate() for q in variables]
    tip = f"f{len(joints) - 1}"
    pose, spin = chain.pose("base", tip), chain.angular_velocity(tip)
    outputs = {
        "spin": spin,
        "spin_carried_out": pose.rotation @ chain.body_angular_velocity(tip),
        "velocity": chain.velocity(tip),
        "velocity_about_the_base": chain.spatial_velocity(tip) + spin.cross(pose.position),
        "J": chain.jacobian(tip, variables),
    }
    program = program_of(d, [*variables, *rates], outputs)
    for place in PLACES:
        speed = SPEEDS[: len(joints)]
        point = {v.name: float(x) for v, x in zip(variables, place, strict=False)}
        point |= {r.name: float(x) for r, x in zip(rates, speed, strict=True)}
        found = {name: np.asarray(value_of(program, point, name)) for name in outputs}
        near(found["spin_carried_out"], found["spin"])
        near(found["velocity_about_the_base"], found["velocity"])
        columns = found["J"].reshape(6, -1) @ speed
        near(columns, np.concatenate([found["velocity"], found["spin"]]))


@given(JOINTS)
def test_every_strategy_gives_the_same_values(joints):
    d, chain, variables = chain_of(joints)
    rates = [q.rate() for q in variables]
    tip = f"f{len(joints) - 1}"
    outputs = {
        "J": chain.jacobian(tip, variables),
        "v": chain.velocity(tip),
        "w": chain.angular_velocity(tip),
    }
    point = {v.name: float(x) for v, x in zip(variables, PLACES[0], strict=False)}
    point |= {r.name: float(x) for r, x in zip(rates, SPEEDS, strict=False)}
    plain = program_of(d, [*variables, *rates], outputs)
    for strategy in strategies():
        program = program_of(d, [*variables, *rates], outputs, strategy)
        for name in outputs:
            near(value_of(program, point, name), value_of(plain, point, name))


a, b, L = (symbol(n) for n in ("a", "b", "L"))


def example():
    d = Derivation("example", title="Example")
    qa, qb = d.angle("a", "first"), d.angle("b", "second")
    length = d.parameter.length("L", "arm")
    chain = (
        Chain("ground")
        .rotate(Z, -qa, frame="column")
        .translate(X, length, frame="arm")
        .rotate(Y, 2 * qb, frame="fork")
        .translate(Z, 3, frame="tip")
    )
    return d, chain, (qa, qb)


def homogeneous(rotation, position=(0, 0, 0)):
    top = rotation.row_join(sympy.Matrix(position))
    return top.col_join(sympy.Matrix([[0, 0, 0, 1]]))


FRAMES = {
    "ground": sympy.eye(4),
    "column": homogeneous(elementary_matrix(2, -a)),
}
FRAMES["arm"] = FRAMES["column"] * homogeneous(sympy.eye(3), (L, 0, 0))
FRAMES["fork"] = FRAMES["arm"] * homogeneous(elementary_matrix(1, 2 * b))
FRAMES["tip"] = FRAMES["fork"] * homogeneous(sympy.eye(3), (0, 0, 3))


@pytest.mark.parametrize("outer", FRAMES)
@pytest.mark.parametrize("inner", FRAMES)
def test_pose_between_any_two_frames(outer, inner):
    _, chain, _ = example()
    found = Explicit()(chain.pose(outer, inner))
    wanted = FRAMES[outer].inv(method="ADJ") * FRAMES[inner]
    assert all(reduce_trigonometry(e) == 0 for e in found - wanted)
    assert Explicit()(chain.rotation(outer, inner)) == found[:3, :3]


def test_velocities_are_derivatives_of_the_pose():
    _, chain, (qa, qb) = example()
    a_dot, b_dot = symbol("a_dot"), symbol("b_dot")
    assert (qa.rate().name, qb.rate().name) == ("a_dot", "b_dot")
    pose = FRAMES["tip"]
    change = pose.diff(a) * a_dot + pose.diff(b) * b_dot
    space = change[:3, :3] * pose[:3, :3].T
    body = pose[:3, :3].T * change[:3, :3]
    vee = lambda m: sympy.Matrix([m[2, 1], m[0, 2], m[1, 0]])  # noqa: E731
    for found, wanted in (
        (chain.angular_velocity("tip"), vee(space)),
        (chain.body_angular_velocity("tip"), vee(body)),
        (chain.velocity("tip"), change[:3, 3]),
    ):
        assert all(reduce_trigonometry(e) == 0 for e in Explicit()(found) - wanted)


def test_velocity_of_a_point_of_a_frame():
    _, chain, (qa, qb) = example()
    qa.rate(), qb.rate()
    point = vector(1, 2, 3)
    pose = FRAMES["tip"]
    place = pose * sympy.Matrix([1, 2, 3, 1])
    change = place.diff(a) * symbol("a_dot") + place.diff(b) * symbol("b_dot")
    found = Explicit()(chain.velocity("tip", point))
    assert all(reduce_trigonometry(e) == 0 for e in found - change[:3, :])
    columns = Explicit()(chain.jacobian("tip", (qa, qb), point))[:3, :]
    wanted = place[:3, :].jacobian([a, b])
    assert all(reduce_trigonometry(e) == 0 for e in columns - wanted)


def test_a_point_may_be_a_symbol():
    _, chain, _ = example()
    pose = chain.pose("ground", "tip")
    p = VectorSymbol("p")
    found = Explicit()(pose.point(p))
    wanted = FRAMES["tip"] * sympy.Matrix([*Explicit()(p), 1])
    assert all(reduce_trigonometry(e) == 0 for e in found - wanted[:3, :])


def test_frames_are_named_once():
    chain = Chain("ground").rotate(Z, "0.1", frame="fork")
    with pytest.raises(ValueError, match="already has a frame named 'fork'"):
        chain.rotate(X, "0.2", frame="fork")
    with pytest.raises(ValueError, match="already has a frame named 'ground'"):
        chain.rotate(X, "0.2", frame="ground")


def test_unknown_frames_are_told_with_the_known_ones():
    chain = Chain("ground").rotate(Z, "0.1", frame="fork")
    with pytest.raises(ValueError, match="no frame named 'tip' in this chain; it has ground, fork"):
        chain.pose("ground", "tip")


def test_an_axis_is_one_of_three():
    with pytest.raises(ValueError, match="an axis is X, Y or Z"):
        Chain("ground").rotate(3, "0.1")


def test_a_chain_is_never_changed():
    chain = Chain("ground")
    chain.rotate(Z, "0.1", frame="fork")
    assert chain.steps == ()
    assert chain.frames == {}
