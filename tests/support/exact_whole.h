/* tests/support/exact_whole.h -- exact decisions of a test, independent of lib/: __int128, and
 * beyond it 113 bits next to the low ones
 * SPDX-License-Identifier: MIT
 *
 * Coordinates become whole numbers, their raw Q16.16: exactly in q16, and in floats that are
 * multiples of 2^-16. A number of up to 200 bits is stored as its value modulo 2^128 and as a quad
 * with an error of 2^-110 of the sizes involved. If the quad is large its sign is right; if it is
 * small the low bits are the whole number.
 */
#ifndef LOFT_TESTS_EXACT_WHOLE_H
#define LOFT_TESTS_EXACT_WHOLE_H

#include "support/exact.h"              /* exact_of */

__extension__ typedef __int128 wide;
__extension__ typedef unsigned __int128 low_bits;
__extension__ typedef __float128 quad;

static inline wide whole_of(loft_real x)    { return (wide)(exact_of(x) * 65536); }
static inline int  wide_sign(wide v)        { return v > 0 ? 1 : v < 0 ? -1 : 0; }

typedef struct {
    low_bits low;
    quad near;
} vast;

static inline vast vast_of(wide v)              { return (vast) { (low_bits)v, (quad)v }; }
static inline vast vast_add(vast a, vast b) { return (vast){ a.low + b.low, a.near + b.near }; }
static inline vast vast_times(wide k, vast a)
{
    return (vast){ (low_bits)k * a.low, (quad)k * a.near };
}
static inline vast vast_product(wide a, wide b) { return vast_times(a, vast_of(b)); }

/* Rounded once, to 64 bits. */
static inline bool        vast_small(vast a)    { return a.near < 0x1p120L && a.near > -0x1p120L; }
static inline long double vast_value(vast a)
{
    return vast_small(a) ? (long double)(wide)a.low : (long double)a.near;
}
static inline int vast_sign(vast a) { return vast_value(a) > 0 ? 1 : vast_value(a) < 0 ? -1 : 0; }

#endif
