"""Verdicts as pages show them: badges, and links from a step to what a paper prints of it."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field

from armillary.site.references import Reference
from armillary.site.steps import Step
from armillary.verify.audit.verdict import Verdict

_NUMBER = re.compile(r"\d+[a-z]?'*")
# The class of a badge; the word on it says the same.
KINDS = {
    Verdict.HOLDS: "holds",
    Verdict.ORDER: "order",
    Verdict.MISPRINT: "misprint",
    Verdict.SIGN: "sign",
    Verdict.WRONG: "wrong",
    Verdict.AMBIGUOUS: "ambiguous",
    Verdict.NOT_CHECKABLE: "unchecked",
}


@dataclass(frozen=True)
class Badge:
    """A verdict: the word, and the class that colours it."""

    word: str
    kind: str


def badge(verdict: Verdict, word: str) -> Badge:
    """The badge of a verdict."""
    return Badge(word, KINDS[verdict])


def key_label(key: str) -> str:
    """A number in parentheses, as papers print it; words as they are."""
    return f"({key})" if _NUMBER.fullmatch(key) else key


def plain_key(key: str) -> str:
    """A key without the zeros that a paper prints before its numbers: 9 for 09."""
    return key.lstrip("0") or key


@dataclass(frozen=True)
class PrintLink:
    """A print that was audited: where the finding stands, and its verdict."""

    paper: str
    key: str
    text: str
    href: str
    badge: Badge


@dataclass(frozen=True)
class Prints:
    """All prints whose audit is current: by paper and key, and by the definition they claim."""

    by_key: Mapping[tuple[str, str], PrintLink] = field(default_factory=dict)
    by_definition: Mapping[str, tuple[PrintLink, ...]] = field(default_factory=dict)

    def judged(self, step: Step, paper: Reference | None) -> PrintLink | None:
        """The finding on the print that a step names."""
        if paper is None or step.printed is None:
            return None
        return self.by_key.get((paper.key, plain_key(step.printed)))

    def others(self, step: Step, paper: Reference | None) -> list[PrintLink]:
        """Further prints that were compared with a step."""
        named = self.judged(step, paper)
        return [link for link in self.by_definition.get(step.identifier, ()) if link is not named]
