"""The trough in time: stick, slip in either sense, and the instants between, on the kernels.

Between two events the motion is smooth and is integrated as such; an event is where the trough
comes to rest, or where the drive overcomes friction. What holds is the kernel's answer, STICKING,
and no threshold.
"""

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from armillary import Status
from armillary.verify.engines import EngineMissing, need
from armillary.verify.implementations import generated_module, native_system

GRID = 257  # times in a piece at which friction is asked whether it holds
POINTS = 8  # rows written of a piece in which the trough stands and water flows
MOST = 100_000  # events of a motion
SHORTEST = 1e-9  # s, of a slip
LONGEST = 1e-3  # s, for which a trough on the edge of friction may seem not to set off
TINY = 1e-300  # rad/s, a sense of motion without speed
STATE = ("theta", "omega", "s", "q", "q_dot")
NAMES = ("time", *STATE, "work", "heat")
MODES = {0: "stick", 1: "slip +", -1: "slip -"}


class MotionError(Exception):
    """The kernels refuse a state, or the motion does not get on."""


@dataclass
class Record:
    """What a motion was, at the steps of the integrator: no value is interpolated.

    Attributes:
        rows: time, theta, omega, s, q, q_dot, work of the pump in J, heat of the bearings in J.
        events: time, angle, and what begins there: "stick", "slip +" or "slip -".
    """

    rows: list = field(default_factory=list)
    events: list = field(default_factory=list)

    def column(self, name):
        """One of the rows' quantities, `NAMES`, as an array."""
        return np.array([row[NAMES.index(name)] for row in self.rows])

    @property
    def states(self):
        """The states as the kernels take them."""
        return {name: self.column(name) for name in STATE}

    def write(self, piece, time, y):
        """A row, unless there is one of this time."""
        if not (self.rows and self.rows[-1][0] == time):
            self.rows.append((float(time), *map(float, (y[0], y[1], *piece(time), y[2], y[3]))))

    def begin(self, time, y, mode):
        """An event, where it is not what was before."""
        if not (self.events and self.events[-1][2] == MODES[mode]):
            self.events.append((float(time), float(y[0]), MODES[mode]))
        if len(self.events) > MOST:
            raise MotionError(f"{MOST} events by {time:g} s: the motion does not get on")


class OneState:
    """A kernel of a trough, compiled or not, for one state at a time."""

    def __init__(self, kernel, trough, name):
        self.kernel, self.trough, self.name = kernel, trough, name
        self.prepared = None
        if hasattr(kernel, "prepare"):
            self.prepared = kernel.prepare(**trough, **dict.fromkeys(STATE, 0.0))
            self.into = [self.prepared.inputs[n] for n in STATE]

    def __call__(self, *state):
        """Result and status at a state.

        Raises:
            MotionError: where the kernel refuses.
        """
        if self.prepared is None:
            found = self.kernel(**self.trough, **dict(zip(STATE, state, strict=True)))
        else:
            for array, value in zip(self.into, state, strict=True):
                array[...] = value
            self.prepared.run()
            found = self.prepared.results
        status = int(found.status)
        if status < 0:
            said = ", ".join(f"{n} = {v:.9g}" for n, v in zip(STATE, state, strict=True))
            raise MotionError(f"{self.name} answers {status} at {said}")
        return float(getattr(found, self.name)), status


