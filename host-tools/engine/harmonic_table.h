/* host-tools/engine/harmonic_table.h -- a solved series as the table of lib/polygon/harmonic.h, in
 * the number type of the file that includes it
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HARMONIC_TABLE_H
#define LOFT_HARMONIC_TABLE_H

#include <math.h>
#include <stdlib.h>

#include "engine/harmonic_solver.h"    /* harmonic_series */
#include "base/memory.h"        /* memory_grow */
#include "polygon/harmonic.h"   /* loft_harmonic_table */

/* A wide number's 1 is 2^32 in q16. */
static inline loft_acc harmonic_acc(long double x)
{
    const long double one = (long double)loft_to_acc(LOFT_REAL(1.0));
    return (loft_acc)(one > 1 ? roundl(x * one) : x);
}

/* The table of a series that was solved for this number type; its two arrays are the caller's to
 * free. False, with an empty table, when
 * a coefficient does not fit. */
static inline bool harmonic_table_of(const harmonic_series *s, loft_harmonic_table *out)
{
    const size_t count = (size_t)s->terms * s->sides;
    loft_acc *coefficient = memory_grow(NULL, count * sizeof *coefficient);
    loft_harmonic_pole *pole = memory_grow(NULL, (s->pole_count + 1) * sizeof *pole);
    bool fits = true;

    for (size_t k = 0; k < count; k++) {
        fits = fits && fabsl(s->coefficient[k]) < 0x1p31L;
        coefficient[k] = fits ? harmonic_acc(s->coefficient[k]) : 0;
    }
    for (unsigned i = 0; i < s->pole_count; i++) {
        pole[i].at[0] = harmonic_acc(s->pole[i][0]);
        pole[i].at[1] = harmonic_acc(s->pole[i][1]);
        pole[i].size = harmonic_acc(s->pole[i][2]);
    }
    *out = (loft_harmonic_table){ coefficient,
                                  pole,
                                  (uint16_t)s->terms,
                                  (uint8_t)s->sides,
                                  (uint16_t)s->poles,
                                  (uint8_t)s->degree,
                                  { 0 },
                                  (uint8_t)s->straight,
                                  { 0 } };
    for (unsigned i = 0; i < s->sides; i++) {
        out->powers[i] = (uint8_t)s->powers[i];
        out->corner_poles[i] = (uint16_t)s->corner_poles[i];
    }
    if (fits)
        return true;
    free(coefficient);
    free(pole);
    *out = (loft_harmonic_table){ 0 };
    return false;
}

#endif
