/* host-tools/engine/engine_cells.c -- how fine a grid shows all lines of a level; compiled once per
 * number type
 * SPDX-License-Identifier: MIT
 *
 * On each net of the surface (lib/surface/net.h) the level is the zero set of one polynomial,
 *
 *     g(x, y) = w(x, y) (d . S(x, y) - h)
 *
 * in Bernstein form. A part where all coefficients have one sign has no line. In a part where the
 * derivative of g in a direction has one sign, by the hull of the coefficients of g_x and g_y, g
 * grows along this direction: the line is a graph over the other one. It has no ring in the part,
 * and no two lines are joined in it. Other parts are halved in both parameters. A grid of marching
 * triangles that is at least as fine as the smallest of these parts crosses each such line as it
 * is. What stays open in the smallest parts is a peak, a saddle or an edge at the level itself, or
 * lines too close for the grid: there they may be joined otherwise.
 */
#include "engine/engine_cells.h"

#include <string.h>

#include "engine/engine_sheet.h"    /* engine_nets */

#define MOST       (LOFT_DEGREE_MAX + 1)
#define DIRECTIONS 8
#define MANY       4096             /* open parts: a plateau, of which no more is asked */

typedef struct {
    unsigned m, n;                  /* degrees */
    double c[MOST][MOST];
} polynomial;

typedef struct {
    engine_surface *e;
    const engine_level *of;
    unsigned most, needed;
    engine_doubt *doubt;
    const engine_net_part *part;
    double share;                   /* of the surface's parameters: of the net */
    unsigned deepest;
} search;

static double double_of_sci(loft_sci x)
{
    loft_acc wide;

    return loft_sci_to_acc(x, &wide) ? double_of_acc(wide) : 0;
}

static void load_level(const engine_level *of, loft_net net, polynomial *out)
{
    static loft_net_form f;
    double d[3] = { 0, 0, 1 }, length = 1;

    if (of->of == ENGINE_LEVEL_PLANE) {
        memcpy(d, of->direction, sizeof d);
        length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    }
    loft_net_load(net, (loft_vec){ { 0 } }, &f);
    out->m = f.axis[0].m;
    out->n = f.axis[0].n;
    for (unsigned i = 0; i <= out->m; i++)
        for (unsigned j = 0; j <= out->n; j++) {
            double sum = -of->value * (f.weighted ? double_of_sci(f.w.c[i][j]) : 1);
            for (int axis = 0; axis < 3; axis++)
                sum += d[axis] / length * double_of_sci(f.axis[axis].c[i][j]);
            out->c[i][j] = sum;
        }
}

/* The least and the largest coefficient of a derivative, or of the polynomial itself. */
static void find_range(const polynomial *p, int by, double out[2])
{
    const unsigned down = by == 0, right = by == 1;

    out[0] = INFINITY;
    out[1] = -INFINITY;
    for (unsigned i = 0; i + down <= p->m; i++)
        for (unsigned j = 0; j + right <= p->n; j++) {
            const double x = by < 0
                                 ? p->c[i][j]
                                 : (down ? p->m : p->n) * (p->c[i + down][j + right] - p->c[i][j]);
            out[0] = fmin(out[0], x);
            out[1] = fmax(out[1], x);
        }
}

static bool grows_somewhere(const polynomial *p)
{
    double by[2][2];

    if (p->m == 0 || p->n == 0)
        return false;
    find_range(p, 0, by[0]);
    find_range(p, 1, by[1]);
    for (int k = 0; k < DIRECTIONS; k++) {
        const double a = acos(-1) * k / DIRECTIONS, way[2] = { cos(a), sin(a) };
        double low = 0, high = 0;
        for (int i = 0; i < 2; i++) {
            low  += fmin(way[i] * by[i][0], way[i] * by[i][1]);
            high += fmax(way[i] * by[i][0], way[i] * by[i][1]);
        }
        if (low > 0 || high < 0)
            return true;
    }
    return false;
}

/* One half, by x or y, by de Casteljau's averages. */
static void halve(polynomial *p, bool by_x, bool upper)
{
    const unsigned degree = by_x ? p->m : p->n, lines = by_x ? p->n : p->m;

    for (unsigned line = 0; line <= lines; line++)
        for (unsigned r = 1; r <= degree; r++)
            for (unsigned k = degree; k >= r; k--) {
                const unsigned at = upper ? degree - k : k, from = upper ? at + 1 : at - 1;
                double *const x = by_x ? &p->c[at][line] : &p->c[line][at];
                *x = (*x + (by_x ? p->c[from][line] : p->c[line][from])) / 2;
            }
}

/* A part where the smallest cell does not tell the lines. */
static void doubt_part(search *z, unsigned level, unsigned i, unsigned j)
{
    engine_doubt *const doubt = z->doubt;
    const double size = ldexp(1, -(int)level), at[2] = { (i + 0.5) * size, (j + 0.5) * size };

    if (doubt->parts++ == 0)
        engine_net_place(z->part, at[0], at[1], doubt->at);
}

static void look_at_part(search *z, const polynomial *p, unsigned level, unsigned i, unsigned j)
{
    double range[2];
    polynomial half;

    find_range(p, -1, range);
    if (range[0] > 0 || range[1] < 0 || z->doubt->parts > MANY)
        return;
    if (grows_somewhere(p)) {
        const double cells = 2 * ldexp(1, (int)level) / z->share;
        z->needed = cells > z->needed ? (unsigned)ceil(fmin(cells, z->most)) : z->needed;
        return;
    }
    if (level == z->deepest) {
        doubt_part(z, level, i, j);
        return;
    }
    for (unsigned k = 0; k < 4; k++) {
        half = *p;
        halve(&half, true, k / 2);
        halve(&half, false, k % 2);
        look_at_part(z, &half, level + 1, 2 * i + k / 2, 2 * j + k % 2);
    }
}

static int look_at_net(void *context, loft_net net, const engine_net_part *part)
{
    search *const z = context;
    polynomial p;

    z->part  = part;
    z->share = 0;
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 2; i++)
            z->share = fmax(z->share, fabs(part->share[k][i]));
    z->share   = z->share > 0 ? z->share : 1;
    z->deepest = (unsigned)fmax(0, ceil(log2(z->most * z->share) - 1e-9));
    load_level(z->of, net, &p);
    look_at_part(z, &p, 0, 0, 0);
    return LOFT_OK;
}

int ENGINE_OF(engine_cells)(engine_surface *e, const engine_level *of, unsigned most, unsigned *n,
                            engine_doubt *doubt)
{
    search z = { .e = e, .of = of, .most = most, .needed = *n, .doubt = doubt };

    *doubt = (engine_doubt){ .parts = 0 };
    if (of->of == ENGINE_LEVEL_ANGLE)
        return LOFT_OK;
    const int status = ENGINE_OF(engine_nets)(e, look_at_net, &z);
    if (status == LOFT_OK)
        *n = z.needed;
    return status == LOFT_ERR_ARG ? LOFT_OK : status;
}
