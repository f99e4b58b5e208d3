"""The tracker once more: loops closed in pinocchio and MuJoCo, the rest in NumPy and SciPy."""

from armillary.verify.engines import each

from .checks_of_dynamics import (
    forces_by_mujoco,
    forces_by_pinocchio,
    forward_dynamics_inverts,
    masses_by_pinocchio,
)
from .checks_of_forces import (
    energy_by_pinocchio,
    forces_by_algebra,
    massless_legs,
    motors,
    power_balances,
    preload_does_nothing,
    third_leg_is_absent,
)
from .checks_of_forward import (
    forward_by_scipy,
    forward_inverts,
    forward_is_blind,
    forward_is_redundant,
    forward_of_anything,
    forward_on_the_day,
)
from .checks_of_inertia import masses_on_one_leg, platforms_of_little_mass
from .checks_of_kinematics import (
    lengths_by_numpy,
    loops_by_pinocchio,
    rates_by_dual_numbers,
    regular_motions,
    turning_by_pinocchio,
)
from .checks_of_singularities import (
    around_home,
    awkward_motions,
    equinox_path,
    home_pose,
    legs_nearly_along,
    legs_without_direction,
    singularity_by_numpy,
    two_legs_by_roots,
)
from .checks_of_spin import (
    spin_free_by_numpy,
    spin_is_about_the_leg,
    spin_matters,
    spin_of_round_light_legs,
)
from .checks_of_trajectory import (
    aim_by_scipy,
    declination_left_out,
    horizon_by_the_sun,
    midnight_sun,
    nearest_by_scipy,
    overhead,
    passes,
    rates_by_circles,
    track_by_erfa,
)
from .checks_of_work import forces_by_virtual_work

CHECKS = (
    regular_motions,
    lengths_by_numpy,
    loops_by_pinocchio,
    turning_by_pinocchio,
    rates_by_dual_numbers,
    forces_by_pinocchio,
    forces_by_mujoco,
    masses_by_pinocchio,
    forward_dynamics_inverts,
    forces_by_virtual_work,
    forces_by_algebra,
    preload_does_nothing,
    third_leg_is_absent,
    massless_legs,
    energy_by_pinocchio,
    power_balances,
    motors,
    spin_free_by_numpy,
    spin_is_about_the_leg,
    spin_of_round_light_legs,
    spin_matters,
    home_pose,
    around_home,
    two_legs_by_roots,
    equinox_path,
    singularity_by_numpy,
    awkward_motions,
    legs_without_direction,
    legs_nearly_along,
    masses_on_one_leg,
    platforms_of_little_mass,
    aim_by_scipy,
    nearest_by_scipy,
    overhead,
    passes,
    rates_by_circles,
    track_by_erfa,
    declination_left_out,
    horizon_by_the_sun,
    midnight_sun,
    forward_inverts,
    forward_by_scipy,
    forward_is_redundant,
    forward_of_anything,
    forward_on_the_day,
    forward_is_blind,
)


def checks(kernels):
    """Everything measured about the tracker."""
    yield from each(kernels, *CHECKS)
