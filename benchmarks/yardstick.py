"""Kernels written by hand: what a generator is measured against."""

from __future__ import annotations

from pathlib import Path

from benchmarks.measure import measure
from benchmarks.peers import Generated
from benchmarks.recipes import KERNELS
from benchmarks.table import Row

FOLDER = Path(__file__).parent / "hand"
TOOL = "By hand"


def hand_rows() -> list[Row]:
    """One row per file: `k1.c` holds `void hand_k1(const double *in, double *out)`."""
    rows = []
    for path in sorted(FOLDER.glob("*.c")):
        code = Generated("", path.read_text(), f"hand_{path.stem}(in, out);")
        kernel = KERNELS[path.stem.upper()]
        rows.append(measure(kernel, code, tool=TOOL, version="", recipe="own derivation"))
    return rows
