/* host-tools/read/surface_text.c -- reads surfaces in the text format .loft, as LOFT.md describes
 * it
 * SPDX-License-Identifier: MIT
 *
 * A line that starts with a word begins a surface. A line that starts with a number is a point. An
 * error in a line is reported at once; an error of a whole surface is reported for its first line,
 * when the surface ends.
 */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "num/status.h"  /* enum loft_status */

#include "engine/engine_sided.h"    /* complete, cut */
#include "base/lines.h"             /* lines_numbers, lines_wrong */
#include "base/scan.h"              /* scan_word */
#include "engine/sided.h"           /* sided_regular, sided_is_lattice */
#include "engine/solid.h"           /* solid_faces */
#include "engine/surface.h"

typedef struct {
    surfaces *all;
    lines at;
    surface *now;           /* NULL before the first surface and between surfaces */
    bool counted;           /* its degree was given                         */
} reading;


// First lines
// -----------

static bool is_degree(double x, unsigned least)
{
    return x == floor(x) && x >= least && x <= SURFACE_DEGREE_MAX;
}

static int head_degrees(reading *r, unsigned least)
{
    double degree[2];

    if (lines_numbers_alone(&r->at, degree, 2) != 2 || !is_degree(degree[0], least) ||
        !is_degree(degree[1], least))
        return lines_wrong(
            &r->at, "not two degrees",
            least ? "give two whole numbers from 1 to 9, that along u and that along v"
                  : "give two whole numbers from 0 to 9, that along u and that along v");
    r->now->m = (unsigned)degree[0];
    r->now->n = (unsigned)degree[1];
    return 0;
}

static int head_tensor(reading *r) { return head_degrees(r, 0); }

static int head_triangle(reading *r)
{
    double degree = 0;
    const int count = lines_numbers_alone(&r->at, &degree, 1);

    if (count < 0 || !is_degree(degree, 0))
        return lines_wrong(
            &r->at, "not a degree",
            "give a whole number from 0 to 9, or nothing: then the points are counted");
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
        return lines_wrong(&r->at, "not a kind of Coons patch",
                           "give nothing, slopes or curvatures, and the two degrees");
    return head_degrees(r, 1);
}

static int head_bare(reading *r)
{
    return lines_numbers_alone(&r->at, NULL, 0) == 0
               ? 0
               : lines_wrong(&r->at, "more after the kind",
                             "give its points on lines of their own");
}

