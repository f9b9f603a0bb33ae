/* host-tools/base/tool.c -- options, help
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/describe.h"   /* describe_command */
#include "base/near.h"       /* near_try */
#include "base/host.h"       /* host.strict */
#include "base/tool.h"
#include "loft.h"            /* LOFT_VERSION */

const char tool_version[] = LOFT_VERSION;

static bool strict;         /* --strict */

/* Read the number at the start of `text`, and find its end. Returns false if there is none, or if
 * it is out of bounds. */
static bool number_at(const char *text, double least, double most, double *out, char **end)
{
    const double value = strtod(text, end);

    if (*end == text || !(value >= least && value <= most))
        return false;
    *out = value;
    return true;
}

static bool number_refused(const char *option, const char *text, double least, double most,
                           const char *unit)
{
    (void)tool_error(EX_USAGE, "--%s %s: give a number from %.9g to %.9g%s", option, text, least,
                     most, unit);
    return false;
}

bool tool_number(const char *option, const char *text, double least, double most, double *out)
{
    char *end;

    if (!number_at(text, least, most, out, &end) || *end != '\0')
        return number_refused(option, text, least, most, "");
    return true;
}

static bool count_of(const tool_option *o, const char *text)
{
    char *end;
    double value;

    if (!number_at(text, o->least, o->most, &value, &end) || *end != '\0' || value != floor(value))
        return number_refused(o->name, text, o->least, o->most, ", a whole one");
    *(unsigned *)o->out = (unsigned)value;
    return true;
}

static bool speed_of(const char *option, const char *text, double least, double most, double *out)
{
    static const struct {
        const char *unit;
        double factor;
    } units[] = { { "", 1 },
                  { "mm/s", 1 },
                  { "mm/min", 1 / 60.0 },
                  { "m/min", 1000 / 60.0 },
                  { "in/min", 25.4 / 60.0 } };
    char *end;
    double value;

    if (number_at(text, -HUGE_VAL, HUGE_VAL, &value, &end)) {
        while (*end == ' ')
            end++;
        for (size_t i = 0; i < sizeof units / sizeof units[0]; i++)
            if (strcmp(end, units[i].unit) == 0 && value * units[i].factor >= least &&
                value * units[i].factor <= most) {
                *out = value * units[i].factor;
                return true;
            }
    }
    return number_refused(option, text, least, most, " mm/s, as 20, 20mm/s or 1200mm/min");
}

static bool list_of(const tool_option *o, const char *text)
{
    tool_list *list = o->out;

    for (char *end;; text = end + 1) {
        double value;
        if (!number_at(text, o->least, o->most, &value, &end) || (*end != ',' && *end != '\0'))
            return number_refused(o->name, text, o->least, o->most,
                                  ", or several with commas between");
        if (list->count == TOOL_LIST_MAX) {
            (void)tool_error(EX_USAGE, "--%s: give at most %d numbers", o->name, TOOL_LIST_MAX);
            return false;
        }
        list->value[list->count++] = value;
        if (*end == '\0')
            return true;
    }
}

static bool take_value(const tool_option *o, const char *text)
{
    switch (o->kind) {
    case TOOL_IS_MAYBE:
        *(double *)o->out = 0;
        return text == NULL || tool_number(o->name, text, o->least, o->most, o->out);
    case TOOL_IS_SWITCH: *(bool *)o->out = true; return true;
    case TOOL_IS_NUMBER: return tool_number(o->name, text, o->least, o->most, o->out);
    case TOOL_IS_COUNT:  return count_of(o, text);
    case TOOL_IS_SPEED:  return speed_of(o->name, text, o->least, o->most, o->out);
    case TOOL_IS_TEXT:   *(const char **)o->out = text; return true;
    case TOOL_IS_LIST:   return list_of(o, text);
    case TOOL_IS_PARSED: return o->parse(text, o->out);
    case TOOL_END:       break;
    }
    return false;
}

/* The row that -o abbreviates; -1 if the command writes no file. */
static int output_row(const tool_option options[])
{
    for (int i = 0; options[i].kind != TOOL_END; i++)
        if (strcmp(options[i].name, "output") == 0)
            return i;
    return -1;
}

/* getopt accepts an optional number only after `=`. Returns the next word if it is a number, else
 * NULL. */
