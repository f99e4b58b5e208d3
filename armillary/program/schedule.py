"""Puts a program into loops: lines in an order that runs, in as few loops as are found.

Greedy: what is ready stands where it is; else a loop is opened and takes in whatever can run in it.
A loop that could not take in everything of its index takes in only what others wait for.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import count

from armillary.algebra.index import Index
from armillary.program.nesting import Path, path
from armillary.program.program import Op, Program, domains
from armillary.program.sources import Source, has_line, needs, sources


@dataclass(frozen=True, order=True)
class Store:
    """An entry of a result, written where it belongs."""

    result: int
    entry: int


Node = int | Store


@dataclass(frozen=True)
class Loop:
    """Steps for each point of an index; `key` tells two loops over one index apart."""

    key: int
    index: Index
    steps: tuple[Step, ...]


Step = Node | Loop
# The loops that a line stands in, outermost first.
Chain = tuple[tuple[int, Index], ...]


@dataclass(frozen=True)
class Schedule:
    """Lines and loops in order, and the loops around each line.

    Attributes:
        stores: what is run after the status is known.
    """

    steps: tuple[Step, ...]
    stores: tuple[Step, ...]
    chains: dict[Node, Chain]


def schedule(
    program: Program, stored: frozenset[str] = frozenset(), late: bool = False
) -> Schedule:
    """The loops of a program.

    Args:
        stored: results that are written entry by entry, in loops over their indices.
        late: whether they are written only when everything is computed.

    Raises:
        ValueError: if no order of loops computes the program.
    """
    stores = {
        Store(k, entry)
        for k, result in enumerate(program.results)
        for entry in range(len(result.entries))
        if result.name in stored
    }
    scheduler = _Scheduler(program, stores)
    lines: set[Node] = {n for n in range(len(program.instructions)) if has_line(program, n)}
    steps = scheduler.all_of(lines if late else lines | stores)
    after = scheduler.all_of(set(stores)) if late else ()
    return Schedule(steps, after, scheduler.placed)


@dataclass(frozen=True)
class _Attempt:
    loop: Loop
    placed: dict[Node, Chain]
    left: frozenset[Node]


class _Scheduler:
    def __init__(self, program: Program, stores: Iterable[Store]) -> None:
        self.program = program
        self.placed: dict[Node, Chain] = {}
        self.keys = count()
        known = domains(program)
        self.needs: dict[Node, tuple[Source, ...]] = dict(enumerate(needs(program)))
        self.paths: dict[Node, Path] = {}
        for number, instruction in enumerate(program.instructions):
            # A sum is taken where its terms are.
            closes = instruction.op in (Op.SUM, Op.ANY)
            domain = known[instruction.args[0] if closes else number]
            self.paths[number] = path(program, domain)
        for store in stores:
            result = program.results[store.result]
            self.paths[store] = path(program, frozenset(result.indices))
            self.needs[store] = tuple(sources(program, result.entries[store.entry]))
        self.users = self._users()

    def _users(self) -> list[tuple[Source, Node]]:
        """Each source with what uses it; what is carried is used by the phi it goes to."""
        found = [(source, node) for node, given in self.needs.items() for source in given]
        for phi, following in self.program.carried.items():
            found += [(source, phi) for source in sources(self.program, following)]
        return found

    def all_of(self, nodes: set[Node]) -> tuple[Step, ...]:
        """The steps of all of some nodes."""
        steps, left = self.block((), nodes, self.placed)
        if left:
            raise ValueError(
                f"no order of loops computes {self.program.name}: give two iterations two names"
            )
        return steps

    def block(
        self, chain: Chain, nodes: set[Node], placed: dict[Node, Chain]
    ) -> tuple[tuple[Step, ...], set[Node]]:
        """Steps at one depth, as many as can run, and the nodes that are left."""
        here = tuple(index for _, index in chain)
        left, steps = set(nodes), list[Step]()
        while left:
            for node in sorted((n for n in left if self.paths[n] == here), key=_order):
                if self.is_ready(node, chain, placed):
                    placed[node] = chain
                    left.remove(node)
                    steps.append(node)
            attempt = self.best(chain, left, placed)
            if attempt is None:
                break
            placed.update(attempt.placed)
            left -= attempt.placed.keys()
            steps.append(attempt.loop)
        return tuple(steps), left

    def is_ready(self, node: Node, chain: Chain, placed: dict[Node, Chain]) -> bool:
        """Whether everything it is made of is there, and the loops it must be outside are over."""
        return all(
            source.number in placed and not _is_inside(placed[source.number], source, chain)
            for source in self.needs[node]
        )

    def best(self, chain: Chain, nodes: set[Node], placed: dict[Node, Chain]) -> _Attempt | None:
        """The next loop: one that takes in all of its index if there is one."""
        found = []
        for index in self.next_indices(len(chain), nodes):
            attempt = self.attempt(chain, index, nodes, placed)
            if attempt is not None and not attempt.left:
                return attempt
            if attempt is not None:
                found.append(attempt)
        return found[0] if found else None

    def next_indices(self, depth: int, nodes: set[Node]) -> Iterator[Index]:
        """The indices of the loops that could be opened, in order of nesting."""
        wanted = {self.paths[node][depth] for node in nodes if len(self.paths[node]) > depth}
        yield from path(self.program, frozenset(wanted))

    def attempt(
        self, chain: Chain, index: Index, nodes: set[Node], placed: dict[Node, Chain]
    ) -> _Attempt | None:
        """A loop of all that can run in it, or of what others wait for; None if nothing can."""
        depth = len(chain)
        inside = {n for n in nodes if self.paths[n][depth : depth + 1] == (index,)}
        attempt = self.filled(chain, index, inside, placed)
        if attempt.left:
            wanted = self.waited_for(attempt, (*(i for _, i in chain), index))
            attempt = self.filled(chain, index, wanted, placed)
            attempt = _Attempt(attempt.loop, attempt.placed, frozenset(inside - wanted))
        return attempt if attempt.placed else None

    def filled(
        self, chain: Chain, index: Index, nodes: set[Node], placed: dict[Node, Chain]
    ) -> _Attempt:
        """A loop of all nodes that can run in it. No iteration is torn: a phi needs its next."""
        key, tried = next(self.keys), set(nodes)
        while True:
            known = dict(placed)
            steps, left = self.block((*chain, (key, index)), tried, known)
            torn = {n for n in tried - left if not self.is_carried(n, known)}
            if not torn:
                new = {n: c for n, c in known.items() if n not in placed}
                return _Attempt(Loop(key, index, steps), new, frozenset(nodes - new.keys()))
            tried -= torn

    def is_carried(self, node: Node, known: dict[Node, Chain]) -> bool:
        """Whether what a phi has in the next turn is there too."""
        if node not in self.program.carried:
            return True
        following = sources(self.program, self.program.carried[node])
        return all(source.number in known for source in following)

    def waited_for(self, attempt: _Attempt, here: Path) -> set[Node]:
        """Of a loop's nodes those that something outside of such loops needs."""
        wanted: set[Node] = set()
        stack = [
            source.number
            for source, user in self.users
            if source.number in attempt.placed
            and user not in attempt.placed
            and (
                self.paths[user][: len(here)] != here
                or not dict(source.fixed).keys().isdisjoint(here)
            )
        ]
        while stack:
            node = stack.pop()
            if node in attempt.placed and node not in wanted:
                wanted.add(node)
                given = list(self.needs[node])
                if node in self.program.carried:
                    given += sources(self.program, self.program.carried[node])
                stack.extend(source.number for source in given)
        return wanted


def _order(node: Node) -> tuple[int, int, int]:
    """Instructions in their order, then stores."""
    return (1, node.result, node.entry) if isinstance(node, Store) else (0, node, 0)


def _is_inside(made: Chain, source: Source, chain: Chain) -> bool:
    """Whether a loop that must be over goes on around both."""
    return any(loop in chain and loop[1] in dict(source.fixed) for loop in made)
