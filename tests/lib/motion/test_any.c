/* tests/lib/motion/test_any.c -- random chains, limits and arrivals planned: no limit exceeded, no
 * deadlock, no step lost
 * SPDX-License-Identifier: MIT
 */
#include "support/motion_any.h"     /* check_case */

/* Each of them exceeded a limit once, or seemed to. */
static const uint32_t once[] = {
    494, 1036, 1442, 2918,      /* the path turned around at both ends of less than 2^-18 mm */
    1582, 2952,                 /* a curve that came later asked to brake where the speed had just
                                 * been raised */
    2954,                       /* a change of curvature was eased across a place of rest */
    4389, 7203,                 /* a span of some beats was faster between the places looked at than
                                 * at them */
    1547,                       /* the speed of a span along the path, half way between beats */
    294, 300,                   /* the spline of the samples carried speed across a change of the
                                 * feed */
    970, 4351,                  /* loops below the tolerance, which are passed all the same */
    860, 54890,                 /* where easing begins in a cell more was asked for than at its
                                 * ends */
    4201, 38499,                /* a part of a piece ended before it began */
    1005, 2351,                 /* a part of a span across a change of the feed was compared with
                                 * that behind it */
    52033, 56225, 57847,        /* easing: fastest within a cell, longer than the path, over a rest
                                 * on its way */
    62692, 64011,               /* averaged: eased behind a rest that it had decided on; an axis
                                 * faster while eased */
    53112, 74767,               /* a piece whose curvature changes was braked in, though it is
                                 * passed at its cap as a rule */
    112815,                     /* raised: the spline of the samples carried speed across a change
                                 * of the feed */
    116982,                     /* a longer span was faster than a slow feed */
    19732,                      /* accelerations at the far end of a scope that relieve a bend were
                                 * taken for those that lead elsewhere */
    34848,                      /* raised: near a rest the jerk of an axis was asked at the ends of
                                 * a cell only */
    38774,                      /* averaged: a speed was called sure where gentle braking beyond the
                                 * zone could still lower it */
    89907,                      /* averaged: a joint was eased with the curvature that the path has
                                 * at the joint, not that where it is eased */
    35225,                      /* averaged: q16 divided by 0 where a chord beside an eased joint
                                 * was cut again */
    86786, 40446                /* averaged: a beat of braking led into or over a zone where it had
                                 * to be slow */
};

static void cases_that_were_violations_are_none(arb *a)
{
    (void)a;
    for (unsigned k = 0; k < sizeof once / sizeof once[0]; k++) {
        bad = false;
        check_case(once[k]);
        CHECK(!bad);
    }
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
