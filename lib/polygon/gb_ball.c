/* lib/polygon/gb_ball.c -- generalized Bezier patches over a piece of their polygon
 * SPDX-License-Identifier: MIT
 *
 * Wachspress coordinates with the areas A and C of wachspress.c give the parameter of side i of a
 * gb patch without a quotient that is 0/0 on the far sides:
 *
 *     s_i = C_(i+1) A_(i-1) / (C_(i+1) A_(i-1) + C_i A_(i+1))
 *
 * The weights of corners are those of gb_differential.c. Only alpha and beta have no bounded
 * derivatives, at vertices. They are shares: in the smallest parts, where points alone are bounded,
 * 1/2 plus or minus 1/2.
 *
 * Such a part is near a vertex, and relative to its point all but a few weights are small. With
 * t = 1 - a, and R and both quotients of e as there, the three largest weights leave
 *
 *     1 - (1 - t)^d - d t (1 - t)^(d-1) + d a^(d-1) (R - beta e / (a + c) - alpha e / (a + b))
 *
 * to all others, the middle point included. The first terms are the chance of two or more in d
 * tries: at most d (d - 1) / 2 t^2. So the middle has a weight of at most that, plus the sizes of
 * the rest and of all other weights: of second order, like these.
 */
#include "polygon/patch_ball.h"

static unsigned next_of(unsigned i, unsigned n) { return i + 1 < n ? i + 1 : 0; }
static unsigned before(unsigned i, unsigned n)  { return i ? i - 1 : n - 1; }

static loft_jet_ball mul3(const loft_jet_ball *a, const loft_jet_ball *b, const loft_jet_ball *c)
{
    const loft_jet_ball ab = loft_jet_ball_mul(a, b);
    return loft_jet_ball_mul(&ab, c);
}

#define LAYERS ((LOFT_DEGREE_MAX + 1) / 2)

/* The parameters of one side, and 1 minus each of them. */
typedef struct {
    loft_jet_ball s, before_s, h, below_h;
} side_balls;

/* All of them, and the coordinates. */
typedef struct {
    const loft_gb *g;
    const loft_jet_ball *phi;
    side_balls side[LOFT_SIDES_MAX];
    bool point;
    unsigned vertex;            /* of points alone: the nearest one */
    loft_sci rest;              /* the most that is left to the point in the middle */
} gb_balls;

/* a / b, a share; of points alone 1/2 plus or minus 1/2 where b may be 0. */
static bool share_of(const gb_balls *b, const loft_jet_ball *a, const loft_jet_ball *whole,
                     loft_jet_ball *out)
{
    if (loft_jet_ball_div(a, whole, out))
        return true;
    *out = loft_jet_ball_of(loft_sci_from_real(LOFT_REAL(0.5)));
    out->off.f = out->mid.f;
    return b->point;
}

static loft_jet_ball sum_of_rest(const gb_balls *b, unsigned first, unsigned count)
{
    loft_jet_ball sum = loft_jet_ball_of(loft_sci_zero());

    for (unsigned k = count; k < b->g->sides; k++)
        sum = loft_jet_ball_add(&sum, &b->phi[(first + k) % b->g->sides]);
    return sum;
}

static bool find_sides(gb_balls *b, const loft_domain *d, const loft_jet_ball area[])
{
    const unsigned n = b->g->sides;

    for (unsigned i = 0; i < n; i++) {
        side_balls *const s = &b->side[i];
        const unsigned j = next_of(i, n);
        const loft_jet_ball after = loft_jet_ball_scale(&area[before(i, n)], d->corner[j]),
                            here = loft_jet_ball_scale(&area[j], d->corner[i]),
                            both = loft_jet_ball_add(&after, &here);
        if (!share_of(b, &after, &both, &s->s) || !share_of(b, &here, &both, &s->before_s))
            return false;
        s->below_h = loft_jet_ball_add(&b->phi[i], &b->phi[j]);
        s->h = sum_of_rest(b, i, 2);
    }
    return true;
}

static loft_sci size_of(const loft_jet_ball *b) { return loft_jet_ball_most(b).f; }

