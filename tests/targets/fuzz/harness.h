/* Calls every kernel of a table with random inputs and holds it to its contract:
   - the guards refuse exactly what lies beyond the limits, and say why;
   - any other status is one that the kernel declares;
   - a negative status leaves the outputs alone, any other makes them all finite;
   - a call whose outputs overlap its inputs gives the same results, unless it must not be made.
   REAL, NEXT, LARGEST, SMALLEST are defined by the file that includes this one. */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 256, PADDING = 4, CANARY = 0xA5 };

/* `unit` marks a unit vector (size 3) and a rotation (size 9). */
struct quantity {
  const char *name;
  int size, unit;
  REAL low, high, from, to;
};

struct kernel {
  const char *name;
  const struct quantity *quantities;
  int count, inputs, outputs;
  int apart;        /* inputs and outputs must not overlap */
  unsigned allowed; /* bit status + 8 */
  int (*call)(const REAL *in, REAL *out);
  const REAL *drawn; /* rows of inputs that fit together, where ranges alone will not do */
  int rows;
};

static uint64_t state;

static uint64_t next_bits(void) {
  uint64_t z = (state += 0x9E3779B97F4A7C15u);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

static int below(int n) { return (int)(next_bits() % (uint64_t)n); }

static REAL between(REAL low, REAL high) {
  const double part = (double)(next_bits() >> 11) / 9007199254740992.0;
  const REAL x = (REAL)((double)low + (((double)high - (double)low) * part));
  return x < low ? low : (x > high ? high : x);
}

static REAL pattern(void) {
  const uint64_t bits = next_bits();
  REAL x;
  memcpy(&x, &bits, sizeof x);
  return x;
}

static REAL special(const struct quantity *q) {
  const REAL pi = (REAL)3.14159265358979323846;
  const REAL found[] = {(REAL)NAN,
                        -(REAL)NAN,
                        (REAL)INFINITY,
                        -(REAL)INFINITY,
                        (REAL)0,
                        -(REAL)0,
                        SMALLEST,
                        -SMALLEST,
                        LARGEST,
                        -LARGEST,
                        (REAL)FLT_MIN,
                        (REAL)1,
                        (REAL)-1,
                        pi / 2,
                        -pi / 2,
                        pi,
                        -pi,
                        2 * pi,
                        (REAL)1e-7,
                        (REAL)1e-20,
                        q->low,
                        q->high,
                        q->from,
                        q->to,
                        NEXT(q->low, -(REAL)INFINITY),
                        NEXT(q->low, (REAL)INFINITY),
                        NEXT(q->high, -(REAL)INFINITY),
                        NEXT(q->high, (REAL)INFINITY)};
  return found[below((int)(sizeof found / sizeof found[0]))];
}

/* A direction, its length off by up to `off`. */
static void direction(REAL *x, double off) {
  double v[3], square;
  do {
    square = 0;
    for (int k = 0; k < 3; k++) {
      v[k] = (2.0 * ((double)(next_bits() >> 11) / 9007199254740992.0)) - 1.0;
      square += v[k] * v[k];
    }
  } while (square > 1.0 || square < 1e-4);
  const double scale = (1.0 + (off * ((double)below(2001) - 1000.0) / 1000.0)) / sqrt(square);
  for (int k = 0; k < 3; k++) {
    x[k] = (REAL)(v[k] * scale);
  }
}

/* A rotation, row-major: two directions made orthonormal, and their cross product. */
static void attitude(REAL *x, double off) {
  REAL drawn[6];
  double c[3][3], along, square;
  do {
    direction(drawn, 0.0);
    direction(drawn + 3, 0.0);
    along = 0;
    for (int k = 0; k < 3; k++) {
      c[0][k] = (double)drawn[k];
      along += c[0][k] * (double)drawn[3 + k];
    }
  } while (fabs(along) > 0.9);
  square = 0;
  for (int k = 0; k < 3; k++) {
    c[1][k] = (double)drawn[3 + k] - (along * c[0][k]);
    square += c[1][k] * c[1][k];
  }
  for (int k = 0; k < 3; k++) {
    c[1][k] /= sqrt(square);
  }
  for (int k = 0; k < 3; k++) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    c[2][k] = (c[0][i] * c[1][j]) - (c[0][j] * c[1][i]);
  }
  for (int k = 0; k < 9; k++) {
    const double part = off * ((double)below(2001) - 1000.0) / 1000.0;
    const double y = c[k % 3][k / 3] + part;
    x[k] = (REAL)y;
  }
}

