/* tests/check.h -- assertions and seeded properties; no files, no malloc: runs on a target as well
 * SPDX-License-Identifier: MIT
 *
 * A property is a function whose name is a sentence. It runs with many seeds. A failure prints the
 * seed, and LOFT_SEED=<seed> in the environment (or -DLOFT_SEED) repeats that case. A long sweep
 * can be cut into parts: LOFT_SEED=<first>-<last>.
 *
 *     static void ends_on_the_last_point(arb *a) { ... CHECK(x == y); ... }
 *     int main(void) { PROPERTY(ends_on_the_last_point, 2000); return check_failures(); }
 *
 * On a target, only one of CHECK_SHARE seeds runs, the first ones. On a host LOFT_SHARE=<n> takes
 * one of n, spread over all: always the same for a property, others for another. LOFT_FIRST=<seed>
 * moves all seeds: they begin there instead of at 1.
 * Exhaustive loops use the step CHECK_STEP, and totals over all seeds are checked only if
 * !check_sampled(). Each property prints one line, `ok` or `FAIL`. check_failures() prints the
 * totals and returns the exit code.
 */
#ifndef LOFT_TESTS_CHECK_H
#define LOFT_TESTS_CHECK_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "num/num.h"
#include "support/arb.h"

/* One tolerance for each number type, in one place. */
#if LOFT_NUM == LOFT_Q16
#  define BY_NUM(q16, f32, f64) (q16)
#  define CHECK_NUM "q16"
#elif LOFT_NUM == LOFT_F32
#  define BY_NUM(q16, f32, f64) (f32)
#  define CHECK_NUM "f32"
#else
#  define BY_NUM(q16, f32, f64) (f64)
#  define CHECK_NUM "f64"
#endif

#ifndef CHECK_SHARE
#  define CHECK_SHARE 1
#endif

static unsigned check_passed, check_failed;
static uint64_t check_seed;
static bool     check_bad;

#define CHECK(condition)                                                                           \
    do {                                                                                           \
        if (!(condition))                                                                          \
            check_report(__FILE__, __LINE__, #condition);                                          \
    } while (0)

/* |got - want| <= bound, as doubles; prints the three. */
#define CHECK_NEAR(got, want, bound)                                                               \
    check_near((double)(got), (double)(want), (double)(bound), __FILE__, __LINE__, #got)

static inline void check_report(const char *file, int line, const char *what)
{
    if (!check_bad)
        printf("%s:%d: seed %llu: %s\n", file, line, (unsigned long long)check_seed, what);
    check_bad = true;
}

static inline void check_near(double got, double want, double bound, const char *file, int line,
                              const char *what)
{
    const double off = got > want ? got - want : want - got;
    if (off <= bound)
        return;
    if (!check_bad)
        printf("%s:%d: seed %llu: %s = %.17g, wanted %.17g, off by %.6g, bound %.6g\n", file, line,
               (unsigned long long)check_seed, what, got, want, off, bound);
    check_bad = true;
}

/* One of how many seeds does this run use? */
static inline unsigned check_one_of(void)
{
    const char *share = CHECK_SHARE > 1 ? NULL : getenv("LOFT_SHARE");
    const unsigned long n = share ? strtoul(share, NULL, 10) : CHECK_SHARE;
    return n > 1 ? (unsigned)n : 1;
}

/* Does this run use only some of the seeds? */
static inline bool check_sampled(void)
{
    return check_one_of() > 1 || getenv("LOFT_SEED") != NULL || getenv("LOFT_FIRST") != NULL;
}

/* The step of an exhaustive loop. */
#define CHECK_STEP (check_one_of() > 1 ? 31 : 1)

#define PROPERTY(name, times) check_property(#name, name, (times))

/* A property that gives a function the extremes of its types (support/extremes.h). `make lint` asks
 * for one of each function whose `range` says "any". */
#define EXTREMES(function, name, times) PROPERTY(name, times)

/* For properties that take seconds per seed: skipped, with a message, in a share of the seeds. */
#define PROPERTY_LONG(name, times)                                                                 \
    (check_one_of() > 1 ? check_left(#name, name) : PROPERTY(name, times))

typedef struct {
    uint64_t first, last, step;
} check_seeds;

/* A share of the seeds begins at another one for each property. */
static inline uint64_t check_share_start(const char *name, uint64_t step)
{
    uint32_t hash = 2166136261u;

    while (*name)
        hash = (hash ^ (uint8_t)*name++) * 16777619u;
    return step > 1 ? hash % step : 0;
}

static inline check_seeds check_seeds_of(const char *name, unsigned times)
{
    const char *one = getenv("LOFT_SEED"), *from = getenv("LOFT_FIRST");
    const uint64_t share = check_one_of(), step = share < times ? share : times,
                   first = from ? strtoull(from, NULL, 10) : 1;
    char *end = NULL;
    check_seeds s = { first + check_share_start(name, step), first + times - 1, step };

    if (CHECK_SHARE > 1)                    /* as many of the first ones as a share has */
        s = (check_seeds){ 1, (times + share - 1) / share, 1 };
    if (one) {
        s.first = s.last = strtoull(one, &end, 10);
        s.step = 1;
        if (*end == '-')
            s.last = strtoull(end + 1, NULL, 10);
    }
    return s;
}

static inline void check_property(const char *name, void (*property)(arb *), unsigned times)
{
    const check_seeds s = check_seeds_of(name, times);
    unsigned count = 0;

    check_bad = false;
    for (check_seed = s.first; check_seed <= s.last && !check_bad; check_seed += s.step, count++) {
        arb a = arb_start(check_seed);
        property(&a);
    }
    if (check_bad)
        check_failed++;
    else
        check_passed++;
    printf("%s %s %s (%u)\n", check_bad ? "FAIL" : "ok  ", CHECK_NUM, name, count);
    fflush(stdout);
}

static inline void check_left(const char *name, void (*property)(arb *))
{
    (void)property;
    printf("left %s %s (too long for a share of the seeds)\n", CHECK_NUM, name);
}

static inline int check_failures(void)
{
    printf("%u passed, %u failed\n", check_passed, check_failed);
    return check_failed ? 1 : 0;
}

#endif
