/* lib/polygon/spatch_triangle.c
 * SPDX-License-Identifier: MIT
 *
 * Wachspress coordinates are phi_i = w_i / sum w, w_i = C_i prod A_j over j not i - 1 or i, with
 * the areas of polygon/wachspress.c. A_j is linear: its Bernstein coefficients over a triangle are
 * its values at the corners, at the middle the mean of those at the vertices. So w_i is a product
 * of n - 2 linear polynomials, none negative in the polygon.
 *
 * De Casteljau's algorithm of the S-patch with w_i in place of phi_i,
 *
 *     V_l^r = sum over i of w_i V_(l + e_i)^(r - 1)
 *
 * gives the numerator from weights times points, and the denominator from the weights: one
 * polynomial of degree depth (n - 2) each. Coefficients times their multinomials make products
 * plain. All factors of the weights are positive or 0, so none cancels.
 */
#include "polygon/spatch_triangle.h"
#include "surface/triangle/triangle.h"      /* loft_triangle_place */

/* coefficients of all polynomials of one depth: most for 3 sides of depth 9 */
#define ROOM  315
#define CROSS 28        /* of w_i: degree 6 */

typedef struct {
    loft_sci w[LOFT_SIDES_MAX][CROSS];
    loft_sci now[ROOM], before[ROOM];
} work;

static unsigned points_of(unsigned degree) { return (degree + 1) * (degree + 2) / 2; }

/* out += a b, of degrees m and n */
static void add_product(const loft_sci a[], unsigned m, const loft_sci b[], unsigned n,
                        loft_sci out[])
{
    for (unsigned i = 0; i <= m; i++)
        for (unsigned j = 0; i + j <= m; j++)
            for (unsigned k = 0; k <= n; k++)
                for (unsigned l = 0; k + l <= n; l++) {
                    loft_sci *at = &out[loft_triangle_place(i + k, j + l)];
                    *at = loft_sci_add(*at, loft_sci_mul(a[loft_triangle_place(i, j)],
                                                         b[loft_triangle_place(k, l)]));
                }
}

static void clear(loft_sci c[], unsigned count)
{
    for (unsigned k = 0; k < count; k++)
        c[k] = loft_sci_zero();
}

static loft_sci area_at(const loft_domain *d, unsigned edge, unsigned vertex)
{
    const loft_spot *a = &d->v[edge], *b = &d->v[(edge + 1) % d->sides];
    return loft_sci_cross(a->at, b->at, a->at, d->v[vertex].at);
}

/* Twice the areas of edge j with the middle and the ends of `edge`, over that of the polygon. */
static void load_area(const loft_domain *d, unsigned j, unsigned edge, loft_sci size,
                      loft_sci out[3])
{
    const loft_sci n = loft_sci_from_int(d->sides);

    out[0] = loft_sci_zero();
    for (unsigned k = 0; k < d->sides; k++)
        out[0] = loft_sci_add(out[0], loft_sci_div(area_at(d, j, k), n));
    out[1] = area_at(d, j, edge);
    out[2] = area_at(d, j, (edge + 1) % d->sides);
    for (int k = 0; k < 3; k++)
        out[k] = loft_sci_div(out[k], size);
}

static void load_coordinates(const loft_domain *d, unsigned edge, work *x)
{
    const unsigned n = d->sides;
    loft_sci size    = loft_sci_zero(), area[LOFT_SIDES_MAX][3], product[CROSS];

    for (unsigned i = 0; i < n; i++)
        size = loft_sci_add(size, d->corner[i]);
    for (unsigned j = 0; j < n; j++)
        load_area(d, j, edge, size, area[j]);
    for (unsigned i = 0; i < n; i++) {
        unsigned degree = 0;
        x->w[i][0] = loft_sci_div(d->corner[i], size);
        for (unsigned j = 0; j < n; j++) {
            if (j == i || (j + 1) % n == i)
                continue;
            clear(product, points_of(degree + 1));
            add_product(x->w[i], degree, area[j], 1, product);
            degree++;
            for (unsigned k = 0; k < points_of(degree); k++)
                x->w[i][k] = product[k];
        }
    }
}

