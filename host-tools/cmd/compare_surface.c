/* host-tools/cmd/compare_surface.c -- the error of a surface in a number type
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/tool.h"
#include "num/status.h"         /* enum loft_status */

#include "cmd/compare.h"
#include "geometry/print.h"       /* parameter_text */
#include "geometry/reference_surface.h"
#include "engine/sided.h"

typedef struct {
    const engine *e;
    const compare_to *to;
    const surface *s;                   /* rounded to the number type                     */
    engine_surface *held;
    const surface *other;               /* what it is compared with, rounded alike        */
    engine_surface *with;               /* in `than`, or in f64 if there is another file */
    const double *part;                 /* the parameters of its corners in the other     */
    double unit, worst, sum, u, v;
    int axis;
    size_t count;
} comparison;

/* Copy a surface, rounded. Its points are to be freed, and its knots if there is no error. */
static bool round_surface(const engine *e, const surface *s, surface *out)
{
    bool fits = compare_round(e, &out->radius, 1);

    out->point = tool_grow(NULL, (s->count + 1) * sizeof *s->point);
    for (unsigned i = 0; i < s->count; i++) {
        out->point[i] = s->point[i];
        fits = fits && compare_round(e, out->point[i].p, SURFACE_AXES) &&
               compare_round(e, out->point[i].d, SURFACE_AXES) &&
               compare_round(e, &out->point[i].w, 1);
    }
    return fits;
}

static double unit_of(const engine *e, const surface *s)
{
    double largest = fabs(s->radius);

    for (unsigned k = 0; k < s->count; k++)
        for (int i = 0; i < SURFACE_AXES; i++)
            largest = fmax(largest, fabs(s->point[k].p[i]));
    return e->fixed || largest < 1e-300 ? e->lsb : e->lsb * exp2(floor(log2(largest)));
}

/* The parameters of a place of a kite; in the other surface they may have corners of their own. */
static void place_of(const comparison *m, unsigned kite, const double at[2], double out[2])
{
    const double u = at[0], v = at[1], *c = m->part;

    if (surface_is_sided(m->s)) {
        sided_spot(m->s, sided_kite(m->s, kite, u, v), out);
        for (int i = 0; i < 2 && c != NULL; i++)
            out[i] = (1 - out[i]) * c[i] + out[i] * c[2 + i];
    } else if (c != NULL && surface_is_triangle(m->s))
        for (int i = 0; i < 2; i++)
            out[i] = (1 - u - v) * c[i] + u * c[2 + i] + v * c[4 + i];
    else
        for (int i = 0; i < 2; i++)
            out[i] = c ? (1 - at[i]) * c[i] + at[i] * c[2 + i] : at[i];
}

/* What the point is to be. Returns enum loft_status. */
static int wanted(const comparison *m, unsigned kite, const double at[2],
                  long double out[ENGINE_AXES])
{
    double place[2], point[ENGINE_AXES];
    int status = LOFT_OK;

    if (m->with == NULL)
        return reference_surface(m->other, (long double)at[0], (long double)at[1], out)
                   ? LOFT_OK
                   : LOFT_ERR_ARG;
    place_of(m, kite, at, place);
    if (surface_is_sided(m->other))
        status = (m->to->other ? &engine_f64 : m->to->than)
                     ->surface->kite(m->with, kite, at[0], at[1], point);
    else
        status = (m->to->other ? &engine_f64 : m->to->than)
                     ->surface->eval(m->with, place[0], place[1], point);
    for (int i = 0; i < ENGINE_AXES; i++)
        out[i] = (long double)point[i];
    return status;
}

static void note(comparison *m, double off, const double at[2], int axis)
{
    m->sum += off;
    m->count++;
    if (!(off <= m->worst)) {
        m->worst = off;
        m->u     = at[0];
        m->v     = at[1];
        m->axis  = axis;
    }
}

