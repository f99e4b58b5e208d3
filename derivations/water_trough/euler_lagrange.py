"""SymPy's own Lagrange equations of the trough; the Lagrangian is typed in SymPy's symbols."""

from functools import cache

import mpmath
import sympy
from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

_DIGITS = 30


@cache
def equations():
    """Functions (acceleration of theta without friction, pressure at an acceleration) of a point.

    The second takes the acceleration as `alpha` in the point.
    """
    names = (
        "M l lam I_zz A_1 A_2 w x_1 y_1 x_2 y_2 h_10 h_20 a_t L_t m_t S_t_xi S_t_eta I_t Gamma_t "
        "rho g"
    )
    p = dict(zip(names.split(), sympy.symbols(names), strict=True))
    theta, s = dynamicsymbols("theta s")
    method = LagrangesMethod(_lagrangian(p, theta, s), [theta, s])
    of_theta, of_s = method.form_lagranges_equations()
    t = dynamicsymbols._t
    state = sympy.symbols("alpha q_dot omega q theta s")
    order = (theta.diff(t, 2), s.diff(t, 2), theta.diff(t), s.diff(t), theta, s)
    plain = [e.subs(list(zip(order, state, strict=True))) for e in (of_theta, of_s)]
    alpha = state[0]
    free = -plain[0].subs(alpha, 0) / plain[0].diff(alpha)
    taken = [*p, *map(str, state)]
    symbols = [*p.values(), *state]
    functions = [sympy.lambdify(symbols, e, modules="mpmath") for e in (free, plain[1])]
    return [_at_digits(function, taken) for function in functions]


def _at_digits(function, names):
    def value(row):
        with mpmath.workdps(_DIGITS):
            return float(function(*(mpmath.mpf(row.get(name, 0.0)) for name in names)))

    return value


def _lagrangian(p, theta, s):
    """T - V: a plate of water in either container, integrated over its height."""
    t = dynamicsymbols._t
    omega, q = theta.diff(t), s.diff(t)
    h_1, h_2 = p["h_10"] + s / p["A_1"], p["h_20"] - s / p["A_2"]
    z = sympy.Symbol("z")
    columns = ((p["A_1"], p["x_1"], p["y_1"], h_1), (p["A_2"], p["x_2"], p["y_2"], h_2))
    xi = p["M"] * p["l"] * sympy.cos(p["lam"]) + p["S_t_xi"]
    eta = p["M"] * p["l"] * sympy.sin(p["lam"]) + p["S_t_eta"]
    inertia = p["I_zz"] + p["I_t"]
    for area, x, y, h in columns:
        line = p["rho"] * area
        xi += line * h * x
        eta += line * sympy.integrate(y + z, (z, 0, h))
        inertia += line * sympy.integrate(x**2 + (y + z) ** 2 + p["w"] ** 2 / 12, (z, 0, h))
    arm = p["x_1"] * h_1 - p["x_2"] * h_2 + p["Gamma_t"]
    flow = p["rho"] * (h_1 / p["A_1"] + h_2 / p["A_2"] + p["L_t"] / p["a_t"])
    kinetic = inertia * omega**2 / 2 + p["rho"] * arm * q * omega + flow * q**2 / 2
    return kinetic - p["g"] * (xi * sympy.sin(theta) + eta * sympy.cos(theta))
