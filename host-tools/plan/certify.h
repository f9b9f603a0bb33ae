/* host-tools/plan/certify.h -- judges a plan: the worst of each limit at any instant, and how far
 * motion and drawing are apart at most
 * SPDX-License-Identifier: MIT
 *
 * A plan is a chain of cubics in time with control points that are integers times 2^-16 mm. The
 * largest speed, acceleration and jerk of each are fractions of integers: nothing is sampled.
 */
#ifndef LOFT_CERTIFY_H
#define LOFT_CERTIFY_H

#include <stdio.h>

#include "plan/certify_plan.h"  /* certify_plan, certify_worst */

/* What a plan holds: these parts of the limits of speed, acceleration and jerk. */
#define CERTIFY_SPEED 1.001
#define CERTIFY_ACCEL 1.005
#define CERTIFY_JERK  1.02

typedef struct {
    certify_worst speed[ENGINE_AXES], accel[ENGINE_AXES], jerk[ENGINE_AXES]; /* of the limits */
    certify_worst off, missed;      /* mm: of the motion from the drawing, and of the drawing from
                                     * the motion */
    bool connected;                 /* each span begins where the last one ended */
} certify;

/* Judge.
 *
 *   shape   both paths are cut into parts, and each part is compared with chords of the other path
 *           near it
 *   error   parts of limits: 2^-48 of themselves above the exact value, and not below it; distances
 *           are at most tol / 100 above the exact ones, and not below them; tol / 1000 where that
 *           decides. A distance above tol may be farther above
 *   cost    about 10 us for each chord, of which the sagitta is tol / 200 */
void certify_make(certify *c, const certify_plan *plan);

/* Judge one span by the limits; it begins after so many seconds. */
void certify_span(certify *c, const engine_limits *limits, const engine_span *s, double begin);

/* Add what a part of a plan has, if that is worse. */
void certify_fold(certify *sum, const certify *part);

/* True if everything is within its bounds. */
bool certify_holds(const certify *c);

/* Print the table. `axes` are the names of the motors. Returns whether everything is within its
 * bounds. */
bool certify_print(FILE *out, const certify *c, const certify_plan *plan, const char *axes);

#endif
