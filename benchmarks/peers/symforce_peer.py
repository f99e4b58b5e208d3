"""SymForce: its default backend (SymEngine), its own elimination of common subexpressions."""

from __future__ import annotations

import importlib
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from benchmarks.matrices import Matrix, Recipe, Scalar, Vector
from benchmarks.peers import ENTRY, Generated, Peer, scalar_call
from benchmarks.recipes import Kernel

PEER = Peer("SymForce", package="symforce", module="symforce")
OPTIONS = ("default",)

# Named only by functions whose arguments are matrices; these take scalars.
UNUSED_INCLUDE = "#include <Eigen/Core>"


class SymForceOps:
    """The recipe's operations in SymForce."""

    def __init__(self, sf: Any) -> None:
        """Borrow the functions of the imported module."""
        self.sin, self.cos, self.sqrt = sf.sin, sf.cos, sf.sqrt
        self._sf = sf

    def atan2(self, y: Scalar, x: Scalar, /) -> Scalar:
        """The plain angle: SymForce shifts `x` by an epsilon unless told not to."""
        return self._sf.atan2(y, x, epsilon=0)

    def named(self, values: Vector, /) -> Vector:
        """As they are: an expression is not written out where it is used."""
        return values

    def jacobian(self, values: Vector, variables: Vector, /) -> Matrix:
        """Entry by entry with `diff`."""
        return [[self._sf.sympify(y).diff(x) for x in variables] for y in values]


def generate(kernel: Kernel, recipe: Recipe) -> Iterator[Generated]:
    """The C++ function that SymForce writes by default, with scalars for arguments."""
    sf: Any = importlib.import_module("symforce.symbolic")
    codegen: Any = importlib.import_module("symforce.codegen")
    settings: Any = importlib.import_module("symforce.codegen.codegen_config")
    make_values: Any = importlib.import_module("symforce.values").Values
    symbols = [sf.Symbol(name) for name in kernel.inputs]
    inputs, outputs = make_values(), make_values()
    for name, symbol in zip(kernel.inputs, symbols, strict=True):
        inputs[name] = symbol
    for i, value in enumerate(recipe(SymForceOps(sf), list(symbols))):
        outputs[f"out_{i}"] = sf.sympify(value)
    config = codegen.CppConfig(
        render_template_config=settings.RenderTemplateConfig(autoformat=False),
        zero_epsilon_behavior=settings.ZeroEpsilonBehavior.ALLOW,
    )
    with tempfile.TemporaryDirectory(prefix="symforce-") as folder:
        function = codegen.Codegen(inputs, outputs, config=config, name=ENTRY)
        done = function.generate_function(output_dir=Path(folder), skip_directory_nesting=True)
        source = Path(done.generated_files[0]).read_text()
    source = source.replace(UNUSED_INCLUDE, "").replace("#pragma once", "")
    entry = "sym::" + "".join(word.capitalize() for word in ENTRY.split("_"))
    targets = [f"out + {i}" for i in range(kernel.n_out)]
    yield Generated(*OPTIONS, source, scalar_call(entry, len(symbols), targets))
