/* lib/motion/profile.c
 * SPDX-License-Identifier: MIT
 *
 * On a path with direction u and curvature vector k, passed at speed v with acceleration a along it, the
 * acceleration vector is  a u + v^2 k.  With x = v^2, which grows by 2 a per mm, it stays within the limits when
 *
 *     -A <= a u + x k <= A        in every axis
 *
 * a straight line in a and x, so that all questions have answers in closed form. It is asked at the start, the middle
 * and the end of a piece; between them |k| is less than the largest by an eighth of its second difference, which every
 * k is lengthened by in advance. First, x |k| <= A, at each end with the |k| of that half. Then, from x at one end,
 * growing evenly by 2 g per mm toward the other (g = a forward, -a backward), at the part z of the length l
 *
 *     -A <= g c + x k <= A,  c = +-u + 2 l z k     that is     g <= (A - x k) / c  or  (A + x k) / -c
 *
 * A piece may also be passed up and down again, to a peak p: with U, K the largest |u|, |k|
 *
 *     p <= m + l a,  U a + K p <= A                that is     a <= (A - K m) / (U + l K),  m the mean of both ends
 *
 * q16: x < 2^28, x k < 2^14, l <= 256, g <= 16383, so that x + 2 l g < 2^29; |k| < 2^14, l |k| < 1.
 */
#include "motion/profile.h"

static loft_acc  smaller(loft_acc x, loft_acc y) { return x < y ? x : y; }
static loft_acc  larger(loft_acc x, loft_acc y)  { return x > y ? x : y; }
static loft_real size_of(loft_real x)            { return x < 0 ? -x : x; }

static loft_real largest(const loft_vec at[3], int i)
{
    loft_real most = 0;
    for (int k = 0; k < 3; k++)
        most = size_of(at[k].axis[i]) > most ? size_of(at[k].axis[i]) : most;
    return most;
}

/* By what a parabola through three values may exceed the largest of them. */
static loft_real bulge(const loft_vec at[3], int i)
{
    return size_of(at[0].axis[i] / 8 - at[1].axis[i] / 4 + at[2].axis[i] / 8);
}

static loft_acc bend_cap(loft_acc x, loft_real accel, loft_real bend)
{
    return bend > 0 ? smaller(x, loft_acc_div(loft_wide(accel), bend)) : x;
}

void loft_piece_init(loft_piece *p, const loft_budget *b, const loft_arc *arc, loft_real feed)
{
    loft_arc_shape shape;
    loft_real v = feed;

    loft_arc_measure(arc, &shape);
    p->length = arc->length;
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_real more = bulge(shape.bend, i);
        for (int k = 0; k < 3; k++) {
            p->along[k].axis[i] = shape.along[k].axis[i];
            p->bend[k].axis[i]  = shape.tight ? 0 : shape.bend[k].axis[i] + (shape.bend[k].axis[i] < 0 ? -more : more);
        }
        v = loft_real_cap(v, b->max_speed[i], largest(p->along, i) + bulge(p->along, i));
        if (shape.tight && b->spare[i] < 2 * v)
            v = b->spare[i] / 2;
    }
    p->most[0] = p->most[1] = p->top = loft_prod(v, v);
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_real k0 = size_of(p->bend[0].axis[i]), k1 = size_of(p->bend[1].axis[i]), k2 = size_of(p->bend[2].axis[i]);
        p->most[0] = bend_cap(p->most[0], b->accel[i], k0 > k1 ? k0 : k1);
        p->most[1] = bend_cap(p->most[1], b->accel[i], k2 > k1 ? k2 : k1);
        p->top     = bend_cap(p->top, b->accel[i], largest(p->bend, i));
    }
}

loft_acc loft_piece_reach(const loft_piece *p, const loft_budget *b, loft_acc from, bool back)
{
    loft_real g = LOFT_ACCEL_MAX;

    for (int k = 0; k < 3; k++)
        for (int i = 0; i < LOFT_AXES; i++) {
            const loft_vec *along = &p->along[back ? 2 - k : k], *bend = &p->bend[back ? 2 - k : k];
            const loft_real grown = loft_acc_round(loft_acc_mul(p->length * k, bend->axis[i]));
            const loft_real c = (back ? -along->axis[i] : along->axis[i]) + grown;
            const loft_acc used = loft_acc_mul(from, bend->axis[i]);
            const loft_acc left = loft_wide(b->accel[i]) - (c < 0 ? -used : used);
            g = loft_real_cap(g, left > 0 ? loft_acc_round(left) : 0, size_of(c));
        }
    return smaller(p->most[back ? 0 : 1], from + 2 * loft_acc_mul(p->length, g));
}

/* min (A - K x) / (U + length K) over the axes */
static loft_real accel_at(const loft_piece *p, const loft_budget *b, loft_acc x, loft_acc length)
{
    loft_real a = LOFT_ACCEL_MAX;

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_real most = largest(p->bend, i);
        const loft_acc  left = loft_wide(b->accel[i]) - loft_acc_mul(x, most);
        a = loft_real_cap(a, left > 0 ? loft_acc_round(left) : 0, largest(p->along, i) + loft_acc_round(loft_acc_mul(length, most)));
    }
    return a;
}

unsigned loft_piece_phases(const loft_piece *p, const loft_budget *b, loft_acc end, loft_phase out[LOFT_PHASES_MAX])
{
    const loft_acc least = smaller(p->start, end), mean = (p->start + end) / 2;
    const loft_acc rise  = loft_acc_mul(p->length, accel_at(p, b, mean, p->length));
    const loft_acc peak  = larger(smaller(p->top, mean + rise), larger(p->start, end));
    const loft_real a    = accel_at(p, b, peak, 0);
    const loft_acc all   = 2 * loft_acc_mul(p->length, a);

    if (all < peak - least || !(all > 0)) {
        out[0] = (loft_phase){ p->length, p->start, end, loft_acc_quot(end - p->start, 2 * p->length) };
        return 1;
    }
    const loft_acc up   = loft_acc_scale(p->length, loft_unit_ratio(peak - p->start, all)), rest = p->length - up;
    const loft_acc down = smaller(rest, loft_acc_scale(p->length, loft_unit_ratio(peak - end, all)));

    out[0] = (loft_phase){ up, p->start, peak, a };
    out[1] = (loft_phase){ rest - down, peak, peak, 0 };
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
