/* host-tools/fit/spline_fit.c
 * SPDX-License-Identifier: MIT
 *
 * C. de Boor, A Practical Guide to Splines (2001), chapter XIV.
 *
 * What holds at the points alone says nothing of the curve between them: with a knot for each point
 * the equations can be nearly singular, and control points of 10^8 mm meet all points. Three rules
 * bound the curve:
 *
 *   knots   each interval has two points or more, so there are at most count / 2 + degree control
 *           points, and the points tell each of them (Schoenberg and Whitney) by a margin.
 *   speed   the parameter is the length of the chords, so the curve runs at speed 1 or little more.
 *           Its derivative lies in the hull of n (c_i+1 - c_i) / T_i with T_i = t_i+n+1 - t_i+1.
 *           Each is at most SPEED + SLACK within / T_i. A gap between two points lies in one
 *           interval, or in two by halves, none longer than T_i. So over a gap L the curve is at
 *           most SPEED L + 2 SLACK `within` long, and stays within the ellipse of this length, and
 *           2 `within` more, around the points: for a small `within` 0.87 L from their chord, for a
 *           small L 5 `within`.
 */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/space.h"         /* space_distance */
#include "base/tool.h"          /* tool_grow */
#include "fit/spline_fit.h"

#define BETWEEN     4       /* checked places between two points */
#define CHECKED     0.9     /* of `within` may be used there     */
#define ROUNDS      40
#define LEAST       2       /* points of an interval               */
#define SPEED       2       /* of the curve along the length of the chords, at most */
#define SLACK       4
#define DEGREES     10


// Points
// ------

void spline_fit_begin(spline_fit *f) { f->count = 0; }

void spline_fit_add(spline_fit *f, const double p[ENGINE_AXES])
{
    if (f->count == f->room) {
        f->room = f->room ? 2 * f->room : 1024;
        f->p    = tool_grow(f->p, f->room * sizeof *f->p);
        f->u    = tool_grow(f->u, f->room * sizeof *f->u);
    }
    const size_t n = f->count++;
    memcpy(f->p[n], p, sizeof f->p[n]);
    const double u = n > 0 ? f->u[n - 1] + space_distance(p, f->p[n - 1]) : 0;
    f->u[n] = u;
    (void)f->e->hold(u, &f->u[n]);      /* what does not fit is refused later */
}

void spline_fit_free(spline_fit *f)
{
    free(f->p);
    free(f->u);
    free(f->knot);
    free(f->first);
    free(f->c);
    free(f->weight);
    free(f->whole);
    *f = (spline_fit){ .e = f->e };
}

/* Halfway between points i - 1 and i, as the number type holds it. */
static double knot_before(const spline_fit *f, size_t i)
{
    double at = (f->u[i - 1] + f->u[i]) / 2;

    (void)f->e->hold(at, &at);
    return at;
}

/* One interval; a closed curve needs degree + 1. */
static void start_intervals(spline_fit *f)
{
    const size_t room = f->count + 4 * DEGREES, last = f->count - 1;

    f->knot   = tool_grow(f->knot, room * sizeof *f->knot);
    f->first  = tool_grow(f->first, room * sizeof *f->first);
    f->c      = tool_grow(f->c, room * sizeof *f->c);
    f->weight = tool_grow(f->weight, room * sizeof *f->weight);
    f->whole  = tool_grow(f->whole, room * sizeof *f->whole);
    f->intervals = f->closed ? f->degree + 1 : 1;
    for (size_t k = 0; k <= f->intervals; k++) {
        f->first[k] = k == f->intervals ? f->count : k * f->count / f->intervals;
        f->knot[k]  = k == 0 ? 0 : k == f->intervals ? f->u[last] : knot_before(f, f->first[k]);
    }
    for (size_t s = 0; s < f->count; s++)
        f->weight[s] = f->u[s < last ? s + 1 : s] - f->u[s > 0 ? s - 1 : 0];
}


// The spline
// ----------

double spline_fit_knot(const spline_fit *f, long i)
{
    const long n = (long)f->intervals;

    if (!f->closed)
        return f->knot[i < 0 ? 0 : i > n ? n : i];
    return i < 0 ? f->knot[i + n] - f->knot[n] : i > n ? f->knot[i - n] + f->knot[n] : f->knot[i];
}

/* The B-splines that are not 0 on interval k, and their derivatives (de Boor's recurrence). */
static void basis_values(const spline_fit *f, size_t k, double u, double value[], double deriv[])
{
    const int n = (int)f->degree;
    double left[DEGREES], right[DEGREES], lower[DEGREES] = { 1 };

    value[0] = 1;
    for (int j = 1; j <= n; j++) {
        double saved = 0;
        if (j == n)
            memcpy(lower, value, (size_t)n * sizeof *lower);
        left[j]  = u - spline_fit_knot(f, (long)k + 1 - j);
        right[j] = spline_fit_knot(f, (long)k + j) - u;
        for (int r = 0; r < j; r++) {
            const double part = value[r] / (right[r + 1] + left[j - r]);
            value[r] = saved + right[r + 1] * part;
            saved    = left[j - r] * part;
        }
        value[j] = saved;
    }
    for (int r = 0; r <= n; r++) {
        const long i = (long)k + r - n;
        deriv[r] = 0;
        if (r > 0)
            deriv[r] = n * lower[r - 1] / (spline_fit_knot(f, i + n) - spline_fit_knot(f, i));
        if (r < n)
            deriv[r] -= n * lower[r] / (spline_fit_knot(f, i + n + 1) - spline_fit_knot(f, i + 1));
    }
}

