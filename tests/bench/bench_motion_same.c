/* tests/bench/bench_motion_same.c -- does the planner give the same plans in q16 and in f64?
 * SPDX-License-Identifier: MIT
 * usage: same FOLDER [CHAINS]      FOLDER holds lists of moves; CHAINS random smooth ones as well
 *
 * In q16 it writes the spans to FOLDER/NAME.spans. In f64 it reads them, and compares them with the
 * spans that f64 plans: it prints `time VALUE NAME`, the largest |t16 / t64 - 1|, and `apart VALUE
 * NAME`, the largest distance as a fraction of 1 LSB + tolerance.
 */
#define CURVES   1024
#define PATH_MAX 400000

#include "support/motion_follow.h"  /* follow_path              */
#include "support/motion_paths.h"   /* test_paths, smooth_path  */

static double worst[2];
static char   where[2][40];

static FILE *open_spans(const char *folder, const char *name, const char *mode)
{
    char file[300];

    snprintf(file, sizeof file, "%s/%s.spans", folder, name);
    FILE *f = fopen(file, mode);
    if (!f)
        exit(66);
    return f;
}

static void write_spans(const char *folder, const char *name)
{
    FILE *f = open_spans(folder, name, "w");

    for (unsigned k = 0; k < count; k++) {
        fprintf(f, "%u", spans[k].ticks);
        for (int j = 0; j < 4 * LOFT_AXES; j++)
            fprintf(f, " %.17g", arb_value(spans[k].p[j / LOFT_AXES].axis[j % LOFT_AXES]));
        fprintf(f, "\n");
    }
    fclose(f);
}

static void read_spans(const char *folder, const char *name)
{
    FILE *f = open_spans(folder, name, "r");
    unsigned ticks;
    double x;

    for (count = 0; count < SPANS && fscanf(f, "%u", &ticks) == 1; count++) {
        spans[count].ticks = (uint16_t)ticks;
        for (int j = 0; j < 4 * LOFT_AXES && fscanf(f, "%lf", &x) == 1; j++)
            spans[count].p[j / LOFT_AXES].axis[j % LOFT_AXES] = real_of(x);
    }
    fclose(f);
}

static void take(int k, double value, const char *name)
{
    if (value <= worst[k])
        return;
    worst[k] = value;
    snprintf(where[k], sizeof where[k], "%s", name);
}

static void compare(const char *folder, const char *name)
{
    static loft_move mine[SPANS];
    static path track;
    const double time = seconds();
    const unsigned mines = count;

    for (unsigned k = 0; k < mines; k++) {
        for (int j = 0; j < 4; j++)
            mine[k].curve.p[j] = spans[k].p[j];
        mine[k].feed = chain[0].feed;
    }
    read_spans(folder, name);
    take(0, fabs(seconds() / time - 1), name);
    const motion_follow f = follow_path(&track, mine, mines, arb_value(limits.tol) / 64);
    take(1, f.off / (arb_value(limits.tol) + 0x1p-16), name);
}

static void plan(const char *folder, const char *name)
{
    const arrival all = { CURVES, KNOTS, NULL };

    if (plan_chain(&all) != PLANNED || count == 0)
        return;
    if (BY_NUM(true, false, false))
        write_spans(folder, name);
    else
        compare(folder, name);
}

int main(int words, char **word)
{
    const unsigned chains = words > 2 ? (unsigned)atoi(word[2]) : 0;
    char name[40];

    if (words < 2)
        return 64;
    for (unsigned k = 0; k < TEST_PATHS; k++) {
        if (!load_path(&test_paths[k], word[1]))
            return 66;
        plan(word[1], test_paths[k].name);
    }
    for (unsigned seed = 1; seed <= chains; seed++) {
        snprintf(name, sizeof name, "smooth-seed-%u", seed);
        smooth_path(seed, seed % 2 > 0);
        plan(word[1], name);
    }
    if (!BY_NUM(true, false, false))
        printf("time %.6f %s\napart %.4f %s\n", worst[0], where[0], worst[1], where[1]);
    return 0;
}
