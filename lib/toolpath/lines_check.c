/* lib/toolpath/lines_check.c -- the proof that a ball can cut a patch line by line
 * SPDX-License-Identifier: MIT
 *
 * It holds over each of some parts of the patch, with parameters of its own. |P_ab| is bounded by
 * the largest difference of order a, b of its net, N = P_u x P_v by its Bernstein coefficients: a
 * box of them with the centre c and the radius r. So |N| >= least, the larger of |c| - r and the
 * smallest coefficient of |N_z|. These must all have one sign: then the normal is upward.
 *
 * The curvatures toward a ball of radius x are not 1 / x as long as
 *
 *     1 - x (E K + G L - 2 F M) / |N|^3 + x^2 (L K - M^2) / |N|^4 > 0
 *
 *     E = P_u P_u    F = P_u P_v    G = P_v P_v    L = P_uu N    M = P_uv N    K = P_vv N
 *
 * and they are below where that holds from 0 to x. Each vector is known within a radius around a
 * centre, and so are the products. Then T is regular. Were a ball too large elsewhere, a smaller
 * one would touch at both ends of a diameter (Federer, Curvature measures, 1959; Aamari, Berenfeld,
 * Levrard, Optimal reach estimation, 2023): one of these normals would look down.
 *
 * nu = N (N N)^-1/2. Let |N^(k)| <= k! c_k |N| be the derivatives along v. Then the k-th derivative
 * of nu is at most k! times the coefficient of t^k in the series with A = 1 + c_1 t + c_2 t^2 ..
 *
 *     A (2 - A^2)^-1/2 = A (1 + D / 2 + 3/8 D^2 + 5/16 D^3 + 35/128 D^4 ..),  D = A^2 - 1
 *
 * because each coefficient of (N N)^-1/2 is a polynomial of those of N N, with positive
 * coefficients when the signs of D are made the same. The patch is cubic along v: its own fourth
 * derivative is 0. A cubic of Hermite over h leaves a function by at most h^4 / 384 of its fourth
 * derivative, a chord by h^2 / 8 of its second.
 */
#include "num/sci.h"
#include "toolpath/lines.h"

typedef struct {
    const loft_vec *p;
    unsigned m, n;
    loft_sci size[4][4];        /* |P_ab| */
    loft_sci centre[3], radius, least;
    loft_sci slack;             /* the error of a control point */
} part_bound;

static const unsigned char binomial[6][6] = {
    { 1 }, { 1, 1 }, { 1, 2, 1 }, { 1, 3, 3, 1 }, { 1, 4, 6, 4, 1 }, { 1, 5, 10, 10, 5, 1 }
};

static loft_sci times(loft_sci x, int32_t by) { return loft_sci_mul(x, loft_sci_from_int(by)); }

static int32_t falling(unsigned degree, unsigned order)
{
    int32_t factor = 1;

    for (unsigned k = 0; k < order; k++)
        factor *= (int32_t)(degree - k);
    return factor;
}

/* The difference of order a, b at i, j. */
static void difference_at(const part_bound *b, unsigned a, unsigned c, unsigned i, unsigned j,
                          loft_acc out[3])
{
    out[0] = out[1] = out[2] = 0;
    for (unsigned x = 0; x <= a; x++)
        for (unsigned y = 0; y <= c; y++) {
            const loft_vec *const p = &b->p[(i + x) * (b->n + 1) + j + y];
            const int32_t share = ((a + c - x - y) & 1 ? -1 : 1) * binomial[a][x] * binomial[c][y];
            for (int k = 0; k < 3; k++)
                out[k] += loft_to_acc(loft_vec_axis(p, k)) * share;
        }
}

/* What the errors of control points make of a difference of order a + b. */
static loft_sci slack_of(const part_bound *b, unsigned order)
{
    return times(b->slack, 1 << order);
}

static void bound_sizes(part_bound *b)
{
    for (unsigned a = 0; a < 4; a++)
        for (unsigned c = 0; c < 4; c++) {
            loft_acc most = 0, d[3];
            b->size[a][c] = loft_sci_zero();
            for (unsigned i = 0; i + a <= b->m && a + c > 0; i++)
                for (unsigned j = 0; j + c <= b->n; j++) {
                    difference_at(b, a, c, i, j, d);
                    most = loft_acc_max(most, loft_acc_hypot(d, 3));
                }
            most += loft_hypot_ulp(most);
            if (a + c > 0 && a <= b->m && c <= b->n)
                b->size[a][c] = times(loft_sci_add(loft_sci_of(most), slack_of(b, a + c)),
                                      falling(b->m, a) * falling(b->n, c));
        }
}

