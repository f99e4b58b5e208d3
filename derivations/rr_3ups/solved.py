"""Fast motions that pinocchio has solved, once for all checks."""

from dataclasses import dataclass
from functools import cache

import numpy as np

from .closure import generalized_force, move
from .models_pinocchio import Tree
from .samples import fast, rows, state

SEED = 101


@dataclass(frozen=True)
class Solved:
    """Points (n, ...), and what an engine says there: itself and a motion a point, tau (n, 2)."""

    points: dict[str, np.ndarray]
    engines: list
    motions: list
    tau: np.ndarray

    def each(self, of):
        """An array (n, ...) of what a function finds on each engine and motion."""
        return np.array([of(e, m) for e, m in zip(self.engines, self.motions, strict=True)])

    def ways(self, name):
        """An array (n, ...) of an attribute of each motion."""
        return np.array([getattr(motion, name) for motion in self.motions])


@cache
def by_pinocchio(legs=(0, 1, 2)):
    """Fast motions of a machine on some of its legs."""
    return solve(fast(SEED), legs)


def solve(points, legs=(0, 1, 2), tree=Tree):
    """What an engine says at points."""
    engines, motions, tau = [], [], []
    for row in rows(points):
        engine = tree(row, legs)
        motion = move(engine, *state(row))
        engines.append(engine)
        motions.append(motion)
        tau.append(generalized_force(engine, motion, row["f_d"], row["n_d"]))
    return Solved(points, engines, motions, np.array(tau))


def least_norm(J, tau):
    """Forces of least norm with J^T F = tau, by singular values: (n, legs)."""
    return np.einsum("nkj,nj->nk", np.linalg.pinv(np.swapaxes(J, 1, 2)), tau)
