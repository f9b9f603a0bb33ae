/* lib/toolpath/raster_cusp.c -- the cusps between two lines of a raster
 * SPDX-License-Identifier: MIT
 *
 * A ball that rests between the lines touches a point of a sheet that no other ball must leave.
 * What the lines leave there is the distance of the point from the nearest centre on each of them,
 * less the radius. So no derivative of a surface is needed, and a border is no exception: where
 * balls roll around it they all touch it, and leave nothing.
 *
 * Away from a line what it leaves grows with the square of the distance. With a and b left by the
 * two lines, the tip of the cusp, where both leave the same, is
 *
 *     ((sqrt(a) + sqrt(b)) / 2)^2
 *
 * high. Where a and b differ much, the sheet ends between, or the ball has gone over to another
 * part of it: then the point beside the line that leaves more is looked at too.
 */
#include "toolpath/raster.h"

#include "toolpath/tip_place.h"

#define FEET  3                 /* tries of the place that is nearest to a point */
#define CLOSE 8                 /* how many times closer sections are where cusps change */
#define ALIKE 4                 /* the largest ratio of what two lines leave */

/* Two lines, at one place along them. */
typedef struct {
    const loft_drop *d;
    unsigned axis;
    loft_real along, at, step;
    loft_vec tip[2];            /* over each line */
    bool met[2];                /* there the ball touches a sheet */
    loft_real slope[2];         /* of the way over each line, as far as it is known */
    loft_drop_spot spot[3];     /* that is touched: over each line, and between */
} section;

/* The tip over a place; returns whether the ball touches a sheet there. */
static bool look_at(const section *s, loft_real along, loft_real across, loft_drop_spot *spot,
                    loft_vec *tip)
{
    *tip = loft_place_of(s->axis, along, across);
    const loft_real z = loft_drop_height(s->d, loft_vec_axis(tip, 0), loft_vec_axis(tip, 1), spot);
    loft_place_lift(tip, z);
    return z > s->d->floor + 2 * s->d->tol;
}

static loft_real place_across(const section *s, int quarter)
{
    return quarter < 4 ? s->at + s->step / 4 * (loft_real)quarter : s->at + s->step;
}

/* What a ball leaves over a point: the distance between them, at most a radius. */
static loft_real left_by(const section *s, const loft_vec *tip, const loft_vec *p)
{
    const loft_acc radius = loft_to_acc(s->d->cutter.radius);
    loft_acc off[3];

    for (int k = 0; k < 3; k++)
        off[k] = loft_to_acc(loft_vec_axis(p, k)) - loft_to_acc(loft_vec_axis(tip, k));
    off[2] -= radius;
    return loft_acc_round(loft_acc_min(loft_acc_max(loft_acc_hypot(off, 3) - radius, 0), radius));
}

/* From a centre on a way of this slope to the foot of a point, along the axis; at most a radius. */
static loft_real foot_of(const section *s, const loft_vec *tip, loft_real slope, const loft_vec *p)
{
    const int axis = (int)s->axis;
    const loft_real ahead = loft_vec_axis(p, axis) - loft_vec_axis(tip, axis),
                    above = loft_vec_axis(p, 2) - loft_vec_axis(tip, 2) - s->d->cutter.radius;
    const loft_acc length2 = loft_to_acc(LOFT_REAL(1)) + loft_prod(slope, slope),
                   to = loft_to_acc(ahead) + loft_prod(slope, above),
                   most = loft_acc_mul(length2, s->d->cutter.radius);
    const loft_real by = loft_acc_quot(loft_acc_min(loft_acc_abs(to), most), length2);

    return to < 0 ? -by : by;
}

/* What a line leaves over a point, of which its ball at this section leaves `left`. The feet are
 * looked for from there; a place that is not the nearest one leaves more, never less. */
static loft_real left_by_line(const section *s, int line, const loft_vec *p, loft_real left)
{
    loft_drop_spot spot = s->spot[line];
    loft_real slope = s->slope[line];
    loft_vec tip = s->tip[line];

    for (int round = 0; round < FEET; round++) {
        const loft_real by = foot_of(s, &tip, slope, p);
        loft_vec next;
        if (!(loft_prod(by, by) > loft_prod(2 * s->d->tol, s->d->cutter.radius)))
            break;
        (void)look_at(s, loft_vec_axis(&tip, (int)s->axis) + by, place_across(s, 4 * line), &spot,
                      &next);
        const loft_real now = left_by(s, &next, p),
                        rise = loft_vec_axis(&next, 2) - loft_vec_axis(&tip, 2);
        slope = loft_place_slope(by < 0 ? -rise : rise, loft_real_abs(by));
        tip = next;
        left = now < left ? now : left;
    }
    return left;
}

