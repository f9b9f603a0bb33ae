/* tests/support/meetings.h -- how far a place is from where two surfaces meet
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_MEETINGS_H
#define LOFT_TESTS_MEETINGS_H

#include "support/exact.h"      /* exact_of */
#include "surface/net_meet.h"   /* loft_net_meeting */

/* From all branches, and from all touches, which are branches of one point. */
static inline long double distance_from_meetings(const loft_net_meeting out[], unsigned count,
                                                 const long double p[3])
{
    long double best = INFINITY;

    for (unsigned k = 0; k < count; k++) {
        const loft_vec *from = &out[out[k].start ? k : k - 1].point, *to = &out[k].point;
        long double along = 0, length = 0, sum = 0;
        for (int axis = 0; axis < 3; axis++) {
            const long double d = exact_of(to->axis[axis]) - exact_of(from->axis[axis]);
            along += d * (p[axis] - exact_of(from->axis[axis]));
            length += d * d;
        }
        const long double t = length > 0 ? fmaxl(0, fminl(1, along / length)) : 0;
        for (int axis = 0; axis < 3; axis++) {
            const long double a = exact_of(from->axis[axis]), b = exact_of(to->axis[axis]);
            sum += powl(p[axis] - a - t * (b - a), 2);
        }
        best = fminl(best, sqrtl(sum));
    }
    return best;
}

#endif
