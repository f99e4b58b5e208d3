"""The attitudes that face the sun: the one with beta >= 0, and the nearest to where it stands."""

from dataclasses import dataclass

from armillary import (
    PI,
    X,
    Z,
    atan2,
    atan2_or_zero,
    cos,
    elementary,
    hypot,
    sin,
    substitute,
    unit,
    where,
)
from armillary.derivation.units import RADIAN

from .legs import R_m
from .symbols import alpha, beta, d, enu

alpha_before = d.angle(
    "alpha_before", "turn of the platform before the move", latex=r"\alpha_\mathrm{b}"
)
beta_before = d.angle(
    "beta_before",
    "tilt of the platform before the move",
    range=(-1.6, 1.6),
    latex=r"\beta_\mathrm{b}",
)
zenith_tolerance = d.constant(
    "zenith_tolerance",
    "1e-6",
    "horizontal length of the sun's direction below which the turn of the platform is free",
    latex=r"\tau_z",
)


def naming(suffix, mark, *, printed=None, reasons=True):
    """A way to define the steps for one direction; braces in a name stand for the suffix.

    Args:
        mark: the subscript on the page.
        printed: numbers of the paper's equations, by name.
        reasons: whether the steps are taken for the first time, and so say why.
    """

    def define(name, value, *, because, meaning, latex, unit=None):
        full = name.format(suffix)
        return d.define(
            full,
            value,
            because=because if reasons else "The same step as for a direction that is given.",
            meaning=meaning,
            printed=(printed or {}).get(full),
            unit=unit,
            latex=rf"{{{latex}}}_{{{mark}}}",
        )

    return define


def unnamed(name, value, **words):
    """For what is not worth a name."""
    return value


# ---- the attitude that faces a direction ----


@dataclass(frozen=True)
class Aim:
    """The attitude that faces the direction c.

    Attributes:
        rho: length of the direction's horizontal part.
        free: whether the turn is free; None where that is not asked.
    """

    c: object
    rho: object
    free: object
    alpha: object
    beta: object

    def unless_free(self, value, otherwise=0):
        """A value, replaced where the turn is free."""
        return value if self.free is None else where(self.free, otherwise, value)


def aim(c, define):
    """The attitude that faces the direction c."""
    rho = define(
        "rho_{}",
        hypot(c.x, c.y),
        because="The shadow of a unit pole that points to the sun has this length; it is sin(beta) "
        "of the platform that faces it.",
        meaning="length of the horizontal part of the sun's direction",
        latex=r"\rho",
    )
    free = define(
        "free_{}",
        rho < zenith_tolerance,
        because="Level, the platform faces the zenith in whatever turn.",
        meaning="whether the turn of the platform is free",
        latex=r"\mathit{free}",
    )
    turn = define(
        "alpha_{}",
        atan2_or_zero(c.x, -c.y, free),
        because="With alpha = 0 a positive tilt leans the platform south; alpha turns this to the "
        "east. It is 0 where it is free. The print's arc tangent knows half of the circle.",
        meaning="turn of the platform that faces the sun with beta >= 0, in [-pi, pi]",
        latex=r"\alpha",
    )
    tilt = define(
        "beta_{}",
        atan2(rho, c.z),
        because="It leans as far as the sun is from the zenith. The print's arc cosine would lose "
        "half of the digits near the zenith.",
        meaning="tilt of the platform that faces the sun, in [0, pi]",
        latex=r"\beta",
    )
    return Aim(c, rho, free, turn, tilt)


PRINTED = {
    "alpha_aim": "32",
    "beta_aim": "32'",
    "alpha_track_dot": "33",
    "alpha_track_ddot": "33'",
}
aimed = aim(enu, naming("aim", r"\mathrm{aim}", printed=PRINTED))
alpha_aim, beta_aim, at_zenith = aimed.alpha, aimed.beta, aimed.free

normal = R_m.column(Z)
alone = Aim(enu, hypot(enu.x, enu.y), None, atan2(enu.x, -enu.y), atan2(aimed.rho, enu.z))
d.identity(
    "away from the zenith the platform's normal is on the sun",
    (elementary(Z, alone.alpha) @ elementary(X, alone.beta)).column(Z),
    unit(enu),
)

# ---- the nearest of all attitudes that face it ----

ahead = d.define(
    "ahead",
    enu.x * sin(alpha_before) - enu.y * cos(alpha_before),
    because="In the axes that turn with alpha the platform leans along the second axis alone, "
    "backward for a positive tilt.",
    meaning="part of the sun's direction along the way that a positive tilt leaned the platform",
    latex=r"c_\parallel",
)
aside = d.define(
    "aside",
    enu.x * cos(alpha_before) + enu.y * sin(alpha_before),
    because="The tilt moves the normal square to its axis: what the sun has along that axis alpha "
    "must reach.",
    meaning="part of the sun's direction along the axis of the tilt before",
    latex=r"c_\perp",
)
kept = d.define(
    "kept",
    ahead * (1 + cos(beta_before) * enu.z) + sin(beta_before) * (enu.x * enu.x + enu.y * enu.y),
    because="Two attitudes face the sun: half a turn of alpha and the other sign of beta lead from "
    "one to the other, which is half a turn about the normal. The platform reaches the one "
    "that has the larger trace with the attitude before by the smaller turn. Near the zenith this "
    "asks for the smaller turn of alpha; near the horizon it does not tilt through the zenith to "
    "the other side.",
    meaning="positive where the attitude with beta >= 0 is reached by the smaller turn of the "
    "platform",
    latex="k",
)
flips = d.define(
    "flips",
    kept < 0,
    because="The attitude before has the larger trace with the other attitude, which is so the "
    "nearer.",
    meaning="whether the platform faces the sun with beta < 0, but for whole turns",
    latex=r"\mathit{flips}",
)
leaned = d.define(
    "leaned",
    aimed.unless_free(where(flips, -aimed.rho, aimed.rho), ahead),
    because="The sine of the tilt. Where the turn is free it is held, and the tilt follows what "
    "it can: the sun is missed by less than the tolerance.",
    meaning="sine of the tilt of the nearest attitude",
    latex=r"\sin\beta_\mathrm{n}",
)
alpha_nearest = d.define(
    "alpha_nearest",
    alpha_before
    + atan2_or_zero(where(flips, -aside, aside), where(flips, -ahead, ahead), at_zenith),
    because="The turn that is left, added to the turn before: nothing is ever unwrapped, so that "
    "a half turn is no border.",
    meaning="turn of the nearest attitude that faces the sun",
    unit=RADIAN,
    latex=r"\alpha_\mathrm{n}",
)
beta_nearest = d.define(
    "beta_nearest",
    beta_before
    + atan2(
        leaned * cos(beta_before) - enu.z * sin(beta_before),
        enu.z * cos(beta_before) + leaned * sin(beta_before),
    ),
    because="The tilt that is left, added in the same way: the sine and cosine of a difference.",
    meaning="tilt of the nearest attitude that faces the sun",
    unit=RADIAN,
    latex=r"\beta_\mathrm{n}",
)


def trace_with(turn, tilt):
    """Trace of the rotation from the attitude before to another."""
    before = elementary(Z, alpha_before) @ elementary(X, beta_before)
    after = elementary(Z, turn) @ elementary(X, tilt)
    return sum(before.column(k).dot(after.column(k)) for k in (0, 1, 2))


d.identity(
    "what decides is the difference of the traces",
    2 * substitute(kept, {enu: normal}),
    sin(beta) * (trace_with(alpha, beta) - trace_with(alpha + PI, -beta)),
)
