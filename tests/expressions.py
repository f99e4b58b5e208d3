"""Random expressions for property tests, regular everywhere: nothing divides by zero."""

from hypothesis import strategies as st

from armillary import Derivation, absolute, atan2, cos, sin, sqrt, unit, vector, where
from armillary.algebra.rotation import elementary, rotate

record = d = Derivation("random", title="Random expressions")
x = d.angle("x", "first input")
y = d.angle("y", "second input")
c = d.vector("c", "a vector input")
x_dot, y_dot, c_dot = x.rate(), y.rate(), c.rate()
INPUTS = [x, y, c, x_dot, y_dot, c_dot]


def _safe(e):
    return 2 + cos(e)


def _binary(inner):
    pairs = st.tuples(inner, inner)
    return st.one_of(
        pairs.map(lambda p: p[0] + p[1]),
        pairs.map(lambda p: p[0] - p[1]),
        pairs.map(lambda p: p[0] * p[1]),
        pairs.map(lambda p: p[0] / _safe(p[1])),
        pairs.map(lambda p: atan2(sin(p[0]), _safe(p[1]))),
        pairs.map(lambda p: where(p[0] < p[1], sin(p[0]), cos(p[1]))),
    )


def _unary(inner):
    return st.one_of(
        inner.map(sin),
        inner.map(cos),
        inner.map(lambda e: -e),
        inner.map(lambda e: sqrt(2 + sin(e))),
        inner.map(lambda e: absolute(e)),
        st.tuples(st.integers(2, 9), inner).map(lambda p: cos(p[0] * p[1])),
        st.tuples(st.integers(2, 9), inner).map(lambda p: sin(p[0] * p[1])),
    )


LEAVES = st.one_of(
    st.sampled_from([x, y, c.x, c.z]), st.sampled_from([1, -2, "0.7"]).map(lambda k: x * 0 + k)
)
SCALARS = st.recursive(LEAVES, lambda inner: st.one_of(_binary(inner), _unary(inner)), max_leaves=8)


def _turned(pair):
    (axis, angle), inner = pair
    return rotate(elementary(axis, angle), inner)


def _vectors(inner):
    pairs = st.tuples(inner, inner)
    return st.one_of(
        pairs.map(lambda p: p[0] + p[1]),
        pairs.map(lambda p: p[0].cross(p[1])),
        inner.map(lambda v: -v),
        st.tuples(SCALARS, inner).map(lambda p: p[0] * p[1]),
        st.tuples(st.tuples(st.integers(0, 2), SCALARS), inner).map(_turned),
        # Never null: its z component is 3 at least.
        inner.map(lambda v: unit(vector(sin(v.x), cos(v.y), 4 + sin(v.z)))),
    )


VECTORS = st.recursive(
    st.one_of(st.just(c), st.tuples(SCALARS, LEAVES).map(lambda p: vector(p[0], 1, p[1]))),
    _vectors,
    max_leaves=4,
)
