"""Tuning of the rods' law: Figs. 11 and 12 and Table 2, and other searches beside the swarm."""

import numpy as np

from armillary.verify.engines import need
from armillary.verify.plots import Axis, Curve, Mark, Panels, Plot
from armillary.verify.study import Column, Heading, ParameterTable, Prose, Result, Table

from .days import MM
from .plant import corner, nominal
from .tracking import outline
from .tuning import (
    LOOSE,
    Trial,
    law_of,
    plain_score,
    radius,
    robust_score,
    sensitivity,
    swarm,
    worst,
)

DIGITS = 3  # of the gains that are kept
SEED = 1
GRID = 121  # gains of a loop with K_P alone
STABLE = 1 + 1e-9
SIMPLEX = 120  # trials of the simplex search
GAINS = ("K_P", "K_I", "K_D")
UNITS = ("N/m", "N/(m s)", "N s/m")
OURS = "PID, swarm, both plants, robust"
AS_PRINTED = "PID, swarm, nominal plant, nothing else"
P_BEST, P_ROBUST = "P only, nominal plant, stable", "P only, both plants, robust"


# -- the swarm ------------------------------------------------------------------------------------


def tuning(kernels, native, parameters, tell):
    """The law, the plant, the swarm, the gains."""
    both = Trial(native, parameters, (nominal(parameters), corner(parameters)))
    one = Trial(native, parameters, both.plants[:1])
    box = np.log10([parameters.tuning.least, parameters.tuning.greatest])
    found = {
        OURS: swarm(
            lambda at: robust_score(both, at), box, parameters.tuning, SEED,
            lambda part: tell(0.6 * part, "swarm, both plants"),
        ),
        AS_PRINTED: swarm(
            lambda at: plain_score(one, at), box, parameters.tuning, SEED,
            lambda part: tell(0.6 + 0.4 * part, "swarm, nominal plant"),
        ),
    }  # fmt: skip
    gains = {name: rounded(10.0**of.best) for name, of in found.items()}
    gains.update(proportional(both))
    yield from the_plant(parameters, both.plants)
    yield from convergence(parameters, found)
    yield from the_gains(both, gains)
    yield from trials(both, gains)
    yield Result("gains", {"PID": gains[OURS], "P": gains[P_BEST]})
    best = [float(gain) for gain in 10.0 ** found[OURS].best]  # as they were scored
    yield Result("swarm", {"way": found[OURS].way, "score": found[OURS].score, "gains": best})


def rounded(gains):
    """To the digits that are kept, so that no last bit of a search is told as if it counted."""
    return [float(f"{gain:.{DIGITS}g}") for gain in gains]


def proportional(trial):
    """The best gain of the error alone: as long as the loop is stable, and if it must be robust."""
    gains = np.zeros((GRID, 3))
    gains[:, 0] = np.geomspace(1e4, 1e6, GRID)
    law, scores = law_of(trial.parameters, gains), trial.scores(gains)
    stable = radius(trial.plants[0], law) < STABLE
    robust = worst(radius, trial.plants, law) < STABLE
    robust &= worst(sensitivity, trial.plants, law) < trial.parameters.tuning.sensitivity
    best = np.argmin(np.where(stable, scores[0], np.inf))
    firm = np.argmin(np.where(robust, scores.sum(axis=0), np.inf))
    return {P_BEST: rounded(gains[best]), P_ROBUST: rounded(gains[firm])}


def the_plant(parameters, plants):
    """What is controlled, and Figs. 11 and 13 in words."""
    yield Heading("Figs. 11 and 13: the loop around a rod")
    yield Prose(
        "Figs. 11 and 13 of the paper are block diagrams, and lost; here they are told in words. "
        "The sun's kernels and `aim` give the dish's angles, `rod_lengths` and `rod_rates` the "
        "wanted length and speed of each rod, and, where "
        "there is feed-forward, `static_forces` the force that carries the facet; to that comes "
        "the rod's own weight along its lean. The law is the exported kernel "
        "`rod_control_update`, its compiled C called once a sampling period for twelve rods; it "
        "hears the length that the encoder tells. It drives the multibody model, and nothing else "
        "in the loop knows the model. **The paper gives no mass, no friction, no drive and no "
        "encoder: all of these are ours.**"
    )
    yield ParameterTable("The plant, its corner, the gust and the law.",
                         ["plant", "corner", "gust", "control"])  # fmt: skip
    yield Prose(
        f"A rod moves {plants[0].moved:.1f} kg, {plants[0].screw:.1f} kg of which are the screw's "
        f"inertia, and upright carries {plants[0].weight:.0f} N; on the corner plant "
        f"{plants[1].moved:.1f} kg and {plants[1].weight:.0f} N. Dry friction sticks: a rod at "
        "rest stays until the other forces exceed it. The corner plant has all that "
        "makes control harder at once, and the law must bear it with the same gains."
    )


