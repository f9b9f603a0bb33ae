/* tests/lib/polygon/test_zheng_ball.c -- properties of lib/polygon/zheng_ball.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_quad.h"             /* quad, quad_differences */
#include "support/arb_patch.h"              /* arb_net, power */
#include "polygon/zheng_ball.h"

static net points;
static const unsigned kinds[3] = { 3, 5, 6 };

static loft_zheng_ball arb_ring(arb *a)
{
    const unsigned sides = kinds[arb_below(a, 3)], degree = 2 + arb_below(a, LOFT_DEGREE_MAX - 1);
    loft_zheng_ball r = { 0, 0, 0 };

    arb_net(a, &points, loft_zheng_ball_count(sides, degree));
    CHECK(loft_zheng_ball_init(&r, points.p, sides, degree) == LOFT_OK);
    return r;
}

/* Near 0 and 1 as often as between. */
static loft_unit arb_share(arb *a)
{
    const uint32_t n = 65536, small[6] = { 0, 1, 2, n - 2, n - 1, n };
    const loft_unit last = LOFT_UNIT(1) - (loft_unit)BY_NUM(1, 0x1p-24, 0x1p-53);

    if (arb_below(a, 8) == 0)
        return arb_below(a, 2) ? last : LOFT_UNIT(1) - last;
    return loft_unit_of(arb_below(a, 2) ? arb_below(a, n + 1) : small[arb_below(a, 6)], n);
}

static void arb_params(arb *a, unsigned sides, loft_sci u[])
{
    loft_unit one, two;
    enum loft_status status;

    do {
        one = arb_share(a);
        two = arb_below(a, 5) ? arb_share(a) : one;
        if (sides == 3 && two > LOFT_UNIT(1) - one)
            two = LOFT_UNIT(1) - one;
        status = loft_zheng_ball_params(sides, one, two, u);
        CHECK(status ==
              (sides > 3 && one >= LOFT_UNIT(1) && two >= LOFT_UNIT(1) ? LOFT_SINGULAR : LOFT_OK));
    } while (status == LOFT_SINGULAR);
}

/* The definitions, only from the distances. The sides i with l_i = 0 select the boundary
 * formula. */
static long double exact_weight(unsigned n, unsigned d, const uint8_t l[], const long double u[],
                                bool *inside)
{
    long double b = 1, all = 1;
    unsigned least = d, next = d, side = n;

    for (unsigned i = 0; i < n; i++) {
        b *= power(u[i], l[i]);
        all *= u[i];
        if (l[i] < least) {
            next = least;
            least = l[i];
        } else if (l[i] < next)
            next = l[i];
        if (l[i] == 0 && side == n)
            side = i;
    }
    *inside = side == n;
    if (*inside)
        return b * loft_binomial(d, least) * loft_binomial(d, next);
    const unsigned k = l[(side + n - 1) % n];
    const long double before = u[(side + n - 1) % n], after = u[(side + 1) % n];
    long double f = 1 - all * (n == 6 ? 2 * d : d);
    if (n == 3)
        f = d - k <= k ? 1 - u[side] * ((d - k) + (2.0L * k - d) * after)
                       : 1 - u[side] * (k + (d - 2.0L * k) * before);
    return loft_binomial(d, k) * b * f;
}

static void exact_weights(unsigned n, unsigned d, const loft_sci u[], long double out[])
{
    const unsigned count = loft_zheng_ball_count(n, d);
    long double v[LOFT_ZHENG_BALL_SIDES], sum = 0;
    bool inside[PATCH_POINTS];
    unsigned inner = 0;

    for (unsigned i = 0; i < n; i++)
        v[i] = exact_sci(u[i]);
    for (unsigned k = 0; k < count; k++) {
        uint8_t l[LOFT_ZHENG_BALL_SIDES];
        loft_zheng_ball_index(n, d, k, l);
        out[k] = exact_weight(n, d, l, v, &inside[k]);
        sum += out[k];
        inner += inside[k];
    }
    for (unsigned k = 0; k < count; k++)
        out[k] -= inside[k] ? (sum - 1) / inner : 0;
}

/* There are n d points on the boundary and n (d - 2) d / 4 + 1 or n (d - 1)^2 / 4 inside. No two
 * are equal, and all are valid. */
