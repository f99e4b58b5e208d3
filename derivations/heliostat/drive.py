"""The drive angles that point the normal along a direction, on both branches and at the edge."""

from dataclasses import dataclass

from armillary import Status, atan2, cos, number, sin, sqrt, where

from .frames import I_R_L, local, normal_I
from .optics import m
from .symbols import alpha, b, beta, chi, d, edge_tolerance, opposite_tolerance, sun


def again(suffix, mark, of="m"):
    """Names the same steps for another direction."""

    def define(name, expression, *, meaning, latex=None, because=""):
        return d.define(
            f"{name}_{suffix}",
            expression,
            because="The same step as for the drive.",
            meaning=meaning.replace(" m ", f" {of} ").replace("|m|", f"|{of}|"),
            latex=latex and rf"{{{latex}}}_{{{mark}}}",
        )

    return define


def unnamed(name, expression, **words):
    """For what is not worth a name."""
    return expression


_AZIMUTH = (
    "The azimuth drive carries (X, Y) to (Q, W), so it turns by the difference of their "
    "directions. On the azimuth axis itself every azimuth will do, and 0 is taken."
)
_ELEVATION = "The height is sin(beta), what is left across cos(beta), both times cos(chi) |m|."


def side(define, name, value, because):
    """One side of the triangle that a drive angle is taken from."""
    angle, axis = name.split("_")
    which = "opposite" if axis == "y" else "adjacent"
    meaning = f"side of the triangle of {angle}, {which}"
    return define(name, value, because=because, meaning=meaning, latex=rf"{axis}_\{angle}")


def turned(v, W, Q):
    """Sine and cosine of the azimuth drive that carries (v.x, v.y) to (Q, W), times a length."""
    return W * v.x - Q * v.y, Q * v.x + W * v.y


def sideways(v, offset=None):
    """W: how far a direction must stand off sideways, `offset` more than the inclination asks."""
    return sin(chi) * v.z if offset is None else offset + sin(chi) * v.z


def left_across(across, W):
    """Q squared: what of the part across is left for the elevation drive."""
    return cos(chi) * cos(chi) * across - W * W


def risen(v, W, offset=None):
    """What sin(beta) is proportional to."""
    return v.z if offset is None else sin(chi) * W + cos(chi) * cos(chi) * v.z


def closed_form(v, offset=None):
    """The drive angles of a direction where nothing is singular: no guard stands in the way."""
    W = sideways(v, offset)
    Q = sqrt(left_across(v.x * v.x + v.y * v.y, W))
    return atan2(*turned(v, W, Q)), atan2(risen(v, W, offset), Q)


@dataclass(frozen=True)
class Reach:
    """A direction in the frame of the azimuth axis, seen from the elevation axis.

    Attributes:
        v: any positive multiple of the normal.
        across: square of its part across the azimuth axis.
        size: square of its length.
        W: its offset along the elevation axis, made by the inclination, times cos(chi).
        rise: what sin(beta) is proportional to.
        square: square of its part across the elevation axis, times cos(chi)^2.
        blind: whether no elevation reaches it.
        steep: whether the azimuth drive runs away.
        free: whether every azimuth is as good as another.
        null: whether there is no direction at all; None for one of length 1.
        Q: root of the square, 0 where it is blind.
    """

    v: object
    across: object
    size: object
    W: object
    rise: object
    square: object
    blind: object
    steep: object
    free: object
    null: object
    Q: object

    def points(self, Q, define=unnamed):
        """Sine and cosine of azimuth and elevation drive, times lengths, for a sign of the root.

        An angle that is free has the sine 0 and the cosine 1.
        """
        sine, cosine = turned(self.v, self.W, Q)
        rise, run = self.rise, Q
        if self.null is not None:
            rise, run = where(self.null, 0, rise), where(self.null, 1, run)
        return (
            (
                side(define, "alpha_y", where(self.free, 0, sine), _AZIMUTH),
                side(define, "alpha_x", where(self.free, 1, cosine), _AZIMUTH),
            ),
            (
                side(define, "beta_y", rise, _ELEVATION),
                side(define, "beta_x", run, _ELEVATION),
            ),
        )

    def angles(self, Q, define=unnamed):
        """Azimuth and elevation drive for a sign of the root, in [-pi, pi]."""
        return tuple(atan2(*point) for point in self.points(Q, define))


