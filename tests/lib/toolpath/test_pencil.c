/* tests/lib/toolpath/test_pencil.c -- properties of lib/toolpath/pencil.h
 * SPDX-License-Identifier: MIT
 */
#include "support/sheets.h"
#include "toolpath/pencil.h"

#define HALF 16

/* The plane z = slope . (x, y) over a square, and its upward normal. */
typedef struct {
    loft_vec p[4];
    loft_tensor tensor;
    long double normal[3];
} flank;

static void make_flank(flank *f, loft_real slope_x, loft_real slope_y, loft_sheet *out)
{
    long double length;

    for (int k = 0; k < 4; k++) {
        const int32_t x = k / 2 ? HALF : -HALF, y = k % 2 ? HALF : -HALF;
        f->p[k].axis[0] = loft_real_from_int(x);
        f->p[k].axis[1] = loft_real_from_int(y);
        f->p[k].axis[2] = (x > 0 ? HALF * slope_x : -HALF * slope_x) +
                          (y > 0 ? HALF * slope_y : -HALF * slope_y);
    }
    CHECK(loft_tensor_init(&f->tensor, f->p, 1, 1) == LOFT_OK);
    CHECK(loft_sheet_from_tensor(out, &f->tensor) == LOFT_OK);
    f->normal[0] = -exact_of(slope_x);
    f->normal[1] = -exact_of(slope_y);
    f->normal[2] = 1;
    length = sqrtl(f->normal[0] * f->normal[0] + f->normal[1] * f->normal[1] + 1);
    for (int k = 0; k < 3; k++)
        f->normal[k] /= length;
}

static loft_box make_area(int32_t half)
{
    loft_box area = { { { 0 } }, { { 0 } } };

    for (int k = 0; k < 2; k++) {
        area.min.axis[k] = loft_real_from_int(-half);
        area.max.axis[k] = loft_real_from_int(half);
    }
    return area;
}

/* How far the ball is from one flank, at least; 0: it touches. */
static long double off_of(const flank *f, const loft_vec *tip, long double radius)
{
    long double sum = -radius;

    for (int k = 0; k < 3; k++)
        sum += f->normal[k] * (exact_of(tip->axis[k]) + (k == 2 ? radius : 0));
    return sum;
}

/* Two planes through 0, the higher one of them everywhere: the ball touches both all along. */
static void a_valley_of_planes_is_followed(arb *a)
{
    const loft_real tol = LOFT_REAL(0.01), radius = LOFT_REAL(2);
    const loft_box area = make_area(10);
    loft_touch left, right;
    loft_sheet sheet[2];
    flank f[2];
    loft_cutter c;
    loft_drop d;
    loft_pencil p;
    loft_vec tip;
    unsigned count = 0;

    make_flank(&f[0], -LOFT_REAL(0.7) - loft_real_abs(arb_real(a, 1)), arb_real(a, 1) / 4,
               &sheet[0]);
    make_flank(&f[1], LOFT_REAL(0.7) + loft_real_abs(arb_real(a, 1)), arb_real(a, 1) / 4,
               &sheet[1]);
    CHECK(loft_cutter_init(&c, radius, radius) == LOFT_OK);
    CHECK(loft_drop_init(&d, sheet, 2, &c, tol, -LOFT_REAL(60)) == LOFT_OK);
    CHECK(loft_pencil_init(&p, &d, &area) == LOFT_OK);
    CHECK(loft_pencil_touch(&p, LOFT_REAL(-2), 0, &left));
    CHECK(loft_pencil_touch(&p, LOFT_REAL(2), 0, &right));
    CHECK(loft_pencil_apart(&p, &left, &right));
    for (int back = 0; back < 2; back++) {
        CHECK(loft_pencil_begin(&p, &left, &right, back) == LOFT_OK);
        tip = p.from;
        do {
            for (int k = 0; k < 2; k++) {
                const long double off = off_of(&f[k], &tip, 2);
                CHECK(off > -1e-4L && off < 0.02L);
            }
            count++;
        } while (loft_pencil_next(&p, &tip));
        CHECK(fabsl(exact_of(tip.axis[1])) > 8 || fabsl(exact_of(tip.axis[0])) > 8);
    }
    CHECK(count > 16 && count < 60);
    CHECK(loft_pencil_touch(&p, LOFT_REAL(-3), 0, &right));
    CHECK(loft_pencil_begin(&p, &left, &right, false) == LOFT_SINGULAR);
}

static void wrong_orders_are_refused(arb *a)
{
    const loft_box area = make_area(10), none = make_area(0);
    loft_sheet sheet;
    loft_pencil p;
    loft_cutter c;
    loft_drop d;
    flank f;

    (void)a;
    make_flank(&f, 0, 0, &sheet);
    CHECK(loft_cutter_init(&c, LOFT_REAL(2), LOFT_REAL(2)) == LOFT_OK);
    CHECK(loft_drop_init(&d, &sheet, 1, &c, LOFT_REAL(0.01), 0) == LOFT_OK);
    CHECK(loft_pencil_init(&p, &d, &none) == LOFT_ERR_ARG);
    CHECK(loft_pencil_init(&p, &d, &area) == LOFT_OK);
    CHECK(loft_cutter_init(&d.cutter, LOFT_REAL(2), LOFT_REAL(1)) == LOFT_OK);
    CHECK(loft_pencil_init(&p, &d, &area) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(a_valley_of_planes_is_followed, 20);
    PROPERTY(wrong_orders_are_refused, 1);
    return check_failures();
}
