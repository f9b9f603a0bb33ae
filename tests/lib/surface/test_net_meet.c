/* tests/lib/surface/test_net_meet.c -- properties of lib/surface/net_meet.h and net_cell.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact.h"          /* exact_of, exact_unit, exact_eval; CHECK, PROPERTY */
#include "support/meetings.h"       /* distance_from_meetings */
#include "surface/net_ray.h"
#include "surface/octant.h"

#if LOFT_AXES < 3
#  error "patches need space"
#endif

#define ROOM 2000
#define TOL  0.03125L

static loft_net_meeting out[ROOM];
static unsigned count;

static loft_vec at_point(double x, double y, double z)
{
    loft_vec p = { { 0 } };

    p.axis[0] = LOFT_REAL(x);
    p.axis[1] = LOFT_REAL(y);
    p.axis[2] = LOFT_REAL(z);
    return p;
}

static unsigned branches(void)
{
    unsigned sum = 0;

    for (unsigned k = 0; k < count; k++)
        sum += out[k].start;
    return sum;
}

static bool is_closed(unsigned start)
{
    unsigned last = start;

    while (last + 1 < count && !out[last + 1].start)
        last++;
    return last > start && loft_vec_equal(out[start].point, out[last].point);
}


// Heights over one grid
// ---------------------

/* Two heights over the same square: they meet where a polynomial is 0. */
typedef struct {
    loft_vec a[16], b[16];
    loft_tensor s, t;
    unsigned m, n;
} heights;

static void arb_heights(arb *a, heights *h)
{
    h->m = 2 + arb_below(a, 2);
    h->n = 1 + arb_below(a, 3);
    for (unsigned i = 0; i <= h->m; i++)
        for (unsigned j = 0; j <= h->n; j++) {
            const unsigned k = i * (h->n + 1) + j;
            h->a[k] = at_point(12.0 * i / h->m, 12.0 * j / h->n, 0);
            h->b[k] = h->a[k];
            h->a[k].axis[2] = arb_real(a, 6);
            h->b[k].axis[2] = arb_real(a, 6);
        }
    CHECK(loft_tensor_init(&h->s, h->a, h->m, h->n) == LOFT_OK);
    CHECK(loft_tensor_init(&h->t, h->b, h->m, h->n) == LOFT_OK);
}

static long double height_of(const loft_tensor *s, long double u, long double v, int axis)
{
    long double row[LOFT_DEGREE_MAX + 1], column[LOFT_DEGREE_MAX + 1];

    for (unsigned i = 0; i <= s->m; i++) {
        for (unsigned j = 0; j <= s->n; j++)
            row[j] = exact_of(s->p[i * (s->n + 1u) + j].axis[axis]);
        column[i] = exact_eval(row, s->n, v);
    }
    return exact_eval(column, s->m, u);
}

static long double gap_of(const heights *h, long double u, long double v)
{
    return height_of(&h->s, u, v, 2) - height_of(&h->t, u, v, 2);
}

/* Where the heights cross between two places, by halving: is it near a branch? */
static void check_crossing(const heights *h, const long double from[2], const long double to[2])
{
    const bool above = gap_of(h, from[0], from[1]) > 0;
    long double low = 0, high = 1, u = from[0], v = from[1], p[3];

    if (above == (gap_of(h, to[0], to[1]) > 0))
        return;
    for (int k = 0; k < 60; k++) {
        const long double t = (low + high) / 2;
        u = from[0] + t * (to[0] - from[0]);
        v = from[1] + t * (to[1] - from[1]);
        *((gap_of(h, u, v) > 0) == above ? &low : &high) = t;
    }
    if (fminl(u, 1 - u) < TOL / 12 && fminl(v, 1 - v) < TOL / 12)
        return;                                         /* a branch across a corner may be short */
    for (int axis = 0; axis < 3; axis++)
        p[axis] = height_of(&h->s, u, v, axis);
    CHECK(distance_from_meetings(out, count, p) <= 2 * TOL);
}

