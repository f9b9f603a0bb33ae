/* tests/lib/path/test_tube.c -- properties of lib/path/tube.h
 * SPDX-License-Identifier: MIT
 */
#include <math.h>                   /* sqrt */

#include "support/motion_paths.h"   /* arb_limits */

#include "path/tube.h"            /* loft_tube_smooth */

#define KNOTS 60

static loft_period period;
static loft_knot   knot[KNOTS];
static unsigned    knots;

/* A path of steps that turn, with corners, and gaps in it that are skipped. */
static void arb_knots(arb *a)
{
    double at[LOFT_AXES] = { 0 }, step[LOFT_AXES];

    arb_limits(a);
    loft_period_init(&period, &limits);
    knots = 8 + arb_below(a, KNOTS - 8);
    arb_direction(a, step);
    for (unsigned k = 0; k < knots; k++) {
        if (arb_below(a, 8) == 0)
            arb_direction(a, step);
        const double size = period.tol * arb_between(a, 0.01, 20);
        knot[k].is.on.loose = arb_below(a, 4) > 0;
        loft_path_set_skip(&knot[k].is.on,
                           arb_below(a, 3) ? 0 : (loft_coord)(period.tol * arb_between(a, 0, 1)));
        for (int i = 0; i < LOFT_AXES; i++) {
            knot[k].is.on.at.axis[i] = (loft_coord)at[i];
            at[i] += size * step[i];
        }
    }
    for (unsigned k = 0; k < knots; k++)
        knot[k].point = knot[k].is.on.at;
    loft_tube_load(knot, 1, knots - 1);
}

static double roughness(void)
{
    double sum = 0;
    for (unsigned k = 3; k < knots; k++)
        for (int i = 0; i < LOFT_AXES; i++) {
            const double d = (double)knot[k].point.axis[i] - 3.0 * knot[k - 1].point.axis[i] +
                             3.0 * knot[k - 2].point.axis[i] - knot[k - 3].point.axis[i];
            sum += d * d;
        }
    return sum;
}

/* The spline through the centres is at the places but for D4 / 36. */
static void the_path_meets_its_places(arb *a)
{
    arb_knots(a);
    for (unsigned k = 3; k + 3 < knots; k++)
        for (int i = 0; i < LOFT_AXES; i++) {
            const double on = ((double)knot[k - 1].point.axis[i] + 4.0 * knot[k].point.axis[i] +
                               knot[k + 1].point.axis[i]) /
                              6;
            const double d4 = (double)knot[k - 2].is.on.at.axis[i] -
                              4.0 * knot[k - 1].is.on.at.axis[i] + 6.0 * knot[k].is.on.at.axis[i] -
                              4.0 * knot[k + 1].is.on.at.axis[i] + knot[k + 2].is.on.at.axis[i];
            CHECK_NEAR(on + d4 / 36, knot[k].is.on.at.axis[i], 4 + 0.002 * period.tol);
        }
}

static void smoothing_stays_within_the_tolerance(arb *a)
{
    static loft_knot before[KNOTS];

    arb_knots(a);
    for (unsigned k = 0; k < knots; k++)
        before[k] = knot[k];
    const double rough = roughness();
    period.one_sided = (uint8_t)(arb_below(a, 2) * arb_below(a, 1u << LOFT_AXES));
    const unsigned from = 3 + arb_below(a, 3), to = knots - 3;
    loft_tube_measure(&period, knot, from < to ? from : to, to);
    loft_tube_smooth(&period, knot, from < to ? from : to, to, 30);
    if (period.one_sided == 0)
        CHECK(roughness() <= rough * 1.01 + 1000.0 * knots);
    for (unsigned k = 0; k < knots; k++) {
        double sum = 0;
        for (int i = 0; i < LOFT_AXES; i++) {
            const double d = (double)knot[k].point.axis[i] - before[k].point.axis[i];
            sum += d * d;
        }
        loft_coord tol = period.tol + period.more;
        for (unsigned i = k - 2; k >= from && k < to && i <= k + 1; i++)
            tol = loft_path_tol(&period, &knot[i].is.on) < tol ? period.tol : tol;
        CHECK(sqrt(sum) <= (k < from || k >= to ? 0 : 6.0 / 7 * tol + 4));
        if (k > 0 && loft_path_skip(&knot[k].is.on) > tol)
            CHECK(sqrt(sum) <= period.tol / 5 + 4);
    }
}

/* A straight line of even steps is as smooth as can be. */
static void a_line_stays_as_it_is(arb *a)
{
    loft_coord step[LOFT_AXES];

    arb_knots(a);
    for (int i = 0; i < LOFT_AXES; i++)
        step[i] = (loft_coord)arb_below(a, 1u << 20) - (1 << 19);
    for (unsigned k = 0; k < knots; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            knot[k].point.axis[i] = knot[k].is.on.at.axis[i] = (loft_coord)k * step[i];
    loft_tube_load(knot, 1, knots - 1);
    loft_tube_measure(&period, knot, 3, knots - 3);
    loft_tube_smooth(&period, knot, 3, knots - 3, 10);
    for (unsigned k = 0; k < knots; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK(knot[k].point.axis[i] == knot[k].is.on.at.axis[i]);
}

int main(void)
{
    PROPERTY(the_path_meets_its_places, 500);
    PROPERTY(smoothing_stays_within_the_tolerance, 300);
    PROPERTY(a_line_stays_as_it_is, 100);
    return check_failures();
}
