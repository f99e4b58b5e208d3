"""Every derivative that a rule made, checked by dual numbers on the evaluator.

The evaluator differentiates the base kernel's program, operation by operation; the rules of the
algebra made the derivative kernel's program. The two share nothing but the base kernel.

Which kernel is the derivative of which is read off the names of CONVENTIONS: `velocity` and
`jacobian` belong to `pose`, `Omega` of `velocity_x` to the rotation of `matrix_x`, that of
`x_rates` to the one rotation of `x`, and a result `x_dot` or `x_rate` to the result `x` of any
kernel whose inputs the first one has too, as `x_ddot` does to `x_dot`. A result that depends on
rates, and whose name tells of no such pair, is reported as not covered.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import mpmath

from armillary.derivation.quantity import AnyQuantity
from armillary.derivation.record import Derivation
from armillary.derivation.statements import Kernel, Output
from armillary.derivation.status import Status
from armillary.derivation.symbols import leaves
from armillary.program.arithmetic import DIGITS, Reals
from armillary.program.evaluate import Answer, guard_status
from armillary.program.program import Program
from armillary.verify import exact
from armillary.verify.exact import directional_derivative
from armillary.verify.measured import Measured, Point, Skipped, exceeds
from armillary.verify.points import awkward_points, joined, quantities, random_points, rows_of

__all__ = ["checks", "directional_derivative", "pair_of"]

AGREEMENT = 1e-30
POINTS = 12
Programs = Mapping[str, Program]
Row = dict[str, Any]
Slope = Callable[[Program, Row], list[Any]]


@dataclass(frozen=True)
class Pair:
    """A result made by derivative rules, and how dual numbers find the same from `base`."""

    kernel: Kernel
    output: Output
    base: Kernel
    claim: str
    wanted: Slope


def checks(record: Derivation, programs: Programs) -> Iterator[Measured | Skipped]:
    """One check for each derivative of a system, and a row for each result that has none.

    Args:
        programs: the compiled programs of its kernels, by name.
    """
    for kernel in record.kernels.values():
        for output in kernel.outputs:
            pair = pair_of(record, kernel, output)
            if pair is not None:
                yield _measure(pair, programs)
            elif _takes_rates(record, output):
                yield _not_covered(kernel, output)


def pair_of(record: Derivation, kernel: Kernel, output: Output) -> Pair | None:
    """What a result is the derivative of, as far as its name and its kernel's tell."""
    pose = record.kernels.get("pose")
    base = _primitive(record, kernel, output)
    if base is not None:
        return _rate_pair(kernel, output, *base)
    if pose is not None and output.name in _OF_POSE and _moves(kernel, pose):
        return _velocity_pair(kernel, output, pose)
    if pose is not None and _is_geometric_jacobian(kernel, output, pose):
        return _jacobian_pair(kernel, output, pose)
    turned = _rotation_of(record, kernel)
    if turned is not None and output.name == "Omega" and _moves(kernel, turned):
        return _spin_pair(kernel, output, turned)
    return None


def _takes_rates(record: Derivation, output: Output) -> bool:
    """Whether a result depends on the rate of some quantity."""
    records = [record, *(used.derivation for used in record.used.values())]
    known = {id(q.known_rate.get("rate")) for r in records for q in r.quantities.values()}
    return any(id(leaf) in known for leaf in leaves(output.value))


def _not_covered(kernel: Kernel, output: Output) -> Skipped:
    known = ", ".join(_OF_POSE)
    return Skipped(
        f"{output.name} of {kernel.name} is not covered",
        "dual numbers",
        f"its name does not tell what it is the derivative of: name it {known} where a kernel "
        "pose returns the pose, Omega of velocity_x where matrix_x returns the rotation, or of "
        "x_rates where x does, or x_dot or x_rate where a kernel of the same inputs returns x, "
        "or x_ddot where one returns x_dot",
    )


# -- finding pairs --------------------------------------------------------------------------------


def _primitive(record: Derivation, kernel: Kernel, output: Output) -> tuple[Kernel, Output] | None:
    """The result that `output` is the rate of, and a kernel that returns it: itself first."""
    name = _primitive_name(output.name)
    if name == output.name:
        return None
    given = {id(q) for q in kernel.inputs}
    for base in (kernel, *record.kernels.values()):
        for candidate in base.outputs:
            fits = candidate.name == name and candidate.shape == output.shape
            if fits and all(id(q) in given for q in base.inputs) and _moves(kernel, base):
                return base, candidate
    return None


def _primitive_name(name: str) -> str:
    if name.endswith("_ddot"):
        return f"{name.removesuffix('_ddot')}_dot"
    return name.removesuffix("_dot").removesuffix("_rate")


def _is_geometric_jacobian(kernel: Kernel, output: Output, pose: Kernel) -> bool:
    named = kernel.name == "jacobian" and output.name == "J"
    return named and output.shape == (6, len(pose.inputs))


def _rotation_of(record: Derivation, kernel: Kernel) -> Kernel | None:
    """The kernel that returns the rotation whose velocity `kernel` returns."""
    kind, _, name = kernel.name.partition("_")
    if kind == "velocity":
        return record.kernels.get(f"matrix_{name}")
    if not kernel.name.endswith("_rates"):
        return None
    base = record.kernels.get(kernel.name.removesuffix("_rates"))
    rotations = [] if base is None else [o for o in base.outputs if o.shape == (3, 3)]
    return base if len(rotations) == 1 else None


def _moves(kernel: Kernel, base: Kernel) -> bool:
    """Whether the kernel is given rates of the base's inputs."""
    return bool(_rates(kernel, base))