class Motion:
    """A trough that moves under dry friction.

    Args:
        kernels: of the trough, compiled or not; compiled ones are much faster.
        trough: its parameters.
        tolerance: of the integrator, relative; a tenth of it absolute, in rad, rad/s and J.
        book: whether work and heat are kept too, else they stay 0.
    """

    def __init__(self, kernels, trough, tolerance=1e-12, book=True):
        self.kernels, self.trough, self.book = kernels, dict(trough), book
        self.solve_ivp = need("scipy.integrate").solve_ivp
        self.settings = {"method": "DOP853", "rtol": tolerance, "atol": 0.1 * tolerance}
        self.alpha = OneState(kernels.acceleration, self.trough, "alpha")
        self.pressure = OneState(kernels.pump_pressure, self.trough, "pressure")
        self.friction = OneState(kernels.friction, self.trough, "M_F")
        self.pause = 0.0

    def run(self, pieces, theta, omega=0.0, tell=None, record=None):
        """The motion through pieces of flow, one after the other, as a `Record`.

        Args:
            theta, omega: at the beginning of the first, rad and rad/s.
            tell: hears how far it is, 0 to 1.
            record: goes on with this one; its last row is the beginning.

        Raises:
            MotionError: where the kernels refuse a state.
        """
        record, self.pause = Record() if record is None else record, 0.0
        y = np.array([theta, omega, *(record.rows[-1][6:] if record.rows else (0.0, 0.0))])
        first, last = pieces[0].start, pieces[-1].end
        for piece in pieces:
            time = piece.start
            while time < piece.end:
                mode = self._mode(piece, time, y)
                record.begin(time, y, mode)
                record.write(piece, time, y)
                go = self._slip if mode else self._stick
                time, y = go(piece, time, y, record, mode)
                record.write(piece, time, y)
                if tell is not None:
                    tell((time - first) / (last - first), f"{time:.0f} s of {last:.0f}")
        return record

    def held(self, theta, s, q, q_dot):
        """Whether friction holds the trough at rest; arrays are broadcast.

        Raises:
            MotionError: where the kernel refuses.
        """
        found = self.kernels.acceleration(
            **self.trough, theta=theta, omega=0.0, s=s, q=q, q_dot=q_dot
        )
        if np.any(found.status < 0):
            raise MotionError(f"acceleration answers {np.min(found.status)} at theta = {theta:.9g}")
        # A container that is empty is told before STICKING; then the acceleration tells.
        return (found.status == Status.STICKING) | (found.alpha == 0)

    # ---- from an event to the next, or to the end of the piece ----

    def _mode(self, piece, time, y):
        """0 where the trough stays at rest, else the sense of its motion."""
        if y[1] != 0:
            return int(np.sign(y[1]))
        alpha, status = self.alpha(y[0], 0.0, *piece(time))
        return 0 if status == Status.STICKING else int(np.sign(alpha))

    def _stick(self, piece, time, y, record, _):
        end = self._breakaway(piece, time, y[0])
        if self.book and not piece.idle and end > time:
            found = self._solved(piece, time, end, y, 0, max_step=(end - time) / POINTS)
            y = _kept(found, piece, record, found.t.size - 1)
            y[1] = 0.0
        return end, y

    def _breakaway(self, piece, time, theta):
        """When the drive overcomes friction, to the last bit; or the end of the piece."""
        if piece.idle:
            return piece.end
        times = np.linspace(time, piece.end, GRID)
        loose = np.flatnonzero(~self.held(theta, *piece(times)))
        if not loose.size:
            return piece.end
        low, high = times[max(loose[0] - 1, 0)], times[loose[0]]
        while low < (middle := (low + high) / 2) < high:
            if self.held(theta, *piece(middle)):
                low = middle
            else:
                high = middle
        return float(high)

    def _slip(self, piece, time, y, record, sense):
        found = self._until_rest(piece, time, y, sense)
        if not found.t_events[0].size:
            return piece.end, _kept(found, piece, record, found.t.size - 1)
        # The event stands on interpolated values: the last step is taken once more, up to it.
        end, before = float(found.t_events[0][0]), found.t.size - 2
        if end <= time:  # on the edge of friction, within rounding: the trough stays where it is
            return self._wait(piece, time, y)
        self.pause = 0.0
        y = _kept(found, piece, record, before)
        if end > found.t[before]:
            y = self._solved(piece, found.t[before], end, y, sense).y[:, -1].copy()
        slope = self._rates(piece, end, y, sense)
        if slope[1] != 0:  # what the search left of the speed, a rounding
            end, y = min(end - y[1] / slope[1], piece.end), y - y[1] / slope[1] * slope
        y[1] = 0.0
        return end, y

    def _wait(self, piece, time, y):
        """A little later, the trough not moved: its drive exceeds friction by a rounding only."""
        self.pause = max(SHORTEST, 2 * self.pause)
        if self.pause > LONGEST:
            raise MotionError(f"at {time:g} s friction neither holds the trough nor lets it go")
        end = min(time + self.pause, piece.end)
        work = (end - time) * self._pumped(y[0], 0.0, piece((time + end) / 2)) if self.book else 0.0
        return end, np.array([y[0], 0.0, y[2] + work, y[3]])

    def _until_rest(self, piece, time, y, sense):
        """The motion until its speed is 0, also where that is so for a part of a step only."""

        def speed(_, of):
            return of[1]

        def turning(t, of):
            return sense * self._rates(piece, t, of, sense)[1]

        speed.terminal, speed.direction, turning.direction = True, -sense, 1.0
        end, first = piece.end, {}
        while True:
            found = self._solved(piece, time, end, y, sense, events=(speed, turning), **first)
            if _at_once(found, time) and first.get("first_step", 1.0) > SHORTEST:
                # From rest and back within the first step: the search saw the beginning itself.
                first = {"first_step": min(first.get("first_step", 0.1) / 16, end - time)}
                continue
            beyond = [
                t
                for t, of in zip(found.t_events[1], found.y_events[1], strict=True)
                if sense * of[1] < 0 and t < end
            ]
            if found.t_events[0].size or not beyond:
                return found
            end = float(beyond[0])

    def _solved(self, piece, time, end, y, sense, **more):
        found = self.solve_ivp(
            lambda t, of: self._rates(piece, t, of, sense), (time, end), y, **self.settings, **more
        )
        if not found.success:
            raise MotionError(f"the integrator stops at {found.t[-1]:g} s: {found.message}")
        return found

    def _rates(self, piece, time, y, sense):
        """Rates of angle, speed, work and heat.

        The speed's is mirrored beyond rest: no step of the integrator meets the jump of friction.
        """
        theta, omega = y[0], y[1]
        flow = piece(time)
        if not sense:
            return np.array([0.0, 0.0, self._pumped(theta, 0.0, flow), 0.0])
        if sense * omega > 0:
            near, alpha = omega, self.alpha(theta, omega, *flow)[0]
        else:
            near = sense * TINY
            alpha = self.alpha(theta, near, *flow)[0]
            if omega != 0:
                alpha = 2 * alpha - self.alpha(theta, -omega, *flow)[0]
        if not self.book:
            return np.array([omega, alpha, 0.0, 0.0])
        heat = -self.friction(theta, near, *flow)[0] * omega
        return np.array([omega, alpha, self._pumped(theta, near, flow), heat])

    def _pumped(self, theta, omega, flow):
        """Power of the pump, W."""
        return flow[1] * self.pressure(theta, omega, *flow)[0] if flow[1] else 0.0


