"""Forces of the drives: of least norm with three legs, the only ones with two."""

from armillary import (
    Matrix,
    at,
    hypot,
    number,
    one_like,
    reciprocal_or_zero,
    sqrt,
    total,
    vector,
    where,
)
from armillary.derivation.units import NEWTON

from .dynamics import tau_alpha, tau_alpha_2, tau_alpha_free, tau_beta, tau_beta_2, tau_beta_free
from .legs import J_alpha, J_beta
from .symbols import d, hold_tolerance, leg, r

preload = d.scalar(
    "preload",
    "internal force: legs press against each other by it and the platform does not move",
    unit=NEWTON,
    range=(-100.0, 100.0),
    latex="N",
)


def of_legs(entry, letter):
    """A column of the Jacobian, as a vector over the legs."""
    return d.define(
        f"column_{letter}",
        vector(*(at(entry, leg, k) for k in range(leg.size))),
        because="A column of J holds what one angle does to each of the three lengths.",
        meaning=f"what {letter} does to the three lengths, a component a leg",
        latex=rf"\mathbf{{J}}_\{letter}",
    )


column_alpha, column_beta = of_legs(J_alpha, "alpha"), of_legs(J_beta, "beta")
null = d.define(
    "null",
    column_alpha.cross(column_beta),
    because="Square to both columns: forces in this proportion do no work along any motion.",
    meaning="normal of the two columns, a component a leg",
    latex=r"\mathbf{n}_0",
)
gram = d.define(
    "gram",
    null.dot(null),
    because="The determinant of J^T J is the squared area that the columns span.",
    meaning="determinant of J^T J",
    latex=r"\det J^T J",
)
scale = d.define(
    "scale",
    total(r * r, over=leg),
    because="An angle moves a spherical joint by at most r per radian, so that no entry of J "
    "exceeds it.",
    meaning="sum of the squared distances of the spherical joints from o",
    latex=r"\Sigma r^2",
)
loose = d.define(
    "loose",
    ~(gram > (hold_tolerance * scale) ** 2),
    because="Where the columns are parallel, some motion lengthens no leg and no drive holds it.",
    meaning="whether three drives do not hold the platform",
)
inverse = d.define(
    "inverse",
    reciprocal_or_zero(gram, loose),
    because="Drives that do not hold are given no force.",
    meaning="one over that determinant, 0 where it vanishes",
    latex=r"(\det J^T J)^{-1}",
)


def least(moment_alpha, moment_beta, mark, which):
    """The force of least norm among those that give a generalised force."""
    return d.define(
        f"F_q{mark}",
        (moment_alpha * column_beta - moment_beta * column_alpha).cross(null) * inverse,
        because="In the plane of the columns, so that nothing of it is wasted on the normal: "
        "J (J^T J)^-1 tau, with the inverse of a 2 by 2 matrix written out.",
        meaning=f"forces of the three drives{which}, of least norm; extending positive",
        latex=r"\mathbf{F}",
    )


F_q = least(tau_alpha, tau_beta, "", "")
F_free = least(tau_alpha_free, tau_beta_free, "_free", " of legs that do not spin")
internal = d.define(
    "internal",
    null * where(loose, number(0), 1 / sqrt(where(loose, one_like(gram), gram))),
    because="The normal does no work; divided by its length it has norm 1.",
    meaning="forces of norm 1 that do no work along any motion, 0 where drives do not hold",
    latex=r"\mathbf{n}_0 / |\mathbf{n}_0|",
)
F_preloaded = d.define(
    "F_preloaded",
    F_q + preload * internal,
    because="What does no work may be added: it takes up play, and costs heat.",
    meaning="forces of the three drives with an internal force, extending positive",
    latex=r"\mathbf{F}_N",
)

# ---- two legs ----

J_1a, J_1b, J_2a, J_2b = (
    at(entry, leg, k) for k in (0, 1) for entry in (J_alpha, J_beta)
)  # fmt: skip
det_2 = d.define(
    "det_2",
    J_1a * J_2b - J_1b * J_2a,
    because="Two legs hold the platform where their rows are not parallel.",
    meaning="determinant of the Jacobian of legs 1 and 2",
    latex=r"\det J_2",
)
scale_2 = d.define(
    "scale_2",
    at(r, leg, 0) * at(r, leg, 0) + at(r, leg, 1) * at(r, leg, 1),
    because="An angle moves a spherical joint by at most r per radian, so that no entry of J "
    "exceeds it.",
    meaning="sum of the squared distances of two spherical joints from o",
    latex=r"\Sigma_2 r^2",
)
loose_2 = d.define(
    "loose_2",
    ~(det_2 * det_2 > (hold_tolerance * scale_2) ** 2),
    because="Where the two rows are parallel, some motion lengthens neither leg and no drive holds "
    "it.",
    meaning="whether two drives do not hold the platform",
)
inverse_2 = d.define(
    "inverse_2",
    reciprocal_or_zero(det_2, loose_2),
    because="Drives that do not hold are given no force.",
    meaning="one over that determinant, 0 where it vanishes",
    latex=r"(\det J_2)^{-1}",
)
F_2 = d.define(
    "F_2",
    Matrix(
        (
            (
                (tau_alpha_2 * J_2b - tau_beta_2 * J_2a) * inverse_2,
                (tau_beta_2 * J_1a - tau_alpha_2 * J_1b) * inverse_2,
            ),
        )
    ),
    because="J^T F = tau is two equations for two forces: the inverse of a 2 by 2 matrix, written "
    "out.",
    meaning="forces of the drives of legs 1 and 2 where leg 3 is absent; extending positive",
    unit=NEWTON,
    latex=r"\mathbf{F}_2",
)

# ---- how well the drives hold ----

norm_alpha, norm_beta, mixed = (
    d.define(
        name,
        left.dot(right),
        because="The eigenvalues of J^T J, whose entries are products of columns, tell how well "
        "drives hold.",
        meaning=f"entry of J^T J: {what}",
        latex=latex,
    )
    for name, left, right, what, latex in (
        ("norm_alpha", column_alpha, column_alpha, "column of alpha squared", r"G_{\alpha\alpha}"),
        ("norm_beta", column_beta, column_beta, "column of beta squared", r"G_{\beta\beta}"),
        ("mixed", column_alpha, column_beta, "both columns", r"G_{\alpha\beta}"),
    )
)
largest = d.define(
    "largest",
    (norm_alpha + norm_beta + hypot(norm_alpha - norm_beta, 2 * mixed)) / 2,
    because="The larger root of the characteristic equation, of sums alone.",
    meaning="larger eigenvalue of J^T J",
    latex=r"\lambda_1",
)
sigma_min = d.define(
    "sigma_min",
    where(loose, number(0), sqrt(gram / where(loose, one_like(largest), largest))),
    because="The two eigenvalues multiply to the determinant.",
    meaning="smallest singular value of J: how far some leg moves per unit of the worst motion; "
    "0 where drives do not hold",
    latex=r"\sigma_2",
)
