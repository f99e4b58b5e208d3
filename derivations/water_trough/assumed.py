"""What the model takes for granted: first what the paper says, then what is ours."""

from .symbols import d

d.assume(
    "From the paper: one freedom, the turn about the axis z through O that the two bearings carry; "
    "two containers joined by a tube, a pump in each; the forces on the trough are those of the "
    "bearings, its weight M g, and F_1 and F_2 of the containers."
)
d.assume(
    "From the paper: filling container 1 turns the trough counterclockwise. We read this as "
    "positive theta, seen against z, with container 1 on the left, x_1 < 0 < x_2."
)
d.assume(
    "Ours: every formula of this page but one. The paper prints a balance of forces, (2), which "
    "the force of both bearings claims with the water's momentum added, and names its symbols; the "
    "moment equation is announced as (3), and the file ends before it."
)
d.assume("Ours: F_1 and F_2 are the weights of the water. Its inertia stands in the accelerations.")
d.assume(
    "Ours: the axis is level and its bearings do not give; trough, containers and tube are rigid, "
    "also where the paper's tube is flexible."
)
d.assume(
    "Ours: `single_axis` takes an axis of any tilt b, the mechanics a level one. On a tilted axis "
    "g stands for g cos(b) in every moment, pressure and force across the axis. The part m g "
    "sin(b) along it is a thrust that one bearing must take, with a friction of its own; it also "
    "tilts the water along the containers, which the model has no place for."
)
d.assume(
    "Ours: all mass, water included, lies symmetric about the plane z = 0. The rate of momentum "
    "then has no moment across the axis, and the bearings share the force as r_B to r_A."
)
d.assume("Ours: the bearings bear no force along the axis and no moment but friction.")
d.assume(
    "Ours: the walls of the containers are straight and stand at a right angle to floors that are "
    "parallel to xi and z; the tube leaves and enters at the centres of the floors."
)
d.assume(
    "Ours: in a container the water moves only along the normal of the floor, all of it at one "
    "speed, and spreads over the floor at once where the tube ends."
)
d.assume(
    "Ours, a convention: the water's surface stays parallel to the floor, as under a lid that "
    "slides with it. Left to itself it would be level at the speed of tracking, since the first "
    "slosh of a container is faster than the swing of the trough. `free_surface` tells what that "
    "takes off the stiffness and how high the water then stands at the lower wall, "
    "`rest_volume_level` what it changes of the volumes; sloshing itself is left out. Steep turns "
    "need closed containers."
)
d.assume(
    "Ours: the tube is always full, one speed across its section. Its inlet and outlet, its bends "
    "and its walls lose no pressure, and the water has one density."
)
d.assume(
    "Ours: a pump that stands is a closed valve: the flow is prescribed, and none is prescribed as "
    "none. A centrifugal pump in a full tube would let the water run back; what it, or a valve, "
    "must hold is the result of `pump_pressure` at no flow."
)
d.assume(
    "Ours: one pressure stands for both pumps, positive where it drives water from container 2 to "
    "1; the air above the water has one pressure, and no mass."
)
d.assume(
    "Ours: dry friction after Coulomb, one coefficient at rest and in motion, at the surface of "
    "either bearing, r_f / 2 from the axis; r_f is a diameter, as the nomenclature says. At rest "
    "only the sum of both moments is determined; it is shared as in motion, by convention."
)
d.assume("Ours: no wind and no drag of the air.")
d.assume(
    "Ours: the row of troughs of the backtracking is endless and straight; its ground is a plane."
)