static void heights_meet_everywhere_they_cross(arb *a)
{
    const int n = 24;
    heights h;

    arb_heights(a, &h);
    const enum loft_status status = loft_net_meet(
        loft_net_from_tensor(&h.s), loft_net_from_tensor(&h.t), LOFT_REAL(TOL), out, ROOM, &count);
    CHECK(status == LOFT_OK || status == LOFT_SINGULAR);
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= n; j++) {
            const long double at[2] = { (long double)i / n, (long double)j / n },
                              next_u[2] = { (i + 1.0L) / n, at[1] },
                              next_v[2] = { at[0], (j + 1.0L) / n };
            if (i < n)
                check_crossing(&h, at, next_u);
            if (j < n)
                check_crossing(&h, at, next_v);
        }
}

/* Each point lies on both, at the parameters that it names. */
static void points_lie_on_both(arb *a)
{
    heights h;

    arb_heights(a, &h);
    (void)!loft_net_meet(loft_net_from_tensor(&h.s), loft_net_from_tensor(&h.t), LOFT_REAL(TOL),
                         out, ROOM, &count);
    for (unsigned k = 0; k < count; k++)
        for (int axis = 0; axis < 3 && !out[k].touch; axis++) {
            const long double p = exact_of(out[k].point.axis[axis]),
                              lsb = BY_NUM(0x1p-17L, 0x1p-20L, 0x1p-40L),
                              unit = BY_NUM(0x1p-25L, 0x1p-25L, 0x1p-38L);
            /* heights: at most 3 * 12 per parameter, sums of two */
            CHECK_NEAR(height_of(&h.s, exact_unit(out[k].at[0]), exact_unit(out[k].at[1]), axis), p,
                       lsb + 72 * unit);
            CHECK_NEAR(height_of(&h.t, exact_unit(out[k].at[2]), exact_unit(out[k].at[3]), axis), p,
                       lsb + 72 * unit);
        }
}


// Known curves
// ------------

/* Parabolas z = 8 - x^2/8 and z = 8 - y^2/8 over a square: they meet in x = y and x = -y. */
static void branches_cross_where_both_are_level(arb *a)
{
    const int side = 4 + (int)arb_below(a, 5);
    loft_vec p[6], q[6];
    loft_tensor s, t;

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 2; j++) {
            const double z = 8 + (i == 1 ? 1 : -1) * side * side / 8.0;
            p[2 * i + j] = at_point(side * (i - 1), side * (2 * j - 1), z);
            q[2 * i + j] = at_point(side * (2 * j - 1), side * (i - 1), z);
        }
    CHECK(loft_tensor_init(&s, p, 2, 1) == LOFT_OK && loft_tensor_init(&t, q, 2, 1) == LOFT_OK);
    const enum loft_status status = loft_net_meet(
        loft_net_from_tensor(&s), loft_net_from_tensor(&t), LOFT_REAL(TOL), out, ROOM, &count);
    CHECK(status == LOFT_OK || status == LOFT_SINGULAR);
    for (int k = -50; k <= 50; k++)
        for (int sign = -1; sign <= 1; sign += 2) {
            const long double x = side * k / 50.0L, at[3] = { x, sign * x, 8 - x * x / 8 };
            CHECK(distance_from_meetings(out, count, at) <= 2 * TOL);
        }
    for (unsigned k = 0; k < count; k++) {
        const long double x = exact_of(out[k].point.axis[0]), y = exact_of(out[k].point.axis[1]);
        CHECK_NEAR(fabsl(x), fabsl(y), out[k].touch ? 16 * TOL : TOL / 4);
    }
}

