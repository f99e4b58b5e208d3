"""Readings against pinocchio and against themselves; the pointing law against the exact reading."""

import numpy as np

from armillary import Status
from armillary.verify.measured import compare
from armillary.verify.points import chosen

from .checks_of_errors import worst
from .rays import COUNT, drives_everywhere, poses, tilts

TURN = 2 * np.pi


def _encoders(n, seed):
    """Zeros anywhere on the circle and collimation errors up to 0.1 rad."""
    random = np.random.default_rng(seed)
    return {
        "alpha_0": random.uniform(-np.pi, np.pi, n),
        "beta_0": random.uniform(-np.pi, np.pi, n),
        "collimation": random.uniform(-0.1, 0.1, n),
    }


def encoder_by_pinocchio(kernels):
    """At the readings the true normal points where the drive angles would point the first axis."""
    points = drives_everywhere(81)
    points |= _encoders(len(points["alpha"]), 82)
    found = kernels.encoder(**points)
    ok = found.status == Status.OK
    some = chosen(points, ok)
    read = found.alpha_reading[ok], found.beta_reading[ok]
    driven = poses(some, read[0] - some["alpha_0"], read[1] - some["beta_0"])
    offset = some["collimation"]
    body = np.stack([np.cos(offset), np.sin(offset), np.zeros_like(offset)], axis=1)
    yield compare(
        "at the readings the true normal points where it is wanted", "pinocchio",
        np.einsum("kij,kj->ki", driven, body), poses(some, some["alpha"], some["beta"])[:, :, 0],
        1e-14, some, "encoder",
    )  # fmt: skip
    excess = np.maximum(np.abs(np.stack(read)) - np.pi, 0.0).max(axis=0)
    yield compare("readings lie in [-pi, pi]", "bounds", excess, 0.0, 0.0, some, "encoder")
    kept = np.minimum(np.cos(read[1] - some["beta_0"]) * np.sign(np.cos(some["beta"])), 0.0)
    yield compare("the branch is kept", "bounds", kept, 0.0, 1e-15, some, "encoder")
    yield from _inverse(kernels, some, read)
    yield from _blind(points, found.status)


def _inverse(kernels, points, read):
    """Decoded, the readings give the drive angles again, as far as the edge lets them."""
    rest = {name: a for name, a in points.items() if name not in ("alpha", "beta")}
    back = kernels.encoder_inverse(alpha_reading=read[0], beta_reading=read[1], **rest)
    # Both the edge of the drive and that of the reading magnify what is rounded.
    near = np.minimum(np.cos(points["beta"]) ** 2, np.cos(read[1] - points["beta_0"]) ** 2)
    for name in ("alpha", "beta"):
        apart = np.remainder(getattr(back, name) - points[name] + np.pi, TURN) - np.pi
        yield compare(
            f"{name} comes back from the readings, times the smaller cos(beta)^2", "round trip",
            apart * near, 0.0, 1e-14, points, "encoder_inverse",
        )  # fmt: skip


def _blind(points, status):
    """Near the azimuth axis an offset normal cannot be brought: by the height it would need."""
    chi, offset = points["chi"], points["collimation"]
    height = np.cos(chi) * np.sin(points["beta"])
    across = np.sqrt(1 - height**2)
    needed = np.abs(np.sin(offset) + np.sin(chi) * height) - across * np.cos(chi)
    decided = np.abs(needed) > 1e-9
    wanted = np.where(needed > 0, Status.UNREACHABLE, Status.OK)
    yield compare(
        "a normal that cannot be brought there is told", "geometry", status[decided],
        wanted[decided], 0.0, chosen(points, decided), "encoder",
    )  # fmt: skip


# -- telescope pointing terms ---------------------------------------------------------------------


def _sky(n, seed):
    """Azimuths all round and elevations up to 70 degrees."""
    random = np.random.default_rng(seed)
    return {"azimuth": random.uniform(0, TURN, n), "elevation": random.uniform(-1.2, 1.2, n)}


