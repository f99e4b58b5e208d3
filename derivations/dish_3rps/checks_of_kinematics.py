"""Poses, rates and Jacobians against NumPy, SciPy and complex steps; statuses; rods to pose."""

import numpy as np

from armillary import Status
from armillary.verify.engines import need
from armillary.verify.measured import compare
from armillary.verify.points import chosen

from .reference import (
    dish,
    facet,
    hinge_axes,
    lengths,
    rate,
    rods,
    shortest,
    times,
    vee,
)

COUNT = 1000
STEEP = np.radians(80.0)
AWKWARD = np.array([0.0, np.pi / 2, np.pi, -np.pi / 2, 1e-9, 999.0])
SIZES = ("f", "d", "r_b", "r_m", "z_O", "phi")


def attitudes(seed, count=COUNT, most=1.4):
    """Dishes, facets and attitudes at random; a tenth of them level, some at whole quarters."""
    random = np.random.default_rng(seed)
    points = {
        "alpha": random.uniform(-np.pi, np.pi, count), "beta": random.uniform(0.0, most, count),
        "f": random.uniform(0.5, 5.0, count), "d": random.uniform(0.1, 2.0, count),
        "r_b": random.uniform(0.05, 1.0, count), "r_m": random.uniform(0.2, 1.0, count),
        "z_O": random.uniform(3.0, 6.0, count), "phi": random.uniform(-7.0, 7.0, count),
    }  # fmt: skip
    points["beta"][::10] = 0.0
    points["phi"][::7] = random.choice(AWKWARD, len(points["phi"][::7]))
    points["alpha"][::9] = random.choice(AWKWARD, len(points["alpha"][::9]))
    return points


def moving(seed):
    """Attitudes, and how fast they change."""
    random = np.random.default_rng(seed)
    rates = {name: random.uniform(-1, 1, COUNT) for name in ("alpha_dot", "beta_dot", "z_dot")}
    points = attitudes(seed + 1)
    speeds = dict(zip(("alpha", "beta", "z_O"), rates.values(), strict=True))
    return points, rates, speeds


def planes_of_the_hinges(kernels):
    """Each S-joint is in the plane of its hinge, and the facet is as it was asked for."""
    points = attitudes(81)
    found = kernels.facet(**points)
    along, _ = rods(found.H_R_M, found.M, **points)
    residual = np.sum(along * hinge_axes(points["phi"]), axis=-1)
    yield compare(
        "S-joints out of the planes of their hinges, over the rods' lengths", "NumPy",
        residual / np.linalg.norm(along, axis=-1), 0.0, 1e-13, points, "facet", relative=False,
    )  # fmt: skip
    R, M = facet(**points)
    for what, got, wanted in (("H_R_M", found.H_R_M, R), ("M", found.M, M)):
        yield compare(
            f"{what} from two of the planes and the shortest turn", "NumPy", got, wanted, 1e-13,
            points, "facet",
        )  # fmt: skip
    yield compare(
        "the facet's axes are square and right-handed", "NumPy",
        np.swapaxes(found.H_R_M, 1, 2) @ found.H_R_M, np.eye(3), 1e-14, points, "facet",
    )  # fmt: skip
    yield compare(
        "rods from S-joint to hinge", "NumPy", kernels.rod_lengths(**points).l,
        np.linalg.norm(along, axis=-1), 1e-14, points, "rod_lengths",
    )  # fmt: skip


def pose_by_scipy(kernels):
    """SciPy looks for torsion, x and y that satisfy all three planes, and ends at the kernel's."""
    root = need("scipy.optimize").root
    points = attitudes(82, 60)
    found = kernels.facet(**points)
    normal, height = found.H_R_M[:, :, 2], found.M[:, 2]

    def searched(k):
        one = {name: np.atleast_1d(value[k]) for name, value in points.items()}

        def pose(x):
            spin = np.array([[np.cos(x[0]), -np.sin(x[0])], [np.sin(x[0]), np.cos(x[0])]])
            turned = shortest(normal[k]) @ np.pad(spin, (0, 1))
            turned[:, 2] = normal[k]
            return turned[None], np.array([[x[1], x[2], height[k]]])

        def off(x):
            along, _ = rods(*pose(x), **one)
            return np.sum(along * hinge_axes(one["phi"]), axis=-1)[0]

        out = one["d"][0] * np.array([np.cos(one["phi"][0]), np.sin(one["phi"][0])])
        answer = root(off, [one["phi"][0] - np.pi + 0.1, *out], tol=1e-14)
        return [part[0] for part in pose(answer.x)]

    poses = [searched(k) for k in range(60)]
    for what, place in (("H_R_M", 0), ("M", 1)):
        yield compare(
            f"{what} that all three hinges permit", "SciPy", getattr(found, what),
            np.array([pose[place] for pose in poses]), 1e-11, points, "facet",
        )  # fmt: skip


