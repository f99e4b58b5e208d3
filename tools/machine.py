"""The programs of the machine that the checks use beyond Python, make and gcc.

    python tools/machine.py report      what is missing, and what was therefore not exercised
    python tools/machine.py require     the same, and fails when anything is missing
    python tools/machine.py install     through apt where that is allowed, else says what to install

A check that needs one of them is skipped where it is missing; CI asks for them all.
"""

import os
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass
from importlib.util import find_spec


@dataclass(frozen=True)
class Tool:
    """Something to find, what goes unchecked without it, and the Debian packages that bring it."""

    name: str
    left_out: str
    packages: tuple[str, ...]
    programs: tuple[str, ...] = ()

    def found(self) -> bool:
        """Whether one of the names the program goes by is on the path."""
        return any(shutil.which(program) for program in self.programs or (self.name,))


@dataclass(frozen=True)
class Sanitizers(Tool):
    """A compiler's run-time library, which shows only by linking with it."""

    def found(self) -> bool:
        """Whether an empty program links with the address sanitizer."""
        compiler = shutil.which("clang")
        command = ["-x", "c", "-fsanitize=address,undefined", "-o", os.devnull, "-"]
        return bool(compiler) and _succeeds([compiler, *command], "int main(void) { return 0; }\n")


TOOLS = (
    Tool("gcc", "everything that compiles C", ("gcc", "libc6-dev")),
    Tool("g++", "the headers as C++, and the stated costs by counting", ("g++",)),
    Tool("clang", "the C under clang's warnings", ("clang",)),
    Sanitizers("clang's sanitizers", "the C under clang's ASan and UBSan", ("libclang-rt-dev",)),
    Tool(
        "chromium",
        "the site in a browser",
        ("chromium",),
        ("chromium", "chromium-browser", "google-chrome"),
    ),
    Tool("chromedriver", "the site in a browser", ("chromium-driver",)),
)


def _succeeds(command: list[str], text: str = "") -> bool:
    run = subprocess.run(command, input=text, text=True, capture_output=True, check=False)
    return run.returncode == 0


def _missing() -> list[Tool]:
    return [tool for tool in TOOLS if not tool.found()]


def _packages(tools: list[Tool]) -> list[str]:
    names = [package for tool in tools for package in tool.packages]
    if "libclang-rt-dev" in names:
        names.remove("libclang-rt-dev")
        names += _clang_runtime()
    if find_spec("ensurepip") is None:
        names.append("python3-venv")
    return list(dict.fromkeys(names))


def _clang_runtime() -> list[str]:
    """The package of clang's sanitizers, which carries the version that `clang` stands for."""
    depends = subprocess.run(
        ["apt-cache", "depends", "clang"], capture_output=True, text=True, check=False
    )
    version = re.search(r"Depends: clang-(\d+)$", depends.stdout, re.MULTILINE)
    return [f"libclang-rt-{version[1]}-dev"] if version else []


def report() -> list[Tool]:
    """Name what this machine could not exercise."""
    missing = _missing()
    if missing:
        print("Not exercised, because the machine does not have it:")
        for tool in missing:
            print(f"  {tool.name + ':':20} {tool.left_out}")
        print("`make tools` installs what is missing.")
    return missing


def install() -> int:
    """Install what is missing, as far as the machine and the user allow."""
    if shutil.which("apt-get") is None:
        if missing := _missing():
            print("This is not a Debian system. Please install:")
            print("  " + ", ".join(tool.name for tool in missing))
        return 0
    as_root: list[str] | None = None
    if os.geteuid() == 0:
        as_root = []
    elif shutil.which("sudo") and _succeeds(["sudo", "-n", "true"]):
        as_root = ["sudo", "-n"]
    if not _missing() and find_spec("ensurepip"):
        print("Every tool is there.")
        return 0
    update = ["apt-get", "update", "-qq"]
    if as_root is not None and subprocess.run([*as_root, *update], check=False).returncode:
        print("apt-get update failed: is there a network? Trying with the lists as they are.")
    packages = _packages(_missing())
    command = ["apt-get", "install", "-y", "--no-install-recommends", *packages]
    if as_root is None:
        print("Not root, and sudo asks for a password. Please run:")
        print("  sudo " + " ".join(command))
        return 0
    noninteractive = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    return subprocess.run([*as_root, *command], env=noninteractive, check=False).returncode


def main() -> int:
    """Do what the command line says."""
    match sys.argv[1:]:
        case ["report"]:
            report()
            return 0
        case ["require"]:
            return 1 if report() else 0
        case ["install"]:
            return install()
        case _:
            print(__doc__)
            return 2


if __name__ == "__main__":
    sys.exit(main())