/* A quarter of x^2 + z^2 = R^2 through one of y^2 + z^2 = r^2, r < R, with exact weights. */
static void cylinders_meet_in_one_curve(arb *a)
{
    const double big = 8, small = 3 + arb_below(a, 4);
    loft_weighted p[6], q[6];
    loft_tensor_rational s, t;

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 2; j++) {
            const double c = i < 2, d = i > 0, along = 20 * j - 10;
            p[2 * i + j].p = at_point(big * c, along, big * d);
            q[2 * i + j].p = at_point(along, small * c, small * d);
            p[2 * i + j].w = q[2 * i + j].w = LOFT_REAL(i < 2 ? 1 : 2);
        }
    CHECK(loft_tensor_rational_init(&s, p, 2, 1) == LOFT_OK);
    CHECK(loft_tensor_rational_init(&t, q, 2, 1) == LOFT_OK);
    CHECK(loft_net_meet(loft_net_from_tensor_rational(&s), loft_net_from_tensor_rational(&t),
                        LOFT_REAL(TOL), out, ROOM, &count) == LOFT_OK);
    CHECK(branches() == 1);
    for (int k = 0; k <= 100; k++) {
        const long double turn = 1.57079632679489661923L * k / 100, y = small * cosl(turn),
                          z = small * sinl(turn), at[3] = { sqrtl(big * big - z * z), y, z };
        CHECK(distance_from_meetings(out, count, at) <= TOL);
    }
    for (unsigned k = 0; k < count; k++) {
        const long double x = exact_of(out[k].point.axis[0]), y = exact_of(out[k].point.axis[1]),
                          z = exact_of(out[k].point.axis[2]);
        CHECK_NEAR(hypotl(x, z), big, BY_NUM(0x1p-16L, 0x1p-19L, 0x1p-35L));
        CHECK_NEAR(hypotl(y, z), small, BY_NUM(0x1p-16L, 0x1p-19L, 0x1p-35L));
    }
}

/* The octant of a sphere and a plane z = h: a quarter of a circle. */
static void a_plane_cuts_an_octant_in_an_arc(arb *a)
{
    const double height = 1 + arb_below(a, 7);
    const long double r = sqrtl(64 - height * height);
    loft_weighted p[15];
    loft_vec q[4];
    loft_triangle_rational s;
    loft_tensor t;

    CHECK(loft_octant_from_radius(LOFT_REAL(8), p) == LOFT_OK);
    CHECK(loft_triangle_rational_init(&s, p, 4) == LOFT_OK);
    for (int i = 0; i < 4; i++)
        q[i] = at_point(30 * (i / 2) - 11, 32 * (i % 2) - 13, height);
    CHECK(loft_tensor_init(&t, q, 1, 1) == LOFT_OK);
    CHECK(loft_net_meet(loft_net_from_tensor(&t), loft_net_from_triangle_rational(&s),
                        LOFT_REAL(TOL), out, ROOM, &count) == LOFT_OK);
    CHECK(branches() == 1);
    for (int k = 0; k <= 100; k++) {
        const long double turn = 1.57079632679489661923L * k / 100,
                          at[3] = { r * cosl(turn), r * sinl(turn), height };
        CHECK(distance_from_meetings(out, count, at) <= TOL);
    }
}

/* z = (x^2 + y^2) / 8 and a level plane: a circle, or nothing. */
static void a_bowl_is_cut_in_a_closed_curve(arb *a)
{
    const double level[] = { -0.5, 0.015625, 0.5, 4 };
    const double height = level[arb_below(a, 4)];
    loft_vec p[9], q[4];
    loft_tensor s, t;

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            p[3 * i + j] = at_point(8 * (i - 1), 8 * (j - 1),
                                    (i == 1 ? -8 : 8) + (j == 1 ? -8 : 8));
    for (int i = 0; i < 4; i++)
        q[i] = at_point(50 * (i / 2) - 23, 50 * (i % 2) - 21, height);
    CHECK(loft_tensor_init(&s, p, 2, 2) == LOFT_OK && loft_tensor_init(&t, q, 1, 1) == LOFT_OK);
    CHECK(loft_net_meet(loft_net_from_tensor(&s), loft_net_from_tensor(&t), LOFT_REAL(TOL), out,
                        ROOM, &count) == LOFT_OK);
    CHECK(height < 0 ? count == 0 : branches() == 1 && is_closed(0));
    for (unsigned k = 0; k < count; k++)
        CHECK_NEAR(hypotl(exact_of(out[k].point.axis[0]), exact_of(out[k].point.axis[1])),
                   sqrtl(8 * height), BY_NUM(0x1p-13L, 0x1p-16L, 0x1p-32L));
}

