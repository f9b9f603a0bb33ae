/* lib/surface/net_field_part.c -- parts of the polynomial of net_field.h, and integrals over them
 * SPDX-License-Identifier: MIT
 *
 * Factors w_ij c^i d^j with c, d > 0 change the parameters and not the surface, and M_kl (and those
 * of D and D X) become M_kl c^(k+1) d^(l+1). So on each part the sums of the weights at opposite
 * edges are made nearly equal: then w = w0 + e, |e| <= d, with d of the second order of the width.
 * Taylor's polynomial of w^-k, k = 3 or 4,
 *
 *     h = w0^-k - k w0^-(k+1) e,   |w^-k - h| <= k (k + 1) / 2 d^2 / min w^(k+2)
 *
 * is a polynomial of u and v, so int M h is a sum of integrals of products.
 */
#include "surface/net_field.h"
#include "basis/integral.h"     /* loft_binomial_sci */

#define SIDE (LOFT_DEGREE_MAX + 1)

static loft_sci sci_of(unsigned k) { return loft_sci_from_int((int32_t)k); }

/* The polynomial c[0], c[stride] .. on 0..t, or from its other end on t..1, by De Casteljau. */
static void cut_line(loft_sci c[], unsigned degree, unsigned stride, bool behind, loft_sci t)
{
    for (unsigned row = 0; row < degree; row++)
        for (unsigned k = 0; k < degree - row; k++) {
            loft_sci *to = &c[(behind ? k : degree - k) * stride],
                     *other = behind ? to + stride : to - stride;
            *to = behind ? loft_sci_lerp(*to, *other, t) : loft_sci_lerp(*other, *to, t);
        }
}

static void cut_net(loft_sci c[], unsigned m, unsigned n, unsigned each, unsigned along,
                    bool behind, loft_sci t)
{
    const unsigned row = (n + 1) * each;

    for (unsigned k = 0; k < row && along == 0; k++)
        cut_line(c + k, m, row, behind, t);
    for (unsigned i = 0; i <= m && along == 1; i++)
        for (unsigned k = 0; k < each; k++)
            cut_line(c + i * row + k, n, each, behind, t);
}

/* The piece k / 2^m .. (k + 1) / 2^m: what is before its end, and of that what is behind
 * k / (k + 1). */
static void cut_along(loft_net_field *x, unsigned along, loft_dyad piece)
{
    const loft_sci end = loft_sci_from_int((int32_t)piece.k + 1);

    for (int behind = 0; behind < 2; behind++) {
        const loft_sci t = behind ? loft_sci_div(loft_sci_from_int((int32_t)piece.k), end)
                                  : loft_sci_mul(end, loft_sci_power2(-(int)piece.level));
        if (behind ? piece.k == 0 : piece.k + 1 == UINT32_C(1) << piece.level)
            continue;
        cut_net(x->c, x->p, x->q, x->each, along, behind, t);
        if (x->weighted)
            cut_net(x->w, x->m, x->n, 1, along, behind, t);
    }
}

/* About r^(1/m), by Pade's quotient: any number above 0 does. */
static loft_sci root_near(loft_sci r, unsigned m)
{
    const loft_sci x = loft_sci_sub(r, loft_sci_one()), two = sci_of(2 * m);

    return loft_sci_div(loft_sci_add(two, loft_sci_mul(x, sci_of(m + 1))),
                        loft_sci_add(two, loft_sci_mul(x, sci_of(m - 1))));
}

/* Multiply row (along u) or column i by factor^(i + above). */
static void scale_net(loft_sci c[], unsigned m, unsigned n, unsigned each, unsigned along,
                      loft_sci factor, unsigned above)
{
    const unsigned row = (n + 1) * each;
    loft_sci power     = loft_sci_pow(factor, above);

    for (unsigned i = 0; i <= (along == 0 ? m : n); i++) {
        for (unsigned k = 0; k < (along == 0 ? row : (m + 1) * each); k++) {
            loft_sci *at = along == 0 ? &c[i * row + k] : &c[k / each * row + i * each + k % each];
            *at = loft_sci_mul(*at, power);
        }
        power = loft_sci_mul(power, factor);
    }
}

static void balance_weights(loft_net_field *x)
{
    for (unsigned along = 0; along < 2; along++) {
        const unsigned last = along == 0 ? x->m * (x->n + 1) : x->n,
                       step = along == 0 ? 1 : x->n + 1, count = along == 0 ? x->n : x->m;
        loft_sci sum[2] = { loft_sci_zero(), loft_sci_zero() };
        for (unsigned k = 0; k <= count; k++) {
            sum[0] = loft_sci_add(sum[0], x->w[k * step]);
            sum[1] = loft_sci_add(sum[1], x->w[last + k * step]);
        }
        const loft_sci factor = root_near(loft_sci_div(sum[0], sum[1]), along == 0 ? x->m : x->n);
        scale_net(x->w, x->m, x->n, 1, along, factor, 0);
        scale_net(x->c, x->p, x->q, x->each, along, factor, 1);
    }
}

