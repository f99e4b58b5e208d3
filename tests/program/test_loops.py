"""Loops: what the builder folds, what a program means, what it costs."""

import math

import pytest
import sympy

from armillary.derivation.status import Status
from armillary.program.arithmetic import Dual, Duals, Floats, Reals
from armillary.program.cost import cost
from armillary.program.evaluate import evaluate
from armillary.program.passes import PASSES, factor_sums, regroup_products, share_reciprocals
from armillary.program.program import Op, domains, turns
from armillary.program.schedule import Loop, schedule
from armillary.program.unroll import unrolled
from tests.loops import (
    POINT,
    PROGRAMS,
    Hand,
    again,
    at_random,
    facet,
    leg,
    program_of,
    turn,
)
from tests.programs import exact

every = pytest.mark.parametrize("make", PROGRAMS.values(), ids=PROGRAMS)
SEEDS = range(60)


def numbers(program, arithmetic=None, point=POINT):
    arithmetic = arithmetic or Reals()
    answer = evaluate(program, exact(point) if isinstance(arithmetic, Reals) else point, arithmetic)
    flat = [n for v in answer.results.values() for n in (v if isinstance(v, list) else [v])]
    return [answer.status, *flat]


def same(first, second):
    assert len(first) == len(second)
    for a, b in zip(first, second, strict=True):
        assert abs(a - b) <= 1e-45 * (1 + abs(a))


# -- the builder ----------------------------------------------------------------------------------


def test_domains_follow_the_arguments():
    b = Hand()
    both = b.multiply(b.l, b.h)
    assert b.domains[b.x] == frozenset()
    assert b.domains[both] == {leg, facet}
    assert b.domains[b.sum(both, leg)] == {facet}
    assert b.domains[b.element(both, facet, 1)] == {leg}
    assert b.domains[b.any_of(b.less(both, b.x), facet)] == {leg}
    phi = b.phi(b.l, turn, "p", over=[facet])
    assert b.domains[b.sin(phi)] == {leg, facet, turn}


def test_tables_fold_exactly():
    b = Hand()
    t, u = b.values(leg, 0, "1/2", -1), b.values(leg, 1, 2, 4)
    third = b.constant(sympy.pi / 3)
    assert b.tabled(b.add(t, u)) == (leg, (1, sympy.Rational(5, 2), 3))
    assert b.tabled(b.multiply(t, u)) == (leg, (0, 1, -4))
    assert b.tabled(b.divide(t, u)) == (leg, (0, sympy.Rational(1, 4), sympy.Rational(-1, 4)))
    assert b.tabled(b.multiply(b.number(2), t)) == (leg, (0, 1, -2))
    assert b.tabled(b.cos(b.multiply(third, u)))[1] == (
        sympy.Rational(1, 2),
        *[-sympy.Rational(1, 2)] * 2,
    )
    assert b.tabled(b.sqrt(u)) == (leg, (1, sympy.sqrt(2), 2))
    assert b.tabled(b.absolute(t)) == (leg, (0, sympy.Rational(1, 2), 1))
    assert b.instructions[b.sqrt(t)].op is Op.SQRT
    assert b.instructions[b.divide(u, t)].op is Op.DIVIDE
    assert b.instructions[b.multiply(u, b.values(facet, 1, 2))].op is Op.MULTIPLY


def test_a_table_of_one_number_is_a_constant():
    b = Hand()
    assert b.value(b.values(leg, 2, 2, 2)) == 2
    t = b.values(leg, 1, 2, 3)
    assert b.value(b.add(t, b.values(leg, 2, 1, 0))) == 3
    assert b.value(b.divide(t, t)) == 1
    with pytest.raises(ValueError, match="2 values for the 3 parts of leg"):
        b.values(leg, 1, 2)


def test_tables_carry_their_sign_outward():
    b = Hand()
    t, minus = b.values(leg, 0, "1/2", -1), b.values(leg, 0, "-1/2", 1)
    assert minus == b.negate(t)
    assert b.multiply(minus, b.x) == b.negate(b.multiply(t, b.x))


def test_factors_that_are_tables_meet():
    b = Hand()
    t = b.values(leg, 1, 2, 3)
    product = b.multiply(t, b.multiply(t, b.x))
    assert b.tabled(b.instructions[product].args[0]) == (leg, (1, 4, 9))
    assert b.multiply(b.number(2), b.multiply(t, b.x)) == b.multiply(b.values(leg, 2, 4, 6), b.x)


