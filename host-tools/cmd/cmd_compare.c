/* host-tools/cmd/cmd_compare.c -- loft compare: the error of a number type, as a number
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cmd/commands.h"
#include "geometry/surface_text.h"
#include "num/status.h"     /* enum loft_status */

#include "cmd/compare.h"
#include "engine/curve.h"
#include "engine/engine.h"
#include "engine/piece.h"
#include "geometry/print.h"          /* parameter_text */
#include "geometry/reference.h"
#include "base/source.h"         /* source_name */
#include "readers.h"

/* The largest error of one way to compute a curve in one number type. */
typedef struct {
    const reference *exact;         /* of the curve, rounded to the number type */
    const reference *with;          /* of the other one, or NULL                     */
    long double with_from, with_to; /* its part                                      */
    const option_list *quadric;
    const engine *against;          /* NULL: exact, in long double                   */
    engine_curve *other;            /* the curve in `against`                        */
    uint32_t n, j;                  /* parameters per piece, parameters visited */
    double unit;                    /* 1 LSB of the curve in mm                      */
    double worst, sum;              /* LSB                                           */
    double t;
    int axis;
    size_t count;
    unsigned piece;                 /* the piece of the last parameter, and its range */
    long double from, to;
} comparison;

double compare_quadric(const option_list *q, const double p[ENGINE_AXES])
{
    const double *a = q->value, x = p[0], y = p[1], z = p[2];
    const double f = a[0] * x * x + a[1] * y * y + a[2] * z * z + a[3] * x * y + a[4] * y * z +
                     a[5] * z * x + a[6] * x + a[7] * y + a[8] * z + a[9],
                 fx = 2 * a[0] * x + a[3] * y + a[5] * z + a[6],
                 fy = 2 * a[1] * y + a[3] * x + a[4] * z + a[7],
                 fz = 2 * a[2] * z + a[4] * y + a[5] * x + a[8],
                 slope = sqrt(fx * fx + fy * fy + fz * fz);

    return slope > 0 ? fabs(f) / slope : f < 0 || f > 0 ? INFINITY : 0;
}

static void note(comparison *m, double off, long double t, int axis)
{
    m->sum += off;
    m->count++;
    if (off > m->worst) {
        m->worst = off;
        m->t     = (double)t;
        m->axis  = axis;
    }
}

static void measure_point(comparison *m, long double t, const double got[ENGINE_AXES])
{
    const curve *c = m->exact->c;
    long double want[ENGINE_AXES];
    double other[ENGINE_AXES];

    if (m->quadric != NULL) {
        note(m, compare_quadric(m->quadric, got) / m->unit, t, 3);
        return;
    }
    if (m->with != NULL) {
        const long double from = (long double)curve_from(c), to = (long double)curve_to(c);
        reference_eval(m->with,
                       m->with_from + (m->with_to - m->with_from) * (t - from) / (to - from), want);
    } else if (m->against == NULL)
        reference_eval(m->exact, t, want);
    else if (m->against->curve->eval(m->other, (double)t, other) != 0)
        return;
    for (int i = 0; i < ENGINE_AXES; i++) {
        const long double right = m->against ? (long double)other[i] : want[i];
        note(m, (double)fabsl((long double)got[i] - right) / m->unit, t, i);
    }
}

/* Parameter j of all, n per piece. Successive calls have ascending j. */
static long double parameter_of(comparison *m, uint32_t j)
{
    const unsigned i = (j - 1) / m->n;

    if (j == 1 || i != m->piece) {
        m->piece = i;
        m->from  = (long double)curve_break(m->exact->c, i);
        m->to    = (long double)curve_break(m->exact->c, i + 1);
    }
    return m->from + (m->to - m->from) * (long double)(j - i * m->n) / (long double)m->n;
}

static void take_point(void *context, const double point[ENGINE_AXES])
{
    comparison *m = context;

    m->j++;
    measure_point(m, parameter_of(m, m->j), point);
}

