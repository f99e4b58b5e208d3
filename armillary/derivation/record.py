"""The record: an ordered list of definitions, with the kernels and identities made of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType
from typing import Any, TypeVar, overload

from armillary.algebra import scalar as s
from armillary.algebra import vector as v
from armillary.algebra.index import Index
from armillary.algebra.rotation import RotationSymbol
from armillary.derivation.asking import (
    as_cases,
    as_inputs,
    as_named_outputs,
    as_numbers,
    as_outputs,
    as_states,
    check_arguments,
    check_no_state,
    check_reach,
)
from armillary.derivation.checking import (
    check_expression,
    check_identity,
    check_meaning,
    check_parts,
    check_per,
    check_reason,
    check_symbols,
    check_unit,
)
from armillary.derivation.drawing import Near, as_drawn, others
from armillary.derivation.errors import DerivationError, Source, caller
from armillary.derivation.names import check_name
from armillary.derivation.naming import latex_name, named, rate_latex
from armillary.derivation.quantities import Quantities
from armillary.derivation.quantity import (
    AnyQuantity,
    Box,
    Constant,
    ConstantTable,
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
from armillary.mechanism.scene import Scene

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
        self.state = Quantities(self, Role.STATE, Rate.TICK)
        self.constants: dict[str, Constant | ConstantTable] = {}
        self.indices: dict[str, Index] = {}
        self.definitions: dict[str, Definition] = {}
        self.identities: list[Identity] = []
        self.kernels: dict[str, Kernel] = {}
        self.assumptions: list[str] = []
        self.pictures: list[Picture] = []
        self.used: dict[str, Used] = {}
        self.files: tuple[str, ...] = ()  # what it was read from, once it is loaded
        self._by_value: dict[int, Definition] = {}

    # -- stating ------------------------------------------------------------------------------

    def index(self, name: str, size: int, *, letter: str = "i") -> Index:
        """Like parts: what is declared `per` it has a value for each, and is a loop in C.

        Args:
            size: how many parts there are.
            letter: the subscript that stands for one on the page.
        """
        source = caller()
        check_name(name, "index", source)
        self._free(name, source)
        if type(size) is not int or size < 1:
            raise DerivationError(
                f"the index {name} has {size!r} parts", "give a whole number from 1 up", source
            )
        self.indices[name] = Index(name, size, letter=letter)
        return self.indices[name]

    def all_indices(self) -> list[Index]:
        """Its own indices and those of the systems it uses, in the order declared."""
        known = [i for used in self.used.values() for i in used.derivation.all_indices()]
        return list(dict.fromkeys([*known, *self.indices.values()]))

    def unknown(
        self, name: str, meaning: str, *, unit: Unit = ONE, latex: str | None = None
    ) -> Quantity:
        """What `solve` looks for; it has a value only inside the iteration."""
        return Quantities(self, Role.UNKNOWN, Rate.TICK).scalar(
            name, meaning, unit=unit, latex=latex
        )

    @overload
    def constant(
        self, name: str, value: s.ScalarLike, meaning: str, *, unit: Unit = ONE, latex: str = ""
    ) -> Constant: ...
    @overload
    def constant(
        self, name: str, value: Sequence[s.ScalarLike], meaning: str, *, unit: Unit = ONE,
        latex: str = "", per: Index,
    ) -> ConstantTable: ...  # fmt: skip
    def constant(
        self, name: str, value: s.ScalarLike | Sequence[s.ScalarLike], meaning: str, *,
        unit: Unit = ONE, latex: str = "", per: Index | None = None,
    ) -> Constant | ConstantTable:  # fmt: skip
        """A number with a name, a meaning and a unit; decimals are kept exactly as written.

        With `per`, a number for each part of an index.
        """
        source = caller()
        check_name(name, "constant", source)
        check_meaning(name, meaning, source)
        check_per(self, name, per, source)
        numbers = as_numbers(name, value, per, source)
        wide = (0.0, 0.0)
        facts = Facts(
            meaning, unit, Rate.MOUNT, Role.CONSTANT, Kind.REAL, wide, wide,
            latex or latex_name(name), source, per,
        )  # fmt: skip
        self._free(name, source)
        made = (
            Constant(name, numbers[0], facts)
            if per is None
            else ConstantTable(name, numbers, per, facts)
        )
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
            check_parts(self, f"definition {name}", expression, source),
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
        drawn: Mapping[Any, Block | Near] = MappingProxyType({}),
    ) -> None:
        """Ask for a function in every language.

        Args:
            inputs: its arguments in order; parameters of the system come by themselves.
            outputs: definitions, or a mapping from a result's name to an expression.
            cases: (status, condition, reason) for points that need a status.
            drawn: what inputs and parameters are at the points of checks, where values taken at
                random do not fit together: expressions of others, or `near(expression, by=...)`.
        """
        source = caller()
        given = as_inputs(self, inputs, name, source)
        made = Kernel(
            self.name, name, summary, given, self.parameters,
            as_outputs(self, outputs, name, source), as_cases(cases, name, source), source,
            drawn=as_drawn(self, drawn, given, name, source),
        )  # fmt: skip
        self._keep(made)

    def controller(
        self,
        name: str,
        *,
        inputs: Sequence[s.Symbol | v.VectorSymbol | RotationSymbol],
        outputs: Sequence[Block] | Mapping[str, Block],
        states: Mapping[Quantity, s.Scalar],
        start: Mapping[Quantity, s.ScalarLike],
        start_inputs: Sequence[s.Symbol | v.VectorSymbol | RotationSymbol] = (),
        summary: str = "",
        cases: Sequence[tuple[Status, s.Condition, str]] = (),
    ) -> None:
        """Ask for a law that keeps states: kernels `<name>_init` and `<name>_update`.

        C keeps the states in a struct; in Python they are arguments and results.

        Args:
            inputs: arguments of the update, in order.
            outputs: what the update answers, from its inputs and the states before.
            states: each state, made by `d.state`, with what the update makes of it.
            start: the value that init gives to each state.
            start_inputs: arguments of init.
            cases: of the update; a negative status leaves the states as they are.
        """
        source = caller()
        init, update = f"{name}_init", f"{name}_update"
        kept = as_states(self, states, start, name, source)
        after = dict(as_named_outputs(self, outputs, update, source))
        check_no_state(kept, after, name, source)
        started = {q.name: s.as_scalar(start[q]) for q in kept}
        told = f"{(summary or name).rstrip('.')}: the states before the first update"
        made = Kernel(
            self.name, init, told,
            as_inputs(self, start_inputs, init, source), self.parameters,
            as_outputs(self, started, init, source), (), source, kept, "init", name,
        )  # fmt: skip
        self._keep(made)
        arguments = (*kept, *as_inputs(self, inputs, update, source))
        results = as_outputs(self, {**after, **{q.name: states[q] for q in kept}}, update, source)
        made = Kernel(
            self.name, update, summary, arguments, self.parameters, results,
            as_cases(cases, update, source), source, kept, "update", name,
        )  # fmt: skip
        self._keep(made)

    def _keep(self, kernel: Kernel) -> None:
        check_name(kernel.name, "kernel", kernel.source)
        if kernel.name in self.kernels:
            raise DerivationError(
                f"two kernels of {self.name} are named {kernel.name}",
                f"rename one; the first is at {self.kernels[kernel.name].source}",
                kernel.source,
            )
        check_reach(kernel)
        check_arguments(replace(kernel, inputs=(*kernel.inputs, *others(kernel))))
        self.kernels[kernel.name] = kernel

    def assume(self, sentence: str) -> None:
        """State what the model takes for granted; the page lists it."""
        self.assumptions.append(sentence.strip())

    def picture(
        self, shown: Chain | Scene, *, caption: str, at: dict[str, float], sun: int | None = None
    ) -> None:
        """Draw a chain or a scene on the page, posed at values given by the names of symbols.

        Args:
            sun: axis of a chain's last frame that is drawn pointing to the sun.
        """
        self.pictures.append(Picture(shown, dict(at), sun, caption.strip(), caller()))

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
        if name in self.indices:
            raise DerivationError(
                f"{name} is defined twice in {self.name}",
                f"rename one of them; the first is an index of {self.indices[name].size} parts",
                source,
            )
        taken: Definition | AnyQuantity | Constant | ConstantTable | None = (
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
        if quantity.facts.role is Role.PARAMETER:
            # A kernel takes every parameter of its system, those declared after it too.
            for name, kernel in self.kernels.items():
                self.kernels[name] = replace(kernel, parameters=self.parameters)
        return quantity

    def _make_rate(
        self, of: AnyQuantity, name: str | None, meaning: str | None, limits: Box, range: Box
    ) -> Quantity | VectorQuantity:
        name = name or f"{of.name}_dot"
        meaning = meaning or f"rate of {of.name}"
        unit, latex = of.unit / SECOND, rate_latex(of.facts.latex)
        make = self.vector if isinstance(of, VectorQuantity) else self.scalar
        facts = {"unit": unit, "latex": latex, "limits": limits, "range": range}
        return make(name, meaning, rate=Rate.TICK, **facts)  # type: ignore[arg-type]


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
