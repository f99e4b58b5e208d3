"""SVG as text: the same drawing gives the same bytes, and it carries classes instead of colours."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from html import escape

Point2 = tuple[float, float]
_TELEPHONE = 350.0  # a drawing no wider than this is shown whole on one, and its words with it

LETTERS = {
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "zeta": "ζ",
    "eta": "η", "theta": "θ", "iota": "ι", "kappa": "κ", "lambda": "λ", "mu": "μ", "nu": "ν",
    "xi": "ξ", "pi": "π", "rho": "ρ", "sigma": "σ", "tau": "τ", "upsilon": "υ", "phi": "φ",
    "chi": "χ", "psi": "ψ", "omega": "ω", "Gamma": "Γ", "Delta": "Δ", "Theta": "Θ",
    "Lambda": "Λ", "Xi": "Ξ", "Pi": "Π", "Sigma": "Σ", "Upsilon": "Υ", "Phi": "Φ", "Psi": "Ψ",
    "Omega": "Ω", "varphi": "φ", "vartheta": "ϑ",
}  # fmt: skip
_LOW = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")


def plain(latex: str) -> str:
    """A short LaTeX name as plain text: `L_{0}` is L₀."""
    text = re.sub(r"\\(\w+?)(?![A-Za-z])", lambda m: LETTERS.get(m[1], ""), latex)
    text = re.sub(r"_\{?(\d+)\}?", lambda m: m[1].translate(_LOW), text)
    return text.replace("{", "").replace("}", "").replace("_", " ").strip()


def number(value: float) -> str:
    """A coordinate, to a hundredth, never -0."""
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


class Drawing:
    """Collects elements, and keeps track of how much room they need."""

    def __init__(self) -> None:
        self._elements: list[str] = []
        self._x: list[float] = []
        self._y: list[float] = []

    def _met(self, points: Iterable[Point2], room: float = 0.0) -> None:
        for x, y in points:
            self._x += [x - room, x + room]
            self._y += [y - room, y + room]

    def line(self, a: Point2, b: Point2, kind: str, dashed: bool = False) -> None:
        """A straight line."""
        self.path([a, b], kind, dashed)

    def path(
        self, points: Sequence[Point2], kind: str, dashed: bool = False, closed: bool = False
    ) -> None:
        """A line through points."""
        self._met(points, 3)
        text = "M" + "L".join(f"{number(x)} {number(y)}" for x, y in points)
        dash = ' stroke-dasharray="4 4"' if dashed else ""
        self._elements.append(f'<path class="{kind}" d="{text}{"Z" if closed else ""}"{dash}/>')

    def arrow(self, a: Point2, b: Point2, kind: str, dashed: bool = False) -> None:
        """A line with a head at its end."""
        self.line(a, b, kind, dashed)
        self.head(a, b, kind)

    def head(self, a: Point2, b: Point2, kind: str, size: float = 9.0) -> None:
        """An arrow head at b that comes from a."""
        dx, dy = b[0] - a[0], b[1] - a[1]
        length = (dx * dx + dy * dy) ** 0.5
        if length < 1e-6:
            return
        ux, uy = dx / length, dy / length
        corners = [
            b,
            (b[0] - size * ux + 0.38 * size * uy, b[1] - size * uy - 0.38 * size * ux),
            (b[0] - size * ux - 0.38 * size * uy, b[1] - size * uy + 0.38 * size * ux),
        ]
        text = " ".join(f"{number(x)},{number(y)}" for x, y in corners)
        self._elements.append(f'<polygon class="{kind}" points="{text}"/>')

    def circle(self, centre: Point2, radius: float, kind: str) -> None:
        """A circle on the paper."""
        self._met([centre], radius + 2)
        self._elements.append(
            f'<circle class="{kind}" cx="{number(centre[0])}" cy="{number(centre[1])}" '
            f'r="{number(radius)}"/>'
        )

    def shape(self, path: str, kind: str, corners: Iterable[Point2]) -> None:
        """A path in SVG's own words; `corners` say how far it reaches."""
        self._met(corners, 1)
        self._elements.append(f'<path class="{kind}" d="{path}"/>')

    def text(self, at: Point2, words: str, kind: str = "", anchor: str = "middle") -> None:
        """A label."""
        width = 9.5 * len(words)
        left = {"start": 0.0, "middle": -width / 2, "end": -width}[anchor]
        self._met([(at[0] + left, at[1] - 18), (at[0] + left + width, at[1] + 6)])
        self._elements.append(
            f'<text class="{("label " + kind).strip()}" x="{number(at[0])}" y="{number(at[1])}" '
            f'text-anchor="{anchor}">{escape(words)}</text>'
        )

    def svg(self, identifier: str, title: str, margin: float = 8.0, about: str = "") -> str:
        """The whole drawing, cut to what it needs; `about` tells what it shows to who listens."""
        x, y = min(self._x) - margin, min(self._y) - margin
        width, height = max(self._x) + margin - x, max(self._y) + margin - y
        told = f'<desc id="{identifier}-desc">{escape(about)}</desc>' if about else ""
        labels = f"{identifier}-title {identifier}-desc" if about else f"{identifier}-title"
        small = ' class="small"' if width <= _TELEPHONE else ""
        return (
            f'<svg{small} viewBox="{number(x)} {number(y)} {number(width)} {number(height)}" '
            f'width="{number(width)}" height="{number(height)}" role="img" '
            f'aria-labelledby="{labels}"><title id="{identifier}-title">'
            f"{escape(title)}</title>{told}{''.join(self._elements)}</svg>"
        )
