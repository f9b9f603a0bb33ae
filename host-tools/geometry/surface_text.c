/* host-tools/geometry/surface_text.c -- reads surfaces in the text format .loft, as LOFT.md
 * describes it
 * SPDX-License-Identifier: MIT
 *
 * A line that starts with a word begins a surface. A line that starts with a number is a point. An
 * error in a line is reported at once; an error of a whole surface is reported for its first line,
 * when the surface ends.
 */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "num/status.h"  /* enum loft_status */

#include "engine/engine_sided.h"    /* complete, cut */
#include "base/host.h"
#include "base/text_lines.h"             /* lines_numbers, lines_wrong */
#include "base/source.h"            /* source_read */
#include "base/tool.h"              /* tool_error, sysexits */
#include "base/scan.h"              /* scan_word */
#include "engine/sided.h"           /* sided_regular, sided_is_lattice */
#include "geometry/solid.h"           /* solid_faces */
#include "geometry/surface_text.h"
#include "geometry/surface_ends.h"      /* surface_end_knots, surface_end_domain */

typedef struct {
    surfaces *all;
    lines at;
    surface *now;           /* NULL before the first surface and between surfaces */
    bool counted;           /* its degree was given                         */
} reading;


// First lines
// -----------

static bool is_whole(double x, unsigned least, unsigned most)
{
    return x == floor(x) && x >= least && x <= most;
}

static bool is_degree(double x, unsigned least) { return is_whole(x, least, SURFACE_DEGREE_MAX); }

/* The library computes up to degree 9; a picture of higher ones is drawn by the host. */
static unsigned most_degree(const reading *r, const surface *s)
{
    return r->all->drawn && (s->kind == SURFACE_TENSOR || s->kind == SURFACE_TRIANGLE)
               ? SURFACE_DRAWN_MAX
               : SURFACE_DEGREE_MAX;
}

/* Say whether a picture may have them. */
static int wrong_degree(reading *r, const double degree[], int count, unsigned least, bool two)
{
    const unsigned most = most_degree(r, r->now);
    bool drawn = count > 0 && most < SURFACE_DRAWN_MAX &&
                 (r->now->kind == SURFACE_TENSOR || r->now->kind == SURFACE_TRIANGLE);
    char remedy[160];

    for (int k = 0; k < count; k++)
        drawn = drawn && is_whole(degree[k], 0, SURFACE_DRAWN_MAX);
    snprintf(remedy, sizeof remedy, "give %s from %u to %u, %s%s",
             two ? "two whole numbers" : "a whole number", least, most,
             two ? "that along u and that along v" : "or nothing: then the points are counted",
             drawn ? "; only `loft plot` takes up to 32" : "");
    return lines_wrong(&r->at, "surface.degree", two ? "not two degrees" : "not a degree", remedy);
}

static int head_degrees(reading *r, unsigned least)
{
    const unsigned most = most_degree(r, r->now);
    double degree[2];
    const int count = lines_numbers_alone(&r->at, degree, 2);

    if (count != 2 || !is_whole(degree[0], least, most) || !is_whole(degree[1], least, most))
        return wrong_degree(r, degree, count == 2 ? 2 : 0, least, true);
    r->now->m = (unsigned)degree[0];
    r->now->n = (unsigned)degree[1];
    return 0;
}

static int head_tensor(reading *r) { return head_degrees(r, 0); }

static int head_triangle(reading *r)
{
    double degree = 0;
    const int count = lines_numbers_alone(&r->at, &degree, 1);

    if (count < 0 || !is_whole(degree, 0, most_degree(r, r->now)))
        return wrong_degree(r, &degree, count, 0, false);
    r->counted = count == 1;
    r->now->m  = (unsigned)degree;
    return 0;
}

static int head_coons(reading *r)
{
    if (lines_word(&r->at, "slopes"))
        r->now->orders = 2;
    else if (lines_word(&r->at, "curvatures"))
        r->now->orders = 3;
    else if (isalpha((unsigned char)*r->at.rest))
        return lines_wrong(&r->at, "surface.coons-kind", "not a kind of Coons patch",
                           "give nothing, slopes or curvatures, and the two degrees");
    return head_degrees(r, 1);
}

static int head_bare(reading *r)
{
    return lines_numbers_alone(&r->at, NULL, 0) == 0
               ? 0
               : lines_wrong(&r->at, "surface.more-after-kind", "more after the kind",
                             "give its points on lines of their own");
}

static int head_radius(reading *r)
{
    if (lines_numbers_alone(&r->at, &r->now->radius, 1) != 1 || r->now->radius <= 0)
        return lines_wrong(&r->at, "surface.radius", "no radius",
                           "give it after the kind, as `sphere 20`, and the centre on the next "
                           "line, if it is not 0 0 0");
    return 0;
}

