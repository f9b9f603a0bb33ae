/* host-tools/base/option_put.c -- tables of options as JSON: all that they say
 * SPDX-License-Identifier: MIT
 */
#include <string.h>

#include "base/option.h"

static void put_text(FILE *out, const char *text)
{
    putc('"', out);
    for (; *text; text++) {
        const unsigned char c = (unsigned char)*text;
        if (c == '"' || c == '\\')
            fprintf(out, "\\%c", c);
        else if (c < ' ')
            fprintf(out, "\\u%04x", c);
        else
            putc(c, out);
    }
    putc('"', out);
}

void option_put_member(FILE *out, const char *name, const char *text)
{
    if (text == NULL || *text == '\0')
        return;
    fprintf(out, ", \"%s\": ", name);
    put_text(out, text);
}

static void put_choices(FILE *out, const char *choices)
{
    char word[80];

    fputs(", \"choices\": [", out);
    for (const char *c = choices; *c;) {
        const int size = (int)strcspn(c, "|");
        snprintf(word, sizeof word, "%.*s", size, c);
        fputs(c == choices ? "" : ", ", out);
        put_text(out, word);
        c += size + (c[size] == '|');
    }
    putc(']', out);
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

static void put_option(FILE *out, const option *o, const char *heading)
{
    const bool number = o->kind == OPTION_IS_NUMBER || o->kind == OPTION_IS_MAYBE ||
                        o->kind == OPTION_IS_INTEGER || o->kind == OPTION_IS_LIST;
    char value[80];

    fprintf(out, "{\"name\": \"%s\", \"kind\": \"%s\"", o->name, kind_name(o->kind));
    option_put_member(out, "value", option_value(o, value));
    option_put_member(out, "unit", o->unit);
    if (number || option_is_word(o))
        fprintf(out, ", \"least\": %.17g, \"most\": %.17g", o->least, o->most);
    if (o->choices != NULL)
        put_choices(out, o->choices);
    option_put_member(out, "counts", o->counts);
    option_put_member(out, "default", o->standard);
    option_put_member(out, "remedy", o->remedy);
    option_put_member(out, "help", o->help);
    option_put_member(out, "heading", heading);
    putc('}', out);
}

static void put_rule(FILE *out, const option *o)
{
    fprintf(out, "{\"kind\": \"%s\"", kind_name(o->kind));
    option_put_member(out, "when", o->when);
    option_put_member(out, "what", o->what);
    option_put_member(out, "why", o->help);
    putc('}', out);
}

void option_put_json(FILE *out, const option rows[], bool rules)
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
        fputs(between, out);
        if (rule)
            put_rule(out, o);
        else
            put_option(out, o, heading);
        between = ",\n  ";
    }
}
