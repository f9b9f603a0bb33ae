/* host-tools/draw/mesh_contour.c -- lines of equal height on a mesh
 * SPDX-License-Identifier: MIT
 *
 * A vertex at the height itself counts as above it. So a contour crosses two edges of a triangle,
 * or none.
 */
#include <math.h>

#include "draw/mesh_contour.h"
#include "draw/plot.h"       /* plot_step */

static void cross_edge(const double a[ENGINE_AXES], const double b[ENGINE_AXES], double height,
                       double out[ENGINE_AXES])
{
    const double share = (height - a[2]) / (b[2] - a[2]);

    for (int i = 0; i < ENGINE_AXES; i++)
        out[i] = i == 2 ? height : a[i] + share * (b[i] - a[i]);
}

static void cross_triangle(const mesh *m, size_t cell, const size_t corner[3], double height,
                           contour_sink *sink, void *context)
{
    const double *p[3];
    double end[2][ENGINE_AXES];
    int ends = 0;

    for (int k = 0; k < 3; k++)
        p[k] = m->vertex[corner[k]].p;
    for (int k = 0; k < 3; k++) {
        const double *low = p[k], *high = p[(k + 1) % 3];
        if ((low[2] < height) == (high[2] < height))
            continue;
        cross_edge(low[2] < height ? low : high, low[2] < height ? high : low, height,
                   end[ends++ % 2]);
    }
    if (ends == 2)
        sink(context, cell, end[0], end[1]);
}

double plot_step(double range, double count)
{
    const double least = range / count, power = pow(10, floor(log10(least)));

    return least <= power       ? power
           : least <= 2 * power ? 2 * power
           : least <= 5 * power ? 5 * power
                                : 10 * power;
}

void contour_lines(const mesh *m, double height, contour_sink *sink, void *context)
{
    for (size_t i = 0; i < m->cells; i++) {
        const size_t *c = m->cell[i].corner, first[3] = { c[0], c[1], c[2] },
                     second[3] = { c[0], c[2], c[3] };
        cross_triangle(m, i, first, height, sink, context);
        if (c[2] != c[3])
            cross_triangle(m, i, second, height, sink, context);
    }
}

size_t contour_heights(const mesh *m, unsigned count, double out[], size_t most)
{
    double least = INFINITY, highest = -INFINITY;
    size_t found = 0;

    for (size_t i = 0; i < m->vertices; i++) {
        least   = fmin(least, m->vertex[i].p[2]);
        highest = fmax(highest, m->vertex[i].p[2]);
    }
    if (!(highest > least))
        return 0;
    const double step = plot_step(highest - least, count);
    for (double z = floor(least / step) + 1; z * step < highest && found < most; z++)
        out[found++] = z * step;
    return found;
}
