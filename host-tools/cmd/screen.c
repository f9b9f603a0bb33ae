/* host-tools/cmd/screen.c -- the whole terminal as a grid of characters, by ncurses
 * SPDX-License-Identifier: MIT
 *
 * ncurses sends only what has changed, which suits a slow line. Its signal handlers stay out:
 * keys.c has those for ends, and a change of the window is seen at the next screen_show.
 */
#include <curses.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <term.h>
#include <unistd.h>
#undef columns                  /* a macro of term.h */

#include "cmd/keys.h"           /* keys_leave_by */
#include "base/say.h"
#include "cmd/screen.h"
#include "base/tool.h"

static SCREEN *screen;          /* the program has one terminal */
static bool open_now;

int screen_check(const char *name)
{
    int known         = 0;
    const char *named = getenv("TERM");

    if (!isatty(STDIN_FILENO) || !isatty(STDERR_FILENO))
        return tool_error(EX_USAGE,
                          "--%s: standard input and standard error must be a terminal: give `ssh "
                          "-t`, or --json for a program",
                          name);
    if (setupterm(NULL, STDERR_FILENO, &known) == OK && tigetstr("cup") != NULL)
        return 0;
    return tool_error(EX_UNAVAILABLE,
                      "--%s: the terminal `%s` has no full screen: set TERM to what it is, or "
                      "leave this out",
                      name, named ? named : "");
}

/* What a signal handler writes to leave the screen: it may not call ncurses. */
static void remember_leave(void)
{
    static char leave[128];
    static const char *const names[] = { "sgr0", "cnorm", "rmcup" };
    size_t used = 0;

    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        const char *text = tigetstr(names[i]);
        if (text == NULL || text == (char *)-1 || used + strlen(text) >= sizeof leave)
            continue;
        memcpy(leave + used, text, strlen(text) + 1);
        used += strlen(text);
    }
    keys_leave_by(leave);
}

bool screen_open(void)
{
    if (open_now)
        return true;
    if (screen == NULL) {
        (void)signal(SIGWINCH, SIG_IGN);
        screen = newterm(NULL, stderr, stdin);
        if (screen == NULL)
            return false;
        (void)atexit(screen_close);
        (void)curs_set(0);
    }
    remember_leave();
    open_now = true;
    clear();
    return true;
}

void screen_close(void)
{
    if (!open_now)
        return;
    open_now = false;
    (void)endwin();
    keys_leave_by(NULL);
}

void screen_size(int *rows, int *columns)
{
    struct winsize size;

    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_row > 0 && size.ws_col > 0 &&
        (size.ws_row != LINES || size.ws_col != COLS))
        (void)resizeterm(size.ws_row, size.ws_col);
    *rows    = LINES;
    *columns = COLS;
}

void screen_put(int row, int column, const char *text)
{
    char shown[1024];

    if (row >= 0 && row < LINES && column >= 0 && column < COLS)
        (void)mvaddnstr(row, column, say_copy(shown, sizeof shown, text), COLS - column);
}

void screen_paint(void)
{
    if (open_now)
        (void)clearok(curscr, TRUE);
}

void screen_show(void)
{
    (void)refresh();
    (void)erase();
}
