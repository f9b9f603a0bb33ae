/* lib/motion/tube.c
 * SPDX-License-Identifier: MIT
 *
 * The spline with control points Q is at (Q[k-1] + 4 Q[k] + Q[k+1]) / 6 at knot k. So it meets the
 * places P to within D4 P / 36 if Q is at the centres C = P - D2 P / 6, and leaves them by at most
 * r more if each Q is within r of its centre.
 *
 * The sum of the squares of the third differences is least where
 *
 *     20 Q[k] - 15 (Q[k-1] + Q[k+1]) + 6 (Q[k-2] + Q[k+2]) - (Q[k-3] + Q[k+3]) = 0
 *
 * Each point in turn is moved 1.4 times as far as that asks for (over-relaxation), and back into
 * its ball.
 */
#include "motion/tube.h"

#define RELAX       4588            /* 1.4 / 20, 2^-16 */
#define SIXTH       10923           /* 1 / 6, 2^-16    */

static loft_coord sixth(loft_coord x) { return (loft_coord)(((int64_t)x * SIXTH + 32768) >> 16); }

static loft_coord second(loft_coord a, loft_coord b, loft_coord c)
{
    return loft_coord_sub(a, b) + loft_coord_sub(c, b);
}

static loft_coord centre(const loft_knot knot[], unsigned k, int i)
{
    const loft_coord at = knot[k].on.at.axis[i];
    return loft_coord_add(at,
                          -sixth(second(knot[k - 1].on.at.axis[i], at, knot[k + 1].on.at.axis[i])));
}

void loft_tube_load(loft_knot knot[], unsigned from, unsigned to)
{
    for (unsigned k = from; k < to; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            knot[k].point.axis[i] = centre(knot, k, i);
}

static int64_t off(const loft_knot knot[], unsigned k, int d, int i, loft_coord q)
{
    return (int64_t)loft_coord_sub(knot[k - (unsigned)d].point.axis[i], q) +
           loft_coord_sub(knot[k + (unsigned)d].point.axis[i], q);
}

/* The centre of a knot; of the first one that is kept, its place. */
static void centre_of(const loft_knot knot[], unsigned k, loft_coord out[])
{
    for (int i = 0; i < LOFT_AXES; i++)
        out[i] = k > 0 ? centre(knot, k, i) : knot[0].on.at.axis[i];
}

/* How far the spline through the centres is from the cubic through the places, in the middle
 * between knot k and the next: it is (C[k-1] + 23 C[k] + 23 C[k+1] + C[k+2]) / 48 there. */
static loft_coord off_between(const loft_knot knot[], unsigned k, const loft_path_place *const at[])
{
    loft_coord a[LOFT_AXES], b[LOFT_AXES], c[LOFT_AXES], d[LOFT_AXES];
    loft_position p;

    centre_of(knot, k - 1, a);
    centre_of(knot, k, b);
    centre_of(knot, k + 1, c);
    centre_of(knot, k + 2, d);
    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t sum = (int64_t)loft_coord_sub(a[i], b[i]) +
                            23 * (int64_t)loft_coord_sub(c[i], b[i]) + loft_coord_sub(d[i], b[i]);
        p.axis[i] = loft_coord_add(b[i], (loft_coord)(sum / 48));
    }
    return loft_path_off(at, INT32_C(1) << 23, &p);
}

/* The same at knot k, where it is D4 / 36 off: from the way before it or from the way behind it. */
static loft_coord off_at(const loft_knot knot[], unsigned k, const loft_path_place *const before[],
                         const loft_path_place *const behind[])
{
    loft_coord a[LOFT_AXES], b[LOFT_AXES], c[LOFT_AXES];
    loft_position p;

    centre_of(knot, k - 1, a);
    centre_of(knot, k, b);
    centre_of(knot, k + 1, c);
    for (int i = 0; i < LOFT_AXES; i++)
        p.axis[i] = loft_coord_add(b[i], sixth(second(a[i], b[i], c[i])));
    const loft_coord x = loft_path_off(before, INT32_C(1) << 24, &p),
                     y = loft_path_off(behind, 0, &p);
    return x < y ? x : y;
}

static void four(const loft_knot knot[], unsigned k, const loft_path_place *at[])
{
    for (unsigned i = 0; i < 4; i++)
        at[i] = &knot[k + i - 1].on;
}

/* The part of the tolerance that is left between knot k and the next. */
static loft_coord left_between(const loft_period *p, const loft_knot knot[], unsigned k)
{
    const loft_path_place *before[4], *here[4], *behind[4];

    four(knot, k - (k > 1), before);
    four(knot, k, here);
    four(knot, k + 1, behind);
    const loft_coord x = k > 1 ? off_at(knot, k, before, here) : 0,
                     y = off_at(knot, k + 1, here, behind), z = off_between(knot, k, here);
    const loft_coord most = x > y ? x : y;
    return p->tube - knot[k].on.skip - (most > z ? most : z);
}

static void set_room(const loft_period *p, loft_knot knot[], unsigned from, unsigned to)
{
    for (unsigned k = from; k < to; k++)
        knot[k].room = p->tol - p->tol / 7;
    for (unsigned k = from - 2; k < to; k++) {
        const loft_coord left = left_between(p, knot, k);
        for (unsigned i = k - 1; i <= k + 2; i++)
            if (i >= from && i < to && knot[i].room > left)
                knot[i].room = left > 0 ? left : 0;
    }
}

static void relax(loft_knot knot[], unsigned k)
{
    loft_coord e[LOFT_AXES], c[LOFT_AXES];
    uint64_t square = 0;
    const loft_coord r = knot[k].room;

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_coord q = knot[k].point.axis[i];
        const int64_t sum = 15 * off(knot, k, 1, i, q) - 6 * off(knot, k, 2, i, q) +
                            off(knot, k, 3, i, q);
        c[i] = centre(knot, k, i);
        e[i] = loft_coord_sub(q, c[i]) + (loft_coord)((sum * RELAX + 32768) >> 16);
        square += (uint64_t)((int64_t)e[i] * e[i]);
    }
    if (square > (uint64_t)((int64_t)r * r)) {
        const int64_t size = (int64_t)loft_coord_sqrt(square) + 1;
        for (int i = 0; i < LOFT_AXES; i++)
            e[i] = (loft_coord)((int64_t)e[i] * r / size);
    }
    for (int i = 0; i < LOFT_AXES; i++)
        knot[k].point.axis[i] = loft_coord_add(c[i], e[i]);
}

void loft_tube_smooth(const loft_period *period, loft_knot knot[], unsigned from, unsigned to,
                      int sweeps)
{
    set_room(period, knot, from, to);
    for (int n = 0; n < sweeps; n++)
        for (unsigned k = from; k < to; k++)
            relax(knot, n % 2 ? from + to - 1 - k : k);
}
