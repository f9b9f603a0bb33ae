/* lib/motion/beat.h -- beat: how an averaged law goes on for a beat: faster, as fast, slower, or to
 * the end
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_MOTION_BEAT_H
#define LOFT_MOTION_BEAT_H

#include "motion/law.h"     /* loft_law */

LOFT_BEGIN_C

#if LOFT_PLAN_FILTER > 1

/* Is what the next beat looks at sure? If not, look back once more. */
bool loft_beat_knows(loft_law *law);

/* Go on for one beat; gives the way. The law rests when that leads to a place of rest.
 *
 *   range   it moves, and knows
 */
loft_unit loft_beat_next(loft_law *law);

/* Can everything up to `way` further on be braked for from speed v? */
bool loft_beat_clear(const loft_law *law, loft_acc way, loft_real v);

#endif

LOFT_END_C

#endif
