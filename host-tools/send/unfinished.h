/* host-tools/send/unfinished.h -- remembers that a job began on a machine and has not ended: if the
 * machine restarts meanwhile, it does not know where it stands
 * SPDX-License-Identifier: MIT
 *
 * One small file for each port, in host.state: the boot id of the machine and the axes whose
 * place is in doubt if it comes back with another one. It is written
 * when the machine has taken a job, and removed when that has ended, with a report of its place.
 * Another computer does not know it.
 */
#ifndef LOFT_UNFINISHED_H
#define LOFT_UNFINISHED_H

#include <stdbool.h>
#include <stdint.h>

#include "base/host.h"

/* A machine, as it was greeted. */
typedef struct {
    const char *port;
    uint32_t boot;
    bool busy;                  /* it has a job now */
    host *host;                 /* hears of it; its `state` has the notes */
} unfinished_machine;

/* Refuse to go on where the machine was restarted in a job and was not placed since. Forgets a job
 * that has ended meanwhile. Returns 0, or an exit code after one message. */
int unfinished_check(const unfinished_machine *m);

/* The machine has taken job `id`, or goes on with it; `file` is told by unfinished_check. */
void unfinished_begin(const unfinished_machine *m, uint32_t id, const char *file);

/* It has ended, and its place is known. */
void unfinished_end(const host *h, const char *port);

/* The place of these axes was told or found: bit i for axis i. */
void unfinished_placed(const unfinished_machine *m, unsigned axes);

#endif
