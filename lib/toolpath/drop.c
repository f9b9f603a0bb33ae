/* lib/toolpath/drop.c
 * SPDX-License-Identifier: MIT
 *
 * A plane z = c + g . (x, y) on which every point of a piece lies, or below it, lets the cutter
 * rest on it with its tip
 *
 *     lift(|g|) + c + g . (tip's x, y)
 *
 * high: there it cuts nothing of the piece. So for every slope g
 *
 *     B(g) = max over the corners of (z - g . (corner - tip)) + lift(|g|) + (1 + |g_x| + |g_y|) e
 *
 * is high enough, e the distance between the piece and the hull of its corners. B is wanted low,
 * and any g is allowed: g errs without harm. Two are tried: that of the piece itself, where the
 * cutter rests on its inside, and that of the cutter over the piece, where it rests on an edge.
 * Both exceed the true height by a constant times the square of the piece's size, so few pieces
 * remain at each level.
 *
 * On a way from a to b the plane must serve at both ends, which are the worst: B is linear along
 * the way. The best plane does not rise or fall against the way, so the part of g along it is
 * replaced by the slope of the way.
 */
#include "toolpath/drop.h"

#define ROOM (3 * LOFT_DROP_LEVELS + 1)

/* A piece with its corners: 4, or 3 of a triangle. */
typedef struct {
    loft_acc bound;
    loft_vec corner[4];
    loft_sheet_piece at;
    uint8_t corners;
    bool inside;                /* of the region to which the sheet is trimmed */
} piece;

/* A way of the tip. To find a height: from a point at height 0 to itself, and `limit` rises. */
typedef struct {
    const loft_drop *d;
    loft_real from[3], by[2];
    loft_acc rise;              /* of the way */
    loft_acc length2;           /* squared, seen from above */
    loft_real along[2], slope;  /* its direction, and its steepness */
    loft_acc limit;             /* no piece is of interest that asks for no more */
    loft_acc need;              /* the largest bound of what was left out */
    loft_drop_spot spot;
} way;

enum loft_status loft_drop_init(loft_drop *d, const loft_sheet sheet[], uint32_t count,
                                const loft_cutter *cutter, loft_real tol, loft_real floor)
{
    if (count < 1 || !(tol >= loft_drop_tol()) ||
        !(loft_real_abs(floor) <= LOFT_REAL(LOFT_SHEET_REACH)))
        return LOFT_ERR_ARG;
    d->sheet = sheet;
    d->count = count;
    d->cutter = *cutter;
    d->tol = tol;
    d->floor = floor;
    d->slack = loft_acc_mul(loft_real_ulp(loft_to_acc(LOFT_REAL(1))), cutter->radius) +
               loft_real_ulp(loft_to_acc(cutter->radius));
    return LOFT_OK;
}


/* Where the way is nearest to a place, and the slope of the cutter there */

typedef struct {
    loft_real off[2], distance; /* of the place, seen from above */
    loft_acc below;             /* the height of the way there */
    bool inside;                /* strictly between the ends */
} foot;

static void find_foot(const way *w, loft_real x, loft_real y, foot *out)
{
    const loft_real to[2] = { x - w->from[0], y - w->from[1] };
    const loft_acc along = loft_prod(to[0], w->by[0]) + loft_prod(to[1], w->by[1]);
    loft_acc d2 = 0;
    loft_unit t = 0;

    out->inside = along > 0 && along < w->length2;
    if (out->inside)
        t = loft_unit_ratio(along, w->length2);
    else if (along > 0)
        t = LOFT_UNIT(1);
    for (int k = 0; k < 2; k++) {
        out->off[k] = to[k] - loft_acc_round(loft_acc_scale(loft_to_acc(w->by[k]), t));
        d2 += loft_prod(out->off[k], out->off[k]);
    }
    out->distance = loft_acc_sqrt(d2);
    out->below = loft_to_acc(w->from[2]) + loft_acc_scale(w->rise, t);
}

/* x / y, of the sign of x, at most the steepest slope. y = 0: the steepest. */
static loft_real slope_of(loft_acc x, loft_acc y)
{
    const loft_acc size = loft_acc_abs(x);
    const loft_real slope = !(size < LOFT_CUTTER_SLOPE * y) ? LOFT_REAL(LOFT_CUTTER_SLOPE)
                                                            : loft_acc_quot(size, y);

    return x < 0 ? -slope : slope;
}

