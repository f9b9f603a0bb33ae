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

/* How far the path through the centres is from its cubics: at knot k, and in the middle between it
 * and the next. */
static loft_coord off_at(unsigned k)
{
    const loft_path_place *at[5];
    loft_position p;

    loft_tube_places(knot, k - 2, 5, at);
    loft_tube_place(knot, k, 0, &p);
    return loft_path_miss(at, &p);
}

static loft_coord off_behind(unsigned k)
{
    const loft_path_place *at[4];
    loft_position p;

    loft_tube_places(knot, k - 1, 4, at);
    loft_tube_place(knot, k, 1 << 29, &p);
    return loft_path_off(at, 1 << 23, &p);
}

/* A point may be moved by what that and what is skipped leave of the tolerance of the ways that it
 * matters for, and by no more than 6/7 of it. Where the path begins, nothing is off. */
static void what_the_tolerance_leaves_is_room(arb *a)
{
    arb_knots(a);
    const unsigned from = 3 + arb_below(a, 3), to = knots - 3;
    if (from >= to)
        return;
    loft_tube_measure(&period, knot, from, to);
    for (unsigned k = from; k < to; k++) {
        double tol = period.tol + period.more, left = tol;
        for (unsigned i = k - 2; i <= k + 1; i++) {
            const loft_path_place *on = &knot[i].is.on;
            tol = fmin(tol, loft_path_tol(&period, on));
            if (i < to)
                left = fmin(left,
                            period.tube + (on->loose ? period.more : 0) - loft_path_skip(on) -
                                fmax(i == 1 ? 0 : off_at(i), fmax(off_at(i + 1), off_behind(i))));
        }
        CHECK_NEAR(knot[k].is.on.room, fmax(0, fmin(left, 6 / 7.0 * tol)) / LOFT_COORD_GRAIN, 2.1);
    }
}

/* A path that begins, or ends, does so in its first three points, or in the last ones. */
static void the_path_begins_and_ends_at_rest(arb *a)
{
    const bool begins = arb_below(a, 2), ends = arb_below(a, 2);
    static loft_knot before[KNOTS];

    arb_knots(a);
    for (unsigned k = 0; k < knots; k++)
        knot[k].point.axis[0] += 1000;
    memcpy(before, knot, sizeof knot);
    loft_tube_tie(knot, knots, begins, ends);
    for (unsigned k = 0; k < KNOTS; k++) {
        const loft_position *want = begins && k < 3          ? &before[0].is.on.at
                                    : ends && k + 3 >= knots && k < knots
                                        ? &before[knots - 1].is.on.at
                                        : &before[k].point;
        CHECK(memcmp(&knot[k].point, want, sizeof *want) == 0);
        CHECK(memcmp(&knot[k].is, &before[k].is, sizeof knot[k].is) == 0);
    }
}

/* The spline, to the last bit at a knot. */
static void a_place_is_on_the_spline(arb *a)
{
    loft_position p;

    arb_knots(a);
    const unsigned k = 1 + arb_below(a, knots - 3);
    const int32_t z = arb_below(a, 3) ? (int32_t)arb_below(a, 1 << 30) : 0;
    loft_tube_place(knot, k, z, &p);
    for (int i = 0; i < LOFT_AXES; i++) {
        const double x = ldexp(z, -30),
                     q[4] = { knot[k - 1].point.axis[i], knot[k].point.axis[i],
                              knot[k + 1].point.axis[i], knot[k + 2].point.axis[i] };
        const double w[4] = { (1 - x) * (1 - x) * (1 - x), 3 * x * x * x - 6 * x * x + 4,
                              -3 * x * x * x + 3 * x * x + 3 * x + 1, x * x * x };
        CHECK_NEAR(p.axis[i], (w[0] * q[0] + w[1] * q[1] + w[2] * q[2] + w[3] * q[3]) / 6,
                   z > 0 ? 1 : 0.51);
    }
}

/* Where many sweeps lead: no point can move so that third differences become smaller, but out of
 * its ball. Into that it is pulled by a factor of 15 bits. */
