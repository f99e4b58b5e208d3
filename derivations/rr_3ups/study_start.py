"""What the study is computed with, and how."""

from armillary.verify.study import Heading, ParameterTable, Prose

from .study_basis import centre_words


def start(kernels, parameters):
    """Time, sampling, and where each number comes from."""
    yield Heading("What it is computed with")
    yield Prose(
        "Time is solar time: at 12 h the sun stands highest. Its declination is held through "
        f"a day. A day is sampled from sunrise to sunset in steps of {parameters.sampling.step:g} "
        "min, noon among them, and means and energies are taken by trapezoids; where that decides "
        "a figure, it is said. The paper's "
        "$H$ in (26) has the other sign. With $X$ east and $Y$ north, $\\alpha$ is positive in the "
        "morning, as in (32). Forces are positive where they push a leg longer."
    )
    yield Prose(
        "Table 1 gives no mass centre of the platform, no constant of the motors and no pitch of "
        "the screws. The study takes the mass centre "
        f"{centre_words(parameters)}. It does not take the values with which the paper's figures "
        "come out; two parts below show what such values could explain and what they could not."
    )
    yield ParameterTable(
        "Site and mechanism, and what of it is printed and what is ours.",
        ["site", "days", "mount", "bodies"],
    )
    yield ParameterTable(
        "What the paper reports, and ours.", ["published", "drive", "sampling", "fast", "zenith"]
    )
