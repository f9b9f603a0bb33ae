/* lib/toolpath/sector.c
 * SPDX-License-Identifier: MIT
 *
 * The weights of a patch are computed in ranges (polygon/jet_ball.h), as functions of the
 * parameters of the sector. There all distances from the sides of a polygon are linear. Points are
 * relative to one of them, for the derivatives of all weights sum to 0.
 *
 * A basepoint patch has three sectors where a corner of the triangle has the largest share, so at
 * least 1/3: v of loft_basepoint_corner is at most 2/3, away from the other corners.
 *
 * A Zheng-Ball patch with 5 or 6 sides has a sector for each corner: the parameters of its two
 * sides are at most those of the middle, 0.618 and 0.707. Of 5 parameters two neighbours always
 * are, for u_i = 1 - u_(i+2) u_(i+3). Of 6 as well: u_(i-1) and u_(i+1) are both 0.707 only in the
 * middle. With 3 sides u_1 and u_2 are used everywhere.
 */
#include "toolpath/sector.h"
#include "polygon/patch_ball.h"     /* loft_spatch_ball */
#include "polygon/wachspress.h"     /* loft_wachspress_eval */

#define CORNER_SHARE 0.66666666666666674
#define RING_SHARE(sides) ((sides) == 5 ? LOFT_UNIT(0.625) : LOFT_UNIT(0.71875))
#define FINER 3                 /* levels of pieces of a part */
#define ROUNDED LOFT_UNIT(0x1p-22)      /* parameters err by less, in every number type */

static unsigned next_of(unsigned i, unsigned n) { return i + 1 < n ? i + 1 : 0; }

static bool is_ring(const loft_sector *c) { return c->disk->of == LOFT_DISK_OF_ZHENG_BALL; }

static bool is_triangular(const loft_sector *c)
{
    return c->disk->of != LOFT_DISK_OF_BASEPOINT && (!is_ring(c) || c->disk->sides == 3);
}

unsigned loft_sector_count(const loft_disk *d)
{
    switch (d->of) {
    case LOFT_DISK_OF_SPATCH:
    case LOFT_DISK_OF_GB:
        return !d->harmonic && d->coordinates == loft_wachspress_eval && d->domain->convex
                   ? d->sides
                   : 0;
    case LOFT_DISK_OF_TORIC:     return d->sides;
    case LOFT_DISK_OF_BASEPOINT: return 3;
    case LOFT_DISK_OF_ZHENG_BALL: return d->sides == 3 ? 1 : d->sides;
    default:                     return 0;
    }
}


/* The surface */

/* The sides whose parameters are those of the sector: the one before its corner, the one after. */
static unsigned first_side(const loft_sector *c)
{
    const unsigned n = c->disk->sides;

    return n == 3 ? 0 : (c->number + n - 1) % n;
}

static enum loft_status ring_at(const loft_sector *c, loft_unit u, loft_unit v, loft_vec *out)
{
    const unsigned n = c->disk->sides;
    const loft_unit share = RING_SHARE(n);
    loft_sci turned[LOFT_ZHENG_BALL_SIDES], at[LOFT_ZHENG_BALL_SIDES];

    const enum loft_status status =
        n == 3
            ? loft_zheng_ball_params(n, u, v, turned)
            : loft_zheng_ball_params(n, loft_unit_round(loft_acc_scale(loft_unit_to_acc(share), u)),
                                     loft_unit_round(loft_acc_scale(loft_unit_to_acc(share), v)),
                                     turned);
    if (status != LOFT_OK)
        return status;
    for (unsigned i = 0; i < n; i++)
        at[(first_side(c) + i) % n] = turned[i];
    return loft_zheng_ball_eval((const loft_zheng_ball *)c->disk->patch, at, out);
}

static enum loft_status sector_at(const void *surface, loft_unit u, loft_unit v, loft_vec *out)
{
    const loft_sector *c = (const loft_sector *)surface;
    const loft_unit one = LOFT_UNIT(1), both = u + v;

    if (is_ring(c))
        return ring_at(c, u, v, out);
    if (!is_triangular(c)) {
        const loft_acc share = loft_acc_scale(loft_unit_to_acc(LOFT_UNIT(CORNER_SHARE)), v);
        return loft_basepoint_corner((const loft_basepoint *)c->disk->patch, c->number, u,
                                     loft_unit_round(share), out);
    }
    if (!(u >= 0 && v >= 0))
        return LOFT_ERR_ARG;
    const loft_unit share = both > 0 ? loft_unit_ratio(loft_unit_to_acc(v), loft_unit_to_acc(both))
                                     : 0;
    return c->disk->at(c->disk, c->number, share, both < one ? both : one, out, NULL);
}

