"""Mass matrix, bias, and what the platform does under given forces."""

from armillary import (
    Matrix,
    number,
    partial,
    reciprocal_or_zero,
    substitute,
    total,
    where,
)
from armillary.derivation.units import KILOGRAM, METRE, NEWTON_METRE

from .dynamics import tau_alpha, tau_beta
from .energy import F_leg
from .legs import J_alpha, J_beta
from .symbols import alpha_ddot, beta_ddot, d, least_inertia, leg, mass_tolerance

_HELD = {alpha_ddot: number(0), beta_ddot: number(0)}


def entry(of, by, letters, latex):
    """An entry of the mass matrix."""
    return d.define(
        f"M_{letters}",
        partial(of, by),
        because="The generalised force is linear in the accelerations; these are its slopes.",
        meaning=f"entry of the mass matrix: {of.name[4:]} per unit of {by.name}",
        latex=f"M_{{{latex}}}",
    )


M_aa = entry(tau_alpha, alpha_ddot, "aa", r"\alpha\alpha")
M_ab = entry(tau_alpha, beta_ddot, "ab", r"\alpha\beta")
M_bb = entry(tau_beta, beta_ddot, "bb", r"\beta\beta")
d.identity("kinetic energy does not tell the two apart", M_ab, partial(tau_beta, alpha_ddot))
mass_matrix = d.define(
    "mass_matrix",
    Matrix(((M_aa, M_ab), (M_ab, M_bb))),
    because="It is symmetric: kinetic energy is a quadratic form of the rates.",
    meaning="mass matrix of alpha and beta, legs included",
    unit=KILOGRAM * METRE**2,
    latex="H",
)


def held(of, letter):
    """The generalised force at no acceleration."""
    return d.define(
        f"bias_{letter}",
        substitute(of, _HELD),
        because="What is asked for when nothing accelerates.",
        meaning=f"generalised force of {letter} at no acceleration: weight, disturbance and "
        "centrifugal terms",
        latex=rf"\tau_{{0\{letter}}}",
    )


bias_alpha, bias_beta = held(tau_alpha, "alpha"), held(tau_beta, "beta")
bias = d.define(
    "bias",
    Matrix(((bias_alpha, bias_beta),)),
    because="The platform has two freedoms: a moment about each axis.",
    meaning="generalised force at no acceleration",
    unit=NEWTON_METRE,
    latex=r"\boldsymbol{\tau}_0",
)


def left_over(entries, of, letter):
    """What accelerates an angle."""
    return d.define(
        f"excess_{letter}",
        total(entries * F_leg, over=leg) - of,
        because="What the drives give beyond that accelerates.",
        meaning=f"generalised force that accelerates {letter}",
        latex=rf"\Delta\tau_\{letter}",
    )


excess_alpha = left_over(J_alpha, bias_alpha, "alpha")
excess_beta = left_over(J_beta, bias_beta, "beta")
no_inertia = d.define(
    "no_inertia",
    ~(M_aa > least_inertia),
    because="An angle that nothing weighs takes any acceleration.",
    meaning="whether the turn about the vertical moves no mass",
)
carried = d.define(
    "carried",
    M_ab * reciprocal_or_zero(M_aa, no_inertia),
    because="The row of alpha, times this, leaves beta alone in the row of beta: products of two "
    "entries, which single precision may not hold, are not asked for.",
    meaning="acceleration of alpha that goes with one of beta, with its sign turned",
    latex=r"H_{\alpha\beta}/H_{\alpha\alpha}",
)
M_left = d.define(
    "M_left",
    M_bb - carried * M_ab,
    because="Subtract the row of alpha, times the factor before: what is left weighs beta with "
    "alpha free.",
    meaning="inertia of beta with alpha free",
    latex=r"H_{\beta\beta}'",
)
massless = d.define(
    "massless",
    ~(~no_inertia & (M_left > least_inertia) & (M_left > mass_tolerance * M_bb)),
    because="The same of beta; and of both together, where the two rows are hardly two.",
    meaning="whether some motion of the two angles moves no mass",
)
beta_found = d.define(
    "beta_ddot_found",
    (excess_beta - carried * excess_alpha) * reciprocal_or_zero(M_left, massless),
    because="With alpha eliminated the row of beta is one equation for one acceleration.",
    meaning="acceleration of beta under the forces given",
    latex=r"\ddot{\beta}",
)
alpha_found = d.define(
    "alpha_ddot_found",
    where(massless, 0, (excess_alpha - M_ab * beta_found) * reciprocal_or_zero(M_aa, no_inertia)),
    because="The row of alpha, with beta's acceleration put in, is one equation for alpha's.",
    meaning="acceleration of alpha under the forces given",
    latex=r"\ddot{\alpha}",
)
