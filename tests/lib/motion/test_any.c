/* tests/lib/motion/test_any.c -- random chains, limits and arrivals planned: no limit exceeded, no
 * deadlock, no step lost
 * SPDX-License-Identifier: MIT
 */
#include "support/motion_any.h"     /* check_case */

/* Each of them exceeded a limit once, or seemed to, by one planner or another: ends that turn
 * around, loops and teeth below the tolerance, changes of the feed, curves that come late. */
static const uint32_t once[] = {
    494,      1036,     1442,     2918,     1582,     2952,    2954,    4389,     7203,
    1547,     294,      300,      970,      4351,     860,     54890,   4201,     38499,
    1005,     2351,     52033,    56225,    57847,    62692,   64011,   53112,    74767,
    112815,   116982,   19732,    34848,    38774,    89907,   35225,   86786,    40446,
    2001219,  2001383,  2001861,  2000886,  2002549,  3000081, 3100411, 20009472, 20070336,
    20093728,  21066560,  61230784,  70530496,  70571808, 70711040, 81201280, 81290880, 102000520,
    102014028, 102003982, 103015879, 106018957, 105037927
};

/* The same, of curves of at most 2 mm: ends that came too fast for the last period, and tips that
 * were lost, where the path turns back; a way much longer than the one before it. */
static const uint32_t once_small[] = { 20000387,  20000558, 20008242, 20011011, 20025454, 20027738,
                                       20027929,  20029540, 20032867, 20036547, 20038891, 20040708,
                                       20049967,  20052128, 20058871, 20001198, 20025008, 20044723,
                                       20112143,  20109484, 20143362, 20004906, 20023169, 20253991,
                                       20211987,  20054031, 20149897, 21047081, 30003289, 61050383,
                                       61081239,  70047167, 70760323, 70774210, 70818135, 121297384,
                                       132186548, 132267096 };

static void none_is_a_violation(const uint32_t seeds[], unsigned n)
{
    for (unsigned k = 0; k < n; k++) {
        bad = false;
        check_case(seeds[k]);
        CHECK(!bad);
    }
}

static void cases_that_were_violations_are_none(arb *a)
{
    const double large = any_size;

    (void)a;
    none_is_a_violation(once, sizeof once / sizeof once[0]);
    any_size = 2;
    none_is_a_violation(once_small, sizeof once_small / sizeof once_small[0]);
    any_size = large;
}

/* Other seeds than those of `make bench-motion`. */
static void no_limit_is_exceeded_and_no_step_is_lost(arb *a)
{
    const uint64_t seed = ((uint64_t)1 << 32) + arb_below(a, 1u << 30);

    bad = false;
    check_case(seed);
    if (bad)
        printf("any %llu\n", (unsigned long long)seed);
    CHECK(!bad);
}

int main(void)
{
    PROPERTY_LONG(cases_that_were_violations_are_none,   1);
    PROPERTY(no_limit_is_exceeded_and_no_step_is_lost,  60);
    return check_failures();
}
