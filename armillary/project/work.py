"""Loads, compiles and renders systems. Everything that needs SymPy is reached through here."""

from __future__ import annotations

import dataclasses
import sys
from ast import literal_eval
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from armillary.derivation.load import load
from armillary.derivation.record import Derivation
from armillary.derivation.statements import Kernel
from armillary.program.cost import Cost
from armillary.program.lower import Strategy
from armillary.project.config import Project
from armillary.project.errors import ProjectError
from armillary.targets.c import signature
from armillary.targets.files import (
    KernelFacts,
    Rendered,
    StageFacts,
    Target,
    render_shared,
    render_system,
)
from armillary.targets.manifest import (
    MANIFEST,
    Entry,
    Facts,
    Manifest,
    engine_versions,
    entry_of,
)


@dataclass(frozen=True)
class Made:
    """A system as it comes out: its texts, its manifest entry, and the files it was read from."""

    rendered: Rendered
    entry: Entry
    reads: tuple[str, ...]

    @property
    def table(self) -> str:
        """What the shared files tell of the system, as a Python literal."""
        return repr(self.rendered.table)


class Listener(Protocol):
    """Hears how the work goes on."""

    def kernel(self, system: str, name: str) -> None:
        """A kernel is about to be compiled."""

    def system(self, name: str, made: Made) -> None:
        """A system has come out."""


def make_system(project: Project, name: str, listener: Listener) -> Made:
    """Load, compile and render one system.

    Raises:
        DerivationError: for anything its derivation does wrong.
    """
    derivation = load(project.derivations / name / "derivation.py")
    rendered = render_system(
        derivation, _target(project), lambda kernel: listener.kernel(name, kernel.name)
    )
    kernels = {kernel: _to_facts(facts) for kernel, facts in rendered.kernels.items()}
    made = Made(rendered, entry_of(rendered.files, kernels), _reads(project, derivation))
    listener.system(name, made)
    return made


def known_system(project: Project, name: str, entry: Entry, table: str) -> Rendered:
    """A system as it stands on disk, which must be intact."""
    files = {name: (project.generated / name).read_bytes().decode() for name in entry.files}
    kernels = {kernel: _from_facts(kernel, facts) for kernel, facts in entry.kernels.items()}
    return Rendered(name, files, kernels, literal_eval(table))


def make_shared(
    project: Project, rendered: Mapping[str, Rendered], entries: Mapping[str, Entry]
) -> tuple[dict[str, str], Manifest]:
    """The files common to all systems, and the manifest of the whole set.

    Raises:
        ProjectError: when two systems want a file of one name.
    """
    ordered = {name: rendered[name] for name in sorted(rendered)}
    shared = dict(render_shared(_target(project), ordered))
    _check_names({"what all systems share": shared, **{n: r.files for n, r in ordered.items()}})
    manifest = Manifest(engine_versions(), dict(entries), entry_of(shared, {}))
    return shared, manifest


def _check_names(owners: Mapping[str, Mapping[str, str]]) -> None:
    """Refuse two files of one name, also where case does not count."""
    owned: dict[str, str] = {}
    for owner, files in owners.items():
        for name in files:
            other = owned.setdefault(name.lower(), owner)
            if other != owner:
                raise ProjectError(
                    f"{owner} and {other} both make generated/{name}",
                    f"rename the system {owner}, or its kernel",
                )


def make_everything(project: Project, listener: Listener) -> tuple[dict[str, str], Manifest]:
    """All texts of a project by name, the manifest among them, from its derivations alone."""
    done = {name: make_system(project, name, listener) for name in project.systems()}
    shared, manifest = make_shared(
        project,
        {name: one.rendered for name, one in done.items()},
        {name: one.entry for name, one in done.items()},
    )
    texts = {n: text for one in done.values() for n, text in one.rendered.files.items()}
    return {**texts, **shared, MANIFEST: manifest.text()}, manifest


def signature_of(project: Project, kernel: Kernel) -> str:
    """A kernel as C declares it, in the widest precision."""
    target = _target(project)
    return signature(kernel, target.c, target.precisions[-1])


def _target(project: Project) -> Target:
    return Target(
        package=project.kernels,
        folder=project.c_folder,
        c_prefix=project.c_prefix,
        precisions=project.precisions,
        version=project.version,
    )


def _to_facts(facts: KernelFacts) -> Facts:
    return {
        "stated": facts.stated,
        "digest": facts.digest,
        "cost": dataclasses.asdict(facts.cost),
        "strategy": dataclasses.asdict(facts.strategy),
        "definitions": dict(facts.definitions),
        "signatures": dict(facts.signatures),
        "stages": {name: dataclasses.asdict(stage) for name, stage in facts.stages.items()},
    }


def _from_facts(name: str, facts: Facts) -> KernelFacts:
    return KernelFacts(
        name=name,
        stated=facts["stated"],
        digest=facts["digest"],
        cost=Cost(**facts["cost"]),
        strategy=Strategy(**facts["strategy"]),
        definitions=dict(facts["definitions"]),
        signatures=dict(facts["signatures"]),
        stages={
            name: StageFacts(**{**stage, "cost": Cost(**stage["cost"])})
            for name, stage in facts["stages"].items()
        },
    )


def _reads(project: Project, derivation: Derivation) -> tuple[str, ...]:
    """Files that a derivation is read from: its own, those it uses, and what they import."""
    paths = {Path(file).resolve() for d in _used(derivation) for file in d.files}
    for module in list(sys.modules.values()):
        origin = getattr(module, "__file__", None)
        if origin and project.derivations in Path(origin).parents:
            paths.add(Path(origin))
    return tuple(sorted(path.relative_to(project.root).as_posix() for path in paths))


def _used(derivation: Derivation) -> Iterator[Derivation]:
    yield derivation
    for used in derivation.used.values():
        yield from _used(used.derivation)
