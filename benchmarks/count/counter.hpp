// A scalar that carries a double and tallies every operation done to it.
//
// Kernels are compiled with `double` and `float` defined as this type, so loops, helper functions
// and repeated calls count as often as they run. Arithmetic between literals is done by the
// compiler and is not counted; neither is a sign change.
#pragma once

#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#undef isfinite
#undef isinf
#undef isnan
#undef signbit

namespace counting {

struct Tally {
  long add, mul, div, sqrt, pow, trig, inverse, absolute, compare;
};

inline Tally tally{};

class Count {
public:
  Count() = default;
  template <class T, class = std::enable_if_t<std::is_arithmetic_v<T>>>
  Count(T x) : value(static_cast<double>(x)) {}
  template <class T, class = std::enable_if_t<std::is_arithmetic_v<T>>>
  explicit operator T() const {
    return static_cast<T>(value);
  }
  Count operator-() const { return Count(-value); }
  Count operator+() const { return *this; }
  double value = 0;
};

#define COUNTING_OPERATOR(op, kind)                                                                \
  inline Count operator op(Count a, Count b) {                                                     \
    ++tally.kind;                                                                                  \
    return Count(a.value op b.value);                                                              \
  }                                                                                                \
  inline Count &operator op## = (Count & a, Count b) { return a = a op b; }
COUNTING_OPERATOR(+, add)
COUNTING_OPERATOR(-, add)
COUNTING_OPERATOR(*, mul)
COUNTING_OPERATOR(/, div)

#define COUNTING_COMPARISON(op)                                                                    \
  inline bool operator op(Count a, Count b) {                                                      \
    ++tally.compare;                                                                               \
    return a.value op b.value;                                                                     \
  }
COUNTING_COMPARISON(<)
COUNTING_COMPARISON(<=)
COUNTING_COMPARISON(>)
COUNTING_COMPARISON(>=)
COUNTING_COMPARISON(==)
COUNTING_COMPARISON(!=)

#define COUNTING_FUNCTION(name, kind)                                                              \
  inline Count name(Count x) {                                                                     \
    ++tally.kind;                                                                                  \
    return Count(std::name(x.value));                                                              \
  }                                                                                                \
  inline Count name##f(Count x) { return name(x); }
COUNTING_FUNCTION(sin, trig)
COUNTING_FUNCTION(cos, trig)
COUNTING_FUNCTION(tan, trig)
COUNTING_FUNCTION(asin, inverse)
COUNTING_FUNCTION(acos, inverse)
COUNTING_FUNCTION(atan, inverse)
COUNTING_FUNCTION(sqrt, sqrt)
COUNTING_FUNCTION(fabs, absolute)

inline Count atan2(Count y, Count x) {
  ++tally.inverse;
  return Count(std::atan2(y.value, x.value));
}
inline Count atan2f(Count y, Count x) { return atan2(y, x); }

// A square is one multiplication: C compilers turn pow(x, 2) into x * x.
inline Count pow(Count x, Count exponent) {
  ++(exponent.value == 2 ? tally.mul : tally.pow);
  return Count(std::pow(x.value, exponent.value));
}
inline Count powf(Count x, Count exponent) { return pow(x, exponent); }

inline bool isfinite(Count x) { return std::isfinite(x.value); }
inline bool isinf(Count x) { return std::isinf(x.value); }
inline bool isnan(Count x) { return std::isnan(x.value); }
inline bool signbit(Count x) { return std::signbit(x.value); }

} // namespace counting

// Kernels in C++ write std::sin.
namespace std {
using counting::acos;
using counting::asin;
using counting::atan;
using counting::atan2;
using counting::cos;
using counting::fabs;
using counting::isfinite;
using counting::isinf;
using counting::isnan;
using counting::pow;
using counting::signbit;
using counting::sin;
using counting::sqrt;
using counting::tan;
} // namespace std
