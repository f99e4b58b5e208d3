"""Loops closed by search: an engine tells how far apart joints are, Newton brings them together.

An engine knows a tree: the two turns of the platform, then for each leg the two turns of its
universal joint and its length. The spherical joints are left open; a *gap* is where the platform
has its joint P less where the leg has it. What is passive follows from the gaps, their slopes and
their drift alone.
"""

from dataclasses import dataclass
from itertools import product
from typing import Any, Protocol

import numpy as np

DRIVES = 2
PER_LEG = 3
STEPS = 30
SMALL = 1e-10  # rad or m: Newton squares it in the step that was just made
CLOSED = 1e-13  # m
GRID = np.radians(30.0)  # of directions to start from


class Engine(Protocol):
    """A tree of joints with coordinates x, their rates v and accelerations a."""

    legs: int

    def gap(self, x) -> Any:
        """(3 legs,) in m, world axes."""

    def slope(self, x) -> Any:
        """(3 legs, 2 + 3 legs): the gap by the coordinates."""

    def drift(self, x, v) -> Any:
        """(3 legs,): the gap's second derivative when no coordinate accelerates."""

    def inverse(self, x, v, a, f_d, n_d) -> Any:
        """(2 + 3 legs,): forces in the joints that make a motion, gaps left open."""


@dataclass(frozen=True)
class Motion:
    """Coordinates, rates and accelerations of a tree whose loops are closed.

    Attributes:
        ways: (2 + 3 legs, 2): how all coordinates go with alpha and beta.
    """

    x: np.ndarray
    v: np.ndarray
    a: np.ndarray
    ways: np.ndarray

    @property
    def J(self) -> np.ndarray:
        """How the lengths go with alpha and beta."""
        return self.ways[lengths(self.ways)]

    @property
    def q(self) -> np.ndarray:
        """The lengths."""
        return self.x[lengths(self.x)]

    @property
    def q_dot(self) -> np.ndarray:
        """Their rates."""
        return self.v[lengths(self.v)]

    @property
    def q_ddot(self) -> np.ndarray:
        """Their accelerations."""
        return self.a[lengths(self.a)]


def lengths(coordinates):
    """Where in the coordinates the lengths of the legs are."""
    return slice(DRIVES + PER_LEG - 1, len(coordinates), PER_LEG)


def close(engine, angles):
    """Coordinates at which no gap is left, with legs longer than 0 and |psi| below a quarter.

    Raises:
        ArithmeticError: if the search ends elsewhere.
    """
    x = _first(engine, angles)
    for _ in range(STEPS):
        step = np.linalg.solve(engine.slope(x)[:, DRIVES:], engine.gap(x))
        x[DRIVES:] -= step
        if np.abs(step).max() < SMALL:
            break
    found = x[DRIVES:].reshape(-1, PER_LEG)
    if np.abs(engine.gap(x)).max() > CLOSED or np.any(found[:, 2] <= 0):
        raise ArithmeticError("the loops do not close")
    if np.any(np.cos(found[:, 1]) <= 0):
        raise ArithmeticError("the loops close on another branch of the universal joint")
    return x


def _first(engine, angles):
    """The best of a grid of directions, leg by leg."""
    x = np.concatenate([angles, np.zeros(PER_LEG * engine.legs)])
    size = np.linalg.norm(engine.gap(x).reshape(-1, 3), axis=1)  # legs of no length end at Q
    best = np.full(engine.legs, np.inf)
    found = np.zeros((engine.legs, PER_LEG))
    for gamma, psi in product(np.arange(-6, 6) * GRID, np.arange(-2, 3) * GRID):
        tried = np.stack([np.full_like(size, gamma), np.full_like(size, psi), size], axis=1)
        x[DRIVES:] = tried.ravel()
        off = np.linalg.norm(engine.gap(x).reshape(-1, 3), axis=1)
        found[off < best] = tried[off < best]
        best = np.minimum(best, off)
    x[DRIVES:] = found.ravel()
    return x


def move(engine, angles, rates, accelerations):
    """How every joint moves when the platform is told to."""
    x = close(engine, angles)
    slope = engine.slope(x)
    driven, passive = slope[:, :DRIVES], slope[:, DRIVES:]
    ways = np.concatenate([np.eye(DRIVES), -np.linalg.solve(passive, driven)])
    v = ways @ rates
    pull = np.linalg.solve(passive, -driven @ accelerations - engine.drift(x, v))
    return Motion(x, v, np.concatenate([accelerations, pull]), ways)


def generalized_force(engine, motion, f_d, n_d):
    """tau: what the drives must do against the whole tree, along alpha and along beta."""
    return motion.ways.T @ engine.inverse(motion.x, motion.v, motion.a, f_d, n_d)
