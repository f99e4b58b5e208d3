"""Acceleration, reactions, friction and pressure against other models of the same trough."""

import inspect

import numpy as np

from armillary import Status
from armillary.verify.engines import need
from armillary.verify.measured import compare
from armillary.verify.points import chosen

from .euler_lagrange import equations
from .parcels import bearings, bends, demand, offsets, state, sums, tube
from .samples import awkward, call, fast, joined, rows


def by_euler_lagrange(kernels):
    """The moment equation without friction, and the pressure with it and without."""
    free, pressure = equations()
    points = {**joined(fast(1), awkward())}
    smooth = {**points, "mu": 0 * points["mu"]}
    wanted = np.array([free(row) for row in rows(smooth)])
    alpha = call(kernels.acceleration, smooth).alpha
    yield compare(
        "acceleration without friction", "SymPy's Euler-Lagrange", alpha, wanted, 1e-13, smooth,
        "acceleration",
    )  # fmt: skip
    for what, at in (("without friction", smooth), ("with friction", points)):
        alpha = call(kernels.acceleration, at).alpha
        moving = chosen({**at, "alpha": alpha}, np.isfinite(alpha))
        yield compare(
            f"pressure of the pump {what}", "SymPy's Euler-Lagrange",
            call(kernels.pump_pressure, moving).pressure,
            np.array([pressure(row) for row in rows(moving)]), 1e-13, moving, "pump_pressure",
        )  # fmt: skip


def whole(seed, count=60, **changed):
    """Motions of troughs whose tube is a real one, with the moments of its shape."""
    points = fast(seed, count)
    points["sag"] = np.random.default_rng(seed).uniform(0.05, 0.3, count)
    points.update({name: np.full(count, value) for name, value in changed.items()})
    tubes = [tube(row) for row in rows(points)]
    return {**points, **{name: np.array([one[name] for one in tubes]) for name in tubes[0]}}


def free_acceleration(row):
    """The acceleration at which the parcels need no moment about the axis from outside."""
    still, moved = (demand(row, alpha).moment[2] for alpha in (0.0, 1.0))
    return -still / (moved - still)


def by_parcels(kernels):
    """Energy, acceleration, reactions, friction and pressure from sums over parcels."""
    points = whole(2)
    energy = call(kernels.energy, points)
    found = [sums(row, *state(row)) for row in rows(points)]
    for name, wanted in (("T", [f.kinetic for f in found]), ("V", [f.potential for f in found])):
        yield compare(
            f"energy {name}", "parcels", getattr(energy, name), wanted, 1e-12, points, "energy"
        )
    smooth = {**points, "mu": 0 * points["mu"]}
    yield compare(
        "acceleration without friction", "parcels", call(kernels.acceleration, smooth).alpha,
        [free_acceleration(row) for row in rows(smooth)], 1e-10, smooth, "acceleration",
    )  # fmt: skip
    yield from _with_friction(kernels, points)
    yield from _with_friction(kernels, whole(3, omega=0.0))


def _with_friction(kernels, points):
    """Forces, moments and power at the acceleration that friction leaves."""
    alpha = call(kernels.acceleration, points).alpha
    needs = [demand(row, a) for row, a in zip(rows(points), alpha, strict=True)]
    friction, forces = call(kernels.friction, points), call(kernels.reactions, points)
    yield compare(
        "moment about the axis is that of friction", "parcels", friction.M_F,
        [n.moment[2] for n in needs], 1e-10, points, "friction",
    )  # fmt: skip
    pairs = [bearings(row, n.force, n.moment) for row, n in zip(rows(points), needs, strict=True)]
    for k, name in enumerate(("F_A", "F_B")):
        yield compare(
            f"{name} from forces and moments in three dimensions", "parcels",
            getattr(forces, name).reshape(-1, 2), [pair[k] for pair in pairs], 1e-10, points,
            "reactions",
        )  # fmt: skip
    told = call(kernels.power, points)
    booked = [
        n.power - n.moment[2] * row["omega"] for n, row in zip(needs, rows(points), strict=True)
    ]
    yield compare("power of the pump", "parcels", told.pump, booked, 1e-9, points, "power")
    yield compare(
        "heat of the bearings", "friction", told.heat, -friction.M_F * points["omega"], 1e-13,
        points, "power",
    )  # fmt: skip
    power = [n.power for n in needs] - friction.M_F * points["omega"]
    yield compare(
        "pressure from the balance of power", "parcels",
        call(kernels.pump_pressure, points).pressure, power / points["q"], 1e-9, points,
        "pump_pressure",
    )  # fmt: skip


