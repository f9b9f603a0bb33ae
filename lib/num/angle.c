/* lib/num/angle.c
 * SPDX-License-Identifier: MIT
 *
 * An angle is reduced to k quarter turns and a remainder r, |r| <= pi/4. For r the series
 *
 *     sin r = r (1 - r^2/(2*3) (1 - r^2/(4*5) (1 - .. r^2/(16*17))))      next term below 2^-63
 *     cos r =    1 - r^2/(1*2) (1 - r^2/(3*4) (1 - .. r^2/(17*18)))       next term below 2^-68
 *
 * are summed from the end. Each step rounds by at most 2^-60, and the following steps multiply that
 * by r^2/2 < 0.31 or less: the sum of the errors is below 2^-58 (q16). In doubles the steps round
 * by 2^-54, the last one by 2^-53.
 */
#include "num/angle.h"

static loft_fine quarter_rest(loft_acc a, int32_t *quarters);  /* |r| <= pi/4, about */

#if LOFT_NUM == LOFT_Q16

#define HALF_PI ((loft_fine)1811004864519280711)

/* (a b + 2^59) / 2^60, |a b| < 2^123: four 32-bit products. It works on magnitudes, so ties go away
 * from 0. */
static int64_t multiply_fine(int64_t a, int64_t b)
{
    const uint64_t x = loft_acc_size(a), y = loft_acc_size(b);
    const uint64_t x1 = x >> 32, x0 = x & 0xffffffffu, y1 = y >> 32, y0 = y & 0xffffffffu;
    const uint64_t middle = x1 * y0 + (x0 * y0 >> 32);             /* below 2^31 2^32 + 2^32 */
    const uint64_t cross = x0 * y1 + (middle & 0xffffffffu);
    const uint64_t high = x1 * y1 + (middle >> 32) + (cross >> 32);
    const uint64_t low = cross << 32 | (x0 * y0 & 0xffffffffu);
    const uint64_t size = (high << 4 | low >> 60) + (low >> 59 & 1);
    return (a < 0) != (b < 0) ? -(int64_t)size : (int64_t)size;
}

bool loft_fine_valid(loft_real a)
{
    (void)a;
    return true;
}
loft_fine loft_fine_of(loft_real a) { return (loft_fine)a * ((loft_fine)1 << 44); }
loft_fine loft_fine_unit(loft_unit t) { return (loft_fine)t * ((loft_fine)1 << 36); }
loft_acc loft_fine_to_acc(loft_fine x) { return (x / 134217728 + (x < 0 ? -1 : 1)) / 2; }
loft_fine loft_fine_mul(loft_fine x, loft_fine y)       { return multiply_fine(x, y); }
loft_acc  loft_fine_scale(loft_acc a, loft_fine x)      { return multiply_fine(a, x); }

/* `bits` fraction bits of x / y, x < y < 2^63, rounded. */
static uint64_t fraction_bits(uint64_t x, uint64_t y, int bits)
{
    uint64_t q = 0;

    for (int round = 0; round < bits; round++) {
        x += x;
        q += q;
        if (x >= y) {
            x -= y;
            q++;
        }
    }
    return q + (x + x >= y);
}

loft_acc loft_fine_quot(loft_fine x, loft_fine y)
{
    const uint64_t n = loft_acc_size(x), d = loft_acc_size(y);
    const int64_t q = (int64_t)((n / d << 32) + fraction_bits(n % d, d, 32));
    return (x < 0) != (y < 0) ? -q : q;
}

loft_fine loft_fine_ratio(loft_acc x, loft_acc y)
{
    const uint64_t n = loft_acc_size(x), d = loft_acc_size(y);
    const loft_fine q = (loft_fine)((n / d << 60) + fraction_bits(n % d, d, 60));
    return (x < 0) != (y < 0) ? -q : q;
}

/* The difference is correct modulo 2^64, whatever its operands lose. */
static loft_fine quarter_rest(loft_acc a, int32_t *quarters)
{
    const int64_t quarter = HALF_PI >> 28, half = a < 0 ? -(quarter / 2) : quarter / 2;

    *quarters = (int32_t)((a + half) / quarter);
    return (loft_fine)((uint64_t)a * 268435456 - (uint64_t)*quarters * (uint64_t)HALF_PI);
}

static loft_fine quarter_rest_fine(loft_fine x, int32_t *quarters)
{
    *quarters = x > 0 ? (int32_t)((x / 2 + HALF_PI / 4) / (HALF_PI / 2))
                      : -(int32_t)((HALF_PI / 4 - x / 2) / (HALF_PI / 2));
    return x - *quarters * HALF_PI;
}

/* Scale both alike, the larger to 2^59 .. 2^60. */
static void normalise_vector(int64_t *x, int64_t *y)
{
    const int64_t top = (int64_t)1 << 59;

    while (*x >= 2 * top || *x <= -2 * top || *y >= 2 * top || *y <= -2 * top) {
        *x /= 2;
        *y /= 2;
    }
    while (*x < top && *x > -top && *y < top && *y > -top) {
        *x *= 2;
        *y *= 2;
    }
}

#else

#define HALF_PI 1.5707963267948966

