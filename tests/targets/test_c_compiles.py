"""The C under two compilers: warnings, symbols, versions, short doubles, C++."""

import re
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from tests.targets.compilers import WARNINGS, attempt, needs, run

pytestmark = pytest.mark.tool
COMPILERS = [pytest.param("gcc", marks=needs("gcc")), pytest.param("clang", marks=needs("clang"))]
CXX = [pytest.param("g++", marks=needs("g++")), pytest.param("clang++", marks=needs("clang++"))]
CXX_FLAGS = ["-std=c++17", "-Wall", "-Wextra", "-Wpedantic", "-Werror"]
LIBM = {"sin", "cos", "tan", "asin", "acos", "atan2", "sqrt", "fabs"}


def compile_all(printed, folder, compiler, *flags, precision="*"):
    """An object of every source, two at a time."""

    def one(source):
        made = folder / f"{source.stem}.o"
        run(compiler, "-std=c99", "-O2", *flags, "-c", source, "-o", made)
        return made

    with ThreadPoolExecutor(2) as pool:
        return list(pool.map(one, printed.sources(precision)))


@pytest.fixture(scope="module", params=COMPILERS)
def objects(request, printed, tmp_path_factory):
    return compile_all(printed, tmp_path_factory.mktemp(request.param), request.param, *WARNINGS)


def symbols(path: Path) -> list[tuple[str, str]]:
    """(kind, name) of each symbol of an object."""
    words = [line.split() for line in run("nm", path).stdout.splitlines()]
    return [(w[-2], w[-1]) for w in words]


def test_there_is_an_object_for_every_kernel_and_precision(printed, objects):
    assert printed.stages
    assert len(objects) == 2 * (len(printed.compiled) + len(printed.stages))


def functions(printed, stem):
    """What the object of a source defines: a kernel, or the set-up and the step of one."""
    steps = {f"{system}_{name}_step" for system, name in printed.stages}
    whole, precision = stem.rsplit("_", 1)
    if whole not in steps:
        return [stem]
    return [f"{whole.removesuffix('_step')}_setup_{precision}", stem]


def test_a_kernel_or_its_two_stages_and_nothing_else_is_defined(printed, objects):
    for path in objects:
        # Read-only entries named .L... are the function's own constants.
        found = [s for s in symbols(path) if s[0] != "U" and not re.match(r"r \.L", " ".join(s))]
        assert found == [("T", name) for name in functions(printed, path.stem)]


def test_only_libm_is_called_in_the_right_precision(objects):
    for path in objects:
        suffix = "f" if path.stem.endswith("f32") else ""
        # gcc and clang join sin(x) and cos(x) where the C library has a function for both.
        allowed = {name + suffix for name in (*LIBM, "sincos")}
        found = {name for kind, name in symbols(path) if kind == "U"}
        assert found <= allowed | {"_GLOBAL_OFFSET_TABLE_"}, path.stem


@needs("gcc")
@pytest.mark.parametrize("standard", ["c11", "gnu17", "gnu99"])
def test_other_standards_are_as_quiet(printed, tmp_path, standard):
    everything = tmp_path / "all.c"
    everything.write_text("".join(f'#include "{p.name}"\n' for p in printed.sources()))
    run("gcc", f"-std={standard}", *WARNINGS, f"-I{printed.c}", "-fsyntax-only", everything)


@needs("gcc")
@pytest.mark.slow
def test_the_static_analyser_finds_nothing(printed, tmp_path):
    compile_all(printed, tmp_path, "gcc", "-fanalyzer", "-Werror")


# -- headers --------------------------------------------------------------------------------------


def headers(printed):
    return sorted(printed.c.glob("*.h"))


@pytest.mark.parametrize("compiler", CXX)
def test_headers_are_cplusplus_alone_and_together(printed, tmp_path, compiler):
    names = [h.name for h in headers(printed)]
    for chosen in (*([n] for n in names), names, [*reversed(names), *names]):
        unit = tmp_path / "unit.cpp"
        unit.write_text("".join(f'#include "{n}"\n' for n in chosen))
        run(compiler, *CXX_FLAGS, f"-I{printed.c}", "-fsyntax-only", unit)


