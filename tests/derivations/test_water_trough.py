"""The trough's own integrator and what the study feeds it."""

from itertools import pairwise
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.integrate import quad

from armillary.derivation.beside import run
from armillary.verify.implementations import generated_module
from armillary.verify.parameters import read_parameters

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "derivations" / "water_trough"

motion_of, pumping, troughs, cycles_of = (
    run(FOLDER / f"{name}.py").module for name in ("motion_of", "pumping", "troughs", "cycles_of")
)


@pytest.fixture(scope="module")
def kernels():
    return generated_module(ROOT / "generated" / "python", "armillary_kernels", "water_trough")


@pytest.fixture(scope="module")
def parameters():
    return read_parameters(FOLDER / "parameters.toml")


@pytest.fixture(scope="module")
def trough(parameters):
    return troughs.trough(parameters)


def rest(kernels, trough, s=0.0):
    return float(kernels.rest_angle(s=s, **trough).theta)


def test_a_piece_of_flow_is_the_rate_of_its_volume():
    piece = pumping.Piece(2.0, 5.0, 1e-3, 1e-5, -4e-5)
    for time in (2.0, 2.7, 4.1, 5.0):
        s, q, _ = piece(time)
        assert s == pytest.approx(1e-3 + quad(lambda t: piece(t)[1], 2.0, time)[0], abs=1e-16)
        assert q == pytest.approx(1e-5 + quad(lambda t: piece(t)[2], 2.0, time)[0], abs=1e-18)
    assert piece(5.0)[0] == pytest.approx(piece.last, abs=1e-18)
    assert [piece(time)[2] for time in (2.0, 5.0)] == [0.0, 0.0]


def test_pulses_follow_each_other_without_a_gap():
    pieces = pumping.pulses(1e-4, 0.5, (1.0, 4.0, 2e-5), (3.0, 2.0, -1e-5), (2.0, 0.0, 0.0))
    for one, other in pairwise(pieces):
        assert one.end == other.start
        assert one(one.end) == pytest.approx(other(other.start), abs=1e-16)
    assert pieces[-1].end == pytest.approx(12.0)
    assert pieces[-1].last == pytest.approx(1e-4 + 3.5 * 2e-5 - 1.5 * 1e-5)


def test_moments_of_a_tube_are_those_of_its_water():
    """Against a thousand pieces of water along it."""
    corners = np.array([(0.5, -0.1), (0.2, -0.3), (-0.4, -0.05)])
    found = troughs.tube(corners, 2e-4, 1000.0)
    u = (np.arange(1000) + 0.5) / 1000
    xi, eta, mass, swept = [], [], [], 0.0
    for a, b in pairwise(corners):
        at = a + u[:, None] * (b - a)
        xi, eta = np.append(xi, at[:, 0]), np.append(eta, at[:, 1])
        mass = np.append(mass, np.full(1000, 0.2 * np.linalg.norm(b - a) / 1000))
        swept += float(np.sum(at[:, 0] * (b - a)[1] - at[:, 1] * (b - a)[0])) / 1000
    assert found["m_t"] == pytest.approx(mass.sum())
    assert found["S_t_xi"] == pytest.approx(mass @ xi)
    assert found["S_t_eta"] == pytest.approx(mass @ eta)
    assert found["I_t"] == pytest.approx(mass @ (xi**2 + eta**2), rel=1e-6)
    assert found["Gamma_t"] == pytest.approx(swept)


def test_a_pulse_moves_the_trough_and_the_book_closes(kernels, trough):
    pieces = pumping.pulses(0.0, 0.4, (1.0, 3.0, 4e-5), (25.0, 0.0, 0.0))
    record = motion_of.Motion(kernels, trough, 1e-10).run(pieces, rest(kernels, trough))
    modes = [mode for _, _, mode in record.events]
    assert modes[:2] == ["stick", "slip +"]
    assert modes[-1] == "stick"
    assert record.rows[-1][2] == 0.0
    off = np.abs(motion_of.closed(kernels, trough, record)).max()
    assert off < 1e-9 * np.ptp(record.column("work"))
    assert record.column("heat")[-1] > 1e-4
    assert np.all(np.diff(record.column("heat")) >= -1e-12)


def test_without_friction_it_swings_with_the_period_of_the_rest(kernels, trough):
    free = {**trough, "mu": 0.0}
    period = float(kernels.rest(s=0.0, **free).period)
    still = pumping.Piece(0.0, 3 * period, 0.0)
    first = rest(kernels, free) + 1e-3
    record = motion_of.Motion(kernels, free, 1e-11, book=False).run([still], first)
    turns = [time for time, _, mode in record.events if mode == "slip +"]
    assert np.diff(turns) == pytest.approx([period] * (len(turns) - 1), rel=1e-6)
    assert len(turns) >= 2


def test_inside_the_band_it_stands_and_outside_it_does_not(kernels, trough):
    width = float(kernels.stick_band(s=0.0, **trough).half_width)
    still = [pumping.Piece(0.0, 1.0, 0.0)]
    for part, sense in ((1 - 1e-9, None), (1 + 1e-9, "slip -"), (-1 - 1e-9, "slip +")):
        first = rest(kernels, trough) + part * width
        record = motion_of.Motion(kernels, trough, 1e-8, book=False).run(still, first)
        modes = [mode for _, _, mode in record.events]
        assert (modes == ["stick"]) if sense is None else (modes[0] == sense)