/* The coefficient i, j of P_u x P_v, divided by m n. */
static void normal_at(const part_bound *b, unsigned i, unsigned j, loft_acc out[3])
{
    const unsigned m = b->m, n = b->n;
    loft_acc sum[3] = { 0, 0, 0 }, u[3], v[3];

    for (unsigned x = i > m ? i - m : 0; x < m && x <= i; x++)
        for (unsigned y = j >= n ? j - n + 1 : 0; y <= n && y <= j; y++) {
            const int32_t share = binomial[m - 1][x] * binomial[m][i - x] * binomial[n][y] *
                                  binomial[n - 1][j - y];
            difference_at(b, 1, 0, x, y, u);
            difference_at(b, 0, 1, i - x, j - y, v);
            for (int k = 0; k < 3; k++) {
                const int p = (k + 1) % 3, q = (k + 2) % 3;
                sum[k] += (loft_prod(loft_acc_round(u[p]), loft_acc_round(v[q])) -
                           loft_prod(loft_acc_round(u[q]), loft_acc_round(v[p]))) *
                          share;
            }
        }
    for (int k = 0; k < 3; k++)
        out[k] = loft_acc_ratio(sum[k], binomial[2 * m - 1][i] * binomial[2 * n - 1][j]);
}

/* The box of the normals. Returns LOFT_LINES_FINE with b->least > 0, or what is wrong. */
static enum loft_lines_fault bound_normals(part_bound *b)
{
    loft_acc low[3], high[3], centre[3], half[3], at[3];

    for (unsigned i = 0; i < 2 * b->m; i++)
        for (unsigned j = 0; j < 2 * b->n; j++) {
            normal_at(b, i, j, at);
            for (int k = 0; k < 3; k++) {
                low[k] = i + j > 0 ? loft_acc_min(low[k], at[k]) : at[k];
                high[k] = i + j > 0 ? loft_acc_max(high[k], at[k]) : at[k];
            }
        }
    for (int k = 0; k < 3; k++) {
        centre[k] = loft_acc_mean(low[k], high[k]);
        half[k] = loft_acc_max(high[k] - centre[k], centre[k] - low[k]);
        b->centre[k] = times(loft_sci_of(centre[k]), (int32_t)(b->m * b->n));
    }
    const loft_acc from = loft_acc_hypot(centre, 3), reach = loft_acc_hypot(half, 3),
                   upright = loft_acc_max(low[2], -high[2]);
    /* an error of e in both factors, and the roundings of the coefficients and of the lengths */
    const loft_sci e = slack_of(b, 1), both = times(e, (int32_t)(b->m * b->n)),
                   blur = loft_sci_add(
                       loft_sci_add(loft_sci_mul(loft_sci_add(b->size[1][0], b->size[0][1]), both),
                                    loft_sci_mul(both, e)),
                       loft_sci_of(64 * loft_hypot_ulp(from + reach)));
    const int32_t mn = (int32_t)(b->m * b->n);
    const loft_sci flat = loft_sci_sub(times(loft_sci_of(upright), mn), blur);

    b->radius = loft_sci_add(times(loft_sci_of(reach), mn), blur);
    const loft_sci away = loft_sci_sub(times(loft_sci_of(from), mn), b->radius);
    if (loft_sci_sign(flat) <= 0)
        return loft_sci_sign(away) > 0 ? LOFT_LINES_OVERHANG : LOFT_LINES_NORMAL;
    b->least = loft_sci_larger(flat, away);
    return LOFT_LINES_FINE;
}

/* Vectors within a radius of one, and a number within `half` of one. */
typedef struct {
    loft_sci at[3], length, radius;
} around;
typedef struct {
    loft_sci mid, half;
} spread;

static void set_around(around *x, const loft_sci at[3], loft_sci radius)
{
    for (int k = 0; k < 3; k++)
        x->at[k] = at[k];
    x->length = loft_sci_sqrt(loft_sci_dot3(at, at));
    x->radius = radius;
}

