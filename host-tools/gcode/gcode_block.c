/* host-tools/gcode/gcode_block.c
 * SPDX-License-Identifier: MIT
 *
 * The grammar is that of NIST RS274/NGC version 3 (section 3.3), with the comments of LinuxCNC and
 * grbl (from ; to the end of the line) and named parameters.
 */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/host.h"       /* host_error */
#include "gcode/gcode_number.h"

#define CODE_TOL 1e-4       /* of a number that must be a tenth */

int gcode_wrong(const gcode_block *b, const char *name, const char *what, const char *remedy)
{
    return host_error(b->host, EX_DATAERR, name, (host_place){ b->file, b->line }, remedy, "%s",
                      what);
}


// Words
// -----

/* The ) that closes a comment with comments in it, as Marlin takes it, or NULL. */
static const char *outer_end(const gcode_scanner *s)
{
    int depth = 1;

    for (const char *at = s->at; at < s->end; at++) {
        depth += *at == '(' ? 1 : *at == ')' ? -1 : 0;
        if (depth == 0)
            return at;
    }
    return NULL;
}

/* `(MSG,text)` is said; all other comments are left out. */
static void skip_comment(gcode_scanner *s)
{
    const char *from = s->at, *close = memchr(from, ')', (size_t)(s->end - from));
    const char *inner = close ? memchr(from, '(', (size_t)(close - from)) : NULL;

    if (inner != NULL && s->b->printer)
        close = outer_end(s);
    else if (inner != NULL)
        gcode_scan_fail(s, "gcode.comment-nested", "( in a comment",
                        "comments do not nest: write [ ] within");
    if (close == NULL) {
        gcode_scan_fail(s, "gcode.comment-open", "( without )", "close the comment");
        s->at = s->end;
        return;
    }
    if (gcode_take_word(s, "MSG,")) {
        s->b->say        = s->at;
        s->b->say_length = (size_t)(close - s->at);
    }
    s->at = close + 1;
}

static void read_setting(gcode_scanner *s)
{
    char name[GCODE_NAME_MAX] = "";
    const int n = gcode_read_parameter(s, name);

    if (!gcode_take(s, '='))
        gcode_scan_fail(s, "gcode.parameter-no-value", "# without =",
                        "set a parameter as #5 = 2, or use it behind a letter, as X#5");
    const double value = gcode_read_value(s);
    if (s->sets == GCODE_SETTINGS)
        gcode_scan_fail(s, "gcode.parameters-in-line", "more than 16 parameters set in a line",
                        "split the line");
    if (s->code != 0)
        return;
    s->set[s->sets].number = n;
    s->set[s->sets].value  = value;
    memcpy(s->set[s->sets].name, name, sizeof name);
    s->sets++;
}

static void apply_settings(gcode_scanner *s)
{
    for (unsigned i = 0; i < s->sets && s->code == 0; i++) {
        gcode_parameters *all = s->b->at;
        gcode_named *named    = NULL;
        if (s->set[i].number >= 0) {
            all->number[s->set[i].number] = s->set[i].value;
            continue;
        }
        double live;
        if (gcode_live_name(s->b->of, s->set[i].name, &live)) {
            gcode_scan_fail(s, "gcode.parameter-read-only", "a parameter that only tells",
                            "take another name");
            return;
        }
        named = gcode_find_named(s->b, s->set[i].name);
        if (named == NULL && all->count == GCODE_NAMED) {
            gcode_scan_fail(s, "gcode.parameters-named", "more than 1024 named parameters",
                            "use numbers: #1 to #5602");
            return;
        }
        if (named == NULL) {
            named = &all->named[all->count++];
            memcpy(named->name, s->set[i].name, sizeof named->name);
            named->depth = *named->name == '_' ? 0 : all->depth;
        }
        named->value = s->set[i].value;
    }
}

static void add_code(gcode_scanner *s, char letter, double value)
{
    const double tenths = floor(10 * value + 0.5);
    short *list         = letter == 'G' ? s->b->g : s->b->m;
    unsigned *count     = letter == 'G' ? &s->b->gs : &s->b->ms;
    char what[64];

    if (!(fabs(10 * value - tenths) <= 10 * CODE_TOL) || tenths < 0 || tenths > 9999 ||
        (letter == 'M' && fmod(tenths, 10) > 0 && !s->b->printer)) {
        snprintf(what, sizeof what, "%c%.10g: no such code", letter, value);
        gcode_scan_fail(s, "gcode.code-unknown", what, "leave it out, or correct it");
    } else if (*count == GCODE_CODES) {
        snprintf(what, sizeof what, "more than 16 %c words in a line", letter);
        gcode_scan_fail(s, "gcode.words-in-line", what, "split the line");
    } else {
        list[(*count)++] = (short)tenths;
    }
}

static void read_word(gcode_scanner *s, char letter)
{
    const double value = gcode_read_value(s);
    char what[32];

    if (s->code != 0)
        return;
    if (letter == 'G' || letter == 'M') {
        add_code(s, letter, value);
        return;
    }
    if (gcode_has(s->b, letter)) {
        snprintf(what, sizeof what, "%c twice in a line", GCODE_SHOWN(letter));
        gcode_scan_fail(s, "gcode.letter-twice", what, "leave one of them out");
        return;
    }
    s->b->has |= GCODE_BIT(letter);
    s->b->value[letter - 'A'] = value;
}

/* M words of a printer whose numbers this reader uses. The rest of a line with any other M word has
 * no meaning here: text for the display, the name of a file or of a part. */