def test_what_does_not_run_is_not_summed():
    b = Hand()
    assert b.sum(b.x, leg) == b.multiply(b.number(3), b.x)
    assert b.value(b.sum(b.values(leg, 1, 2, 3), leg)) == 6
    assert b.sum(b.negate(b.l), leg) == b.negate(b.sum(b.l, leg))
    assert b.any_of(b.less(b.x, b.y), leg) == b.less(b.x, b.y)


def test_elements_of_inputs_and_tables_are_known():
    b = Hand()
    assert b.instructions[b.element(b.v[1], leg, 2)].data == ("v", 7)
    assert b.value(b.element(b.values(leg, 1, 2, 3), leg, 1)) == 2
    assert b.element(b.x, leg, 1) == b.x
    assert b.element(b.negate(b.l), leg, 0) == b.negate(b.element(b.l, leg, 0))
    with pytest.raises(ValueError, match="leg has no place 3"):
        b.element(b.l, leg, 3)


def test_what_is_carried_runs_over_what_its_start_does():
    b = Hand()
    phi = b.phi(b.x, turn, "p")
    with pytest.raises(ValueError, match="depends on leg, and its start does not"):
        b.carry(phi, b.add(phi, b.l))
    with pytest.raises(ValueError, match="cannot be carried"):
        b.phi(b.x, leg, "p")
    with pytest.raises(ValueError, match="nothing is carried"):
        program_of(b, {"r": ([b.element(phi, turn, 4)], [])})


def test_iterations_that_start_alike_are_two():
    b = Hand()
    assert b.phi(b.x, turn, "p") != b.phi(b.x, turn, "p")


def test_results_and_cases_have_their_indices():
    b = Hand()
    with pytest.raises(ValueError, match="the result r depends on an index"):
        program_of(b, {"r": ([b.l], [facet])})
    with pytest.raises(ValueError, match="take any of it"):
        program_of(b, {"r": ([b.x], [])}, [(Status.LIMIT, b.less(b.l, b.x))])


# -- what a program means -------------------------------------------------------------------------


def test_sums_against_plain_numbers():
    found = evaluate(PROGRAMS["sums"](), POINT, Floats()).results
    term = [[math.sin(length * h + 0.7) for length in POINT["l"]] for h in POINT["h"]]
    assert found["inner"] == pytest.approx([sum(row) for row in term], rel=1e-14)
    assert found["outer"] == pytest.approx([sum(c) for c in zip(*term, strict=True)], rel=1e-14)
    assert found["all"] == pytest.approx(sum(map(sum, term)), rel=1e-14)


def test_conditions_against_plain_numbers():
    program = PROGRAMS["conditions"]()
    assert evaluate(program, POINT, Floats()).status == 5
    assert evaluate(program, {**POINT, "l": [9.0, 11.0, 9.0]}, Floats()).status == -3
    none = evaluate(program, {**POINT, "l": [1.0, 2.0, 3.0]}, Floats())
    assert (none.status, none.results) == (0, {"kept": [1.0, 2.0, 3.0], "shift": -0.4})
    some = evaluate(program, POINT, Floats()).results["kept"]
    assert some == pytest.approx([1.25, -1.3, 2.0])


def test_iteration_against_plain_numbers():
    found = evaluate(PROGRAMS["iteration"](), POINT, Floats()).results
    assert found["root"] == pytest.approx([(n * n + 1) ** 0.5 for n in POINT["l"]], rel=1e-6)


def test_exchange_against_plain_numbers():
    a, b, c, sign = 0.7, -0.4, 1.0, 2.0
    for _ in range(5):
        a, b, c, sign = b, c, a + sign, -sign
    found = evaluate(PROGRAMS["exchange"](), POINT, Floats()).results["ends"]
    assert found == pytest.approx([a, b, c, sign])


def test_history_against_plain_numbers():
    found = evaluate(PROGRAMS["history"](), POINT, Floats()).results
    for k, h in enumerate(POINT["h"]):
        z, before, steps = 0.7, [], []
        for _ in range(5):
            before.append(z)
            steps.append(math.sin(z + h))
            z = steps[-1] * -0.4
        assert found["travelled"][2 * k : 2 * k + 2] == pytest.approx([sum(steps), steps[2]])
        assert found["before"][2 * k : 2 * k + 2] == pytest.approx([before[3], 0.7])


