/* tests/lib/surface/triangle/test_triangle_shape.c -- properties of
 * lib/surface/triangle/triangle_shape.h
 * SPDX-License-Identifier: MIT
 */
#include "check.h"
#include "support/exact_form.h"             /* exact_place, wide */
#include "basis/copositive.h"
#include "surface/triangle/triangle_shape.h"

#define NET_MAX 55

static unsigned net_count(unsigned n) { return (n + 1) * (n + 2) / 2; }

/* Small whole numbers: ties are frequent. */
static void arb_net(arb *a, unsigned n, int32_t limit, int32_t raw[NET_MAX], loft_real net[NET_MAX])
{
    for (unsigned k = 0; k < net_count(n); k++) {
        raw[k] = arb_raw(a, limit);
        net[k] = loft_real_from_raw(raw[k]);
    }
}

/* The same triangle with its corners in the order T2 T3 T1. */
static void turn(unsigned n, const loft_real net[], loft_real out[])
{
    for (unsigned rest = 0; rest <= n; rest++)
        for (unsigned k = 0; k <= rest; k++)
            out[exact_place(k, n - rest)] = net[exact_place(rest - k, k)];
}

static void mirror(unsigned n, const loft_real net[], loft_real out[])
{
    for (unsigned rest = 0; rest <= n; rest++)
        for (unsigned k = 0; k <= rest; k++)
            out[exact_place(k, rest - k)] = net[exact_place(rest - k, k)];
}

/* n! m^n / n! times the value at (x, y, m - x - y) / m */
static wide value_at(unsigned n, const int32_t raw[], int m, int x, int y)
{
    wide sum = 0;

    for (unsigned rest = 0; rest <= n; rest++)
        for (unsigned k = 0; k <= rest; k++) {
            const unsigned i = n - rest, j = rest - k;
            wide term = (wide)loft_binomial(n, i) * loft_binomial(rest, j) * raw[exact_place(j, k)];
            for (unsigned p = 0; p < i; p++)
                term *= x;
            for (unsigned p = 0; p < j; p++)
                term *= y;
            for (unsigned p = 0; p < k; p++)
                term *= m - x - y;
            sum += term;
        }
    return sum;
}

static wide least_value(unsigned n, const int32_t raw[])
{
    wide least = value_at(n, raw, 12, 12, 0);

    for (int x = 0; x <= 12; x++)
        for (int y = 0; x + y <= 12; y++) {
            const wide v = value_at(n, raw, 12, x, y);
            least = v < least ? v : least;
        }
    return least;
}

/* Hadeler's two criteria, by roots and by minors, agree. */
static void nonnegative_is_copositive(arb *a)
{
    int32_t raw[NET_MAX];
    loft_real b[NET_MAX];
    loft_triangle_sign s = { false, false, false, false };
    bool flag = false;

    arb_net(a, 2, (int32_t)1 << arb_below(a, 24), raw, b);
    /* A c b B a C is the upper triangle */
    const loft_real m[6] = { b[0], b[1], b[2], b[3], b[4], b[5] };
    CHECK(loft_triangle2_sign(b, &s) == LOFT_OK && loft_matrix_copositive(m, 3, &flag) == LOFT_OK);
    CHECK(s.nonnegative == flag);
    if (flag)
        CHECK(least_value(2, raw) >= 0);
}

/* Squares x (p u1 + q u2 + r u3)^2 touch zero where the line meets the triangle: nonnegative, and
 * one LSB decides. */
static void squares_are_nonnegative(arb *a)
{
    const int32_t p = (int32_t)arb_below(a, 90), q = (int32_t)arb_below(a, 90), r = -p - q;
    int32_t raw[6] = { p * p, p * q, p * r, q * q, q * r, r * r };
    loft_real b[6];
    loft_triangle_sign s = { false, false, false, false };

    for (int k = 0; k < 6; k++)
        b[k] = loft_real_from_raw(raw[k]);
    CHECK(loft_triangle2_sign(b, &s) == LOFT_OK && s.nonnegative && s.edges && s.determinant);
    const unsigned k = arb_below(a, 6);
    b[k] = loft_real_from_raw(raw[k] - 1);
    CHECK(loft_triangle2_sign(b, &s) == LOFT_OK && !s.nonnegative);
}

static void order_of_the_corners_is_no_matter(arb *a)
{
    int32_t raw[NET_MAX];
    loft_real b[NET_MAX], t[NET_MAX], m[NET_MAX];
    loft_triangle_sign s[3];

    arb_net(a, 2, (int32_t)1 << arb_below(a, 24), raw, b);
    turn(2, b, t);
    mirror(2, b, m);
    CHECK(loft_triangle2_sign(b, &s[0]) == LOFT_OK && loft_triangle2_sign(t, &s[1]) == LOFT_OK &&
          loft_triangle2_sign(m, &s[2]) == LOFT_OK);
    for (int k = 1; k < 3; k++)
        CHECK(s[k].nonnegative == s[0].nonnegative && s[k].edges == s[0].edges &&
              s[k].roots == s[0].roots && s[k].determinant == s[0].determinant);
}

