/* host-tools/plan/grid_fit.c -- parameters, knots, and how many of them
 * SPDX-License-Identifier: MIT
 *
 * Parameters are the lengths of chords, in the mean of all rows or columns. A knot follows after
 * even shares of them, so that each span has points (The NURBS Book, 9.69).
 */
#include "plan/grid_fit.h"

#include <math.h>
#include <stdlib.h>

#include "num/status.h"         /* LOFT_OK */

#include "base/space.h"         /* space_distance */
#include "base/tool.h"          /* tool_grow */

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
    for (;;) {
        bool more = false;
        status = fit_once(g, e);
        if (status != LOFT_OK || g->off <= tol)
            return status;
        for (int k = 0; k < 2; k++) {
            const unsigned spans = g->points[k] - g->degree[k],
                           next = spans + (spans + 1) / 2 + g->degree[k];
            const unsigned to = next < g->count[k] ? next : g->count[k];
            more = more || to > g->points[k];
            g->points[k] = to;
        }
        if (!more)
            return status;
    }
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
