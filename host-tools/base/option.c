/* host-tools/base/option.c -- options: texts into a struct, checked by its table
 * SPDX-License-Identifier: MIT
 */
#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sysexits.h>

#include "base/near.h"       /* near_try */
#include "base/option.h"



// Tables
// ------

static size_t add_rows(const option rows[], size_t base, option_at all[OPTIONS_MOST], size_t count)
{
    for (const option *o = rows; o->kind != OPTION_END && count < OPTIONS_MOST; o++)
        if (o->kind == OPTION_IS_GROUP)
            count = add_rows(o->group, base + o->offset, all, count);
        else
            all[count++] = (option_at){ o, base + o->offset };
    return count;
}

size_t option_all(const option rows[], option_at all[OPTIONS_MOST])
{
    return add_rows(rows, 0, all, 0);
}

bool option_is_word(const option *o)
{
    return o->kind == OPTION_IS_WORD || o->kind == OPTION_IS_WORDS;
}

bool option_is_named(const option *o) { return o->kind < OPTION_IS_WORD; }

static bool has_unit(const option *o, const char *unit)
{
    return o->unit != NULL && strcmp(o->unit, unit) == 0;
}

const char *option_value(const option *o, char out[80])
{
    const char *text = o->value               ? o->value
                       : o->choices           ? o->choices
                       : has_unit(o, "mm/s")  ? "SPEED"
                       : o->unit              ? o->unit
                                             : "";
    const bool upper = o->value == NULL && o->choices == NULL;
    size_t n = 0;

    for (; text[n] && n < 79; n++)
        out[n] = upper ? (char)toupper((unsigned char)text[n]) : text[n];
    out[n] = '\0';
    return out;
}

const char *option_help(const option *o, char out[400])
{
    const size_t end = strlen(o->help);

    if (o->standard == NULL || (end > 0 && o->help[end - 1] == ')'))
        snprintf(out, 400, "%s", o->help);
    else
        snprintf(out, 400, "%s (%s)", o->help, o->standard);
    return out;
}


// Faults
// ------

int option_wrong(option_reading *r, const char *name, const char *format, ...)
{
    va_list values;

    r->f->name = name;
    va_start(values, format);
    vsnprintf(r->f->text, sizeof r->f->text, format, values);
    va_end(values);
    return EX_USAGE;
}

const char *option_see(const option_reading *r, char out[80])
{
    if (r->self == NULL)
        return strcpy(out, "");
    snprintf(out, 80, ": see `loft %s --help`", r->self);
    return out;
}

int option_unknown(option_reading *r, const char *word)
{
    const bool dashed = strncmp(word, "--", 2) == 0;
    near_words near   = { .word = word + (dashed ? 2 : 0) };
    char meant[160], more[80];

    near.length = strcspn(near.word, "=");
    for (size_t i = 0; (dashed || r->self == NULL) && i < r->count; i++)
        if (option_is_named(r->all[i].row))
            near_try(&near, r->all[i].row->name);
    return option_wrong(r, "option.unknown", "%.*s is not an option%s%s%s%s", OPTION_SHOWN, word,
                        r->self ? " of " : "", r->self ? r->self : "",
                        near_text(&near, "--", meant), option_see(r, more));
}

static int number_refused(option_reading *r, const option *o, const char *text, const char *more)
{
    return option_wrong(r, "option.range", "--%s %.*s: give a number from %.9g to %.9g%s", o->name,
                        OPTION_SHOWN, text, o->least, o->most, more);
}


// Values
// ------

bool option_number_at(const char *text, double least, double most, double *out, char **end)
{
    const double value = strtod(text, end);

    if (*end == text || !(value >= least && value <= most))
        return false;
    *out = value;
    return true;
}

static int take_number(option_reading *r, const option *o, const char *text, double *out)
{
    char *end;

    if (!option_number_at(text, o->least, o->most, out, &end) || *end != '\0')
        return number_refused(r, o, text, "");
    return 0;
}

static int take_speed(option_reading *r, const option *o, const char *text, double *out)
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

    if (option_number_at(text, -HUGE_VAL, HUGE_VAL, &value, &end)) {
        end += strspn(end, " ");
        for (size_t i = 0; i < sizeof units / sizeof units[0]; i++)
            if (strcmp(end, units[i].unit) == 0 && value * units[i].factor >= o->least &&
                value * units[i].factor <= o->most) {
                *out = value * units[i].factor;
                return 0;
            }
    }
    return number_refused(r, o, text, " mm/s, as 20, 20mm/s or 1200mm/min");
}

