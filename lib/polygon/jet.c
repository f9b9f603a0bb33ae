/* lib/polygon/jet.c
 * SPDX-License-Identifier: MIT
 *
 *     (a b)_x  = a_x b + a b_x
 *     (a b)_xx = a_xx b + 2 a_x b_x + a b_xx
 *     (a b)_xy = a_xy b + a_x b_y + a_y b_x + a b_xy
 *
 * A quotient q = a / b solves q b = a, and a root r solves r r = a: the same lines, solved for the
 * derivatives of q and r.
 */
#include "polygon/jet.h"

static loft_sci mul(loft_sci a, loft_sci b)             { return loft_sci_mul(a, b); }
static loft_sci twice(loft_sci a)                       { return loft_sci_add(a, a); }
loft_jet loft_jet_of(loft_sci c)
{
    const loft_sci none = loft_sci_zero();
    const loft_jet r = { c, none, none, none, none, none };
    return r;
}

loft_jet loft_jet_add(const loft_jet *a, const loft_jet *b)
{
    const loft_jet r = { loft_sci_add(a->f, b->f),   loft_sci_add(a->x, b->x),
                         loft_sci_add(a->y, b->y),   loft_sci_add(a->xx, b->xx),
                         loft_sci_add(a->xy, b->xy), loft_sci_add(a->yy, b->yy) };
    return r;
}

loft_jet loft_jet_scale(const loft_jet *a, loft_sci c)
{
    const loft_jet r = { mul(a->f, c),  mul(a->x, c),  mul(a->y, c),
                         mul(a->xx, c), mul(a->xy, c), mul(a->yy, c) };
    return r;
}

loft_jet loft_jet_sub(const loft_jet *a, const loft_jet *b)
{
    const loft_jet r = { loft_sci_sub(a->f, b->f),   loft_sci_sub(a->x, b->x),
                         loft_sci_sub(a->y, b->y),   loft_sci_sub(a->xx, b->xx),
                         loft_sci_sub(a->xy, b->xy), loft_sci_sub(a->yy, b->yy) };
    return r;
}

/* a b' + a' b. */
static loft_sci product_rule(loft_sci a, loft_sci a_x, loft_sci b, loft_sci b_x)
{
    return loft_sci_add(mul(a, b_x), mul(a_x, b));
}

loft_jet loft_jet_mul(const loft_jet *a, const loft_jet *b)
{
    const loft_sci xx = twice(mul(a->x, b->x)), xy = product_rule(a->x, a->y, b->x, b->y),
                   yy = twice(mul(a->y, b->y));
    const loft_jet r = { mul(a->f, b->f),
                         product_rule(a->f, a->x, b->f, b->x),
                         product_rule(a->f, a->y, b->f, b->y),
                         loft_sci_add(product_rule(a->f, a->xx, b->f, b->xx), xx),
                         loft_sci_add(product_rule(a->f, a->xy, b->f, b->xy), xy),
                         loft_sci_add(product_rule(a->f, a->yy, b->f, b->yy), yy) };
    return r;
}

loft_jet loft_jet_div(const loft_jet *a, const loft_jet *b)
{
    loft_jet q;

    q.f = loft_sci_div(a->f, b->f);
    q.x = loft_sci_div(loft_sci_sub_product(a->x, q.f, b->x), b->f);
    q.y = loft_sci_div(loft_sci_sub_product(a->y, q.f, b->y), b->f);
    q.xx = loft_sci_div(
        loft_sci_sub_product(loft_sci_sub_product(a->xx, twice(q.x), b->x), q.f, b->xx), b->f);
    q.xy = loft_sci_div(
        loft_sci_sub_product(
            loft_sci_sub_product(loft_sci_sub_product(a->xy, q.x, b->y), q.y, b->x), q.f, b->xy),
        b->f);
    q.yy = loft_sci_div(
        loft_sci_sub_product(loft_sci_sub_product(a->yy, twice(q.y), b->y), q.f, b->yy), b->f);
    return q;
}

loft_jet loft_jet_sqrt(const loft_jet *a)
{
    const loft_sci half = loft_sci_from_real(LOFT_REAL(0.5));
    loft_jet r;

    r.f = loft_sci_sqrt(a->f);
    r.x = loft_sci_div(mul(half, a->x), r.f);
    r.y = loft_sci_div(mul(half, a->y), r.f);
    r.xx = loft_sci_div(loft_sci_sub_product(mul(half, a->xx), r.x, r.x), r.f);
    r.xy = loft_sci_div(loft_sci_sub_product(mul(half, a->xy), r.x, r.y), r.f);
    r.yy = loft_sci_div(loft_sci_sub_product(mul(half, a->yy), r.y, r.y), r.f);
    return r;
}

loft_jet loft_jet_pow(const loft_jet *a, unsigned k)
{
    loft_jet r = loft_jet_of(loft_sci_one()), square = *a;

    for (; k; k >>= 1) {
        if (k & 1)
            r = loft_jet_mul(&r, &square);
        if (k > 1)
            square = loft_jet_mul(&square, &square);
    }
    return r;
}