static bool takes_text(const gcode_block *b)
{
    static const short codes[] = { 0, 10, 30, 40, 50, 60, 70, 80, 90 };

    if (!b->printer || b->ms == 0)
        return false;
    for (size_t i = 0; i < sizeof codes / sizeof codes[0]; i++)
        if (b->m[b->ms - 1] == codes[i])
            return false;
    return true;
}

static bool at_line_end(gcode_scanner *s, char c)
{
    return c == '\0' || c == ';' || (c == '*' && s->b->printer) || takes_text(s->b);
}

/* Behind M0 and M1 of a printer: P or S with numbers, then text for the display. */
static bool is_message(gcode_scanner *s, char letter)
{
    const gcode_block *b = s->b;
    const char next = s->at < s->end ? *s->at : '\0';

    return b->printer && b->ms > 0 && b->m[b->ms - 1] <= 10 &&
           !((letter == 'P' || letter == 'S') && next != '\0' && strchr("0123456789.", next));
}

static void take_message(gcode_scanner *s)
{
    const char *from = --s->at, *end = from;

    while (end < s->end && *end != ';' && *end != '\r')
        end++;
    s->b->say        = from;
    s->b->say_length = (size_t)(end - from);
    s->at = s->end;
}

/* Commands of a printer's firmware that are words, as Klipper's: they are left out and reported. */
static bool takes_command(gcode_scanner *s)
{
    gcode_block *b  = s->b;
    size_t n        = 0;
    const char *at  = s->at;
    const char next = at + 1 < s->end ? at[1] : '\0';

    if (!b->printer || b->gs + b->ms > 0 || (b->has & ~GCODE_BIT('N')) != 0 ||
        !((next >= 'A' && next <= 'Z') || (next >= 'a' && next <= 'z') || next == '_'))
        return false;
    while (at < s->end && n < sizeof b->unknown - 1 && (isalnum((unsigned char)*at) || *at == '_'))
        b->unknown[n++] = *at++;
    b->unknown[n] = '\0';
    s->at = s->end;
    return true;
}

/* A printer takes letters without numbers, as G28 X: they are 0. */
static bool stands_alone(gcode_scanner *s)
{
    const char c = gcode_peek(s);

    return s->b->printer &&
           (c == '\0' || c == ';' || c == '(' || c == '*' || (c >= 'A' && c <= 'Z'));
}

static void add_bare(gcode_block *b, char letter)
{
    b->has |= GCODE_BIT(letter);
    b->value[letter - 'A'] = 0;
}

/* O and a number, and nothing else in the line: the name of the program. */
static bool names_program(gcode_scanner *s)
{
    gcode_scanner ahead = *s;
    const char *begin;

    gcode_peek(&ahead);
    for (begin = ahead.at; gcode_peek(&ahead) >= '0' && *ahead.at <= '9';)
        ahead.at++;
    const char c    = gcode_peek(&ahead);
    const bool good = ahead.at > begin && (at_line_end(s, c) || c == '(') &&
                      (s->b->has & ~GCODE_BIT('N')) == 0 && s->b->gs + s->b->ms == 0;
    if (good)
        s->at = ahead.at;
    return good;
}

static void refuse_character(gcode_scanner *s, unsigned char c)
{
    char what[40];

    if (c == '*') {
        gcode_scan_fail(s, "gcode.checksum", "*: a checksum",
                        "for a 3-D printer's file give --dialect marlin");
        return;
    }

    if (c < 32 || c > 126)
        snprintf(what, sizeof what, "a character of code %u", (unsigned)c);
    else
        snprintf(what, sizeof what, "`%c`", c);
    gcode_scan_fail(s, "gcode.not-a-word", what, "is this G-code? a word is a letter and a number");
}

static void read_words(gcode_scanner *s)
{
    for (char c = gcode_peek(s); s->code == 0 && !at_line_end(s, c); c = gcode_peek(s)) {
        if (((c >= 'A' && c <= 'Z') || c == '_') && takes_command(s))
            return;
        s->at++;
        if (c == '(')
            skip_comment(s);
        else if (c >= 'A' && c <= 'Z' && is_message(s, c))
            take_message(s);
        else if (c == '#')
            read_setting(s);
        else if (c == 'O' && !names_program(s))
            gcode_scan_fail(s, "gcode.label-misplaced", "O behind other words, or without a number",
                            "begin the line with O100 sub, or the like");
        else if (c == 'O')
            continue;
        else if ((c == '@' || c == '^') && !s->b->printer)
            read_word(s, c == '@' ? GCODE_RADIUS : GCODE_ANGLE);
        else if (c >= 'A' && c <= 'Z' && stands_alone(s))
            add_bare(s->b, c);
        else if (c >= 'A' && c <= 'Z')
            read_word(s, c);
        else
            refuse_character(s, (unsigned char)c);
    }
}

int gcode_block_read(gcode_block *b, const char *text, size_t length)
{
    gcode_scanner s = { .b = b, .at = text, .end = text + length };

    b->has = 0;
    b->gs = b->ms = 0;
    b->say = NULL;
    b->percent = false;
    b->unknown[0] = '\0';
    if (length > GCODE_LINE_MAX)
        return gcode_wrong(b, "gcode.line-too-long", "a line of more than 65536 characters",
                           "is this G-code?");
    const char first = gcode_peek(&s);
    if (first == '%') {
        b->percent = true;
        return 0;
    }
    if (first == '/') {
        if (b->skip)
            return 0;
        s.at++;
    }
    read_words(&s);
    apply_settings(&s);
    return s.code;
}
