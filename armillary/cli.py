"""The command line. Each command finds the project and leaves the work to `armillary.project`.

What a command needs is imported when it runs, so that `--help` and a run with nothing to do are
quick. In a docstring, \\b tells click to keep the lines of a block as they are.
"""
# ruff: noqa: D301

from __future__ import annotations

import functools
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from armillary import __version__
from armillary.derivation.errors import DerivationError
from armillary.project.errors import ProjectError
from armillary.site.errors import SiteError

if TYPE_CHECKING:
    from armillary.project.config import Project

_KNOWN = (DerivationError, ProjectError, SiteError)


class _Group(click.Group):
    """Tells known errors without a traceback, which says nothing to who wrote a derivation."""

    def invoke(self, ctx: click.Context) -> Any:
        try:
            return super().invoke(ctx)
        except _KNOWN as problem:
            if ctx.params.get("debug"):
                raise
            click.echo(f"error: {problem}", err=True)
            ctx.exit(1)
        except OSError as problem:
            # A full disk, a folder that may not be written: nothing here can be mended in code.
            if ctx.params.get("debug") or problem.filename is None:
                raise
            click.echo(f"error: {problem.filename}: {problem.strerror}", err=True)
            click.echo("  mend: see that the project's folder can be written", err=True)
            ctx.exit(1)


@click.group(cls=_Group, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="armillary", message="%(prog)s %(version)s")
@click.option("--debug", is_flag=True, help="Show the traceback of every error.")
def main(debug: bool) -> None:
    """Derive machines that follow the sun; write C, Python and pages from one source.

    Commands work on the project that the current folder belongs to: the nearest folder, here or
    above, whose pyproject.toml has a [tool.armillary].

    \b
    To begin, in an empty folder:
      armillary init              a project that builds
      armillary new my_tracker    a mechanism that already works
      armillary generate          derivations/ -> generated/
      armillary check             kernels against independent engines
      armillary audit             printed equations against the derivations
      armillary site serve        the pages, rebuilt while you edit
    """


def _project() -> Project:
    from armillary.project.config import find_project

    return find_project(Path.cwd())


def _say(line: str) -> None:
    click.echo(line)
    sys.stdout.flush()


@main.command()
@click.option("--name", help="Name of the project; that of the folder, unless given.")
def init(name: str | None) -> None:
    """Make an empty project in this folder.

    It has a pyproject.toml from which `pip install .` installs the generated kernels, a folder for
    derivations, and the beginning of a site. Nothing that is already here is overwritten.

    \b
    Example:
      mkdir my_plant && cd my_plant && armillary init
    """
    from armillary.project.scaffold import make_project

    for path in make_project(Path.cwd(), name):
        _say(f"wrote {path.relative_to(Path.cwd())}")
    _say("next: armillary new NAME")


@main.command()
@click.argument("name")
def new(name: str) -> None:
    """Add the mechanism NAME: a small tracker, to be changed into yours.

    It generates, checks and renders as it is. derivations/NAME/derivation.py says what is derived,
    derivations/NAME/simulation.py computes the same in another way.

    \b
    Example:
      armillary new my_tracker && armillary generate && armillary check my_tracker
    """
    from armillary.project.scaffold import make_system

    project = _project()
    for path in make_system(project, name):
        _say(f"wrote {path.relative_to(project.root)}")
    _say(f"next: armillary generate && armillary check {name}")


@main.command("list")
def list_systems() -> None:
    """List systems, their kernels and what a call costs."""
    from armillary.project.overview import overview

    for line in overview(_project()):
        _say(line)


@main.command()
@click.argument("system")
@click.argument("kernel", required=False)
@click.option("--latex", is_flag=True, help="Print formulas as LaTeX.")
def show(system: str, kernel: str | None, latex: bool) -> None:
    """Show a SYSTEM, or one KERNEL of it: definitions, cost, checks.

    Each definition comes with its id, the reason for the step, the line it was written in and the
    number of the paper's equation.

    \b
    Examples:
      armillary show my_tracker
      armillary show my_tracker pose --latex
    """
    from armillary.project.describe import show as describe

    for line in describe(_project(), system, kernel, latex):
        _say(line)


@main.command()
@click.argument("systems", nargs=-1)
@click.option(
    "--check",
    is_flag=True,
    help="Write nothing; fail with a diff where generated/ is not what the derivations give.",
)
def generate(systems: tuple[str, ...], check: bool) -> None:
    """Write the kernels of SYSTEMS, or of all, to generated/.

    Only what an edit touches is generated again: a system, and those that use it. For every kernel
    it says which definitions changed and the operations before and after. All files change at once
    or not at all, also when the run is killed.

    \b
    Examples:
      armillary generate                 all that is out of date
      armillary generate my_tracker      one system, and those that use it
      armillary generate --check         for CI: make everything anew and compare
    """
    project = _project()
    if not check:
        from armillary.project.generate import generate as regenerate

        regenerate(project, systems, _say)
        return
    from armillary.project.difference import differences

    wrong = differences(project, systems, _say)
    if wrong:
        raise ProjectError(
            f"{wrong} file{'s are' if wrong > 1 else ' is'} not what the derivations give",
            "run `armillary generate`; it takes away what is extra if it wrote that itself",
        )
    _say("generated/ is what the derivations give")


