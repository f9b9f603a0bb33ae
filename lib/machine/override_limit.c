/* lib/machine/override_limit.c
 * SPDX-License-Identifier: MIT
 */
#include "machine/override_limit.h"

/* Let D1, D2, D3 be the largest first, second and third difference of the control points of an
 * axis, and s the seconds of the span. Then
 *
 *     |x'| <= 3 D1 / s      |x''| <= 6 D2 / s^2      |x'''| = 6 D3 / s^3
 *
 * so at the pace r the limits V, A and J hold if
 *
 *     r <= V s / (3 D1)     r^2 <= A s^2 / (6 D2)    r^3 <= J s^3 / (6 D3)
 *
 * D1 to D3 do not count the possible rounding of points by 1/2: 1, 2 and 4. A span of n ticks may
 * follow one of m ticks. With d its own first difference and e the last difference of the span
 * before, the velocity jumps by 3 (d m - e n) / (m n) per tick. More than twice the rounding, m +
 * n, is a real jump, which must not grow.
 *
 * In numbers: a difference of 2^27 (2 m) or more allows nothing, so 6 D3 is below 2^32. s is in
 * Q24, rounded down, below 2^29 (1023 ticks at 50 Hz; a lower rate counts as 50). V s, A s^2 and J
 * s^3 are raw mm, rounded down, at most 2^32 - 1. A quotient is computed in units of 1 / `unit`,
 * and only up to `most`. Before the division the limit is shifted down to 23 bits, and the need as
 * well, but rounded up. */
#define FAR ((uint32_t)1 << 27)

/* limit * seconds / 2^24 */
static uint32_t times_seconds(uint32_t limit, uint32_t seconds)
{
    const uint64_t product = (uint64_t)limit * seconds;

    return product >> 56 ? UINT32_MAX : (uint32_t)(product >> 24);
}

static uint16_t limit_quotient(uint32_t limit, uint32_t need, uint16_t unit, uint16_t most)
{
    for (; limit >= (uint32_t)1 << 23; limit >>= 1)
        need = (need >> 1) + (need & 1);
    if (need == 0)
        return most;
    const uint32_t q = limit * unit / need;
    return q > most ? most : (uint16_t)q;
}

/* The largest c = 64 r^2 for 512 r^3: c^3 <= (512 r^3)^2 <= 2^24. */
static uint16_t square_of_cube(uint16_t cube)
{
    const uint32_t square = (uint32_t)cube * cube;
    uint16_t c = 0;

    for (uint16_t bit = 256; bit; bit >>= 1) {
        const uint32_t trial = (uint32_t)c + bit;
        if (trial <= 256 && trial * trial * trial <= square)
            c = (uint16_t)trial;
    }
    return c;
}

static uint16_t min_u16(uint16_t a, uint16_t b)      { return a < b ? a : b; }
static uint32_t max_u32(uint32_t a, uint32_t b)     { return a > b ? a : b; }

/* The absolute difference beyond the possible rounding. */
static uint32_t sure_difference(int32_t d, uint8_t rounding)
{
    const uint32_t size = d < 0 ? 0 - (uint32_t)d : (uint32_t)d;

    return size > rounding ? size - rounding : 0;
}

/* b - a; *far is set if it is FAR or more. */
static int32_t raw_difference(int32_t a, int32_t b, bool *far)
{
    const uint32_t d = (uint32_t)b - (uint32_t)a;

    if ((b < a ? 0 - d : d) >= FAR)
        *far = true;
    return (int32_t)d;
}

/* True if the velocity jumps. */
static bool velocity_jumps(int32_t d, uint16_t n, int32_t e, uint16_t m)
{
    const int64_t by = (int64_t)d * m - (int64_t)e * n, rounding = 2 * (int32_t)(m + n);

    return by > rounding || by < -rounding;
}

static uint16_t axis_limit(const int32_t d[3], const loft_axis_config *axis, uint32_t seconds)
{
    const int32_t d20 = d[1] - d[0], d21 = d[2] - d[1];
    uint16_t limit = 256;

    if (axis->max_speed > 0) {
        const uint32_t need = 3 *
                              max_u32(max_u32(sure_difference(d[0], 1), sure_difference(d[1], 1)),
                                      sure_difference(d[2], 1));
        const uint16_t r = limit_quotient(times_seconds((uint32_t)axis->max_speed, seconds), need,
                                          128, 256);
        limit = (uint16_t)((uint32_t)r * r >> 8);
    }
    if (axis->max_accel > 0) {
        const uint32_t need = 6 * max_u32(sure_difference(d20, 2), sure_difference(d21, 2));
        limit = min_u16(
            limit, limit_quotient(
                       times_seconds(times_seconds((uint32_t)axis->max_accel, seconds), seconds),
                       need, 64, 256));
    }
    if (axis->max_jerk > 0) {
        const uint64_t raw = (uint64_t)axis->max_jerk * seconds >> 8;
        const uint32_t change = times_seconds(raw > UINT32_MAX ? UINT32_MAX : (uint32_t)raw,
                                              seconds);
        limit = min_u16(
            limit, square_of_cube(limit_quotient(times_seconds(change, seconds),
                                                 6 * sure_difference(d21 - d20, 4), 512, 4096)));
    }
    return limit;
}

uint8_t loft_override_limit_of(const loft_item *item, const int32_t from[LOFT_AXES],
                               const volatile loft_item *before,
                               const loft_axis_config axis[LOFT_AXES], uint16_t tick_hz)
{
    const uint32_t seconds = ((uint32_t)item->ticks << 22) / (tick_hz < 50 ? 50 : tick_hz) << 2;
    uint16_t limit = 256;
    bool far = false, moves = false;

    for (int i = 0; i < LOFT_AXES && limit > LOFT_OVERRIDE_LIMIT_ONE + 1; i++) {
        const int32_t d[3] = { raw_difference(from[i], item->p[0][i], &far),
                               raw_difference(item->p[0][i], item->p[1][i], &far),
                               raw_difference(item->p[1][i], item->p[2][i], &far) };
        const int32_t e = before ? raw_difference(before->p[1][i], before->p[2][i], &far) : 0;
        if (far || velocity_jumps(d[0], item->ticks, e, before ? before->ticks : 1))
            return LOFT_OVERRIDE_LIMIT_ONE;
        if (d[0] || d[1] || d[2]) {
            moves = true;
            limit = min_u16(limit, axis_limit(d, &axis[i], seconds));
        }
    }
    if (!moves)
        return LOFT_OVERRIDE_LIMIT_ONE;
    return (uint8_t)((limit < LOFT_OVERRIDE_LIMIT_ONE + 1 ? LOFT_OVERRIDE_LIMIT_ONE + 1 : limit) -
                     1);
}
