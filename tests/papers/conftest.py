"""The prints of this project's papers and what the audit finds, made once and only where asked."""

from pathlib import Path

import pytest

from armillary.derivation.paper import Paper
from armillary.derivation.papers import load_papers
from armillary.verify.audit.audit import audit
from armillary.verify.audit.verdict import Finding

ROOT = Path(__file__).parents[2] / "derivations"


class Findings(dict[str, dict[str, Finding]]):
    """By paper and by key; a paper is audited when it is first asked for."""

    def __init__(self, papers: dict[str, Paper]) -> None:
        super().__init__()
        self.papers = papers

    def __missing__(self, name: str) -> dict[str, Finding]:
        self[name] = {finding.key: finding for finding in audit(self.papers[name])}
        return self[name]


@pytest.fixture(scope="session")
def papers() -> dict[str, Paper]:
    """Every paper, by its key."""
    return load_papers(ROOT)


@pytest.fixture(scope="session")
def found(papers: dict[str, Paper]) -> Findings:
    """`found["yu"]["5"]` is the finding on a print."""
    return Findings(papers)
