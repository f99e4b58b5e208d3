"""The small paper that the tests of the audit print in."""

import pytest

from tests.verify.audit.papers import Arm


@pytest.fixture
def arm():
    return Arm()
