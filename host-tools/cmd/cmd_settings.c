/* host-tools/cmd/cmd_settings.c -- loft settings: prints or saves what a machine keeps about itself
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "base/tool.h"
#include "send/settings.h"

static const char *origin_of(const settings *s)
{
    return s->origin == LOFT_SETTINGS_KEPT      ? "kept by the machine"
           : s->origin == LOFT_SETTINGS_DAMAGED ? "those of its firmware: what it kept is damaged"
                                                : "those of its firmware: it keeps none yet";
}

static void print_settings(const settings *s, const talk *t, FILE *out)
{
    fprintf(out, "# settings of %s, %s: %u of %u bytes\n", t->port, origin_of(s), s->size, s->room);
    machine_print(&s->m, MACHINE_OBEYS, out);
    machine_print(&s->m, MACHINE_TEXT, out);
}

static int save_settings(const settings *s, const talk *t, const char *file)
{
    FILE *out = fopen(file, "w");

    if (out == NULL)
        return tool_error(EX_CANTCREAT, "%s: %s: name a file that can be written", file,
                          strerror(errno));
    print_settings(s, t, out);
    if ((ferror(out) | fclose(out)) != 0)
        return tool_error(EX_IOERR, "%s: is not complete: %s: is the disk full?", file,
                          strerror(errno));
    printf("saved: %s, a file for --machine and for `loft set`\n", file);
    return 0;
}

static int run_settings(const tool_command *self, int argc, char **argv)
{
    struct {
        const char *port;
        unsigned baud;
        double wait;
    } o              = { .baud = 115200, .wait = 5 };
    const char *save = NULL, *log = NULL;
    settings s;
    talk t;
    int first;

    const tool_option options[] = {
        TALK_OPTIONS(o), TOOL_TEXT("save", "FILE", &save, "write them to FILE, and print nothing"),
        TOOL_TEXT("log", "FILE", &log, "write what passes on the line, in words"), TOOL_OPTIONS_END
    };
    int code = tool_options(self, options, argc, argv, &first);
    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    if (first < argc)
        return tool_error(EX_USAGE, "%s: settings takes no file: see `loft settings --help`",
                          argv[first]);
    if (o.port == NULL)
        return tool_error(EX_USAGE, "no --port: name the machine's port");
    code = talk_open(&t, o.port, o.baud, o.wait, log);
    if (code != 0)
        return code;
    code = settings_read(&s, &t);
    if (code == 0 && save != NULL)
        code = save_settings(&s, &t, save);
    else if (code == 0)
        print_settings(&s, &t, stdout);
    talk_close(&t);
    return code;
}

const tool_command command_settings = {
    "settings", "--port PORT [--save FILE]", "what a machine keeps about itself",
    "Prints lines of a machine file (host-tools/MACHINE.md): gearing, limits, contacts, table,\n"
    "homing. `loft set` changes them. Nothing moves.\n",
    run_settings
};
