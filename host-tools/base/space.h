/* host-tools/base/space.h -- points and cubics of three coordinates
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_SPACE_H
#define LOFT_SPACE_H

#include <math.h>

static inline double space_distance(const double a[3], const double b[3])
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

/* From p to the segment a..b. */
static inline double space_segment_distance(const double p[3], const double a[3], const double b[3])
{
    double along = 0, square = 0, at[3];

    for (int i = 0; i < 3; i++) {
        along  += (p[i] - a[i]) * (b[i] - a[i]);
        square += (b[i] - a[i]) * (b[i] - a[i]);
    }
    const double z = square > 0 ? fmin(fmax(along / square, 0), 1) : 0;
    for (int i = 0; i < 3; i++)
        at[i] = a[i] + z * (b[i] - a[i]);
    return space_distance(p, at);
}

/* The point at t of the cubic with these control points. */
static inline void space_eval(const double p[4][3], double t, double out[3])
{
    const double s = 1 - t;

    for (int i = 0; i < 3; i++)
        out[i] = s * s * s * p[0][i] + 3 * s * s * t * p[1][i] + 3 * s * t * t * p[2][i] +
                 t * t * t * p[3][i];
}

#endif
