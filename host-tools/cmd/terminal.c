/* host-tools/cmd/terminal.c
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"     /* memory_is_out */
#include "cmd/screen.h"     /* screen_close */
#include "base/tool.h"       /* tool_clock, tool_error */
#include "cmd/terminal.h"

/* `loft: file:line: what: remedy`, on a line of its own. */
static void print(void *context, const host_message *m)
{
    const bool fatal = m->code == EX_OK && tool_host()->strict;

    (void)context;
    fflush(stdout);
    progress_clear_any();
    screen_close();
    host_put_line(stderr, m, "loft: ", fatal ? " (an error by --strict)" : "");
}

static bool draw(void *context, const host_progress *p)
{
    terminal *t = context;

    if (p->doing == NULL) {
        progress_clear_any();
    } else {
        if (t->doing == NULL || strcmp(t->doing, p->doing) != 0)
            (p->brief ? progress_start_late : progress_start)(&t->bar, p->total);
        progress_show(&t->bar, p->done, p->doing);
    }
    t->doing = p->doing;
    return true;
}

static double seconds(void *context)
{
    (void)context;
    return tool_clock();
}

static void end(size_t bytes)
{
    exit(tool_error(EX_OSERR, "no memory for %zu bytes: give a smaller drawing", bytes));
}

host terminal_host(terminal *t)
{
    memory_is_out(end);
    return (host){ .message = print, .progress = draw, .now = seconds, .context = t };
}
