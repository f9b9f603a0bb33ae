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

/* As the XDG Base Directory Specification says. */
static void find_state(char folder[PATH_MAX])
{
    const char *state = getenv("XDG_STATE_HOME"), *home = getenv("HOME");
    int length        = 0;

    if (state != NULL && *state == '/')
        length = snprintf(folder, PATH_MAX, "%s/loft", state);
    else if (home != NULL && *home == '/')
        length = snprintf(folder, PATH_MAX, "%s/.local/state/loft", home);
    if (length <= 0 || length >= PATH_MAX)
        folder[0] = '\0';
}

host terminal_host(terminal *t)
{
    memory_is_out(end);
    find_state(t->state);
    return (host){
        .message = print, .progress = draw, .now = seconds, .context = t, .state = t->state
    };
}
