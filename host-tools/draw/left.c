/* host-tools/draw/left.c -- what a mill left on surfaces
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/tool.h"          /* tool_grow */
#include "draw/left.h"

/* The bin of a place, limited to the bins that exist. */
static size_t bin_along(const left_over *l, int axis, double x)
{
    const double k = floor((x - l->low[axis]) / l->size);

    return k < 0 ? 0 : k >= (double)l->bins[axis] ? l->bins[axis] - 1 : (size_t)k;
}

static size_t bin_of(const left_over *l, const double at[3])
{
    return bin_along(l, 1, at[1]) * l->bins[0] + bin_along(l, 0, at[0]);
}

static size_t first_of_work(const record *r)
{
    size_t first = 1;

    while (first < r->count && r->pulse[first].at[2] >= r->pulse[first - 1].at[2])
        first++;
    return first < r->count ? first : 0;
}

void left_make(left_over *l, const record *r, double radius, double corner)
{
    const size_t first = first_of_work(r);
    double high[2] = { 0, 0 };

    *l = (left_over){ .radius = radius, .corner = corner, .size = radius / 2 };
    for (size_t i = first; i < r->count; i++)
        for (int k = 0; k < 2; k++) {
            l->low[k] = i == first ? r->pulse[i].at[k] : fmin(l->low[k], r->pulse[i].at[k]);
            high[k] = i == first ? r->pulse[i].at[k] : fmax(high[k], r->pulse[i].at[k]);
        }
    l->size = fmax(l->size, fmax(high[0] - l->low[0], high[1] - l->low[1]) / 2000);
    for (int k = 0; k < 2; k++)
        l->bins[k] = (size_t)((high[k] - l->low[k]) / l->size) + 1;
    const size_t bins = l->bins[0] * l->bins[1];
    l->start = tool_grow(NULL, (bins + 2) * sizeof *l->start);
    memset(l->start, 0, (bins + 2) * sizeof *l->start);
    l->count = r->count - first;
    l->tip = tool_grow(NULL, (l->count + 1) * sizeof *l->tip);
    for (size_t i = first; i < r->count; i++)
        l->start[bin_of(l, r->pulse[i].at) + 2]++;
    for (size_t b = 2; b < bins + 2; b++)
        l->start[b] += l->start[b - 1];
    for (size_t i = first; i < r->count; i++)       /* afterwards start[b] is where bin b begins */
        memcpy(l->tip[l->start[bin_of(l, r->pulse[i].at) + 1]++], r->pulse[i].at, sizeof *l->tip);
}

void left_free(left_over *l)
{
    free(l->tip);
    free(l->start);
}

/* The underside of the tool over x, y; infinite beyond its radius. */
static double underside(const left_over *l, const double tip[3], const double p[3])
{
    const double d = hypot(p[0] - tip[0], p[1] - tip[1]), x = d - (l->radius - l->corner);

    if (d > l->radius)
        return INFINITY;
    return tip[2] + (x > 0 ? l->corner - sqrt(fmax(0, l->corner * l->corner - x * x)) : 0);
}

/* How deep a point is in the tool, whose shank is a cylinder: 0 beyond it. */
static double depth(const left_over *l, const double tip[3], const double p[3])
{
    const double h = p[2] - tip[2],
                 x = hypot(p[0] - tip[0], p[1] - tip[1]) - (l->radius - l->corner);
    const double inside = h >= l->corner ? fmin(h, l->corner - x)
                          : x <= 0       ? h
                                         : l->corner - hypot(x, l->corner - h);

    return fmax(0, inside);
}

double left_at(void *context, const mesh_vertex *v)
{
    left_over *l = context;
    double height = INFINITY, cut = 0;

    if (l->count == 0)
        return 0;
    for (size_t j = bin_along(l, 1, v->p[1] - l->radius); j <= bin_along(l, 1, v->p[1] + l->radius);
         j++)
        for (size_t i = bin_along(l, 0, v->p[0] - l->radius);
             i <= bin_along(l, 0, v->p[0] + l->radius); i++) {
            const size_t bin = j * l->bins[0] + i;
            for (size_t k = l->start[bin]; k < l->start[bin + 1]; k++) {
                height = fmin(height, underside(l, l->tip[k], v->p));
                cut    = fmax(cut, depth(l, l->tip[k], v->p));
            }
        }
    if (height == INFINITY)
        return 0;
    const double over = cut > 0 ? -cut : (height - v->p[2]) * fabs(v->normal[2]);
    l->most[0] = fmax(l->most[0], -over);
    l->most[1] = fmax(l->most[1], over);
    return over;
}
