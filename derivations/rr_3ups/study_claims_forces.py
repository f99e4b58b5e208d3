"""What the paper says of the forces (Fig. 6), judged."""

from .study_basis import clock_words, near
from .study_claims import ORDER, SIZE, Claim, exceptions, hanging, judged, listed, yes
from .study_forces import SAME, agree

NO_BOUND = "no bound"


def of_the_forces(facts, unknowns, open_, published):
    """Fig. 6."""
    yield largest(facts, open_, published)
    yield largest_of_two(facts, open_, published)
    both = facts["dawn"][1]
    yield Claim(
        ("4.5 W of both",), ORDER, "the same at dawn and dusk for both", "yes",
        f"{max(map(abs, both)):.2f} N for both" if agree(facts) else "not the same",
        judged(agree(facts)),
        "leg 3 has no lever there, whatever the masses"
        if facts["lever"] < SAME
        else f"leg 3 moves {1e3 * facts['lever']:.0f} mm a radian there",
    )  # fmt: skip
    yield means(facts, unknowns, open_, published)
    yield means_of_two(facts, open_, published)
    yield lower(facts, open_)


def largest(facts, open_, published):
    """The largest force of three drives."""
    peak, theirs = max(facts["peak"]), published.peak_force
    centre = open_.where(lambda one, _: near(one["largest"], theirs))
    verdict, why = hanging(
        near(peak, theirs), centre, lambda of: f"{of['drives'][0]['largest']:.1f} N"
    )
    return Claim(
        ("80 N",), SIZE, "Fig. 6: largest force, three drives", f"{theirs:g} N", f"{peak:.1f} N",
        verdict, why,
    )  # fmt: skip


def largest_of_two(facts, open_, published):
    """The largest force without leg 3."""
    peak, theirs = facts["peak_two"], published.peak_force
    centre = open_.where(lambda _, other: near(other["largest"], theirs), two=True)
    verdict, why = hanging(
        peak is not None and near(peak, theirs), centre,
        lambda of: f"{of['drives'][1]['largest']:.1f} N",
        unbounded(facts["zeros"], exceptions(open_.conditions)) if facts["zeros"] else "",
    )  # fmt: skip
    return Claim(
        ("80 N with two",), SIZE, "largest force, two drives", f"{theirs:g} N",
        NO_BOUND if peak is None else f"{peak:.1f} N", verdict, why,
    )  # fmt: skip


def unbounded(zeros, except_):
    """Why there is no largest force."""
    words = f"two drives do not hold the platform at {' and '.join(map(clock_words, zeros))}"
    return f"{words}; a bound for {except_}, and none beside it" if except_ else words


def means(facts, unknowns, open_, published):
    """The mean forces of three drives, with their peak."""
    ours, theirs = facts["mean"], published.mean_forces

    def fits(one, _=None):
        peak = near(one["largest"], published.peak_force)
        return peak and all_near(one["means"], theirs)

    verdict, why = hanging(
        fits({"largest": max(facts["peak"]), "means": ours}), open_.where(fits),
        lambda of: f"{listed(of['drives'][0]['means'], '.1f')} N",
        "no mass centre gives peak and means; the best misses one by "
        f"{unknowns['residual']:.1f} N",
    )  # fmt: skip
    return Claim(
        ("30 N",), SIZE, "mean forces, three drives, with that peak",
        f"{listed(theirs, 'g')} N", f"{listed(ours, '.1f')} N", verdict, why,
    )  # fmt: skip


def means_of_two(facts, open_, published):
    """The mean forces of two drives."""
    ours, theirs = facts["mean_two"], published.mean_forces_two
    centre = open_.where(lambda _, other: all_near(other["means"], theirs), two=True)
    verdict, why = hanging(
        ours is not None and all_near(ours, theirs), centre,
        lambda of: f"{listed(of['drives'][1]['means'], '.1f')} N",
        "the mean grows with the logarithm of the finest step" if ours is None else "",
    )  # fmt: skip
    return Claim(
        ("36 N",), SIZE, "mean forces, two drives", f"{listed(theirs, 'g')} N",
        NO_BOUND if ours is None else f"{listed(ours, '.1f')} N", verdict, why,
    )  # fmt: skip


def lower(facts, open_):
    """Which mechanism has the lower mean force."""
    ours, others = facts["mean"], facts["mean_two"]
    if others is None:
        words = f"{sum(ours) / 3:.1f} N against no bound"
        holds, verdict, why = True, judged(True), "by how much has no number"
    else:
        holds = sum(ours) / 3 < sum(others) / 2
        words = f"{sum(ours) / 3:.1f} against {sum(others) / 2:.1f} N"
        centre = open_.where(
            lambda one, other: sum(one["means"]) / 3 < sum(other["means"]) / 2, two=True
        )
        verdict, why = hanging(
            holds, centre,
            lambda of: " against ".join(f"{sum(one['means']) / len(one['means']):.1f} N"
                                        for one in of["drives"]),
        )  # fmt: skip
    return Claim(
        ("mean force lower",), ORDER, "mean force lower with three drives", "yes",
        f"{yes(holds)}, {words}", verdict, why,
    )  # fmt: skip


def all_near(ours, theirs):
    """Whether every figure is reproduced."""
    return all(near(a, b) for a, b in zip(ours, theirs, strict=True))
