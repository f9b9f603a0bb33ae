/* tests/vectors/vectors_polygon.c -- readers of polygons and of coordinates with respect to their
 * vertices
 * SPDX-License-Identifier: MIT
 */
#include <string.h>

#include "support/exact_polygon.h"          /* exact_meanvalue: how much is lost */
#include "support/polygons.h"               /* polygon_of, coordinates, solution_of */
#include "polygon/meanvalue.h"
#include "polygon/wachspress.h"

bool polygon_of(row *r, const char *id, polygon *p)
{
    const sheet *s = sheet_of(r, "polygons");

    p->n = 0;
    for (unsigned k = 0; k < s->rows; k++) {
        char *const *f = s->field[k];
        if (strcmp(f[0], id) != 0)
            continue;
        const unsigned i = (unsigned)decimal(r, f[3]) - 1;
        if (i >= LOFT_SIDES_MAX) {
            row_complain(r, "polygon %s has a vertex %s", id, f[3]);
            return false;
        }
        p->kind = f[1];
        p->v[i].at[0] = decimal_real(r, f[4]);
        p->v[i].at[1] = decimal_real(r, f[5]);
        p->n++;
    }
    if (p->n == 0)
        row_complain(r, "no polygon %s", id);
    else if (loft_domain_init(&p->d, p->v, p->n) != LOFT_OK)
        row_complain(r, "polygon %s was refused", id);
    return !r->complaint[0];
}

loft_spot spot_of(row *r)
{
    loft_spot p;

    p.at[0] = decimal_real(r, row_text(r, "x"));
    p.at[1] = decimal_real(r, row_text(r, "y"));
    return p;
}

bool coordinates(row *r, char which, const polygon *p, loft_spot at, loft_sci phi[])
{
    const enum loft_status status = which == 'W' ? loft_wachspress_eval(&p->d, at, phi)
                                    : which == 'M'
                                        ? loft_meanvalue_eval(&p->d, at, phi)
                                        : loft_harmonic_eval(&solution_of(p)->h, at, phi);
    /* rounded out of the polygon */
    if (status != LOFT_OK && !(r->inexact > 0 && status == LOFT_ERR_RANGE))
        row_complain(r, "no coordinates: status %d", status);
    return status == LOFT_OK;
}

bool coordinate_jets(row *r, char which, const polygon *p, loft_spot at, loft_jet phi[])
{
    const enum loft_status status = which == 'W'   ? loft_wachspress_jet(&p->d, at, phi)
                                    : which == 'M' ? loft_meanvalue_jet(&p->d, at, phi)
                                                   : loft_harmonic_jet(&solution_of(p)->h, at, phi);
    if (status != LOFT_OK && !(r->inexact > 0 && status == LOFT_ERR_RANGE))
        row_complain(r, "no derivatives of coordinates: status %d", status);
    return status == LOFT_OK;
}

/* Each row is one vertex; all of them are judged. */
static void polygons(row *r)
{
    polygon p;

    if (!polygon_of(r, row_text(r, "polygon"), &p))
        return;
    row_expect_word(r, "kind", p.d.convex ? "convex" : "nonconvex");
    if (row_count(r, "n", LOFT_SIDES_MAX) != p.n)
        row_complain(r, "%u vertices, not %s", p.n, row_text(r, "n"));
}

void expect_place(row *r, const polygon *p, loft_spot at)
{
    loft_sci area[LOFT_SIDES_MAX];
    unsigned index = 0;
    const enum loft_place place = loft_domain_place(&p->d, at, area, &index);
    const char *type = row_text(r, "type");
    const bool edge = strcmp(type, "edge") == 0, vertex = strcmp(type, "vertex") == 0,
               outside = strcmp(type, "outside") == 0;

    if (r->inexact > 0)
        return;
    if (edge != (place == LOFT_ON_EDGE) || vertex != (place == LOFT_AT_VERTEX) ||
        outside != (place == LOFT_OUTSIDE))
        row_complain(r, "%s, but found in place %d", type, place);
}

/* `lost` is a factor on the error that the place has. */
static void expect_phi(row *r, unsigned n, const loft_sci phi[], long double lost)
{
    loft_acc x[LOFT_SIDES_MAX] = { 0 };
    char column[16];

    r->largest = 1;
    for (unsigned i = 0; i < n; i++) {
        if (!loft_sci_to_acc(phi[i], &x[i]))
            row_complain(r, "coordinate %u does not fit", i);
        r->largest = fmaxl(r->largest, fabsl(exact_acc(x[i])));
    }
    for (unsigned i = 0; i < n; i++) {
        snprintf(column, sizeof column, "phi_%u", i + 1);
        expect_wide(r, column, x[i],
                    (law){ .lsb = 0x1p-17L + 0x1p-24L + r->largest * lost * 0x1p-39L,
                           .gain = 64,
                           .roundings = 64 * lost });
    }
}

