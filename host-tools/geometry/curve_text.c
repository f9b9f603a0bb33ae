/* host-tools/geometry/curve_text.c -- reads the text format of curves, .loft, as LOFT.md describes
 * it
 * SPDX-License-Identifier: MIT
 *
 * A line that starts with a word begins a curve, or gives its knots. A line that starts with a
 * number is a point. An error in a line is reported at once; an error of a whole curve is reported
 * for its first line, when the curve ends.
 */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "geometry/curve_text.h"
#include "base/host.h"
#include "base/text_lines.h"         /* lines_numbers, lines_wrong */
#include "base/scan.h"          /* scan_word */
#include "geometry/surface_text.h"  /* surface_begins */

#define TURNS_MAX 1000

typedef struct {
    curves *all;
    lines at;
    curve *now;             /* NULL before the first curve and between curves */
    bool counted;           /* its degree was given              */
} reading;

/* What follows the colon in a point line. */
enum behind { NOTHING, A_WEIGHT, A_PARAMETER, A_VECTOR, TWO_VECTORS, A_SLOPE, A_WAY };

typedef struct {
    const char *word;
    enum curve_kind kind;
    int (*head)(reading *r);    /* reads the rest of the first line */
    unsigned least;             /* points                                        */
    enum behind behind;
    const char *point;          /* the syntax of a point */
    bool exact;                 /* `least` points, and no more                   */
    int (*check)(const lines *at, curve *c);    /* a curve that is complete; NULL: nothing */
} row;


/* The library computes up to degree 9; a picture of a Bezier curve is drawn by the host. */
static unsigned most_degree(const reading *r, const curve *c)
{
    return r->all->drawn && !curve_has_knots(c) ? CURVE_DRAWN_MAX : CURVE_DEGREE_MAX;
}


// First lines
// -----------

static int head_bare(reading *r)
{
    return lines_numbers_alone(&r->at, NULL, 0) == 0
               ? 0
               : lines_wrong(&r->at, "curve.more-after-kind", "more after the kind",
                             "give its points on lines of their own");
}

static int head_degree(reading *r)
{
    double degree = -1;
    const bool least = r->now->kind != CURVE_BEZIER, knots = curve_has_knots(r->now);
    const unsigned most = most_degree(r, r->now);
    const int count = lines_numbers_alone(&r->at, &degree, 1);

    if (count < 0 || (count == 1 && (degree != floor(degree) || degree < least || degree > most))) {
        char remedy[96];
        snprintf(remedy, sizeof remedy, "give a whole number from %d to %u%s", least, most,
                 most < CURVE_DRAWN_MAX && !knots && degree > most && degree <= CURVE_DRAWN_MAX
                     ? "; only drawings take up to 32, as `loft plot`"
                     : "");
        return lines_wrong(&r->at, "curve.degree", "not a degree", remedy);
    }
    r->counted = count == 1;
    r->now->degree = r->counted ? (unsigned)degree : 0;
    if (!r->counted && knots)
        return lines_wrong(&r->at, "curve.degree-missing", "no degree",
                           "give it after the kind, as `bspline 3`");
    return 0;
}

static int head_fixed(reading *r)
{
    r->now->degree = curve_kinds[r->now->kind].degree;
    return head_bare(r);
}

static int head_tension(reading *r)
{
    r->now->degree = 3;
    if (lines_numbers_alone(&r->at, &r->now->tension, 1) < 0 || fabs(r->now->tension) > 60)
        return lines_wrong(&r->at, "curve.tension", "not a tension",
                           "give a number from -60 to 60, or nothing for 0 (Catmull-Rom)");
    return 0;
}

static int head_natural(reading *r)
{
    r->now->degree = 3;
    if (lines_word(&r->at, "chord"))
        r->now->kind = CURVE_CHORD;
    else if (scan_word(r->at.rest) > 0 && !lines_word(&r->at, "uniform"))
        return lines_wrong(&r->at, "curve.knot-spacing", "not a spacing of knots",
                           "give uniform or chord");
    return head_bare(r);
}

