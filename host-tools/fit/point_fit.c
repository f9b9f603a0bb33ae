/* host-tools/fit/point_fit.c
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>

#include "base/space.h"         /* space_distance */
#include "base/tool.h"          /* tool_grow */
#include "fit/point_fit.h"

#define FEW   12        /* points of a polygon that may all be corners */
#define REACH 10        /* tolerances: from there the turn at a point is seen */

// Corners
// -------

/* The nearest point before (step -1) or behind i that is `reach` away; the end of an open row. */
static size_t point_away(const point_row *r, size_t i, int step, double reach)
{
    size_t at = i;

    for (size_t k = 1; k < r->count; k++) {
        if (!r->closed && (step < 0 ? at == 0 : at + 1 == r->count))
            break;
        at = step > 0 ? (at + 1) % r->count : (at + r->count - 1) % r->count;
        if (space_distance(r->p[at], r->p[i]) >= reach)
            break;
    }
    return at;
}

/* The angle between the directions to point i and from it. */
static double turn_at(const point_row *r, size_t i, double reach)
{
    const double *from = r->p[point_away(r, i, -1, reach)], *at = r->p[i],
                 *to = r->p[point_away(r, i, 1, reach)];
    double along = 0;
    const double length = space_distance(from, at) * space_distance(at, to);

    for (int axis = 0; axis < ENGINE_AXES; axis++)
        along += (at[axis] - from[axis]) * (to[axis] - at[axis]);
    return length > 0 ? acos(fmin(fmax(along / length, -1), 1)) : 0;
}

/* Does no point within `reach` of i turn more? Of equal ones the first counts. */
static bool turns_most(const point_row *r, const double turn[], size_t i, double reach)
{
    for (int step = -1; step <= 1; step += 2) {
        const size_t end = point_away(r, i, step, reach);
        for (size_t at = i; at != end; ) {
            at = step > 0 ? (at + 1) % r->count : (at + r->count - 1) % r->count;
            if (turn[at] > turn[i] || (step < 0 && !(turn[at] < turn[i]) && at != i &&
                                       space_distance(r->p[at], r->p[i]) < reach))
                return false;
        }
    }
    return true;
}

/* The corners, in order: corner[count]. */
static size_t find_corners(const point_row *r, const point_fit_options *o, size_t corner[])
{
    const double reach = REACH * o->tol;
    double *turn = tool_grow(NULL, r->count * sizeof *turn);
    size_t count = 0;

    for (size_t i = 0; i < r->count; i++)
        turn[i] = r->closed || (i > 0 && i + 1 < r->count) ? turn_at(r, i, reach) : 0;
    for (size_t i = 0; i < r->count; i++)
        if (turn[i] > o->corner && turns_most(r, turn, i, reach))
            corner[count++] = i;
    free(turn);
    return count;
}


// Parts
// -----

static void take_points(const point_row *r, size_t from, size_t to, spline_fit *f)
{
    spline_fit_begin(f);
    for (size_t i = from; i <= to; i++)
        spline_fit_add(f, r->p[i % r->count]);
}

static bool fit_part(const point_row *r, const point_fit_options *o, size_t from, size_t to,
                     spline_fit *f, size_t *where)
{
    f->closed = f->between = f->by_length = false;
    f->degree = to - from < o->degree ? (unsigned)(to - from) : o->degree;
    take_points(r, from, to, f);
    return spline_fit_within(f, o->tol, where);
}

/* Control points that are free: of the stretch between two corners, of the row. */
typedef struct {
    point_fit_sink *sink;
    void *context;
    size_t stretch, row;
} taking;

static int take_part(taking *t, const spline_fit *f)
{
    const size_t control = f->intervals + (f->closed ? 0 : f->degree - 1);

    t->stretch += control;
    t->row += control;
    return t->sink(t->context, f);
}

/* A curve with as many control points as points follows their noise. */
static int check_count(size_t control, size_t points, size_t few)
{
    return control <= few || 3 * control <= 2 * points ? 0 : POINT_FIT_NOISY;
}

/* The points from..to, cut further where they cannot be one curve. */
static int fit_stretch(const point_row *r, const point_fit_options *o, size_t from, size_t to,
                       spline_fit *f, taking *t)
{
    const size_t points = to - from + 1;
    int code = 0;

    t->stretch = 1;
    for (size_t stop = to; from < to && code == 0; stop = to) {
        size_t where;
        while (!fit_part(r, o, from, stop, f, &where)) {
            if (stop - from == 1)       /* the line between two points */
                return EX_DATAERR;
            stop = where > 0 && where < stop - from ? from + where : (from + stop) / 2;
        }
        code = take_part(t, f);
        from = stop;
    }
    return code != 0 ? code : check_count(t->stretch, points, o->degree + 1);
}

static int fit_closed(const point_row *r, const point_fit_options *o, spline_fit *f, taking *t)
{
    size_t where;

    f->between = f->by_length = false;
    f->degree = o->degree;
    take_points(r, 0, r->count, f);
    f->closed = true;
    if (!spline_fit_within(f, o->tol, &where))
        return fit_stretch(r, o, where, where + r->count, f, t);
    return take_part(t, f);
}

static int fit_row(const point_row *row, const point_fit_options *o, spline_fit *f,
                   point_fit_sink *sink, void *context)
{
    taking t = { sink, context, 0, 0 };
    size_t *corner = tool_grow(NULL, (row->count + 2) * sizeof *corner);
    size_t count = find_corners(row, o, corner + 1);
    int code = 0;

    if (row->closed && count == 0) {
        code = fit_closed(row, o, f, &t);
    } else {
        corner[0] = row->closed ? corner[count] : 0;
        if (!row->closed)
            corner[++count] = row->count - 1;
        for (size_t k = 0; k < count && code == 0; k++) {
            const size_t from = row->closed && k == 0 ? corner[count] : corner[k];
            const size_t to = corner[k + 1] + (corner[k + 1] <= from ? row->count : 0);
            code = fit_stretch(row, o, from, to, f, &t);
        }
    }
    free(corner);
    return code != 0 ? code : check_count(t.row, row->count, FEW);
}

static int drop_part(void *context, const spline_fit *f)
{
    (void)context;
    (void)f;
    return 0;
}

int point_fit(const point_row *row, const point_fit_options *o, spline_fit *f, point_fit_sink *sink,
              void *context)
{
    const int code = fit_row(row, o, f, drop_part, NULL);

    return code != 0 ? code : fit_row(row, o, f, sink, context);
}

double point_fit_enough(const point_row *row, const point_fit_options *o, double most,
                        spline_fit *f)
{
    point_fit_options wider = *o;

    for (;;) {
        const double unit = pow(10, floor(log10(wider.tol) + 1e-9));
        wider.tol = (floor(wider.tol / unit + 1e-9) + 1) * unit;
        if (wider.tol > most)
            break;
        if (fit_row(row, &wider, f, drop_part, NULL) == 0)
            return wider.tol;
    }
    return 0;
}
