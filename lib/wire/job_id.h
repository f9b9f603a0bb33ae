/* lib/wire/job_id.h -- where the items of a job come from, and the number by which the same job is
 * known again
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_WIRE_JOB_ID_H
#define LOFT_WIRE_JOB_ID_H

#include "wire/message.h"   /* loft_job, loft_item */

LOFT_BEGIN_C

/* Of a job whose items are still being made: how many they will be is not known yet. */
#define LOFT_ITEMS_OPEN 0xFFFFFFFFu

/* Fill *out with item `index` of the job, 0 .. count - 1. Asked for any item from the last
 * acknowledged one on, and the three before, again and again: it must answer the same each time. */
typedef void loft_item_source(void *context, uint32_t index, loft_item *out);

/* The id of a job: a CRC-32C of its kind, start, limits, count and all items; never 0. The same job
 * has the same id. For a job whose items are still being made: of the first `count` of them, to be
 * combined with all that decides the others. */
uint32_t loft_job_id(const loft_job *job, uint32_t count, loft_item_source *source, void *context);

LOFT_END_C

#endif
