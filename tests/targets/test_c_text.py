"""What the C says: signatures, Doxygen, width, what it never uses, prefix and precisions."""

import re

import pytest

from armillary import Derivation
from armillary.derivation.errors import DerivationError
from armillary.derivation.status import MEANINGS, Status
from armillary.targets.files import Target, render_system
from tests.targets.compilers import WARNINGS, needs, run
from tests.targets.conftest import TARGET, print_all
from tests.targets.stress import LONG, SYSTEMS, answers, bare, stress

FORBIDDEN = r"\b(malloc|free|static|goto|errno|restrict|alloca|printf|long double|pow|extern int)\b"


def texts(printed):
    return {path.name: path.read_text("utf-8") for path in printed.c.iterdir()}


def without_comments(text):
    return re.sub(r"/\*.*?\*/", "", text, flags=re.S)


def test_no_line_is_longer_than_a_hundred_columns(printed):
    names = re.compile(r"\w{48,}")
    for name, text in texts(printed).items():
        for line in text.splitlines():
            assert len(line) <= 100 or names.search(line), f"{name}: {line}"
            assert line == line.rstrip()
            assert "\t" not in line


def test_nothing_forbidden_is_used(printed):
    for name, text in texts(printed).items():
        assert not re.search(FORBIDDEN, without_comments(text)), name
        assert not re.search(r"20\d\d-\d\d", text), f"{name} holds a date"


def test_every_literal_of_an_f32_source_is_a_float(printed):
    for path in printed.sources("f32"):
        code = without_comments(path.read_text())
        assert not re.search(r"\d\.\d+(e-?\d+)?(?![\de.f])", code), path.name
        assert not re.search(r"\bdouble\b", code)


def test_signatures_follow_the_contract(printed):
    header = texts(printed)["stress.h"]
    assert re.search(
        r"int stress_vectors_f32\(\s*const stress_params_f32 \*p, const float c\[3\], "
        r"const float v\[3\], float turn, float R\[9\],\s+float w\[3\]\);",
        header,
    )
    assert (
        "int stress_numbers_f64(const stress_params_f64 *p, double k[3], double *zero);" in header
    )
    assert "int bare_root_f64(double x, double *r);" in texts(printed)["bare.h"]
    struct = re.search(r"typedef struct \{(.*?)\} stress_params_f64;", header, re.S)
    assert re.findall(r"double (.*);", struct[1]) == ["mount[3]", "S_t[3]", "L_0", "unread"]


def test_doxygen_tells_units_limits_shapes_and_ids(printed):
    flat = " ".join(texts(printed)["stress.h"].replace("\n *", " ").split())
    assert "@param[in] turn an angle, rad, refused outside [-1000, 1000]" in flat
    assert "@param[in] c a direction, unit vector; refused when its square is off" in flat
    assert "@param[out] R R, 3 by 3, row-major" in flat
    assert "not read: S_t, L_0, unread" in flat
    flat = " ".join(texts(printed)["answers.h"].replace("\n *", " ").split())
    assert "(answers-root)" in flat
    assert "UNREACHABLE: x is too large" in flat
    for status in ("OK", "NOT_CONVERGED", "LIMIT", "NOT_FINITE", "OUT_OF_RANGE"):
        assert f"ARMILLARY_{status}" in flat


def test_a_rotation_is_nine_entries(printed):
    header = texts(printed)["attitudes.h"]
    flat = " ".join(header.replace("\n *", " ").split())
    assert "int attitudes_parts_f32( const attitudes_params_f32 *p, const float R[9]," in flat
    struct = re.search(r"typedef struct \{(.*?)\} attitudes_params_f64;", header, re.S)
    assert re.findall(r"double (.*);", struct[1]) == ["Q[9]", "unread[9]"]
    assert "@param[in] R an attitude, rotation matrix, 3 by 3, row-major; refused when" in flat
    source = texts(printed)["attitudes_parts_f64.c"]
    assert "const double R_32 = R[7];" in source
    assert "*e = R_13;" in source


def test_a_controller_keeps_a_struct(printed):
    header = texts(printed)["keepers.h"]
    struct = re.search(r"typedef struct \{([^}]*)\} keepers_array_state_f64;", header)
    assert re.findall(r"double (.*);", struct[1]) == ["several[3]", "last"]
    assert header.count("} keepers_array_state_f64;") == 1
    flat = " ".join(header.replace("\n *", " ").split())
    assert (
        "int keepers_array_init_f64( const keepers_params_f64 *p, const double each[3], "
        "keepers_array_state_f64 *s);"
    ) in flat
    assert (
        "int keepers_array_update_f64( const keepers_params_f64 *p, keepers_array_state_f64 *s, "
        "const double each[3], double *whole, double moved[3]);"
    ) in flat
    assert "@param[in,out] s state of the array; untouched where the status is negative" in flat
    assert "keepers_named_state_f32 *s_value, float given, float *wave);" in flat


