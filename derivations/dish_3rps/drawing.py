"""Line drawings of a facet: its joints in space, and how they are seen from a side."""

import numpy as np

from armillary.verify.plots import Curve, Plot

EYE_AZIMUTH, EYE_ELEVATION = 160.0, 20.0  # degrees from north and above the horizon
ROUND = np.radians([0.0, 120.0, -120.0])  # of the joints, in base and platform
CIRCLE = np.stack([np.cos(ROUND), np.sin(ROUND), 0 * ROUND], axis=-1)
NORMAL = 0.6  # m, length of the drawn normal and of the drawn ray to the sun
GAP = np.full((1, 3), np.nan)


def joints(kernels, size, angles):
    """Base joints, platform joints, and the pose of the facet; batches by azimuth phi."""
    pose = kernels.facet(**angles, **size)
    phi = np.asarray(angles["phi"])
    inward = phi - np.pi  # the base's first joint is on the dish's side
    round_ = inward[..., None] + ROUND
    middle = size["d"] * np.stack([np.cos(phi), np.sin(phi), 0 * phi], axis=-1)
    base = middle[..., None, :] + size["r_b"] * np.stack(
        [np.cos(round_), np.sin(round_), 0 * round_], axis=-1
    )
    arms = size["r_m"] * np.einsum("...ij,kj->...ki", pose.H_R_M, CIRCLE)
    platform = pose.M[..., None, :] + arms
    return np.broadcast_to(base, platform.shape), platform, pose


def seen(points):
    """Places on the paper, to the right and upward, seen without perspective."""
    turn, rise = np.radians(EYE_AZIMUTH), np.radians(EYE_ELEVATION)
    # The eye stands in this direction; what is right of it is clockwise from it, seen from above.
    right = np.array([-np.cos(turn), np.sin(turn), 0.0])
    upward = np.array([-np.sin(turn) * np.sin(rise), -np.cos(turn) * np.sin(rise), np.cos(rise)])
    return points @ right, points @ upward


def facet_drawing(caption, base, platform, M, normal, to_sun):
    """One facet: base, rods, platform, its normal and the ray to the sun from its point M."""
    pairs = zip(base, platform, strict=True)
    rods = np.concatenate([np.concatenate([b[None], s[None], GAP]) for b, s in pairs])
    lines = [
        ("rods", rods[:-1]),
        ("platform", np.concatenate([platform, platform[:1]])),
        ("base", np.concatenate([base, base[:1]])),
        ("normal of the facet", np.stack([M, M + NORMAL * normal])),
        ("to the sun", np.stack([M, M + NORMAL * to_sun])),
    ]
    curves = [Curve(name, *seen(points)) for name, points in lines]
    return Plot(caption, "to the right, m", "upward, m", curves, equal=True)
