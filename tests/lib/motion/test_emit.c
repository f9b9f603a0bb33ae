/* tests/lib/motion/test_emit.c -- properties of lib/motion/emit.h
 * SPDX-License-Identifier: MIT
 */
#define GRAIN_OF(size) BY_NUM(0, ((size) + 1) * 0x1p-23, 0)
#define JUMP_GRAINS(g) (12 * 0x1p-16 + 12 * (g))
#include "support/motion_uses.h"    /* uses_of_spans */

#include "support/motion_paths.h"   /* even_limits */
#include "motion/emit.h"            /* loft_emit_next */

#define SAMPLES 120

static double sample[SAMPLES][LOFT_AXES];
static unsigned samples;

/* A motion from rest to rest whose jerk changes at any time from one limit to the other. */
static void arb_motion(arb *a, const loft_period *p)
{
    double dir[LOFT_AXES];
    const unsigned half = 6 + arb_below(a, 30);
    double jerk[128], at = 0, v = 0, acc = 0;

    arb_direction(a, dir);
    for (unsigned k = 0; k < half; k++)
        jerk[k] = p->jerk[0] * (k < half / 2 ? 1.0 : -1.0) * (2 * (half / 2) == half);
    samples = 2 * half + 1;
    for (unsigned k = 0; k < 2 * half; k++)         /* up, and its mirror */
        jerk[k] = k < half ? (k < half / 2           ? 1
                              : k >= half - half / 2 ? -1
                                                     : 0)
                           : (k - half < half / 2        ? -1
                              : k >= 2 * half - half / 2 ? 1
                                                         : 0);
    for (unsigned k = 0; k < samples; k++) {
        for (int i = 0; i < LOFT_AXES; i++)
            sample[k][i] = at * dir[i];
        const double j = k < 2 * half ? jerk[k] * 0.98 * p->jerk[0] : 0;
        at  += v + acc / 2 + j / 6;
        v   += acc + j / 2;
        acc += j;
    }
    double top = 0, fast = 0;
    for (unsigned k = 1; k < samples; k++)
        for (int i = 0; i < LOFT_AXES; i++) {
            fast = fmax(fast, fabs(sample[k][i] - sample[k - 1][i]));
            top = fmax(top,
                       k > 1 ? fabs(sample[k][i] - 2 * sample[k - 1][i] + sample[k - 2][i]) : 0);
        }
    const double scale = fmin(1, fmin(0.98 * p->accel[0] / top, 0.98 * p->speed[0] / fast));
    for (unsigned k = 0; k < samples; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            sample[k][i] *= scale;
}

static loft_vec vec_of(const loft_position *p)
{
    loft_vec v;
    for (int i = 0; i < LOFT_AXES; i++)
        v.axis[i] = loft_acc_round(loft_coord_to_acc(p->axis[i]));
    return v;
}

static loft_position place_of(unsigned k)
{
    loft_position p;
    for (int i = 0; i < LOFT_AXES; i++)
        p.axis[i] = (loft_coord)floor(sample[k][i] + 0.5);
    return p;
}

static void all_limits_are_held_exactly(arb *a)
{
    static loft_emit emit;
    loft_period p;
    loft_span s;

    even_limits(arb_decades(a, 20, 500), arb_decades(a, 300, 5000), arb_decades(a, 5000, 200000));
    loft_period_init(&p, &limits);
    p.joined = 1;
    arb_motion(a, &p);
    const loft_position first = place_of(0);
    loft_position last = place_of(samples - 1);
    begin_chain();
    curves = 1;
    for (int k = 0; k < 4; k++)
        chain[0].curve.p[k] = vec_of(k < 2 ? &first : &last);
    for (int i = 0; i < LOFT_AXES; i++)             /* the sample is the end that is given */
        last.axis[i] = loft_coord_of(loft_to_acc(chain[0].curve.p[3].axis[i]));
    loft_emit_begin(&emit, &p, chain[0].curve.p[0]);
    count = 0;
    for (unsigned k = 0; k < samples; k++) {
        const loft_position at = k + 1 == samples ? last : place_of(k);
        CHECK(emit.count < LOFT_EMIT_SAMPLES);
        if (k + 1 == samples)
            loft_emit_end(&emit, &at, LOFT_COORD_MM * 16, 0, chain[0].curve.p[3], p.ticks);
        else
            loft_emit_add(&emit, &at, LOFT_COORD_MM * 16, 0);
        while (loft_emit_next(&emit, &s))
            spans[count++] = s;
    }
    CHECK(count == samples - 1);
    CHECK(spans_connect());
    const motion_uses u = uses_of_spans(1e9);
    CHECK(u.speed <= 1.001 && u.accel <= BY_NUM(1, 1.005, 1) && u.jerk <= BY_NUM(1, 1.02, 1));
    for (unsigned k = 0; k < count; k++)        /* the spans pass the samples */
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK_NEAR(arb_value(spans[k].p[3].axis[i]) * LOFT_COORD_MM, sample[k + 1][i],
                       p.jerk[0] * 0.2 + 0x1p8);
}

int main(void)
{
    PROPERTY(all_limits_are_held_exactly, 300);
    return check_failures();
}
