"""The same functions over the compiled C: `native.<system>.<kernel>(...)`.

The library is built with the machine's C compiler on first use and cached. Inputs and results are
NumPy arrays; float32 inputs run the f32 kernels, everything else the f64 ones.

A kernel that is called a million times is prepared once: `native.<system>.<kernel>.prepare(...)`
takes the same arguments and gives a `Prepared` call, which allocates nothing when it runs.

Where a kernel has a set-up and a step, `<kernel>_setup(...)` takes what changes with the mount and
gives a `Context`; `<kernel>_step(context, ...)` takes the rest, and may be prepared too.
"""

import ctypes
import functools
from collections.abc import Callable
from importlib import import_module
from math import prod
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np

from ._batch import batch_source, stages_files, stages_source
from ._compiler import NoCompilerError, library
from ._runtime import lengths
from ._signatures import FOLDER, PRECISIONS, SYSTEMS

__all__ = ["Context", "NoCompilerError", "Prepared"]

_HERE = Path(__file__).resolve().parent
_TYPES = {"f32": np.float32, "f64": np.float64}
_KINDS = {(3,): "a vector", (3, 3): "a rotation"}


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
    for name, facts in kernels.items():
        if "stages" in facts:
            made |= _stages(system, name, module)
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
    result_type = _result_type(name, module)

    @functools.wraps(like)
    def kernel(**arguments: Any) -> Any:
        call = _Call(system, name, arguments)
        results = call.results()
        call.function()(*call.pointers(call.spread, results))
        return result_type(*results)

    def prepare(**arguments: Any) -> Prepared:
        """A call of this kernel that may run many times; see `Prepared`."""
        return Prepared(_Call(system, name, arguments), result_type)

    kernel.prepare = prepare  # type: ignore[attr-defined]
    return kernel


def _result_type(name: str, module: Any) -> Any:
    return getattr(module, "".join(w.capitalize() for w in name.split("_")) + "Result")


def _stages(system: str, name: str, module: Any) -> dict[str, Any]:
    """The set-up and the step of a kernel."""
    result_type = _result_type(name, module)

    def setup(**arguments: Any) -> Context:
        return Context(_Call(system, name, arguments, "setup"))

    def step(context: Context, **arguments: Any) -> Any:
        call = _Call(system, name, arguments, "step", context)
        results = call.results()
        call.function()(*call.pointers(call.spread, results))
        return result_type(*results)

    def prepare(context: Context, **arguments: Any) -> Prepared:
        """A step of this kernel that may run many times; see `Prepared`."""
        return Prepared(_Call(system, name, arguments, "step", context), result_type)

    step.prepare = prepare  # type: ignore[attr-defined]
    for stage, made in (("setup", setup), ("step", step)):
        made.__name__ = made.__qualname__ = f"{name}_{stage}"
        made.__doc__ = _told(system, name, stage)
    return {f"{name}_setup": setup, f"{name}_step": step}


def _told(system: str, name: str, stage: str) -> str:
    facts = SYSTEMS[system]["kernels"][name]["stages"][stage]
    names = ", ".join([q for q, _ in facts["inputs"]] + facts["reads"])
    if stage == "setup":
        return f"What the steps of `{name}` read of the mount, from {names}: one mount a call."
    return f"`{name}` after its set-up, from its context and {names or 'nothing else'}."


class Context:
    """What a set-up left for the steps of its kernel, in one precision.

    Attributes:
        status: what the set-up answered; where it is negative no step runs.
    """

    status: int

    def __init__(self, call: "_Call") -> None:
        if call.batch:
            raise ValueError(f"{call.name}_setup sets up one mount, not a batch")
        self.kernel, self.precision = (call.system, call.name), call.precision
        symbol = f"{call.system}_{call.name}_setup_{call.precision}"
        size = getattr(_stages_library(), f"size_{symbol}")
        size.restype = ctypes.c_size_t
        self.memory = ctypes.create_string_buffer(size())
        one = getattr(_stages_library(), f"one_{symbol}")
        self.status = int(one(_pointers(call.spread), self.memory))


class Prepared:
    """A call with memory of its own: fill `inputs`, `run()`, read `results`.

    Nothing is checked or allocated when it runs: about 1 microsecond and the kernel's own time for
    each point of the batch. Write into the arrays, `call.inputs["alpha"][...] = 0.3`; an array put
    in their place is not seen. `run` is a function of no arguments, kept once by those who call it
    in a loop: `run = call.run`.

    The update of a controller keeps its states: a state among `inputs` is that among `results`, so
    the next run starts where this one ended. Where the status is negative, results are NaN and the
    states are what they were.

    Attributes:
        inputs: the arrays that are read, by name: one number where one was given, which every
            point of the batch reads, else one for each point; parameters too.
        results: the kernel's NamedTuple, of arrays that every run writes; read or copy them.
        run: computes the results from the inputs.
    """

    inputs: dict[str, Any]
    results: Any
    run: Callable[[], None]

    def __init__(self, call: "_Call", result_type: Any) -> None:
        kept = [q for q, _ in call.facts.get("states", []) if q in call.wanted]
        self.inputs = {q: a.copy() for q, a in zip(call.wanted, call.spread, strict=True)}
        for q in kept:
            full = (*call.batch, *call.shapes[q])
            self.inputs[q] = np.array(np.broadcast_to(self.inputs[q], full), order="C")
            call.steps[call.wanted.index(q)] = prod(call.shapes[q])
        results = call.results()
        names = [q for q, _ in call.facts["results"]]
        for q in kept:
            results[names.index(q)] = self.inputs[q]
        self.results = result_type(*results)
        pointers = call.pointers(list(self.inputs.values()), results)
        self.run = functools.partial(call.function(), *pointers)


