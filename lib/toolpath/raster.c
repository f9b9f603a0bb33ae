/* lib/toolpath/raster.c
 * SPDX-License-Identifier: MIT
 *
 * Heights are found within tol / 4, and raised by tol / 4; a chord that clears all sheets then may
 * sag by as much. Its middle is at most tol / 2 too high.
 *
 * A ball of radius r leaves a cusp between two lines whose centres are L apart, across the way, of
 *
 *     r - sqrt(r^2 - L^2 / 4) - b
 *
 * where b is how far the surface of all centres bulges over their chord: the cusp's tip lies under
 * the middle of the chord, and the surface r under the middle of the bulge. The ball's own heights
 * say both, so no derivative of a surface is needed.
 *
 * Where a spiral turns, two of its lines are corners, a step s apart along both axes. A place at
 * (a, a) inside the outer corner is a from it and sqrt(2) (s - a) from the inner one, at worst
 * (2 - sqrt(2)) s; between lines it is s / 2. Cusps go with the square: 4 (2 - sqrt(2))^2 times.
 */
#include "toolpath/raster.h"

#define FINEST 16               /* a line has at most 2^16 steps */
#define ROUNDS 8                /* tries of one step across */
#define CORNER 1.3725830020304792   /* 4 (2 - sqrt(2))^2 */


/* A line */

static void set_height(loft_vec *p, loft_real z)
{
    if (LOFT_AXES > 2)
        p->axis[LOFT_AXES > 2 ? 2 : 0] = z;
}

static loft_vec point_over(loft_pass *p, uint32_t at)
{
    loft_vec out = p->start;

    for (int k = 0; k < LOFT_AXES && k < 2; k++)
        out.axis[k] = loft_acc_round(
            loft_acc_lerp_at(loft_to_acc(p->start.axis[k]), loft_to_acc(p->end.axis[k]), at, p->n));
    const loft_real z = loft_drop_height(p->d, loft_vec_axis(&out, 0), loft_vec_axis(&out, 1),
                                         &p->spot);
    set_height(&out, z + p->d->tol);
    return out;
}

enum loft_status loft_pass_init(loft_pass *p, const loft_drop *d, const loft_vec *start,
                                const loft_vec *end)
{
    const loft_real reach = LOFT_REAL(LOFT_SHEET_REACH);
    loft_acc length = 0;
    unsigned levels = 0;

    if (LOFT_AXES < 3)
        return LOFT_ERR_ARG;
    for (int k = 0; k < 2; k++) {
        const loft_real a = loft_vec_axis(start, k), b = loft_vec_axis(end, k);
        if (!(loft_real_abs(a) <= reach && loft_real_abs(b) <= reach))
            return LOFT_ERR_ARG;
        length = loft_acc_max(length, loft_acc_abs(loft_to_acc(b) - loft_to_acc(a)));
    }
    p->d = d;
    p->start = *start;
    p->end = *end;
    while (levels < FINEST && length > loft_to_acc(d->tol) * 4) {
        length = loft_acc_ratio(length, 2);
        levels++;
    }
    p->n = (uint32_t)1 << levels;
    p->most = 0;                /* chords of up to a diameter */
    while (p->most < levels && length < loft_to_acc(d->cutter.radius)) {
        length += length;
        p->most++;
    }
    p->level = p->most;
    p->at = 0;
    p->queued = 0;
    p->spot.sheet = 0;
    p->spot.u = p->spot.v = 0;
    p->from = point_over(p, 0);
    return LOFT_OK;
}

/* May the chord to `end`, over step `to`, be given? It is looked at in its quarters: the middle
 * alone does not tell a wave from a straight line. */
static bool chord_fits(loft_pass *p, const loft_vec *end, uint32_t to)
{
    const loft_acc a = loft_to_acc(loft_vec_axis(&p->from, 2)),
                   b = loft_to_acc(loft_vec_axis(end, 2));
    const uint32_t n = to - p->at;

    for (uint32_t k = 1; k < 4 && n > 1; k++) {
        const uint32_t at = k * n / 4;
        if (at == 0 || (n < 4 && k != 2))
            continue;
        const loft_vec over = point_over(p, p->at + at);
        if (loft_acc_lerp_at(a, b, at, n) - loft_to_acc(loft_vec_axis(&over, 2)) >
            2 * loft_to_acc(p->d->tol))
            return false;
    }
    return loft_drop_clear(p->d, &p->from, end);
}

