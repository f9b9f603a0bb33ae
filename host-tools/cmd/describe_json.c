/* host-tools/cmd/describe_json.c -- tables of options as JSON: all that they say
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cmd/describe_json.h"

static void put_text(const char *text)
{
    putchar('"');
    for (; *text; text++) {
        const unsigned char c = (unsigned char)*text;
        if (c == '"' || c == '\\')
            printf("\\%c", c);
        else if (c < ' ')
            printf("\\u%04x", c);
        else
            putchar(c);
    }
    putchar('"');
}

/* A member whose text may be missing. */
static void put_member(const char *name, const char *text)
{
    if (text == NULL || *text == '\0')
        return;
    printf(", \"%s\": ", name);
    put_text(text);
}

static void put_choices(const char *choices)
{
    char word[80];

    fputs(", \"choices\": [", stdout);
    for (const char *c = choices; *c;) {
        const int size = (int)strcspn(c, "|");
        snprintf(word, sizeof word, "%.*s", size, c);
        fputs(c == choices ? "" : ", ", stdout);
        put_text(word);
        c += size + (c[size] == '|');
    }
    putchar(']');
}

static const char *kind_name(enum option_kind kind)
{
    static const char *const names[] = {
        [OPTION_IS_FLAG] = "flag",       [OPTION_IS_NUMBER] = "number",
        [OPTION_IS_MAYBE] = "maybe",     [OPTION_IS_INTEGER] = "integer",
        [OPTION_IS_TEXT] = "text",       [OPTION_IS_FILE] = "file",
        [OPTION_IS_FOLDER] = "folder",   [OPTION_IS_CHOICE] = "choice",
        [OPTION_IS_LIST] = "list",       [OPTION_IS_PARSED] = "form",
        [OPTION_IS_WORD] = "word",       [OPTION_IS_WORDS] = "words",
        [OPTION_IS_EXCLUDES] = "excludes", [OPTION_IS_NEEDS] = "needs"
    };

    return names[kind];
}

static void put_option(const option *o, const char *heading)
{
    const bool number = o->kind == OPTION_IS_NUMBER || o->kind == OPTION_IS_MAYBE ||
                        o->kind == OPTION_IS_INTEGER || o->kind == OPTION_IS_LIST;
    char value[80];

    printf("{\"name\": \"%s\", \"kind\": \"%s\"", o->name, kind_name(o->kind));
    put_member("value", option_value(o, value));
    put_member("unit", o->unit);
    if (number || option_is_word(o))
        printf(", \"least\": %.17g, \"most\": %.17g", o->least, o->most);
    if (o->choices != NULL)
        put_choices(o->choices);
    put_member("counts", o->counts);
    put_member("default", o->standard);
    put_member("remedy", o->remedy);
    put_member("help", o->help);
    put_member("heading", heading);
    putchar('}');
}

static void put_rule(const option *o)
{
    printf("{\"kind\": \"%s\"", kind_name(o->kind));
    put_member("when", o->when);
    put_member("what", o->what);
    put_member("why", o->help);
    putchar('}');
}

/* The options, or the rules, with commas between. */
static void put_rows(const option rows[], bool rules)
{
    option_at all[OPTIONS_MOST];
    const size_t count  = option_all(rows, all);
    const char *between = "\n  ", *heading = NULL;

    for (size_t i = 0; i < count; i++) {
        const option *o = all[i].row;
        const bool rule = o->kind == OPTION_IS_EXCLUDES || o->kind == OPTION_IS_NEEDS;
        if (o->kind == OPTION_IS_HEADING)
            heading = o->help;
        if (rule != rules || o->kind == OPTION_IS_HEADING)
            continue;
        fputs(between, stdout);
        if (rule)
            put_rule(o);
        else
            put_option(o, heading);
        between = ",\n  ";
    }
}

void describe_json(const command *self, const option rows[])
{
    printf("{\"name\": \"%s\"", self->name);
    put_member("arguments", self->arguments);
    put_member("summary", self->summary);
    put_member("detail", self->detail);
    fputs(", \"options\": [", stdout);
    put_rows(rows, false);
    fputs("], \"rules\": [", stdout);
    put_rows(rows, true);
    fputs("]}", stdout);
}
