/* tests/support/solved.h -- harmonic coordinates of a polygon: solved by the host's solver for the
 * compiled number type
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_SOLVED_H
#define LOFT_TESTS_SOLVED_H

#include "check.h"                  /* BY_NUM */
#include "engine/harmonic_table.h"

typedef struct {
    harmonic_series series;
    loft_harmonic_table table;
    loft_harmonic h;
    bool reached, ready;            /* reached the target; a table exists and was accepted */
} solved;

/* The domain must outlive it. */
static inline void solve_to(solved *s, const loft_domain *d, harmonic_target target)
{
    double v[LOFT_SIDES_MAX][2];

    for (unsigned i = 0; i < d->sides; i++)
        for (int k = 0; k < 2; k++)
            v[i][k] = BY_NUM((double)d->v[i].at[k] / 65536, d->v[i].at[k], d->v[i].at[k]);
    s->reached = harmonic_solve(v, d->sides, target, &s->series);
    s->ready = harmonic_table_of(&s->series, &s->table) &&
               loft_harmonic_init(&s->h, d, &s->table) == LOFT_OK;
}

/* To the target of the number type. */
static inline void solve(solved *s, const loft_domain *d)
{
    solve_to(s, d, BY_NUM(HARMONIC_TARGET_Q16, HARMONIC_TARGET_F32, HARMONIC_TARGET_F64));
}

/* The rounding error in addition to the bound of the series. */
static inline long double solved_rounding(const solved *s)
{
    return s->series.weight * HARMONIC_ROUNDING;
}

static inline void solved_free(solved *s)
{
    harmonic_free(&s->series);
    free((void *)(uintptr_t)s->table.coefficient);
    free((void *)(uintptr_t)s->table.pole);
}

#endif
