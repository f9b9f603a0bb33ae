/* host-tools/base/option_line.c -- options: from the command line into a struct
 * SPDX-License-Identifier: MIT
 */
#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sysexits.h>

#include "base/option.h"

/* getopt accepts an optional number only after `=`. Returns the next word if it is a number, else
 * NULL. */
static const char *number_behind(int argc, char **argv)
{
    double value;
    char *end;

    if (optind >= argc || !option_number_at(argv[optind], -HUGE_VAL, HUGE_VAL, &value, &end) ||
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

/* getopt's table; its values are the rows. */
static void fill_table(const option_reading *r, struct option table[OPTIONS_MOST + 2])
{
    size_t n = 0;

    for (size_t i = 0; i < r->count; i++) {
        const option *o = r->all[i].row;
        if (option_is_named(o))
            table[n++] = (struct option){ o->name,
                                          o->kind == OPTION_IS_MAYBE  ? optional_argument
                                          : o->kind == OPTION_IS_FLAG ? no_argument
                                                                      : required_argument,
                                          NULL, (int)i + 256 };
    }
    table[n++] = (struct option){ "help", optional_argument, NULL, 'h' };
    table[n]   = (struct option){ NULL, 0, NULL, 0 };
}

static int take_argument(option_reading *r, int c, int argc, char **argv)
{
    const size_t output = option_row_named(r, "output", 6);
    char more[80];

    if (c == 'o' && output < r->count)
        return option_take(r, output, optarg);
    if (c == ':')
        return option_wrong(r, "option.value", "%.*s needs a value%s", OPTION_SHOWN,
                            argv[optind - 1], option_see(r, more));
    if (c < 256)
        return option_unknown(r, c == 'o' ? "-o" : argv[optind - 1]);
    const option *o = r->all[c - 256].row;
    if (is_abbreviated(argv, o->name))
        return option_wrong(r, "option.unknown", "--%s: write the whole name%s", o->name,
                            option_see(r, more));
    const bool behind = o->kind == OPTION_IS_MAYBE && optarg == NULL;
    return option_take(r, (size_t)c - 256, behind ? number_behind(argc, argv) : optarg);
}

/* A first word that begins with a minus may be a number: `loft go -5,3`. */
static bool is_number_word(int argc, char **argv)
{
    return argc > 1 && argv[1][0] == '-' && argv[1][1] != '\0' &&
           strchr("0123456789.", argv[1][1]) != NULL;
}

/* The words, with the number that stood before the options. */
static char **first_word(char **line, bool number)
{
    char *word = line[0];

    if (!number)
        return line + optind;
    memmove(&line[0], &line[1], (size_t)(optind - 1) * sizeof *line);
    line[optind - 1] = word;
    return line + optind - 1;
}

int options_read(const option rows[], int argc, char **argv, void *o, option_fault *f)
{
    struct option table[OPTIONS_MOST + 2];
    option_reading r;
    int code          = option_begin(&r, rows, o, f);
    const bool number = is_number_word(argc, argv);
    char **line       = argv + number;

    r.self = argv[0];
    fill_table(&r, table);
    optind = 0;
    opterr = 0;
    for (int c; code == 0 && (c = getopt_long(argc - number, line, ":ho:", table, NULL)) != -1;)
        if (c == 'h') {
            snprintf(f->text, sizeof f->text, "%s", optarg ? optarg : "");
            return OPTIONS_HELP;
        } else {
            code = take_argument(&r, c, argc - number, line);
        }
    if (code == 0) {
        char **word = first_word(line, number);
        code = option_take_words(&r, (const char *const *)word, (size_t)(argv + argc - word));
    }
    return code ? code : option_end(&r);
}
