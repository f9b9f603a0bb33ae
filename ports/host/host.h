/* ports/host/host.h -- the machine as a program: a pseudo terminal in front, every pulse recorded
 * behind
 * SPDX-License-Identifier: MIT
 *
 * The code between the two is lib/machine, the same as in firmware. The files of this folder are
 * compiled once per number type; one program may hold all three:
 *
 *     struct loft_host_options o = loft_host_defaults();
 *     o.record = "pulses.csv";
 *     return loft_host_simulate_q16x3(&o);
 */
#ifndef LOFT_HOST_H
#define LOFT_HOST_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#include "config.h"     /* LOFT_AXES, LOFT_NAME */

struct loft_board;

struct loft_host_options {
    struct loft_board *board;   /* the pulses go to its lines, in real time; NULL: to the record
                                 * alone */
    const char *port;           /* a serial port in place of a pseudo terminal, or NULL */
    unsigned baud;              /* of the serial port */
    const char *link;           /* make this symbolic link to the pseudo terminal, in place of that
                                 * of a machine that is gone; NULL: none */
    const char *record;         /* write every pulse to this file, "-" is standard output; NULL:
                                 * none */
    bool     fast;              /* simulated time: as fast as possible, and time stands while the
                                 * line is slow */
    bool     once;              /* end after one job, with its report on standard output */
    bool     quiet;             /* print only the name of the pseudo terminal and errors */
    /* mm/s, mm/s^2 */
    double   steps_per_mm[LOFT_AXES], max_speed[LOFT_AXES], max_accel[LOFT_AXES];
    double   max_jerk[LOFT_AXES];   /* mm/s^3; 0: not limited */
    unsigned tick_hz;           /* ticks per second, 1..65535 */
    unsigned slots;             /* chances to step per tick, 1..4096 */
    unsigned ramp;              /* ticks from full pace to standing in a hold */
    unsigned queue;             /* items, 1..32768 */
    unsigned curves;            /* that its plan can hold, 4..4096; 0: it does not plan */
    double   limit[LOFT_AXES][2];   /* of a machine without a board: mm at which the limit switches
                                     * of the motors close, low and high */
    const char *note;           /* lines to be added to the head of the record, or NULL */
    double   noise;             /* of a million bits, how many are flipped on the line, each way */
};

/* What `loft simulate` does without options: fast, 80 steps/mm, 1000 Hz, 40 slots, ramp 100, queue
 * 256, plan 64. */
static inline struct loft_host_options loft_host_defaults(void)
{
    struct loft_host_options o = { 0 };
    o.fast = true;
    o.baud = 115200;
    for (int i = 0; i < LOFT_AXES; i++) {
        o.steps_per_mm[i] = 80;
        o.max_speed[i] = 500;
        o.max_accel[i] = 2000;
        o.limit[i][0] = -HUGE_VAL;
        o.limit[i][1] = HUGE_VAL;
    }
    o.tick_hz = 1000;
    o.slots = 40;
    o.ramp = 100;
    o.queue = 256;
    o.curves = 64;
    return o;
}

/* Make a pseudo terminal, or open the port, print its name on standard output as `machine: NAME`,
 * and be the machine behind it until SIGINT, SIGTERM or, with `once`, the end of a job. A signal
 * stops the machine on the path first; the record is then complete.
 *
 *   shape   gives 0 or an exit code of <sysexits.h> after one line on standard error
 *   record  CSV: lines `# key = value`, a line of column names, then `# job = 7c3e11d0` where a job
 *           begins, and per slot with pulses `slot,x,y,z`: the number of the slot since the start
 *           of the machine and the positions after it in steps */
typedef int loft_host_simulator(const struct loft_host_options *o);

#define loft_host_simulate LOFT_NAME(loft_host_simulate)
loft_host_simulator loft_host_simulate;             /* of the number type that this file is compiled
                                                     * with */
#if LOFT_AXES == 3
loft_host_simulator loft_host_simulate_q16x3, loft_host_simulate_f32x3, loft_host_simulate_f64x3;
#endif

#endif