/* No more than the steepest slope, in any direction. */
static void limit_slope(loft_real g[2])
{
    const loft_real most = LOFT_REAL(LOFT_CUTTER_SLOPE), x = loft_real_abs(g[0]),
                    y = loft_real_abs(g[1]);

    if (!(x + y <= most))
        for (int k = 0; k < 2; k++)
            g[k] = loft_div(loft_mul(g[k], most), x + y);
}

/* Give the slope the steepness of the way along it. */
static void turn_to_way(const way *w, loft_real g[2])
{
    if (!(w->length2 > 0))
        return;
    const loft_real more = w->slope - loft_acc_round(loft_prod(g[0], w->along[0]) +
                                                     loft_prod(g[1], w->along[1]));

    for (int k = 0; k < 2; k++)
        g[k] += loft_mul(more, w->along[k]);
    limit_slope(g);
}

/* The slope of the underside of the cutter, at its foot, over a place. */
static void slope_of_cutter(const way *w, const foot *at, loft_real g[2])
{
    const loft_cutter *c = &w->d->cutter;
    const loft_real x = at->distance - (c->radius - c->corner);

    g[0] = g[1] = 0;
    if (!(x > 0))
        return;
    const loft_acc square = loft_prod(c->corner, c->corner) - loft_prod(x, x);
    const loft_real across = square > 0 && x < c->corner ? loft_acc_sqrt(square) : 0,
                    slope = slope_of(loft_to_acc(x), loft_to_acc(across));
    for (int k = 0; k < 2; k++) {
        const loft_acc part = loft_prod(slope, at->off[k]);
        g[k] = slope_of(part, loft_to_acc(at->distance));
    }
    limit_slope(g);
}


/* Pieces of a sheet */

/* True if all of it is beside the way. */
static bool lies_aside(const way *w, const loft_box *box, loft_acc off)
{
    const loft_acc reach = loft_to_acc(w->d->cutter.radius) + off;

    for (int k = 0; k < 2; k++) {
        const loft_acc a = loft_to_acc(w->from[k]), b = loft_to_acc(w->from[k] + w->by[k]);
        if (loft_to_acc(loft_vec_axis(&box->max, k)) + reach < loft_acc_min(a, b) ||
            loft_to_acc(loft_vec_axis(&box->min, k)) - reach > loft_acc_max(a, b))
            return true;
    }
    return false;
}

/* By how much the way must rise to clear a plane of this slope over the piece. */
static loft_acc bound_of(const way *w, const piece *p, loft_acc off, const loft_real g[2])
{
    const loft_real steep = loft_real_abs(g[0]) + loft_real_abs(g[1]);
    loft_acc top = 0;

    for (unsigned k = 0; k < p->corners; k++) {
        const loft_acc z = loft_to_acc(loft_vec_axis(&p->corner[k], 2)) -
                           loft_prod(g[0], loft_vec_axis(&p->corner[k], 0) - w->from[0]) -
                           loft_prod(g[1], loft_vec_axis(&p->corner[k], 1) - w->from[1]);
        top = k == 0 || z > top ? z : top;
    }
    const loft_acc rises = loft_prod(g[0], w->by[0]) + loft_prod(g[1], w->by[1]) - w->rise;
    top += loft_acc_max(rises, 0) - loft_to_acc(w->from[2]);
    return top + loft_cutter_lift(&w->d->cutter, g) + off + loft_acc_mul(off, steep) + w->d->slack;
}

/* The slope of the piece, from its sides. */
static void slope_of_piece(const piece *p, loft_real g[2])
{
    const unsigned last = p->corners - 1u;
    loft_real a[3], b[3];

    for (int k = 0; k < 3; k++) {
        const loft_real base = loft_vec_axis(&p->corner[0], k);
        a[k] = loft_vec_axis(&p->corner[1], k) - base;
        b[k] = loft_vec_axis(&p->corner[2], k) - base;
        if (last == 3) {        /* half of the diagonals' sum and difference */
            const loft_acc far = loft_to_acc(loft_vec_axis(&p->corner[3], k) - base),
                           side = loft_to_acc(a[k] - b[k]);
            a[k] = loft_acc_round(loft_acc_mean(far, side));
            b[k] = loft_acc_round(loft_acc_mean(far, -side));
        }
    }
    loft_acc n[3];
    for (int k = 0; k < 3; k++)
        n[k] = loft_prod(a[(k + 1) % 3], b[(k + 2) % 3]) -
               loft_prod(a[(k + 2) % 3], b[(k + 1) % 3]);
    for (int k = 0; k < 2; k++)
        g[k] = n[2] < 0 ? slope_of(n[k], -n[2]) : slope_of(-n[k], n[2]);
    limit_slope(g);
}

