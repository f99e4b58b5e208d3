"""The record: an ordered list of definitions, with the kernels and identities made of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeVar

import sympy

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.rigid import Matrix, Pose, Twist, Wrench
from armillary.algebra.rotation import Rotation, RotationReference
from armillary.derivation.errors import DerivationError, Source, caller
from armillary.derivation.names import check_name
from armillary.derivation.quantity import (
    AnyQuantity,
    Constant,
    Facts,
    Kind,
    Quantity,
    Rate,
    Role,
    VectorQuantity,
    default_limits,
    default_range,
)
from armillary.derivation.status import Status
from armillary.derivation.symbols import leaves
from armillary.derivation.units import (
    METRE,
    ONE,
    RADIAN,
    SECOND,
    Unit,
    UnitError,
    check_block,
)

Block = Pose | Twist | Wrench | Matrix | Rotation | s.Scalar | v.Vector | s.Condition
B = TypeVar("B", bound=Block)


@dataclass(frozen=True, eq=False)
class Definition:
    """`name := expression`, with the reason for the step.

    `value` is what later lines use (it carries the name); `expression` is what was written.
    """

    name: str
    identifier: str
    expression: Block
    value: Block
    because: str
    meaning: str
    printed: str | None
    unit: Unit | None
    latex: str
    source: Source


@dataclass(frozen=True, eq=False)
class Identity:
    """Two expressions that must be equal for reasons the definitions do not share."""

    claim: str
    left: Block
    right: Block
    source: Source


@dataclass(frozen=True, eq=False)
class Output:
    """A named result of a kernel."""

    name: str
    value: s.Scalar | v.Vector | Rotation | Matrix
    definition: Definition | None
    unit: Unit | None

    @property
    def shape(self) -> tuple[int, ...]:
        if isinstance(self.value, Matrix):
            return self.value.shape
        if isinstance(self.value, Rotation):
            return (3, 3)
        return (3,) if isinstance(self.value, v.Vector) else ()


@dataclass(frozen=True, eq=False)
class Case:
    """A condition under which a kernel answers with a status of its own."""

    status: Status
    condition: s.Condition
    because: str


@dataclass(frozen=True, eq=False)
class Kernel:
    """A function that every target prints."""

    system: str
    name: str
    summary: str
    inputs: tuple[AnyQuantity, ...]
    parameters: tuple[AnyQuantity, ...]
    outputs: tuple[Output, ...]
    cases: tuple[Case, ...]
    source: Source


class Quantities:
    """Declares quantities of one role: `d.length(...)` inputs, `d.parameter.length(...)`."""

    def __init__(self, record: Derivation, role: Role, rate: Rate) -> None:
        self._record, self._role, self._rate = record, role, rate

    def scalar(
        self,
        name: str,
        meaning: str,
        *,
        unit: Unit = ONE,
        rate: Rate | None = None,
        kind: Kind = Kind.REAL,
        limits: tuple[float, float] | None = None,
        range: tuple[float, float] | None = None,
        latex: str | None = None,
    ) -> Quantity:
        """A scalar in any unit; `limits` are refused beyond, `range` is where it works."""
        facts = self._facts(name, meaning, unit, rate, kind, limits, range, latex)
        return self._record._declare(Quantity(name, facts, self._record._make_rate, {}))

    def angle(self, name: str, meaning: str, **more: object) -> Quantity:
        """An angle in radians; every finite angle up to 1000 rad is legal."""
        return self.scalar(name, meaning, unit=RADIAN, **more)  # type: ignore[arg-type]

    def length(self, name: str, meaning: str, **more: object) -> Quantity:
        """A length in metres that may not be negative."""
        return self.scalar(name, meaning, unit=METRE, kind=Kind.NON_NEGATIVE, **more)  # type: ignore[arg-type]

    def time(self, name: str, meaning: str, **more: object) -> Quantity:
        """A time in seconds."""
        return self.scalar(name, meaning, unit=SECOND, **more)  # type: ignore[arg-type]

    def vector(
        self,
        name: str,
        meaning: str,
        *,
        unit: Unit = ONE,
        rate: Rate | None = None,
        kind: Kind = Kind.REAL,
        limits: tuple[float, float] | None = None,
        range: tuple[float, float] | None = None,
        latex: str | None = None,
    ) -> VectorQuantity:
        """A vector of three components in one unit."""
        facts = self._facts(name, meaning, unit, rate, kind, limits, range, latex)
        return self._record._declare(VectorQuantity(name, facts, self._record._make_rate, {}))

    def unit_vector(self, name: str, meaning: str, **more: object) -> VectorQuantity:
        """A vector of norm 1; refused when its square is off by more than 1e-3."""
        return self.vector(name, meaning, kind=Kind.UNIT_VECTOR, **more)  # type: ignore[arg-type]

    def _facts(
        self,
        name: str,
        meaning: str,
        unit: Unit,
        rate: Rate | None,
        kind: Kind,
        limits: tuple[float, float] | None,
        range: tuple[float, float] | None,
        latex: str | None,
    ) -> Facts:
        source = caller()
        check_name(name, "quantity", source)
        return Facts(
            meaning=meaning,
            unit=unit,
            rate=rate or self._rate,
            role=self._role,
            kind=kind,
            limits=limits or default_limits(unit, kind),
            range=range or default_range(unit, kind),
            latex=latex or latex_name(name),
            source=source,
        )


class Derivation(Quantities):
    """One system: its quantities, definitions, identities and kernels, in the order written.

    Args:
        name: folder and kernel prefix of the system.
        title: heading of its page.
        paper: key of the source, if there is one.
        summary: a paragraph for the page.
    """

    def __init__(
        self, name: str, *, title: str, paper: str | None = None, summary: str = ""
    ) -> None:
        super().__init__(self, Role.INPUT, Rate.TICK)
        self.source = caller()
        check_name(name, "derivation", self.source)
        self.name, self.title, self.paper, self.summary = name, title, paper, summary
        self.parameter = Quantities(self, Role.PARAMETER, Rate.MOUNT)
        self.quantities: dict[str, AnyQuantity] = {}
        self.constants: dict[str, Constant] = {}
        self.definitions: dict[str, Definition] = {}
        self.identities: list[Identity] = []
        self.kernels: dict[str, Kernel] = {}
        self.used: dict[str, Used] = {}
        self._by_value: dict[int, Definition] = {}

    # -- stating ------------------------------------------------------------------------------

    def constant(
        self, name: str, value: s.ScalarLike, meaning: str, *, unit: Unit = ONE, latex: str = ""
    ) -> Constant:
        """A number with a name, a meaning and a unit; decimals are kept exactly as written."""
        source = caller()
        check_name(name, "constant", source)
        exact = s.as_scalar(value)
        if not isinstance(exact, s.Number):
            raise DerivationError(
                f"the value of {name} is not a number", "give a number or a decimal string", source
            )
        wide = (0.0, 0.0)
        facts = Facts(
            meaning, unit, Rate.MOUNT, Role.CONSTANT, Kind.REAL, wide, wide,
            latex or latex_name(name), source,
        )  # fmt: skip
        self._free(name, source)
        made = Constant(name, exact.value, facts)
        self.constants[name] = made
        return made

    def define(
        self,
        name: str,
        expression: B,
        *,
        because: str,
        meaning: str = "",
        printed: str | None = None,
        unit: Unit | None = None,
        latex: str | None = None,
    ) -> B:
        """State `name := expression` and the reason; later lines use what is returned.

        Args:
            because: why this step is taken; it is printed on the page.
            printed: number of the paper's equation that claims the same.
            unit: checked against the unit that follows from the expression.
        """
        source = caller()
        check_name(name, "definition", source)
        self._free(name, source)
        if not because.strip():
            raise DerivationError(
                f"{name} gives no reason", "say in because= why this step is taken", source
            )
        self._check_symbols(f"definition {name}", expression, source)
        found = self._check_unit(name, expression, unit, source)
        identifier = f"{self.name}-{name}"
        value = _named(name, identifier, expression)
        definition = Definition(
            name, identifier, expression, value, because.strip(), meaning, printed, found,
            latex or latex_name(name), source,
        )  # fmt: skip
        self.definitions[name] = definition
        self._by_value[id(value)] = definition
        return value  # type: ignore[return-value]

    def identity(self, claim: str, left: Block, right: Block) -> None:
        """State that two expressions are equal; `armillary check` proves it with SymPy."""
        source = caller()
        for side in (left, right):
            self._check_symbols(f"identity {claim!r}", side, source)
        self.identities.append(Identity(claim, left, right, source))

    def kernel(
        self,
        name: str,
        *,
        inputs: Sequence[s.Symbol | v.VectorSymbol],
        outputs: Sequence[Block] | Mapping[str, Block],
        summary: str = "",
        cases: Sequence[tuple[Status, s.Condition, str]] = (),
    ) -> None:
        """Ask for a function in every language.

        Args:
            inputs: its arguments in order; parameters of the system come by themselves.
            outputs: definitions, or a mapping from a result's name to an expression.
            cases: (status, condition, reason) for points that need a status.
        """
        source = caller()
        check_name(name, "kernel", source)
        if name in self.kernels:
            raise DerivationError(
                f"two kernels of {self.name} are named {name}",
                f"rename one; the first is at {self.kernels[name].source}",
                source,
            )
        made = Kernel(
            self.name,
            name,
            summary,
            tuple(self._as_input(q, name, source) for q in inputs),
            self.parameters,
            tuple(self._outputs(outputs, source)),
            tuple(Case(*case) for case in cases),
            source,
        )
        self._check_reach(made)
        self.kernels[name] = made

    def use(self, name: str) -> Used:
        """Another system's definitions; the dependency edge for incremental work."""
        from armillary.derivation.load import load_beside

        if name not in self.used:
            self.used[name] = Used(load_beside(caller(), name), self)
        return self.used[name]

    @property
    def parameters(self) -> tuple[AnyQuantity, ...]:
        """All parameters of the system, in the order declared: the fields of the C struct."""
        return tuple(q for q in self.quantities.values() if q.facts.role is Role.PARAMETER)

    def definition_of(self, value: object) -> Definition | None:
        """The definition that returned this value."""
        found = self._by_value.get(id(value))
        if found is None:
            for used in self.used.values():
                found = found or used.derivation.definition_of(value)
        return found

    # -- checking -----------------------------------------------------------------------------

    def _free(self, name: str, source: Source) -> None:
        taken: Definition | AnyQuantity | Constant | None = (
            self.definitions.get(name) or self.quantities.get(name) or self.constants.get(name)
        )
        if taken is not None:
            where = taken.source if isinstance(taken, Definition) else taken.facts.source
            raise DerivationError(
                f"{name} is defined twice in {self.name}",
                f"rename one of them; the first is at {where}",
                source,
            )

    def _declare(self, quantity: Q) -> Q:
        self._free(quantity.name, quantity.facts.source)
        self.quantities[quantity.name] = quantity
        return quantity

    def _make_rate(
        self, of: AnyQuantity, name: str | None, meaning: str | None
    ) -> Quantity | VectorQuantity:
        name = name or f"{of.name}_dot"
        meaning = meaning or f"rate of {of.name}"
        unit, latex = of.unit / SECOND, f"\\dot{{{of.facts.latex}}}"
        if isinstance(of, VectorQuantity):
            return self.vector(name, meaning, unit=unit, latex=latex, rate=Rate.TICK)
        return self.scalar(name, meaning, unit=unit, latex=latex, rate=Rate.TICK)

    def _check_symbols(self, what: str, expression: Block, source: Source) -> None:
        for leaf in leaves(expression):
            known = self.quantities.get(leaf.name) or self.constants.get(leaf.name)
            if known is leaf or any(leaf in used for used in self.used.values()):
                continue
            raise DerivationError(
                f"{what} of {self.name} uses {leaf.name}, which {self.name} does not define",
                f"declare it in this derivation, or take it from its own with "
                f'd.use("<system>").quantity("{leaf.name}")',
                source,
            )

    def _check_unit(
        self, name: str, expression: Block, unit: Unit | None, source: Source
    ) -> Unit | None:
        try:
            found = check_block(expression)
        except UnitError as problem:
            raise DerivationError(
                f"units in {name}: {problem}",
                "every term of a sum needs one unit, and angles go into sines; "
                "check the symbols of this line in the notation table",
                source,
            ) from None
        if unit is not None and found is not None and not unit.agrees(found):
            raise DerivationError(
                f"{name} is stated in {unit}, but its expression is in {found}",
                "correct the unit= or the expression",
                source,
            )
        return unit or found

    def _as_input(
        self, quantity: s.Symbol | v.VectorSymbol, kernel: str, source: Source
    ) -> AnyQuantity:
        if not isinstance(quantity, (Quantity, VectorQuantity)):
            raise DerivationError(
                f"an input of kernel {kernel} is not a quantity of {self.name}",
                "list quantities made by d.angle, d.length, ... or a quantity's rate()",
                source,
            )
        if quantity.facts.role is not Role.INPUT:
            raise DerivationError(
                f"{quantity.name} is a {quantity.facts.role.value}, not an input",
                "leave it out of inputs=: every kernel gets all parameters by itself",
                source,
            )
        return quantity

    def _outputs(
        self, outputs: Sequence[Block] | Mapping[str, Block], source: Source
    ) -> list[Output]:
        if not isinstance(outputs, Mapping):
            named: dict[str, Block] = {}
            for value in outputs:
                definition = self.definition_of(value)
                if definition is None:
                    raise DerivationError(
                        "an output is not a definition, so it has no name",
                        "d.define it, or give outputs={'name': expression}",
                        source,
                    )
                named[definition.name] = value
            outputs = named
        return [self._output(name, value, source) for name, value in outputs.items()]

    def _output(self, name: str, value: Block, source: Source) -> Output:
        check_name(name, "result", source)
        self._check_symbols(f"result {name}", value, source)
        definition = self.definition_of(value)
        unit = definition.unit if definition else check_block(value)
        if isinstance(value, (Pose, Twist)):
            value = value.matrix()
        if isinstance(value, (Wrench, s.Condition)):
            raise DerivationError(
                f"result {name} is a {type(value).__name__.lower()}, which no kernel returns whole",
                "return its parts as vectors",
                source,
            )
        return Output(name, value, definition, unit)

    def _check_reach(self, kernel: Kernel) -> None:
        given = {id(q) for q in (*kernel.inputs, *kernel.parameters)}
        names = {q.name for q in kernel.inputs} & {o.name for o in kernel.outputs}
        for output in kernel.outputs:
            for leaf in leaves(output.value):
                if id(leaf) not in given and not isinstance(leaf, Constant):
                    raise DerivationError(
                        f"result {output.name} of kernel {kernel.name} needs {leaf.name}, "
                        "which is neither an input of the kernel nor a parameter",
                        f"add {leaf.name} to inputs=",
                        kernel.source,
                    )
        if names:
            raise DerivationError(
                f"kernel {kernel.name} has {', '.join(sorted(names))} both as input and as result",
                "give the result another name with outputs={'name': value}",
                kernel.source,
            )