def rates_by_complex_steps(kernels):
    """Everything that moves, by complex steps through NumPy's model."""
    points, rates, speeds = moving(83)
    both = {**points, **rates}
    yield compare(
        "rates of the rods", "complex step", kernels.rod_rates(**both).l_dot,
        rate(lengths, points, speeds), 1e-11, both, "rod_rates",
    )  # fmt: skip
    found = kernels.facet_rates(**both)
    at = kernels.facet(**points).H_R_M
    velocity = rate(lambda p: facet(**p)[1], points, speeds)
    spin = vee(rate(lambda p: facet(**p)[0], points, speeds) @ np.swapaxes(at, 1, 2))
    for what, wanted in (("M_dot", velocity), ("Omega", spin)):
        yield compare(
            f"{what} of the facet", "complex step", getattr(found, what), wanted, 1e-11, both,
            "facet_rates",
        )  # fmt: skip
    J_B = kernels.jacobian_b(**points).J_B
    three = np.stack([rates[name] for name in ("alpha_dot", "beta_dot", "z_dot")], axis=-1)
    yield compare(
        "J_B times the rates", "complex step", times(J_B, three),
        np.concatenate([velocity, spin], axis=1), 1e-11, both, "jacobian_b",
    )  # fmt: skip


def jacobians_of_the_rods(kernels):
    """Rows of force along the rod, along the hinge and across the rod, from the pose alone."""
    points, rates, speeds = moving(84)
    both = {**points, **rates}
    R, M = facet(**points)
    along, arms = rods(R, M, **points)
    size = np.linalg.norm(along, axis=-1)[..., None]
    hinges = hinge_axes(points["phi"])
    across = np.cross(hinges, along / size)
    rows = [
        np.concatenate([way, np.cross(arms, way)], axis=-1)
        for way in (along / size, hinges, across)
    ]
    for what, kernel, wanted in (
        ("J_A", "jacobian_a", rows[0]),
        ("J", "jacobian_full", np.concatenate(rows[:2], axis=1)),
        ("J_P", "jacobian_passive", rows[2] / size),
    ):
        yield compare(
            f"{what} by the S-joints' places", "NumPy",
            getattr(getattr(kernels, kernel)(**points), what), wanted, 1e-13, points, kernel,
        )  # fmt: skip
    twist = times(
        kernels.jacobian_b(**points).J_B,
        np.stack([rates[name] for name in ("alpha_dot", "beta_dot", "z_dot")], axis=-1),
    )
    full = times(kernels.jacobian_full(**points).J, twist)
    wanted = np.concatenate([rate(lengths, points, speeds), np.zeros((COUNT, 3))], axis=1)
    yield compare(
        "the whole Jacobian times the facet's twist: rates of rods, and no way out of the planes",
        "complex step", full, wanted, 1e-11, both, "jacobian_full",
    )  # fmt: skip


def joints_by_numpy(kernels):
    """Angles of hinges and S-joints, and how fast the hinges turn."""
    points, rates, speeds = moving(85)
    both = {**points, **rates}

    def tangents(p):
        R, M = facet(**p)
        along, _ = rods(R, M, **p)
        out = -np.cross(np.array([0.0, 0.0, 1.0]), hinge_axes(p["phi"]))  # z x (z x u) = -u
        return np.sum(along * out, axis=-1), along[..., 2]

    outward, up = tangents(points)
    yield compare(
        "angles of the hinges", "NumPy", kernels.revolute_angles(**points).p_R,
        np.arctan2(outward, up), 1e-13, points, "revolute_angles",
    )  # fmt: skip
    slopes = [rate(lambda p, k=k: tangents(p)[k], points, speeds) for k in (0, 1)]
    yield compare(
        "rates of the hinges", "complex step", kernels.passive_rates(**both).p_R_dot,
        (up * slopes[0] - outward * slopes[1]) / (outward**2 + up**2), 1e-11, both, "passive_rates",
    )  # fmt: skip
    R, M = facet(**points)
    along, _ = rods(R, M, **points)
    normal = R[:, None, :, 2]
    wanted = np.arctan2(
        np.linalg.norm(np.cross(along, normal), axis=-1), np.sum(along * normal, axis=-1)
    )
    yield compare(
        "angles of the S-joints", "NumPy", kernels.joint_angles(**points).s, wanted, 1e-13, points,
        "joint_angles",
    )  # fmt: skip