static int take_integer(option_reading *r, const option *o, const char *text, unsigned *out)
{
    char *end;
    double value;

    if (!option_number_at(text, o->least, o->most, &value, &end) || *end != '\0' ||
        value != floor(value))
        return number_refused(r, o, text, ", a whole one");
    *out = (unsigned)value;
    return 0;
}

static int take_list(option_reading *r, const option *o, const char *text, option_list *list)
{
    for (char *end;; text = end + 1) {
        double value;
        if (!option_number_at(text, o->least, o->most, &value, &end) ||
            (*end != ',' && *end != '\0'))
            return number_refused(r, o, text, ", or several with commas between");
        if (list->count == OPTION_LIST_MAX)
            return option_wrong(r, "option.count", "--%s: give at most %d numbers", o->name,
                                OPTION_LIST_MAX);
        list->value[list->count++] = value;
        if (*end == '\0')
            return 0;
    }
}

/* The index of a word of "host|chip", or -1. */
static int choice_of(const char *choices, const char *word, size_t length)
{
    for (int i = 0; *choices; i++) {
        const size_t size = strcspn(choices, "|");
        if (size == length && strncmp(choices, word, size) == 0)
            return i;
        choices += size + (choices[size] == '|');
    }
    return -1;
}

/* "give a, b or c" */
static int choice_refused(option_reading *r, const option *o, const char *text)
{
    char words[200] = "";
    size_t n = 0;

    if (o->remedy != NULL)
        return option_wrong(r, "option.choice", "--%s %.*s: %s", o->name, OPTION_SHOWN, text,
                            o->remedy);
    for (const char *c = o->choices; *c && n < sizeof words - 5; c++) {
        const bool last = strchr(c + 1, '|') == NULL;
        if (*c == '|')
            n += (size_t)snprintf(words + n, sizeof words - n, last ? " or " : ", ");
        else
            words[n++] = *c;
    }
    words[n] = '\0';
    return option_wrong(r, "option.choice", "--%s %.*s: give %s", o->name, OPTION_SHOWN, text,
                        words);
}

static int take_choice(option_reading *r, const option *o, const char *text, void *out)
{
    const int at = choice_of(o->choices, text, strlen(text));

    if (at < 0)
        return choice_refused(r, o, text);
    memcpy(out, &at, sizeof at);
    return 0;
}

static int take_parsed(option_reading *r, const option *o, const char *text, void *out)
{
    if (o->parse(text, out))
        return 0;
    if (o->choices != NULL)
        return choice_refused(r, o, text);
    return option_wrong(r, "option.form", "--%s %.*s: %s", o->name, OPTION_SHOWN, text, o->remedy);
}

static int word_refused(option_reading *r, const option *o, const char *word)
{
    char more[80];

    if (o != NULL && o->remedy != NULL)
        return option_wrong(r, "option.words", "%.*s: %s%s", OPTION_SHOWN, word, o->remedy,
                            option_see(r, more));
    return option_wrong(r, "option.words", "%.*s: give one file%s", OPTION_SHOWN, word,
                        option_see(r, more));
}

static int take_value(option_reading *r, const option_at *at, const char *text)
{
    const option *o = at->row;
    void *out       = (char *)r->o + at->offset;

    switch (o->kind) {
    case OPTION_IS_FLAG: *(bool *)out = true; return 0;
    case OPTION_IS_MAYBE:
        *(double *)out = 0;
        return text == NULL ? 0 : take_number(r, o, text, out);
    case OPTION_IS_NUMBER:
        return has_unit(o, "mm/s") ? take_speed(r, o, text, out) : take_number(r, o, text, out);
    case OPTION_IS_INTEGER: return take_integer(r, o, text, out);
    case OPTION_IS_CHOICE:  return take_choice(r, o, text, out);
    case OPTION_IS_LIST:    return take_list(r, o, text, out);
    case OPTION_IS_PARSED:  return take_parsed(r, o, text, out);
    case OPTION_IS_TEXT:
        if (o->choices != NULL && choice_of(o->choices, text, strlen(text)) < 0)
            return choice_refused(r, o, text);
        *(const char **)out = text;
        return 0;
    case OPTION_IS_FILE:
    case OPTION_IS_FOLDER: *(const char **)out = text; return 0;
    case OPTION_IS_WORD:
        *(const char **)out = text;
        return o->choices && choice_of(o->choices, text, strlen(text)) < 0
                   ? word_refused(r, o, text)
                   : 0;
    default:                return 0;
    }
}

