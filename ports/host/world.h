/* ports/host/world.h -- the table of the simulated machine: walls, switches that bounce, a probe
 * SPDX-License-Identifier: MIT
 *
 * The firmware counts its pulses; this counts what the motors do. A step that runs into a wall is
 * lost: then the two differ, as on a real machine.
 */
#ifndef LOFT_HOST_WORLD_H
#define LOFT_HOST_WORLD_H

#include "host/host.h"      /* struct loft_host_options */
#include "machine/step.h"   /* loft_pins                */

#define host_world_init     LOFT_NAME(host_world_init)
#define host_world_slot     LOFT_NAME(host_world_slot)
#define host_world_settle   LOFT_NAME(host_world_settle)
#define host_world_skew     LOFT_NAME(host_world_skew)
#define host_world_limited  LOFT_NAME(host_world_limited)

/* A contact: a switch at an end of an axis, or the probe. */
struct host_contact {
    bool touched, closed;
    uint64_t settled;                   /* the slot from which on it no longer bounces */
};

#define HOST_WORLD_PROBE (2 * LOFT_AXES)

struct host_world {
    const struct loft_host_options *o;
    int64_t motor[LOFT_AXES];           /* steps that the motors have really done */
    double at[LOFT_AXES];               /* the tool, mm; of a gantry its first motor */
    int64_t ahead;                      /* steps: of its second motor */
    uint64_t lost;                      /* steps                    */
    struct host_contact contact[2 * LOFT_AXES + 1];
    uint16_t inputs;                    /* closed in this slot, as they bounce: LOFT_INPUT_ */
    uint64_t bounces;                   /* the slot until which some contact does */
    uint32_t random;
};

/* The machine is switched on with its motors at 0. */
void host_world_init(struct host_world *w, const struct loft_host_options *o);

/* Take the pins of slot number `slot`, which follows the last one. `gated`: motors of a gantry that
 * stand, as loft_machine_gated. */
void host_world_slot(struct host_world *w, uint64_t slot, loft_pins pins, uint16_t gated);

/* How far the second motor of a gantry is ahead, mm. */
double host_world_skew(const struct host_world *w);

/* Time passes without slots: no contact bounces any longer. */
void host_world_settle(struct host_world *w);

/* True if there is a wall, a switch or a probe. */
bool host_world_limited(const struct host_world *w);

#endif