static int head_radius(reading *r)
{
    if (lines_numbers_alone(&r->at, &r->now->radius, 1) != 1 || r->now->radius <= 0)
        return lines_wrong(&r->at, "no radius",
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
    return lines_over(&r->at) ? 0
                              : lines_wrong(&r->at, "not a kind of coordinates",
                                            "give wachspress, meanvalue, harmonic or nothing");
}

static int head_spatch(reading *r)
{
    if (!sides_and_degree(r, SURFACE_SIDES_MAX))
        return lines_wrong(&r->at, "not sides and depth",
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
        return lines_wrong(&r->at, "not two degrees, rows and columns",
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
        return lines_wrong(&r->at, "not sides and degree",
                           "give two whole numbers, 3 to 8 sides and a degree of 3 to 9");
    r->now->split = lines_word(&r->at, "split");
    return read_coordinates(r);
}

static int head_basepoint(reading *r)
{
    double number[4];

    if (lines_numbers_alone(&r->at, number, 4) != 4 || !is_degree(number[0], 1))
        return lines_wrong(
            &r->at, "not a degree and three cuts",
            "give the degree, 1 to 9, and how much is cut off each corner, 0 for nothing");
    r->now->m = (unsigned)number[0];
    r->now->n = 3;
    for (int i = 0; i < 3; i++) {
        if (number[1 + i] != floor(number[1 + i]) || number[1 + i] < 0 ||
            !(number[1 + i] + number[1 + (i + 1) % 3] < number[0]))
            return lines_wrong(&r->at, "not a cut",
                               "give whole numbers, any two of them together below the degree");
        r->now->cut[i] = (unsigned)number[1 + i];
        r->now->n += number[1 + i] > 0;
    }
    return 0;
}

static int head_zheng_ball(reading *r)
{
    if (!sides_and_degree(r, 6) || !lines_over(&r->at) || r->now->n == 4 || r->now->m < 2)
        return lines_wrong(&r->at, "not sides and degree",
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
        return lines_wrong(&r->at, "a point of no surface", "begin with a kind, as `tensor 3 3`");
    if (r->now->kind == SURFACE_TORIC && !sided_is_lattice(r->now))
        return lines_wrong(&r->at, "no polygon",
                           "give `domain x y x y ..` before the points: whole numbers of -32 to "
                           "32, convex, counterclockwise");
    if (lines_vector(&r->at, p.p) == 0 || !what_is_behind(r, &p) || !lines_over(&r->at))
        return lines_wrong(&r->at, "not a point", row_of(r->now)->point);
    const unsigned most = r->counted                       ? surface_points(r->now)
                          : r->now->kind == SURFACE_TRIANGLE ? 55
                                                             : 220;
    if (r->now->count == most) {
        snprintf(words, sizeof words, "more than the %u point%s of this %s", most,
                 most == 1 ? "" : "s", surface_name(r->now->kind));
        return lines_wrong(&r->at, words, "begin another surface, or give a higher degree");
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
        return lines_wrong(&r->at, "a polygon of no patch",
                           "give it below `spatch`, `gb` or `toric`");
    while ((count = lines_numbers(&r->at, x, 2)) == 2) {
        if (r->now->corners == SURFACE_SIDES_MAX)
            return lines_wrong(&r->at, "more than 8 vertices", "give 3 to 8 pairs of x and y");
        memcpy(r->now->domain[r->now->corners++], x, sizeof x);
    }
    if (count != 0 || !lines_over(&r->at))
        return lines_wrong(&r->at, "not a vertex", "give pairs of x and y");
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
        return lines_wrong(&r->at, "knots of no NURBS surface",
                           "give `knots u ..` and `knots v ..` below `nurbs-surface`");
    while ((count = lines_numbers(&r->at, &knot, 1)) == 1) {
        const unsigned held = s->knots[along];
        if (held > 0 && knot < s->knot[along][held - 1])
            return lines_wrong(&r->at, "knots that descend", "give them in ascending order");
        if (held <= ROWS_MAX + SURFACE_DEGREE_MAX + 1)
            surface_add_knot(s, along, knot);
    }
    return count == 0 && lines_over(&r->at)
               ? 0
               : lines_wrong(&r->at, "not a knot", "give numbers: rows, or columns, + degree + 1");
}

/* Without knots: 0 .. 0 1 2 .. m .. m, as for curves. */
static int end_knots(const lines *at, surface *s)
{
    char words[96];

    for (unsigned along = 0; along < 2; along++) {
        const unsigned degree = along ? s->n : s->m, points = along ? s->columns : s->rows,
                       pieces = points - degree, count = points + degree + 1;
        for (unsigned i = 0; i < count && s->knots[along] == i; i++)
            surface_add_knot(s, along, i <= degree ? 0 : i - degree < pieces ? i - degree : pieces);
        if (s->knots[along] != count) {
            snprintf(words, sizeof words, "%u knots %c for %u points of degree %u", s->knots[along],
                     along ? 'v' : 'u', points, degree);
            return lines_wrong(at, words, "give as many as points + degree + 1, or none");
        }
        const double *k = s->knot[along];
        for (unsigned i = 0; i < points; i++)
            if (!(k[i] < k[i + degree + 1]))
                return lines_wrong(at, "too many equal knots",
                                   "give each at most degree + 1 times");
        if (!(k[degree] < k[points]))
            return lines_wrong(at, "knots that leave no surface",
                               "let those behind the first `degree` ascend");
    }
    return 0;
}


// Surfaces
// --------

/* Take the degree of a triangle or tetrahedron from the number of its points; 10 if there is none
 * of so many. */
static void count_degree(surface *s)
{
    s->m = 0;
    while (s->m <= SURFACE_DEGREE_MAX && surface_points(s) != s->count)
        s->m++;
}

/* Sides are counted from 1: side k goes from vertex k to the next one. */
static int broken_domain(const lines *at, const surface *s, const unsigned side[2])
{
    const unsigned i = side[0], j = side[1], k = (j + 1) % s->n, n = (i + 1) % s->n;
    const double *a = s->domain[i], *b = s->domain[n], *c = s->domain[j], *d = s->domain[k];
    const double over = (b[0] - a[0]) * (d[1] - c[1]) - (b[1] - a[1]) * (d[0] - c[0]);
    const double share = ((c[0] - a[0]) * (d[1] - c[1]) - (c[1] - a[1]) * (d[0] - c[0])) / over;
    unsigned one = 0;
    char words[160];

    while (one < s->n &&
           memcmp(s->domain[one], s->domain[(one + 1) % s->n], sizeof *s->domain) != 0)
        one++;
    if (one < s->n)
        snprintf(words, sizeof words, "vertices %u and %u of the domain are one point, (%g, %g)",
                 one + 1, (one + 1) % s->n + 1, s->domain[one][0], s->domain[one][1]);
    else if (j == n)
        snprintf(words, sizeof words, "the domain folds back onto itself at vertex %u, (%g, %g)",
                 j + 1, c[0], c[1]);
    else if (over != 0)
        snprintf(words, sizeof words, "sides %u and %u of the domain meet at (%g, %g)", i + 1,
                 j + 1, a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]));
    else
        snprintf(words, sizeof words, "sides %u and %u of the domain lie on each other", i + 1,
                 j + 1);
    return lines_wrong(at, words, "list its vertices once around, so that no two sides touch");
}

/* Is the polygon valid, and valid for these coordinates? */
static int judge_domain(const lines *at, surface *s)
{
    unsigned where[2];
    char words[160];
    const int status = engine_sides_f64.cut(s, where);

    if (status == LOFT_SINGULAR)
        return broken_domain(at, s, where);
    if (status == LOFT_ERR_ARG)
        return lines_wrong(at, "the vertices of the domain run clockwise",
                           "list them counterclockwise, and the points of the net with them");
    const double *v = s->domain[where[0] % SURFACE_SIDES_MAX];
    if (status != LOFT_OK) {
        snprintf(words, sizeof words, "vertex %u of the domain, (%g, %g)", where[0] + 1, v[0],
                 v[1]);
        return lines_wrong(
            at, words, "give coordinates below 32768, of not more than 15 digits behind the point");
    }
    if (where[0] < s->n && s->coordinates == COORDINATES_WACHSPRESS) {
        snprintf(
            words, sizeof words,
            "the domain is not convex at vertex %u, (%g, %g), which Wachspress coordinates ask for",
            where[0] + 1, v[0], v[1]);
        return lines_wrong(at, words, "write meanvalue or harmonic behind the numbers");
    }
    return 0;
}

/* A patch with n sides has a polygon: the regular one if none was given. */
static int end_domain(const lines *at, surface *s)
{
    char words[64];

    if (s->kind == SURFACE_TORIC && !sided_is_lattice(s))
        return lines_wrong(at, "toric without a polygon",
                           "give `domain x y x y ..` below it: whole numbers of -32 to 32, convex, "
                           "counterclockwise");
    if (s->kind != SURFACE_TORIC && s->corners != 0 && s->corners != s->n) {
        snprintf(words, sizeof words, "%u sides over a domain of %u vertices", s->n, s->corners);
        return lines_wrong(at, words, "give as many, or none for a regular polygon");
    }
    if (s->corners == 0 && s->kind != SURFACE_BASEPOINT)
        sided_regular(s);
    return judge_domain(at, s);
}

/* The surface is complete: is it valid? */
static int end_surface(reading *r)
{
    const lines at = { .file = r->at.file, .line = r->now ? r->now->line : 0 };
    surface *s = r->now;
    char words[64], remedy[64];

    r->now = NULL;
    if (s == NULL)
        return 0;
    if ((s->kind == SURFACE_SPHERE || s->kind == SURFACE_OCTANT) && s->count == 0)
        surface_add_point(s, &(surface_point){ .w = 1, .c = 1 });
    if (!r->counted)
        count_degree(s);
    const int code = surface_is_sided(s)          ? end_domain(&at, s)
                     : s->kind == SURFACE_NURBS ? end_knots(&at, s)
                                                : 0;
    if (code == 0 && s->kind == SURFACE_GB && engine_sides_f64.complete(s) != 0)
        return lines_wrong(&at, "a net beyond +-32767 mm", "make the part smaller");
    if (code != 0 || (s->m <= SURFACE_DEGREE_MAX && s->count == surface_points(s)))
        return code;
    snprintf(words, sizeof words, "%s with %u point%s", surface_name(s->kind), s->count,
             s->count == 1 ? "" : "s");
    snprintf(remedy, sizeof remedy, "give %u", surface_points(s));
    return lines_wrong(&at, words,
                       s->m <= SURFACE_DEGREE_MAX    ? remedy
                       : s->kind == SURFACE_TRIANGLE ? "give 1, 3, 6, 10, 15, 21, 28, 36, 45 or 55"
                                                     : "give 1, 4, 10, 20, 35, 56, 84, 120, 165 or "
                                                       "220");
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
            &r->at, words,
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

int surfaces_read_text(surfaces *all, const char *file, const char *text)
{
    reading r = { .all = all, .at = { .file = file } };
    int code = lines_read(&r.at, text, read_line, &r);

    if (code == 0)
        code = end_surface(&r);
    if (code == 0 && !all->solids)
        solid_faces(all);
    return code;
}