def convergence(parameters, found):
    """Fig. 12."""
    settings, trial = parameters.tuning, parameters.tuning
    yield Heading("Fig. 12: tuning by a swarm")
    yield Prose(
        "Fig. 12 of the paper is a flow chart of the search; here the search is told in words, and "
        "a plot of how it converges stands for the chart."
    )
    yield Prose(
        f"A rod starts {MM * trial.offset:g} mm off and at rest, under its load, and follows a "
        f"cosine of speed of {MM * trial.speed:g} mm/s for {trial.duration:g} s, so that it turns "
        "round twice; (36) scores it. (38) and (39) are taken as printed, with a random number for "
        "each particle and coordinate, in the logarithms of the gains; the swarm's best is known "
        "before the first step. Two searches: **(36) of the nominal plant and nothing "
        "else**, as the paper has it; and **the sum of both plants' scores, of laws that are "
        f"stable on both with a sensitivity peak of at most {settings.sensitivity:g}**."
    )
    yield ParameterTable("The search.", ["tuning"])
    yield Plot(
        "Fig. 12: the best score in each generation.",
        "generation",
        Axis("score (36), m s²", log=True),
        [
            Curve(name, np.arange(len(of.way)), np.where(of.way < LOOSE, of.way, np.nan))
            for name, of in found.items()
        ],
    )


def the_gains(trial, gains):
    """Table 2."""
    rows = [(name, *of, *told(trial, of)) for name, of in gains.items()]
    yield Table(
        "Table 2: gains, the score (36), and the linear loop on both plants: peak of the "
        "sensitivity, and whether it is stable. The gains of the tracking are those of the first "
        "row; P only is there at its best stable gain.",
        [
            "law and search",
            *(Column(f"${n}$", unit, ".3g") for n, unit in zip(GAINS, UNITS, strict=True)),
            Column("score, nominal", "m s²", ".2e"), Column("score, corner", "m s²", ".2e"),
            Column("peak, nominal", "", ".2f"), Column("peak, corner", "", ".2f"), "stable",
        ],
        rows,
    )  # fmt: skip
    ours, printed = (dict(zip(gains, rows, strict=True))[name] for name in (OURS, AS_PRINTED))
    loops = printed[8].split(", ")
    only = "**The paper's criterion alone finds gains that hold on the plant it knows only.** "
    peak = f", with a sensitivity peak of {printed[6]:.1f}" if loops[0] == "stable" else ""
    yield Prose(
        (only if loops == ["stable", "unstable"] else "")
        + f"The $K_P$ that the paper's criterion alone finds is {printed[1] / ours[1]:.1f} times "
        f"ours. Its score on the nominal plant, where less is better, is "
        f"{printed[4] / ours[4]:.2g} times ours{peak}. On the corner plant the loop "
        f"is {loops[1]} and its score {printed[5] / ours[5]:.3g} times ours. The "
        f"robust law has peaks of {ours[6]:.2f} and {ours[7]:.2f}, where "
        f"{trial.parameters.tuning.sensitivity:g} are allowed."
    )


def told(trial, gains):
    """Scores, peaks and stability of a law, nominal plant first."""
    law, scores = law_of(trial.parameters, [gains]), trial.scores(np.array([gains]))[:, 0]
    peaks = [float(sensitivity(plant, law)[0]) for plant in trial.plants]
    stable = [float(radius(plant, law)[0]) < STABLE for plant in trial.plants]
    words = ", ".join("stable" if one else "unstable" for one in stable)
    # The peak says how near the edge a stable loop is, and nothing of one that is not.
    return [*map(float, scores), *np.where(stable, peaks, np.nan).tolist(), words]


