"""The dish once more: hinges in NumPy, SciPy and MuJoCo, rods in single precision, the law."""

from armillary.verify.engines import each

from .checks_of_control import law_at_its_bound, law_by_scipy
from .checks_of_kinematics import (
    aim_by_scipy,
    facets_face_down,
    forces_by_balance,
    forward_inverts,
    jacobians_of_the_rods,
    joints_by_numpy,
    planes_of_an_aimed_facet,
    planes_of_the_hinges,
    pose_by_scipy,
    rates_by_complex_steps,
    rods_that_hold_nothing,
)
from .checks_of_multibody import forces_by_mujoco, poses_by_mujoco
from .checks_of_rods import (
    extremes_of_the_paper,
    facets_by_turning,
    height_by_two_searches,
    rays_of_aimed_facets,
    rods_in_single_precision,
    squares_over_the_height,
)
from .checks_of_surface import normals_meet


def checks(kernels):
    """Everything measured about the dish."""
    yield from each(
        kernels,
        normals_meet,
        planes_of_the_hinges,
        pose_by_scipy,
        rates_by_complex_steps,
        jacobians_of_the_rods,
        joints_by_numpy,
        forces_by_balance,
        forward_inverts,
        planes_of_an_aimed_facet,
        aim_by_scipy,
        facets_face_down,
        rods_that_hold_nothing,
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