def test_arrays_of_an_index_are_told(printed):
    flat = " ".join(texts(printed)["loops.h"].replace("\n *", " ").split())
    assert "@param[in] l a length for each leg, for each leg, refused outside [0, 1000]" in flat
    assert "@param[out] tilt tilt, for each leg and facet, 3 by 2, row-major" in flat
    assert "@param[out] rows rows, for each leg, 3 by 3, row-major" in flat
    struct = re.search(
        r"typedef struct \{(.*?)\} loops_params_f32;", texts(printed)["loops.h"], re.S
    )
    assert re.findall(r"float (.*);", struct[1]) == ["R[3]", "S[9]", "h[2]", "unread[2]"]


def test_sentences_end_once_and_comments_do_not_end_early(printed):
    for name, text in texts(printed).items():
        assert not re.search(r"@brief .*\.\.", text), name
    header = texts(printed)["stress.h"]
    assert "not * / an end" in header
    assert "/ * even * /" in header


def test_status_numbers_never_change(printed):
    text = texts(printed)["armillary_status.h"]
    found = {n: int(v.strip("()")) for n, v in re.findall(r"#define ARMILLARY_(\w+) (\S+)", text)}
    assert found == {
        "OK": 0, "CLAMPED": 1, "SINGULAR": 2, "STICKING": 3, "BELOW_HORIZON": 4, "LIMIT": 5,
        "NOT_FINITE": -1, "OUT_OF_RANGE": -2, "UNREACHABLE": -3, "NOT_CONVERGED": -4,
    }  # fmt: skip
    assert set(MEANINGS) == set(Status)


def test_results_step_aside_for_arguments_of_the_same_name(printed):
    flat = " ".join(texts(printed)["names.h"].split())
    assert (
        "int names_same_f32( const names_params_f32 *p, const float v[3], float v_out_out[3], "
        "float *S_out, float *step_out, float *v_out, float *S_y_out);"
    ) in flat


def test_arguments_that_would_print_as_one_name_are_refused():
    d = Derivation("clash", title="Clash")
    v, v_x = d.vector("v", "a vector"), d.scalar("v_x", "a number")
    with pytest.raises(DerivationError, match="two arguments that print as v_x"):
        d.kernel("k", inputs=[v, v_x], outputs={"r": v.x + v_x})


def test_a_system_may_not_take_the_name_of_a_module():
    with pytest.raises(DerivationError, match="may not be named native"):
        render_system(Derivation("native", title="Native"), TARGET)


def test_long_names_survive(printed):
    assert LONG in texts(printed)["names_all_f32.c"]


@needs("gcc")
@pytest.mark.tool
def test_a_prefix_reaches_every_symbol(tmp_path):
    target = Target("acme_kernels", "acme", "acme_", ("f32", "f64"), "7.0")
    printed = print_all(tmp_path, target, {n: make() for n, make in SYSTEMS.items()})
    objects = []
    for source in printed.sources():
        objects.append(tmp_path / f"{source.stem}.o")
        run("gcc", "-std=c99", *WARNINGS, "-c", source, "-o", objects[-1])
    defined = re.findall(r" T (\w+)", run("nm", *objects).stdout)
    assert len(defined) == len(objects) + 2 * len(printed.stages)
    assert all(name.startswith("acme_") for name in defined)
    assert "acme_stress_params_f32" in (printed.c / "stress.h").read_text()
    native = printed.module("native")
    assert native.bare.root(x=9.0).r == 3.0


@needs("gcc")
@pytest.mark.tool
def test_a_project_of_one_precision(tmp_path):
    target = Target("single_kernels", "armillary", "", ("f32",), "0.1.0")
    printed = print_all(tmp_path, target, {"bare": bare(), "stress": stress()})
    assert not printed.sources("f64")
    assert "double" not in without_comments((printed.c / "stress.h").read_text())
    found = printed.module("native").bare.root(x=9.0)
    assert found.r == 3.0
    assert found.r.dtype == "float32"


