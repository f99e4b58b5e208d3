"""Parts run side by side and get what they need; errors, interruptions and runs at once."""

import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from armillary.verify.studies import running
from armillary.verify.studies.errors import StudyError
from armillary.verify.studies.running import run_study
from armillary.verify.study import Absent, Heading, Prose
from tests.project.projects import environment
from tests.verify.studies.small import HEAD, PARAMETERS, WINDS, ran, set_to, texts, write
from tests.verify.studies.small import project as made


def test_the_page_has_the_order_of_the_list_and_not_of_the_end(study):
    items = run_study(study, (), lambda line: None)
    assert items[0] == Heading("Arms")
    assert items[1] == Prose("arms 6.0")
    assert items[2].text.startswith("winds 14.0 in ")
    assert items[3] == Prose("sun 8")


@pytest.mark.parametrize("count", [1, 2])
def test_what_is_kept_is_taken_and_nothing_is_said_of_it(study, count, monkeypatch):
    monkeypatch.setattr(running, "cores", lambda: count)
    said: list[str] = []
    first = run_study(study, (), said.append)
    assert said[0] == "studying arm arms"
    assert said[1].startswith("studying" if count == 2 else "studied")
    assert sum(line.startswith("studied arm ") for line in said) == 3
    said.clear()
    assert run_study(study, (), said.append) == first
    assert said == []


def test_parts_run_in_processes_of_their_own_and_the_last_one_here(study, monkeypatch):
    monkeypatch.setattr(running, "cores", lambda: 2)
    (pid,) = (re.search(r"in (\d+)", t)[1] for t in texts(study) if t.startswith("winds"))
    assert int(pid) != os.getpid()
    write(study.root, winds=WINDS + "\n")
    assert f"in {os.getpid()}" in texts(study)[2]


def test_on_one_core_all_run_here(study):
    assert f"in {os.getpid()}" in texts(study)[2]


def test_only_some(study):
    assert ran(study, "winds") == ["winds"]
    assert texts(study, "suns") == ["sun 8"]
    with pytest.raises(StudyError, match="no part 'moons'"):
        run_study(study, ["moons"], lambda line: None)


# -- parts that need others -----------------------------------------------------------------------

REPORT = f"""{HEAD}
def report(kernels, results):
    yield Prose(f"gains {{results['gains']}}, n {{results['n']}}")
"""
TUNED = f"""{HEAD}
import numpy as np

def tuned(kernels, parameters):
    yield Prose("tuned")
    yield Result("gains", {{"K_P": np.float64(parameters.plant.mass), "list": np.arange(2)}})

def counted(kernels):
    yield Result("n", 3)
"""
NEEDS = f"""{HEAD}
from .report import report
from .tuned import counted, tuned

parts = [Part("report", report, needs=("tuned", "counted")), ("tuned", tuned), ("counted", counted)]
"""


def needing(root, tuned=TUNED):
    return made(root, NEEDS, PARAMETERS, report=REPORT, tuned=tuned)


@pytest.mark.parametrize("count", [1, 2])
def test_a_part_gets_the_results_of_those_it_needs(tmp_path, count, monkeypatch):
    monkeypatch.setattr(running, "cores", lambda: count)
    study = needing(tmp_path)
    found = texts(study)
    assert found == ["gains {'K_P': 2.0, 'list': [0, 1]}, n 3", "tuned"]  # a result is not shown
    assert texts(study) == found
    assert ran(set_to(study, "mass=4"), "report") == ["tuned", "report"]


def test_equal_results_do_not_run_a_part_again(tmp_path):
    study = needing(tmp_path)
    assert ran(study) == ["tuned", "counted", "report"]
    write(tmp_path, tuned=TUNED + "\n# a word\n")
    assert ran(study) == ["tuned", "counted"]
    write(tmp_path, tuned=TUNED.replace('"n", 3', '"n", 4'))
    assert ran(study) == ["tuned", "counted", "report"]


def test_two_results_of_one_name_are_refused(tmp_path):
    study = needing(tmp_path, TUNED.replace('"n", 3', '"gains", 3'))
    with pytest.raises(StudyError, match="'report' needs leave a result 'gains'"):
        run_study(study, (), lambda line: None)


