/* tests/support/motion_paths.h -- the test paths: drawings and smooth chains, each with limits
 * SPDX-License-Identifier: MIT
 *
 * A drawing is a list of moves, one per line: 12 numbers for the control points, mm, and the feed,
 * mm/s (bench_motion_moves.c).
 */
#ifndef LOFT_TESTS_MOTION_PATHS_H
#define LOFT_TESTS_MOTION_PATHS_H

#include <string.h>         /* memset */

#include "support/motion_chains.h"  /* chain, limits, arb_curve */

#if LOFT_AXES != 3
#  error "lists of moves have three axes"
#endif

/* speed, accel, jerk: per axis; jerk 0: not limited. `corner` in mm. */
typedef struct {
    const char *name, *drawing;
    double feed, speed, accel, jerk, corner;
} test_path;

static const test_path test_paths[] = {
    { "outline-50",          "outline12", 50,  1000,   500,      0, 0.01 },
    { "outline-100",         "outline12", 100, 1000,  2000,      0, 0.01 },
    { "outline-200",         "outline12", 200, 1000, 10000,      0, 0.01 },
    { "outline-100-soft",    "outline12", 100, 1000,   500,      0, 0.01 },
    { "outline-100-axes",    "outline12", 100,   60,  2000,      0, 0.01 },
    { "outline-50-j",        "outline12", 50,  1000,   500,  10000, 0.01 },
    { "outline-100-j",       "outline12", 100, 1000,  2000,  40000, 0.01 },
    { "outline-200-j",       "outline12", 200, 1000, 10000, 400000, 0.01 },
    { "outline-100-soft-j",  "outline12", 100, 1000,   500,  10000, 0.01 },
    { "outline-50-gentle-j", "outline12", 50,  1000,   500,   2500, 0.01 },
    { "outline-100-axes-j",  "outline12", 100,   60,  2000,  40000, 0.01 },
    { "demo-50",             "demo",      50,  1000,   500,      0, 0    },
    { "demo-50-corner",      "demo",      50,  1000,   500,      0, 0.01 },
    { "demo-100-j",          "demo",      100, 1000,  2000,  40000, 0.01 },
    { "curves-50",           "curves",    50,  1000,   500,      0, 0    },
    { "curves-50-corner",    "curves",    50,  1000,   500,      0, 0.01 },
    { "curves-100-j",        "curves",    100, 1000,  2000,  40000, 0.01 }
};

#define TEST_PATHS (sizeof test_paths / sizeof test_paths[0])

static inline void even_limits(double speed, double accel, double jerk)
{
    usual_limits();
    for (int i = 0; i < LOFT_AXES; i++) {
        limits.max_speed[i] = real_of(speed);
        limits.max_accel[i] = real_of(accel);
        limits.max_jerk[i]  = (uint32_t)jerk;
    }
}

static inline void arb_jerk(arb *a)
{
    const double ratio = arb_decades(a, 5, 200);
    for (int i = 0; i < LOFT_AXES; i++)
        limits.max_jerk[i] = (uint32_t)(ratio * arb_value(limits.max_accel[i]));
}

/* Lines, arcs and other curves whose tangents agree at the joints, to rounding. */
static inline void arb_smooth_chain(arb *a)
{
    const double size = arb_decades(a, 5, 200), feed = arb_value(real_of(arb_decades(a, 5, 500)));
    const unsigned n = 1 + arb_below(a, 12);

    begin_chain();
    for (unsigned k = 0; k < n; k++)
        arb_curve(a, (enum kind)arb_below(a, SMOOTH + 1), size * arb_decades(a, 0.2, 1), feed,
                  true);
}

/* A smooth chain with its limits, jerk limited or not. */
static inline void smooth_path(uint64_t seed, bool jerk)
{
    arb a = arb_start(seed);
    arb_limits(&a);
    arb_smooth_chain(&a);
    memset(limits.max_jerk, 0, sizeof limits.max_jerk);
    if (jerk)
        arb_jerk(&a);
}

/* Load the list `folder`/`name`.moves; its feeds are scaled so that drawing has the wanted feed.
 * Returns false if there is no such list. */
static inline bool load_moves(const char *folder, const char *name, double scale)
{
    char file[300];

    snprintf(file, sizeof file, "%s/%s.moves", folder, name);
    FILE *f = fopen(file, "r");
    begin_chain();
    while (f && curves < CURVES) {
        loft_move *m = &chain[curves];
        double x;
        int got = 0;
        for (int k = 0; k < 12; k++) {
            got += fscanf(f, "%lf", &x) == 1;
            m->curve.p[k / 3].axis[k % 3] = real_of(x);
        }
        if (got < 12 || fscanf(f, "%lf", &x) != 1)
            break;
        m->feed = real_of(x * scale);
        curves++;
    }
    if (f)
        fclose(f);
    return curves > 0;
}

static inline bool load_path(const test_path *t, const char *folder)
{
    even_limits(t->speed, t->accel, t->jerk);
    limits.corner = real_of(t->corner);
    return load_moves(folder, t->drawing, t->feed);
}

#endif
