/* host-tools/read/record.h -- what the machine really did: every pulse, and how far from the
 * drawing
 * SPDX-License-Identifier: MIT
 *
 * The simulated machine writes lines `# key = value` and, for each slot with pulses, `slot,x,y,z`:
 * the positions after it in steps. Steps are of the motors: lines `# kinematics = corexy` and what
 * belongs to it say how they carry the tool, and all places here are the tool's. The pen is down
 * while z is at most half of the greatest z; a record that never moves z is all pen down. A line `#
 * job = 7c3e11d0` stands where a job begins; what was before it is not looked at. A last line
 * without its end is still being written and is passed over.
 */
#ifndef LOFT_RECORD_H
#define LOFT_RECORD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/drawing.h"
#include "read/machine_file.h"   /* machine_file, for its kinematics */

typedef struct {
    uint64_t slot;
    double at[3];               /* mm */
} record_pulse;

typedef struct {
    record_pulse *pulse;
    size_t count, room;
    double steps_per_mm[3], slot_hz;
    machine_file machine;       /* its kinematics       */
    double motors[3];           /* after the last pulse */
    double start[3];            /* of the tool          */
    uint32_t wanted;            /* job, 0: any          */
    bool other;                 /* another job is read  */
    double now[3];              /* of the motors, in any job */
    double pen_down;            /* z in mm up to which the pen draws */
} record;

/* Read `file`, "-" is standard input: of several jobs in it `job` as it was done last, or, for 0,
 * the last one. Gives 0, or a code of <sysexits.h> after printing one line. `*r` must be zeroed;
 * free with record_free. */
int  record_read(record *r, const char *file, uint32_t job);
void record_free(record *r);

/* Has pulse i moved the pen over the paper? */
bool record_draws(const record *r, size_t i);

/* From the first to the last pulse, in seconds; 0 if the record does not tell its slot rate. */
double record_seconds(const record *r);

/* How far the machine was from the true curves, at the worst of all positions with the pen down. 0
 * if there are none.
 *
 *   shape   point: room for r->count points, the nearest of the drawing to each pulse that draws,
 *           or NULL where: the worst pulse, or NULL
 *   units   mm
 *   error   1e-4 mm, for the search is among chords; less where the nearest curve is the only one
 *           near
 *   cost    about 1 us per pulse */
double record_worst_error(const drawing *d, const record *r, double (*point)[2], size_t *where);

/* The other way round: how far the machine stayed away from that point of the drawing that it came
 * least near to. What is left out shows here. `where`: that point, or NULL. */
double record_worst_gap(const drawing *d, const record *r, double where[2]);

#endif