/* P_ab. */
static void bound_derivative(const part_bound *b, unsigned a, unsigned c, around *out)
{
    const int32_t factor = a > b->m || c > b->n ? 0 : falling(b->m, a) * falling(b->n, c);
    loft_acc low[3] = { 0, 0, 0 }, high[3] = { 0, 0, 0 }, half[3], d[3];
    loft_sci at[3];

    for (unsigned i = 0; i + a <= b->m; i++)
        for (unsigned j = 0; j + c <= b->n; j++) {
            difference_at(b, a, c, i, j, d);
            for (int k = 0; k < 3; k++) {
                low[k] = i + j > 0 ? loft_acc_min(low[k], d[k]) : d[k];
                high[k] = i + j > 0 ? loft_acc_max(high[k], d[k]) : d[k];
            }
        }
    for (int k = 0; k < 3; k++) {
        const loft_acc centre = loft_acc_mean(low[k], high[k]);
        half[k] = loft_acc_max(high[k] - centre, centre - low[k]);
        at[k] = times(loft_sci_of(centre), factor);
    }
    const loft_acc reach = loft_acc_hypot(half, 3);
    set_around(out, at,
               times(loft_sci_add(loft_sci_of(reach + loft_hypot_ulp(reach)), slack_of(b, a + c)),
                     factor));
}

static spread product_of(const around *x, const around *y, int32_t sign)
{
    const spread r = { times(loft_sci_dot3(x->at, y->at), sign),
                      loft_sci_add(loft_sci_mul(x->length, y->radius),
                                    loft_sci_mul(loft_sci_add(y->length, y->radius), x->radius)) };
    return r;
}

static spread multiply(spread x, spread y)
{
    const spread r = { loft_sci_mul(x.mid, y.mid),
                      loft_sci_add(
                           loft_sci_mul(loft_sci_abs(x.mid), y.half),
                           loft_sci_mul(loft_sci_add(loft_sci_abs(y.mid), y.half), x.half)) };
    return r;
}

static spread add_range(spread x, spread y, int32_t by)
{
    const spread r = { loft_sci_add(x.mid, times(y.mid, by)),
                      loft_sci_add(x.half, times(y.half, by < 0 ? -by : by)) };
    return r;
}

static bool ball_fits(const part_bound *b, loft_real tool)
{
    const int32_t up = loft_sci_sign(b->centre[2]);
    const loft_sci radius = loft_sci_from_real(tool);
    around n, u, v, second;

    set_around(&n, b->centre, b->radius);
    bound_derivative(b, 1, 0, &u);
    bound_derivative(b, 0, 1, &v);
    bound_derivative(b, 2, 0, &second);
    const spread l = product_of(&second, &n, up);
    bound_derivative(b, 0, 2, &second);
    const spread k = product_of(&second, &n, up);
    bound_derivative(b, 1, 1, &second);
    const spread m = product_of(&second, &n, up),
                 sum = add_range(add_range(multiply(product_of(&u, &u, 1), k),
                                           multiply(product_of(&v, &v, 1), l), 1),
                                 multiply(product_of(&u, &v, 1), m), -2),
                 product = add_range(multiply(l, k), multiply(m, m), -1);
    /* 1 - t x + d x^2 for x = 0 .. radius */
    const loft_sci most = loft_sci_add(sum.mid, sum.half),
                   least = loft_sci_sub(product.mid, product.half),
                   far = loft_sci_sign(least) < 0 ? b->least : loft_sci_add(n.length, n.radius),
                   t = loft_sci_div(most, loft_sci_pow(b->least, 3)),
                   d = loft_sci_div(least, loft_sci_pow(far, 4)),
                   slope = loft_sci_sub_product(t, times(d, 2), radius);

    if (loft_sci_sign(t) <= 0 && loft_sci_sign(d) >= 0)
        return true;
    if (loft_sci_sign(d) > 0 && loft_sci_sign(slope) < 0)
        return loft_sci_less(loft_sci_mul(t, t), times(d, 4));
    return loft_sci_less(loft_sci_mul(radius, loft_sci_sub_product(t, d, radius)), loft_sci_one());
}

