/* host-tools/cmd/cmd_measure.c -- loft measure: lengths and boxes, nearest points, crossings,
 * joins; and the path beside
 * SPDX-License-Identifier: MIT
 *
 * Prints rows of fields that are separated by tabs. The first line starts with `#` and names the
 * fields. A curve is printed as FILE:LINE.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cmd/commands.h"
#include "num/status.h"     /* LOFT_SINGULAR */

#include "base/say.h"
#include "geometry/element.h"
#include "geometry/print.h"   /* print_words */
#include "geometry/stretches.h"
#include "base/source.h"    /* source_name */
#include "cmd/measure_surface.h"
#include "readers.h"

#define NO_TOL "give --tol above 0"
#define FINE 0.01           /* of the tolerance, for cubics that replace other curves */

typedef struct {
    print_options p;
    elements list;
    double tol, at[ENGINE_AXES], distance;
} measuring;

static void print_name(const element *x) { (void)say(stdout, "%s:%u", x->file, x->of->line); }

/* Print coordinates as separate fields. */
static void print_fields(const measuring *m, const double point[ENGINE_AXES])
{
    for (int i = 0; i < (m->p.solid ? ENGINE_AXES : 2); i++) {
        putchar('\t');
        print_number(m->p.e, point[i]);
    }
}

static void print_value(const measuring *m, double x) { printf("\t%s", number_text(m->p.e, x)); }

static void print_place(const measuring *m, double t) { printf("\t%s", parameter_text(m->p.e, t)); }

/* `names` ends with the names of the coordinates. Those of `rest` follow. */
static void print_head(const measuring *m, const char *names, const char *prefix, const char *rest)
{
    printf("# %s", names);
    for (int i = 0; i < (m->p.solid ? ENGINE_AXES : 2); i++)
        printf("\t%s%c", prefix, "xyz"[i]);
    printf("%s\n", rest);
}

/* The elements of one curve are first .. result - 1. */
static size_t curve_end(const elements *list, size_t first)
{
    size_t last = first;

    while (last < list->count && list->element[last].number == list->element[first].number)
        last++;
    return last;
}


// Lengths and boxes
// -----------------

typedef struct {
    const measuring *m;
    double sum, tol;
    int status;
} summing;

static void add_length(void *context, double p[4][CURVE_AXES])
{
    summing *s = context;
    double length = 0;

    if (s->status == 0)
        s->status = s->m->p.e->measure->length((const double (*)[CURVE_AXES])p, s->tol, &length);
    s->sum += length;
}

/* The part of the tolerance for cubics that replace an element. */
static double cubics_share(const measuring *m, const element *x)
{
    return fmax(FINE * m->tol, engine_finest(m->p.e, &x->p));
}

static void widen_box(double box[2][ENGINE_AXES], const double other[2][ENGINE_AXES], bool first)
{
    for (int i = 0; i < ENGINE_AXES; i++) {
        box[0][i] = first ? other[0][i] : fmin(box[0][i], other[0][i]);
        box[1][i] = first ? other[1][i] : fmax(box[1][i], other[1][i]);
    }
}

static void print_size(const measuring *m, const char *kind, double length,
                       const double box[2][ENGINE_AXES])
{
    printf("\t%s", kind);
    print_value(m, length);
    print_fields(m, box[0]);
    print_fields(m, box[1]);
    putchar('\n');
}

static int size_of_curve(const measuring *m, size_t first, size_t last, double *length,
                         double box[2][ENGINE_AXES])
{
    summing s = { m, 0, m->tol / (double)(last - first), 0 };

    for (size_t i = first; i < last; i++) {
        const element *x = &m->list.element[i];
        engine_shape shape;
        int status = m->p.e->piece->shape(&x->p, &shape);
        if (status == 0)
            status = m->p.e->piece->cubics(&x->p, cubics_share(m, x), add_length, &s);
        if (status != 0 || s.status != 0)
            return element_error(tool_host(), x, engine_status(status ? status : s.status, NO_TOL));
        widen_box(box, (const double (*)[ENGINE_AXES])shape.box, i == first);
    }
    *length = s.sum;
    return EX_OK;
}

static int print_sizes(const measuring *m)
{
    double all[2][ENGINE_AXES] = { { 0 } }, sum = 0;

    print_head(m, "curve\tkind\tlength_mm", "min_",
               m->p.solid ? "\tmax_x\tmax_y\tmax_z" : "\tmax_x\tmax_y");
    for (size_t first = 0, last; first < m->list.count; first = last) {
        double box[2][ENGINE_AXES], length = 0;
        last = curve_end(&m->list, first);
        const int code = size_of_curve(m, first, last, &length, box);
        if (code != EX_OK)
            return code;
        print_name(&m->list.element[first]);
        print_size(m, curve_name(m->list.element[first].of->kind), length,
                   (const double(*)[ENGINE_AXES])box);
        widen_box(all, (const double (*)[ENGINE_AXES])box, first == 0);
        sum += length;
    }
    fputs("all", stdout);
    print_size(m, "-", sum, (const double (*)[ENGINE_AXES])all);
    return EX_OK;
}


