/* tests/target/libc/test_libc.c -- checks the mathematics under the tests' references, by
 * identities and known values in 113 bits
 * SPDX-License-Identifier: MIT
 */
#include <math.h>

#include "check.h"

static void is_near(long double got, long double want, long double bound)
{
    CHECK_NEAR((double)(fabsl(got - want) / bound), 0, 1);
}

/* To 36 digits, from another program */
static void known_values_are_met(arb *a)
{
    (void)a;
    is_near(sqrtl(2), 1.414213562373095048801688724209698079L, 0x1p-110L);
    is_near(expl(1), 2.718281828459045235360287471352662498L, 0x1p-108L);
    is_near(logl(10), 2.302585092994045684017991454684364208L, 0x1p-108L);
    is_near(sinl(1), 0.841470984807896506652502321630298999L, 0x1p-108L);
    is_near(cosl(1), 0.540302305868139717400936607442976603L, 0x1p-108L);
    is_near(4 * atan2l(1, 1), 3.141592653589793238462643383279502884L, 0x1p-108L);
    is_near(atan2l(1, -2), 2.677945044588987122248387151818288482L, 0x1p-108L);
    is_near(asinl(0.5L) * 6, acosl(-1), 0x1p-105L);
    is_near(exp2l(0.5L), sqrtl(2), 0x1p-108L);
    is_near(log2l(1024), 10, 0x1p-105L);
    is_near(hypotl(3e300L, -4e300L) / 1e300L, 5, 0x1p-108L);
    CHECK(sqrt(2) == 0x1.6a09e667f3bcdp0 && sqrt(1e-200) == 1e-100 && sqrt(0) == 0);
    CHECK(nextafter(1, 2) == 1 + 0x1p-52 && nextafter(1, 0) == 1 - 0x1p-53 &&
          nextafter(0, -1) == -0x1p-1074 && nextafterf(1, 2) == 1 + 0x1p-23f);
    CHECK(floor(-0.5) == -1 && ceil(-0.5) == 0 && round(-0.5) == -1 && round(2.5) == 3 &&
          lround(-2.5) == -3 && llroundl(0x1p52L + 0.25L) == 1ll << 52);
    CHECK(fmod(-7.5, 2) == -1.5 && remainderl(7.5L, 2) == -0.5L && remainderl(3, 2) == -1 &&
          remainderl(5, 2) == 1 && powl(3, -2) * 9 == 1 && pow(2, 0.5) == sqrt(2));
}

static void functions_invert_each_other(arb *a)
{
    const long double x = (long double)arb_next(a) * 0x1p-64L,
                      y = (long double)arb_next(a) * 0x1p-60L + 1;
    const long double angle = (x - 0.5L) * 6.28L, s = sinl(angle), c = cosl(angle);
    int n;

    is_near(sqrtl(x) * sqrtl(x), x, 0x1p-110L);
    is_near(s * s + c * c, 1, 0x1p-108L);
    is_near(atan2l(s * y, c * y), angle, 0x1p-105L);
    is_near(sinl(x + y), sinl(x) * cosl(y) + cosl(x) * sinl(y), 0x1p-104L);
    is_near(expl(logl(y)) / y, 1, 0x1p-104L);
    is_near(expl(x + y) / (expl(x) * expl(y)), 1, 0x1p-104L);
    is_near(sinl(asinl(x)), x, 0x1p-106L);
    is_near(cosl(acosl(-x)), -x, 0x1p-106L);
    is_near(tanl(x) * cosl(x), sinl(x), 0x1p-106L);
    is_near(powl(y, 5) / (y * y * y * y * y), 1, 0x1p-108L);
    is_near(powl(y, 0.25L), sqrtl(sqrtl(y)), 0x1p-104L);
    const long double m = frexpl(x * 0x1p-9000L, &n);
    CHECK(x == 0 || (m >= 0.5L && m < 1 && ldexpl(m, n + 9000) == x));
    CHECK(x / y * y - x <= 0x1p-112L && x - x / y * y <= 0x1p-112L);
}

int main(void)
{
    PROPERTY(known_values_are_met, 1);
    PROPERTY(functions_invert_each_other, 2000);
    return check_failures();
}
