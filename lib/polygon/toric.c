/* lib/polygon/toric.c
 * SPDX-License-Identifier: MIT
 *
 * All terms are positive, so errors are relative: a power h^k errs by k times the error of h and at
 * most k roundings, h by the error of a cross product. Exponents: a product of heights is below
 * 2^900 and, since h >= 2^-16 in q16, above 2^-16 * 900. In floats the smallest terms may vanish.
 * That changes no point of the patch: near a vertex the term of that vertex is a product of the
 * other heights.
 */
#include "polygon/toric.h"
#include "polygon/weighted_sum.h"      /* loft_weighted_sum */

#define BITS_MAX 900

static unsigned bit_length(int h)
{
    unsigned count = 0;

    for (; h; h >>= 1)
        count++;
    return count;
}

/* The bits of the product of heights at whole point l, if each height were the largest in the
 * polygon. */
static unsigned product_bits(const loft_lattice_polygon *lattice, const int highest[], loft_whole l)
{
    unsigned sum = 0;

    for (unsigned i = 0; i < lattice->sides; i++)
        sum += (unsigned)loft_lattice_polygon_height(lattice, i, l) * bit_length(highest[i]);
    return sum;
}

static bool lattice_valid(const loft_lattice_polygon *lattice)
{
    int highest[LOFT_SIDES_MAX] = { 0 };
    loft_whole l;

    for (unsigned i = 0; i < lattice->sides; i++)
        for (unsigned k = 0; k < lattice->sides; k++) {
            const int h = loft_lattice_polygon_height(lattice, i, lattice->edge[k].from);
            if (h > highest[i])
                highest[i] = h;
        }
    loft_lattice_polygon_first(lattice, &l);
    do
        if (product_bits(lattice, highest, l) > BITS_MAX)
            return false;
    while (loft_lattice_polygon_next(lattice, &l));
    return true;
}

enum loft_status loft_toric_init(loft_toric *t, const loft_lattice_polygon *lattice,
                                 const loft_vec p[], const loft_real c[], const loft_real w[])
{
    const unsigned count = loft_lattice_polygon_count(lattice);

    for (unsigned k = 0; k < count; k++) {
        if ((w && !(w[k] >= LOFT_WEIGHT_MIN && w[k] <= LOFT_WEIGHT_MAX)) ||
            (c && !(c[k] > 0 && c[k] <= LOFT_REAL(32767))))
            return LOFT_ERR_RANGE;
        if (!loft_vec_valid(p[k]))
            return LOFT_ERR_RANGE;
    }
    if (!lattice_valid(lattice))
        return LOFT_ERR_RANGE;
    t->lattice = lattice;
    t->p = p;
    t->c = c;
    t->w = w;
    return LOFT_OK;
}

static loft_spot spot_of(loft_whole p)
{
    loft_spot s;

    for (int i = 0; i < 2; i++)
        s.at[i] = loft_real_from_int(p.at[i]);
    return s;
}

/* The heights of p, all exact in sign: the cross product of an edge and the vector to p, over the
 * length of the edge. False when p is outside. */
static bool point_heights(const loft_lattice_polygon *l, loft_spot p, loft_sci h[])
{
    for (unsigned i = 0; i < l->sides; i++) {
        const loft_spot a = spot_of(l->edge[i].from),
                        b = spot_of(l->edge[i + 1u < l->sides ? i + 1 : 0].from);
        h[i] = loft_sci_div(loft_sci_cross(a.at, b.at, a.at, p.at),
                            loft_sci_from_int(l->edge[i].length));
        if (loft_sci_sign(h[i]) < 0)
            return false;
    }
    return true;
}

/* Each corner that is cut off has two vertices. */
static unsigned vertices_of(const loft_basepoint *b, loft_whole v[2 * 3])
{
    const int d = b->degree, cut[3] = { b->cut[0], b->cut[1], b->cut[2] };
    const int at[2 * 3][2] = { { 0, cut[0] },      { cut[0], 0 },      { d - cut[1], 0 },
                               { d - cut[1], cut[1] }, { cut[2], d - cut[2] }, { 0, d - cut[2] } };
    unsigned count = 0;

    for (unsigned k = 0; k < 2 * 3; k++) {
        if (k % 2 == 1 && cut[k / 2] == 0)
            continue;
        v[count].at[0] = (int8_t)at[k][0];
        v[count++].at[1] = (int8_t)at[k][1];
    }
    return count;
}

enum loft_status loft_toric_from_basepoint(const loft_basepoint *b, loft_lattice_polygon *lattice,
                                           loft_vec p[], loft_real c[], loft_real w[],
                                           loft_toric *t)
{
    loft_whole v[2 * 3], l;
    unsigned k = 0;
    const enum loft_status status = loft_lattice_polygon_init(lattice, v, vertices_of(b, v));

    if (status != LOFT_OK)
        return status;
    loft_lattice_polygon_first(lattice, &l);
    do {
        const uint8_t power[3] = { (uint8_t)(b->degree - l.at[0] - l.at[1]), (uint8_t)l.at[0],
                                   (uint8_t)l.at[1] };
        const unsigned rank = loft_multiindex_rank(power, 3);
        p[k] = b->p[rank];
        w[k] = b->w[rank];
        c[k++] = loft_real_from_int(loft_multiindex_multinomial(power, 3));
    } while (loft_lattice_polygon_next(lattice, &l));
    return loft_toric_init(t, lattice, p, c, w);
}

loft_sci loft_toric_factor(const loft_toric *t, unsigned k)
{
    const loft_sci c = t->c ? loft_sci_from_real(t->c[k]) : loft_sci_one();
    return t->w ? loft_sci_mul(c, loft_sci_from_real(t->w[k])) : c;
}

