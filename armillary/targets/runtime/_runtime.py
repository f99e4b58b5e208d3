"""What every kernel does around its arithmetic: shapes, guards, statuses.

Works on any array library that array-api-compat knows: NumPy, PyTorch, JAX, dask, CuPy.
"""

import math
from collections.abc import Iterator
from typing import Any

import array_api_compat
import numpy as np
from array_api_compat import numpy as array_api_numpy

NOT_FINITE, OUT_OF_RANGE = -1, -2
TOLERANCE = 1e-3
_COLUMNS = ((0, 3, 6), (1, 4, 7), (2, 5, 8))


def _dot(first: tuple[int, ...], second: tuple[int, ...], value: float) -> tuple[Any, ...]:
    return tuple((1, pair) for pair in zip(first, second, strict=True)), value, TOLERANCE


# What the parts of a unit vector and of a rotation owe together: signed products whose sum must be
# near a value. Of matrices with orthonormal columns, the determinant tells a reflection.
_FORMS = {
    3: [_dot((0, 1, 2), (0, 1, 2), 1.0)],
    9: [
        *(_dot(column, column, 1.0) for column in _COLUMNS),
        *(_dot(_COLUMNS[i], _COLUMNS[j], 0.0) for i, j in ((0, 1), (0, 2), (1, 2))),
        (
            (
                (1, (0, 4, 8)),
                (1, (1, 5, 6)),
                (1, (2, 3, 7)),
                (-1, (2, 4, 6)),
                (-1, (1, 3, 8)),
                (-1, (0, 5, 7)),
            ),
            1.0,
            1.0,
        ),
    ],
}


