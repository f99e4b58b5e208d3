"""Small systems to check, right and wrong ones."""

from pathlib import Path

from armillary.derivation.load import load_all
from armillary.program.compile import compile_kernel
from armillary.targets.files import Target, render_shared, render_system

PACKAGE = "demo_kernels"

TWO_AXES = '''"""Two axes."""

from armillary import Chain, Derivation, Status, X, Y, Z, direction_angles, vector
from armillary.algebra.derivative import time_derivative

derivation = d = Derivation("two_axes", title="Two axes")
a, b = d.angle("a", "first"), d.angle("b", "second")
L = d.parameter.length("L", "arm")
a_dot, b_dot = a.rate(), b.rate()
chain = Chain("g").rotate(Z, -a).translate(Y, L).rotate(X, b).translate(Z, L, frame="tip")
M = d.define("M", chain.pose("g", "tip"), because="compose the joints")
w = d.define("Omega_space", chain.angular_velocity("tip"), because="add the axes")
u = d.define("Omega_body", chain.body_angular_velocity("tip"), because="add the axes")
v = d.define("v_origin", chain.velocity("tip"), because="differentiate")
J = d.define("J", chain.jacobian("tip", (a, b)), because="differentiate")
n = d.unit_vector("n", "a direction")
azimuth, elevation = direction_angles(n)
height = d.define("height", M.position.z, because="take the third component")
height_rate = d.define("height_rate", time_derivative(M.position.z), because="differentiate")
d.identity("both angular velocities are one", w, M.rotation @ u)
d.kernel("pose", inputs=[a, b], outputs=[M])
d.kernel("heights", inputs=[a, b], outputs=[height])
d.kernel("velocity", inputs=[a, b, a_dot, b_dot], outputs=[w, u, v])
d.kernel("climb", inputs=[a, b, a_dot, b_dot], outputs=[height_rate])
d.kernel("jacobian", inputs=[a, b], outputs=[J])
'''

AIM = '''"""Aim."""

from armillary import Derivation, Status, atan2, full_turn, hypot, where

derivation = d = Derivation("aim", title="Aim")
n = d.unit_vector("n", "direction of the sun")
rho = d.define("rho", hypot(n.x, n.y), because="project on the horizon")
vertical = d.define("vertical", rho < "1e-6", because="the azimuth is free there")
east, north = where(vertical, 0, n.x), where(vertical, 1, n.y)
azimuth = d.define("azimuth", full_turn(atan2(east, north)), because="clockwise from north")
elevation = d.define("elevation", atan2(n.z, rho), because="above the horizon")
below = n.z < 0
d.kernel(
    "aim", inputs=[n], outputs=[azimuth, elevation],
    cases=[(Status.SINGULAR, vertical, "the sun stands in the zenith"),
           (Status.UNREACHABLE, below, "the sun is down")],
)
'''


def write(root: Path, **texts: str) -> Path:
    for name, text in texts.items():
        folder = root / "derivations" / name
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "derivation.py").write_text(text, "utf-8")
    return root


def generate(root: Path) -> None:
    """What `armillary generate` writes, without its care."""
    target = Target(PACKAGE, PACKAGE, "", ("f32", "f64"), "0.1.0")
    records = load_all(root / "derivations")
    rendered = {name: render_system(record, target) for name, record in records.items()}
    texts = [made.files for made in rendered.values()] + [render_shared(target, rendered)]
    for files in texts:
        for name, text in files.items():
            path = root / "generated" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, "utf-8")


def record_and_programs(root: Path, name: str):
    record = load_all(root / "derivations")[name]
    return record, {k: compile_kernel(v).program for k, v in record.kernels.items()}