static int head_spline(reading *r)
{
    static const char *const word[CURVE_ENDS] = { "closed", "clamped", "not-a-knot", "through",
                                                  "slope" };
    curve *c = r->now;
    int ends = 0;

    while (ends < CURVE_ENDS && !lines_word(&r->at, word[ends]))
        ends++;
    if (ends == CURVE_ENDS)
        return lines_wrong(&r->at, "curve.spline-ends", "not the ends of a spline",
                           "give closed, clamped, not-a-knot, through or slope");
    c->degree = 3;
    c->ends   = (enum curve_ends)ends;
    c->chord  = !curve_hides_ends(c) && lines_word(&r->at, "chord");
    if (!c->chord && scan_word(r->at.rest) > 0 && !lines_word(&r->at, "uniform"))
        return lines_wrong(&r->at, "curve.knot-spacing", "not a spacing of knots",
                           curve_hides_ends(c) ? "give none: knots are uniform"
                                               : "give uniform or chord");
    return head_bare(r);
}

static int head_catmull(reading *r)
{
    r->now->degree = 3;
    r->now->tension = 0.5;
    if (lines_numbers_alone(&r->at, &r->now->tension, 1) < 0 ||
        !(r->now->tension >= 0 && r->now->tension <= 1))
        return lines_wrong(&r->at, "curve.catmull-power", "not a power of the chords",
                           "give 0 to 1, or nothing for 0.5 (centripetal)");
    return 0;
}

static int head_arc(reading *r)
{
    const bool left = lines_word(&r->at, "left");
    double turns = 1;

    if ((!left && !lines_word(&r->at, "right")) || lines_numbers_alone(&r->at, &turns, 1) < 0 ||
        turns != floor(turns) || turns < 1 || turns > TURNS_MAX)
        return lines_wrong(&r->at, "curve.arc", "not an arc",
                           "give the way it turns, `arc left` or `arc right`, and start, centre "
                           "and end as points");
    r->now->turns  = left ? (int)turns : -(int)turns;
    r->now->degree = 3;
    return 0;
}

// Whole curves
// ------------

/* Default knots: 0 .. 0 1 2 .. m .. m, so that the curve starts at its first point and ends at its
 * last. */
static int knots_of(curve *c)
{
    const unsigned pieces = c->count - c->degree;

    for (unsigned i = 0; c->knot_count < c->count + c->degree + 1; i++)
        curve_add_knot(c, i <= c->degree ? 0 : i - c->degree < pieces ? i - c->degree : pieces);
    return 0;
}

/* More equal knots would separate a point from the curve. */
static bool has_too_many_equal_knots(const curve *c)
{
    for (unsigned i = 0; i < c->count; i++)
        if (!(c->knot[i] < c->knot[i + c->degree + 1]))
            return true;
    return false;
}

static int check_knots(const lines *at, curve *c)
{
    char words[96];

    if (c->count <= c->degree) {
        snprintf(words, sizeof words, "degree %u with %u points", c->degree, c->count);
        return lines_wrong(at, "curve.degree-points", words, "give more points than the degree");
    }
    if (c->knot_count == 0)
        return knots_of(c);
    if (c->knot_count != c->count + c->degree + 1) {
        snprintf(words, sizeof words, "%u knots for %u points of degree %u", c->knot_count,
                 c->count, c->degree);
        return lines_wrong(at, "curve.knots-count", words,
                           "give as many as points + degree + 1, or none");
    }
    if (has_too_many_equal_knots(c))
        return lines_wrong(at, "curve.knots-equal", "too many equal knots",
                           "give each at most degree + 1 times");
    if (!(c->knot[c->degree] < c->knot[c->count]))
        return lines_wrong(at, "curve.knots-none", "knots that leave no curve",
                           "let those behind the first `degree` ascend");
    return 0;
}

