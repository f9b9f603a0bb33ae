/* tests/bench/bench_motion_limits.c -- measures how much of each limit the spans of all test paths
 * use, and their distance from the path
 * SPDX-License-Identifier: MIT
 * usage: limits FOLDER [CHAINS]    FOLDER holds lists of moves; CHAINS random ones as well
 *
 * Prints `what value where`, the largest value of all paths.
 */
#define CURVES 1024

#include "support/motion_follow.h"  /* follow_path, uses_of_spans */
#include "support/motion_paths.h"   /* test_paths                 */

enum { SPEED, ALONG, ACCEL, JERK, JUMP, OFF, KINDS_OF_USE };

static const char *const what[KINDS_OF_USE] = { "speed", "along", "accel", "jerk", "jump", "off" };
static double worst[KINDS_OF_USE];
static char   where[KINDS_OF_USE][40];
static path   track;
static bool   bad;

static void take(int kind, double value, const char *name)
{
    if (value <= worst[kind])
        return;
    worst[kind] = value;
    snprintf(where[kind], sizeof where[kind], "%s", name);
}

/* `follow`: also measure the distance from the path. */
static void measure(const char *name, bool follow)
{
    const arrival all = { CURVES, KNOTS, NULL };
    const enum outcome o = plan_chain(&all);

    if (o != PLANNED || (count > 0 && !spans_connect())) {
        printf("broken 1 %s:%s\n", name, outcome_name[o]);
        bad = true;
        return;
    }
    const motion_uses u = uses_of_spans(arb_value(limits.max_speed[0]));
    take(SPEED, u.speed, name);
    take(ACCEL, u.accel, name);
    take(JERK, u.jerk, name);
    take(JUMP, u.jump, name);
    if (!follow || count == 0)
        return;
    const motion_follow f = follow_path(&track, chain, curves, arb_value(limits.tol) / 64);
    take(ALONG, f.along, name);
    take(OFF, f.off / arb_value(limits.tol), name);
}

static void measure_chains(unsigned chains)
{
    char name[40];

    for (unsigned seed = 1; seed <= chains; seed++) {
        snprintf(name, sizeof name, "smooth-seed-%u", seed);
        smooth_path(seed, seed % 2 > 0);
        measure(name, seed % 4 < 2);
        arb a = arb_start(seed);
        snprintf(name, sizeof name, "any-seed-%u", seed);
        arb_limits(&a);
        if (seed % 2 > 0)
            arb_jerk(&a);
        arb_chain(&a);
        measure(name, seed % 4 < 2);
    }
}

int main(int words, char **word)
{
    if (words < 2)
        return 64;
    for (unsigned k = 0; k < TEST_PATHS; k++) {
        if (!load_path(&test_paths[k], word[1]))
            return 66;
        measure(test_paths[k].name, true);
    }
    measure_chains(words > 2 ? (unsigned)atoi(word[2]) : 0);
    for (int k = 0; k < KINDS_OF_USE; k++)
        printf("%s %.5f %s\n", what[k], worst[k], where[k]);
    return bad;
}
