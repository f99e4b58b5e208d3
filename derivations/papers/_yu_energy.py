"""Yu, Wu and Zhang: power of the drives, (34) to (36), and what sections 4 and 5 say of it."""

from armillary import PI, absolute, at, number, substitute, total, vector, where

from ._yu_days import hours_up, on_equinox
from ._yu_dynamics import f_d, n_d
from ._yu_kinematics import a_dot, alpha_ddot, alpha_dot, beta_ddot, beta_dot, leg, p, q_dot, rr, w

F_q, P_q, F_leg = rr["F_q"], rr["P_q"], rr.quantity("F_leg")
K_M, R_w, lead = (rr.quantity(name) for name in ("K_M", "R_w", "lead"))

p.equation(
    "34",
    words="mechanical power of the drives",
    claims=P_q,
    printed={
        "v_i is the rate of the length": vector(*(F_q[k] * at(q_dot, leg, k) for k in range(3))),
        "v_i is the velocity of P_i, F_i along the leg": vector(
            *((F_q[k] * at(w, leg, k)).dot(at(a_dot, leg, k)) for k in range(3))
        ),
    },
)
T = rr["torque"]
p.equation("35", words="heat of motor i", claims=rr["P_copper"], printed=(T / K_M) ** 2 * R_w)
p.equation(
    "36",
    words="moment of motor i",
    claims=T,
    printed=F_leg * lead / (2 * PI),
)

# ---- The forces on the equinox: Fig. 6 ----

AT_REST = {rate: number(0) for rate in (alpha_dot, beta_dot, alpha_ddot, beta_ddot)}
CALM = {load: vector(0, 0, 0) for load in (f_d, n_d)}


def held(value, time=hours_up):
    """A value of the mechanism that holds its platform against the sun, in no wind."""
    return on_equinox(substitute(value, {**AT_REST, **CALM}), time)


def largest(forces):
    """The largest magnitude of some forces."""
    found = absolute(forces[0])
    for force in forces[1:]:
        found = where(found < absolute(force), absolute(force), found)
    return found


def squares(forces):
    """The sum of the squares of some forces."""
    return sum((force * force for force in forces[1:]), start=forces[0] * forces[0])


OF_THREE = [
    p.define(
        f"F_{k + 1}",
        F_q[k],
        because="The paper names the drives by number.",
        meaning=f"force of drive {k + 1}",
        latex=f"F_{k + 1}",
    )
    for k in range(3)
]
OF_TWO = list(rr["F_2"].rows[0])


def on_day(name, value, meaning, latex, time=hours_up):
    """A named value of the mechanism that holds its platform on the equinox."""
    return p.define(
        name, held(value, time), because="With Table 1, at rest and in no wind.",
        meaning=f"{meaning} on the equinox", latex=latex,
    )  # fmt: skip


for key, name, forces, which in (
    ("80 N", "F_largest", OF_THREE, "three"),
    ("80 N with two", "F_2_largest", OF_TWO, "two"),
):
    p.extremes(
        key,
        "the largest forces of both mechanisms come to 80 N",
        on_day(
            name, largest(forces), f"largest force of {which} drives",
            rf"\max_i |{'F_i' if which == 'three' else 'F_{2,i}'}|",
        ),
        None,
        80,
        to="0.5",  # to the nearest newton
        words=f"the largest force of {which} drives on the equinox, in N,",
    )  # fmt: skip
p.between(
    "36 N",
    "[without the third leg] a non-redundant mechanism of two freedoms and two drives [...] the "
    "mean forces of its two legs are 36 N",
    on_day("det_day", rr["det_2"], "determinant of the two-leg Jacobian", r"\det J_2"),
    0,
    None,
    words="the determinant of the two-leg Jacobian on the equinox, on both sides of 0 where a "
    "force has no bound, and no mean,",
)
SAMPLES = 60
sample = p.index("sample", SAMPLES, letter="k")
moment = p.constant(
    "h_sample",
    tuple(str(6 + 12 * (2 * k + 1) / (2 * SAMPLES)) for k in range(SAMPLES)),
    "sundial time in hours, every twelve minutes of the equinox",
    per=sample,
)
for key, part, stated in (("30 N", 0, 30), ("11 N", 2, 11)):
    force = on_day(
        f"F_sample_{part + 1}", OF_THREE[part], f"force of drive {part + 1} at time k",
        f"F_{part + 1}", moment,
    )  # fmt: skip
    p.extremes(
        key,
        "the mean forces of the three legs of the redundant mechanism are 30, 30 and 11 N",
        total(absolute(force), over=sample) / SAMPLES,
        None,
        stated,
        to="0.5",  # to the nearest newton
        words=f"the mean force of leg {part + 1} on the equinox, in N,",
    )

# ---- Heat and energy: Figs. 7 to 9 ----
# Heat goes with the sum of the squared forces, whatever the motors are.

heat_3, heat_2, dawn_3, dawn_2 = (
    on_day(f"{name}_{count}", squares(forces), f"sum of the squared forces of {which} drives{when}",
           latex, time)
    for name, when, time in (("heat", "", hours_up), ("dawn", " at sunrise", number(6)))
    for count, which, forces, latex in (
        (3, "three", OF_THREE, r"\textstyle\sum F_i^2"),
        (2, "two", OF_TWO, r"\textstyle\sum F_{2,i}^2"),
    )
)  # fmt: skip
near_noon = absolute(hours_up - 12) < 1
p.between(
    "4.5 W",
    "both reach their largest heat of 4.5 W in the early morning and in the evening",
    heat_3 / dawn_3,
    0,
    1,
    words="the heat of three drives on the equinox, by that at sunrise,",
)
p.between(
    "4.5 W of both",
    "both reach their largest heat of 4.5 W in the early morning and in the evening",
    dawn_2 / dawn_3,
    number("4.45") / number("4.55"),
    number("4.55") / number("4.45"),
    words="the heat of two drives at sunrise, by that of three,",
)
p.between(
    "1.4 W",
    "around noon the heat of the redundant mechanism is less than 1.4 W",
    heat_3 / dawn_3,
    0,
    number("1.4") / number("4.45"),
    words="the heat of three drives within an hour of noon on the equinox, by that at sunrise,",
    given=near_noon,
)
p.between(
    "3.8 W",
    "[around noon] that of the non-redundant mechanism comes to 3.8 W",
    heat_2 / dawn_2,
    0,
    number("3.85") / number("4.45"),
    words="the heat of two drives within an hour of noon on the equinox, by that at sunrise,",
    given=near_noon,
)
p.unchecked(
    "mechanical power",
    "the mean mechanical power of the redundant mechanism is higher, as its third leg adds to "
    "kinetic and potential energy",
    "Which mean is meant is not said. The equinox ends with the legs as long as they were at its "
    "start, so that the mechanical work of the day is 0 with three legs and with two. The study of "
    "rr_3ups looks at the parts of either sign.",
)
p.unchecked(
    "62.1 kJ",
    "the energy of the day: 62.1 kJ with three legs, 79.8 kJ with two",
    "It stands on K_M, R and d of (35) and (36), which are not given, and on the mass centre of "
    "the platform, which is not given either. The study of rr_3ups says what they would have to "
    "be.",
)
