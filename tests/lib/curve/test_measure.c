/* tests/lib/curve/test_measure.c -- arc lengths and their inverse (lib/curve/measure.h) against
 * long double
 * SPDX-License-Identifier: MIT
 */
#include "curve/measure.h"
#include "support/cubics.h"          /* the reference, CHECK, PROPERTY, arb_shape */

/* What the header promises for a tolerance. */
static real promised(const exact *e, real tol, real share)
{
    const real p = polygon(e);
    return fmaxl(tol, p * share) + BY_NUM(p * 0x1p-27L + 0x1p-16L, p * 0x1p-40L, p * 0x1p-40L);
}

static void length_is_within_the_tolerance(arb *a)
{
    const loft_cubic c = arb_shape(a);
    const exact e = exact_of(&c);
    const int32_t raw = arb_tol(a, &e, 1);
    const real bound = promised(&e, raw / 65536.0L, 0x1p-22L);

    CHECK_NEAR(wide(loft_cubic_arclen(&c, tol_of(raw))) - length(&e, bound / 64, 0), 0, bound);
}

/* y = x^2: length sqrt(5) / 2 + ln(2 + sqrt(5)) / 4 per unit. */
static void the_length_of_a_parabola_is_its_closed_form(arb *a)
{
    const int32_t scale = 3 << arb_below(a, 12);
    loft_cubic c = {{{{0}}}};

#if LOFT_AXES > 1
    c.p[1].axis[0] = loft_real_from_int(scale / 3);
    c.p[2].axis[0] = loft_real_from_int(2 * scale / 3);
    c.p[2].axis[1] = loft_real_from_int(scale / 3);
    c.p[3].axis[0] = c.p[3].axis[1] = loft_real_from_int(scale);
    const real want = scale * (sqrtl(5) / 2 + logl(2 + sqrtl(5)) / 4);
    const exact e = exact_of(&c);
    for (int32_t raw = 1; raw < 1 << 20; raw *= 4)
        CHECK_NEAR(wide(loft_cubic_arclen(&c, tol_of(raw))) - want, 0,
                   promised(&e, raw / 65536.0L, 0x1p-22L));
#else
    (void)c;
    (void)scale;
#endif
}

static void the_parameter_at_a_length_has_that_length(arb *a)
{
    const loft_cubic c = arb_shape(a);
    const exact e = exact_of(&c);
    const int32_t raw = arb_tol(a, &e, 2);
    const real bound = promised(&e, raw / 65536.0L, 0x1p-21L), whole = length(&e, bound / 64, 0);
    loft_arclen r;

    CHECK(loft_arclen_init(&r, &c, tol_of(raw)) == LOFT_OK);
    CHECK_NEAR(wide(loft_arclen_total(&r)) - whole, 0, bound);
    for (int k = 0; k < 8; k++) {
        const real want = whole * arb_below(a, 1025) / 1024;
        const loft_unit t = k % 2 ? loft_arclen_inverse(&r, acc_of(want))
                                  : loft_cubic_inv_arclen(&c, acc_of(want), tol_of(raw));
        const real got = length_to(&e, parameter(t), bound / 64), before = parameter(t) - 0x1p-24L,
                   after = parameter(t) + 0x1p-24L;
        CHECK(t >= 0 && t <= LOFT_UNIT(1));
        if (fabsl(got - want) > bound) {        /* at most one step of t too far */
            const real low  = length_to(&e, before > 0 ? before : 0, bound / 64);
            const real high = length_to(&e, after < 1 ? after : 1, bound / 64);
            CHECK(want >= low - bound && want <= high + bound);
        }
    }
}

static void a_table_measures_from_the_start_to_anywhere(arb *a)
{
    const loft_cubic c = arb_shape(a);
    const exact e = exact_of(&c);
    const int32_t raw = arb_tol(a, &e, 2);
    const real bound = promised(&e, raw / 65536.0L, 0x1p-21L);
    const loft_unit t = arb_unit(a);
    loft_arclen r;

    CHECK(loft_arclen_init(&r, &c, tol_of(raw)) == LOFT_OK);
    CHECK_NEAR(wide(loft_arclen_eval(&r, t)) - length_to(&e, parameter(t), bound / 64), 0, bound);
    CHECK(!(loft_arclen_eval(&r, 0) > 0) && !(loft_arclen_eval(&r, -LOFT_UNIT(1)) > 0));
    CHECK_NEAR(loft_arclen_eval(&r, LOFT_UNIT(1)), loft_arclen_total(&r), 0);
    CHECK_NEAR(loft_arclen_eval(&r, LOFT_UNIT(2)), loft_arclen_total(&r), 0);
}

