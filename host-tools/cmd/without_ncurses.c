/* host-tools/cmd/without_ncurses.c -- refuses a full screen in a program without ncurses
 * SPDX-License-Identifier: MIT
 */
#include "cmd/screen.h"
#include "base/tool.h"

int screen_check(const char *name)
{
    return tool_error(EX_UNAVAILABLE,
                      "--%s: this loft was built without ncurses: build it with libncurses-dev, or "
                      "leave this out: a line shows the progress",
                      name);
}

bool screen_open(void) { return false; }

void screen_close(void) { }

void screen_size(int *rows, int *columns)
{
    *rows    = 24;
    *columns = 80;
}

void screen_put(int row, int column, const char *text) { (void)row, (void)column, (void)text; }

void screen_paint(void) { }

void screen_show(void) { }
