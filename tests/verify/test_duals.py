"""Dual numbers find every derivative of a system, and a wrong sign in any of them."""

import pytest

from armillary.verify import duals
from armillary.verify.measured import Skipped
from tests.verify.systems import TWO_AXES, record_and_programs, write

CHECKS = {
    ("velocity", "Omega_space by dual numbers of the pose"),
    ("velocity", "Omega_body by dual numbers of the pose"),
    ("velocity", "v_origin by dual numbers of the pose"),
    ("jacobian", "each column of J by dual numbers of the pose"),
    ("climb", "height_rate is the time derivative of height"),
}


def checked(root, text):
    record, programs = record_and_programs(write(root, two_axes=text), "two_axes")
    return list(duals.checks(record, programs))


def test_every_derivative_is_found_and_right(tmp_path):
    made = checked(tmp_path, TWO_AXES)
    assert {(m.kernel, m.name) for m in made} == CHECKS
    assert all(m.passed and m.points > 20 for m in made), made
    assert max(m.worst for m in made) < 1e-40


WRONG = {
    "Omega_space": ('w = d.define("Omega_space", chain', 'w = d.define("Omega_space", -chain'),
    "Omega_body": ("chain.body_angular_velocity", "chain.angular_velocity"),
    "v_origin": ('chain.velocity("tip")', 'chain.velocity("tip", vector(0, "1e-20", 0) * L)'),
    "J": ('chain.jacobian("tip", (a, b))', 'chain.jacobian("tip", (b, a))'),
    "height_rate": ("time_derivative(M.position.z)", "time_derivative(M.position.z) * 2"),
}


@pytest.mark.parametrize("name", WRONG)
def test_a_wrong_derivative_is_found(tmp_path, name):
    right, wrong = WRONG[name]
    assert right in TWO_AXES
    failed = [m for m in checked(tmp_path, TWO_AXES.replace(right, wrong)) if not m.passed]
    assert len(failed) == 1
    assert name in failed[0].name
    assert failed[0].at


def test_a_result_whose_name_tells_nothing_is_reported(tmp_path):
    text = TWO_AXES.replace('d.define("Omega_space"', 'd.define("Omega"')
    made = checked(tmp_path, text)
    (skipped,) = [m for m in made if isinstance(m, Skipped)]
    assert skipped.name == "Omega of velocity is not covered"
    assert "name it Omega_space" in skipped.why
    assert len(made) == len(CHECKS)


MOVED = f"""{TWO_AXES}
a_ddot, b_ddot = a_dot.rate("a_ddot", "rate of a_dot"), b_dot.rate("b_ddot", "rate of b_dot")
height_ddot = d.define("height_ddot", time_derivative(height_rate), because="differentiate")
d.kernel("speed", inputs=[a, b, a_dot, b_dot], outputs={{"height_dot": height_rate}})
d.kernel("lift", inputs=[a, b, a_dot, b_dot, a_ddot, b_ddot], outputs=[height_ddot])
"""


def test_an_acceleration_is_the_rate_of_a_rate(tmp_path):
    def accelerations(folder, text):
        claim = "height_ddot is the time derivative of height_dot"
        return [m for m in checked(folder, text) if m.name == claim]

    (right,) = accelerations(tmp_path / "right", MOVED)
    assert right.passed
    assert right.points > 20
    wrong = MOVED.replace("time_derivative(height_rate)", "time_derivative(height_rate) * 2")
    assert [m.passed for m in accelerations(tmp_path / "wrong", wrong)] == [False]


TURNS = '''"""Turns."""

from armillary import Chain, Derivation, X, Z

derivation = d = Derivation("turns", title="Turns")
a, b = d.angle("a", "first"), d.angle("b", "second")
chain = Chain("base").rotate(Z, a).rotate(X, b, frame="body")
R = chain.rotation("base", "body")
rates = [a.rate(), b.rate()]
d.kernel("matrix_zx", inputs=[a, b], outputs={"R": R})
d.kernel("velocity_zx", inputs=[a, b, *rates], outputs={"Omega": chain.angular_velocity("body")})
'''


def test_an_angular_velocity_belongs_to_the_matrix_of_its_name(tmp_path):
    (right,) = duals.checks(*record_and_programs(write(tmp_path / "right", turns=TURNS), "turns"))
    assert right.name == "Omega by dual numbers of the rotation"
    assert right.passed
    assert right.points > 20
    text = TURNS.replace("chain.angular_velocity", "chain.body_angular_velocity")
    (wrong,) = duals.checks(*record_and_programs(write(tmp_path / "wrong", turns=text), "turns"))
    assert not wrong.passed


ROOTS = '''"""Roots."""

from armillary import Derivation, sqrt, time_derivative

derivation = d = Derivation("roots", title="Roots")
a = d.angle("a", "an angle")
a_dot = a.rate()
size = d.define("size", sqrt(a * a), because="It has a corner at 0.", meaning="size")
size_rate = d.define(
    "size_rate", time_derivative(size), because="Nothing guards the corner.", meaning="rate"
)
d.kernel("plain", inputs=[a], outputs=[size])
d.kernel("moved", inputs=[a, a_dot], outputs=[size_rate])
'''


def test_a_point_without_a_value_is_left_to_the_comparison_of_targets(tmp_path):
    (right,) = duals.checks(*record_and_programs(write(tmp_path, roots=ROOTS), "roots"))
    assert right.passed
    assert right.points > 20


STAND = (
    TURNS.split("rates =")[0]
    + """
L = d.parameter.length("L", "height")
top = vector(L * sin(a), 0, L)
rates = [a.rate(), b.rate(), L.rate()]
d.kernel("head", inputs=[a, b], outputs={"R": R, "top": top})
d.kernel("head_rates", inputs=[a, b, *rates], outputs={
    "top_dot": time_derivative(top), "Omega": chain.angular_velocity("body")})
"""
)
STAND = STAND.replace("Derivation, X, Z", "Derivation, X, Z, sin, time_derivative, vector")


def test_a_parameter_may_move_too_and_rates_belong_to_the_kernel_of_their_name(tmp_path):
    made = list(duals.checks(*record_and_programs(write(tmp_path / "right", turns=STAND), "turns")))
    assert [m.name for m in made] == [
        "top_dot is the time derivative of top",
        "Omega by dual numbers of the rotation",
    ]
    assert all(m.passed and m.points > 20 for m in made)
    for right, wrong in (
        ("time_derivative(top)", "vector(L * cos(a) * rates[0], 0, rates[2])"),
        ("chain.angular_velocity", "chain.body_angular_velocity"),
    ):
        text = STAND.replace(right, wrong).replace("sin, time", "cos, sin, time")
        root = write(tmp_path / right[:5], turns=text)
        made = list(duals.checks(*record_and_programs(root, "turns")))
        assert sum(not m.passed for m in made) == 1
