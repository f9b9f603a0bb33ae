/* lib/num/explog.c
 * SPDX-License-Identifier: MIT
 *
 * ln x = e ln 2 + ln m, where x = m 2^e with m in 1/sqrt 2 .. sqrt 2. With s = (m - 1) / (m + 1),
 * |s| < 0.1716,
 *
 *     ln m = 2 s (1 + s^2/3 + s^4/5 + .. + s^24/25)         next term below 2^-70 of the first
 *
 * e^x = 2^n e^r, where n is the integer nearest to x / ln 2 and |r| <= 0.347, and
 *
 *     e^r = 1 + r (1 + r/2 (1 + r/3 (1 + .. r/16)))         next term below 2^-74
 */
#include "num/explog.h"

#if LOFT_NUM == LOFT_Q16

static const loft_sci LN2 = { 6393154322601327829u, -63, false };
#define ROOT2 6521908912666391106u      /* times 2^62 */

loft_sci loft_sci_from_fine(loft_fine x)
{
    loft_sci r = loft_sci_of(x);

    if (r.m)
        r.e = (int16_t)(r.e - 28);
    return r;
}

loft_fine loft_sci_to_fine(loft_sci x)
{
    loft_acc wide = 0;

    if (x.m)
        x.e = (int16_t)(x.e + 28);
    return loft_sci_to_acc(x, &wide) ? wide : 0;
}

static loft_sci mantissa_of(loft_sci x, int32_t *e)
{
    const bool high = x.m > ROOT2;

    *e = x.e + 62 + high;
    x.e = (int16_t)(-62 - high);
    return x;
}

static loft_sci times_power_of_two(loft_sci x, int32_t e)
{
    x.e = (int16_t)(x.e + e);
    return x;
}

static loft_sci ln2_rest(loft_sci x, int32_t n)
{
    return loft_sci_sub(x, loft_sci_mul(loft_sci_from_int(n), LN2));
}

#else

static const loft_sci LN2 = 0x1.62e42fefa39efp-1;

loft_sci  loft_sci_from_fine(loft_fine x) { return x; }
loft_fine loft_sci_to_fine(loft_sci x)       { return x; }

static loft_sci mantissa_of(loft_sci x, int32_t *e)
{
    *e = 0;
    for (int step = 64; step; step /= 8) {              /* by 2^64, 2^8, 2 */
        const double power = step == 64 ? 0x1p64 : step == 8 ? 0x1p8 : 2, inverse = 1 / power;
        while (x > power) {
            x *= inverse;
            *e += step;
        }
        while (x < inverse) {
            x *= power;
            *e -= step;
        }
    }
    for (; x > 1.4142135623730951; ++*e)
        x *= 0.5;
    for (; x < 0.7071067811865475; --*e)
        x *= 2;
    return x;
}

static loft_sci times_power_of_two(loft_sci x, int32_t e)
{
    for (; e >= 32; e -= 32)
        x *= 0x1p32;
    for (; e <= -32; e += 32)
        x *= 0x1p-32;
    for (; e > 0; e--)
        x *= 2;
    for (; e < 0; e++)
        x *= 0.5;
    return x;
}

/* ln 2 is split into two parts. The first has 33 bits, so its product with n is exact. */
static loft_sci ln2_rest(loft_sci x, int32_t n)
{
    return x - n * 0x1.62e42fefp-1 - n * 0x1.473de6af278edp-34;
}

#endif

loft_sci loft_sci_log(loft_sci x)
{
    int32_t e;
    const loft_sci m = mantissa_of(x, &e), one = loft_sci_one(),
                   s = loft_sci_div(loft_sci_sub(m, one), loft_sci_add(m, one));
    const loft_fine square = loft_sci_to_fine(loft_sci_mul(s, s));
    loft_fine sum = LOFT_FINE_1 / 25;

    for (int k = 23; k > 0; k -= 2)
        sum = LOFT_FINE_1 / k + loft_fine_mul(square, sum);
    return loft_sci_add(loft_sci_mul(loft_sci_from_int(e), LN2),
                        loft_sci_mul(loft_sci_add(s, s), loft_sci_from_fine(sum)));
}

loft_sci loft_sci_exp(loft_sci x)
{
    loft_acc ratio = 0;

    if (loft_sci_less(x, loft_sci_from_int(-694)) || !loft_sci_to_acc(loft_sci_div(x, LN2), &ratio))
        return loft_sci_zero();
    const int32_t n = loft_acc_int(ratio);
    const loft_fine r = loft_sci_to_fine(ln2_rest(x, n));
    loft_fine sum = LOFT_FINE_1;
    for (int k = 16; k > 0; k--)
        sum = LOFT_FINE_1 + loft_fine_mul(r, sum) / k;
    const loft_sci power = times_power_of_two(loft_sci_from_fine(sum), n);
    return loft_sci_less(power, loft_sci_power2(-1000)) ? loft_sci_zero() : power;
}
