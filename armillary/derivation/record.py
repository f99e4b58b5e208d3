"""The record: an ordered list of definitions, with the kernels and identities made of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, TypeVar

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.rotation import RotationSymbol
from armillary.derivation.checking import (
    as_cases,
    as_inputs,
    as_outputs,
    check_arguments,
    check_expression,
    check_identity,
    check_meaning,
    check_reach,
    check_reason,
    check_symbols,
    check_unit,
)
from armillary.derivation.errors import DerivationError, Source, caller
from armillary.derivation.names import check_name
from armillary.derivation.naming import latex_name, named
from armillary.derivation.quantities import Quantities
from armillary.derivation.quantity import (
    AnyQuantity,
    Constant,
    Facts,
    Kind,
    Quantity,
    Rate,
    Role,
    RotationQuantity,
    VectorQuantity,
)
from armillary.derivation.statements import (
    Block,
    Definition,
    Identity,
    Kernel,
    Picture,
)
from armillary.derivation.status import Status
from armillary.derivation.units import (
    ONE,
    SECOND,
    Unit,
)
from armillary.mechanism.chain import Chain

B = TypeVar("B", bound=Block)
Q = TypeVar("Q", Quantity, VectorQuantity, RotationQuantity)


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
        self.assumptions: list[str] = []
        self.pictures: list[Picture] = []
        self.used: dict[str, Used] = {}
        self.files: tuple[str, ...] = ()  # what it was read from, once it is loaded
        self._by_value: dict[int, Definition] = {}

    # -- stating ------------------------------------------------------------------------------

    def constant(
        self, name: str, value: s.ScalarLike, meaning: str, *, unit: Unit = ONE, latex: str = ""
    ) -> Constant:
        """A number with a name, a meaning and a unit; decimals are kept exactly as written."""
        source = caller()
        check_name(name, "constant", source)
        check_meaning(name, meaning, source)
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
        because = check_reason(name, because, source)
        check_expression(f"definition {name}", expression, source)
        check_symbols(self, f"definition {name}", expression, source)
        found = check_unit(name, expression, unit, source)
        identifier = f"{self.name}-{name}"
        value = named(name, identifier, expression)
        definition = Definition(
            name, identifier, expression, value, because, meaning, printed, found,
            latex or latex_name(name), source,
        )  # fmt: skip
        self.definitions[name] = definition
        self._by_value[id(value)] = definition
        return value  # type: ignore[return-value]

    def identity(self, claim: str, left: Block, right: Block) -> None:
        """State that two expressions are equal; `armillary check` proves it with SymPy."""
        source = caller()
        check_identity(self, claim, left, right, source)
        self.identities.append(Identity(claim, left, right, source))

    def kernel(
        self,
        name: str,
        *,
        inputs: Sequence[s.Symbol | v.VectorSymbol | RotationSymbol],
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
            as_inputs(self, inputs, name, source),
            self.parameters,
            as_outputs(self, outputs, name, source),
            as_cases(cases, name, source),
            source,
        )
        check_reach(made)
        check_arguments(made)
        self.kernels[name] = made

    def assume(self, sentence: str) -> None:
        """State what the model takes for granted; the page lists it."""
        self.assumptions.append(sentence.strip())

    def picture(
        self, chain: Chain, *, caption: str, at: dict[str, float], sun: int | None = None
    ) -> None:
        """Draw a chain on the page, posed at the values given by the names of its symbols.

        Args:
            sun: axis of the last frame that is drawn pointing to the sun.
        """
        self.pictures.append(Picture(chain, dict(at), sun, caption.strip(), caller()))

    def use(self, name: str) -> Used:
        """Another system's definitions; the dependency edge for incremental work."""
        from armillary.derivation.load import load_beside

        if name not in self.used:
            self.used[name] = Used(load_beside(caller(), name))
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


class Used:
    """Another derivation, as seen from the one that uses it."""

    def __init__(self, derivation: Derivation) -> None:
        self.derivation = derivation

    def __getitem__(self, name: str) -> Any:
        if name not in self.derivation.definitions:
            names = ", ".join(self.derivation.definitions)
            raise DerivationError(
                f"{self.derivation.name} defines no {name}", f"it defines {names}", caller()
            )
        return self.derivation.definitions[name].value

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
