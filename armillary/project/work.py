"""Loads, compiles and renders systems. Everything that needs SymPy is reached through here."""

from __future__ import annotations

import dataclasses
import sys
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from armillary.derivation.load import load
from armillary.derivation.record import Derivation
from armillary.program.cost import Cost
from armillary.program.lower import Strategy
from armillary.project.config import Project
from armillary.project.manifest import (
    MANIFEST,
    Entry,
    Facts,
    Manifest,
    engine_versions,
    entry_of,
)
from armillary.targets.files import KernelFacts, Rendered, Target, render_shared, render_system


@dataclass(frozen=True)
class Made:
    """A system as it comes out: its texts, its manifest entry, and the files it was read from."""

    rendered: Rendered
    entry: Entry
    reads: tuple[str, ...]


def make_system(project: Project, name: str) -> Made:
    """Load, compile and render one system.

    Raises:
        DerivationError: for anything its derivation does wrong.
    """
    derivation = load(project.derivations / name / "derivation.py")
    rendered = render_system(derivation, _target(project))
    kernels = {kernel: _to_facts(facts) for kernel, facts in rendered.kernels.items()}
    return Made(rendered, entry_of(rendered.files, kernels), _reads(project, derivation))


def make_all(
    project: Project, names: list[str], made: Callable[[str, Made], None]
) -> dict[str, Made]:
    """Several systems; `made` hears of each as it comes out."""
    done = {}
    for name in names:
        done[name] = make_system(project, name)
        made(name, done[name])
    return done


def known_system(project: Project, entry: Entry) -> Rendered:
    """A system as it stands on disk, which must be intact."""
    files = {name: (project.generated / name).read_bytes().decode() for name in entry.files}
    return Rendered(files, {name: _from_facts(name, f) for name, f in entry.kernels.items()})


def make_shared(
    project: Project, rendered: Mapping[str, Rendered], entries: Mapping[str, Entry]
) -> tuple[dict[str, str], Manifest]:
    """The files common to all systems, and the manifest of the whole set."""
    ordered = {name: rendered[name] for name in sorted(rendered)}
    shared = dict(render_shared(_target(project), ordered))
    manifest = Manifest(engine_versions(), dict(entries), entry_of(shared, {}))
    return shared, manifest


def make_everything(
    project: Project, made: Callable[[str, Made], None]
) -> tuple[dict[str, str], Manifest]:
    """All texts of a project by name, the manifest among them, from its derivations alone."""
    done = make_all(project, project.systems(), made)
    shared, manifest = make_shared(
        project,
        {name: one.rendered for name, one in done.items()},
        {name: one.entry for name, one in done.items()},
    )
    texts = {n: text for one in done.values() for n, text in one.rendered.files.items()}
    return {**texts, **shared, MANIFEST: manifest.text()}, manifest


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
        "digest": facts.digest,
        "cost": dataclasses.asdict(facts.cost),
        "strategy": dataclasses.asdict(facts.strategy),
        "definitions": dict(facts.definitions),
        "signature": facts.signature,
    }


def _from_facts(name: str, facts: Facts) -> KernelFacts:
    return KernelFacts(
        name=name,
        digest=facts["digest"],
        cost=Cost(**facts["cost"]),
        strategy=Strategy(**facts["strategy"]),
        definitions=dict(facts["definitions"]),
        signature=facts["signature"],
    )


def _reads(project: Project, derivation: Derivation) -> tuple[str, ...]:
    """Files that a derivation is read from: its own, those it uses, and what they import."""
    paths = {Path(d.source.path).resolve() for d in _used(derivation)}
    for module in list(sys.modules.values()):
        origin = getattr(module, "__file__", None)
        if origin and project.derivations in Path(origin).parents:
            paths.add(Path(origin))
    return tuple(sorted(path.relative_to(project.root).as_posix() for path in paths))


def _used(derivation: Derivation) -> Iterator[Derivation]:
    yield derivation
    for used in derivation.used.values():
        yield from _used(used.derivation)