/* Beside a wall: up on the spot, across where it is clear, down on the spot. */
static void go_over(loft_pass *p, const loft_vec *to)
{
    loft_vec up = p->from, over = *to;
    const loft_real z = loft_drop_over(p->d, &up, to);

    set_height(&up, z);
    set_height(&over, z);
    p->next[0] = *to;           /* the last one first */
    p->next[1] = over;
    p->queued = 2;
    p->from = up;
}

bool loft_pass_next(loft_pass *p, loft_vec *out)
{
    if (p->queued > 0) {
        p->from = p->next[--p->queued];
        *out = p->from;
        return true;
    }
    if (p->at >= p->n)
        return false;
    for (;;) {
        const uint32_t by = (uint32_t)1 << p->level, to = p->at + by < p->n ? p->at + by : p->n;
        const loft_vec end = point_over(p, to);
        if (chord_fits(p, &end, to)) {
            p->at = to;
            p->from = end;
            p->level = (uint8_t)(p->level + (p->level < p->most));
            break;
        }
        if (p->level == 0) {
            p->at = to;
            go_over(p, &end);
            break;
        }
        p->level--;
    }
    *out = p->from;
    return true;
}


/* Cusps */

static loft_vec point_of(unsigned axis, loft_real along, loft_real across)
{
    loft_vec p = { { 0 } };

    p.axis[0] = axis == 0 ? along : across;
    p.axis[LOFT_AXES > 1 ? 1 : 0] = axis == 0 ? across : along;
    return p;
}

/* x / y as a slope, y > 0. */
static loft_real ratio_of(loft_real x, loft_real y)
{
    const loft_real size = loft_real_abs(x);

    if (!(loft_to_acc(size) < loft_to_acc(y) * 64))
        return x < 0 ? LOFT_REAL(-64) : LOFT_REAL(64);
    return loft_div(x, y);
}

/* z: the tip over the first line, between, over the second line; slope: of the way. */
static loft_real cusp_of(loft_real radius, const loft_real z[3], loft_real step, loft_real slope)
{
    const loft_acc one = loft_to_acc(LOFT_REAL(1)), r2 = loft_prod(radius, radius),
                   along2 = one + loft_prod(slope, slope);
    const loft_real rise = z[2] - z[0], g = ratio_of(rise, step),
                    turned = loft_div(rise, loft_acc_sqrt(along2)),
                    steep = loft_acc_sqrt(along2 + loft_prod(g, g));
    const loft_acc half2 = loft_acc_ratio(loft_prod(step, step) + loft_prod(turned, turned), 4);
    const loft_acc mean = loft_acc_mean(loft_to_acc(z[0]), loft_to_acc(z[2]));
    const loft_acc bulge = loft_acc_div(loft_to_acc(z[1]) - mean, steep);

    if (half2 >= r2)
        return radius;
    const loft_acc sum = loft_to_acc(radius) + loft_to_acc(loft_acc_sqrt(r2 - half2));
    return loft_acc_round(loft_to_acc(loft_acc_quot(half2, sum)) - bulge);
}

/* Is the tangent plane of a sheet at a spot nearly at a right angle to the ball's radius there? At
 * a border it is not. The spot errs by what the tolerance allows: sqrt(2 tol / radius) < 1/8. */
