"""Frames: the horizontal axes of the papers, and the East-North-Up axes of every kernel."""

from armillary import PI, Derivation, Z, elementary, full_turn, vector, wrap

derivation = d = Derivation(
    "frames",
    title="Horizontal frames",
    summary="Every kernel speaks East-North-Up. The papers do not: Musabekov et al. write "
    "South-East-Up and Yu et al. West-South-Up, and some count the azimuth from the south. "
    "These kernels carry a vector or an azimuth over, for those who compare.",
)

v = d.vector(
    "v",
    "a vector of any unit, in the axes that the kernel's name ends with",
    limits=(-1e6, 1e6),
    range=(-10.0, 10.0),
    latex=r"\mathbf{v}",
)
azimuth = d.angle("azimuth", "azimuth from north, positive towards east", range=(0.0, 6.3))
azimuth_south = d.angle("azimuth_south", "azimuth from south, positive towards west")

# ---- South-East-Up ----

seu = d.define(
    "seu",
    vector(-v.y, v.x, v.z),
    because="South is minus north, and east and up keep their components.",
    meaning="the vector in South-East-Up axes",
)
enu_of_seu = d.define(
    "enu_of_seu",
    vector(v.y, -v.x, v.z),
    because="The second component is east, and north is minus the first.",
    meaning="a South-East-Up vector in East-North-Up axes",
)
d.identity(
    "South-East-Up is East-North-Up seen from axes turned a quarter to the right",
    seu,
    elementary(Z, PI / 2) @ v,
)
d.identity(
    "the way back is a quarter to the left",
    enu_of_seu,
    elementary(Z, -PI / 2) @ v,
)

# ---- West-South-Up ----

wsu = d.define(
    "wsu",
    vector(-v.x, -v.y, v.z),
    because="West is minus east, and south is minus north.",
    meaning="the vector in West-South-Up axes",
)
enu_of_wsu = d.define(
    "enu_of_wsu",
    vector(-v.x, -v.y, v.z),
    because="East is minus west, and north is minus south.",
    meaning="a West-South-Up vector in East-North-Up axes",
)
d.identity(
    "West-South-Up is East-North-Up after half a turn about the vertical",
    wsu,
    elementary(Z, PI) @ v,
)

# ---- azimuths ----

from_south = d.define(
    "from_south",
    wrap(azimuth - PI),
    because="South lies half a turn from north, and both azimuths grow clockwise.",
    meaning="azimuth from south, positive towards west, in [-pi, pi]",
)
from_north = d.define(
    "from_north",
    full_turn(wrap(azimuth_south + PI)),
    because="North lies half a turn from south; the azimuth is brought into one turn from north.",
    meaning="azimuth from north, positive towards east, in [0, 2 pi)",
)

d.kernel(
    "seu_from_enu",
    inputs=[v],
    outputs={"v": seu},
    summary="A vector in South-East-Up axes from its East-North-Up components.",
)
d.kernel(
    "enu_from_seu",
    inputs=[v],
    outputs={"v": enu_of_seu},
    summary="A vector in East-North-Up axes from its South-East-Up components.",
)
d.kernel(
    "wsu_from_enu",
    inputs=[v],
    outputs={"v": wsu},
    summary="A vector in West-South-Up axes from its East-North-Up components.",
)
d.kernel(
    "enu_from_wsu",
    inputs=[v],
    outputs={"v": enu_of_wsu},
    summary="A vector in East-North-Up axes from its West-South-Up components.",
)
d.kernel(
    "azimuth_from_south_west",
    inputs=[azimuth],
    outputs={"azimuth_south": from_south},
    summary="Azimuth counted from south towards west, from the azimuth counted from north "
    "towards east.",
)
d.kernel(
    "azimuth_from_north_east",
    inputs=[azimuth_south],
    outputs={"azimuth": from_north},
    summary="Azimuth counted from north towards east, from the azimuth counted from south "
    "towards west.",
)
