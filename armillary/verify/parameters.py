"""The numbers that a study uses: `parameters.toml` beside it, each with its unit and its source.

[plant.mass]
value = 176.0
unit = "kg"
meaning = "mass that a rod moves"
provenance = "ours"
source = "A third of a facet, the rod, and the inertia of its screw."
low = 1.0

`parameters.plant.mass` is the number. A value is an int, a float, or a tuple of these.
"""

from __future__ import annotations

import ast
import difflib
import math
import tomllib
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from keyword import iskeyword
from pathlib import Path
from typing import Any

NAME = "parameters.toml"
PROVENANCES = ("printed", "inferred", "ours")
_WORDS = ("unit", "meaning", "provenance", "source")
_KEYS = ("value", *_WORDS, "low", "high")

Value = int | float | tuple["Value", ...]
Read = Callable[[str], None]


class ParameterError(ValueError):
    """A parameter that is written or set wrongly; `mend` says how it should be."""

    def __init__(self, problem: str, mend: str) -> None:
        self.problem, self.mend = problem, mend
        super().__init__(f"{problem}\n  mend: {mend}")


@dataclass(frozen=True)
class Parameter:
    """A number of a study.

    Attributes:
        provenance: "printed" in the paper, "inferred" from it, or "ours".
        source: where it is from, in a sentence.
        low: the least that may be set, of each entry of a tuple.
        high: the most.
        default: what the file says, where something else was set.
    """

    section: str
    name: str
    value: Value
    unit: str
    meaning: str
    provenance: str
    source: str
    low: int | float | None = None
    high: int | float | None = None
    default: Value | None = None

    @property
    def full(self) -> str:
        """Section and name."""
        return f"{self.section}.{self.name}"

    @property
    def after(self) -> str:
        """The unit as it stands after a number; nothing for a pure one."""
        return "" if self.unit == "1" else f" {self.unit}"


class Section(Mapping[str, Value]):
    """The values of a section by name; also as attributes."""

    def __init__(self, name: str, records: Mapping[str, Parameter], read: Read) -> None:
        self._name, self._records, self._read = name, records, read

    def __getitem__(self, name: str) -> Any:
        if name not in self._records:
            self._read(f"{self._name}.")
            raise KeyError(name)
        self._read(f"{self._name}.{name}")
        return self._records[name].value

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name not in self._records:
            known = "" if name.startswith("_") else f"; it has {', '.join(self._records)}"
            raise AttributeError(f"the parameters have no {name!r} in their section{known}")
        return self[name]

    def __iter__(self) -> Iterator[str]:
        self._read(f"{self._name}.")
        return iter(self._records)

    def __len__(self) -> int:
        self._read(f"{self._name}.")
        return len(self._records)


class Parameters(Mapping[str, Section]):
    """The sections of a `parameters.toml` by name; also as attributes.

    Args:
        records: every parameter, in the order of the file.
        read: hears what is read: "plant.mass"; "plant." for the names in a section, "" for those
            of the sections; "plant.mass*" for a parameter with all that is said of it.
    """

    def __init__(self, records: Iterable[Parameter], read: Read = lambda _: None) -> None:
        self._records = {one.full: one for one in records}
        self._read = read
        self._sections: dict[str, dict[str, Parameter]] = {}
        for one in self._records.values():
            self._sections.setdefault(one.section, {})[one.name] = one

    def __getitem__(self, section: str) -> Section:
        if section not in self._sections:
            self._read("")
            raise KeyError(section)
        return Section(section, self._sections[section], self._read)

    def __getattr__(self, section: str) -> Any:
        if section.startswith("_") or section not in self._sections:
            known = "" if section.startswith("_") else f"; there are {', '.join(self._sections)}"
            raise AttributeError(f"the parameters have no section {section!r}{known}")
        return self[section]

    def __iter__(self) -> Iterator[str]:
        self._read("")
        return iter(self._sections)

    def __len__(self) -> int:
        self._read("")
        return len(self._sections)

    def record(self, full: str) -> Parameter:
        """A parameter with all that is said of it, by section and name: "plant.mass"."""
        self._read(f"{full}*")
        return self._records[full]

    def records(self, sections: Iterable[str] = ()) -> list[Parameter]:
        """Every parameter, or those of some sections in their order; this is not logged as read.

        Raises:
            ParameterError: for a section that is not there.
        """
        chosen = tuple(sections) or tuple(self._sections)
        for name in chosen:
            if name not in self._sections:
                raise ParameterError(
                    f"the parameters have no section {name!r}", _choose(name, self._sections)
                )
        return [one for name in chosen for one in self._sections[name].values()]

    def watched(self, read: Read) -> Parameters:
        """The same; `read` hears what is read."""
        return Parameters(self._records.values(), read)

    def state(self, key: str) -> str:
        """What a reader of a key, as `read` hears it, has seen; empty where it is gone."""
        if key == "":
            return repr(sorted(self._sections))
        if key.endswith("."):
            return repr(sorted(self._sections.get(key[:-1], {})))
        found = self._records.get(key.removesuffix("*"))
        if found is None:
            return ""
        return repr(found) if key.endswith("*") else repr(found.value)