/* A number of sides and a degree: two whole numbers. */
static bool sides_and_degree(reading *r, unsigned most)
{
    double number[2];

    if (lines_numbers(&r->at, number, 2) != 2 || !is_degree(number[1], 1) ||
        number[0] != floor(number[0]) || number[0] < 3 || number[0] > most)
        return false;
    r->now->n = (unsigned)number[0];
    r->now->m = (unsigned)number[1];
    return true;
}

static int read_coordinates(reading *r)
{
    if (lines_word(&r->at, "meanvalue"))
        r->now->coordinates = COORDINATES_MEANVALUE;
    else if (lines_word(&r->at, "harmonic"))
        r->now->coordinates = COORDINATES_HARMONIC;
    else
        lines_word(&r->at, "wachspress");
    return lines_over(&r->at)
               ? 0
               : lines_wrong(&r->at, "surface.coordinates", "not a kind of coordinates",
                             "give wachspress, meanvalue, harmonic or nothing");
}

static int head_spatch(reading *r)
{
    if (!sides_and_degree(r, SURFACE_SIDES_MAX))
        return lines_wrong(&r->at, "surface.sides-depth", "not sides and depth",
                           "give two whole numbers, 3 to 8 sides and a depth of 1 to 9");
    return read_coordinates(r);
}

#define ROWS_MAX 1000

static int head_nurbs(reading *r)
{
    double x[4];
    surface *s = r->now;

    if (lines_numbers_alone(&r->at, x, 4) != 4 || !is_degree(x[0], 1) || !is_degree(x[1], 1) ||
        x[2] != floor(x[2]) || x[3] != floor(x[3]) || !(x[2] > x[0] && x[2] <= ROWS_MAX) ||
        !(x[3] > x[1] && x[3] <= ROWS_MAX))
        return lines_wrong(&r->at, "surface.rows", "not two degrees, rows and columns",
                           "give degrees of 1 to 9 along u and v, then more rows and columns than "
                           "the degrees, at most 1000");
    s->m = (unsigned)x[0];
    s->n = (unsigned)x[1];
    s->rows = (unsigned)x[2];
    s->columns = (unsigned)x[3];
    return 0;
}

static int head_gb(reading *r)
{
    if (!sides_and_degree(r, SURFACE_SIDES_MAX) || r->now->m < 3)
        return lines_wrong(&r->at, "surface.sides-degree", "not sides and degree",
                           "give two whole numbers, 3 to 8 sides and a degree of 3 to 9");
    r->now->split = lines_word(&r->at, "split");
    return read_coordinates(r);
}

static int head_basepoint(reading *r)
{
    double number[4];

    if (lines_numbers_alone(&r->at, number, 4) != 4 || !is_degree(number[0], 1))
        return lines_wrong(
            &r->at, "surface.cuts", "not a degree and three cuts",
            "give the degree, 1 to 9, and how much is cut off each corner, 0 for nothing");
    r->now->m = (unsigned)number[0];
    r->now->n = 3;
    for (int i = 0; i < 3; i++) {
        if (number[1 + i] != floor(number[1 + i]) || number[1 + i] < 0 ||
            !(number[1 + i] + number[1 + (i + 1) % 3] < number[0]))
            return lines_wrong(&r->at, "surface.cut", "not a cut",
                               "give whole numbers, any two of them together below the degree");
        r->now->cut[i] = (unsigned)number[1 + i];
        r->now->n += number[1 + i] > 0;
    }
    return 0;
}

static int head_zheng_ball(reading *r)
{
    if (!sides_and_degree(r, 6) || !lines_over(&r->at) || r->now->n == 4 || r->now->m < 2)
        return lines_wrong(&r->at, "surface.gb-sides", "not sides and degree",
                           "give 3, 5 or 6 sides and a degree of 2 to 9");
    return 0;
}

typedef struct {
    enum surface_kind kind;
    int (*head)(reading *r);
    bool weighted;
    const char *point;      /* the syntax of a point */
} row;

#define WEIGHTED true, "`x y z` or `x y z : weight`, a weight of 1/256 to 256"