static void every_point_has_distances_of_its_own(arb *a)
{
    const unsigned n = kinds[arb_below(a, 3)], d = 2 + arb_below(a, LOFT_DEGREE_MAX - 1),
                   count = loft_zheng_ball_count(n, d);
    uint8_t l[PATCH_POINTS][LOFT_ZHENG_BALL_SIDES];

    CHECK(count == n * d + (d % 2 ? n * (d - 1) * (d - 1) / 4 : n * (d - 2) * d / 4 + 1));
    for (unsigned k = 0; k < count; k++) {
        loft_zheng_ball_index(n, d, k, l[k]);
        unsigned corner = 0, total = 0, least = d;
        for (unsigned i = 0; i < n; i++) {
            total += l[k][i];
            least = l[k][i] < least ? l[k][i] : least;
            const unsigned x = l[k][(i + n - 1) % n], y = l[k][i];
            if (n > 3)
                corner += 2 * x <= d && 2 * y <= d && l[k][(i + 1) % n] == d - x &&
                          l[k][(i + n - 2) % n] == d - y;
        }
        CHECK(n > 3 ? corner > 0 : total == d + least);
        for (unsigned j = 0; j < k; j++) {
            unsigned same = 0;
            for (unsigned i = 0; i < n; i++)
                same += l[j][i] == l[k][i];
            CHECK(same < n);
        }
    }
}

/* All relations between neighbours hold, also the unused ones. Near 0/0 the relation itself loses
 * digits. */
static void parameters_fit_together_all_around(arb *a)
{
    const unsigned n = kinds[arb_below(a, 3)];
    loft_sci u[LOFT_ZHENG_BALL_SIDES];
    long double v[LOFT_ZHENG_BALL_SIDES];

    arb_params(a, n, u);
    for (unsigned i = 0; i < n; i++) {
        v[i] = exact_sci(u[i]);
        CHECK(v[i] >= 0 && v[i] <= 1 + 0x1p-40L);
    }
    for (unsigned i = 0; i < n; i++) {
        const long double p = v[i], q = v[(i + 1) % n], x = v[(i + 2) % n];
        if (n == 3)
            CHECK_EXACT(p + q + x, 2 * p * q * x + 1, BY_NUM(0x1p-55L, 0x1p-50L, 0x1p-50L));
        else if (n == 5)
            CHECK_EXACT(p, 1 - x * v[(i + 3) % n], BY_NUM(0x1p-55L, 0x1p-50L, 0x1p-50L));
        else
            CHECK_EXACT((1 - p * q) * (1 - 2 * p * q) * x * x +
                            (2 * p - 3 * p * p * q + p * q * q) * x + p * p,
                        1, BY_NUM(0x1p-55L, 0x1p-49L, 0x1p-49L));
    }
}

/* The reversed order gives the same: u_2 and u_1 of the mirrored patch. */
static void parameters_of_the_mirror_are_mirrored(arb *a)
{
    const unsigned n = kinds[arb_below(a, 3)];
    const loft_unit one = arb_share(a), two = arb_share(a);
    loft_sci u[LOFT_ZHENG_BALL_SIDES], v[LOFT_ZHENG_BALL_SIDES];

    const enum loft_status status = loft_zheng_ball_params(n, one, two, u);
    CHECK(loft_zheng_ball_params(n, two, one, v) == status);
    for (unsigned i = 0; i < n && status == LOFT_OK; i++)
        CHECK_EXACT(exact_sci(u[i]), exact_sci(v[(n + 1 - i) % n]),
                    BY_NUM(0x1p-55L, 0x1p-48L, 0x1p-48L));
}

static void a_lift_fits_together(arb *a)
{
    const bool centre = arb_below(a, 4) == 0;
    const loft_unit one = centre ? loft_unit_of(1, 3) : arb_share(a),
                    two = centre ? one : loft_unit_of(arb_below(a, 65537), 65536);
    loft_sci u[3];

    if (two > LOFT_UNIT(1) - one) {
        CHECK(loft_zheng_ball_lift(one, two, u) == LOFT_ERR_ARG);
        return;
    }
    CHECK(loft_zheng_ball_lift(one, two, u) == LOFT_OK);
    const long double x = exact_sci(u[0]), y = exact_sci(u[1]), z = exact_sci(u[2]),
                      p = exact_unit(one), q = exact_unit(two);
    CHECK_EXACT(x + y + z, 2 * x * y * z + 1, BY_NUM(0x1p-55L, 0x1p-50L, 0x1p-50L));
    CHECK_EXACT(x * q, y * p, BY_NUM(0x1p-55L, 0x1p-49L, 0x1p-49L));
    CHECK_EXACT(y * (1 - p - q), z * q, BY_NUM(0x1p-55L, 0x1p-49L, 0x1p-49L));
}

