/* host-tools/base/progress.c -- a progress bar with the remaining time
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/time.h>
#include <unistd.h>

#include "base/progress.h"
#include "base/say.h"
#include "base/tool.h"           /* tool_clock */
#include "host/duration.h"      /* host_duration */

#define BAR 24

static volatile sig_atomic_t drawn;     /* some bar is on the terminal */

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

void progress_start_late(progress *p, double total)
{
    progress_start(p, total);
    p->drawn = tool_clock() + 0.9;
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
    char bar[BAR + 1], line[256], left[HOST_DURATION];

    measure(p, done, now);
    if (!p->shown || now - p->drawn < 0.1)
        return;
    p->drawn = now;

    const double part = p->total > 0 ? fmin(done / p->total, 1) : 1;
    for (int i = 0; i < BAR; i++)
        bar[i] = part * BAR >= i + 1 ? '#' : '.';
    bar[BAR] = '\0';
    const int used = snprintf(line, sizeof line, "[%s] %3.0f %%  %s left  ", bar, floor(100 * part),
                              host_duration(left, p->left, 0));
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


// Silence
// -------

/* A signal handler reaches globals only. */
static struct {
    char text[128];
    size_t size;
    volatile sig_atomic_t seconds, due;
} watched;

/* Only async-signal-safe calls. */
static void tell_silence(int number)
{
    const int before = errno;
    char line[192], time[HOST_DURATION];
    size_t used = 0;

    (void)number;
    watched.seconds = watched.seconds + 1;
    if (!drawn && watched.seconds >= watched.due) {
        watched.due = 10 * watched.due;
        for (; used < watched.size; used++)
            line[used] = watched.text[used];
        for (const char *rest = host_duration(time, watched.seconds, 0); *rest != '\0'; rest++)
            line[used++] = *rest;
        for (const char *rest = " by now; ^C ends it\n"; *rest != '\0'; rest++)
            line[used++] = *rest;
        if (write(STDERR_FILENO, line, used) < 0)
            watched.due = 0;
    }
    errno = before;
}

void progress_watch(const char *what)
{
    const struct itimerval each = { { what ? 1 : 0, 0 }, { what ? 1 : 0, 0 } };
    struct sigaction action     = { .sa_flags = SA_RESTART };

    if (!isatty(STDERR_FILENO))
        return;
    watched.seconds = 0;
    watched.due     = 1;
    if (what != NULL)
        watched.size = (size_t)snprintf(watched.text, sizeof watched.text,
                                        "working: %.80s: ", what);
    action.sa_handler = what != NULL ? tell_silence : SIG_IGN;
    (void)sigaction(SIGALRM, &action, NULL);
    (void)setitimer(ITIMER_REAL, &each, NULL);
}