def test_any_change_of_layout_changes_the_version(tmp_path):
    def abi(change):
        record = bare()
        change(record.parameter)
        record.kernels.clear()
        x = record.quantities["x"]
        record.kernel("root", inputs=[x], outputs={"r": x})
        printed = print_all(tmp_path / "abi", target, {"bare": record})
        return re.search(r"_ABI (\w+)", (printed.c / "bare.h").read_text())[1]

    target = Target("abi_kernels", "armillary", "", ("f32",), "0.1.0")
    layouts = [
        lambda p: None,
        lambda p: p.length("a", "a length"),
        lambda p: p.vector("a", "a vector"),
        lambda p: (p.length("a", "a length"), p.length("b", "a length")),
        lambda p: (p.length("b", "a length"), p.length("a", "a length")),
    ]
    assert len({abi(change) for change in layouts}) == len(layouts)
    assert abi(layouts[1]) == abi(layouts[1])


def test_headers_tell_what_is_handed_over_and_what_each_stage_reads(printed):
    flat = " ".join(texts(printed)["stress.h"].replace("\n *", " ").split())
    assert "What carry_setup hands to carry_step: 3 numbers." in flat
    struct = "volatile unsigned long ready; float S_2_x; float S_2_y; float S_2_z;"
    assert f"typedef struct {{ {struct} }} stress_carry_ctx_f32;" in flat
    setup = "int stress_carry_setup_f64(const stress_params_f64 *p, stress_carry_ctx_f64 *ctx);"
    assert setup in flat
    step = "int stress_carry_step_f64( const stress_carry_ctx_f64 *ctx, double turn, "
    assert f"{step}const double v[3], double w[3]);" in flat
    assert "@param[out] ctx what carry_step reads; not ready where the status is negative" in flat
    assert "OUT_OF_RANGE: ctx is not ready, or an argument is beyond its limits" in flat
    assert "do not store or send it, and set it up again after recompiling" in flat


def test_the_functions_of_a_divided_kernel_lead_to_each_other(printed):
    header = texts(printed)["stress.h"]
    names = ["stress_carry_f32", "stress_carry_setup_f32", "stress_carry_step_f32"]
    for name in names:
        (said,) = re.findall(rf"/\*\*((?:(?!\*/).)*)\*/\nint {name}\(", header, re.S)
        assert re.findall(r"@see (\w+)", said) == [other for other in names if other != name]
    (said,) = re.findall(r"/\*\*((?:(?!\*/).)*)\*/\nint stress_numbers_f32\(", header, re.S)
    assert "@see" not in said


def test_arguments_tell_how_often_they_change(printed):
    flat = " ".join(texts(printed)["loops.h"].replace("\n *", " ").split())
    assert re.search(r"@param\[in\] l [^@]*; each tick @", flat)
    assert "held by the mount unless a field says otherwise" in flat


def test_a_context_bears_a_mark_of_its_own(printed):
    marks = {}
    for system, name in printed.stages:
        for precision in ("f32", "f64"):
            text = texts(printed)[f"{system}_{name}_step_{precision}.c"]
            setup, step = re.findall(r"ready (?:=|==) (0x\w{8})UL", text)
            assert setup == step
            assert text.index("ctx->ready = 0;") < text.index(f"ctx->ready = {setup}")
            marks[system, name, precision] = int(setup, 16)
    assert len(set(marks.values())) == len(marks)
    assert not {0, 0xFFFFFFFF} & set(marks.values())


def test_a_kernel_may_not_take_the_name_of_a_stage():
    d = Derivation("clash", title="Clash")
    x, a = d.scalar("x", "a number"), d.parameter.scalar("a", "a number")
    d.kernel("wind", inputs=[x], outputs={"r": a * a * x})
    d.kernel("wind_step", inputs=[x], outputs={"r": 2 * x})
    with pytest.raises(DerivationError, match="stages of the kernel wind"):
        render_system(d, TARGET)


def test_golden(printed, golden):
    assert answers().name == "answers"
    files = (
        *("answers.h", "answers_both_signs_f32.c", "bare_root_f64.c", "attitudes_parts_f32.c"),
        *(
            "loops_grid_f32.c",
            "iterations_forward_f64.c",
            "keepers.h",
            "keepers_array_update_f32.c",
        ),
        *("loops.h", "loops_rods_step_f32.c"),
    )
    for name in files:
        golden(name, (printed.c / name).read_text("utf-8"))
    for name in ("answers", "iterations"):
        text = (printed.folder / f"python/printed_kernels/{name}.py").read_text()
        golden(f"{name}.py.txt", text)
