/* host-tools/fit/grid_fit.c -- parameters, knots, and how many of them
 * SPDX-License-Identifier: MIT
 *
 * Parameters are the lengths of chords, in the mean of all rows or columns. A knot follows after
 * even shares of them, so that each span has points (The NURBS Book, 9.69).
 *
 * With as many control points as points the equations of (9.69) can be nearly singular, and the net
 * meets all points with control points anywhere. So along each direction there are at most 2
 * control points for 3 points, but degree + 1. And the net must be no faster than the points: along
 * each direction the derivative lies in the hull of degree (c_i+1 - c_i) / (t_i+degree+1 - t_i+1).
 * Each is at most SPEED times the largest chord between neighbouring points over the step of their
 * parameters, and SLACK tolerances over the step of knots more. This bounds the surface between the
 * points as spline_fit.c says for curves.
 */
#include "fit/grid_fit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "num/status.h"         /* LOFT_OK */

#include "base/space.h"         /* space_distance */
#include "base/tool.h"          /* tool_grow */

#define SPEED 2
#define SLACK 4


static const double *point_at(const grid_fit *g, int along, unsigned k, unsigned line)
{
    return along == 0 ? g->p[(size_t)k * g->count[1] + line] : g->p[(size_t)line * g->count[1] + k];
}

/* False if two neighbouring rows are one. */
static bool set_parameters(grid_fit *g, int along)
{
    const unsigned count = g->count[along], lines = g->count[1 - along];
    double *const at = g->at[along] = tool_grow(NULL, count * sizeof *at);

    at[0] = 0;
    for (unsigned k = 1; k < count; k++) {
        double sum = 0;
        for (unsigned line = 0; line < lines; line++)
            sum += space_distance(point_at(g, along, k, line), point_at(g, along, k - 1, line));
        if (!(sum > 0))
            return false;
        at[k] = at[k - 1] + sum;
    }
    for (unsigned k = 1; k < count; k++)
        at[k] = k + 1 == count ? 1 : at[k] / at[count - 1];
    return true;
}

static void set_knots(grid_fit *g, int along)
{
    const unsigned n = g->points[along], p = g->degree[along], spans = n - p;
    const double share = (double)g->count[along] / spans;

    for (unsigned k = 0; k <= n + p; k++)
        g->knot[along][k] = k > p && k >= n ? 1 : 0;
    for (unsigned j = 1; j < spans; j++) {
        const unsigned i = (unsigned)(j * share);
        const double *at = g->at[along] + i;
        g->knot[along][p + j] = at[-1] + (j * share - i) * (at[0] - at[-1]);
    }
}

static int fit_once(grid_fit *g, const engine *e)
{
    const engine_grid_fit f = {
        (const double(*)[ENGINE_AXES])g->p, { g->at[0], g->at[1] },
        { g->knot[0], g->knot[1] },         { g->count[0], g->count[1] },
        { g->points[0], g->points[1] },     { g->degree[0], g->degree[1] }
    };

    set_knots(g, 0);
    set_knots(g, 1);
    g->net = tool_grow(g->net, (size_t)g->points[0] * g->points[1] * sizeof *g->net);
    return e->fit_grid(&f, g->net, &g->off);
}

/* Along one direction: the largest chord over the step of its parameters. */
static double points_speed(const grid_fit *g, int along)
{
    double most = 0;

    for (unsigned k = 1; k < g->count[along]; k++)
        for (unsigned line = 0; line < g->count[1 - along]; line++)
            most = fmax(
                most, space_distance(point_at(g, along, k, line), point_at(g, along, k - 1, line)) /
                          (g->at[along][k] - g->at[along][k - 1]));
    return most;
}

/* The length by which a leg of the net is too long for SPEED. */
static double net_excess(const grid_fit *g, int along)
{
    const unsigned n = g->degree[along], step = along == 0 ? g->points[1] : 1;
    const double speed = SPEED * points_speed(g, along);
    double most = 0;

    for (unsigned i = 0; i + 1 < g->points[along]; i++)
        for (unsigned line = 0; line < g->points[1 - along]; line++) {
            const size_t from = along == 0 ? (size_t)i * step + line
                                           : (size_t)line * g->points[1] + i;
            const double time = g->knot[along][i + n + 1] - g->knot[along][i + 1];
            most = fmax(most, n * space_distance(g->net[from], g->net[from + step]) - speed * time);
        }
    return most;
}

/* More spans along both; false if the points do not tell them. */
static bool refine(grid_fit *g)
{
    bool more = false;

    for (int k = 0; k < 2; k++) {
        const unsigned spans = g->points[k] - g->degree[k],
                       next = spans + (spans + 1) / 2 + g->degree[k], most = 2 * g->count[k] / 3,
                       to = next < most ? next : most;
        more = more || to > g->points[k];
        g->points[k] = to > g->points[k] ? to : g->points[k];
    }
    return more;
}

int grid_fit_make(grid_fit *g, const engine *e, unsigned degree, double tol)
{
    int status = LOFT_OK;

    for (int k = 0; k < 2; k++) {
        if (!set_parameters(g, k))
            return LOFT_SINGULAR;
        g->degree[k] = g->count[k] > degree ? degree : g->count[k] - 1;
        g->points[k] = g->degree[k] + 1;
        g->knot[k]   = tool_grow(NULL, (g->count[k] + degree + 1) * sizeof *g->knot[k]);
    }
    g->enough = INFINITY;
    do {
        status = fit_once(g, e);
        if (status != LOFT_OK)
            break;
        const double need = fmax(g->off, fmax(net_excess(g, 0), net_excess(g, 1)) / SLACK);
        if (need < g->enough) {
            g->enough = need;
            memcpy(g->best, g->points, sizeof g->best);
        }
    } while (!(g->enough <= tol) && refine(g));
    return g->enough < INFINITY ? LOFT_OK : status;
}

void grid_fit_free(grid_fit *g)
{
    for (int k = 0; k < 2; k++) {
        free(g->at[k]);
        free(g->knot[k]);
    }
    free(g->net);
    free(g->p);
}
