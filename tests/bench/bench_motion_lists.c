/* tests/bench/bench_motion_lists.c -- how good plans of lists of moves are
 * SPDX-License-Identifier: MIT
 * usage: lists SPEED[:FEED] ACCEL JERK TOL KNOTS LIST..   (mm/s, mm/s^2, mm/s^3 or 0, mm)
 *
 * Without FEED it is the speed that an axis may have.
 * Prints, of each list and their sum: seconds; the largest part of speed, acceleration and jerk per
 * axis that the spans use; the distance (Frechet) over the tolerance, 1 if it is less, else the
 * power of two; spans; milliseconds of processor per second of motion.
 */
#define CURVES   16384
#define PATH_MAX 400000

#include <time.h>           /* clock */

#include "support/motion_follow.h"  /* follow_path, uses_of_spans */
#include "support/motion_paths.h"   /* even_limits, load_moves */

static path track;

int main(int words, char **word)
{
    double sum = 0, cpu = 0;

    if (words < 7)
        return 64;
    const char *colon = strchr(word[1], ':');
    const double speed = atof(word[1]), feed = colon ? atof(colon + 1) : speed;
    printf("%-28s %9s %7s %7s %7s %7s %7s %7s\n", "list", "s", "speed", "accel", "jerk", "off/tol",
           "spans", "ms/s");
    for (int n = 6; n < words; n++) {
        const arrival how = { CURVES, (uint16_t)atoi(word[5]), NULL };
        char folder[300] = ".";
        const char *slash = strrchr(word[n], '/'), *name = slash ? slash + 1 : word[n];
        if (slash)
            snprintf(folder, sizeof folder, "%.*s", (int)(slash - word[n]), word[n]);
        even_limits(speed, atof(word[2]), atof(word[3]));
        limits.tol = real_of(atof(word[4]));
        if (!load_moves(folder, name, 1))
            return 66;
        for (unsigned c = 0; c < curves; c++)
            chain[c].feed = real_of(feed);
        const clock_t begun = clock();
        const enum outcome o = plan_chain(&how);
        const double took = (double)(clock() - begun) / CLOCKS_PER_SEC;
        if (o != PLANNED || !spans_connect()) {
            printf("%-28s %s\n", name, outcome_name[o]);
            continue;
        }
        const motion_uses u = uses_of_spans(1e9);
        const motion_follow f = follow_path(&track, chain, curves, arb_value(limits.tol));
        printf("%-28s %9.4f %7.4f %7.4f %7.4f %7.3f %7u %7.2f\n", name, seconds(), u.speed, u.accel,
               u.jerk, f.off / arb_value(limits.tol), count, took * 1000 / seconds());
        sum += seconds();
        cpu += took;
    }
    printf("%-28s %9.4f %47.2f\n", "sum", sum, cpu * 1000 / sum);
    return 0;
}
