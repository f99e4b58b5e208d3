"""The triples once more: as Euler angles in SciPy, and as joints in pinocchio."""

import numpy as np

from armillary.derivation.status import Status
from armillary.verify.engines import each, need
from armillary.verify.engines.rigid import Mechanism, Revolute
from armillary.verify.measured import compare
from armillary.verify.points import AWKWARD_ROTATIONS, rotations

COUNT = 400
ANGLES = ("a", "b", "c")
AXES = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1)}
# The order of the turns, and what the middle angle lies in.
TRIPLES = {
    "zxz": ("zxz", (0.0, np.pi)),
    "zyz": ("zyz", (0.0, np.pi)),
    "zyx": ("zyx", (-np.pi / 2, np.pi / 2)),
    "tilt_torsion": ("zyz", (0.0, np.pi)),
}
# Twice the distance from the singular set within which an angle is called free.
FREE = 2e-6


def checks(kernels):
    """Everything measured about the triples."""
    yield from each(
        kernels,
        attitudes_by_scipy,
        angles_by_scipy,
        round_trips,
        singular_attitudes,
        torsion_without_tilt,
        motion_by_pinocchio,
        rates_give_the_motion_back,
        singular_rates,
    )


def own(triple, angles):
    """Angles of the turns, as (n, 3): the third turn of tilt and torsion undoes the first."""
    a, b, c = (angles[name] for name in ANGLES)
    return np.stack([a, b, c - a if triple == "tilt_torsion" else c], axis=1)


