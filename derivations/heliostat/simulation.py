"""The heliostat once more: joints in pinocchio, searches in SciPy, the sun by ERFA."""

from armillary.verify.engines import each

from .checks_of_budget import budget_by_monte_carlo
from .checks_of_drive import (
    angles_come_back,
    chain_by_scipy,
    drive_by_pinocchio,
    nearest_by_scipy,
    stand_by_pinocchio,
    statuses_at_the_cone,
    statuses_without_a_normal,
    track_by_erfa,
)
from .checks_of_encoders import encoder_by_pinocchio, pointing_by_readings
from .checks_of_errors import (
    derivatives_by_duals,
    error_angles_by_numpy,
    normal_errors_by_pinocchio,
    orders_of_the_laws,
    orders_of_the_rotations,
    rates_add_up,
    sizes_of_the_laws,
    terms_of_the_laws,
)
from .checks_of_optics import (
    beam_by_pinocchio,
    miss_by_intersection,
    on_the_mirror,
    optics_by_householder,
)


def checks(kernels):
    """Everything measured about the heliostat."""
    yield from each(
        kernels,
        stand_by_pinocchio,
        chain_by_scipy,
        drive_by_pinocchio,
        angles_come_back,
        statuses_at_the_cone,
        statuses_without_a_normal,
        nearest_by_scipy,
        track_by_erfa,
        optics_by_householder,
        beam_by_pinocchio,
        miss_by_intersection,
        on_the_mirror,
        derivatives_by_duals,
        rates_add_up,
        orders_of_the_laws,
        sizes_of_the_laws,
        terms_of_the_laws,
        orders_of_the_rotations,
        normal_errors_by_pinocchio,
        error_angles_by_numpy,
        encoder_by_pinocchio,
        pointing_by_readings,
        budget_by_monte_carlo,
    )
