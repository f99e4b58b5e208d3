"""An on-off pump with a dead band: the law that a microcontroller runs."""

from armillary import absolute, where, wrap

from .cycle import band_off, band_on, q_pump
from .symbols import FLOW, METRE, d
from .water import h_max

theta_ref = d.angle(
    "theta_ref",
    "angle wanted; at night, where the single axis answers BELOW_HORIZON, the angle to wait at",
    range=(-1.6, 1.6),
    latex=r"\theta_\mathrm{ref}",
)
theta_measured = d.angle(
    "theta_measured", "angle measured", range=(-1.6, 1.6), latex=r"\theta_\mathrm{m}"
)
_LEVEL = {"unit": METRE, "limits": (-10.0, 10.0), "range": (0.0, 0.3)}
level_1 = d.scalar("level_1", "level measured in container 1", latex=r"\hat{h}_1", **_LEVEL)
level_2 = d.scalar("level_2", "level measured in container 2", latex=r"\hat{h}_2", **_LEVEL)
pump = d.state.scalar(
    "pump",
    "which pump runs: 1 fills container 1, -1 fills container 2, 0 none",
    limits=(-1.0, 1.0),
    range=(-1.0, 1.0),
    latex=r"u",
)
error = d.define(
    "error",
    wrap(theta_ref - theta_measured),
    because="The short way round.",
    meaning="error of the angle",
    latex="e",
)
unfit = d.define(
    "unfit",
    absolute(band_off) > band_on,
    because="A pump that is to stop before it may start, or only after the other one has started, "
    "has no dead band.",
    meaning="whether the two errors of the dead band contradict each other",
)
running = d.define(
    "running",
    where(pump > 0, 1, where(pump < 0, -1, 0)),
    because="What runs, runs wholly.",
    meaning="sign of the pump that runs",
    latex=r"\operatorname{sgn} u",
)
wish = d.define(
    "wish",
    where(
        error > band_on,
        1,
        where(error < -band_on, -1, where(running * error > band_off, running, 0)),
    ),
    because="A pump starts when the error leaves the dead band, and runs until it has fallen to "
    "where it is to stop.",
    meaning="pump that the law asks for",
    latex="u'",
)
blocked = d.define(
    "blocked",
    ~(
        ~((wish > 0) & ~((level_1 < h_max) & (level_2 > 0)))
        & ~((wish < 0) & ~((level_2 < h_max) & (level_1 > 0)))
    ),
    because="A pump does not run dry, and fills no container beyond its height. The levels are "
    "measured: a volume summed up from the pump's flow drifts, and water evaporates.",
    meaning="whether the levels forbid the pump that is asked for",
)
astray = d.define(
    "astray",
    ~(~(level_1 < 0) & ~(level_2 < 0) & ~(level_1 > h_max) & ~(level_2 > h_max)),
    because="Water was lost or spilt, or a sensor is at fault.",
    meaning="whether a level measured lies outside its container",
)
pump_next = d.define(
    "pump_next",
    where(blocked, 0, wish),
    because="The levels have the last word.",
    meaning="pump that runs after this sample",
    latex="u_+",
)
flow = d.define(
    "flow",
    q_pump * pump_next,
    because="The pump knows on and off.",
    meaning="flow from container 2 to 1 that the pump gives",
    unit=FLOW,
    latex="q",
)
