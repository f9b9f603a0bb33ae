/* host-tools/svg/svg_lines.c -- letters of single lines, for a pen: Hershey's fonts
 * SPDX-License-Identifier: MIT
 *
 * The files are those of Debian's hershey-fonts-data. Each line is a glyph: 5 characters for its
 * number, 3 for the count of pairs, then the pairs of characters, whose distance from R is a
 * coordinate. The first pair is the left and the right edge; " R" lifts the pen. The glyphs stand
 * for the characters from the space to ~. Letters of Latin 1 are made of theirs and of an accent.
 *   see  Hurt: fonts.doc of the Hershey distribution of 1986
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "svg/svg.h"

#define FOLDER "/usr/share/hershey-fonts"
#define FIRST  32
#define GLYPHS 95
#define BASE   9                /* of the unit below R: the baseline */
#define CAPS   21               /* the height of a capital letter */
#define UNIT   (0.7 / CAPS)     /* em: capitals of usual fonts have about 0.7 em */
#define USUAL  "futural"

struct svg_lines {
    char *text;                     /* the file */
    const char *glyph[GLYPHS];      /* in it, behind the number of pairs */
    int pairs[GLYPHS];
};

/* A file of a few kB, or NULL. */
static char *file_of(const char *name)
{
    char path[200];
    const char *folder = getenv("HERSHEY_FONTS_DIR");
    FILE *in;

    if (strchr(name, '/') != NULL || strlen(name) > 40)
        return NULL;
    snprintf(path, sizeof path, "%.140s/%s.jhf", folder ? folder : FOLDER, name);
    in = fopen(path, "r");
    if (in == NULL)
        return NULL;
    const size_t room = 1 << 20;
    char *text        = memory_grow(NULL, room);
    const size_t size = fread(text, 1, room - 1, in);
    text[size]        = '\0';
    fclose(in);
    return text;
}

static void find_glyphs(svg_lines *l)
{
    const char *at = l->text;

    for (int i = 0; i < GLYPHS && *at != '\0'; i++) {
        const size_t length = strcspn(at, "\r\n");
        char count[4]       = "";
        if (length >= 10)
            memcpy(count, at + 5, 3);
        const int pairs = atoi(count);
        if (pairs > 0 && 8 + 2 * (size_t)pairs <= length) {
            l->glyph[i] = at + 8;
            l->pairs[i] = pairs;
        }
        at += length;
        at += strspn(at, "\r\n");
    }
}

/* The font that --text line:NAME names. Returns false after one line. */
static bool open_lines(svg_reader *r)
{
    const char *colon = r->d->text ? strchr(r->d->text, ':') : NULL;
    const char *name  = colon ? colon + 1 : USUAL;
    char *text        = file_of(name);

    if (text == NULL)
        return svg_fail(r, "svg.no-font",
                        "--text line: no font \"%.40s\": install hershey-fonts-data, or name one "
                        "of its files, as rowmans",
                        name);
    r->lines       = memory_grow(NULL, sizeof *r->lines);
    *r->lines      = (svg_lines){ .text = text };
    find_glyphs(r->lines);
    return true;
}

void svg_lines_close(svg_lines *l)
{
    if (l != NULL)
        free(l->text);
    free(l);
}


// Letters
// -------

/* The letters from 0xC0 on without their accents, and the accents. */
static const char bare[]    = "AAAAAA.CEEEEIIII.NOOOOO.OUUUUY..aaaaaa.ceeeeiiii.nooooo.ouuuuy.y";
static const char accents[] = "`'^~:o.,`'^:`'^:.~`'^~:./`'^:'..`'^~:o.,`'^:`'^:.~`'^~:./`'^:'.:";

/* Lines of accents: x from the middle, y up from the top of the letter, in units; 99 lifts. */
static const signed char
    grave[] = { -3, 6, 1, 2 },
    acute[] = { 3, 6, -1, 2 }, circumflex[] = { -4, 2, 0, 6, 4, 2 },
    tilde[]      = { -5, 3, -3, 5, -1, 5, 1, 3, 3, 3, 5, 5 },
    diaeresis[]  = { -4, 4, -3, 5, -3, 4, -4, 4, 99, 0, 3, 4, 4, 5, 4, 4, 3, 4 },
    ring[] = { 0, 1, 2, 2, 3, 4, 2, 6, 0, 7, -2, 6, -3, 4, -2, 2, 0, 1 };

static void add_accent(svg_shaped *s, const signed char at[], size_t size, double middle,
                       double top)
{
    bool fresh = true;

    for (size_t i = 0; i + 1 < size; i += 2) {
        const double p[2] = { middle + at[i] * UNIT, top - at[i + 1] * UNIT };
        if (at[i] != 99)
            svg_shaped_part(s, fresh ? 'M' : 'L', p, 1);
        fresh = at[i] == 99;
    }
}

/* Below the baseline, or through the letter. */
static void add_tail(svg_shaped *s, char accent, double width, double top)
{
    const double cedilla[4][2] = { { width / 2, 0 },
                                   { width / 2 + 2 * UNIT, 3 * UNIT },
                                   { width / 2 + UNIT, 5 * UNIT },
                                   { width / 2 - 2 * UNIT, 5 * UNIT } };
    const double slash[2][2]   = { { width * 0.15, UNIT }, { width * 0.85, top - UNIT } };

    for (int k = 0; k < (accent == '/' ? 2 : 4); k++)
        svg_shaped_part(s, k ? 'L' : 'M', accent == '/' ? slash[k] : cedilla[k], 1);
}

