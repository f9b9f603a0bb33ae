/* host-tools/cmd/cmd_compare.c -- loft compare: the error of a number type, as a number
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "num/status.h"     /* enum loft_status */

#include "engine/curve.h"
#include "engine/engine.h"
#include "engine/piece.h"
#include "engine/reference.h"
#include "base/source.h"         /* source_name */
#include "base/tool.h"

/* The largest error of one way to compute a curve in one number type. */
typedef struct {
    const reference *exact;         /* of the curve, rounded to the number type */
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

static void measure_point(comparison *m, long double t, const double got[ENGINE_AXES])
{
    long double want[ENGINE_AXES];
    double other[ENGINE_AXES];

    if (m->against == NULL)
        reference_eval(m->exact, t, want);
    else if (m->against->curve->eval(m->other, (double)t, other) != 0)
        return;
    for (int i = 0; i < ENGINE_AXES; i++) {
        const long double right = m->against ? (long double)other[i] : want[i];
        const double off = (double)fabsl((long double)got[i] - right) / m->unit;
        m->sum += off;
        m->count++;
        if (off > m->worst) {
            m->worst = off;
            m->t     = (double)t;
            m->axis  = i;
        }
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

static bool round_numbers(const engine *e, double x[], int count)
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
        fits = fits && round_numbers(e, p.p, CURVE_AXES) && round_numbers(e, p.d[0], CURVE_AXES) &&
               round_numbers(e, p.d[1], CURVE_AXES) && round_numbers(e, &p.w, 1);
        curve_add_point(held, &p);
    }
    for (unsigned i = 0; i < c->knot_count; i++) {
        double knot = c->knot[i];
        fits = fits && round_numbers(e, &knot, 1);
        curve_add_knot(held, knot);
    }
    return fits && round_numbers(e, &held->tension, 1);
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
    printf("%-4s %-5s %-5s %5zu %9.4f %9.4f %11.3e %.9g %c %s\n", e->name,
           m->against ? m->against->name : "exact", way, curve_number, m->worst,
           m->sum / (double)m->count, m->worst * m->unit, m->t, "xyz"[m->axis],
           curve_name(m->exact->c->kind));
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

static int compare_curve(const engine *e, const engine *against, const curve *c, uint32_t n,
                         size_t curve_number)
{
    engine_curve *held = NULL, *other = NULL;
    curves rounded = { 0 };
    reference exact = { 0 };
    int status = round_curve(e, c, &rounded) ? LOFT_OK : LOFT_ERR_RANGE;

    if (status == LOFT_OK && curve_pieces(&rounded.curve[0]) > UINT32_MAX / n)
        status = LOFT_ERR_RANGE;
    if (status == LOFT_OK && !reference_init(&exact, &rounded.curve[0]))
        status = LOFT_SINGULAR;
    if (status == LOFT_OK)
        status = e->curve->open(&rounded.curve[0], &held);
    if (status == LOFT_OK && against != NULL)
        status = against->curve->open(&rounded.curve[0], &other);
    if (status == LOFT_OK) {
        comparison m = { .exact = &exact,
                         .against = against,
                         .other = other,
                         .n = n,
                         .unit = unit_of(e, &rounded.curve[0]) };
        status = compare_ways(e, &m, held, curve_number);
    }
    if (held != NULL)
        e->curve->close(held);
    if (other != NULL)
        against->curve->close(other);
    reference_free(&exact);
    curves_free(&rounded);
    return status;
}

static int compare_curves(const engine *e, const engine *against, const curves *all, uint32_t n,
                          const char *file)
{
    for (size_t i = 0; i < all->count; i++) {
        const int status = compare_curve(e, against, &all->curve[i], n, i);
        if (status != 0)
            return tool_error(EX_DATAERR, "%s:%u: %s in %s: %s", file, all->curve[i].line,
                              curve_name(all->curve[i].kind), e->name, engine_status(status));
    }
    return EX_OK;
}

static int compare_types(const char *types, const engine *against, const curves *all, uint32_t n,
                         const char *file)
{
    char names[64];
    int code = EX_OK;

    if (strlen(types) >= sizeof names)
        return tool_error(EX_USAGE, "--num %s: give q16, f32, f64, or several with commas between",
                          types);
    strcpy(names, types);
    printf("# num than  way   curve worst_lsb  mean_lsb    worst_mm t axis kind\n");
    for (char *name = strtok(names, ","); name && code == EX_OK; name = strtok(NULL, ",")) {
        const engine *e = engine_find(name);
        code = e ? compare_curves(e, against, all, n, file)
                 : tool_error(EX_USAGE,
                              "--num %s: give q16, f32, f64, or several with commas between",
                              types);
    }
    return code;
}

static int run_compare(const tool_command *self, int argc, char **argv)
{
    const char *types = "q16,f32,f64", *than = "exact", *text = NULL;
    unsigned n        = 1024;
    curves all        = { 0 };
    const char *file;

    const tool_option options[] = {
        TOOL_TEXT("num", "TYPE,..", &types, "number types to measure (q16,f32,f64)"),
        TOOL_TEXT("against", "exact|q16|f32|f64", &than,
                  "what they are measured against: exact, q16, f32 or f64 (exact)"),
        TOOL_COUNT("n", "N", &n, 1, 1e8, "parameters per piece, j/N (1024)"),
        TOOL_TEXT("points", "POINTS", &text, "the control points themselves: \"0,0 1,2 3,0\""),
        TOOL_OPTIONS_END
    };
    int code = tool_file_options(self, options, argc, argv, &text, &file);
    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    const engine *against = engine_find(than);
    if (against == NULL && strcmp(than, "exact") != 0)
        return tool_error(EX_USAGE, "--against %s: give exact, q16, f32 or f64", than);

    code = curves_read(&all, file, text);
    if (code == 0)
        code = compare_types(types, against, &all, n, text ? "--points" : source_name(file));
    curves_free(&all);
    return code;
}

const tool_command command_compare = {
    "compare", "[--num TYPE,..] [FILE|-]",
    "the error of a number type, in LSB, and where it is worst",
    "For each curve and each way to compute it (eval: point by point, walk: forward\n"
    "differences) prints one line: the largest and the mean error in LSB (q16: 2^-16 mm;\n"
    "floats: of the largest coordinate), the largest in mm, its t and its axis. The input is\n"
    "rounded to the number type first, so this measures the arithmetic. Walks follow the\n"
    "Bezier pieces, so the rounding of the pieces counts. Arcs, whose pieces have a\n"
    "tolerance, are not walked.\n",
    run_compare
};