# -- three dimensions ---------------------------------------------------------------------------


def off_the_plane(kernels):
    """Containers, tube and trough off the middle plane: force along z, moment, and the split."""
    random = np.random.default_rng(9)
    points = fast(9, 60)
    aside = {name: random.uniform(-0.4, 0.4, 60) for name in ("z_1", "z_2", "z_M", "lean")}
    points.update(aside, sag=random.uniform(0.05, 0.3, 60))
    found = [{**tube(row), **offsets(row)} for row in rows(points)]
    points.update({name: np.array([one[name] for one in found]) for name in found[0]})
    points["alpha"] = random.uniform(-3.0, 3.0, 60)
    needs = [demand(row, row["alpha"]) for row in rows(points)]
    told = call(kernels.reactions_off, points)
    yield compare(
        "force along the axis, trough without symmetry", "parcels", told.F_z,
        [n.force[2] for n in needs], 1e-9, points, "reactions_off",
    )  # fmt: skip
    c, s = np.cos(points["theta"]), np.sin(points["theta"])
    x, y, z = np.array([n.moment for n in needs]).T
    yield compare(
        "moment about O, trough without symmetry", "parcels", told.M_O.reshape(-1, 3),
        np.stack([c * x + s * y, c * y - s * x, z], axis=-1), 1e-10, points, "reactions_off",
    )  # fmt: skip
    pairs = [bearings(row, n.force, n.moment) for row, n in zip(rows(points), needs, strict=True)]
    for k, name in enumerate(("F_A", "F_B")):
        force = np.array([pair[k] for pair in pairs])
        yield compare(
            f"{name} without symmetry", "parcels", getattr(told, name).reshape(-1, 2), force, 1e-10,
            points, "reactions_off",
        )  # fmt: skip
    both = told.F_A.reshape(-1, 2) + told.F_B.reshape(-1, 2)
    share = points["r_B"] / (points["r_A"] + points["r_B"])
    miss = np.linalg.norm(told.F_A.reshape(-1, 2) - share[:, None] * both, axis=1)
    yield compare(
        "without symmetry the distances alone do not tell the split", "reactions_off",
        np.median(miss / np.linalg.norm(both, axis=1)) > 0.01, 1.0, 0.0, {"motions": 60},
        "reactions_off",
    )  # fmt: skip
    nothing = dict.fromkeys(("z_1", "z_2", "S_z", "D_xi", "D_eta", "G_xi", "G_eta"), np.zeros(60))
    plain = {**points, **nothing}
    plain["alpha"] = call(kernels.acceleration, plain).alpha
    told, forces = call(kernels.reactions_off, plain), call(kernels.reactions, plain)
    for name in ("F_A", "F_B"):
        yield compare(
            f"{name} of the symmetric trough", "reactions", getattr(told, name),
            getattr(forces, name), 1e-12, plain, "reactions_off",
        )  # fmt: skip


def tube_of_parts(kernels):
    """Length, mass and moments of the tube's straight parts add up to those of its parcels."""
    points = whole(10)
    corners = np.array([bends(row) for row in rows(points)])
    told = kernels.tube_part(
        xi_a=corners[:, :-1, 0], eta_a=corners[:, :-1, 1], xi_b=corners[:, 1:, 0],
        eta_b=corners[:, 1:, 1],
        **{n: points[n][:, None] for n in inspect.signature(kernels.tube_part).parameters
           if n in points},
    )  # fmt: skip
    names = ("L_t", "m_t", "S_t_xi", "S_t_eta", "I_t", "Gamma_t")
    for name, field in zip(names, told._fields, strict=False):
        yield compare(
            f"{name} from straight parts", "parcels", getattr(told, field).sum(axis=1),
            points[name], 1e-12, points, "tube_part", relative=False,
        )  # fmt: skip


# -- friction -------------------------------------------------------------------------------------


