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
_IDENTIFIER = re.compile(r"[A-Za-z][A-Za-z0-9_]*\Z")


def check_name(name: str, what: str, source: Source) -> None:
    """Refuse a name that a target language could not print."""
    if not _IDENTIFIER.match(name) or "__" in name or name.endswith("_"):
        raise DerivationError(
            f"{name!r} cannot name a {what}",
            "use letters, digits and single underscores, beginning with a letter "
            "and ending without an underscore",
            source,
        )
    if name in RESERVED:
        raise DerivationError(
            f"{name!r} cannot name a {what}: it is {RESERVED[name]}",
            f"choose another name in code, such as {name}_0 or a longer word; "
            "the page can still print the paper's symbol with latex=",
            source,
        )
