"""The dish in MuJoCo: hinges, slides and ball joints, told nothing but lengths and masses.

A rod is a hinge on the ground (R), a slide (P) whose coordinate is the rod's length, and a ball
joint (S) at the facet. The facet hangs on its first rod; the ball joints of the second and the
third are closed by constraints. East, north and up are x, y and z.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from armillary.verify.engines import need

FACETS = 4
LEGS = 3
AZIMUTHS = np.radians([0.0, 90.0, 180.0, 270.0])  # of the facets: phi
JOINTS = np.radians([0.0, 120.0, -120.0])  # of a facet's legs, from the way to the dish's axis
IMPEDANCE = 0.9999  # of the constraints: they yield by about 1e-8 m
STIFFNESS = 2.0  # steps in which a constraint mends its error, the least that is stable
SLIGHT = 1e-3  # kg: MuJoCo refuses a moving body of no mass


@dataclass(frozen=True)
class Facet:
    """What hangs on three rods: mass in kg, centre of mass and moments of inertia about it.

    Both in the facet's axes; the moments are about its three axes, in kg m^2.
    """

    mass: float
    centre: tuple[float, float, float] = (0.0, 0.0, 0.0)
    inertia: tuple[float, float, float] = (1.0, 1.0, 2.0)


@dataclass(frozen=True)
class Rod:
    """A rod: its moving section and what drives it.

    Attributes:
        mass: of the moving section, kg; the other hangs on the ground and has none.
        length: of the moving section, m; it is a slender bar.
        screw: what the turning screw adds to the mass along the rod, kg.
        viscous: N s/m.
        coulomb: friction in N, sticking.
        lag: time constant of the force, s.
        limit: the largest force, N.
    """

    mass: float = 0.0
    length: float = 2.0
    screw: float = 0.0
    viscous: float = 0.0
    coulomb: float = 0.0
    lag: float = 0.0
    limit: float = 1e6


@dataclass(frozen=True)
class Machine:
    """A model of MuJoCo with its state, and where in them the joints of each facet are.

    Attributes:
        hinges: places of the hinges in `qpos`, in the order facet by facet, leg by leg.
        slides: likewise of the rods' lengths.
        balls: the first of four numbers of a ball joint in `qpos`, for each facet.
        bodies: the facets' bodies.
    """

    model: Any
    data: Any
    hinges: np.ndarray
    slides: np.ndarray
    balls: np.ndarray
    bodies: np.ndarray
    r_m: float

    @property
    def lengths(self) -> np.ndarray:
        """The rods' lengths, (4, 3)."""
        return self.data.qpos[self.slides].reshape(FACETS, LEGS)

    @property
    def origins(self) -> np.ndarray:
        """The points M, (4, 3)."""
        return self.data.xpos[self.bodies].copy()

    @property
    def attitudes(self) -> np.ndarray:
        """The matrices H_R_M, (4, 3, 3)."""
        return self.data.xmat[self.bodies].reshape(FACETS, 3, 3).copy()


def ring(radius, azimuths=JOINTS):
    """Points on a level circle, (n, 3)."""
    return radius * np.stack([np.cos(azimuths), np.sin(azimuths), np.zeros_like(azimuths)], -1)


def turn_z(angle):
    """The rotation about the vertical, (..., 3, 3)."""
    angle = np.asarray(angle, dtype=float)
    cos, sin, one, zero = np.cos(angle), np.sin(angle), np.ones_like(angle), np.zeros_like(angle)
    rows = [(cos, -sin, zero), (sin, cos, zero), (zero, zero, one)]
    return np.stack([np.stack(row, -1) for row in rows], -2)


def bases(shape):
    """Where the rods stand, (4, 3, 3), and their azimuths, (4, 3)."""
    azimuths = AZIMUTHS[:, None] - np.pi + JOINTS
    feet = ring(shape["d"], AZIMUTHS)[:, None] + ring(shape["r_b"], azimuths)
    return feet, azimuths


# -- building -------------------------------------------------------------------------------------


