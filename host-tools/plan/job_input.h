/* host-tools/plan/job_input.h -- all data that the items of a job depend on
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_JOB_INPUT_H
#define LOFT_JOB_INPUT_H

#include "plan/job.h"       /* job_options, joints */

/* Continue a CRC with the path of the motors, its events, the limits, the number type and the
 * version of this program. */
uint32_t job_input_crc(uint32_t crc, const joints *of, const job_options *o);

#endif
