"""How few operations the benchmark kernels need, each written as a text book writes it."""

import sympy

from armillary import (
    Chain,
    Derivation,
    X,
    Y,
    Z,
    atan2,
    cos,
    direction_angles,
    hypot,
    partial,
    sin,
    unit,
    vector,
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
    sun = vector(
        -cos(dec) * sin(hour),
        sin(dec) * cos(lat) - cos(dec) * cos(hour) * sin(lat),
        sin(dec) * sin(lat) + cos(dec) * cos(hour) * cos(lat),
    )
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
    assert cost.flops <= 91
    assert cost.trigonometry <= 12
    assert cost.inverse == 2


def test_heliostat_by_arc_tangents():
    """Written with atan2 and hypot the chain rule must not cost much more."""
    cost = heliostat(lambda n: (atan2(n.x, n.y), atan2(n.z, hypot(n.x, n.y))))
    assert cost.flops <= 130
    assert cost.trigonometry <= 12


AXES = (Z, Y, Y, X, Y, X)
LINKS = ((2, "d1"), (2, "a2"), (0, "a3"), None, None, (0, "d6"))


def test_six_axis_arm_against_common_subexpressions():
    d = Derivation("arm", title="Arm")
    q = tuple(d.angle(f"q{k}", "joint") for k in range(1, 7))
    chain = Chain("base")
    for axis, angle, link in zip(AXES, q, LINKS, strict=True):
        chain = chain.rotate(axis, angle)
        if link:
            chain = chain.translate(link[0], d.parameter.length(link[1], "link"))
    chain = chain.translate(X, 0, frame="tool")
    ours = compile_kernel(kernel_of(d, list(q), {"J": chain.jacobian("tool", q)})).cost
    for recipe in (by_differentiation, by_cross_products):
        flops, calls = counted(recipe())
        assert ours.flops <= flops
        assert ours.weighted <= flops + 40 * calls


def frames():
    """Joint frames and tool frame as full matrices, multiplied in order."""
    pose, found = sympy.eye(4), []
    for k, (axis, link) in enumerate(zip(AXES, LINKS, strict=True), 1):
        turn = sympy.eye(4)
        turn[:3, :3] = elementary_matrix(axis, symbol(f"q{k}"))
        pose = pose * turn
        found.append(pose)
        if link:
            shift = sympy.eye(4)
            shift[link[0], 3] = symbol(link[1])
            pose = pose * shift
    return found, pose


def by_differentiation():
    joints, tool = frames()
    linear = tool[:3, 3].jacobian([symbol(f"q{k}") for k in range(1, 7)])
    return linear.col_join(axes(joints))


def by_cross_products():
    joints, tool = frames()
    linear = sympy.zeros(3, 6)
    for k, (frame, axis) in enumerate(zip(joints, AXES, strict=True)):
        linear[:, k] = frame[:3, axis].cross(tool[:3, 3] - frame[:3, 3])
    return linear.col_join(axes(joints))


def axes(joints):
    return sympy.Matrix.hstack(*(f[:3, x] for f, x in zip(joints, AXES, strict=True)))


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


def test_the_explicit_form_has_the_same_jacobian():
    """The two recipes above are the same matrix, so the comparison is fair."""
    point = {symbol(f"q{k}"): sympy.Rational(k, 3) for k in range(1, 7)}
    point |= {symbol(n): sympy.Rational(7, 5) for n in ("d1", "a2", "a3", "d6")}
    difference = (by_differentiation() - by_cross_products()).subs(point).evalf(20)
    assert max(abs(e) for e in difference) < 1e-18
