/* tests/lib/motion/test_thin.c -- properties of lib/motion/thin.h
 * SPDX-License-Identifier: MIT
 */
#define GRAIN_OF(size) BY_NUM(0, ((size) + 1) * 0x1p-23, 0)
#define JUMP_GRAINS(g) (12 * 0x1p-16 + 12 * (g))
#include "support/motion_uses.h"    /* uses_of_spans */

#include "support/motion_paths.h"   /* even_limits */
#include "motion/thin.h"            /* loft_thin_next */

#define MOST 400
#define PART 48

static loft_period   period;
static loft_position points[MOST];
static unsigned      total;             /* of them; the first three are the start */

/* Where the motion is at the knot of point k, in units, exactly. */
static double place_at(unsigned k, int i)
{
    return (points[k - 1].axis[i] + 4.0 * points[k].axis[i] + points[k + 1].axis[i]) / 6;
}

static loft_vec vec_of(const loft_position *p)
{
    loft_vec v;
    for (int i = 0; i < LOFT_AXES; i++)
        v.axis[i] = loft_acc_round(loft_coord_to_acc(p->axis[i]));
    return v;
}

/* All spans of the points; false: one was not given. */
static bool thin_all(void)
{
    static loft_thin thin;
    loft_position sample;
    loft_span s;

    begin_chain();
    curves = 1;
    for (int k = 0; k < 4; k++)
        chain[0].curve.p[k] = vec_of(&points[k < 2 ? 0 : total - 1]);
    loft_thin_begin(&thin, &period, chain[0].curve.p[0]);
    count = 0;
    for (unsigned k = 0; k < total; k++) {
        for (int i = 0; i < LOFT_AXES; i++)
            sample.axis[i] = k == 0 || k + 1 == total ? points[k].axis[i]
                                                      : (loft_coord)floor(place_at(k, i) + 0.5);
        const loft_thin_input in = {
            .point = points[k], .sample = sample, .feed = 1 << 29, .number = (uint16_t)k
        };
        loft_thin_add(&thin, &in);
        if (k + 1 == total)
            loft_thin_end(&thin, chain[0].curve.p[3], period.ticks);
        while (loft_thin_next(&thin, &s))
            spans[count++] = s;
    }
    return count > 0 && thin.passed == total - 2;
}

/* From rest to rest: third differences that are even for a while each, then so that acceleration
 * comes back to 0, a cruise, and all of it the other way. In whole numbers, within the limits and
 * 60 mm. */
static void arb_points(arb *a, unsigned part, unsigned cruise)
{
    const unsigned hold = 1 + arb_below(a, 12);
    double third[PART], most[3];

    total = 3 + 4 * part + cruise + 2;
    for (int i = 0; i < LOFT_AXES; i++) {
        double acc = 0, v = 0, at = 0, jerk = 0, scale = 1;
        most[0] = most[1] = most[2] = 1;
        for (unsigned k = 0; k < part; k++)
            third[k] = jerk = k % hold ? jerk : arb_between(a, -1, 1) * period.jerk[i];
        for (int turn = 0; turn < 2; turn++) {          /* to see how far it goes, then for good */
            acc = v = at = 0;
            for (unsigned k = 0; k < total; k++) {
                const unsigned n = k - 3, m = n < 2 * part ? n : n - 2 * part - cruise;
                const bool moves = k > 2 &&
                                   (n < 2 * part || (n >= 2 * part + cruise && m < 2 * part));
                const double j = floor(scale * third[m < part                  ? m
                                                     : 2 * part - 1 - m < part ? 2 * part - 1 - m
                                                                               : 0]);
                const double sign = (m < part ? 1 : -1) * (n < 2 * part ? 1.0 : -1.0);
                acc += moves ? sign * j : 0;
                v   += acc;
                at  += v;
                points[k].axis[i] = (loft_coord)at;
                most[0] = fmax(most[0], fabs(v));
                most[1] = fmax(most[1], fabs(acc));
                most[2] = fmax(most[2], fabs(at));
            }
            scale = fmin(fmin(0.99, 0.9 * period.speed[i] / most[0]),
                         fmin(0.9 * period.accel[i] / most[1], 0x1p29 / most[2]));
            most[0] = most[1] = most[2] = 1;
        }
    }
}

static void arb_period(arb *a)
{
    even_limits(arb_decades(a, 20, 500), arb_decades(a, 300, 5000), arb_decades(a, 5000, 200000));
    limits.tol = real_of(arb_decades(a, 0.002, 0.1));
    loft_period_init(&period, &limits);
}

static double bezier_at(const loft_span *s, int i, double u)
{
    double q[4];
    for (int k = 0; k < 4; k++)
        q[k] = arb_value(s->p[k].axis[i]);
    for (int r = 3; r > 0; r--)
        for (int k = 0; k < r; k++)
            q[k] += u * (q[k + 1] - q[k]);
    return q[0];
}

