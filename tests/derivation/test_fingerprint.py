"""The digest of a kernel sees all that a kernel is made from, and no words."""

import pytest

from armillary.derivation.fingerprint import kernel_digest
from armillary.derivation.load import load_all

TEXT = """
from armillary import Derivation, Status
derivation = d = Derivation("demo", title="Demo")
t = d.angle("t", "turn")
u = d.scalar("u", "another", limits=(-5, 5))
L = d.parameter.length("L", "length")
w = d.define("w", t + u, because="because")
d.kernel("demo", inputs=[t, u], outputs={"r": 2 * w}, cases=[(Status.LIMIT, t < 1, "why")])
d.kernel("other", inputs=[t], outputs={"r": t})
"""


def digests(project, text):
    record = load_all(project(demo=text) / "derivations")["demo"]
    return [kernel_digest(record, kernel) for kernel in record.kernels.values()]


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("2 * w", "3 * w"),
        ('{"r": 2 * w}', '{"s": 2 * w}'),
        ("t + u", "t - u"),
        ("[t, u]", "[u, t]"),
        ("(-5, 5)", "(-6, 5)"),
        ("t < 1", "t < 2"),
        ("Status.LIMIT", "Status.CLAMPED"),
    ],
)
def test_each_part_of_a_kernel_counts_for_it_alone(project, tmp_path, old, new):
    demo, other = digests(project, TEXT)
    assert old in TEXT
    path = tmp_path / "derivations" / "demo" / "derivation.py"
    path.write_text(TEXT.replace(old, new, 1), "utf-8")
    record = load_all(tmp_path / "derivations")["demo"]
    assert kernel_digest(record, record.kernels["demo"]) != demo
    assert kernel_digest(record, record.kernels["other"]) == other


def test_words_do_not_count(project, tmp_path):
    before = digests(project, TEXT)
    path = tmp_path / "derivations" / "demo" / "derivation.py"
    words = TEXT.replace('"because"', '"for a reason"').replace('"why"', '"as said"')
    path.write_text(words.replace('"turn"', '"a turn"'), "utf-8")
    record = load_all(tmp_path / "derivations")["demo"]
    assert [kernel_digest(record, kernel) for kernel in record.kernels.values()] == before