def friction_by_root(kernels):
    """The closed form against a search for the acceleration that friction and force agree on."""
    points = whole(4)
    wanted = [_root(row, np.sign(row["omega"])) for row in rows(points)]
    yield compare(
        "acceleration with dry friction", "SciPy's root", call(kernels.acceleration, points).alpha,
        wanted, 1e-11, points, "acceleration",
    )  # fmt: skip
    parts = points["omega"] / np.hypot(points["omega"], points["omega_s"])
    slow = {**points, "omega": points["omega_s"] * np.linspace(-3.0, 3.0, len(parts))}
    parts = slow["omega"] / np.hypot(slow["omega"], slow["omega_s"])
    yield compare(
        "acceleration with smooth friction", "SciPy's root",
        call(kernels.acceleration_smooth, slow).alpha,
        [_root(row, part) for row, part in zip(rows(slow), parts, strict=True)], 1e-11, slow,
        "acceleration_smooth",
    )  # fmt: skip
    heavy = {**points, "mu": 6.0 + 0 * points["mu"]}
    forces, moments = call(kernels.reactions, heavy), call(kernels.friction, heavy)
    turns = heavy["mu"] * heavy["r_f"] / 2 * -np.sign(heavy["omega"])
    good = np.isfinite(moments.M_F)
    heavy = chosen(heavy, good)
    for letter in "AB":
        size = np.linalg.norm(getattr(forces, f"F_{letter}").reshape(-1, 2), axis=1)
        yield compare(
            f"M_F{letter} is mu r_f/2 |F_{letter}| against the motion", "NumPy",
            getattr(moments, f"M_F{letter}")[good], (turns * size)[good], 1e-12, heavy, "friction",
        )  # fmt: skip
    yield compare(
        "M_FA and M_FB make M_F", "NumPy", (moments.M_FA + moments.M_FB)[good], moments.M_F[good],
        1e-13, heavy, "friction",
    )  # fmt: skip


def friction_near_jamming(kernels):
    """Close to where the bearings jam the one acceleration is still found; beyond it is refused."""
    points = whole(8)
    reach = [np.linalg.norm(sums(row, *state(row)).first[:2]) for row in rows(points)]
    inertia = [demand(row, 1.0).moment[2] - demand(row, 0.0).moment[2] for row in rows(points)]
    points["mu"] = np.full(60, 8.0)
    widest = 2 * np.array(inertia) / np.array(reach) / points["mu"]
    near = {**points, "r_f": 0.99 * widest}
    yield compare(
        "acceleration with bearings that almost jam", "SciPy's root",
        call(kernels.acceleration, near).alpha,
        [_root(row, np.sign(row["omega"])) for row in rows(near)], 1e-10, near, "acceleration",
    )  # fmt: skip
    for part, status in ((0.9994, Status.OK), (0.9996, Status.UNREACHABLE)):
        at = {**points, "r_f": part * widest}  # what the derivation states: 1e-3 of the square
        yield compare(
            "where bearings count as jammed", "parcels", call(kernels.acceleration, at).status,
            status, 0.0, at, "acceleration",
        )  # fmt: skip


def _root(row, part):
    """Where the parcels' moment is a part of k |F|, against the motion; k = mu r_f / 2."""
    arm = row["mu"] * row["r_f"] / 2

    def excess(alpha):
        need_of = demand(row, alpha)
        return need_of.moment[2] + part * arm * np.linalg.norm(need_of.force[:2])

    middle = free_acceleration(row)
    wide = 1.0
    while excess(middle - wide) * excess(middle + wide) > 0:
        wide *= 2.0
    return need("scipy.optimize").brentq(
        excess, middle - wide, middle + wide, xtol=1e-13, rtol=1e-14
    )


