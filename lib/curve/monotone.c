/* lib/curve/monotone.c
 * SPDX-License-Identifier: MIT
 *
 * D[i] = (y[i + 1] - y[i]) / (x[i + 1] - x[i]) are the secants. The slopes begin as the means of
 * the secants beside them, 0 where these have different signs or one is 0. A cubic rises all along
 * its interval if its slopes m, n are within the circle m^2 + n^2 <= 9 D^2 (Fritsch and Carlson,
 * region S2); those outside are drawn back to it, from left to right, each as the one before left
 * it.
 *
 * q16: a secant errs by 2^-33, a mean by as much again. On the circle m becomes 3 D m / l, l the
 * length of (m, n) with 59 bits: D adds 3 * 2^-33, the quotient 2^-33, the length, below 2^23,
 * 2^-36. A slope that is drawn back twice has erred by less than 2^-30. The arm of the cubic is
 * a third of the slope times h, so it errs by h 2^-30 / 3 + 2^-33, and two of them with weights
 * of at most 3/4 in all make less than h 2^-31, which is h 2^-15 LSB.
 */
#include "curve/monotone.h"
#include "num/muldiv.h"         /* loft_acc_muldiv, loft_acc_length */

#define STEEPEST ((int32_t)1 << 22)

static loft_acc difference(loft_real from, loft_real to)
{
    return loft_to_acc(to) - loft_to_acc(from);
}

static loft_acc secant(const loft_real x[], const loft_real y[], uint32_t i)
{
    return loft_acc_muldiv(loft_to_acc(LOFT_REAL(1)), difference(y[i], y[i + 1]),
                           difference(x[i], x[i + 1]));
}

static enum loft_status check(const loft_real x[], const loft_real y[], uint32_t count)
{
    if (count < 2)
        return LOFT_ERR_ARG;
    for (uint32_t i = 0; i < count; i++)
        if (!loft_real_valid(x[i]) || !loft_real_valid(y[i]))
            return LOFT_ERR_RANGE;
    for (uint32_t i = 0; i + 1 < count; i++) {
        if (x[i] >= x[i + 1])
            return LOFT_ERR_ARG;
        if (loft_acc_ratio(loft_acc_abs(difference(y[i], y[i + 1])), STEEPEST) >
            difference(x[i], x[i + 1]))
            return LOFT_ERR_RANGE;
    }
    return LOFT_OK;
}

/* Draw the slopes m[0] and m[1] beside the secant d back to the circle, if they are outside. */
static void draw_back(loft_acc d, loft_acc m[2])
{
    uint8_t shift;
    loft_acc reach = 3 * loft_acc_abs(d);
    const loft_acc length = loft_acc_length(m, 2, &shift);

    if (d == 0) {
        m[0] = m[1] = 0;
        return;
    }
    if (reach >= loft_acc_abs(m[0]) + loft_acc_abs(m[1]))
        return;                 /* so that reach times 2^shift has room below */
    for (unsigned i = 0; i < shift; i++)
        reach = 2 * reach;
    if (reach < length)
        for (int i = 0; i < 2; i++)
            m[i] = loft_acc_muldiv(reach, m[i], length);
}

enum loft_status loft_monotone_init(loft_monotone *f, const loft_real x[], const loft_real y[],
                                    uint32_t count, loft_acc slope[])
{
    const enum loft_status status = check(x, y, count);

    if (status != LOFT_OK)
        return status;
    loft_acc before = secant(x, y, 0);
    slope[0] = before;
    for (uint32_t i = 1; i + 1 < count; i++) {
        const loft_acc behind = secant(x, y, i);
        const bool turns = (before <= 0 && behind >= 0) || (before >= 0 && behind <= 0);
        slope[i] = turns ? 0 : loft_acc_mean(before, behind);
        before = behind;
    }
    slope[count - 1] = before;
    for (uint32_t i = 0; i + 1 < count; i++)
        draw_back(secant(x, y, i), &slope[i]);

    f->x = x;
    f->y = y;
    f->slope = slope;
    f->count = count;
    return LOFT_OK;
}

/* The interval that x is in; x is between the first point and the last. */
static uint32_t interval_of(const loft_monotone *f, loft_real x)
{
    uint32_t low = 0, high = f->count - 1;

    while (high - low > 1) {
        const uint32_t middle = low + (high - low) / 2;
        if (f->x[middle] <= x)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* de Casteljau in the parameter x, x0..x1. */
static loft_acc blossom_at(loft_acc b[], int degree, loft_real x, loft_real x0, loft_real x1)
{
    for (int k = degree; k > 0; k--)
        for (int i = 0; i < k; i++)
            b[i] = loft_acc_lerp_in(b[i], b[i + 1], x, x0, x1);
    return b[0];
}

loft_real loft_monotone_eval(const loft_monotone *f, loft_real x)
{
    const uint32_t last = f->count - 1;

    if (x <= f->x[0])
        return f->y[0];
    if (x >= f->x[last])
        return f->y[last];
    const uint32_t i = interval_of(f, x);
    const loft_acc h = difference(f->x[i], f->x[i + 1]), three = loft_to_acc(LOFT_REAL(3));
    const loft_acc from = loft_to_acc(f->y[i]), to = loft_to_acc(f->y[i + 1]);
    loft_acc b[4] = { from, from + loft_acc_muldiv(h, f->slope[i], three),
                      to - loft_acc_muldiv(h, f->slope[i + 1], three), to };

    return loft_acc_round(blossom_at(b, 3, x, f->x[i], f->x[i + 1]));
}

loft_acc loft_monotone_deriv(const loft_monotone *f, loft_real x)
{
    const uint32_t last = f->count - 1;

    if (x < f->x[0] || x > f->x[last])
        return 0;
    const uint32_t i = interval_of(f, x);
    const loft_acc m = f->slope[i], n = f->slope[i + 1];
    loft_acc b[3] = { m, 3 * secant(f->x, f->y, i) - m - n, n };

    return blossom_at(b, 2, x, f->x[i], f->x[i + 1]);
}
