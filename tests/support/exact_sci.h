/* tests/support/exact_sci.h -- converts numbers with an exponent of their own for references
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_EXACT_SCI_H
#define LOFT_TESTS_EXACT_SCI_H

#include "support/exact.h"  /* exact_of */
#include "num/sci.h"        /* loft_sci */

/* A q16 number has 62 bits and long double has 64, so the conversion is exact. */
static inline long double exact_sci(loft_sci x)
{
#if LOFT_NUM == LOFT_Q16
    const long double v = ldexpl((long double)x.m, x.e);
    return x.minus ? -v : v;
#else
    return (long double)x;
#endif
}

#endif
