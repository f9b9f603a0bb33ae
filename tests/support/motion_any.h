/* tests/support/motion_any.h -- a random case: a chain, limits, feeds and arrival of curves; checks
 * everything that spans must hold
 * SPDX-License-Identifier: MIT
 *
 * Prints the first seeds of each kind of violation, and each seed that is worse than all before.
 */
#ifndef LOFT_TESTS_MOTION_ANY_H
#define LOFT_TESTS_MOTION_ANY_H

#include "support/motion_follow.h"  /* follow_path, uses_of_spans   */
#include "support/motion_paths.h"   /* arb_jerk                     */
#include "support/motion_steps.h"   /* steps_arrive                 */

enum { OUTCOME, BROKEN, SPEED, ALONG, ACCEL, JERK, JUMP, OFF, STEPS, FAULTS };

static const char *const fault_name[FAULTS] = { "deadlock", "gap",  "speed",    "along", "accel",
                                                "jerk",     "jump", "off-path", "steps" };
static unsigned long faults[FAULTS];
static double worst[FAULTS];
static path   any_track;
static bool   bad;                  /* in this case */
static double any_size = 200;       /* mm, of the largest curves at most: small ones take
                                     * little time to plan */

static inline void fault(int kind, uint64_t seed, double value)
{
    if (faults[kind]++ < 40 || value > worst[kind])
        printf("  seed %llu: %s %.5g\n", (unsigned long long)seed, fault_name[kind], value);
    worst[kind] = fmax(worst[kind], value);
    bad = true;
}

static inline void at_most(int kind, uint64_t seed, double value, double bound)
{
    if (!(value <= bound))
        fault(kind, seed, value);
}

/* One to six curves of all kinds, of similar size, that take about a second; `smooth`: tangents
 * agree at their joints. */
static inline void arb_short_chain(arb *a, bool smooth)
{
    const double size = arb_decades(a, smooth ? 1 : 0.0002, any_size),
                 feed = arb_decades(a, fmax(1, size), 500);
    const unsigned n = 1 + arb_below(a, 6);

    begin_chain();
    for (unsigned k = 0; k < n; k++) {
        const double mine = smooth || arb_below(a, 4) ? size * arb_decades(a, 0.2, 1)
                                                      : size * 0.001;
        const enum kind kind = (enum kind)arb_below(a, smooth ? SMOOTH + 1 : KINDS);
        arb_curve(a, kind, mine, arb_below(a, 3) ? feed : feed * arb_between(a, 0.1, 1), smooth);
    }
}

static inline arrival arb_arrival(arb *a)
{
    const arrival all = { CURVES, KNOTS, NULL };
    return arb_below(a, 4) ? (arrival){ (uint16_t)(1 + arb_below(a, 6)),
                                        (uint16_t)(LOFT_PLAN_KNOTS_MIN + arb_below(a, 60)), a }
                           : all;
}

/* Where coarse chords say too much, finer ones decide. */
static inline motion_follow follow_case(void)
{
    const double tol = arb_value(limits.tol);
    motion_follow f = follow_path(&any_track, chain, curves, tol);

    follow_chords /= 16;
    if (f.off > tol)
        f.off = follow_path(&any_track, chain, curves, tol).off;
    follow_chords *= 16;
    return f;
}

/* The chain and its limits are made; the rest is drawn. */
static inline void check_chain(uint64_t seed, arb *a)
{
    const arrival how = arb_arrival(a);
    const enum outcome o = plan_chain(&how);
    at_most(OUTCOME, seed, o, PLANNED);
    if (o != PLANNED || count == 0)
        return;
    if (!spans_connect())
        fault(BROKEN, seed, 1);
    const motion_uses u = uses_of_spans(1e9);
    const motion_follow f = follow_case();
    at_most(SPEED, seed, u.speed, 1.001);
    at_most(ALONG, seed, f.along, 1.001);
    at_most(ACCEL, seed, u.accel, 1.005);
    at_most(JERK, seed, u.jerk, 1.02);
    at_most(JUMP, seed, u.jump, 0.01);
    at_most(OFF, seed, f.off / arb_value(limits.tol), 1);
    at_most(STEPS, seed, steps_arrive(arb_decades(a, 5, 400), (uint16_t)(1 + arb_below(a, 40)), a),
            0);
}

static inline void check_case(uint64_t seed)
{
    arb a = arb_start(seed);
    const bool smooth = arb_below(&a, 3) == 0;

    arb_limits(&a);
    if (arb_below(&a, 2))
        arb_jerk(&a);
    arb_short_chain(&a, smooth);
    check_chain(seed, &a);
}

#endif
