/* ports/host/record.h -- a record of every pulse
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_RECORD_H
#define LOFT_HOST_RECORD_H

#include <stdint.h>
#include <stdio.h>

#include "host/host.h"      /* struct loft_host_options */
#include "machine/step.h"   /* loft_pins                */

#define host_record_open    LOFT_NAME(host_record_open)
#define host_record_slot    LOFT_NAME(host_record_slot)
#define host_record_job     LOFT_NAME(host_record_job)
#define host_record_output  LOFT_NAME(host_record_output)
#define host_record_close   LOFT_NAME(host_record_close)

struct host_record {
    FILE *file;                         /* NULL: nothing is written               */
    int32_t position[LOFT_AXES];        /* counted here, only from the pins       */
    uint16_t level[LOFT_MACHINE_OUTPUTS];
    double  energy[LOFT_MACHINE_OUTPUTS];   /* the sum of levels over slots        */
};

/* Begin the file of `o` with its header. Returns 0 or an exit code after one line on standard
 * error. */
int host_record_open(struct host_record *r, const struct loft_host_options *o);

/* The pulses that follow belong to this job. */
void host_record_job(struct host_record *r, uint32_t id);

/* Record the pins of slot number `slot`. */
void host_record_slot(struct host_record *r, uint64_t slot, loft_pins pins);

/* Record the level of an output, from 1, in slot number `slot`, if it has changed. */
void host_record_output(struct host_record *r, uint64_t slot, int output, uint16_t level);

/* Flush and close the file. Returns 0 or an exit code after one line on standard error. */
int host_record_close(struct host_record *r, const struct loft_host_options *o);

#endif
