"""What to do about an error of Python that reading a derivation met."""

from __future__ import annotations

import linecache
import re
import sys
from pathlib import Path

import sympy

from armillary.algebra.misuse import MisuseError
from armillary.derivation.beside import PREFIX
from armillary.derivation.errors import Source

# What stands in a message of Python, and the mend of it; the first that is found is told.
_TYPE_ERRORS = (
    (r"'because'", "say in because= why this step is taken; the page prints it"),
    (r"'meaning'", "say in a few words what it is, after its name"),
    (r"missing .* argument", "give the argument that is missing"),
    (r"unexpected keyword argument", "correct the spelling of that argument, or leave it out"),
    (r"positional argument", "name the arguments after the first ones, as in because="),
    (r"no unit rule", "add vectors to vectors and scalars to scalars; wrap numbers in number(...)"),
    (r"bad operand type for abs", "use armillary.absolute(x), not abs(x)"),
    (r"not callable", "write * between factors; only functions take parentheses"),
    (r"not (subscriptable|iterable)", "a scalar has no components; give a list where one is asked"),
    (
        r"unsupported operand|not supported between",
        "add vectors to vectors and scalars to scalars; rotations and poses act with @",
    ),
)
_FOREIGN = re.compile(r"(real|complex) number|ufunc|annot sympify")
_CALL = re.compile(r"\b(math|cmath|np|numpy|sympy|sp)\.(\w+)\s*\(")
# What other libraries call a function, and how it is written here.
_OURS = {
    **{name: f"armillary.{name}" for name in ("sin", "cos", "sqrt", "atan2", "hypot")},
    **dict.fromkeys(("fabs", "abs", "Abs", "absolute"), "armillary.absolute"),
    **dict.fromkeys(("radians", "deg2rad", "rad"), "armillary.degrees(a number of degrees)"),
    "arctan2": "armillary.atan2",
    "tan": "sin(x) / cos(x)",
    **dict.fromkeys(("atan", "arctan"), "atan2(x, 1)"),
    **dict.fromkeys(("asin", "arcsin"), "atan2(x, sqrt(1 - x * x))"),
    **dict.fromkeys(("acos", "arccos"), "atan2(sqrt(1 - x * x), x)"),
}


def told_and_mended(problem: Exception, source: Source) -> tuple[str, str]:
    """The problem in words, and the mend."""
    if isinstance(problem, MisuseError):
        return problem.problem, problem.mend
    return f"{type(problem).__name__}: {problem}", _mend(problem, source)


def _mend(problem: Exception, source: Source) -> str:
    if isinstance(problem, NameError):
        return (
            f"declare {problem.name} above this line, or import it: "
            f"`from armillary import {problem.name}` if it is a word of armillary"
        )
    if isinstance(problem, ImportError):
        return _of_import(problem, source)
    if isinstance(problem, SyntaxError):
        return "complete this line, or the one before it, as Python wants it"
    if isinstance(problem, (TypeError, sympy.SympifyError)):
        return _of_type(problem, source)
    if isinstance(problem, ValueError) and "frame" in str(problem):
        return "name each frame once with frame=, and ask only for frames of this chain"
    if isinstance(problem, ValueError) and "axis" in str(problem):
        return "write X, Y or Z: `from armillary import X, Y, Z`"
    if isinstance(problem, ZeroDivisionError):
        return "divide by something that is not 0"
    if isinstance(problem, AttributeError):
        # NumPy asks an object that it does not know for the function's name.
        call = _call(source)
        if call is not None and call[2] == problem.name:
            return _instead_of(call)
        return "correct the spelling of what follows the point"
    return "mend this line; the derivation could not be read to its end"


def _of_import(problem: ImportError, source: Source) -> str:
    package, _, module = (problem.name or "").partition(".")
    if package.startswith(PREFIX):
        return _of_beside(module, isinstance(problem, ModuleNotFoundError))
    if problem.name is None and "relative import" in str(problem):
        return '`d.use("name")` is the way to another system; imports stay in one folder'
    if Path(source.path).with_name(f"{package}.py").is_file():
        return f"write a point before its name, as it stands beside: from .{package} import ..."
    if package != "armillary":
        return (
            f"correct the spelling of {package}, or install it beside armillary; "
            "a derivation needs only `from armillary import ...`"
        )
    words = getattr(sys.modules.get(problem.name or ""), "__all__", None)
    if words is None:
        return "import what a derivation needs with `from armillary import ...`"
    return f"import words that armillary has: {', '.join(words)}"


def _of_beside(module: str, missing: bool) -> str:
    """The mend of an import from a file beside the derivation."""
    if missing:
        return f"write {module}.py beside derivation.py, or correct the name after the point"
    return (
        f"correct the spelling of what is imported from {module}.py; "
        "two files that import each other do not work"
    )


def _of_type(problem: Exception, source: Source) -> str:
    text = str(problem)
    if isinstance(problem, sympy.SympifyError) or _FOREIGN.search(text):
        return _instead_of(_call(source))
    for pattern, mend in _TYPE_ERRORS:
        if re.search(pattern, text):
            return mend
    return "mend this line; the derivation could not be read to its end"


def _call(source: Source) -> re.Match[str] | None:
    """The call of another library's function on the line of the error."""
    return _CALL.search(linecache.getline(source.path, source.line))


def _instead_of(call: re.Match[str] | None) -> str:
    if call is None or call[2] not in _OURS:
        return "use armillary.sin, armillary.cos, ..., not the functions of other libraries"
    return f"use {_OURS[call[2]]}, not {call[1]}.{call[2]}: that keeps the expression"