static void add_weight(loft_jet_ball_sum *sum, gb_balls *b, const loft_vec *p,
                       const loft_jet_ball *weight)
{
    loft_jet_ball_sum_add(sum, p, weight);
    b->rest = loft_sci_add(b->rest, size_of(weight));
}

static const loft_vec *point_of(const gb_balls *b, unsigned side, unsigned j, unsigned k)
{
    return &b->g->p[loft_gb_place(b->g->sides, b->g->degree, side, j, k)];
}

static void add_of(loft_jet_ball_sum *sum, gb_balls *b, unsigned side, unsigned j, unsigned k,
                   const loft_jet_ball *weight)
{
    add_weight(sum, b, point_of(b, side, j, k), weight);
}

/* times (b + share e). */
static loft_jet_ball moved_by(const loft_jet_ball *times, const loft_jet_ball *b,
                              const loft_jet_ball *share, const loft_jet_ball *e)
{
    const loft_jet_ball by = loft_jet_ball_mul(share, e), sum = loft_jet_ball_add(b, &by);
    return loft_jet_ball_mul(times, &sum);
}

/* x s - y t. */
static loft_jet_ball cross_of(const loft_jet_ball *x, const loft_jet_ball *s,
                              const loft_jet_ball *y, const loft_jet_ball *t)
{
    const loft_jet_ball a = loft_jet_ball_mul(x, s), b = loft_jet_ball_mul(y, t);
    return loft_jet_ball_sub(&a, &b);
}

/* The points next to vertex i, from the second one on; `power` is a^(d-2). */
static void add_inner(loft_jet_ball_sum *sum, gb_balls *b, unsigned i, const loft_jet_ball *power,
                      const loft_jet_ball *beta, const loft_jet_ball *e_c)
{
    const unsigned n = b->g->sides;
    const side_balls *here = &b->side[i], *last = &b->side[before(i, n)];
    const loft_sci m = loft_sci_from_int((int32_t)b->g->degree), m2 = loft_sci_mul(m, m);
    const loft_jet_ball apart = loft_jet_ball_sub(&b->phi[before(i, n)], &b->phi[next_of(i, n)]),
                        turn = mul3(&here->before_s, &apart, e_c), x = mul3(power, beta, &turn),
                        full = loft_jet_ball_mul(power, &b->phi[i]),
                        y = mul3(&full, &here->s, &here->h), both = loft_jet_ball_add(&x, &y),
                        weight = loft_jet_ball_scale(&both, m2);

    add_of(sum, b, i, 1, 1, &weight);
    if (!b->g->split)
        return;
    const loft_jet_ball turned = mul3(&full, beta, &last->before_s),
                        whole = loft_jet_ball_mul(&turned, &last->h),
                        share = loft_jet_ball_scale(&whole, m2),
                        less = loft_jet_ball_scale(&share, loft_sci_from_int(-1));
    add_weight(sum, b, &b->g->split[i], &share);
    add_of(sum, b, i, 1, 1, &less);
}

/* What the three largest weights leave at most. */
static loft_sci left_by_corner(const gb_balls *b, const loft_jet_ball *rest,
                               const loft_jet_ball *e_c, const loft_jet_ball *e_b)
{
    const int32_t d = b->g->degree;
    const loft_jet_ball all = sum_of_rest(b, b->vertex, 1);
    const loft_sci t = size_of(&all),
                   sizes = loft_sci_add(size_of(rest), loft_sci_add(size_of(e_c), size_of(e_b)));

    return loft_sci_add(loft_sci_mul(loft_sci_from_int(d * (d - 1) / 2), loft_sci_mul(t, t)),
                        loft_sci_mul(loft_sci_from_int(d), sizes));
}