static void the_parameter_never_decreases_with_the_length(arb *a)
{
    const loft_cubic c = arb_shape(a);
    const exact e = exact_of(&c);
    const loft_real tol = tol_of(arb_tol(a, &e, 2));
    loft_arclen r;
    loft_unit last = 0, low = 0;

    CHECK(loft_arclen_init(&r, &c, tol) == LOFT_OK);
    const real whole = wide(loft_arclen_total(&r)), fine = whole / (1 << (8 + arb_below(a, 16)));
    const real start = whole * arb_below(a, 1024) / 1024;
    for (int k = -2; k < 60; k++) {
        const loft_unit t = loft_arclen_inverse(&r, acc_of(start + k * fine));
        const loft_unit u = k % 8 ? low : loft_cubic_inv_arclen(&c, acc_of(start + k * fine), tol);
        CHECK(t >= last && u >= low);
        last = t;
        low  = u;
    }
    CHECK(!(loft_arclen_inverse(&r, -loft_to_acc(tol)) > 0) &&
          !(loft_cubic_inv_arclen(&c, -loft_to_acc(tol), tol) > 0));
    CHECK(loft_arclen_inverse(&r, acc_of(whole * 1.01L + 1)) >= LOFT_UNIT(1));
    CHECK(loft_cubic_inv_arclen(&c, acc_of(whole * 1.01L + 1), tol) >= LOFT_UNIT(1));
}

static void a_point_has_no_length_and_ends_where_it_starts(arb *a)
{
    const loft_vec p = arb_vec(a, 32767);
    const loft_cubic c = {{ p, p, p, p }};
    const loft_real tol = LOFT_REAL(0.125);
    loft_arclen r;

    CHECK(loft_arclen_init(&r, &c, tol) == LOFT_OK);
    CHECK(!(loft_cubic_arclen(&c, tol) > 0) && !(loft_arclen_total(&r) > 0));
    CHECK(!(loft_cubic_inv_arclen(&c, 0, tol) > 0) && !(loft_arclen_inverse(&r, 0) > 0));
    CHECK(loft_cubic_inv_arclen(&c, loft_to_acc(tol), tol) >= LOFT_UNIT(1) &&
          loft_arclen_inverse(&r, loft_to_acc(tol)) >= LOFT_UNIT(1));
}

static void a_table_refuses_what_is_not_a_number(arb *a)
{
    loft_cubic c = arb_cubic(a, 32767);
    loft_arclen r;

    CHECK(loft_arclen_init(&r, &c, 0) == LOFT_ERR_ARG &&
          loft_arclen_init(&r, &c, -LOFT_REAL(1)) == LOFT_ERR_ARG);
#if LOFT_NUM != LOFT_Q16
    CHECK(loft_arclen_init(&r, &c, (loft_real)NAN) == LOFT_ERR_ARG);
    c.p[arb_below(a, 4)].axis[0] = arb_below(a, 2) ? (loft_real)NAN : (loft_real)INFINITY;
    CHECK(loft_arclen_init(&r, &c, LOFT_REAL(1)) == LOFT_ERR_RANGE);
#endif
}

int main(void)
{
    PROPERTY(length_is_within_the_tolerance,                  400);
    PROPERTY(the_length_of_a_parabola_is_its_closed_form,      12);
    PROPERTY(the_parameter_at_a_length_has_that_length,       100);
    PROPERTY(a_table_measures_from_the_start_to_anywhere,     200);
    PROPERTY(the_parameter_never_decreases_with_the_length,   100);
    PROPERTY(a_point_has_no_length_and_ends_where_it_starts,   50);
    PROPERTY(a_table_refuses_what_is_not_a_number,             50);
    return check_failures();
}