enum loft_status loft_toric_eval(const loft_toric *t, loft_spot p, loft_vec *out)
{
    const unsigned sides = t->lattice->sides;
    loft_sci h[LOFT_SIDES_MAX];
    loft_weighted_sum sum;
    loft_whole l;
    unsigned k = 0;

    if (!loft_spot_valid(p) || !point_heights(t->lattice, p, h))
        return LOFT_ERR_RANGE;
    loft_weighted_sum_start(&sum);
    loft_lattice_polygon_first(t->lattice, &l);
    do {
        loft_sci weight = loft_toric_factor(t, k);
        for (unsigned i = 0; i < sides && loft_sci_sign(weight); i++)
            weight = loft_sci_mul(weight, loft_sci_pow(h[i], (unsigned)loft_lattice_polygon_height(
                                                                 t->lattice, i, l)));
        if (loft_sci_sign(weight))
            loft_weighted_sum_add(&sum, &t->p[k], weight);
        k++;
    } while (loft_lattice_polygon_next(t->lattice, &l));
    return loft_weighted_sum_project(&sum, out);
}


/* The curves along the edges */

/* The index of whole point l among the control points. */
static unsigned place_of(const loft_lattice_polygon *lattice, loft_whole l)
{
    loft_whole q;
    unsigned k = 0;

    loft_lattice_polygon_first(lattice, &q);
    for (; q.at[0] != l.at[0] || q.at[1] != l.at[1]; k++)
        if (!loft_lattice_polygon_next(lattice, &q))
            break;
    return k;
}

static loft_whole edge_point(const loft_lattice_edge *e, unsigned step)
{
    loft_whole l;

    l.at[0] = (int8_t)(e->from.at[0] + (int)step * e->normal.at[1]);
    l.at[1] = (int8_t)(e->from.at[1] - (int)step * e->normal.at[0]);
    return l;
}

/* Scale the weights for loft_rational_weights: the largest to 128..256, and all times
 * LOFT_PROJECT. */
static enum loft_status scale_weights(loft_sci w[], unsigned degree, loft_weighted out[])
{
    const loft_sci two = loft_sci_from_int(2), top = loft_sci_from_int(256);
    loft_sci largest = w[0], least = w[0], scale = loft_sci_from_int(LOFT_PROJECT);
    loft_acc wide[LOFT_DEGREE_MAX + 1];

    for (unsigned k = 1; k <= degree; k++) {
        if (loft_sci_less(largest, w[k]))
            largest = w[k];
        if (loft_sci_less(w[k], least))
            least = w[k];
    }
    for (; !loft_sci_less(largest, top); largest = loft_sci_div(largest, two))
        scale = loft_sci_div(scale, two);
    for (; loft_sci_less(loft_sci_mul(largest, two), top); largest = loft_sci_mul(largest, two))
        scale = loft_sci_mul(scale, two);
    if (loft_sci_less(loft_sci_mul(least, scale), loft_sci_from_int(LOFT_PROJECT / 256)))
        return LOFT_ERR_RANGE;
    for (unsigned k = 0; k <= degree; k++)
        if (!loft_sci_to_acc(loft_sci_mul(w[k], scale), &wide[k]))
            return LOFT_ERR_RANGE;
    loft_rational_weights(wide, degree, out);
    return LOFT_OK;
}

enum loft_status loft_toric_edge(const loft_toric *t, unsigned edge, loft_weighted out[])
{
    loft_sci w[LOFT_DEGREE_MAX + 1];

    if (edge >= t->lattice->sides || t->lattice->edge[edge].length > LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    const unsigned m = t->lattice->edge[edge].length;
    for (unsigned step = 0; step <= m; step++) {
        const unsigned k = place_of(t->lattice, edge_point(&t->lattice->edge[edge], step));
        w[step] = loft_sci_div(loft_toric_factor(t, k), loft_sci_from_int(loft_binomial(m, step)));
        out[step].p = t->p[k];
    }
    return scale_weights(w, m, out);
}

/* A / (A + B) of the products of heights with positive and with negative exponents. At the first
 * vertex the height of the edge before is 0 and its exponent is positive. At the second vertex the
 * height of the edge after is 0 and its exponent is negative. */
enum loft_status loft_toric_parameter(const loft_toric *t, unsigned edge, loft_spot p,
                                      loft_unit *out)
{
    const loft_lattice_polygon *lattice = t->lattice;
    loft_sci h[LOFT_SIDES_MAX], product[2] = { loft_sci_one(), loft_sci_one() };
    loft_acc share = 0;

    if (edge >= lattice->sides || !loft_spot_valid(p) || !point_heights(lattice, p, h) ||
        loft_sci_sign(h[edge]))
        return LOFT_ERR_ARG;
    const loft_whole *n = &lattice->edge[edge].normal;
    for (unsigned j = 0; j < lattice->sides; j++) {
        const loft_whole *e = &lattice->edge[j].normal;
        const int power = e->at[0] * n->at[1] - e->at[1] * n->at[0];
        if (j != edge)
            product[power < 0] = loft_sci_mul(
                product[power < 0], loft_sci_pow(h[j], (unsigned)(power < 0 ? -power : power)));
    }
    if (!loft_sci_to_acc(loft_sci_div(product[0], loft_sci_add(product[0], product[1])), &share))
        return LOFT_ERR_RANGE;
    *out = loft_unit_ratio(share, loft_to_acc(LOFT_REAL(1)));
    return LOFT_OK;
}