/* A bound of what a piece asks for; below the limit as soon as one slope shows it. */
static loft_acc find_bound(const way *w, const piece *p, loft_acc off, const foot *middle)
{
    loft_acc top = loft_to_acc(loft_vec_axis(&p->corner[0], 2));
    loft_real g[2];

    for (unsigned k = 1; k < p->corners; k++)
        top = loft_acc_max(top, loft_to_acc(loft_vec_axis(&p->corner[k], 2)));
    loft_acc bound = top + off - loft_to_acc(w->from[2]) - loft_acc_min(w->rise, 0);
    if (bound <= w->limit)
        return bound;
    slope_of_piece(p, g);
    turn_to_way(w, g);
    bound = loft_acc_min(bound, bound_of(w, p, off, g));
    if (bound <= w->limit)
        return bound;
    slope_of_cutter(w, middle, g);
    if (middle->inside)
        turn_to_way(w, g);
    return loft_acc_min(bound, bound_of(w, p, off, g));
}

/* True if it is a point of a sheet that may be trimmed. */
static bool belongs_to(const loft_sheet *s, const loft_vec *p, loft_unit u, loft_unit v)
{
    if (!s->trim)
        return true;
    return loft_region_has(s->trim, s->plane
                                        ? loft_region_spot(loft_vec_axis(p, 0), loft_vec_axis(p, 1))
                                        : loft_region_spot(loft_acc_round(loft_unit_to_acc(u)),
                                                           loft_acc_round(loft_unit_to_acc(v))));
}

/* A point of the surface, a lower bound of the cutter's height over it. */
static void learn_point(way *w, const loft_vec *p, uint32_t sheet, loft_unit u, loft_unit v)
{
    foot at;

    if (loft_to_acc(loft_vec_axis(p, 2)) - loft_to_acc(w->from[2]) <= w->limit)
        return;
    find_foot(w, loft_vec_axis(p, 0), loft_vec_axis(p, 1), &at);
    if (at.distance > w->d->cutter.radius)
        return;
    const loft_acc need = loft_to_acc(loft_vec_axis(p, 2)) - at.below -
                          loft_cutter_rise(&w->d->cutter, at.distance);
    if (need > w->limit && belongs_to(&w->d->sheet[sheet], p, u, v)) {
        w->limit = need;
        w->spot.sheet = sheet;
        w->spot.u = u;
        w->spot.v = v;
    }
}

/* Corner k of a piece. */
static loft_vec get_corner(way *w, uint32_t sheet, const loft_sheet_piece *at, unsigned k,
                           bool learn)
{
    const loft_surface *s = &w->d->sheet[sheet].surface;
    const uint32_t n = (uint32_t)1 << at->level;
    uint32_t step[2];
    loft_vec p = { { 0 } };

    loft_sheet_piece_corner(at, k, step);
    const loft_unit u = loft_unit_of(step[0], n), v = loft_unit_of(step[1], n);

    if (s->eval(s->surface, u, v, &p) == LOFT_OK && learn)      /* these have points everywhere */
        learn_point(w, &p, sheet, u, v);
    return p;
}

/* True if an upright plane across the direction from the foot separates the piece from the sides of
 * the cutter. */
static bool lies_beyond(const way *w, const piece *p, loft_acc off, const foot *middle)
{
    const loft_acc reach = loft_to_acc(w->d->cutter.radius) + off + off + w->d->slack,
                   length = loft_to_acc(middle->distance);
    loft_real toward[2];

    if (!(length > 0))
        return false;
    for (int k = 0; k < 2; k++)
        toward[k] = slope_of(loft_to_acc(middle->off[k]), length);
    const loft_acc on = loft_acc_max(
        loft_prod(toward[0], w->by[0]) + loft_prod(toward[1], w->by[1]), 0);
    for (unsigned k = 0; k < p->corners; k++)
        if (loft_prod(toward[0], loft_vec_axis(&p->corner[k], 0) - w->from[0]) +
                loft_prod(toward[1], loft_vec_axis(&p->corner[k], 1) - w->from[1]) - on <=
            reach)
            return false;
    return true;
}