// Nearest points
// --------------

/* The nearest point of one curve, elements first .. last - 1. */
static int nearest_point(const measuring *m, size_t first, size_t last, engine_near *near)
{
    const element *x = m->list.element;
    const double range[2] = { x[first].from, x[last - 1].to };
    int code = EX_OK;
    reference r;

    const bool known = reference_init(&r, x[first].of);
    near->distance = HUGE_VAL;
    for (size_t i = first; i < last && code == EX_OK; i++) {
        engine_near n;
        const int status = m->p.e->measure->nearest(&x[i].p, m->at, m->tol / 2, &n);
        if (status != 0)
            code = element_error(tool_host(), &x[i], engine_status(status, NO_TOL));
        else if (known)
            element_settle(&x[i], &r, range, m->at, &n);
        if (code == EX_OK && n.distance < near->distance)
            *near = n;
    }
    reference_free(&r);
    return code;
}

static int print_nearest(const measuring *m)
{
    print_head(m, "curve\tkind\tt", "", "\tdistance_mm");
    for (size_t first = 0, last; first < m->list.count; first = last) {
        const element *x = &m->list.element[first];
        engine_near near;
        last = curve_end(&m->list, first);
        const int code = nearest_point(m, first, last, &near);
        if (code != EX_OK)
            return code;
        print_name(x);
        printf("\t%s", curve_name(x->of->kind));
        print_place(m, near.t);
        print_fields(m, near.point);
        print_value(m, near.distance);
        putchar('\n');
    }
    return EX_OK;
}


// Crossings
// ---------

static int compare_stretches(const void *a, const void *b)
{
    const stretch *x = a, *y = b;
    return (x->s[1] > y->s[1]) - (x->s[1] < y->s[1]);
}

/* Print the stretches of two curves in the order of the first curve. */
static void print_stretches(const measuring *m, const element *a, const element *b, stretches *list)
{
    if (list->count)
        qsort(list->row, list->count, sizeof *list->row, compare_stretches);
    for (size_t k = 0; k < list->count; k++) {
        const stretch *r = &list->row[k];
        print_name(a);
        for (int i = 0; i < 3; i++)
            print_place(m, r->s[i]);
        putchar('\t');
        print_name(b);
        for (int i = 0; i < 3; i++)
            print_place(m, r->t[i]);
        print_fields(m, r->point);
        print_value(m, r->distance);
        printf("\t%s\n", r->overlap ? "overlap" : "meet");
    }
    list->count = 0;
}

/* Compare two curves: elements first .. last - 1 and other .. end - 1. */
static int print_pair(const measuring *m, size_t first, size_t last, size_t other, size_t end,
                      stretches *found)
{
    const element *x = m->list.element;

    found->range[0] = x[last - 1].to - x[first].from;
    found->range[1] = x[end - 1].to - x[other].from;
    for (size_t i = first; i < last; i++)
        for (size_t j = other; j < end; j++) {
            const int code = stretches_meet(tool_host(), found, m->p.e, &x[i], &x[j], m->tol);
            if (code != EX_OK)
                return code;
        }
    print_stretches(m, &x[first], &x[other], found);
    return EX_OK;
}

static int print_meetings(const measuring *m)
{
    const elements *list = &m->list;
    stretches found = { 0 };
    int code = EX_OK;

    print_head(m, "first\ts_from\ts\ts_to\tsecond\tt_from\tt\tt_to", "", "\tdistance_mm\thow");
    for (size_t first = 0, last; first < list->count && code == EX_OK; first = last) {
        last = curve_end(list, first);
        for (size_t other = last, end; other < list->count && code == EX_OK; other = end) {
            end = curve_end(list, other);
            code = print_pair(m, first, last, other, end, &found);
        }
    }
    free(found.row);
    return code;
}


// Joins
// -----

/* The cubic that has the point and the first two derivatives of the piece at its end, or at its
 * start. */
