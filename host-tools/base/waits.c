/* host-tools/base/waits.c
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/say.h"
#include "base/tool.h"           /* tool_clock */
#include "base/waits.h"

bool waits_due(waits *w, const char *what)
{
    const double now = tool_clock();

    if (what == NULL) {
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

void waits_for(waits *w, const char *what)
{
    if (waits_due(w, what)) {
        fputs(isatty(STDERR_FILENO) ? "\r\033[K" : "", stderr);
        (void)say(stderr, "waiting: %s\n", w->what);
    }
}
