/* host-tools/read/drawing.c -- curves are added to a drawing; its length and its box
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/host.h"
#include "engine/curve.h"   /* curves_is_text, curves_free */
#include "read/drawing.h"
#include "base/memory.h"    /* memory_grow */
#include "base/space.h"     /* space_distance */
#include "base/spool.h"     /* spool_grow */

#define SAME 1e-6       /* mm; closer ends count as one point */
#define MANY 8192       /* curves that are worth being taken out */
#define HALVINGS 60     /* of a parameter: down to the last bit */

void drawing_free(drawing *d)
{
    if (d->of != NULL)
        curves_free(d->of);
    free(d->of);
    for (size_t i = 0; i < d->clips; i++)
        drawing_free(&d->clip[i].outline);
    free(d->clip);
    spool_free(d->curve);
    spool_free(d->event);
    *d = (drawing){ 0 };
}

void drawing_names_free(drawing_names *n)
{
    for (size_t i = 0; i < n->count; i++)
        free(n->name[i]);
    free(n->name);
    *n = (drawing_names){ 0 };
}

void drawing_add_event(drawing *d, const drawing_event *e)
{
    const drawing_event one = *e;

    if (d->events == d->event_room) {
        d->event_room = d->event_room ? 2 * d->event_room : 16;
        d->event      = spool_grow(d->event, d->event_room * sizeof *d->event);
    }
    spool_passed(d->events);
    d->event[d->events] = one;
    d->event[d->events++].before = d->taken + d->count;
}

unsigned drawing_add_clip(drawing *d, const drawing *outline, unsigned up)
{
    drawing_clip *to;

    d->clip = memory_grow(d->clip, (d->clips + 1) * sizeof *d->clip);
    to      = &d->clip[d->clips++];
    *to     = (drawing_clip){ .up = up };
    for (size_t i = 0; i < outline->count; i++)
        drawing_add_like(&to->outline, &outline->curve[i],
                         i == 0 || outline->curve[i].path != outline->curve[i - 1].path);
    for (size_t i = 0; i < outline->clips; i++)
        (void)drawing_add_clip(&to->outline, &outline->clip[i].outline, outline->clip[i].up);
    return (unsigned)d->clips;
}

void drawing_add_like(drawing *d, const drawing_curve *c, bool fresh)
{
    const unsigned path     = d->count == 0 ? 0 : d->curve[d->count - 1].path + (fresh ? 1 : 0);
    const drawing_curve one = *c;       /* it may be one of this drawing */

    if (d->count == d->room) {
        d->room  = d->room ? 2 * d->room : 256;
        d->curve = spool_grow(d->curve, d->room * sizeof *d->curve);
    }
    spool_passed(d->count);
    d->curve[d->count]        = one;
    d->curve[d->count++].path = path;
}

int drawing_offer(drawing *d)
{
    return d->taker != NULL && d->count >= MANY ? d->taker(d->context, d) : 0;
}

void drawing_forget(drawing *d, size_t count)
{
    d->taken += count;
    d->count -= count;
    memmove(d->curve, d->curve + count, d->count * sizeof *d->curve);
}

void drawing_like(drawing *to, const drawing *from)
{
    to->width     = from->width;
    to->height    = from->height;
    to->program   = from->program;
    to->from_line = from->from_line;
    to->clear     = from->clear;
}

void drawing_add(drawing *d, double p[4][2], bool fresh, unsigned line)
{
    drawing_curve c = { .line = line };

    memcpy(c.p, p, sizeof c.p);
    drawing_add_like(d, &c, fresh);
}

void drawing_add_space(drawing *d, double p[4][3], double feed, bool fresh, unsigned line)
{
    double flat[4][2];

    for (int k = 0; k < 4; k++)
        memcpy(flat[k], p[k], sizeof flat[k]);
    drawing_add(d, flat, fresh, line);
    for (int k = 0; k < 4; k++)
        d->curve[d->count - 1].z[k] = p[k][2];
    d->curve[d->count - 1].feed = feed;
}

int drawing_join(host *h, drawing *d, const char *file, unsigned line, double p[4][2])
{
    double space[4][3];

    for (int k = 0; k < 4; k++) {
        memcpy(space[k], p[k], sizeof p[k]);
        space[k][2] = 0;
    }
    return drawing_join_space(h, d, file, line, space, 0);
}

