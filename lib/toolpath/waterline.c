/* lib/toolpath/waterline.c
 * SPDX-License-Identifier: MIT
 *
 * The line is the border of the places where a cutter may stand that has e = tol / 2 more on all
 * of its underside: a body and its cutter, both rounded by e, meet at the distance e. So the cutter
 * itself has room on chords whose sagitta is less than e, and where a cutter that is larger by tol
 * may not stand, a sheet is within tol.
 *
 * A step goes to a place on a circle about the last point. The circle is looked at from the
 * direction of the way back, turning left: first it is blocked by what is to the right of the line,
 * then it is clear. The border lies between, and is halved for. A circle may also meet something
 * else, or pass around a corner; then the quarters of the chord touch nothing, or the chord is not
 * clear, and the circle is halved.
 *
 * A line has gone around when it crosses the upright of one of its own chords, a gate, in the same
 * direction and near to it. The first chord is a gate. It may have led out of a sharp inner corner,
 * beside which the line passes later, so the last chord with a number 2^k is another.
 */
#include "toolpath/waterline.h"

#define TURNS 20                /* a circle has 16; it may begin inside of what is blocked */
#define COS   LOFT_REAL(0.9238795325112867)     /* of 22.5 degrees */
#define SIN   LOFT_REAL(0.3826834323650898)

static const unsigned upright = LOFT_AXES > 2 ? 2 : 0;
static const unsigned across = LOFT_AXES > 1 ? 1 : 0;

static bool lies_inside(const loft_box *area, loft_real x, loft_real y, loft_real margin)
{
    return x - margin >= loft_vec_axis(&area->min, 0) &&
           x + margin <= loft_vec_axis(&area->max, 0) &&
           y - margin >= loft_vec_axis(&area->min, 1) && y + margin <= loft_vec_axis(&area->max, 1);
}

enum loft_status loft_waterline_init(loft_waterline *w, const loft_drop *d, const loft_box *area,
                                     loft_real z)
{
    const loft_real reach = LOFT_REAL(LOFT_SHEET_REACH), half = d->tol / 2;

    if (LOFT_AXES < 3 || !loft_drop_takes(area) || !(loft_real_abs(z) <= reach) ||
        !(d->tol >= 4 * loft_drop_tol()))
        return LOFT_ERR_ARG;
    w->d = *d;
    w->area = *area;
    w->z = z;
    for (int k = 0; k < 2; k++) {
        const loft_real by = k == 0 ? half : 2 * half;
        w->grown[k] = *d;
        if (loft_cutter_init(&w->grown[k].cutter, d->cutter.radius + by, d->cutter.corner + by) !=
            LOFT_OK)
            return LOFT_ERR_ARG;
    }
    w->least = half;
    w->most = d->cutter.radius > half ? d->cutter.radius : half;
    w->points = 0;
    w->closed = false;
    w->over = true;
    return LOFT_OK;
}

static loft_vec place_of(const loft_waterline *w, loft_real x, loft_real y)
{
    loft_vec out = { { 0 } };

    out.axis[0] = x;
    out.axis[across] = y;
    out.axis[upright] = w->z;
    return out;
}

static bool clears(const loft_waterline *w, unsigned size, loft_real x, loft_real y)
{
    loft_vec at = place_of(w, x, y);

    at.axis[upright] -= size == 0 ? w->least : 2 * w->least;
    return loft_drop_clear(&w->grown[size], &at, &at);
}

bool loft_waterline_clear(const loft_waterline *w, loft_real x, loft_real y)
{
    return lies_inside(&w->area, x, y, 0) && clears(w, 0, x, y);
}

/* True if a sheet or the border of the area is within tol. */
static bool touches(const loft_waterline *w, loft_real x, loft_real y)
{
    return !lies_inside(&w->area, x, y, 2 * w->least) || !clears(w, 1, x, y);
}

static loft_real length_of(const loft_real v[2])
{
    return loft_acc_sqrt(loft_prod(v[0], v[0]) + loft_prod(v[1], v[1]));
}

static void normalize(loft_real v[2])
{
    const loft_acc length = loft_to_acc(length_of(v));

    for (int k = 0; k < 2 && length > 0; k++) {
        const loft_real share = loft_acc_quot(loft_acc_abs(loft_to_acc(v[k])), length);
        v[k] = v[k] < 0 ? -share : share;
    }
}

enum loft_status loft_waterline_begin(loft_waterline *w, const loft_vec *clear,
                                      const loft_vec *blocked)
{
    loft_real a[2], b[2], by[2];

    for (int k = 0; k < 2; k++) {
        a[k] = loft_vec_axis(clear, k);
        b[k] = loft_vec_axis(blocked, k);
        by[k] = b[k] - a[k];
    }
    if (LOFT_AXES < 3 || !loft_waterline_clear(w, a[0], a[1]) ||
        loft_waterline_clear(w, b[0], b[1]))
        return LOFT_ERR_ARG;
    while (loft_real_abs(b[0] - a[0]) + loft_real_abs(b[1] - a[1]) > w->least / 4) {
        const loft_real x = a[0] / 2 + b[0] / 2, y = a[1] / 2 + b[1] / 2;
        loft_real *const end = loft_waterline_clear(w, x, y) ? a : b;
        end[0] = x;
        end[1] = y;
    }
    normalize(by);
    w->heading[0] = -by[1];
    w->heading[1] = by[0];
    w->from = place_of(w, a[0], a[1]);
    w->step = w->most;
    w->points = 1;
    w->closed = w->over = false;
    return LOFT_OK;
}

