/* host-tools/svg/svg_rail.c -- paths that carry text
 * SPDX-License-Identifier: MIT
 *
 * The curves of the path, in user units, with their lengths.
 *   see  SVG 2, 11.8.2: Text on a path
 */
#include <math.h>
#include <stdlib.h>

#include "base/memory.h"
#include "svg/svg.h"

#define SAMPLES 32              /* of a curve */

bool svg_lay_rail(svg_reader *r, const xmlNode *node, const svg_space *space, svg_rail *out)
{
    drawing *const to    = r->d;
    const xmlNode *was   = r->node;
    svg_space alone      = *space;
    bool known           = true;
    const double factor  = svg_stretch(space->to_mm);

    *out        = (svg_rail){ .scale = factor > 0 ? factor : 1 };
    alone.to_mm = (svg_matrix){ out->scale, 0, 0, out->scale, 0, 0 };
    r->d        = &out->d;
    r->node     = node;
    char *turn  = svg_attribute(node, "transform");
    if (turn != NULL)
        svg_transform(r, turn, false, &alone.to_mm);
    xmlFree(turn);
    const bool good = svg_shape(r, &alone, &known);
    r->d    = to;
    r->node = was;
    out->until = memory_grow(NULL, (out->d.count * SAMPLES + 1) * sizeof *out->until);
    out->until[0] = 0;
    for (size_t i = 0; i < out->d.count * SAMPLES; i++) {
        const drawing_curve *c = &out->d.curve[i / SAMPLES];
        double a[2], b[2];
        drawing_eval(c, (double)(i % SAMPLES) / SAMPLES, a);
        drawing_eval(c, (double)(i % SAMPLES + 1) / SAMPLES, b);
        out->until[i + 1] = out->until[i] + hypot(b[0] - a[0], b[1] - a[1]) / out->scale;
    }
    out->length = out->until[out->d.count * SAMPLES];
    return good;
}

void svg_free_rail(svg_rail *l)
{
    drawing_free(&l->d);
    free(l->until);
}

bool svg_rail_at(const svg_rail *l, double distance, double at[2], double way[2])
{
    size_t low = 0, high = l->d.count * SAMPLES;

    if (!(distance >= 0 && distance <= l->length) || high == 0)
        return false;
    while (high - low > 1) {
        const size_t middle = (low + high) / 2;
        *(l->until[middle] <= distance ? &low : &high) = middle;
    }
    const drawing_curve *c = &l->d.curve[low / SAMPLES];
    const double part      = l->until[low + 1] - l->until[low];
    const double t =
        ((double)(low % SAMPLES) + (part > 0 ? (distance - l->until[low]) / part : 0)) / SAMPLES;
    double next[2], before[2];
    drawing_eval(c, t, at);
    drawing_eval(c, fmin(t + 0.5 / SAMPLES, 1), next);
    drawing_eval(c, fmax(t - 0.5 / SAMPLES, 0), before);
    drawing_deriv(c, t, way);
    if (!(hypot(way[0], way[1]) > 1e-9))
        for (int i = 0; i < 2; i++)
            way[i] = next[i] - before[i];
    const double length = hypot(way[0], way[1]);
    for (int i = 0; i < 2; i++) {
        way[i] = length > 0 ? way[i] / length : i == 0;
        at[i] /= l->scale;
    }
    return true;
}