/* sqrt(A B C) + .. in 113 bits */
static void roots_are_those_of_the_definition(arb *a)
{
    int32_t raw[NET_MAX];
    loft_real b[NET_MAX];
    loft_triangle_sign s = { false, false, false, false };

    arb_net(a, 2, arb_below(a, 2) ? 9 : (int32_t)1 << 24, raw, b);
    for (int k = 0; k < 6; k += k == 0 ? 3 : 2) {
        raw[k] = abs(raw[k]);
        b[k] = loft_real_from_raw(raw[k]);
    }
    const wide square[3] = { raw[0], raw[3], raw[5] }, mixed[3] = { raw[4], raw[2], raw[1] };
    CHECK(loft_triangle2_sign(b, &s) == LOFT_OK);
    CHECK(s.roots == exact_roots(square, mixed));
}

static void wang_liu_is_enough(arb *a)
{
    const unsigned n = 1 + arb_below(a, 5);
    int32_t raw[NET_MAX];
    loft_real b[NET_MAX], sums[3];
    bool flag = false;

    arb_net(a, n, 1000, raw, b);
    for (unsigned k = 0; k < net_count(n); k++)
        raw[k] += 600;
    raw[0] += 900 * (int32_t)n, raw[exact_place(n, 0)] += 900 * (int32_t)n,
        raw[exact_place(0, n)] += 900 * (int32_t)n;
    for (unsigned k = 0; k < net_count(n); k++)
        b[k] = loft_real_from_raw(raw[k]);
    CHECK(loft_triangle_wang_liu(b, n, &flag, sums) == LOFT_OK);
    CHECK(flag == (sums[0] >= 0 && sums[1] >= 0 && sums[2] >= 0));
    if (flag)
        CHECK(least_value(n, raw) >= 0);
    else
        CHECK(n > 1 || raw[0] < 0 || raw[1] < 0 || raw[2] < 0);
}

/* A sum that no coordinate holds is reported, and the flag is still right. */
static void wang_liu_reports_what_does_not_fit(arb *a)
{
    loft_real b[NET_MAX], sums[3];
    bool flag = true;

    (void)a;
    for (int k = 0; k < NET_MAX; k++)
        b[k] = LOFT_REAL(-32000);
    CHECK(loft_triangle_wang_liu(b, 9, &flag, sums) == BY_NUM(LOFT_ERR_RANGE, LOFT_OK, LOFT_OK) &&
          !flag);
    CHECK(loft_triangle_wang_liu(b, 0, &flag, sums) == LOFT_ERR_ARG &&
          loft_triangle_wang_liu(b, 10, &flag, sums) == LOFT_ERR_ARG);
}

/* Half the second derivatives of degree n - 2, with x = u1, y = u2, semidefinite at each index: for
 * n = 2 and 3 this is convexity itself, since they are constant or linear. */
static bool hessians_are_semidefinite(const int32_t raw[], int n)
{
    for (int i = n - 2; i >= 0; i--)
        for (int j = n - 2 - i; j >= 0; j--) {
            const unsigned y = (unsigned)j, z = (unsigned)(n - 2 - i - j);
            const wide corner = raw[exact_place(y, z + 2)], x1 = raw[exact_place(y, z + 1)],
                       y1 = raw[exact_place(y + 1, z + 1)];
            const wide xx = raw[exact_place(y, z)] - 2 * x1 + corner,
                       yy = raw[exact_place(y + 2, z)] - 2 * y1 + corner;
            const wide xy = raw[exact_place(y + 1, z)] - x1 - y1 + corner;
            if (xx < 0 || yy < 0 || xx * yy - xy * xy < 0)
                return false;
        }
    return true;
}

/* A net near that of a paraboloid, so that both answers are frequent. */
static unsigned arb_bowl(arb *a, int32_t raw[NET_MAX], loft_real net[NET_MAX])
{
    const unsigned n = 2 + arb_below(a, 4);
    const int32_t p = (int32_t)arb_below(a, 12), q = (int32_t)arb_below(a, 12),
                  r = (int32_t)arb_below(a, 12);

    arb_net(a, n, 1 + (int32_t)arb_below(a, 40), raw, net);
    for (unsigned rest = 0; rest <= n; rest++)
        for (unsigned k = 0; k <= rest; k++) {
            const int32_t i = (int32_t)(n - rest), j = (int32_t)(rest - k), l = (int32_t)k;
            raw[exact_place(rest - k, k)] += 2 * (p * i * i + q * j * j + r * l * l - 3 * i * j);
            net[exact_place(rest - k, k)] = loft_real_from_raw(raw[exact_place(rest - k, k)]);
        }
    return n;
}

