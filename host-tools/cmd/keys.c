/* host-tools/cmd/keys.c -- single keys and ^C while a job runs
 * SPDX-License-Identifier: MIT
 *
 * Signal handlers can only reach globals: the five below. One set suffices: the program has one
 * terminal.
 */
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sysexits.h>
#include <termios.h>
#include <unistd.h>

#include "base/tool.h"
#include "cmd/keys.h"
#include "base/progress.h"       /* progress_watch */

static struct termios before;
static volatile sig_atomic_t raw, stops, at_once;
static const char *volatile leave;      /* what leaves a full screen, or NULL */

void keys_leave_by(const char *text) { leave = text; }

/* Also called at exit: only async-signal-safe calls. */
void keys_stop(void)
{
    const char *text = leave;

    leave = NULL;
    if (text != NULL && write(STDERR_FILENO, text, strlen(text)) < 0) {
    }
    if (raw)
        (void)tcsetattr(STDIN_FILENO, TCSANOW, &before);
    raw = 0;
}

static void stop(int number)
{
    static const char left[] =
        "\nloft: left at once: the machine finishes what it has and stops on the path\n",
                      early[] = "\nloft: stopped: nothing was sent\n";
    const char *line = at_once ? early : left;

    (void)number;
    if (++stops < 2 && !at_once)
        return;
    keys_stop();
    if (write(STDERR_FILENO, line, at_once ? sizeof early - 1 : sizeof left - 1) < 0)
        _exit(EX_IOERR);
    _exit(EX_TEMPFAIL);
}

/* The program dies of this signal: its terminal does not. */
static void fall(int number)
{
    keys_stop();
    (void)signal(number, SIG_DFL);
    (void)raise(number);
}

/* A ^C that came just before this is not lost: whoever computes now does not look for it. */
void keys_hasty(bool hasty)
{
    at_once = hasty;
    progress_watch(hasty ? "planning" : NULL);
    if (hasty && stops > 0)
        stop(SIGINT);
}

static void catch(int number, void (*handler)(int))
{
    struct sigaction action;

    memset(&action, 0, sizeof action);
    action.sa_handler = handler;
    (void)sigaction(number, &action, NULL);
}

void keys_start(bool single)
{
    catch(SIGINT, stop);
    catch(SIGTERM, stop);
    catch(SIGHUP, stop);
    catch(SIGPIPE, SIG_IGN);
    if (!single || !isatty(STDIN_FILENO) || tcgetpgrp(STDIN_FILENO) != getpgrp() ||
        tcgetattr(STDIN_FILENO, &before) != 0)
        return;
    struct termios mode = before;
    mode.c_lflag &= ~(tcflag_t)(ICANON | ECHO);     /* ISIG stays: ^C is a signal */
    mode.c_cc[VMIN]  = 1;
    mode.c_cc[VTIME] = 0;
    catch(SIGQUIT, fall);
    catch(SIGABRT, fall);
    (void)atexit(keys_stop);
    raw = tcsetattr(STDIN_FILENO, TCSANOW, &mode) == 0;
}

int keys_next(void)
{
    struct pollfd p = { .fd = STDIN_FILENO, .events = POLLIN };
    unsigned char key;

    if (!raw || poll(&p, 1, 0) <= 0 || read(STDIN_FILENO, &key, 1) != 1)
        return 0;
    return key;
}

int keys_answer(int wait)
{
    struct pollfd p = { .fd = STDIN_FILENO, .events = POLLIN };
    unsigned char key;

    if (isatty(STDIN_FILENO)) {
        const int typed = keys_next();
        (void)poll(NULL, 0, typed ? 0 : wait);
        return typed;
    }
    if (poll(&p, 1, wait) <= 0)
        return 0;
    return read(STDIN_FILENO, &key, 1) == 1 ? key : KEYS_END;
}

bool keys_interrupted(void) { return stops > 0; }