static void add_strokes(const svg_lines *l, int which, svg_shaped *out)
{
    const char *at    = l->glyph[which];
    const double left = (at[0] - 'R') * UNIT;
    bool fresh        = true;

    for (int i = 1; i < l->pairs[which]; i++) {
        const char x = at[2 * i], y = at[2 * i + 1];
        const double p[2] = { (x - 'R') * UNIT - left, (y - 'R' - BASE) * UNIT };
        if (x == ' ')
            fresh = true;
        else {
            svg_shaped_part(out, fresh ? 'M' : 'L', p, 1);
            fresh = false;
        }
    }
    out->cluster[out->clusters - 1].advance += (at[1] - at[0]) * UNIT;
}

static void add_letter(const svg_lines *l, int base, char accent, svg_shaped *out)
{
    const double top = base >= 'a' ? -14 * UNIT : -CAPS * UNIT;

    add_strokes(l, base - FIRST, out);
    const double width = out->cluster[out->clusters - 1].advance;
    switch (accent) {
    case '`':  add_accent(out, grave, sizeof grave, width / 2, top);             break;
    case '\'': add_accent(out, acute, sizeof acute, width / 2, top);             break;
    case '^':  add_accent(out, circumflex, sizeof circumflex, width / 2, top);   break;
    case '~':  add_accent(out, tilde, sizeof tilde, width / 2, top);             break;
    case ':':  add_accent(out, diaeresis, sizeof diaeresis, width / 2, top);     break;
    case 'o':  add_accent(out, ring, sizeof ring, width / 2, top);               break;
    case ',':
    case '/':  add_tail(out, accent, width, top);                                break;
    default: break;
    }
}

/* A character, and what it is made of. Returns the number of its bytes. */
static size_t letter_of(const char *text, size_t length, int *base, char *accent)
{
    const unsigned char *at = (const unsigned char *)text;

    *accent = 0;
    *base   = at[0] < 0x80 ? at[0] : 0;
    if (at[0] < 0x80)
        return 1;
    if (length >= 2 && at[0] == 0xC3) {
        *accent = accents[at[1] & 63];
        *base   = bare[at[1] & 63] == '.' ? 0 : bare[at[1] & 63];
    } else if (length >= 2 && at[0] == 0xC2 && at[1] == 0xA0) {
        *base = ' ';
    } else if (length >= 3 && at[0] == 0xE2 && at[1] == 0x80) {     /* dashes and quotes */
        *base = at[2] <= 0x92   ? (at[2] >= 0x90 ? '-' : ' ')
                : at[2] <= 0x95 ? '-'
                : at[2] <= 0x9B ? (at[2] >= 0x98 ? '\'' : 0)
                : at[2] <= 0x9F ? '"'
                                : 0;
    }
    size_t bytes = 1;
    while (bytes < length && (at[bytes] & 0xC0) == 0x80)
        bytes++;
    return bytes;
}

static bool has_lines(const svg_lines *l, int base)
{
    return base >= FIRST && base < FIRST + GLYPHS && l->glyph[base - FIRST] != NULL;
}

/* Append the letters from byte `at` on that have no lines, as outlines. Returns how many bytes. */
static size_t add_others(svg_reader *r, const svg_span *span, const char *text, size_t at,
                         svg_shaped *out)
{
    svg_shaped other = { .cluster = NULL };
    size_t end       = at;
    int base         = 0;
    char accent;

    while (end < span->end) {
        const size_t bytes = letter_of(text + end, span->end - end, &base, &accent);
        if (has_lines(r->lines, base))
            break;
        end += bytes;
    }
    const svg_span part = { span->font, end - at };
    (void)svg_glyphs_shape(r, &part, 1, text + at, span->font->leftwards, &other);
    for (size_t k = 0; k < other.clusters; k++) {
        const svg_cluster *c = &other.cluster[k];
        svg_shaped_add(out, at + c->from, c->advance);
        for (size_t i = c->first; i < c->first + c->count; i++)
            svg_shaped_part(out, other.part[i].kind, other.part[i].p[0], 3);
    }
    out->outlined = true;
    out->missing  = out->missing || other.missing;
    out->pictured = out->pictured || other.pictured;
    svg_shaped_free(&other);
    return end - at;
}

svg_metrics svg_lines_metrics(void)
{
    return (svg_metrics){
        .ascent = 25 * UNIT, .descent = 7 * UNIT, .x_height = 14 * UNIT, .underline = 3 * UNIT
    };
}

bool svg_lines_shape(svg_reader *r, const svg_span *span, size_t from, const char *text,
                     svg_shaped *out)
{
    if (r->lines == NULL && !open_lines(r))
        return false;
    for (size_t i = from; i < span->end;) {
        int base;
        char accent;
        const size_t bytes = letter_of(text + i, span->end - i, &base, &accent);
        if (!has_lines(r->lines, base)) {
            i += add_others(r, span, text, i, out);
            continue;
        }
        svg_shaped_add(out, i, 0);
        out->cluster[out->clusters - 1].lines = true;
        add_letter(r->lines, base, accent, out);
        i += bytes;
    }
    return true;
}