static bool add_corner(loft_jet_ball_sum *sum, gb_balls *b, unsigned i)
{
    const unsigned n = b->g->sides, d = b->g->degree;
    const side_balls *last = &b->side[before(i, n)], *here = &b->side[i];
    const loft_jet_ball *a = &b->phi[i], *after = &b->phi[next_of(i, n)],
                        *ahead = &b->phi[before(i, n)];
    const loft_jet_ball rest = sum_of_rest(b, before(i, n), 3),
                        both = loft_jet_ball_add(&last->h, &here->h),
                        e_c = cross_of(&last->s, &rest, &last->before_s, after),
                        e_b = cross_of(&here->before_s, &rest, &here->s, ahead);
    loft_jet_ball alpha, beta, power = loft_jet_ball_pow(a, d - 2), weight;

    if (!share_of(b, &last->h, &both, &alpha) || !share_of(b, &here->h, &both, &beta))
        return false;
    add_inner(sum, b, i, &power, &beta, &e_c);
    const loft_sci others = b->rest;
    power = loft_jet_ball_mul(&power, a);
    weight = loft_jet_ball_mul(&power, a);
    add_of(sum, b, i, 0, 0, &weight);
    power = loft_jet_ball_scale(&power, loft_sci_from_int((int32_t)d));
    weight = moved_by(&power, after, &beta, &e_c);
    add_of(sum, b, i, 1, 0, &weight);
    weight = moved_by(&power, ahead, &alpha, &e_b);
    add_of(sum, b, i, 0, 1, &weight);
    if (i == b->vertex)
        b->rest = loft_sci_add(others, left_by_corner(b, &rest, &e_c, &e_b));
    return true;
}

/* C(degree, k) x^k y^(degree - k) for k = 0 .. count - 1. */
static void find_bernstein(loft_jet_ball out[], unsigned degree, unsigned count,
                           const loft_jet_ball *x, const loft_jet_ball *y)
{
    loft_jet_ball power = loft_jet_ball_of(loft_sci_one());

    for (unsigned k = 0; k < count; k++) {
        out[k] = loft_jet_ball_scale(&power, loft_sci_from_int(loft_binomial(degree, k)));
        power = loft_jet_ball_mul(&power, x);
    }
    power = loft_jet_ball_pow(y, degree + 1 - count);
    for (unsigned k = count; k-- > 0; ) {
        out[k] = loft_jet_ball_mul(&out[k], &power);
        power = loft_jet_ball_mul(&power, y);
    }
}

/* All other points of ribbon i. */
static void add_ribbon(loft_jet_ball_sum *sum, gb_balls *b, unsigned i)
{
    const unsigned d = b->g->degree, layers = (d + 1) / 2;
    const loft_sci half = loft_sci_from_real(LOFT_REAL(0.5));
    const side_balls *here = &b->side[i];
    loft_jet_ball along[LOFT_DEGREE_MAX + 1], across[LAYERS];

    find_bernstein(along, d, d + 1, &here->s, &here->before_s);
    find_bernstein(across, d, layers, &here->h, &here->below_h);
    for (unsigned k = 0; k < layers; k++)
        for (unsigned j = k < 2 ? 2 : k; j <= d - (k < 2 ? 2 : k); j++) {
            loft_jet_ball weight = loft_jet_ball_mul(&along[j], &across[k]);
            if (loft_gb_mu_of(d, j, k) == LOFT_GB_HALF)
                weight = loft_jet_ball_scale(&weight, half);
            add_of(sum, b, i, j, k, &weight);
        }
}

bool loft_gb_ball(const loft_gb *g, const loft_domain *d, const loft_jet_ball area[],
                  const loft_jet_ball phi[], bool point, loft_jet_ball_sum *out)
{
    const loft_vec *const middle = &g->p[loft_gb_count(g->sides, g->degree) - 1];
    gb_balls b;

    b.g = g;
    b.phi = phi;
    b.point = point;
    b.vertex = 0;
    b.rest = loft_sci_zero();
    if (!find_sides(&b, d, area))
        return false;
    for (unsigned i = 1; i < g->sides; i++)
        if (loft_sci_less(phi[b.vertex].mid.f, phi[i].mid.f))
            b.vertex = i;
    loft_jet_ball_sum_start(out, point ? *point_of(&b, b.vertex, 0, 0) : *middle);
    for (unsigned i = 0; i < g->sides; i++) {
        if (!add_corner(out, &b, i))
            return false;
        add_ribbon(out, &b, i);
    }
    if (point) {
        loft_jet_ball weight = loft_jet_ball_of(loft_sci_zero());
        weight.off.f = b.rest;
        loft_jet_ball_sum_add(out, middle, &weight);
    }
    return true;
}
