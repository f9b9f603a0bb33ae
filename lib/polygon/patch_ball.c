/* lib/polygon/patch_ball.c
 * SPDX-License-Identifier: MIT
 */
#include "polygon/patch_ball.h"

static unsigned before(unsigned i, unsigned n) { return i ? i - 1 : n - 1; }

bool loft_wachspress_ball(const loft_domain *d, const loft_jet_ball area[], loft_jet_ball phi[])
{
    loft_jet_ball sum = loft_jet_ball_of(loft_sci_zero());
    const unsigned n = d->sides;

    for (unsigned i = 0; i < n; i++) {
        phi[i] = loft_jet_ball_of(d->corner[i]);
        for (unsigned j = 0; j < n; j++)
            if (j != i && j != before(i, n))
                phi[i] = loft_jet_ball_mul(&phi[i], &area[j]);
        sum = loft_jet_ball_add(&sum, &phi[i]);
    }
    for (unsigned i = 0; i < n; i++)
        if (!loft_jet_ball_div(&phi[i], &sum, &phi[i]))
            return false;
    return true;
}

#define POWERS 10               /* that are kept */

typedef struct {
    loft_jet_ball of[LOFT_SIDES_MAX][POWERS], base[LOFT_SIDES_MAX];
} powers;

static void find_powers(powers *f, const loft_jet_ball base[], unsigned count)
{
    for (unsigned i = 0; i < count; i++) {
        f->base[i] = f->of[i][1] = base[i];
        for (unsigned k = 2; k < POWERS; k++)
            f->of[i][k] = loft_jet_ball_mul(&f->of[i][k - 1], &base[i]);
    }
}

/* weight times base[i]^k. */
static void times_power(loft_jet_ball *weight, const powers *f, unsigned i, unsigned k)
{
    if (k == 0)
        return;
    const loft_jet_ball power = k < POWERS ? f->of[i][k] : loft_jet_ball_pow(&f->base[i], k);
    *weight = loft_jet_ball_mul(weight, &power);
}

bool loft_spatch_ball(const loft_spatch *s, const loft_jet_ball phi[], loft_jet_ball_sum *out)
{
    uint8_t l[LOFT_SIDES_MAX];
    unsigned rank = 0;
    powers f;

    find_powers(&f, phi, s->sides);
    loft_jet_ball_sum_start(out, s->p[0]);
    loft_multiindex_first(l, s->sides, s->depth);
    do {
        const loft_sci ways = loft_sci_from_int(loft_multiindex_multinomial(l, s->sides));
        loft_jet_ball weight = loft_jet_ball_of(
            s->w ? loft_sci_mul(ways, loft_sci_from_real(s->w[rank])) : ways);
        for (unsigned i = 0; i < s->sides; i++)
            times_power(&weight, &f, i, l[i]);
        loft_jet_ball_sum_add(out, &s->p[rank++], &weight);
    } while (loft_multiindex_next(l, s->sides));
    return !s->w || loft_jet_ball_sum_project(out);
}

bool loft_toric_ball(const loft_toric *t, const loft_jet_ball h[], loft_jet_ball_sum *out)
{
    const loft_lattice_polygon *p = t->lattice;
    loft_whole l;
    unsigned k = 0;
    powers f;

    find_powers(&f, h, p->sides);
    loft_jet_ball_sum_start(out, t->p[0]);
    loft_lattice_polygon_first(p, &l);
    do {
        loft_jet_ball weight = loft_jet_ball_of(loft_toric_factor(t, k));
        for (unsigned i = 0; i < p->sides; i++)
            times_power(&weight, &f, i, (unsigned)loft_lattice_polygon_height(p, i, l));
        loft_jet_ball_sum_add(out, &t->p[k++], &weight);
    } while (loft_lattice_polygon_next(p, &l));
    return loft_jet_ball_sum_project(out);
}

static bool point_is_cut(const loft_basepoint *b, const uint8_t l[3])
{
    for (unsigned i = 0; i < 3; i++)
        if (l[i] + b->cut[i] > b->degree)
            return true;
    return false;
}

bool loft_basepoint_ball(const loft_basepoint *b, unsigned corner, const loft_jet_ball factor[4],
                         loft_jet_ball_sum *out)
{
    uint8_t l[3];
    unsigned rank = 0;
    powers f;

    find_powers(&f, factor, 4);
    loft_multiindex_first(l, 3, b->degree);
    for (; point_is_cut(b, l); rank++)
        if (!loft_multiindex_next(l, 3))
            return false;
    loft_jet_ball_sum_start(out, b->p[rank]);
    do {
        if (!point_is_cut(b, l)) {
            const loft_sci ways = loft_sci_from_int(loft_multiindex_multinomial(l, 3));
            loft_jet_ball weight = loft_jet_ball_of(
                loft_sci_mul(ways, loft_sci_from_real(b->w[rank])));
            times_power(&weight, &f, 3, (unsigned)b->degree - l[corner] - b->cut[corner]);
            for (unsigned i = 0; i < 3; i++)
                times_power(&weight, &f, i, l[i]);
            loft_jet_ball_sum_add(out, &b->p[rank], &weight);
        }
        rank++;
    } while (loft_multiindex_next(l, 3));
    return loft_jet_ball_sum_project(out);
}
