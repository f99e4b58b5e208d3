"""Armillary: derivations of machines that follow the sun, and the kernels printed from them.

The names that a derivation is written with are loaded when one is first asked for, so that a
command with nothing to derive does not wait for SymPy.
"""

from importlib import import_module
from typing import TYPE_CHECKING

__version__ = "0.1.0"

if TYPE_CHECKING:
    from armillary.vocabulary import *  # noqa: F403
else:

    def __getattr__(name: str) -> object:
        """One of the words of `armillary.vocabulary`; `__all__` is what a star imports."""
        if name == "__all__":
            return import_module("armillary.vocabulary").__all__
        if not name.startswith("__"):
            vocabulary = import_module("armillary.vocabulary")
            if name in vocabulary.__all__:
                globals()[name] = found = getattr(vocabulary, name)
                return found
        raise AttributeError(f"module 'armillary' has no attribute {name!r}")


def __dir__() -> list[str]:
    return ["__version__", *import_module("armillary.vocabulary").__all__]
