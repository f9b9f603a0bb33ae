/* tests/lib/toolpath/test_raster.c -- properties of lib/toolpath/raster.h
 * SPDX-License-Identifier: MIT
 *
 * By brute force: each point of a fine grid of the surface against each chord of the path.
 */
#include "support/sheets.h"
#include "toolpath/raster.h"

#define ROOM 40000
#define GRID 40

static long double path[ROOM][3];
static unsigned count;

static void walk_raster(loft_raster *r)
{
    loft_vec p;

    for (count = 0; count < ROOM && loft_raster_next(r, &p); count++)
        for (int axis = 0; axis < 3; axis++)
            path[count][axis] = exact_of(p.axis[axis]);
    CHECK(count > 2 && count < ROOM);
}

/* How far above a point, along a direction, a ball that moves along a chord of centres leaves
 * material: the smallest s >= -1 with the distance of p + s n from the chord at most r. */
static long double left_by_chord(const long double p[3], const long double n[3],
                                 const long double a[3], const long double b[3], long double r)
{
    long double least = 1e6L;

    for (int k = 0; k <= 4; k++) {
        long double d[3], along = 0, d2 = 0;
        for (int axis = 0; axis < 3; axis++) {
            d[axis] = a[axis] + (b[axis] - a[axis]) * k / 4 - p[axis];
            along += d[axis] * n[axis];
            d2 += d[axis] * d[axis];
        }
        const long double under = r * r - d2 + along * along;
        if (under >= 0)
            least = fminl(least, along - sqrtl(under));
    }
    return least;
}

/* The least and the largest of what the path leaves on the surface, away from its border. */
static void measure_left(const hills *h, long double r, long double margin, long double found[2])
{
    found[0] = 1e6L;
    found[1] = -1e6L;
    for (uint32_t i = 5; i < GRID - 5; i++)
        for (uint32_t j = 5; j < GRID - 5; j++) {
            long double p[3], n[3], length = 0, least = 1e6L;
            const loft_vec at = hills_of(h, i, j, GRID), u = hills_of(h, i + 1, j, GRID),
                           v = hills_of(h, i, j + 1, GRID), t = hills_of(h, i - 1, j, GRID),
                           w = hills_of(h, i, j - 1, GRID);
            for (int k = 0; k < 3; k++) {
                const int y = (k + 1) % 3, z = (k + 2) % 3;
                p[k] = exact_of(at.axis[k]);
                n[k] = (exact_of(u.axis[y]) - exact_of(t.axis[y])) *
                           (exact_of(v.axis[z]) - exact_of(w.axis[z])) -
                       (exact_of(u.axis[z]) - exact_of(t.axis[z])) *
                           (exact_of(v.axis[y]) - exact_of(w.axis[y]));
                length += n[k] * n[k];
            }
            for (int k = 0; k < 3; k++)
                n[k] /= sqrtl(length);
            if (p[0] < margin || p[1] < margin || p[0] > 8 - margin || p[1] > 8 - margin)
                continue;
            for (unsigned k = 0; k + 1 < count; k++) {
                const long double *a = path[k], *b = path[k + 1];
                if (fabsl(a[1] - p[1]) > r || fabsl(a[0] - p[0]) > r)
                    continue;
                const long double from[3] = { a[0], a[1], a[2] + r },
                                  to[3] = { b[0], b[1], b[2] + r };
                least = fminl(least, left_by_chord(p, n, from, to, r));
            }
            found[0] = fminl(found[0], least);
            found[1] = fmaxl(found[1], least);
        }
}

/* A patch over 0..8 that bends less than the ball. */
static void gentle_hills(arb *a, hills *h)
{
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++) {
            h->p[4 * i + j].axis[0] = loft_real_from_int(8 * i) / 3;
            h->p[4 * i + j].axis[1] = loft_real_from_int(8 * j) / 3;
            h->p[4 * i + j].axis[2] = arb_real(a, 1);
        }
    CHECK(loft_tensor_init(&h->as.tensor, h->p, 3, 3) == LOFT_OK);
    CHECK(loft_sheet_from_tensor(&h->sheet, &h->as.tensor) == LOFT_OK);
}