def _at_once(found, time):
    """Whether the first event found is where the motion began."""
    return found.t_events[0].size > 0 and found.t_events[0][0] <= time


def _kept(found, piece, record, last):
    """Write the steps down up to one of them; its state."""
    for k in range(1, last + 1):
        record.write(piece, found.t[k], found.y[:, k])
    return found.y[:, last].copy()


def energies(kernels, trough, record):
    """Energy of trough and water at each row, J."""
    states = record.states
    del states["q_dot"]
    found = kernels.energy(**trough, **states)
    return found.T + found.V


def closed(kernels, trough, record):
    """What is missing in the book of energy, J, at each row: 0 where it closes."""
    energy = energies(kernels, trough, record)
    return energy - energy[0] - record.column("work") + record.column("heat")


def creeping(kernels, trough, pieces, theta, tolerance=1e-10):
    """The same under smooth friction, which meets no event: times, angles and speeds."""
    solve_ivp = need("scipy.integrate").solve_ivp
    alpha = OneState(kernels.acceleration_smooth, dict(trough), "alpha")
    times, rows, y = [pieces[0].start], [(theta, 0.0)], np.array([theta, 0.0])
    for piece in pieces:
        found = solve_ivp(
            lambda t, of, piece=piece: np.array([of[1], alpha(of[0], of[1], *piece(t))[0]]),
            (piece.start, piece.end), y, method="Radau", rtol=tolerance, atol=0.1 * tolerance,
        )  # fmt: skip
        if not found.success:
            raise MotionError(f"the integrator stops at {found.t[-1]:g} s: {found.message}")
        times.extend(found.t[1:])
        rows.extend(found.y[:, 1:].T)
        y = found.y[:, -1].copy()
    return np.array(times), *np.array(rows).T


def compiled(kernels):
    """The compiled C of the same kernels: a motion asks for them a hundred thousand times.

    Raises:
        EngineMissing: if there is no compiler, or no C beside the kernels.
    """
    folder, package = Path(kernels.__file__).parents[1], kernels.__name__.rpartition(".")[0]
    if not (folder.parent / "c").is_dir():
        raise EngineMissing("compiled C", "run armillary generate")
    return native_system(folder, generated_module(folder, package, "native"), "water_trough")
