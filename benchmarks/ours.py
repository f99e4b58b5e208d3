"""The benchmark kernels as this project derives them: joints, vectors, the derivatives asked for.

No intermediate of a hand-written kernel is named here; what is shared, carried or factored is the
program's doing. K3 and K4 are the project's own derivation of the tracker on three legs: K4 is
its kernel `forces`, K3 is made of its definitions with the joints' positions for inputs.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import accumulate
from pathlib import Path

from armillary import (
    Chain,
    Derivation,
    Matrix,
    Rate,
    X,
    Y,
    Z,
    __version__,
    direction_angles,
    partial,
    substitute,
    unit,
)
from armillary.algebra.scalar import Scalar, Symbol
from armillary.derivation.load import load
from armillary.derivation.units import METRE
from benchmarks.measure import measure
from benchmarks.peers import Generated
from benchmarks.printed import Asked, Printed
from benchmarks.recipes import KERNELS
from benchmarks.table import OURS, Row
from benchmarks.tracker import SIZES

TRACKER = Path(__file__).parents[1] / "derivations" / "rr_3ups" / "derivation.py"


def armillary_rows() -> list[Row]:
    """A row for each kernel, generated and counted like everyone's, and for both of its stages."""
    return [row for name, asked in kernels().items() for row in _rows(name, Printed(asked))]


def _rows(name: str, printed: Printed) -> Iterator[Row]:
    for stage in printed.stages:
        code = Generated("", printed.source, printed.call(stage))
        row = measure(
            KERNELS[name], code, tool=OURS, version=__version__, recipe=printed.asked.recipe
        )
        yield replace(row, stage=stage)


def kernels() -> dict[str, Asked]:
    """What is compiled for each problem."""
    return {
        "K1": Asked(two_axis()),
        "K2": Asked(heliostat()),
        "K3": legs(),
        "K4": forces(),
        "A6": Asked(arm()),
    }


def two_axis() -> Derivation:
    """K1."""
    d = Derivation("k1", title="K1")
    gamma, nu = d.angle("gamma", "azimuth"), d.angle("nu", "elevation")
    l0, l1, l2 = (d.scalar(f"L_{k}", "length", unit=METRE) for k in range(3))
    mount = Chain("base").translate(Z, l0).rotate(Z, gamma).translate(Y, l1)
    mount = mount.rotate(X, nu).translate(Z, l2, frame="collector")
    jacobian = mount.jacobian("collector", (gamma, nu))
    outputs = {"T": mount.pose("base", "collector"), "J": jacobian}
    d.kernel("run", inputs=[gamma, nu, l0, l1, l2], outputs=outputs)
    return d


def heliostat() -> Derivation:
    """K2."""
    d = Derivation("k2", title="K2")
    hour, dec = (d.angle(name, name) for name in ("hour", "dec"))
    b = d.vector("b", "direction of the receiver", rate=Rate.MOUNT)
    lat, theta, psi, chi = (
        d.angle(name, name, rate=Rate.MOUNT) for name in ("lat", "theta", "psi", "chi")
    )
    sky = Chain("enu").rotate(X, lat).rotate(Y, -hour).rotate(X, -dec, frame="sun")
    base = Chain("enu").rotate(Z, chi).rotate(Y, psi).rotate(X, theta, frame="base")
    normal = unit(b + sky.rotation("enu", "sun").column(2))
    n = d.define("n", base.rotation("base", "enu") @ normal, because="the normal in the base")
    azimuth, elevation = direction_angles(n)
    rows = jacobian([azimuth, elevation], [theta, psi, chi])
    outputs = {"normal": n, "azimuth": azimuth, "elevation": elevation, "J": rows}
    d.kernel("run", inputs=[hour, dec, lat, b, theta, psi, chi], outputs=outputs)
    return d


def legs() -> Asked:
    """K3."""
    d = load(TRACKER)
    leg, known = d.indices["leg"], d.definitions
    joints = d.vector(
        "joint", "spherical joint, platform axes", unit=METRE, per=leg, rate=Rate.MOUNT
    )
    feet = d.vector("foot", "universal joint, world axes", unit=METRE, per=leg, rate=Rate.MOUNT)
    placed = {known["a_m"].value: joints, known["b"].value: feet}

    def put(name: str) -> Matrix:
        value = known[name].value
        rows = value.rows if isinstance(value, Matrix) else ((value,),)
        return Matrix(tuple(tuple(substitute(entry, placed) for entry in row) for row in rows))

    angles = [d.quantities[name] for name in ("alpha", "beta", "alpha_dot", "beta_dot")]
    outputs = {
        "lengths": put("q_leg"),
        "rates": put("q_dot"),
        "rows": put("J"),
        "turns": put("J_dot"),
    }
    d.kernel("k3", inputs=[*angles, joints, feet], outputs=outputs)
    places = {"alpha": 0, "beta": 1, "alpha_dot": 2, "beta_dot": 3, "joint": 5, "foot": 14}
    return Asked(d, "k3", "derivations/rr_3ups", {**places, "h_0": 4})


def forces() -> Asked:
    """K4."""
    places = dict(zip(SIZES, accumulate(SIZES.values(), initial=0), strict=False))
    return Asked(load(TRACKER), "forces", "derivations/rr_3ups", places)


def arm() -> Derivation:
    """A6."""
    d = Derivation("a6", title="A6")
    q = [d.angle(f"q{k}", f"joint {k}") for k in range(1, 7)]
    d1, a2, a3, d6 = (d.scalar(name, "link", unit=METRE) for name in ("d1", "a2", "a3", "d6"))
    links = Chain("base").rotate(Z, q[0]).translate(Z, d1).rotate(Y, q[1]).translate(Z, a2)
    links = links.rotate(Y, q[2]).translate(X, a3).rotate(X, q[3]).rotate(Y, q[4])
    links = links.rotate(X, q[5]).translate(X, d6, frame="tool")
    outputs = {"J": links.jacobian("tool", tuple(q))}
    d.kernel("run", inputs=[*q, d1, a2, a3, d6], outputs=outputs)
    return d


def jacobian(values: list[Scalar], by: list[Symbol]) -> Matrix:
    """Partial derivatives, a row a value."""
    return Matrix(tuple(tuple(partial(e, q) for q in by) for e in values))