def test_a_result_that_cannot_be_kept_is_refused(tmp_path):
    study = needing(tmp_path, TUNED.replace('"n", 3', '"n", object()'))
    with pytest.raises(StudyError, match="the result 'n' cannot be kept"):
        run_study(study, ["counted"], lambda line: None)


# -- what goes wrong ------------------------------------------------------------------------------

BROKEN = f"""{HEAD}
def good(kernels):
    yield Prose("good")

def bad(kernels):
    yield Prose("begun")
    yield 1 / 0

def after(kernels, results):
    yield Prose("never")

parts = [("bad", bad), Part("after", after, needs=["bad"]), ("good", good), ("fine", good)]
"""


@pytest.mark.parametrize("count", [1, 2])
def test_an_error_of_one_part_is_told_with_its_line_and_the_others_are_kept(
    tmp_path, count, monkeypatch
):
    monkeypatch.setattr(running, "cores", lambda: count)
    study = made(tmp_path, BROKEN)
    said: list[str] = []
    with pytest.raises(StudyError, match=r"arm/study\.py:12: ZeroDivisionError"):
        run_study(study, (), said.append)
    assert any(re.match(r"failed arm bad: .*study\.py:12", line) for line in said)
    assert texts(study, "good", "fine") == ["good", "good"]
    assert ran(study, "good", "fine") == []


MISSING = f"""{HEAD}
def bodies(kernels):
    need("nowhere_to_be_found")
    yield Prose("never")

def tracking(kernels, results):
    yield Prose("never")

def curves(kernels):
    yield Prose("curves")

parts = [("bodies", bodies), Part("tracking", tracking, needs=["bodies"]), ("curves", curves)]
"""


@pytest.mark.parametrize("count", [1, 2])
def test_a_missing_engine_takes_its_part_and_those_that_need_it(tmp_path, count, monkeypatch):
    monkeypatch.setattr(running, "cores", lambda: count)
    study = made(tmp_path, MISSING)
    why = "nowhere_to_be_found is not installed"
    expected = (Absent("bodies", why), Absent("tracking", why), Prose("curves"))
    assert run_study(study, (), lambda line: None) == expected
    assert not list(study.folder("bodies").glob("*"))
    assert ran(study) == []


def test_a_missing_engine_of_the_whole_file_is_said(tmp_path):
    study = made(tmp_path, HEAD + "need('nowhere_to_be_found')\n\ndef study(kernels): ...\n")
    assert run_study(study, (), lambda line: None) == (
        Absent("", "nowhere_to_be_found is not installed"),
    )


def test_parameters_that_are_not_there_are_told(tmp_path):
    study = made(tmp_path, "def study(kernels, parameters):\n    yield 3\n")
    with pytest.raises(StudyError, match=r"takes parameters, and there is no .*parameters\.toml"):
        run_study(study, (), lambda line: None)


def test_kernels_that_are_not_generated_are_told(tmp_path):
    study = made(tmp_path, "def study(kernels, sun):\n    yield 3\n")
    (tmp_path / "generated" / "python" / "demo_kernels" / "sun.py").unlink()
    with pytest.raises(StudyError, match="no kernels of sun\n  mend: run `armillary generate`"):
        run_study(study, (), lambda line: None)


DYING = f"""{HEAD}
def dying(kernels):
    os._exit(3)
    yield

def other(kernels):
    yield Prose("other")

parts = [("dying", dying), ("other", other)]
"""


def test_a_process_that_dies_is_told(tmp_path, monkeypatch):
    monkeypatch.setattr(running, "cores", lambda: 2)
    study = made(tmp_path, DYING)
    with pytest.raises(StudyError, match="the part 'dying' was lost: its process ended with 3"):
        run_study(study, (), lambda line: None)
    assert ran(study, "other") == []


# -- progress, interruption, two at once ----------------------------------------------------------