def build(shape, facet, rod, step=1e-3, gravity=9.81, held=False, weightless=False):
    """A machine of four facets.

    Args:
        shape: lengths d, r_b, r_m and z_O in m.
        step: time step in s.
        held: whether the rods are held at lengths that are given, not driven by forces.
        weightless: whether the rods, not the facets, are free of gravity.
    """
    mujoco = need("mujoco")
    spec = mujoco.MjSpec()
    spec.option.timestep = step
    spec.option.gravity = (0.0, 0.0, -gravity)
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    spec.option.tolerance = 1e-12
    spec.option.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT
    feet, azimuths = bases(shape)
    for k in range(FACETS):
        ends = [
            _rod(mujoco, spec, f"{k}{i}", feet[k, i], azimuths[k, i], shape, rod, weightless)
            for i in range(LEGS)
        ]
        _facet(mujoco, spec, k, ends[0], shape["r_m"], facet)
        for i in range(1, LEGS):
            closed = spec.add_equality(
                type=mujoco.mjtEq.mjEQ_CONNECT, objtype=mujoco.mjtObj.mjOBJ_SITE,
                name1=f"end{k}{i}", name2=f"ball{k}{i}",
            )  # fmt: skip
            _stiffen(closed, step)
        for i in range(LEGS):
            (_hold if held else _drive)(mujoco, spec, f"{k}{i}", rod)
    return _machine(mujoco, spec.compile(), shape["r_m"])


def _rod(mujoco, spec, name, foot, azimuth, shape, rod, weightless):
    """Hinge across the way to the axis, slide along the rod; the moving section's body."""
    level = float(np.hypot(shape["r_m"] - shape["r_b"], shape["z_O"]))
    turned = (np.cos(azimuth / 2), 0.0, 0.0, np.sin(azimuth / 2))
    tube = spec.worldbody.add_body(name=f"tube{name}", pos=foot, quat=turned)
    _weigh(tube, SLIGHT, (0.0, 0.0, 0.0), (SLIGHT,) * 3)
    tube.add_joint(name=f"R{name}", type=mujoco.mjtJoint.mjJNT_HINGE, axis=(0, 1, 0))
    end = tube.add_body(name=f"rod{name}", pos=(0, 0, level))
    across = max(rod.mass, SLIGHT) * rod.length**2 / 12
    middle = (0.0, 0.0, -rod.length / 2)
    _weigh(end, max(rod.mass, SLIGHT), middle, (across, across, across / 100))
    tube.gravcomp = end.gravcomp = float(weightless)
    slide = end.add_joint(
        name=f"P{name}", type=mujoco.mjtJoint.mjJNT_SLIDE, axis=(0, 0, 1), ref=level,
        armature=rod.screw, damping=(rod.viscous, 0.0, 0.0), frictionloss=rod.coulomb,
    )  # fmt: skip
    step = spec.option.timestep
    slide.solref_friction = (STIFFNESS * step, 1.0)
    slide.solimp_friction = (IMPEDANCE, IMPEDANCE, 1e-3, 0.5, 2.0)
    end.add_site(name=f"end{name}")
    return end


def _facet(mujoco, spec, k, first, r_m, facet):
    """The facet, on the ball joint of its first rod."""
    body = first.add_body(name=f"facet{k}", pos=(-r_m, 0.0, 0.0))
    _weigh(body, facet.mass, facet.centre, facet.inertia)
    body.add_joint(name=f"S{k}", type=mujoco.mjtJoint.mjJNT_BALL, pos=(r_m, 0.0, 0.0))
    for i, point in enumerate(ring(r_m)):
        body.add_site(name=f"ball{k}{i}", pos=point)


def _weigh(body, mass, centre, inertia):
    body.explicitinertial = True
    body.mass, body.ipos, body.inertia = mass, centre, inertia


def _stiffen(equality, step):
    equality.solref = (STIFFNESS * step, 1.0)
    equality.solimp = (IMPEDANCE, IMPEDANCE, 1e-3, 0.5, 2.0)