static const row rows[] = {
    { SURFACE_TENSOR, head_tensor, WEIGHTED },
    { SURFACE_TRIANGLE, head_triangle, WEIGHTED },
    { SURFACE_COONS, head_coons, false, "`x y z`" },
    { SURFACE_BICUBIC, head_bare, false, "`x y z`" },
    { SURFACE_PN, head_bare, false, "`x y z : nx ny nz`, with the normal" },
    { SURFACE_SPHERE, head_radius, false, "`x y z`: the centre" },
    { SURFACE_OCTANT, head_radius, false, "`x y z`: the centre" },
    { SURFACE_GREGORY, head_bare, false, "`x y z`" },
    { SURFACE_NURBS, head_nurbs, WEIGHTED },
    { SURFACE_TETRA, head_triangle, false, "`x y z`" },
    { SURFACE_SPATCH, head_spatch, WEIGHTED },
    { SURFACE_TORIC, head_bare, true,
      "`x y z`, `x y z : weight` or `x y z : weight coefficient`, a weight of 1/256 to 256" },
    { SURFACE_BASEPOINT, head_basepoint, WEIGHTED },
    { SURFACE_RING, head_zheng_ball, false, "`x y z`" },
    { SURFACE_GB, head_gb, false, "`x y z`" }
};

static const row *row_of_word(const char *text)
{
    const size_t length = (size_t)scan_word(text);

    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++)
        if (strlen(surface_name(rows[i].kind)) == length &&
            strncmp(surface_name(rows[i].kind), text, length) == 0)
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

static bool what_is_behind(reading *r, surface_point *p)
{
    const bool colon = lines_colon(&r->at);

    if (r->now->kind == SURFACE_PN)
        return colon && lines_vector(&r->at, p->d) > 0;
    if (!colon)
        return true;
    r->now->rational = true;
    if (!row_of(r->now)->weighted || !lines_weight(&r->at, &p->w))
        return false;
    return r->now->kind != SURFACE_TORIC || lines_over(&r->at) ||
           (lines_numbers(&r->at, &p->c, 1) == 1 && p->c > 0 && p->c <= 32767);
}

static int point_line(reading *r)
{
    surface_point p = { .w = 1, .c = 1 };
    char words[64];

    if (r->now == NULL)
        return lines_wrong(&r->at, "surface.point-alone", "a point of no surface",
                           "begin with a kind, as `tensor 3 3`");
    if (r->now->kind == SURFACE_TORIC && !sided_is_lattice(r->now))
        return lines_wrong(&r->at, "surface.polygon-missing", "no polygon",
                           "give `domain x y x y ..` before the points: whole numbers of -32 to "
                           "32, convex, counterclockwise");
    if (lines_vector(&r->at, p.p) == 0 || !what_is_behind(r, &p) || !lines_over(&r->at))
        return lines_wrong(&r->at, "surface.point", "not a point", row_of(r->now)->point);
    surface highest = { .kind = r->now->kind, .m = most_degree(r, r->now) };
    const unsigned most = surface_points(r->counted ? r->now : &highest);
    if (r->now->count == most) {
        snprintf(words, sizeof words, "more than the %u point%s of this %s", most,
                 most == 1 ? "" : "s", surface_name(r->now->kind));
        return lines_wrong(&r->at, "surface.too-many-points", words,
                           "begin another surface, or give a higher degree");
    }
    surface_add_point(r->now, &p);
    return 0;
}

/* The vertices of the polygon of a patch with n sides. */
static int domain_line(reading *r)
{
    double x[2];
    int count;

    if (r->now == NULL || (r->now->kind != SURFACE_SPATCH && r->now->kind != SURFACE_GB &&
                           r->now->kind != SURFACE_TORIC))
        return lines_wrong(&r->at, "surface.domain-alone", "a polygon of no patch",
                           "give it below `spatch`, `gb` or `toric`");
    while ((count = lines_numbers(&r->at, x, 2)) == 2) {
        if (r->now->corners == SURFACE_SIDES_MAX)
            return lines_wrong(&r->at, "surface.domain-vertices", "more than 8 vertices",
                               "give 3 to 8 pairs of x and y");
        memcpy(r->now->domain[r->now->corners++], x, sizeof x);
    }
    if (count != 0 || !lines_over(&r->at))
        return lines_wrong(&r->at, "surface.domain-vertex", "not a vertex",
                           "give pairs of x and y");
    if (r->now->kind == SURFACE_TORIC)
        r->now->n = r->now->corners;
    return 0;
}


// Knots
// -----

static int knot_line(reading *r)
{
    const bool u = lines_word(&r->at, "u"), v = !u && lines_word(&r->at, "v");
    const unsigned along = v ? 1 : 0;
    surface *s = r->now;
    double knot;
    int count;

    if (s == NULL || s->kind != SURFACE_NURBS || (!u && !v))
        return lines_wrong(&r->at, "surface.knots-alone", "knots of no NURBS surface",
                           "give `knots u ..` and `knots v ..` below `nurbs-surface`");
    while ((count = lines_numbers(&r->at, &knot, 1)) == 1) {
        const unsigned held = s->knots[along];
        if (held > 0 && knot < s->knot[along][held - 1])
            return lines_wrong(&r->at, "surface.knots-descend", "knots that descend",
                               "give them in ascending order");
        if (held <= ROWS_MAX + SURFACE_DEGREE_MAX + 1)
            surface_add_knot(s, along, knot);
    }
    return count == 0 && lines_over(&r->at)
               ? 0
               : lines_wrong(&r->at, "surface.knot", "not a knot",
                             "give numbers: rows, or columns, + degree + 1");
}



