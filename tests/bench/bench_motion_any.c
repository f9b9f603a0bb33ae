/* tests/bench/bench_motion_any.c -- random chains, limits, feeds and arrivals: no limit exceeded,
 * no deadlock, no step lost
 * SPDX-License-Identifier: MIT
 * usage: any FIRST LAST [MM]       seeds; curves of at most MM (200), but for every 32nd case:
 *                                  short ones take a tenth of the time
 *
 * Prints the violations that motion_any.h finds, `fault KIND COUNT WORST`, and how many cases
 * passed.
 */
#include "support/motion_any.h"     /* check_case */

int main(int words, char **word)
{
    if (words < 3)
        return 64;
    const uint64_t first = strtoull(word[1], NULL, 10), last = strtoull(word[2], NULL, 10);
    const double large = any_size, size = words > 3 ? strtod(word[3], NULL) : large;
    unsigned long passed = 0, failed = 0;

    for (uint64_t seed = first; seed <= last; seed++) {
        bad = false;
        any_size = seed % 32 ? size : large;
        check_case(seed);
        passed += !bad;
        failed += bad;
    }
    for (int k = 0; k < FAULTS; k++)
        printf("fault %s %lu %.6g\n", fault_name[k], faults[k], worst[k]);
    printf("%lu passed, %lu failed\n", passed, failed);
    return failed > 0;
}