def _hold(mujoco, spec, name, rod):
    """The rod's length is what `hold` says."""
    held = spec.add_equality(
        name=f"hold{name}", type=mujoco.mjtEq.mjEQ_JOINT, objtype=mujoco.mjtObj.mjOBJ_JOINT,
        name1=f"P{name}",
    )  # fmt: skip
    _stiffen(held, spec.option.timestep)


def _drive(mujoco, spec, name, rod):
    """A force along the rod, limited and with a lag."""
    motor = spec.add_actuator(name=f"F{name}", target=f"P{name}", trntype=mujoco.mjtTrn.mjTRN_JOINT)
    motor.gainprm = [1.0] + [0.0] * 9
    motor.ctrllimited, motor.ctrlrange = 1, (-rod.limit, rod.limit)
    if rod.lag:
        motor.dyntype = mujoco.mjtDyn.mjDYN_FILTEREXACT
        motor.dynprm = [rod.lag] + [0.0] * 9


def _machine(mujoco, model, r_m):
    names = [f"{k}{i}" for k in range(FACETS) for i in range(LEGS)]

    def places(letter, wanted):
        return np.array([int(model.joint(letter + name).qposadr[0]) for name in wanted])

    facets = [str(k) for k in range(FACETS)]
    bodies = np.array([model.body("facet" + name).id for name in facets])
    return Machine(
        model, mujoco.MjData(model), places("R", names), places("P", names), places("S", facets),
        bodies, r_m,
    )  # fmt: skip


# -- placing and reading --------------------------------------------------------------------------


def stand(machine, shape, attitudes, origins):
    """Put the machine at rest into a pose: H_R_M (4, 3, 3) and M (4, 3); return the lengths."""
    mujoco = need("mujoco")
    feet, azimuths = bases(shape)
    data = machine.data
    mujoco.mj_resetData(machine.model, data)
    ends = origins[:, None] + np.einsum("kab,ib->kia", attitudes, ring(machine.r_m))
    reach = np.einsum("kiba,kib->kia", turn_z(azimuths), ends - feet)
    lean = np.arctan2(reach[..., 0], reach[..., 2])
    data.qpos[machine.hinges] = lean.ravel()
    data.qpos[machine.slides] = np.linalg.norm(reach, axis=-1).ravel()
    for k, place in enumerate(machine.balls):
        cos, sin = np.cos(lean[k, 0]), np.sin(lean[k, 0])
        leaning = np.array([[cos, 0.0, sin], [0.0, 1.0, 0.0], [-sin, 0.0, cos]])
        turned = leaning.T @ turn_z(azimuths[k, 0]).T @ attitudes[k]
        mujoco.mju_mat2Quat(data.qpos[place : place + 4], np.ascontiguousarray(turned).ravel())
    mujoco.mj_forward(machine.model, data)
    return machine.lengths


def hold(machine, lengths):
    """Tell a held machine the lengths of its rods, (4, 3)."""
    flat = np.asarray(lengths, dtype=float).ravel()
    joints = machine.model.eq_obj1id
    kinds = machine.model.eq_type == need("mujoco").mjtEq.mjEQ_JOINT
    places = machine.model.jnt_qposadr[joints[kinds]]
    # A joint's equality counts from where the model was built.
    machine.model.eq_data[kinds, 0] = flat - machine.model.qpos0[places]


def holding_forces(machine):
    """The forces that hold the rods of a held machine, (4, 3), push positive."""
    mujoco, data = need("mujoco"), machine.data
    equality = data.efc_type == mujoco.mjtConstraint.mjCNSTR_EQUALITY
    kinds = machine.model.eq_type[data.efc_id[: data.nefc]]
    rows = equality & (kinds == mujoco.mjtEq.mjEQ_JOINT)
    return data.efc_force[rows].reshape(FACETS, LEGS)


def push(machine, force, torque, points):
    """Put a wrench on each facet: force and torque (4, 3) in N and N m about points (4, 3)."""
    arm = points - machine.data.xipos[machine.bodies]
    machine.data.xfrc_applied[machine.bodies, :3] = force
    machine.data.xfrc_applied[machine.bodies, 3:] = torque + np.cross(arm, force)
