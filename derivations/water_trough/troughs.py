"""The troughs of the study, as the kernels take them."""

import numpy as np

SIZES = ("small", "large")
TITLES = {"small": "smaller", "large": "larger"}


def tube(points, area, density):
    """Mass and moments of the water in a tube of straight parts, from container 2 to 1.

    Args:
        points: (n, 2), m, xi and eta of its corners.
        area: its cross-section, m^2.
        density: kg/m^3.
    """
    points = np.asarray(points, dtype=float)
    begin, end = points[:-1], points[1:]
    lengths = np.linalg.norm(end - begin, axis=1)
    masses = density * area * lengths
    first = masses @ (begin + end) / 2
    squares = np.sum(begin * begin + begin * end + end * end, axis=1) / 3
    swept = begin[:, 0] * end[:, 1] - begin[:, 1] * end[:, 0]
    return {
        "a_t": area, "L_t": float(lengths.sum()), "m_t": float(masses.sum()),
        "S_t_xi": float(first[0]), "S_t_eta": float(first[1]), "I_t": float(masses @ squares),
        "Gamma_t": float(swept.sum()),
    }  # fmt: skip


def trough(parameters, size="small"):
    """Parameters of a trough, all but those of the controller and of smooth friction."""
    of, around = getattr(parameters, size), parameters.around
    return {
        "M": of.M, "l": of.l, "lam": np.radians(of.lam), "I_zz": of.I_zz,
        "A_1": of.A, "A_2": of.A, "w": of.w, "x_1": -of.x, "y_1": of.y, "x_2": of.x, "y_2": of.y,
        "h_10": of.h_0, "h_20": of.h_0, "h_max": of.h_max,
        **tube([(of.x, of.y), (0.0, of.y - of.sag), (-of.x, of.y)], of.a_t, around.rho),
        "rho": around.rho, "g": around.g, "mu": of.mu, "r_f": of.r_f, "r_A": of.r_A, "r_B": of.r_B,
    }  # fmt: skip


def law(parameters, size="small"):
    """Parameters of the controller, as `pump_control` and `cycle` take them."""
    of, control = getattr(parameters, size), parameters.control
    return {
        "q_pump": of.q_pump,
        "band_on": np.radians(control.band_on),
        "band_off": np.radians(control.band_off),
        "lag": (control.period + control.ramp) / 2,
    }


def volumes(kernels, given, count=401):
    """Volumes from one that empties container 1, almost, to one that empties container 2."""
    low = -min(given["A_1"] * given["h_10"], given["A_2"] * (given["h_max"] - given["h_20"]))
    high = min(given["A_2"] * given["h_20"], given["A_1"] * (given["h_max"] - given["h_10"]))
    return np.linspace(low, high, count + 2)[1:-1]
