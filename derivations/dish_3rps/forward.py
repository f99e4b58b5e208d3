"""Rods to pose: a search for the tilt and the height, with a fixed number of steps."""

from armillary import absolute, any_of, solve, substitute

from .half_tilt import UNKNOWNS, h_q, here, placed_at, q_x, q_y, q_z, reach_q
from .symbols import alpha, beta, d, forward_tolerance, guess, l_given, leg, metre, z_O

STEPS = 8

closure = d.define(
    "closure",
    reach_q * reach_q + h_q * h_q - l_given * l_given,
    because="Squared, the length is a rational function of the coordinates, and the search needs "
    "no root.",
    meaning="what vanishes where rod i has the length given",
    latex=r"\Delta",
)
_guessed = {alpha: guess.x, beta: guess.y, z_O: guess.z * metre}
_start = [substitute(here(q), _guessed) for q in UNKNOWNS]
found = solve(
    closure,
    dict(zip(UNKNOWNS, _start, strict=True)),
    steps=STEPS,
    name="newton",
    within={q_x: (-2, 2), q_y: (-2, 2), q_z: (0, 2000 * metre)},
)
left = d.define(
    "left",
    substitute(closure, dict(zip(UNKNOWNS, found, strict=True))),
    because="Nothing says that the search has ended where it should: the lengths of the pose that "
    "was found do.",
    meaning="what is left of the squared length of rod i",
    latex=r"\Delta^+",
)
lost = d.define(
    "lost",
    any_of(~(absolute(left) < forward_tolerance * (l_given * l_given)), over=leg),
    because="A search that converges is at the rounding error by then, and far from this bound.",
    meaning="whether some rod of the pose found is not as long as given",
)
H_R_found, M_found = placed_at(found, "found", "the facet on rods of the lengths given")