static int check_parameters(const lines *at, curve *c)
{
    const double a = c->point[0].w, b = c->point[1].w, z = c->point[2].w;

    return a < b && b < z ? 0
                          : lines_wrong(at, "curve.parameters", "parameters that do not ascend",
                                        "give the three points in the order of their t");
}

/* As in the library: the distances of the ends from the centre may differ by the rounding of
 * numbers with few digits. */
static int check_radii(const lines *at, curve *c)
{
    const curve_point *p = c->point;
    const double first = hypot(p[0].p[0] - p[1].p[0], p[0].p[1] - p[1].p[1]),
                 last = hypot(p[2].p[0] - p[1].p[0], p[2].p[1] - p[1].p[1]);
    char words[96];

    if (first > 0 && fabs(first - last) <= first / 256)
        return 0;
    snprintf(words, sizeof words, "an arc whose ends are %.9g and %.9g mm from its centre", first,
             last);
    return lines_wrong(at, "curve.arc-radius", words,
                       "give start, centre and end so that both are the same");
}

/* Slopes belong to the ends of a clamped spline, and to no other point. */
static int check_slopes(const lines *at, curve *c)
{
    for (unsigned i = 0; i < c->count; i++) {
        const bool wanted = c->ends == CURVE_CLAMPED && (i == 0 || i + 1 == c->count);
        double *d = c->point[i].d[0];
        if (isnan(d[0]) && wanted)
            return lines_wrong(at, "curve.slope-missing",
                               "a clamped spline without a slope at an end",
                               "give its first and last point as `x y : dx dy`");
        if (!isnan(d[0]) && !wanted)
            return lines_wrong(at, "curve.slope-alone", "a slope at a point that takes none",
                               "give slopes at the ends of `spline clamped` only");
        d[0] = wanted ? d[0] : 0;
    }
    return 0;
}


// Kinds
// -----

static const row rows[] = {
    { "bezier", CURVE_BEZIER, head_degree, 1, NOTHING, "`x y` or `x y z`", false, NULL },
    { "line", CURVE_LINE, head_fixed, 2, NOTHING, "`x y` or `x y z`", false, NULL },
    { "rational", CURVE_RATIONAL, head_degree, 2, A_WEIGHT,
      "`x y : weight`, a weight of 1/256 to 256", false, NULL },
    { "parabola", CURVE_PARABOLA, head_fixed, 3, A_PARAMETER,
      "`x y : t`, the point that is reached at t", true, check_parameters },
    { "hermite3", CURVE_HERMITE3, head_fixed, 2, A_VECTOR,
      "`x y : dx dy`, with the first derivative", false, NULL },
    { "hermite5", CURVE_HERMITE5, head_fixed, 2, TWO_VECTORS,
      "`x y : dx dy : ddx ddy`, with both derivatives", false, NULL },
    { "cardinal", CURVE_CARDINAL, head_tension, 4, NOTHING, "`x y` or `x y z`", false, NULL },
    { "natural", CURVE_NATURAL, head_natural, 2, NOTHING, "`x y` or `x y z`", false, NULL },
    { "bspline", CURVE_BSPLINE, head_degree, 2, NOTHING, "`x y` or `x y z`", false, check_knots },
    { "nurbs", CURVE_NURBS, head_degree, 2, A_WEIGHT, "`x y : weight`, a weight of 1/256 to 256",
      false, check_knots },
    { "arc", CURVE_ARC, head_arc, 3, NOTHING, "`x y` or `x y z`: start, centre, end", true,
      check_radii },
    { "spline", CURVE_SPLINE, head_spline, 2, A_SLOPE,
      "`x y`, or at the ends of a clamped spline `x y : dx dy`", false, check_slopes },
    { "tcb", CURVE_TCB, head_fixed, 4, A_WAY,
      "`x y` or `x y : tension continuity bias`, each -2 to 2", false, NULL },
    { "catmull", CURVE_CATMULL, head_catmull, 4, NOTHING, "`x y` or `x y z`", false, NULL }
};
#define ROWS (sizeof rows / sizeof rows[0])

