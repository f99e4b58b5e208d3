"""Lengths to angles: a search with a fixed number of steps, where three lengths tell two angles."""

from armillary import (
    PI,
    Matrix,
    Status,
    absolute,
    at,
    near,
    solve,
    sqrt,
    substitute,
    total,
    vector,
    where,
    wrap,
)
from armillary.derivation.units import RADIAN

from .forces import scale
from .legs import UP, E, a_m, b, g_alpha, g_beta, q
from .symbols import alpha, beta, d, h_0, hold_tolerance, leg, leg_tolerance, r

STEPS = 8

# ---- what is given, and what is looked for ----

way = d.index("way", 2, letter="j")
q_given = d.length(
    "q",
    "length of leg i",
    limits=(0.0, 1e3),
    range=(0.2, 1.5),
    per=leg,
    latex=r"\bar{q}",
)
guess = d.scalar(
    "guess",
    "start of the search, alpha and then beta,",
    unit=RADIAN,
    range=(-1.5, 1.5),
    per=way,
    latex=r"\chi",
)
step_tolerance = d.constant(
    "step_tolerance",
    "1e-4",
    "angle that a step after the last may still go",
    unit=RADIAN,
    latex=r"\tau_k",
)
alpha_k = d.unknown("alpha_k", "turn, while it is looked for", unit=RADIAN, latex=r"\alpha_k")
beta_k = d.unknown("beta_k", "tilt, while it is looked for", unit=RADIAN, latex=r"\beta_k")

# ---- the search ----

apart = d.define(
    "apart",
    (b - h_0 * UP).dot(b - h_0 * UP) + a_m.dot(a_m),
    because="A turn keeps the length of both arms, so that this part of the squared length stands "
    "still.",
    meaning="sum of the squared distances of both joints of leg i from o",
    latex="c_0",
)
closure = d.define(
    "closure",
    E + (apart - q_given * q_given) / 2,
    because="Half the square of a length is smooth everywhere, and the search needs no root.",
    meaning="half the square of length i at some angles, less half that of the length given",
    latex=r"\Delta",
)
_whole = (-2 * PI, 2 * PI)
found = solve(
    substitute(closure, {alpha: alpha_k, beta: beta_k}),
    {alpha_k: wrap(at(guess, way, 0)), beta_k: wrap(at(guess, way, 1))},
    steps=STEPS,
    name="newton",
    over=leg,
    within={alpha_k: _whole, beta_k: _whole},
)
alpha_f = d.define(
    "alpha_f",
    wrap(found[0]),
    because="Three equations for two angles: a step solves them as well as can be, in the sum of "
    "squares, after they have been made linear.",
    meaning="turn of the platform at which the search ends",
    latex=r"\alpha^{+}",
)
beta_f = d.define(
    "beta_f",
    wrap(found[1]),
    because="The second unknown of the same step.",
    meaning="tilt of the platform at which the search ends",
    latex=r"\beta^{+}",
)

# ---- whether it has ended ----


def of_legs(entry, name, meaning, latex):
    """A value of each leg where the search ends, as a vector over the legs."""
    entry = substitute(entry, {alpha: alpha_f, beta: beta_f})
    return d.define(
        name,
        vector(*(at(entry, leg, k) for k in range(leg.size))),
        because="The step takes sums over the legs, which are products of vectors with a component "
        "a leg.",
        meaning=f"{meaning} where the search ends, a component a leg",
        latex=latex,
    )


column_a = of_legs(g_alpha, "column_a", "g_alpha", r"\mathbf{k}^{+}")
column_b = of_legs(g_beta, "column_b", "g_beta", r"\mathbf{m}^{+}")
rest = of_legs(closure, "rest", "what is left of the closure", r"\boldsymbol{\Delta}^{+}")
reach = of_legs(r * q, "reach", "r q, which no slope exceeds,", r"\mathbf{s}^{+}")
normal = d.define(
    "normal",
    column_a.cross(column_b),
    because="Square to both columns; its square is the determinant of the normal equations.",
    meaning="normal of the columns of slopes",
    latex=r"\mathbf{n}^{+}",
)
area = d.define(
    "area",
    normal.dot(normal),
    because="The determinant of the normal equations is the squared area that the columns span.",
    meaning="determinant of the normal equations",
    latex=r"\det N",
)
blind = d.define(
    "blind",
    ~((area > (hold_tolerance * reach.dot(reach)) ** 2) & (scale > leg_tolerance**2)),
    because="Where the columns are parallel, some motion changes no length; where all spherical "
    "joints are at o, every motion.",
    meaning="whether the lengths do not tell the attitude",
)


def stands(across):
    """Whether one more step would move an angle by less than the tolerance."""
    return absolute(across.dot(rest)) < step_tolerance * area


lost = d.define(
    "lost",
    ~blind & ~(stands(column_b.cross(normal)) & stands(normal.cross(column_a))),
    because="Each column has a partner square to the other one, which tells its part of a step. A "
    "search that converges is at rounding errors by then; lengths that do not fit slow it down.",
    meaning="whether the search has not ended",
)

# ---- what is given back ----


def told(end, start, name, what, latex):
    """An angle that was found, or guessed where lengths do not tell it."""
    return d.define(
        name,
        where(blind, wrap(start), end),
        because="Where lengths do not tell the attitude, the guess stands.",
        meaning=f"{what} of the platform at the lengths given",
        latex=latex,
    )


alpha_q = told(alpha_f, at(guess, way, 0), "alpha_q", "turn", r"\alpha^{\ast}")
beta_q = told(beta_f, at(guess, way, 1), "beta_q", "tilt", r"\beta^{\ast}")
misfit = d.define(
    "misfit",
    substitute(q, {alpha: alpha_q, beta: beta_q}) - q_given,
    because="Two angles cannot serve three lengths that do not fit together.",
    meaning="by how much leg i is too long at these angles",
    latex=r"\epsilon",
)
residual = d.define(
    "residual",
    sqrt(total(misfit * misfit, over=leg)),
    because="One number tells a machine whose sensors disagree; it is 0 where the lengths fit.",
    meaning="what is left: root of the sum of the squared errors of the lengths",
    latex=r"\epsilon_\Sigma",
)
d.kernel(
    "forward",
    inputs=[q_given, guess],
    outputs={"alpha": alpha_q, "beta": beta_q, "residual": residual},
    cases=[
        (
            Status.SINGULAR,
            blind,
            "some motion changes no length: the guess is given back",
        ),
        (Status.NOT_CONVERGED, lost, "one more step would move an angle by more than 1e-4 rad"),
    ],
    drawn={q_given: q, guess: near(Matrix(((alpha, beta),)), by=0.05)},
    summary="Angles of the platform at three lengths, by eight steps of Gauss and Newton's method "
    "from a guess: those whose squared lengths are the least off, in the sum of squares. The "
    "residual is 0 if the lengths fit together; if not, they contradict each other, or the search "
    "has ended at another minimum. Near singular attitudes two attitudes may fit.",
)
