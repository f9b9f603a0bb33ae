/* lib/surface/tensor/gregory.c
 * SPDX-License-Identifier: MIT
 *
 * Let s be the distance from the side u = 0 or u = 1 of the corner, t that from v = 0 or 1, and
 * a(x) = x (1 - x)^2 3 the Bernstein polynomial of the inner point. Its weight a(s) a(t) is shared:
 *
 *     9 (1 - s)^2 (1 - t)^2 f(s, t)       f = s^2 t / (s + t)     of the side along u
 *                                         f = s t^2 / (s + t)     of the side along v
 *
 * The derivatives of s^2 t / (s + t) have no differences: nothing cancels.
 *
 *     f_s  = s t (s + 2 t) / (s + t)^2    f_t  = s^3 / (s + t)^2
 *     f_ss = 2 t^3 / (s + t)^3            f_st = s^2 (s + 3 t) / (s + t)^3
 *                                         f_tt = -2 s^3 / (s + t)^3
 *
 * At the corner f and its first derivatives are 0. All weights are sums of at most four products of
 * at most twelve factors, each off by 2^-61 of itself in q16. First derivatives of the weights sum
 * to at most 12, second ones to at most 90, positive and negative ones.
 */
#include "surface/tensor/gregory.h"

static bool unit_inside(loft_unit t) { return t >= 0 && t <= LOFT_UNIT(1); }

enum loft_status loft_gregory_init(loft_gregory *g, const loft_vec p[])
{
    const loft_sci limit = loft_sci_power2(100);