static int compare_eval(comparison *m, const engine *e, engine_curve *held)
{
    const uint32_t all = m->n * curve_pieces(m->exact->c);
    int status = 0;

    for (uint32_t j = 1; j <= all && status == 0; j++) {
        const long double t = parameter_of(m, j);
        double at[ENGINE_AXES];
        status = e->curve->eval(held, (double)t, at);
        if (status == 0)
            measure_point(m, t, at);
    }
    return status;
}

static int compare_walk(comparison *m, const engine *e, engine_curve *held)
{
    int status = 0;

    for (unsigned i = 0; i < e->curve->pieces(held) && status == 0; i++) {
        piece p;
        status = e->curve->piece(held, i, &p);
        if (status == 0)
            status = e->piece->walk(&p, m->n, take_point, m);
    }
    return status;
}


// Rounded to a number type
// ------------------------

bool compare_round(const engine *e, double x[], int count)
{
    for (int i = 0; i < count; i++)
        if (e->hold(x[i], &x[i]) != 0)
            return false;
    return true;
}

/* Copy the curve, rounded to the number type. Returns false if it does not fit. Free the copy in
 * either case. */
static bool round_curve(const engine *e, const curve *c, curves *out)
{
    curve *held = curves_add(out, c->kind, c->line);
    bool fits   = true;

    *held = *c;
    held->point = NULL;
    held->knot  = NULL;
    held->count = held->knot_count = 0;
    for (unsigned i = 0; i < c->count; i++) {
        curve_point p = c->point[i];
        fits = fits && compare_round(e, p.p, CURVE_AXES) && compare_round(e, p.d[0], CURVE_AXES) &&
               compare_round(e, p.d[1], CURVE_AXES) && compare_round(e, &p.w, 1);
        curve_add_point(held, &p);
    }
    for (unsigned i = 0; i < c->knot_count; i++) {
        double knot = c->knot[i];
        fits = fits && compare_round(e, &knot, 1);
        curve_add_knot(held, knot);
    }
    return fits && compare_round(e, &held->tension, 1);
}

/* The LSB in mm: a constant, or that of the largest coordinate. */
static double unit_of(const engine *e, const curve *c)
{
    double largest = 0;

    for (unsigned k = 0; k < c->count; k++)
        for (int i = 0; i < CURVE_AXES; i++)
            largest = fmax(largest, fabs(c->point[k].p[i]));
    return e->fixed || largest < 1e-300 ? e->lsb : e->lsb * exp2(floor(log2(largest)));
}


// Tables
// ------

static void print_row(const engine *e, const comparison *m, const char *way, size_t curve_number)
{
    printf("%-4s %-7s %-5s %5zu %9.4f %9.4f %11.3e %s %c %s\n", e->name,
           m->quadric   ? "quadric"
           : m->with    ? "other"
           : m->against ? m->against->name
                        : "exact",
           way, curve_number, m->worst, m->sum / (double)m->count, m->worst * m->unit,
           parameter_text(e, m->t), "xyz-"[m->axis], curve_name(m->exact->c->kind));
}

static int compare_ways(const engine *e, comparison *m, engine_curve *held, size_t curve_number)
{
    static const struct {
        const char *name;
        int (*run)(comparison *, const engine *, engine_curve *);
    } ways[] = { { "eval", compare_eval }, { "walk", compare_walk } };
    int status = 0;

    for (size_t w = 0; w < sizeof ways / sizeof ways[0] && status == 0; w++) {
        comparison one = *m;
        if (ways[w].run == compare_walk &&
            (m->exact->c->degree > 5 || m->exact->c->kind == CURVE_ARC))
            continue;
        status = ways[w].run(&one, e, held);
        if (status == 0 && one.count > 0)
            print_row(e, &one, ways[w].name, curve_number);
    }
    return status;
}

