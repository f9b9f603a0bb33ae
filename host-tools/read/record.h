/* host-tools/read/record.h -- what the machine really did: every pulse, and its distance from the
 * drawing
 * SPDX-License-Identifier: MIT
 *
 * The simulated machine writes lines `# key = value` and, for each slot with pulses, `slot,x,y,z`:
 * the positions after it in steps. Steps are those of the motors; lines such as `# kinematics =
 * corexy` give the map to the tool, and all places here are the tool's. The pen is down while z is
 * at most half of the largest z; in a record that never moves z the pen is always down. A line `#
 * job = 7c3e11d0` begins a job; earlier lines are ignored. A last line without a newline is still
 * being written and is skipped.
 */
#ifndef LOFT_RECORD_H
#define LOFT_RECORD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/drawing.h"
#include "read/machine_file.h"   /* machine_file, for its kinematics */

struct host;                /* base/host.h */

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
    bool other;                 /* the current job is not the wanted one */
    double now[3];              /* of the motors, in any job */
    double pen_down;            /* largest z in mm at which the pen draws */
} record;

/* Read `file`, "-" is standard input. If it holds several jobs, read the last run of `job`, or, for
 * 0, the last job. Returns 0, or a code of <sysexits.h> after printing one line. `*r` must be
 * zeroed; free with record_free. */
int  record_read(struct host *h, record *r, const char *file, uint32_t job);
void record_free(record *r);

/* True if pulse i moved the pen over the paper. */
bool record_draws(const record *r, size_t i);

/* The time from the first to the last pulse in seconds; 0 if the record has no slot rate. */
double record_seconds(const record *r);

/* The largest distance from the true curves of all positions with the pen down; 0 if there are
 * none.
 *
 *   shape   point: room for r->count points, the nearest of the drawing to each pulse that draws,
 *           or NULL where: the worst pulse, or NULL
 *   units   mm
 *   error   1e-4 mm, for the search is among chords; less where the nearest curve is the only one
 *           near
 *   cost    about 1 us per pulse */
double record_worst_error(const drawing *d, const record *r, double (*point)[2], size_t *where);

/* The reverse: the largest distance of a point of the drawing from the machine's path. It shows
 * what the machine left out. `where`: that point, or NULL. */
double record_worst_gap(const drawing *d, const record *r, double where[2]);

#endif
