/* host-tools/plan/smooth.c
 * SPDX-License-Identifier: MIT
 *
 * A chain is sampled at its vertices and on long lines. A cubic B-spline over the length along the
 * chain is fitted by least squares (C. de Boor, A Practical Guide to Splines, 2001, chapter XIV);
 * the normal equations have seven diagonals. Intervals with too large an error are halved until the
 * fit is good, or until a vertex proves to be a corner. Then the chain is cut there, and both parts
 * are tried.
 */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "plan/smooth.h"
#include "base/space.h"          /* space_distance */
#include "base/tool.h"           /* tool_grow */

#define STRAIGHT    1e-6    /* mm: control points this close to the thirds of a line */
#define TURN        0.86    /* the smallest cosine between lines that may be one curve */
#define LEAST       4       /* lines, at least, to fit a curve */
#define APART       0.25    /* mm: between samples on a long line; at most MANY of them */
#define MANY        200
#define BETWEEN     4       /* checked places between two samples */
#define CHECKED     0.9     /* of `within` may be used there */
#define ROUNDS      40
#define CHAIN       4096    /* lines; longer chains are cut, so that memory is bounded */

/* Samples of a chain, and the spline through them. */
typedef struct fit {
    double (*p)[3], *u;     /* place, length along the chain                  */
    size_t *vertex;         /* the line that starts there, or that it lies on */
    size_t count, room;
    double *knot;           /* ends and inner knots, ascending: `intervals` + 1 */
    size_t *first;          /* of each interval: its first sample             */
    size_t intervals;
    double (*c)[3];         /* intervals + 3 coefficients                     */
    double (*a)[4], (*b)[3];
} fit;


// The spline
// ----------

static double knot_at(const fit *f, long i)
{
    return f->knot[i < 0 ? 0 : i > (long)f->intervals ? (long)f->intervals : i];
}

/* The four B-splines that are not 0 on interval k, and their derivatives (de Boor's recurrence). */
static void basis_values(const fit *f, size_t k, double u, double value[4], double deriv[4])
{
    double left[4], right[4], lower[3] = { 0 };

    value[0] = 1;
    for (int j = 1; j <= 3; j++) {
        double saved = 0;
        if (j == 3)
            memcpy(lower, value, sizeof lower);
        left[j]  = u - knot_at(f, (long)k + 1 - j);
        right[j] = knot_at(f, (long)k + j) - u;
        for (int r = 0; r < j; r++) {
            const double part = value[r] / (right[r + 1] + left[j - r]);
            value[r] = saved + right[r + 1] * part;
            saved    = left[j - r] * part;
        }
        value[j] = saved;
    }
    for (int r = 0; r <= 3; r++) {
        const long i = (long)k + r - 3;
        deriv[r] = (r > 0 ? 3 * lower[r - 1] / (knot_at(f, i + 3) - knot_at(f, i)) : 0) -
                   (r < 3 ? 3 * lower[r] / (knot_at(f, i + 4) - knot_at(f, i + 1)) : 0);
    }
}

static void eval_spline(const fit *f, size_t k, double u, double out[3], double slope[3])
{
    double value[4], deriv[4];

    basis_values(f, k, u, value, deriv);
    for (int i = 0; i < 3; i++) {
        out[i] = slope[i] = 0;
        for (int r = 0; r < 4; r++) {
            out[i]   += value[r] * f->c[k + (size_t)r][i];
            slope[i] += deriv[r] * f->c[k + (size_t)r][i];
        }
    }
}

/* Cholesky with seven diagonals: a[i][j] is row i, column i - j. */
static void solve_banded(double (*a)[4], double (*b)[3], size_t n)
{
    for (size_t i = 0; i < n; i++) {
        for (size_t j = i < 3 ? i : 3; j + 1 > 0; j--) {
            double sum = a[i][j];
            for (size_t k = j + 1; k <= 3 && k <= i; k++)
                sum -= a[i][k] * a[i - j][k - j];
            a[i][j] = j > 0 ? sum / a[i - j][0] : sqrt(sum > 1e-300 ? sum : 1e-300);
            if (j == 0)
                break;
        }
        for (int x = 0; x < 3; x++) {
            for (size_t j = 1; j <= 3 && j <= i; j++)
                b[i][x] -= a[i][j] * b[i - j][x];
            b[i][x] /= a[i][0];
        }
    }
    for (size_t i = n; i-- > 0;)
        for (int x = 0; x < 3; x++) {
            for (size_t j = 1; j <= 3 && i + j < n; j++)
                b[i][x] -= a[i + j][j] * b[i + j][x];
            b[i][x] /= a[i][0];
        }
}

