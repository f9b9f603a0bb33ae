/* tests/lib/motion/test_timing.c -- properties of lib/motion/timing.h, lib/motion/bump.h and
 * lib/motion/emit.h
 * SPDX-License-Identifier: MIT
 */
#include "support/motion_knots.h"   /* arb_path */

#include "motion/bump.h"            /* loft_bump_part */
#include "motion/emit.h"            /* loft_sample_part */

static void creep(void)
{
    for (unsigned k = 0; k < knots; k++)
        knot[k].is.pace.v2 = LOFT_V2_ONE / 1024;
}

static loft_timing timing_of(bool open)
{
    return (loft_timing){ &period, knot, 1, open ? knots - 4 : knots, knots - 2, open };
}

/* What holds holds nearly so between the places that are looked at as well, even for a pace that
 * jumps from knot to knot. */
static void what_holds_holds_all_the_way(arb *a)
{
    arb_path(a);
    for (unsigned k = 0; k < knots; k++)
        knot[k].is.pace.v2 = (int32_t)(LOFT_V2_ONE * arb_decades(a, 0.01, 2));
    for (unsigned k = 1; k + 2 < knots; k++) {
        double use[3];
        uses_of(k, use);
        const bool holds = loft_timing_holds(&period, knot, k, 64);
        if (holds)
            CHECK(use[0] <= 1.001 && use[1] <= 1.1 && use[2] <= 1.3);
        if (use[0] < 0.9 && use[1] < 0.97 && use[2] < 0.97 && knot[k].is.pace.top > 3 * LOFT_V2_ONE)
            CHECK(holds);
    }
}

/* Of a change that part is allowed with which all limits are held, as for any less, and that is not
 * much too small: half as much again, and a quarter of the pace, is too much. */
static void a_part_of_a_change_holds(arb *a)
{
    arb_path(a);
    for (unsigned k = 0; k < knots; k++)
        knot[k].is.pace.v2 = (int32_t)(LOFT_V2_ONE * arb_decades(a, 0.001, 0.002));
    for (unsigned n = 0; n < 200; n++) {
        const unsigned k = 1 + arb_below(a, knots - 3);
        const int share = (int)(16 + arb_below(a, 49));
        int32_t add[3];
        for (int j = 0; j < 3; j++)
            add[j] = (int32_t)(knot[k + 1].is.pace.v2 * arb_decades(a, 0.01, 100));
        if (!loft_timing_holds(&period, knot, k, share))
            continue;
        const int32_t part = loft_bump_part(&period, knot, k, share, add);
        CHECK(part >= 0 && part <= LOFT_BUMP_ONE);
        int32_t before[3];
        for (int j = 0; j < 3; j++)
            before[j] = knot[k + (unsigned)j].is.pace.v2;
        for (int of = 1; of <= 4; of++) {
            for (unsigned j = 0; j < 3; j++)
                knot[k + j].is.pace.v2 = before[j] +
                                         (int32_t)((double)add[j] * part * of / 4 / 32768);
            CHECK(loft_timing_holds(&period, knot, k, share));
        }
        double least = 1e9, most = 0;
        for (unsigned j = 0; j < 3; j++) {
            least = fmin(least, (double)before[j] / add[j]);
            most = fmax(most, part / 32768.0 * add[j] / before[j]);
        }
        const double more = part / 32768.0 * 1.5 + 0.25 * least;
        const bool asked = more < 1 && most < 0.5 && least > 0.5;
        for (unsigned j = 0; j < 3; j++)
            knot[k + j].is.pace.v2 = before[j] + (int32_t)(add[j] * more);
        if (asked)
            CHECK(!loft_timing_holds(&period, knot, k, share));
        for (unsigned j = 0; j < 3; j++)
            knot[k + j].is.pace.v2 = before[j];
    }
}

