/* host-tools/mill/mill_trim.c -- closed loops of a drawing, to which surfaces are trimmed
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>
#include <string.h>

#include "base/host.h"
#include "base/memory.h"        /* memory_grow */
#include "base/source.h"        /* source_name */
#include "read/drawing.h"
#include "mill/mill_trim.h"
#include "readers.h"

static void add_edge(mill_trim *t, const double from[2], const double to[2])
{
    if (from[0] == to[0] && from[1] == to[1])
        return;
    if ((t->count & (t->count - 1)) == 0)
        t->edge = memory_grow(t->edge, (t->count ? 2 * t->count : 1) * sizeof *t->edge);
    memcpy(t->edge[t->count][0], from, sizeof t->edge[0][0]);
    memcpy(t->edge[t->count++][1], to, sizeof t->edge[0][1]);
}

/* Where the chords of a loop are. */
typedef struct {
    mill_trim *trim;
    double at[2];
} walk;

static void give_chord(void *context, const double point[ENGINE_AXES])
{
    walk *const w = context;

    add_edge(w->trim, w->at, point);
    memcpy(w->at, point, sizeof w->at);
}

/* The chords of one path, which ends where it begins. */
static int add_loop(host *h, mill_trim *t, const char *file, const drawing *d, size_t first,
                    size_t end)
{
    const drawing_curve *const last = &d->curve[end - 1];
    walk w = { t, { d->curve[first].p[0][0], d->curve[first].p[0][1] } };

    if (last->p[3][0] != w.at[0] || last->p[3][1] != w.at[1])
        return host_error(h, EX_DATAERR, "trim.open-path",
                          (host_place){ source_name(file), d->curve[first].line },
                          "let it end where it begins",
                          "a path is open: a region needs closed ones");
    for (size_t i = first; i < end; i++) {
        double p[4][ENGINE_AXES] = { { 0 } };
        for (int k = 0; k < 4; k++)
            memcpy(p[k], d->curve[i].p[k], sizeof d->curve[i].p[k]);
        if (engine_f64.flatten((const double(*)[ENGINE_AXES])p, t->tol, give_chord, &w) != 0)
            return host_error(h, EX_DATAERR, "trim.not-flattened",
                              (host_place){ source_name(file), d->curve[i].line }, NULL,
                              "cannot be flattened");
    }
    return 0;
}

int mill_trim_read(host *h, mill_trim *t, const char *file)
{
    drawing d = { 0 };
    int code = drawing_read(h, &d, file);

    for (size_t first = 0; first < d.count && code == 0; ) {
        size_t end = first + 1;
        while (end < d.count && d.curve[end].path == d.curve[first].path)
            end++;
        code = add_loop(h, t, file, &d, first, end);
        first = end;
    }
    drawing_free(&d);
    if (code == 0 && t->count < 3)
        code = host_error(h, EX_DATAERR, "trim.no-loop", (host_place){ source_name(file), 0 },
                          "give closed paths", "no loop in it");
    return code;
}

void mill_trim_free(mill_trim *t)
{
    free(t->edge);
    *t = (mill_trim){ 0 };
}