void loft_net_field_cut(loft_net_field *x, const loft_dyad_box *part)
{
    for (unsigned k = 0; k < (x->p + 1) * (x->q + 1) * x->each; k++)
        x->c[k] = x->whole[k];
    for (unsigned k = 0; k < (x->m + 1) * (x->n + 1) && x->weighted; k++)
        x->w[k] = x->w_whole[k];
    for (unsigned along = 0; along < 2; along++)
        cut_along(x, along, part->n[along]);
    if (x->weighted)
        balance_weights(x);
}

static loft_sci square_of(const loft_sci x[], unsigned each)
{
    return each == 1 ? loft_sci_mul(x[0], x[0]) : loft_sci_dot3(x, x);
}

/* The mean square of the derivative along u or v, of the control net. */
static loft_sci change_of(const loft_sci c[], unsigned m, unsigned n, unsigned each, unsigned along)
{
    const unsigned step = along == 0 ? (n + 1) * each : each, rows = along == 0 ? m : m + 1,
                   columns = along == 0 ? n + 1 : n;
    loft_sci sum = loft_sci_zero(), d[3];

    for (unsigned i = 0; i < rows; i++)
        for (unsigned j = 0; j < columns; j++) {
            const loft_sci *at = c + (i * (n + 1) + j) * each;
            for (unsigned k = 0; k < each; k++)
                d[k] = loft_sci_sub(at[step + k], at[k]);
            sum = loft_sci_add(sum, square_of(d, each));
        }
    return rows * columns == 0 ? sum
                               : loft_sci_div(loft_sci_mul(sum, sci_of(along == 0 ? m * m : n * n)),
                                              sci_of(rows * columns));
}

/* Along u: 0, along v: 1. The weight counts as what it changes the quotient by. */
unsigned loft_net_field_longer(const loft_net_field *x)
{
    loft_sci change[2];

    for (unsigned along = 0; along < 2; along++) {
        change[along] = change_of(x->c, x->p, x->q, x->each, along);
        if (x->weighted)
            change[along] = loft_sci_add(
                loft_sci_mul(change[along], loft_sci_mul(x->w[0], x->w[0])),
                loft_sci_mul(
                    sci_of(x->power * x->power),
                    loft_sci_mul(square_of(x->c, x->each), change_of(x->w, x->m, x->n, 1, along))));
    }
    return loft_sci_less(change[0], change[1]);
}


// Weights
// -------

loft_net_weighing loft_net_field_weighing(const loft_net_field *x)
{
    loft_net_weighing r = { loft_sci_one(), loft_sci_zero(), loft_sci_one(), loft_sci_one(),
                   loft_sci_zero() };
    const loft_sci half = loft_sci_power2(-1);

    if (!x->weighted)
        return r;
    loft_sci low = x->w[0], high = x->w[0];
    for (unsigned k = 1; k < (x->m + 1) * (x->n + 1); k++) {
        low  = loft_sci_smaller(low, x->w[k]);
        high = loft_sci_larger(high, x->w[k]);
    }
    const loft_sci w0 = loft_sci_mul(half, loft_sci_add(low, high)),
                   d  = loft_sci_mul(half, loft_sci_sub(high, low));
    const unsigned k   = x->power;
    const loft_sci one = loft_sci_div(loft_sci_one(), low),
                   all = loft_sci_pow(loft_sci_div(loft_sci_one(), w0), k);
    r.first = loft_sci_mul(sci_of(k + 1), all);
    r.slope = loft_sci_neg(loft_sci_div(loft_sci_mul(sci_of(k), all), w0));
    r.most  = loft_sci_pow(one, k);
    r.least = loft_sci_pow(loft_sci_div(loft_sci_one(), high), k);
    r.rest  = loft_sci_mul(loft_sci_mul(sci_of(k * (k + 1) / 2), loft_sci_mul(d, d)),
                          loft_sci_pow(one, k + 2));
    return r;
}

