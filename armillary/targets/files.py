"""Every generated file of a project, as text in memory; writing them is somebody else's work."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from pprint import pformat

from armillary.derivation.errors import DerivationError
from armillary.derivation.fingerprint import definition_digest, kernel_definitions, kernel_digest
from armillary.derivation.record import Derivation
from armillary.derivation.statements import Kernel
from armillary.program.compile import Compiled, compile_kernel, compile_stages
from armillary.program.cost import Cost, cost
from armillary.program.guards import index_of_parts
from armillary.program.lower import Strategy
from armillary.program.program import Program
from armillary.program.stages import Stages
from armillary.targets import c, python

_RUNTIME = Path(__file__).parent / "runtime"
# How contexts are laid out beside their fields; another layout takes another word.
_CONTEXTS = "marked"


@dataclass(frozen=True)
class Target:
    """How a project wants its kernels.

    Attributes:
        package: name of the Python package.
        folder: folder that C headers are included from, `generated/c/src/<folder>`.
        c_prefix: put before every C symbol.
        precisions: which of "f32" and "f64" are printed.
        version: version stamped into the files.
    """

    package: str
    folder: str
    c_prefix: str
    precisions: tuple[str, ...]
    version: str

    @property
    def c(self) -> c.CTarget:
        return c.CTarget(self.folder, self.c_prefix, self.precisions, self.version)


@dataclass(frozen=True)
class StageFacts:
    """What is told of a set-up or a step.

    Attributes:
        digest: of its program.
        signatures: its C prototypes by precision.
        context: the C type of what is handed over, by precision.
        source: the C file, by precision, below the folder of the generated files.
    """

    digest: str
    cost: Cost
    signatures: dict[str, str]
    context: dict[str, str]
    source: dict[str, str]


@dataclass(frozen=True)
class KernelFacts:
    """What is told of a kernel beside its text.

    Attributes:
        stated: digest of what the derivation states of it.
        digest: of the program that was made of that.
        definitions: digest of each that it stands on, by id.
        signatures: its C prototypes by precision.
        stages: its "setup" and its "step", where it is divided.
    """

    name: str
    stated: str
    digest: str
    cost: Cost
    strategy: Strategy
    definitions: dict[str, str]
    signatures: dict[str, str]
    stages: dict[str, StageFacts] = field(default_factory=dict)


@dataclass(frozen=True)
class Rendered:
    """The files of one system (path below `generated/` to text) and its kernels' facts."""

    system: str
    files: dict[str, str]
    kernels: dict[str, KernelFacts]
    table: dict[str, object]


def render_system(
    derivation: Derivation,
    target: Target,
    progress: Callable[[Kernel], None] = lambda kernel: None,
) -> Rendered:
    """Compile and print every kernel of a system."""
    if derivation.name == "native":
        raise DerivationError(
            "a system may not be named native: the compiled kernels are imported by that name",
            "rename the system and its folder",
            derivation.source,
        )
    compiled: dict[str, Compiled] = {}
    stages: dict[str, Stages] = {}
    for name, kernel in derivation.kernels.items():
        progress(kernel)
        compiled[name] = compile_kernel(kernel)
        divided = compile_stages(compiled[name])
        if divided:
            _must_be_free(derivation, kernel)
            stages[name] = divided
    programs = [k.program for k in compiled.values()]
    abi = _abi(derivation, target, [*programs, *_both(stages)])
    files = {**_c_files(derivation, target, compiled, stages, abi)}
    files[f"python/{target.package}/{derivation.name}.py"] = python.module_file(
        derivation.name,
        derivation.title,
        [python.PythonKernel(k.program, k.cost) for k in compiled.values()],
        target.version,
    )
    facts = {
        name: _facts(derivation, made, stages.get(name), target) for name, made in compiled.items()
    }
    return Rendered(derivation.name, files, facts, _table(derivation, compiled, stages))


def _must_be_free(derivation: Derivation, kernel: Kernel) -> None:
    """The two functions of a divided kernel and what they share need their names."""
    for name in (f"{kernel.name}_{of}" for of in ("setup", "step", "ctx")):
        if name in derivation.kernels:
            raise DerivationError(
                f"{name} is what the stages of the kernel {kernel.name} are called",
                "give the kernel another name",
                derivation.kernels[name].source,
            )


def _both(stages: Mapping[str, Stages]) -> Iterator[Program]:
    for made in stages.values():
        yield from (made.setup, made.step)


def render_shared(target: Target, rendered: Mapping[str, Rendered]) -> dict[str, str]:
    """The files that systems share: statuses, the Python runtime, the table of signatures."""
    package = f"python/{target.package}"
    notice = python.NOTICE.format(version=target.version)
    systems = sorted(rendered)
    table = {name: rendered[name].table for name in systems}
    init = (
        f'{notice}"""Kernels of {", ".join(systems) or "no system yet"}."""\n\n'
        f'__version__ = "{target.version}"\n'
    )
    shared = {
        f"c/src/{target.folder}/armillary_status.h": c.status_header(target.version),
        f"{package}/__init__.py": init,
        f"{package}/_signatures.py": notice + _signatures(target, table),
    }
    for name in ("_runtime.py", "_compiler.py", "_batch.py", "native.py"):
        shared[f"{package}/{name}"] = notice + (_RUNTIME / name).read_text(encoding="utf-8")
    return shared


