/* host-tools/cmd_compare.c -- loft compare: the error of a number type, as a number
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "points.h"     /* points_read */
#include "tool.h"

/* The worst that was seen of one operation in one number type. */
typedef struct {
    const engine *e, *against;      /* against NULL: exact, in long double */
    const points_curve *c;          /* control points as `e` holds them    */
    uint32_t n, j;
    double unit;                    /* 1 LSB of the curve in mm            */
    double worst, sum;              /* LSB                                 */
    double t;
    int axis;
    size_t count;
} comparison;

/* de Casteljau with 64 bits of mantissa: error below 1e-4 LSB of double. */
static void exact_at(const points_curve *c, long double t, double out[ENGINE_AXES])
{
    for (int i = 0; i < ENGINE_AXES; i++) {
        long double b[POINTS_MAX];
        for (unsigned k = 0; k <= c->degree; k++)
            b[k] = (long double)c->p[k][i];
        for (unsigned row = c->degree; row > 0; row--)
            for (unsigned k = 0; k < row; k++)
                b[k] += t * (b[k + 1] - b[k]);
        out[i] = (double)b[0];
    }
}

static void meet(void *context, const double point[ENGINE_AXES])
{
    comparison *m = context;
    double want[ENGINE_AXES];

    m->j++;
    const double t = (double)m->j / (double)m->n;
    if (m->against == NULL)
        exact_at(m->c, (long double)m->j / (long double)m->n, want);
    else if (m->against->eval((const double (*)[ENGINE_AXES])m->c->p, m->c->degree, t, want) != 0)
        return;
    for (int i = 0; i < ENGINE_AXES; i++) {
        const double off = fabs(point[i] - want[i]) / m->unit;
        m->sum += off;
        m->count++;
        if (off > m->worst) {
            m->worst = off;
            m->t     = t;
            m->axis  = i;
        }
    }
}

static int by_eval(comparison *m)
{
    for (uint32_t j = 1; j <= m->n; j++) {
        double at[ENGINE_AXES];
        const int status = m->e->eval((const double (*)[ENGINE_AXES])m->c->p, m->c->degree, (double)j / (double)m->n, at);
        if (status != 0)
            return status;
        meet(m, at);
    }
    return 0;
}

static int by_walk(comparison *m)
{
    return m->e->walk((const double (*)[ENGINE_AXES])m->c->p, m->c->degree, m->n, meet, m);
}

/* The curve as the number type holds it, and its LSB: fixed, or that of the largest coordinate. */
static int hold(const engine *e, const points_curve *c, points_curve *held, double *unit)
{
    double largest = 0;

    *held = *c;
    for (unsigned k = 0; k <= c->degree; k++) {
        const int status = e->eval((const double (*)[ENGINE_AXES])&c->p[k], 0, 0, held->p[k]);
        if (status != 0)
            return status;
        for (int i = 0; i < ENGINE_AXES; i++)
            largest = fmax(largest, fabs(held->p[k][i]));
    }
    *unit = e->fixed || largest < 1e-300 ? e->lsb : e->lsb * exp2(floor(log2(largest)));
    return 0;
}

static int compare_curves(const engine *e, const engine *against, const points *all, uint32_t n, const char *file)
{
    static const struct { const char *name; int (*run)(comparison *); } ways[] = { { "eval", by_eval }, { "walk", by_walk } };

    for (size_t i = 0; i < all->count; i++)
        for (size_t w = 0; w < sizeof ways / sizeof ways[0]; w++) {
            points_curve held;
            comparison m = { .e = e, .against = against, .c = &held, .n = n };
            int status   = hold(e, &all->curve[i], &held, &m.unit);
            if (status == 0 && (held.degree <= 5 || ways[w].run != by_walk))
                status = ways[w].run(&m);
            if (status != 0)
                return tool_error(EX_DATAERR, "%s:%u: %s in %s: %s", file, held.line, ways[w].name, e->name, engine_status(status));
            if (m.count > 0)
                printf("%-4s %-5s %-6s %5zu %9.4f %9.4f %11.3e %.9g %c\n", e->name, against ? against->name : "exact", ways[w].name,
                       i, m.worst, m.sum / (double)m.count, m.worst * m.unit, m.t, "xyz"[m.axis]);
        }
    return EX_OK;
}

static int compare_types(const char *types, const engine *against, const points *all, uint32_t n, const char *file)
{
    char names[64];
    int code = EX_OK;

    if (strlen(types) >= sizeof names)
        return tool_error(EX_USAGE, "--num %s: give q16, f32, f64, or several with commas between", types);
    strcpy(names, types);
    printf("# num than  way    curve worst_lsb  mean_lsb    worst_mm t axis\n");
    for (char *name = strtok(names, ","); name && code == EX_OK; name = strtok(NULL, ",")) {
        const engine *e = engine_find(name);
        code = e ? compare_curves(e, against, all, n, file)
                 : tool_error(EX_USAGE, "--num %s: give q16, f32, f64, or several with commas between", types);
    }
    return code;
}

static int run(const tool_command *self, int argc, char **argv)
{
    const char *types = "q16,f32,f64", *than = "exact", *text = NULL;
    unsigned n        = 1024;
    points all        = { 0 };
    int first;

    const tool_option options[] = {
        TOOL_TEXT("num", "TYPE,..", &types, "number types to measure (q16,f32,f64)"),
        TOOL_TEXT("against", "TYPE", &than, "what they are measured against: exact, q16, f32 or f64 (exact)"),
        TOOL_COUNT("n", "N", &n, 1, 1e8, "parameters per curve, j/N (1024)"),
        TOOL_TEXT("points", "POINTS", &text, "the control points themselves: \"0,0 1,2 3,0\""),
        TOOL_OPTIONS_END
    };
    int code = tool_options(self, options, argc, argv, &first);
    if (code != 0)
        return code == TOOL_HELP ? EX_OK : code;
    const engine *against = engine_find(than);
    if (against == NULL && strcmp(than, "exact") != 0)
        return tool_error(EX_USAGE, "--against %s: give exact, q16, f32 or f64", than);

    const char *file = first < argc ? argv[first] : "-";
    code = points_read(&all, file, text);
    if (code == 0)
        code = compare_types(types, against, &all, n, text ? "--points" : file);
    points_free(&all);
    return code;
}

const tool_command command_compare = {
    "compare", "[--num TYPE,..] [FILE|-]", "the error of a number type, in LSB, and where it is worst",
    "For each curve and way of computing it (eval: de Casteljau, walk: forward differences) prints one line: the worst\n"
    "and the mean error in LSB (q16: 2^-16 mm; floats: of the largest coordinate), the worst in mm, its t and axis.\n"
    "Control points are rounded to the number type first: what is measured is the arithmetic.\n",
    run
};