def _rates(kernel: Kernel, base: Kernel) -> dict[str, str]:
    """Inputs and parameters of the base, and the kernel's input that is the rate of each."""
    given = {id(q): q.name for q in kernel.inputs}
    found: dict[str, str] = {}
    for q in (*base.inputs, *base.parameters):
        rate = q.known_rate.get("rate")
        if rate is not None and id(rate) in given:
            found[q.name] = given[id(rate)]
    return found


# -- what dual numbers say ------------------------------------------------------------------------


def _rate_pair(kernel: Kernel, output: Output, base: Kernel, of: Output) -> Pair:
    rates = _rates(kernel, base)

    def wanted(program: Program, row: Row) -> list[Any]:
        slopes = exact.flat(_along(program, base, row, rates).results[of.name])
        return [d.slope for d in slopes]

    claim = f"{output.name} is the time derivative of {of.name}"
    return Pair(kernel, output, base, claim, wanted)


def _velocity_pair(kernel: Kernel, output: Output, pose: Kernel) -> Pair:
    rates = _rates(kernel, pose)

    def wanted(program: Program, row: Row) -> list[Any]:
        return _OF_POSE[output.name](*_matrices(_along(program, pose, row, rates)))

    return Pair(kernel, output, pose, f"{output.name} by dual numbers of the pose", wanted)


def _spin_pair(kernel: Kernel, output: Output, turned: Kernel) -> Pair:
    rates = _rates(kernel, turned)

    def wanted(program: Program, row: Row) -> list[Any]:
        return _spin_space(*_matrices(_along(program, turned, row, rates), 3))

    return Pair(kernel, output, turned, f"{output.name} by dual numbers of the rotation", wanted)


def _jacobian_pair(kernel: Kernel, output: Output, pose: Kernel) -> Pair:
    def wanted(program: Program, row: Row) -> list[Any]:
        columns = []
        for q in pose.inputs:
            answer = directional_derivative(program, _only(row, pose), {q.name: 1.0})
            matrix, change = _matrices(answer)
            columns.append(_origin(matrix, change) + _spin_space(matrix, change))
        return [column[i] for i in range(6) for column in columns]

    return Pair(kernel, output, pose, "each column of J by dual numbers of the pose", wanted)


def _along(program: Program, base: Kernel, row: Row, rates: Mapping[str, str]) -> Answer:
    return directional_derivative(
        program, _only(row, base), {name: row[rate] for name, rate in rates.items()}
    )


def _only(row: Row, kernel: Kernel) -> Row:
    return {q.name: row[q.name] for q in quantities(kernel)}


def _matrices(answer: Answer, size: int = 4) -> tuple[Any, Any]:
    """The pose and its rate, 4 by 4; or a rotation and its rate, 3 by 3."""
    (duals,) = (v for v in answer.results.values() if len(exact.flat(v)) == size**2)
    values = mpmath.matrix(size, size), mpmath.matrix(size, size)
    for k, dual in enumerate(duals):
        place = divmod(k, size)
        values[0][place], values[1][place] = dual.value, dual.slope
    return values


def _vee(m: Any) -> list[Any]:
    return [m[2, 1], m[0, 2], m[1, 0]]


def _spin_space(m: Any, change: Any) -> list[Any]:
    return _vee(change[:3, :3] * m[:3, :3].T)


def _spin_body(m: Any, change: Any) -> list[Any]:
    return _vee(m[:3, :3].T * change[:3, :3])


def _origin(m: Any, change: Any) -> list[Any]:
    return [change[i, 3] for i in range(3)]


def _velocity_matrix(m: Any, change: Any) -> list[Any]:
    back = m[:3, :3].T
    inverse = mpmath.eye(4)
    inverse[:3, :3], inverse[:3, 3] = back, -(back * m[:3, 3])
    return list(change * inverse)


def _spatial(m: Any, change: Any) -> list[Any]:
    return _velocity_matrix(m, change)[3:12:4]


_OF_POSE: dict[str, Callable[[Any, Any], list[Any]]] = {
    "Omega_space": _spin_space,
    "Omega_body": _spin_body,
    "v_origin": _origin,
    "v_spatial": _spatial,
    "V_space": _velocity_matrix,
}


# -- measuring ------------------------------------------------------------------------------------


def _measure(pair: Pair, programs: Programs) -> Measured:
    program, base = programs[pair.kernel.name], programs[pair.base.name]
    bad, tried = 0.0, 0
    at: Point = {}
    for row in _regular(program, base, _all_quantities(pair)):
        found = exact.run(program, row, Reals()).results[pair.output.name]
        with mpmath.workdps(DIGITS + 10):
            error = exact.worst(exact.flat(found), pair.wanted(base, row))
        tried += 1
        if exceeds(error, bad):
            bad, at = error, row
    worst = bad if tried else float("nan")
    why = "" if tried else "no point of the range is regular"
    return Measured(pair.claim, "dual numbers", pair.kernel.name, tried, worst, AGREEMENT, at, why)


def _all_quantities(pair: Pair) -> list[AnyQuantity]:
    both = [*quantities(pair.kernel), *quantities(pair.base)]
    return list(dict.fromkeys(both))


def _regular(program: Program, base: Program, known: list[AnyQuantity]) -> Iterator[Row]:
    """Points inside the limits where both kernels answer with status 0."""
    reals = Reals()
    for row in rows_of(joined(random_points(known, POINTS, seed=5), awkward_points(known))):
        legal = all(guard_status(p.guards, row) == Status.OK for p in (program, base))
        if legal and all(_answers(p, row, reals) for p in (program, base)):
            yield row


def _answers(program: Program, row: Row, reals: Reals) -> bool:
    """Whether a kernel has real values here, with status 0; where it has none, parity tells."""
    try:
        return exact.run(program, row, reals).status == Status.OK
    except (ArithmeticError, TypeError, ValueError):
        return False
