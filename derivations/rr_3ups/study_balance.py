"""Forces of the equinox as functions of the platform's mass centre, in which they are affine."""

from dataclasses import dataclass

import numpy as np

from .study_basis import (
    CALM,
    SPRING,
    around_noon,
    crossings,
    day_of,
    declination,
    mean,
    mount,
    over_time,
    state_at,
    three,
    two,
)

ROUNDING = 1e-6


@dataclass(frozen=True)
class Affine:
    """A value and its derivatives by the mass centre's coordinates, the last axis."""

    value: np.ndarray
    slopes: np.ndarray

    def at(self, centre):
        """The value for a mass centre, m."""
        return self.value + self.slopes @ np.asarray(centre, dtype=float)


@dataclass(frozen=True)
class Balance:
    """The day, the forces of both mechanisms, and the way out of the two drives' poles.

    Attributes:
        q_dot: rates of the lengths, m/s.
        loose: per crossing, what two drives would have to do along the motion that they do not
            hold, N m.
    """

    clock: np.ndarray
    q_dot: np.ndarray
    three: Affine
    two: Affine
    loose: tuple[Affine, ...]

    def figures(self, centre):
        """Largest force and the three means, N."""
        F = np.abs(self.three.at(centre))
        return np.array([F.max(), *(mean(column, self.clock) for column in F.T)])

    def figures_two(self, centre):
        """Largest force and the two means, N, of the samples."""
        F = np.abs(self.two.at(centre))
        return np.array([np.nanmax(F), *(mean(column, self.clock) for column in F.T)])

    def squares(self, centre):
        """Integrals of the squared forces of both mechanisms over the day, N^2 s."""
        return [
            over_time((of.at(centre) ** 2).sum(axis=1), self.clock)
            for of in (self.three, self.two)
        ]  # fmt: skip

    def heats(self, centre):
        """Summed squared forces of both mechanisms, N^2: at sunrise, least, largest around noon."""
        middle, found = around_noon(self.clock), []
        for of in (self.three, self.two):
            heat = (of.at(centre) ** 2).sum(axis=1)
            ends = np.nanmin(heat[middle]), np.nanmax(heat[middle])
            found.append([float(value) for value in (heat[0], *ends)])
        return found

    def mechanical(self, centre):
        """Largest and mean size of the mechanical power of both mechanisms, W."""
        sizes = [
            np.abs((F.at(centre) * self.q_dot[:, : F.value.shape[1]]).sum(axis=1))
            for F in (self.three, self.two)
        ]
        return [(float(np.nanmax(P)), mean(P, self.clock)) for P in sizes]

    def held_back(self):
        """How many conditions on y and z of the mass centre the loose motions make: 0 to 3."""
        rows = np.array([(of.value, *of.slopes[1:]) for of in self.loose])
        if not rows.size:
            return 0
        return int(np.linalg.matrix_rank(rows, tol=ROUNDING * np.abs(rows).max()))

    def bounded(self, height):
        """Place y of the mass centre, given its height z, at which two drives have no pole."""
        (of, *_) = self.loose
        return float(-(of.value + of.slopes[2] * height) / of.slopes[1])


def balance(kernels, sun, parameters):
    """All of it, by the kernels at four mass centres."""
    day = day_of(kernels, sun, parameters)
    size = mount(parameters)
    angle = declination(parameters, SPRING)
    zeros = crossings(kernels, parameters, angle, day.clock, size)
    return Balance(
        day.clock,
        kernels.leg_rates(**day.motion, **size).q_dot,
        affine(parameters, lambda size: three(kernels, day.state, size)),
        affine(parameters, lambda size: two(kernels, day.state, size)),
        tuple(
            affine(parameters, lambda size, t=t: unheld(kernels, parameters, angle, t, size))
            for t in zeros
        ),
    )


def affine(parameters, of):
    """The value at o and its slopes, from the kernel at four mass centres."""
    at_o, *others = (
        of(mount(parameters, r_sc=centre)) for centre in np.vstack([np.zeros(3), np.eye(3)])
    )
    return Affine(at_o, np.stack([other - at_o for other in others], axis=-1))


def unheld(kernels, parameters, angle, t, size):
    """Generalised force along the motion that lengthens neither leg 1 nor leg 2."""
    state = state_at(kernels, parameters, angle, t)
    J = kernels.jacobian(alpha=state["alpha"], beta=state["beta"], **size).J[:2]
    motion = np.linalg.svd(J)[2][-1]
    tau = kernels.generalized_force_two_legs(**state, **CALM, **size).tau
    return float(motion @ tau) * (1.0 if motion[1] > 0 else -1.0)
