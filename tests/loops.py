"""Programs with loops, built by hand: each tells one thing that a loop may do."""

import random

import sympy

from armillary import Derivation, Matrix
from armillary.algebra.index import Index
from armillary.algebra.scalar import ZERO
from armillary.derivation.errors import Source
from armillary.derivation.statements import Kernel, Output
from armillary.derivation.status import Status
from armillary.program.builder import Builder
from armillary.program.program import CLOSING_OPS, Op, Result

record = Derivation("hand", title="Loops by hand")
leg = record.index("leg", 3)
facet = record.index("facet", 2)
turn = Index("turn", 5, sequential=True)
again = Index("again", 4, sequential=True)
x = record.scalar("x", "a number")
y = record.scalar("y", "another number")
lengths = record.scalar("l", "a number for each leg", per=leg)
heights = record.scalar("h", "a number for each facet", per=facet)
vectors = record.vector("v", "a vector for each leg", per=leg)
POINT = {
    "x": 0.7,
    "y": -0.4,
    "l": [1.25, -0.5, 2.0],
    "h": [0.75, -1.5],
    "v": [0.1, 0.2, 0.3, -0.4, 0.5, -0.6, 0.7, -0.8, 0.9],
}


class Hand(Builder):
    """A builder with its inputs at hand."""

    def __init__(self):
        super().__init__()
        self.x, self.y = (self.emit(Op.INPUT, data=name) for name in "xy")
        self.l = self.emit(Op.INPUT, data=("l", leg, 1, 0))
        self.h = self.emit(Op.INPUT, data=("h", facet, 1, 0))
        self.v = [self.emit(Op.INPUT, data=("v", leg, 3, k)) for k in range(3)]

    def number(self, value):
        return self.constant(sympy.nsimplify(value))

    def values(self, index, *numbers):
        return self.table(index, [sympy.nsimplify(n) for n in numbers])

    def subtract(self, a, b):
        return self.add(a, self.negate(b))

    def square(self, a):
        return self.multiply(a, a)


def program_of(hand, results, cases=(), inputs=(x, y, lengths, heights, vectors)):
    """A finished program; a result is (entries, indices)."""
    made, outputs = [], []
    for name, (entries, indices) in results.items():
        width = len(entries)
        shape = (*(i.size for i in indices), *((width,) if width > 1 else ()))
        value = ZERO if width == 1 else Matrix(((ZERO,) * width,))
        if width > 1 and not indices:
            shape = (1, width)
        made.append(Result(name, shape, tuple(entries), tuple(indices)))
        outputs.append(Output(name, value, None, None, tuple(indices)))
    kernel = Kernel("hand", "k", "", inputs, (), tuple(outputs), (), Source("here", 1))
    return hand.finish(kernel, tuple(made), tuple(cases))


def tables():
    b = Hand()
    t = b.values(leg, 1, "1/2", "-1/3")
    product = b.multiply(b.sin(b.x), t)
    q = b.add(product, b.l)
    return program_of(b, {"q": ([q], [leg]), "first": ([b.element(q, leg, 0)], [])})


def sums():
    """A sum in a loop, and the sum of those; a sum over the outer index."""
    b = Hand()
    term = b.sin(b.add(b.multiply(b.l, b.h), b.x))
    inner, outer = b.sum(term, leg), b.sum(term, facet)
    results = {
        "inner": ([inner], [facet]),
        "outer": ([outer], [leg]),
        "all": ([b.sum(inner, facet)], []),
        "same": ([b.sum(b.square(b.multiply(outer, b.x)), leg)], []),
    }
    return program_of(b, results)


def conditions():
    """A condition kept from one loop to the next, and whether it holds at all."""
    b = Hand()
    below = b.less(b.l, b.x)
    some = b.any_of(below, leg)
    none = b.any_of(b.less(b.number(10), b.l), leg)
    shift = b.select(some, b.sum(b.select(below, b.l, b.y), leg), b.y)
    kept = b.select(below, shift, b.l)
    cases = [(Status.LIMIT, some), (Status.UNREACHABLE, none)]
    return program_of(b, {"kept": ([kept], [leg]), "shift": ([shift], [])}, cases)


def elements():
    """A second loop that needs the first one's sum and one of its values."""
    b = Hand()
    q = b.sqrt(b.add(b.square(b.l), b.square(b.x)))
    total = b.sum(q, leg)
    share = b.divide(q, total)
    turned = b.subtract(share, b.element(q, leg, 1))
    last = b.multiply(b.element(share, leg, 2), b.element(b.l, leg, 2))
    return program_of(b, {"r": ([share, turned, b.number(0)], [leg]), "s": ([last, total], [])})


def vectors_of_legs():
    """Vectors for each leg; two indices in the other order than they nest."""
    b = Hand()
    dot = b.add(b.multiply(b.v[0], b.v[1]), b.v[2])
    scaled = [b.multiply(b.v[k], b.h) for k in range(3)]
    results = {
        "dot": ([dot], [leg]),
        "m": (scaled, [facet, leg]),
        "n": ([scaled[1], dot], [leg, facet]),
    }
    return program_of(b, results)


def iteration():
    """Square roots by Newton, one for each leg."""
    b = Hand()
    square = b.add(b.square(b.l), b.number(1))
    root = b.phi(square, turn, "root")
    following = b.multiply(b.number("1/2"), b.add(root, b.divide(square, root)))
    b.carry(root, following)
    after = b.element(following, turn, turn.size - 1)
    left = b.subtract(b.square(after), square)
    results = {"root": ([after], [leg]), "left": ([b.sum(left, leg)], [])}
    return program_of(b, results)


