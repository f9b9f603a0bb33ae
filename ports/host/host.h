/* ports/host/host.h -- the machine as a program: a pseudo terminal at one end, recorded pulses at
 * the other SPDX-License-Identifier: MIT
 *
 * The code between them is lib/machine, as in firmware. The files of this folder are compiled once
 * per number type; one program may contain all three:
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

/* What is at an end of an axis: mm from where the machine was switched on; infinite: nothing. */
struct loft_host_end {
    double at;
    bool   opens;               /* a switch that is wired the other way: it opens there */
};

#define LOFT_HOST_HALTS 32

struct loft_host_options {
    struct loft_board *board;   /* gives the pulses in real time; NULL: they are only recorded */
    const char *port;           /* a serial port in place of a pseudo terminal, or NULL */
    unsigned baud;              /* of the serial port */
    const char *link;           /* make this symbolic link to the pseudo terminal; it may replace
                                 * the link of a machine that is gone; NULL: none */
    const char *kept;           /* the file that keeps the settings; NULL: only while it runs */
    const char *record;         /* write every pulse to this file, "-" is standard output; NULL:
                                 * none */
    bool     fast;              /* simulated time: as fast as possible, and time stops while the
                                 * line is slow */
    unsigned line_baud;         /* simulated time: no more bytes than this line brings; 0: any */
    double   halt[LOFT_HOST_HALTS]; /* simulated time stops at these ticks of jobs, one after the
                                     * other, each until SIGUSR2, if a sender has the line; one
                                     * that is not above the one before is of a later job */
    unsigned halts;             /* their number */
    bool     once;              /* end after one job, with its report on standard output */
    bool     quiet;             /* print only the name of the pseudo terminal and errors */
    /* mm/s, mm/s^2 */
    double   steps_per_mm[LOFT_AXES], max_speed[LOFT_AXES], max_accel[LOFT_AXES];
    double   max_jerk[LOFT_AXES];   /* mm/s^3; 0: no limit */
    unsigned tick_hz;           /* ticks per second, 1..65535 */
    unsigned slots;             /* chances to step per tick, 1..4096 */
    unsigned ramp;              /* ticks from full pace to a stop in a hold */
    unsigned queue;             /* items, 1..32768 */
    unsigned curves;            /* curves that its plan can hold, 4..4096; 0: it does not plan */
    unsigned columns;           /* curves of a line of a patch, 1..1024; 0: it takes no patches */
    /* without a board: the limit switches at the low and the high end of each axis, the walls, and
     * what a probe touches */
    struct loft_host_end limit[LOFT_AXES][2], wall[LOFT_AXES][2], probe[LOFT_AXES][2];
    int      gantry;            /* an axis with two motors, each with its own switch at both ends of
                                 * the axis; -1: none */
    double   skew;              /* of it: the second motor is so far ahead, mm */
    bool     shared;            /* one input for both switches of an axis */
    double   bounce_ms;         /* how long their contacts bounce */
    void   (*tool)(const void *kinematics, const double motors[LOFT_AXES],
                 double out[LOFT_AXES]);  /* mm; NULL: axes are motors */
    const void *kinematics;
    const char *note;           /* lines to add to the head of the record, or NULL */
    double   noise;             /* flipped bits on the line per million, each way */
};

/* The defaults of `loft simulate`: fast, 80 steps/mm, 1000 Hz, 40 slots, ramp 100, queue 256, plan
 * 64. */
static inline struct loft_host_options loft_host_defaults(void)
{
    struct loft_host_options o = { 0 };
    o.fast = true;
    o.gantry = -1;
    o.baud = 115200;
    for (int i = 0; i < LOFT_AXES; i++) {
        o.steps_per_mm[i] = 80;
        o.max_speed[i] = 500;
        o.max_accel[i] = 2000;
        o.limit[i][0].at = o.wall[i][0].at = o.probe[i][0].at = -HUGE_VAL;
        o.limit[i][1].at = o.wall[i][1].at = o.probe[i][1].at = HUGE_VAL;
    }
    o.tick_hz = 1000;
    o.slots = 40;
    o.ramp = 100;
    o.queue = 256;
    o.curves = 64;
    o.columns = 64;
    return o;
}

/* Make a pseudo terminal, or open the port. Print its name on standard output as `machine: NAME`,
 * and be the machine behind it until SIGINT, SIGTERM or, with `once`, the end of a job. A signal
 * first stops the machine on the path; the record is then complete.
 *
 * SIGUSR1 presses its emergency stop, and frees it. SIGUSR2 ends a halt. A halted machine still
 * talks: a hold or an abort shows at once, by one tick.
 *
 *   shape   returns 0 or an exit code of <sysexits.h> after one line on standard error
 *   record  CSV: lines `# key = value`, a line of column names, then `# job = 7c3e11d0` where a job
 *           begins, and per slot with pulses `slot,x,y,z`: the number of the slot since the start
 *           of the machine and the positions after it in steps */
typedef int loft_host_simulator(const struct loft_host_options *o);

#define loft_host_simulate LOFT_NAME(loft_host_simulate)
loft_host_simulator loft_host_simulate;             /* in the number type of this compilation */
#if LOFT_AXES == 3
loft_host_simulator loft_host_simulate_q16x3, loft_host_simulate_f32x3, loft_host_simulate_f64x3;
#endif

#endif
