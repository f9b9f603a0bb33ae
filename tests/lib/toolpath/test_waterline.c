/* tests/lib/toolpath/test_waterline.c -- properties of lib/toolpath/waterline.h
 * SPDX-License-Identifier: MIT
 */
#include "support/sheets.h"
#include "toolpath/waterline.h"

#define ROOM 20000
#define GRID 64
#define TOL  0.05

static const loft_box table = { { { -LOFT_REAL(12), -LOFT_REAL(12), 0 } },
                                { { LOFT_REAL(48), LOFT_REAL(48), 0 } } };
static long double path[ROOM][3];
static unsigned count;

static loft_vec place(loft_real x, loft_real y)
{
    loft_vec p = { { 0 } };

    p.axis[0] = x;
    p.axis[1] = y;
    return p;
}

/* Begin at the first border along a line y = const., seen from the left. */
static bool begin_at(loft_waterline *w, loft_real y)
{
    const loft_real by = LOFT_REAL(0.5);
    bool clear = false;

    for (loft_real x = -LOFT_REAL(12); x < LOFT_REAL(47); x += by) {
        const bool next = loft_waterline_clear(w, x + by, y);
        if (clear && !next) {
            const loft_vec from = place(x, y), to = place(x + by, y);
            CHECK(loft_waterline_begin(w, &to, &from) == LOFT_ERR_ARG);
            CHECK(loft_waterline_begin(w, &from, &to) == LOFT_OK);
            return true;
        }
        clear = next;
    }
    return false;
}

static void add_point(const loft_vec *p)
{
    CHECK(count < ROOM);
    for (int k = 0; k < 3; k++)
        path[count][k] = exact_of(p->axis[k]);
    count += count + 1 < ROOM;
}

static void walk(loft_waterline *w)
{
    loft_vec p = w->from;

    count = 0;
    add_point(&p);
    while (loft_waterline_next(w, &p))
        add_point(&p);
}

static bool is_same(unsigned i, unsigned k)
{
    return path[i][0] - path[k][0] == 0 && path[i][1] - path[k][1] == 0;
}

/* Is the last point one of those before, and the last chord no return? */
static bool is_back(void)
{
    for (unsigned k = 1; k + 2 < count; k++)
        if (is_same(k, count - 1))
            return true;
    return false;
}

/* Twice the area to the left of the path, which is closed at its second point. */
static long double area_of_path(void)
{
    long double sum = 0;

    for (unsigned k = 1; k + 1 < count; k++)
        sum += path[k][0] * path[k + 1][1] - path[k][1] * path[k + 1][0];
    return sum;
}

/* Around a square plate of 8 mm, with the ball's middle 1 mm above it. */
static void a_plate_is_gone_around_at_its_distance(arb *a)
{
    const long double tol = TOL, pi = 3.14159265358979323846L, beside = sqrtl(3);
    const loft_real side = LOFT_REAL(8);
    hills h;
    loft_waterline w;
    loft_cutter c;
    loft_drop d;

    for (int i = 0; i < 4; i++) {
        h.p[i].axis[0] = i / 2 ? side : 0;
        h.p[i].axis[1] = i % 2 ? side : 0;
        h.p[i].axis[2] = 0;
    }
    CHECK(loft_tensor_init(&h.as.tensor, h.p, 1, 1) == LOFT_OK);
    CHECK(loft_sheet_from_tensor(&h.sheet, &h.as.tensor) == LOFT_OK);
    CHECK(loft_cutter_init(&c, LOFT_REAL(2), LOFT_REAL(2)) == LOFT_OK);
    CHECK(loft_drop_init(&d, &h.sheet, 1, &c, LOFT_REAL(TOL), -LOFT_REAL(20)) == LOFT_OK);
    CHECK(loft_waterline_init(&w, &d, &table, -LOFT_REAL(1)) == LOFT_OK);
    CHECK(begin_at(&w, loft_real_from_int(1 + (int32_t)arb_below(a, 7))));
    walk(&w);
    CHECK(w.closed && count > 12 && count < 400 && is_same(1, count - 1));
    for (unsigned k = 0; k < count; k++) {
        const long double x = fmaxl(fmaxl(-path[k][0], path[k][0] - 8), 0),
                          y = fmaxl(fmaxl(-path[k][1], path[k][1] - 8), 0),
                          distance = sqrtl(x * x + y * y + 1) - 2;
        CHECK(distance >= tol * 0.49L && distance <= tol * 0.75L);
        CHECK(path[k][2] + 1 == 0);
    }
    const long double area = -area_of_path() / 2, least = 64 + 32 * beside + 3 * pi;
    CHECK(area >= least && area <= least + 60 * tol);
}