static const row *row_of_word(const char *text, int length)
{
    for (size_t i = 0; i < ROWS; i++)
        if ((int)strlen(rows[i].word) == length && strncmp(rows[i].word, text, (size_t)length) == 0)
            return &rows[i];
    return NULL;
}

static const row *row_of(const curve *c)
{
    for (size_t i = 0; i < ROWS; i++)
        if (rows[i].kind == (c->kind == CURVE_CHORD ? CURVE_NATURAL : c->kind))
            return &rows[i];
    return NULL;
}


// Points
// ------

/* Read `x y [z]`. Returns the number of axes, 0 if the text is something else. */
static int read_vector(reading *r, double out[CURVE_AXES])
{
    const int count = lines_vector(&r->at, out);

    r->all->solid |= count > 2;
    return count;
}

static bool read_scalar(reading *r, double *out) { return lines_numbers(&r->at, out, 1) == 1; }

/* A slope that is not given is not a number. */
static bool read_slope(reading *r, curve_point *p)
{
    p->d[0][0] = NAN;
    return !lines_colon(&r->at) || read_vector(r, p->d[0]) > 0;
}

static bool read_way(reading *r, curve_point *p)
{
    if (!lines_colon(&r->at))
        return true;
    for (int i = 0; i < 3; i++)
        if (!read_scalar(r, &p->d[0][i]) || !(fabs(p->d[0][i]) <= 2))
            return false;
    return true;
}

/* 0 and negative weights are for those that ask for them. */
static bool read_weight(reading *r, double *out)
{
    if (!lines_colon(&r->at))
        return true;
    if (r->all->any_weights && r->now->kind == CURVE_RATIONAL)
        return read_scalar(r, out) && fabs(*out) <= LINES_WEIGHT_MOST;
    return lines_weight(&r->at, out);
}

static bool what_is_behind(reading *r, enum behind behind, curve_point *p)
{
    switch (behind) {
    case NOTHING:     return true;
    case A_WEIGHT:    return read_weight(r, &p->w);
    case A_PARAMETER: return lines_colon(&r->at) && read_scalar(r, &p->w);
    case A_VECTOR:    return lines_colon(&r->at) && read_vector(r, p->d[0]) > 0;
    case A_SLOPE:     return read_slope(r, p);
    case A_WAY:       return read_way(r, p);
    case TWO_VECTORS:
        return lines_colon(&r->at) && read_vector(r, p->d[0]) > 0 && lines_colon(&r->at) &&
               read_vector(r, p->d[1]) > 0;
    }
    return false;
}

static unsigned most_points(const curve *c)
{
    return curve_has_knots(c) ? CURVE_HUNG_MAX : CURVE_POINTS_MAX;
}

static int point_line(reading *r)
{
    curve_point p = { .w = 1 };

    if (r->now == NULL)
        return lines_wrong(&r->at, "curve.point-alone", "a point of no curve",
                           "begin with a kind, as `bezier 3`");
    const row *kind = row_of(r->now);
    if (read_vector(r, p.p) == 0 || !what_is_behind(r, kind->behind, &p) || !lines_over(&r->at))
        return lines_wrong(&r->at, "curve.point", "not a point", kind->point);
    if (r->now->count == most_points(r->now))
        return lines_wrong(&r->at, "curve.too-many-points",
                           curve_has_knots(r->now) ? "more than 32000 points"
                                                   : "more than 4000000 points",
                           "begin another curve where this one ends");
    curve_add_point(r->now, &p);
    return 0;
}


// Curves
// ------

