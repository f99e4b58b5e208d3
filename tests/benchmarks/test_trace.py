"""A digest of a recipe tells its operations, not how they are written."""

from dataclasses import replace

from benchmarks.recipes import KERNELS
from benchmarks.trace import digest

K1 = KERNELS["K1"]


def marked(recipe):
    return digest(replace(K1, inputs=("a", "b"), recipes={"": recipe}), "")


def test_layout_does_not_count():
    def other(ops, v):
        first, second = v
        product = second * ops.sin(first)
        return [product, *ops.jacobian([product], [first])[0]]

    def one(ops, v):
        return [v[1] * ops.sin(v[0]), ops.jacobian([v[1] * ops.sin(v[0])], v)[0][0]]

    assert marked(one) == marked(other)


def test_every_operation_counts():
    recipes = (
        lambda ops, v: [v[0] + v[1]],
        lambda ops, v: [v[1] + v[0]],
        lambda ops, v: [v[0] - v[1]],
        lambda ops, v: [v[0] * v[1]],
        lambda ops, v: [v[0] / v[1]],
        lambda ops, v: [2 * v[0]],
        lambda ops, v: [v[0] * 2],
        lambda ops, v: [2 - v[0]],
        lambda ops, v: [2 / v[0]],
        lambda ops, v: [-v[0]],
        lambda ops, v: [ops.sin(v[0])],
        lambda ops, v: [ops.cos(v[0])],
        lambda ops, v: [ops.sqrt(v[0])],
        lambda ops, v: [ops.atan2(v[0], v[1])],
        lambda ops, v: ops.named([v[0]]),
        lambda ops, v: ops.jacobian([v[0]], [v[1]])[0],
        lambda ops, v: [v[0]],
        lambda ops, v: [v[0], v[1]],
    )
    assert len({marked(recipe) for recipe in recipes}) == len(recipes)


def test_inputs_count():
    assert digest(K1, "text-book") != digest(replace(K1, inputs=("x", *K1.inputs[1:])), "text-book")
