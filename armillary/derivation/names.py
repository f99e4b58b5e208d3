"""Names that a quantity, a definition or a kernel may not take, because a language claims them."""

from __future__ import annotations

import keyword
import re

from armillary.derivation.errors import DerivationError, Source

_C = """auto break case char const continue default do double else enum extern float for goto if
inline int long register restrict return short signed sizeof static struct switch typedef union
unsigned void volatile while"""
_CPP = """alignas alignof and and_eq asm bitand bitor bool catch char8_t char16_t char32_t class
compl concept consteval constexpr constinit const_cast co_await co_return co_yield decltype delete
dynamic_cast explicit export false final friend mutable namespace new noexcept not not_eq nullptr
operator or or_eq override private protected public reinterpret_cast requires static_assert
static_cast template this thread_local throw true try typeid typename using virtual wchar_t xor
xor_eq main NULL std"""
# <complex.h> claims I; termios, Arduino and the AVR headers claim the rest as macros.
_MACROS = """I complex imaginary F B0 PI HALF_PI TWO_PI DEG_TO_RAD RAD_TO_DEG EULER HIGH LOW INPUT
OUTPUT min max abs round constrain radians degrees sq bit byte word boolean interrupts
noInterrupts DEFAULT EXTERNAL INTERNAL SERIAL DISPLAY SP SPL SPH SREG PINA PINB PINC PIND DDRA DDRB
DDRC DDRD PORTA PORTB PORTC PORTD A0 A1 A2 A3 A4 A5 A6 A7 M_PI M_E NAN INFINITY errno signals slots
emit unix linux"""
_LIBM = """sin cos tan asin acos atan atan2 sqrt fabs sinf cosf tanf asinf acosf atan2f sqrtf fabsf
j0 j1 jn y0 y1 yn gamma_r lgamma tgamma signgam exp log pow floor ceil fmod div time index"""
_OURS = "status p ctx xp np batch ok call Call"

RESERVED = {
    **dict.fromkeys(keyword.kwlist, "a Python keyword"),
    **dict.fromkeys(_C.split(), "a C keyword"),
    **dict.fromkeys(_CPP.split(), "a C++ keyword"),
    **dict.fromkeys(_LIBM.split(), "a function of the C library"),
    **dict.fromkeys(_MACROS.split(), "a macro of a C, Arduino or AVR header"),
    **dict.fromkeys(_OURS.split(), "used by the generated kernels themselves"),
}
# <float.h> claims every name of these families, and the generated headers the last one.
_FAMILIES = ("FLT_", "DBL_", "LDBL_", "ARMILLARY_")
# Names that only some things may not take. What stands in a header may meet <windows.h>, where
# these are macros; a kernel's file has other names beside it, and a system's header a file name.
_WINDOWS = "near far small hyper interface pascal cdecl IN OUT OPTIONAL CONST VOID TRUE FALSE"
_OF_MODULES = "params ctx state setup step init update Any NamedTuple"
_HEADERS = """assert complex ctype errno fenv float inttypes iso646 limits locale malloc math memory
process setjmp signal stdalign stdarg stdatomic stdbool stddef stdint stdio stdlib stdnoreturn
string strings tgmath threads time uchar unistd wchar wctype windows"""

_RESERVED_FOR = {
    "quantity": dict.fromkeys(_WINDOWS.split(), "a macro of <windows.h>"),
    "result": dict.fromkeys(_WINDOWS.split(), "a macro of <windows.h>"),
    "kernel": dict.fromkeys(_OF_MODULES.split(), "used by the generated kernels themselves"),
    "derivation": dict.fromkeys(_HEADERS.split(), "the name of a C header"),
}
_RESERVED_FOR["system"] = {
    **_RESERVED_FOR["derivation"],
    "native": "where the compiled kernels are imported from",
    "papers": "the folder of the papers' own facts",
}
# What no field of a struct may be called: it stands in a header.
CLAIMED_IN_HEADERS = frozenset(_WINDOWS.split())
_IDENTIFIER = re.compile(r"[A-Za-z][A-Za-z0-9_]*\Z")


def check_name(name: str, what: str, source: Source) -> None:
    """Refuse a name that a target language could not print.

    Args:
        what: a quantity, constant, definition, result, kernel, derivation or system.
    """
    if not _IDENTIFIER.match(str(name)) or "__" in name or name.endswith("_"):
        raise DerivationError(
            f"{name!r} cannot name a {what}",
            "use letters, digits and single underscores, beginning with a letter "
            "and ending without an underscore",
            source,
        )
    claimed = _claimed(name, what)
    if claimed is not None:
        mend = f"choose another name in code, such as {_free(name)} or a longer word"
        if what not in ("kernel", "derivation", "system"):
            mend += "; the page can still print the paper's symbol with latex="
        raise DerivationError(f"{name!r} cannot name a {what}: it is {claimed}", mend, source)


def is_macro(name: str) -> bool:
    """Whether a header that a kernel may meet makes a macro of a name."""
    return name in _MACROS.split()


def _claimed(name: str, what: str) -> str | None:
    """By what a name is taken; a result that is named like a macro has another name in C."""
    if what == "result" and is_macro(name):
        return None
    if name.startswith(_FAMILIES):
        return "one of a family of macros of C headers"
    return RESERVED.get(name) or _RESERVED_FOR.get(what, {}).get(name)


def _free(name: str) -> str:
    """A name like one that is taken."""
    return name.lower() if name.startswith(_FAMILIES) else f"{name}_0"