int option_take(option_reading *r, size_t row, const char *text)
{
    if (r->all[row].row->kind == OPTION_IS_LIST && !r->given[row])
        ((option_list *)((char *)r->o + r->all[row].offset))->count = 0;
    r->given[row] = true;
    return take_value(r, &r->all[row], text);
}


// Begin and end
// -------------

static void set_unset(const option_at *at, void *o)
{
    void *out       = (char *)o + at->offset;
    const int index = (int)at->row->unset;

    if (at->row->kind == OPTION_IS_NUMBER || at->row->kind == OPTION_IS_MAYBE)
        *(double *)out = at->row->unset;
    else if (at->row->kind == OPTION_IS_INTEGER)
        *(unsigned *)out = (unsigned)at->row->unset;
    else if (at->row->kind == OPTION_IS_CHOICE)
        memcpy(out, &index, sizeof index);
}

int option_begin(option_reading *r, const option rows[], void *o, option_fault *f)
{
    int code = 0;

    *r = (option_reading){ .o = o, .f = f };
    f->name    = NULL;
    f->text[0] = '\0';
    r->count = option_all(rows, r->all);
    for (size_t i = 0; i < r->count && code == 0; i++)
        if (r->all[i].row->standard == NULL)
            set_unset(&r->all[i], o);
        else
            code = take_value(r, &r->all[i], r->all[i].row->standard);
    return code;
}

/* Words go to the rows that take them, in order. */
int option_take_words(option_reading *r, const char *const *word, size_t count)
{
    const option *last = NULL;
    size_t at          = 0;

    for (size_t i = 0; i < r->count; i++) {
        const option *o = r->all[i].row;
        if (!option_is_word(o))
            continue;
        last = o;
        if (o->kind == OPTION_IS_WORD && at < count) {
            const int code = option_take(r, i, word[at++]);
            if (code != 0)
                return code;
        } else if (o->kind == OPTION_IS_WORDS && o->most > 0 && at < count) {
            option_words *out = (option_words *)((char *)r->o + r->all[i].offset);
            r->given[i]       = true;
            const size_t most = (size_t)o->most;
            *out = (option_words){ word + at, count - at < most ? count - at : most };
            at += out->count;
        }
    }
    return at < count ? word_refused(r, last, word[count - 1]) : 0;
}

static int word_missing(option_reading *r, const option *o)
{
    char name[80], more[80];

    return option_wrong(r, "option.words", "no %s: %s%s", option_value(o, name),
                        o->remedy ? o->remedy : "give one", option_see(r, more));
}

/* "1|2", "2n" */
static bool may_be(const char *counts, size_t count)
{
    for (char *end; *counts; counts = end + (*end == '|')) {
        const unsigned long n = strtoul(counts, &end, 10);
        if (*end == 'n' ? count % n == 0 : count == n)
            return true;
        end += *end == 'n';
    }
    return false;
}

static int check_count(option_reading *r, size_t i)
{
    const option *o         = r->all[i].row;
    const option_list *list = (const option_list *)((char *)r->o + r->all[i].offset);
    char name[80];

    if (o->counts == NULL || list->count == 0 || may_be(o->counts, list->count))
        return 0;
    if (o->remedy != NULL)
        return option_wrong(r, "option.count", "--%s: %zu number%s: %s", o->name, list->count,
                            list->count == 1 ? "" : "s", o->remedy);
    return option_wrong(r, "option.count", "--%s: %zu number%s: give %s", o->name, list->count,
                        list->count == 1 ? "" : "s", option_value(o, name));
}


// Rules
// -----

size_t option_row_named(const option_reading *r, const char *name, size_t length)
{
    for (size_t i = 0; i < r->count; i++) {
        const option *o = r->all[i].row;
        if (o->name != NULL && strlen(o->name) == length && strncmp(o->name, name, length) == 0)
            return i;
    }
    return r->count;
}

