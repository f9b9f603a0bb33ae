/* host-tools/plan/missing.c -- what a program asks and a machine cannot do
 * SPDX-License-Identifier: MIT
 */
#include "base/source.h"         /* source_name */
#include "base/host.h"
#include "plan/missing.h"

int missing_tell(host *h, const missing_job *j, const struct job_does *does)
{
    static const char *const what[] = { [DRAWING_WAITS] = "G4: the machine does not wait there",
                                        [DRAWING_PAUSES] = "M0, M1 or M6: the machine does not "
                                                           "stop there",
                                        [DRAWING_SPINS] = "M3, M4 or M5: the machine has no output "
                                                          "for a spindle",
                                        [DRAWING_COOLS] = "M7, M8 or M9: the machine has no output "
                                                          "for a coolant" };
    const unsigned warned = h->warnings;
    unsigned count[4] = { 0 };

    for (size_t k = 0; k < j->count; k++)
        for (size_t i = 0; i < j->part[k].d.events; i++)
            count[j->part[k].d.event[i].doing] += !job_can(does, &j->part[k].d.event[i]);
    for (size_t k = 0; k < j->count; k++)
        for (size_t i = 0; i < j->part[k].d.events; i++) {
            const drawing_event *e = &j->part[k].d.event[i];
            if (count[e->doing] == 0 || job_can(does, e))
                continue;
            host_warn(h, "plan.left-out", (host_place){ source_name(j->file), e->line }, NULL,
                      "%s (%u times)%s", what[e->doing], count[e->doing],
                      j->chip     ? ": --plan host lets it"
                      : j->points ? ": not with --points"
                                  : "");
            count[e->doing] = 0;
        }
    return host_code(h, warned, 0);
}

int missing_laser(host *h, const missing_job *j, const struct job_does *does)
{
    const drawing *d = &j->part[0].d;

    for (size_t i = 0; i < d->events; i++)
        if (d->event[i].doing == DRAWING_SPINS && !job_can(does, &d->event[i]))
            return host_error(h, EX_CONFIG, "plan.no-laser",
                              (host_place){ source_name(j->file), d->event[i].line },
                              "leave out `laser = yes` to draw without it",
                              "the machine has no output for the laser%s",
                              j->points ? " with --points"
                              : j->chip ? " with --plan chip"
                                        : "");
    return 0;
}
