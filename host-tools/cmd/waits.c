/* host-tools/cmd/waits.c
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/say.h"
#include "cmd/waits.h"

bool waits_due(waits *w, const char *what, double now)
{
    if (*what == '\0') {
        w->what[0] = '\0';
        return false;
    }
    if (strncmp(w->what, what, sizeof w->what - 1) != 0) {
        snprintf(w->what, sizeof w->what, "%s", what);
        w->since = now;
        w->told  = false;
    }
    if (w->told || now - w->since < WAITS_AFTER)
        return false;
    w->told = true;
    return true;
}

void waits_for(waits *w, const char *what, double now)
{
    if (waits_due(w, what, now)) {
        fputs(isatty(STDERR_FILENO) ? "\r\033[K" : "", stderr);
        (void)say(stderr, "waiting: %s\n", w->what);
    }
}