/* Scaled, mirrored, sheared, an axis lost; along the axes; one entry anything. */
static void spoil_attitude(const struct quantity *q, REAL *x) {
  static const double scales[] = {0.0, 0.9994, 1.0006, -1.0, 1e30};
  const int choice = below(10);
  if (choice < 5) {
    for (int k = 0; k < 9; k++) {
      x[k] = (REAL)((double)x[k] * scales[choice]);
    }
  } else if (choice == 5) {
    const int column = below(3);
    const double scale = below(2) ? -1.0 : 0.999;
    for (int i = 0; i < 3; i++) {
      x[(3 * i) + column] = (REAL)((double)x[(3 * i) + column] * scale);
    }
  } else if (choice == 6) {
    const int to = below(3), from = (to + 1 + below(2)) % 3;
    for (int i = 0; i < 3; i++) {
      x[(3 * i) + to] = (REAL)((double)x[(3 * i) + to] + (3e-3 * (double)x[(3 * i) + from]));
    }
  } else if (choice == 7) { /* a signed permutation of the axes: what singular sets are made of */
    const int first = below(3), step = 1 + below(2);
    const int even = step == 1;
    const double one = below(2) ? 1.0 : -1.0, two = below(2) ? 1.0 : -1.0;
    memset(x, 0, 9 * sizeof *x);
    x[3 * first] = (REAL)one;
    x[(3 * ((first + step) % 3)) + 1] = (REAL)two;
    x[(3 * ((first + (2 * step)) % 3)) + 2] = (REAL)(one * two * (even ? 1.0 : -1.0));
  } else {
    x[below(9)] = special(q);
  }
}

enum { WORKING, LEGAL, SPECIAL, WILD };

static void fill(const struct quantity *q, REAL *x, int way) {
  if (q->unit && q->size == 9 && way != WILD) {
    attitude(x, way == WORKING ? 0.0 : 1e-4);
    if (way == SPECIAL) {
      spoil_attitude(q, x);
    }
    return;
  }
  if (q->unit && way != WILD) {
    direction(x, way == WORKING ? 0.0 : 4e-4);
    if (way == SPECIAL) {
      static const double scales[] = {0.0, 0.9994, 1.0006, -2.0, 1e30};
      const int choice = below(8);
      for (int k = 0; k < 3 && choice < 5; k++) {
        x[k] = (REAL)((double)x[k] * scales[choice]);
      }
      if (choice == 5) { /* an axis: what poles and cuts are made of */
        memset(x, 0, 3 * sizeof *x);
        x[below(3)] = below(2) ? (REAL)1 : (REAL)-1;
      } else if (choice > 5) {
        x[below(3)] = special(q);
      }
    }
    return;
  }
  for (int k = 0; k < q->size; k++) {
    x[k] = way == WILD    ? pattern()
           : way == LEGAL ? between(q->low, q->high)
                          : between(q->from, q->to);
  }
  if (way == SPECIAL) {
    x[below(q->size)] = special(q);
  }
}

static void sample(const struct kernel *k, REAL *in) {
  const int way = below(16), chosen = k->count ? below(k->count) : 0;
  if (k->rows) {
    memcpy(in, k->drawn + ((size_t)below(k->rows) * (size_t)k->inputs),
           (size_t)k->inputs * sizeof *in);
  }
  for (int i = 0; i < k->count; i++) {
    const int one = way < 8    ? WORKING
                    : way < 10 ? LEGAL
                    : way < 14 ? (i == chosen ? SPECIAL : WORKING)
                    : way < 15 ? below(4)
                               : WILD;
    if (one != WORKING || !k->rows) {
      fill(&k->quantities[i], in, one);
    }
    in += k->quantities[i].size;
  }
}

/* Whether nine numbers are a rotation within the tolerance; `either` if that is too near to tell.
   What is not finite is the fault of entries, which are judged by themselves. */
static int orthonormal(const REAL *x, int *either) {
  double c[3][3];
  int fits = 1;
  for (int k = 0; k < 9; k++) {
    c[k % 3][k / 3] = (double)x[k];
  }
  for (int a = 0; a < 3; a++) {
    for (int b = a; b < 3; b++) {
      const double dot = (c[a][0] * c[b][0]) + (c[a][1] * c[b][1]) + (c[a][2] * c[b][2]);
      const double off = fabs(dot - (a == b ? 1.0 : 0.0));
      *either = *either || fabs(off - 1e-3) < 1e-6;
      fits = fits && !(isfinite(off) && off > 1e-3);
    }
  }
  const double volume = (c[0][0] * ((c[1][1] * c[2][2]) - (c[1][2] * c[2][1]))) +
                        (c[0][1] * ((c[1][2] * c[2][0]) - (c[1][0] * c[2][2]))) +
                        (c[0][2] * ((c[1][0] * c[2][1]) - (c[1][1] * c[2][0])));
  return fits && !(isfinite(volume) && volume < 0.0);
}