bool loft_fine_valid(loft_real a) { return (double)a < 0x1p400 && (double)a > -0x1p400; }
loft_fine loft_fine_of(loft_real a)                     { return (loft_fine)a; }
loft_acc  loft_fine_to_acc(loft_fine x)                   { return x; }
loft_fine loft_fine_mul(loft_fine x, loft_fine y)       { return x * y; }
loft_acc  loft_fine_scale(loft_acc a, loft_fine x)      { return a * x; }
loft_acc  loft_fine_quot(loft_fine x, loft_fine y)      { return x / y; }
loft_fine loft_fine_ratio(loft_acc x, loft_acc y)       { return x / y; }
loft_fine loft_fine_unit(loft_unit t)                   { return (loft_fine)t; }

/* pi/2 is split into two parts. The first has 33 bits, so its product with up to 2^20 quarters is
 * exact. */
static loft_fine quarter_rest(loft_acc a, int32_t *quarters)
{
    *quarters = loft_acc_int(a / HALF_PI);
    return a - *quarters * 0x1.921fb544p0 - *quarters * 0x1.0b4611a626331p-34;
}

static loft_fine quarter_rest_fine(loft_fine x, int32_t *quarters)
{
    return quarter_rest(x, quarters);
}

static void normalise_vector(double *x, double *y)
{
    (void)x;
    (void)y;
}

#endif

/* Newton's method from above: each step is at least the root, and decreases until it reaches the
 * root. */
loft_fine loft_fine_sqrt(loft_fine x)
{
    loft_fine root = LOFT_FINE_1, next = (LOFT_FINE_1 + x) / 2;

    if (!(x > 0))
        return 0;
    while (next < root) {
        root = next;
        next = (root + loft_fine_ratio(x, root)) / 2;
    }
    return root;
}

static loft_fine short_sine(loft_fine r)
{
    const loft_fine square = loft_fine_mul(r, r);
    loft_fine sum = LOFT_FINE_1;

    for (int k = 16; k > 0; k -= 2)
        sum = LOFT_FINE_1 - loft_fine_mul(square, sum) / (k * (k + 1));
    return loft_fine_mul(r, sum);
}

static loft_fine short_cosine(loft_fine r)
{
    const loft_fine square = loft_fine_mul(r, r);
    loft_fine sum = LOFT_FINE_1;

    for (int k = 17; k > 0; k -= 2)
        sum = LOFT_FINE_1 - loft_fine_mul(square, sum) / (k * (k + 1));
    return sum;
}

/* The sine of r plus `quarters` quarter turns. */
static loft_fine sine_at(loft_fine r, int32_t quarters)
{
    const loft_fine size = quarters & 1 ? short_cosine(r) : short_sine(r);
    return quarters & 2 ? -size : size;
}

loft_fine loft_fine_sin(loft_fine x)
{
    int32_t quarters;
    const loft_fine r = quarter_rest_fine(x, &quarters);
    return sine_at(r, quarters);
}

loft_fine loft_fine_cos(loft_fine x)
{
    int32_t quarters;
    const loft_fine r = quarter_rest_fine(x, &quarters);
    return sine_at(r, quarters + 1);
}

loft_acc loft_sin(loft_acc a)
{
    int32_t quarters;
    const loft_fine r = quarter_rest(a, &quarters);
    return loft_fine_to_acc(sine_at(r, quarters));
}

loft_acc loft_cos(loft_acc a)
{
    int32_t quarters;
    const loft_fine r = quarter_rest(a, &quarters);
    return loft_fine_to_acc(sine_at(r, quarters + 1));
}

/* Four quarters are none, and three are one backwards. Two are added with the sign that keeps the
 * result within half a turn. */
loft_fine loft_fine_angle(loft_acc a)
{
    int32_t quarters;
    const loft_fine r = quarter_rest(a, &quarters);

    switch (quarters & 3) {
    case 0:  return r;
    case 1:  return r + HALF_PI;
    case 2:  return r > 0 ? r - LOFT_FINE_PI : r + LOFT_FINE_PI;
    default: return r - HALF_PI;
    }
}

/* Start from the nearest axis and rotate the vector back by the angle found so far. The rotated
 * vector has tangent q and angle q - q^3/3 to within q^5/5. From |q| <= 1 on, the remaining error
 * is 0.12, 5e-6 and 1e-27. */
loft_fine loft_fine_atan2(loft_acc y, loft_acc x)
{
    const bool below = y < 0;

    if (!(x < 0) && !(x > 0) && !(y < 0) && !(y > 0))
        return 0;
    normalise_vector(&x, &y);
    const loft_acc size = loft_acc_abs(y);
    loft_fine angle = x < 0 && -x > size ? (below ? -LOFT_FINE_PI : LOFT_FINE_PI)
                      : x >= size        ? 0
                                         : (below ? -HALF_PI : HALF_PI);

    for (int round = 0; round < 3; round++) {
        const loft_fine c = loft_fine_cos(angle), s = loft_fine_sin(angle);
        const loft_fine q = loft_fine_ratio(loft_fine_scale(y, c) - loft_fine_scale(x, s),
                                            loft_fine_scale(x, c) + loft_fine_scale(y, s));
        angle += q - loft_fine_mul(loft_fine_mul(q, q), q) / 3;
    }
    return angle > LOFT_FINE_PI ? LOFT_FINE_PI : angle < -LOFT_FINE_PI ? -LOFT_FINE_PI : angle;
}

loft_acc loft_atan2(loft_acc y, loft_acc x)     { return loft_fine_to_acc(loft_fine_atan2(y, x)); }