    for (int k = 0; k < LOFT_GREGORY_POINTS; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            if (!loft_sci_less(loft_sci_abs(loft_sci_from_real(p[k].axis[i])), limit))
                return LOFT_ERR_RANGE;
    g->p = p;
    return LOFT_OK;
}


/* Weights */

/* The derivative of this order of B_k, degree 3, at t. */
static loft_sci cubic_weight(unsigned k, unsigned order, loft_sci t)
{
    loft_sci c[4] = { loft_sci_zero(), loft_sci_zero(), loft_sci_zero(), loft_sci_zero() };

    c[k] = loft_sci_one();
    return loft_sci_deriv(c, 3, order, t);
}

typedef struct {
    loft_sci x[3];      /* a value, its first and its second derivative */
} series;

/* 3 (1 - x)^2 and its derivatives. */
static series outer_part(loft_sci x)
{
    const loft_sci y = loft_sci_sub(loft_sci_one(), x), three = loft_sci_from_int(3);
    const series w = { { loft_sci_mul(three, loft_sci_mul(y, y)),
                         loft_sci_mul(loft_sci_from_int(-6), y), loft_sci_from_int(6) } };
    return w;
}

/* The derivative of order j by s and k by t of s^2 t / (s + t), j + k <= 2; at 0, 0 all are 0. */
static loft_sci shared_part(unsigned j, unsigned k, loft_sci s, loft_sci t)
{
    const loft_sci sum = loft_sci_add(s, t), two = loft_sci_from_int(2);
    loft_sci x;

    if (loft_sci_sign(sum) == 0)
        return sum;
    if (j + k == 0)
        x = loft_sci_mul(loft_sci_mul(s, s), t);
    else if (j == 1 && k == 0)
        x = loft_sci_mul(loft_sci_mul(s, t), loft_sci_add(s, loft_sci_mul(two, t)));
    else if (j == 2)
        x = loft_sci_mul(two, loft_sci_pow(t, 3));
    else if (j == 1)
        x = loft_sci_mul(loft_sci_mul(s, s),
                         loft_sci_add(s, loft_sci_mul(loft_sci_from_int(3), t)));
    else
        x = k == 1 ? loft_sci_pow(s, 3) : loft_sci_mul(loft_sci_from_int(-2), loft_sci_pow(s, 3));
    return loft_sci_div(x, loft_sci_pow(sum, 1 + j + k));
}

/* The derivative of order j by s and k by t of the weight of the inner point of the side along u,
 * or along v, which is the same with s and t in each other's place. */
static loft_sci inner_weight(bool along_v, unsigned j, unsigned k, loft_sci s, loft_sci t)
{
    const series p = outer_part(s), q = outer_part(t);
    static const uint8_t choose[3][3] = { { 1, 0, 0 }, { 1, 1, 0 }, { 1, 2, 1 } };
    loft_sci sum = loft_sci_zero();

    for (unsigned a = 0; a <= j; a++)
        for (unsigned b = 0; b <= k; b++) {
            const loft_sci f = along_v ? shared_part(b, a, t, s) : shared_part(a, b, s, t);
            const loft_sci term = loft_sci_mul(f, loft_sci_mul(p.x[j - a], q.x[k - b]));
            sum = loft_sci_add(sum,
                               loft_sci_mul(term, loft_sci_from_int(choose[j][a] * choose[k][b])));
        }
    return sum;
}

/* The place of b_ij, and of the other point of an inner one. */
static unsigned other_of(unsigned i, unsigned j) { return 16 + 2 * (i - 1) + j - 1; }

static bool is_inner(unsigned i) { return i == 1 || i == 2; }

static void all_weights(unsigned j, unsigned k, loft_sci u, loft_sci v, loft_sci out[])
{
    const loft_sci s[2] = { u, loft_sci_sub(loft_sci_one(), u) },
                   t[2] = { v, loft_sci_sub(loft_sci_one(), v) };

    for (unsigned a = 0; a < 4; a++) {
        const loft_sci row = cubic_weight(a, j, u);
        for (unsigned b = 0; b < 4; b++) {
            if (!is_inner(a) || !is_inner(b)) {
                out[4 * a + b] = loft_sci_mul(row, cubic_weight(b, k, v));
                continue;
            }
            const bool minus = ((a == 2 ? j : 0) + (b == 2 ? k : 0)) % 2 != 0;
            const loft_sci one = inner_weight(false, j, k, s[a - 1], t[b - 1]),
                           two = inner_weight(true, j, k, s[a - 1], t[b - 1]);
            out[4 * a + b] = minus ? loft_sci_neg(one) : one;
            out[other_of(a, b)] = minus ? loft_sci_neg(two) : two;
        }
    }
}


/* Points */

/* The sum of the points relative to the first one. */
static void sum_of_points(const loft_gregory *g, const loft_sci weight[], loft_sci out[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_sci origin = loft_sci_from_real(g->p[0].axis[i]);
        out[i] = loft_sci_zero();
        for (unsigned p = 1; p < LOFT_GREGORY_POINTS; p++)
            out[i] = loft_sci_add(
                out[i],
                loft_sci_mul(weight[p], loft_sci_sub(loft_sci_from_real(g->p[p].axis[i]), origin)));
    }
}

/* True if (u, v) is a corner with two different points inside. */
static bool has_no_second(const loft_gregory *g, loft_unit u, loft_unit v)
{
    const bool ends = (u <= 0 || u >= LOFT_UNIT(1)) && (v <= 0 || v >= LOFT_UNIT(1));
    const unsigned i = u <= 0 ? 1 : 2, j = v <= 0 ? 1 : 2;

    return ends && !loft_vec_equal(g->p[4 * i + j], g->p[other_of(i, j)]);
}

/* At a corner with one point inside, the limits of both weights of it are not there, but their sum:
 * that of the bicubic patch. */
static void slope_at(const loft_gregory *g, unsigned j, unsigned k, loft_unit u, loft_unit v,
                     loft_sci out[LOFT_AXES])
{
    const loft_sci x = loft_sci_from_unit(u), y = loft_sci_from_unit(v);
    loft_sci weight[LOFT_GREGORY_POINTS];
    const bool ends = (u <= 0 || u >= LOFT_UNIT(1)) && (v <= 0 || v >= LOFT_UNIT(1));

    all_weights(j, k, x, y, weight);
    for (unsigned a = 1; a < 3 && ends; a++)
        for (unsigned b = 1; b < 3; b++) {
            weight[4 * a + b] = loft_sci_mul(cubic_weight(a, j, x), cubic_weight(b, k, y));
            weight[other_of(a, b)] = loft_sci_zero();
        }
    sum_of_points(g, weight, out);
}

enum loft_status loft_gregory_deriv(const loft_gregory *g, unsigned j, unsigned k, loft_unit u,
                                    loft_unit v, loft_vec *out)
{
    loft_sci x[LOFT_AXES];
    loft_acc sum[LOFT_AXES];

    if (!unit_inside(u) || !unit_inside(v) || j > 2 || k > 2 || j + k > 2)
        return LOFT_ERR_ARG;
    if (j + k == 2 && has_no_second(g, u, v))
        return LOFT_SINGULAR;
    slope_at(g, j, k, u, v, x);
    for (int i = 0; i < LOFT_AXES; i++) {
        if (j + k == 0)
            x[i] = loft_sci_add(x[i], loft_sci_from_real(g->p[0].axis[i]));
        if (!loft_sci_to_acc(x[i], &sum[i]))
            return LOFT_ERR_RANGE;
    }
    return loft_vec_round(sum, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

enum loft_status loft_gregory_eval(const loft_gregory *g, loft_unit u, loft_unit v, loft_vec *out)
{
    return loft_gregory_deriv(g, 0, 0, u, v, out);
}

static enum loft_status gregory_at(const void *surface, loft_unit u, loft_unit v, loft_vec *out)
{
    return loft_gregory_eval((const loft_gregory *)surface, u, v, out);
}

static enum loft_status gregory_slopes(const void *surface, loft_unit u, loft_unit v,
                                       loft_differential *out)
{
    return loft_gregory_differential((const loft_gregory *)surface, u, v, out);
}

loft_surface loft_surface_from_gregory(const loft_gregory *g)
{
    const loft_surface made = { gregory_at, g, LOFT_SURFACE_SQUARE, gregory_slopes };
    return made;
}

static loft_sci width_of(const loft_gregory *g)
{
    loft_sci most = loft_sci_zero();

    for (int p = 1; p < LOFT_GREGORY_POINTS; p++)
        for (int i = 0; i < LOFT_AXES; i++) {
            const loft_sci d = loft_sci_abs(loft_sci_sub(loft_sci_from_real(g->p[p].axis[i]),
                                                         loft_sci_from_real(g->p[0].axis[i])));
            if (loft_sci_less(most, d))
                most = d;
        }
    return loft_sci_mul(most, loft_sci_from_int(3));
}

enum loft_status loft_gregory_differential(const loft_gregory *g, loft_unit u, loft_unit v,
                                           loft_differential *out)
{
    if (!unit_inside(u) || !unit_inside(v))
        return LOFT_ERR_ARG;
    if (has_no_second(g, u, v))
        return LOFT_SINGULAR;
    slope_at(g, 1, 0, u, v, out->u);
    slope_at(g, 0, 1, u, v, out->v);
    slope_at(g, 2, 0, u, v, out->uu);
    slope_at(g, 1, 1, u, v, out->uv);
    slope_at(g, 0, 2, u, v, out->vv);
    out->width_u = out->width_v = width_of(g);
    return LOFT_OK;
}


/* From curves and slopes */

static enum loft_status cubic_of(const loft_bezier *b, loft_vec out[4])
{
    return b->degree > 3 ? LOFT_ERR_ARG : loft_bezier_elevate(b, 3u - b->degree, out);
}

/* p + d / 3, or p - d / 3. */
static enum loft_status third_from(loft_vec p, loft_vec d, bool back, loft_vec *out)
{
    loft_acc x[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc third = loft_acc_ratio(loft_to_acc(d.axis[i]), 3);
        x[i] = loft_to_acc(p.axis[i]) + (back ? -third : third);
    }
    return loft_vec_round(x, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

/* The side at v = end (or u = end): its four points, and its two inner points. */
static enum loft_status take_side(const loft_bezier *curve, const loft_bezier *slope, bool end,
                                  loft_vec side[4], loft_vec inner[2])
{
    loft_vec d[4];
    enum loft_status status = cubic_of(curve, side);

    if (status == LOFT_OK)
        status = cubic_of(slope, d);
    for (int k = 0; k < 2 && status == LOFT_OK; k++)
        status = third_from(side[k + 1], d[k + 1], end, &inner[k]);
    return status;
}

enum loft_status loft_gregory_from_coons(const loft_coons_bezier *c,
                                         loft_vec out[LOFT_GREGORY_POINTS])
{
    loft_vec side[4], inner[2];

    if (c->orders < 2)
        return LOFT_ERR_ARG;
    for (unsigned end = 0; end < 2; end++) {
        const enum loft_status status = take_side(&c->v[0][end], &c->v[1][end], end, side, inner);
        if (status != LOFT_OK)
            return status;
        for (unsigned j = 0; j < 4; j++)
            out[12 * end + j] = side[j];
        for (unsigned j = 1; j < 3; j++)
            out[other_of(1 + end, j)] = inner[j - 1];
    }
    for (unsigned end = 0; end < 2; end++) {
        const enum loft_status status = take_side(&c->u[0][end], &c->u[1][end], end, side, inner);
        if (status != LOFT_OK)
            return status;
        for (unsigned i = 0; i < 4; i++)
            out[4 * i + 3 * end] = side[i];
        for (unsigned i = 1; i < 3; i++)
            out[4 * i + 1 + end] = inner[i - 1];
    }
    return LOFT_OK;
}