/* Each raise leaves all limits held, and takes no more time than before. */
static void raising_holds_all_limits(arb *a)
{
    arb_path(a);
    creep();
    const bool open = arb_below(a, 2);
    const loft_timing t = timing_of(open);
    CHECK(loft_timing_all_hold(&t, 1, t.end));
    loft_timing_aim(&t);
    CHECK(loft_timing_all_hold(&t, 1, t.end));
    double before = 1e300;
    for (unsigned n = 0; n < 12; n++) {
        for (unsigned part = 0; part < LOFT_TIMING_PARTS; part++)
            loft_timing_raise_part(&t, n, part);
        CHECK(loft_timing_all_hold(&t, 1, t.end));
        double time = 0;
        for (unsigned k = 1; k < t.end; k++)
            time += (double)loft_sample_time(knot, k);
        CHECK(time <= before * (1 + 1e-9));
        before = time;
    }
    for (unsigned k = knots - 4; open && k < knots; k++)
        CHECK(knot[k].is.pace.v2 == LOFT_V2_ONE / 1024);
    double most = 0;
    for (unsigned k = 1; k + 2 < knots; k++) {
        double use[3];
        uses_of(k, use);
        most = fmax(most, fmax(use[0], fmax(use[1], use[2])));
    }
    /* between knots: emit holds the limits themselves */
    CHECK(most <= 1.15 && (open || most >= 0.99));
}

static void an_even_pace_holds(arb *a)
{
    arb_path(a);
    for (unsigned k = 1; k + 2 < knots; k++) {
        const int32_t v2 = loft_timing_even(&period, knot, k);
        for (unsigned j = k; j <= k + 2; j++)
            knot[j].is.pace.v2 = v2 - v2 / 16;
        CHECK(loft_timing_holds(&period, knot, k, 64));
    }
}

/* The integral of du / sqrt(v2), and back. */
static void times_are_those_of_the_pace(arb *a)
{
    knots = 3;
    knot[0].is.pace.v2 = (int32_t)(LOFT_V2_ONE * arb_decades(a, 0.01, 4));
    for (unsigned k = 1; k < 3; k++)
        knot[k].is.pace.v2 = (int32_t)(knot[k - 1].is.pace.v2 * arb_between(a, 0.75, 1.33));
    double sum = 0, slope, curve;
    const int32_t z = (int32_t)(0x1p30 * arb_between(a, 0, 1));
    double part = 0;
    for (int n = 0; n < 2000; n++) {
        sum  += 1 / sqrt(v2_at(0, (n + 0.5) / 2000, &slope, &curve)) / 2000;
        part += 1 / sqrt(v2_at(0, (n + 0.5) / 2000 * z * 0x1p-30, &slope, &curve)) / 2000 * z *
                0x1p-30;
    }
    CHECK_NEAR((double)loft_sample_time(knot, 0) / 0x1p30, sum, sum * 1e-5);
    CHECK_NEAR(loft_timing_time(knot, 0) / 65536.0, sum, sum * 0.03 + 0x1p-15);
    const loft_sample at = { 0, (loft_time)(part * 0x1p30), 0 };
    CHECK_NEAR(loft_sample_part(&at, knot) * 0x1p-30, z * 0x1p-30, 2e-5);
}

static void passing_in_steps_is_passing_at_once(arb *a)
{
    arb_path(a);
    for (unsigned k = 0; k < knots; k++)
        knot[k].is.pace.v2 = (int32_t)(LOFT_V2_ONE * arb_decades(a, 0.1, 2));
    loft_sample one = { 1, 0, 0 }, many = { 1, 0, 0 };
    const loft_time step = (loft_time)(0x1p30 * arb_between(a, 0.01, 1.5));
    CHECK(loft_sample_pass(&one, knot, knots - 2, 7 * step) == 0 || one.knot == knots - 2);
    for (int n = 0; n < 7; n++)
        (void)loft_sample_pass(&many, knot, knots - 2, step);
    CHECK(one.knot == many.knot && one.time == many.time);
}

int main(void)
{
    PROPERTY(what_holds_holds_all_the_way, 300);
    PROPERTY(a_part_of_a_change_holds, 300);
    PROPERTY(raising_holds_all_limits, 60);
    PROPERTY(an_even_pace_holds, 200);
    PROPERTY(times_are_those_of_the_pace, 500);
    PROPERTY(passing_in_steps_is_passing_at_once, 300);
    return check_failures();
}