/* Each sample counts by the length around it; the ends are exact. */
static void solve_spline(fit *f)
{
    const size_t n = f->intervals + 3, last = f->count - 1;

    memset(f->a, 0, n * sizeof *f->a);
    memset(f->b, 0, n * sizeof *f->b);
    for (size_t k = 0; k < f->intervals; k++)
        for (size_t s = f->first[k]; s < f->first[k + 1]; s++) {
            const double weight = f->u[s < last ? s + 1 : s] - f->u[s > 0 ? s - 1 : 0];
            double value[4], deriv[4];
            basis_values(f, k, f->u[s], value, deriv);
            for (size_t r = 0; r < 4; r++) {
                for (size_t j = 0; j <= r; j++)
                    f->a[k + r][j] += weight * value[r] * value[r - j];
                for (int x = 0; x < 3; x++)
                    f->b[k + r][x] += weight * value[r] * f->p[s][x];
            }
        }
    f->a[0][0]     += 1e12;
    f->a[n - 1][0] += 1e12;
    for (int x = 0; x < 3; x++) {
        f->b[0][x]     += 1e12 * f->p[0][x];
        f->b[n - 1][x] += 1e12 * f->p[last][x];
    }
    solve_banded(f->a, f->b, n);
    memcpy(f->c, f->b, n * sizeof *f->c);
    memcpy(f->c[0], f->p[0], sizeof f->c[0]);
    memcpy(f->c[n - 1], f->p[last], sizeof f->c[n - 1]);
}

/* The largest distance of interval k from the chain, and the sample after which it occurs. */
static double error_of(const fit *f, size_t k, size_t *where)
{
    double worst = 0;

    for (size_t s = f->first[k]; s < f->first[k + 1]; s++)
        for (int j = 0; j <= BETWEEN && s + 1 < f->count; j++) {
            const double part = (double)j / (BETWEEN + 1),
                         u = f->u[s] + part * (f->u[s + 1] - f->u[s]);
            double at[3], slope[3], chord[3];
            if (u > f->knot[k + 1])
                break;
            eval_spline(f, k, u, at, slope);
            for (int i = 0; i < 3; i++)
                chord[i] = f->p[s][i] + part * (f->p[s + 1][i] - f->p[s][i]);
            const double off = space_distance(at, chord);
            if (off > worst) {
                worst  = off;
                *where = s;
            }
        }
    return worst;
}

/* Halve all intervals with an error above `within`. Returns how many; SIZE_MAX if one cannot be
 * halved, at sample *where. */
static size_t refine_intervals(fit *f, double within, size_t *where)
{
    const size_t before = f->intervals;
    size_t bad = 0, worst_at = 0;

    for (size_t k = before; k-- > 0;) {
        if (error_of(f, k, &worst_at) <= CHECKED * within)
            continue;
        const size_t middle = (f->first[k] + f->first[k + 1]) / 2;
        bad++;
        if (f->first[k + 1] - f->first[k] < 4) {
            *where = worst_at;
            return SIZE_MAX;
        }
        memmove(&f->knot[k + 2], &f->knot[k + 1], (f->intervals - k) * sizeof *f->knot);
        memmove(&f->first[k + 2], &f->first[k + 1], (f->intervals - k) * sizeof *f->first);
        f->first[k + 1] = middle;
        f->knot[k + 1]  = (f->u[middle - 1] + f->u[middle]) / 2;
        f->intervals++;
    }
    return bad;
}


// Chains
// ------

static void place_of(const drawing_curve *c, int k, double out[3])
{
    out[0] = c->p[k][0];
    out[1] = c->p[k][1];
    out[2] = c->z[k];
}