/* No piece is of interest that asks for no more than this. */
static loft_acc enough_for(const way *w, bool learn)
{
    return learn ? loft_acc_max(w->limit + loft_to_acc(w->d->tol), w->need) : w->limit;
}

static void grow_box(loft_box *box, loft_acc off)
{
    const loft_real by = loft_acc_round(off +
                                        loft_real_ulp(loft_to_acc(LOFT_REAL(LOFT_SHEET_REACH))));

    for (int k = 0; k < LOFT_AXES; k++) {
        box->min.axis[k] -= by;
        box->max.axis[k] += by;
    }
}

/* True if the piece is of interest; then p->bound is known. */
static bool weigh_piece(way *w, uint32_t sheet, piece *p, bool learn)
{
    const loft_acc off = loft_sheet_gap(&w->d->sheet[sheet], p->at.level);
    loft_box box = { p->corner[0], p->corner[0] };
    foot middle;

    for (unsigned k = 1; k < p->corners; k++)
        box = loft_box_join(box, p->corner[k]);
    if (lies_aside(w, &box, off))
        return false;
    find_foot(w, loft_vec_axis(&box.min, 0) / 2 + loft_vec_axis(&box.max, 0) / 2,
              loft_vec_axis(&box.min, 1) / 2 + loft_vec_axis(&box.max, 1) / 2, &middle);
    if (lies_beyond(w, p, off, &middle))
        return false;
    if (!p->inside) {
        grow_box(&box, off);
        const enum loft_region_part part = loft_sheet_part_of(&w->d->sheet[sheet], &box, &p->at);
        if (part == LOFT_REGION_OUT)
            return false;
        p->inside = part == LOFT_REGION_IN;
    }
    p->bound = find_bound(w, p, off, &middle);
    if (p->at.level < LOFT_DROP_LEVELS && p->bound > enough_for(w, learn))
        return true;
    w->need = loft_acc_max(w->need, p->bound);
    return false;
}

/* The four quarters of a piece. They share the points between its corners. */
static void quarter(way *w, uint32_t sheet, const piece *p, bool learn, piece out[4])
{
    loft_vec grid[9];
    unsigned known = 0;

    for (unsigned k = 0; k < p->corners; k++) {
        const unsigned spot = loft_sheet_piece_own(&p->at, k);
        grid[spot] = p->corner[k];
        known |= 1u << spot;
    }
    for (unsigned k = 0; k < 4; k++) {
        out[k].at = loft_sheet_piece_quarter(&p->at, p->corners == 3, k);
        out[k].corners = p->corners;
        out[k].inside = p->inside;
        for (unsigned m = 0; m < p->corners; m++) {
            const unsigned spot = loft_sheet_piece_spot(&p->at, &out[k].at, m);
            if (!(known >> spot & 1))
                grid[spot] = get_corner(w, sheet, &out[k].at, m, learn);
            known |= 1u << spot;
            out[k].corner[m] = grid[spot];
        }
    }
}

static void whole_sheet(way *w, uint32_t sheet, bool learn, piece *p)
{
    const loft_sheet *s = &w->d->sheet[sheet];

    p->corners = s->surface.over == LOFT_SURFACE_TRIANGLE ? 3 : 4;
    p->at = s->part;
    p->inside = s->trim == NULL;
    for (unsigned k = 0; k < p->corners; k++)
        p->corner[k] = get_corner(w, sheet, &p->at, k, learn);
}

/* Search one sheet. `learn`: find what it asks for; otherwise stop when some piece of the smallest
 * size cannot be left out. */
static bool search_sheet(way *w, uint32_t sheet, bool learn)
{
    piece stack[ROOM], child[4];
    unsigned count = 0;

    whole_sheet(w, sheet, learn, &stack[0]);
    if (weigh_piece(w, sheet, &stack[0], learn))
        count = 1;
    while (count > 0) {
        const piece p = stack[--count];
        const unsigned base = count;
        if (p.bound <= enough_for(w, learn)) {
            w->need = loft_acc_max(w->need, p.bound);
            continue;
        }
        quarter(w, sheet, &p, learn, child);
        for (unsigned k = 0; k < 4; k++) {
            if (!weigh_piece(w, sheet, &child[k], learn))
                continue;
            unsigned place = count++;       /* the highest one last: it is the next */
            for (; place > base && stack[place - 1].bound > child[k].bound; place--)
                stack[place] = stack[place - 1];
            stack[place] = child[k];
        }
        if (!learn && w->need > w->limit)
            return false;
    }
    return true;
}