/* The polynomial of one axis, or of the weights (axis LOFT_AXES), in now[]. */
static void load_axis(const loft_spatch *s, int axis, work *x)
{
    const unsigned n = s->sides, step = n - 2;
    uint8_t l[LOFT_SIDES_MAX];

    for (unsigned k = 0; k < loft_multiindex_count(n, s->depth); k++) {
        x->now[k] = s->w ? loft_sci_from_real(s->w[k]) : loft_sci_one();
        if (axis < LOFT_AXES)
            x->now[k] = loft_sci_mul(x->now[k], loft_sci_from_real(s->p[k].axis[axis]));
    }
    for (unsigned r = 1; r <= s->depth; r++) {
        const unsigned size = points_of(r * step), old = points_of((r - 1) * step);
        unsigned at = 0;
        for (unsigned k = 0; k < loft_multiindex_count(n, s->depth - r + 1) * old; k++)
            x->before[k] = x->now[k];
        loft_multiindex_first(l, n, s->depth - r);
        do {
            clear(x->now + at, size);
            for (unsigned i = 0; i < n; i++) {
                l[i]++;
                add_product(x->w[i], step, x->before + loft_multiindex_rank(l, n) * old,
                            (r - 1) * step, x->now + at);
                l[i]--;
            }
            at += size;
        } while (loft_multiindex_next(l, n));
    }
}

/* degree! / (degree - j - k)! j! k! */
static loft_sci multinomial(unsigned degree, unsigned j, unsigned k)
{
    return loft_sci_from_int(loft_binomial(degree, j + k) * loft_binomial(j + k, k));
}

/* Weights with the largest one 255. */
static bool set_weights(const loft_sci w[], unsigned degree, loft_weighted out[])
{
    loft_sci most = loft_sci_zero();

    for (unsigned j = 0; j <= degree; j++)
        for (unsigned k = 0; j + k <= degree; k++)
            most = loft_sci_larger(
                most, loft_sci_div(w[loft_triangle_place(j, k)], multinomial(degree, j, k)));
    for (unsigned j = 0; j <= degree; j++)
        for (unsigned k = 0; j + k <= degree; k++) {
            const unsigned at = loft_triangle_place(j, k);
            loft_acc weight;
            if (!loft_sci_to_acc(loft_sci_div(loft_sci_mul(loft_sci_from_int(255), w[at]),
                                              loft_sci_mul(most, multinomial(degree, j, k))),
                                 &weight))
                return false;
            out[at].w = loft_acc_round(weight);
            if (!(out[at].w >= LOFT_WEIGHT_MIN))
                return false;
        }
    return true;
}

enum loft_status loft_spatch_triangle(const loft_spatch *s, const loft_domain *d, unsigned edge,
                                      loft_weighted out[])
{
    const unsigned degree = s->depth * (s->sides - 2u), count = points_of(degree);
    loft_sci w[LOFT_SPATCH_TRIANGLE_MAX];
    work x;

    if (degree > LOFT_DEGREE_MAX || d->sides != s->sides || !d->convex || edge >= s->sides)
        return LOFT_ERR_ARG;
    load_coordinates(d, edge, &x);
    load_axis(s, LOFT_AXES, &x);
    for (unsigned k = 0; k < count; k++)
        w[k] = x.now[k];
    if (!set_weights(w, degree, out))
        return LOFT_ERR_RANGE;
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        load_axis(s, axis, &x);
        for (unsigned k = 0; k < count; k++) {
            loft_acc at;
            if (!loft_sci_to_acc(loft_sci_div(x.now[k], w[k]), &at) || !loft_acc_valid(at))
                return LOFT_ERR_RANGE;
            out[k].p.axis[axis] = loft_acc_round(at);
        }
    }
    return LOFT_OK;
}
