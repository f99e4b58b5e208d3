"""The trough once more: SymPy's Lagrange equations, water as parcels, SciPy, and pvlib."""

from armillary.verify.engines import each

from .checks_of_axis import (
    awkward_suns,
    backtracking_by_pvlib,
    backtracking_without_limits,
    least_by_search,
    theta_of_the_trough,
    year_by_pvlib,
)
from .checks_of_control import law_by_hand, law_by_machine
from .checks_of_cycle import (
    cycle_across_a_swing,
    cycle_beside_a_swing,
    cycle_by_motion,
    cycle_by_swings,
    cycle_of_many_swings,
    cycle_refused,
    cycle_that_hunts,
)
from .checks_of_motion import (
    by_euler_lagrange,
    by_parcels,
    friction_by_root,
    friction_near_jamming,
    off_the_plane,
    refused_and_told,
    sticks_up_to_its_limit,
    tube_of_parts,
)
from .checks_of_rest import (
    band_by_kernels,
    creep_of_smooth_friction,
    level_surfaces,
    limits_of_the_model,
    linear_to_second_order,
    rest_by_parcels,
    rest_volume_inverts,
    upright,
    volumes_of_breakaway,
)
from .checks_of_shadows import limits_of_the_stroke, rows_of_any_cover, shadows_by_rays
from .checks_of_time import (
    breaking_away,
    energy_closes,
    following,
    swings,
)


def checks(kernels):
    """Everything measured about the trough."""
    yield from each(
        kernels,
        by_euler_lagrange,
        by_parcels,
        off_the_plane,
        tube_of_parts,
        friction_by_root,
        friction_near_jamming,
        sticks_up_to_its_limit,
        refused_and_told,
        rest_by_parcels,
        linear_to_second_order,
        rest_volume_inverts,
        upright,
        level_surfaces,
        band_by_kernels,
        volumes_of_breakaway,
        creep_of_smooth_friction,
        limits_of_the_model,
        energy_closes,
        swings,
        following,
        breaking_away,
        cycle_by_swings,
        cycle_beside_a_swing,
        cycle_by_motion,
        cycle_across_a_swing,
        cycle_of_many_swings,
        cycle_refused,
        cycle_that_hunts,
        law_by_machine,
        law_by_hand,
        year_by_pvlib,
        backtracking_by_pvlib,
        backtracking_without_limits,
        least_by_search,
        theta_of_the_trough,
        awkward_suns,
        shadows_by_rays,
        rows_of_any_cover,
        limits_of_the_stroke,
    )