static loft_real within_reach(loft_real x)
{
    const loft_real most = LOFT_REAL(LOFT_SHEET_REACH);

    return x > most ? most : x < -most ? -most : x;
}

static void begin_way(way *w, const loft_drop *d, const loft_vec *from, const loft_vec *to)
{
    w->d = d;
    for (int k = 0; k < 3; k++)
        w->from[k] = loft_vec_axis(from, k);
    for (int k = 0; k < 2; k++)
        w->by[k] = loft_vec_axis(to, k) - w->from[k];
    w->rise = loft_to_acc(loft_vec_axis(to, 2)) - loft_to_acc(w->from[2]);
    w->length2 = loft_prod(w->by[0], w->by[0]) + loft_prod(w->by[1], w->by[1]);
    const loft_real length = loft_acc_sqrt(w->length2);
    for (int k = 0; k < 2; k++)
        w->along[k] = length > 0 ? slope_of(loft_to_acc(w->by[k]), loft_to_acc(length)) : 0;
    w->slope = length > 0 ? slope_of(w->rise, loft_to_acc(length)) : 0;
    w->limit = w->need = 0;
    w->spot.sheet = 0;
    w->spot.u = w->spot.v = 0;
}

static bool is_of_interest(const way *w, uint32_t sheet, loft_acc above)
{
    const loft_box *box = &w->d->sheet[sheet].box;
    const loft_acc fuzz = w->d->sheet[sheet].fuzz;

    return loft_to_acc(loft_vec_axis(&box->max, 2)) + fuzz > above && !lies_aside(w, box, fuzz);
}

loft_real loft_drop_height(const loft_drop *d, loft_real x, loft_real y, loft_drop_spot *spot)
{
    loft_vec at = { { 0 } };
    way w;

    if (LOFT_AXES < 3)
        return d->floor;
    at.axis[0] = within_reach(x);
    at.axis[LOFT_AXES < 2 ? 0 : 1] = within_reach(y);
    begin_way(&w, d, &at, &at);
    w.limit = w.need = loft_to_acc(d->floor);
    if (spot && spot->sheet < d->count) {
        const loft_surface *s = &d->sheet[spot->sheet].surface;
        loft_vec p;
        w.spot = *spot;
        if (s->eval(s->surface, spot->u, spot->v, &p) == LOFT_OK)
            learn_point(&w, &p, spot->sheet, spot->u, spot->v);
    }
    for (uint32_t k = 0; k < d->count; k++)         /* the corners first: they rule out most */
        if (is_of_interest(&w, k, w.limit)) {
            piece whole;
            whole_sheet(&w, k, true, &whole);
        }
    for (uint32_t k = 0; k < d->count; k++)
        if (is_of_interest(&w, k, w.limit))
            search_sheet(&w, k, true);
    if (spot)
        *spot = w.spot;
    return loft_acc_round(loft_acc_max(w.need, w.limit)) + LOFT_REAL_LSB;
}

bool loft_drop_clear(const loft_drop *d, const loft_vec *from, const loft_vec *to)
{
    way w;

    if (LOFT_AXES < 3)
        return true;
    begin_way(&w, d, from, to);
    const loft_acc lowest = loft_to_acc(w.from[2]) + loft_acc_min(w.rise, 0);
    for (uint32_t k = 0; k < d->count; k++)
        if (is_of_interest(&w, k, lowest) && !search_sheet(&w, k, false))
            return false;
    return true;
}

loft_real loft_drop_over(const loft_drop *d, const loft_vec *from, const loft_vec *to)
{
    const loft_real a = loft_vec_axis(from, 2), b = loft_vec_axis(to, 2);
    loft_vec up = *from, over = *to;
    loft_real z = a > b ? a : b, more = d->tol;

    for (;; z += more, more += more) {
        up.axis[LOFT_AXES > 2 ? 2 : 0] = over.axis[LOFT_AXES > 2 ? 2 : 0] = z;
        if (loft_drop_clear(d, &up, &over) || !(z < LOFT_REAL(LOFT_SHEET_REACH)))
            return z;
    }
}
