/* tests/bench/bench_motion_outline.c -- the outline of 12 cubics at 3000 mm/min, 500 mm/s^2, 250
 * steps/mm: time, evenness, counts
 * SPDX-License-Identifier: MIT
 * usage: outline FOLDER        FOLDER holds lists of moves
 *
 * Prints `ratio`, its time over L / v + v / a; `vary`, the largest minus the smallest speed of the
 * cruise as a fraction of the feed; `slowest`, the smallest speed of the cruise, mm/s; `steps`, 1
 * if the pulses end where the outline ends. The cruise leaves out twice the length v^2 / 2a at each
 * end.
 */
#define CURVES 16
#define PARTS  8       /* of a span */

#include "support/motion_follow.h"  /* part_length, quartic_peak */
#include "support/motion_paths.h"   /* load_path                 */
#include "support/motion_steps.h"   /* steps_arrive              */

/* The smallest and the largest speed in the cruise, exactly. */
static void cruise(double length, double skip, double *least, double *most)
{
    double gone = 0, q[5], turned[5];

    *least = 1e300;
    *most  = 0;
    for (unsigned k = 0; k < count; k++)
        for (int j = 0; j < PARTS; j++) {
            const double from = (double)j / PARTS, to = (j + 1.0) / PARTS, before = gone;
            gone += part_length(&spans[k], from, to);
            if (before < skip || gone > length - skip)
                continue;
            span_squares(&spans[k], from, to, q);
            const double top = hull_top(q);
            for (int n = 0; n < 5; n++)
                turned[n] = top - q[n];
            *most  = fmax(*most, sqrt(quartic_peak(q)));
            *least = fmin(*least, sqrt(fmax(0, top - quartic_peak(turned))));
        }
}

int main(int words, char **word)
{
    const arrival all = { CURVES, KNOTS, NULL };
    double length = 0, least, most;

    if (words < 2 || !load_path(&test_paths[0], word[1]) || plan_chain(&all) != PLANNED ||
        !spans_connect())
        return 66;
    const double feed = test_paths[0].feed, accel = test_paths[0].accel;
    for (unsigned k = 0; k < count; k++)
        length += part_length(&spans[k], 0, 1);
    cruise(length, feed * feed / accel, &least, &most);
    printf("ratio %.5f %.3f-s\nvary %.6f %.3f..%.3f-mm/s\nslowest %.4f mm/s\n",
           seconds() / (length / feed + feed / accel), seconds(), (most - least) / feed, least,
           most, least);
    printf("steps %d 250-steps/mm\n", steps_arrive(250, 40, NULL) == 0);
    return 0;
}
