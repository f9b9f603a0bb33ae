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
    PROPERTY(a_distance_is_never_too_small,             400);
    PROPERTY(what_the_smooth_path_misses_is_known,     2000);
    PROPERTY(where_the_path_turns_back_its_tip_counts, 2000);
    return check_failures();
}
