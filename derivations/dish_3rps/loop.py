"""The exported law, the compiled C of it, closed around the multibody model."""

from dataclasses import dataclass, field

import numpy as np

from armillary.verify.engines import need

from .law import Law
from .multibody import FACETS, LEGS, build, push, stand

RODS = FACETS * LEGS
STRIDE = 10  # control steps between two looks at the normals


@dataclass
class Record:
    """What an experiment has told so far: lists of arrays, a stretch of the way each.

    Attributes:
        time: s.
        errors: lengths wanted less lengths, before the step, (n, 12), m.
        forces: what the law asked for, (n, 12), N.
        looks: times at which the normals were looked at, s.
        tilts: angles then between the normals and those wanted, (n / 10, 4), rad.
    """

    time: list[np.ndarray] = field(default_factory=list)
    errors: list[np.ndarray] = field(default_factory=list)
    forces: list[np.ndarray] = field(default_factory=list)
    looks: list[np.ndarray] = field(default_factory=list)
    tilts: list[np.ndarray] = field(default_factory=list)

    def joined(self, name):
        """One of them in one piece."""
        return np.concatenate(getattr(self, name))


class Loop:
    """A machine under a law.

    Args:
        law: parameters of the law.
        forward: whether the forces that carry the facets are fed forward.
        steps: steps of the multibody model in one of the law.
    """

    def __init__(self, native, shape, plant, law, forward=False, steps=1):
        self.plant, self.shape, self.forward, self.steps = plant, shape, forward, steps
        self.machine = build(shape, plant.facet, plant.rod, law["T_S"] / steps, plant.gravity)
        self.law = Law(native, law, (RODS,))
        self.read = plant.read
        self.record = Record()
        self.begun = False

    def begin(self, way):
        """At rest at the first pose of the way; no force acts yet."""
        lengths = stand(self.machine, self.shape, way.attitudes[0], way.origins[0])
        self.law.start(self.read(lengths.ravel()))
        self.begun = True

    def follow(self, way, wind=None):
        """Go a stretch of the way; `wind` pushes the facets along their normals, (n, 4), N."""
        if not self.begun:
            self.begin(way)
        wanted, rates = (a.reshape(-1, RODS) for a in (way.lengths, way.rates))
        ahead = way.forces.reshape(-1, RODS) * float(self.forward)
        lengths, forces = np.empty_like(wanted), np.empty_like(wanted)
        normals = np.empty((-(-len(wanted) // STRIDE), FACETS, 3))
        step, model, data = need("mujoco").mj_step, self.machine.model, self.machine.data
        qpos, ctrl, xmat = data.qpos, data.ctrl, data.xmat  # views of MuJoCo's own memory
        slides, bodies, law, read = self.machine.slides, self.machine.bodies, self.law, self.read
        for k in range(len(wanted)):
            here = lengths[k]
            qpos.take(slides, 0, here, "clip")
            ctrl[:] = forces[k] = law(wanted[k], rates[k], read(here), ahead[k])
            if wind is not None:
                blow(self.machine, wind[k])
            # A step begins with the pose before it, and leaves the bodies there.
            step(model, data, self.steps)
            if k % STRIDE == 0:
                normals[k // STRIDE] = xmat[bodies, 2::3]
        self.record.time.append(way.time)
        self.record.errors.append(wanted - lengths)
        self.record.forces.append(forces)
        self.record.looks.append(way.time[::STRIDE])
        self.record.tilts.append(apart(normals, way.normals[::STRIDE]))


def blow(machine, along):
    """A force along the normal of each facet, N."""
    normals = machine.data.xmat[machine.bodies, 2::3]
    push(machine, along[:, None] * normals, 0.0, machine.data.xpos[machine.bodies])


def apart(found, wanted):
    """Small angles between unit vectors."""
    return np.linalg.norm(np.cross(found, wanted), axis=-1)