/* Coefficients 1..4 of the series of |N| / least along v, or along u. */
static void bound_normal_series(const part_bound *b, bool along_u, loft_sci c[5])
{
    static const unsigned char leibniz[4] = { 1, 2, 6, 24 };

    for (unsigned k = 1; k <= 4; k++) {
        loft_sci sum = loft_sci_zero();
        for (unsigned i = 0; i <= k; i++) {
            const unsigned a = along_u ? i + 1 : i, e = along_u ? k - i : k - i + 1;
            if (a > 3 || e > 3)
                continue;
            const loft_sci x = along_u ? b->size[a][0] : b->size[1][a],
                           y = along_u ? b->size[e][1] : b->size[0][e];
            sum = loft_sci_add(sum, times(loft_sci_mul(x, y), binomial[k][i]));
        }
        c[k] = loft_sci_div(sum, times(b->least, leibniz[k - 1]));
    }
}

/* out = x y to the order of t^4; x[0] = 0. */
static void multiply_series(const loft_sci x[5], const loft_sci y[5], loft_sci out[5])
{
    for (int k = 4; k >= 0; k--) {
        out[k] = loft_sci_zero();
        for (int i = 1; i <= k; i++)
            out[k] = loft_sci_add(out[k], loft_sci_mul(x[i], y[k - i]));
    }
}

/* The size of the derivative of this order of the unit normal. */
static loft_sci bound_unit(const loft_sci c[5], int order)
{
    static const unsigned char share[5] = { 128, 64, 48, 40, 35 };      /* / 128 */
    static const unsigned char factorial[5] = { 1, 1, 2, 6, 24 };
    loft_sci a[5], d[5], power[5], next[5], sum = loft_sci_zero();

    for (int k = 0; k < 5; k++) {
        a[k] = k > 0 ? c[k] : loft_sci_one();
        power[k] = k > 0 ? loft_sci_zero() : loft_sci_one();
    }
    for (int k = 0; k < 5; k++) {
        d[k] = loft_sci_zero();
        for (int i = 0; i <= k && k > 0; i++)
            d[k] = loft_sci_add(d[k], loft_sci_mul(a[i], a[k - i]));
    }
    for (int i = 0; i <= order; i++) {
        for (int k = 0; k <= order; k++)
            sum = loft_sci_add(sum, times(loft_sci_mul(power[k], a[order - k]), share[i]));
        multiply_series(d, power, next);
        for (int k = 0; k < 5; k++)
            power[k] = next[k];
    }
    return loft_sci_div(times(sum, factorial[order]), loft_sci_from_int(128));
}

/* What rounding does to a curve: see loft_lines_next. */
static loft_sci bound_rounding(const part_bound *b, const loft_lines_way *way, loft_real most)
{
    const loft_sci radius = loft_sci_from_real(way->radius),
                   tip = loft_sci_of(4 *
                                     loft_real_ulp(loft_to_acc(most) + loft_to_acc(way->radius))),
                   unit = loft_sci_power2(-24),
                   turn = loft_sci_div(loft_sci_of(loft_real_ulp(loft_to_acc(LOFT_REAL(1)))),
                                       loft_sci_from_int(way->columns)),
                   grid = loft_sci_div(loft_sci_of(loft_real_ulp(loft_to_acc(LOFT_REAL(4096)))),
                                       loft_sci_from_int(512)),
                   skew = loft_sci_div(loft_sci_mul(b->size[1][0], b->size[0][1]), b->least);

    return loft_sci_add(tip, loft_sci_mul(radius, loft_sci_add(loft_sci_add(unit, turn),
                                                               loft_sci_mul(grid, skew))));
}

/* True if `bend` h^order / share is within what is left of the tolerance. h is 1 / steps of 2^level
 * parts.
 */
static bool step_fits(loft_sci bend, uint16_t steps, unsigned level, unsigned order, int32_t share,
                      loft_sci left)
{
    const loft_sci h = loft_sci_div(loft_sci_from_int((int32_t)1 << level),
                                    loft_sci_from_int(steps));

    return !loft_sci_less(loft_sci_mul(left, loft_sci_from_int(share)),
                          loft_sci_mul(bend, loft_sci_pow(h, order)));
}

