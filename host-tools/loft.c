/* host-tools/loft.c -- the command `loft`: finds the subcommand, nothing else
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "cmd/dispatch.h"
#include "cmd/describe.h"   /* describe_all */
#include "base/near.h"       /* near_try */
#include "base/progress.h"   /* progress_watch */
#include "base/tool.h"       /* tool_error */
#include "cmd/terminal.h"    /* terminal_host */
#include "command_list.h"
#include "loft.h"            /* LOFT_VERSION */

static const command *find(const char *name)
{
    for (size_t i = 0; i < commands_count; i++)
        if (strcmp(commands[i]->name, name) == 0)
            return commands[i];
    return NULL;
}

static int help(void)
{
    printf("loft -- curves from the drawing to the step pulse\n\nusage: loft COMMAND [options] "
           "[FILE|-]\n\n");
    for (size_t i = 0; i < commands_count; i++)
        printf("  %-10s %s\n", commands[i]->name, commands[i]->summary);
    printf("\n`loft help COMMAND` tells more. Coordinates are in mm; exit codes are those of "
           "sysexits.h.\n");
    return EX_OK;
}

/* Check that the output was written. */
static int flushed(int code)
{
    if ((fflush(stdout) != 0 || ferror(stdout)) && code == EX_OK)
        return tool_error(EX_IOERR, "standard output: %s: is the disk full? write elsewhere",
                          strerror(errno));
    return code;
}

static int unknown_command(const char *name)
{
    static const char *const others[][2] = { { "draw", "stream" },   { "send", "stream" },
                                             { "print", "stream" },  { "show", "plot" },
                                             { "preview", "plot" },  { "view", "plot" },
                                             { "convert", "export" } };
    near_words near = { .word = name, .length = strlen(name) };
    char meant[160];

    if (access(name, F_OK) == 0)
        return tool_error(EX_USAGE,
                          "%s: is a file, and no command: `loft plot %s` shows it, `loft stream %s "
                          "--port PORT` draws it: see `loft --help`",
                          name, name, name);
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (strcmp(others[i][0], name) == 0)
            near = (near_words){ others[i][1], strlen(others[i][1]), { 0 }, { 0 } };
    for (size_t i = 0; i < commands_count; i++)
        near_try(&near, commands[i]->name);
    return tool_error(EX_USAGE, "unknown command %s%s: see `loft --help`", name,
                      near_text(&near, "", meant));
}

static int run(const char *name, int argc, char **argv)
{
    const command *c = find(name);

    if (c == NULL)
        return unknown_command(name);
    if (!c->talks)
        progress_watch(c->name);
    return flushed(dispatch(c, argc, argv));
}

static int run_line(int argc, char **argv)
{
    const char *name = argc > 1 ? argv[1] : "";

    if (argc < 2) {
        help();
        return EX_USAGE;
    }
    if (strcmp(name, "--version") == 0)
        return flushed(printf("loft %s\n", tool_version) < 0 ? EX_IOERR : EX_OK);
    if (strcmp(name, "--help") == 0 || strcmp(name, "-h") == 0 ||
        (strcmp(name, "help") == 0 && argc == 2))
        return flushed(help());
    if (strcmp(name, "options") == 0 && argc == 3 && strcmp(argv[2], "--json") == 0)
        return flushed(describe_all("json", commands, commands_count));
    if (strncmp(name, "--help=", 7) == 0)
        return flushed(describe_all(name + 7, commands, commands_count));
    if (strcmp(name, "help") == 0) {
        char word[] = "--help";
        char *line[] = { argv[2], word, NULL };
        return run(argv[2], 2, line);
    }
    return run(name, argc - 1, argv + 1);
}

int main(int argc, char **argv)
{
    terminal t     = { .doing = NULL };
    host h         = terminal_host(&t);

    tool_use(&h);
    const int code = run_line(argc, argv);
    host_close(&h);
    return code;
}
