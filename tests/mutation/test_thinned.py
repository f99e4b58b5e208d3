"""Fewer mutants, when there is little time."""

from mutation.__main__ import Task, thinned
from mutation.operators import mutants

SOURCE = "y = a * b - c + sin(d) * e - f * g\n"


def tasks(system):
    return [Task(system, "derivation.py", m) for m in mutants(SOURCE)]


def test_no_system_has_more_than_are_asked_for():
    few, many = tasks("sun"), tasks("polar") * 3
    kept = thinned([*few, *many], len(few))
    assert [t for t in kept if t.system == "sun"] == few
    assert sum(t.system == "polar" for t in kept) == len(few)


def test_what_is_kept_is_spread_evenly():
    many = tasks("polar") * 5
    kept = thinned(many, 5)
    assert kept == [many[k * len(many) // 5] for k in range(5)]