int drawing_join_space(host *h, drawing *d, const char *file, unsigned line, double p[4][3],
                       double feed)
{
    static const int ends_first[] = { 0, 3, 1, 2 };     /* these numbers stand in the file */
    const host_place at = { file, line };

    for (int i = 0; i < 12; i++) {
        const double x = p[ends_first[i / 3]][i % 3];
        if (!(fabs(x) <= DRAWING_LIMIT))
            return host_error(h, EX_DATAERR, "drawing.too-far", at, "check the units",
                              "%g mm is beyond +-%g mm", x, DRAWING_LIMIT);
    }
    if (d->count >= DRAWING_CURVES_MAX)
        return host_error(h, EX_DATAERR, "drawing.too-many-curves", at, "split the drawing",
                          "more than %u curves", DRAWING_CURVES_MAX);

    const drawing_curve *last = d->count ? &d->curve[d->count - 1] : NULL;
    const double end[3] = { last ? last->p[3][0] : NAN, last ? last->p[3][1] : NAN,
                            last ? last->z[3] : NAN };
    const bool goes_on = space_distance(end, p[0]) <= SAME;
    if (goes_on)
        memcpy(p[0], end, sizeof p[0]);
    for (int k = 1; k < 4; k++)
        if (space_distance(p[k], p[0]) > SAME) {
            drawing_add_space(d, p, feed, !goes_on, line);
            break;                      /* a curve without length draws nothing */
        }
    return 0;
}


// Crossings
// ---------

static double value_at(const double p[4], double t)
{
    const double s = 1 - t;

    return s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
}

/* Where the height turns: the zeros of a t^2 + b t + c in 0..1, in order. */
static int turns_of(const double y[4], double out[2])
{
    const double d0 = y[1] - y[0], d1 = y[2] - y[1], d2 = y[3] - y[2];
    const double a = d0 - 2 * d1 + d2, b = 2 * (d1 - d0);
    const double q = -(b + copysign(sqrt(fmax(b * b - 4 * a * d0, 0)), b)) / 2;
    const double root[2] = { q / a, d0 / q };
    int count = 0;

    for (int k = 0; k < 2; k++)
        if (root[k] > 0 && root[k] < 1)         /* false for the nan of 0/0 */
            out[count++] = root[k];
    if (count == 2 && out[0] > out[1]) {
        const double first = out[0];
        out[0] = out[1];
        out[1] = first;
    }
    return count;
}

/* The curve is cut where its height turns, so each piece crosses a height once at most. */
int drawing_crossings(const double y[4], double height, double t[3], int turn[3])
{
    double cut[4]   = { 0 };
    const int count = turns_of(y, cut + 1);
    double from     = y[0];
    int found       = 0;

    cut[count + 1] = 1;
    for (int k = 0; k <= count; k++) {
        const double to = k == count ? y[3] : value_at(y, cut[k + 1]);
        if (height >= fmin(from, to) && height < fmax(from, to)) {
            double left = cut[k], right = cut[k + 1];
            for (int i = 0; i < HALVINGS; i++) {
                const double middle = (left + right) / 2;
                *((value_at(y, middle) < height) == (to > from) ? &left : &right) = middle;
            }
            t[found]      = (left + right) / 2;
            turn[found++] = to > from ? 1 : -1;
        }
        from = to;
    }
    return found;
}

int drawing_winding(const drawing_curve *c, const double at[2])
{
    const double x[4] = { c->p[0][0], c->p[1][0], c->p[2][0], c->p[3][0] },
                 y[4] = { c->p[0][1], c->p[1][1], c->p[2][1], c->p[3][1] };
    double t[3];
    int turn[3], sum = 0;

    if (fmin(fmin(x[0], x[1]), fmin(x[2], x[3])) >= at[0])
        return 0;
    if (fmax(fmax(x[0], x[1]), fmax(x[2], x[3])) < at[0])   /* all crossings count, up and down */
        return (y[3] > at[1]) - (y[0] > at[1]);
    const int count = drawing_crossings(y, at[1], t, turn);

    for (int k = 0; k < count; k++)
        if (value_at(x, t[k]) < at[0])
            sum += turn[k];
    return sum;
}


// Measuring
// ---------

void drawing_eval(const drawing_curve *c, double t, double out[2])
{
    const double s = 1 - t;
    const double w[4] = { s*s*s, 3*s*s*t, 3*s*t*t, t*t*t };

    for (int i = 0; i < 2; i++)
        out[i] = w[0]*c->p[0][i] + w[1]*c->p[1][i] + w[2]*c->p[2][i] + w[3]*c->p[3][i];
}

void drawing_deriv(const drawing_curve *c, double t, double out[2])
{
    const double s = 1 - t;

    for (int i = 0; i < 2; i++)
        out[i] = 3 * (s * s * (c->p[1][i] - c->p[0][i]) + 2 * s * t * (c->p[2][i] - c->p[1][i]) +
                      t * t * (c->p[3][i] - c->p[2][i]));
}

/* Control value k of the piece from a to b, by blossoming. */
static double blossom(const double p[4], double a, double b, int k)
{
    double q[4] = { p[0], p[1], p[2], p[3] };

    for (int level = 0; level < 3; level++) {
        const double t = level < 3 - k ? a : b;
        for (int j = 0; j < 3 - level; j++)
            q[j] = (1 - t) * q[j] + t * q[j + 1];
    }
    return q[0];
}

