"""Compiles a kernel with the counting scalar, runs it, and reads the tally."""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from dataclasses import astuple, dataclass, fields
from pathlib import Path

HERE = Path(__file__).parent

# Weights of the modelled cost, those of a small core with a floating-point unit.
DIVISION = 14
FUNCTION = 40

_TRANSLATION_UNIT = """\
#include "counter.hpp"
#define double ::counting::Count
#define float ::counting::Count
#define restrict
#define _Static_assert static_assert
{source}
static void call_kernel(const double *in, double *out) {{ {call} }}
#undef double
#undef float
int main() {{
  using counting::Count;
  int points = 0;
  if (scanf("%d", &points) != 1) return 1;
  for (int point = 0; point < points; ++point) {{
    std::vector<Count> in({n_in}), out({n_out});
    for (Count &x : in)
      if (scanf("%la", &x.value) != 1) return 1;
    counting::tally = counting::Tally{{}};
    call_kernel(in.data(), out.data());
    const counting::Tally t = counting::tally;
    printf("%ld %ld %ld %ld %ld %ld %ld %ld %ld", t.add, t.mul, t.div, t.sqrt, t.pow, t.trig,
           t.inverse, t.absolute, t.compare);
    for (const Count &y : out) printf(" %a", y.value);
    printf("\\n");
  }}
  return 0;
}}
"""


class CountError(RuntimeError):
    """A kernel could not be counted; the message says why."""


@dataclass(frozen=True)
class Counts:
    """Operations that one call performs. A subtraction is an addition, a sign change is free."""

    add: int
    mul: int
    div: int
    sqrt: int
    pow: int
    trig: int
    inverse: int
    absolute: int = 0
    compare: int = 0

    @property
    def flops(self) -> int:
        """Additions, multiplications, divisions and square roots."""
        return self.add + self.mul + self.div + self.sqrt

    @property
    def cost(self) -> int:
        """Modelled cost: a division or root weighs 14, an elementary function 40."""
        functions = self.pow + self.trig + self.inverse
        return self.add + self.mul + DIVISION * (self.div + self.sqrt) + FUNCTION * functions


@dataclass(frozen=True)
class Run:
    """One call: what it cost and what it returned."""

    counts: Counts
    values: list[float]


def run_source(
    source: str,
    call: str,
    points: Sequence[Sequence[float]],
    n_out: int,
    include_dirs: Sequence[Path] = (),
) -> list[Run]:
    """Run C99 or C++17 source on the counting scalar, once for each point.

    `call` is the C++ statement that calls the kernel; it finds the inputs in `const double *in`
    and stores what the kernel returns in `double *out`, `n_out` of them. Inside `source` and
    `call`, `double` and `float` both name the counting scalar, so a call may declare and fill a
    struct of parameters: `params_f64 p; p.L_0 = in[2]; pose_f64(&p, in[0], in[1], out);`.
    """
    unit = _TRANSLATION_UNIT.format(source=source, call=call, n_in=len(points[0]), n_out=n_out)
    given = [str(len(points)), *(float(x).hex() for point in points for x in point)]
    with tempfile.TemporaryDirectory(prefix="count-") as name:
        folder = Path(name)
        (folder / "unit.cpp").write_text(unit)
        includes = [f"-I{path}" for path in (HERE, *include_dirs)]
        flags = ["-std=c++17", "-O0", "-ffp-contract=off", "-w", *includes]
        program = folder / "unit"
        _run([compiler(), *flags, str(folder / "unit.cpp"), "-o", str(program)])
        output = _run([str(program)], stdin="\n".join(given))
    return [_parse(line) for line in output.splitlines()]


def count_c_source(
    source: str,
    entry: str,
    inputs: Sequence[float],
    n_out: int,
    *,
    call: str | None = None,
    include_dirs: Sequence[Path] = (),
) -> Counts:
    """Operations of one call of `entry` at one point.

    Without `call`, the kernel's signature is `entry(const double *in, double *out)`.
    """
    statement = call or f"{entry}(in, out);"
    return run_source(source, statement, [inputs], n_out, include_dirs)[0].counts


def dearest(runs: Sequence[Run]) -> Counts:
    """Counts of the run that cost the most; runs differ only where the code branches."""
    return max((run.counts for run in runs), key=lambda counts: (counts.cost, astuple(counts)))


def compiler() -> str:
    """The C++ compiler: `$CXX`, else g++ or clang++."""
    for name in (os.environ.get("CXX"), "g++", "clang++"):
        if name and shutil.which(name):
            return name
    raise CountError("counting needs a C++17 compiler: install g++ or name one in CXX")


def _run(command: Sequence[str], stdin: str | None = None) -> str:
    done = subprocess.run(command, input=stdin, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise CountError(f"{Path(command[0]).name} failed:\n{done.stderr[:4000]}")
    return done.stdout


def _parse(line: str) -> Run:
    words = line.split()
    n = len(fields(Counts))
    return Run(Counts(*map(int, words[:n])), [float.fromhex(word) for word in words[n:]])
