/* tests/vectors/vectors_points.h -- answers that are points, and rows that a number type cannot
 * hold
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_VECTORS_POINTS_H
#define LOFT_TESTS_VECTORS_POINTS_H

#include "vectors/vectors.h"        /* row, answer, law */

/* Where f32 cannot hold the row's coordinates, it reads another curve. */
static inline bool as_given(const row *r) { return !(r->inexact > 0); }

static inline unsigned dimension(row *r) { return row_count(r, "d", LOFT_AXES); }

static inline void expect_vec(row *r, const char *column, enum loft_status status, loft_vec v,
                              unsigned d, law l)
{
    answer *a = answer_new();

    answer_status(r, a, status);
    answer_vec(a, v, d);
    row_expect(r, column, a, l);
}

static inline void expect_vecs(row *r, const char *column, enum loft_status status,
                               const loft_vec v[], unsigned count, unsigned d, law l)
{
    answer *a = answer_new();

    answer_status(r, a, status);
    for (unsigned k = 0; k < count && status == LOFT_OK; k++)
        answer_vec(a, v[k], d);
    row_expect(r, column, a, l);
}

#endif
