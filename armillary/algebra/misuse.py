"""Expressions that mean nothing here: what is wrong with them, and how to write them instead."""

from __future__ import annotations


class MisuseError(TypeError):
    """An expression was written in a way that has no meaning in a derivation."""

    def __init__(self, problem: str, mend: str) -> None:
        self.problem, self.mend = problem, mend
        super().__init__(f"{problem}; {mend}")


def told_shortly(node: object) -> str:
    """A node by its kind, and its name where it has one."""
    name = getattr(node, "name", "")
    return f"<{type(node).__name__}{' ' if name else ''}{name}>"


def told(value: object) -> str:
    """A value as an error tells it: short ones as they are, of others the type."""
    if value is None or isinstance(value, (bool, int, float, str)):
        return repr(value)
    return f"a value of type {type(value).__name__}"


def not_a_condition(value: object) -> MisuseError:
    """The error of what stands where a condition should; usually it came from `==`."""
    return MisuseError(
        f"a condition is wanted, not {told(value)}: == does not compare here",
        "use < and >, joined with & and ~",
    )


class NotANumberError(MisuseError, ValueError):
    """A value that cannot be taken as an exact real number."""


def not_a_number(value: object) -> NotANumberError:
    """The error of what stands where a number should."""
    if isinstance(value, bool):
        return NotANumberError(
            f"{value} is not a number: == does not compare here", "use where(a < b, x, y)"
        )
    return NotANumberError(
        f"{told(value)} is not a number",
        'give a finite number, or a decimal string such as "23.45"',
    )


def not_real(value: object) -> NotANumberError:
    """The error of an expression of SymPy that is no real number."""
    return NotANumberError(
        f"{value} of SymPy is not a real number",
        "declare its symbols as quantities, and combine them with the words of armillary",
    )
