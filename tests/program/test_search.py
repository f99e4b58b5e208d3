"""The search for the cheapest direction of evaluation."""

from armillary import Chain, Derivation, X, Y, Z
from armillary.program.cost import cost
from armillary.program.lower import Strategy, lower, strategies
from armillary.program.passes import PASSES
from armillary.program.scalarise import scalarise
from armillary.program.search import cheapest
from tests.programs import kernel_of


def arm():
    """Six turns with offsets between them: long enough for a direction to matter."""
    d = Derivation("arm", title="Arm")
    q, chain = [], Chain("base")
    for k, axis in enumerate((Z, X, Y, Z, X, Z)):
        q.append(d.angle(f"q{k}", "joint"))
        chain = chain.rotate(axis, q[-1]).translate(X, d.parameter.length(f"a{k}", "link"))
        chain = chain.translate((axis + 1) % 3, d.parameter.length(f"b{k}", "link"))
    chain = chain.translate(X, 0, frame="tool")
    return kernel_of(d, q, {"J": chain.jacobian("tool", tuple(q))})


def whole(kernel, strategy):
    program = lower(kernel, strategy)
    for step in (scalarise, *PASSES):
        program = step(program)
    return cost(program).weighted


def test_a_local_departure_is_taken_where_it_pays():
    kernel = arm()
    found = cheapest(kernel)
    assert found.local
    assert found.rank[0] < min(whole(kernel, strategy) for strategy in strategies())


def test_the_plain_direction_wins_ties():
    d = Derivation("one", title="One joint")
    a = d.angle("a", "joint")
    chain = Chain("base").rotate(Z, a, frame="tip")
    found = cheapest(kernel_of(d, [a], {"M": chain.pose("base", "tip")}))
    assert found.strategy == Strategy()
    assert not found.local


def test_it_ends_at_the_same_program():
    assert cheapest(arm()).program.digest() == cheapest(arm()).program.digest()
