"""The benchmark kernels as this project derives them: joints, vectors, the derivatives asked for.

No intermediate of a hand-written kernel is named here; what is shared, carried or factored is the
program's doing.
"""

from __future__ import annotations

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
    time_derivative,
    unit,
    vector,
)
from armillary.algebra.scalar import Scalar, Symbol
from armillary.derivation.statements import Kernel as Wanted
from armillary.derivation.units import METRE
from armillary.program.compile import compile_kernel
from armillary.targets.c import CKernel, CTarget, header_file, source_file, status_header
from benchmarks.measure import measure
from benchmarks.peers import Generated
from benchmarks.recipes import KERNELS
from benchmarks.table import Row

TARGET = CTarget("armillary", "", ("f64",), __version__)


def armillary_rows() -> list[Row]:
    """One row a kernel, generated and counted like everyone's."""
    made = {"K1": two_axis(), "K2": heliostat(), "K3": platform(), "A6": arm()}
    return [
        measure(
            KERNELS[name],
            Generated("", c_source(derivation), call(derivation)),
            tool="Armillary",
            version=__version__,
            recipe="chain of joints",
        )
        for name, derivation in made.items()
    ]


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
    hour, dec, lat = (d.angle(name, name) for name in ("hour", "dec", "lat"))
    b = d.vector("b", "direction of the receiver")
    theta, psi, chi = (d.angle(name, name) for name in ("theta", "psi", "chi"))
    sky = Chain("enu").rotate(X, lat).rotate(Y, -hour).rotate(X, -dec, frame="sun")
    base = Chain("enu").rotate(Z, chi).rotate(Y, psi).rotate(X, theta, frame="base")
    normal = unit(b + sky.rotation("enu", "sun").column(2))
    n = d.define("n", base.rotation("base", "enu") @ normal, because="the normal in the base")
    azimuth, elevation = direction_angles(n)
    rows = jacobian([azimuth, elevation], [theta, psi, chi])
    outputs = {"normal": n, "azimuth": azimuth, "elevation": elevation, "J": rows}
    d.kernel("run", inputs=[hour, dec, lat, b, theta, psi, chi], outputs=outputs)
    return d


def platform() -> Derivation:
    """K3."""
    d = Derivation("k3", title="K3")
    alpha, beta = d.angle("alpha", "azimuth"), d.angle("beta", "tilt")
    alpha_dot, beta_dot = alpha.rate(), beta.rate()
    h0 = d.scalar("h0", "height", rate=Rate.MOUNT)
    a = [d.vector(f"a{leg}", "joint on the platform", rate=Rate.MOUNT) for leg in range(3)]
    b = [d.vector(f"b{leg}", "joint on the base", rate=Rate.MOUNT) for leg in range(3)]
    attitude = Chain("base").rotate(Z, alpha).rotate(X, beta, frame="platform")
    turned = attitude.rotation("base", "platform")
    legs = [b[k] - vector(0, 0, h0) - turned @ a[k] for k in range(3)]
    q = [leg.norm() for leg in legs]
    j = jacobian(q, [alpha, beta])
    outputs = {
        "q": vector(*q),
        "q_dot": vector(*(time_derivative(length) for length in q)),
        "J": j,
        "J_dot": Matrix(tuple(tuple(time_derivative(e) for e in row) for row in j.rows)),
    }
    d.kernel("run", inputs=[alpha, beta, alpha_dot, beta_dot, h0, *a, *b], outputs=outputs)
    return d


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


def c_source(derivation: Derivation) -> str:
    """The generated C as one text, without what ties its files together."""
    made = compile_kernel(derivation.kernels["run"])
    kernel = CKernel(made.program, made.cost)
    name, abi = derivation.name, "0x0UL"
    parts = [
        status_header(__version__),
        header_file(name, derivation.title, derivation.parameters, [kernel], TARGET, abi),
        source_file(kernel, TARGET, "f64", abi),
    ]
    lines = [line for part in parts for line in part.splitlines()]
    return "\n".join(line for line in lines if not line.startswith('#include "'))


def call(derivation: Derivation) -> str:
    """The statement that hands the benchmark's arrays over, in the order they stand in."""
    kernel: Wanted = derivation.kernels["run"]
    arguments, position = [], 0
    for quantity in kernel.inputs:
        arguments.append(f"in + {position}" if quantity.shape else f"in[{position}]")
        position += len(quantity.parts)
    position = 0
    for output in kernel.outputs:
        arguments.append(f"out + {position}")
        size = 1
        for n in output.shape:
            size *= n
        position += size
    return f"(void){derivation.name}_run_f64({', '.join(arguments)});"
