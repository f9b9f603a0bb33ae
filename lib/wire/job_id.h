/* lib/wire/job_id.h -- the source of a job's items, and the id that identifies a job
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_WIRE_JOB_ID_H
#define LOFT_WIRE_JOB_ID_H

#include "wire/message.h"   /* loft_job, loft_item */

LOFT_BEGIN_C

/* The count of a job whose items are still being made. */
#define LOFT_ITEMS_OPEN 0xFFFFFFFFu

/* Fill *out with item `index` of the job, 0 .. count - 1. It may be called repeatedly for any item
 * from three before the last acknowledged one, and must give the same item each time. */
typedef void loft_item_source(void *context, uint32_t index, loft_item *out);

/* The id of a job: a CRC-32C of its kind, start, limits, count and all items; never 0. The same job
 * has the same id. If items are still being made, pass the first `count` of them, and combine the
 * result with all data that determine the others. */
uint32_t loft_job_id(const loft_job *job, uint32_t count, loft_item_source *source, void *context);

LOFT_END_C

#endif