void drawing_cut(drawing_curve *c, double a, double b)
{
    const drawing_curve of = *c;

    for (int k = 0; k < 4; k++) {
        for (int i = 0; i < 2; i++) {
            const double q[4] = { of.p[0][i], of.p[1][i], of.p[2][i], of.p[3][i] };
            c->p[k][i] = blossom(q, a, b, k);
        }
        c->z[k] = blossom(of.z, a, b, k);
    }
}

static double speed_at(const drawing_curve *c, double t)
{
    const double s = 1 - t;
    double v[2];

    drawing_deriv(c, t, v);
    const double up = 3 * (s * s * (c->z[1] - c->z[0]) + 2 * s * t * (c->z[2] - c->z[1]) +
                           t * t * (c->z[3] - c->z[2]));
    return hypot(hypot(v[0], v[1]), up);
}

/* The length of the piece from a to b by the seven-point Gauss rule: exact for a speed of degree
 * 13. */
static double gauss_length(const drawing_curve *c, double a, double b)
{
    static const double at[4] = { 0, 0.40584515137739716691, 0.74153118559939443986,
                                  0.94910791234275852453 };
    static const double weight[4] = { 0.41795918367346938776, 0.38183005050511894495,
                                      0.27970539148927666790, 0.12948496616886969327 };
    const double middle = (a + b) / 2, half = (b - a) / 2;
    double sum = 0;

    for (int i = -3; i <= 3; i++)
        sum += weight[i < 0 ? -i : i] * speed_at(c, middle + half * (i < 0 ? -at[-i] : at[i]));
    return sum * half;
}

/* Halve until both halves agree with the whole. Near a cusp the speed has a corner, and the halving
 * closes in on it: after 40 levels 2^-40 of the curve is left. */
static double length_between(const drawing_curve *c, double a, double b, double whole, double tol,
                             int levels)
{
    const double middle = (a + b) / 2, left = gauss_length(c, a, middle),
                 right = gauss_length(c, middle, b);

    if (levels == 0 || fabs(left + right - whole) <= tol)
        return left + right;
    return length_between(c, a, middle, left, tol / 2, levels - 1) +
           length_between(c, middle, b, right, tol / 2, levels - 1);
}

double drawing_length(const drawing *d)
{
    double sum = 0;

    for (size_t i = 0; i < d->count; spool_passed(i++)) {
        const drawing_curve *c = &d->curve[i];
        double legs = 0;        /* of the control polygon: at least the length */
        for (int k = 0; k < 3; k++)
            legs += hypot(hypot(c->p[k + 1][0] - c->p[k][0], c->p[k + 1][1] - c->p[k][1]),
                          c->z[k + 1] - c->z[k]);
        sum += length_between(c, 0, 1, gauss_length(c, 0, 1), 1e-8 * legs, 40);
    }
    return sum;
}

static void box_join(double box[2][2], const double p[2])
{
    for (int i = 0; i < 2; i++) {
        box[0][i] = fmin(box[0][i], p[i]);
        box[1][i] = fmax(box[1][i], p[i]);
    }
}

/* Extremes lie at the ends and where a coordinate of the derivative, a t^2 + b t + c, is zero. */
static void box_curve(double box[2][2], const drawing_curve *of)
{
    box_join(box, of->p[0]);
    box_join(box, of->p[3]);
    for (int i = 0; i < 2; i++) {
        const double d0 = of->p[1][i] - of->p[0][i], d1 = of->p[2][i] - of->p[1][i],
                     d2 = of->p[3][i] - of->p[2][i];
        const double a = d0 - 2*d1 + d2, b = 2 * (d1 - d0), c = d0;
        const double q = -(b + copysign(sqrt(fmax(b*b - 4*a*c, 0)), b)) / 2;
        const double root[2] = { q / a, c / q };

        for (int k = 0; k < 2; k++)
            if (root[k] > 0 && root[k] < 1) {   /* false for the nan of 0/0 */
                double p[2];
                drawing_eval(of, root[k], p);
                box_join(box, p);
            }
    }
}

bool drawing_box(const drawing *d, double box[2][2])
{
    box[0][0] = box[0][1] = HUGE_VAL;
    box[1][0] = box[1][1] = -HUGE_VAL;
    for (size_t i = 0; i < d->count; spool_passed(i++))
        box_curve(box, &d->curve[i]);
    return d->count > 0;
}

double drawing_top(const drawing *d)
{
    double top = d->count > 0 ? -HUGE_VAL : 0;

    for (size_t i = 0; i < d->count; spool_passed(i++))
        for (int k = 0; k < 4; k++)
            top = fmax(top, d->curve[i].z[k]);
    return top;
}
