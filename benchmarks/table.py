"""The table: its rows, where they are kept, and how they are printed."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path

from benchmarks.count import Counts
from benchmarks.recipes import KERNELS, Kernel

HERE = Path(__file__).parent
RESULTS = HERE / "results.json"
PAGE = HERE / "RESULTS.md"

_INTRODUCTION = """\
# Operation counts, compared

Written by `make benchmark`. Each peer was given the same text-book recipe (`recipes.py`): full
matrices, multiplied in order, and derivatives by the tool's own rules. Armillary was given what it
asks for, the mechanism itself (`ours.py`): joints, vectors and the derivatives wanted, without any
intermediate of the hand-written kernels. The code it printed was
compiled with a scalar that counts, so loops, helper functions and repeated calls count as often as
they run. Every row returned the right values: they were compared at 16 points with a reference of
50 digits (`reference.py`), to 1e-12 relative to the larger of 1 and the value.

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

_COLUMNS = ("add", "mul", "div", "sqrt", "pow", "trig", "inverse", "flops", "cost")


@dataclass(frozen=True)
class Row:
    """What one tool made of one kernel."""

    kernel: str
    tool: str
    version: str
    options: str
    recipe: str
    counts: Counts
    kept: bool = False

    @property
    def identity(self) -> tuple[str, str, str, str]:
        """What makes it the same row in another run."""
        return (self.kernel, self.tool, self.options, self.recipe)

    @property
    def order(self) -> tuple[int, int, int, tuple[str, str, str, str]]:
        """Kernels as listed, then the cheapest first."""
        place = list(KERNELS).index(self.kernel)
        return (place, self.counts.cost, self.counts.flops, self.identity)


def kept_rows(rows: Iterable[Row], tool: str) -> list[Row]:
    """Earlier rows of a tool that cannot be run now, marked."""
    return [replace(row, kept=True) for row in rows if row.tool == tool and row.kernel in KERNELS]


def load(path: Path = RESULTS) -> list[Row]:
    """Rows of an earlier run; none if there was none."""
    if not path.exists():
        return []
    entries = json.loads(path.read_text())["rows"]
    return [Row(**{**entry, "counts": Counts(**entry["counts"])}) for entry in entries]


def to_json(rows: Sequence[Row]) -> str:
    """The same rows give the same text."""
    entries = [asdict(row) for row in sorted(rows, key=lambda row: row.order)]
    return json.dumps({"rows": entries}, indent=1) + "\n"


def to_markdown(rows: Sequence[Row]) -> str:
    """The page that people read."""
    ordered = sorted(rows, key=lambda row: row.order)
    sections = [_INTRODUCTION, *(_section(kernel, ordered) for kernel in KERNELS.values())]
    if any(row.kept for row in rows):
        sections.append(_KEPT)
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


def _line(row: Row) -> str:
    tool = f"{row.tool} ({row.options})" if row.options else row.tool
    numbers = " | ".join(str(getattr(row.counts, name)) for name in _COLUMNS)
    return f"| {tool}{' (kept)' if row.kept else ''} | {row.recipe} | {numbers} |"
