"""What misaligned axes do to a heliostat: the paper's questions, answered with the kernels."""

from .study_angles import error_angles
from .study_budget import budget
from .study_neglect import neglect
from .study_orders import orders
from .study_terms import terms


def study(kernels):
    """Question by question."""
    yield from error_angles(kernels)
    yield from neglect(kernels)
    yield from orders(kernels)
    yield from budget(kernels)
    yield from terms(kernels)
