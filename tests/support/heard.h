/* tests/support/heard.h -- a host that listens: keeps the messages of what is tested
 * SPDX-License-Identifier: MIT
 *
 * `heard` is that of the program, too, for rooms that do not take one. Before each call: hear().
 */
#ifndef LOFT_TESTS_HEARD_H
#define LOFT_TESTS_HEARD_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/host.h"
#include "base/memory.h"
#include "base/tool.h"      /* tool_use */

#define HEARD_MOST 64           /* of which the names are kept */

static char caught[4096];       /* their lines, without ends */
static unsigned caught_lines;
static struct {
    char name[48];
    unsigned line;
    int code;
} caught_as[HEARD_MOST];

static inline void heard_keep(void *context, const host_message *m)
{
    const size_t used = strlen(caught);
    FILE *out         = fmemopen(caught + used, sizeof caught - used, "w");

    (void)context;
    if (out != NULL) {
        host_put_line(out, m, "", "");
        fclose(out);
    }
    caught[sizeof caught - 1] = '\0';
    if (caught[0] != '\0' && caught[strlen(caught) - 1] == '\n')
        caught[strlen(caught) - 1] = '\0';
    if (caught_lines < HEARD_MOST) {
        snprintf(caught_as[caught_lines].name, sizeof caught_as->name, "%s", m->name);
        caught_as[caught_lines].line = m->at.line;
        caught_as[caught_lines].code = m->code;
    }
    caught_lines++;
}

static host heard = { .message = heard_keep };

/* Forget what was heard. */
static inline void hear(void)
{
    caught[0] = '\0';
    caught_lines = 0;
    heard.warnings = heard.errors = 0;
}

/* Has a message of this name been given, at this line? */
static inline bool heard_it(const char *name, unsigned line)
{
    for (unsigned i = 0; i < caught_lines && i < HEARD_MOST; i++)
        if (caught_as[i].line == line && strcmp(caught_as[i].name, name) == 0)
            return true;
    return false;
}

static void heard_no_memory(size_t bytes)
{
    printf("no memory for %zu bytes\n", bytes);
    abort();
}

__attribute__((constructor)) static void heard_begins(void)
{
    memory_is_out(heard_no_memory);
    tool_use(&heard);
}

#endif
