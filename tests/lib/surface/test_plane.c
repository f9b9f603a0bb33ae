/* tests/lib/surface/test_plane.c -- properties of lib/surface/plane.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_whole.h"        /* wide, whole_of */
#include "surface/plane.h"

/* A coordinate of the largest, of an ordinary or of the smallest magnitude: near ties and overflows
 * are frequent. */
static loft_vec arb_point(arb *a)
{
    static const int32_t limit[3] = { 32767 * 65536, 100 * 65536, 3 };
    const int32_t most = limit[arb_below(a, 3)];
    loft_vec v;

    for (int i = 0; i < LOFT_AXES; i++)
        v.axis[i] = loft_real_from_raw(arb_raw(a, most));
    return v;
}

static wide axis_of(loft_vec v, int i)
{
    return i < LOFT_AXES ? whole_of(v.axis[i < LOFT_AXES ? i : 0]) : 0;
}

/* The coefficients of the plane and its value at x as whole numbers, times 2^16 for each factor. */
static wide plane_of(const loft_facet *f, loft_vec x, wide n[3])
{
    wide value = 0;

    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        n[i] = (axis_of(f->p[1], j) - axis_of(f->p[0], j)) *
                   (axis_of(f->p[2], k) - axis_of(f->p[0], k)) -
               (axis_of(f->p[1], k) - axis_of(f->p[0], k)) *
                   (axis_of(f->p[2], j) - axis_of(f->p[0], j));
        value += n[i] * (axis_of(x, i) - axis_of(f->p[0], i));
    }
    return value;
}

static long double length_of(const wide n[3])
{
    const long double x = (long double)n[0], y = (long double)n[1], z = (long double)n[2];
    return sqrtl(x * x + y * y + z * z);
}

/* A result is rounded once, or reported when it does not fit. */
static void check_number(enum loft_status status, loft_real got, long double want)
{
    const long double half = BY_NUM(LSB / 2, 0, 0), top = BY_NUM(32768 - LSB, FLT_MAX, DBL_MAX);
    const bool fits = want < top + half && want > -(BY_NUM(32768, top, top) + half);

    CHECK(status == (fits ? LOFT_OK : LOFT_ERR_RANGE) || fabsl(fabsl(want) - top) < 1 / 1024.0L);
    if (status == LOFT_OK)
        CHECK_EXACT(exact_of(got), want,
                    BY_NUM(LSB / 2 + LSB * LSB, ulp(want), ulp(want)) + fabsl(want) * 0x1p-60L);
}

static void planes_are_exact(arb *a)
{
    const loft_vec x = arb_point(a);
    loft_facet f = { { arb_point(a), arb_point(a), arb_point(a) } };
    loft_real value = 0, distance = 0;
    loft_vec normal = { { 0 } };
    wide n[3];

    if (arb_below(a, 8) == 0)
        f.p[2] = f.p[arb_below(a, 2)];
    const wide at = plane_of(&f, x, n);
    const long double length = length_of(n);
    const enum loft_status over = loft_facet_value(&f, x, &value);
    check_number(over, value, ldexpl((long double)at, -48));
    const enum loft_status status = loft_facet_distance(&f, x, &distance),
                           other = loft_facet_normal(&f, &normal);
    CHECK((status == LOFT_SINGULAR) == !(length > 0) && (other == LOFT_SINGULAR) == !(length > 0));
    if (!(length > 0))
        return;
    check_number(status, distance, (long double)at / length / 65536);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(normal.axis[i]), (i < 3 ? (long double)n[i] : 0) / length,
                    BY_NUM(LSB / 2 + LSB * LSB, ulp(1), ulp(1)));
}

static void lines_are_exact(arb *a)
{
    const loft_vec x = arb_point(a);
    loft_line l = { { arb_point(a), arb_point(a) } };
    loft_real value = 0, distance = 0;
    loft_vec normal = { { 0 } };

    if (arb_below(a, 8) == 0)
        l.p[1] = l.p[0];
    const wide n[3] = { axis_of(l.p[0], 1) - axis_of(l.p[1], 1),
                        axis_of(l.p[1], 0) - axis_of(l.p[0], 0), 0 };
    const wide at = n[0] * (axis_of(x, 0) - axis_of(l.p[0], 0)) +
                    n[1] * (axis_of(x, 1) - axis_of(l.p[0], 1));
    const long double length = length_of(n);
    const enum loft_status over = loft_line_value(&l, x, &value);
    check_number(over, value, ldexpl((long double)at, -32));
    const enum loft_status status = loft_line_distance(&l, x, &distance),
                           other = loft_line_normal(&l, &normal);
    CHECK((status == LOFT_SINGULAR) == !(length > 0) && (other == LOFT_SINGULAR) == !(length > 0));
    if (!(length > 0))
        return;
    check_number(status, distance, (long double)at / length / 65536);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(normal.axis[i]), (i < 2 ? (long double)n[i] : 0) / length,
                    BY_NUM(LSB / 2 + LSB * LSB, ulp(1), ulp(1)));
}

