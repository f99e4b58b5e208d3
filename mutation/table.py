"""What a run found: `RESULTS.md` for people, `results.json` to compare with."""

from __future__ import annotations

import json
import tomllib
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

from mutation.judge import REFUSED

FOLDER = Path(__file__).resolve().parent
RESULTS, PAGE, REASONS = FOLDER / "results.json", FOLDER / "RESULTS.md", FOLDER / "survivors.toml"
COUNTED = ("killed", "survived")


@dataclass(frozen=True)
class Row:
    """One mutant and what became of it."""

    system: str
    file: str
    line: int
    kind: str
    before: str
    after: str
    state: str
    by: str

    @property
    def place(self) -> str:
        """File and line of the change."""
        return f"derivations/{self.system}/{self.file}:{self.line}"

    @property
    def change(self) -> str:
        """The change by what it says, not by its line: lines move."""
        return f"{self.system}/{self.file}: {self.before} -> {self.after}"


def reasons() -> dict[str, str]:
    """Why known survivors survive, by change."""
    if not REASONS.is_file():
        return {}
    found = tomllib.loads(REASONS.read_text())
    return {entry["change"]: entry["reason"] for entry in found.get("survivor", [])}


def lost(rows: Iterable[Row]) -> list[Row]:
    """Survivors without a reason."""
    known = reasons()
    return [row for row in rows if row.state == "survived" and row.change not in known]


def share(rows: Sequence[Row]) -> tuple[int, int]:
    """How many were killed, of how many that count."""
    counted = [row.state for row in rows if row.state in COUNTED]
    return counted.count("killed"), len(counted)


def write(rows: Sequence[Row]) -> None:
    """Put a run on record; rows of systems that were not run stay."""
    ran = {row.system for row in rows}
    kept = [row for row in read() if row.system not in ran]
    every = sorted([*kept, *rows], key=lambda r: (r.system, r.file, r.line, r.kind, r.change))
    RESULTS.write_text(json.dumps([asdict(row) for row in every], indent=1) + "\n")
    PAGE.write_text(page(every))


def read() -> list[Row]:
    """The rows on record."""
    if not RESULTS.is_file():
        return []
    return [Row(**row) for row in json.loads(RESULTS.read_text())]


def page(rows: Sequence[Row]) -> str:
    """The table of a run."""
    about = (
        "Each row counts small changes of a derivation's source: a flipped sign, a sine for a "
        "cosine, two factors exchanged, a term or a joint left out. A change is *killed* when a "
        "check of `armillary check` fails (identities, dual numbers, independent engines), or the "
        "derivation is *refused*: it cannot be read, or has no real value. Refusals are counted "
        "apart too, for many are exchanges that the algebra does not allow. Changes that alter no "
        "value of any definition or kernel (*equal*), and those of what an identity states or a "
        "picture shows (*no formula*), are no errors of a kernel and are left out of the share. "
        "`python -m mutation` makes this table."
    )
    lines = [
        "# Mutation run",
        "",
        about,
        "",
        "| system | killed | of these refused | survived | share | equal | no formula |",
        "|---|--:|--:|--:|--:|--:|--:|",
    ]
    for system in [*sorted({row.system for row in rows}), "all"]:
        mine = [row for row in rows if system in ("all", row.system)]
        lines.append(f"| {system} | {_cells(mine)} |")
    lines += ["", "| kind | killed | survived |", "|---|--:|--:|"]
    for kind in sorted({row.kind for row in rows}):
        mine = Counter(row.state for row in rows if row.kind == kind)
        lines.append(f"| {kind} | {mine['killed']} | {mine['survived']} |")
    lines += ["", "## Survivors", ""]
    known = reasons()
    survivors = [row for row in rows if row.state == "survived"]
    for row in survivors:
        reason = known.get(row.change, "no reason is known: a check is missing")
        lines.append(
            f"- `{row.system}/{row.file}`, {row.kind}: `{row.before}` -> `{row.after}`. {reason}"
        )
    if not survivors:
        lines.append("None.")
    return "\n".join(lines) + "\n"


def _cells(rows: Sequence[Row]) -> str:
    """The counts of one line of the table."""
    state = Counter(row.state for row in rows)
    refused = sum(row.by.startswith(REFUSED) for row in rows)
    counted = sum(state[s] for s in COUNTED)
    part = f"{state['killed'] / counted:.1%}" if counted else "-"
    cells = (state["killed"], refused, state["survived"], part, state["equivalent"])
    return " | ".join(map(str, (*cells, state["unchanged"])))
