/* tests/lib/surface/tensor/test_skin.c -- properties of lib/surface/tensor/skin.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_spline.h"       /* bound_by_num; CHECK, PROPERTY, BY_NUM */
#include "surface/tensor/skin.h"
#include "surface/tensor/tensor.h"

#define SECTIONS 8

typedef struct {
    unsigned degree, sections;
    loft_vec p[SECTIONS * (LOFT_DEGREE_MAX + 1)];
    loft_real v[SECTIONS];
    loft_spline_knot memory[SECTIONS * (LOFT_DEGREE_MAX + 1)];
    loft_skin s;
} sample;

static sample *arb_sample(arb *a)
{
    static sample s;
    int32_t at = -(int32_t)arb_below(a, 1000000);

    s.degree = arb_below(a, LOFT_DEGREE_MAX + 1);
    s.sections = 2 + arb_below(a, SECTIONS - 1);
    for (unsigned k = 0; k < (s.degree + 1) * s.sections; k++)
        s.p[k] = arb_vec(a, 500);
    for (unsigned k = 0; k < s.sections; k++, at += 32768 + (int32_t)arb_below(a, 65536))
        s.v[k] = loft_real_from_raw(at);
    const enum loft_spline_ends ends = arb_below(a, 2) ? LOFT_ENDS_NATURAL : LOFT_ENDS_NOT_A_KNOT;
    CHECK(loft_skin_init(&s.s, s.p, s.degree, s.sections, s.v, ends, s.memory) == LOFT_OK);
    return &s;
}

static void it_meets_every_section(arb *a)
{
    const sample *s = arb_sample(a);
    const unsigned k = arb_below(a, s->sections);
    const loft_unit u = arb_unit(a);
    loft_bezier b;
    loft_vec p = { { 0 } };

    CHECK(loft_bezier_init(&b, &s->p[k * (s->degree + 1)], s->degree) == LOFT_OK);
    CHECK(loft_skin_deriv(&s->s, 0, 0, u, s->v[k], &p) == LOFT_OK);
    const loft_vec q = loft_bezier_eval(&b, u);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(p.axis[i]), exact_of(q.axis[i]),
                    bound_by_num(LSB, 4 * ulp(512), 256 * ulp(512)));
}

/* The pieces as tensor patches, whose control points are rounded. */
static void its_pieces_are_the_same_surface(arb *a)
{
    const sample *s = arb_sample(a);
    const uint32_t j = arb_below(a, s->sections - 1);
    const loft_unit u = arb_unit(a), x = loft_unit_of(arb_below(a, 65), 64);
    loft_vec net[4 * (LOFT_DEGREE_MAX + 1)], p = { { 0 } };
    loft_tensor t;
    const loft_real v = loft_lerp(s->v[j], s->v[j + 1], x);

    CHECK(loft_tensor_from_skin(&s->s, j, net) == LOFT_OK &&
          loft_tensor_init(&t, net, s->degree, 3) == LOFT_OK);
    CHECK(loft_skin_deriv(&s->s, 0, 0, u, v, &p) == LOFT_OK);
    const loft_vec q = loft_tensor_eval(&t, u, x);
    /* v is rounded by 1/2 LSB of a step of half a unit or more; slopes are below 16 * 1024 * 2 */
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(p.axis[i]), exact_of(q.axis[i]),
                    bound_by_num(2 * LSB + 32768 * LSB, 0x1p-8L, 4096 * ulp(4096)));
}

/* Across a section the first two derivatives along v do not jump. */
static void it_is_smooth_across_sections(arb *a)
{
    const sample *s = arb_sample(a);
    const loft_unit u = arb_unit(a);

    for (unsigned k = 1; k + 1 < s->sections; k++)
        for (unsigned i = 0; i <= s->degree; i++)
            for (int axis = 0; axis < LOFT_AXES; axis++)
                for (unsigned order = 1; order < 3; order++) {
                    const loft_sci end = loft_spline_slope(&s->s.line[i], k - 1, order,
                                                           loft_sci_one(), axis);
                    const loft_sci start = loft_spline_slope(&s->s.line[i], k, order,
                                                             loft_sci_zero(), axis);
                    loft_acc jump = 0;
                    CHECK(loft_sci_to_acc(loft_sci_sub(end, start), &jump));
                    CHECK_EXACT(exact_acc(jump), 0, bound_by_num(0x1p-31L, 0x1p-30L, 0x1p-30L));
                }
    (void)u;
}

static void mistakes_are_refused(arb *a)
{
    sample *s = arb_sample(a);
    loft_vec v, net[4 * (LOFT_DEGREE_MAX + 1)];

    CHECK(loft_skin_deriv(&s->s, 3, 0, 0, s->v[0], &v) == LOFT_ERR_ARG &&
          loft_skin_deriv(&s->s, 0, 3, 0, s->v[0], &v) == LOFT_ERR_ARG &&
          loft_skin_deriv(&s->s, 0, 0, LOFT_UNIT(1.5), s->v[0], &v) == LOFT_ERR_ARG);
    CHECK(loft_tensor_from_skin(&s->s, s->sections - 1, net) == LOFT_ERR_ARG);
    CHECK(loft_skin_init(&s->s, s->p, 10, 2, s->v, LOFT_ENDS_NATURAL, s->memory) == LOFT_ERR_ARG);
    CHECK(loft_skin_init(&s->s, s->p, 1, 1, s->v, LOFT_ENDS_NATURAL, s->memory) == LOFT_ERR_ARG);
    CHECK(loft_skin_init(&s->s, s->p, 1, 2, s->v, LOFT_ENDS_CLOSED, s->memory) == LOFT_ERR_ARG);
    s->v[1] = s->v[0];
    CHECK(loft_skin_init(&s->s, s->p, 1, 2, s->v, LOFT_ENDS_NATURAL, s->memory) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(it_meets_every_section,          500);
    PROPERTY(its_pieces_are_the_same_surface, 500);
    PROPERTY(it_is_smooth_across_sections,    200);
    PROPERTY(mistakes_are_refused,             50);
    return check_failures();
}
