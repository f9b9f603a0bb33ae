/* host-tools/cmd/cmd_set.c -- loft set: changes what a machine keeps about itself
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/tool.h"
#include "send/settings.h"

typedef struct {
    const char *port, *file, *log;
    bool defaults;
    unsigned baud;
    double wait;
} set_options;

/* The words as lines of one text. */
static char *lines_of(char **word, int count)
{
    size_t bytes = 1;

    for (int i = 0; i < count; i++)
        bytes += strlen(word[i]) + 1;
    char *text = tool_grow(NULL, bytes);
    text[0]    = '\0';
    for (int i = 0; i < count; i++) {
        strcat(text, word[i]);
        strcat(text, "\n");
    }
    return text;
}

/* What a machine does not keep has no effect there: a word is refused, a file may say it. */
static int check_kept(const machine_file *before, const machine_file *m, bool named)
{
    const char *key = machine_differs(before, m, MACHINE_FIRMWARE);

    if (key != NULL && named)
        return tool_error(EX_CONFIG, "%s is part of the machine's firmware: it cannot be set", key);
    if (key == NULL)
        key = machine_differs(before, m, MACHINE_PLAN);
    if (key != NULL && named)
        return tool_error(EX_CONFIG,
                          "%s is about the plan of a drawing, and a machine does not keep it: give "
                          "it in a --machine FILE of `loft stream`",
                          key);
    if (key != NULL)
        (void)tool_error(EX_OK, "%s, and what else is of firmware or plan, is not kept", key);
    return 0;
}

static int change_settings(settings *s, const set_options *o, char **word, int count)
{
    const machine_file before = s->m;
    char *text                = lines_of(word, count);
    int code                  = 0;

    if (o->file != NULL)
        code = machine_read(&s->m, o->file);
    if (code == 0)
        code = check_kept(&before, &s->m, false);
    const machine_file read = s->m;
    if (code == 0)
        code = machine_text(&s->m, "set", text);
    if (code == 0)
        code = check_kept(&read, &s->m, true);
    free(text);
    return code;
}

static void print_gearing(const settings *before, const settings *now, bool defaults)
{
    if (defaults)
        printf("back to those of its firmware; steps/mm");
    else
        printf("kept: %u of %u bytes; steps/mm", now->size, now->room);
    for (int i = 0; i < ENGINE_AXES; i++)
        printf(" %g", now->m.steps_per_mm[i]);
    printf("\n");
    for (int i = 0; i < ENGINE_AXES; i++)
        if (before->m.steps_per_mm[i] != now->m.steps_per_mm[i] ||
            before->m.reversed[i] != now->m.reversed[i]) {
            printf("its place in mm is another one now: `loft home` it, or `loft zero`\n");
            return;
        }
}

static int set_machine(const set_options *o, talk *t, char **word, int count)
{
    settings before, now;
    int code = settings_read(&before, t);

    if (code != 0)
        return code;
    now = before;
    if (o->defaults) {
        code = settings_reset(&now, t, o->wait);
    } else {
        code = change_settings(&now, o, word, count);
        if (code == 0)
            code = settings_write(&now, t, o->wait);
        if (code == 0)
            code = settings_read(&now, t);
    }
    if (code == 0)
        print_gearing(&before, &now, o->defaults);
    return code;
}

static int run_set(const tool_command *self, int argc, char **argv)
{
    set_options o = { .baud = 115200, .wait = 5 };
    talk t;
    int first;

    const tool_option options[] = {
        TALK_OPTIONS(o),
        TOOL_TEXT("machine", "FILE", &o.file,
                  "first all that a machine as text says, see host-tools/MACHINE.md"),
        TOOL_SWITCH("defaults", &o.defaults, "back to the settings of its firmware, all of them"),
        TOOL_TEXT("log", "FILE", &o.log, "write what passes on the line, in words"),
        TOOL_OPTIONS_END
    };
    int code = tool_options(self, options, argc, argv, &first);
    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    if (o.port == NULL)
        return tool_error(EX_USAGE, "no --port: name the machine's port");
    if (o.defaults && (first < argc || o.file != NULL))
        return tool_error(EX_USAGE, "--defaults sets all: leave the rest to a second `loft set`");
    if (first == argc && o.file == NULL && !o.defaults)
        return tool_error(EX_USAGE, "nothing to set: give NAME=VALUE, as x.steps_per_mm=80, or "
                                    "--machine FILE, or --defaults");
    code = talk_open(&t, o.port, o.baud, o.wait, o.log);
    if (code != 0)
        return code;
    code = set_machine(&o, &t, argv + first, argc - first);
    talk_close(&t);
    return code;
}

const tool_command command_set = {
    "set", "NAME=VALUE..|--defaults --port PORT", "change what a machine keeps about itself",
    "Names are those of a machine file (host-tools/MACHINE.md), as x.steps_per_mm=80 or\n"
    "x.limit=opens; `loft settings` prints all. All are changed, or none, also if the power\n"
    "fails. The machine must be at rest, and nothing moves.\n",
    run_set
};
