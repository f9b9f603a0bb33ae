/* host-tools/send/greeted.h -- what a greeted machine says: its limits, and where its motors are
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_GREETED_H
#define LOFT_GREETED_H

#include "wire/sender.h"    /* loft_sender */

#include "plan/job.h"       /* job, kinematics */

/* The limits of a greeted machine. */
void stream_machine(const loft_sender *s, engine_limits *l);

/* Where a new job begins: the place of the motors, in whole multiples of 2^-16 mm, which become the
 * same steps again. Where the machine's current job began. */
void stream_new_start(const loft_sender *s, double out[ENGINE_AXES]);
void stream_old_start(const loft_sender *s, bool points, double out[ENGINE_AXES]);

/* Let the limit switches and the emergency stop that are open now stop a job at once. Returns false
 * if the machine cannot do so. */
bool stream_guard(const loft_sender *s, loft_job *head);

/* The position of the tool in mm for steps of the motors. */
void stream_place(const loft_sender *s, const kinematics *k, const int32_t steps[LOFT_AXES],
                  double out[LOFT_AXES]);

/* The commanded end of a job that is planned, rounded to steps as the machine rounds. */
void stream_commanded(const loft_sender *s, const job *j, int32_t out[LOFT_AXES]);

#endif
