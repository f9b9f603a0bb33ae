/* host-tools/arrange/areas.c -- strokes as areas, and painted areas cut at their clip paths
 * SPDX-License-Identifier: MIT
 */
#include <string.h>

#include "base/source.h"        /* source_name */
#include "base/host.h"
#include "arrange/areas.h"
#include "arrange/region.h"

/* Append the outlines of an area, as curves like this one. */
static int put_area(host *h, const region *area, const drawing_curve *like, drawing *out,
                    const char *file)
{
    region_rings rings;
    int code = 0;

    region_outlines(area, &rings);
    for (size_t i = 0; i < rings.count && code == 0; i++) {
        const region_ring *ring = &rings.ring[i];
        for (size_t k = 0; k < ring->count; k++) {
            drawing_curve c = *like;
            const double *from = ring->point[k], *to = ring->point[(k + 1) % ring->count];
            for (int j = 0; j < 4; j++)
                for (int n = 0; n < 2; n++)
                    c.p[j][n] = j == 3 ? to[n] : from[n] + (to[n] - from[n]) * j / 3;
            drawing_add_like(out, &c, k == 0);
        }
        if (out->count > DRAWING_CURVES_MAX)
            code = host_error(h, EX_DATAERR, "areas.too-many-curves",
                              (host_place){ source_name(file), like->line }, "split the drawing",
                              "more than %u curves", DRAWING_CURVES_MAX);
    }
    region_rings_free(&rings);
    return code;
}

static void keep(const drawing *d, size_t first, size_t last, unsigned fill, drawing *out)
{
    for (size_t i = first; i < last; i++) {
        drawing_curve c = d->curve[i];
        c.fill          = fill;
        drawing_add_like(out, &c, i == first || c.path != d->curve[i - 1].path);
    }
}

/* The stroke of a shape becomes a shape. */
static int widen(host *h, const drawing *d, size_t first, size_t last, unsigned *shape,
                 drawing *out, const char *file)
{
    static const enum region_cap caps[]   = { REGION_BUTT, REGION_CAP_ROUND, REGION_SQUARE };
    static const enum region_join joins[] = { REGION_MITRE, REGION_JOIN_ROUND, REGION_BEVEL };
    drawing_curve like                    = d->curve[first];
    const region_stroke s                 = { .width = (double)like.width,
                                              .cap   = caps[like.cap],
                                              .join  = joins[like.join],
                                              .mitre = (double)like.mitre,
                                              .pen   = { (double)like.pen[0], (double)like.pen[1],
                                                         (double)like.pen[2] } };
    region *area = region_of_stroke(h, d, first, last, &s, file);

    *shape += DRAWING_SHAPE;
    like.fill    = *shape + DRAWING_FILLED + DRAWING_STROKED;
    like.clip    = 0;
    const int code = area ? put_area(h, area, &like, out, file) : region_error();
    region_free(area);
    return code;
}

/* What the clip paths around a shape leave of it. */
static int cut_area(host *h, const drawing *d, size_t first, size_t last, drawing *out,
                    const char *file)
{
    drawing_curve like = d->curve[first];
    region *area = region_inside(h, d, first, last, like.fill & DRAWING_EVENODD, file);

    for (unsigned k = like.clip; k > 0 && area != NULL; k = d->clip[k - 1].up)
        if (!region_cut(h, area, &d->clip[k - 1].outline, file)) {
            region_free(area);
            area = NULL;
        }
    like.fill |= DRAWING_EVENODD;
    like.clip      = 0;
    const int code = area ? put_area(h, area, &like, out, file) : region_error();
    region_free(area);
    return code;
}

static int apply_shape(host *h, bool strokes, bool fills, const drawing *d, size_t first,
                       size_t last, unsigned *shape, drawing *out, const char *file)
{
    const drawing_curve *c = &d->curve[first];
    const bool hidden      = c->fill & DRAWING_HIDDEN,
               wide        = strokes && !hidden && c->fill & DRAWING_STROKED && c->width > 0,
               painted     = fills && c->fill & DRAWING_FILLED;
    int code               = 0;

    if (painted && c->clip > 0)
        code = cut_area(h, d, first, last, out, file);
    else if (!wide)
        keep(d, first, last, c->fill, out);
    else if (painted)
        keep(d, first, last, (c->fill & ~DRAWING_STROKED) | DRAWING_HIDDEN, out);
    return code == 0 && wide ? widen(h, d, first, last, shape, out, file) : code;
}

int areas_apply(host *h, bool strokes, bool fills, drawing *d, const char *file)
{
    drawing out    = { .width = d->width, .height = d->height };
    const unsigned warned = h->warnings;
    unsigned shape = 0;
    int code       = 0;

    if (d->count == 0 || d->of != NULL || !(strokes || d->clips > 0))
        return 0;
    for (size_t i = 0; i < d->count; i++)
        shape = d->curve[i].fill > shape ? d->curve[i].fill : shape;
    shape -= shape % DRAWING_SHAPE;
    for (size_t first = 0, last; first < d->count && code == 0; first = last) {
        for (last = first; last < d->count && d->curve[last].fill == d->curve[first].fill; last++)
            ;
        const host_progress p = { strokes ? "widening strokes" : "cutting", (double)first,
                                  (double)d->count, true };
        code = host_goes_on(h, &p)
                   ? apply_shape(h, strokes, fills, d, first, last, &shape, &out, file)
                   : EX_TEMPFAIL;
    }
    host_has_done(h);
    drawing_free(d);
    *d = out;
    return host_code(h, warned, code);
}
