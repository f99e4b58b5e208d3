"""A study of three parts, each in a file of its own."""

import pytest

from armillary.verify.studies import running
from tests.verify.studies.small import ARMS, PARAMETERS, SUNS, THREE, WINDS, project


@pytest.fixture(autouse=True)
def _one_core(monkeypatch):
    """Parts run in this process, which is quicker, unless a test says otherwise."""
    monkeypatch.setattr(running, "cores", lambda: 1)


@pytest.fixture
def study(tmp_path):
    return project(tmp_path, THREE, PARAMETERS, arms=ARMS, winds=WINDS, suns=SUNS)
