"""Short ways from an expression to a program and to numbers."""

import numpy as np

from armillary import Derivation
from armillary.derivation.statements import Kernel, Output
from armillary.program.arithmetic import Floats, Reals
from armillary.program.evaluate import evaluate
from armillary.program.lower import Strategy, lower
from armillary.program.scalarise import scalarise

PLAIN = Strategy()


def kernel_of(record: Derivation, inputs, outputs, name="k") -> Kernel:
    """A kernel of a record that other tests share: it is not kept there."""
    record.kernels.pop(name, None)
    record.kernel(name, inputs=inputs, outputs=outputs)
    return record.kernels.pop(name)


def program_of(record, inputs, outputs, strategy=PLAIN):
    """The structured program of some outputs, before any pass."""
    return lower(kernel_of(record, inputs, outputs), strategy)


def opened(record, inputs, outputs):
    """The same in scalars."""
    return scalarise(program_of(record, inputs, outputs))


def value_of(program, point, name="r", arithmetic=None):
    """One result at a point."""
    return evaluate(program, point, arithmetic or Floats()).results[name]


def answers(**outputs):
    """Values of expressions that depend on nothing."""
    d = Derivation("answers", title="Answers")
    program = program_of(d, [d.angle("idle", "nothing")], outputs)
    return {name: np.array(value_of(program, {"idle": 0.0}, name)) for name in outputs}


def exact(point):
    """A point of floats and lists at 50 digits."""
    reals = Reals()
    return {
        n: [reals.number(c) for c in v] if isinstance(v, (list, tuple)) else reals.number(v)
        for n, v in point.items()
    }


__all__ = ["Kernel", "Output", "answers", "exact", "kernel_of", "opened", "program_of", "value_of"]
