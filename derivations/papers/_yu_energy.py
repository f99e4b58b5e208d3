"""Yu, Wu and Zhang: power of the drives, (34) to (36), and what sections 4 and 5 say of it."""

from armillary import PI, absolute, at, number, sqrt, substitute, total, vector, where

from ._yu_days import hours_up, on_equinox
from ._yu_dynamics import f_d, n_d
from ._yu_kinematics import (
    J,
    a_dot,
    alpha_ddot,
    alpha_dot,
    beta_ddot,
    beta_dot,
    leg,
    p,
    q_dot,
    rr,
    w,
)
from ._yu_table import y_c, z_c

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
        name, held(value, time),
        because="The sun is so slow that the mechanism as good as stands; no wind is mentioned.",
        meaning=f"{meaning} on the equinox", latex=latex,
    )  # fmt: skip


SEE = "The study on the page of the tracker says what it could be, and how firmly."
UNPRINTED = {"on": {y_c: 0, z_c: 0}, "words": "the mass centre at o", "see": SEE}
AT_O = {y_c: number(0), z_c: number(0)}
BOTH_80 = "the largest forces of both mechanisms come to 80 N"
PEAK = {
    "the largest force of three drives on the equinox": (
        on_day("F_largest", largest(OF_THREE), "largest force of three drives", r"\max_i |F_i|"),
        80,
        80,
    )
}
p.hanging("80 N", BOTH_80, PEAK, to="0.5", **UNPRINTED)

# ---- Two drives: they do not hold the platform all day ----

MEAN_36 = (
    "[without the third leg] a non-redundant mechanism of two freedoms and two drives [...] the "
    "mean forces of its two legs are 36 N"
)
det_day = on_day("det_day", rr["det_2"], "determinant of the two-leg Jacobian", r"\det J_2")


def has_a_value(key, quote, what, given=None):
    """A figure of two drives, which has a value where their determinant does not pass 0."""
    p.between(
        key, quote, det_day, 0, None, given=given,
        words="the determinant of the Jacobian of legs 1 and 2 on the equinox, which must not "
        f"pass through 0 where {what} of two drives is to have a value,",
    )  # fmt: skip


has_a_value("80 N with two", BOTH_80, "the largest force")
has_a_value("36 N", MEAN_36, "the mean force")
first = [at(entry, leg, 0) for entry in J.rows[0]]
tau_2 = rr["tau_2"].rows[0]
not_held = on_day(
    "not_held",
    (first[1] * tau_2[0] - first[0] * tau_2[1]) / sqrt(first[0] ** 2 + first[1] ** 2),
    "what two drives must do along the motion that leaves leg 1 as long as it is",
    r"\tau_\perp",
)
p.between(
    "36 N where the determinant is 0",
    MEAN_36,
    absolute(substitute(not_held, AT_O)),
    0,
    0,
    words="the size of what two drives must do along the motion that leaves leg 1 as long as it "
    "is, where the determinant is 0 to within 0.001 m^2 and leg 2 can do next to nothing, with the "
    "mass centre at o, which the paper does not print (the study has the one line of mass centres "
    "that asks for nothing),",
    given=absolute(det_day) < "0.001",
)

# ---- Three drives: the means ----

SAMPLES = 24
sample = p.index("sample", SAMPLES, letter="k")
moment = p.constant(
    "h_sample",
    tuple(str(6 + 12 * (2 * k + 1) / (2 * SAMPLES)) for k in range(SAMPLES)),
    "sundial time in hours, every half hour of the equinox",
    per=sample,
)


def mean_of(name, force, which, latex):
    """The mean size of a force."""
    sampled = on_day(name, force, f"force of {which} at time k", latex, moment)
    return total(absolute(sampled), over=sample) / SAMPLES