@every
def test_unrolled_is_the_same(make):
    program, flat = make(), unrolled(make())
    same(numbers(program), numbers(flat))
    assert not any(domains(flat))
    loops = (Op.TABLE, Op.SUM, Op.ANY, Op.ELEMENT, Op.PHI)
    assert not any(i.op in loops for i in flat.instructions)
    assert cost(flat).weighted <= cost(program).weighted


@pytest.mark.parametrize("seed", SEEDS)
def test_unrolled_is_the_same_at_random(seed):
    program = at_random(seed)
    same(numbers(program), numbers(unrolled(program)))


def test_duals_run_through_loops():
    """The derivative by x of a program with loops, against a central difference."""
    reals = Reals()
    program = PROGRAMS["loops_in_turns"]()
    point = exact(POINT)
    duals = {
        n: [Dual(c, reals.number(0)) for c in v]
        if isinstance(v, list)
        else Dual(v, reals.number(0))
        for n, v in point.items()
    }
    duals["x"] = Dual(point["x"], reals.number(1))
    slopes = [c.slope for c in evaluate(program, duals, Duals(reals)).results["after"]]
    step = reals.number("1e-15")
    ends = [
        evaluate(program, {**point, "x": point["x"] + way}, reals).results["after"]
        for way in (step, -step)
    ]
    for slope, high, low in zip(slopes, *ends, strict=True):
        assert abs((high - low) / (2 * step) - slope) < 1e-25


def test_a_long_iteration_needs_no_deep_stack():
    b = Hand()
    z = b.phi(b.x, turn, "z")
    value = z
    for _ in range(1500):
        value = b.sin(b.add(value, b.y))
    b.carry(z, value)
    program = program_of(b, {"r": ([b.element(value, turn, 4)], [])})
    same(numbers(program), numbers(unrolled(program)))


def test_what_needs_itself_is_refused():
    b = Hand()
    z = b.phi(b.x, turn, "z")
    b.carry(z, b.add(b.y, b.element(b.sin(z), turn, 4)))
    program = program_of(b, {"r": ([b.element(b.sin(z), turn, 4)], [])})
    with pytest.raises(ValueError, match="needs itself"):
        evaluate(program, POINT, Floats())
    with pytest.raises(ValueError, match="no order of loops"):
        schedule(program)


def test_the_digest_tells_loops_apart():
    def made(index, following):
        b = Hand()
        z = b.phi(b.x, index, "z")
        b.carry(z, following(b, z))
        return program_of(b, {"r": ([b.element(b.carried[z], index, 1)], [])})

    programs = [
        made(turn, lambda b, z: b.add(b.sin(z), b.cos(z))),
        made(again, lambda b, z: b.add(b.sin(z), b.cos(z))),
        made(turn, lambda b, z: b.sin(z)),
    ]
    assert len({p.digest() for p in programs}) == 3
    assert made(turn, lambda b, z: b.sin(z)).digest() == programs[2].digest()


# -- cost and passes ------------------------------------------------------------------------------


def test_cost_counts_turns():
    b = Hand()
    q = b.multiply(b.multiply(b.l, b.h), b.x)
    program = program_of(b, {"r": ([b.sum(q, facet)], [leg])})
    found = cost(program)
    assert (found.multiply, found.add) == (12, 6)
    b = Hand()
    z = b.phi(b.x, turn, "z")
    b.carry(z, b.sin(z))
    assert cost(program_of(b, {"r": ([b.element(b.carried[z], turn, 4)], [])})).trigonometry == 5


def test_turns():
    assert turns(frozenset()) == 1
    assert turns(frozenset({leg, facet, turn})) == 30


@every
@pytest.mark.parametrize("step", PASSES)
def test_passes_keep_values(make, step):
    program = make()
    after = step(program)
    same(numbers(program), numbers(after))
    assert cost(after).weighted <= cost(program).weighted
    assert step(after).instructions == after.instructions


@pytest.mark.parametrize("seed", SEEDS)
def test_passes_keep_values_at_random(seed):
    program = at_random(seed)
    for step in PASSES:
        after = step(program)
        same(numbers(program), numbers(after))
        assert cost(after).weighted <= cost(program).weighted, step.__name__
        program = after


