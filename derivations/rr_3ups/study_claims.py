"""A claim of the paper beside what comes out, and how it is judged.

Reproduced: it comes out with what the study assumes. Not determined: it does not, but with one of
the mass centres and motors that the paper leaves open it does, and with those beside it. Not
reproduced: with none that was tried.
"""

from dataclasses import dataclass

from armillary.verify.study import text_of

YES, NO, OPEN = "reproduced", "not reproduced", "not determined"
MOTION, SIZE, ORDER = "motion", "size", "order"
MM = 1e3
TEN_THOUSAND = 1e4


@dataclass(frozen=True)
class Claim:
    """A row of the table.

    Attributes:
        keys: the names of the same claims among the prints of the paper, or a name of its own.
        kind: about the motion, a size of forces, power or energy, or an order of two of these.
    """

    keys: tuple[str, ...]
    kind: str
    words: str
    printed: str
    here: str
    verdict: str
    why: str

    @property
    def row(self):
        """Its cells."""
        return self.words, self.printed, self.here, self.verdict, self.why


@dataclass(frozen=True)
class Open:
    """What the paper leaves open: the mass centres that were tried, and the motor's constant.

    Attributes:
        centres: what each gives, the first choice first.
        conditions: how many there are on a mass centre for forces of two drives without poles. If
            there are any, forces that are bounded with one have no bound beside it.
        low, high: bounds on the constant, W/N^2, from the paper's own figures.
    """

    centres: tuple[dict, ...]
    conditions: int
    low: float
    high: float

    def where(self, test, two=False):
        """The first mass centre that passes, or None.

        Args:
            test: takes what three and what two drives give.
            two: whether it takes forces of two drives.
        """
        if two and self.conditions:
            return None
        return next((of for of in self.centres if test(*of["drives"])), None)

    def permits(self, constant):
        """Whether a motor with this constant agrees with all of the paper's figures."""
        return self.low <= constant <= self.high


def left_open(results):
    """That, from the results of the parts."""
    unknowns, motor = results["unknowns"], results["motor"]
    return Open(
        tuple(unknowns["centres"]), unknowns["conditions"], motor["low"], motor["high"]
    )  # fmt: skip


def judged(holds):
    """A verdict on what hangs on nothing that is left open."""
    return YES if holds else NO


def hanging(holds, centre, shown, otherwise=""):
    """Verdict and reason where something that is left open decides.

    Args:
        centre: the mass centre with which it comes out, or None.
        shown: takes that and says what comes out.
        otherwise: the reason where none does.
    """
    if holds:
        return YES, "with what is assumed here; the mass centre is not given"
    if centre is not None:
        return OPEN, f"the mass centre is not given; {place(centre)}: {shown(centre)}"
    return NO, otherwise or "nor with another mass centre that was tried"


def place(centre):
    """A mass centre in words."""
    return "with y = {} mm, z = {} mm".format(
        *(text_of(MM * at, ".0f") for at in centre["place"])
    )  # fmt: skip


def motor(constant):
    """A motor's constant in words."""
    return f"$k$ = {TEN_THOUSAND * constant:.1f}·10⁻⁴ W/N²"


def listed(values, form):
    """Numbers beside each other."""
    return ", ".join(text_of(value, form) for value in values)


def exceptions(conditions):
    """The mass centres with which two drives that are singular on the way have no pole."""
    return {1: "one line of mass centres", 2: "a single mass centre"}.get(conditions, "")


def times(ratio):
    """A ratio in words."""
    return f"up to {text_of(ratio, '.2g')} times dawn's"


def yes(holds):
    """What comes out of a claim that holds or does not."""
    return "yes" if holds else "no"