Q = TypeVar("Q", Quantity, VectorQuantity)


class Used:
    """Another derivation, as seen from the one that uses it."""

    def __init__(self, derivation: Derivation, user: Derivation) -> None:
        self.derivation = derivation
        self._user = user

    def __getitem__(self, name: str) -> Callable[..., object] | Block:
        if name not in self.derivation.definitions:
            names = ", ".join(self.derivation.definitions)
            raise DerivationError(
                f"{self.derivation.name} defines no {name}", f"it defines {names}", caller()
            )
        return self.derivation.definitions[name].value  # type: ignore[return-value]

    def quantity(self, name: str) -> AnyQuantity:
        """A quantity of the other system, for use as an input here."""
        if name not in self.derivation.quantities:
            names = ", ".join(self.derivation.quantities)
            raise DerivationError(
                f"{self.derivation.name} has no quantity {name}", f"it has {names}", caller()
            )
        return self.derivation.quantities[name]

    def __contains__(self, leaf: object) -> bool:
        d = self.derivation
        mine = {id(q) for q in (*d.quantities.values(), *d.constants.values())}
        return id(leaf) in mine or any(leaf in used for used in d.used.values())


def _named(name: str, identifier: str, expression: Block) -> Block:
    """The expression under its name; blocks carry the name on their parts."""
    if isinstance(expression, s.Scalar):
        return s.ScalarReference(name, identifier, expression)
    if isinstance(expression, v.Vector):
        return v.VectorReference(name, identifier, expression)
    if isinstance(expression, Rotation):
        return RotationReference(name, identifier, expression)
    if isinstance(expression, s.Condition):
        return s.ConditionReference(name, identifier, expression)
    if isinstance(expression, Pose):
        return Pose(
            RotationReference(f"{name}_R", identifier, expression.rotation),
            v.VectorReference(f"{name}_p", identifier, expression.position),
        )
    if isinstance(expression, Twist):
        return Twist(
            v.VectorReference(f"{name}_angular", identifier, expression.angular),
            v.VectorReference(f"{name}_linear", identifier, expression.linear),
        )
    if isinstance(expression, Wrench):
        return Wrench(
            v.VectorReference(f"{name}_moment", identifier, expression.moment),
            v.VectorReference(f"{name}_force", identifier, expression.force),
        )
    rows = tuple(
        tuple(_entry(name, identifier, i, j, entry) for j, entry in enumerate(row))
        for i, row in enumerate(expression.rows)
    )
    return Matrix(rows)


def _entry(name: str, identifier: str, i: int, j: int, entry: s.Scalar) -> s.Scalar:
    if isinstance(entry, s.Number):
        return entry
    return s.ScalarReference(f"{name}_{i + 1}{j + 1}", identifier, entry)


def latex_name(name: str) -> str:
    """The printed form of a code name: Omega_space, L_0, gamma_dot."""
    return sympy.latex(sympy.Symbol(name))
