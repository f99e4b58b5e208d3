"""Python text that is broken over lines stays Python."""

import ast

from armillary.derivation.record import Derivation
from armillary.program.compile import compile_kernel
from armillary.targets.python import PythonKernel, module_file

WIDTHS = range(60, 90)


def long_names() -> Derivation:
    """Kernels whose arguments fill a line, each by one letter more."""
    d = Derivation("long_names", title="Long names")
    second = d.scalar("rest", "the other part")
    for width in WIDTHS:
        first = d.scalar("a" * width, "one part")
        d.kernel(f"sum_{width}", inputs=[first, second], outputs={"s": first + second})
    return d


def test_arguments_of_any_length_are_unpacked():
    made = [
        PythonKernel(compiled.program, compiled.cost)
        for compiled in map(compile_kernel, long_names().kernels.values())
    ]
    text = module_file("long_names", "Long names", made, "0.1.0")
    ast.parse(text)
    unpacked = [line for line in text.splitlines() if line.endswith(") = call.values")]
    assert len(unpacked) == len(WIDTHS)
    assert {line.startswith("    (") for line in unpacked} == {True, False}
    assert max(map(len, unpacked)) <= 100
