"""The same program whatever the hash seed, the folder and the locale."""

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SCRIPT = """
import sys
from pathlib import Path
from armillary.derivation.load import load_all
from armillary.program.compile import compile_kernel, compile_stages
for name, record in load_all(Path(sys.argv[1])).items():
    for kernel in record.kernels.values():
        made = compile_kernel(kernel)
        stages = compile_stages(made)
        print(name, kernel.name, made.program.digest())
        if stages:
            print(stages.setup.digest(), stages.step.digest())
"""
DEMO = """
from armillary import *
from armillary import Chain, Derivation, X, Y, Z, cos, direction_angles, sin, unit

derivation = d = Derivation("demo", title="Demo")
a, b = d.angle("a", "first"), d.angle("b", "second")
n = d.unit_vector("n", "direction")
L = d.parameter.length("L", "arm")
tilt = d.parameter.angle("tilt", "tilt of the base")
base = Chain("g").rotate(X, tilt)
chain = base.rotate(Z, a).translate(Y, L).rotate(X, b).translate(Z, L, frame="tip")
M = d.define("M", chain.pose("g", "tip"), because="compose")
J = d.define("J", chain.jacobian("tip", (a, b)), because="differentiate")
az, el = direction_angles(unit(n + chain.rotation("g", "tip").column(2)))
azimuth = d.define("azimuth", az + cos(3 * a) + cos(2 * a) + sin(a), because="a mixture")
d.kernel("pose", inputs=[a, b], outputs=[M, J])
d.kernel("aim", inputs=[a, b, n], outputs={"azimuth": azimuth, "el": el})
"""


def digests(root, seed, **more):
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "PYTHONHASHSEED": seed, **more}
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT, str(root / "derivations")],
        capture_output=True, text=True, env=environment, cwd=root, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_digests_do_not_depend_on_the_hash_seed(project):
    root = project(demo=DEMO)
    first = digests(root, "0")
    assert first.count("\n") == 4  # two kernels, and the stages of both
    assert digests(root, "1") == first
    assert digests(root, "2", LC_ALL="C", TZ="Pacific/Apia") == first
