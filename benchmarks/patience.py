"""Tools that take minutes over a recipe: limited, and kept while what decides them is the same."""

from __future__ import annotations

import hashlib
import importlib
import multiprocessing
import resource
from collections.abc import Iterable, Sequence
from dataclasses import replace
from multiprocessing.connection import Connection
from pathlib import Path

from benchmarks import trace
from benchmarks.measure import measure
from benchmarks.peers import Generated, Peer, PeerModule
from benchmarks.recipes import KERNELS, Kernel
from benchmarks.table import SECONDS, Row

HERE = Path(__file__).parent

# Tool, kernel, recipe.
SLOW = {
    ("SymPy", "K4", "leg angles, differentiated"),
    ("SymPy", "K4", "leg axes, differentiated"),
}


def is_slow(peer: Peer, kernel: str, recipe: str) -> bool:
    """Whether this is left out of every run that would only find the same again."""
    return (peer.name, kernel, recipe) in SLOW


def digest(peer: PeerModule, kernel: Kernel, recipe: str) -> str:
    """Tells whether a slow row could come out otherwise: by recipe, version, limit and printer."""
    printer = HERE / Path(*peer.__name__.split(".")[1:]).with_suffix(".py")
    text = printer.read_text()
    parts = [trace.digest(kernel, recipe), peer.PEER.version, str(SECONDS), text]
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:16]


def slow_rows(
    peer: PeerModule, kernel: Kernel, recipe: str, committed: Sequence[Row], *, check: bool
) -> list[Row]:
    """The committed rows if they would come out the same, else new ones; none in a check."""
    wanted = digest(peer, kernel, recipe)
    place = (kernel.name, peer.PEER.name, recipe)
    kept = [r for r in committed if (r.kernel, r.tool, r.recipe) == place and r.digest == wanted]
    if kept or check:
        return kept
    finished = generate_in_time(peer.__name__, kernel.name, recipe, SECONDS)
    found = {code.options: code for code in finished}
    rows = []
    for options in peer.OPTIONS:
        tool, version = peer.PEER.name, peer.PEER.version
        code = found.get(options)
        row = (
            Row(kernel.name, tool, version, options, recipe, None)
            if code is None
            else measure(kernel, code, tool=tool, version=version, recipe=recipe)
        )
        rows.append(replace(row, digest=wanted))
    return rows


def generate_in_time(module: str, kernel: str, recipe: str, seconds: int) -> list[Generated]:
    """The sources that a peer gives away before its processor time is used up."""
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe(duplex=False)
    arguments = (theirs, module, kernel, recipe, seconds)
    worker = context.Process(target=_generate, args=arguments)
    worker.start()
    theirs.close()
    found = list(_received(ours))
    worker.join()
    return found


def _received(pipe: Connection) -> Iterable[Generated]:
    while True:
        try:
            yield pipe.recv()
        except EOFError:
            return


def _generate(pipe: Connection, module: str, kernel: str, recipe: str, seconds: int) -> None:
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
    problem = KERNELS[kernel]
    for generated in importlib.import_module(module).generate(problem, problem.recipes[recipe]):
        pipe.send(generated)
    pipe.close()
