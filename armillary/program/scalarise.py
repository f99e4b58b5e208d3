"""Opens vectors and rotations into scalars; zeros and ones disappear on the way."""

from __future__ import annotations

from collections.abc import Callable

from armillary.program.program import Instruction, Program
from armillary.program.rewrite import Rewriter

Triple = tuple[int, int, int]


def scalarise(program: Program) -> Program:
    """The same program without vector operations."""
    return _Scalarise(program).run()


class _Scalarise(Rewriter):
    def __init__(self, program: Program) -> None:
        super().__init__(program)
        self.vectors: dict[int, Triple] = {}

    def rewrite(self, number: int) -> int:
        instruction = self.program.instructions[number]
        rule = getattr(self, "open_" + instruction.op.value, None)
        if rule is None:
            return super().rewrite(number)
        opened = rule(instruction)
        if isinstance(opened, tuple):
            self.vectors[number] = opened
            return -1  # a vector has no number of its own any more
        return int(opened)

    def carry_labels(self, number: int) -> None:
        if number not in self.vectors:
            super().carry_labels(number)
            return
        for label in self.program.labels.get(number, ()):
            for name, component in zip(label.names, self.vectors[number], strict=True):
                self.builder.label(component, (name,), label.identifier)

    def open_pack(self, i: Instruction) -> Triple:
        x, y, z = (self.new[a] for a in i.args)
        return x, y, z

    def open_pick(self, i: Instruction) -> int:
        return self.vectors[i.args[0]][_whole(i)]

    def open_add_vectors(self, i: Instruction) -> Triple:
        left, right = (self.vectors[a] for a in i.args)
        return tuple(self.builder.add(a, b) for a, b in zip(left, right, strict=True))  # type: ignore[return-value]

    def open_negate_vector(self, i: Instruction) -> Triple:
        return tuple(self.builder.negate(a) for a in self.vectors[i.args[0]])  # type: ignore[return-value]

    def open_scale(self, i: Instruction) -> Triple:
        factor = self.new[i.args[0]]
        return tuple(self.builder.multiply(factor, a) for a in self.vectors[i.args[1]])  # type: ignore[return-value]

    def open_rotate(self, i: Instruction) -> Triple:
        sine, cosine = self.new[i.args[0]], self.new[i.args[1]]
        turned = list(self.vectors[i.args[2]])
        first, second = (_whole(i) + 1) % 3, (_whole(i) + 2) % 3
        b, p, q = self.builder, turned[first], turned[second]
        turned[first] = b.add(b.multiply(cosine, p), b.negate(b.multiply(sine, q)))
        turned[second] = b.add(b.multiply(sine, p), b.multiply(cosine, q))
        return turned[0], turned[1], turned[2]

    def open_cross(self, i: Instruction) -> Triple:
        x, y = self.vectors[i.args[0]], self.vectors[i.args[1]]
        b = self.builder

        def minor(j: int, k: int) -> int:
            return b.add(b.multiply(x[j], y[k]), b.negate(b.multiply(x[k], y[j])))

        return minor(1, 2), minor(2, 0), minor(0, 1)

    def open_dot(self, i: Instruction) -> int:
        x, y = self.vectors[i.args[0]], self.vectors[i.args[1]]
        b = self.builder
        terms = [b.multiply(p, q) for p, q in zip(x, y, strict=True)]
        return b.add(b.add(terms[0], terms[1]), terms[2])

    def open_sum(self, i: Instruction) -> int | Triple:
        return self._closed(i, lambda a: self.builder.sum(a, i.data))  # type: ignore[arg-type]

    def open_element(self, i: Instruction) -> int | Triple:
        return self._closed(i, lambda a: self.builder.element(a, *i.data))  # type: ignore[misc]

    def _closed(self, i: Instruction, rule: Callable[[int], int]) -> int | Triple:
        """A rule that takes an index away, for a scalar or for each component."""
        if i.args[0] not in self.vectors:
            return rule(self.new[i.args[0]])
        x, y, z = self.vectors[i.args[0]]
        return rule(x), rule(y), rule(z)


def _whole(i: Instruction) -> int:
    """The axis or the component of an instruction."""
    assert isinstance(i.data, int)
    return i.data
