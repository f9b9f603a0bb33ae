/* host-tools/cmd/command.h -- a command: a table of options, a struct that it fills, one call
 * SPDX-License-Identifier: MIT
 *
 * A command is a file cmd_<name>.c that defines one `command`; commands.h declares it, and
 * command_list.c lists it.
 */
#ifndef LOFT_COMMAND_H
#define LOFT_COMMAND_H

#include "base/option.h"
#include "base/tool.h"          /* tool_error */

typedef struct {
    const char *name;
    const char *arguments;      /* what follows the name in the usage line              */
    const char *summary;        /* half a line, for `loft --help`                       */
    const char *detail;         /* paragraphs for `loft help NAME`, ends with a newline */
    const option *options;
    size_t size;                /* of the struct of options */
    int (*run)(void *options);  /* returns the exit code */
    bool talks;                 /* to a machine, and says itself what it waits for */
} command;

/* Its table with the options that all commands have. */
void command_options(const command *c, option whole[3]);

/* The size of the struct that this table fills; whether --strict was given. */
size_t command_size(const command *c);
bool command_is_strict(const command *c, const void *options);

#endif
