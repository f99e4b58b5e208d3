"""Yu, Wu and Zhang: velocities and accelerations of the two links of a leg, (11) to (18)."""

from armillary import matrix, number, time_derivative

from ._yu_kinematics import (
    SPIN_FREE,
    J_omega,
    J_omega_columns,
    a_dot,
    alpha_ddot,
    b,
    beside,
    beta_ddot,
    omega,
    p,
    q,
    q_dot,
    rates,
    rr,
    times,
    w,
)

t, s = rr.quantity("t"), rr.quantity("s")
T_W, S_W, v_t, v_s, a_t, a_s = (rr[name] for name in ("T_W", "S_W", "v_t", "v_s", "a_t", "a_s"))
J_tv, J_sv, J = rr["J_tv"], rr["J_sv"], rr["J"]
omega_free = rr["omega_free_W"]
FROM_Q = "true of the vector from Q_i to it"

# ---- Positions and velocities ----

T_O, S_O = (
    p.define(
        f"{letter}_O",
        b + from_Q_i,
        because="The static frame has its origin at O, from which Q_i stands at b_i.",
        meaning=f"centre of mass {letter}_i in the static frame",
        latex=rf"\mathbf{{{letter}}}_O",
    )
    for letter, from_Q_i in (("T", T_W), ("S", S_W))
)

p.equation(
    "11",
    words="from Q_i to the first link's centre of mass",
    claims=T_W,
    printed=t * w,
)
p.equation(
    "11 in words",
    words="the first link's centre of mass in the static frame",
    quote="the centre of mass T_i of the first link can be written in the static frame as",
    claims=T_O,
    printed=t * w,
    meant={FROM_Q: {T_O: T_W}},
)
p.equation(
    "12",
    words="velocity of the first link's centre of mass",
    claims=v_t,
    printed=t * w.cross(omega),
)
p.equation(
    "12'",
    words="Jacobian of the first link's centre of mass",
    claims=J_tv,
    printed=beside([t * w.cross(column) for column in J_omega_columns]),
)
p.equation(
    "13",
    words="from Q_i to the second link's centre of mass",
    claims=S_W,
    printed=(q - s) * w,
)
p.equation(
    "13 in words",
    words="the second link's centre of mass in the static frame",
    quote="the centre of mass S_i of the second link can be written in the static frame as",
    claims=S_O,
    printed=(q - s) * w,
    meant={FROM_Q: {S_O: S_W}},
)
p.equation(
    "14",
    words="velocity of the second link's centre of mass",
    claims=v_s,
    printed=q_dot * w + (q - s) * w.cross(omega),
)
q_S = p.define(
    "q_S",
    q - s,
    because="The second link ends at P_i, and its centre of mass is s_i before that.",
    meaning="distance from Q_i to the second link's centre of mass",
    latex="q_S",
)
p.equation(
    "14'",
    words="Jacobian of the second link's centre of mass",
    claims=J_sv,
    printed=beside(
        [
            entry * w + q_S * w.cross(column)
            for entry, column in zip(J.rows[0], J_omega_columns, strict=True)
        ]
    ),
)
p.equation(
    "15",
    words="velocity of P_i beside that of S_i, as the second link turns with the leg",
    claims=a_dot - v_s,
    printed=omega.cross(s * w),
)


# ---- The six components, and accelerations ----


def stacked(linear, angular):
    """Two vectors, one below the other."""
    return matrix(*([linear[k]] for k in range(3)), *([angular[k]] for k in range(3)))


def products(letter, jacobian, symbol):
    """A Jacobian times the derivatives of the rates, and its own rate times the rates."""
    rate = matrix(*([time_derivative(entry) for entry in row] for row in jacobian.rows))
    made = (
        (
            "Jacc",
            times(jacobian, alpha_ddot, beta_ddot),
            rf"({symbol}\ddot{{X}})",
            f"J_{letter} times the derivatives of the rates",
        ),
        (
            "Jdot",
            rates(rate),
            rf"(\dot{{J}}{symbol[1:]}\dot{{X}})",
            f"rate of J_{letter} times the rates",
        ),
    )
    return tuple(
        p.define(
            f"{name}_{letter}",
            value,
            because="(17) and (18) print it as one of two terms of an acceleration.",
            meaning=meaning,
            latex=latex,
        )
        for name, value, latex, meaning in made
    )


p.between(
    "12 and 16",
    "v_ti = t_i w_i x omega_i = J_ti X_dot",
    number(len(J_tv.rows) + len(J_omega.rows)),
    3,
    3,
    words="the number of rows of J_ti by (16)",
)
acc_t, drift_t = products("t", J_tv, "J_t")
acc_s, drift_s = products("s", J_sv, "J_s")
acc_omega, drift_omega = products("omega", J_omega, r"J_\omega")
p.equation(
    "16",
    words="velocity and angular velocity of the first link, J_tiv and J_omega_i as derived",
    claims=stacked(v_t, omega),
    printed=stacked(rates(J_tv), rates(J_omega)),
    meant={SPIN_FREE: {omega: omega_free}},
)
p.equation(
    "17",
    words="acceleration of the first link's centre of mass: the upper half",
    claims=a_t,
    printed=acc_t + drift_s,
)
turning = {SPIN_FREE: {rr["omega_dot_W"]: rr["omega_free_dot_W"]}}
p.equation(
    "17'",
    words="angular acceleration of the first link: the lower half",
    claims=rr["omega_dot_W"],
    printed=acc_omega + drift_omega,
    meant=turning,
)
p.equation(
    "18",
    words="velocity and angular velocity of the second link, J_siv and J_omega_i as derived",
    claims=stacked(v_s, omega),
    printed=stacked(rates(J_sv), rates(J_omega)),
    meant={SPIN_FREE: {omega: omega_free}},
)
p.equation(
    "18'",
    words="acceleration of the second link's centre of mass: the upper half",
    claims=a_s,
    printed=acc_s + drift_s,
)
p.equation(
    "18''",
    words="angular acceleration of the second link: the lower half",
    claims=rr["omega_dot_W"],
    printed=acc_omega + drift_omega,
    meant=turning,
)