static loft_real tip_of_cusp(const loft_real left[2])
{
    const loft_acc root = loft_to_acc(loft_acc_sqrt(loft_prod(left[0], left[1])));

    return loft_acc_round(
        loft_acc_ratio(loft_to_acc(left[0]) + loft_to_acc(left[1]) + root + root, 4));
}

/* The cusp about the point that the ball touches between the lines. Less than half of `most` may be
 * told as up to that. *more: the line beside which it may be higher, or -1. */
static loft_real cusp_between(section *s, int quarter, loft_real most, int *more)
{
    loft_real left[2];
    loft_vec tip, p;

    *more = -1;
    if (!look_at(s, s->along, place_across(s, quarter), &s->spot[2], &tip)) {
        *more = s->met[0] ? 0 : 1;
        return 0;
    }
    const loft_drop_spot *const at = &s->spot[2];
    const loft_surface of = s->d->sheet[at->sheet].surface;
    if (of.eval(of.surface, at->u, at->v, &p) != LOFT_OK)
        return 0;
    for (int k = 0; k < 2; k++)
        left[k] = left_by(s, &s->tip[k], &p);
    for (int k = 0; k < 2 && tip_of_cusp(left) > most / 2; k++)
        left[k] = left_by_line(s, k, &p, left[k]);
    const int nearer = left[0] < left[1] ? 0 : 1;
    if (loft_to_acc(left[1 - nearer]) <= ALIKE * loft_to_acc(left[nearer]))
        return tip_of_cusp(left);
    *more = 1 - nearer;
    return left[nearer];
}

static loft_real cusp_at(section *s, loft_real most)
{
    loft_real cusp = 0;
    int more = -1;

    if (s->met[0] || s->met[1]) {
        cusp = cusp_between(s, 2, most, &more);
        if (more >= 0) {
            const loft_real beside = cusp_between(s, more ? 3 : 1, cusp > most ? cusp : most,
                                                  &more);
            cusp = beside > cusp ? beside : cusp;
        }
    }
    return cusp;
}

/* Go on to a place, `by` beyond the last one; 0: this is the first one. */
static void move_section(section *s, loft_real along, loft_real by)
{
    s->along = along;
    for (int k = 0; k < 2; k++) {
        const loft_real z = loft_vec_axis(&s->tip[k], 2);
        const bool was = s->met[k];
        s->met[k] = look_at(s, along, place_across(s, 4 * k), &s->spot[k], &s->tip[k]);
        s->slope[k] = 0;
        if (was && s->met[k] && by > 0)
            s->slope[k] = loft_place_slope(loft_vec_axis(&s->tip[k], 2) - z, by);
    }
}

/* Sections are close where cusps change much from one to the next: a sheet ends there, or the ball
 * goes over to another part. */
loft_real loft_raster_cusp(const loft_drop *d, unsigned axis, loft_real at, loft_real step,
                           loft_real from, loft_real to)
{
    const loft_acc a = loft_to_acc(from < to ? from : to), b = loft_to_acc(from < to ? to : from),
                   length = b - a;
    section s = { .d = d, .axis = axis, .at = at, .step = step };
    loft_real most = 0, last = 0;
    uint32_t n = CLOSE, j = 0, by = CLOSE;

    while (n < CLOSE * LOFT_RASTER_LOOKS &&
           (n < CLOSE * 16 || loft_to_acc(d->cutter.radius) * (int32_t)n < CLOSE * length))
        n *= 2;
    for (bool first = true; first || j < n; first = false) {
        const uint32_t next = first ? 0 : j + by;
        section there = s;
        move_section(&there, loft_acc_round(loft_acc_lerp_at(a, b, next, n)),
                     loft_acc_round(loft_acc_ratio(length * (int32_t)(next - j), (int32_t)n)));
        const loft_real cusp = cusp_at(&there, most), change = loft_real_abs(cusp - last);
        most = cusp > most ? cusp : most;
        if (!first && by > 1 && change > most / 4) {
            by /= 2;
            continue;
        }
        s = there;
        last = cusp;
        j = next;
        by = by < CLOSE && j % (2 * by) == 0 ? 2 * by : by;
    }
    return most;
}
