/* host-tools/cmd/view.h -- a job on the whole terminal: its drawing, its numbers, its keys
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_VIEW_H
#define LOFT_VIEW_H

#include "cmd/report.h"        /* report_job, send_facts */

/* Show it all. `left` in seconds, HUGE_VAL if it is not known; `line` is the last event. */
void view_show(const report_job *job, const send_facts *f, double left, const char *line);

/* Give the terminal back, and forget the job. */
void view_end(void);

#endif