static const loft_box table = { { { 0, 0, 0 } }, { { LOFT_REAL(8), LOFT_REAL(8), 0 } } };

static void cusps_are_as_asked_and_nothing_is_cut(arb *a)
{
    static hills h;
    const double cusp = arb_below(a, 2) ? 0.1 : 0.08;
    const long double tol = cusp / 25;
    long double found[2];
    loft_cutter c;
    loft_raster r;
    loft_drop d;

    gentle_hills(a, &h);
    CHECK(loft_cutter_init(&c, LOFT_REAL(2), LOFT_REAL(2)) == LOFT_OK);
    CHECK(loft_drop_init(&d, &h.sheet, 1, &c, LOFT_REAL(cusp / 25), -LOFT_REAL(20)) == LOFT_OK);
    const bool spiral = arb_below(a, 2) > 0;
    CHECK((spiral ? loft_raster_init_spiral(&r, &d, &table, LOFT_REAL(cusp), 0)
                  : loft_raster_init(&r, &d, &table, 0, LOFT_REAL(cusp), 0)) == LOFT_OK);
    walk_raster(&r);
    measure_left(&h, 2, 1, found);
    CHECK(found[0] >= BY_NUM(-0x1p-16L, -0x1p-19L, -1e-12L));
    CHECK(found[0] <= tol);
    CHECK(found[1] <= cusp * 1.05L + tol && found[1] >= cusp * (spiral ? 0.6L : 0.8L));
    CHECK(exact_of(r.cusp) <= cusp * 1.0001L && exact_of(r.cusp) > cusp * 0.9L);
}

/* How far a centre is from the path of centres, a radius of 1 above the tips. */
static long double from_path(const long double centre[3])
{
    long double least = 1e6L;

    for (unsigned k = 0; k + 1 < count; k++) {
        long double along = 0, l2 = 0, d2 = 0;
        for (int axis = 0; axis < 3; axis++) {
            const long double by = path[k + 1][axis] - path[k][axis];
            along += by * (centre[axis] - path[k][axis] - (axis == 2));
            l2 += by * by;
        }
        const long double t = l2 > 0 ? fminl(1, fmaxl(0, along / l2)) : 0;
        for (int axis = 0; axis < 3; axis++) {
            const long double on = path[k][axis] + t * (path[k + 1][axis] - path[k][axis]),
                              off = centre[axis] - on - (axis == 2);
            d2 += off * off;
        }
        least = fminl(least, sqrtl(d2));
    }
    return least;
}

/* Over a plane that slopes along both axes the corners of a spiral are acute. A ball of radius 1
 * that touches a point has its centre at a distance d from the path: 1 - sqrt(1 - d^2) is left. */
static void corners_on_slopes_leave_no_more(arb *a)
{
    static hills h;
    const loft_real p = arb_real(a, 3), q = arb_real(a, 3);
    const long double slope[2] = { exact_of(p), exact_of(q) },
                      steep = sqrtl(1 + slope[0] * slope[0] + slope[1] * slope[1]);
    const double cusp = 0.1;
    long double most = 0;
    loft_cutter c;
    loft_raster r;
    loft_drop d;

    gentle_hills(a, &h);
    for (int k = 0; k < 16; k++)
        h.p[k].axis[2] = loft_mul(p, h.p[k].axis[0]) + loft_mul(q, h.p[k].axis[1]);
    CHECK(loft_tensor_init(&h.as.tensor, h.p, 3, 3) == LOFT_OK);
    CHECK(loft_sheet_from_tensor(&h.sheet, &h.as.tensor) == LOFT_OK);
    CHECK(loft_cutter_init(&c, LOFT_REAL(1), LOFT_REAL(1)) == LOFT_OK);
    CHECK(loft_drop_init(&d, &h.sheet, 1, &c, LOFT_REAL(cusp / 25), -LOFT_REAL(60)) == LOFT_OK);
    CHECK(loft_raster_init_spiral(&r, &d, &table, LOFT_REAL(cusp), 0) == LOFT_OK);
    walk_raster(&r);
    for (int i = 0; i <= 50; i++)
        for (int j = 0; j <= 50; j++) {
            const long double x = 1.5L + i / 10.0L, y = 1.5L + j / 10.0L,
                              centre[3] = { x - slope[0] / steep, y - slope[1] / steep,
                                            slope[0] * x + slope[1] * y + 1 / steep },
                              off = from_path(centre);
            most = fmaxl(most, 1 - sqrtl(fmaxl(0, 1 - off * off)));
        }
    CHECK(most <= exact_of(r.cusp) * 1.02L + cusp / 25 && most >= exact_of(r.cusp) * 0.7L);
    CHECK(exact_of(r.cusp) <= cusp * 1.0001L);
}