/* The largest distance of the spans from the samples, in units. */
static double off_samples(void)
{
    double most = 0;
    unsigned k = 1;

    for (unsigned n = 0; n < count; n++) {
        const unsigned periods = spans[n].ticks / period.ticks;
        for (unsigned m = 1; m <= periods; m++) {
            double square = 0;
            k++;
            for (int i = 0; i < LOFT_AXES; i++) {
                const double at = bezier_at(&spans[n], i, (double)m / periods) * LOFT_COORD_MM;
                square += (at - place_at(k, i)) * (at - place_at(k, i));
            }
            most = fmax(most, sqrt(square));
        }
    }
    return k == total - 2 ? most : 1e300;
}

#define GRAIN 256.0     /* in units */

/* Grains by which velocity jumps from span to span, times the shorter one's length. */
static double velocity_jump(void)
{
    double most = 0;

    for (unsigned n = 1; n < count; n++)
        for (int i = 0; i < LOFT_AXES; i++) {
            double u[3], v[3];
            const double shorter = fmin(duration(&spans[n - 1]), duration(&spans[n]));
            span_speeds(&spans[n - 1], i, u);
            span_speeds(&spans[n], i, v);
            most = fmax(most, fabs(u[2] - v[0]) * shorter * 65536 / 3);
        }
    return most;
}

#define F32_GRAINS BY_NUM(0, 2, 0)      /* by which f32 rounds 64 mm */

static void spans_hold_all_limits_and_follow_the_samples(arb *a)
{
    unsigned ticks = 0;

    arb_period(a);
    arb_points(a, 2 + arb_below(a, 40), arb_below(a, 100));
    CHECK(thin_all());
    CHECK(spans_connect());
    for (unsigned n = 0; n < count; n++) {
        CHECK(spans[n].ticks % period.ticks == 0);
        CHECK(spans[n].ticks <= period.ticks * period.joined);
        ticks += spans[n].ticks;
    }
    CHECK(ticks == (total - 3) * period.ticks);
    const motion_uses u = uses_of_spans(1e9);
    CHECK(u.speed <= 1.001 && u.accel <= BY_NUM(1, 1.005, 1) && u.jerk <= BY_NUM(1, 1.02, 1));
    CHECK(u.jump <= 0.001);
    CHECK_NEAR(velocity_jump(), 0, 4 + 6 * F32_GRAINS);
    CHECK_NEAR(off_samples(), 0, period.off + (2 + F32_GRAINS) * GRAIN);
}

/* Where each period is a span, each ends within a grain and a half of its sample, along each axis:
 * where it has as much acceleration as may be at both ends it ends at one of three grains. */
static void a_span_ends_close_to_its_sample(arb *a)
{
    arb_period(a);
    period.joined = 1;
    arb_points(a, 2 + arb_below(a, 40), arb_below(a, 100));
    CHECK(thin_all());
    CHECK(count == total - 3);
    for (unsigned n = 0; n < count; n++)
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK_NEAR(arb_value(spans[n].p[3].axis[i]) * LOFT_COORD_MM, place_at(n + 2, i),
                       (1.5 + F32_GRAINS) * GRAIN + 1);
}

/* An even stretch takes few spans, however long, and so does one of even jerk. */
static void even_stretches_are_few_spans(arb *a)
{
    const unsigned cruise = 100 + arb_below(a, 100), part = 3;

    arb_period(a);
    arb_points(a, part, cruise);
    CHECK(thin_all());
    CHECK(count <= 4 * part + 2 + (cruise + period.joined - 1) / period.joined + 1);
}

/* Not beyond the feed either, which may fall on the way. */
static void no_span_is_faster_than_the_feed(arb *a)
{
    static loft_thin thin;
    loft_span s;
    double most = 0;

    arb_period(a);
    arb_points(a, 2 + arb_below(a, 40), arb_below(a, 100));
    for (unsigned k = 1; k < total; k++) {
        double square = 0;
        for (int i = 0; i < LOFT_AXES; i++)
            square += pow((double)points[k].axis[i] - points[k - 1].axis[i], 2);
        most = fmax(most, sqrt(square));
    }
    const loft_vec from = vec_of(&points[0]);
    loft_thin_begin(&thin, &period, from);
    for (unsigned k = 0; k < total; k++) {
        loft_thin_input in = {
            .point = points[k], .sample = points[k], .feed = (loft_coord)most + 1, .number = 0
        };
        for (int i = 0; i < LOFT_AXES; i++)
            in.sample.axis[i] = k == 0 || k + 1 == total ? points[k].axis[i]
                                                         : (loft_coord)floor(place_at(k, i) + 0.5);
        loft_thin_add(&thin, &in);
        if (k + 1 == total)
            loft_thin_end(&thin, vec_of(&points[k]), period.ticks);
        while (loft_thin_next(&thin, &s)) {
            double q[5];
            span_squares(&s, 0, 1, q);
            CHECK(sqrt(quartic_peak(q)) * period.ticks / limits.tick_hz * LOFT_COORD_MM <=
                  most + (6 + 6 * F32_GRAINS) * GRAIN);
        }
    }
}

int main(void)
{
    PROPERTY(spans_hold_all_limits_and_follow_the_samples, 400);
    PROPERTY(a_span_ends_close_to_its_sample, 200);
    PROPERTY(even_stretches_are_few_spans, 100);
    PROPERTY(no_span_is_faster_than_the_feed, 200);
    return check_failures();
}
