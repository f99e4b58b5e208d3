"""Engines: absent ones are named, pinocchio answers as the text book does."""

import numpy as np
import pytest

from armillary.verify.engines import EngineMissing, each, need
from armillary.verify.measured import Measured, Skipped


def test_an_absent_engine_is_named_with_the_mend():
    with pytest.raises(EngineMissing, match=r"gazebo is not installed.*armillary\[check\]"):
        need("gazebo.physics")


def test_a_present_engine_is_imported():
    assert need("numpy.linalg") is np.linalg


def test_a_broken_engine_is_not_an_absent_one(tmp_path, monkeypatch):
    (tmp_path / "halfengine.py").write_text("import there_is_no_such_thing\n")
    monkeypatch.syspath_prepend(tmp_path)
    with pytest.raises(ModuleNotFoundError, match="there_is_no_such_thing"):
        need("halfengine")


def test_one_absent_engine_does_not_stop_the_others():
    fine = Measured("fine", "numpy", None, 1, 0.0, 0.0)

    def by_gazebo(kernels):
        yield fine
        need("gazebo")

    def by_numpy(kernels):
        yield fine

    found = list(each(None, by_gazebo, by_numpy))
    assert found[0] is fine
    assert found[2] is fine
    assert isinstance(found[1], Skipped)
    assert (found[1].name, found[1].engine) == ("by gazebo", "gazebo")


@pytest.fixture
def arm():
    pytest.importorskip("pinocchio")
    from armillary.verify.engines.rigid import Fixed, Mechanism, Revolute

    column, arm = Fixed((0, 0, 2.0)), Fixed((0, 3.0, 0))
    return Mechanism([column, Revolute((0, 0, -2)), arm, Revolute((1, 0, 0)), Fixed((0, 0, 1.5))])


def by_hand(a, b):
    """Tz(2) Rz(-a) Ty(3) Rx(b) Tz(1.5), entry by entry."""
    sa, ca, sb, cb = np.sin(a), np.cos(a), np.sin(b), np.cos(b)
    reach = 3.0 - 1.5 * sb
    return np.array([
        [ca, sa * cb, -sa * sb, sa * reach],
        [-sa, ca * cb, -ca * sb, ca * reach],
        [0, sb, cb, 2.0 + 1.5 * cb],
        [0, 0, 0, 1],
    ])  # fmt: skip


def test_pose(arm):
    assert np.allclose(arm.pose([0.3, -0.8]), by_hand(0.3, -0.8), atol=1e-15)
    both = arm.pose([[0.3, -0.8], [2.0, 1.0]])
    assert both.shape == (2, 4, 4)
    assert np.allclose(both[1], by_hand(2.0, 1.0), atol=1e-15)


def test_jacobian_and_velocity(arm):
    q, speed, h = np.array([0.3, -0.8]), np.array([0.7, 0.2]), 1e-6
    columns = [(by_hand(*(q + h * e)) - by_hand(*(q - h * e)))[:3, 3] / (2 * h) for e in np.eye(2)]
    jacobian = arm.jacobian(q)
    assert np.allclose(jacobian[:3], np.transpose(columns), atol=1e-9)
    axis = by_hand(0.3, 0.0)[:3, 0]
    assert np.allclose(jacobian[3:], np.transpose([[0, 0, -1], axis]), atol=1e-15)
    assert np.allclose(arm.velocity(q, speed), jacobian @ speed, atol=1e-15)
    turned = np.kron(np.eye(2), by_hand(*q)[:3, :3].T)
    assert np.allclose(arm.body_velocity(q, speed), turned @ jacobian @ speed, atol=1e-15)


def test_a_fixed_turn_and_a_slide():
    pytest.importorskip("pinocchio")
    from armillary.verify.engines.rigid import Fixed, Mechanism, Prismatic

    slide = Mechanism([Fixed(rpy=(0, 0, np.pi / 2)), Prismatic((1, 0, 0))])
    assert np.allclose(slide.pose([2.0])[:3, 3], [0, 2, 0], atol=1e-15)
    assert np.allclose(slide.jacobian([2.0])[:, 0], [0, 1, 0, 0, 0, 0], atol=1e-15)
