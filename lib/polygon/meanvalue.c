/* lib/polygon/meanvalue.c
 * SPDX-License-Identifier: MIT
 */
#include "polygon/meanvalue.h"

static unsigned next_vertex(unsigned i, unsigned sides) { return i + 1 < sides ? i + 1 : 0; }

/* The tangent of half the signed angle from d_i to d_(i+1), seen from p:
 *
 *     cross / (r_i r_(i+1) + dot)    or    (r_i r_(i+1) - dot) / cross
 *
 * The form that adds two numbers of one sign is taken. The cross product is 0 only where the angle
 * is 0, because p is not on the edge. */
static loft_sci half_tangent(const loft_sci d[2][2], loft_sci r0, loft_sci r1, loft_sci cross)
{
    const loft_sci dot = loft_sci_add(loft_sci_mul(d[0][0], d[1][0]),
                                      loft_sci_mul(d[0][1], d[1][1]));
    const loft_sci rr = loft_sci_mul(r0, r1);

    if (loft_sci_sign(dot) < 0)
        return loft_sci_div(loft_sci_sub(rr, dot), cross);
    return loft_sci_div(cross, loft_sci_add(rr, dot));
}

/* w_i = (t_(i-1) + t_i) / r_i, phi_i = w_i / sum w. The sum of a simple polygon is never 0
 * (Hormann, Floater: it is positive inside and negative outside).
 *
 * A tangent errs by eight roundings of itself, in floats by the error of the cross product, and by
 * the error of the dot product: at most 2 roundings of r r', which is at most the sum it is part
 * of. The two tangents may cancel, and outside so may the w_i. So errors are multiplied by K = sum
 * (|t_(i-1)| + |t_i|) / r_i over |sum w_i|, and in phi_i = w_i / sum w by (1 + |phi_i|) K. */
enum loft_status loft_meanvalue_eval(const loft_domain *d, loft_spot p, loft_sci phi[])
{
    loft_sci area[LOFT_SIDES_MAX], r[LOFT_SIDES_MAX], to[LOFT_SIDES_MAX][2], sum = loft_sci_zero();
    const unsigned n = d->sides;
    unsigned index = 0;

    if (!loft_spot_valid(p))
        return LOFT_ERR_RANGE;
    const enum loft_place place = loft_domain_place(d, p, area, &index);
    if (place == LOFT_AT_VERTEX)
        loft_domain_vertex(d, index, phi);
    if (place == LOFT_ON_EDGE)
        loft_domain_edge(d, p, index, phi);
    if (place == LOFT_AT_VERTEX || place == LOFT_ON_EDGE)
        return LOFT_OK;

    for (unsigned i = 0; i < n; i++) {
        for (int k = 0; k < 2; k++)
            to[i][k] = loft_sci_sub(loft_sci_from_real(d->v[i].at[k]), loft_sci_from_real(p.at[k]));
        r[i] = loft_sci_sqrt(
            loft_sci_add(loft_sci_mul(to[i][0], to[i][0]), loft_sci_mul(to[i][1], to[i][1])));
    }
    for (unsigned i = 0; i < n; i++) {
        const unsigned j = next_vertex(i, n);
        const loft_sci both[2][2] = { { to[i][0], to[i][1] }, { to[j][0], to[j][1] } };
        area[i] = half_tangent(both, r[i], r[j], area[i]);
    }
    for (unsigned i = 0; i < n; i++) {
        phi[i] = loft_sci_div(loft_sci_add(area[i ? i - 1 : n - 1], area[i]), r[i]);
        sum = loft_sci_add(sum, phi[i]);
    }
    for (unsigned i = 0; i < n; i++)
        phi[i] = loft_sci_div(phi[i], sum);
    return LOFT_OK;
}


/* Derivatives */

/* The tangent of an edge: t = above / below, from its ends as seen from p. `back` is true where the
 * angle is obtuse. */
typedef struct {
    loft_jet above, below;
    bool back;
} tangent;

static loft_jet jet_difference(loft_real from, loft_real to, bool along_y)
{
    const loft_sci minus = loft_sci_neg(loft_sci_one());
    loft_jet r = loft_jet_of(loft_sci_sub(loft_sci_from_real(to), loft_sci_from_real(from)));

    *(along_y ? &r.y : &r.x) = minus;
    return r;
}