/* Where f32 rounded the polygon or the point, the row speaks of others: then the answers are
 * compared with the test's own. */
static void expect_own(row *r, unsigned n, const loft_sci phi[], const long double own[],
                       long double lost)
{
    long double largest = 1;

    for (unsigned i = 0; i < n; i++)
        largest = fmaxl(largest, fabsl(own[i]));
    for (unsigned i = 0; i < n; i++) {
        loft_acc x = 0;
        if (!loft_sci_to_acc(phi[i], &x))
            row_complain(r, "coordinate %u does not fit", i);
        row_within(r, "phi, as read", fabsl(exact_acc(x) - own[i]) * 65536,
                   64 * lost * largest * 0x1p-52L * 65536);
    }
}

static void coordinates_row(row *r, char which)
{
    polygon p;
    loft_sci phi[LOFT_SIDES_MAX], area[LOFT_SIDES_MAX];
    long double own[LOFT_SIDES_MAX];
    unsigned index = 0;

    if (!polygon_of(r, row_text(r, "polygon"), &p))
        return;
    const loft_spot at = spot_of(r);
    expect_place(r, &p, at);
    if (!coordinates(r, which, &p, at, phi))
        return;
    const enum loft_place place = loft_domain_place(&p.d, at, area, &index);
    const bool off = place == LOFT_INSIDE || place == LOFT_OUTSIDE;
    const long double lost = which == 'M' && off ? exact_meanvalue(p.v, p.n, at, own) : 1;
    if (!(r->inexact > 0)) {
        expect_phi(r, p.n, phi, lost);
    } else if (off) {
        if (which == 'W')
            exact_wachspress(p.v, p.n, at, own);
        expect_own(r, p.n, phi, own, lost);
    }
}

static void gbc_wachspress(row *r) { coordinates_row(r, 'W'); }
static void gbc_meanvalue(row *r)  { coordinates_row(r, 'M'); }

static void expect_column(row *r, const char *column, const loft_sci phi[], unsigned n)
{
    answer *a = answer_new();

    for (unsigned i = 0; i < n; i++) {
        loft_acc x = 0;
        if (loft_sci_to_acc(phi[i], &x))
            answer_wide(a, x);
    }
    r->largest = 1;
    row_expect(r, column, a, (law) { .lsb = 0x1p-16L, .gain = 64, .roundings = 64 });
}

/* `utext` weighs with the area at the next vertex as well: the same in triangles, parallelograms
 * and regular polygons, elsewhere no coordinates of the point, but numbers that the library's areas
 * must give. */
static void spatch_coords(row *r)
{
    const unsigned n = row_count(r, "s", LOFT_SIDES_MAX);
    loft_vec v[LOFT_SIDES_MAX + 1];
    polygon p = { .n = n };
    loft_sci phi[LOFT_SIDES_MAX], sum = loft_sci_zero();

    row_points(r, "V_q16", n, 2, v);
    row_points(r, "X_q16", 1, 2, v + LOFT_SIDES_MAX);
    for (unsigned i = 0; i < n; i++)
        for (int k = 0; k < 2; k++)
            p.v[i].at[k] = loft_vec_axis(&v[i], k);
    const loft_spot at = { { loft_vec_axis(&v[LOFT_SIDES_MAX], 0),
                             loft_vec_axis(&v[LOFT_SIDES_MAX], 1) } };
    if (loft_domain_init(&p.d, p.v, n) != LOFT_OK)
        row_complain(r, "the polygon was refused");
    else if (coordinates(r, 'W', &p, at, phi)) {
        expect_column(r, "uwach", phi, n);
        for (unsigned i = 0; i < n; i++) {
            phi[i] = loft_sci_mul(phi[i], p.d.corner[(i + 1) % n]);
            sum = loft_sci_add(sum, phi[i]);
        }
        for (unsigned i = 0; i < n; i++)
            phi[i] = loft_sci_div(phi[i], sum);
        expect_column(r, "utext", phi, n);
    }
}

#define PHI "phi_1,phi_2,phi_3,phi_4,phi_5,phi_6,phi_7,phi_8"

const vector_system vectors_polygon[] = {
    { "polygons", "polygon,kind,n,i,x,y", polygons, "simple, convex: exact" },
    { "gbc_wachspress", "polygon,n,type,x,y," PHI, gbc_wachspress,
      "q16 2^-33 + 2^-40; floats 64 ulp of double of the largest coordinate; where the point lies: "
      "exact" },
    { "gbc_meanvalue", "polygon,n,type,x,y," PHI, gbc_meanvalue,
      "q16 2^-33 + 2^-40 + K 2^-55; floats 64 K ulp of double of the largest coordinate; where the "
      "point lies: exact" },
    { "spatch_coords", "s,V_q16,X_q16,utext,uwach", spatch_coords,
      "q16 2^-32; floats 64 ulp of double" },
    { 0 }
};