static bool rests_inside(const loft_drop *d, const loft_drop_spot *spot, const loft_vec *tip)
{
    const loft_surface *s = &d->sheet[spot->sheet].surface;
    const loft_unit step = LOFT_UNIT(0.00390625), one = LOFT_UNIT(1);
    loft_vec p, q;

    if (s->eval(s->surface, spot->u, spot->v, &p) != LOFT_OK)
        return false;
    for (int k = 0; k < 2; k++) {
        const loft_unit sum = s->over == LOFT_SURFACE_TRIANGLE ? spot->u + spot->v
                              : k == 0                         ? spot->u
                                                               : spot->v,
                        by = sum + step > one ? -step : step;
        loft_acc along = 0, length2 = 0;
        if ((k == 0 ? spot->u : spot->v) + by < 0 ||
            s->eval(s->surface, spot->u + (k == 0 ? by : 0), spot->v + (k == 1 ? by : 0), &q) !=
                LOFT_OK)
            return false;
        for (int axis = 0; axis < 3; axis++) {
            const loft_real side = loft_vec_axis(&q, axis) - loft_vec_axis(&p, axis),
                            to = loft_vec_axis(tip, axis) - loft_vec_axis(&p, axis) +
                                 (axis == 2 ? d->cutter.radius : 0);
            along += loft_prod(side, to);
            length2 += loft_prod(side, side);
        }
        if (loft_acc_abs(along) * 16 > 3 * loft_prod(loft_acc_sqrt(length2), d->cutter.radius))
            return false;
    }
    return true;
}

/* Five places across: the first line, and every quarter of the step to the second one. */
typedef struct {
    loft_real z[5];
    bool met[5];                /* the ball rests inside of a sheet */
    loft_drop_spot spot[5];
} section;

static void look_at(const loft_drop *d, unsigned axis, loft_real along, loft_real at,
                    loft_real step, int k, section *s)
{
    loft_vec tip = point_of(axis, along, k < 4 ? at + step / 4 * (loft_real)k : at + step);

    s->z[k] = loft_drop_height(d, loft_vec_axis(&tip, 0), loft_vec_axis(&tip, 1), &s->spot[k]);
    set_height(&tip, s->z[k]);
    s->met[k] = s->z[k] > d->floor + 2 * d->tol && rests_inside(d, &s->spot[k], &tip);
}

/* The largest slope between places of a sheet; `step` from the first to the last. */
static loft_real steepest(const section *s, loft_real step)
{
    loft_real most = 0;

    for (int k = 0; k < 4; k++)
        if (s->met[k] && s->met[k + 1]) {
            const loft_real slope = ratio_of(loft_real_abs(s->z[k + 1] - s->z[k]), step / 4);
            most = slope > most ? slope : most;
        }
    return most;
}

/* The cusp there, `by` beyond the section before. Over a border only one side of the cusp stands,
 * on a sheet that is taken for a plane of its steepest slope. */
static loft_real cusp_at(const loft_drop *d, unsigned axis, loft_real along, loft_real at,
                         loft_real step, loft_real by, const section *before, section *s)
{
    loft_real slope = 0, z[3];

    for (int k = 0; k < 5; k += 2) {
        look_at(d, axis, along, at, step, k, s);
        z[k / 2] = s->z[k];
        if (s->met[k] && before->met[k])
            slope = ratio_of(s->z[k] - before->z[k], by);
    }
    if (!(s->met[0] || s->met[2] || s->met[4]))
        return 0;
    if (!(s->met[0] && s->met[2] && s->met[4])) {
        look_at(d, axis, along, at, step, 1, s);
        look_at(d, axis, along, at, step, 3, s);
        z[0] = 0;
        z[2] = loft_mul(steepest(s, step), step);
        z[1] = z[2] / 2;
    } else if (before->met[2])
        slope = ratio_of(s->z[2] - before->z[2], by);
    else
        return 0;
    return cusp_of(d->cutter.radius, z, step, slope);
}

loft_real loft_raster_cusp(const loft_drop *d, unsigned axis, loft_real at, loft_real step,
                           loft_real from, loft_real to)
{
    const loft_acc length = loft_acc_abs(loft_to_acc(to) - loft_to_acc(from));
    loft_real most = 0;
    section before, here;
    uint32_t n = 1;

    while (n < LOFT_RASTER_LOOKS && (n < 16 || loft_to_acc(d->cutter.radius) * (int32_t)n < length))
        n *= 2;
    for (int k = 0; k < 5; k++) {
        here.spot[k].sheet = 0;
        here.spot[k].u = here.spot[k].v = 0;
        here.z[k] = 0;
        here.met[k] = false;
    }
    const loft_real by = loft_acc_round(loft_acc_ratio(length, (int32_t)n));
    for (uint32_t j = 0; j <= n; j++) {
        before = here;
        const loft_real along = loft_acc_round(
                            loft_acc_lerp_at(loft_to_acc(from), loft_to_acc(to), j, n)),
                        cusp = cusp_at(d, axis, along, at, step, by, &before, &here);
        most = cusp > most ? cusp : most;
    }
    return most;
}


