"""`armillary list`: systems, kernels and costs, from the manifest; needs no SymPy."""

from __future__ import annotations

from collections.abc import Iterator

from armillary.project.config import Project
from armillary.project.generate import survey
from armillary.project.report import operations


def overview(project: Project) -> Iterator[str]:
    """The lines of `armillary list`."""
    systems = project.systems()
    if not systems:
        yield "no system yet: `armillary new NAME` adds one"
    state = survey(project)
    for name in systems:
        entry = state.entry(name)
        if entry is None:
            yield f"{name}  (not generated yet)"
            continue
        yield name + ("  (out of date: run `armillary generate`)" if name in state.stale else "")
        for kernel, facts in sorted(entry.kernels.items()):
            yield f"  {kernel:<24} {operations(facts['cost'])}"
    papers = project.papers()
    if papers:
        yield f"papers: {', '.join(papers)}  (`armillary audit` compares what they print)"
