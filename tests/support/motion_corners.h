/* tests/support/motion_corners.h -- where a path has corners, and what they are allowed
 * SPDX-License-Identifier: MIT
 *
 * A corner is where the direction changes by more than 5 degrees at a joint or a cusp. So each
 * curve is halved until the directions of its hodograph are close together, or it is not longer
 * than 2^-16 mm.
 */
#ifndef LOFT_TESTS_MOTION_CORNERS_H
#define LOFT_TESTS_MOTION_CORNERS_H

#include "support/motion_oracle.h"  /* path, distance, cubic_at */
#include "support/motion_chains.h"  /* limits */

#define CORNERS_MAX 4000
#define CORNER_NEAR 32          /* limits.corner */
#define CORNER_TURN 0.0865      /* a little less than 5 degrees */

static struct {
    double at[CORNERS_MAX][LOFT_AXES], last[LOFT_AXES];
    double part[CORNERS_MAX];   /* its curve, and the parameter there */
    double s[CORNERS_MAX];      /* along the path */
    unsigned count;
    bool turns;                 /* is there a direction before? */
} corners;

/* The part from .. to of a cubic, by blossoms. */
static inline void cubic_part(const double p[4][LOFT_AXES], double from, double to,
                              double out[4][LOFT_AXES])
{
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < LOFT_AXES; i++) {
            double q[4] = { p[0][i], p[1][i], p[2][i], p[3][i] };
            for (int n = 3; n > 0; n--) {
                const double t = n <= k ? to : from;
                for (int j = 0; j < n; j++)
                    q[j] += t * (q[j + 1] - q[j]);
            }
            out[k][i] = q[0];
        }
}

static inline double cubic_leg(const double p[4][LOFT_AXES], int k, double out[LOFT_AXES])
{
    const double size = distance(p[k], p[k + 1]);
    for (int i = 0; i < LOFT_AXES; i++)
        out[i] = size > 0 ? (p[k + 1][i] - p[k][i]) / size : 0;
    return size;
}

/* The path goes on in direction u from a place. */
static inline void corner_turn(double part, const double at[LOFT_AXES], const double u[LOFT_AXES])
{
    if (!corners.turns || !(distance(u, corners.last) > CORNER_TURN) ||
        corners.count == CORNERS_MAX)
        return;
    corners.part[corners.count] = part;
    memcpy(corners.at[corners.count++], at, sizeof corners.at[0]);
}

static inline void corners_of_part(unsigned c, const double p[4][LOFT_AXES], double from, double to)
{
    double q[4][LOFT_AXES], u[3][LOFT_AXES], size = 0;

    cubic_part(p, from, to, q);
    for (int k = 0; k < 3; k++)
        size += cubic_leg((const double(*)[LOFT_AXES])q, k, u[k]);
    if (!(size > 0x1p-16))
        return;
    if (distance(u[0], u[1]) > 0.04 || distance(u[1], u[2]) > 0.04) {
        corners_of_part(c, p, from, (from + to) / 2);
        corners_of_part(c, p, (from + to) / 2, to);
        return;
    }
    corner_turn(c + from, q[0], u[0]);
    memcpy(corners.last, u[2], sizeof u[2]);
    corners.turns = true;
}

static inline void corners_find(const loft_move moves[], unsigned count)
{
    corners.count = 0;
    corners.turns = false;
    for (unsigned c = 0; c < count; c++) {
        double p[4][LOFT_AXES];
        for (int k = 0; k < 4; k++)
            for (int i = 0; i < LOFT_AXES; i++)
                p[k][i] = arb_value(moves[c].curve.p[k].axis[i]);
        corners_of_part(c, (const double(*)[LOFT_AXES])p, 0, 1);
    }
    CHECK(corners.count < CORNERS_MAX);
}

static inline double corner_distance(const double at[LOFT_AXES])
{
    double least = HUGE_VAL;
    for (unsigned k = 0; k < corners.count; k++)
        least = fmin(least, distance(at, corners.at[k]));
    return least;
}

static inline bool corners_matter(void) { return limits.corner > limits.tol; }

/* Chords within `error`, which near corners are short. */
static inline bool chord_is_near_by_corners(const loft_vec c[4], double t, double dt, double error)
{
    double a[LOFT_AXES], b[LOFT_AXES];

    if (!chord_is_near(c, t, dt, error))
        return false;
    cubic_at(c, t, a);
    cubic_at(c, t + dt, b);
    const double size = distance(a, b), corner = arb_value(limits.corner);
    return size <= corner || corner_distance(a) > CORNER_NEAR * corner + 2 * size;
}

/* Where the corners are along the path, in chords. */
static inline void corners_measure(const path *p)
{
    for (unsigned n = 0, k = 0; n < corners.count; n++) {
        while (k + 1 < p->count && p->end[k].curve + p->end[k].t < corners.part[n])
            k++;
        corners.s[n] = p->end[k].s;
    }
}

/* How far it is from s to the nearest corner along the path. */
static inline double corner_way(double s)
{
    double least = HUGE_VAL;
    for (unsigned n = 0; n < corners.count; n++)
        least = fmin(least, fabs(s - corners.s[n]));
    return least;
}

/* The tolerance of a chord of the path, as a multiple of limits.tol. */
static inline double corner_share(const path *p, unsigned k)
{
    const double corner = arb_value(limits.corner), reach = CORNER_NEAR * corner;
    return corners_matter() && fmax(corner_way(p->end[k].s), corner_way(p->end[k + 1].s)) <= reach
               ? corner / arb_value(limits.tol)
               : 1;
}

#endif
