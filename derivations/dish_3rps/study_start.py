"""What the study is computed with."""

from armillary.verify.study import ParameterTable, Prose


def start(kernels):
    """Where each number comes from."""
    yield Prose(
        "Every figure and table of the paper has its counterpart here, under its number. Table 1 "
        "of the paper is lost: what is marked inferred was chosen so that the shortest and the "
        "longest rod come out as printed; other dimensions do so too, and a part below says which "
        "conclusions hang on the choice."
    )
    yield ParameterTable(
        "What the kinematics is computed with.", ["site", "days", "nominal", "rods", "joints"]
    )
