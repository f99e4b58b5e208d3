"""Regenerate `RESULTS.md` and `results.json`, or check that they are up to date."""

from __future__ import annotations

import argparse
import importlib
import importlib.util
import sys
from collections.abc import Iterator, Sequence

from benchmarks.count import CountError
from benchmarks.measure import WrongValuesError, measure
from benchmarks.patience import is_slow, slow_rows
from benchmarks.peers import PeerModule, peers
from benchmarks.recipes import KERNELS
from benchmarks.table import OURS, PAGE, RESULTS, Row, kept_rows, load, to_json, to_markdown
from benchmarks.yardstick import hand_rows


def main(arguments: Sequence[str] | None = None) -> int:
    """Entry point; returns the exit status."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__)
    parser.add_argument(
        "--check",
        action="store_true",
        help="write nothing; fail if a count differs from the committed one",
    )
    options = parser.parse_args(arguments)
    committed = load()
    try:
        rows = list(collect(committed, check=options.check))
    except (CountError, WrongValuesError) as error:
        print(f"benchmark: {error}", file=sys.stderr)
        return 1
    if options.check:
        return check(rows, committed)
    RESULTS.write_text(to_json(rows))
    PAGE.write_text(to_markdown(rows))
    say(f"wrote {PAGE.name} and {RESULTS.name}: {len(rows)} rows")
    return 0


def collect(committed: Sequence[Row], *, check: bool) -> Iterator[Row]:
    """Every row: our own, those by hand, then the peers', measured or else kept."""
    yield from ours(committed)
    say("by hand")
    yield from hand_rows()
    for peer in peers():
        if peer.PEER.installed:
            yield from peer_rows(peer, committed, check=check)
            continue
        kept = kept_rows(committed, peer.PEER.name)
        say(f"{peer.PEER.name} is not installed: {peer.PEER.remedy}. {len(kept)} old rows kept.")
        yield from kept


def ours(committed: Sequence[Row]) -> list[Row]:
    """Rows of this project's own generator, from `benchmarks/ours.py`."""
    if importlib.util.find_spec("benchmarks.ours") is None:
        say("no benchmarks/ours.py: the project's own rows are left out")
        return kept_rows(committed, OURS)
    say(OURS)
    rows: list[Row] = importlib.import_module("benchmarks.ours").armillary_rows()
    return rows


def peer_rows(peer: PeerModule, committed: Sequence[Row], *, check: bool) -> Iterator[Row]:
    """Measure every variant of every recipe that a peer can be given."""
    tool, version = peer.PEER.name, peer.PEER.version
    for kernel in KERNELS.values():
        say(f"{tool} {version}: {kernel.name}")
        for name, recipe in kernel.recipes.items():
            if is_slow(peer.PEER, kernel.name, name):
                yield from slow_rows(peer, kernel, name, committed, check=check)
                continue
            for code in peer.generate(kernel, recipe):
                yield measure(kernel, code, tool=tool, version=version, recipe=name)


def check(rows: Sequence[Row], committed: Sequence[Row]) -> int:
    """Compare with the committed rows; a row that could not be measured proves nothing."""
    old = {row.identity: row.counts or "not finished" for row in committed}
    new = {row.identity: row.counts or "not finished" for row in rows}
    changed = [name for name in {**old, **new} if old.get(name) != new.get(name)]
    for name in changed:
        print(f"{' / '.join(filter(None, name))}: {old.get(name)} -> {new.get(name)}")
    say(f"{len(changed)} of {len(new)} rows differ from the committed ones")
    stale = not PAGE.exists() or PAGE.read_text() != to_markdown(committed)
    if stale:
        say(f"{PAGE.name} does not show what {RESULTS.name} says")
    return 1 if changed or stale else 0


def say(text: str) -> None:
    """Progress, at once."""
    print(text, flush=True)


if __name__ == "__main__":
    sys.exit(main())