void spline_fit_eval(const spline_fit *f, size_t k, double u, double out[ENGINE_AXES],
                     double slope[ENGINE_AXES])
{
    double value[DEGREES], deriv[DEGREES];

    basis_values(f, k, u, value, deriv);
    for (int i = 0; i < ENGINE_AXES; i++) {
        out[i] = slope[i] = 0;
        for (size_t r = 0; r <= f->degree; r++) {
            out[i]   += value[r] * f->c[k + r][i];
            slope[i] += deriv[r] * f->c[k + r][i];
        }
    }
}

static int solve_spline(spline_fit *f)
{
    const unsigned points = (unsigned)f->intervals + f->degree;
    const engine_fit q = { (const double(*)[ENGINE_AXES])f->p,
                           f->u,
                           f->by_length ? f->weight : NULL,
                           f->count,
                           f->whole,
                           points,
                           f->degree,
                           f->closed };

    for (unsigned i = 0; i <= points + f->degree; i++)
        f->whole[i] = spline_fit_knot(f, (long)i - (long)f->degree);
    return f->e->fit(&q, f->c);
}


// Knots
// -----

/* The largest distance of interval k from the points, and the one at or after which it occurs. */
static double error_of(const spline_fit *f, size_t k, size_t *where)
{
    const int places = f->between ? BETWEEN : 0;
    double worst = 0;

    for (size_t s = f->first[k]; s < f->first[k + 1]; s++)
        for (int j = 0; j <= places && (j == 0 || s + 1 < f->count); j++) {
            const double part = (double)j / (places + 1),
                         u = j ? f->u[s] + part * (f->u[s + 1] - f->u[s]) : f->u[s];
            double at[ENGINE_AXES], slope[ENGINE_AXES], chord[ENGINE_AXES];
            if (u > f->knot[k + 1])
                break;
            spline_fit_eval(f, k, u, at, slope);
            for (int i = 0; i < ENGINE_AXES; i++)
                chord[i] = j ? f->p[s][i] + part * (f->p[s + 1][i] - f->p[s][i]) : f->p[s][i];
            const double off = space_distance(at, chord);
            if (off > worst) {
                worst  = off;
                *where = s;
            }
        }
    return worst;
}

double spline_fit_error(const spline_fit *f)
{
    double worst = 0;
    size_t where;

    for (size_t k = 0; k < f->intervals; k++)
        worst = fmax(worst, error_of(f, k, &where));
    return worst;
}

/* Is the curve of interval k no faster than the points are? By the legs of its control points. */
static bool speed_is_bounded(const spline_fit *f, size_t k, double within)
{
    const long n = (long)f->degree;

    for (long i = (long)k; i < (long)k + n; i++) {
        const double time = spline_fit_knot(f, i + 1) - spline_fit_knot(f, i + 1 - n);
        if (!((double)n * space_distance(f->c[i + 1], f->c[i]) <= SPEED * time + SLACK * within))
            return false;
    }
    return true;
}

/* Halve all intervals with an error above `within`, or where the curve is too fast. Returns how
 * many; SIZE_MAX if one cannot be halved, at point *where. */
static size_t refine_intervals(spline_fit *f, double within, size_t *where)
{
    const size_t before = f->intervals;
    size_t bad = 0, worst_at = 0;

    for (size_t k = before; k-- > 0;) {
        if (error_of(f, k, &worst_at) <= (f->between ? CHECKED : 1) * within &&
            speed_is_bounded(f, k, within))
            continue;
        const size_t middle = (f->first[k] + f->first[k + 1]) / 2;
        bad++;
        if (f->first[k + 1] - f->first[k] < 2 * LEAST) {
            *where = worst_at;
            return SIZE_MAX;
        }
        memmove(&f->knot[k + 2], &f->knot[k + 1], (f->intervals - k) * sizeof *f->knot);
        memmove(&f->first[k + 2], &f->first[k + 1], (f->intervals - k) * sizeof *f->first);
        f->first[k + 1] = middle;
        f->knot[k + 1]  = knot_before(f, middle);
        f->intervals++;
    }
    return bad;
}

bool spline_fit_within(spline_fit *f, double within, size_t *where)
{
    *where = 0;
    if (f->count < (f->closed ? 2 * f->degree + 2 : 2))
        return false;
    start_intervals(f);
    for (int round = 0; round < ROUNDS; round++) {
        if (f->count < f->intervals + f->degree || solve_spline(f) != 0)
            return false;
        const size_t bad = refine_intervals(f, within, where);
        if (bad == 0)
            return true;
        if (bad == SIZE_MAX)
            return false;
    }
    return false;
}