/* Any cutter over any sheet, and beside it: no point of the path is below the tip of any point. */
static void no_path_cuts(arb *a)
{
    static hills h;
    loft_raster r;
    loft_drop d;

    arb_hills(a, arb_below(a, HILLS_KINDS), 8, &h);
    const loft_cutter c = arb_cutter(a, LOFT_REAL(2));
    CHECK(loft_drop_init(&d, &h.sheet, 1, &c, LOFT_REAL(0.02), -LOFT_REAL(10)) == LOFT_OK);
    CHECK(loft_raster_init(&r, &d, &table, arb_below(a, 2), 0, LOFT_REAL(4)) == LOFT_OK);
    walk_raster(&r);
    CHECK(r.lines == 3);
    for (unsigned k = 0; k + 1 < count; k++)
        for (int part = 0; part < 2; part++) {
            long double at[3];
            for (int axis = 0; axis < 3; axis++)
                at[axis] = path[k][axis] + (path[k + 1][axis] - path[k][axis]) * part / 2;
            CHECK(at[0] >= 0 && at[0] <= 8 && at[1] >= 0 && at[1] <= 8 && at[2] >= -10);
            for (uint32_t i = 0; i <= 16; i++)
                for (uint32_t j = 0; j <= 16; j++) {
                    const loft_vec p = hills_of(&h, i, j, 16);
                    CHECK(tip_over(&c, &p, at[0], at[1]) <= at[2] + 1e-12L);
                }
        }
}

/* Lines begin and end at the border, one after the other, there and back. */
static void lines_follow_each_other(arb *a)
{
    static hills h;
    const unsigned axis = arb_below(a, 2), across = 1 - axis;
    loft_cutter c;
    loft_raster r;
    loft_drop d;
    bool ends[2] = { false, false };

    gentle_hills(a, &h);
    CHECK(loft_cutter_init(&c, LOFT_REAL(1), 0) == LOFT_OK);
    CHECK(loft_drop_init(&d, &h.sheet, 1, &c, LOFT_REAL(0.05), -LOFT_REAL(20)) == LOFT_OK);
    CHECK(loft_raster_init(&r, &d, &table, axis, 0, LOFT_REAL(3)) == LOFT_OK);
    walk_raster(&r);
    CHECK(r.lines == 4);
    for (unsigned k = 0; k < count; k++) {
        CHECK(k == 0 || path[k][across] >= path[k - 1][across]);
        ends[0] = ends[0] || path[k][axis] <= 0;
        ends[1] = ends[1] || path[k][axis] > 7.999L;
    }
    CHECK(path[0][across] <= 0 && path[count - 1][across] > 7.999L && ends[0] && ends[1]);
}

/* A spiral over a flat sheet: all of the area comes within half a step of it, or (2 - sqrt(2)) of
 * one at corners; it never turns to the right, and ends in the middle. */