static void weights_sum_to_one_and_are_within_their_bound(arb *a)
{
    static loft_sci w[PATCH_POINTS];
    static long double want[PATCH_POINTS];
    const unsigned n = kinds[arb_below(a, 3)], d = 2 + arb_below(a, LOFT_DEGREE_MAX - 1),
                   count = loft_zheng_ball_count(n, d);
    loft_sci u[LOFT_ZHENG_BALL_SIDES];
    long double sum = 0;

    arb_params(a, n, u);
    loft_zheng_ball_weights(n, d, u, w);
    exact_weights(n, d, u, want);
    for (unsigned k = 0; k < count; k++) {
        CHECK_EXACT(exact_sci(w[k]), want[k], BY_NUM(0x1p-50L, 0x1p-42L, 0x1p-42L));
        sum += exact_sci(w[k]);
    }
    CHECK_EXACT(sum, 1, BY_NUM(0x1p-50L, 0x1p-42L, 0x1p-42L));
}

static void a_point_is_within_its_bound(arb *a)
{
    static long double weight[PATCH_POINTS];
    const loft_zheng_ball r = arb_ring(a);
    const unsigned count = loft_zheng_ball_count(r.sides, r.degree);
    loft_sci u[LOFT_ZHENG_BALL_SIDES];
    long double want[LOFT_AXES] = { 0 };
    loft_vec v = { { 0 } };
    bool fits = true;

    arb_params(a, r.sides, u);
    exact_weights(r.sides, r.degree, u, weight);
    for (unsigned k = 0; k < count; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            want[i] += weight[k] * exact_of(r.p[k].axis[i]);
    for (int i = 0; i < LOFT_AXES; i++)
        fits = fits && BY_NUM(fabsl(want[i]) < 32767.5L, true, true);
    bool side = false;
    for (unsigned i = 0; i < r.sides; i++)
        side = side || loft_sci_sign(u[i]) == 0;
    const enum loft_status status = loft_zheng_ball_eval(&r, u, &v);
    CHECK(status == LOFT_OK || (!fits && status == LOFT_ERR_RANGE));
    for (int i = 0; i < LOFT_AXES && status == LOFT_OK; i++)
        check_axis(v.axis[i], want[i], points.largest, side ? 0x1p-13L : 0x1p-16L, 4096);
}

/* The number of sides; u_4 from u_6 and u_5, or u_5 from u_3 and u_4; or a lift. */
typedef struct {
    unsigned sides;
    bool fourth, fifth, lift;
} quad_params;

/* The root of the relation of three neighbours. */
static quad quad_neighbour(quad p, quad q)
{
    const quad a = (1 - p * q) * (1 - 2 * p * q), c = p * p - 1;
    const quad b = 2 * p - 3 * p * p * q + p * q * q;
    return -2 * c / (b + quad_sqrt(b * b - 4 * a * c));
}

static void quad_lift(quad_spot at, quad u[])
{
    const quad b[3] = { at.x, at.y, 1 - at.x - at.y }, p = b[0] * b[1] * b[2];
    quad t = 1;

    for (int k = 0; k < 8; k++)
        t -= (2 * p * t * t * t - t + 1) / (6 * p * t * t - 1);
    for (int i = 0; i < 3; i++)
        u[i] = t * b[i];
}

static void quad_params_at(const void *of, quad_spot at, quad u[])
{
    const quad_params *x = (const quad_params *)of;

    u[0] = at.x;
    u[1] = at.y;
    if (x->lift) {
        quad_lift(at, u);
    } else if (x->sides == 3) {
        u[2] = (1 - at.x - at.y) / (1 - 2 * at.x * at.y);
    } else if (x->sides == 5) {
        u[3] = 1 - at.x * at.y;
        u[2] = (1 - at.x) / u[3];
        u[4] = (1 - at.y) / u[3];
    } else {
        u[2] = quad_neighbour(at.x, at.y);
        u[5] = quad_neighbour(at.y, at.x);
        u[3] = quad_neighbour(at.y, u[2]);
        u[4] = x->fifth ? quad_neighbour(u[2], u[3]) : quad_neighbour(at.x, u[5]);
        u[3] = x->fourth ? quad_neighbour(u[5], u[4]) : u[3];
    }
}

/* Two parameters or coordinates, and their values; r of zheng_ball.h. */
static long double arb_pair(arb *a, const quad_params *x, loft_unit at[2])
{
    do {
        at[0] = arb_share(a);
        at[1] = arb_below(a, 5) ? arb_share(a) : at[0];
    } while (x->sides == 3 ? at[1] > LOFT_UNIT(1) - at[0]
                           : at[0] > LOFT_UNIT(0.996) && at[1] > LOFT_UNIT(0.996));
    const long double p = 1 - exact_unit(at[0]), q = 1 - exact_unit(at[1]);
    return x->sides == 3 ? 1 : fmaxl(p, q);
}

static void arb_jets(arb *a, quad_params *x, loft_jet u[], loft_unit at[2], long double *r)
{
    x->lift = x->sides == 3 && arb_below(a, 2);
    *r = arb_pair(a, x, at);
    x->fourth = at[1] > LOFT_UNIT(0.75) && at[1] >= at[0];
    x->fifth = at[0] > LOFT_UNIT(0.75) && !x->fourth;
    CHECK((x->lift ? loft_zheng_ball_lift_jet(at[0], at[1], u)
                   : loft_zheng_ball_params_jet(x->sides, at[0], at[1], u)) == LOFT_OK);
}

static void parameters_have_their_derivatives(arb *a)
{
    quad want[LOFT_SIDES_MAX][5];
    loft_jet u[LOFT_ZHENG_BALL_SIDES];
    loft_sci value[LOFT_ZHENG_BALL_SIDES];
    quad_params x = { .sides = kinds[arb_below(a, 3)] };
    loft_unit at[2];
    long double r;

    arb_jets(a, &x, u, at, &r);
    const quad_spot spot = { exact_unit(at[0]), exact_unit(at[1]) };
    quad_differences(quad_params_at, &x, x.sides, spot, (quad)(r * r) / 262144, want);
    CHECK((x.lift ? loft_zheng_ball_lift(at[0], at[1], value)
                  : loft_zheng_ball_params(x.sides, at[0], at[1], value)) == LOFT_OK);
    for (unsigned i = 0; i < x.sides; i++) {
        const loft_sci got[5] = { u[i].x, u[i].y, u[i].xx, u[i].xy, u[i].yy };
        CHECK_EXACT(exact_sci(u[i].f), exact_sci(value[i]), 0);
        for (int k = 0; k < 5; k++) {
            const long double off = BY_NUM(0x1p-56L, 0x1p-48L, 0x1p-48L) / (r * r);
            const long double law = k < 2 ? off : 4 * off / (r * r);
            CHECK_EXACT(exact_sci(got[k]), (long double)want[i][k], law);
        }
    }
}

/* In 113 bits, by the definition of exact_weight, at consistent parameters. */
typedef struct {
    const loft_zheng_ball *r;
    quad_params params;
} quad_ring;

static quad quad_border(unsigned n, unsigned d, unsigned side, unsigned k, const quad u[])
{
    const quad before = u[(side + n - 1) % n], after = u[(side + 1) % n];
    quad all = n == 6 ? 2 * d : d;

    if (n == 3 && d - k <= k)
        return 1 - u[side] * ((d - k) + (2 * (quad)k - d) * after);
    if (n == 3)
        return 1 - u[side] * (k + (d - 2 * (quad)k) * before);
    for (unsigned i = 0; i < n; i++)
        all *= u[i];
    return 1 - all;
}

static quad quad_ring_weight(unsigned n, unsigned d, const uint8_t l[], const quad u[],
                             bool *inside)
{
    unsigned least = d, next = d, side = n;
    quad w = 1;

    for (unsigned i = 0; i < n; i++) {
        for (unsigned k = 0; k < l[i]; k++)
            w *= u[i];
        next = l[i] < least ? least : l[i] < next ? l[i] : next;
        least = l[i] < least ? l[i] : least;
        side = side == n && l[i] == 0 ? i : side;
    }
    *inside = side == n;
    if (*inside)
        return w * loft_binomial(d, least) * loft_binomial(d, next);
    const unsigned k = l[(side + n - 1) % n];
    return w * loft_binomial(d, k) * quad_border(n, d, side, k, u);
}

static void quad_ring_at(const void *of, quad_spot at, quad out[])
{
    const quad_ring *s = (const quad_ring *)of;
    const unsigned n = s->r->sides, d = s->r->degree, count = loft_zheng_ball_count(n, d);
    quad u[LOFT_ZHENG_BALL_SIDES], sum = 0, inner[LOFT_AXES] = { 0 };
    unsigned many = 0;

    quad_params_at(&s->params, at, u);
    for (int i = 0; i < LOFT_AXES; i++)
        out[i] = 0;
    for (unsigned k = 0; k < count; k++) {
        uint8_t l[LOFT_ZHENG_BALL_SIDES];
        bool inside;
        loft_zheng_ball_index(n, d, k, l);
        const quad w = quad_ring_weight(n, d, l, u, &inside);
        sum += w;
        many += inside;
        for (int i = 0; i < LOFT_AXES; i++) {
            out[i] += w * (quad)exact_of(s->r->p[k].axis[i]);
            inner[i] += inside * (quad)exact_of(s->r->p[k].axis[i]);
        }
    }
    for (int i = 0; i < LOFT_AXES; i++)
        out[i] += (1 - sum) / many * inner[i];
}

static void largest_slopes(const loft_jet u[], unsigned n, long double *first, long double *second)
{
    *first = *second = 1;
    for (unsigned k = 0; k < n; k++) {
        const loft_sci of[5] = { u[k].x, u[k].y, u[k].xx, u[k].xy, u[k].yy };
        for (int m = 0; m < 5; m++) {
            long double *most = m < 2 ? first : second;
            *most = fmaxl(*most, fabsl(exact_sci(of[m])));
        }
    }
}

static void derivatives_are_limits_of_differences(arb *a)
{
    const loft_zheng_ball r = arb_ring(a);
    quad want[LOFT_AXES][5];
    loft_jet u[LOFT_ZHENG_BALL_SIDES];
    loft_unit at[2];
    loft_differential here;
    long double near, first, second;
    quad_ring s = { &r, { .sides = r.sides } };

    arb_jets(a, &s.params, u, at, &near);
    if (near < 0.25L)
        return;
    const quad_spot spot = { exact_unit(at[0]), exact_unit(at[1]) };
    quad_differences(quad_ring_at, &s, LOFT_AXES, spot, 0x1p-22L, want);
    loft_zheng_ball_differential(&r, u, &here);
    largest_slopes(u, r.sides, &first, &second);
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_sci got[5] = { here.u[i], here.v[i], here.uu[i], here.uv[i], here.vv[i] };
        const long double steep = r.degree * first, law = BY_NUM(0x1p-52L, 0x1p-44L, 0x1p-44L);
        for (int k = 0; k < 5; k++) {
            const long double size = k < 2 ? steep : steep * steep + r.degree * second;
            CHECK_EXACT(exact_sci(got[k]), (long double)want[i][k], points.largest * size * law);
        }
        CHECK(!loft_sci_less(here.width_u, loft_sci_abs(here.u[i])));
        CHECK(!loft_sci_less(here.width_v, loft_sci_abs(here.v[i])));
    }
}