static void weak_is_semidefinite(arb *a)
{
    int32_t raw[NET_MAX];
    loft_real net[NET_MAX];
    loft_net_convexity c = { false, false, { false, false, false }, { 0, 0, 0 } };
    const unsigned n = arb_bowl(a, raw, net);

    CHECK(loft_triangle_convex(net, n, &c) == LOFT_OK);
    CHECK(c.weak == hessians_are_semidefinite(raw, (int)n));
    CHECK(!c.net || c.weak);
    CHECK(!c.weak || (c.line[0] && c.line[1] && c.line[2]));
}

static void bowls_are_of_every_kind(arb *a)
{
    int count[3] = { 0, 0, 0 };

    for (int k = 0; k < 300; k++) {
        int32_t raw[NET_MAX];
        loft_real net[NET_MAX];
        loft_net_convexity c = { false, false, { false, false, false }, { 0, 0, 0 } };
        const unsigned n = arb_bowl(a, raw, net);
        CHECK(loft_triangle_convex(net, n, &c) == LOFT_OK);
        count[c.net + c.weak]++;
    }
    CHECK(count[0] > 20 && count[1] > 5 && count[2] > 20);
}

/* Adding a plane changes nothing. Rotating the triangle rotates the directions. The negative net
 * has the negative trends. */
static void convexity_is_affine(arb *a)
{
    int32_t raw[NET_MAX];
    loft_real net[NET_MAX], other[NET_MAX];
    loft_net_convexity c, d;
    const unsigned n = arb_bowl(a, raw, net);
    const int32_t p = arb_raw(a, 5000), q = arb_raw(a, 5000), r = arb_raw(a, 5000);

    CHECK(loft_triangle_convex(net, n, &c) == LOFT_OK);
    for (unsigned rest = 0; rest <= n; rest++)
        for (unsigned k = 0; k <= rest; k++)
            other[exact_place(rest - k, k)] = loft_real_from_raw(
                raw[exact_place(rest - k, k)] + p * (int32_t)(n - rest) + q * (int32_t)(rest - k) +
                r * (int32_t)k);
    CHECK(loft_triangle_convex(other, n, &d) == LOFT_OK && c.net == d.net && c.weak == d.weak);
    for (int x = 0; x < 3; x++)
        CHECK(c.line[x] == d.line[x]);
    turn(n, net, other);
    CHECK(loft_triangle_convex(other, n, &d) == LOFT_OK && c.net == d.net && c.weak == d.weak);
    for (int x = 0; x < 3; x++)
        CHECK(c.line[(x + 1) % 3] == d.line[x] && c.trend[(x + 1) % 3] == d.trend[x]);
    for (unsigned k = 0; k < net_count(n); k++)
        other[k] = -net[k];
    CHECK(loft_triangle_convex(other, n, &d) == LOFT_OK);
    for (int x = 0; x < 3; x++)
        CHECK(c.trend[x] == LOFT_TREND_NONE ? d.trend[x] == LOFT_TREND_NONE
                                            : d.trend[x] == -c.trend[x]);
}

static void planes_are_convex_and_more_is_refused(arb *a)
{
    int32_t raw[NET_MAX];
    loft_real net[NET_MAX];
    loft_net_convexity c = { false, false, { false, false, false }, { 0, 0, 0 } };

    for (unsigned n = 0; n < 2; n++) {
        arb_net(a, n, 1000, raw, net);
        CHECK(loft_triangle_convex(net, n, &c) == LOFT_OK && c.net && c.weak && c.line[0] &&
              c.line[1] && c.line[2]);
    }
    CHECK(loft_triangle_convex(net, 10, &c) == LOFT_ERR_ARG);
    net[2] = BY_NUM(0, 1e30f, 1e300);
    CHECK(loft_triangle_convex(net, 1, &c) == BY_NUM(LOFT_OK, LOFT_ERR_RANGE, LOFT_ERR_RANGE));
}

int main(void)
{
    PROPERTY(nonnegative_is_copositive, 1000);
    PROPERTY(squares_are_nonnegative, 300);
    PROPERTY(order_of_the_corners_is_no_matter, 300);
    PROPERTY(roots_are_those_of_the_definition, 600);
    PROPERTY(wang_liu_is_enough, 300);
    PROPERTY(wang_liu_reports_what_does_not_fit, 1);
    PROPERTY(weak_is_semidefinite, 500);
    PROPERTY(bowls_are_of_every_kind, 1);
    PROPERTY(convexity_is_affine, 300);
    PROPERTY(planes_are_convex_and_more_is_refused, 20);
    return check_failures();
}
