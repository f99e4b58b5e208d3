"""Which index is the outer one of a loop in a loop."""

from __future__ import annotations

from collections.abc import Iterator

from armillary.algebra.index import Index
from armillary.program.program import Program, asked_once, domains, index_of

Path = tuple[Index, ...]


@asked_once
def nesting(program: Program) -> Path:
    """All indices, outermost first.

    An iteration stands inside the loops over what its carried values depend on, and around all
    others that it meets. The rest is in the order of the results' indices, then as met.

    Raises:
        ValueError: if two iterations contradict each other.
    """
    left = _declared(program)
    outside = _outside(program, left)
    found: list[Index] = []
    while left:
        free = [index for index in left if not outside[index] - set(found)]
        if not free:
            names = ", ".join(index.name for index in left)
            raise ValueError(f"no order of loops over {names}: give two iterations two names")
        found.append(free[0])
        left.remove(free[0])
    return tuple(found)


def _declared(program: Program) -> list[Index]:
    found = [index for result in program.results for index in result.indices]
    found += [i for i in map(index_of, program.instructions) if i is not None]
    return list(dict.fromkeys(found))


def _outside(program: Program, indices: list[Index]) -> dict[Index, set[Index]]:
    """For each index those that must be outside it."""
    outside: dict[Index, set[Index]] = {index: set() for index in indices}
    for iteration, other in _pairs(program):
        around = any(
            other in domain and iteration in domain for domain in program.phi_domains.values()
        )
        outside[iteration if around else other].add(other if around else iteration)
    return outside


def _pairs(program: Program) -> Iterator[tuple[Index, Index]]:
    """An iteration and another index that one value depends on."""
    for domain in dict.fromkeys(domains(program)):
        for iteration in domain:
            if iteration.sequential:
                yield from ((iteration, other) for other in domain if other != iteration)


def path(program: Program, domain: frozenset[Index]) -> Path:
    """The loops, outermost first, that a value of a domain stands in."""
    return tuple(index for index in nesting(program) if index in domain)
