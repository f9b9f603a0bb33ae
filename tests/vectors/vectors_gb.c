/* tests/vectors/vectors_gb.c -- readers of generalized Bezier patches: parameters, nets, points,
 * curvature
 * SPDX-License-Identifier: MIT
 */
#define _GNU_SOURCE                 /* strsep */
#include <string.h>

#include "support/exact_quad.h"             /* quad_gauss: of what was read */
#include "support/polygons.h"               /* polygon_of, coordinates */
#include "polygon/gb.h"

#define POINTS 201                  /* 8 sides, degree 9 */

static loft_vec point[POINTS];

/* What coordinates err by that are no more than solved for. */
static long double error_of(char which, const polygon *p)
{
    return which == 'H' ? solution_error(solution_of(p)) : 0;
}

/* The row complains about what `coordinates` refuses. */
static bool phi_of(row *r, char which, const polygon *p, loft_spot at, loft_sci phi[])
{
    if (coordinates(r, which, p, at, phi))
        return true;
    if (!(r->inexact > 0))
        row_complain(r, "no coordinates of the kind %c", which);
    return false;
}


/* Parameters: the last columns are s_1 .. s_m, h_1 .. h_m, for an m of the file's own. */

static void split_rest(row *r, char fields[2 * LOFT_SIDES_MAX][64], unsigned n)
{
    static char name[2 * LOFT_SIDES_MAX][16];
    const char *text = row_text(r, "parameters");
    unsigned count = 1, own = 0;

    for (const char *c = text; *c; c++)
        count += *c == ',';
    for (unsigned k = 0; k < count; k++, text += strcspn(text, ",") + 1) {
        const unsigned i = k % (count / 2);
        if (i >= n || own >= 2 * LOFT_SIDES_MAX || r->columns >= ROW_COLUMNS)
            continue;
        snprintf(name[own], sizeof name[own], "%c%u", k < count / 2 ? 's' : 'h', i + 1);
        snprintf(fields[own], sizeof fields[own], "%.*s", (int)strcspn(text, ","), text);
        r->name[r->columns] = name[own];
        r->field[r->columns++] = fields[own++];
    }
    if (own != 2 * n)
        row_complain(r, "%u parameters of %u sides", own, n);
}

static void expect_parameter(row *r, char letter, unsigned i, loft_sci value, long double off)
{
    char column[16];
    loft_acc x = 0;

    snprintf(column, sizeof column, "%c%u", letter, i + 1);
    if (!loft_sci_to_acc(value, &x))
        row_complain(r, "%s does not fit", column);
    expect_wide(r, column, x,
                (law){ .lsb = 0x1p-17L + 0x1p-24L + off * 65536,
                       .gain = 1,
                       .roundings = 256 + off * 0x1p52L });
}

static void gb_params(row *r)
{
    polygon p;
    loft_sci phi[LOFT_SIDES_MAX];
    loft_gb_side side[LOFT_SIDES_MAX];
    char fields[2 * LOFT_SIDES_MAX][64];

    if (!polygon_of(r, row_text(r, "polygon"), &p) ||
        !phi_of(r, row_text(r, "which")[0], &p, spot_of(r), phi))
        return;
    split_rest(r, fields, p.n);
    if (loft_gb_params(p.n, phi, side) != LOFT_OK) {
        row_complain(r, "no parameters");
        return;
    }
    const long double error = error_of(row_text(r, "which")[0], &p);
    r->largest = 1;
    for (unsigned i = 0; i < p.n && !r->complaint[0]; i++) {
        const long double below = exact_sci(side[i].below_h);
        char column[16];
        snprintf(column, sizeof column, "s%u", i + 1);
        if (row_is(r, column, "") != side[i].any)
            row_complain(r, "%s is %sfree", column, side[i].any ? "" : "not ");
        else if (!side[i].any)
            expect_parameter(r, 's', i, side[i].s, error / below);
        expect_parameter(r, 'h', i, side[i].h, p.n * error);
    }
}


/* Nets */