/* l_i = 0, l_(i-1) = k: bit for bit the Bezier curve at u_(i-1). */
static void sides_are_the_curves_of_their_points(arb *a)
{
    const loft_zheng_ball r = arb_ring(a);
    const unsigned n = r.sides, side = arb_below(a, n), count = loft_zheng_ball_count(n, r.degree);
    const loft_unit t = arb_share(a);
    loft_vec p[LOFT_DEGREE_MAX + 1], v = { { 0 } };
    loft_sci u[LOFT_ZHENG_BALL_SIDES];
    unsigned found = 0;
    loft_bezier b;

    for (unsigned k = 0; k < count; k++) {
        uint8_t l[LOFT_ZHENG_BALL_SIDES];
        loft_zheng_ball_index(n, r.degree, k, l);
        if (l[side] == 0) {
            p[l[(side + n - 1) % n]] = r.p[k];
            found++;
        }
    }
    CHECK(found == r.degree + 1u && loft_bezier_init(&b, p, r.degree) == LOFT_OK);
    for (unsigned i = 0; i < n; i++)
        u[i] = loft_sci_one();
    u[side] = loft_sci_zero();
    u[(side + n - 1) % n] = loft_sci_from_unit(t);
    u[(side + 1) % n] = loft_sci_sub(loft_sci_one(), loft_sci_from_unit(t));
    CHECK(loft_zheng_ball_eval(&r, u, &v) == LOFT_OK);
    check_same(v, loft_bezier_eval(&b, t));
}

