"""Sentences about kernels: what they cost, and what changed since the last generation."""

from __future__ import annotations

from collections.abc import Mapping

from armillary.targets.manifest import Entry, Facts


def operations(cost: Mapping[str, int]) -> str:
    """A cost in words, without what is zero: "10 flops, 4 sin/cos"."""
    flops = cost["add"] + cost["multiply"] + cost["divide"] + cost["sqrt"]
    parts = [f"{flops} flops"]
    parts += [f"{cost['trigonometry']} sin/cos"] if cost["trigonometry"] else []
    parts += [f"{cost['inverse']} atan2"] if cost["inverse"] else []
    return ", ".join(parts)


def system_report(system: str, old: Entry | None, new: Entry) -> list[str]:
    """One line for each kernel that a system has or had."""
    before = old.kernels if old else {}
    names = [*new.kernels, *(name for name in before if name not in new.kernels)]
    return [
        f"{system}.{name}: {_kernel(before.get(name), new.kernels.get(name))}" for name in names
    ]


def _kernel(old: Facts | None, new: Facts | None) -> str:
    if new is None:
        return "removed"
    if old is None:
        return f"new, {operations(new['cost'])}"
    now, was = operations(new["cost"]), operations(old["cost"])
    cost = now if now == was else f"{was} -> {now}"
    return f"{_change(old, new)}, {cost}"


def _change(old: Facts, new: Facts) -> str:
    """Which definitions changed; with none, whether the program did."""
    before, after = old["definitions"], new["definitions"]
    changed = [_short(i) for i in after if i in before and before[i] != after[i]]
    added = [f"+{_short(i)}" for i in after if i not in before]
    gone = [f"-{_short(i)}" for i in before if i not in after]
    if changed or added or gone:
        return f"changed {' '.join([*changed, *added, *gone])}"
    if old["digest"] != new["digest"]:
        return "same definitions, another program"
    return "unchanged"


def _short(identifier: str) -> str:
    """The definition's name without its system."""
    return identifier.split("-", 1)[-1]
