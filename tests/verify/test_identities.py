"""Proofs that can fail, and say so."""

import pytest

from armillary import Chain, Derivation, X, Z, atan2, cos, elementary, sin, sqrt, vector
from armillary.derivation.errors import Source
from armillary.derivation.statements import Identity
from armillary.program.compile import compile_kernel
from armillary.program.program import Op
from armillary.program.rewrite import Rewriter
from armillary.verify.identities import (
    NotComparableError,
    prove,
    text_book_expression,
    text_book_rotation,
)  # fmt: skip


@pytest.fixture
def d():
    return Derivation("identities", title="Identities")


def claimed(d, left, right):
    d.identity("claimed", left, right)
    return prove(d.identities[-1])


def test_a_true_identity_is_proved_for_all_values(d):
    t = d.angle("t", "angle")
    made = claimed(d, sin(2 * t) + 0, 2 * sin(t) * cos(t))
    assert made.passed
    assert (made.engine, made.why) == ("SymPy", "proved for all values")


def test_a_false_identity_fails_with_its_residual(d):
    t = d.angle("t", "angle")
    made = claimed(d, sin(2 * t), 2 * sin(t))
    assert not made.passed
    assert made.worst > 0.1
    assert "residual: " in made.why
    assert "t" in made.at


def test_a_sign_in_one_entry_of_a_vector_is_found(d):
    t = d.angle("t", "angle")
    assert not claimed(d, vector(sin(t), cos(t), 1), vector(sin(t), -cos(t), 1)).passed


def test_a_constant_counts_with_its_value(d):
    t = d.angle("t", "angle")
    k = d.constant("k", "0.5", "one half")
    assert claimed(d, k * t, t / 2).passed
    assert not claimed(d, k * t, t / 3).passed


def test_what_sympy_cannot_reduce_is_not_called_proved(d):
    t = d.angle("t", "angle", range=(0.1, 1.0))
    made = claimed(d, atan2(sin(t), cos(t)), t)
    assert made.passed
    assert made.engine == "50 digits"
    assert "not proved for all values" in made.why


def test_roots_do_not_stop_the_proof(d):
    t = d.angle("t", "angle")
    made = claimed(d, sqrt(1 + sin(t) * sin(t)) - sqrt(2 - cos(t) * cos(t)), 0 * t)
    assert made.passed


def test_shapes_must_agree(d):
    t = d.angle("t", "angle")
    # The record refuses it when it is stated; the proof must not compare it either.
    with pytest.raises(NotComparableError, match="shape"):
        prove(Identity("claimed", vector(t, t, t), t, Source("x", 1)))


def test_every_rotation_is_orthonormal(d):
    t, L = d.angle("t", "angle"), d.length("L", "arm")
    chain = Chain("g").rotate(Z, -t).rotate(X, 2 * t, frame="f").translate(Z, L, frame="tip")
    d.define("M", chain.pose("g", "tip"), because="compose")
    d.define("R", chain.rotation("g", "f"), because="compose")
    d.define("s", sin(t), because="a scalar has no rotation")
    made = {name: text_book_rotation(definition) for name, definition in d.definitions.items()}
    assert made["s"] is None
    assert made["M"] is not None
    assert made["R"] is not None
    assert made["M"].engine == made["R"].engine == "SymPy"
    assert made["M"].passed


def test_a_rotation_by_an_angle_that_is_no_number(d):
    """The root of a negative number: its matrix is orthonormal, and not real."""
    t, u = d.angle("t", "angle"), d.scalar("u", "a number", range=(2.0, 3.0))
    d.define("R", elementary(Z, sqrt(u - 1)) @ elementary(X, t), because="compose")
    d.define("S", elementary(Z, sqrt(1 - u)) @ elementary(X, t), because="compose")
    right, wrong = (text_book_rotation(definition) for definition in d.definitions.values())
    assert (right.passed, right.engine) == (True, "SymPy")
    assert not wrong.passed
    assert "no real rotation" in wrong.why


class Wrong(Rewriter):
    """Takes a cosine for a sine."""

    def rewrite(self, number):
        i = self.program.instructions[number]
        if i.op is Op.SIN:
            return self.builder.cos(self.new[i.args[0]])
        return super().rewrite(number)


def test_the_program_is_held_to_the_text_book(d):
    t, u = d.angle("t", "angle"), d.vector("u", "a vector")
    chain = Chain("g").rotate(Z, -t).rotate(X, 2 * t, frame="f")
    d.kernel("k", inputs=[t, u], outputs={"r": chain.rotation("g", "f") @ u, "s": u.x * t})
    program = compile_kernel(d.kernels["k"]).program
    right = list(text_book_expression(d.kernels["k"], program))
    assert [m.passed for m in right] == [True, True]
    wrong = list(text_book_expression(d.kernels["k"], Wrong(program).run()))
    assert [m.passed for m in wrong] == [False, True]
