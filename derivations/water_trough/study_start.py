"""What the study is computed with."""

from armillary.verify.study import Heading, ParameterTable, Prose

SIZED = ["small", "large", "around"]


def start(kernels):
    """Where each number comes from."""
    yield Heading("What it is computed with")
    yield Prose(
        "The paper verified its model on two concentrators of different size, and its file holds "
        "neither their numbers nor the results. The two troughs here are ours, so that the "
        "questions that such a trough asks can be answered; no figure below is the paper's."
    )
    yield ParameterTable("Two troughs.", SIZED)
    yield ParameterTable("The experiments.", ["pulses", "place", "control", "smooth", "reversal"])