/* The raster */

static loft_real limit_of(const loft_raster *r, bool upper, unsigned axis)
{
    return loft_vec_axis(upper ? &r->area.max : &r->area.min, (int)axis);
}

/* The step that leaves this cusp over a level plane: 2 sqrt(c (2 r - c)). */
static loft_real level_step(const loft_raster *r)
{
    return 2 * loft_acc_sqrt(loft_prod(r->wish, 2 * r->d.cutter.radius - r->wish));
}

/* Walk from the end of the last pass, whose height is as good as a new one. */
static enum loft_status go_on(loft_raster *r, const loft_vec *start, const loft_vec *end)
{
    const loft_vec last = r->pass.from;
    const bool first = r->lines == 0;
    const enum loft_status status = loft_pass_init(&r->pass, &r->d, start, end);

    if (!first)
        r->pass.from = last;
    return status;
}

static enum loft_status begin_line(loft_raster *r)
{
    const loft_real from = limit_of(r, r->back, r->axis), to = limit_of(r, !r->back, r->axis);
    const loft_vec start = point_of(r->axis, from, r->place), end = point_of(r->axis, to, r->place);
    const enum loft_status status = go_on(r, &start, &end);

    r->lines += status == LOFT_OK;
    r->back = !r->back;
    r->linking = false;
    return status;
}

static loft_real tol_of(loft_real tol)
{
    const loft_real least = loft_drop_tol();

    return tol > least ? tol : least;
}

/* All but the first line. */
static enum loft_status prepare(loft_raster *r, const loft_drop *d, const loft_box *area,
                                unsigned axis, loft_real cusp, loft_real step)
{
    const bool ball = d->cutter.radius <= d->cutter.corner;

    if (LOFT_AXES < 3 || !loft_drop_takes(area) || axis > 1 || !(cusp >= 0 && step >= 0) ||
        (cusp > 0) == (step > 0) || (cusp > 0 && (!ball || !(cusp < d->cutter.radius / 2))))
        return LOFT_ERR_ARG;
    r->d = *d;
    r->d.tol = tol_of(d->tol / 4);
    r->fine = *d;
    r->fine.tol = tol_of(cusp / 64 < d->tol ? cusp / 64 : d->tol);
    r->area = *area;
    r->axis = (uint8_t)axis;
    r->wish = cusp;
    r->step = step;
    r->cusp = 0;
    r->lines = 0;
    r->back = r->over = r->begun = r->linking = r->spiral = false;
    r->side = 0;
    r->place = limit_of(r, false, 1u - axis);
    if (cusp > 0)
        r->step = level_step(r);
    return LOFT_OK;
}

enum loft_status loft_raster_init(loft_raster *r, const loft_drop *d, const loft_box *area,
                                  unsigned axis, loft_real cusp, loft_real step)
{
    const enum loft_status status = prepare(r, d, area, axis, cusp, step);

    return status == LOFT_OK ? begin_line(r) : status;
}

/* Does the line lie at the upper end of what is left of a spiral? */
static bool is_upper(const loft_raster *r) { return r->side == 1 || r->side == 2; }

/* The step that should leave the wished cusp: it goes about with the square of the step. */
static loft_real scale_step(const loft_raster *r, loft_real step, loft_real cusp)
{
    /* aim at 24/25 of the wish */
    const loft_acc share = loft_acc_ratio(loft_to_acc(r->wish) * 24, 25);
    const loft_real by = !(loft_to_acc(cusp) * 16 > share)
                             ? LOFT_REAL(4)
                             : loft_acc_sqrt(loft_to_acc(loft_acc_quot(share, loft_to_acc(cusp))));

    return loft_mul(step, by < LOFT_REAL(0.25) ? LOFT_REAL(0.25) : by);
}

static loft_real within(loft_real x, loft_real least, loft_real most)
{
    return x < least ? least : x > most ? most : x;
}

/* Find the step to the next line, between the largest one that is known to be small enough and the
 * smallest one that is not. */
