/* tests/vectors/vectors_harmonic.c -- harmonic coordinates of the polygons of CSVs: each is solved
 * once, at run time
 * SPDX-License-Identifier: MIT
 */
#include <string.h>

#include "support/polygons.h"               /* polygon_of, solution_of */

/* Those that were solved; later ones of a long file take the place of the first. */
#define KEPT 24

static struct {
    polygon p;
    solved s;
} kept[KEPT];
static unsigned solved_so_far;

static bool same_polygon(const polygon *a, const polygon *b)
{
    return a->n == b->n && memcmp(a->v, b->v, a->n * sizeof a->v[0]) == 0;
}

const solved *solution_of(const polygon *p)
{
    for (unsigned k = 0; k < KEPT && k < solved_so_far; k++)
        if (same_polygon(&kept[k].p, p))
            return &kept[k].s;
    const unsigned place = solved_so_far++ % KEPT;
    if (solved_so_far > KEPT)
        solved_free(&kept[place].s);
    kept[place].p = *p;
    kept[place].p.d.v = kept[place].p.v;
    solve(&kept[place].s, &kept[place].p.d);
    return &kept[place].s;
}

long double solution_error(const solved *s) { return s->series.bound + solved_rounding(s); }

/* q16: 2^-18, f64: 1e-12, unless the solver says that it errs more: then the row is wrong. */
static void gbc_harmonic(row *r)
{
    const long double most = BY_NUM(0x1p-18L, 1e-8L, 1e-12L);
    loft_sci phi[LOFT_SIDES_MAX];
    long double own[LOFT_SIDES_MAX];
    double at[2];
    char column[16];
    polygon p;

    if (!polygon_of(r, row_text(r, "polygon"), &p))
        return;
    const loft_spot q = spot_of(r);
    expect_place(r, &p, q);
    if (!coordinates(r, 'H', &p, q, phi))
        return;
    const solved *s = solution_of(&p);
    const long double bound = solution_error(s) + decimal(r, row_text(r, "bound"));
    if (!(bound <= most))
        row_complain(r, "the solver's bound is %Lg", bound);
    for (int k = 0; k < 2; k++)
        at[k] = (double)exact_of(q.at[k]);
    harmonic_at(&s->series, at, own);
    for (unsigned i = 0; i < p.n; i++) {
        loft_acc x = 0;
        snprintf(column, sizeof column, "phi_%u", i + 1);
        if (!loft_sci_to_acc(phi[i], &x))
            row_complain(r, "coordinate %u does not fit", i);
        const long double want = r->inexact > 0 ? own[i] : decimal(r, row_text(r, column));
        row_within(r, column, fabsl(exact_acc(x) - want) * 65536,
                   (bound + BY_NUM(0x1p-32L, 0, 0)) * 65536);
    }
}

#define PHI "phi_1,phi_2,phi_3,phi_4,phi_5,phi_6,phi_7,phi_8"

const vector_system vectors_harmonic[] = {
    { "gbc_harmonic", "polygon,n,type,x,y,bound," PHI, gbc_harmonic,
      "what the solver states for the polygon, at most q16 2^-18, f32 1e-8, f64 1e-12; where the "
      "point lies: exact" },
    { 0 }
};
