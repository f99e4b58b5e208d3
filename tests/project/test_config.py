"""`[tool.armillary]`: what it may say, and what is told of what it may not."""

from pathlib import Path

import pytest

from armillary.project.config import find_project
from armillary.project.errors import ProjectError


def write(folder: Path, *lines: str) -> None:
    (folder / "pyproject.toml").write_text("\n".join(lines), "utf-8")


def test_the_nearest_project_above_is_found(tmp_path: Path):
    write(tmp_path, "[tool.armillary]", 'kernels = "a_kernels"', 'version = "1.2.3"')
    inner = tmp_path / "deep" / "deeper"
    inner.mkdir(parents=True)
    write(inner, "[project]", 'name = "something else"')
    project = find_project(inner)
    assert project.root == tmp_path.resolve()
    assert (project.c_folder, project.c_prefix) == ("a_kernels", "")
    assert project.precisions == ("f32", "f64")


def test_the_c_folder_is_the_package_s_unless_it_is_named(tmp_path: Path):
    lines = ["[tool.armillary]", 'kernels = "field_kernels"', 'version = "0.1.0"']
    write(tmp_path, *lines)
    assert find_project(tmp_path).c_folder == "field_kernels"
    write(tmp_path, *lines, 'c_folder = "field"')
    assert find_project(tmp_path).c_folder == "field"


def test_the_version_may_be_the_package_s(tmp_path: Path):
    write(tmp_path, "[project]", 'version = "4.5.6"', "[tool.armillary]", 'kernels = "k"')
    assert find_project(tmp_path).version == "4.5.6"


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ('kernel = "k"', "unknown 'kernel'"),
        ('version = "1.0.0"', "does not name the kernel package"),
        ('kernels = "my-kernels"', "is no name"),
        ('kernels = "k"\nprecisions = ["f16"]', "precisions"),
        ('kernels = "k"\nprecisions = []', "precisions"),
        ('kernels = "k"\nc_prefix = "9"', "is no name"),
        ('kernels = "k"\nversion = 1', "version"),
        ('kernels = "k', "pyproject.toml"),
    ],
)
def test_a_wrong_setting_is_named_with_its_mend(tmp_path: Path, line: str, told: str):
    write(tmp_path, "[project]", 'version = "0.1.0"', "[tool.armillary]", line)
    with pytest.raises(ProjectError, match="mend: ") as caught:
        find_project(tmp_path)
    assert told in str(caught.value)
