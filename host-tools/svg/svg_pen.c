/* host-tools/svg/svg_pen.c -- converts lines, quadratics, cubics and arcs in user units to cubics
 * in mm
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "engine/engine.h"     /* engine_f64: arcs */
#include "svg/svg.h"

/* mm; shorter curves are not drawn, closer ends are one point */
#define SAME    1e-6
#define ARC_TOL 0.0005      /* mm; half of the promised micrometre */
#define OUTLINE_LIMIT 1e6   /* mm; of what cuts, which is not drawn */

static void to_mm(const svg_matrix *m, double x, double y, double out[2])
{
    out[0] = m->a * x + m->c * y + m->e;
    out[1] = m->b * x + m->d * y + m->f;
}

static double apart(const double a[2], const double b[2])
{
    return hypot(a[0] - b[0], a[1] - b[1]);
}

svg_pen svg_pen_at(const svg_reader *r, svg_matrix matrix)
{
    svg_pen pen = { .r = r, .to_mm = matrix, .line = svg_at_line(r) };

    svg_move(&pen, 0, 0);
    return pen;
}

/* A part without length, as SVG 2, 13.5.4 draws it: its ends alone, along the x axis. */
static void draw_dot(svg_pen *pen)
{
    const double x = pen->start[0], y = pen->start[1], stretch = svg_stretch(pen->to_mm),
                 half = stretch > 0 ? SVG_DOT / 2 / stretch : 0;

    pen->still = false;
    to_mm(&pen->to_mm, x - half, y, pen->end);
    (void)svg_cubic(pen, x - half / 3, y, x + half / 3, y, x + half, y);
    pen->still = false;
}

void svg_end(svg_pen *pen)
{
    if (pen->fresh && pen->still && pen->dots)
        draw_dot(pen);
}

void svg_move(svg_pen *pen, double x, double y)
{
    svg_end(pen);
    pen->still    = false;
    pen->start[0] = pen->at[0] = x;
    pen->start[1] = pen->at[1] = y;
    to_mm(&pen->to_mm, x, y, pen->end);
    pen->fresh = true;
}

/* A curve that is too short to draw is left out, and the next curve starts where the last drawn one
 * ended. So there is no gap, and a path of many tiny pieces is still followed to SAME. */
bool svg_cubic(svg_pen *pen, double x1, double y1, double x2, double y2, double x, double y)
{
    drawing *d = pen->r->d;
    double p[4][2];

    memcpy(p[0], pen->end, sizeof p[0]);
    to_mm(&pen->to_mm, x1, y1, p[1]);
    to_mm(&pen->to_mm, x2, y2, p[2]);
    to_mm(&pen->to_mm, x, y, p[3]);
    pen->at[0] = x;
    pen->at[1] = y;

    for (int i = 0; i < 8; i++)
        if (!(fabs(p[i / 2][i % 2]) <= (pen->r->clipping ? OUTLINE_LIMIT : DRAWING_LIMIT))) {
            svg_lose(pen->r, SVG_WARN_FAR,
                     "<%s> is not drawn, a point at %g mm is beyond +-%g mm: check units and "
                     "transforms",
                     (const char *)pen->r->node->name, p[i / 2][i % 2], DRAWING_LIMIT);
            return true;
        }
    if (apart(p[1], p[0]) <= SAME && apart(p[2], p[0]) <= SAME && apart(p[3], p[0]) <= SAME) {
        pen->still = true;
        return true;
    }
    if (d->count >= DRAWING_CURVES_MAX)
        return svg_fail(pen->r, "svg.too-many-curves", "more than %u curves: split the drawing",
                        DRAWING_CURVES_MAX);

    drawing_add(d, p, pen->fresh, pen->line);
    drawing_curve *c = &d->curve[d->count - 1];
    c->fill  = pen->r->fill;
    c->tool  = pen->r->tool;
    c->layer = pen->r->layer;
    c->width = pen->r->width;
    c->mitre = pen->r->mitre;
    c->cap   = pen->r->cap;
    c->join  = pen->r->join;
    memcpy(c->pen, pen->r->pen, sizeof c->pen);
    memcpy(pen->end, p[3], sizeof p[3]);
    pen->fresh = false;
    return true;
}

bool svg_line(svg_pen *pen, double x, double y)
{
    const double x0 = pen->at[0], y0 = pen->at[1], dx = (x - x0) / 3, dy = (y - y0) / 3;

    return svg_cubic(pen, x0 + dx, y0 + dy, x - dx, y - dy, x, y);
}

/* The same curve, one degree higher. */
bool svg_quad(svg_pen *pen, double x1, double y1, double x, double y)
{
    const double x0 = pen->at[0], y0 = pen->at[1];

    return svg_cubic(pen, x0 + (x1 - x0) * 2 / 3, y0 + (y1 - y0) * 2 / 3, x + (x1 - x) * 2 / 3,
                     y + (y1 - y) * 2 / 3, x, y);
}

/* A closing line that only corrects rounding is not drawn: the end moves onto the start instead. */
bool svg_close(svg_pen *pen)
{
    double start[2];

    to_mm(&pen->to_mm, pen->start[0], pen->start[1], start);
    if (!pen->fresh && apart(start, pen->end) <= SAME)
        memcpy(pen->r->d->curve[pen->r->d->count - 1].p[3], start, sizeof start);
    else if (!svg_line(pen, pen->start[0], pen->start[1]))
        return false;
    svg_move(pen, pen->start[0], pen->start[1]);
    return true;
}


// Arcs
// ----

typedef struct {
    svg_pen *pen;
    bool drawn;
} arc_pen;

static void draw_span(void *context, double p[4][ENGINE_AXES])
{
    arc_pen *arc = context;

    arc->drawn = arc->drawn &&
                 svg_cubic(arc->pen, p[1][0], p[1][1], p[2][0], p[2][1], p[3][0], p[3][1]);
}

/* Is it so flat that a line is within 1 nm of it? Then the centre would be too far away to
 * compute. */
static bool is_flat(const double radii[2], const double from[2], const double to[2], double stretch)
{
    const double chord = apart(from, to) / fmin(radii[0], radii[1]);

    return chord < 1 && chord * chord / 4 * fmax(radii[0], radii[1]) * stretch < SAME;
}

bool svg_arc(svg_pen *pen, double rx, double ry, double degrees, bool large, bool sweep, double x,
             double y)
{
    const double from[2] = { pen->at[0], pen->at[1] }, to[2] = { x, y },
                 radii[2] = { fabs(rx), fabs(ry) };
    const double stretch = svg_stretch(pen->to_mm);
    arc_pen arc = { pen, true };

    if (from[0] == to[0] && from[1] == to[1])
        return true;
    if (radii[0] == 0 || radii[1] == 0 || stretch == 0 ||
        (!large && is_flat(radii, from, to, stretch)))
        return svg_line(pen, x, y);
    const int status = engine_f64.ellipse(from, to, radii, fmod(degrees, 360), large,
                                          sweep ? 1 : -1, ARC_TOL / stretch, draw_span, &arc);
    if (status != 0)
        svg_lose(pen->r, SVG_WARN_FAR,
                 "<%s> is not drawn, it has an arc of %g mm radius: give at most 1e11",
                 (const char *)pen->r->node->name, fmax(radii[0], radii[1]) * stretch);
    return arc.drawn;
}