class Call:
    """One call of a kernel: checks the inputs, then assembles the results.

    Args:
        arguments: for each input (name, value, low, high, safe) and for a vector a sixth entry:
            whether it must have norm 1. A rotation has nine entries in `safe`, row-major, and its
            columns must be orthonormal. `safe` stands in where the input is refused, so that the
            arithmetic raises no warning there. A seventh entry is the shape of what runs over an
            index; the kernel takes its parts as one tuple.
    """

    def __init__(self, *arguments: tuple[Any, ...]) -> None:
        arrays = [a[1] for a in arguments if array_api_compat.is_array_api_obj(a[1])]
        # Beside another library's arrays, NumPy's are plain numbers: they follow those.
        leading = [x for x in arrays if not isinstance(x, np.ndarray | np.generic)]
        self.xp = array_api_compat.array_namespace(*leading) if leading else array_api_numpy
        self.device = array_api_compat.device(leading[0]) if leading else None
        self.dtype = self._dtype(leading or arrays)
        with np.errstate(over="ignore", invalid="ignore"):
            # What float32 cannot hold becomes infinite, and is refused below.
            raw = [c for a in arguments for c in self._components(*a)]
        shaped = self.xp.broadcast_arrays(*raw) if raw else [self.xp.asarray(0.0, dtype=self.dtype)]
        self._zero = self.xp.zeros_like(shaped[0])
        self.status = self.xp.astype(self._zero, self.xp.int8)
        self._guard(arguments, list(shaped))

    def _dtype(self, arrays: list[Any]) -> Any:
        kinds = [a.dtype for a in arrays if self.xp.isdtype(a.dtype, "real floating")]
        if not kinds:
            return self.xp.float64
        # Half precision cannot hold the limits that the guards compare with.
        return self.xp.result_type(self.xp.float32, *kinds)

    def _components(self, name: str, value: Any, *bounds: Any) -> list[Any]:
        if value is None:
            raise TypeError(f"{name} is missing: the kernel needs it")
        if isinstance(value, np.ndarray | np.generic) or not hasattr(value, "dtype"):
            plain = np.asarray(value)
            if plain.dtype.kind not in "biuf":
                raise TypeError(f"{name} must be real numbers, not {plain.dtype}")
            value = plain
            if self.device is not None:
                numbers = plain.astype(np.float64).tolist()
                value = self.xp.asarray(numbers, dtype=self.dtype, device=self.device)
        elif self.xp.isdtype(value.dtype, "complex floating"):
            raise TypeError(f"{name} must be real numbers, not {value.dtype}")
        value = self.xp.astype(self.xp.asarray(value), self.dtype)
        if len(bounds) == 3:
            return [value]
        if len(bounds) == 5:
            return self._parts(value, name, bounds[4], "an array")
        if len(bounds[2]) == 9:
            return self._parts(value, name, (3, 3), "a rotation")
        return self._parts(value, name, (3,), "a vector")

    def _parts(self, value: Any, name: str, shape: tuple[int, ...], kind: str) -> list[Any]:
        """The numbers on the last axes, row-major."""
        if value.ndim < len(shape) or tuple(value.shape[-len(shape) :]) != shape:
            raise ValueError(f"{name} is {kind}: {lengths(shape)}")
        return [value[(..., *place)] for place in np.ndindex(*shape)]

    def _guard(self, arguments: tuple[tuple[Any, ...], ...], values: list[Any]) -> None:
        xp, position = self.xp, 0
        checked: list[tuple[Any, float]] = []
        for argument in arguments:
            low, high = argument[2], argument[3]
            count = len(_tuple(argument[4]))
            group = values[position : position + count]
            position += count
            for value in group:
                self._refuse(xp.logical_and(value >= low, value <= high), value)
            if count > 1 and argument[5]:
                for terms, value, tolerance in _FORMS[count]:
                    self._refuse_form(group, terms, value, tolerance)
            checked += list(zip(group, _tuple(argument[4]), strict=True))
        fine = self.status >= 0
        values = [xp.where(fine, v, self._full(safe)) for v, safe in checked]
        self.values: tuple[Any, ...] = tuple(_grouped(arguments, values))

    def _refuse_form(self, parts: Any, terms: Any, value: float, tolerance: float) -> None:
        """A sum of signed products that must be near a value; wild parts are refused by now."""
        xp = self.xp
        used = sorted({k for _, places in terms for k in places})
        inside = xp.abs(parts[used[0]]) <= 2
        for k in used[1:]:
            inside = xp.logical_and(inside, xp.abs(parts[k]) <= 2)
        tame = {k: xp.where(inside, parts[k], xp.ones_like(parts[k])) for k in used}
        products = [(sign, math.prod(tame[k] for k in places)) for sign, places in terms]
        total = sum(sign * product for sign, product in products)
        fits = xp.logical_and(inside, xp.abs(total - value) <= tolerance)
        self._refuse(xp.logical_or(fits, xp.logical_not(inside)), total)

    def _refuse(self, fits: Any, value: Any) -> None:
        """Of several faults the most negative status wins."""
        xp = self.xp
        code = xp.where(xp.isfinite(value), self._code(OUT_OF_RANGE), self._code(NOT_FINITE))
        code = xp.where(fits, self._code(0), code)
        self.status = xp.where(code < self.status, code, self.status)

    def _code(self, number: int) -> Any:
        return self.xp.full_like(self.status, number)

    def _full(self, value: float) -> Any:
        return self.xp.full_like(self._zero, value)

    def select(self, condition: Any, then: Any, otherwise: Any) -> Any:
        """`then` where the condition holds, else `otherwise`; numbers are spread."""
        return self.xp.where(condition, self.spread(then), self.spread(otherwise))

    @property
    def never(self) -> Any:
        """A condition that holds nowhere."""
        return self._zero > 0

    def spread(self, value: Any) -> Any:
        """A number at every point; adding it to zeros would lose the sign of -0.0."""
        return self._full(value) if isinstance(value, (int, float)) else value

    def case(self, status: int, condition: Any) -> None:
        """Report a status where a condition holds; of negative ones the first call stays."""
        applies = self.xp.logical_and(condition, self.status >= 0)
        self.status = self.xp.where(applies, self._code(status), self.status)

    def array(self, shape: tuple[int, ...], entries: tuple[Any, ...]) -> Any:
        """The entries on trailing axes, NaN where the status is negative."""
        refused = self.status < 0
        nan = self._full(float("nan"))
        filled = [self.xp.where(refused, nan, self.spread(entry)) for entry in entries]
        if shape == ():
            return filled[0]
        stacked = self.xp.stack(filled, axis=-1)
        return self.xp.reshape(stacked, (*self._zero.shape, *shape))


def lengths(shape: tuple[int, ...]) -> str:
    """What is asked of the last axes of an array."""
    if shape == (3, 3):
        return "its last two axes must have length 3"
    if len(shape) == 1:
        return f"its last axis must have length {shape[0]}"
    return f"its last axes must have the lengths {', '.join(map(str, shape))}"


def _grouped(arguments: tuple[tuple[Any, ...], ...], values: list[Any]) -> Iterator[Any]:
    """The numbers one by one, those of an array that runs over an index together."""
    position = 0
    for argument in arguments:
        group = values[position : position + len(_tuple(argument[4]))]
        position += len(group)
        if len(argument) == 7:
            yield tuple(group)
        else:
            yield from group


def _tuple(safe: Any) -> tuple[Any, ...]:
    return safe if isinstance(safe, tuple) else (safe,)