def points(seed):
    """Random angles, well beyond a turn, and quarter turns."""
    random = np.random.default_rng(seed)
    found = random.uniform(-7, 7, (COUNT, 3))
    found[: COUNT // 4] = random.integers(-4, 5, (COUNT // 4, 3)) * np.pi / 2
    return dict(zip(ANGLES, found.T, strict=True))


def attitudes():
    """Random attitudes and awkward ones."""
    return np.concatenate([rotations(COUNT, np.random.default_rng(31)), AWKWARD_ROTATIONS])


def on_the_singular_set(triple):
    """Attitudes where the first and the third turn have one axis, exactly."""
    angles = np.linspace(-np.pi, np.pi, 37)
    c, s, o, i = np.cos(angles), np.sin(angles), np.zeros(37), np.ones(37)
    if triple == "zyx":
        up = [[o, -s, c], [o, c, s], [-i, o, o]]
        down = [[o, s, -c], [o, c, s], [i, o, o]]
    else:
        up = [[c, -s, o], [s, c, o], [o, o, i]]
        down = [[c, s, o], [s, -c, o], [o, o, -i]]
    return np.concatenate([np.moveaxis(np.array(m), 2, 0) for m in (up, down)])


def found_angles(kernels, triple, R):
    """What the kernel says, and its angles as keywords."""
    answer = getattr(kernels, f"angles_{triple}")(R=R)
    return answer, {name: np.asarray(getattr(answer, name)) for name in ANGLES}


def attitudes_by_scipy(kernels):
    """Each product of turns as Euler angles about the body's own axes."""
    rotation = need("scipy.spatial.transform").Rotation
    for triple, (order, _) in TRIPLES.items():
        angles = points(32)
        wanted = rotation.from_euler(order.upper(), own(triple, angles)).as_matrix()
        kernel = f"matrix_{triple}"
        found = getattr(kernels, kernel)(**angles).R
        yield compare(f"attitude by {triple}", "SciPy", found, wanted, 1e-14, angles, kernel)


def angles_by_scipy(kernels):
    """The angles of attitudes that are not singular, and the intervals they lie in."""
    rotation = need("scipy.spatial.transform").Rotation
    for triple, (order, (low, high)) in TRIPLES.items():
        R = rotations(COUNT, np.random.default_rng(33))
        _, angles = found_angles(kernels, triple, R)
        wanted = rotation.from_matrix(R).as_euler(order.upper())
        kernel = f"angles_{triple}"
        yield compare(
            f"angles of {triple}", "SciPy", own(triple, angles), wanted, 1e-12, {"R": R}, kernel,
            turn=True,
        )  # fmt: skip
        over = [np.maximum(low - angles["b"], angles["b"] - high)]
        over += [np.abs(angles[name]) - np.pi for name in ("a", "c")]
        beyond = np.maximum(np.max(over, axis=0), 0.0)
        yield compare(f"angles of {triple} lie in their intervals", "bounds", beyond, 0.0, 0.0,
                      {"R": R}, kernel)  # fmt: skip


def round_trips(kernels):
    """From an attitude to its angles and back, through every awkward attitude."""
    for triple in TRIPLES:
        R, kernel = attitudes(), f"angles_{triple}"
        answer, angles = found_angles(kernels, triple, R)
        back = np.asarray(getattr(kernels, f"matrix_{triple}")(**angles).R)
        regular = answer.status == Status.OK
        yield compare(
            f"matrix_{triple} of {kernel} is the attitude", "round trip",
            back[regular], R[regular], 1e-14, {"R": R[regular]}, kernel,
        )  # fmt: skip
        yield compare(
            f"where an angle of {triple} is free, within the tolerance of the singular set",
            "round trip", back[~regular], R[~regular], FREE, {"R": R[~regular]}, kernel,
        )  # fmt: skip


def singular_attitudes(kernels):
    """On the singular set itself the attitude comes back whole, with the first angle 0."""
    for triple in TRIPLES:
        R, kernel = on_the_singular_set(triple), f"angles_{triple}"
        answer, angles = found_angles(kernels, triple, R)
        back = getattr(kernels, f"matrix_{triple}")(**angles).R
        yield compare(
            f"{kernel} and back on the singular set", "round trip", back, R, 1e-14, {"R": R}, kernel
        )
        missed = (answer.status != Status.SINGULAR) | (angles["a"] != 0)
        yield compare(
            f"{kernel} says SINGULAR there, and its first angle is 0", "status", missed, 0.0, 0.0,
            {"R": R}, kernel,
        )  # fmt: skip


def torsion_without_tilt(kernels):
    """As the tilt goes to 0 its direction is lost; the torsion is not."""
    tilts = 10.0 ** np.linspace(-17, -1, 200)
    random = np.random.default_rng(34)
    a, c = random.uniform(-3, 3, (2, len(tilts)))
    R = kernels.matrix_tilt_torsion(a=a, b=tilts, c=c).R
    found = kernels.angles_tilt_torsion(R=R)
    yield compare(
        "the torsion keeps its digits as the tilt goes to 0", "round trip", found.c, c, 1e-14,
        {"a": a, "b": tilts, "c": c}, "angles_tilt_torsion", turn=True,
    )  # fmt: skip
    regular = found.status == Status.OK
    yield compare(
        "the tilt keeps its digits too", "round trip", found.b[regular] / tilts[regular], 1.0,
        1e-9, {"b": tilts[regular]}, "angles_tilt_torsion",
    )  # fmt: skip


def joints(order):
    """A wrist of three revolute joints."""
    return Mechanism([Revolute(AXES[axis]) for axis in order])


def moving(seed):
    """Random angles with random rates."""
    random = np.random.default_rng(seed)
    rates = {f"{name}_dot": random.uniform(-2, 2, COUNT) for name in ANGLES}
    return {**points(seed), **rates}


def own_rates(triple, given):
    """Rates of the turns, as (n, 3)."""
    return own(triple, {name: given[f"{name}_dot"] for name in ANGLES})


def motion_by_pinocchio(kernels):
    """Angular velocity of a wrist whose joints run."""
    for triple, (order, _) in TRIPLES.items():
        given, kernel = moving(35), f"velocity_{triple}"
        wanted = joints(order).velocity(own(triple, given), own_rates(triple, given))[:, 3:]
        found = getattr(kernels, kernel)(**given).Omega
        yield compare(
            f"angular velocity by {triple}", "pinocchio", found, wanted, 1e-14, given, kernel
        )


def rates_give_the_motion_back(kernels):
    """From an angular velocity to the rates of the angles, and back by pinocchio."""
    random = np.random.default_rng(36)
    for triple, (order, _) in TRIPLES.items():
        kernel, given = f"rates_{triple}", {**points(36), "Omega": random.normal(size=(COUNT, 3))}
        answer = getattr(kernels, kernel)(**given)
        regular = answer.status == Status.OK
        some = {name: value[regular] for name, value in given.items()}
        rates = {f"{n}_dot": np.asarray(getattr(answer, f"{n}_dot"))[regular] for n in ANGLES}
        back = joints(order).velocity(own(triple, some), own_rates(triple, rates))[:, 3:]
        # The rates grow without bound towards the singular set, and rounding with them.
        scale = np.maximum(np.abs(own_rates(triple, rates)).max(axis=1, keepdims=True), 1.0)
        yield compare(
            f"the rates of {triple} make the angular velocity", "pinocchio", back / scale,
            some["Omega"] / scale, 1e-14, some, kernel,
        )  # fmt: skip


def singular_rates(kernels):
    """At a singular attitude the part that can be had is had, with the first angle at rest."""
    random = np.random.default_rng(37)
    for triple, (order, _) in TRIPLES.items():
        turns = random.integers(-3, 4, 50) * np.pi + (np.pi / 2 if triple == "zyx" else 0.0)
        a, c = random.uniform(-3, 3, (2, 50))
        given = {"a": a, "b": turns, "c": c, "Omega": random.normal(size=(50, 3))}
        kernel = f"rates_{triple}"
        answer = getattr(kernels, kernel)(**given)
        missed = (answer.status != Status.SINGULAR) | (answer.a_dot != 0)
        yield compare(
            f"{kernel} says SINGULAR there, and its first angle rests", "status", missed, 0.0, 0.0,
            given, kernel,
        )  # fmt: skip
        wrist = joints(order)
        rates = {f"{n}_dot": np.asarray(getattr(answer, f"{n}_dot")) for n in ANGLES}
        back = wrist.velocity(own(triple, given), own_rates(triple, rates))[:, 3:]
        # What is left over stands square to the vertical and to the second axis.
        along = np.stack([wrist.jacobian(q)[3:, :2] for q in own(triple, given)])
        left_over = np.einsum("nij,ni->nj", along, given["Omega"] - back)
        yield compare(
            f"{kernel} there turns about the vertical and the second axis as asked", "pinocchio",
            left_over, 0.0, 1e-13, given, kernel,
        )  # fmt: skip
