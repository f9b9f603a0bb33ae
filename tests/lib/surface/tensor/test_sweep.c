/* tests/lib/surface/tensor/test_sweep.c -- properties of lib/surface/tensor/sweep.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_spline.h"       /* bound_by_num; CHECK, PROPERTY, BY_NUM */
#include "curve/moving_frame.h"
#include "surface/tensor/sweep.h"

#define PIECES   3
#define STATIONS 13     /* so that every fourth one is a joint */

typedef struct {
    loft_vec point[3 * PIECES + 1], section[4], out[4 * STATIONS];
    loft_bezier path[PIECES];
} sample;

static const loft_vec up = { { 0, 0, LOFT_REAL(1) } };

/* Cubics along x that join smoothly; a cubic section of size 10. */
static sample *arb_sample(arb *a)
{
    static sample s;

    for (int k = 0; k <= 3 * PIECES; k++) {
        s.point[k] = arb_vec(a, 4);
        s.point[k].axis[0] = LOFT_REAL(10 * k);
    }
    for (int k = 3; k < 3 * PIECES; k += 3)
        for (int i = 0; i < LOFT_AXES; i++)
            s.point[k + 1].axis[i] = 2 * s.point[k].axis[i] - s.point[k - 1].axis[i];
    for (int k = 0; k < PIECES; k++)
        CHECK(loft_bezier_init(&s.path[k], s.point + 3 * k, 3) == LOFT_OK);
    for (int k = 0; k < 4; k++)
        s.section[k] = arb_vec(a, 10);
    CHECK(loft_sweep_sections(s.path, PIECES, STATIONS, up, s.section, 3, s.out) == LOFT_OK);
    return &s;
}

static void a_section_keeps_its_shape(arb *a)
{
    const sample *s = arb_sample(a);

    for (int k = 0; k < STATIONS; k++)
        for (int i = 0; i < 3; i++)
            CHECK_EXACT(exact_acc(loft_vec_distance(s->out[4 * k + i], s->out[4 * k + i + 1])),
                        exact_acc(loft_vec_distance(s->section[i], s->section[i + 1])),
                        bound_by_num(2 * LSB, 4 * ulp(64), 32 * ulp(64)));
}

/* At the joints the frames stand at the given points, across the given tangents. */
static void it_stands_across_the_path(arb *a)
{
    sample *s = arb_sample(a);
    const loft_vec zero = { { 0 } };

    for (int k = 0; k < 4; k++)
        s->section[k] = zero;
    s->section[1].axis[0] = s->section[2].axis[1] = LOFT_REAL(100);
    CHECK(loft_sweep_sections(s->path, PIECES, STATIONS, up, s->section, 3, s->out) == LOFT_OK);
    for (int k = 0; k <= PIECES; k++) {
        const loft_vec *placed = s->out + 16 * k;
        const loft_vec *p = s->point + 3 * k,
                       along = k ? loft_vec_sub(p[0], p[-1]) : loft_vec_sub(p[1], p[0]);
        CHECK(loft_vec_equal(placed[0], *p) && loft_vec_equal(placed[3], *p));
        for (int i = 1; i < 3; i++)
            CHECK_EXACT(exact_acc(loft_vec_dot(along, loft_vec_sub(placed[i], *p))), 0,
                        bound_by_num(40 * LSB, 0x1p-10L, 0x1p-36L));
    }
}

static void along_a_line_it_only_moves(arb *a)
{
    sample *s = arb_sample(a);
    const loft_vec line[2] = { { { 0 } }, { { LOFT_REAL(1200) } } };
    loft_bezier path;

    CHECK(loft_bezier_init(&path, line, 1) == LOFT_OK);
    CHECK(loft_sweep_sections(&path, 1, STATIONS, up, s->section, 3, s->out) == LOFT_OK);
    for (int k = 0; k < STATIONS; k++)
        for (int i = 0; i < 4; i++) {
            const loft_vec *p = &s->section[i], *q = &s->out[4 * k + i];
            const loft_real want[3] = { loft_vec_axis(p, 2) + LOFT_REAL(100) * (loft_real)k,
                                        -loft_vec_axis(p, 1), loft_vec_axis(p, 0) };
            for (int axis = 0; axis < 3; axis++)
                CHECK_EXACT(exact_of(loft_vec_axis(q, axis)), exact_of(want[axis]),
                            bound_by_num(LSB, ulp(1300), 16 * ulp(1300)) +
                                bound_by_num(0x1p-25L, 0x1p-25L, 0x1p-54L) * 1200);
        }
}

static void mistakes_are_refused(arb *a)
{
    sample *s = arb_sample(a);
    const loft_vec x = { { LOFT_REAL(1) } };
    loft_vec cusp[4] = { { { 0 } } };
    loft_bezier path;

    CHECK(loft_sweep_sections(s->path, 0, 5, up, s->section, 3, s->out) == LOFT_ERR_ARG &&
          loft_sweep_sections(s->path, 1, 1, up, s->section, 3, s->out) == LOFT_ERR_ARG &&
          loft_sweep_sections(s->path, 1, 70000, up, s->section, 3, s->out) == LOFT_ERR_ARG &&
          loft_sweep_sections(s->path, 1, 5, up, s->section, 10, s->out) == LOFT_ERR_ARG);
    cusp[2] = cusp[3] = x;
    CHECK(loft_bezier_init(&path, cusp, 3) == LOFT_OK);
    CHECK(loft_sweep_sections(&path, 1, 5, up, s->section, 3, s->out) == LOFT_SINGULAR);
}

int main(void)
{
    PROPERTY(a_section_keeps_its_shape,  300);
    PROPERTY(it_stands_across_the_path,  300);
    PROPERTY(along_a_line_it_only_moves, 100);
    PROPERTY(mistakes_are_refused,        20);
    return check_failures();
}
