/* tests/lib/polygon/test_basepoint.c -- properties of lib/polygon/basepoint.h
 * SPDX-License-Identifier: MIT
 */
#include "support/arb_patch.h"              /* arb_net, power */
#include "curve/rational.h"
#include "polygon/basepoint.h"
#include "polygon/spatch.h"

static net points;

/* Cut-off entries hold arbitrary values, which must not matter. */
static loft_basepoint arb_basepoint(arb *a, bool cuts)
{
    const unsigned d = 1 + arb_below(a, LOFT_DEGREE_MAX);
    uint8_t cut[3] = { 0, 0, 0 }, l[3];
    loft_basepoint b = { .degree = 0 };
    unsigned k = 0;

    while (cuts && (cut[0] + cut[1] + cut[2] == 0 || cut[0] + cut[1] >= (int)d ||
                    cut[1] + cut[2] >= (int)d || cut[2] + cut[0] >= (int)d)) {
        for (int i = 0; i < 3; i++)
            cut[i] = (uint8_t)arb_below(a, arb_below(a, 3) ? d : 1);
        if (d < 2)
            break;
    }
    arb_net(a, &points, loft_multiindex_count(3, d));
    loft_multiindex_first(l, 3, d);
    do {
        for (int i = 0; i < 3; i++)
            if (l[i] + cut[i] > (int)d)
                points.w[k] = (loft_real)BY_NUM(-7, NAN, NAN);
        k++;
    } while (loft_multiindex_next(l, 3));
    CHECK(loft_basepoint_init(&b, points.p, points.w, d, cut) == LOFT_OK);
    return b;
}

/* sum of C w x^i y^j z^k s^(i + j - less); the weight sum is 0 at base points. */
static long double exact_basepoint(const loft_basepoint *b, long double x, long double y,
                                   long double z, long double s, unsigned less,
                                   long double out[LOFT_AXES])
{
    uint8_t l[3];
    long double w = 0;
    unsigned k = 0;

    for (int i = 0; i < LOFT_AXES; i++)
        out[i] = 0;
    loft_multiindex_first(l, 3, b->degree);
    do {
        if (l[0] + b->cut[0] <= b->degree && l[1] + b->cut[1] <= b->degree &&
            l[2] + b->cut[2] <= b->degree) {
            const long double t = loft_multiindex_multinomial(l, 3) * exact_of(b->w[k]) *
                                  power(x, l[0]) * power(y, l[1]) * power(z, l[2]) *
                                  power(s, l[0] + l[1] - less);
            w += t;
            for (int i = 0; i < LOFT_AXES; i++)
                out[i] += t * exact_of(b->p[k].axis[i]);
        }
        k++;
    } while (loft_multiindex_next(l, 3));
    for (int i = 0; i < LOFT_AXES; i++)
        out[i] /= w;
    return w;
}

static void arb_shares(arb *a, loft_unit *one, loft_unit *two)
{
    const uint32_t n = 65536, small[4] = { 0, 1, n - 1, n };
    const uint32_t i = arb_below(a, 4) ? arb_below(a, n + 1) : small[arb_below(a, 4)];
    const uint32_t j = arb_below(a, 4) ? arb_below(a, n - i + 1) : arb_below(a, 2) ? 0 : n - i;

    *one = loft_unit_of(i, n);
    *two = loft_unit_of(j, n);
}

/* On a side the curve's own bound holds. */
static void check_point(const loft_basepoint *b, loft_vec v, const long double want[], bool side)
{
    for (int i = 0; i < LOFT_AXES; i++)
        check_axis(v.axis[i], want[i], points.largest, side ? 0x1p-9L : 0x1p-16L,
                   8 * b->degree + 60);
}