static void no_path_in_the_tube_is_smoother(arb *a)
{
    static const double weight[7] = { 1, -6, 15, -20, 15, -6, 1 };
    static loft_knot centre[KNOTS];

    arb_knots(a);
    knots = 7 + arb_below(a, 5);
    memcpy(centre, knot, sizeof knot);
    loft_tube_measure(&period, knot, 3, knots - 3);
    loft_tube_smooth(&period, knot, 3, knots - 3, 400);
    for (unsigned k = 3; k + 3 < knots; k++) {
        const double room = knot[k].is.on.room * (double)LOFT_COORD_GRAIN;
        double wanted[LOFT_AXES], off = 0, along = 0, across = 0, size = 0;
        for (int i = 0; i < LOFT_AXES; i++) {
            const double e = (double)knot[k].point.axis[i] - centre[k].point.axis[i];
            wanted[i] = 0;
            for (unsigned n = 0; n < 7; n++)
                wanted[i] += weight[n] * knot[k + n - 3].point.axis[i] / 20;
            off += e * e;
            along += wanted[i] * e;
            size += wanted[i] * wanted[i];
        }
        off = sqrt(off);
        across = sqrt(fmax(0, size - along * along / fmax(1, off * off)));
        CHECK(off <= room + LOFT_AXES);
        if (off < 0.99 * room - 0x1p-13 * sqrt(size) - 64 || along < 0)
            CHECK_NEAR(sqrt(size), 0, 64 + room / 200);
        else if (room > 0)
            CHECK(across <= sqrt(size) / 20 + 64);
    }
}

/* May an axis that stands still from knot k to the next not move there? It is one that does not
 * pass its end values, or only such ones move. */
static bool is_still(unsigned k, int i)
{
    const loft_position *p = &knot[k].is.on.at, *q = &knot[k + 1].is.on.at;
    unsigned moved = 0;

    for (int j = 0; j < LOFT_AXES; j++)
        moved |= (unsigned)(p->axis[j] != q->axis[j]) << j;
    return !(moved >> i & 1) && ((period.one_sided >> i & 1) ||
                                 (moved != 0 && (moved & ~(unsigned)period.one_sided) == 0));
}

/* If an axis is still at knot k, where is it before or behind, within 12 knots? Bit 0: above, 1:
 * below. */
static unsigned sides_of(unsigned k, int i)
{
    const loft_coord at = knot[k].is.on.at.axis[i];
    unsigned sides = 0;

    if (!is_still(k - 1, i) && !is_still(k, i))
        return 0;
    for (int way = -1; way <= 1; way += 2)
        for (int n = 1; n <= 12 && (int)k + way * n >= 0 && k + (unsigned)(way * n) < knots; n++) {
            const loft_coord d = knot[(int)k + way * n].is.on.at.axis[i] - at;
            if (loft_coord_abs(d) > 64 * LOFT_COORD_GRAIN) {
                sides |= d > 0 ? 1 : 2;
                break;
            }
        }
    return sides;
}

/* An axis that may not pass its end values stands still on their side of them, if the ball holds
 * these. */
static void an_axis_does_not_pass_where_it_stops(arb *a)
{
    static loft_knot centre[KNOTS];

    arb_knots(a);
    for (unsigned k = 1; k < knots; k++)            /* axes stop here and there */
        for (int i = 0; i < LOFT_AXES; i++)
            if (arb_below(a, 3) == 0)
                knot[k].is.on.at.axis[i] = knot[k - 1].is.on.at.axis[i];
    for (unsigned k = 0; k < knots; k++)
        knot[k].point = knot[k].is.on.at;
    loft_tube_load(knot, 1, knots - 1);
    memcpy(centre, knot, sizeof knot);
    period.one_sided = (uint8_t)(1 + arb_below(a, (1u << LOFT_AXES) - 1));
    loft_tube_measure(&period, knot, 3, knots - 3);
    loft_tube_smooth(&period, knot, 3, knots - 3, 20);
    for (unsigned k = 3; k + 3 < knots; k++) {
        const double room = knot[k].is.on.room * (double)LOFT_COORD_GRAIN;
        double off = 0, needed = 0;
        for (int i = 0; i < LOFT_AXES; i++) {
            off += pow((double)knot[k].point.axis[i] - centre[k].point.axis[i], 2);
            needed += fabs((double)knot[k].is.on.at.axis[i] - centre[k].point.axis[i]);
        }
        CHECK(sqrt(off) <= room + 4);
        for (int i = 0; i < LOFT_AXES && needed <= room; i++) {
            const loft_coord past = knot[k].point.axis[i] - knot[k].is.on.at.axis[i];
            const unsigned sides = sides_of(k, i);
            CHECK(!(sides == 1 && past < -1) && !(sides == 2 && past > 1));
        }
    }
    period.one_sided = 0;
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
    PROPERTY(what_the_tolerance_leaves_is_room, 300);
    PROPERTY(the_path_begins_and_ends_at_rest, 100);
    PROPERTY(a_place_is_on_the_spline, 2000);
    PROPERTY(smoothing_stays_within_the_tolerance, 300);
    PROPERTY(no_path_in_the_tube_is_smoother, 200);
    PROPERTY(an_axis_does_not_pass_where_it_stops, 1000);
    PROPERTY(a_line_stays_as_it_is, 100);
    return check_failures();
}