class _Call:
    """The arguments of one call, checked, in one precision."""

    def __init__(
        self,
        system: str,
        name: str,
        arguments: dict[str, Any],
        stage: str = "",
        context: Context | None = None,
    ) -> None:
        self.system, self.name, self.stage, self.context = system, name, stage, context
        kernel = SYSTEMS[system]["kernels"][name]
        self.facts = kernel["stages"][stage] if stage else kernel
        self.shapes = dict([*SYSTEMS[system]["parameters"], *self.facts["inputs"]])
        self.wanted = [q for q, _ in self.facts["inputs"]] + self.facts["reads"]
        self._check_names(arguments)
        if stage == "step":
            self.precision = self._precision_of(context)
        else:
            self.precision = _precision([arguments[q] for q in self.wanted])
        self.dtype = _TYPES[self.precision]
        with np.errstate(over="ignore", invalid="ignore"):
            # What float32 cannot hold becomes infinite, and the kernel refuses it.
            arrays = [_real(q, arguments[q], self.dtype) for q in self.wanted]
        batches = [self._batch_of(q, a.shape) for q, a in zip(self.wanted, arrays, strict=True)]
        self.batch: tuple[int, ...] = np.broadcast_shapes(*batches) if batches else ()
        self.steps: list[int] = []
        self.spread: list[Any] = []
        for q, array, batch in zip(self.wanted, arrays, batches, strict=True):
            # What is the same at every point stays one value that every point reads.
            full = (*self.batch, *self.shapes[q])
            one = batch == ()
            self.spread.append(
                array if one else np.asarray(np.broadcast_to(array, full), order="C")
            )
            self.steps.append(0 if one else prod(self.shapes[q]))

    def _precision_of(self, context: Context | None) -> str:
        """That of the set-up, which must be one of this kernel that succeeded."""
        if context is None or getattr(context, "kernel", None) != (self.system, self.name):
            raise TypeError(f"{self.name}_step needs the context of {self.name}_setup")
        if context.status < 0:
            raise ValueError(f"{self.name}_setup answered {context.status}: it left no context")
        return context.precision

    def _check_names(self, arguments: dict[str, Any]) -> None:
        unknown = sorted(set(arguments) - set(self.shapes))
        missing = [q for q in self.wanted if arguments.get(q) is None]
        for problem, names in (("unknown", unknown), ("missing", missing)):
            if names:
                listed = ", ".join(names)
                raise TypeError(f"{self.system}.{self.name}: arguments {problem}: {listed}")

    def _batch_of(self, name: str, shape: tuple[int, ...]) -> tuple[int, ...]:
        wanted = self.shapes[name]
        if shape[len(shape) - len(wanted) :] != wanted or len(shape) < len(wanted):
            parts = name in SYSTEMS[self.system]["arrays"]
            kind = "an array" if parts else _KINDS.get(wanted, "an array")
            raise ValueError(f"{name} is {kind}: {lengths(wanted)}")
        return shape[: len(shape) - len(wanted)]

    def results(self) -> list[Any]:
        """New arrays for the results and the status."""
        made = [np.empty((*self.batch, *s), self.dtype) for _, s in self.facts["results"]]
        return [*made, np.empty(self.batch, np.int8)]

    def function(self) -> Any:
        """The compiled function."""
        stage = f"_{self.stage}" if self.stage else ""
        made = _stages_library() if stage else _library()
        return getattr(made, f"batch_{self.system}_{self.name}{stage}_{self.precision}")

    def pointers(self, inputs: list[Any], results: list[Any]) -> tuple[Any, ...]:
        """What the compiled function takes; the arrays must outlive it."""
        context = () if self.context is None else (self.context.memory,)
        return (
            *context,
            ctypes.c_size_t(prod(self.batch)),
            _pointers(inputs),
            (ctypes.c_size_t * max(1, len(self.steps)))(*self.steps),
            _pointers(results[:-1]),
            results[-1].ctypes.data_as(ctypes.c_void_p),
        )


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


def _pointers(arrays: list[Any]) -> Any:
    made = (ctypes.c_void_p * max(1, len(arrays)))()
    for k, a in enumerate(arrays):
        made[k] = a.ctypes.data
    # As long as the pointers live, so do the arrays.
    made.arrays = arrays  # type: ignore[attr-defined]
    return made


@functools.cache
def _library() -> Any:
    apart = stages_files()
    names = sorted(path.name for path in sources().glob("*.c") if path.name not in apart)
    return ctypes.CDLL(str(library(sources(), names, batch_source())))


@functools.cache
def _stages_library() -> Any:
    """Set-ups and steps: a library of its own, built only for those who use them."""
    return ctypes.CDLL(str(library(sources(), sorted(stages_files()), stages_source())))