static int knot_line(reading *r)
{
    double knot;

    if (r->now == NULL || !curve_has_knots(r->now))
        return lines_wrong(&r->at, "curve.knots-alone", "knots of no B-spline",
                           "give them below `bspline` or `nurbs`");
    while (read_scalar(r, &knot)) {
        if (r->now->knot_count > CURVE_HUNG_MAX + CURVE_DEGREE_MAX)
            break;
        if (r->now->knot_count > 0 && knot < r->now->knot[r->now->knot_count - 1])
            return lines_wrong(&r->at, "curve.knots-descend", "knots that descend",
                               "give them in ascending order");
        curve_add_knot(r->now, knot);
    }
    return lines_over(&r->at) ? 0
                              : lines_wrong(&r->at, "curve.knot", "not a knot",
                                            "give numbers, as many as points + degree + 1");
}

/* The curve is complete: refuse what is not valid. */
static int end_curve(reading *r)
{
    const lines at = { .host = r->at.host, .file = r->at.file, .line = r->now ? r->now->line : 0 };
    curve *c = r->now;
    char words[96];

    r->now = NULL;
    if (c == NULL)
        return 0;
    const row *kind = row_of(c);
    const bool bezier = kind->head == head_degree && !curve_has_knots(c);
    if (bezier && !r->counted)
        c->degree = c->count > 0 ? c->count - 1 : 0;
    const unsigned least = bezier && r->counted   ? c->degree + 1
                           : curve_hides_ends(c) ? 4
                           : curve_is_closed(c)  ? 3
                                                 : kind->least;
    const unsigned most = bezier ? (r->counted ? c->degree + 1 : most_degree(r, c) + 1)
                          : kind->exact ? kind->least
                                        : most_points(c);
    if (c->count < least || c->count > most) {
        char remedy[32];
        snprintf(words, sizeof words, "%s with %u point%s", kind->word, c->count,
                 c->count == 1 ? "" : "s");
        snprintf(remedy, sizeof remedy, "give %s%u",
                 least == most      ? ""
                 : c->count < least ? "at least "
                                    : "at most ",
                 c->count < least ? least : most);
        return lines_wrong(&at, "curve.points-count", words, remedy);
    }
    return kind->check != NULL ? kind->check(&at, c) : 0;
}

/* "give bezier line .. tcb or catmull" */
static const char *list_kinds(char *out, size_t size)
{
    size_t used = (size_t)snprintf(out, size, "give");

    for (size_t i = 0; i < ROWS && used < size; i++)
        used += (size_t)snprintf(out + used, size - used, "%s %s", i == ROWS - 1 ? " or" : "",
                                 rows[i].word);
    return out;
}

static int word_line(reading *r)
{
    const int length = scan_word(r->at.rest);
    const row *kind  = row_of_word(r->at.rest, length);
    char words[64];

    if (lines_word(&r->at, "knots"))
        return knot_line(r);
    const int code = end_curve(r);
    if (code != 0)
        return code;
    if (kind == NULL) {
        char kinds[200];
        snprintf(words, sizeof words, "`%.*s` is not a kind of curve", length > 20 ? 20 : length,
                 r->at.rest);
        return lines_wrong(&r->at, "curve.kind", words,
                           surface_begins(r->at.rest) ? "surfaces go into a file of their own"
                                                      : list_kinds(kinds, sizeof kinds));
    }
    r->now     = curves_add(r->all, kind->kind, r->at.line);
    r->counted = false;
    lines_word(&r->at, kind->word);
    return kind->head(r);
}

static int read_line(void *context)
{
    reading *r = context;

    return isalpha((unsigned char)*r->at.rest) ? word_line(r) : point_line(r);
}

int curves_read_text(host *h, curves *all, const char *file, const char *text)
{
    reading r = { .all = all, .at = { .host = h, .file = file } };
    const int code = lines_read(&r.at, text, read_line, &r);

    return code ? code : end_curve(&r);
}

bool curves_is_text(const char *file, const char *text)
{
    const size_t length = strlen(file);

    if (length >= 5 && strcmp(file + length - 5, ".loft") == 0)
        return true;
    text = lines_start(text);
    return row_of_word(text, scan_word(text)) != NULL;
}