@pytest.mark.parametrize("compiler", COMPILERS)
def test_headers_are_c_alone_and_together(printed, tmp_path, compiler):
    names = [h.name for h in headers(printed)]
    for chosen in (*([n] for n in names), names):
        unit = tmp_path / "unit.c"
        unit.write_text("".join(f'#include "{n}"\n' for n in chosen) + "typedef int not_empty;\n")
        run(compiler, "-std=c99", *WARNINGS, f"-I{printed.c}", "-fsyntax-only", unit)


@pytest.mark.parametrize("compiler", CXX)
def test_a_cplusplus_program_links_with_the_objects(printed, objects, tmp_path, compiler):
    whole = "".join(h.read_text() for h in headers(printed))
    declared = re.findall(r"^int (\w+)\(", whole, re.M)
    assert sorted(declared) == sorted(n for p in objects for n in functions(printed, p.stem))
    lines = [f'#include "{h.name}"' for h in headers(printed)]
    lines += ["#include <cstdio>", "typedef void (*any)(void);", "int main() {"]
    lines += ["  any all[] = {"]
    lines += [f"    reinterpret_cast<any>({name})," for name in declared]
    lines += ["  };", "  float r = 0.0f;", "  int bad = bare_root_f32(4.0f, &r);"]
    lines += ['  std::printf("%d %g %d", bad, double(r), int(sizeof all / sizeof *all));', "}"]
    main = tmp_path / "main.cpp"
    main.write_text("\n".join(lines) + "\n")
    run(compiler, *CXX_FLAGS, f"-I{printed.c}", main, *objects, "-lm", "-o", tmp_path / "main")
    assert run(tmp_path / "main").stdout == f"0 2 {len(declared)}"


# -- versions and short doubles -------------------------------------------------------------------


@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("edit", [r"(?<=ABI )0x\w+UL", r"#define \w+_ABI .*"])
def test_a_header_of_another_version_is_an_error(printed, tmp_path, compiler, edit):
    for source in ("stress_vectors_f32.c", "stress_vectors_f64.c", "armillary_status.h"):
        (tmp_path / source).write_text((printed.c / source).read_text())
    text, count = re.subn(
        edit, "0x0UL" if "<=" in edit else "", (printed.c / "stress.h").read_text()
    )
    assert count == 1
    (tmp_path / "stress.h").write_text(text)
    for source in tmp_path.glob("*.c"):
        said = attempt(compiler, "-std=c99", "-c", source, "-o", tmp_path / "x.o")
        assert said.returncode != 0
        assert "stress.h is of another version than this file" in said.stderr


@pytest.fixture
def short_double(tmp_path):
    """A <float.h> as of a machine whose double is a float, to be found before the real one."""
    folder = tmp_path / "short"
    folder.mkdir()
    (folder / "float.h").write_text(
        "#include_next <float.h>\n#undef DBL_MANT_DIG\n#define DBL_MANT_DIG 24\n"
    )
    return f"-isystem{folder}"


@pytest.mark.parametrize("compiler", COMPILERS)
def test_f64_is_left_out_where_double_is_short(printed, tmp_path, short_double, compiler):
    for path in compile_all(printed, tmp_path, compiler, *WARNINGS, short_double, precision="f64"):
        assert symbols(path) == []
    program = tmp_path / "unit.c"
    program.write_text('#include "bare.h"\nint (*a)(float, float *) = bare_root_f32;\n')
    run(compiler, short_double, f"-I{printed.c}", "-fsyntax-only", program)
    program.write_text('#include "bare.h"\nint (*a)(double, double *) = bare_root_f64;\n')
    said = attempt(compiler, short_double, f"-I{printed.c}", "-fsyntax-only", program)
    assert "bare_root_f64" in said.stderr
    assert said.returncode != 0


@pytest.mark.parametrize("compiler", COMPILERS)
def test_fast_math_is_refused(printed, tmp_path, compiler):
    source = printed.sources("f32")[0]
    done = attempt(compiler, "-O2", "-ffast-math", "-c", source, "-o", tmp_path / "k.o")
    assert done.returncode != 0
    assert "compile without -ffast-math" in done.stderr
