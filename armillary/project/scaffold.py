"""`armillary init` and `armillary new`: files to begin with, from `armillary/templates/`."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

from jinja2 import Environment, StrictUndefined

from armillary.derivation.errors import DerivationError, Source
from armillary.derivation.names import check_name
from armillary.project.config import Project
from armillary.project.errors import ProjectError

_TEMPLATES = Path(__file__).resolve().parents[1] / "templates"
_SUFFIX = ".j2"


def make_project(folder: Path, name: str | None) -> list[Path]:
    """Write an empty project into a folder; tells the files.

    Raises:
        ProjectError: when the name does not do, or a file is already there.
    """
    name = name or re.sub(r"\W+", "_", folder.resolve().name).strip("_").lower()
    if not re.match(r"[a-z][a-z0-9_]*\Z", name):
        raise ProjectError(
            f"{name!r} cannot name a project",
            "give one with --name: small letters, digits and underscores, first a letter",
        )
    facts = {"name": name, "title": _title(name), "kernels": f"{name}_kernels"}
    made = _write("project", folder, facts)
    (folder / "derivations").mkdir(exist_ok=True)
    return made


def make_system(project: Project, name: str) -> list[Path]:
    """Write a mechanism to begin with; tells the files.

    Raises:
        ProjectError: when the name does not do, or a file is already there.
    """
    folder = project.derivations / name
    try:
        check_name(name, "system", Source(str(folder / "derivation.py"), 1))
    except DerivationError as problem:
        raise ProjectError(problem.problem, problem.mend) from None
    alike = [s for s in project.systems() if s != name and s.casefold() == name.casefold()]
    if alike:
        raise ProjectError(
            f"{name} and {alike[0]} would be one folder where case does not count",
            "choose another name",
        )
    facts = {"name": name, "title": _title(name), "kernels": project.kernels}
    return _write("system", folder, facts)


def _title(name: str) -> str:
    return name.replace("_", " ").capitalize()


def _write(template: str, folder: Path, facts: Mapping[str, str]) -> list[Path]:
    """Fill in every file of a template, unless one of them is already there."""
    environment = Environment(
        undefined=StrictUndefined, keep_trailing_newline=True, autoescape=False
    )
    top = _TEMPLATES / template
    texts = {
        folder / path.relative_to(top).with_suffix(""): environment.from_string(
            path.read_text("utf-8")
        ).render(facts)
        for path in sorted(top.rglob(f"*{_SUFFIX}"))
    }
    there = [str(path) for path in texts if path.exists()]
    if there:
        raise ProjectError(
            f"already there: {', '.join(there)}",
            "nothing was written; take an empty folder or another name",
        )
    for path, text in texts.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, "utf-8", newline="\n")
    return list(texts)