def weighted(hand, entries, indices, *steps):
    program = program_of(hand, {"r": (entries, indices)})
    for step in steps:
        program = step(program)
    return cost(program).weighted


def test_a_divisor_is_inverted_outside_the_loop_of_its_quotient():
    b = Hand()
    q = b.divide(b.l, b.add(b.x, b.y))
    assert weighted(b, [q], [leg]) == 1 + 3 * 14
    assert weighted(b, [q], [leg], share_reciprocals) == 1 + 14 + 3
    b = Hand()
    beside = b.divide(b.x, b.add(b.l, b.y))
    assert weighted(b, [beside], [leg], share_reciprocals) == 3 + 3 * 14


def test_a_sum_is_taken_before_the_factor_that_all_share():
    b = Hand()
    total = b.sum(b.multiply(b.x, b.multiply(b.l, b.y)), leg)
    assert weighted(b, [total], []) == 6 + 3
    assert weighted(b, [total], [], factor_sums) == 2 + 3
    b = Hand()
    mean = b.sum(b.divide(b.sin(b.l), b.x), leg)
    assert weighted(b, [mean], [], factor_sums) == 3 * 40 + 3 + 14


def test_a_common_factor_is_left_where_its_sum_would_run_longer():
    b = Hand()
    few = b.add(b.multiply(b.l, b.x), b.multiply(b.h, b.x))
    assert weighted(b, [few], [leg, facet]) == 3 + 2 + 6
    assert weighted(b, [few], [leg, facet], factor_sums) == 3 + 2 + 6


def test_what_stays_the_same_is_multiplied_outside():
    b = Hand()
    product = b.multiply(b.multiply(b.multiply(b.l, b.x), b.h), b.y)
    assert weighted(b, [product], [leg, facet]) == 3 + 6 + 6
    assert weighted(b, [product], [leg, facet], regroup_products) == 1 + 2 + 6


def test_a_product_that_is_used_twice_is_not_opened():
    b = Hand()
    inner = b.multiply(b.l, b.x)
    program = program_of(b, {"r": ([b.multiply(inner, b.y), inner], [leg])})
    assert regroup_products(program).instructions == program.instructions


# -- schedules ------------------------------------------------------------------------------------


def loops(steps):
    found = []
    for step in steps:
        if isinstance(step, Loop):
            found.append((str(step.index), loops(step.steps)))
    return found


def plan(make, **more):
    program = make()
    return loops(schedule(program, frozenset(r.name for r in program.results), **more).steps)


LOOPS = {
    "tables": [("leg", [])],
    "sums": [("facet", [("leg", [])]), ("leg", [])],
    "conditions": [("leg", []), ("leg", [])],
    "elements": [("leg", []), ("leg", [])],
    "vectors_of_legs": [("leg", [("facet", [])])],
    "iteration": [("leg", [("turn", [])])],
    "exchange": [("turn", [])],
    "loops_in_turns": [("leg", []), ("turn", [("leg", [])]), ("leg", [])],
    "history": [("facet", [("turn", [])])],
    "one_after_the_other": [("leg", [("turn", []), ("turn", [])]), ("again", [])],
}


@every
def test_loops_are_few(make):
    assert plan(make) == LOOPS[make.__name__]


def test_a_program_without_loops_keeps_its_order():
    b = Hand()
    r = b.add(b.sin(b.x), b.multiply(b.x, b.y))
    program = program_of(b, {"r": ([r], [])})
    lines = [n for n, i in enumerate(program.instructions) if i.op is not Op.INPUT]
    assert schedule(program).steps == tuple(lines)


def test_iterations_that_contradict_each_other_are_refused():
    b = Hand()
    z = b.phi(b.l, turn, "z")
    b.carry(z, b.sin(z))
    w = b.phi(b.x, turn, "w")
    b.carry(w, b.sin(b.sum(b.multiply(w, b.h), facet)))
    v = b.phi(b.h, turn, "v")
    b.carry(v, b.sin(v))
    ends = [b.element(b.carried[p], turn, 4) for p in (z, w, v)]
    with pytest.raises(ValueError, match="give two iterations two names"):
        schedule(program_of(b, {"r": (ends, [leg, facet])}))
