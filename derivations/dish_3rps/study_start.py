"""What the study is computed with."""

from armillary.verify.study import ParameterTable, Prose


def start(kernels):
    """Where each number comes from."""
    yield Prose(
        "Figs. 4 to 16 and Tables 1 to 3 of the paper have their counterparts here, under their "
        "numbers. Table 1 of the paper is lost: what is marked inferred was chosen so that the "
        "shortest and the longest rod come out as printed; other dimensions do so too, and a part "
        "below says which conclusions hang on the choice."
    )
    yield ParameterTable(
        "What the kinematics is computed with.", ["site", "days", "nominal", "rods", "joints"]
    )
