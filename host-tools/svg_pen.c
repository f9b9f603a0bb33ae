/* host-tools/svg_pen.c -- lines, quadratics, cubics and arcs in user units become cubics in mm
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "svg.h"

#define SAME    1e-6        /* mm; what is shorter is not drawn, ends that are nearer are one point */
#define ARC_TOL 0.0005      /* mm; half of the promised micrometre                                  */
#define TAU     6.283185307179586476925

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

void svg_move(svg_pen *pen, double x, double y)
{
    pen->start[0] = pen->at[0] = x;
    pen->start[1] = pen->at[1] = y;
    to_mm(&pen->to_mm, x, y, pen->end);
    pen->fresh = true;
}

/* What is too short to draw is left out, and the next curve starts where the last drawn one ended: no gap, and a path
 * of many tiny pieces is still followed to SAME. */
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

    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 2; k++)
            if (!(fabs(p[i][k]) <= DRAWING_LIMIT))
                return svg_fail(pen->r, "a point at %g mm is beyond +-%g mm: check units and transforms", p[i][k], DRAWING_LIMIT);
    if (apart(p[1], p[0]) <= SAME && apart(p[2], p[0]) <= SAME && apart(p[3], p[0]) <= SAME)
        return true;
    if (d->count >= DRAWING_CURVES_MAX)
        return svg_fail(pen->r, "more than %u curves: split the drawing", DRAWING_CURVES_MAX);

    drawing_add(d, p, pen->fresh, pen->line);
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

    return svg_cubic(pen, x0 + (x1 - x0) * 2 / 3, y0 + (y1 - y0) * 2 / 3, x + (x1 - x) * 2 / 3, y + (y1 - y) * 2 / 3, x, y);
}

/* A closing line that only makes up for rounding is not drawn: the end moves onto the start instead. */
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

/* A cubic over the angle w of the unit circle with handles of 4/3 tan(w/4) leaves the circle by at most
 * 2/27 sin^6(w/4) / cos^2(w/4), outwards only (Goldapp 1991); an ellipse is an image of the circle that stretches this
 * by its larger half axis at most. The fewest pieces, each at most a quarter, that keep ARC_TOL: */
static int arc_pieces(double angle, double radius_mm)
{
    int n = (int)ceil(fabs(angle) / (TAU / 4) - 1e-9);

    if (n < 1)
        n = 1;
    for (;; n++) {
        const double s = sin(fabs(angle) / n / 4), c = cos(fabs(angle) / n / 4);
        if (2.0 / 27 * pow(s, 6) / (c * c) * radius_mm <= ARC_TOL)
            return n;
    }
}

/* An ellipse in user units as the image of the unit circle. */
typedef struct {
    double centre[2], from, angle;      /* of the unit circle: where the arc is on it    */
    double rx, ry, cos, sin;
} ellipse;

static void on_ellipse(const ellipse *e, double u, double v, double out[2])
{
    const double x = e->rx * (e->centre[0] + u), y = e->ry * (e->centre[1] + v);

    out[0] = e->cos * x - e->sin * y;
    out[1] = e->sin * x + e->cos * y;
}

/* Find the circle through both ends in the space where the ellipse is a unit circle. Its centre lies on the
 * perpendicular through their middle, at sqrt(1/d^2 - 1/4) times their distance d; if they are further apart than the
 * diameter, the radii grow until it lies in the middle. (SVG 2, appendix B.2.4, says the same in longer formulas.) */
static void find_centre(ellipse *e, const double from[2], const double to[2], bool large, bool sweep)
{
    double a[2], b[2];
    bool grown = false;

    for (;;) {
        a[0] = ( e->cos * from[0] + e->sin * from[1]) / e->rx;
        a[1] = (-e->sin * from[0] + e->cos * from[1]) / e->ry;
        b[0] = ( e->cos * to[0] + e->sin * to[1]) / e->rx;
        b[1] = (-e->sin * to[0] + e->cos * to[1]) / e->ry;
        const double half = apart(a, b) / 2;
        if (!(half > 1) || grown)
            break;
        e->rx *= half;
        e->ry *= half;
        grown = true;
    }
    const double dx = b[0] - a[0], dy = b[1] - a[1];
    const double up = grown ? 0 : sqrt(fmax(1 / (dx * dx + dy * dy) - 0.25, 0)) * (large == sweep ? -1 : 1);

    e->centre[0] = (a[0] + b[0]) / 2 - up * dy;
    e->centre[1] = (a[1] + b[1]) / 2 + up * dx;
    e->from  = atan2(a[1] - e->centre[1], a[0] - e->centre[0]);
    e->angle = atan2(b[1] - e->centre[1], b[0] - e->centre[0]) - e->from;
    if (sweep && e->angle < 0)
        e->angle += TAU;
    if (!sweep && e->angle > 0)
        e->angle -= TAU;
}

/* So flat that a line is within 1 nm of it? Then the centre would be too far away to be computed. */
static bool is_flat(const ellipse *e, const double from[2], const double to[2], double stretch)
{
    const double chord = apart(from, to) / fmin(e->rx, e->ry);

    return chord < 1 && chord * chord / 4 * fmax(e->rx, e->ry) * stretch < SAME;
}

bool svg_arc(svg_pen *pen, double rx, double ry, double degrees, bool large, bool sweep, double x, double y)
{
    const double from[2] = { pen->at[0], pen->at[1] }, to[2] = { x, y }, stretch = svg_stretch(pen->to_mm);
    const double turn = fmod(degrees, 360) * TAU / 360;
    ellipse e = { .rx = fabs(rx), .ry = fabs(ry), .cos = cos(turn), .sin = sin(turn) };

    if (from[0] == to[0] && from[1] == to[1])
        return true;
    if (e.rx == 0 || e.ry == 0 || (!large && is_flat(&e, from, to, stretch)))
        return svg_line(pen, x, y);
    find_centre(&e, from, to, large, sweep);
    if (!(fmax(e.rx, e.ry) * stretch <= 1e12))
        return svg_fail(pen->r, "an arc of %g mm radius: give at most 1e12", fmax(e.rx, e.ry) * stretch);

    const int n = arc_pieces(e.angle, fmax(e.rx, e.ry) * stretch);
    const double step = e.angle / n, k = 4.0 / 3 * tan(step / 4);
    for (int i = 0; i < n; i++) {
        const double c0 = cos(e.from + i * step), s0 = sin(e.from + i * step);
        const double c1 = cos(e.from + (i + 1) * step), s1 = sin(e.from + (i + 1) * step);
        double p[3][2];

        on_ellipse(&e, c0 - k * s0, s0 + k * c0, p[0]);
        on_ellipse(&e, c1 + k * s1, s1 - k * c1, p[1]);
        on_ellipse(&e, c1, s1, p[2]);
        if (!svg_cubic(pen, p[0][0], p[0][1], p[1][0], p[1][1], i < n - 1 ? p[2][0] : x, i < n - 1 ? p[2][1] : y))
            return false;
    }
    return true;
}
