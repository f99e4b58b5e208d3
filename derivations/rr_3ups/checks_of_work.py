"""The generalised force once more: what each body asks for by itself, along each angle.

A leg is a chain of two turns, and its motion is differentiated, not derived: no formula for a
spin, for the acceleration of a centre or for an arm is shared with the dynamics.
"""

from dataclasses import replace

import numpy as np

from armillary import (
    Body,
    Chain,
    Matrix,
    Twist,
    Wrench,
    X,
    Y,
    Z,
    at,
    atan2,
    elementary,
    hypot,
    partial,
    time_derivative,
    total,
    vector,
    virtual_work,
)
from armillary.derivation.statements import Output
from armillary.program.arithmetic import Reals
from armillary.program.lower import Strategy, lower
from armillary.verify.exact import run
from armillary.verify.measured import compare
from armillary.verify.points import rows_of

from .derivation import derivation
from .legs import UP, b, l_W
from .samples import call, fast
from .symbols import (
    I_m,
    I_s,
    I_t,
    alpha,
    alpha_dot,
    beta,
    beta_dot,
    f_d,
    g,
    leg,
    m_m,
    m_s,
    m_t,
    n_d,
    r_sc,
    s,
    t,
    zeta,
)

RATES = (alpha_dot, beta_dot)
NULL = vector(0, 0, 0)
DIGITS = "Body.demand and virtual_work, 50 digits"


def forces_by_virtual_work(kernels):
    """The generalised force of three legs and of two, from what every body asks for."""
    points = fast(24)
    legs, body = _works(_links()), _works(_platform())
    for kernel, together in (
        ("generalized_force", lambda work: total(work, over=leg)),
        ("generalized_force_two_legs", lambda work: at(work, leg, 0) + at(work, leg, 1)),
    ):
        tau = Matrix((tuple(together(a) + b for a, b in zip(legs, body, strict=True)),))
        yield compare(
            "tau is the virtual work of each body by itself", DIGITS,
            call(getattr(kernels, kernel), points).tau, _values(kernel, tau, points), 1e-12, points,
            kernel,
        )  # fmt: skip


def _works(demands):
    """What wrenches do per unit of each rate; each comes with its motion at all rates."""
    return [
        virtual_work(
            [
                (asked, Twist(partial(motion.angular, rate), partial(motion.linear, rate)))
                for asked, motion in demands
            ]
        )
        for rate in RATES
    ]


def _links():
    """Both links of leg i: what moves each about its centre of mass, and its motion; leg axes."""
    seen = elementary(Y, -zeta) @ l_W
    chain = (
        Chain("joint")
        .rotate(Y, zeta)
        .rotate(Z, atan2(-seen.x, seen.y))
        .rotate(X, atan2(seen.z, hypot(seen.x, seen.y)), frame="leg")
    )
    to_leg, spin = chain.rotation("leg", "joint"), chain.body_angular_velocity("leg")

    def link(body, centre):
        velocity = time_derivative(centre)
        upwards = time_derivative(velocity) + g * UP  # what carries weight accelerates so
        asked = body.demand(to_leg @ upwards, spin, time_derivative(spin))
        return asked, Twist(spin, to_leg @ velocity)

    direction = l_W / l_W.norm()
    return [
        link(Body(m_t, I_t), b + t * direction),
        link(Body(m_s, I_s), b + l_W - s * direction),
    ]


def _platform():
    """The platform, its weight and the disturbance about o, which stands still; its own axes."""
    chain = Chain("o").rotate(Z, alpha).rotate(X, beta, frame="platform")
    turned, spin = chain.rotation("platform", "o"), chain.body_angular_velocity("platform")
    wrenches = (
        Body(m_m, I_m).demand(NULL, spin, time_derivative(spin)),
        Wrench(r_sc.cross(turned @ (m_m * g * UP)), NULL),
        Wrench(turned @ -n_d, turned @ -f_d),
    )
    return [(wrench, Twist(spin, NULL)) for wrench in wrenches]


def _values(kernel, value, points):
    """A value at points, by the program of a kernel whose inputs it takes: (n, 2)."""
    stated = derivation.kernels[kernel]
    (output,) = stated.outputs
    stated = replace(stated, outputs=(Output(output.name, value, None, output.unit),), cases=())
    program, reals = lower(stated, Strategy()), Reals()
    names = [q.name for q in (*stated.inputs, *stated.parameters)]
    found = [
        run(program, {name: row[name] for name in names}, reals).results[output.name]
        for row in rows_of(points)
    ]
    return np.array(found, dtype=float)