/* int M h, by components. */
void loft_net_field_integral(const loft_net_field *x, const loft_net_weighing *by, loft_sci out[3])
{
    const unsigned p = x->p, q = x->q, m = x->m, n = x->n;
    const loft_sci mean = loft_sci_div(by->first, sci_of((p + 1) * (q + 1)));
    loft_sci row[SIDE];

    for (unsigned i = 0; i < 3; i++)
        out[i] = loft_sci_zero();
    for (unsigned k = 0; k <= p; k++) {
        for (unsigned j = 0; j <= n && x->weighted; j++) {
            row[j] = loft_sci_zero();
            for (unsigned i = 0; i <= m; i++)
                loft_sci_add_product(&row[j], x->with[0][k * (m + 1) + i], x->w[i * (n + 1) + j]);
        }
        for (unsigned l = 0; l <= q; l++) {
            loft_sci sum = loft_sci_zero(), share = mean;
            for (unsigned j = 0; j <= n && x->weighted; j++)
                loft_sci_add_product(&sum, x->with[1][l * (n + 1) + j], row[j]);
            loft_sci_add_product(&share, by->slope, sum);
            for (unsigned i = 0; i < x->each; i++)
                loft_sci_add_product(&out[i], share, x->c[(k * (q + 1) + l) * x->each + i]);
        }
    }
}


// Nodes
// -----

void loft_net_field_row(const loft_net_field *x, unsigned g, loft_net_row *out)
{
    const loft_sci *b = x->node[0] + g * (x->p + 1), *w = x->w_node[0] + g * (x->m + 1);

    for (unsigned l = 0; l <= x->q; l++)
        for (unsigned i = 0; i < x->each; i++) {
            out->c[l][i] = loft_sci_zero();
            for (unsigned k = 0; k <= x->p; k++)
                loft_sci_add_product(&out->c[l][i], b[k], x->c[(k * (x->q + 1) + l) * x->each + i]);
        }
    for (unsigned j = 0; j <= x->n && x->weighted; j++) {
        out->w[j] = loft_sci_zero();
        for (unsigned i = 0; i <= x->m; i++)
            loft_sci_add_product(&out->w[j], w[i], x->w[i * (x->n + 1) + j]);
    }
}

void loft_net_field_value(const loft_net_field *x, const loft_net_row *row, unsigned h,
                          loft_sci value[3], loft_sci *weight)
{
    const loft_sci *b = x->node[1] + h * (x->q + 1), *w = x->w_node[1] + h * (x->n + 1);

    for (unsigned i = 0; i < 3; i++)
        value[i] = loft_sci_zero();
    for (unsigned l = 0; l <= x->q; l++)
        for (unsigned i = 0; i < x->each; i++)
            loft_sci_add_product(&value[i], b[l], row->c[l][i]);
    *weight = x->weighted ? loft_sci_zero() : loft_sci_one();
    for (unsigned j = 0; j <= x->n && x->weighted; j++)
        loft_sci_add_product(weight, w[j], row->w[j]);
}


// Taylor coefficients
// -------------------

/* The largest size of differences of each order, of the lines of one component. */
static void largest_differences(const loft_sci c[], unsigned m, unsigned n, unsigned each,
                                unsigned along, loft_sci most[LOFT_NET_ORDER + 1])
{
    const unsigned degree = along == 0 ? m : n, lines = along == 0 ? n : m,
                   step = along == 0 ? (n + 1) * each : each,
                   next = along == 0 ? each : (n + 1) * each;
    loft_sci line[LOFT_NET_LINE];

    for (unsigned k = 0; k <= LOFT_NET_ORDER; k++)
        most[k] = loft_sci_zero();
    for (unsigned j = 0; j <= lines; j++)
        for (unsigned order = 0; order <= degree && order <= LOFT_NET_ORDER; order++)
            for (unsigned k = 0; k <= degree - order; k++) {
                line[k] = order == 0 ? c[j * next + k * step] : loft_sci_sub(line[k + 1], line[k]);
                most[order] = loft_sci_larger(most[order], loft_sci_abs(line[k]));
            }
}

void loft_net_field_taylor(const loft_net_field *x, bool of_weight, unsigned along,
                           loft_sci out[LOFT_NET_ORDER + 1])
{
    const unsigned m = of_weight ? x->m : x->p, n = of_weight ? x->n : x->q,
                   each = of_weight ? 1 : x->each, degree = along == 0 ? m : n;
    const loft_sci *c   = of_weight ? x->w : x->c;
    loft_sci most[3][LOFT_NET_ORDER + 1];

    for (unsigned i = 0; i < each; i++)
        largest_differences(c + i, m, n, each, along, most[i]);
    for (unsigned k = 0; k <= LOFT_NET_ORDER; k++) {
        const loft_sci size[3] = { most[0][k], each == 3 ? most[1][k] : loft_sci_zero(),
                                   each == 3 ? most[2][k] : loft_sci_zero() };
        out[k] = k > degree
                     ? loft_sci_zero()
                     : loft_sci_mul(loft_binomial_sci(degree, k),
                                    each == 1 ? size[0] : loft_sci_sqrt(loft_sci_dot3(size, size)));
    }
}
