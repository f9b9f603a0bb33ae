/* host-tools/arrange/tools.c -- sorts a drawing by the tools of the machine
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/source.h"            /* source_name */
#include "base/host.h"
#include "base/memory.h"
#include "base/tool.h"
#include "engine/curve.h"           /* curves_free */
#include "arrange/tools.h"

static double height_of(const machine_tool *t) { return isnan(t->pen_down) ? 0 : t->pen_down; }

double tools_lift(const machine_tool *tool, double usual)
{
    return tool == NULL || isnan(tool->pen_up) ? usual : tool->pen_up - height_of(tool);
}

double tools_most_lift(const machine_tools *t, double usual)
{
    double most = usual;

    for (unsigned i = 0; i < t->count; i++)
        most = fmax(most, tools_lift(&t->tool[i], usual));
    return most;
}

static int check_heights(host *h, const machine_tools *t)
{
    for (unsigned i = 0; i < t->count; i++)
        if (!(tools_lift(&t->tool[i], 1) >= 0))
            return host_error(h, EX_DATAERR, "tools.height", (host_place){ NULL, 0 },
                              "lift it higher", "tool %s: pen_up is %g mm, below pen_down of %g mm",
                              t->tool[i].name, t->tool[i].pen_up, height_of(&t->tool[i]));
    return 0;
}

/* Append what this tool draws, 0: none, as it draws it. */
static void take_part(const machine_tools *t, unsigned number, const drawing *d, drawing *to)
{
    const machine_tool *tool = number > 0 ? &t->tool[number - 1] : NULL;
    size_t last              = 0;

    for (size_t i = 0, any = 0; i < d->count; i++) {
        drawing_curve c = d->curve[i];
        if (c.tool != number)
            continue;
        const bool fresh = any == 0 || last + 1 != i || c.path != d->curve[last].path;
        if (tool != NULL && tool->feed > 0)
            c.feed = tool->feed;
        for (int k = 0; k < 4 && tool != NULL; k++)
            c.z[k] += height_of(tool);
        drawing_add_like(to, &c, fresh);
        last = i;
        any  = 1;
    }
}

int tools_apply(host *h, const machine_tools *t, drawing *d, const char *file)
{
    drawing sorted = { .width = d->width, .height = d->height };
    unsigned rest  = 0;
    size_t none    = 0;
    const unsigned warned = h->warnings;
    const int code = check_heights(h, t);

    if (t->count == 0 || d->program || d->count == 0 || code != 0)
        return code;
    for (unsigned i = t->count; i > 0; i--)
        rest = machine_tool_draws_rest(&t->tool[i - 1]) ? i : rest;
    for (size_t i = 0; i < d->count; i++) {
        d->curve[i].tool = d->curve[i].tool ? d->curve[i].tool : rest;
        none += d->curve[i].tool == 0;
    }
    if (none > 0)
        host_warn(h, "tools.none-for", (host_place){ source_name(file), 0 },
                  "give a tool without colours and layers",
                  "%zu curve%s belong%s to no tool, and %s drawn first", none, tool_s(none),
                  none == 1 ? "s" : "", none == 1 ? "is" : "are");
    for (unsigned i = 0; i <= t->count; i++)
        take_part(t, i, d, &sorted);
    drawing_free(d);
    *d = sorted;
    return host_code(h, warned, 0);
}

/* The end of the part that begins at `first`. */
static size_t part_end(const drawing *d, size_t first)
{
    size_t last = first;

    while (last < d->count && d->curve[last].tool == d->curve[first].tool)
        last++;
    return last;
}

static size_t layer_end(const drawing *d, size_t first)
{
    size_t last = first;

    while (last < d->count && d->curve[last].tool == d->curve[first].tool &&
           d->curve[last].layer == d->curve[first].layer)
        last++;
    return last;
}

static int compare_layers(const void *a, const void *b)
{
    const drawing_curve *x = *(const drawing_curve *const *)a,
                        *y = *(const drawing_curve *const *)b;

    if (x->tool != y->tool)
        return x->tool > y->tool ? 1 : -1;
    if (x->layer != y->layer)
        return x->layer > y->layer ? 1 : -1;
    return (x > y) - (x < y);
}