def reach(v, define, offset=None, unit=False):
    """What the drives can do for a direction; `define` names the steps.

    With an `offset` it is not the mirror's first axis that is pointed there, but one turned from
    it towards the second. `unit` says that `v` has length 1, as it must with an offset.
    """
    across = define(
        "across",
        v.x * v.x + v.y * v.y,
        because="The azimuth drive turns this part of the direction and leaves the rest.",
        meaning="square of the part of m across the azimuth axis",
        latex=r"\rho^2",
    )
    size = number(1) if unit else across + v.z * v.z
    aside = None if offset is None else sin(offset)
    W = define(
        "W",
        sideways(v, aside),
        because="The normal stays square to the elevation axis. That axis is inclined by chi, so "
        "a normal raised to the height Z must stand off sideways by tan(chi) Z; everything here "
        "carries the factor cos(chi), so that nothing is divided.",
        meaning="sideways part of m that the inclination asks for, times cos(chi)",
        latex="W",
    )
    square = define(
        "Q_square",
        left_across(across, W),
        because="What is left of the part across is cos(beta) times the length of m, here times "
        "cos(chi). Both squares are small where the difference is, so it keeps its digits near "
        "the edge, which 1 - sin(beta)^2 would lose.",
        meaning="(cos(beta) cos(chi) |m|)^2, negative in the blind cone",
        latex="Q^2",
    )
    blind = define(
        "blind",
        square < 0,
        because="Within chi of the azimuth axis there is less across than the inclination asks "
        "for: no elevation brings the normal there.",
        meaning="whether the direction lies in the blind cone",
    )
    steep = define(
        "steep",
        ~(square > edge_tolerance * edge_tolerance * (cos(chi) * cos(chi) * size)),
        because="Where cos(beta) vanishes, the elevation drive turns the mirror about the same "
        "axis as the azimuth drive would need to.",
        meaning="whether cos(beta) is below the tolerance, or the direction in the blind cone",
    )
    free = define(
        "on_axis",
        ~(across > edge_tolerance * edge_tolerance * size),
        because="On the azimuth axis the azimuth drive turns nothing.",
        meaning="whether the direction lies on the azimuth axis, within 1e-6",
    )
    null = None if unit else _null(size, define)
    Q = define(
        "Q",
        sqrt(where(blind, 0, square)),
        because="The root is taken where there is one; the other branch has the other sign.",
        meaning="cos(beta) cos(chi) |m| on the front branch, 0 in the blind cone",
        latex="Q",
    )
    return Reach(v, across, size, W, risen(v, W, aside), square, blind, steep, free, null, Q)


def _null(size, define):
    return define(
        "no_direction",
        size < opposite_tolerance * opposite_tolerance,
        because="A receiver opposite the sun singles out no normal; a turn leaves the length of m "
        "as it is, so it may be tested here, where its square is known.",
        meaning="whether sun and receiver stand opposite each other, as the drives see it",
    )


