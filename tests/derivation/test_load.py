"""A derivation in several files: read anew each time, and its errors name the right one."""

import sys
from pathlib import Path

import pytest

from armillary.algebra.explicit import Explicit
from armillary.derivation.beside import PREFIX, files_of, run
from armillary.derivation.errors import DerivationError
from armillary.derivation.load import load, load_all

SYMBOLS = """
from armillary import Derivation
d = Derivation("arm", title="Arm")
turn = d.angle("turn", "an angle")
"""
REACH = """
from armillary import cos
from .symbols import d, turn
reach = d.define("reach", 2 * cos(turn), because="a projection")
"""
MAIN = """
from .symbols import d, turn
from .reach import reach
derivation = d
d.kernel("reach_of", inputs=[turn], outputs={"distance": reach})
"""


@pytest.fixture
def arm(tmp_path) -> Path:
    folder = tmp_path / "derivations" / "arm"
    write(folder, derivation=MAIN, symbols=SYMBOLS, reach=REACH)
    return folder


def write(folder: Path, **texts: str) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in texts.items():
        (folder / f"{name}.py").write_text(text, "utf-8")


def test_parts_state_one_record(arm):
    record = load(arm / "derivation.py")
    assert list(record.definitions) == ["reach"]
    assert record.source.path == str(arm / "symbols.py")
    assert str(record.definitions["reach"].source) == f"{arm / 'reach.py'}:4"
    assert record.files == tuple(str(arm / f"{n}.py") for n in ("derivation", "reach", "symbols"))


def test_nothing_stays_behind(arm):
    for text in (REACH, REACH.replace("2 *", "3 *")):  # of one length, within one second
        write(arm, reach=text)
        number = text.split(" * ")[0][-1]
        reach = load(arm / "derivation.py").definitions["reach"]
        assert number in str(Explicit()(reach.expression))
        assert not [name for name in sys.modules if name.startswith(PREFIX)]
    assert not [finder for finder in sys.meta_path if type(finder).__module__.startswith("armill")]
    assert not list(arm.rglob("*.pyc"))


def test_a_failed_load_leaves_nothing_behind(arm):
    write(arm, reach="1 / 0\n")
    with pytest.raises(DerivationError):
        load(arm / "derivation.py")
    assert not [name for name in sys.modules if name.startswith(PREFIX)]
    write(arm, reach=REACH)
    assert load(arm / "derivation.py").definitions


def test_parts_of_two_systems_may_share_a_name(arm):
    other = arm.parent / "leg"
    write(
        other,
        symbols=SYMBOLS.replace('"arm"', '"leg"'),
        derivation="from .symbols import d, turn\nderivation = d\n"
        'arm = d.use("arm")\n'
        'd.define("far", arm["reach"] + turn / turn, because="one further")\n',
    )
    records = load_all(arm.parent)
    assert records["leg"].used["arm"].derivation is records["arm"]
    assert {Path(f).parent.name for f in records["leg"].files} == {"leg"}


WRONG = {
    "an error of Python": ({"reach": REACH + "1 / 0\n"}, "reach.py:5", "ZeroDivisionError"),
    "an error of a derivation": (
        {"reach": REACH + 'd.define("reach", turn, because="x")\n'},
        "reach.py:5",
        "reach is defined twice",
    ),
    "a syntax error": ({"reach": REACH + "d.define(\n"}, "reach.py:5", "SyntaxError"),
    "an error in a function that another file calls": (
        {
            "reach": REACH + "\n\ndef f():\n    return math.pi\n",
            "derivation": MAIN + "from .reach import f\nf()\n",
        },
        "reach.py:8",
        "NameError",
    ),
    "a file that is not there": (
        {"derivation": MAIN.replace(".reach", ".raech")},
        "derivation.py:3",
        "there is no raech.py in .*arm\n  mend: write raech.py beside derivation.py",
    ),
    "a name that is not there": (
        {"derivation": MAIN.replace("import reach", "import raech")},
        "derivation.py:3",
        "mend: correct the spelling of what is imported from reach.py",
    ),
    "a ring": (
        {"symbols": "from .reach import reach\n" + SYMBOLS},
        "reach.py:3",
        "two files that import each other do not work",
    ),
    "no point before a file beside": (
        {"derivation": MAIN.replace("from .reach", "from reach")},
        "derivation.py:3",
        "mend: write a point before its name",
    ),
    "another system": (
        {"reach": "from ..sun import enu\n" + REACH},
        "reach.py:1",
        'mend: `d.use\\("name"\\)` is the way to another system',
    ),
}


@pytest.mark.parametrize("case", WRONG)
def test_an_error_names_the_file_and_the_line(arm, case):
    texts, place, says = WRONG[case]
    write(arm, **texts)
    with pytest.raises(DerivationError, match=f"(?s)({place}).*{says}"):
        load(arm / "derivation.py")


def test_the_files_of_a_module_are_known_without_running_it(arm):
    write(arm, simulation="from . import symbols, _missing\nfrom .rays import x\n", rays="1 / 0\n")
    found = files_of(arm / "simulation.py")
    assert [path.name for path in found] == ["rays.py", "simulation.py", "symbols.py"]
    write(arm, rays="from .simulation import\n")
    assert files_of(arm / "simulation.py") == found
    assert files_of(arm / "study.py") == []


def test_a_module_runs_with_the_files_beside_it(arm):
    write(
        arm,
        simulation="from .rays import twice\nfour = twice(2)\n",
        rays="def twice(x):\n    return 2 * x\n",
    )
    ran = run(arm / "simulation.py")
    assert ran.module.four == 4
    assert [path.name for path in ran.files] == ["rays.py", "simulation.py"]