loft_surface loft_surface_from_sector(const loft_sector *c)
{
    const loft_surface s = { sector_at, c,
                             is_triangular(c) ? LOFT_SURFACE_TRIANGLE : LOFT_SURFACE_SQUARE, NULL };
    return s;
}


/* Parts */

/* The corners of a part as steps of 2^-level, as loft_drop counts them. */
typedef struct {
    uint32_t at[4][2];
    unsigned corners, level;
    bool points;                /* the last level: derivatives do not count */
} part;

static void make_part(const loft_sector *c, const loft_sheet_piece *p, part *out)
{
    out->corners = is_triangular(c) ? 3 : 4;
    out->level = p->level;
    out->points = false;
    for (unsigned k = 0; k < out->corners; k++)
        loft_sheet_piece_corner(p, k, out->at[k]);
}

static loft_sci steps_of(const part *p, uint32_t n)
{
    return loft_sci_mul(loft_sci_from_int((int32_t)n), loft_sci_power2(-(int)p->level));
}

/* start + x u + y v over a part. */
static loft_jet_ball linear_ball(const part *p, loft_sci start, loft_sci x, loft_sci y)
{
    loft_jet_ball r = loft_jet_ball_of(loft_sci_zero());
    loft_sci value[4];

    for (unsigned k = 0; k < p->corners; k++) {
        value[k] = loft_sci_add(start, loft_sci_add(loft_sci_mul(x, steps_of(p, p->at[k][0])),
                                                    loft_sci_mul(y, steps_of(p, p->at[k][1]))));
        r.mid.f = loft_sci_add(r.mid.f, value[k]);
    }
    r.mid.f = loft_sci_div(r.mid.f, loft_sci_from_int((int32_t)p->corners));
    for (unsigned k = 0; k < p->corners; k++) {
        const loft_sci off = loft_sci_abs(loft_sci_sub(value[k], r.mid.f));
        if (loft_sci_less(r.off.f, off))
            r.off.f = off;
    }
    r.mid.x = x;
    r.mid.y = y;
    return r;
}

/* A linear function of the polygon, from its values at the middle and at two vertices. */
static loft_jet_ball ball_between(const part *p, const loft_sci at[3])
{
    return linear_ball(p, at[0], loft_sci_sub(at[1], at[0]), loft_sci_sub(at[2], at[0]));
}


/* Coordinates of a polygon */

/* A vertex of the polygon of a patch, of a toric one as well. */
static loft_spot vertex_of(const loft_sector *c, unsigned k)
{
    if (c->disk->of != LOFT_DISK_OF_TORIC)
        return c->disk->domain->v[k];
    const loft_lattice_edge *e = &((const loft_toric *)c->disk->patch)->lattice->edge[k];
    const loft_spot s = { { loft_real_from_int(e->from.at[0]),
                            loft_real_from_int(e->from.at[1]) } };

    return s;
}

/* Where a sector lies: its middle and two vertices. */
static loft_spot spot_of_sector(const loft_sector *c, unsigned k)
{
    const unsigned n = c->disk->sides;
    loft_acc sum[2] = { 0, 0 };
    loft_spot m;

    if (k > 0)
        return vertex_of(c, k == 1 ? c->number : next_of(c->number, n));
    for (unsigned j = 0; j < n; j++)
        for (int i = 0; i < 2; i++)
            sum[i] += loft_to_acc(vertex_of(c, j).at[i]);
    for (int i = 0; i < 2; i++)
        m.at[i] = loft_acc_round(loft_acc_ratio(sum[i], (int32_t)n));
    return m;
}

/* Twice the area of a point, vertex j and the next one. */
static void find_areas(const loft_sector *c, const part *p, loft_jet_ball area[])
{
    const loft_domain *d = c->disk->domain;

    for (unsigned j = 0; j < d->sides; j++) {
        const loft_spot *a = &d->v[j], *b = &d->v[next_of(j, d->sides)];
        loft_sci at[3];
        for (unsigned k = 0; k < 3; k++) {
            const loft_spot q = spot_of_sector(c, k);
            at[k] = loft_sci_cross(a->at, b->at, a->at, q.at);
        }
        area[j] = ball_between(p, at);
    }
}

/* Points and their derivatives */

