/* host-tools/mill/stock.c -- the block out of which a mill cuts surfaces
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/host.h"
#include "base/memory.h"
#include "draw/mesh.h"
#include "mill/stock.h"

#define SLACK 2e-3              /* mm: what rounding may take */

bool stock_parse(const char *text, void *out)
{
    stock *s = out;
    double *const d = s->size, *const p = s->low;
    char rest = 0;
    const int read = sscanf(text, "%lfx%lfx%lf@%lf,%lf,%lf%c", &d[0], &d[1], &d[2], &p[0], &p[1],
                            &p[2], &rest);

    s->given  = read == 6;
    s->placed = read == 6;
    if (read == 3)
        s->given = sscanf(text, "%lfx%lfx%lf%c", &d[0], &d[1], &d[2], &rest) == 3;
    for (int k = 0; k < 3 && s->given; k++)
        s->given = d[k] > 0 && d[k] <= STOCK_MOST && (read == 3 || fabs(p[k]) <= STOCK_MOST);
    return s->given;
}

/* True if a vertex is inside of the loops: a ray from it crosses them an odd number of times. */
static bool is_kept(const mill_trim *trim, const mesh_vertex *v)
{
    const double at[2] = { trim->plane ? v->p[0] : v->u, trim->plane ? v->p[1] : v->v };
    bool inside = trim->count == 0;

    for (size_t i = 0; i < trim->count; i++) {
        const double *const a = trim->edge[i][0], *const b = trim->edge[i][1];
        if ((a[1] > at[1]) != (b[1] > at[1]) &&
            at[0] < a[0] + (at[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
            inside = !inside;
    }
    return inside;
}

static void widen(double box[2][3], const double p[3])
{
    for (int k = 0; k < 3; k++) {
        box[0][k] = fmin(box[0][k], p[k]);
        box[1][k] = fmax(box[1][k], p[k]);
    }
}

/* The box of one surface; an empty one is from INFINITY to -INFINITY. */
static int find_box(host *h, const surface *s, unsigned n, const mill_trim *trim, const char *file,
                    double box[2][3])
{
    surface copy = *s;
    const surfaces one = { .surface = &copy, .count = 1 };
    mesh m = { 0 };
    const int code = mesh_make(h, &m, &one, file, &engine_f64, n, n);

    for (int k = 0; k < 3; k++) {
        box[0][k] = INFINITY;
        box[1][k] = -INFINITY;
    }
    for (size_t i = 0; i < m.vertices && code == 0; i++)
        if (is_kept(trim, &m.vertex[i]))
            widen(box, m.vertex[i].p);
    mesh_free(&m);
    return code;
}

/* By how much a box is beyond the block, at worst; 0: it is not. */
static double beyond(const stock *s, double box[2][3], int *axis, bool *above)
{
    double most = 0;

    for (int k = 0; k < 6; k++) {
        const int a = k / 2;
        const double by = k % 2 ? box[1][a] - s->low[a] - s->size[a] : s->low[a] - box[0][a];
        if (by > SLACK && by > most) {
            most   = by;
            *axis  = a;
            *above = k % 2;
        }
    }
    return most;
}

int stock_place(host *h, stock *s, const surfaces *all, const mill_trim *trim, const char *file)
{
    const unsigned n = all->count <= 16 ? 96 : 16;
    double (*const box)[2][3] = memory_grow(NULL, (all->count + 1) * sizeof *box),
                  (*const whole)[3] = box[all->count];
    int code = 0, axis = 0;
    bool above = false;

    for (size_t i = 0; i < all->count && code == 0; i++) {
        code = find_box(h, &all->surface[i], n, trim, file, box[i]);
        for (int k = 0; k < 3 && code == 0; k++) {
            whole[0][k] = i == 0 ? box[i][0][k] : fmin(whole[0][k], box[i][0][k]);
            whole[1][k] = i == 0 ? box[i][1][k] : fmax(whole[1][k], box[i][1][k]);
        }
    }
    if (code == 0 && !s->placed && whole[0][0] <= whole[1][0]) {
        for (int k = 0; k < 3; k++) {
            const double high = k < 2 ? (whole[0][k] + whole[1][k] + s->size[k]) / 2 : whole[1][k];
            s->low[k] = ceil(high * 1000 - 1e-6) / 1000 - s->size[k];
        }
        s->placed = true;
    }
    for (size_t i = 0; i < all->count && code == 0 && s->placed; i++) {
        const double by = beyond(s, box[i], &axis, &above);
        if (by > 0)
            code = host_error(
                h, EX_DATAERR, "stock.surface-outside", (host_place){ file, all->surface[i].line },
                "give a larger --stock, or another place: WxDxH@X,Y,Z",
                "%s: reaches to %c %.3f, %.3f mm %s the block", surface_name(all->surface[i].kind),
                "xyz"[axis], box[i][above][axis], by, axis == 2 && !above ? "below" : "beyond");
    }
    free(box);
    return code;
}

int stock_holds(host *h, const stock *s, const mill_cut *path, const char *file)
{
    double box[2][3];
    int axis = 0;
    bool above = false;

    if (path->count == 0)
        return 0;
    memcpy(box[0], path->point[0], sizeof box[0]);
    memcpy(box[1], path->point[0], sizeof box[1]);
    for (size_t i = 1; i < path->count; i++)
        widen(box, path->point[i]);
    box[1][2] = s->low[2];                  /* above it the tool may be anywhere */
    const double by = beyond(s, box, &axis, &above);
    if (!(by > 0))
        return 0;
    return host_error(h, EX_DATAERR, "stock.lines-outside", (host_place){ file, 0 },
                      axis == 2 ? "give a thicker --stock, or a higher --floor"
                                : "give a larger --stock, or a smaller --area",
                      "the lines reach to %c %.3f, %.3f mm %s the block", "xyz"[axis],
                      box[above][axis], by, axis == 2 ? "below" : "beyond");
}