def _signatures(target: Target, table: dict[str, dict[str, object]]) -> str:
    """The module that tells the compiled kernels what they are called with."""
    lines = [
        '"""Arguments and results of every kernel, for the compiled kernels."""',
        "",
        f"FOLDER = {target.folder!r}",
        f"PREFIX = {target.c_prefix!r}",
        f"PRECISIONS = {target.precisions!r}",
        f"SYSTEMS = {pformat(table, width=90, sort_dicts=False)}",
    ]
    return "\n".join(lines) + "\n"


def _c_files(
    derivation: Derivation,
    target: Target,
    compiled: Mapping[str, Compiled],
    stages: Mapping[str, Stages],
    abi: str,
) -> dict[str, str]:
    made = {name: c.CKernel(k.program, k.cost, stages.get(name)) for name, k in compiled.items()}
    folder = f"c/src/{target.folder}"
    files = {
        f"{folder}/{derivation.name}.h": c.header_file(
            derivation.name,
            derivation.title,
            derivation.parameters,
            list(made.values()),
            target.c,
            abi,
        )
    }
    for name, kernel in made.items():
        for precision in target.precisions:
            stem = f"{folder}/{derivation.name}_{name}"
            files[f"{stem}_{precision}.c"] = c.source_file(kernel, target.c, precision, abi)
            if kernel.stages:
                text = c.stages_file(kernel.stages, target.c, precision, abi)
                files[f"{stem}_step_{precision}.c"] = text
    return files


def _abi(derivation: Derivation, target: Target, programs: Iterable[Program]) -> str:
    """A number that changes whenever any source or the header of a system does."""
    parts = [target.version, target.c_prefix, _CONTEXTS]
    parts += [f"{q.name}{q.shape}" for q in derivation.parameters]
    parts += [program.digest() for program in programs]
    return "0x" + hashlib.sha256("\n".join(parts).encode()).hexdigest()[:8] + "UL"


def _facts(
    derivation: Derivation, made: Compiled, stages: Stages | None, target: Target
) -> KernelFacts:
    kernel = made.program.kernel
    definitions = kernel_definitions(derivation, kernel)
    return KernelFacts(
        kernel.name,
        kernel_digest(derivation, kernel),
        made.program.digest(),
        made.cost,
        made.strategy,
        {identifier: definition_digest(d) for identifier, d in definitions.items()},
        _signatures_of(made.program, target),
        {
            program.kernel.stage: _stage_facts(program, target)
            for program in ((stages.setup, stages.step) if stages else ())
        },
    )


def _stage_facts(program: Program, target: Target) -> StageFacts:
    kernel = program.kernel
    stem = f"c/src/{target.folder}/{kernel.system}_{kernel.whole}_step"
    return StageFacts(
        program.digest(),
        cost(program),
        _signatures_of(program, target),
        {p: c.context_type(kernel, target.c, p) for p in target.precisions},
        {p: f"{stem}_{p}.c" for p in target.precisions},
    )


def _signatures_of(program: Program, target: Target) -> dict[str, str]:
    return {p: c.signature(program.kernel, target.c, p) for p in target.precisions}


def _table(
    derivation: Derivation, compiled: Mapping[str, Compiled], stages: Mapping[str, Stages]
) -> dict[str, object]:
    """Names and shapes in the order of the arguments, and what runs over an index."""
    kernels: dict[str, object] = {}
    arrays: dict[str, None] = {}
    for name, made in compiled.items():
        kernel, facts = made.program.kernel, _row(made.program)
        if name in stages:
            facts["stages"] = {p.kernel.stage: _row(p) for p in _both({name: stages[name]})}
        if kernel.stateful:
            facts["states"] = [(q.name, q.shape) for q in kernel.states]
            facts["stateful"], facts["controller"] = kernel.stateful, kernel.controller
        kernels[name] = facts
        quantities = (*kernel.inputs, *kernel.parameters)
        arrays.update((q.name, None) for q in quantities if index_of_parts(q))
    parameters = [(q.name, q.shape) for q in derivation.parameters]
    return {"parameters": parameters, "arrays": list(arrays), "kernels": kernels}


def _row(program: Program) -> dict[str, object]:
    """What one function is called with, and what it gives."""
    kernel, used = program.kernel, program.inputs_used()
    return {
        "inputs": [(q.name, q.shape) for q in kernel.inputs],
        "reads": [q.name for q in kernel.parameters if q.name in used],
        "results": [(o.name, o.shape) for o in kernel.outputs],
    }
