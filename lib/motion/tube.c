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
    return loft_coord_from(a, b) + loft_coord_from(c, b);
}

static loft_coord centre(const loft_knot knot[], unsigned k, int i)
{
    const loft_coord at = knot[k].on.at.axis[i];
    return loft_coord_plus(
        at, -sixth(second(knot[k - 1].on.at.axis[i], at, knot[k + 1].on.at.axis[i])));
}

void loft_tube_load(loft_knot knot[], unsigned from, unsigned to)
{
    for (unsigned k = from; k < to; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            knot[k].point.axis[i] = centre(knot, k, i);
}

static int64_t off(const loft_knot knot[], unsigned k, int d, int i, loft_coord q)
{
    return (int64_t)loft_coord_from(knot[k - (unsigned)d].point.axis[i], q) +
           loft_coord_from(knot[k + (unsigned)d].point.axis[i], q);
}

static loft_coord radius(const loft_period *p, const loft_knot knot[], unsigned k)
{
    const loft_coord skip = knot[k].on.skip > knot[k - 1].on.skip ? knot[k].on.skip
                                                                  : knot[k - 1].on.skip;
    const loft_coord most = p->tol - p->tol / 7, least = p->tol / 5;
    return most - skip > least ? most - skip : least;
}

static void relax(const loft_period *p, loft_knot knot[], unsigned k)
{
    loft_coord e[LOFT_AXES], c[LOFT_AXES];
    uint64_t square = 0;
    const loft_coord r = radius(p, knot, k);

    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_coord q = knot[k].point.axis[i];
        const int64_t sum = 15 * off(knot, k, 1, i, q) - 6 * off(knot, k, 2, i, q) +
                            off(knot, k, 3, i, q);
        c[i] = centre(knot, k, i);
        e[i] = loft_coord_from(q, c[i]) + (loft_coord)((sum * RELAX + 32768) >> 16);
        square += (uint64_t)((int64_t)e[i] * e[i]);
    }
    if (square > (uint64_t)((int64_t)r * r)) {
        const int64_t size = (int64_t)loft_coord_sqrt(square) + 1;
        for (int i = 0; i < LOFT_AXES; i++)
            e[i] = (loft_coord)((int64_t)e[i] * r / size);
    }
    for (int i = 0; i < LOFT_AXES; i++)
        knot[k].point.axis[i] = loft_coord_plus(c[i], e[i]);
}

void loft_tube_smooth(const loft_period *period, loft_knot knot[], unsigned from, unsigned to,
                      int sweeps)
{
    for (int n = 0; n < sweeps; n++)
        for (unsigned k = from; k < to; k++)
            relax(period, knot, n % 2 ? from + to - 1 - k : k);
}
