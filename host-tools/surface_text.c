/* host-tools/surface_text.c -- surfaces in the text format .loft; LOFT.md says what it is
 * SPDX-License-Identifier: MIT
 *
 * A line that starts with a word begins a surface, one that starts with a number is a point of it. What is wrong with
 * a line is said at once, what is wrong with a whole surface at its first line, when it ends.
 */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "scan.h"       /* scan_numbers, scan_word */
#include "surface.h"
#include "tool.h"       /* tool_error, sysexits */

#define WEIGHT_LEAST (1 / 256.0)    /* of the library */
#define WEIGHT_MOST  256.0

typedef struct {
    surfaces *all;
    const char *file;
    unsigned line;
    const char *rest;       /* of the line                                  */
    surface *now;           /* NULL before the first                        */
    bool counted;           /* its degree was given                         */
} reading;

static int wrong(const reading *r, const char *what, const char *remedy)
{
    return tool_error(EX_DATAERR, "%s:%u: %s: %s", r->file, r->line, what, remedy);
}

static bool at_end(const reading *r)
{
    return *r->rest == '\0' || *r->rest == '\n' || *r->rest == '#';
}

/* Up to `most` finite numbers; their count, or -1. */
static int numbers(reading *r, double out[], int most)
{
    const int count = scan_numbers(&r->rest, out, most);

    for (int i = 0; i < count; i++) {
        if (!isfinite(out[i]))
            return -1;
        out[i] += 0.0;          /* no -0 */
    }
    return count;
}


// First lines
// -----------

static bool is_degree(double x, unsigned least)
{
    return x == floor(x) && x >= least && x <= SURFACE_DEGREE_MAX;
}

static int head_degrees(reading *r, unsigned least)
{
    double degree[2];

    if (numbers(r, degree, 2) != 2 || !at_end(r) || !is_degree(degree[0], least) || !is_degree(degree[1], least))
        return wrong(r, "not two degrees", least ? "give two whole numbers from 1 to 9, that along u and that along v"
                                                 : "give two whole numbers from 0 to 9, that along u and that along v");
    r->now->m = (unsigned)degree[0];
    r->now->n = (unsigned)degree[1];
    return 0;
}

static int head_tensor(reading *r) { return head_degrees(r, 0); }

static int head_triangle(reading *r)
{
    double degree = 0;
    const int count = numbers(r, &degree, 1);

    if (count < 0 || !at_end(r) || !is_degree(degree, 0))
        return wrong(r, "not a degree", "give a whole number from 0 to 9, or nothing: then the points are counted");
    r->counted = count == 1;
    r->now->m  = (unsigned)degree;
    return 0;
}

static int head_coons(reading *r)
{
    const int length = scan_word(r->rest);

    if (length > 0 && isalpha((unsigned char)*r->rest)) {
        const bool slopes = length == 6 && strncmp(r->rest, "slopes", 6) == 0;
        if (!slopes && !(length == 10 && strncmp(r->rest, "curvatures", 10) == 0))
            return wrong(r, "not a kind of Coons patch", "give nothing, slopes or curvatures, and the two degrees");
        r->now->orders = slopes ? 2 : 3;
        r->rest += length;
    }
    return head_degrees(r, 1);
}

static int head_bare(reading *r)
{
    return numbers(r, NULL, 0) == 0 && at_end(r) ? 0 : wrong(r, "more behind the kind", "give its points on lines of their own");
}

static int head_radius(reading *r)
{
    if (numbers(r, &r->now->radius, 1) != 1 || !at_end(r) || r->now->radius <= 0)
        return wrong(r, "no radius", "give it behind the kind, as `sphere 20`, and the centre on the next line, if it is not 0 0 0");
    return 0;
}

typedef struct {
    enum surface_kind kind;
    int (*head)(reading *r);
    const char *point;      /* how a point is written */
} row;

static const row rows[] = {
    { SURFACE_TENSOR,   head_tensor,   "`x y z` or `x y z : weight`, a weight of 1/256 to 256" },
    { SURFACE_TRIANGLE, head_triangle, "`x y z` or `x y z : weight`, a weight of 1/256 to 256" },
    { SURFACE_COONS,    head_coons,    "`x y z`" },
    { SURFACE_BICUBIC,  head_bare,     "`x y z`" },
    { SURFACE_PN,       head_bare,     "`x y z : nx ny nz`, with the normal" },
    { SURFACE_SPHERE,   head_radius,   "`x y z`: the centre" },
    { SURFACE_OCTANT,   head_radius,   "`x y z`: the centre" }
};

static const row *row_of_word(const char *text)
{
    const size_t length = (size_t)scan_word(text);

    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++)
        if (strlen(surface_name(rows[i].kind)) == length && strncmp(surface_name(rows[i].kind), text, length) == 0)
            return &rows[i];
    return NULL;
}

