/* lib/motion/sample.c
 * SPDX-License-Identifier: MIT
 *
 * The time from a knot to the part z of the way to the next is the integral of 1 / sqrt b, by
 * Gauss with three points: it errs by z^7 / 2,016,000 of the sixth derivative of the integrand.
 */
#include "motion/sample.h"

#include "num/part.h"       /* loft_part_root_fine */

#define ONE         ((int32_t)1 << 30)
#define CLOSE       256                         /* of a time, 2^-22 of a period */

/* b at the part z, 2^-24. */
static int64_t pace_at(const loft_knot knot[], unsigned k, int32_t z)
{
    const int64_t b0 = ((int64_t)knot[k].is.pace.v2 + knot[k + 1].is.pace.v2) / 2,
                  rise = (int64_t)knot[k + 1].is.pace.v2 - knot[k].is.pace.v2,
                  curve = (int64_t)knot[k + 2].is.pace.v2 - knot[k + 1].is.pace.v2 - rise;
    return b0 + ((rise + (curve * z >> 31)) * z >> 30);
}

/* 1 / sqrt b, 2^-30. */
static int64_t slowness(int64_t b)
{
    const uint32_t size = b > 0 ? (uint32_t)b : 1;
    const int half = loft_doublings(size) / 2;
    const int64_t root = loft_part_root_fine(size << 2 * half);
    return half >= 2 ? root << (half - 2) : root >> (2 - half);
}

static loft_time time_to(const loft_knot knot[], unsigned k, int32_t z)
{
    /* (1 -+ sqrt(3/5)) / 2, weights 5/18, 8/18, 5/18 */
    static const int32_t at[3] = { 121015611, 536870912, 952726213 };
    loft_time sum = 0;

    for (int n = 0; n < 3; n++) {
        const int64_t b = pace_at(knot, k, (int32_t)((int64_t)at[n] * z >> 30));
        sum += (n == 1 ? 8 : 5) * slowness(b);
    }
    /* sum <= 18 * 2^30 * 2^12; 1 / 18 is 2^-29 29826162, but for 2^-27 of it */
    const int64_t mean = (sum >> 10) * 29826162 >> 19;
    return (mean >> 30) * z + (((mean & (ONE - 1)) * z) >> 30);
}

loft_time loft_sample_time(const loft_knot knot[], unsigned k) { return time_to(knot, k, ONE); }

loft_time loft_sample_pass(loft_sample *at, const loft_knot knot[], unsigned last, loft_time time)
{
    at->time += time;
    while (at->knot < last) {
        if (at->whole == 0)
            at->whole = loft_sample_time(knot, at->knot);
        if (at->time < at->whole)
            return 0;
        at->time -= at->whole;
        at->whole = 0;
        at->knot++;
    }
    const loft_time left = at->time;
    at->time = 0;
    return left;
}

/* Newton, from what even acceleration gives. */
int32_t loft_sample_part(const loft_sample *at, const loft_knot knot[])
{
    const unsigned k = at->knot;
    if (at->time == 0)
        return 0;
    const loft_time whole = at->whole > 0 ? at->whole : loft_sample_time(knot, k);
    int64_t z = (at->time << 20) / ((whole >> 10) + 1);

    for (int n = 0; n < 4; n++) {
        z = z > ONE ? ONE : z < 0 ? 0 : z;
        const int64_t off = at->time - time_to(knot, k, (int32_t)z);
        if (loft_long_abs(off) < CLOSE)
            break;
        const int64_t b = pace_at(knot, k, (int32_t)z), root = b * slowness(b) >> 25;
        z += (off >> 8) * (root >> 8) >> 13;
    }
    return z > ONE ? ONE : z < 0 ? 0 : (int32_t)z;
}

/* 6 S = 6 Q + D2 + z (6 D1 + z (3 D2 + z D3)) */
void loft_sample_place(const loft_sample *at, const loft_knot knot[], loft_position *out)
{
    const unsigned k = at->knot;
    const int64_t z = loft_sample_part(at, knot);

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_coord q = knot[k].point.axis[i];
        const int64_t a = loft_coord_sub(q, knot[k - 1].point.axis[i]),
                      b = loft_coord_sub(knot[k + 1].point.axis[i], q),
                      c = z > 0
                              ? loft_coord_sub(knot[k + 2].point.axis[i], knot[k + 1].point.axis[i])
                              : b;
        int64_t sum = c - 2 * b + a;
        sum = 3 * (b - a) + (sum * z >> 30);
        sum = 3 * (a + b) + (sum * z >> 30);
        sum = (b - a) + (sum * z >> 30);
        out->axis[i] = loft_coord_add(q, (loft_coord)((sum + (sum < 0 ? -3 : 3)) / 6));
    }
}