# -- from a file ----------------------------------------------------------------------------------


def read_parameters(path: Path) -> Parameters:
    """The parameters in a file.

    Raises:
        ParameterError: for anything that is wrong in it, or missing.
    """
    try:
        content = tomllib.loads(path.read_text("utf-8"))
    except FileNotFoundError:
        raise ParameterError(
            f"there is no {path}",
            'write it: [section], then name = { value = 1.0, unit = "m", ... }',
        ) from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as problem:
        raise ParameterError(f"{path}: {problem}", "correct the file; it must be TOML") from None
    found = []
    for section, table in content.items():
        if not isinstance(table, dict) or not all(isinstance(one, dict) for one in table.values()):
            raise ParameterError(
                f"{path}: {section!r} is no section of parameters",
                "write a table of tables: [plant], then mass = { value = 1.0, ... }",
            )
        _check_name(path, section, Parameters)
        found += [_parameter(path, section, name, one) for name, one in table.items()]
    return Parameters(found)


def _parameter(path: Path, section: str, name: str, table: Mapping[str, Any]) -> Parameter:
    where = f"{path}: {section}.{name}"
    _check_name(path, name, Section)
    for key in table:
        if key not in _KEYS:
            raise ParameterError(f"{where} has an unknown {key!r}", f"it knows {', '.join(_KEYS)}")
    if "value" not in table:
        raise ParameterError(f"{where} has no value", "write value = 1.0")
    for key in _WORDS:
        if not isinstance(table.get(key), str) or not table[key].strip():
            raise ParameterError(f"{where} has no {key}", _WANTED[key])
    if table["provenance"] not in PROVENANCES:
        raise ParameterError(
            f"{where} has the provenance {table['provenance']!r}", _WANTED["provenance"]
        )
    low, high = (_bound(where, key, table.get(key)) for key in ("low", "high"))
    words = {key: table[key] for key in _WORDS}
    value = _number(where, table["value"])
    return _bounded(where, Parameter(section, name, value, low=low, high=high, **words))


_WANTED = {
    "unit": 'write unit = "kg", or unit = "1" for a pure number',
    "meaning": 'say what it is: meaning = "mass that a rod moves"',
    "provenance": f"write provenance = one of {', '.join(map(repr, PROVENANCES))}",
    "source": 'say where it is from, in a sentence: source = "Table 1 of the paper."',
}


def _check_name(path: Path, name: str, kind: type) -> None:
    """Refuse what cannot stand after a point."""
    if not name.isidentifier() or iskeyword(name) or name.startswith("_") or hasattr(kind, name):
        raise ParameterError(
            f"{path}: {name!r} cannot be the name of a section or parameter",
            "use letters, digits and underscores, a letter first, and no word of Python's",
        )


def _number(where: str, given: object) -> Value:
    """A value as it is kept: in a tuple with one float all are floats."""
    if isinstance(given, (list, tuple)) and given:
        made = tuple(_number(where, one) for one in given)
        return made if _is_whole(made) else _as_floats(made)
    if isinstance(given, (int, float)) and not isinstance(given, bool) and math.isfinite(given):
        return given
    raise ParameterError(
        f"{where} has the value {given!r}", "give a finite number, or an array of some: [1.0, 2.0]"
    )


