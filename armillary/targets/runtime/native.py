"""The same functions over the compiled C: `native.<system>.<kernel>(...)`.

The library is built with the machine's C compiler on first use and cached. Inputs and results are
NumPy arrays; float32 inputs run the f32 kernels, everything else the f64 ones.
"""

import ctypes
import functools
from importlib import import_module
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np

from ._compiler import NoCompilerError, library
from ._signatures import FOLDER, PRECISIONS, PREFIX, SYSTEMS

__all__ = ["NoCompilerError"]

_HERE = Path(__file__).resolve().parent
_SHAPES: dict[int, tuple[int, ...]] = {1: (), 3: (3,), 9: (3, 3)}
_TYPES = {"f32": ("float", np.float32), "f64": ("double", np.float64)}


def sources() -> Path:
    """The folder of the C kernels: inside an installed package, or in the project beside it."""
    installed = _HERE / "_c"
    return installed if installed.is_dir() else _HERE.parents[1] / "c" / "src" / FOLDER


def __getattr__(system: str) -> Any:
    if system not in SYSTEMS:
        raise AttributeError(f"no system {system!r}; there are {', '.join(SYSTEMS)}")
    module = import_module(f".{system}", __package__)
    kernels = SYSTEMS[system]["kernels"]
    made = {name: _function(system, name, getattr(module, name), module) for name in kernels}
    globals()[system] = _System(system, made)
    return globals()[system]


class _System(SimpleNamespace):
    """The compiled kernels of one system."""

    def __init__(self, name: str, kernels: dict[str, Any]) -> None:
        super().__init__(**kernels)
        self._name = name

    def __getattr__(self, kernel: str) -> Any:
        names = ", ".join(SYSTEMS[self._name]["kernels"])
        raise AttributeError(f"{self._name} has no kernel {kernel!r}; it has {names}")


def __dir__() -> list[str]:
    return [*__all__, *SYSTEMS]


def _function(system: str, name: str, like: Any, module: Any) -> Any:
    result_type = getattr(module, "".join(w.capitalize() for w in name.split("_")) + "Result")

    @functools.wraps(like)
    def kernel(**arguments: Any) -> Any:
        return _call(system, name, arguments, result_type)

    return kernel


def _call(system: str, name: str, arguments: dict[str, Any], result_type: Any) -> Any:
    facts = SYSTEMS[system]["kernels"][name]
    sizes = dict([*facts["inputs"], *SYSTEMS[system]["parameters"]])
    unknown = sorted(set(arguments) - set(sizes))
    wanted = [q for q, _ in facts["inputs"]] + facts["reads"]
    missing = [q for q in wanted if arguments.get(q) is None]
    for problem, names in (("unknown", unknown), ("missing", missing)):
        if names:
            raise TypeError(f"{system}.{name}: arguments {problem}: {', '.join(names)}")
    precision = _precision([arguments[q] for q in wanted])
    dtype = _TYPES[precision][1]
    with np.errstate(over="ignore", invalid="ignore"):
        # What float32 cannot hold becomes infinite, and the kernel refuses it.
        arrays = [_real(q, arguments[q], dtype) for q in wanted]
    for q, a in zip(wanted, arrays, strict=True):
        _check_shape(q, a.shape, sizes[q])
    shapes = [
        a.shape[: a.ndim - len(_SHAPES[sizes[q]])] for q, a in zip(wanted, arrays, strict=True)
    ]
    batch = np.broadcast_shapes(*shapes) if shapes else ()
    spread = [
        _spread(a, s, batch, sizes[q]) for q, a, s in zip(wanted, arrays, shapes, strict=True)
    ]
    steps = [0 if s == () else sizes[q] for q, s in zip(wanted, shapes, strict=True)]
    results = [np.empty((*batch, *shape), dtype) for _, shape in facts["results"]]
    status = np.empty(batch, np.int8)
    function = getattr(_library(), f"batch_{system}_{name}_{precision}")
    function(
        ctypes.c_size_t(int(np.prod(batch, dtype=np.int64))),
        _pointers(spread),
        (ctypes.c_size_t * max(1, len(steps)))(*steps),
        _pointers(results),
        status.ctypes.data_as(ctypes.c_void_p),
    )
    return result_type(*results, status)