/* The coefficients of the equation; a x + b y + c z + d is the value. */
static void equations_are_exact(arb *a)
{
    const loft_vec origin = { { 0 } };
    const loft_facet f = { { arb_point(a), arb_point(a), arb_point(a) } };
    const loft_line l = { { f.p[0], f.p[1] } };
    loft_real plane[4] = { 0 }, line[3] = { 0 };
    wide n[3];

    const wide at = plane_of(&f, origin, n);
    const long double want[4] = { ldexpl((long double)n[0], -32), ldexpl((long double)n[1], -32),
                                  ldexpl((long double)n[2], -32), ldexpl((long double)at, -48) };
    bool fits = true;
    for (int i = 0; i < 4; i++)
        fits = fits && want[i] < BY_NUM(32768 - LSB / 2, FLT_MAX, DBL_MAX) &&
               want[i] >= BY_NUM(-32768 - LSB / 2, -FLT_MAX, -DBL_MAX);
    const enum loft_status status = loft_facet_equation(&f, plane);
    CHECK(status == (fits ? LOFT_OK : LOFT_ERR_RANGE));
    for (int i = 0; i < 4 && fits; i++)
        CHECK_EXACT(exact_of(plane[i]), want[i],
                    BY_NUM(LSB / 2 + LSB * LSB, ulp(want[i]), ulp(want[i])));
    if (loft_line_equation(&l, line) == LOFT_OK) {
        CHECK_EXACT(exact_of(line[0]),
                    (long double)(axis_of(l.p[0], 1) - axis_of(l.p[1], 1)) / 65536,
                    BY_NUM(0, ulp(65536), 0));
        CHECK_EXACT(exact_of(line[1]),
                    (long double)(axis_of(l.p[1], 0) - axis_of(l.p[0], 0)) / 65536,
                    BY_NUM(0, ulp(65536), 0));
    }
}

/* A point made from the three lies in the plane: its distance is below the effect of rounding. */
static void points_lie_in_their_plane(arb *a)
{
    const loft_facet f = { { arb_vec(a, 5000), arb_vec(a, 5000), arb_vec(a, 5000) } };
    const loft_line l = { { f.p[0], f.p[1] } };
    const loft_unit s = arb_unit(a), t = arb_unit(a);
    loft_vec p = { { 0 } };
    loft_real distance = 0;

    CHECK(loft_facet_eval(&f, s, t, &p) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double p0 = exact_of(f.p[0].axis[i]);
        CHECK_EXACT(exact_of(p.axis[i]),
                    p0 + exact_unit(s) * (exact_of(f.p[1].axis[i]) - p0) +
                        exact_unit(t) * (exact_of(f.p[2].axis[i]) - p0),
                    BY_NUM(LSB / 2 + 2 * 0x1p-33L, ulp(25000), 16 * ulp(5000)));
    }
    if (loft_facet_distance(&f, p, &distance) == LOFT_OK)
        CHECK_EXACT(exact_of(distance), 0, 2 * BY_NUM(LSB, ulp(25000), 16 * ulp(5000)));
    CHECK(loft_line_eval(&l, s, &p) == LOFT_OK);
    if (loft_line_distance(&l, p, &distance) == LOFT_OK)
        CHECK_EXACT(exact_of(distance), 0, 2 * BY_NUM(LSB, ulp(25000), 16 * ulp(5000)));
    CHECK(loft_line_eval(&l, LOFT_UNIT(2.1), &p) == LOFT_ERR_ARG &&
          loft_facet_eval(&f, 0, LOFT_UNIT(-1.1), &p) == LOFT_ERR_ARG);
    const loft_line wild = { { arb_vec(a, 32767), arb_vec(a, 32767) } };
    CHECK(loft_line_eval(&wild, LOFT_UNIT(2), &p) != LOFT_ERR_ARG);
}

/* A change of order reverses the normal; a cyclic one does not. */
static void orientation_follows_the_order(arb *a)
{
    const loft_facet f = { { arb_point(a), arb_point(a), arb_point(a) } };
    const loft_facet cyclic = { { f.p[1], f.p[2], f.p[0] } },
                     turned = { { f.p[0], f.p[2], f.p[1] } };
    loft_vec n[3] = { { { 0 } }, { { 0 } }, { { 0 } } };

    if (loft_facet_normal(&f, &n[0]) != LOFT_OK)
        return;
    CHECK(loft_facet_normal(&cyclic, &n[1]) == LOFT_OK &&
          loft_facet_normal(&turned, &n[2]) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++) {
        CHECK_EXACT(exact_of(n[1].axis[i]), exact_of(n[0].axis[i]), 0);
        CHECK_EXACT(exact_of(n[2].axis[i]), -exact_of(n[0].axis[i]), BY_NUM(LSB, 0, 0));
    }
}

int main(void)
{
    PROPERTY(planes_are_exact, 1500);
    PROPERTY(lines_are_exact, 1500);
    PROPERTY(equations_are_exact, 800);
    PROPERTY(points_lie_in_their_plane, 500);
    PROPERTY(orientation_follows_the_order, 300);
    return check_failures();
}