static bool sum_polygon(const loft_sector *c, const part *p, loft_jet_ball_sum *sum)
{
    const loft_domain *d = c->disk->domain;
    loft_jet_ball area[LOFT_SIDES_MAX], phi[LOFT_SIDES_MAX];

    find_areas(c, p, area);
    return loft_wachspress_ball(d, area, phi) &&
           (c->disk->of == LOFT_DISK_OF_SPATCH
                ? loft_spatch_ball((const loft_spatch *)c->disk->patch, phi, sum)
                : loft_gb_ball((const loft_gb *)c->disk->patch, d, area, phi, p->points, sum));
}

/* The height over edge `edge` at the middle and at two vertices. */
static void toric_heights(const loft_sector *c, unsigned edge, loft_sci at[3])
{
    const loft_lattice_polygon *l = ((const loft_toric *)c->disk->patch)->lattice;
    int32_t sum = 0;

    for (unsigned k = 0; k < l->sides; k++)
        sum += loft_lattice_polygon_height(l, edge, l->edge[k].from);
    at[0] = loft_sci_div(loft_sci_from_int(sum), loft_sci_from_int(l->sides));
    for (unsigned k = 0; k < 2; k++) {
        const unsigned v = k == 0 ? c->number : next_of(c->number, l->sides);
        at[1 + k] = loft_sci_from_int(loft_lattice_polygon_height(l, edge, l->edge[v].from));
    }
}

static bool sum_toric(const loft_sector *c, const part *p, loft_jet_ball_sum *sum)
{
    loft_jet_ball h[LOFT_SIDES_MAX];

    for (unsigned i = 0; i < c->disk->sides; i++) {
        loft_sci at[3];
        toric_heights(c, i, at);
        h[i] = ball_between(p, at);
    }
    return loft_toric_ball((const loft_toric *)c->disk->patch, h, sum);
}

static bool sum_basepoint(const loft_sector *c, const part *p, loft_jet_ball_sum *sum)
{
    const loft_sci one = loft_sci_one(), none = loft_sci_zero(),
                   share = loft_sci_from_unit(LOFT_UNIT(CORNER_SHARE));
    loft_jet_ball factor[4];

    factor[3] = linear_ball(p, none, none, share);
    factor[c->number] = linear_ball(p, one, none, loft_sci_neg(share));
    factor[next_of(c->number, 3)] = linear_ball(p, one, loft_sci_neg(one), none);
    factor[(c->number + 2u) % 3] = linear_ball(p, none, one, none);
    return loft_basepoint_ball((const loft_basepoint *)c->disk->patch, c->number, factor, sum);
}

static bool sum_ring(const loft_sector *c, const part *p, loft_jet_ball_sum *sum)
{
    const unsigned n = c->disk->sides;
    const loft_sci none = loft_sci_zero(),
                   share = n == 3 ? loft_sci_one() : loft_sci_from_unit(RING_SHARE(n));
    const loft_jet_ball a = linear_ball(p, none, share, none),
                        b = linear_ball(p, none, none, share);
    loft_jet_ball turned[LOFT_ZHENG_BALL_SIDES], u[LOFT_ZHENG_BALL_SIDES];

    if (!loft_zheng_ball_params_ball(n, &a, &b, turned))
        return false;
    for (unsigned i = 0; i < n; i++)
        u[(first_side(c) + i) % n] = turned[i];
    loft_zheng_ball_range((const loft_zheng_ball *)c->disk->patch, u, sum);
    return true;
}

static bool sum_of(const loft_sector *c, const part *p, loft_jet_ball_sum *sum)
{
    switch (c->disk->of) {
    case LOFT_DISK_OF_TORIC:     return sum_toric(c, p, sum);
    case LOFT_DISK_OF_BASEPOINT: return sum_basepoint(c, p, sum);
    case LOFT_DISK_OF_ZHENG_BALL: return sum_ring(c, p, sum);
    default:                     return sum_polygon(c, p, sum);
    }
}


/* Sheets */

/* The length of a vector of which no component is larger than that of the derivatives. */
static loft_sci length_of(const loft_jet size[3], unsigned a, unsigned b)
{
    loft_sci sum = loft_sci_zero();

    for (int k = 0; k < 3; k++) {
        const loft_sci x = a + b == 0   ? size[k].f
                           : a + b == 1 ? (a ? size[k].x : size[k].y)
                           : a == 2     ? size[k].xx
                           : a == 1     ? size[k].xy
                                        : size[k].yy;
        sum = loft_sci_add(sum, loft_sci_mul(x, x));
    }
    return loft_sci_sqrt(sum);
}