/* What curve k is compared with: the same one of the other file, or a part of its first one. */
static int find_other(const engine *e, const compare_to *to, const curves *other, size_t k,
                      comparison *m, reference *with, curves *rounded)
{
    const size_t at = to->part.count > 0 ? 0 : k;

    if (at >= other->count || (to->part.count > 0 && k + 1 >= to->part.count))
        return LOFT_ERR_ARG;
    if (!round_curve(e, &other->curve[at], rounded))
        return LOFT_ERR_RANGE;
    if (!reference_init(with, &rounded->curve[0]))
        return LOFT_SINGULAR;
    m->with      = with;
    m->with_from = (long double)(to->part.count > 0 ? to->part.value[k] : curve_from(with->c));
    m->with_to   = (long double)(to->part.count > 0 ? to->part.value[k + 1] : curve_to(with->c));
    return LOFT_OK;
}

static int compare_curve(const engine *e, const compare_to *to, const curve *c,
                         const curves *others, size_t curve_number)
{
    engine_curve *held = NULL, *other = NULL;
    curves rounded = { 0 }, besides = { 0 };
    reference exact = { 0 }, with = { 0 };
    int status = round_curve(e, c, &rounded) ? LOFT_OK : LOFT_ERR_RANGE;
    comparison m = { .exact = &exact,
                     .against = to->than,
                     .quadric = to->quadric.count > 0 ? &to->quadric : NULL,
                     .n = to->n,
                     .unit = unit_of(e, &rounded.curve[0]) };

    if (status == LOFT_OK && curve_pieces(&rounded.curve[0]) > UINT32_MAX / to->n)
        status = LOFT_ERR_RANGE;
    if (status == LOFT_OK && !reference_init(&exact, &rounded.curve[0]))
        status = LOFT_SINGULAR;
    if (status == LOFT_OK && to->other)
        status = find_other(e, to, others, curve_number, &m, &with, &besides);
    if (status == LOFT_OK)
        status = e->curve->open(&rounded.curve[0], &held);
    if (status == LOFT_OK && to->than != NULL)
        status = to->than->curve->open(&rounded.curve[0], &other);
    m.other = other;
    if (status == LOFT_OK)
        status = compare_ways(e, &m, held, curve_number);
    if (held != NULL)
        e->curve->close(held);
    if (other != NULL)
        to->than->curve->close(other);
    reference_free(&exact);
    reference_free(&with);
    curves_free(&rounded);
    curves_free(&besides);
    return status;
}

/* Curves or surfaces, as both files hold. */
typedef struct {
    curves curve;
    surfaces surface;
} content;

static int compare_all(const engine *e, const compare_to *to, const content *all,
                       const content *other, const char *file)
{
    if (all->surface.count > 0)
        return compare_surfaces(e, to, &all->surface, &other->surface, file);
    for (size_t i = 0; i < all->curve.count; i++) {
        const curve *c   = &all->curve.curve[i];
        const int status = compare_curve(e, to, c, &other->curve, i);
        if (status == LOFT_ERR_ARG && to->other)
            return tool_error(EX_DATAERR,
                              "%s:%u: nothing in %s is its own: give as many curves, "
                              "or a --part for each",
                              file, c->line, to->other);
        if (status != 0)
            return tool_error(EX_DATAERR, "%s:%u: %s in %s: %s", file, c->line, curve_name(c->kind),
                              e->name, curve_status(c, status));
    }
    return EX_OK;
}

static int compare_types(const char *types, const compare_to *to, const content *all,
                         const content *other, const char *file)
{
    char names[64];
    int code = EX_OK;

    if (strlen(types) >= sizeof names)
        return tool_error(EX_USAGE, "--num %s: give q16, f32, f64, or several with commas between",
                          types);
    strcpy(names, types);
    printf("# num than    way   curve worst_lsb  mean_lsb    worst_mm t axis kind\n");
    for (char *name = strtok(names, ","); name && code == EX_OK; name = strtok(NULL, ",")) {
        const engine *e = engine_find(name);
        code = e ? compare_all(e, to, all, other, file)
                 : tool_error(EX_USAGE,
                              "--num %s: give q16, f32, f64, or several with commas between",
                              types);
    }
    return code;
}