static loft_jet product_sum(const loft_jet a[2], const loft_jet b[2])
{
    const loft_jet x = loft_jet_mul(&a[0], &b[0]), y = loft_jet_mul(&a[1], &b[1]);
    return loft_jet_add(&x, &y);
}

static void vertex_jets(const loft_domain *d, loft_spot p, unsigned i, loft_jet to[2])
{
    to[0] = jet_difference(p.at[0], d->v[i].at[0], false);
    to[1] = jet_difference(p.at[1], d->v[i].at[1], true);
}

/* The cross product is linear in p, so its derivatives are differences of the ends. */
static tangent tangent_at(const loft_domain *d, loft_spot p, unsigned i, const loft_jet r[],
                          loft_sci area)
{
    const unsigned j = next_vertex(i, d->sides);
    loft_jet a[2], b[2], cross = loft_jet_of(area);
    tangent t;

    vertex_jets(d, p, i, a);
    vertex_jets(d, p, j, b);
    cross.x = loft_sci_sub(a[1].f, b[1].f);
    cross.y = loft_sci_sub(b[0].f, a[0].f);
    const loft_jet dot = product_sum(a, b), rr = loft_jet_mul(&r[i], &r[j]);
    t.back = loft_sci_sign(dot.f) < 0;
    t.above = t.back ? loft_jet_sub(&rr, &dot) : cross;
    t.below = t.back ? cross : loft_jet_add(&rr, &dot);
    return t;
}

/* t of edge i, times the product of `below` over all edges that are seen at an obtuse angle. */
static loft_jet lifted_tangent(const tangent t[], unsigned sides, unsigned i)
{
    loft_jet r = t[i].back ? t[i].above : loft_jet_div(&t[i].above, &t[i].below);

    for (unsigned k = 0; k < sides; k++)
        if (k != i && t[k].back)
            r = loft_jet_mul(&r, &t[k].below);
    return r;
}

/* All coordinates sum to 1. Near a vertex, at a distance r, second derivatives of the tangents grow
 * as 1 / r^2, those of coordinates as 1 / r. The coordinates of the other vertices have the factor
 * r. That of the vertex, the largest, follows from the sum 1. */
static void complete_sum(loft_jet phi[], unsigned sides)
{
    loft_jet rest = loft_jet_of(loft_sci_zero());
    unsigned largest = 0;

    for (unsigned i = 1; i < sides; i++)
        if (loft_sci_less(phi[largest].f, phi[i].f))
            largest = i;
    for (unsigned i = 0; i < sides; i++)
        if (i != largest)
            rest = loft_jet_sub(&rest, &phi[i]);
    rest.f = phi[largest].f;
    phi[largest] = rest;
}

/* Near an edge its tangent is unbounded, and so are the derivatives of all w_i. Their product with
 * the cross product of that edge is finite. Such an edge is seen at an obtuse angle. So all w_i are
 * multiplied by `below` of all edges seen at an obtuse angle: the products are finite, also on the
 * edges, and have the same quotients. Inside a convex polygon there are at most three such
 * edges. */
enum loft_status loft_meanvalue_jet(const loft_domain *d, loft_spot p, loft_jet phi[])
{
    loft_sci area[LOFT_SIDES_MAX];
    loft_jet r[LOFT_SIDES_MAX], sum = loft_jet_of(loft_sci_zero());
    tangent t[LOFT_SIDES_MAX];
    const unsigned n = d->sides;
    unsigned index = 0;

    if (!loft_spot_valid(p))
        return LOFT_ERR_RANGE;
    if (loft_domain_place(d, p, area, &index) == LOFT_AT_VERTEX)
        return LOFT_SINGULAR;
    for (unsigned i = 0; i < n; i++) {
        loft_jet to[2];
        vertex_jets(d, p, i, to);
        const loft_jet square = product_sum(to, to);
        r[i] = loft_jet_sqrt(&square);
    }
    for (unsigned i = 0; i < n; i++)
        t[i] = tangent_at(d, p, i, r, area[i]);
    for (unsigned i = 0; i < n; i++) {
        const loft_jet one = lifted_tangent(t, n, i ? i - 1 : n - 1), two = lifted_tangent(t, n, i),
                       both = loft_jet_add(&one, &two);
        phi[i] = loft_jet_div(&both, &r[i]);
        sum = loft_jet_add(&sum, &phi[i]);
    }
    for (unsigned i = 0; i < n; i++)
        phi[i] = loft_jet_div(&phi[i], &sum);
    complete_sum(phi, n);
    return LOFT_OK;
}