static const char *number_behind(int argc, char **argv)
{
    double value;
    char *end;

    if (optind >= argc || !number_at(argv[optind], -HUGE_VAL, HUGE_VAL, &value, &end) ||
        *end != '\0')
        return NULL;
    return argv[optind++];
}

/* getopt accepts `--f` for `--feed`. We refuse that: a script with `--f` could mean another option
 * one day. */
static bool is_abbreviated(char **argv, const char *name)
{
    const bool apart = optarg != NULL && optarg == argv[optind - 1];
    const char *word = argv[optind - (apart ? 2 : 1)];

    return strncmp(word, "--", 2) == 0 && strcspn(word + 2, "=") != strlen(name);
}

static int unknown_option(const tool_command *self, const tool_option options[], const char *word)
{
    near_words near = { .word = word + 2, .length = strcspn(word + 2, "=") };
    char meant[160];

    for (int i = 0; strncmp(word, "--", 2) == 0 && options[i].kind != TOOL_END; i++)
        near_try(&near, options[i].name);
    return tool_error(EX_USAGE, "%s is not an option of %s%s: see `loft %s --help`", word,
                      self->name, near_text(&near, "--", meant), self->name);
}

static int parse_options(const tool_command *self, const tool_option options[], size_t count,
                         int argc, char **argv)
{
    struct option *table = tool_grow(NULL, (count + 2) * sizeof *table);
    for (size_t i = 0; i < count; i++)
        table[i] = (struct option){ options[i].name,
                                    options[i].kind == TOOL_IS_MAYBE ? optional_argument
                                    : options[i].argument            ? required_argument
                                                                     : no_argument,
                                    NULL, 0 };
    table[count]     = (struct option){ "help", optional_argument, NULL, 'h' };
    table[count + 1] = (struct option){ NULL, 0, NULL, 0 };

    int code = 0;
    optind = 1;
    opterr = 0;
    while (code == 0) {
        int which = -1;
        int c = getopt_long(argc, argv, ":ho:", table, &which);
        if (c == 'o' && (which = output_row(options)) >= 0)
            c = 0;
        if (c == -1)
            break;
        if (c == 'h') {
            code = describe_command(optarg, self, options);
            code = code == EX_OK ? TOOL_HELP : code;
        } else if (c == ':') {
            code = tool_error(EX_USAGE, "%s needs a value: see `loft %s --help`", argv[optind - 1],
                              self->name);
        } else if (c != 0) {
            code = unknown_option(self, options, argv[optind - 1]);
        } else if (is_abbreviated(argv, options[which].name)) {
            code = tool_error(EX_USAGE, "--%s: write the whole name: see `loft %s --help`",
                              options[which].name, self->name);
        } else if (!take_value(&options[which],
                               options[which].kind == TOOL_IS_MAYBE && optarg == NULL
                                   ? number_behind(argc, argv)
                                   : optarg)) {
            code = EX_USAGE;
        }
    }
    free(table);
    return code;
}

int tool_options(const tool_command *self, const tool_option options[], int argc, char **argv,
                 int *first)
{
    static const tool_option common[] = {
        TOOL_SWITCH("strict", &strict, "a warning is an error: the command ends with it"),
        TOOL_OPTIONS_END
    };
    size_t count = 0;
    while (options[count].kind != TOOL_END)
        count++;

    tool_option *all = tool_grow(NULL, (count + 2) * sizeof *all);
    memcpy(all, options, count * sizeof *all);
    memcpy(all + count, common, sizeof common);
    const int code = parse_options(self, all, count + 1, argc, argv);
    free(all);
    *first = optind;
    tool_host()->strict = strict;
    return code;
}

int tool_file_options(const tool_command *self, const tool_option options[], int argc, char **argv,
                      const char *const *points, const char **file)
{
    int first;
    const int code = tool_options(self, options, argc, argv, &first);
    const bool given = points != NULL && *points != NULL;

    if (code == 0 && argc - first > !given)
        return tool_error(EX_USAGE, "%s: give one file%s: see `loft %s --help`", argv[argc - 1],
                          given ? " or --points, not both" : "", self->name);
    *file = first < argc ? argv[first] : "-";
    return code;
}