typedef struct {
    loft_gb g;
    polygon domain;
    char which;
    long double largest;
} patch;

/* Where the point of a row of gb_net.csv is stored. */
static unsigned place_of(row *r, char *const f[], unsigned n, unsigned d)
{
    const unsigned side = (unsigned)decimal(r, f[5]), j = (unsigned)decimal(r, f[6]),
                   k = (unsigned)decimal(r, f[7]);

    if (side == 0)
        return loft_gb_count(n, d) - 1;
    if (side <= n && j <= d && k < (d + 1) / 2)
        return loft_gb_place(n, d, side - 1, j, k);
    row_complain(r, "no control point %u %u %u", side, j, k);
    return 0;
}

static bool patch_of(row *r, const char *id, patch *p)
{
    const sheet *s = sheet_of(r, "gb_net");
    bool found[POINTS] = { false };
    unsigned n = 0, d = 0, missing = 0;

    r->largest = 0;
    for (unsigned k = 0; k < s->rows && !r->complaint[0]; k++) {
        char *const *f = s->field[k];
        if (strcmp(f[0], id) != 0)
            continue;
        if (!n && !polygon_of(r, f[4], &p->domain))
            return false;
        if (!n)
            r->largest = 0;
        n = (unsigned)decimal(r, f[1]);
        d = (unsigned)decimal(r, f[2]);
        p->which = f[3][0];
        if (n != p->domain.n || d < 3 || d > LOFT_DEGREE_MAX) {
            row_complain(r, "%u sides of degree %u over %s", n, d, f[4]);
            return false;
        }
        const unsigned place = place_of(r, f, n, d);
        for (int i = 0; i < 3; i++)
            point[place].axis[i] = decimal_real(r, f[8 + i]);
        found[place] = true;
    }
    for (unsigned k = 0; n && k < loft_gb_count(n, d); k++)
        missing += !found[k];
    p->largest = r->largest;
    if (!n || missing)
        row_complain(r, "the net of %s misses %u points", id, missing);
    else if (loft_gb_init(&p->g, point, n, d) != LOFT_OK)
        row_complain(r, "the patch %s was refused", id);
    return !r->complaint[0];
}

/* A point that two ribbons share is the same in both; a corner of the patch is its point. */
static void gb_net(row *r)
{
    patch p;
    loft_sci phi[LOFT_SIDES_MAX];
    loft_vec v = { { 0 } };

    if (!patch_of(r, row_text(r, "case"), &p))
        return;
    const unsigned n = p.g.sides, d = p.g.degree;
    const unsigned side = row_count(r, "side", n), j = row_count(r, "j", d),
                   k = row_count(r, "k", d);
    const unsigned place = side ? loft_gb_place(n, d, side - 1, j, k) : loft_gb_count(n, d) - 1;
    const law none = { .lsb = 0, .gain = 1, .roundings = 0 };
    expect_point(r, LOFT_OK, point[place], none);
    if (side && (j == 0 || j == d) && k == 0) {
        loft_domain_vertex(&p.domain.d, (side - 1 + (j == d)) % n, phi);
        expect_point(r, loft_gb_eval(&p.g, phi, &v), v, none);
    }
}


/* Points */

static void gb_eval(row *r)
{
    static loft_sci weight[POINTS];
    patch p;
    loft_sci phi[LOFT_SIDES_MAX];
    loft_vec v = { { 0 } };
    loft_acc x = 0;

    if (!patch_of(r, row_text(r, "case"), &p))
        return;
    const loft_spot at = spot_of(r);
    if (!phi_of(r, p.which, &p.domain, at, phi))
        return;
    const long double off = 16 * error_of(p.which, &p.domain);
    r->largest = p.largest;
    expect_point(r, loft_gb_eval(&p.g, phi, &v), v,
                 (law){ .lsb = 0.5L + 0x1p-12L + off * r->largest * 65536,
                        .gain = 4,
                        .roundings = 128 + off * 0x1p52L });
    if (loft_gb_weights(p.g.sides, p.g.degree, phi, weight) != LOFT_OK ||
        !loft_sci_to_acc(weight[loft_gb_count(p.g.sides, p.g.degree) - 1], &x))
        row_complain(r, "no weights");
    r->largest = 1;
    expect_wide(
        r, "B0", x,
        (law){ .lsb = 0x1p-16L + off * 65536, .gain = 4, .roundings = 128 + off * 0x1p52L });
}

