/* host-tools/cmd/cmd_set.c -- loft set: changes what a machine keeps about itself
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cmd/commands.h"
#include "cmd/run.h"            /* run_open */
#include "cmd/run_settings.h"

typedef struct {
    talk_options line;
    const char *file;
    bool defaults;
    option_words settings;
} set_options;

static const option set_rows[] = {
    OPTION_GROUP(set_options, line, talk_rows),
    { "machine", OPTION_FILE(set_options, file), .value = "FILE",
      .help = "first all that a machine as text says, see host-tools/MACHINE.md" },
    { "defaults", OPTION_FLAG(set_options, defaults),
      .help = "back to the settings of its firmware, all of them" },
    { "log", OPTION_FILE(set_options, line.log), .value = "FILE",
      .help = "write what passes on the line, in words" },
    { "settings", OPTION_WORDS(set_options, settings), .most = 1e6, .value = "NAME=VALUE" },
    OPTION_NEEDS("", "port", "name the machine's port"),
    OPTION_EXCLUDES("defaults", "settings|machine",
                    "--defaults sets all: leave the rest to a second `loft set`"),
    OPTION_NEEDS("", "settings|machine|defaults",
                 "nothing to set: give a setting, as x.steps_per_mm=80, or a machine file"),
    { 0 }
};

/* The words as lines of one text. */
static char *lines_of(const option_words *w)
{
    size_t bytes = 1;

    for (size_t i = 0; i < w->count; i++)
        bytes += strlen(w->word[i]) + 1;
    char *text = tool_grow(NULL, bytes);
    text[0]    = '\0';
    for (size_t i = 0; i < w->count; i++) {
        strcat(text, w->word[i]);
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

static int change_settings(settings *s, const set_options *o)
{
    const machine_file before = s->m;
    char *text                = lines_of(&o->settings);
    int code                  = 0;

    if (o->file != NULL)
        code = machine_read(tool_host(), &s->m, o->file);
    if (code == 0)
        code = check_kept(&before, &s->m, false);
    const machine_file read = s->m;
    if (code == 0)
        code = machine_text(tool_host(), &s->m, "set", text);
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

static int set_machine(const set_options *o, talk *t)
{
    settings before, now;
    int code = run_settings_read(&before, t);

    if (code != 0)
        return code;
    now = before;
    if (o->defaults) {
        code = run_settings_reset(&now, t, o->line.wait);
    } else {
        code = change_settings(&now, o);
        if (code == 0)
            code = run_settings_write(&now, t, o->line.wait);
        if (code == 0)
            code = run_settings_read(&now, t);
    }
    if (code == 0)
        print_gearing(&before, &now, o->defaults);
    return code;
}

static int run_set(void *options)
{
    const set_options *o = options;
    talk t;
    int code = run_open(&t, &o->line);

    if (code != 0)
        return code;
    code = set_machine(o, &t);
    talk_close(&t);
    return code;
}

const command command_set = {
    .name = "set",
    .arguments = "NAME=VALUE..|--defaults --port PORT",
    .summary = "change what a machine keeps about itself",
    .detail =
        "Names are those of a machine file (host-tools/MACHINE.md), as x.steps_per_mm=80 or\n"
        "x.limit=opens; `loft settings` prints all. All are changed, or none, also if the power\n"
        "fails. The machine must be at rest, and nothing moves.\n",
    .options = set_rows,
    .size = sizeof(set_options),
    .run = run_set,
    .talks = true,
};
