/* tests/bench/bench_motion_deviation.c -- random cubics in a box, planned with the usual tolerance:
 * measures the distance of the spans
 * SPDX-License-Identifier: MIT
 * usage: deviation BOX CUBICS      BOX in mm
 *
 * Prints `off VALUE SEED`, as a fraction of the tolerance.
 */
#define CURVES 4

#include "support/motion_follow.h"  /* follow_path  */
#include "support/motion_paths.h"   /* even_limits  */

static path track;

/* In the plane, as in drawings; half of them with limited jerk. */
static void random_cubic(uint64_t seed, double box)
{
    arb a = arb_start(seed);

    even_limits(1000, 500, seed % 2 ? 10000 : 0);
    begin_chain();
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            chain[0].curve.p[k].axis[i] = real_of(i < 2 ? arb_between(&a, 0, box) : 0);
    chain[0].feed = real_of(100);
    curves = 1;
}

int main(int words, char **word)
{
    const unsigned cubics = words > 2 ? (unsigned)atoi(word[2]) : 2000;
    const arrival all = { CURVES, KNOTS, NULL };
    double worst = 0;
    unsigned seed_of = 0;

    if (words < 2)
        return 64;
    for (unsigned seed = 1; seed <= cubics; seed++) {
        random_cubic(seed, atof(word[1]));
        if (plan_chain(&all) != PLANNED || !spans_connect()) {
            printf("broken 1 %u\n", seed);
            return 1;
        }
        const double off = follow_path(&track, chain, curves, arb_value(limits.tol) / 64).off /
                           arb_value(limits.tol);
        if (off > worst) {
            worst   = off;
            seed_of = seed;
        }
    }
    printf("off %.4f seed-%u\n", worst, seed_of);
    return 0;
}
