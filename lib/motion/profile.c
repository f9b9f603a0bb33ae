/* lib/motion/profile.c
 * SPDX-License-Identifier: MIT
 *
 * On a path with direction u and curvature vector k, passed at speed v with acceleration a along it, the
 * acceleration vector is  a u + v^2 k.  With U and K the largest |u| and |k| per axis on the piece and x = v^2,
 * it stays within the limits A when
 *
 *     U a + K x <= A          in every axis
 *
 * a straight line in x, so that all questions have answers in closed form:
 *
 *     x <= A / K                                  how fast at all
 *     a <= (A - K x0) / (U + 2 l K)               from x0, evenly, over the length l, to x0 + 2 l a
 *     a <= (A - K m) / (U + l K)                  up and down again to a peak m + l a, m the mean of both ends
 *
 * q16: x < 2^28, A < 2^14, l <= 256, a <= 16383, so that x + 2 l a < 2^29; K <= 2^14, l K <= 1.
 */
#include "motion/profile.h"

static loft_acc smaller(loft_acc x, loft_acc y) { return x < y ? x : y; }
static loft_acc larger(loft_acc x, loft_acc y)  { return x > y ? x : y; }

void loft_piece_init(loft_piece *p, const loft_budget *b, const loft_arc *arc, loft_real feed)
{
    loft_arc_shape shape;
    loft_real v = feed;

    loft_arc_measure(arc, &shape);
    p->length = arc->length;
    for (int i = 0; i < LOFT_AXES; i++) {
        p->along[i] = shape.along[i];
        p->bend[i]  = shape.bend[i];
        v = loft_real_cap(v, b->max_speed[i], p->along[i]);
        if (shape.tight && b->spare[i] < 2 * v)
            v = b->spare[i] / 2;
    }
    p->most = loft_prod(v, v);
    for (int i = 0; i < LOFT_AXES; i++)
        if (p->bend[i] > 0)
            p->most = smaller(p->most, loft_acc_div(loft_wide(b->accel[i]), p->bend[i]));
}

/* min (A - K x) / (U + lengths K) over the axes */
static loft_real accel_at(const loft_piece *p, const loft_budget *b, loft_acc x, loft_acc lengths)
{
    loft_real a = LOFT_ACCEL_MAX;

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_acc  left = loft_wide(b->accel[i]) - loft_acc_mul(x, p->bend[i]);
        const loft_real over = p->along[i] + loft_acc_round(loft_acc_mul(lengths, p->bend[i]));
        a = loft_real_cap(a, left > 0 ? loft_acc_round(left) : 0, over);
    }
    return a;
}

loft_acc loft_piece_reach(const loft_piece *p, const loft_budget *b, loft_acc from)
{
    const loft_real a = accel_at(p, b, from, 2 * p->length);
    return smaller(p->most, from + 2 * loft_acc_mul(p->length, a));
}

unsigned loft_piece_phases(const loft_piece *p, const loft_budget *b, loft_acc end, loft_phase out[LOFT_PHASES_MAX])
{
    const loft_acc least = smaller(p->start, end), mean = (p->start + end) / 2;
    const loft_acc rise  = loft_acc_mul(p->length, accel_at(p, b, mean, p->length));
    const loft_acc peak  = larger(smaller(p->most, mean + rise), p->start + end - least);
    const loft_real a  = accel_at(p, b, peak, 0);
    const loft_acc all = 2 * loft_acc_mul(p->length, a);

    if (all < peak - least || !(all > 0)) {
        out[0] = (loft_phase){ p->length, p->start, end, loft_acc_quot(end - p->start, 2 * p->length) };
        return 1;
    }
    loft_acc up   = loft_acc_scale(p->length, loft_unit_ratio(peak - p->start, all));
    loft_acc down = loft_acc_scale(p->length, loft_unit_ratio(peak - end, all));

    if (up + down > p->length)
        down = p->length - up;
    out[0] = (loft_phase){ up, p->start, peak, a };
    out[1] = (loft_phase){ p->length - up - down, peak, peak, 0 };
    out[2] = (loft_phase){ down, peak, end, -a };
    return 3;
}

/* v^2 is counted from the slower end, where it is known best. */
loft_real loft_phase_speed(const loft_phase *phase, loft_acc done)
{
    if (phase->accel < 0)
        return loft_acc_sqrt(phase->to - 2 * loft_acc_mul(phase->length - done, phase->accel));
    return loft_acc_sqrt(phase->from + 2 * loft_acc_mul(done, phase->accel));
}
