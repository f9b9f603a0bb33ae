/* tests/lib/path/test_place.c -- properties of lib/path/place.h
 * SPDX-License-Identifier: MIT
 */
#include <math.h>                   /* sqrt */

#include "support/motion_chains.h"  /* arb_between */

#include "path/place.h"             /* loft_path_between */

#define UNIT    0x1p-24
#define WHOLE   (1 << 24)

/* Ways of 0.01 to 1 mm that bend and turn back, each up to four times as long as the one before. */
static loft_path_place places[6];

static void arb_places(arb *a)
{
    double way[LOFT_AXES], at[LOFT_AXES] = { 0 };

    for (int i = 0; i < LOFT_AXES; i++)
        way[i] = arb_between(a, -0.1, 0.1);
    for (unsigned k = 0; k < 6; k++) {
        places[k] = (loft_path_place){ .sharp = arb_below(a, 8) == 0 };
        const double longer = arb_between(a, 0.25, 2);
        for (int i = 0; i < LOFT_AXES; i++) {
            places[k].at.axis[i] = (loft_coord)(at[i] / UNIT);
            way[i] = way[i] * (arb_below(a, 6) ? longer : -longer) + arb_between(a, -0.02, 0.02);
            at[i] += way[i];
        }
    }
}

static void pointers(const loft_path_place *at[], unsigned n)
{
    for (unsigned k = 0; k < n; k++)
        at[k] = &places[k];
}

static double distance(const loft_position *a, const loft_position *b)
{
    double sum = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        sum += pow(a->axis[i] - b->axis[i], 2);
    return sqrt(sum);
}

static void the_cubic_leads_from_place_to_place(arb *a)
{
    const loft_path_place *at[4];
    loft_position p;

    arb_places(a);
    pointers(at, 4);
    loft_path_between(at, 0, &p);
    CHECK(distance(&p, &at[1]->at) == 0);
    loft_path_between(at, WHOLE, &p);
    CHECK(distance(&p, &at[2]->at) <= 8 * LOFT_AXES);
}

/* The cubic itself: `before` and `after` are half of what the legs beside it differ by from the
 * chord, where legs are at most twice as long as that; at a sharp place there is none. */
static void the_cubic_turns_as_its_legs_do(arb *a)
{
    const loft_path_place *at[4];
    double leg[3][LOFT_AXES], large[3] = { 0 };
    loft_position p;

    arb_places(a);
    pointers(at, 4);
    for (unsigned k = 0; k < 3; k++)
        for (int i = 0; i < LOFT_AXES; i++) {
            leg[k][i] = (double)at[k + 1]->at.axis[i] - at[k]->at.axis[i];
            large[k] = fmax(large[k], fabs(leg[k][i]));
        }
    const double z = (double)arb_below(a, WHOLE) / WHOLE;
    loft_path_between(at, (int32_t)(z * WHOLE), &p);
    for (int i = 0; i < LOFT_AXES; i++) {
        double turn[2];
        for (unsigned n = 0; n < 2; n++) {
            const double most = 2 * large[1], size = large[2 * n],
                         part = leg[2 * n][i] * (size > most ? most / size : 1);
            turn[n] = at[1 + n]->sharp ? 0 : (part - leg[1][i]) / 2;
        }
        CHECK_NEAR(p.axis[i],
                   at[1]->at.axis[i] +
                       z * (leg[1][i] + (1 - z) * ((1 - z) * turn[0] - z * turn[1])),
                   16 + (large[0] + large[1] + large[2]) * 0x1p-20);
    }
}

