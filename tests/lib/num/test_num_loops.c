/* tests/lib/num/test_num_loops.c -- the loops that headers of lib/num print, word for word, over
 * arbitrary numbers
 * SPDX-License-Identifier: MIT
 *
 * tests/house/loops.py compares them with the headers.
 */
#include <math.h>

#include "support/exact.h"          /* exact_of, exact_unit, exact_acc; CHECK */
#include "num/acc2.h"
#include "num/residue.h"

/* Of the lerp of two differences, which may nearly cancel. */
static void a_direction_keeps_its_digits(arb *r)
{
    const loft_unit t = arb_unit(r);
    loft_vec a = arb_vec(r, 1000), b = arb_vec(r, 1000), c = arb_vec(r, 1000), d = c;
    long double want[2], got[2] = { 0, 0 };

    for (int i = 0; i < 2; i++) {
        d.axis[i] += arb_below(r, 2) ? a.axis[i] - b.axis[i] : arb_real(r, 1000);
        want[i] = (1 - exact_unit(t)) * (exact_of(b.axis[i]) - exact_of(a.axis[i])) +
                  exact_unit(t) * (exact_of(d.axis[i]) - exact_of(c.axis[i]));
    }
#define use(to) (got[0] = exact_acc((to)[0]), got[1] = exact_acc((to)[1]))
    loft_acc2 v[2];
    loft_acc  way[2];
    for (int i = 0; i < 2; i++)
        v[i] = loft_acc2_lerp(loft_acc2_sub(b.axis[i], a.axis[i]),
                              loft_acc2_sub(d.axis[i], c.axis[i]), t);
    if (loft_acc2_scaled(v, 2, way))
        use(way);
#undef use
    const long double size = hypotl(got[0], got[1]), all = hypotl(want[0], want[1]);
    CHECK((size > 0) == (all > 0));
    for (int i = 0; i < 2 && size > 0; i++)
        CHECK_NEAR(got[i] / size, want[i] / all, 0x1p-28);
}

static loft_real factor[4];

/* x y - z w */
static uint32_t formula(const loft_residue *r)
{
    return loft_residue_sub(
        r, loft_residue_mul(r, loft_residue_real(r, factor[0]), loft_residue_real(r, factor[1])),
        loft_residue_mul(r, loft_residue_real(r, factor[2]), loft_residue_real(r, factor[3])));
}

static bool is_zero(uint32_t bits)
{
    loft_residue r;
    for (loft_residue_start(&r, bits); loft_residue_next(&r); )
        if (formula(&r) != 0)
            return false;
    return true;
}

static void a_formula_is_0_or_not(arb *a)
{
    for (int k = 0; k < 4; k++)
        factor[k] = arb_real(a, 30000);
    if (arb_below(a, 2)) {
        factor[2] = -factor[1];
        factor[3] = -factor[0];
    }
    const loft_exact det = loft_exact_det(
        loft_exact_from_real(factor[0]), loft_exact_from_real(factor[2]),
        loft_exact_from_real(factor[3]), loft_exact_from_real(factor[1]));
    CHECK(is_zero(2 * LOFT_RESIDUE_REAL + 1) == (loft_exact_sign(det) == 0));
}

int main(void)
{
    PROPERTY(a_direction_keeps_its_digits, 1000);
    PROPERTY(a_formula_is_0_or_not,        1000);
    return check_failures();
}