/* name, name=value */
static bool is_so(const option_reading *r, const char *term, size_t length)
{
    const size_t size = strcspn(term, "=|&"), i = option_row_named(r, term, size);
    const char *value = term + size + 1, *text;
    int now;

    if (i == r->count || size == length)
        return i < r->count && r->given[i];
    const void *at = (const char *)r->o + r->all[i].offset;
    if (r->all[i].row->kind == OPTION_IS_CHOICE) {
        memcpy(&now, at, sizeof now);
        return now == choice_of(r->all[i].row->choices, value, length - size - 1);
    }
    memcpy(&text, at, sizeof text);
    return text != NULL && strlen(text) == length - size - 1 &&
           strncmp(text, value, length - size - 1) == 0;
}

static bool holds(const option_reading *r, const char *term)
{
    for (;; term++) {
        const size_t length = strcspn(term, "|&");
        if (length > 0 && !is_so(r, term, length))
            return false;
        term += length;
        if (*term != '&')
            return true;
    }
}

/* The first term that is true, or NULL. */
static const char *which_holds(const option_reading *r, const char *terms)
{
    for (;; terms++) {
        if (holds(r, terms))
            return terms;
        terms += strcspn(terms, "|");
        if (*terms == '\0')
            return NULL;
    }
}

/* name, name=value: "FILE", "--plan chip"; if it is to be given, "--csv RATE". */
static void put_term(const option_reading *r, const char *term, bool wanted, char out[120])
{
    const int length = (int)strcspn(term, "|&"), size = (int)strcspn(term, "=|&");
    const option *o  = r->all[option_row_named(r, term, (size_t)size)].row;
    char value[80];

    option_value(o, value);
    if (size < length)
        snprintf(value, sizeof value, "%.*s", length - size - 1, term + size + 1);
    if (option_is_word(o))
        snprintf(out, 120, "%s%s%s", o->value, size < length ? " " : "",
                 size < length ? value : "");
    else
        snprintf(out, 120, "--%s%s%s", o->name, (wanted || size < length) && *value ? " " : "",
                 wanted || size < length ? value : "");
}

/* "--grbl and --dry-run"; of what is to be given all that would do, "--csv RATE or --spans". */
static const char *terms_text(const option_reading *r, const char *terms, bool wanted,
                              char out[400])
{
    const char *between = "";
    size_t n            = 0;
    char one[120];

    for (out[0] = '\0'; *terms && n < 300;) {
        put_term(r, terms, wanted, one);
        n += (size_t)snprintf(out + n, 400 - n, "%s%s", between, one);
        terms += strcspn(terms, "|&");
        between = *terms == '&' ? " and " : " or ";
        if (*terms == '\0' || (*terms == '|' && !wanted))
            break;
        terms++;
    }
    return out;
}

static int check_rule(option_reading *r, const option *rule)
{
    const char *one = which_holds(r, rule->when), *other = which_holds(r, rule->what);
    const char *why = rule->help ? rule->help : "", *because = *why ? ": " : "";
    const bool needs = rule->kind == OPTION_IS_NEEDS;
    char text[2][400];

    if (one == NULL || (other != NULL) == needs)
        return 0;
    (void)terms_text(r, one, false, text[0]);
    (void)terms_text(r, needs ? rule->what : other, needs && *one, text[1]);
    if (needs && *one == '\0')
        return option_wrong(r, "option.needs", "no %s: %s", text[1], why);
    if (needs)
        return option_wrong(r, "option.needs", "%s: give %s as well%s%s", text[0], text[1], because,
                            why);
    if (*rule->what == '\0')
        return option_wrong(r, "option.excludes", "%s: %s", text[0], why);
    return option_wrong(r, "option.excludes", "%s and %s: give one of them%s%s", text[0], text[1],
                        because, why);
}

int option_end(option_reading *r)
{
    int code = 0;

    for (size_t i = 0; i < r->count && code == 0; i++) {
        const option *o = r->all[i].row;
        if (o->kind == OPTION_IS_LIST)
            code = check_count(r, i);
        else if (option_is_word(o) && o->least > 0 && !r->given[i])
            code = word_missing(r, o);
        else if (o->kind == OPTION_IS_EXCLUDES || o->kind == OPTION_IS_NEEDS)
            code = check_rule(r, o);
    }
    return code;
}
