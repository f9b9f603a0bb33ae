/* tests/lib/geom/test_chord.c -- properties of lib/geom/chord.h
 * SPDX-License-Identifier: MIT
 */
#include "geom/chord.h"
#include "support/exact.h"          /* exact_acc, CHECK_EXACT */

typedef struct {
    loft_chord c;
    loft_acc w[LOFT_AXES];
    long double u[LOFT_AXES], x[LOFT_AXES], length, distance, along, size;
} scene;

/* Chords from 1 LSB to the whole range, points near them and far away. */
static void arb_scene(arb *a, scene *s)
{
    const int32_t limits[4] = { 1, 30, 1000, 32767 }, near = limits[arb_below(a, 4)],
                  far = limits[arb_below(a, 4)];
    const int32_t small = arb_below(a, 3) == 0 ? 65536 : 1;
    long double uu = 0, uw = 0, ww = 0, rr = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        s->c.u[i] = loft_acc_ratio(loft_to_acc(arb_real(a, near)), small);
        s->w[i]   = loft_acc_ratio(loft_to_acc(arb_real(a, far)), arb_below(a, 2) ? small : 1);
        s->u[i]   = exact_acc(s->c.u[i]);
        s->x[i]   = exact_acc(s->w[i]);
        uu += s->u[i] * s->u[i];
        uw += s->u[i] * s->x[i];
        ww += s->x[i] * s->x[i];
    }
    loft_chord_aim(&s->c);
    const long double t = uu > 0 ? fminl(fmaxl(uw / uu, 0), 1) : 0;
    for (int i = 0; i < LOFT_AXES; i++)
        rr += (s->x[i] - t * s->u[i]) * (s->x[i] - t * s->u[i]);
    s->length   = sqrtl(uu);
    s->distance = sqrtl(rr);
    s->along    = t * s->length;
    s->size     = fmaxl(s->length, sqrtl(ww));
}

/* The nearest point is on the chord, and at the correct place. */
static void the_foot_is_the_nearest_point(arb *a)
{
    scene s;
    loft_acc r[LOFT_AXES];
    long double rr = 0;

    arb_scene(a, &s);
    const loft_acc at = loft_chord_foot(&s.c, s.w, r);
    const long double slack = BY_NUM(0x1p-31L + s.size * 0x1p-43L, s.size * 0x1p-43L,
                                     s.size * 0x1p-50L);
    for (int i = 0; i < LOFT_AXES; i++)
        rr += exact_acc(r[i]) * exact_acc(r[i]);

    CHECK(at >= 0 && exact_acc(at) <= s.length * (1 + BY_NUM(0x1p-27L, 0x1p-49L, 0x1p-49L)) +
                                          BY_NUM(0x1p-31L, 0, 0));
    CHECK(sqrtl(rr) >= s.distance - slack);
    CHECK(sqrtl(rr) <= s.distance + slack);
    if (s.length > 0x1p-14L)
        CHECK_EXACT(exact_acc(at), s.along,
                    BY_NUM(0x1p-30L + s.length * 0x1p-27L, s.size * 0x1p-43L, s.size * 0x1p-48L) +
                        s.distance * BY_NUM(0x1p-23L, 0x1p-23L, 0x1p-49L));
}

/* It has no direction, and is nearest itself. */
static void a_chord_without_length_is_a_point(arb *a)
{
    scene s;
    loft_acc r[LOFT_AXES];

    arb_scene(a, &s);
    for (int i = 0; i < LOFT_AXES; i++)
        s.c.u[i] = 0;
    loft_chord_aim(&s.c);
    CHECK(s.c.length <= 0 && s.c.length >= 0);
    const loft_acc at = loft_chord_foot(&s.c, s.w, r);
    CHECK(at <= 0 && at >= 0);
    for (int i = 0; i < LOFT_AXES; i++) {
        CHECK(s.c.toward[i] <= 0 && s.c.toward[i] >= 0);
        CHECK(r[i] <= s.w[i] && r[i] >= s.w[i]);
    }
}

int main(void)
{
    PROPERTY(the_foot_is_the_nearest_point, 30000);
    PROPERTY(a_chord_without_length_is_a_point, 1000);
    return check_failures();
}
