"""Searches over one number: a plain genetic algorithm, and SciPy's.

An objective takes an array of candidates, shape (k,), and returns as many values.
"""

from dataclasses import dataclass

import numpy as np

from armillary.verify.engines import need

GENERATIONS = 100
PEOPLE = 20
SEED = 2023
# -- the genetic algorithm --
ELITE = 2
CROSSED = 0.8
SPREAD = 0.1  # of the interval: a mutation in the first generation


@dataclass(frozen=True)
class Search:
    """The best candidate, and the best of each generation."""

    best: float
    way: np.ndarray


def local(objective, low, high):
    """Brent's search, which needs the objective to have one valley."""
    optimize = need("scipy.optimize")
    found = optimize.minimize_scalar(
        lambda x: float(objective(np.array([x]))[0]),
        bounds=(low, high), method="bounded", options={"xatol": 1e-9},
    )  # fmt: skip
    # The bounded search never tries the ends themselves.
    return min((low, float(found.x), high), key=lambda x: float(objective(np.array([x]))[0]))


def differential_evolution(objective, low, high):
    """SciPy's, without its local polish at the end, so that it stands on its own."""
    optimize = need("scipy.optimize")
    way = []
    found = optimize.differential_evolution(
        lambda x: objective(x[0]),
        [(low, high)], popsize=PEOPLE, maxiter=GENERATIONS, tol=0.0, atol=0.0, polish=False,
        updating="deferred", vectorized=True, seed=SEED,
        callback=lambda intermediate_result: way.append(float(intermediate_result.x[0])),
    )  # fmt: skip
    return Search(float(found.x[0]), np.array(way))


def genetic(objective, low, high):
    """Tournaments of two, blends of parents, and mutations that shrink with the generations."""
    random = np.random.default_rng(SEED)
    people = random.uniform(low, high, PEOPLE)
    worth = objective(people)
    way = []
    for generation in range(GENERATIONS):
        order = np.argsort(worth, kind="stable")
        people, worth = people[order], worth[order]
        way.append(float(people[0]))
        # In order of worth, the winner of a tournament is the one with the smaller place.
        parents = people[random.integers(PEOPLE, size=(2, 2, PEOPLE)).min(axis=0)]
        share = random.uniform(-0.25, 1.25, PEOPLE)
        mixed = parents[0] + share * (parents[1] - parents[0])
        children = np.where(random.random(PEOPLE) < CROSSED, mixed, parents[0])
        width = SPREAD * (high - low) * (1 - generation / GENERATIONS) ** 3
        children = np.clip(children + random.normal(size=PEOPLE) * width, low, high)
        children[:ELITE] = people[:ELITE]
        people, worth = children, objective(children)
    return Search(way[-1], np.array(way))
