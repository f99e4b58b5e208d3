"""The table: its rows, where they are kept, and how they are printed."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass, replace
from math import inf
from pathlib import Path

from benchmarks.count import Counts
from benchmarks.recipes import KERNELS, Kernel

HERE = Path(__file__).parent
OURS = "Armillary"
WHOLE, SETUP, STEP = "", "setup", "step"
RESULTS = HERE / "results.json"
PAGE = HERE / "RESULTS.md"
SECONDS = 30  # of processor time that a tool may take over a recipe known to be slow

_INTRODUCTION = """\
# Operation counts, compared

Written by `make benchmark`. Each peer was given the same text-book recipe (`recipes.py`): full
matrices, multiplied in order, and derivatives by the tool's own rules. K4 was also given to them as
a recursion from link to link that names each of its steps, as SymPyBotics does
(`tracker_recursion.py`). Armillary was given what it asks for, the mechanism itself (`ours.py`):
joints, vectors and the derivatives wanted, without any intermediate of the hand-written kernels;
K3 and K4 come of this project's derivation of the tracker. The code it printed was compiled with a
scalar that counts, so loops, helper functions and repeated calls count as often as they run. Every
row returned the right values: they were compared at 16 points with a reference of 50 digits
(`reference.py`), to 1e-12 relative to the larger of 1 and the value.

* **flops** = add + mul + div + sqrt. A subtraction is an addition; a sign change, a comparison and
  an absolute value are free; `pow(x, 2)` is a multiplication, as every C compiler makes it one;
  arithmetic between literals is the compiler's.
* **trig** is sine and cosine; **inverse** is `atan2` and its kin; **pow** is every other power.
* **cost** = add + mul + 14 (div + sqrt) + 40 (pow + trig + inverse): a small core with a
  floating-point unit. Rows are sorted by it.
* **By hand** is the code in `hand/`, the yardstick: what a person who knows the mechanism writes.
"""

_KEPT = """\
(kept) Not measured when this page was last written, because the tool was not installed; the row
is from an earlier run.
"""

_SLOW = f"""\
–: not finished in {SECONDS} s of processor time, and not tried again until recipe, printer or
version change.
"""

_STAGES = """\
## Setup and step

What changes with the mount only is computed once, by the setup; the step does the rest. Of the
mount are in K2 latitude, receiver and the three turns of the base, in K3 both ends of the legs and
the height, in K4 every parameter. A setup keeps to what the step needs, and the step is made for
itself, so that both together may take more or less than the kernel at once.
"""

_COLUMNS = ("add", "mul", "div", "sqrt", "pow", "trig", "inverse", "flops", "cost")


@dataclass(frozen=True)
class Row:
    """What one tool made of one kernel."""

    kernel: str
    tool: str
    version: str
    options: str
    recipe: str
    counts: Counts | None  # None: not finished
    kept: bool = False
    digest: str = ""  # of what decides a slow row
    stage: str = ""  # WHOLE, SETUP or STEP

    @property
    def identity(self) -> tuple[str, ...]:
        """What makes it the same row in another run."""
        return (self.kernel, self.tool, self.options, self.recipe, self.stage)

    @property
    def order(self) -> tuple[int, float, float, tuple[str, ...]]:
        """Kernels as listed, then the cheapest first."""
        place = list(KERNELS).index(self.kernel)
        if self.counts is None:
            return (place, inf, inf, self.identity)
        return (place, self.counts.cost, self.counts.flops, self.identity)


def kept_rows(rows: Iterable[Row], tool: str) -> list[Row]:
    """Earlier rows of a tool that cannot be run now, marked."""
    return [replace(row, kept=True) for row in rows if row.tool == tool and row.kernel in KERNELS]


def load(path: Path = RESULTS) -> list[Row]:
    """Rows of an earlier run; none if there was none."""
    if not path.exists():
        return []
    entries = json.loads(path.read_text())["rows"]
    return [Row(**{**entry, "counts": _counts(entry["counts"])}) for entry in entries]


def _counts(entry: dict[str, int] | None) -> Counts | None:
    return None if entry is None else Counts(**entry)


def to_json(rows: Sequence[Row]) -> str:
    """The same rows give the same text."""
    entries = [asdict(row) for row in sorted(rows, key=lambda row: row.order)]
    return json.dumps({"rows": entries}, indent=1) + "\n"


def to_markdown(rows: Sequence[Row]) -> str:
    """The page that people read."""
    ordered = sorted(rows, key=lambda row: row.order)
    whole = [row for row in ordered if row.stage == WHOLE]
    sections = [_INTRODUCTION, *(_section(kernel, whole) for kernel in KERNELS.values())]
    sections.append(_stages(ordered))
    if any(row.kept for row in rows):
        sections.append(_KEPT)
    if any(row.digest for row in rows):
        sections.append(_SLOW)
    versions = sorted({(row.tool, row.version) for row in rows if row.version})
    sections.append("Versions: " + ", ".join(f"{t} {v}" for t, v in versions) + ".\n")
    return "\n".join(sections)


def _section(kernel: Kernel, rows: Sequence[Row]) -> str:
    own = [row for row in rows if row.kernel == kernel.name]
    lines = [
        f"## {kernel.name}: {kernel.title}\n",
        f"{kernel.definition} {len(kernel.inputs)} numbers in, {kernel.n_out} out.\n",
        "| tool | recipe | " + " | ".join(_COLUMNS) + " |",
        "|---|---|" + "--:|" * len(_COLUMNS),
    ]
    return "\n".join([*lines, *map(_line, own)]) + "\n"


def _stages(rows: Sequence[Row]) -> str:
    """Armillary's kernels whose quantities of the mount are dealt with beforehand."""
    divided = {row.kernel for row in rows if row.stage != WHOLE}
    found = {(row.kernel, row.stage): row for row in rows if row.tool == OURS}
    lines = [_STAGES, "| kernel | " + " | ".join(_COLUMNS) + " |", "|---|" + "--:|" * len(_COLUMNS)]
    for kernel in KERNELS:
        if kernel in divided:
            lines += [
                f"| {kernel}, {stage or 'at once'} | {_numbers(found[kernel, stage])} |"
                for stage in (WHOLE, SETUP, STEP)
            ]
    return "\n".join(lines) + "\n"


def _line(row: Row) -> str:
    tool = f"{row.tool} ({row.options})" if row.options else row.tool
    return f"| {tool}{' (kept)' if row.kept else ''} | {row.recipe} | {_numbers(row)} |"


def _numbers(row: Row) -> str:
    return " | ".join(
        "–" if row.counts is None else str(getattr(row.counts, name)) for name in _COLUMNS
    )