static void surfaces_that_coincide_say_so(arb *a)
{
    heights h;

    arb_heights(a, &h);
    CHECK(loft_net_meet(loft_net_from_tensor(&h.s), loft_net_from_tensor(&h.s), LOFT_REAL(0.5), out,
                        8, &count) == LOFT_MORE);
}

/* A net whose parameters are turned round and exchanged is the same surface; one moved point makes
 * another one. */
static void nets_in_another_order_are_the_same(arb *a)
{
    loft_vec other[16], points[15], turned[15];
    loft_tensor t;
    loft_triangle first, second;
    heights h;

    arb_heights(a, &h);
    const unsigned order = arb_below(a, 8), rows = h.m + 1, columns = h.n + 1;
    const bool crossed = order & 4;
    for (unsigned i = 0; i < rows; i++)
        for (unsigned j = 0; j < columns; j++) {
            const unsigned x = order & 1 ? rows - 1 - i : i, y = order & 2 ? columns - 1 - j : j;
            other[crossed ? y * rows + x : x * columns + y] = h.a[i * columns + j];
        }
    CHECK(loft_tensor_init(&t, other, crossed ? h.n : h.m, crossed ? h.m : h.n) == LOFT_OK);
    CHECK(loft_net_same(loft_net_from_tensor(&h.s), loft_net_from_tensor(&t)));
    other[arb_below(a, rows * columns)].axis[2] += LOFT_REAL(0.5);
    CHECK(!loft_net_same(loft_net_from_tensor(&h.s), loft_net_from_tensor(&t)));

    const unsigned n = 1 + arb_below(a, 4), corners = (n + 1) * (n + 2) / 2;
    for (unsigned k = 0; k < corners; k++)
        points[k] = arb_vec(a, 10);
    for (unsigned i = 0; i <= n; i++)               /* T1, T2, T3 become T2, T3, T1 */
        for (unsigned k = 0; k <= i; k++) {
            const unsigned one = n - i, two = i - k, three = k;
            turned[(one + three) * (one + three + 1) / 2 + one] = points[i * (i + 1) / 2 + k];
            CHECK(one + two + three == n);
        }
    CHECK(loft_triangle_init(&first, points, n) == LOFT_OK &&
          loft_triangle_init(&second, turned, n) == LOFT_OK);
    CHECK(loft_net_same(loft_net_from_triangle(&first), loft_net_from_triangle(&second)));
    CHECK(!loft_net_same(loft_net_from_triangle(&first), loft_net_from_tensor(&t)));
    turned[arb_below(a, corners)].axis[1] += LOFT_REAL(0.25);
    CHECK(!loft_net_same(loft_net_from_triangle(&first), loft_net_from_triangle(&second)));
}


// Curves
// ------