static loft_vec place_ahead(const loft_waterline *w, const loft_real toward[2])
{
    return place_of(w, loft_vec_axis(&w->from, 0) + loft_mul(toward[0], w->step),
                    loft_vec_axis(&w->from, 1) + loft_mul(toward[1], w->step));
}

static bool is_clear_ahead(const loft_waterline *w, const loft_real toward[2])
{
    const loft_vec at = place_ahead(w, toward);

    return loft_waterline_clear(w, loft_vec_axis(&at, 0), loft_vec_axis(&at, 1));
}

/* Look around, turning left: a clear direction, and the blocked one before it. */
static bool look_around(const loft_waterline *w, loft_real toward[2], loft_real before[2])
{
    bool met = false;

    toward[0] = -w->heading[0];
    toward[1] = -w->heading[1];
    for (unsigned k = 0; k < TURNS; k++) {
        const bool clear = is_clear_ahead(w, toward);
        if (clear && met)
            return true;
        met = met || !clear;
        before[0] = toward[0];
        before[1] = toward[1];
        toward[0] = loft_mul(before[0], COS) - loft_mul(before[1], SIN);
        toward[1] = loft_mul(before[0], SIN) + loft_mul(before[1], COS);
    }
    return false;
}

/* Find the border on the circle: a clear direction that is nearly blocked. */
static bool find_direction(const loft_waterline *w, loft_real toward[2])
{
    loft_real before[2] = { 0, 0 }, apart[2];

    if (!look_around(w, toward, before))
        return false;
    do {
        loft_real middle[2] = { toward[0] + before[0], toward[1] + before[1] };
        normalize(middle);
        loft_real *const end = is_clear_ahead(w, middle) ? toward : before;
        for (int k = 0; k < 2; k++) {
            end[k] = middle[k];
            apart[k] = toward[k] - before[k];
        }
    } while (loft_mul(length_of(apart), w->step) > w->least / 4);
    return true;
}

/* True if the chord may be given. */
static bool chord_fits(const loft_waterline *w, const loft_vec *end)
{
    const loft_real x = loft_vec_axis(&w->from, 0), y = loft_vec_axis(&w->from, 1),
                    by[2] = { loft_vec_axis(end, 0) - x, loft_vec_axis(end, 1) - y };

    for (int k = 1; k < 4 && w->step > w->least; k++) {
        const loft_real part = loft_real_from_int(k) / 4;
        if (!touches(w, x + loft_mul(by[0], part), y + loft_mul(by[1], part)))
            return false;
    }
    return loft_drop_clear(&w->d, &w->from, end);
}

/* True if the chord to `end` passes the gate. */
static bool passes_gate(const loft_waterline *w, const loft_vec gate[2], const loft_vec *end)
{
    const loft_vec *const place[2] = { &w->from, end };
    loft_real by[2], along[2], off[2];

    for (int k = 0; k < 2; k++)
        by[k] = loft_vec_axis(&gate[1], k) - loft_vec_axis(&gate[0], k);
    const loft_real half = length_of(by) / 2;
    normalize(by);
    for (int i = 0; i < 2; i++) {
        const loft_real x = loft_vec_axis(place[i], 0) - loft_vec_axis(&gate[0], 0),
                        y = loft_vec_axis(place[i], 1) - loft_vec_axis(&gate[0], 1);
        along[i] = loft_acc_round(loft_prod(x, by[0]) + loft_prod(y, by[1])) - half;
        off[i] = loft_acc_round(loft_prod(x, by[1]) - loft_prod(y, by[0]));
    }
    if (!(along[0] < 0 && along[1] >= 0))
        return false;
    const loft_real at = off[0] +
                         loft_mul(off[1] - off[0], loft_div(along[0], along[0] - along[1]));
    return loft_real_abs(at) <= half + 8 * w->least;
}

/* A chord may be given: take it. */
static void take_chord(loft_waterline *w, const loft_vec *end, const loft_real toward[2])
{
    if ((w->points & (w->points - 1)) == 0) {
        loft_vec *const gate = w->gate[w->points > 1];
        gate[0] = w->from;
        gate[1] = *end;
    }
    w->from = *end;
    w->heading[0] = toward[0];
    w->heading[1] = toward[1];
    w->over = ++w->points >= LOFT_WATERLINE_MOST;
}

/* Try one chord of the present step. */
static bool go_on(loft_waterline *w)
{
    loft_real toward[2];

    if (!find_direction(w, toward))
        return false;
    loft_vec end = place_ahead(w, toward);
    for (int k = 0; k < 2 && w->points > 2 && !w->closed; k++)
        if (passes_gate(w, w->gate[k], &end)) {
            w->closed = true;
            end = w->gate[k][1];
        }
    if (!chord_fits(w, &end))
        return false;
    take_chord(w, &end, toward);
    w->over = w->over || w->closed;
    return true;
}

bool loft_waterline_next(loft_waterline *w, loft_vec *out)
{
    while (!w->over) {
        if (go_on(w)) {
            w->step = w->step < w->most / 2 ? 2 * w->step : w->most;
            *out = w->from;
            return true;
        }
        w->closed = false;
        w->over = w->step <= w->least;
        w->step = w->step / 2 > w->least ? w->step / 2 : w->least;
    }
    return false;
}