def pointing_by_readings(kernels):
    """The law against drive and encoder: its error falls by 4 when all six errors are halved."""
    sky = _sky(COUNT, 83)
    level = np.cos(sky["elevation"])
    n = np.stack(
        [
            np.sin(sky["azimuth"]) * level,
            np.cos(sky["azimuth"]) * level,
            np.sin(sky["elevation"]),
        ],
        axis=1,
    )
    random = np.random.default_rng(84)
    errors = {**tilts(COUNT, 85)}
    errors |= {name: random.uniform(-0.3, 0.3, COUNT) for name in _encoders(1, 0)}

    def apart(scale):
        given = {name: scale * a for name, a in errors.items()}
        aimed = kernels.drive(c=n, b=n, **given)
        read = kernels.encoder(alpha=aimed.alpha, beta=aimed.beta, **given)
        law = kernels.pointing(**sky, **given)
        turn = read.alpha_reading + np.pi - sky["azimuth"] - law.delta_azimuth
        rise = read.beta_reading - sky["elevation"] - law.delta_elevation
        return np.hypot(np.remainder(turn + np.pi, TURN) - np.pi, rise)

    once, half = apart(0.02), apart(0.01)
    slope = np.log2(np.sqrt(np.mean(once**2)) / np.sqrt(np.mean(half**2)))
    yield compare(
        f"reading minus nominal: the error of the law falls as order 2 ({slope:.3f})",
        "drive, encoder", slope, 2.0, 0.02, {"scale": 0.02}, "pointing", relative=False,
    )  # fmt: skip
    yield from _one_by_one(kernels, sky, n)
    yield from _sizes(kernels)


def _sizes(kernels):
    """How far the law is off at most, all four errors that it truncates at their ends."""
    for size, rise, bounds in ((0.3, 30, (0.9, 0.5)), (0.01, 60, (1.4e-3, 4e-4))):
        points = worst(size, rise, ("theta", "psi", "chi", "collimation")) | {
            "alpha_0": 0.0,
            "beta_0": 0.0,
        }
        n = points.pop("c")
        sky = {
            "azimuth": np.arctan2(n[:, 0], n[:, 1]),
            "elevation": np.arcsin(n[:, 2]),
        }
        errors = {name: a for name, a in points.items() if name != "b"}
        aimed = kernels.drive(c=n, b=n, **errors)
        read = kernels.encoder(alpha=aimed.alpha, beta=aimed.beta, **errors)
        law = kernels.pointing(**sky, **errors)
        for name, found, wanted, bound in (
            ("azimuth", law.delta_azimuth, read.alpha_reading + np.pi - sky["azimuth"], bounds[0]),
            ("elevation", law.delta_elevation, read.beta_reading - sky["elevation"], bounds[1]),
        ):
            yield compare(
                f"{name} for errors of up to {size:g} rad, up to {rise} degrees high",
                "drive, encoder", found, wanted, bound, {**sky, **errors}, "pointing",
                relative=False, turn=True,
            )  # fmt: skip


def _one_by_one(kernels, sky, n):
    """Each term by itself, at a ten millionth of a radian, against the law of telescopes."""
    azimuth, elevation = sky["azimuth"], sky["elevation"]
    secant, tangent = 1 / np.cos(elevation), np.tan(elevation)
    zero, one = np.zeros(COUNT), np.ones(COUNT)
    laws = {
        "IA": (one, zero),
        "IE": (zero, one),
        "CA": (secant, zero),
        "NPAE": (tangent, zero),
        "AN": (np.sin(azimuth) * tangent, np.cos(azimuth)),
        "AW": (np.cos(azimuth) * tangent, -np.sin(azimuth)),
    }
    names = ("alpha_0", "beta_0", "collimation", "chi", "theta", "psi")
    small = 1e-7
    for name in names:
        given = {other: small * (other == name) for other in names}
        terms = kernels.pointing_terms(**given)
        aimed = kernels.drive(c=n, b=n, **given)
        read = kernels.encoder(alpha=aimed.alpha, beta=aimed.beta, **given)
        turn = np.remainder(read.alpha_reading - azimuth, TURN) - np.pi
        found = np.stack([turn, read.beta_reading - elevation], axis=1)
        law = sum(float(getattr(terms, t)) * np.stack(way, axis=1) for t, way in laws.items())
        yield compare(
            f"what {name} does to the readings is its term of the pointing law", "drive, encoder",
            found / small, law / small, 1e-5, sky, "pointing_terms",
        )  # fmt: skip