/* A line as a curve of degree 1 meets what a ray meets. */
static void a_line_meets_what_a_ray_meets(arb *a)
{
    loft_vec p[2];
    loft_bezier b;
    loft_ray_hit hit[20];
    unsigned hits;
    heights h;

    arb_heights(a, &h);
    for (int axis = 0; axis < 3; axis++) {
        p[0].axis[axis] = LOFT_REAL(6) + arb_real(a, 10);
        p[1].axis[axis] = LOFT_REAL(6) + arb_real(a, 10);
    }
    const loft_vec d = loft_vec_sub(p[1], p[0]);
    if (loft_net_ray(loft_net_from_tensor(&h.s), p[0], d, hit, 20, &hits) != LOFT_OK ||
        loft_bezier_init(&b, p, 1) != LOFT_OK)
        return;
    CHECK(loft_net_meet(loft_net_from_bezier(&b), loft_net_from_tensor(&h.s), LOFT_REAL(TOL), out,
                        ROOM, &count) >= 0);
    for (unsigned k = 0; k < hits; k++) {
        long double at[3];
        if (exact_acc(hit[k].t) > 1)
            continue;
        for (int axis = 0; axis < 3; axis++)
            at[axis] = exact_of(p[0].axis[axis]) + exact_acc(hit[k].t) * exact_of(d.axis[axis]);
        CHECK(distance_from_meetings(out, count, at) <= 2 * TOL);
    }
    for (unsigned k = 0; k < count; k++) {
        bool found = out[k].touch;
        for (unsigned i = 0; i < hits; i++)
            found = found || fabsl(exact_acc(hit[i].t) - exact_unit(out[k].at[0])) < 0x1p-18L;
        CHECK(out[k].start && found);
    }
}

/* A cubic whose middle lies on the patch. */
static void a_curve_through_a_patch_is_found(arb *a)
{
    loft_vec p[4];
    loft_bezier b;
    heights h;

    arb_heights(a, &h);
    const loft_vec at = loft_tensor_eval(&h.s, LOFT_UNIT(0.375), LOFT_UNIT(0.625));
    for (int i = 0; i < 4; i++)
        p[i] = arb_vec(a, 10);
    for (int axis = 0; axis < 3; axis++)                /* p0 + 3 p1 + 3 p2 + p3 = 8 at */
        p[3].axis[axis] = 8 * at.axis[axis] - p[0].axis[axis] -
                          3 * (p[1].axis[axis] + p[2].axis[axis]);
    CHECK(loft_bezier_init(&b, p, 3) == LOFT_OK);
    const enum loft_status status = loft_net_meet(
        loft_net_from_bezier(&b), loft_net_from_tensor(&h.s), LOFT_REAL(TOL), out, ROOM, &count);
    const long double known[3] = { exact_of(at.axis[0]), exact_of(at.axis[1]),
                                   exact_of(at.axis[2]) };
    CHECK(status == LOFT_OK || status == LOFT_SINGULAR);
    CHECK(distance_from_meetings(out, count, known) <= 2 * TOL);
}

static void what_cannot_meet_is_refused(arb *a)
{
    loft_bezier b;
    heights h;

    arb_heights(a, &h);
    const loft_net net = loft_net_from_tensor(&h.s);
    CHECK(loft_bezier_init(&b, h.a, 2) == LOFT_OK);
    CHECK(loft_net_meet(net, loft_net_from_bezier(&b), LOFT_REAL(1), out, ROOM, &count) ==
              LOFT_ERR_ARG &&
          count == 0);
    CHECK(loft_net_meet(net, net, 0, out, ROOM, &count) == LOFT_ERR_ARG && count == 0);
    CHECK(loft_net_meet(net, net, LOFT_REAL(BY_NUM(0x1p-14, 0x1p-18, 0x1p-46)), out, ROOM,
                        &count) == LOFT_ERR_RANGE &&
          count == 0);
}

int main(void)
{
    PROPERTY(heights_meet_everywhere_they_cross, 12);
    PROPERTY(points_lie_on_both, 12);
    PROPERTY_LONG(branches_cross_where_both_are_level, 3);
    PROPERTY(cylinders_meet_in_one_curve, 4);
    PROPERTY_LONG(a_plane_cuts_an_octant_in_an_arc, 3);
    PROPERTY(a_bowl_is_cut_in_a_closed_curve, 5);
    PROPERTY(surfaces_that_coincide_say_so, 2);
    PROPERTY(nets_in_another_order_are_the_same, 200);
    PROPERTY(a_line_meets_what_a_ray_meets, 20);
    PROPERTY(a_curve_through_a_patch_is_found, 20);
    PROPERTY(what_cannot_meet_is_refused, 2);
    return check_failures();
}