@pytest.mark.parametrize("angle", [-0.7, 0.0, 0.7])
def test_it_slips_back_after_the_water_of_a_reversal(kernels, trough, angle):
    told = kernels.stick_volumes(theta=angle, **trough)
    first, back, flow = float(told.s_on), float(told.s_back), 1e-6
    length = 1.1 * abs(back - first) / flow
    sign = np.sign(back - first)
    pieces = pumping.joined(first, 0.0, (1.0, sign * flow), (length, sign * flow))
    record = motion_of.Motion(kernels, trough, 1e-8, book=False).run(pieces, angle)
    time = next(time for time, _, mode in record.events if mode == "slip -")
    assert pieces[1](time)[0] - first == pytest.approx(back - first, rel=1e-6)


def test_a_container_that_would_overflow_stops_the_motion(kernels, trough):
    pieces = pumping.pulses(0.0, 0.4, (0.5, 200.0, 5e-5))
    with pytest.raises(motion_of.MotionError, match="answers -3"):
        motion_of.Motion(kernels, trough, 1e-6, book=False).run(pieces, rest(kernels, trough))


def test_smooth_friction_creeps_as_predicted(kernels, trough):
    width = float(kernels.stick_band(s=0.0, **trough).half_width)
    given = {**trough, "omega_s": 1e-5}
    still = [pumping.Piece(0.0, 1.0, 0.0)]
    first = rest(kernels, trough) + np.arcsin(0.6 * np.sin(width))
    _, theta, omega = motion_of.creeping(kernels, given, still, first)
    told = kernels.creep(theta=theta[-1], s=0.0, **given)
    assert omega[-1] == pytest.approx(told.omega, rel=1e-4)
    assert told.omega < 0


def test_friction_that_neither_holds_nor_lets_go_stops_the_motion(trough):
    """Driven on at rest, and back as soon as it moves."""

    def acceleration(omega, **_):
        return SimpleNamespace(alpha=np.where(np.asarray(omega) == 0, 1.0, -1.0), status=0)

    fake = SimpleNamespace(acceleration=acceleration, pump_pressure=None, friction=None)
    motion = motion_of.Motion(fake, trough, 1e-6, book=False)
    with pytest.raises(motion_of.MotionError, match="neither holds"):
        motion.run([pumping.Piece(0.0, 1.0, 0.0)], 0.0)


def test_work_is_booked_while_a_trough_waits_on_the_edge(kernels, trough):
    motion = motion_of.Motion(kernels, trough, 1e-6)
    piece = pumping.Piece(0.0, 1.0, 0.0, 1e-5, 1e-5)
    end, y = motion._wait(piece, 0.25, np.array([0.1, 0.0, 2.0, 3.0]))
    s, q, q_dot = piece(0.25)
    power = (
        kernels.pump_pressure(theta=0.1, omega=0.0, s=s, q=q, q_dot=q_dot, **trough).pressure * q
    )
    assert end == 0.25 + motion.pause
    assert y[2] - 2.0 == pytest.approx(float(power) * motion.pause, rel=1e-3)
    assert (y[0], y[1], y[3]) == (0.1, 0.0, 3.0)


def test_the_cycle_of_the_pump_is_that_of_the_motion(kernels, trough, parameters):
    """Behind the sun and back before it: a mirror of the same."""
    given = {**trough, **troughs.law(parameters), "lag": 0.2}
    pump, found = cycles_of.Pump(up=0.4, down=0.05), []
    for sense in (1, -1):
        rate = sense * np.radians(15) / 3600
        (one,) = cycles_of.cycles(kernels, given, pump, rate, 0.0, 1, tolerance=1e-6)
        told = kernels.cycle(s=one.s, theta_dot_ref=rate, **given)
        found.append(one)
        assert float(told.travel) == pytest.approx(one.travel, rel=0.1)
        assert not one.backs
        assert one.error_rest < given["band_off"]
    assert found[0].travel == pytest.approx(found[1].travel, rel=1e-4)
    assert found[0].t_on == pytest.approx(found[1].t_on, rel=1e-4)


@pytest.mark.parametrize("size", troughs.SIZES)
def test_open_containers_run_over_beyond_the_stroke_only(kernels, parameters, size):
    """At the angle told a level surface stands at the rim, by plain trigonometry."""
    study = run(FOLDER / "study_surface.py").module
    given = troughs.trough(parameters, size)
    angle = study.brim(kernels, given)
    assert angle > parameters.place.stroke
    s = float(kernels.rest_volume(theta=np.radians(angle), **given).s)
    level = given["h_10"] + s / given["A_1"] + given["w"] / 2 * np.tan(np.radians(angle))
    assert level == pytest.approx(given["h_max"], rel=5e-3)


def test_a_sampling_period_begins_with_the_flow_there_was_and_ends_with_the_one_asked_for(
    parameters,
):
    day = run(FOLDER / "study_day.py").module
    settings = parameters.control
    for before, flow in ((0.0, 1e-6), (1e-6, -1e-6), (2e-6, 2e-6)):
        pieces = day.sample(10.0, settings, 1e-4, before, flow)
        assert pieces[0].start == 10.0
        assert pieces[-1].end == 10.0 + settings.period
        assert pieces[0](10.0)[:2] == pytest.approx((1e-4, before), abs=1e-18)
        assert pieces[-1](pieces[-1].end)[1] == pytest.approx(flow, abs=1e-18)
        moved = sum(quad(lambda t, p=p: p(t)[1], p.start, p.end)[0] for p in pieces)
        assert pieces[-1].last == pytest.approx(1e-4 + moved, abs=1e-14)


def test_volumes_of_a_trough_keep_both_levels_inside(kernels, parameters):
    for size in troughs.SIZES:
        given = troughs.trough(parameters, size)
        s = troughs.volumes(kernels, given, 21)
        assert np.all(kernels.levels(s=s, **given).status == 0)
        step = s[1] - s[0]
        beyond = kernels.levels(s=np.array([s[0] - 1.5 * step, s[-1] + 1.5 * step]), **given)
        assert np.all(beyond.status < 0)
