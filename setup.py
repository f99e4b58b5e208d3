"""What a wheel carries. Everything that does not need code is in pyproject.toml."""

from pathlib import Path

from setuptools import find_packages, setup
from setuptools.command.build_py import build_py
from setuptools.errors import SetupError

PACKAGES = {
    "armillary": "armillary",
    "armillary_kernels": "generated/python/armillary_kernels",
    # The C sources travel along, so that an installed wheel can compile the native kernels.
    "armillary_kernels._c": "generated/c/src/armillary",
}
# What is not committed, or made by a command, and which command to run.
MADE = {
    "armillary/site/theme/assets/katex/katex.min.js": "make katex",
    "armillary/site/theme/assets/katex/katex.min.css": "make katex",
    "armillary/site/theme/assets/katex/LICENSE": "make katex",
    "generated/python/armillary_kernels/__init__.py": "make generate",
}


class Build(build_py):
    """Refuses to build a wheel that would miss a part."""

    def run(self) -> None:
        """Look for the parts that a command makes, then build."""
        if not self.editable_mode:
            for part, command in MADE.items():
                if not Path(part).is_file():
                    raise SetupError(f"{part} is not there. Please run `{command}` first.")
        super().run()


setup(
    packages=[*find_packages(include=["armillary", "armillary.*"]), *list(PACKAGES)[1:]],
    package_dir=PACKAGES,
    include_package_data=False,
    package_data={
        "armillary": [
            "py.typed",
            "**/*.j2",
            "templates/**",
            "templates/**/.*",
            "site/theme/**",
            "targets/runtime/*.py",
        ],
        "armillary_kernels": ["py.typed"],
        "armillary_kernels._c": ["*.c", "*.h"],
    },
    cmdclass={"build_py": Build},
)