/* Where f32 rounded the polygon, the net or the point, the row speaks of others. */
static void expect_own_curvature(row *r, const patch *p, loft_spot at, long double got)
{
    arb_domain own = { .n = p->domain.n };
    const quad_surface s = { &p->g, &own, p->which == 'M' };
    quad slope[LOFT_AXES][5];

    memcpy(own.v, p->domain.v, sizeof own.v);
    if (p->which == 'H')
        return;
    quad_differences(quad_surface_at, &s, LOFT_AXES, quad_of(at),
                     quad_scale(&own, quad_of(at), true) * 1e-7L, slope);
    const long double want = (long double)quad_gauss(slope);
    row_within(r, "K, as read", fabsl(got - want) * 65536, fmaxl(1, fabsl(want)) * 1e-9L * 65536);
}

static long double distance_from(const polygon *p, loft_spot at)
{
    long double least = 1;

    for (unsigned i = 0; i < p->n; i++) {
        const quad_spot from = quad_of(p->v[i]), to = quad_of(p->v[(i + 1) % p->n]);
        least = fminl(least, (long double)(quad_size(quad_cross(quad_of(at), from, to)) /
                                           quad_sqrt(quad_dot(from, to, to))));
    }
    return least;
}

static void gb_curvature(row *r)
{
    patch p;
    loft_jet phi[LOFT_SIDES_MAX];
    loft_differential here;
    loft_curvatures k;

    if (!patch_of(r, row_text(r, "case"), &p))
        return;
    const loft_spot at = spot_of(r);
    if (!coordinate_jets(r, p.which, &p.domain, at, phi)) {
        row_complain(r, "no derivatives of coordinates of the kind %c", p.which);
        return;
    }
    const enum loft_status status = loft_gb_differential(&p.g, phi, &here);
    if (status != LOFT_OK || loft_differential_curvatures(&here, &k) != LOFT_OK) {
        /* no loft_acc holds it */
        if (status != LOFT_OK ||
            !BY_NUM(fabsl(decimal(r, row_text(r, "K"))) > 0x1p30L, false, false))
            row_complain(r, "no curvature");
        return;
    }
    if (r->inexact > 0) {
        expect_own_curvature(r, &p, at, exact_acc(k.gauss));
        return;
    }
    r->largest = fmaxl(1, fabsl(decimal(r, row_text(r, "K"))));
    const long double near = distance_from(&p.domain, at),
                      off = 64 * error_of(p.which, &p.domain) / fminl(1, near * near);
    expect_wide(r, "K", k.gauss,
                (law){ .lsb = 0x1p-16L + r->largest * (0x1p-20L + off * 65536),
                       .gain = 1,
                       .roundings = 0x1p21L + off * 0x1p52L });
}

/* E: what harmonic coordinates err by. */
const vector_system vectors_gb[] = {
    { "gb_params", "polygon,which,n,type,x,y,parameters", gb_params,
      "q16 2^-33 + 2^-40; floats 256 ulp of double; and E / (1 - h) or n E; blank where free: "
      "exact" },
    { "gb_net", "case,n,d,which,polygon,side,j,k,X,Y,Z", gb_net,
      "points of two ribbons, corners: exact" },
    { "gb_eval", "case,type,x,y,X,Y,Z,B0", gb_eval,
      "q16 1/2 LSB + 2^-12 LSB, B0 2^-32; floats 512 ulp of double; and 16 E of the largest "
      "coordinate" },
    { "gb_curvature", "case,x,y,K", gb_curvature,
      "q16 2^-32 + 2^-36 |K|; floats 2^-31 max(1, |K|); and 64 E max(1, |K|) over the square of "
      "the distance from the edges" },
    { 0 }
};