static void spirals_leave_nothing_out(arb *a)
{
    static hills h;
    const long double step = 0.5L + 0.125L * arb_below(a, 8);
    loft_cutter c;
    loft_raster r;
    loft_drop d;

    gentle_hills(a, &h);
    for (int k = 0; k < 16; k++)
        h.p[k].axis[2] = 0;
    CHECK(loft_tensor_init(&h.as.tensor, h.p, 3, 3) == LOFT_OK);
    CHECK(loft_sheet_from_tensor(&h.sheet, &h.as.tensor) == LOFT_OK);
    CHECK(loft_cutter_init(&c, LOFT_REAL(1), LOFT_REAL(1)) == LOFT_OK);
    CHECK(loft_drop_init(&d, &h.sheet, 1, &c, LOFT_REAL(0.05), -LOFT_REAL(20)) == LOFT_OK);
    CHECK(loft_raster_init_spiral(&r, &d, &table, 0, LOFT_REAL((double)step)) == LOFT_OK);
    walk_raster(&r);
    for (int i = 0; i <= 40; i++)
        for (int j = 0; j <= 40; j++) {
            long double least = 1e6L;
            for (unsigned k = 0; k + 1 < count; k++) {
                const long double *p = path[k], *q = path[k + 1];
                const long double x = q[0] - p[0], y = q[1] - p[1], l2 = x * x + y * y,
                                  to = (0.2L * i - p[0]) * x + (0.2L * j - p[1]) * y,
                                  t = l2 > 0 ? fminl(1, fmaxl(0, to / l2)) : 0;
                least = fminl(least, hypotl(p[0] + t * x - 0.2L * i, p[1] + t * y - 0.2L * j));
            }
            CHECK(least <= 0.5858L * step + 1e-4L);
        }
    for (unsigned k = 0; k + 2 < count; k++)
        CHECK((path[k + 1][0] - path[k][0]) * (path[k + 2][1] - path[k + 1][1]) -
                  (path[k + 1][1] - path[k][1]) * (path[k + 2][0] - path[k + 1][0]) >=
              -1e-9L);
    CHECK(hypotl(path[count - 1][0] - 4, path[count - 1][1] - 4) < 4);
}

static void wrong_rasters_are_refused(arb *a)
{
    static hills h;
    const loft_box empty = { { { 0, 0, 0 } }, { { LOFT_REAL(8), 0, 0 } } };
    const loft_real one = LOFT_REAL(1), half = LOFT_REAL(0.5);
    loft_cutter flat, ball;
    loft_raster r;
    loft_drop d;

    gentle_hills(a, &h);
    CHECK(loft_cutter_init(&flat, one, 0) == LOFT_OK &&
          loft_cutter_init(&ball, one, one) == LOFT_OK);
    CHECK(loft_drop_init(&d, &h.sheet, 1, &flat, LOFT_REAL(0.05), 0) == LOFT_OK);
    CHECK(loft_raster_init(&r, &d, &table, 0, LOFT_REAL(0.1), 0) == LOFT_ERR_ARG);
    CHECK(loft_raster_init(&r, &d, &table, 2, 0, one) == LOFT_ERR_ARG);
    CHECK(loft_raster_init(&r, &d, &table, 0, 0, 0) == LOFT_ERR_ARG);
    CHECK(loft_raster_init(&r, &d, &empty, 0, 0, one) == LOFT_ERR_ARG);
    CHECK(loft_drop_init(&d, &h.sheet, 1, &ball, LOFT_REAL(0.05), 0) == LOFT_OK);
    CHECK(loft_raster_init(&r, &d, &table, 0, half, 0) == LOFT_ERR_ARG);
    CHECK(loft_raster_init(&r, &d, &table, 0, half / 2, half) == LOFT_ERR_ARG);
    CHECK(loft_raster_init(&r, &d, &table, 0, half / 2, 0) == LOFT_OK);
}

int main(void)
{
    PROPERTY_LONG(cusps_are_as_asked_and_nothing_is_cut, 4);
    PROPERTY_LONG(corners_on_slopes_leave_no_more, 8);
    PROPERTY_LONG(no_path_cuts, 4);
    PROPERTY(lines_follow_each_other, 3);
    PROPERTY(spirals_leave_nothing_out, 2);
    PROPERTY(wrong_rasters_are_refused, 1);
    return check_failures();
}