static void a_point_is_within_its_bound_next_to_base_points_too(arb *a)
{
    const loft_basepoint b = arb_basepoint(a, arb_below(a, 4));
    loft_unit one, two;
    long double want[LOFT_AXES];
    loft_vec v = { { 0 } };

    arb_shares(a, &one, &two);
    const long double x = exact_unit(one), y = exact_unit(two);
    const long double w = exact_basepoint(&b, x, y, 1 - x - y, 1, 0, want);
    CHECK(loft_basepoint_eval(&b, one, two, &v) == (w > 0 ? LOFT_OK : LOFT_SINGULAR));
    if (w > 0)
        check_point(&b, v, want, one == 0 || two == 0 || one + two >= LOFT_UNIT(1));
}

static void the_form_in_u_and_v_is_the_same_surface(arb *a)
{
    const loft_basepoint b = arb_basepoint(a, arb_below(a, 4));
    const loft_unit u = loft_unit_of(arb_below(a, 257), 256),
                    v = arb_below(a, 4) ? loft_unit_of(arb_below(a, 257), 256) : 0;
    long double want[LOFT_AXES], same[LOFT_AXES];
    loft_vec p = { { 0 } };

    const long double x = exact_unit(u), y = exact_unit(v);
    const long double w = exact_basepoint(&b, 1 - x, x, 1 - y, y, b.cut[2], want);
    CHECK(loft_basepoint_uv(&b, u, v, &p) == (w > 0 ? LOFT_OK : LOFT_SINGULAR));
    if (!(w > 0))
        return;
    check_point(&b, p, want, false);
    if (y > 0) {
        exact_basepoint(&b, (1 - x) * y, x * y, 1 - y, 1, 0, same);
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK_EXACT(same[i], want[i], 0x1p-50L * points.largest);
    }
}

/* The surface meets every side that is next to it, from base points along lines. */
static void sides_bound_the_surface(arb *a)
{
    const loft_basepoint b = arb_basepoint(a, true);
    const unsigned sides = loft_basepoint_sides(&b), number = arb_below(a, sides);
    const loft_basepoint_side s = loft_basepoint_side_of(&b, number);
    const unsigned c = s.corner, n = (c + 1) % 3, m = (c + 2) % 3;
    const loft_unit t = loft_unit_of(1 + arb_below(a, 255), 256);
    const long double x = exact_unit(t), e = s.cut ? 1e-13L : 0;
    long double phi[3], want[LOFT_AXES];
    loft_vec v = { { 0 } };

    CHECK(sides == 3u + (b.cut[0] > 0) + (b.cut[1] > 0) + (b.cut[2] > 0));
    phi[c] = s.cut ? 1 - e : 1 - x;
    phi[n] = s.cut ? e * x : x;
    phi[m] = s.cut ? e * (1 - x) : 0;
    exact_basepoint(&b, phi[0], phi[1], phi[2], 1, 0, want);
    CHECK(loft_basepoint_boundary(&b, number, t, &v) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++)         /* e times a ratio of two weights with binomials */
        CHECK_EXACT(exact_of(v.axis[i]), want[i],
                    BY_NUM(0.51L * LSB, ulp(points.largest), 150 * ulp_double(points.largest)) +
                        (s.cut ? e * 65536.0L * 65536 * points.largest * power(4, b.degree) : 0));
}

static void sides_meet_at_their_ends(arb *a)
{
    const loft_basepoint b = arb_basepoint(a, arb_below(a, 4));
    const unsigned sides = loft_basepoint_sides(&b);
    loft_vec end = { { 0 } }, start = { { 0 } };

    for (unsigned i = 0; i < sides; i++) {
        CHECK(loft_basepoint_boundary(&b, i, LOFT_UNIT(1), &end) == LOFT_OK);
        CHECK(loft_basepoint_boundary(&b, (i + 1) % sides, 0, &start) == LOFT_OK);
        for (int k = 0; k < LOFT_AXES; k++)
            CHECK_EXACT(exact_of(end.axis[k]), exact_of(start.axis[k]),
                        BY_NUM(0, 1, 1) * ulp(points.largest));
    }
}