/* Bring together what each layer has: copies of a drawing and layers in layers part it. */
static void sort_layers(host *h, drawing *d, const char *file)
{
    const drawing_curve **all = memory_grow(NULL, d->count * sizeof(drawing_curve *));
    drawing sorted            = { .width = d->width, .height = d->height };
    bool any                  = false;

    for (size_t i = 0; i < d->count; i++) {
        all[i] = &d->curve[i];
        any    = any || all[i]->layer > 0;
    }
    if (!any)
        host_warn(h, "order.no-layers", (host_place){ source_name(file), 0 },
                  "--order best orders all of it", "it has no layers of Inkscape");
    qsort(all, d->count, sizeof *all, compare_layers);
    for (size_t i = 0; i < d->count; i++)
        drawing_add_like(&sorted, all[i],
                         i == 0 || all[i] != all[i - 1] + 1 || all[i]->path != all[i - 1]->path);
    free(all);
    drawing_free(d);
    *d = sorted;
}

static void append(drawing *to, const drawing *from)
{
    for (size_t i = 0; i < from->count; i++)
        drawing_add_like(to, &from->curve[i],
                         i == 0 || from->curve[i].path != from->curve[i - 1].path);
}

int tools_order(host *h, const order_options *o, drawing *d, const double from[2], bool returns,
                const char *file)
{
    const bool layers = o->how != NULL && strcmp(o->how, "layer") == 0;
    size_t (*end)(const drawing *, size_t) = layers ? layer_end : part_end;
    drawing ordered = { .width = d->width, .height = d->height };
    double at[2]    = { from[0], from[1] };
    const unsigned warned = h->warnings;
    int code        = 0;

    if (layers && !d->program && d->count > 0)
        sort_layers(h, d, file);
    code = host_code(h, warned, code);
    if (code == 0 && (d->program || end(d, 0) == d->count))
        return order_apply(h, o, d, from, returns, file);
    for (size_t first = 0, last; first < d->count && code == 0; first = last) {
        drawing part = { .count = 0 };
        last         = end(d, first);
        for (size_t i = first; i < last; i++)
            drawing_add_like(&part, &d->curve[i],
                             i > first && d->curve[i].path != d->curve[i - 1].path);
        code = order_apply(h, o, &part, at, returns && last == d->count, file);
        if (part.count > 0)
            memcpy(at, part.curve[part.count - 1].p[3], sizeof at);
        append(&ordered, &part);
        drawing_free(&part);
    }
    drawing_free(d);
    *d = ordered;
    return code;
}

/* Events before a curve belong to its part, those at the end to the last one. */
static void take_events(drawing *part, const drawing *d, size_t first, size_t last)
{
    part->taken = d->taken + first;
    while (part->events > 0 && part->event->before < part->taken)
        part->event++, part->events--;
    while (part->events > 0 && last < d->count &&
           part->event[part->events - 1].before >= d->taken + last)
        part->events--;
}

static drawing view_of(const drawing *d, size_t first, size_t last)
{
    drawing part = *d;

    part.curve = d->curve + first;
    part.count = last - first;
    take_events(&part, d, first, last);
    part.of    = NULL;
    return part;
}

size_t tools_split(const machine_tools *t, const drawing *d, const drawing *smooth,
                   tools_part part[TOOLS_PARTS])
{
    size_t parts = 0, first = 0;

    part[0] = (tools_part){ .d = *d, .smooth = *smooth };
    if (t->count == 0 || d->count == 0)
        return 1;
    for (size_t i = 0; i < d->count; parts++) {
        if (parts == TOOLS_PARTS)
            return 0;
        const unsigned number = d->curve[i].tool;
        const size_t last = part_end(d, i), end = part_end(smooth, first);
        part[parts] = (tools_part){ .tool   = number > 0 ? &t->tool[number - 1] : NULL,
                                    .d      = view_of(d, i, last),
                                    .smooth = view_of(smooth, first, end) };
        i     = last;
        first = end;
    }
    return parts;
}

void tools_counted(const drawing *part, double out[3])
{
    const drawing_curve *c = part->curve;

    for (int i = 0; i < 3; i++)
        out[i] = c->loose[0] >> i & 1 ? (i < 2 ? c->p[0][i] : c->z[0]) : 0;
}