static piece end_jet(const piece *whole, bool end)
{
    piece out = { .degree = 3 };
    double d[3][CURVE_AXES];
    const int sign = end ? -1 : 1;

    piece_eval(whole, end ? 1 : 0, d);
    for (unsigned k = 0; k < 4; k++)
        out.w[k] = 1;
    for (int i = 0; i < CURVE_AXES; i++) {
        const double p = d[0][i], arm = p + sign * d[1][i] / 3, next = d[2][i] / 6 + 2 * arm - p;
        out.p[end ? 3 : 0][i] = p;
        out.p[end ? 2 : 1][i] = arm;
        out.p[end ? 1 : 2][i] = next;
        out.p[end ? 0 : 3][i] = next;
    }
    return out;
}

/* Join polynomials of one degree directly; for others, use their derivatives at the joint. */
static int join_elements(const measuring *m, const element *a, const element *b, engine_joint *out)
{
    if (a->exact && b->exact && a->p.degree == b->p.degree && a->p.degree >= 1)
        return m->p.e->measure->join(&a->p, &b->p, m->tol, out);
    const piece first = end_jet(&a->whole, true), second = end_jet(&b->whole, false);
    return m->p.e->measure->join(&first, &second, m->tol, out);
}

static int print_joins(const measuring *m)
{
    printf("# first\tsecond\tC0\tC1\tC2\tG0\tG1\tG2\talpha\teta\n");
    for (size_t first = 0, last; first < m->list.count; first = last) {
        last = curve_end(&m->list, first);
        if (last == m->list.count)
            break;
        const element *a = &m->list.element[last - 1], *b = &m->list.element[last];
        engine_joint j;
        const int status = join_elements(m, a, b, &j);
        if (status != 0)
            return element_error(tool_host(), b, engine_status(status, NO_TOL));
        print_name(a);
        putchar('\t');
        print_name(b);
        for (int k = 0; k < 6; k++)
            printf("\t%d", k < 3 ? j.c[k] : j.g[k - 3]);
        print_value(m, j.alpha);
        print_value(m, j.eta);
        putchar('\n');
    }
    return EX_OK;
}


// The path beside
// ---------------

typedef struct {
    const measuring *m;
    double tol;
    int status;
} offsetting;

/* Spans that run backwards would cut into the curve. */
static void print_span(void *context, double p[4][ENGINE_AXES], bool behind)
{
    offsetting *o = context;

    if (behind)
        return;
    puts("bezier 3");
    for (int k = 0; k < 4; k++)
        print_point((print_options *)&o->m->p, p[k]);
}

static void offset_cubic(void *context, double p[4][CURVE_AXES])
{
    offsetting *o = context;
    const measuring *m = o->m;

    if (o->status == 0)
        o->status = m->p.e->measure->offset((const double(*)[CURVE_AXES])p, m->distance, o->tol,
                                            print_span, o);
}

static int print_offset(const measuring *m)
{
    size_t number = SIZE_MAX;

    for (size_t i = 0; i < m->list.count; i++) {
        const element *x = &m->list.element[i];
        const double share = cubics_share(m, x);
        offsetting o = { m, x->p.degree == 3 ? 0.9 * m->tol : fmin(0.9 * m->tol, m->tol - share),
                         0 };
        if (x->number != number) {
            printf("# %s mm to the %s of ", number_text(m->p.e, fabs(m->distance)),
                   m->distance < 0 ? "right" : "left");
            print_name(x);
            putchar('\n');
            number = x->number;
        }
        const int status = o.tol > 0 ? m->p.e->piece->cubics(&x->p, share, offset_cubic, &o)
                                     : LOFT_ERR_RANGE;
        if (o.status == 0)
            o.status = status;
        if (o.status != 0 && o.status != LOFT_SINGULAR)     /* a point has no offset */
            return element_error(tool_host(), x, engine_status(o.status, NO_TOL));
    }
    return EX_OK;
}


// The command
// -----------

static int read_files(measuring *m, curves all[], const char *const *file, size_t count,
                      const char *points)
{
    static const char *const none[] = { "-" };
    int code = 0;

    if (count == 0) {
        file  = none;
        count = 1;
    }
    for (size_t i = 0; i < count && code == 0; i++) {
        code = curves_read(tool_host(), &all[i], file[i], points);
        if (code == 0)
            code = elements_add(tool_host(), &m->list, m->p.e, &all[i],
                                points ? "--points" : source_name(file[i]), m->tol);
    }
    m->p.solid = m->list.solid;
    return code;
}

typedef struct {
    option_words files;
    const char *points;
    option_list nearest;
    bool intersect, joins;
    double offset, tol;
    const engine *e;
} measure_options;