/* Without cuts: a rational S-patch of three sides, and edges bit for bit those of the curves. */
static void without_cuts_it_is_a_rational_triangle(arb *a)
{
    const loft_basepoint b = arb_basepoint(a, false);
    loft_spatch s;
    loft_unit one, two;
    loft_vec u = { { 0 } }, v = { { 0 } }, w = { { 0 } };
    loft_weighted side[LOFT_DEGREE_MAX + 1];
    loft_rational r;

    CHECK(loft_spatch_init(&s, points.p, points.w, 3, b.degree) == LOFT_OK);
    arb_shares(a, &one, &two);
    const loft_sci phi[3] = { loft_sci_from_unit(one), loft_sci_from_unit(two),
                              loft_sci_sub(loft_sci_sub(loft_sci_one(), loft_sci_from_unit(one)),
                                           loft_sci_from_unit(two)) };
    CHECK(loft_basepoint_eval(&b, one, two, &u) == LOFT_OK &&
          loft_spatch_eval(&s, phi, &v) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(u.axis[i]), exact_of(v.axis[i]),
                    BY_NUM(1, 1, 256) * ulp(points.largest));
    for (unsigned k = 0; k <= b.degree; k++) {
        const uint8_t l[3] = { (uint8_t)(b.degree - k), (uint8_t)k, 0 };
        side[k].p = points.p[loft_multiindex_rank(l, 3)];
        side[k].w = points.w[loft_multiindex_rank(l, 3)];
    }
    CHECK(loft_rational_init(&r, side, b.degree) == LOFT_OK);
    CHECK(loft_basepoint_boundary(&b, 0, two, &w) == LOFT_OK);
    check_same(w, loft_rational_eval(&r, two));
    CHECK(loft_basepoint_eval(&b, LOFT_UNIT(1) - two, two, &w) == LOFT_OK);
    if (two > 0 && two < LOFT_UNIT(1))
        check_same(w, loft_rational_eval(&r, two));
}

static void nonsense_is_refused(arb *a)
{
    const loft_basepoint good = arb_basepoint(a, true);
    const uint8_t none[3] = { 0, 0, 0 }, all[3] = { 2, 0, 2 };
    loft_basepoint b = { .degree = 77 };
    loft_vec v = { { 0 } };

    CHECK(loft_basepoint_init(&b, points.p, points.w, 0, none) == LOFT_ERR_ARG &&
          loft_basepoint_init(&b, points.p, points.w, 10, none) == LOFT_ERR_ARG);
    CHECK(loft_basepoint_init(&b, points.p, points.w, 4, all) == LOFT_ERR_ARG);
    CHECK(loft_basepoint_eval(&good, LOFT_UNIT(0.75), LOFT_UNIT(0.5), &v) == LOFT_ERR_ARG);
    CHECK(loft_basepoint_eval(&good, -LOFT_UNIT(0.25), LOFT_UNIT(0.5), &v) == LOFT_ERR_ARG);
    CHECK(loft_basepoint_uv(&good, LOFT_UNIT(1.25), 0, &v) == LOFT_ERR_ARG &&
          loft_basepoint_uv(&good, 0, -LOFT_UNIT(0.25), &v) == LOFT_ERR_ARG);
    CHECK(loft_basepoint_boundary(&good, loft_basepoint_sides(&good), 0, &v) == LOFT_ERR_ARG);
    CHECK(loft_basepoint_boundary(&good, 0, LOFT_UNIT(1.5), &v) == LOFT_ERR_ARG);
    arb_net(a, &points, 10);
    points.w[arb_below(a, 10)] = LOFT_REAL(257);
    CHECK(loft_basepoint_init(&b, points.p, points.w, 3, none) == LOFT_ERR_RANGE && b.degree == 77);
}

int main(void)
{
    PROPERTY(a_point_is_within_its_bound_next_to_base_points_too,  2000);
    PROPERTY(the_form_in_u_and_v_is_the_same_surface,              1000);
    PROPERTY(sides_bound_the_surface,                              1000);
    PROPERTY(sides_meet_at_their_ends,                              400);
    PROPERTY(without_cuts_it_is_a_rational_triangle,                500);
    PROPERTY(nonsense_is_refused,                                   100);
    return check_failures();
}
