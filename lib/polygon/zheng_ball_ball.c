/* lib/polygon/zheng_ball_ball.c -- Zheng-Ball patches over a piece of their parameters
 * SPDX-License-Identifier: MIT
 *
 * The weights are those of zheng_ball.c. The correction (1 - sum) / T of the T points inside needs
 * no range: with the mean M of these points the patch is
 *
 *     S - M = sum W_l(u) (V_l - M)        W_l: the weights before the correction
 *
 * M is rounded, which adds the sum of weights times its rounding.
 *
 * Six sides: the neighbour of zheng_ball_params.c, x = -2C / (B + sqrt D), D = B^2 - 4AC. In a
 * sector a and b are at most 0.72, where D is at least 0.4.
 */
#include "polygon/patch_ball.h"

static unsigned before(unsigned i, unsigned n) { return i ? i - 1 : n - 1; }
static unsigned after(unsigned i, unsigned n)  { return i + 1 < n ? i + 1 : 0; }

/* c + k a. */
static loft_jet_ball linear_of(int32_t c, int32_t k, const loft_jet_ball *a)
{
    loft_jet_ball r = loft_jet_ball_scale(a, loft_sci_from_int(k));

    r.mid.f = loft_sci_add(r.mid.f, loft_sci_from_int(c));
    return r;
}

/* The neighbour of b that is not a. */
static bool find_neighbour(const loft_jet_ball *a, const loft_jet_ball *b, loft_jet_ball *out)
{
    const loft_jet_ball ab = loft_jet_ball_mul(a, b), left = linear_of(1, -1, &ab),
                        right = linear_of(1, -2, &ab), first = loft_jet_ball_mul(&left, &right);
    const loft_jet_ball square = loft_jet_ball_mul(b, b), inner = linear_of(2, -3, &ab),
                        both = loft_jet_ball_add(&inner, &square),
                        second = loft_jet_ball_mul(a, &both), a2 = loft_jet_ball_mul(a, a),
                        third = linear_of(1, -1, &a2), twice = linear_of(0, 2, &third);
    const loft_jet_ball product = loft_jet_ball_mul(&first, &third),
                        four = linear_of(0, 4, &product), b2 = loft_jet_ball_mul(&second, &second),
                        d = loft_jet_ball_add(&b2, &four);
    loft_jet_ball root;

    if (!loft_jet_ball_sqrt(&d, &root))
        return false;
    const loft_jet_ball below = loft_jet_ball_add(&second, &root);
    return loft_jet_ball_div(&twice, &below, out);
}

bool loft_zheng_ball_params_ball(unsigned sides, const loft_jet_ball *u1, const loft_jet_ball *u2,
                                 loft_jet_ball u[])
{
    u[0] = *u1;
    u[1] = *u2;
    if (sides == 6)
        return find_neighbour(&u[0], &u[1], &u[2]) && find_neighbour(&u[1], &u[0], &u[5]) &&
               find_neighbour(&u[1], &u[2], &u[3]) && find_neighbour(&u[0], &u[5], &u[4]);
    const loft_jet_ball ab = loft_jet_ball_mul(u1, u2), a = linear_of(1, -1, u1),
                        b = linear_of(1, -1, u2);
    if (sides == 3) {
        const loft_jet_ball above = loft_jet_ball_sub(&a, u2), below = linear_of(1, -2, &ab);
        return loft_jet_ball_div(&above, &below, &u[2]);
    }
    u[3] = linear_of(1, -1, &ab);
    return loft_jet_ball_div(&a, &u[3], &u[2]) && loft_jet_ball_div(&b, &u[3], &u[4]);
}

typedef struct {
    const loft_zheng_ball *r;
    loft_jet_ball power[LOFT_ZHENG_BALL_SIDES][LOFT_DEGREE_MAX + 1];
    loft_jet_ball factor;       /* of points on a side, for 5 and 6 sides */
} balls;

