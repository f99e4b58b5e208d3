"""What the pump does in time: volume, flow and rate of the flow, smooth piece by piece."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Piece:
    """A time in which the flow goes from one value to another; its rate is 0 at both ends.

    Attributes:
        start, end: s.
        s: volume moved from container 2 to 1 at the start, m^3.
        q_start, q_end: flow at either end, m^3/s.
    """

    start: float
    end: float
    s: float
    q_start: float = 0.0
    q_end: float = 0.0

    def __call__(self, time):
        """s, q and q_dot at a time, or at an array of times."""
        length, change = self.end - self.start, self.q_end - self.q_start
        u = (time - self.start) / length
        return (
            self.s + length * u * (self.q_start + change * u * u * (1 - u / 2)),
            self.q_start + change * u * u * (3 - 2 * u),
            change * 6 * u * (1 - u) / length,
        )

    @property
    def idle(self):
        """Whether nothing flows."""
        return self.q_start == 0 and self.q_end == 0

    @property
    def last(self):
        """Volume moved at the end, m^3."""
        return self.s + (self.end - self.start) * (self.q_start + self.q_end) / 2


def joined(s, start, *legs):
    """Pieces one after the other from a volume and a time; no flow at first.

    Args:
        legs: (length in s, flow at its end in m^3/s) of each.
    """
    pieces, q = [], 0.0
    for length, wanted in legs:
        pieces.append(Piece(start, start + length, s, q, wanted))
        s, start, q = pieces[-1].last, pieces[-1].end, wanted
    return pieces


def pulses(s, ramp, *given):
    """A pump that runs several times: pauses, runs and ramps.

    Args:
        s: volume moved at the beginning, m^3.
        ramp: length of each ramp of the flow, s.
        given: (pause before it in s, length with its ramps in s, flow in m^3/s) of each run; the
            last may be a pause with no flow.
    """
    legs = []
    for pause, length, flow in given:
        legs.append((pause, 0.0))
        if flow:
            legs += [(ramp, flow), (length - 2 * ramp, flow), (ramp, 0.0)]
    return joined(s, 0.0, *legs)


def experiment(settings, scale):
    """The pieces of flow of three pulses, the flow scaled."""
    runs, end = [], 0.0
    for begin, run, flow in zip(settings.begin, settings.run, settings.flow, strict=True):
        runs.append((begin - end, run, scale * flow))
        end = begin + run
    return pulses(0.0, settings.ramp, *runs, (settings.length - end, 0.0, 0.0))
