/* lib/toolpath/raster.c
 * SPDX-License-Identifier: MIT
 *
 * Heights are found within tol / 4, and raised by tol / 4; a chord that clears all sheets then may
 * sag by as much. Its middle is at most tol / 2 too high.
 *
 * Where a spiral turns, two of its lines are corners, of an angle a on the surface, with lines L
 * apart. Along their bisector the inner corner is L / sin(a / 2) behind the outer one. The place
 * that is as far from the inner corner as from the outer lines is L / (1 + sin(a / 2)) from both;
 * between lines it is L / 2. Cusps go with the square: 4 / (1 + sin(a / 2))^2 times. Level, that is
 * 4 (2 - sqrt(2))^2; over slopes p and q along the two ways inward, cos a = p q / sqrt((1 + p^2)
 * (1 + q^2)), so that cusps are up to four times as high.
 */
#include "toolpath/raster.h"

#include "toolpath/tip_place.h"

#define FINEST 16               /* a line has at most 2^16 steps */
#define ROUNDS 8                /* tries of one step across */
#define LEVEL_CORNER 1.3725830020304792     /* 4 (2 - sqrt(2))^2 */


/* A line */

static loft_vec point_over(loft_pass *p, uint32_t at)
{
    loft_vec out = p->start;

    for (int k = 0; k < LOFT_AXES && k < 2; k++)
        out.axis[k] = loft_acc_round(
            loft_acc_lerp_at(loft_to_acc(p->start.axis[k]), loft_to_acc(p->end.axis[k]), at, p->n));
    const loft_real z = loft_drop_height(p->d, loft_vec_axis(&out, 0), loft_vec_axis(&out, 1),
                                         &p->spot);
    loft_place_lift(&out, z + p->d->tol);
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

/* True if the chord to `end`, over step `to`, may be given. It is looked at in its quarters: the
 * middle alone does not tell a wave from a straight line. */
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

    loft_place_lift(&up, z);
    loft_place_lift(&over, z);
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
    const loft_vec start = loft_place_of(r->axis, from, r->place),
                   end = loft_place_of(r->axis, to, r->place);
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

/* True if the line lies at the upper end of what is left of a spiral. */
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
        left = loft_mul(left, r->corner);
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
    const loft_vec start = loft_place_of(r->axis, along, r->place);
    const loft_real step = r->wish > 0 ? find_step(r) : r->step;
    r->place = end - r->place > step ? r->place + step : end;
    const loft_vec to = loft_place_of(r->axis, along, r->place);
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
    return loft_place_of(r->axis, limit_of(r, r->side < 2, r->axis), r->place);
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
    r->asked = cusp;
    r->corner = LOFT_REAL(LEVEL_CORNER);
    r->wish = loft_div(cusp, r->corner);
    return begin_side(r, &area->min);
}

/* True if the tangent plane of a sheet at a spot is nearly at a right angle to the ball's radius
 * there. At a border it is not. The spot errs by what the tolerance allows: sqrt(2 tol / radius) <
 * 1/8. */
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

/* By how much cusps are higher inside of a corner than between lines; by: the ways inward from it.
 * Where the ball does not rest inside of a sheet, that of a level corner. */
static loft_real share_at(const loft_raster *r, const loft_vec *at, const loft_real by[2])
{
    const loft_acc one = loft_to_acc(LOFT_REAL(1));
    loft_real z[3], slope[2], length[2];
    loft_drop_spot spot = { 0, 0, 0 };

    for (int k = 0; k < 3; k++) {           /* there, and beside it along each axis */
        loft_vec tip = *at;
        if (k > 0)
            tip.axis[k <= LOFT_AXES ? k - 1 : 0] += by[k - 1];
        z[k] = loft_drop_height(&r->fine, loft_vec_axis(&tip, 0), loft_vec_axis(&tip, 1), &spot);
        loft_place_lift(&tip, z[k]);
        if (!rests_inside(&r->fine, &spot, &tip))
            return LOFT_REAL(LEVEL_CORNER);
    }
    for (int k = 0; k < 2; k++) {
        slope[k] = loft_place_slope(z[k + 1] - z[0], loft_real_abs(by[k]));
        length[k] = loft_acc_sqrt(one + loft_prod(slope[k], slope[k]));
    }
    const loft_real cosine = loft_div(loft_mul(slope[0], slope[1]), loft_mul(length[0], length[1])),
                    sum = LOFT_REAL(1) +
                          loft_acc_sqrt(loft_acc_ratio(one - loft_to_acc(cosine), 2));
    return loft_div(LOFT_REAL(4), loft_mul(sum, sum));
}

/* The largest share at the corners where this side begins and ends, and a step inside of them. */
static loft_real corner_share(const loft_raster *r)
{
    const loft_real fine = r->d.cutter.radius / 8;
    loft_real most = LOFT_REAL(LEVEL_CORNER);

    for (int end = 0; end < 2; end++)
        for (int inside = 0; inside < 2; inside++) {
            const bool down[2] = { end > 0, is_upper(r) };
            const loft_real step = inside ? r->step : 0;
            const loft_vec at = loft_place_of(
                r->axis, limit_of(r, end > 0, r->axis) + (down[0] ? -step : step),
                r->place + (down[1] ? -step : step));
            loft_real by[2];
            by[r->axis] = down[0] ? -fine : fine;
            by[1 - r->axis] = down[1] ? -fine : fine;
            const loft_real share = share_at(r, &at, by);
            most = share > most ? share : most;
        }
    return most;
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
    if (r->wish > 0) {
        r->corner = corner_share(r);
        r->wish = loft_div(r->asked, r->corner);
    }
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
