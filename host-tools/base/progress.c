/* host-tools/base/progress.c -- a progress bar with the remaining time
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "base/progress.h"
#include "base/say.h"
#include "base/tool.h"           /* tool_clock */

#define BAR 24

static bool drawn;          /* some bar is on the terminal */

static int columns(void)
{
    struct winsize size;

    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

void progress_start(progress *p, double total)
{
    const char *kind = getenv("TERM");

    *p = (progress){ .shown = isatty(STDERR_FILENO) && !(kind && strcmp(kind, "dumb") == 0),
                     .total = total,
                     .last = -1,
                     .left = HUGE_VAL };
}

void progress_rest(progress *p)     { p->resting = true; }

/* Use the pace since the first call, which is not the start after a resume. Rests do not count. */
static void measure(progress *p, double done, double now)
{
    if (p->last < 0) {
        p->last  = now;
        p->first = done;
    }
    if (!p->resting) {
        p->worked += now - p->last;
        p->left    = done > p->first ? (p->total - done) * p->worked / (done - p->first) : HUGE_VAL;
    }
    p->last    = now;
    p->resting = false;
}

void progress_show(progress *p, double done, const char *text)
{
    const double now = tool_clock();
    char bar[BAR + 1], line[256], eta[32] = "--:--";

    measure(p, done, now);
    if (!p->shown || now - p->drawn < 0.1)
        return;
    p->drawn = now;

    const double part = p->total > 0 ? fmin(done / p->total, 1) : 1;
    for (int i = 0; i < BAR; i++)
        bar[i] = part * BAR >= i + 1 ? '#' : '.';
    bar[BAR] = '\0';
    if (p->left < 360000)
        snprintf(eta, sizeof eta, "%d:%02d", (int)p->left / 60, (int)p->left % 60);
    const int used = snprintf(line, sizeof line, "[%s] %3.0f %%  %s left  ", bar, floor(100 * part),
                              eta);
    say_copy(line + used, sizeof line - (size_t)used, text);
    fprintf(stderr, "\r%.*s\033[K", columns() - 1, line);
    fflush(stderr);
    drawn = true;
}

void progress_clear(progress *p)
{
    if (!p->shown)
        return;
    fputs("\r\033[K", stderr);
    fflush(stderr);
    drawn = false;
}

void progress_clear_any(void)
{
    if (drawn)
        fputs("\r\033[K", stderr);
    drawn = false;
}