def _bound(where: str, key: str, given: object) -> int | float | None:
    if given is None or (isinstance(given, (int, float)) and not isinstance(given, bool)):
        return given
    raise ParameterError(f"{where} has {key} = {given!r}", f"give a number, or leave {key} out")


def _bounded(where: str, one: Parameter) -> Parameter:
    low = -math.inf if one.low is None else one.low
    high = math.inf if one.high is None else one.high
    wrong = [x for x in _entries(one.value) if not low <= x <= high]
    if wrong:
        raise ParameterError(
            f"{where} is {wrong[0]:g}{one.after}", f"give {bounds_text(one)}{one.after}"
        )
    return one


def bounds_text(one: Parameter) -> str:
    """The bounds of a parameter in words; empty where it has none."""
    if one.low is not None and one.high is not None:
        return f"{one.low:g} to {one.high:g}"
    if one.low is not None:
        return f"at least {one.low:g}"
    return f"at most {one.high:g}" if one.high is not None else ""


def _entries(value: Value) -> list[int | float]:
    return [x for part in value for x in _entries(part)] if isinstance(value, tuple) else [value]


def _is_whole(value: Value) -> bool:
    return all(isinstance(x, int) for x in _entries(value))


def _as_floats(value: Value) -> Value:
    return tuple(map(_as_floats, value)) if isinstance(value, tuple) else float(value)


# -- set by hand ----------------------------------------------------------------------------------


def with_settings(parameters: Parameters, settings: Iterable[str]) -> Parameters:
    """The parameters with others set: "plant.mass=60", or "mass=60" where one section has it.

    Raises:
        ParameterError: for an unknown or ambiguous name, another type or shape, or a value out of
            its bounds.
    """
    records = {one.full: one for one in parameters.records()}
    for setting in settings:
        name, mark, text = (part.strip() for part in setting.partition("="))
        if not mark or not text:
            raise ParameterError(f"--set {setting}", "write --set name=value")
        one = _named(records, name)
        value = _fitted(name, text, one)
        default = one.value if one.default is None else one.default
        changed = replace(one, value=value, default=None if value == default else default)
        records[one.full] = _bounded(name, changed)
    return Parameters(records.values())


def _named(records: Mapping[str, Parameter], name: str) -> Parameter:
    found = [one for one in records.values() if name in (one.name, one.full)]
    if len(found) == 1:
        return found[0]
    if found:
        names = " or ".join(one.full for one in found)
        raise ParameterError(f"there are several parameters {name!r}", f"write {names}")
    known = [*(one.name for one in records.values()), *records]
    raise ParameterError(f"there is no parameter {name!r}", _choose(name, known))


def _choose(name: str, known: Iterable[str]) -> str:
    names = list(dict.fromkeys(known))
    return f"choose from {', '.join(difflib.get_close_matches(name, names) or names)}"


def _fitted(name: str, text: str, one: Parameter) -> Value:
    """A value of the type and shape that the parameter has."""
    try:
        value = _number(name, ast.literal_eval(text))
    except (ValueError, SyntaxError):
        value = ""  # type: ignore[assignment]
    if not _alike(value, one.value):
        raise ParameterError(f"{name} cannot be {text}", f"give {_kind(one)}, as {one.value} is")
    if _is_whole(one.value) and not _is_whole(value):
        raise ParameterError(
            f"{name} is a whole number, not {text}",
            f"give a whole number; where any will do, write {_as_floats(one.value)} in {NAME}",
        )
    return value if _is_whole(one.value) else _as_floats(value)


def _alike(a: object, b: object) -> bool:
    """Whether both have one shape."""
    if isinstance(a, tuple) and isinstance(b, tuple):
        return len(a) == len(b) and all(map(_alike, a, b))
    return not isinstance(b, tuple) and isinstance(a, (int, float))


def _kind(one: Parameter) -> str:
    count = f"{len(one.value)} numbers" if isinstance(one.value, tuple) else "a number"
    return f"{count} in{one.after}" if one.after else count