// Surfaces
// --------

/* Take the degree of a triangle or tetrahedron from the number of its points; the next one if there
 * is none of so many. */
static void count_degree(surface *s)
{
    s->m = 0;
    while (surface_points(s) < s->count)
        s->m++;
}

/* The surface is complete: refuse what is not valid. */
static int end_surface(reading *r)
{
    const lines at = { .host = r->at.host, .file = r->at.file, .line = r->now ? r->now->line : 0 };
    surface *s = r->now;
    char words[64], remedy[64];
    const bool counted = r->counted;

    r->now = NULL;
    if (s == NULL)
        return 0;
    if ((s->kind == SURFACE_SPHERE || s->kind == SURFACE_OCTANT) && s->count == 0)
        surface_add_point(s, &(surface_point){ .w = 1, .c = 1 });
    if (!counted)
        count_degree(s);
    const int code = surface_is_sided(s)          ? surface_end_domain(&at, s)
                     : s->kind == SURFACE_NURBS ? surface_end_knots(&at, s)
                                                : 0;
    if (code == 0 && s->kind == SURFACE_GB && engine_sides_f64.complete(s) != 0)
        return lines_wrong(&at, "surface.net-too-far", "a net beyond +-32767 mm",
                           "make the part smaller");
    if (code != 0 || s->count == surface_points(s))
        return code;
    snprintf(words, sizeof words, "%s with %u point%s", surface_name(s->kind), s->count,
             s->count == 1 ? "" : "s");
    surface lower = *s;
    lower.m -= !counted && s->m > 0;
    const unsigned fewer = surface_points(&lower), points = surface_points(s);
    if (fewer < points)
        snprintf(remedy, sizeof remedy, "give %u or %u", fewer, points);
    else
        snprintf(remedy, sizeof remedy, "give %u", points);
    return lines_wrong(&at, "surface.points-count", words, remedy);
}

static int word_line(reading *r)
{
    const row *kind = row_of_word(r->at.rest);
    const int length = scan_word(r->at.rest);
    char words[64];

    if (lines_word(&r->at, "domain"))
        return domain_line(r);
    if (lines_word(&r->at, "knots"))
        return knot_line(r);
    const int code = end_surface(r);
    if (code != 0)
        return code;
    if (kind == NULL) {
        snprintf(words, sizeof words, "`%.*s` is not a kind of surface", length > 20 ? 20 : length,
                 r->at.rest);
        return lines_wrong(
            &r->at, "surface.kind", words,
            "give tensor triangle coons bicubic pn sphere octant gregory "
            "nurbs-surface tetra spatch toric basepoint ring or gb; curves go into a "
            "file of their own");
    }
    r->now     = surfaces_add(r->all, kind->kind, r->at.line);
    r->counted = true;
    lines_word(&r->at, surface_name(kind->kind));
    return kind->head(r);
}

static int read_line(void *context)
{
    reading *r = context;

    return isalpha((unsigned char)*r->at.rest) ? word_line(r) : point_line(r);
}

int surfaces_read_text(host *h, surfaces *all, const char *file, const char *text)
{
    reading r = { .all = all, .at = { .host = h, .file = file } };
    int code = lines_read(&r.at, text, read_line, &r);

    if (code == 0)
        code = end_surface(&r);
    if (code == 0 && !all->solids)
        solid_faces(all);
    return code;
}

int surfaces_read(host *h, surfaces *all, const char *file)
{
    size_t size;
    int code;
    char *text = source_read(h, file, &size, &code);

    if (text == NULL)
        return code;
    if (strlen(text) == size && surface_begins(lines_start(text)))
        code = surfaces_read_text(h, all, source_name(file), text);
    free(text);
    return code;
}

int surfaces_read_only(host *h, surfaces *all, const char *file)
{
    const int code = surfaces_read(h, all, file);

    if (code == 0 && all->count == 0)
        return host_error(h, EX_DATAERR, "surface.none", (host_place){ source_name(file), 0 },
                          "begin with tensor, triangle, coons, bicubic, pn, sphere, octant, "
                          "gregory, nurbs-surface, tetra, spatch, toric, basepoint, ring or gb",
                          "no surface in it");
    return code;
}
