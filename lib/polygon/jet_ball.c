/* lib/polygon/jet_ball.c
 * SPDX-License-Identifier: MIT
 *
 * Jets are polynomials in two variables, cut off after the second degree, and |a| has the absolute
 * values of a's coefficients. So |a b| <= |a| |b|, coefficient by coefficient, and
 *
 *     a b - A B = (a - A) b + A (b - B)       off: da (|B| + db) + |A| db
 *     a / b - A / B = ((a - A) - A / B (b - B)) / b
 *
 * With b = f + n, n without a constant, 1 / b is the sum of (-n)^k / f^(k+1), no coefficient of
 * which exceeds that of 1 / (least f - |n|).
 *
 *     sqrt b - sqrt B = (b - B) / (sqrt b + sqrt B)
 *
 * All coefficients of -sqrt(1 - n) but the first are positive: no coefficient of that quotient is
 * larger than in |b - B| / (2 sqrt(least f - |n|)).
 */
#include "polygon/jet_ball.h"

static loft_jet abs_of(const loft_jet *a)
{
    const loft_jet r = { loft_sci_abs(a->f),  loft_sci_abs(a->x),  loft_sci_abs(a->y),
                         loft_sci_abs(a->xx), loft_sci_abs(a->xy), loft_sci_abs(a->yy) };
    return r;
}

loft_jet loft_jet_ball_most(const loft_jet_ball *a)
{
    const loft_jet mid = abs_of(&a->mid);
    return loft_jet_add(&mid, &a->off);
}

loft_jet_ball loft_jet_ball_of(loft_sci c)
{
    const loft_jet_ball r = { loft_jet_of(c), loft_jet_of(loft_sci_zero()) };
    return r;
}

loft_jet_ball loft_jet_ball_add(const loft_jet_ball *a, const loft_jet_ball *b)
{
    const loft_jet_ball r = { loft_jet_add(&a->mid, &b->mid), loft_jet_add(&a->off, &b->off) };
    return r;
}

loft_jet_ball loft_jet_ball_sub(const loft_jet_ball *a, const loft_jet_ball *b)
{
    const loft_jet_ball r = { loft_jet_sub(&a->mid, &b->mid), loft_jet_add(&a->off, &b->off) };
    return r;
}

loft_jet_ball loft_jet_ball_scale(const loft_jet_ball *a, loft_sci c)
{
    const loft_jet_ball r = { loft_jet_scale(&a->mid, c),
                              loft_jet_scale(&a->off, loft_sci_abs(c)) };
    return r;
}

loft_jet_ball loft_jet_ball_mul(const loft_jet_ball *a, const loft_jet_ball *b)
{
    const loft_jet of_a = abs_of(&a->mid), of_b = loft_jet_ball_most(b),
                   left = loft_jet_mul(&a->off, &of_b), right = loft_jet_mul(&of_a, &b->off);
    const loft_jet_ball r = { loft_jet_mul(&a->mid, &b->mid), loft_jet_add(&left, &right) };
    return r;
}

loft_jet_ball loft_jet_ball_pow(const loft_jet_ball *a, unsigned k)
{
    loft_jet_ball r = loft_jet_ball_of(loft_sci_one()), square = *a;

    for (; k; k >>= 1) {
        if (k & 1)
            r = loft_jet_ball_mul(&r, &square);
        if (k > 1)
            square = loft_jet_ball_mul(&square, &square);
    }
    return r;
}

/* The least value, minus the largest coefficients of all else. */
static loft_jet least_of(const loft_jet_ball *b, loft_sci least)
{
    const loft_jet most = loft_jet_ball_most(b);
    loft_jet below = loft_jet_scale(&most, loft_sci_from_int(-1));

    below.f = least;
    return below;
}

/* No coefficient of 1 / b is larger. */
static loft_jet inverse_of(const loft_jet_ball *b, loft_sci least)
{
    const loft_jet one = loft_jet_of(loft_sci_one()), below = least_of(b, least);

    return loft_jet_div(&one, &below);
}

bool loft_jet_ball_div(const loft_jet_ball *a, const loft_jet_ball *b, loft_jet_ball *out)
{
    const loft_sci least = loft_sci_sub(b->mid.f, b->off.f);

    if (!(loft_sci_sign(least) > 0))
        return false;
    const loft_jet inverse = inverse_of(b, least), mid = loft_jet_div(&a->mid, &b->mid),
                   size = abs_of(&mid), moved = loft_jet_mul(&size, &b->off),
                   off = loft_jet_add(&a->off, &moved);
    out->mid = mid;
    out->off = loft_jet_mul(&off, &inverse);
    return true;
}

bool loft_jet_ball_sqrt(const loft_jet_ball *a, loft_jet_ball *out)
{
    const loft_sci least = loft_sci_sub(a->mid.f, a->off.f);

    if (!(loft_sci_sign(least) > 0))
        return false;
    const loft_jet below = least_of(a, least), root = loft_jet_sqrt(&below),
                   twice = loft_jet_scale(&root, loft_sci_from_int(2)), off = a->off;
    out->mid = loft_jet_sqrt(&a->mid);
    out->off = loft_jet_div(&off, &twice);
    return true;
}