def _check_shape(name: str, shape: tuple[int, ...], size: int) -> None:
    wanted = _SHAPES[size]
    if shape[len(shape) - len(wanted) :] != wanted or len(shape) < len(wanted):
        kind, axes = ("vector", "axis") if size == 3 else ("rotation", "two axes")
        raise ValueError(f"{name} is a {kind}: its last {axes} must have length 3")


def _real(name: str, value: Any, dtype: Any) -> Any:
    found = np.asarray(value)
    if found.dtype.kind not in "biuf":
        raise TypeError(f"{name} must be real numbers, not {found.dtype}")
    return np.asarray(found, dtype=dtype, order="C")


def _precision(values: list[Any]) -> str:
    arrays = [v for v in values if isinstance(v, (np.ndarray, np.generic))]
    kinds = {v.dtype for v in arrays if v.dtype.kind == "f"}
    single = kinds == {np.dtype(np.float32)} and "f32" in PRECISIONS
    return "f32" if single or "f64" not in PRECISIONS else "f64"


def _spread(array: Any, shape: tuple[int, ...], batch: tuple[int, ...], size: int) -> Any:
    """A scalar stays one value that every point reads; anything else fills the batch."""
    if shape == ():
        return array
    full = (*batch, *_SHAPES[size])
    return np.asarray(np.broadcast_to(array, full), order="C")


def _pointers(arrays: list[Any]) -> Any:
    made = (ctypes.c_void_p * max(1, len(arrays)))()
    for k, a in enumerate(arrays):
        made[k] = a.ctypes.data
    return made


@functools.cache
def _library() -> Any:
    return ctypes.CDLL(str(library(sources(), batch_source())))


def batch_source() -> str:
    """C that calls each kernel over a batch; a step of 0 repeats one value."""
    lines = ["#include <float.h>", "#include <math.h>", "#include <stddef.h>"]
    lines += [f'#include "{system}.h"' for system in SYSTEMS]
    for system, facts in SYSTEMS.items():
        for name in facts["kernels"]:
            for precision in PRECISIONS:
                lines += _batch_function(system, name, precision)
    return "\n".join(lines) + "\n"


def _batch_function(system: str, name: str, precision: str) -> list[str]:
    facts, parameters = SYSTEMS[system]["kernels"][name], SYSTEMS[system]["parameters"]
    kind = _TYPES[precision][0]
    symbol = f"{system}_{name}_{precision}"
    lines = [
        f"void batch_{symbol}(size_t n, const {kind} *const *in, const size_t *step,",
        f"                    {kind} *const *out, signed char *status);",
        f"void batch_{symbol}(size_t n, const {kind} *const *in, const size_t *step,",
        f"                    {kind} *const *out, signed char *status)",
        "{",
        "  (void)in; (void)step; (void)out;",
        "  for (size_t i = 0; i < n; i++) {",
    ]
    call = []
    if parameters:
        lines.append(f"    {PREFIX}{system}_params_{precision} p = {{0}};")
        call.append("&p")
        sizes = dict(parameters)
        for k, field in enumerate(facts["reads"], len(facts["inputs"])):
            where = f"in[{k}] + (i * step[{k}])"
            for c in range(sizes[field]):
                target = f"p.{field}" if sizes[field] == 1 else f"p.{field}[{c}]"
                lines.append(f"    {target} = ({where})[{c}];")
    for k, (_, size) in enumerate(facts["inputs"]):
        where = f"in[{k}] + (i * step[{k}])"
        call.append(where if size > 1 else f"*({where})")
    clear = []
    for k, (_, shape) in enumerate(facts["results"]):
        size = int(np.prod(shape, dtype=np.int64))
        call.append(f"out[{k}] + (i * {size})")
        clear.append(
            f"      for (int k = 0; k < {size}; k++) {{ out[{k}][(i * {size}) + k] = NAN; }}"
        )
    lines.append(f"    const int s = {PREFIX}{symbol}({', '.join(call)});")
    lines += ["    if (s < 0) {", *clear, "    }", "    status[i] = (signed char)s;", "  }", "}"]
    return lines
