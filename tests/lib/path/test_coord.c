/* tests/lib/path/test_coord.c -- properties of lib/path/coord.h
 * SPDX-License-Identifier: MIT
 */
#include <math.h>           /* sqrt: the reference */

#include "check.h"          /* CHECK, PROPERTY */
#include "path/coord.h"   /* loft_coord_of */

static void a_length_comes_back(arb *a)
{
    const int32_t raw = (int32_t)(uint32_t)arb_next(a) / 4 >> arb_below(a, 28);
    const loft_real x = loft_real_from_raw(raw);
    const double want = arb_value(x), mod = want - 256 * floor(want / 256 + 0.5);
    const double got = (double)loft_coord_of(loft_to_acc(x)) / LOFT_COORD_MM;

    CHECK(fabs(got - mod) <= 0x1p-25 || fabs(fabs(got - mod) - 256) <= 0x1p-25);
    const int64_t units = (int64_t)(want * LOFT_COORD_MM);
    CHECK_NEAR(arb_value(loft_acc_round(loft_coord_to_acc(units))) - want, 0,
               BY_NUM(0, fabs(want) * 0x1p-24, 0x1p-24));
}

static void differences_of_neighbours_wrap(arb *a)
{
    const loft_coord x = (loft_coord)(uint32_t)arb_next(a);
    const loft_coord d = (loft_coord)arb_below(a, 1u << 30) - (1 << 29);

    CHECK(loft_coord_sub(loft_coord_add(x, d), x) == d);
}

static void roots_are_rounded_down(arb *a)
{
    const uint64_t x = arb_next(a) >> arb_below(a, 64);
    const uint64_t r = loft_coord_sqrt(x), q = loft_coord_cbrt(x);

    CHECK(r * r <= x && (r == UINT32_MAX || (r + 1) * (r + 1) > x));
    CHECK(q * q * q <= x && (q >= 2642245 || (q + 1) * (q + 1) * (q + 1) > x));
}

static void a_vector_has_its_length(arb *a)
{
    loft_coord v[LOFT_AXES];
    double sum = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        v[i] = ((loft_coord)arb_below(a, 1u << 30) - (1 << 29)) >> arb_below(a, 20);
        sum += (double)v[i] * v[i];
    }
    CHECK_NEAR(loft_coord_length(v), sqrt(sum), 1.001);
}

int main(void)
{
    PROPERTY(a_length_comes_back, 20000);
    PROPERTY(differences_of_neighbours_wrap, 20000);
    PROPERTY(roots_are_rounded_down, 50000);
    PROPERTY(a_vector_has_its_length, 20000);
    return check_failures();
}