/* Parameters with u_1 = 0 are those of side 1. */
static void parameters_of_a_side_are_exact(arb *a)
{
    const unsigned n = kinds[arb_below(a, 3)];
    const loft_unit t = loft_unit_of(arb_below(a, 65537), 65536);
    loft_sci u[LOFT_ZHENG_BALL_SIDES];

    CHECK(loft_zheng_ball_params(n, 0, t, u) == LOFT_OK);
    for (unsigned i = 0; i < n; i++)
        CHECK_EXACT(exact_sci(u[i]),
                    i == 0       ? 0
                    : i == 1     ? exact_unit(t)
                    : i == n - 1 ? 1 - exact_unit(t)
                                 : 1,
                    BY_NUM(0x1p-58L, 0x1p-51L, 0x1p-51L));
}

static void the_same_point_everywhere_makes_a_point(arb *a)
{
    const loft_zheng_ball r = arb_ring(a);
    const loft_vec p = arb_vec(a, 100);
    loft_sci u[LOFT_ZHENG_BALL_SIDES];
    loft_vec v = { { 0 } };

    for (unsigned k = 0; k < loft_zheng_ball_count(r.sides, r.degree); k++)
        points.p[k] = p;
    arb_params(a, r.sides, u);
    CHECK(loft_zheng_ball_eval(&r, u, &v) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(v.axis[i]), exact_of(p.axis[i]), BY_NUM(0, ulp(100), 4096 * ulp(100)));
}