static const row *row_of(const surface *s)
{
    const row *found = rows;

    while (found->kind != s->kind)
        found++;
    return found;
}

bool surface_begins(const char *word) { return row_of_word(word) != NULL; }


// Points
// ------

static bool vector(reading *r, double out[SURFACE_AXES])
{
    double number[SURFACE_AXES + 1];
    const int count = numbers(r, number, SURFACE_AXES + 1);

    for (int i = 0; i < SURFACE_AXES; i++)
        out[i] = i < count ? number[i] : 0;
    return count == 2 || count == 3;
}

static bool what_is_behind(reading *r, surface_point *p)
{
    const bool weighted = r->now->kind == SURFACE_TENSOR || r->now->kind == SURFACE_TRIANGLE, colon = *r->rest == ':';

    r->rest += colon;
    if (r->now->kind == SURFACE_PN)
        return colon && vector(r, p->d);
    if (!colon)
        return true;
    r->now->rational = true;
    return weighted && numbers(r, &p->w, 1) == 1 && p->w >= WEIGHT_LEAST && p->w <= WEIGHT_MOST;
}

static int point_line(reading *r)
{
    surface_point p = { .w = 1 };
    char words[64];

    if (r->now == NULL)
        return wrong(r, "a point of no surface", "begin with a kind, as `tensor 3 3`");
    if (!vector(r, p.p) || !what_is_behind(r, &p) || !at_end(r))
        return wrong(r, "not a point", row_of(r->now)->point);
    const unsigned most = r->now->kind == SURFACE_TRIANGLE && !r->counted ? 55 : surface_points(r->now);
    if (r->now->count == most) {
        snprintf(words, sizeof words, "more than the %u point%s of this %s", most, most == 1 ? "" : "s", surface_name(r->now->kind));
        return wrong(r, words, "begin another surface, or give a higher degree");
    }
    surface_add_point(r->now, &p);
    return 0;
}


// Surfaces
// --------

/* The degree of a triangle with so many points; 10 for none. */
static unsigned triangle_degree(unsigned count)
{
    unsigned m = 0;

    while (m <= SURFACE_DEGREE_MAX && (m + 1) * (m + 2) / 2 != count)
        m++;
    return m;
}

/* The surface is complete: is it one? */
static int end_surface(reading *r)
{
    const reading at = { .file = r->file, .line = r->now ? r->now->line : 0 };
    surface *s = r->now;
    char words[64], remedy[64];

    r->now = NULL;
    if (s == NULL)
        return 0;
    if ((s->kind == SURFACE_SPHERE || s->kind == SURFACE_OCTANT) && s->count == 0)
        surface_add_point(s, &(surface_point){ .w = 1 });
    if (s->kind == SURFACE_TRIANGLE && !r->counted)
        s->m = triangle_degree(s->count);
    if (s->m <= SURFACE_DEGREE_MAX && s->count == surface_points(s))
        return 0;
    snprintf(words, sizeof words, "%s with %u point%s", surface_name(s->kind), s->count, s->count == 1 ? "" : "s");
    snprintf(remedy, sizeof remedy, "give %u", surface_points(s));
    return wrong(&at, words, s->m > SURFACE_DEGREE_MAX ? "give 1, 3, 6, 10, 15, 21, 28, 36, 45 or 55" : remedy);
}

static int word_line(reading *r)
{
    const row *kind = row_of_word(r->rest);
    const int length = scan_word(r->rest), code = end_surface(r);
    char words[64];

    if (code != 0)
        return code;
    if (kind == NULL) {
        snprintf(words, sizeof words, "`%.*s` is no kind of surface", length > 20 ? 20 : length, r->rest);
        return wrong(r, words, "give tensor triangle coons bicubic pn sphere or octant; curves go into a file of their own");
    }
    r->now     = surfaces_add(r->all, kind->kind, r->line);
    r->counted = true;
    r->rest   += length;
    r->rest   += strspn(r->rest, " \t");
    return kind->head(r);
}

static int read_line(reading *r)
{
    r->rest += strspn(r->rest, " \t\r");
    if (at_end(r))
        return 0;
    return isalpha((unsigned char)*r->rest) ? word_line(r) : point_line(r);
}

int surfaces_read_text(surfaces *all, const char *file, const char *text)
{
    reading r = { .all = all, .file = file };
    int code = 0;

    if (strncmp(text, "\xEF\xBB\xBF", 3) == 0)
        text += 3;
    for (; *text != '\0' && code == 0; text += *text == '\n') {
        r.line++;
        r.rest = text;
        code = read_line(&r);
        text += strcspn(text, "\n");
    }
    return code ? code : end_surface(&r);
}