static loft_real find_step(loft_raster *r)
{
    const bool upper = is_upper(r);
    const loft_real rest = limit_of(r, !upper, 1u - r->axis) - r->place,
                    width = upper ? -rest : rest, from = limit_of(r, false, r->axis),
                    to = limit_of(r, true, r->axis), most = within(width, 0, 4 * level_step(r)),
                    least = within(level_step(r) / 64, 0, most);
    loft_real step = within(r->step, least, most), low = 0, high = most, cusp = 0, left = 0;

    for (int round = 0; round < ROUNDS; round++) {
        cusp = loft_raster_cusp(&r->fine, r->axis, upper ? r->place - step : r->place, step, from,
                                to);
        const bool small = cusp <= r->wish;
        *(small ? &low : &high) = step;
        if (small || !(low > 0))
            left = cusp;
        if (small ? loft_to_acc(cusp) * 25 >= loft_to_acc(r->wish) * 23 || step >= most
                  : step <= least)
            break;
        step = within(scale_step(r, step, cusp), least, most);
        if (low > 0 && low < high && !(step > low && step < high))
            step = low / 2 + high / 2;
    }
    step = low > 0 ? low : step;
    if (r->spiral)
        left = loft_mul(left, LOFT_REAL(CORNER));
    if (left > r->cusp)
        r->cusp = left;
    r->step = step;
    return step;
}

/* Begin the way to the next line, along the border of the area. */
static bool begin_link(loft_raster *r)
{
    const loft_real end = limit_of(r, true, 1u - r->axis), along = limit_of(r, r->back, r->axis);

    if (!(r->place < end))
        return false;
    const loft_vec start = point_of(r->axis, along, r->place);
    const loft_real step = r->wish > 0 ? find_step(r) : r->step;
    r->place = end - r->place > step ? r->place + step : end;
    const loft_vec to = point_of(r->axis, along, r->place);
    r->linking = true;
    return go_on(r, &start, &to) == LOFT_OK;
}


/* A spiral
 *
 * Of four lines around a rectangle each begins where the one before ends. Whoever has walked one
 * moves that side inward: the area is what is still to be walked. */

/* The corner at which this side ends. */
static loft_vec corner_of(const loft_raster *r)
{
    return point_of(r->axis, limit_of(r, r->side < 2, r->axis), r->place);
}

static enum loft_status begin_side(loft_raster *r, const loft_vec *start)
{
    const loft_vec end = corner_of(r);
    const enum loft_status status = go_on(r, start, &end);

    r->lines += status == LOFT_OK;
    return status;
}

enum loft_status loft_raster_init_spiral(loft_raster *r, const loft_drop *d, const loft_box *area,
                                         loft_real cusp, loft_real step)
{
    const enum loft_status status = prepare(r, d, area, 0, cusp, step);

    if (status != LOFT_OK)
        return status;
    r->spiral = true;
    r->wish = loft_div(cusp, LOFT_REAL(CORNER));
    return begin_side(r, &area->min);
}

/* Move the side inward, and begin the next one. */
static bool turn_corner(loft_raster *r)
{
    const loft_vec start = corner_of(r);
    const bool upper = is_upper(r);
    const unsigned across = 1u - r->axis;
    const loft_real width = limit_of(r, true, across) - limit_of(r, false, across);

    if (!(width > 0))
        return false;
    const loft_real wish = r->wish > 0 ? find_step(r) : r->step, step = wish < width ? wish : width,
                    to = r->place + (upper ? -step : step);
    loft_vec *const limit = upper ? &r->area.max : &r->area.min;
    limit->axis[across < LOFT_AXES ? across : 0] = to;
    r->side = (uint8_t)((r->side + 1) % 4);
    r->axis = (uint8_t)across;
    r->place = limit_of(r, is_upper(r), 1u - r->axis);
    return begin_side(r, &start) == LOFT_OK;
}

bool loft_raster_next(loft_raster *r, loft_vec *out)
{
    if (r->over)
        return false;
    if (!r->begun) {
        r->begun = true;
        *out = r->pass.from;
        return true;
    }
    while (!loft_pass_next(&r->pass, out))
        if (r->spiral ? !turn_corner(r) : r->linking ? begin_line(r) != LOFT_OK : !begin_link(r)) {
            r->over = true;
            return false;
        }
    return true;
}