def trials(trial, gains):
    """What the laws do in the trial."""
    names = [OURS, AS_PRINTED, P_BEST]
    errors = MM * np.abs(trial.run(np.array([gains[name] for name in names])))
    time = np.arange(len(errors)) * trial.parameters.control.T_S
    yield Panels(
        "The trial with the gains of Table 2: the largest error of each tenth of a second.",
        [
            Plot(
                name, "time, s", Axis("error, mm", log=True),
                [
                    Curve(law, *outline(time, errors[:, k, j], round(10 * time[-1])))
                    for j, law in enumerate(names)
                ],
            )
            for k, name in enumerate(("nominal plant", "corner plant"))
        ],
    )  # fmt: skip


# -- other searches -------------------------------------------------------------------------------


def searches(kernels, native, parameters, results, tell):
    """The same problem by optimisers from SciPy."""
    trial = Trial(native, parameters, (nominal(parameters), corner(parameters)))
    box = np.log10([parameters.tuning.least, parameters.tuning.greatest])
    ours = results["swarm"]
    evolved, way = evolution(trial, box, parameters.tuning, lambda p: tell(p / 2, "evolution"))
    simple, tried = simplex(trial, box, lambda p: tell(0.5 + p / 2, "simplex"))
    count = parameters.tuning.particles * (parameters.tuning.generations + 1)
    yield Heading("Other searches for the same gains")
    rows = [
        ("swarm (38), (39)", count, *ours["gains"], ours["score"]),
        ("differential evolution", count, *10.0 ** evolved[0], evolved[1]),
        ("Nelder and Mead's simplex", tried, *10.0 ** simple[0], simple[1]),
    ]
    yield Table(
        "Table 2, beside it: the robust gains by other optimisers, each as it was scored, before "
        f"the gains of the tracking are rounded to {DIGITS} digits.",
        [
            "search", "trials",
            *(Column(f"${n}$", unit, ".4g") for n, unit in zip(GAINS, UNITS, strict=True)),
            Column("score", "m s²", ".4e"),
        ],
        rows,
    )  # fmt: skip
    yield beside(ours["way"], way, simple[1])
    scores = [row[-1] for row in rows]
    apart = max(scores[1], scores[0]) / min(scores[1], scores[0]) - 1
    yield Prose(
        f"Swarm and differential evolution end {100 * apart:.2g}% apart in the score. The simplex, "
        "started in the middle of the box, "
        + (
            f"ends {100 * (scores[2] / min(scores) - 1):.2g}% above the best."
            if scores[2] < LOOSE
            else "finds no robust law at all."
        )
    )


def beside(swarmed, evolved, simple):
    """The best of each generation of both searches, and where the simplex ended."""
    return Plot(
        "Fig. 12, beside it: swarm and differential evolution, the best of each generation.",
        "generation",
        Axis("score, m s²", log=True),
        [
            Curve(name, np.arange(len(of)), np.where(np.array(of) < LOOSE, of, np.nan))
            for name, of in (("swarm", swarmed), ("differential evolution", evolved))
        ],
        [Mark(simple, "simplex")] if simple < LOOSE else [],
    )


def evolution(trial, box, settings, tell):
    """SciPy's differential evolution, as many trials as the swarm has; the best of each step."""
    optimize = need("scipy.optimize")
    way = []

    def generation(intermediate_result):
        way.append(float(intermediate_result.fun))
        tell(len(way) / settings.generations)

    first = np.random.default_rng(SEED).uniform(*box, (settings.particles, 3))
    found = optimize.differential_evolution(
        lambda at: robust_score(trial, at.T), np.transpose(box), init=first,
        maxiter=settings.generations, tol=0.0, atol=0.0, polish=False, updating="deferred",
        vectorized=True, seed=SEED, callback=generation,
    )  # fmt: skip
    return (found.x, float(found.fun)), way


def simplex(trial, box, tell):
    """SciPy's Nelder and Mead, one law at a time; the best, and how many were tried."""
    optimize = need("scipy.optimize")
    tried = []

    def score(at):
        tried.append(at)
        tell(min(1.0, len(tried) / SIMPLEX))
        return float(robust_score(trial, at[None])[0])

    found = optimize.minimize(
        score, np.mean(box, axis=0), method="Nelder-Mead", bounds=np.transpose(box),
        options={"maxfev": SIMPLEX, "xatol": 1e-3, "fatol": 0.0},
    )  # fmt: skip
    return (found.x, float(found.fun)), len(tried)