static int read_content(content *out, const char *file, const char *text)
{
    int code = text ? 0 : surfaces_read(tool_host(), &out->surface, file);

    if (code == 0 && out->surface.count == 0)
        code = curves_read(tool_host(), &out->curve, file, text);
    return code;
}

static void free_content(content *c)
{
    curves_free(&c->curve);
    surfaces_free(&c->surface);
}

typedef struct {
    source_given from;
    const char *types, *with;
    int against;                /* 0: exact */
    option_list part, quadric;
    unsigned n;
} compare_options;

static const option compare_rows[] = {
    { "num", OPTION_TEXT(compare_options, types), .value = "TYPE,..", .standard = "q16,f32,f64",
      .help = "number types to measure" },
    { "against", OPTION_CHOICE(compare_options, against), .choices = "exact|q16|f32|f64",
      .standard = "exact", .help = "what they are measured against: exact, q16, f32 or f64" },
    { "with", OPTION_FILE(compare_options, with), .value = "FILE",
      .help = "or the curves or surfaces of this file, each in turn" },
    { "part", OPTION_LIST(compare_options, part), .least = -32768, .most = 32767, .value = "T,T,..",
      .help = "or these parts of its first one: see above" },
    { "quadric", OPTION_LIST(compare_options, quadric), .least = -1e9, .most = 1e9, .value = "A,..",
      .counts = "10", .remedy = "give 10, of xx yy zz xy yz zx x y z 1",
      .help = "or the quadric xx yy zz xy yz zx x y z 1" },
    { "n", OPTION_INTEGER(compare_options, n), .least = 1, .most = 1e8, .value = "N",
      .help = "parameters per piece, j/N (1024; of a surface 30)" },
    OPTION_GROUP(compare_options, from, source_rows),
    OPTION_EXCLUDES("against=q16|against=f32|against=f64", "with|quadric", NULL),
    OPTION_EXCLUDES("with", "quadric", NULL),
    { 0 }
};

static int run_compare(void *options)
{
    static const engine *const engines[] = { NULL, &engine_q16, &engine_f32, &engine_f64 };
    const compare_options *o             = options;
    content all = { 0 }, other = { 0 };
    compare_to to = { .than = engines[o->against],
                      .other = o->with,
                      .part = o->part,
                      .quadric = o->quadric,
                      .n = o->n };
    int code = read_content(&all, o->from.file, o->from.points);

    if (code == 0 && to.other != NULL)
        code = read_content(&other, to.other, NULL);
    if (to.n == 0)
        to.n = all.surface.count > 0 ? 30 : 1024;
    if (code == 0)
        code = compare_types(o->types, &to, &all, &other, source_given_name(&o->from));
    free_content(&all);
    free_content(&other);
    return code;
}

const command command_compare = {
    .name = "compare",
    .arguments = "[--num TYPE,..] [--with FILE] [FILE|-]",
    .summary = "the error of a number type, in LSB, and where it is worst",
    .detail =
        "For each curve and each way to compute it (eval: point by point, walk: forward\n"
        "differences) prints one line: the largest and the mean error in LSB (q16: 2^-16 mm;\n"
        "floats: of the largest coordinate), the largest in mm, its t and its axis. The input is\n"
        "rounded to the number type first, so this measures the arithmetic. Walks follow the\n"
        "Bezier pieces, so the rounding of the pieces counts. Arcs, whose pieces have a\n"
        "tolerance, are not walked.\n\n"
        "For each surface the same, on a grid; tensor products, triangles, bicubic and Coons "
        "patches\n"
        "and spheres have a definition, others are compared with f64. With --with each curve or\n"
        "surface is compared with that of another file at the same parameters. With --part curve "
        "k\n"
        "is the part T[k]..T[k+1] of the first one there; a surface has u,v of its corners (0,0) "
        "and\n"
        "(1,1), a triangle those of its three corners. With --quadric the distance from a conic,\n"
        "cylinder, sphere or another quadric is measured, to first order.\n",
    .options = compare_rows,
    .size = sizeof(compare_options),
    .run = run_compare,
};
