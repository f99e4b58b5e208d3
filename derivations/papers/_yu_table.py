"""Yu, Wu and Zhang: Table 1, and what it says of the bodies and of the axes."""

import tomllib
from pathlib import Path

from armillary import at, degrees, substitute, vector
from armillary.derivation.quantity import VectorQuantity
from armillary.derivation.symbols import leaves
from armillary.derivation.units import METRE, RADIAN

from ._yu_kinematics import b, leg, p, q, rr

_FILE = Path(__file__).parents[1] / "rr_3ups" / "parameters.toml"
TABLES = tomllib.loads(_FILE.read_text())
values = {
    name: one["value"]
    for part in ("mount", "bodies")
    for name, one in TABLES[part].items()
    if one["provenance"] == "printed"
}

p.assume(
    "The centre of mass of a link is on its leg, at the distances t_i and s_i of Table 1 from Q_i "
    "and P_i, as (11) and (13) have it; y is the axis along the leg."
)
p.assume(
    "Table 1 does not have the mass centre of the platform with its mirror. What stands on it is "
    "told with the mass centre at o, where the platform weighs nothing on the drives, and judged "
    "by whether another place, y_c and z_c from o in the axes of the platform, gives what is "
    "stated. Its x does not enter: the weight turns the platform about its level axis, x, only."
)
p.assume(
    "The mounting angles are those of the text after (2), the acceleration of free fall that of "
    "the text after (19)."
)


def exact(number, unit):
    """A number of the table, as it is written there; degrees are made radians."""
    return degrees(str(number)) if unit == RADIAN else str(number)


def constant(quantity, name, latex, numbers):
    """A row of the table with its name, the same for all legs or a number each."""
    facts = quantity.facts
    many = isinstance(numbers, list)
    value = [exact(x, facts.unit) for x in numbers] if many else exact(numbers, facts.unit)
    meaning = f"{facts.meaning}, by Table 1"
    if many:
        return p.constant(name, value, meaning, unit=facts.unit, latex=latex, per=leg)
    return p.constant(name, value, meaning, unit=facts.unit, latex=latex)


def row_of(name):
    """What the table gives for a quantity: a scalar, or a vector of three."""
    quantity, given = rr.quantity(name), values[name]
    latex = quantity.facts.latex
    if not isinstance(quantity, VectorQuantity):
        return constant(quantity, f"{name}_1", rf"{{{latex}}}^*", given)
    parts = list(map(list, zip(*given, strict=True))) if quantity.per is not None else given
    return vector(
        *(
            constant(quantity, f"{name}_{axis}_1", rf"{{{latex}}}^*_{axis}", part)
            for axis, part in zip("xyz", parts, strict=True)
        )
    )


table = {name: row_of(name) for name in values}
given = {rr.quantity(name): value for name, value in table.items()}
p.example_at(given)
y_c, z_c = (
    p.scalar(
        f"{axis}_c",
        f"{axis} of the platform's mass centre, from o in the platform's axes",
        unit=METRE,
        range=(-0.16, 0.16),
        latex=f"{axis}_c",
    )
    for axis in "yz"
)
centre = {rr.quantity("r_sc"): vector(0, y_c, z_c)}


def by_table(value):
    """A value of the mechanism with those numbers of Table 1 that it stands on."""
    needed = leaves(value)
    return substitute(value, {q: x for q, x in (given | centre).items() if q in needed})


# ---- Bodies that there can be ----

for key, name, of in (
    ("table: I'_t", "I_t", "a first link"),
    ("table: I'_s", "I_s", "a second link"),
):
    moments = table[name]
    p.between(
        key,
        f"{key[7:]}1, {key[7:]}2, {key[7:]}3: diag{tuple(values[name][0])} kg m^2",
        moments.x + moments.z - moments.y,
        0,
        None,
        words=f"the sum of the moments of {of} across the leg less that along it, negative for no "
        "body,",
    )
I_m = table["I_m"]
p.between(
    "table: I'_m",
    "I'_m: diag(11, 11, 1.0) kg m^2",
    I_m.x + I_m.z - I_m.y,
    0,
    None,
    words="the sum of two moments of the platform less the third",
)

# ---- Where the centres of mass are ----

row = p.constant("r_c_1", "0.2", "200 mm of Table 1", unit=METRE, latex="r^*")
p.equation(
    "table: r'_tc",
    words="the first link's centre of mass in the axes of its leg, by the first row of r'_s",
    quote="r'_s1c, r'_s2c, r'_s3c: [200 0 0] mm, a row that stands twice",
    claims=vector(0, row, 0),
    printed=vector(row, 0, 0),
)
p.equation(
    "table: r'_sc",
    words="the second link's centre of mass in the axes of its leg, from Q_i as (20) has it",
    quote="r'_s1c, r'_s2c, r'_s3c: [200 0 0] mm",
    claims=vector(0, by_table(q) - row, 0),
    printed=vector(row, 0, 0),
)
p.unchecked(
    "table: rows",
    "the two rows of r'_s1c, r'_s2c, r'_s3c",
    "Both have the same name and the same numbers. One of them must be r'_t1c, r'_t2c, r'_t3c of "
    "(20), for which there is no row; r'_sc of (19) has none at all.",
)

# ---- The axes that go through leg 3 ----

p.equation(
    "table: Y axis",
    words="universal joint 3, on the Y axis",
    quote="the Y axis points from O to the centre Q_3 of the U joint of the third leg",
    claims=by_table(at(b, leg, 2)),
    printed=vector(0, at(table["R"], leg, 2), 0),
)
p.equation(
    "table: y axis",
    words="spherical joint 3, on the y axis of the platform",
    quote="the y axis points from o to the centre P_3 of the ball joint of the third leg",
    claims=by_table(at(rr["a_m"], leg, 2)),
    printed=vector(0, at(table["r"], leg, 2), 0),
)