/* How far rounding may move a place of the sector, in its parameters: in the polygon by 2 ulp along
 * x and y, times the sides of the sector over its area. */
static loft_sci moved_of(const loft_sector *c)
{
    const loft_sci rounded = loft_sci_from_unit(ROUNDED);
    loft_acc most = 0, reach = 0;

    if (!is_triangular(c) || is_ring(c))
        return rounded;
    const loft_spot m = spot_of_sector(c, 0), a = spot_of_sector(c, 1), b = spot_of_sector(c, 2);
    for (int i = 0; i < 2; i++)
        for (unsigned k = 0; k < c->disk->sides; k++) {
            const loft_acc x = loft_to_acc(vertex_of(c, k).at[i]);
            most = loft_acc_max(most, loft_acc_abs(x));
            reach = loft_acc_max(reach, loft_acc_abs(x - loft_to_acc(m.at[i])));
        }
    const loft_sci moved = loft_sci_mul(
        loft_sci_from_int(16), loft_sci_mul(loft_sci_of(loft_real_ulp(most)), loft_sci_of(reach)));
    return loft_sci_add(rounded, loft_sci_div(moved, loft_sci_cross(m.at, a.at, m.at, b.at)));
}

/* Bounds over a part: of the sum of second derivatives (sheet.c), of first derivatives; what the
 * middles of its pieces alone would give. */
typedef struct {
    loft_sci bend, turn, least;
} bounds;

static loft_sci second_of(const loft_jet size[3], const loft_jet *wide, bool triangle)
{
    const loft_sci fine = loft_sci_power2(-36);
    loft_sci sum = loft_sci_add(length_of(size, 2, 0), length_of(size, 0, 2));

    sum = loft_sci_add(sum, loft_sci_mul(fine, loft_sci_add(wide->xx, wide->yy)));
    if (!triangle)
        return sum;
    const loft_sci mixed = loft_sci_add(length_of(size, 1, 1), loft_sci_mul(fine, wide->xy));
    return loft_sci_add(sum, loft_sci_add(mixed, mixed));
}

/* Take the bounds over a piece; false, where they are more than three times what its middle gives
 * and quarters may do better. */
static bool take_bounds(const loft_jet_ball_sum *sum, const part *p, bool last, bounds *b)
{
    loft_jet all[3], middle[3];

    for (int k = 0; k < 3; k++) {
        const loft_jet_ball alone = { sum->x[k].mid, loft_jet_of(loft_sci_zero()) };
        all[k] = loft_jet_ball_most(&sum->x[k]);
        middle[k] = loft_jet_ball_most(&alone);
    }
    const loft_sci bend = second_of(all, &sum->wide, p->corners == 3),
                   least = second_of(middle, &sum->wide, p->corners == 3);
    b->least = loft_sci_larger(b->least, least);
    if (!last && loft_sci_less(loft_sci_mul(loft_sci_from_int(3), b->least), bend))
        return false;
    b->bend = loft_sci_larger(b->bend, bend);
    b->turn = loft_sci_larger(b->turn, loft_sci_add(length_of(all, 1, 0), length_of(all, 0, 1)));
    return true;
}

/* Bound a part, piece by piece. */
static bool find_bounds(const loft_sector *c, const loft_sheet_piece *whole, bounds *b)
{
    const loft_sci none = loft_sci_zero();
    loft_sheet_piece stack[3 * FINER + 1];
    unsigned count = 1;
    loft_jet_ball_sum sum;

    b->bend = b->turn = b->least = none;
    stack[0] = *whole;
    while (count > 0) {
        const loft_sheet_piece now = stack[--count];
        const bool last = now.level >= whole->level + FINER;
        part p;
        make_part(c, &now, &p);
        const bool known = sum_of(c, &p, &sum);
        if (known && take_bounds(&sum, &p, last, b))
            continue;
        if (last)
            return false;
        for (unsigned k = 0; k < 4; k++)
            stack[count++] = loft_sheet_piece_quarter(&now, is_triangular(c), k);
    }
    return true;
}

/* The range of the corners. */
static enum loft_status find_box(const loft_sector *c, const part *p, loft_box *out)
{
    const uint32_t n = (uint32_t)1 << p->level;
    loft_vec at;