def sticks_up_to_its_limit(kernels):
    """At rest friction holds up to k |F| and no further, in either sense."""
    points = whole(6, omega=0.0)
    needs = [demand(row, 0.0) for row in rows(points)]
    moment = np.array([n.moment[2] for n in needs])  # what friction has to give
    force = np.array([np.linalg.norm(n.force[:2]) for n in needs])
    limit = 2 * np.abs(moment) / (force * points["r_f"])  # of mu
    for part, status, what in (
        (1 + 1e-9, Status.STICKING, "held just inside the limit of friction"),
        (1 - 1e-9, Status.OK, "not held just outside it"),
    ):
        at = {**points, "mu": limit * part}
        able = at["mu"] < 10.0
        at = chosen(at, able)
        found = call(kernels.acceleration, at)
        legal = found.status >= 0
        if status == Status.STICKING:
            yield compare(what, "parcels", found.alpha[legal], 0.0, 0.0, at, "acceleration")
            held = call(kernels.friction, at).M_F[legal]
            yield compare(
                "and friction is what the parcels need", "parcels", held, moment[able][legal],
                1e-10, chosen(at, legal), "friction",
            )  # fmt: skip
        else:
            sense = np.sign(found.alpha[legal])
            yield compare(
                "it sets off where it is driven", "parcels", sense, -np.sign(moment[able][legal]),
                0.0, chosen(at, legal), "acceleration",
            )  # fmt: skip
        yield compare(what, "parcels", found.status[legal], status, 0.0, at, "acceleration")


# -- what is refused ------------------------------------------------------------------------------


def refused_and_told(kernels):
    """Levels outside their box, empty containers, jammed bearings, and values without meaning."""
    base = whole(7, 12)
    spill = {
        "overflow of 1": base["A_1"] * (base["h_max"] - base["h_10"]) + 1e-9,
        "overflow of 2": -base["A_2"] * (base["h_max"] - base["h_20"]) - 1e-9,
        "less than nothing in 2": base["A_2"] * base["h_20"] + 1e-9,
        "less than nothing in 1": -base["A_1"] * base["h_10"] - 1e-9,
    }
    for what, s in spill.items():
        yield from _status(kernels, {**base, "s": s}, Status.UNREACHABLE, what)
    sizes = {"A_1": 0.125, "A_2": 0.0625, "h_20": 0.125, "s": 0.0625 * 0.125}  # exact in floats
    empty = {**base, **{name: np.full(12, value) for name, value in sizes.items()}}
    yield from _status(kernels, empty, Status.LIMIT, "container 2 is empty")
    for name in ("A_1", "A_2", "rho", "a_t", "h_max", "m_t", "M", "r_f", "mu"):
        yield from _status(
            kernels, {**base, name: -np.abs(base[name])}, Status.OUT_OF_RANGE, f"negative {name}",
            ("acceleration",) if name != "a_t" else ("energy",),
        )  # fmt: skip
    contradictions = {
        "less inertia than the mass at its centre": {"I_zz": 0.99 * base["M"] * base["l"] ** 2},
        "a tube of more water than it holds": {"m_t": 1.01 * base["m_t"]},
        "a tube of less water than it holds": {"m_t": 0.99 * base["m_t"]},
        "a flow of more momentum than its energy allows": {"Gamma_t": 1e4 + 0 * base["s"]},
    }
    for what, changed in contradictions.items():
        names = WATERY[1:] if "tube" in what else WATERY[1:8]
        yield from _status(kernels, {**base, **changed}, Status.UNREACHABLE, what, names)
    yield from _status(
        kernels, {**base, "theta": 0 * base["s"] + np.nan}, Status.NOT_FINITE, "no angle",
        ("acceleration", "reactions"),
    )  # fmt: skip
    jam = {
        **base,
        "mu": 10.0 + 0 * base["s"],
        "r_f": 50.0 + 0 * base["s"],
        "omega": 1 + 0 * base["s"],
    }
    yield from _status(
        kernels, jam, Status.UNREACHABLE, "bearings wider than the trough jam",
        ("acceleration", "friction", "reactions", "pump_pressure", "acceleration_smooth"),
    )  # fmt: skip


WATERY = (
    "levels", "energy", "acceleration", "acceleration_smooth", "friction", "reactions",
    "pump_pressure", "power", "rest_angle", "rest", "linear", "stick_band",
)  # fmt: skip


def _status(kernels, points, status, what, names=WATERY):
    """Each kernel answers with a status; refused, it gives no number."""
    for name in names:
        found = call(getattr(kernels, name), points)
        yield compare(what, "geometry", found.status, status, 0.0, points, name)
        numbers = np.isfinite(np.column_stack([
            np.reshape(getattr(found, field), (len(points["s"]), -1))
            for field in found._fields if field != "status"
        ]))  # fmt: skip
        yield compare(
            f"{what}: {'finite' if status >= 0 else 'no'} numbers", "geometry", numbers,
            float(status >= 0), 0.0, points, name,
        )  # fmt: skip