static void start_balls(balls *b, const loft_zheng_ball *r, const loft_jet_ball u[])
{
    loft_jet_ball all = u[0];

    b->r = r;
    for (unsigned i = 0; i < r->sides; i++) {
        b->power[i][0] = loft_jet_ball_of(loft_sci_one());
        b->power[i][1] = u[i];
        for (unsigned k = 2; k <= r->degree; k++)
            b->power[i][k] = loft_jet_ball_mul(&b->power[i][k - 1], &u[i]);
        if (i > 0)
            all = loft_jet_ball_mul(&all, &u[i]);
    }
    b->factor = linear_of(1, r->sides == 6 ? -2 * (int32_t)r->degree : -(int32_t)r->degree, &all);
}

/* The factor of point k on a side. */
static loft_jet_ball factor_of(const balls *b, unsigned side, unsigned k)
{
    const unsigned d = b->r->degree;
    const bool far = d - k <= k;
    const int32_t one = (int32_t)(far ? d - k : k), rest = (int32_t)d - 2 * one;

    if (b->r->sides != 3)
        return b->factor;
    const loft_jet_ball *const beside = b->power[far ? after(side, 3) : before(side, 3)];
    const loft_jet_ball sum = linear_of(one, rest, &beside[1]),
                        product = loft_jet_ball_mul(&b->power[side][1], &sum);
    return linear_of(1, -1, &product);
}

/* The side of a point; the number of sides if it is inside. */
static unsigned side_of(const uint8_t l[], unsigned sides)
{
    unsigned i = 0;

    while (i < sides && l[i])
        i++;
    return i;
}

static loft_jet_ball weight_of(const balls *b, unsigned k)
{
    const unsigned n = b->r->sides, d = b->r->degree, block = (d / 2 + 1) * ((d + 1) / 2),
                   corner = k / block < n ? k / block : 0;
    uint8_t l[LOFT_ZHENG_BALL_SIDES];

    loft_zheng_ball_index(n, d, k, l);
    loft_jet_ball weight = loft_jet_ball_of(
        loft_sci_from_int(loft_binomial(d, l[before(corner, n)]) * loft_binomial(d, l[corner])));
    for (unsigned i = 0; i < n; i++)
        if (l[i])
            weight = loft_jet_ball_mul(&weight, &b->power[i][l[i]]);
    const unsigned side = side_of(l, n);
    if (side == n)
        return weight;
    const loft_jet_ball factor = factor_of(b, side, l[before(side, n)]);
    return loft_jet_ball_mul(&weight, &factor);
}

/* The mean of the points inside, rounded. */
static loft_vec mean_inside(const loft_zheng_ball *r, unsigned count)
{
    loft_acc sum[LOFT_AXES] = { 0 };
    int32_t used = 0;
    loft_vec m;

    for (unsigned k = 0; k < count; k++) {
        uint8_t l[LOFT_ZHENG_BALL_SIDES];
        loft_zheng_ball_index(r->sides, r->degree, k, l);
        if (side_of(l, r->sides) < r->sides)
            continue;
        for (int i = 0; i < LOFT_AXES; i++)
            sum[i] += loft_to_acc(r->p[k].axis[i]);
        used++;
    }
    for (int i = 0; i < LOFT_AXES; i++)
        m.axis[i] = loft_acc_round(loft_acc_ratio(sum[i], used));
    return m;
}

void loft_zheng_ball_range(const loft_zheng_ball *r, const loft_jet_ball u[],
                           loft_jet_ball_sum *out)
{
    const unsigned count = loft_zheng_ball_count(r->sides, r->degree);
    const loft_vec mean = mean_inside(r, count);
    balls b;

    start_balls(&b, r, u);
    loft_jet_ball_sum_start(out, mean);
    for (unsigned k = 0; k < count; k++) {
        const loft_jet_ball weight = weight_of(&b, k);
        loft_jet_ball_sum_add(out, &r->p[k], &weight);
    }
    const loft_jet most = loft_jet_ball_most(&out->w);
    for (int k = 0; k < 3; k++) {
        const loft_acc rounded = loft_real_ulp(loft_to_acc(loft_vec_axis(&mean, k)));
        const loft_jet moved = loft_jet_scale(&most, loft_sci_of(rounded));
        out->x[k].off = loft_jet_add(&out->x[k].off, &moved);
    }
}