@pytest.mark.parametrize("count", [1, 2])
def test_progress_is_told_now_and_then(tmp_path, count, monkeypatch):
    monkeypatch.setattr(running, "cores", lambda: count)
    text = f"""{HEAD}
from armillary.verify.studies import compute
compute.EVERY = 0.02

def slow(kernels, tell):
    import time
    for k in range(40):
        tell(k / 40, f"step {{k}}")
        time.sleep(0.005)
    yield Prose("slow")

parts = [("slow", slow), ("also", slow)]
"""
    said: list[str] = []
    run_study(made(tmp_path, text), (), said.append)
    told = [line for line in said if re.fullmatch(r"  arm slow: \d+%, step \d+", line)]
    assert 2 <= len(told) < 35


SLOW = f"""{HEAD}
import time
from pathlib import Path

def quick(kernels):
    yield Prose("quick")

def slow(kernels, tell):
    Path(__file__).with_name("begun.txt").touch()
    for k in range(600):
        tell(k / 600)
        time.sleep(0.1)
    yield Prose("slow")

parts = [("slow", slow), ("quick", quick)]
"""
DRIVER = """
import sys
from pathlib import Path
from armillary.verify.studies import running
from armillary.verify.studies.compute import Study
running.cores = lambda: 2
study = Study(Path(sys.argv[1]), "demo_kernels", "arm")
running.run_study(study, (), lambda line: print(line, flush=True))
"""


def test_what_was_finished_before_an_interruption_is_kept_and_nothing_runs_on(tmp_path):
    study = made(tmp_path, SLOW)
    run = subprocess.Popen(
        [sys.executable, "-c", DRIVER, str(tmp_path)],
        env=environment(),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    while "studied arm quick" not in run.stdout.readline():
        pass
    wait_for(tmp_path / "derivations" / "arm" / "begun.txt")
    os.killpg(run.pid, signal.SIGINT)  # as the terminal does: to all of them
    rest, errors = run.communicate(timeout=20)
    assert "stopped studying arm; what was finished is kept" in rest
    assert errors.count("Traceback") == 1  # of the program above, and not of the worker
    assert ran(study, "quick") == []
    with pytest.raises(ProcessLookupError):
        os.killpg(run.pid, 0)


def wait_for(path: Path) -> None:
    while not path.exists():
        time.sleep(0.02)


ONCE = f"""{HEAD}
import time
from pathlib import Path

def study(kernels):
    with Path(__file__).with_name("runs.txt").open("a") as file:
        file.write("run\\n")
    while not Path(__file__).with_name("go.txt").exists():
        time.sleep(0.02)
    yield Prose("done")
"""


def test_two_runs_at_once_compute_once(tmp_path):
    made(tmp_path, ONCE)
    folder = tmp_path / "derivations" / "arm"
    driver = [sys.executable, "-c", DRIVER, str(tmp_path)]

    def start() -> subprocess.Popen[str]:
        return subprocess.Popen(driver, env=environment(), stdout=subprocess.PIPE, text=True)

    with start() as first:
        wait_for(folder / "runs.txt")
        with start() as second:
            assert second.stdout.readline() == "studying arm\n"
            assert "waiting for another run of it to finish" in second.stdout.readline()
            (folder / "go.txt").touch()
            assert first.wait() == second.wait() == 0
    assert (folder / "runs.txt").read_text() == "run\n"


def test_the_part_that_took_longest_starts_first(tmp_path):
    text = f"""{HEAD}
import time

def quick(kernels):
    yield Prose("quick")

def slow(kernels):
    time.sleep(0.15)
    yield Prose("slow")

parts = [("quick", quick), ("slow", slow), ("third", quick)]
"""
    study = made(tmp_path, text)
    assert ran(study) == ["quick", "slow", "third"]
    write(tmp_path, study=text + "\n")
    assert ran(study)[0] == "slow"


def test_without_a_compiler_only_what_needs_it_is_missing(tmp_path, monkeypatch):
    study = made(tmp_path, "def study(kernels, native):\n    yield 3\n")
    monkeypatch.setenv("PATH", "")
    monkeypatch.delenv("CC", raising=False)
    assert run_study(study, (), lambda line: None) == (
        Absent("study", "a C compiler is not installed"),
    )