    for (unsigned k = 0; k < p->corners; k++) {
        const enum loft_status status = sector_at(c, loft_unit_of(p->at[k][0], n),
                                                  loft_unit_of(p->at[k][1], n), &at);
        if (status != LOFT_OK)
            return status;
        if (k == 0)
            out->min = out->max = at;
        *out = loft_box_join(*out, at);
    }
    return LOFT_OK;
}

/* At least the error of a point, in ulp of double: 2^9 of a generalized Bezier patch, less of an
 * S-patch and with base points; 2^12 of a Zheng-Ball patch; N + 2^7 H of a toric one. */
static int32_t ulps_of(const loft_sector *c)
{
    return is_ring(c) || c->disk->of == LOFT_DISK_OF_TORIC ? 8192 : 512;
}

/* The box around the surface, and how far its points err: by `moved`, rounding and ulps_of. */
static enum loft_status finish_sheet(loft_sheet *s, const loft_sector *c, loft_acc moved)
{
    const loft_real beyond = loft_acc_round(s->bend + loft_real_ulp(s->bend));
    loft_real most = 0;

    if (!(s->bend < loft_to_acc(LOFT_REAL(LOFT_SHEET_REACH))) ||
        !loft_vec_within(s->box.min, LOFT_REAL(LOFT_SHEET_REACH)) ||
        !loft_vec_within(s->box.max, LOFT_REAL(LOFT_SHEET_REACH)))
        return LOFT_ERR_RANGE;
    for (int k = 0; k < LOFT_AXES; k++) {
        s->box.min.axis[k] -= beyond;
        s->box.max.axis[k] += beyond;
        const loft_real x = loft_real_abs(s->box.min.axis[k]),
                        y = loft_real_abs(s->box.max.axis[k]);
        most = x > most ? x : most;
        most = y > most ? y : most;
    }
    s->fuzz = moved + 4 * loft_real_ulp(loft_to_acc(most)) +
              ulps_of(c) * loft_acc_ulp(loft_to_acc(most));
    return LOFT_OK;
}

/* The bend of a part and how far its points move; at the last level the range of its points. */
static enum loft_status find_bend(const loft_sector *c, const loft_sheet_piece *whole,
                                  const part *p, loft_acc *bend, loft_acc *moved)
{
    loft_jet size[3];
    loft_jet_ball_sum sum;
    bounds b;

    *moved = 0;
    if (!p->points) {
        if (!find_bounds(c, whole, &b))
            return LOFT_SINGULAR;
        b.bend = loft_sci_mul(b.bend, loft_sci_power2(-3 - 2 * (int)p->level));
        if (!loft_sci_to_acc(loft_sci_mul(b.turn, moved_of(c)), moved))
            return LOFT_SINGULAR;
    } else {
        if (!sum_of(c, p, &sum))
            return LOFT_SINGULAR;
        for (int k = 0; k < 3; k++)
            size[k] = sum.x[k].off;
        b.bend = loft_sci_mul(loft_sci_from_int(2), length_of(size, 0, 0));
    }
    if (loft_sci_less(loft_sci_from_int(LOFT_SHEET_REACH), b.bend) ||
        !loft_sci_to_acc(b.bend, bend))
        return LOFT_SINGULAR;
    *bend += loft_acc_ratio(*bend, 1048576) + loft_acc_ulp(*bend);
    return LOFT_OK;
}

enum loft_status loft_sheet_from_sector(loft_sheet *s, const loft_sector *c, loft_sheet_piece whole)
{
    const uint32_t n = (uint32_t)1 << (whole.level <= LOFT_DROP_LEVELS ? whole.level : 0),
                   right = (uint32_t)whole.i + whole.j + (whole.upper ? 1 : 0);
    loft_acc moved;
    loft_sheet made;
    part p;

    if (LOFT_AXES < 3 || whole.level > LOFT_DROP_LEVELS ||
        c->number >= loft_sector_count(c->disk) || whole.i >= n || whole.j >= n ||
        (is_triangular(c) ? right >= n : whole.upper))
        return LOFT_ERR_ARG;
    make_part(c, &whole, &p);
    p.points = whole.level == LOFT_DROP_LEVELS;
    enum loft_status status = find_bend(c, &whole, &p, &made.bend, &moved);
    if (status == LOFT_OK)
        status = find_box(c, &p, &made.box);
    if (status != LOFT_OK)
        return status;
    made.surface = loft_surface_from_sector(c);
    made.part = whole;
    made.measured = 0;
    made.plane = false;
    made.trim = NULL;
    status = finish_sheet(&made, c, moved);
    if (status == LOFT_OK)
        *s = made;
    return status;
}
