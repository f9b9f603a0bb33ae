/* host-tools/plan/job_curve.h -- what a machine that plans is sent: curves, and their limits
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_JOB_CURVE_H
#define LOFT_JOB_CURVE_H

#include "wire/codec.h"     /* loft_item */
#include "wire/message.h"   /* loft_job_limits */

#include "engine/engine.h"  /* engine_move, engine_limits */

/* A move that begins at `from`, raw, as an item, with its feed in mm/min. */
loft_item job_curve(const engine_move *m, const int32_t from[ENGINE_AXES]);

loft_job_limits job_curve_limits(const engine_limits *l);

#endif