static enum loft_lines_fault check_part(part_bound *b, const loft_lines_way *way, loft_real most,
                                        unsigned level, bool *near)
{
    const loft_sci radius = loft_sci_from_real(way->radius);
    loft_sci c[5];

    b->slack = loft_sci_of(level > 0 ? 3 * loft_real_ulp(loft_to_acc(most)) : 0);
    bound_sizes(b);
    const enum loft_lines_fault fault = bound_normals(b);
    if (fault != LOFT_LINES_FINE)
        return fault;
    if (!ball_fits(b, way->radius))
        return LOFT_LINES_GOUGE;
    const loft_sci left = loft_sci_sub(loft_sci_from_real(way->tol), bound_rounding(b, way, most));
    bound_normal_series(b, false, c);
    if (!step_fits(loft_sci_mul(radius, bound_unit(c, 4)), way->columns, level, 4, 384, left))
        return LOFT_LINES_COARSE;
    bound_normal_series(b, true, c);
    *near = *near && step_fits(loft_sci_add(b->size[2][0], loft_sci_mul(radius, bound_unit(c, 2))),
                               way->rows, level, 2, 8, left);
    return LOFT_LINES_FINE;
}

/* The net of a part; that of the whole patch is its own. */
static bool cut_part(const loft_tensor *s, unsigned level, unsigned i, unsigned j, loft_vec net[])
{
    const uint32_t n = (uint32_t)1 << level;
    loft_vec across[16];
    const loft_tensor strip = { across, s->m, s->n };

    return loft_tensor_sub_u(s, loft_unit_of(i, n), loft_unit_of(i + 1, n), across) == LOFT_OK &&
           loft_tensor_sub_v(&strip, loft_unit_of(j, n), loft_unit_of(j + 1, n), net) == LOFT_OK;
}

/* Every second bit of a number of LOFT_LINES_LEVELS pairs. */
static unsigned odd_bits(unsigned code)
{
    const unsigned b = (code & 0x1u) | (code & 0x4u) >> 1 | (code & 0x10u) >> 2 |
                       (code & 0x40u) >> 3;

    return b;
}

/* The part after this one of four, of which the last ends the one that they divide. */
static void next_part(unsigned *level, unsigned *code)
{
    *code += 1;
    while (*level > 0 && (*code & 3u) == 0) {
        *code >>= 2;
        *level -= 1;
    }
}

static bool way_valid(const loft_tensor *s, const loft_lines_way *way)
{
    for (unsigned k = 0; k < (s->m + 1u) * (s->n + 1u); k++)
        if (!loft_vec_within(s->p[k], LOFT_REAL(LOFT_LINES_REACH)))
            return false;
    return way->radius >= LOFT_REAL(1 / 64.0) && way->radius <= LOFT_REAL(LOFT_LINES_RADIUS) &&
           way->tol >= LOFT_REAL(1 / 1024.0) && way->tol <= LOFT_REAL(1) && way->rows >= 1 &&
           way->rows <= 1024 && way->columns >= 1 && way->columns <= 1024;
}

enum loft_lines_fault loft_lines_check(const loft_tensor *s, const loft_lines_way *way, bool *near)
{
    loft_vec net[16];
    loft_real most = 0;
    unsigned level = 0, code = 0;
    part_bound b;

    if (LOFT_AXES < 3 || s->m < 1 || s->n < 1 || s->m > LOFT_LINES_DEGREE ||
        s->n > LOFT_LINES_DEGREE || !way_valid(s, way))
        return LOFT_LINES_COARSE;
    for (unsigned k = 0; k < (s->m + 1u) * (s->n + 1u); k++) {
        if (loft_vec_axis(&s->p[k], 2) > way->safe)
            return LOFT_LINES_LOW;
        for (int axis = 0; axis < 3; axis++) {
            const loft_real size = loft_real_abs(loft_vec_axis(&s->p[k], axis));
            most = size > most ? size : most;
        }
    }
    *near = true;
    b.m = s->m;
    b.n = s->n;
    for (bool over = false; !over; over = level == 0) {
        bool joined = *near;
        b.p = level > 0 ? net : s->p;
        if (level > 0 && !cut_part(s, level, odd_bits(code), odd_bits(code >> 1), net))
            return LOFT_LINES_COARSE;
        const enum loft_lines_fault fault = check_part(&b, way, most, level, &joined);
        if (fault != LOFT_LINES_FINE && level == LOFT_LINES_LEVELS)
            return fault;
        if (fault == LOFT_LINES_FINE) {
            *near = joined;
            next_part(&level, &code);
        } else {
            level++;
            code <<= 2;
        }
    }
    return LOFT_LINES_FINE;
}
