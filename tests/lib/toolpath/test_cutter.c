/* tests/lib/toolpath/test_cutter.c -- properties of lib/toolpath/cutter.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact.h"          /* exact_of, exact_acc; CHECK, PROPERTY */
#include "toolpath/cutter.h"

static loft_cutter arb_cutter(arb *a)
{
    const loft_real radius = LOFT_REAL(0.5) + loft_real_from_raw((int32_t)arb_below(a, 655360));
    const uint32_t kind = arb_below(a, 3);
    const loft_real corner = kind == 0 ? radius : kind == 1 ? 0 : radius / 4;
    loft_cutter c;

    CHECK(loft_cutter_init(&c, radius, corner) == LOFT_OK);
    return c;
}

/* A plane of slope g through the lowest resting place touches the underside and never enters it. */
static void a_cutter_rests_on_a_plane(arb *a)
{
    const loft_cutter c = arb_cutter(a);
    const loft_real slope[2] = { arb_real(a, 20), arb_real(a, 20) };
    const long double g = hypotl(exact_of(slope[0]), exact_of(slope[1])),
                      lift = exact_acc(loft_cutter_lift(&c, slope)),
                      disk = exact_of(c.radius) - exact_of(c.corner),
                      at = disk + exact_of(c.corner) * g / sqrtl(1 + g * g),
                      off = BY_NUM(0x1p-14L, 0x1p-14L, 1e-10L);
    const long double want = disk * g + exact_of(c.corner) * (sqrtl(1 + g * g) - 1);

    CHECK_NEAR(lift, want, BY_NUM(disk * 0x1p-17L + 0x1p-26L, 0x1p-22L, 0x1p-47L) * (1 + want));
    for (int k = 0; k <= 16; k++) {
        const loft_real distance = loft_mul(c.radius, loft_real_from_int(k)) / 16;
        const long double room = lift - g * exact_of(distance) +
                                 exact_acc(loft_cutter_rise(&c, distance));
        CHECK(room >= -off * (1 + g));
    }
    if (g < 8) {
        const loft_real touch = LOFT_REAL((double)at);
        CHECK_NEAR(exact_acc(loft_cutter_rise(&c, touch)), g * at - lift, off * (1 + g));
    }
}

static void impossible_cutters_are_refused(arb *a)
{
    loft_cutter c;

    (void)a;
    CHECK(loft_cutter_init(&c, LOFT_REAL(129), 0) == LOFT_ERR_ARG);
    CHECK(loft_cutter_init(&c, 0, 0) == LOFT_ERR_ARG);
    CHECK(loft_cutter_init(&c, LOFT_REAL(2), LOFT_REAL(3)) == LOFT_ERR_ARG);
    CHECK(loft_cutter_init(&c, LOFT_REAL(2), -LOFT_REAL(1)) == LOFT_ERR_ARG);
    CHECK(loft_cutter_init(&c, LOFT_REAL(128), LOFT_REAL(128)) == LOFT_OK);
}

int main(void)
{
    PROPERTY(a_cutter_rests_on_a_plane, 2000);
    PROPERTY(impossible_cutters_are_refused, 1);
    return check_failures();
}
