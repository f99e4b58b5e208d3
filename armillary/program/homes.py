"""Where values live that are used outside the loops that made them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from armillary.algebra.index import Index
from armillary.program.program import Op, Program, index_of
from armillary.program.schedule import Chain, Schedule
from armillary.program.sources import Fixed, needs, sources


@dataclass(frozen=True)
class Home:
    """A variable, or an array over some indices.

    Attributes:
        block: the loops around its declaration.
        dims: the indices of its places; none for a variable, which keeps the value of the last
            turn, or a sum so far.
    """

    block: Chain
    dims: tuple[Index, ...]


@dataclass(frozen=True)
class Use:
    """A value used inside some loops, and where it is taken of those that are over."""

    number: int
    fixed: Fixed
    chain: Chain


@dataclass(frozen=True)
class Homes:
    """What is declared ahead of its loop.

    Attributes:
        arrays: the home of each value that has one; every SUM and ANY has.
        carried: values that need none, because the phi that carries them keeps the last.
        shared: values that are used in another block than theirs.
    """

    arrays: dict[int, Home]
    carried: dict[int, int]
    shared: frozenset[int]


def homes(program: Program, plan: Schedule) -> Homes:
    """The homes of all values of a scheduled program."""
    arrays: dict[int, Home] = {}
    carried: dict[int, int] = {}
    shared = set()
    for number, uses in _by_value(program, plan).items():
        chain = plan.chains[number]
        if any(use.chain != chain for use in uses):
            shared.add(number)
        outside = [use for use in uses if use.chain[: len(chain)] != chain]
        if not outside:
            continue
        home = _home(program, number, chain, outside)
        phi = _carrier(program, plan, number, home)
        if phi is None:
            arrays[number] = home
        else:
            carried[number] = phi
    return Homes(arrays, carried, frozenset(shared))


def _by_value(program: Program, plan: Schedule) -> dict[int, list[Use]]:
    found: dict[int, list[Use]] = {}
    for use in _uses(program, plan):
        found.setdefault(use.number, []).append(use)
    return found


def _uses(program: Program, plan: Schedule) -> Iterator[Use]:
    known = needs(program)
    stored = set()
    for node, chain in plan.chains.items():
        if isinstance(node, int):
            # Where a phi starts from is read before its loop.
            before = program.instructions[node].op is Op.PHI
            given, at = known[node], chain[:-1] if before else chain
        else:
            stored.add(node.result)
            entry = program.results[node.result].entries[node.entry]
            given, at = tuple(sources(program, entry)), chain
        yield from (Use(source.number, source.fixed, at) for source in given)
    for phi, following in program.carried.items():
        for source in sources(program, following):
            yield Use(source.number, source.fixed, plan.chains[phi])
    for k, result in enumerate(program.results):
        if k not in stored:
            everywhere: Fixed = tuple((index, None) for index in result.indices)
            for entry in result.entries:
                for source in sources(program, entry, everywhere):
                    yield Use(source.number, source.fixed, ())
    for _, condition in program.cases:
        for source in sources(program, condition):
            yield Use(source.number, source.fixed, ())


def _home(program: Program, number: int, chain: Chain, outside: list[Use]) -> Home:
    depth = min(_common(chain, use.chain) for use in outside)
    instruction = program.instructions[number]
    if instruction.op in (Op.SUM, Op.ANY):
        inner = [index for _, index in chain[depth:] if index != index_of(instruction)]
        return Home(chain[:depth], tuple(inner))
    dims = []
    for loop in chain[depth:]:
        _, index = loop
        after = [dict(use.fixed).get(index) for use in outside if loop not in use.chain]
        if any(place != index.size - 1 for place in after):
            dims.append(index)
    return Home(chain[:depth], tuple(dims))


def _common(first: Chain, second: Chain) -> int:
    """How many loops two chains share."""
    pairs = zip(first, second, strict=False)
    return next((k for k, (a, b) in enumerate(pairs) if a != b), min(len(first), len(second)))


def _carrier(program: Program, plan: Schedule, number: int, home: Home) -> int | None:
    """The phi that still has a value after its loop."""
    for phi, following in program.carried.items():
        chain = plan.chains.get(phi)
        beside = following == number and chain == plan.chains[number]
        if beside and chain and home == Home(chain[:-1], ()):
            return phi
    return None