static int measure_place(comparison *m, unsigned kite, const double at[2])
{
    long double want[ENGINE_AXES];
    double got[ENGINE_AXES];
    int status = m->e->surface->kite(m->held, kite, at[0], at[1], got);

    if (status == LOFT_OK && m->to->quadric.count > 0) {
        note(m, compare_quadric(&m->to->quadric, got) / m->unit, at, 3);
        return status;
    }
    if (status == LOFT_OK)
        status = wanted(m, kite, at, want);
    for (int i = 0; i < ENGINE_AXES && status == LOFT_OK; i++)
        note(m, (double)fabsl((long double)got[i] - want[i]) / m->unit, at, i);
    return status;
}

/* i / n as all number types hold it. */
static double step_of(unsigned i, unsigned n) { return floor(i * 0x1p24 / n) * 0x1p-24; }

static int measure_grid(comparison *m)
{
    const unsigned n = m->to->n;
    int status = LOFT_OK;

    for (unsigned kite = 0; kite < surface_kites(m->s); kite++)
        for (unsigned i = 0; i <= n; i++)
            for (unsigned j = 0; j <= n && status == LOFT_OK; j++) {
                const double at[2] = { step_of(i, n), step_of(j, n) };
                if (!surface_is_triangle(m->s) || i + j <= n)
                    status = measure_place(m, kite, at);
            }
    return status;
}

static void print_row(const comparison *m, size_t number)
{
    const compare_to *to = m->to;

    printf("%-4s %-7s %-5s %5zu %9.4f %9.4f %11.3e %s,%s %c %s\n", m->e->name,
           to->quadric.count ? "quadric"
           : to->other       ? "other"
           : to->than        ? to->than->name
                             : "exact",
           "eval", number, m->worst, m->sum / (double)m->count, m->worst * m->unit,
           parameter_text(m->e, m->u), parameter_text(m->e, m->v), "xyz-"[m->axis],
           surface_name(m->s->kind));
}

static int compare_one(comparison *m, const surface *given, const surface *other, size_t number)
{
    surface s = *given, o = other ? *other : s;
    const engine *with = other ? &engine_f64 : m->to->than;
    int status = round_surface(m->e, given, &s) ? LOFT_OK : LOFT_ERR_RANGE;

    if (!round_surface(m->e, other ? other : given, &o))
        status = LOFT_ERR_RANGE;
    m->s     = &s;
    m->other = &o;
    m->unit  = unit_of(m->e, &s);
    if (status == LOFT_OK)
        status = m->e->surface->open(&s, &m->held);
    if (status == LOFT_OK && with != NULL)
        status = with->surface->open(&o, &m->with);
    if (status == LOFT_OK)
        status = measure_grid(m);
    if (status == LOFT_OK)
        print_row(m, number);
    if (m->held != NULL)
        m->e->surface->close(m->held);
    if (m->with != NULL)
        with->surface->close(m->with);
    free(s.point);
    free(o.point);
    return status;
}

/* Surface k of the other file, or parts of its first one. */
int compare_surfaces(const engine *e, const compare_to *to, const surfaces *all,
                     const surfaces *other, const char *file)
{
    for (size_t k = 0; k < all->count; k++) {
        const surface *s = &all->surface[k];
        const size_t corners = surface_is_triangle(s) ? 6 : 4;
        comparison m = { .e = e, .to = to };
        if (to->part.count > 0)
            m.part = &to->part.value[corners * k];
        if (to->part.count > 0 && (k + 1) * corners > to->part.count)
            return tool_error(EX_USAGE, "--part: %zu numbers: give %zu for each surface",
                              (size_t)to->part.count, corners);
        if (to->other && to->part.count == 0 && k >= other->count)
            return tool_error(EX_DATAERR, "%s: %zu surfaces, %s has %zu: give as many, or --part",
                              file, all->count, to->other, other->count);
        const surface *o = !to->other ? NULL : &other->surface[to->part.count > 0 ? 0 : k];
        const int status = compare_one(&m, s, o, k);
        if (status == LOFT_ERR_ARG && to->than == NULL && o == NULL)
            return tool_error(EX_DATAERR, "%s:%u: %s has no definition here: give --against f64",
                              file, s->line, surface_name(s->kind));
        if (status != LOFT_OK)
            return tool_error(EX_DATAERR, "%s:%u: %s in %s: %s", file, s->line,
                              surface_name(s->kind), e->name, surface_status(s, status));
    }
    return EX_OK;
}