@main.command()
@click.argument("systems", nargs=-1)
@click.option(
    "--update-tolerances",
    is_flag=True,
    help="Measure the kernels anew and write derivations/*/tolerances.json.",
)
@click.option("-v", "--verbose", is_flag=True, help="A row for every check.")
def check(systems: tuple[str, ...], update_tolerances: bool, verbose: bool) -> None:
    """Check SYSTEMS, or all, against identities and independent engines.

    A row tells the engine, how many checks it made, at how many points, and the part of what is
    allowed that the worst of them took up. What fails or is skipped has a row of its own. An
    engine that is not installed is skipped by name; `pip install 'armillary[check]'` brings all of
    them. The results go to build/checks.json, for the pages and for `armillary show`.

    \b
    Examples:
      armillary check
      armillary check -v sun
      armillary check my_tracker --update-tolerances
    """
    from armillary.project.checks import check as run

    if not run(_project(), systems, update_tolerances, _say, verbose):
        raise SystemExit(1)


@main.command()
@click.argument("papers", nargs=-1)
@click.option("-v", "--verbose", is_flag=True, help="Every reading, entry and counterexample.")
@click.option("--json", "as_json", is_flag=True, help="Print the findings as JSON, and no table.")
def audit(papers: tuple[str, ...], verbose: bool, as_json: bool) -> None:
    """Compare what PAPERS print, or all, with what is derived.

    derivations/papers/KEY.py holds what the paper KEY prints, as it stands there. Each row tells
    the verdict on one equation or sentence, the largest error over the working ranges, and the
    smallest repair that makes it hold. The findings go to build/audit.json, for the pages; a wrong
    equation of a paper is a finding and no error, so the exit status stays 0.

    \b
    Examples:
      armillary audit
      armillary audit -v ky
      armillary audit --json ky > findings.json
    """
    from armillary.project.audit import NONE, table
    from armillary.project.audit import audit as run
    from armillary.verify.audit.kept import as_json as printed

    done = run(_project(), papers, lambda line: click.echo(line, err=True))
    if as_json:
        click.echo(printed({name: found for name, (_, found) in done.items()}), nl=False)
        return
    for paper, found in done.values():
        for line in table(paper, found, verbose):
            _say(line)
    if not done:
        _say(NONE)


@main.command()
@click.argument("system")
@click.option("--set", "settings", multiple=True, metavar="NAME=VALUE", help="Set a parameter.")
@click.option("--only", multiple=True, metavar="PART", help="Only this part, and what it needs.")
@click.option(
    "--csv",
    "folder",
    type=click.Path(file_okay=False, path_type=Path),
    help="Write the data of every plot and table to this folder; nothing is written without it.",
)
@click.option("--parameters", "list_them", is_flag=True, help="Print the parameters; run nothing.")
def study(
    system: str,
    settings: tuple[str, ...],
    only: tuple[str, ...],
    folder: Path | None,
    list_them: bool,
) -> None:
    """Print what the study of a SYSTEM found: its tables, and the captions of its plots.

    What a part of derivations/SYSTEM/study.py found is kept in build/studies, for the pages too. It
    runs again only when its files, or a parameter or kernel that it reads, have changed; parts run
    side by side, and a run that is stopped loses only the parts at work.

    A parameter of derivations/SYSTEM/parameters.toml that is set is set for this run, and kept
    apart; it is refused when it is out of its bounds. An array is written 1,2,3. Where two sections
    have the name, write SECTION.NAME.

    The name of a file of data is made from the caption. A part that runs alone shows the traceback
    of its error with `armillary --debug study`.

    \b
    Examples:
      armillary study my_tracker --parameters
      armillary study my_tracker --set mass=60 --only tracking
      armillary study my_tracker --csv data
    """
    from armillary.project.study import parameters
    from armillary.project.study import study as run

    project = _project()
    if list_them:
        lines: Iterable[str] = parameters(project, system, settings)
    else:
        tell = functools.partial(click.echo, err=True)
        lines = run(project, system, tell, settings, only, folder)
    for line in lines:
        _say(line)


@main.group()
def site() -> None:
    """Build the pages, or serve them while you edit."""


@site.command("build")
@click.option(
    "--out",
    type=click.Path(file_okay=False, path_type=Path),
    help="Folder for the site; site/ unless given.",
)
@click.option("--strict/--no-strict", default=True, help="Whether a warning is an error.")
def site_build(out: Path | None, strict: bool) -> None:
    """Build the site; open index.html in it with a browser, no server is needed.

    \b
    Example:
      armillary site build --out pages
    """
    from armillary.site.build import build_site

    _say(f"built {build_site(_project().root, out, strict, _say) / 'index.html'}")


@site.command("serve")
@click.option(
    "--address", default="127.0.0.1:8000", show_default=True, help="Host and port to listen at."
)
def site_serve(address: str) -> None:
    """Serve the site on this machine and rebuild it on every edit."""
    from armillary.site.build import serve

    serve(_project().root, address)


if __name__ == "__main__":
    main()
