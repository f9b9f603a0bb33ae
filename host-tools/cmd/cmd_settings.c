/* host-tools/cmd/cmd_settings.c -- loft settings: prints or saves what a machine keeps about itself
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "cmd/commands.h"
#include "base/create.h"
#include "base/say.h"
#include "send/grbl.h"
#include "cmd/run.h"            /* run_open */
#include "cmd/run_settings.h"

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
    talk_options line;
    const char *save;
    bool grbl;
} settings_options;

static const option settings_rows[] = {
    OPTION_GROUP(settings_options, line, talk_rows),
    { "save", OPTION_FILE(settings_options, save), .value = "FILE",
      .help = "write them to FILE, and print nothing" },
    { "grbl", OPTION_FLAG(settings_options, grbl),
      .help = "of a controller of grbl's kind: what it answers to $$" },
    { "log", OPTION_FILE(settings_options, line.log), .value = "FILE",
      .help = "write what passes on the line, in words" },
    OPTION_NO_WORDS("settings takes no file"),
    OPTION_NEEDS("", "port", "name the machine's port"),
    OPTION_EXCLUDES("grbl", "log", "it is for machines of loft"),
    { 0 }
};

static int ask_machine(const settings_options *o, machine_file *m, char *title, size_t room)
{
    settings s;
    talk t;
    int code = run_open(&t, &o->line);

    if (code != 0)
        return code;
    code = run_settings_read(&s, &t);
    talk_close(&t);
    if (code != 0)
        return code;
    snprintf(title, room, "%s, %s: %u of %u bytes", o->line.port, origin_of(&s), s.size, s.room);
    *m = s.m;
    return 0;
}

static int ask_grbl(const settings_options *o, machine_file *m, char *title, size_t room)
{
    grbl *g;
    int code = run_controller(&g, &o->line);

    if (code != 0)
        return code;
    snprintf(title, room, "%s, %s; the table, if it has soft limits, in work coordinates",
             o->line.port, grbl_name(g)[0] != '\0' ? grbl_name(g) : "a controller of grbl's kind");
    code = grbl_machine(g, m);
    grbl_close(g);
    return code;
}

static int run_settings(void *options)
{
    const settings_options *o = options;
    machine_file m            = machine_usual();
    char title[200];
    int code = (o->grbl ? ask_grbl : ask_machine)(o, &m, title, sizeof title);

    if (code == 0 && o->save != NULL)
        code = save_settings(&m, title, o->save);
    else if (code == 0)
        print_settings(&m, title, stdout);
    return code;
}

const command command_settings = {
    .name = "settings",
    .arguments = "--port PORT [--save FILE] [--grbl]",
    .summary = "what a machine keeps about itself",
    .detail = "Prints lines of a machine file (host-tools/MACHINE.md): gearing, limits, contacts, "
              "table,\n"
        "homing. `loft set` changes them. Nothing moves. With --grbl: what a controller of\n"
        "grbl's kind says of itself, so that --machine FILE plans for it.\n",
    .options = settings_rows,
    .size = sizeof(settings_options),
    .run = run_settings,
    .talks = true,
};
