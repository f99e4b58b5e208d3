"""The audit of Yu and the study of its tracker judge the same claims alike."""

import numpy as np
import pytest

from armillary.verify.audit.verdict import Verdict
from armillary.verify.implementations import generated_module
from tests.rr_3ups.conftest import ROOT, studied

ALIKE = {
    "reproduced": Verdict.HOLDS,
    "not reproduced": Verdict.WRONG,
    "not determined": Verdict.NOT_CHECKABLE,
}
ONLY_IN_THE_STUDY = {"Fig. 9"}  # a plot of both powers, of which the text has no number
# Section 4 of the paper begins with the four days: its claims, but for Table 1.
FIRST = "summer and winter"
# A second reason for a claim, by its key.
PARTS = {"36 N where the determinant is 0": "36 N"}


@pytest.fixture(scope="module")
def study():
    return studied().verdicts


def test_every_claim_of_the_day_is_judged_alike(found, study):
    audit = {key: finding.verdict for key, finding in found["yu"].items()}
    shared = audit.keys() & study.keys()
    assert {key: audit[key] for key in shared} == {key: ALIKE[study[key]] for key in shared}
    assert study.keys() - shared == ONLY_IN_THE_STUDY


def test_no_claim_of_the_day_is_judged_in_one_place_only(papers, found, study):
    keys = list(papers["yu"].printed)
    days = [key for key in keys[keys.index(FIRST) :] if key not in ("34", "35", "36")]
    assert set(days) - study.keys() == set(PARTS)
    for part, whole in PARTS.items():
        assert found["yu"][part].verdict is ALIKE[study[whole]]


def test_the_nearest_mass_centre_misses_as_far_in_both(found):
    """The audit looks for it by itself: another grid, other samples of the day, other code."""
    residual = studied().results("unknowns")["unknowns"]["residual"]
    assert found["yu"]["30 N"].readings[0].worst == pytest.approx(residual, rel=0.1)


def test_the_mass_centres_x_moves_no_force_at_rest():
    """The audit leaves it out of what is not printed; beside it, y and z do move them."""
    kernels = generated_module(ROOT / "generated" / "python", "armillary_kernels", "rr_3ups")
    legs = {"r": [0.3] * 3, "phi": np.radians([-150, -30, 90]), "R": [0.6, 0.6, 0.4],
            "theta": np.radians([-150, -30, 90]), "h": [0.6, 0.6, 0.0],
            "zeta": np.radians([0, 0, -90]), "t": [0.2] * 3, "s": [0.2] * 3,
            "m_t": [11.0] * 3, "m_s": [6.0] * 3, "I_t": [[0.2, 2.0, 0.2]] * 3,
            "I_s": [[0.1, 1.0, 0.1]] * 3}  # fmt: skip
    sizes = {**{name: np.array(value) for name, value in legs.items()}, "h_0": 0.6, "m_m": 70.0,
             "I_m": np.array([11.0, 11.0, 1.0]), "g": 9.8}  # fmt: skip
    rest = dict.fromkeys(("alpha_dot", "beta_dot", "alpha_ddot", "beta_ddot"), 0.0)
    calm = {"f_d": np.zeros(3), "n_d": np.zeros(3)}

    def forces(x, y, z):
        at = {"alpha": np.array([0.4, -1.1]), "beta": np.array([0.7, 1.2])}
        place = {"r_sc": np.array([x, y, z])}
        return [kernel(**at, **rest, **calm, **sizes, **place).F
                for kernel in (kernels.forces, kernels.forces_two_legs)]  # fmt: skip

    for here, there, moved in zip(
        forces(0.1, 0.02, 0.03), forces(-0.1, 0.02, 0.03), forces(0.1, 0.03, 0.03), strict=True
    ):
        np.testing.assert_allclose(there, here, rtol=1e-12)
        assert np.abs(moved - here).max() > 1