m_I = d.define(
    "m_I",
    I_R_L @ local(m),
    because="The wanted direction, seen from the leaning azimuth axis.",
    meaning="sum of the directions to receiver and sun, in the frame of the azimuth axis",
    latex=r"\mathbf{m}_I",
)
aim = reach(m_I, d.define)
azimuth_point, elevation_point = aim.points(aim.Q, d.define)
alpha_drive = d.define(
    "alpha_drive",
    atan2(*azimuth_point),
    because="The arc sine of the print knows half the circle only; this knows all of it.",
    meaning="azimuth drive angle, front branch",
    printed="20",
    latex=r"\alpha_{bc}",
)
beta_drive = d.define(
    "beta_drive",
    atan2(*elevation_point),
    because="The arc sine of the print is blunt near its ends.",
    meaning="elevation drive angle, front branch: in [-pi/2, pi/2]",
    printed="19",
    latex=r"\beta_{bc}",
)
over = aim.angles(-aim.Q, again("back", r"\prime"))
alpha_back = d.define(
    "alpha_back",
    over[0],
    because="The normal can also be raised over the top from behind: cos(beta) is negative then.",
    meaning="azimuth drive angle, back branch",
    latex=r"\alpha'_{bc}",
)
beta_back = d.define(
    "beta_back",
    over[1],
    because="The same height from the other side.",
    meaning="elevation drive angle, back branch",
    latex=r"\beta'_{bc}",
)

# ---- with the sun by the clock ----

m_sun = d.define(
    "m_sun",
    b + sun["enu"],
    because="The sun is where latitude, declination and hour angle put it.",
    meaning="sum of the directions to the receiver and to the sun of the almanac",
    latex=r"\mathbf{m}_\odot",
)
m_I_sun = d.define(
    "m_I_sun",
    I_R_L @ local(m_sun),
    because="The same step as for the drive.",
    meaning="this sum in the frame of the azimuth axis",
    latex=r"\mathbf{m}_{I\odot}",
)
_for_sun = again("sun", r"\odot")
aim_sun = reach(m_I_sun, _for_sun)
tracking = aim_sun.angles(aim_sun.Q, _for_sun)
alpha_track = d.define(
    "alpha_track",
    tracking[0],
    because="The drive angle as before, for this sum.",
    meaning="azimuth drive angle that follows the sun",
    latex=r"\alpha_\odot",
)
beta_track = d.define(
    "beta_track",
    tracking[1],
    because="The drive angle as before, for this sum.",
    meaning="elevation drive angle that follows the sun",
    latex=r"\beta_\odot",
)

# ---- what makes the closed form true ----
# The normal of angles alpha and beta, with the W and Q that these angles stand for.

_W = sideways(normal_I)
_Q = cos(chi) * cos(beta)
_across = normal_I.x * normal_I.x + normal_I.y * normal_I.y
_sine, _cosine = turned(normal_I, _W, _Q)
d.identity(
    "for the normal of angles alpha and beta the square is that of cos(beta) cos(chi)",
    left_across(_across, _W),
    _Q * _Q,
)
d.identity(
    "and the azimuth drive's sine comes back, on either branch",
    _sine,
    cos(chi) * _across * sin(alpha),
)
d.identity("with its cosine", _cosine, cos(chi) * _across * cos(alpha))
d.identity(
    "a direction is in the blind cone when its height exceeds cos(chi)",
    aim.square,
    cos(chi) * cos(chi) * m.dot(m) - m_I.z * m_I.z,
)


def _no_normal(aim):
    return (Status.UNREACHABLE, aim.null, "b = -c within 1e-6: no normal is singled out")


def cases_of(aim):
    """What the drives answer at the points that need a status."""
    return [
        _no_normal(aim),
        (Status.UNREACHABLE, aim.blind, "the normal would lie in the blind cone"),
        (
            Status.SINGULAR,
            aim.steep,
            "cos(beta) is below 1e-6: the azimuth drive runs away there; on its own axis it is 0",
        ),
    ]


def cases_of_nearest(aim):
    """The same where the nearest pose will do."""
    return [
        _no_normal(aim),
        (Status.CLAMPED, aim.blind, "the normal would lie in the blind cone: the nearest is taken"),
        (
            Status.SINGULAR,
            aim.free,
            "the normal is on the azimuth axis: alpha is 0, and the nearest pose is chi away",
        ),
        (
            Status.SINGULAR,
            aim.steep & ~aim.blind,
            "cos(beta) is below 1e-6: the azimuth drive runs away",
        ),
    ]
