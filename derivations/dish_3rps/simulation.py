"""The dish once more: hinges in MuJoCo, rods in single precision, the law in SciPy."""

from armillary.verify.engines import each

from .checks_of_control import law_at_its_bound, law_by_scipy
from .checks_of_multibody import forces_by_mujoco, poses_by_mujoco
from .checks_of_rods import (
    extremes_of_the_paper,
    facets_by_turning,
    height_by_two_searches,
    rays_of_aimed_facets,
    rods_in_single_precision,
    squares_over_the_height,
)


def checks(kernels):
    """Everything measured about the dish."""
    yield from each(
        kernels,
        facets_by_turning,
        poses_by_mujoco,
        forces_by_mujoco,
        extremes_of_the_paper,
        height_by_two_searches,
        squares_over_the_height,
        rods_in_single_precision,
        rays_of_aimed_facets,
        law_by_scipy,
        law_at_its_bound,
    )
