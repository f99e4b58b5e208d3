"""What every kernel does around its arithmetic: shapes, guards, statuses.

Works on any array library that array-api-compat knows: NumPy, PyTorch, JAX, dask, CuPy.
"""

from typing import Any

import array_api_compat
import numpy as np
from array_api_compat import numpy as array_api_numpy

NOT_FINITE, OUT_OF_RANGE = -1, -2
UNIT_SQUARE_TOLERANCE = 1e-3


class Call:
    """One call of a kernel: checks the inputs, then assembles the results.

    Args:
        arguments: for each input (name, value, low, high, safe) and for a vector a sixth entry:
            whether it must have norm 1. `safe` stands in where the input is refused, so that the
            arithmetic raises no warning there.
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
        if value.ndim == 0 or value.shape[-1] != 3:
            raise ValueError(f"{name} is a vector: its last axis must have length 3")
        return [value[..., k] for k in range(3)]

    def _guard(self, arguments: tuple[tuple[Any, ...], ...], values: list[Any]) -> None:
        xp, position = self.xp, 0
        checked: list[tuple[Any, float]] = []
        for argument in arguments:
            low, high = argument[2], argument[3]
            count = 1 if len(argument) == 5 else 3
            group = values[position : position + count]
            position += count
            for value in group:
                self._refuse(xp.logical_and(value >= low, value <= high), value)
            if count == 3 and argument[5]:
                inside = xp.logical_and(
                    xp.abs(group[0]) <= 2,
                    xp.logical_and(xp.abs(group[1]) <= 2, xp.abs(group[2]) <= 2),
                )
                a, b, c = (xp.where(inside, x, xp.ones_like(x)) for x in group)
                square = a * a + b * b + c * c
                fits = xp.logical_and(inside, xp.abs(square - 1.0) <= UNIT_SQUARE_TOLERANCE)
                self._refuse(xp.logical_or(fits, xp.logical_not(inside)), square)
            checked += list(zip(group, _tuple(argument[4]), strict=True))
        fine = self.status >= 0
        self.values: tuple[Any, ...] = tuple(
            xp.where(fine, v, self._full(safe)) for v, safe in checked
        )

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
        return self.xp.where(condition, self._spread(then), self._spread(otherwise))

    def _spread(self, value: Any) -> Any:
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
        filled = [self.xp.where(refused, nan, self._spread(entry)) for entry in entries]
        if shape == ():
            return filled[0]
        stacked = self.xp.stack(filled, axis=-1)
        return self.xp.reshape(stacked, (*self._zero.shape, *shape))


def _tuple(safe: Any) -> tuple[Any, ...]:
    return safe if isinstance(safe, tuple) else (safe,)