static bool is_line(const drawing_curve *c)
{
    double p[4][3];

    for (int k = 0; k < 4; k++)
        place_of(c, k, p[k]);
    for (int i = 0; i < 3; i++) {
        const double a = p[0][i], b = p[3][i];
        if (fabs(p[1][i] - (2 * a + b) / 3) > STRAIGHT ||
            fabs(p[2][i] - (a + 2 * b) / 3) > STRAIGHT)
            return false;
    }
    /* travels of a program stay as they are, and so does its way from where the machine stands */
    return c->feed >= 0 && c->loose[0] == c->loose[1];
}

/* Can the vertex between two lines lie on a curve? It must turn little, and not rise high above the
 * line between its neighbours. */
static bool vertex_is_smooth(const drawing_curve *a, const drawing_curve *b, double within)
{
    double p[3], q[3], r[3], by[2][3], cross[3], along = 0;

    place_of(a, 0, p);
    place_of(a, 3, q);
    place_of(b, 3, r);
    for (int i = 0; i < 3; i++) {
        by[0][i] = q[i] - p[i];
        by[1][i] = r[i] - q[i];
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        cross[i] = by[0][j] * by[1][k] - by[0][k] * by[1][j];
        along += by[0][i] * by[1][i];
    }
    const double length = space_distance(p, q) * space_distance(q, r),
                 across = hypot(hypot(cross[0], cross[1]), cross[2]);
    const bool alike = a->path == b->path && a->tool == b->tool && a->loose[1] == b->loose[0] &&
                       !(a->feed < b->feed) && !(a->feed > b->feed);
    return alike && length > 0 && along > TURN * length &&
           across <= 4 * within * space_distance(p, r);
}

static void add_sample(fit *f, const double p[3], size_t vertex)
{
    if (f->count == f->room) {
        f->room   = f->room ? 2 * f->room : 1024;
        f->p      = tool_grow(f->p, f->room * sizeof *f->p);
        f->u      = tool_grow(f->u, f->room * sizeof *f->u);
        f->vertex = tool_grow(f->vertex, f->room * sizeof *f->vertex);
    }
    const size_t n = f->count++;
    memcpy(f->p[n], p, sizeof f->p[n]);
    f->u[n]      = n > 0 ? f->u[n - 1] + space_distance(p, f->p[n - 1]) : 0;
    f->vertex[n] = vertex;
}

/* Sample lines from..to-1 of `d`. */
static void sample_lines(fit *f, const drawing *d, size_t from, size_t to)
{
    double a[3], b[3] = { 0 };

    f->count = 0;
    for (size_t i = from; i < to; i++) {
        place_of(&d->curve[i], 0, a);
        place_of(&d->curve[i], 3, b);
        const int pieces = (int)fmin(fmax(ceil(space_distance(a, b) / APART), 1), MANY);
        for (int j = 0; j < pieces; j++) {
            const double part = (double)j / pieces;
            const double at[3] = { a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1]),
                                   a[2] + part * (b[2] - a[2]) };
            add_sample(f, at, i);
        }
    }
    add_sample(f, b, to);
    f->knot  = tool_grow(f->knot, (f->count + 2) * sizeof *f->knot);
    f->first = tool_grow(f->first, (f->count + 2) * sizeof *f->first);
    f->a     = tool_grow(f->a, (f->count + 4) * sizeof *f->a);
    f->b     = tool_grow(f->b, (f->count + 4) * sizeof *f->b);
    f->c     = tool_grow(f->c, (f->count + 4) * sizeof *f->c);
    f->knot[0]   = 0;
    f->knot[1]   = f->u[f->count - 1];
    f->first[0]  = 0;
    f->first[1]  = f->count;
    f->intervals = 1;
}

/* Returns `to`, or the line before which the chain must be cut. */
static size_t fit_lines(fit *f, const drawing *d, size_t from, size_t to, double within)
{
    size_t where = 0;

    sample_lines(f, d, from, to);
    for (int round = 0; round < ROUNDS; round++) {
        if (f->count < f->intervals + 3)
            break;
        solve_spline(f);
        const size_t bad = refine_intervals(f, within, &where);
        if (bad == 0)
            return to;
        if (bad == SIZE_MAX)
            break;
    }
    const size_t at = f->vertex[where] +
                      (where + 1 < f->count && f->vertex[where + 1] != f->vertex[where]);
    return at <= from ? from + 1 : at >= to ? to - 1 : at;
}

