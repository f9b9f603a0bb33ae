/* ports/linux-gpio/powers.h -- what is driven beside the motors: a PWM of the kernel, and lines
 * SPDX-License-Identifier: MIT
 *
 *     output 1   the PWM channel of `pwm`, and the line `spindle` while it is above 0; or `relay`
 *     output 2   the line `coolant`
 *
 * A line is on or off. A thread cannot switch it so often that a laser has half its power, so that
 * needs a PWM of the chip.
 */
#ifndef LOFT_POWERS_H
#define LOFT_POWERS_H

#include "linux-gpio/machine_lines.h"

struct powers {
    int duty;                   /* the file of the duty cycle; -1: there is no PWM */
    int64_t period_ns;
    bool relay;                 /* output 1 is a line alone */
};

/* Open the PWM and switch it on with a duty of 0; without one in `s` do nothing. Returns 0 or an
 * exit code after one line on standard error. */
int  powers_open(struct powers *p, const struct settings *s);

/* The outputs that can be driven: 0, 1 or 2. */
int  powers_count(const struct settings *s);

/* True if output 1 can have this level, or follow the speed. */
bool powers_can(const struct powers *p, int output, bool moving);

/* Set an output, from 1, to a level, 65535 at most. Returns false if something did not obey. */
bool powers_set(struct powers *p, struct lines *lines, int output, uint16_t level);

/* Switch the PWM off, and close it. */
void powers_close(struct powers *p);

#endif