static void nonsense_is_refused(arb *a)
{
    loft_zheng_ball r = { .sides = 77 };
    loft_sci u[LOFT_ZHENG_BALL_SIDES];
    const unsigned bad[5] = { 0, 2, 4, 7, 8 };

    arb_net(a, &points, loft_zheng_ball_count(6, 9));
    for (int i = 0; i < 5; i++) {
        CHECK(loft_zheng_ball_init(&r, points.p, bad[i], 4) == LOFT_ERR_ARG);
        CHECK(loft_zheng_ball_params(bad[i], LOFT_UNIT(0.5), LOFT_UNIT(0.25), u) == LOFT_ERR_ARG);
    }
    CHECK(loft_zheng_ball_init(&r, points.p, 5, 1) == LOFT_ERR_ARG &&
          loft_zheng_ball_init(&r, points.p, 5, 10) == LOFT_ERR_ARG);
    CHECK(loft_zheng_ball_params(3, LOFT_UNIT(0.75), LOFT_UNIT(0.5), u) == LOFT_ERR_ARG);
    CHECK(loft_zheng_ball_params(5, LOFT_UNIT(1.25), 0, u) == LOFT_ERR_ARG &&
          loft_zheng_ball_params(6, 0, -LOFT_UNIT(0.25), u) == LOFT_ERR_ARG);
    CHECK(loft_zheng_ball_lift(-LOFT_UNIT(0.25), 0, u) == LOFT_ERR_ARG &&
          loft_zheng_ball_lift(LOFT_UNIT(0.75), LOFT_UNIT(0.5), u) == LOFT_ERR_ARG);
    points.p[arb_below(a, 5)].axis[0] = (loft_real)BY_NUM(0, NAN, NAN);
    CHECK(loft_zheng_ball_init(&r, points.p, 5, 2) ==
          BY_NUM(LOFT_OK, LOFT_ERR_RANGE, LOFT_ERR_RANGE));
    CHECK(BY_NUM(true, r.sides == 77, r.sides == 77));
}

int main(void)
{
    PROPERTY(every_point_has_distances_of_its_own,             60);
    PROPERTY(parameters_fit_together_all_around,             3000);
    PROPERTY(parameters_of_the_mirror_are_mirrored,           500);
    PROPERTY(a_lift_fits_together,                            500);
    PROPERTY(weights_sum_to_one_and_are_within_their_bound,   800);
    PROPERTY(a_point_is_within_its_bound,                     800);
    PROPERTY(parameters_have_their_derivatives,               2000);
    PROPERTY(derivatives_are_limits_of_differences,            400);
    PROPERTY(sides_are_the_curves_of_their_points,            500);
    PROPERTY(parameters_of_a_side_are_exact,                  300);
    PROPERTY(the_same_point_everywhere_makes_a_point,         300);
    PROPERTY(nonsense_is_refused,                              50);
    return check_failures();
}
