/* tests/lib/motion/test_law.c -- properties of lib/motion/law.h where jerk is limited by averaging
 * SPDX-License-Identifier: MIT
 */
#include "support/motion_paths.h"   /* arb_jerk, arb_smooth_chain */

#include "motion/law.h"

#define RING  40
#define SLACK 1e-3
#define NOISE 1e-4      /* mm/s */

static loft_move       ring[CURVES];
static loft_plan_piece pieces[RING];
static loft_law        law;

static double value_of(loft_acc x)
{
    return BY_NUM((double)x / 4294967296.0, (double)x, (double)x);
}

/* A strong axis, with lines along it, and small features that need the weak ones. */
static void arb_rough_chain(arb *a)
{
    const double size = arb_decades(a, 0.02, 5), feed = arb_decades(a, 2, 100);
    const unsigned n = 2 + arb_below(a, 5);

    begin_chain();
    for (unsigned k = 0; k < n; k++) {
        heading[0] = 1;
        heading[1] = heading[2] = 0;
        if (k % 2 == 0)
            arb_curve(a, arb_below(a, 2) ? LINE : EASED_LINE, size * arb_decades(a, 0.1, 1), feed,
                      k > 0);
        else
            arb_curve(a, (enum kind)arb_below(a, KINDS), size * arb_decades(a, 0.0005, 0.02), feed,
                      arb_below(a, 2));
    }
}

static void arb_weak_limits(arb *a)
{
    const double weak = arb_decades(a, 0.01, 1);

    arb_limits(a);
    for (int i = 1; i < LOFT_AXES; i++)
        limits.max_accel[i] = real_of(fmax(1, weak * arb_value(limits.max_accel[0])));
    arb_jerk(a);
}

static void arb_law(arb *a)
{
    loft_budget budget;

    arb_weak_limits(a);
    arb_rough_chain(a);
    CHECK(loft_limits_check(&limits) == LOFT_OK);
    loft_budget_init(&budget, &limits);
    loft_course_init(&law.course, &budget, ring, CURVES, pieces, RING);
    loft_law_init(&law);
    for (unsigned k = 0; k < curves; k++)
        CHECK(loft_course_push(&law.course, &chain[k]) == LOFT_OK);
    law.course.ended = true;
}

/* What the law is before a beat: pieces that it drops are seen as they were. */
static loft_law        was;
static loft_plan_piece were[RING];

/* The cap of piece j, counted from the oldest there was, when `dropped` of them have gone since. */
static double cap_of(unsigned j, unsigned dropped)
{
    return arb_value(j < dropped ? were[(was.course.first + j) % RING].cap
                                 : loft_course_piece(&law.course, j - dropped)->cap);
}

/* When it leaves a place of rest, what is behind that is dropped first. */
static void passes_at_their_caps(void)
{
    const bool     leaves  = was.rests && !law.rests;
    const unsigned dropped = leaves ? 0
                                    : (law.course.first + (unsigned)RING - was.course.first) % RING;
    const double way = value_of(loft_law_mean(&law, law.sum)),
                 beat = value_of(loft_budget_beat(&law.course.budget, LOFT_REAL(1)));

    for (unsigned j = leaves ? 0 : was.from; j <= law.from + dropped; j++) {
        const double cap = cap_of(j, dropped);
        CHECK_NEAR(fmax(way / beat, cap), cap, SLACK * cap + NOISE);
    }
}

/* What the mean of the window passes in a beat, from the piece where it was to that where it is. */
static void no_piece_is_passed_faster_than_its_cap(arb *a)
{
    enum loft_law_state state = LOFT_LAW_RUNS;

    arb_law(a);
    for (unsigned beats = 0; state == LOFT_LAW_RUNS && beats < 1000000; beats++) {
        was = law;
        memcpy(were, pieces, sizeof pieces);
        state = loft_law_next(&law);
        if (state == LOFT_LAW_RUNS)
            passes_at_their_caps();
    }
    CHECK(state == LOFT_LAW_RESTS);
}

int main(void)
{
    PROPERTY(no_piece_is_passed_faster_than_its_cap, 150);
    return check_failures();
}