static void give_spline(drawing *to, const fit *f, bool fresh, const drawing_curve *like)
{
    double p[4][3], slope[2][3];

    memcpy(p[3], f->p[0], sizeof p[3]);
    for (size_t k = 0; k < f->intervals; k++) {
        const double third = (f->knot[k + 1] - f->knot[k]) / 3;
        memcpy(p[0], p[3], sizeof p[0]);
        eval_spline(f, k, f->knot[k], p[1], slope[0]);
        eval_spline(f, k, f->knot[k + 1], p[3], slope[1]);
        for (int i = 0; i < 3; i++) {
            p[1][i] = p[0][i] + third * slope[0][i];
            p[2][i] = p[3][i] - third * slope[1][i];
        }
        if (k + 1 == f->intervals)
            memcpy(p[3], f->p[f->count - 1], sizeof p[3]);
        drawing_add_space(to, p, like->feed, fresh && k == 0, like->line);
        memcpy(to->curve[to->count - 1].loose, like->loose, sizeof like->loose);
        to->curve[to->count - 1].tool = like->tool;
    }
}

static void copy_curve(drawing *to, const drawing *from, size_t i)
{
    double p[4][3];

    for (int k = 0; k < 4; k++)
        place_of(&from->curve[i], k, p[k]);
    drawing_add_space(to, p, from->curve[i].feed,
                      i == 0 || from->curve[i].path != from->curve[i - 1].path,
                      from->curve[i].line);
    memcpy(to->curve[to->count - 1].loose, from->curve[i].loose, sizeof from->curve[i].loose);
    to->curve[to->count - 1].tool = from->curve[i].tool;
}

/* Replace the chain from..to-1 by as few curves as are found. Returns how many lines were
 * replaced. */
static size_t smooth_chain(drawing *to, const drawing *d, fit *f, size_t from, size_t end,
                           double within)
{
    size_t replaced = 0, stop = end;

    while (from < end) {
        if (stop - from < LEAST) {
            while (from < stop)
                copy_curve(to, d, from++);
            stop = end;
            continue;
        }
        const size_t cut = fit_lines(f, d, from, stop, within);
        if (cut < stop) {
            stop = cut;
            continue;
        }
        give_spline(to, f, from == 0 || d->curve[from].path != d->curve[from - 1].path,
                    &d->curve[from]);
        replaced += stop - from;
        from = stop;
        stop = end;
    }
    return replaced;
}

/* Copy the events that come before curve i: chains do not lead past one. */
static void copy_events(smoothing *s, drawing *to, const drawing *from, size_t i)
{
    while (s->events < from->events && from->event[s->events].before <= from->taken + i)
        drawing_add_event(to, &from->event[s->events++]);
}

/* The end of the chain that begins at i; `open`: it may go on beyond the drawing. */
static size_t chain_end(const drawing *d, size_t i, double within, bool *open)
{
    size_t end = i + 1;

    *open = false;
    if (!(within > 0) || !is_line(&d->curve[i]))
        return end;
    while (end < d->count && end - i < CHAIN && is_line(&d->curve[end]) &&
           vertex_is_smooth(&d->curve[end - 1], &d->curve[end], within))
        end++;
    *open = end == d->count && end - i < CHAIN;
    return end;
}

void smooth_more(smoothing *s, drawing *to, drawing *from, bool last)
{
    size_t i = s->given;
    bool open;

    if (s->fit == NULL)
        *(s->fit = tool_grow(NULL, sizeof *s->fit)) = (fit){ 0 };
    for (size_t end; i < from->count; i = end) {
        end = chain_end(from, i, s->within, &open);
        if (open && !last)
            break;
        copy_events(s, to, from, i);
        s->replaced += smooth_chain(to, from, s->fit, i, end, s->within);
    }
    if (last)
        copy_events(s, to, from, from->count);
    s->given = i;
}

void smooth_end(smoothing *s)
{
    fit *f = s->fit;

    if (f == NULL)
        return;
    free(f->p);
    free(f->u);
    free(f->vertex);
    free(f->knot);
    free(f->first);
    free(f->a);
    free(f->b);
    free(f->c);
    free(f);
    s->fit = NULL;
}

size_t drawing_smooth(drawing *to, drawing *from, double within)
{
    smoothing s = { .within = within };

    drawing_like(to, from);
    smooth_more(&s, to, from, true);
    smooth_end(&s);
    return s.replaced;
}
