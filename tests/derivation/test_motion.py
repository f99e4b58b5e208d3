"""`define_motion`: seven definitions and three kernels, said of the mechanism at hand."""

import pytest

from armillary import Chain, Derivation, Rate, X, Z, define_motion
from armillary.derivation.errors import DerivationError
from armillary.program.compile import compile_kernel
from armillary.verify import duals

NAMES = ["M", "Omega_space", "Omega_body", "v_origin", "v_spatial", "V_space", "J"]


def mount(**words):
    d = Derivation("mount", title="Mount")
    turn, tilt = (d.angle(name, "a drive", rate=Rate.TICK) for name in ("turn", "tilt"))
    arm = d.parameter.length("arm", "an arm")
    chain = Chain("ground").rotate(Z, -turn).translate(Z, arm).rotate(X, tilt)
    return d, define_motion(d, chain.translate(Z, arm, frame="dish"), "dish", (turn, tilt), **words)


def test_definitions_and_kernels_are_made_in_order():
    d, motion = mount()
    assert list(d.definitions) == NAMES
    assert all(d.definition_of(getattr(motion, name)).name == name for name in NAMES)
    inputs = {name: [q.name for q in kernel.inputs] for name, kernel in d.kernels.items()}
    assert inputs == {
        "pose": ["turn", "tilt"],
        "velocity": ["turn", "tilt", "turn_dot", "tilt_dot"],
        "jacobian": ["turn", "tilt"],
    }


def test_it_speaks_of_the_mechanism():
    d, _ = mount(foot="the foot of the pole", printed={"M": "7"}, because={"J": "As the author."})
    stated = d.definitions
    assert stated["M"].printed == "7"
    assert stated["J"].because == "As the author."
    foot = "the foot of the pole"
    assert stated["v_spatial"].meaning == f"velocity of the dish's point that passes {foot}"
    assert "from the ground up" in stated["M"].because
    assert all(definition.source.path == __file__ for definition in stated.values())


def test_dual_numbers_cover_all_of_it():
    d, _ = mount()
    programs = {name: compile_kernel(kernel).program for name, kernel in d.kernels.items()}
    made = list(duals.checks(d, programs))
    assert len(made) == len(NAMES) - 1
    assert all(m.passed for m in made), made


@pytest.mark.parametrize("words", [{"printed": {"Omega": "3"}}, {"because": {"Omega": "So."}}])
def test_an_unknown_name_is_told_with_the_known_ones(words):
    with pytest.raises(DerivationError, match=r"defines no Omega\n.*it defines M, Omega_space"):
        mount(**words)