/* Of points near it, but for the rounding of a place on it. */
static void a_distance_is_never_too_small(arb *a)
{
    enum { PARTS = 2048 };
    const loft_path_place *at[4];
    loft_position p, on, last;
    double least = INFINITY, step = 0;

    arb_places(a);
    pointers(at, 4);
    const int32_t z = (int32_t)arb_below(a, WHOLE);
    loft_path_between(at, z, &p);
    for (int i = 0; i < LOFT_AXES; i++)
        p.axis[i] += (loft_coord)(arb_between(a, -0.01, 0.01) / UNIT);
    for (int k = 0; k <= PARTS; k++) {
        loft_path_between(at, k * (WHOLE / PARTS), &on);
        least = fmin(least, distance(&on, &p));
        step = k > 0 ? fmax(step, distance(&on, &last)) : 0;
        last = on;
    }
    CHECK(loft_path_off(at, z, &p) + 16 >= least - step / 2);
}

/* A point of the cubic is nowhere off it, and one across it by so much as it is across. */
static void a_point_of_it_is_not_off(arb *a)
{
    const loft_path_place *at[4];
    loft_position p, before, behind;

    arb_places(a);
    pointers(at, 4);
    const int32_t z = 1000 + (int32_t)arb_below(a, WHOLE - 2000);
    loft_path_between(at, z, &p);
    CHECK(loft_path_off(at, z, &p) <= 32);
    loft_path_between(at, z - 1000, &before);
    loft_path_between(at, z + 1000, &behind);
    const double x = behind.axis[0] - before.axis[0], y = behind.axis[1] - before.axis[1],
                 size = sqrt(x * x + y * y), off = arb_between(a, -0.0005, 0.0005) / UNIT;
    if (size < 500)
        return;
    p.axis[0] += (loft_coord)(off * y / size);
    p.axis[1] -= (loft_coord)(off * x / size);
    CHECK(loft_path_off(at, z, &p) <= fabs(off) * 1.02 + 64);
}

/* The spline whose control points are the centres of the places. */
static double centre(unsigned k, int i)
{
    const double x = places[k].at.axis[i];
    return x - (places[k - 1].at.axis[i] - 2 * x + places[k + 1].at.axis[i]) / 6;
}

static void what_the_smooth_path_misses_is_known(arb *a)
{
    const loft_path_place *at[6];
    loft_position knot, middle;

    arb_places(a);
    pointers(at, 6);
    for (int i = 0; i < LOFT_AXES; i++) {
        knot.axis[i] = (loft_coord)((centre(1, i) + 4 * centre(2, i) + centre(3, i)) / 6);
        middle.axis[i] =
            (loft_coord)((centre(1, i) + 23 * centre(2, i) + 23 * centre(3, i) + centre(4, i)) /
                         48);
    }
    const loft_coord miss = loft_path_miss(at, &knot), slack = 64;
    CHECK(loft_path_missed(at, miss - slack) || miss <= slack);
    CHECK(!loft_path_missed(at, miss + slack));
    CHECK_NEAR(loft_path_missed_between(at), loft_path_off(at + 1, WHOLE / 2, &middle), slack);
}

static void where_the_path_turns_back_its_tip_counts(arb *a)
{
    const loft_path_place *at[5];
    double dot = 0, size = 0;

    arb_places(a);
    pointers(at, 5);
    for (int i = 0; i < LOFT_AXES; i++) {
        const double before = at[2]->at.axis[i] - at[1]->at.axis[i],
                     behind = at[3]->at.axis[i] - at[2]->at.axis[i];
        dot += before * behind;
        size += fabs(before) + fabs(behind);
    }
    if (fabs(dot) > 16 * size)
        CHECK(loft_path_turns_back(at[1], at[2], at[3]) == (dot < 0));
    if (dot < -16 * size)
        CHECK(loft_path_miss(at, &at[3]->at) >= distance(&at[2]->at, &at[3]->at) - 4);
}

int main(void)
{
    PROPERTY(the_cubic_leads_from_place_to_place,      2000);
    PROPERTY(the_cubic_turns_as_its_legs_do,           2000);
    PROPERTY(a_distance_is_never_too_small,             400);
    PROPERTY(a_point_of_it_is_not_off,                 2000);
    PROPERTY(what_the_smooth_path_misses_is_known,     2000);
    PROPERTY(where_the_path_turns_back_its_tip_counts, 2000);
    return check_failures();
}