def forces_by_balance(kernels):
    """All six forces at the S-joints, of rods and hinges, balance the load."""
    random = np.random.default_rng(86)
    points = attitudes(87)
    load = {
        "mass": random.uniform(0.0, 100.0, COUNT), "centre": random.uniform(-0.3, 0.3, (COUNT, 3)),
        "f_d": random.uniform(-500, 500, (COUNT, 3)), "n_d": random.uniform(-200, 200, (COUNT, 3)),
    }  # fmt: skip
    R, M = facet(**points)
    along, arms = rods(R, M, **points)
    ways = np.concatenate(
        [along / np.linalg.norm(along, axis=-1)[..., None], hinge_axes(points["phi"])], axis=1
    )
    moments = np.cross(np.concatenate([arms, arms], axis=1), ways)
    weight = -9.81 * load["mass"][:, None] * np.array([0.0, 0.0, 1.0])
    pushed = load["f_d"] + weight
    turned = load["n_d"] + np.cross(times(R, load["centre"]), weight)
    balance = np.swapaxes(np.concatenate([ways, moments], axis=-1), 1, 2)
    wanted = np.linalg.solve(balance, -np.concatenate([pushed, turned], axis=1)[..., None])
    given = {**points, **load}
    # Near a singular pose rounding grows with the condition of the balance.
    condition = np.linalg.cond(balance)
    yield compare(
        "forces of the rods, over the condition of the balance", "NumPy",
        (kernels.static_forces(**given, g=9.81).F - wanted[:, :3, 0])
        / (condition * np.abs(wanted).max(axis=(1, 2)))[:, None],
        0.0, 1e-13, given, "static_forces", relative=False,
    )  # fmt: skip


# -- rods to pose ---------------------------------------------------------------------------------


def forward_inverts(kernels):
    """From a guess that is off by 0.1 rad and 0.2 m, the rods lead back to the pose.

    Facets on edge are left out: at about 86 degrees two poses of the same rods meet.
    """
    random = np.random.default_rng(88)
    points = attitudes(89, most=1.2)
    points["r_b"] = points["r_m"] * random.uniform(0.3, 0.8, COUNT)
    points = chosen(points, kernels.facet(**points).H_R_M[:, 2, 2] > np.cos(STEEP))
    wanted, lengths_ = kernels.facet(**points), kernels.rod_lengths(**points).l
    off = random.uniform(-1, 1, (len(lengths_), 3)) * [0.1, 0.1, 0.2]
    guess = np.stack([points["alpha"], points["beta"], points["z_O"]], axis=-1) + off
    sizes = {name: points[name] for name in SIZES}
    found = kernels.forward(l=lengths_, guess=guess, **sizes)
    given = {**points, "guess": guess}
    yield compare("the search ends", "round trip", found.status, Status.OK, 0.0, given, "forward")
    for what in ("H_R_M", "M"):
        yield compare(
            f"{what}, rods, {what}", "round trip", getattr(found, what), getattr(wanted, what),
            1e-12, given, "forward",
        )  # fmt: skip
    # Two joints of the facet are no further apart than their distance, r_m times the root of 3.
    apart = lengths_ + 3 * points["r_m"][:, None] * np.array([1.0, -1.0, 0.0])
    told = kernels.forward(l=np.abs(apart), guess=guess, **sizes).status
    yield compare(
        "rods that no facet joins are refused", "geometry", told, Status.NOT_CONVERGED, 0.0, given,
        "forward",
    )  # fmt: skip


# -- statuses -------------------------------------------------------------------------------------