means_of_three = [
    mean_of(f"F_sample_{k + 1}", force, f"drive {k + 1}", f"F_{k + 1}")
    for k, force in enumerate(OF_THREE)
]
means_of_two = [
    mean_of(f"F_2_sample_{k + 1}", force, f"drive {k + 1} of two", f"F_{{2,{k + 1}}}")
    for k, force in enumerate(OF_TWO)
]
p.hanging(
    "30 N",
    "the mean forces of the three legs of the redundant mechanism are 30, 30 and 11 N",
    PEAK
    | {
        f"the mean force of leg {k + 1}": (mean, stated, stated)
        for k, (mean, stated) in enumerate(zip(means_of_three, (30, 30, 11), strict=True))
    },
    to="0.5",
    **UNPRINTED,
)
p.between(
    "mean force lower",
    "the redundant mechanism lowers the mean driving force",
    substitute((sum(means_of_three[1:], start=means_of_three[0]) / 3)
               / (sum(means_of_two[1:], start=means_of_two[0]) / 2), AT_O),
    0,
    1,
    words="the mean force of three drives on the equinox, by that of two, which at these times has "
    "a value and over the whole day has none, with the mass centre at o, which the paper does not "
    "print,",
)  # fmt: skip

# ---- Heat and energy: Figs. 7 to 9 ----
# Heat goes with the sum of the squared forces, whatever the motors are.

heat_3, heat_2, dawn_3, dawn_2 = (
    on_day(f"{name}_{count}", squares(forces), f"sum of the squared forces of {which} drives{when}",
           latex + then, time)
    for name, when, then, time in (
        ("heat", "", "", hours_up), ("dawn", " at sunrise", r"\big|_{h = 6}", number(6)),
    )
    for count, which, forces, latex in (
        (3, "three", OF_THREE, r"\textstyle\sum F_i^2"),
        (2, "two", OF_TWO, r"\textstyle\sum F_{2,i}^2"),
    )
)  # fmt: skip
near_noon = absolute(hours_up - 12) < 1
BOTH_HEATS = "both reach their largest heat of 4.5 W in the early morning and in the evening"
p.hanging(
    "4.5 W",
    BOTH_HEATS,
    {"the largest heat of three drives on the equinox, by that at sunrise,": (
        heat_3 / dawn_3, 1, 1,
    )},
    to="0.01",
    **UNPRINTED,
)  # fmt: skip
p.between(
    "4.5 W of both",
    BOTH_HEATS,
    dawn_2 / dawn_3,
    number("4.45") / number("4.55"),
    number("4.55") / number("4.45"),
    words="the heat of two drives at sunrise, by that of three, wherever the mass centre is,",
)
p.hanging(
    "1.4 W",
    "around noon the heat of the redundant mechanism is less than 1.4 W",
    {"the heat of three drives within an hour of noon on the equinox, by that at sunrise,": (
        where(near_noon, heat_3 / dawn_3, 0), None, number("1.4") / number("4.5"),
    )},
    **UNPRINTED,
)  # fmt: skip
has_a_value(
    "3.8 W", "[around noon] that of the non-redundant mechanism comes to 3.8 W", "the heat",
    near_noon,
)  # fmt: skip
p.unchecked(
    "Fig. 8",
    "the largest heat is 4.5 W",
    "It stands on K_M, R and d of (35) and (36) and on the mass centre of the platform, none of "
    "which is printed; what can be judged without them stands in the entries before.",
)
p.unchecked(
    "Fig. 7",
    "the largest mechanical power of both is the same",
    "It stands on the mass centre of the platform, which is not printed. The study on the page of "
    "the tracker has both powers with it at o and elsewhere.",
)
p.unchecked(
    "mechanical power",
    "the mean mechanical power of the redundant mechanism is higher, as its third leg adds to "
    "kinetic and potential energy",
    "Which mean is meant is not said: the legs end the day as long as they began it, so that the "
    "work of the day is 0 with three legs and with two. Which mechanism has the higher mean size "
    "of power stands on the mass centre, which is not printed; the study on the page of the "
    "tracker has both with it at o and elsewhere.",
)
p.unchecked(
    "62.1 kJ",
    "the energy of the day with three legs: 62.1 kJ",
    "It stands on K_M, R and d of (35) and (36) and on the mass centre of the platform, none of "
    "which is printed. The study on the page of the tracker says what they would have to be.",
)
has_a_value("79.8 kJ", "[the energy of the day] of the non-redundant mechanism is 79.8 kJ",
            "the heat, and so the energy,")  # fmt: skip
p.between(
    "total lower",
    "it lowers the mean moment and also the power consumption of the whole",
    substitute(heat_3 / heat_2, AT_O),
    0,
    1,
    words="the heat of three drives at a time of the equinox, by that of two (the work of the day "
    "is 0 for both), with the mass centre at o, which the paper does not print,",
)
