"""What a loop shares: the four facets of the dish cost one attitude and four times the rest."""

from pathlib import Path

from armillary.derivation.load import load
from armillary.program.compile import compile_kernel
from armillary.program.cost import cost
from armillary.program.program import Op, domains, turns

DISH = Path(__file__).parents[2] / "derivations" / "dish_3rps" / "derivation.py"
WEIGHTS = {Op.ADD: 1, Op.MULTIPLY: 1, Op.DIVIDE: 14, Op.SQRT: 14, Op.SIN: 40, Op.COS: 40}


def compiled(kernel):
    return compile_kernel(load(DISH).kernels[kernel]).program


def on_phi(program):
    """Which instructions stand on the azimuth of the facet."""
    found = []
    for i in program.instructions:
        given = i.op is Op.INPUT and i.data == "phi"
        found.append(given or any(found[a] for a in i.args))
    return found


def weight(program, chosen):
    """The weighted cost of some of the instructions, all turns of their loops."""
    return sum(
        WEIGHTS.get(i.op, 0) * turns(domain)
        for i, domain, mine in zip(program.instructions, domains(program), chosen, strict=True)
        if mine
    )


def test_four_facets_cost_the_shared_part_and_four_times_the_rest():
    one, four = compiled("rod_lengths"), compiled("rod_lengths_all")
    of_the_facet = on_phi(one)
    rest = weight(one, of_the_facet)
    shared = weight(one, [not mine for mine in of_the_facet])
    assert shared + rest == cost(one).weighted  # no operation is left out
    assert cost(four).weighted <= shared + 4 * rest
    in_the_loop = [any(i.name == "facet" for i in domain) for domain in domains(four)]
    trigonometry = [i.op in (Op.SIN, Op.COS) for i in four.instructions]
    assert sum(trigonometry) == 4
    assert not any(t and inside for t, inside in zip(trigonometry, in_the_loop, strict=True))