static const option measure_rows[] = {
    { "nearest", OPTION_LIST(measure_options, nearest), .least = -1e6, .most = 1e6,
      .value = "X,Y[,Z]", .counts = "2|3", .remedy = "give x,y or x,y,z",
      .help = "the point of each curve that is nearest to this one" },
    { "intersect", OPTION_FLAG(measure_options, intersect),
      .help = "where the curves meet, each with each" },
    { "joins", OPTION_FLAG(measure_options, joins),
      .help = "how smoothly each curve continues the one before" },
    { "offset", OPTION_NUMBER(measure_options, offset), .least = -1e4, .most = 1e4, .unit = "mm",
      .help = "the path at this distance to the left (< 0: right), as .loft" },
    { "tol", OPTION_NUMBER(measure_options, tol), .least = 1e-9, .most = 1000, .unit = "mm",
      .standard = "0.001", .help = "within which all of it is" },
    { "points", OPTION_TEXT(measure_options, points), .value = "POINTS",
      .help = "the control points themselves: \"0,0 1,2 3,0\"" },
    ENGINE_ROW(measure_options, e, "q16", "number type"),
    { "files", OPTION_WORDS(measure_options, files), .most = 1e6, .value = "FILE" },
    OPTION_EXCLUDES("points", "files", NULL),
    OPTION_EXCLUDES("nearest", "intersect|joins|offset", "each has rows of its own"),
    OPTION_EXCLUDES("intersect", "joins|offset", "each has rows of its own"),
    OPTION_EXCLUDES("joins", "offset", "each has rows of its own"),
    { 0 }
};

static int print_measured(const measure_options *o, const measuring *m)
{
    return o->nearest.count                   ? print_nearest(m)
           : o->intersect                     ? print_meetings(m)
           : o->joins                         ? print_joins(m)
           : o->offset < 0 || o->offset > 0   ? print_offset(m)
                                            : print_sizes(m);
}

static int measure_curves(const measure_options *o)
{
    measuring m = { .p = { o->e, false }, .tol = o->tol, .distance = o->offset };
    const size_t files = o->files.count + 1;
    curves *all        = memset(tool_grow(NULL, files * sizeof *all), 0, files * sizeof *all);

    memcpy(m.at, o->nearest.value, o->nearest.count * sizeof m.at[0]);
    int code = read_files(&m, all, o->files.word, o->files.count, o->points);
    if (code == 0)
        code = print_measured(o, &m);
    elements_free(&m.list);
    for (size_t i = 0; i < files; i++)
        curves_free(&all[i]);
    free(all);
    return code;
}

static int run_measure(void *options)
{
    const measure_options *o = options;
    const bool path          = o->intersect || o->joins || o->offset < 0 || o->offset > 0;
    bool done                = false;
    int code                 = 0;

    if (o->files.count == 1)
        code = measure_surfaces(o->files.word[0], o->e, &o->nearest, o->tol, path, &done);
    return code != 0 || done ? code : measure_curves(o);
}

const command command_measure = {
    .name = "measure",
    .arguments = "[--nearest X,Y | --intersect | --joins | --offset MM] [FILE..|-]",
    .summary = "lengths, boxes, nearest points, crossings, joins, offsets",
    .detail =
        "A FILE is a drawing in SVG, curves of any kind (host-tools/LOFT.md), lines of eight\n"
        "numbers (a cubic each), or control points, one per line. Prints rows of fields that are\n"
        "separated by tabs; the first line, which starts with #, names them. A curve is called\n"
        "FILE:LINE, and its parameter is that of `loft eval`. Lengths and coordinates are in "
        "mm.\n\n"
        "Without an option: length and smallest box of each curve, and of all. --nearest: the\n"
        "point of each curve that is nearest to X,Y. Its distance is within the tolerance of the\n"
        "smallest distance, and there the distance has a minimum along the curve (for the centre\n"
        "of a circle any point is right). --intersect: where any two curves come within the\n"
        "tolerance: begin, closest place and end, on both curves, a row for each stretch; how:\n"
        "meet, or overlap if the curves stay together until one of them ends.\n"
        "--joins: 1 or 0 for C0 C1 C2 (derivatives, each last or first piece over 0..1) and G0 G1\n"
        "G2 (position, tangent, curvature) of each curve and the next; alpha and eta of G2.\n"
        "--offset: the path of a tool's centre beside the curves, in the plane of x and y, as\n"
        "cubics in .loft, which all commands read. Parts that would cut into the curve are left\n"
        "out; corners between curves are not joined. Curves with weights (for length and offset\n"
        "also curves above degree 3) are first converted to cubics within a hundredth of the\n"
        "tolerance, or within what the number type can hold.\n\n"
        "Of one FILE of surfaces with nets: the area of each within --tol mm^2, or with --nearest\n"
        "X,Y,Z the point, as `loft decide area` and `nearest` print them.\n",
    .options = measure_rows,
    .size = sizeof(measure_options),
    .run = run_measure,
};