def aim_by_scipy(kernels):
    """The dish that is aimed has its axis on the sun; overhead the azimuth is 0."""
    random = np.random.default_rng(90)
    enu = random.normal(size=(COUNT, 3))
    enu /= np.linalg.norm(enu, axis=1, keepdims=True)
    found = kernels.aim(enu=enu)
    euler = need("scipy.spatial.transform").Rotation.from_euler
    turned = euler("ZYZ", np.stack([found.alpha, found.beta, -found.alpha], axis=1)).as_matrix()
    yield compare(
        "the dish's axis is on the sun", "SciPy", turned[:, :, 2], enu, 1e-14, {"enu": enu}, "aim"
    )
    yield compare(
        "the dish of the other checks is the same", "SciPy", dish(found.alpha, found.beta), turned,
        1e-14, {"enu": enu}, "aim",
    )  # fmt: skip
    turn = random.uniform(-np.pi, np.pi, 40)
    off = np.repeat([0.0, 1e-9, 0.9e-6, 1.1e-6], 10)
    near = np.stack([off * np.cos(turn), off * np.sin(turn), np.ones(40)], axis=1)
    near[::2, 2] = -1.0
    found = kernels.aim(enu=near)
    free = off < 1e-6
    for what, got, wanted in (
        ("the azimuth is free within 1e-6 of the vertical, and nowhere else", found.status,
         np.where(free, Status.SINGULAR, Status.OK)),
        ("a free azimuth is 0", np.where(free, found.alpha, 0.0), 0.0),
    ):  # fmt: skip
        yield compare(what, "geometry", got, wanted, 0.0, {"enu": near}, "aim")


def facets_face_down(kernels):
    """Face down there is no tilt to speak of; a thousandth of a radian away there is."""
    points = attitudes(91, 60)
    # Leaning along its own azimuth by a half turn and the slope of the dish.
    points["alpha"] = points["phi"]
    slope = np.arctan2(points["d"], 2 * points["f"])
    off = np.repeat([0.0, 1.3e-3, 1.5e-3], 20)  # 1 + n_z is half the square of it
    points["beta"] = np.pi + slope + off * np.tile([1, -1], 30)
    wanted = np.where(off < 1.4e-3, Status.UNREACHABLE, Status.OK)
    for kernel in ("facet", "rod_lengths", "jacobian_b", "central_ray"):
        yield compare(
            "a facet that hangs face down is told", "geometry",
            getattr(kernels, kernel)(**points).status, wanted, 0.0, points, kernel,
        )  # fmt: skip


def rods_that_hold_nothing(kernels):
    """A facet of no size is not held; a rod of no length has no direction."""
    points = attitudes(92, 60)
    load = {"mass": 30.0, "centre": np.zeros(3), "f_d": np.ones(3), "n_d": np.ones(3), "g": 9.81}
    point = {**points, "r_m": np.zeros(60)}
    found = kernels.static_forces(**point, **load)
    yield compare(
        "a facet on one point is not held", "geometry", found.status, Status.SINGULAR, 0.0, point,
        "static_forces",
    )  # fmt: skip
    yield compare("and its rods are given no force", "geometry", found.F, 0.0, 0.0, point)
    # Level, at the height 0, and as wide above as below: rods of length 0.
    flat = {**points, "beta": np.zeros(60), "r_b": points["r_m"]}
    flat["f"] = flat["f"] + flat["d"]
    flat["z_O"] = np.zeros(60)
    flat["d"] = np.zeros(60)
    for kernel in ("jacobian_a", "jacobian_full", "jacobian_passive", "joint_angles"):
        yield compare(
            "rods of no length are told", "geometry", getattr(kernels, kernel)(**flat).status,
            Status.UNREACHABLE, 0.0, flat, kernel,
        )  # fmt: skip


def planes_of_an_aimed_facet(kernels):
    """A facet that aims at the receiver keeps to its hinges too, on rods as long as is said."""
    points = attitudes(93, most=1.2)
    points["d"] = np.minimum(points["d"], points["f"])
    found = kernels.aim_at_receiver(**points)
    along, _ = rods(found.H_R_M, found.M, **points)
    length = np.linalg.norm(along, axis=-1)
    yield compare("the search ends", "bounds", found.status, Status.OK, 0.0, points)
    yield compare(
        "S-joints out of the planes of their hinges, over the rods' lengths", "NumPy",
        np.sum(along * hinge_axes(points["phi"]), axis=-1) / length, 0.0, 1e-13, points,
        "aim_at_receiver", relative=False,
    )  # fmt: skip
    yield compare(
        "rods from S-joint to hinge", "NumPy", found.l, length, 1e-13, points, "aim_at_receiver"
    )
