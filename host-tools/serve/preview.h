/* host-tools/serve/preview.h -- plans a drawing in a process beside this one
 * SPDX-License-Identifier: MIT
 *
 * It writes lines of JSON, each an object with a `kind`: "message", "progress", "plan" (what it
 * takes) and "moves" (SERVE.md has them). Nobody waits for it.
 */
#ifndef LOFT_PREVIEW_H
#define LOFT_PREVIEW_H

#include <sys/types.h>          /* pid_t */

#include "send/desk.h"

/* Run `work` in another process, which ends then, with a file that can be read here at *fd. Returns
 * the process, or -1 with errno. The program gives it. */
typedef pid_t serve_beside(void (*work)(void *given, FILE *out), void *given, int *fd);

typedef struct {
    pid_t child;                /* 0: none runs */
    int fd;
    char *text;                 /* what it has written, from `at` on */
    size_t at, size, room;
} preview;

/* Plan a drawing by these options, as this machine would be sent it; one that runs is left. Returns
 * false, with errno, if no process can begin. */
bool preview_begin(preview *v, serve_beside *beside, const desk *d, const planning *how,
                   const char *file);

/* Take what has come: the next line, without its end, which is valid until the next call. NULL:
 * none yet; child is 0 then if there will be no other one. */
const char *preview_line(preview *v);

void preview_end(preview *v);

#endif
