"""How few operations the benchmark kernels need, each written as a text book writes it."""

from dataclasses import dataclass

import pytest
import sympy

from armillary import (
    Chain,
    Derivation,
    X,
    Y,
    Z,
    atan2,
    direction_angles,
    hypot,
    partial,
    unit,
)  # fmt: skip
from armillary.algebra.explicit import elementary_matrix, symbol
from armillary.program.compile import compile_kernel
from tests.programs import kernel_of


def test_two_axis_pose_and_jacobian():
    d = Derivation("k1", title="K1")
    gamma, nu = d.angle("gamma", "first"), d.angle("nu", "second")
    lengths = [d.parameter.length(f"L_{k}", "a length") for k in range(3)]
    chain = (
        Chain("ground").translate(Z, lengths[0]).rotate(Z, gamma).translate(Y, lengths[1])
        .rotate(X, nu).translate(Z, lengths[2], frame="tip")
    )  # fmt: skip
    outputs = {"T": chain.pose("ground", "tip"), "J": chain.jacobian("tip", (gamma, nu))}
    cost = compile_kernel(kernel_of(d, [gamma, nu], outputs)).cost
    assert cost.flops <= 12
    assert cost.trigonometry <= 4
    assert cost.inverse == cost.divide == cost.sqrt == 0


def heliostat(angles):
    d = Derivation("k2", title="K2")
    hour, dec, lat = (d.angle(n, "sun") for n in ("hour", "dec", "lat"))
    b = d.unit_vector("b", "towards the receiver")
    theta, psi, chi = (d.angle(n, "tilt of the base") for n in ("theta", "psi", "chi"))
    sky = Chain("site").rotate(X, lat).rotate(Y, -hour).rotate(X, -dec, frame="sun")
    sun = sky.rotation("site", "sun").column(2)
    base = Chain("site").rotate(Z, chi).rotate(Y, psi).rotate(X, theta, frame="base")
    n = base.rotation("base", "site") @ unit(b + sun)
    azimuth, elevation = angles(n)
    outputs = {"n": n, "azimuth": azimuth, "elevation": elevation}
    for q in (theta, psi, chi):
        outputs[f"az_{q.name}"] = partial(azimuth, q)
        outputs[f"el_{q.name}"] = partial(elevation, q)
    return compile_kernel(kernel_of(d, [hour, dec, lat, b, theta, psi, chi], outputs)).cost


def test_heliostat_angles_and_jacobian():
    cost = heliostat(direction_angles)
    assert cost.flops <= 59
    assert cost.divide == cost.sqrt == 2
    assert cost.trigonometry <= 12
    assert cost.inverse == 2


def test_heliostat_by_arc_tangents():
    """Written with atan2 and hypot the chain rule must not cost much more."""
    cost = heliostat(lambda n: (atan2(n.x, n.y), atan2(n.z, hypot(n.x, n.y))))
    assert cost.flops <= 130
    assert cost.trigonometry <= 12


@dataclass(frozen=True)
class Arm:
    """Joint axes, and the axes of the links behind each joint."""

    axes: tuple[int, ...]
    links: tuple[tuple[int, ...], ...]

    def named(self):
        """For each joint its axis, its angle's name, and its links with their names."""
        for k, (axis, links) in enumerate(zip(self.axes, self.links, strict=True), 1):
            yield axis, f"q{k}", [(link, f"d{k}{'xyz'[link]}") for link in links]


ARMS = {
    "spherical wrist": Arm((Z, Y, Y, X, Y, X), ((Z,), (Z,), (X,), (), (), (X,))),
    "three parallel axes": Arm((Z, Y, Y, Y, Z, Y), ((Z,), (X,), (X,), (Y,), (Z,), (Y,))),
    "offset shoulder": Arm((Z, Y, Y, Z, Y, Z), ((), (X, Y), (X, Z), (), (), (Z,))),
    "tool on the wrist": Arm((Y, X, Z, X, Y, Z), ((X, Z), (), (Y,), (Y,), (), ())),
    "no two axes parallel": Arm((X, Y, Z, X, Y, Z), ((Y,), (Z,), (X,), (), (Z,), (X, Y))),
    "offsets everywhere": Arm((Z, X, Y, Z, X, Z), ((X, Z), (Y,), (X, Y), (Z,), (X,), (Y, Z))),
}


@pytest.mark.parametrize("arm", ARMS.values(), ids=list(ARMS))
def test_six_axis_arm_against_common_subexpressions(arm):
    d = Derivation("arm", title="Arm")
    q, chain = [], Chain("base")
    for axis, name, links in arm.named():
        q.append(d.angle(name, "joint"))
        chain = chain.rotate(axis, q[-1])
        for along, length in links:
            chain = chain.translate(along, d.parameter.length(length, "link"))
    chain = chain.translate(X, 0, frame="tool")
    ours = compile_kernel(kernel_of(d, q, {"J": chain.jacobian("tool", tuple(q))})).cost
    for recipe in (by_differentiation, by_cross_products):
        flops, calls = counted(recipe(arm))
        assert ours.flops <= flops
        assert ours.weighted <= flops + 40 * calls


def frames(arm):
    """Joint frames and tool frame as full matrices, multiplied in order."""
    pose, found = sympy.eye(4), []
    for axis, name, links in arm.named():
        turn = sympy.eye(4)
        turn[:3, :3] = elementary_matrix(axis, symbol(name))
        pose = pose * turn
        found.append(pose)
        for along, length in links:
            shift = sympy.eye(4)
            shift[along, 3] = symbol(length)
            pose = pose * shift
    return found, pose


def by_differentiation(arm):
    joints, tool = frames(arm)
    linear = tool[:3, 3].jacobian([symbol(name) for _, name, _ in arm.named()])
    return linear.col_join(axes(arm, joints))


def by_cross_products(arm):
    joints, tool = frames(arm)
    linear = sympy.zeros(3, 6)
    for k, (frame, axis) in enumerate(zip(joints, arm.axes, strict=True)):
        linear[:, k] = frame[:3, axis].cross(tool[:3, 3] - frame[:3, 3])
    return linear.col_join(axes(arm, joints))


def axes(arm, joints):
    return sympy.Matrix.hstack(*(f[:3, x] for f, x in zip(joints, arm.axes, strict=True)))


def counted(matrix):
    """Additions and multiplications, and calls of sine and cosine, after SymPy's own cse."""
    shared, (reduced,) = sympy.cse(matrix, optimizations="basic")
    flops = calls = 0
    for expression in [e for _, e in shared] + list(reduced):
        for node in sympy.preorder_traversal(expression):
            if node.is_Add:
                flops += len(node.args) - 1
            elif node.is_Mul:
                flops += len([f for f in node.args if f != -1]) - 1
            elif node.is_Pow:
                flops += abs(int(node.exp)) - 1
            elif isinstance(node, (sympy.sin, sympy.cos)):
                calls += 1
    return flops, calls


@pytest.mark.parametrize("arm", ARMS.values(), ids=list(ARMS))
def test_both_recipes_give_one_jacobian(arm):
    """So that the comparison is fair."""
    difference = by_differentiation(arm) - by_cross_products(arm)
    names = sorted(difference.free_symbols, key=str)
    point = {name: sympy.Rational(k + 3, 7) for k, name in enumerate(names)}
    assert max(abs(e) for e in difference.subs(point).evalf(20)) < 1e-18
