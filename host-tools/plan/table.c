/* host-tools/plan/table.c -- compares the box of a path with that of the table
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/source.h"         /* source_name */
#include "base/spool.h"          /* spool_passed */
#include "base/host.h"
#include "plan/table.h"

/* least[i] .. most[i], mm */
typedef struct {
    double least[ENGINE_AXES], most[ENGINE_AXES];
} table_box;

static bool axis_inside(const table_box *in, const table_box *table, int axis, double tol)
{
    return in->least[axis] >= table->least[axis] - tol && in->most[axis] <= table->most[axis] + tol;
}

static bool all_inside(const table_box *in, const table_box *table, double tol)
{
    bool inside = true;

    for (int i = 0; i < ENGINE_AXES; i++)
        inside = inside && axis_inside(in, table, i, tol);
    return inside;
}

static void include_place(table_box *b, const double at[ENGINE_AXES], int first)
{
    for (int i = first; i < ENGINE_AXES; i++) {
        b->least[i] = fmin(b->least[i], at[i]);
        b->most[i] = fmax(b->most[i], at[i]);
    }
}

/* The box from above; the heights are one more coordinate. */
static table_box box_of_drawing(const drawing *d)
{
    double box[2][2] = { { 0, 0 }, { 0, 0 } }, high[2][2];

    (void)drawing_box(d, box);
    table_box b = { { box[0][0], box[0][1], HUGE_VAL }, { box[1][0], box[1][1], -HUGE_VAL } };
    for (size_t i = 0; i < d->count; spool_passed(i++)) {
        drawing_curve up = { .path = 0 };
        const drawing one = { .curve = &up, .count = 1 };
        for (int k = 0; k < 4; k++)
            up.p[k][0] = d->curve[i].z[k];
        (void)drawing_box(&one, high);
        b.least[2] = fmin(b.least[2], high[0][0]);
        b.most[2] = fmax(b.most[2], high[1][0]);
    }
    return b;
}

/* Travels are straight, so the ends of the moves and the drawing contain the path. Lifting the pen
 * where the machine stands counts for z alone. */
static table_box box_of_path(const table_box *drawn, const toolpath *path)
{
    const double *start = path->move[0].p[0];
    bool away = false;
    table_box b = *drawn;

    for (size_t k = 0; k < path->count; spool_passed(k++)) {
        const double *at = path->move[k].p[3];
        away = away || at[0] != start[0] || at[1] != start[1];
        include_place(&b, at, away ? 0 : 2);
    }
    return b;
}

void table_ends(const machine_file *m, int axis, double *least, double *most)
{
    const bool limited = m->travel[axis] > 0;

    *least = limited ? m->min[axis] - m->zero[axis] : -HUGE_VAL;
    *most  = limited ? m->min[axis] - m->zero[axis] + m->travel[axis] : HUGE_VAL;
}

static table_box box_of_table(const machine_file *m)
{
    table_box b;

    for (int i = 0; i < ENGINE_AXES; i++)
        table_ends(m, i, &b.least[i], &b.most[i]);
    return b;
}

/* `x -5..215.3, y 10..287`: the axes on which the table ends. */
static void box_words(const table_box *b, const table_box *table, char *out, size_t room)
{
    size_t used = 0;

    out[0] = '\0';
    for (int i = 0; i < ENGINE_AXES; i++)
        if (table->most[i] < HUGE_VAL && used < room)
            used += (size_t)snprintf(out + used, room - used, "%s%c %.6g..%.6g", used ? ", " : "",
                                     "xyz"[i], b->least[i], b->most[i]);
}


// What would fit
// --------------

static double size_of(const table_box *b, int axis) { return b->most[axis] - b->least[axis]; }

/* The smallest move along an axis that brings the drawing inside; 0: it is. */
static double move_inside(const table_box *drawn, const table_box *table, int axis)
{
    return drawn->least[axis] < table->least[axis] ? table->least[axis] - drawn->least[axis]
                                                   : fmin(0, table->most[axis] - drawn->most[axis]);
}

/* The largest part of its size that fits, rounded down to a thousandth. */
static double fitting_part(const table_box *drawn, const table_box *table)
{
    double part = 1;

    for (int i = 0; i < 2; i++)
        part = fmin(part, size_of(table, i) / size_of(drawn, i));
    return floor(part * 1000) / 1000;
}

static void remedy_words(const table_box *drawn, const table_box *table, double tol, char *out,
                         size_t room)
{
    const double x = size_of(drawn, 0), y = size_of(drawn, 1), wide = size_of(table, 0) + 2 * tol,
                 high = size_of(table, 1) + 2 * tol;

    if (!axis_inside(drawn, table, 2, tol))
        snprintf(out, room, "the pen draws at z %.6g..%.6g: give a z.min and a z.travel around it",
                 drawn->least[2], drawn->most[2]);
    else if (axis_inside(drawn, table, 0, tol) && axis_inside(drawn, table, 1, tol))
        snprintf(out, room, "the drawing fits: give a lower --lift, and leave out --park");
    else if (x <= wide && y <= high)
        snprintf(out, room, "moved by %.6g,%.6g it fits", move_inside(drawn, table, 0),
                 move_inside(drawn, table, 1));
    else if (y <= wide && x <= high)
        snprintf(out, room, "turned by 90 degrees it fits");
    else
        snprintf(out, room, "at %.3g of its size it fits", fitting_part(drawn, table));
}

int table_check(host *h, const machine_file *m, const char *file, const drawing *d,
                const toolpath *path, double tol)
{
    if (path->count == 0)
        return 0;
    const table_box table = box_of_table(m), drawn = box_of_drawing(d),
                    all = box_of_path(&drawn, path);
    char takes[160], ends[160], remedy[120];

    if (all_inside(&all, &table, tol))
        return 0;
    box_words(&all, &table, takes, sizeof takes);
    box_words(&table, &table, ends, sizeof ends);
    remedy_words(&drawn, &table, tol, remedy, sizeof remedy);
    return host_error(h, EX_DATAERR, "table.left", (host_place){ source_name(file), 0 }, remedy,
                      "takes the tool to %s, and the table is %s", takes, ends);
}

const char *table_words(const drawing *d, const toolpath *path, char out[160])
{
    const table_box drawn = box_of_drawing(d);
    table_box all         = drawn;

    if (path->count > 0)
        all = box_of_path(&drawn, path);
    box_words(&all, &all, out, 160);
    return out;
}

int table_place(host *h, const machine_file *m, const double from[ENGINE_AXES],
                const double to[ENGINE_AXES], double tol)
{
    for (int i = 0; i < ENGINE_AXES; i++) {
        double least, most;
        table_ends(m, i, &least, &most);
        if (to[i] < fmin(least - tol, from[i]) || to[i] > fmax(most + tol, from[i]))
            return host_error(h, EX_DATAERR, "table.place", (host_place){ NULL, 0 }, "stay on it",
                              "%c %.6g is beyond the table, %.6g..%.6g", "xyz"[i], to[i], least,
                              most);
    }
    return 0;
}
