/* host-tools/engine/engine_harmonic.h -- harmonic coordinates of a domain, solved when it is opened
 * SPDX-License-Identifier: MIT
 *
 * For the files that are compiled once per number type.
 */
#ifndef LOFT_HOST_ENGINE_HARMONIC_H
#define LOFT_HOST_ENGINE_HARMONIC_H

#include "engine/engine_num.h"         /* double_of */
#include "base/memory.h"               /* memory_grow */
#include "engine/harmonic_table.h"     /* harmonic_table_of */

typedef struct {
    harmonic_series series;
    loft_harmonic_table table;
    loft_harmonic h;
} engine_harmonic;

static inline const loft_harmonic *engine_harmonic_of(const engine_harmonic *e) { return &e->h; }

static inline void engine_harmonic_free(engine_harmonic *e)
{
    if (e == NULL)
        return;
    harmonic_free(&e->series);
    free((void *)(uintptr_t)e->table.coefficient);
    free((void *)(uintptr_t)e->table.pole);
    free(e);
}

/* The best there is for this number type: q16 has a grain, floats differ by what is worth while.
 * LOFT_ERR_RANGE when coefficients do not fit or
 * the error on the boundary is above 1e-3. */
static inline int engine_harmonic_solve(const loft_domain *d, engine_harmonic **out)
{
    const harmonic_target target = LOFT_REAL_LSB > 0                     ? HARMONIC_TARGET_Q16
                                   : sizeof(loft_real) == sizeof(double) ? HARMONIC_TARGET_F64
                                                                         : HARMONIC_TARGET_F32;
    engine_harmonic *e = memory_grow(NULL, sizeof *e);
    double v[LOFT_SIDES_MAX][2];

    *e = (engine_harmonic){ .table = { .coefficient = NULL } };
    for (unsigned i = 0; i < d->sides; i++)
        for (int k = 0; k < 2; k++)
            v[i][k] = double_of(d->v[i].at[k]);
    harmonic_solve(v, d->sides, target, &e->series);
    int status = e->series.bound < 1e-3L && harmonic_table_of(&e->series, &e->table)
                     ? LOFT_OK
                     : LOFT_ERR_RANGE;
    if (status == LOFT_OK)
        status = loft_harmonic_init(&e->h, d, &e->table);
    if (status == LOFT_OK)
        *out = e;
    else
        engine_harmonic_free(e);
    return status;
}

#endif
