/* tests/support/extremes.h -- the ends of each number type, and what lies beside them
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_EXTREMES_H
#define LOFT_TESTS_EXTREMES_H

#include <float.h>

#include "exact.h"          /* BY_NUM */

static inline int32_t extreme_int(arb *a)
{
    const int32_t ends[] = { INT32_MIN, INT32_MAX, INT32_MIN + 1, 0, 1, -1, 65536, -65536 };
    const uint32_t kind = arb_below(a, 12);
    return kind < 8 ? ends[kind] : (int32_t)(uint32_t)arb_next(a) >> arb_below(a, 31);
}

#if LOFT_NUM == LOFT_Q16
static inline loft_acc extreme_acc(arb *a)
{
    const loft_acc ends[] = { INT64_MIN, INT64_MAX, INT64_MIN + 1, 0, 1, -1, INT64_MAX - 1 };
    const uint32_t kind = arb_below(a, 10);
    return kind < 7 ? ends[kind] : (loft_acc)arb_next(a) >> arb_below(a, 63);
}
static inline loft_real extreme_real(arb *a) { return extreme_int(a); }
static inline loft_real extreme_exact(arb *a) { return extreme_int(a); }
#else
static inline double extreme_double(arb *a, int least, int most)
{
    const int e = arb_below(a, 3) ? least + (int)arb_below(a, (uint32_t)(most - least) + 1)
                                  : (arb_below(a, 2) ? most : least);
    const double size = ldexp(1 + (double)(arb_next(a) >> 12) * 0x1p-52, e - 1);
    return arb_below(a, 8) == 0 ? 0 : arb_below(a, 2) ? size : -size;
}
static inline loft_acc extreme_acc(arb *a) { return extreme_double(a, -499, 1000); }
static inline loft_real extreme_real(arb *a)
{
    const loft_real largest = BY_NUM(0, FLT_MAX, (loft_real)DBL_MAX);
    return arb_below(a, 4) ? (loft_real)extreme_double(a, -100, 127)
           : arb_below(a, 2) ? largest
                             : -largest;
}
/* The largest, the smallest and any that loft_exact_valid takes. */
static inline loft_real extreme_exact(arb *a)
{
    const double ends[] = { 0x1p20 - 0x1p-4, 0x1p-40, 0, 1, 1023 };
    const uint32_t kind = arb_below(a, 8);
    const double size = kind < 5 ? ends[kind] : extreme_double(a, -30, 20);
    return (loft_real)(arb_below(a, 2) ? size : -size);
}
#endif

static inline loft_vec extreme_vec(arb *a)
{
    loft_vec p = { { 0 } };
    for (int i = 0; i < LOFT_AXES; i++)
        p.axis[i] = extreme_real(a);
    return p;
}

#endif