/* What the guards must say; `either` if a square lies too near its bound to tell. */
static int judged(const struct kernel *k, const REAL *in, int *either) {
  int worst = 0;
  *either = 0;
  for (int i = 0; i < k->count; i++) {
    const struct quantity *q = &k->quantities[i];
    int legal = 1;
    double square = 0;
    for (int c = 0; c < q->size; c++) {
      const int here = !isfinite(in[c]) ? -1 : (in[c] < q->low || in[c] > q->high) ? -2 : 0;
      worst = here < worst ? here : worst;
      legal = legal && here == 0;
      square += (double)in[c] * (double)in[c];
    }
    const double excess = fabs(square - 1.0);
    if (q->unit && q->size == 9) {
      int near = 0;
      if (!orthonormal(in, &near)) {
        worst = -2;
      }
      *either = *either || near;
    } else if (q->unit && legal && fabs(excess - 1e-3) < 1e-6) {
      *either = 1;
    } else if (q->unit && legal && excess > 1e-3) {
      worst = -2;
    }
    in += q->size;
  }
  return worst;
}

static void fail(const struct kernel *k, const REAL *in, int status, const char *why) {
  printf("FAILED %s: %s; status %d at", k->name, why, status);
  for (int i = 0; i < k->count; i++) {
    for (int c = 0; c < k->quantities[i].size; c++) {
      printf(" %s[%d]=%a", k->quantities[i].name, c, (double)*in++);
    }
  }
  printf("\n");
  exit(1);
}

static void check_outputs(const struct kernel *k, const REAL *in, const REAL *out, int status) {
  static const unsigned char canary[sizeof(REAL)] = {CANARY, CANARY, CANARY, CANARY,
                                                     CANARY, CANARY, CANARY, CANARY};
  for (int i = 0; i < k->outputs + PADDING; i++) {
    const int same = memcmp(&out[i], canary, sizeof canary) == 0;
    if ((status < 0 || i >= k->outputs) && !same) {
      fail(k, in, status, "an output was written that should be left alone");
    }
    if (status >= 0 && i < k->outputs && (same || !isfinite(out[i]))) {
      fail(k, in, status, "an output is not finite, or was not written");
    }
  }
}

static void check_in_place(const struct kernel *k, const REAL *in, const REAL *out, int status) {
  REAL both[MOST];
  memcpy(both, in, (size_t)k->inputs * sizeof *in);
  if (k->call(both, both) != status) {
    fail(k, in, status, "another status in place");
  }
  if (status >= 0 && memcmp(both, out, (size_t)k->outputs * sizeof *both) != 0) {
    fail(k, in, status, "other results in place");
  }
}

static void run(const struct kernel *k, long calls) {
  long accepted = 0, answered = 0;
  REAL in[MOST] = {0}, before[MOST], out[MOST];
  const size_t read = (size_t)k->inputs * sizeof *in;
  for (long n = 0; n < calls; n++) {
    int either;
    sample(k, in);
    memcpy(before, in, read);
    memset(out, CANARY, (size_t)(k->outputs + PADDING) * sizeof *out);
    const int expected = judged(k, in, &either);
    const int status = k->call(in, out);
    if (memcmp(before, in, read) != 0) {
      fail(k, before, status, "an input was written");
    }
    if (expected != 0 ? (status != expected && !either)
                      : ((status == -1 || status == -2) && !either)) {
      fail(k, in, status, expected ? "another refusal was due" : "a legal input was refused");
    }
    if (status < -8 || status > 8 || !((k->allowed >> (status + 8)) & 1u)) {
      fail(k, in, status, "an undeclared status");
    }
    check_outputs(k, in, out, status);
    if (n % 16 == 0 && !k->apart) {
      check_in_place(k, in, out, status);
    }
    accepted += status != -1 && status != -2;
    answered += status >= 0;
  }
  printf("%s %ld %ld %ld\n", k->name, calls, accepted, answered);
}

static int run_all(const struct kernel *kernels, int count, const char *calls) {
  for (int i = 0; i < count; i++) {
    state = (uint64_t)i * 1000003u;
    run(&kernels[i], strtol(calls, NULL, 10));
  }
  return 0;
}