def exchange():
    """Values that trade places; one that turns its sign."""
    b = Hand()
    first, second = b.phi(b.x, turn, "first"), b.phi(b.y, turn, "second")
    third, sign = b.phi(b.number(1), turn, "third"), b.phi(b.number(2), turn, "sign")
    b.carry(first, second)
    b.carry(second, third)
    b.carry(third, b.add(first, sign))
    b.carry(sign, b.negate(sign))
    ends = [b.element(b.carried[p], turn, 4) for p in (first, second, third, sign)]
    return program_of(b, {"ends": (ends, [])})


def loops_in_turns():
    """A loop in each turn, its sum and single values carried on."""
    b = Hand()
    z, w = b.phi(b.x, turn, "z"), b.phi(b.number(0), turn, "w")
    offset = b.multiply(b.y, b.values(leg, 1, 2, 3))
    q = b.sqrt(b.add(b.square(b.subtract(z, offset)), b.number(1)))
    b.carry(z, b.divide(b.add(b.sum(q, leg), z), b.number(5)))
    b.carry(w, b.subtract(b.element(q, leg, 0), b.element(q, leg, 2)))
    after = [b.element(b.carried[p], turn, 4) for p in (z, w)]
    ends = b.element(q, turn, 4)
    return program_of(b, {"after": (after, []), "ends": ([ends], [leg])})


def history():
    """What an iteration did on the way: a sum over turns, a turn in the middle, its start."""
    b = Hand()
    z = b.phi(b.x, turn, "z", over=[facet])
    step = b.sin(b.add(z, b.h))
    b.carry(z, b.multiply(step, b.y))
    travelled = b.sum(step, turn)
    results = {
        "travelled": ([travelled, b.element(step, turn, 2)], [facet]),
        "before": ([b.element(z, turn, 3), b.element(z, turn, 0)], [facet]),
        "all": ([b.sum(b.sum(b.square(z), turn), facet)], []),
    }
    return program_of(b, results)


def one_after_the_other():
    """An iteration that starts where one over the same turns ended, in a loop of its own."""
    b = Hand()
    z = b.phi(b.l, turn, "z")
    b.carry(z, b.cos(z))
    w = b.phi(b.element(b.carried[z], turn, 4), turn, "w")
    b.carry(w, b.add(w, b.sin(b.carried[z])))
    u = b.phi(b.sum(b.element(w, turn, 4), leg), again, "u")
    b.carry(u, b.multiply(u, b.x))
    results = {
        "w": ([b.element(b.carried[w], turn, 4)], [leg]),
        "u": ([b.element(b.carried[u], again, 3)], []),
    }
    return program_of(b, results)


PROGRAMS = {
    make.__name__: make
    for make in (
        tables, sums, conditions, elements, vectors_of_legs, iteration, exchange, loops_in_turns,
        history, one_after_the_other,
    )
}  # fmt: skip


def at_random(seed, size=40):
    """A program of operations and indices drawn at random."""
    chance, b = random.Random(seed), Hand()
    values = [b.x, b.y, b.l, b.h, *b.v, b.values(leg, 1, 2, -3), b.values(facet, "1/2", 2)]
    conditions = [b.less(b.x, b.l)]
    phis = []
    for _ in range(size):
        kind, a, c = chance.random(), chance.choice(values), chance.choice(values)
        indices = sorted(b.domains[a], key=str)
        if kind < 0.25:
            values.append(b.add(a, c))
        elif kind < 0.45:
            values.append(b.sin(b.multiply(a, c)))
        elif kind < 0.5:
            values.append(b.divide(a, b.add(b.square(c), b.number(1))))
        elif kind < 0.55:
            # A little apart, so that rounding does not decide between equals.
            conditions.append(b.less(a, b.add(c, b.number("0.0137"))))
            values.append(b.select(chance.choice(conditions), a, c))
        elif kind < 0.6:
            condition = chance.choice(conditions)
            for index in sorted(b.domains[condition], key=str):
                if chance.random() < 0.7:
                    condition = b.any_of(condition, index)
            values.append(b.select(condition, a, c))
        elif kind < 0.68 and indices:
            values.append(b.sum(a, chance.choice(indices)))
        elif kind < 0.8 and indices:
            index = chance.choice(indices)
            values.append(b.element(a, index, chance.randrange(index.size)))
        elif kind < 0.9 and turn not in indices:
            phis.append(b.phi(a, turn, f"p{len(phis)}", over=[leg, facet]))
            values.append(phis[-1])
        else:
            values.append(b.cos(a))
    for phi in phis:
        # What a part carries may depend on no other part, nor on a turn to come.
        causal = [v for v in values if not closes_over(b, v, phis)]
        b.carry(phi, b.sin(chance.choice(causal)))
    results = {}
    for k, value in enumerate(chance.sample(values, 8)):
        if turn in b.domains[value]:
            value = b.element(value, turn, chance.randrange(turn.size))
        order = sorted(b.domains[value], key=str)
        chance.shuffle(order)
        results[f"r{k}"] = ([value, b.x], order)
    return program_of(b, results)


def closes_over(b, number, phis):
    """Whether a value depends on an iteration through a sum or a single element."""
    stack, seen = [(number, False)], set()
    while stack:
        n, closed = stack.pop()
        if n in phis and closed:
            return True
        if (n, closed) not in seen:
            seen.add((n, closed))
            i = b.instructions[n]
            stack += [(a, closed or i.op in CLOSING_OPS) for a in i.args]
            stack += [(b.carried[n], closed)] if n in b.carried else []
    return False
