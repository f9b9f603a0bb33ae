/* host-tools/cmd/cmd_settings.c -- loft settings: prints or saves what a machine keeps about itself
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "base/create.h"
#include "base/say.h"
#include "base/tool.h"
#include "send/grbl.h"
#include "send/settings.h"

static const char *origin_of(const settings *s)
{
    return s->origin == LOFT_SETTINGS_KEPT      ? "kept by the machine"
           : s->origin == LOFT_SETTINGS_DAMAGED ? "those of its firmware: what it kept is damaged"
                                                : "those of its firmware: it keeps none yet";
}

static void print_settings(const machine_file *m, const char *title, FILE *out)
{
    (void)say(out, "# settings of %s\n", title);
    machine_print(m, MACHINE_OBEYS, out);
    machine_print(m, MACHINE_TEXT, out);
}

static int save_settings(const machine_file *m, const char *title, const char *file)
{
    FILE *out = create_file(file);

    if (out == NULL)
        return create_refused(tool_host(), file, errno);
    print_settings(m, title, out);
    if ((ferror(out) | fclose(out)) != 0)
        return tool_error(EX_IOERR, "%s: is not complete: %s: is the disk full?", file,
                          strerror(errno));
    (void)say(stdout, "saved: %s, a file for --machine and for `loft set`\n", file);
    return 0;
}

typedef struct {
    const char *port;
    unsigned baud;
    double wait;
    bool grbl;
    const char *log;
} where;

static int ask_machine(const where *o, machine_file *m, char *title, size_t room)
{
    settings s;
    talk t;
    int code = talk_open(&t, o->port, o->baud, o->wait, o->log);

    if (code != 0)
        return code;
    code = settings_read(&s, &t);
    talk_close(&t);
    if (code != 0)
        return code;
    snprintf(title, room, "%s, %s: %u of %u bytes", o->port, origin_of(&s), s.size, s.room);
    *m = s.m;
    return 0;
}

static int ask_grbl(const where *o, machine_file *m, char *title, size_t room)
{
    grbl *g;
    int code = grbl_open(&g, o->port, o->baud, o->wait);

    if (code != 0)
        return code;
    snprintf(title, room, "%s, %s; the table, if it has soft limits, in work coordinates", o->port,
             grbl_name(g)[0] != '\0' ? grbl_name(g) : "a controller of grbl's kind");
    code = grbl_machine(g, m);
    grbl_close(g);
    return code;
}

static int run_settings(const tool_command *self, int argc, char **argv)
{
    where o          = { .baud = 115200, .wait = 5 };
    const char *save = NULL;
    machine_file m   = machine_usual();
    char title[200];
    int first;

    const tool_option options[] = {
        TALK_OPTIONS(o), TOOL_TEXT("save", "FILE", &save, "write them to FILE, and print nothing"),
        TOOL_SWITCH("grbl", &o.grbl, "of a controller of grbl's kind: what it answers to $$"),
        TOOL_TEXT("log", "FILE", &o.log, "write what passes on the line, in words"),
        TOOL_OPTIONS_END
    };
    int code = tool_options(self, options, argc, argv, &first);
    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    if (first < argc)
        return tool_error(EX_USAGE, "%s: settings takes no file: see `loft settings --help`",
                          argv[first]);
    if (o.port == NULL)
        return tool_error(EX_USAGE, "no --port: name the machine's port");
    if (o.grbl && o.log != NULL)
        return tool_error(EX_USAGE, "--log: is for machines of loft, and not with --grbl");
    code = (o.grbl ? ask_grbl : ask_machine)(&o, &m, title, sizeof title);
    if (code == 0 && save != NULL)
        code = save_settings(&m, title, save);
    else if (code == 0)
        print_settings(&m, title, stdout);
    return code;
}

const tool_command command_settings = {
    "settings", "--port PORT [--save FILE] [--grbl]", "what a machine keeps about itself",
    "Prints lines of a machine file (host-tools/MACHINE.md): gearing, limits, contacts, table,\n"
    "homing. `loft set` changes them. Nothing moves. With --grbl: what a controller of\n"
    "grbl's kind says of itself, so that --machine FILE plans for it.\n",
    run_settings
};