/* How near the cutter, grown by `by`, is to a grid of points: how far its tip is too low. */
static long double depth_at(const hills *h, const loft_cutter *c, const long double at[3])
{
    long double most = -1000;

    for (uint32_t i = 0; i <= GRID; i++)
        for (uint32_t j = 0; j <= GRID; j++) {
            const loft_vec p = hills_of(h, i, j, GRID);
            most = fmaxl(most, tip_over(c, &p, at[0], at[1]) - at[2]);
        }
    return most;
}

/* Any cutter around any sheet at any height. */
static void no_line_cuts_and_each_comes_back(arb *a)
{
    static hills h;
    loft_waterline w;
    loft_drop d;

    arb_hills(a, arb_below(a, HILLS_KINDS), 8, &h);
    const loft_cutter c = arb_cutter(a, LOFT_REAL(2));
    CHECK(loft_drop_init(&d, &h.sheet, 1, &c, LOFT_REAL(TOL), -LOFT_REAL(20)) == LOFT_OK);
    CHECK(loft_waterline_init(&w, &d, &table, arb_real(a, 5)) == LOFT_OK);
    if (!begin_at(&w, loft_real_from_int((int32_t)arb_below(a, 8))))
        return;
    walk(&w);
    CHECK(w.closed && is_back());
    for (unsigned k = 0; k + 1 < count; k += 1 + count / 64) {
        long double at[3];
        const long double part = arb_below(a, 256) / 256.0L;
        for (int axis = 0; axis < 3; axis++)
            at[axis] = path[k][axis] + (path[k + 1][axis] - path[k][axis]) * part;
        CHECK(depth_at(&h, &c, at) <= 1e-12L);
    }
}

static void wrong_lines_are_refused(arb *a)
{
    static hills h;
    const loft_box empty = { { { 0, 0, 0 } }, { { LOFT_REAL(8), 0, 0 } } };
    const loft_real one = LOFT_REAL(1);
    const loft_vec out = place(-LOFT_REAL(11), 0), beyond = place(-LOFT_REAL(13), 0);
    loft_waterline w;
    loft_cutter ball;
    loft_drop d;

    arb_hills(a, HILLS_TENSOR, 4, &h);
    CHECK(loft_cutter_init(&ball, one, one) == LOFT_OK);
    CHECK(loft_drop_init(&d, &h.sheet, 1, &ball, loft_drop_tol(), 0) == LOFT_OK);
    CHECK(loft_waterline_init(&w, &d, &table, 0) == LOFT_ERR_ARG);
    CHECK(loft_drop_init(&d, &h.sheet, 1, &ball, LOFT_REAL(TOL), 0) == LOFT_OK);
    CHECK(loft_waterline_init(&w, &d, &empty, 0) == LOFT_ERR_ARG);
    CHECK(loft_waterline_init(&w, &d, &table, LOFT_REAL(5000)) == LOFT_ERR_ARG);
    CHECK(loft_waterline_init(&w, &d, &table, BY_NUM(INT32_MIN, -FLT_MAX, (loft_real)-DBL_MAX)) ==
          LOFT_ERR_ARG);
    CHECK(loft_waterline_init(&w, &d, &table, LOFT_REAL(20)) == LOFT_OK);
    CHECK(!loft_waterline_next(&w, &h.p[0]));
    CHECK(loft_waterline_begin(&w, &out, &out) == LOFT_ERR_ARG);
    CHECK(loft_waterline_begin(&w, &out, &beyond) == LOFT_OK);       /* the border of the area */
    walk(&w);
    CHECK(w.closed && count > 100);
    CHECK(loft_cutter_init(&ball, LOFT_REAL(128), one) == LOFT_OK);
    CHECK(loft_drop_init(&d, &h.sheet, 1, &ball, LOFT_REAL(TOL), 0) == LOFT_OK);
    CHECK(loft_waterline_init(&w, &d, &table, 0) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(a_plate_is_gone_around_at_its_distance, 4);
    PROPERTY_LONG(no_line_cuts_and_each_comes_back, 12);
    PROPERTY(wrong_lines_are_refused, 1);
    return check_failures();
}
