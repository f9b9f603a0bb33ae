/* lib/polygon/disk.c
 * SPDX-License-Identifier: MIT
 *
 * In a convex polygon the path from the middle to the point of the side is straight. Any other
 * polygon is replaced by a convex one with as many sides, the model, in which the paths are
 * straight too. The same diagonals divide both into convex pieces; diagonals of a convex polygon
 * never cross. In each piece, the triangles between the mean of the vertices and two successive
 * vertices are mapped linearly from the model to the polygon. On a side of a triangle the map
 * depends only on its ends. So the triangles fit together, none is turned over, and together they
 * cover the polygon once. A convex polygon is one piece, and its map keeps the shares in each
 * triangle, so the paths are straight again.
 *
 * Other patches are divided into kites, one for each corner k. s runs along side k and t along side
 * k - 1, each from 0 to 1 at the middle of the side. s = t = 1 is the middle of the patch. In a
 * kite the path is straight. Kites meet where two parameters are equal.
 */
#include "polygon/disk.h"

static unsigned next_side(unsigned i, unsigned n) { return i + 1 < n ? i + 1 : 0; }

static loft_unit one_minus(loft_unit t) { return LOFT_UNIT(1) - t; }

static loft_unit unit_product(loft_unit a, loft_unit b)
{
    return loft_unit_round(loft_acc_scale(loft_unit_to_acc(a), b));
}


/* Over polygons */

static void phi_of_side(unsigned n, unsigned side, loft_unit share, loft_sci phi[])
{
    for (unsigned i = 0; i < n; i++)
        phi[i] = loft_sci_zero();
    phi[next_side(side, n)] = loft_sci_from_unit(share);
    phi[side] = loft_sci_sub(loft_sci_one(), loft_sci_from_unit(share));
}

/* A point on the way from the middle to a point between a and b. */
static loft_spot spot_of(loft_spot middle, loft_spot a, loft_spot b, loft_unit share, loft_unit u)
{
    loft_spot p;

    for (int i = 0; i < 2; i++) {
        const loft_acc on = loft_acc_lerp(loft_to_acc(a.at[i]), loft_to_acc(b.at[i]), share);
        p.at[i] = loft_acc_round(loft_acc_lerp(loft_to_acc(middle.at[i]), on, u));
    }
    return p;
}

/* The model: a convex octagon of whole numbers, or a subset of its vertices. */
static void model_vertex(unsigned sides, unsigned i, int32_t out[2])
{
    static const int8_t octagon[8][2] = { { 1, 0 }, { 2, 0 }, { 3, 1 }, { 3, 2 },
                                          { 2, 3 }, { 1, 3 }, { 0, 2 }, { 0, 1 } };
    const int8_t *v = octagon[8 * i / sides];

    out[0] = v[0];
    out[1] = v[1];
}

/* The sum of the vertices of a piece of the model: their mean times their number. */
static void model_sum(const loft_disk *r, unsigned part, int32_t out[2])
{
    int32_t v[2];

    out[0] = out[1] = 0;
    for (unsigned k = 0; k < r->cut.sides[part]; k++) {
        model_vertex(r->sides, r->cut.vertex[part][k], v);
        out[0] += v[0];
        out[1] += v[1];
    }
}

/* A point of the model, times the number of sides of the first piece. */
static void model_point(const loft_disk *r, unsigned side, loft_unit share, loft_unit u,
                        loft_acc out[2])
{
    const loft_acc one = loft_unit_to_acc(LOFT_UNIT(1));
    const int32_t times = r->cut.sides[0];
    int32_t a[2], b[2], sum[2];

    model_vertex(r->sides, side, a);
    model_vertex(r->sides, next_side(side, r->sides), b);
    model_sum(r, 0, sum);
    for (int i = 0; i < 2; i++) {
        const loft_acc on = times * (a[i] * one + (b[i] - a[i]) * loft_unit_to_acc(share));
        out[i] = loft_acc_lerp(sum[i] * one, on, u);
    }
}

/* A triangle of a piece, and the barycentric coordinates of a point in it with any common factor:
 * of the middle, of vertex a, of vertex b. */
typedef struct {
    unsigned part, a, b;
    loft_acc of[3];
} fan_triangle;

static loft_acc acc_cross(int32_t x, int32_t y, const loft_acc p[2]) { return x * p[1] - y * p[0]; }

/* With the middle m = M / k, and the point q times n:
 *
 *     of m: k (b - a) x (n q - n a)
 *     of a: (M - k b) x (n q - n b)
 *     of b: (k a - M) x (n q - n a) */
static fan_triangle triangle_of(const loft_disk *r, unsigned part, unsigned corner,
                                const loft_acc q[2])
{
    const int32_t k = r->cut.sides[part], n = r->cut.sides[0];
    const loft_acc one = loft_unit_to_acc(LOFT_UNIT(1));
    fan_triangle t = { part,
                       r->cut.vertex[part][corner],
                       r->cut.vertex[part][next_side(corner, r->cut.sides[part])],
                       { 0, 0, 0 } };
    int32_t a[2], b[2], m[2];
    loft_acc from_a[2], from_b[2];

    model_vertex(r->sides, t.a, a);
    model_vertex(r->sides, t.b, b);
    model_sum(r, part, m);
    for (int i = 0; i < 2; i++) {
        from_a[i] = q[i] - n * a[i] * one;
        from_b[i] = q[i] - n * b[i] * one;
    }
    t.of[0] = acc_cross(k * (b[0] - a[0]), k * (b[1] - a[1]), from_a);
    t.of[1] = acc_cross(m[0] - k * b[0], m[1] - k * b[1], from_b);
    t.of[2] = acc_cross(k * a[0] - m[0], k * a[1] - m[1], from_a);
    return t;
}

static loft_acc least_share(const fan_triangle *t)
{
    return loft_acc_min(t->of[0], loft_acc_min(t->of[1], t->of[2]));
}

/* The triangle that contains q; on a border between two, either of them. */
static fan_triangle triangle_around(const loft_disk *r, const loft_acc q[2])
{
    fan_triangle best = triangle_of(r, 0, 0, q);

    for (unsigned part = 0; part < r->cut.count; part++)
        for (unsigned corner = 0; corner < r->cut.sides[part]; corner++) {
            const fan_triangle t = triangle_of(r, part, corner, q);
            if (least_share(&t) > least_share(&best))
                best = t;
        }
    for (int i = 0; i < 3; i++)
        best.of[i] = loft_acc_max(best.of[i], 0);
    return best;
}

static loft_spot mean_of(const loft_spot v[], const uint8_t vertex[], unsigned n)
{
    loft_spot m;

    for (int i = 0; i < 2; i++) {
        loft_acc sum = 0;
        for (unsigned k = 0; k < n; k++)
            sum += loft_to_acc(v[vertex[k]].at[i]);
        m.at[i] = loft_acc_round(loft_acc_ratio(sum, (int32_t)n));
    }
    return m;
}

static loft_spot spot_in(const loft_disk *r, unsigned side, loft_unit share, loft_unit u)
{
    loft_acc q[2];

    model_point(r, side, share, u, q);
    const fan_triangle t = triangle_around(r, q);
    const loft_spot *v = r->domain->v,
                    middle = mean_of(v, r->cut.vertex[t.part], r->cut.sides[t.part]);
    const loft_acc both = t.of[1] + t.of[2];
    const loft_unit along = both > 0 ? loft_unit_ratio(t.of[2], both) : 0;
    return spot_of(middle, v[t.a], v[t.b], along, loft_unit_ratio(both, both + t.of[0]));
}

/* Near the boundary a point may be rounded to one outside. Then the nearest one is taken. */
static enum loft_status coordinates_at(const loft_disk *r, unsigned side, loft_unit share,
                                       loft_unit u, loft_sci phi[])
{
    enum loft_status status;

    if (!(u < LOFT_UNIT(1))) {
        phi_of_side(r->sides, side, share, phi);
        return LOFT_OK;
    }
    if (!r->coordinates && !r->harmonic)
        return LOFT_ERR_ARG;
    const loft_spot p = spot_in(r, side, share, u);
    status = r->harmonic ? loft_harmonic_eval(r->harmonic, p, phi)
                         : r->coordinates(r->domain, p, phi);
    if (status == LOFT_ERR_RANGE) {
        loft_domain_nearest(r->domain, p, phi);
        status = LOFT_OK;
    }
    return status;
}

static enum loft_status spatch_at(const loft_disk *r, unsigned side, loft_unit share, loft_unit u,
                                  loft_vec *out)
{
    loft_sci phi[LOFT_SIDES_MAX];
    const enum loft_status status = coordinates_at(r, side, share, u, phi);

    return status ? status : loft_spatch_eval((const loft_spatch *)r->patch, phi, out);
}

static enum loft_status gb_at(const loft_disk *r, unsigned side, loft_unit share, loft_unit u,
                              loft_vec *out)
{
    loft_sci phi[LOFT_SIDES_MAX];
    const enum loft_status status = coordinates_at(r, side, share, u, phi);

    return status ? status : loft_gb_eval((const loft_gb *)r->patch, phi, out);
}

static loft_spot corner_of(const loft_toric *t, unsigned k)
{
    loft_spot s;

    for (int i = 0; i < 2; i++)
        s.at[i] = loft_real_from_int(t->lattice->edge[k].from.at[i]);
    return s;
}

static loft_spot mean_of_corners(const loft_toric *t)
{
    loft_spot m;

    for (int i = 0; i < 2; i++) {
        int32_t sum = 0;
        for (unsigned k = 0; k < t->lattice->sides; k++)
            sum += t->lattice->edge[k].from.at[i];
        m.at[i] = loft_acc_round(
            loft_acc_ratio(loft_to_acc(loft_real_from_int(sum)), t->lattice->sides));
    }
    return m;
}

/* A point that is rounded to one outside is moved toward the middle. */
static enum loft_status toric_at(const loft_disk *r, unsigned side, loft_unit share, loft_unit u,
                                 loft_vec *out)
{
    const loft_toric *patch = (const loft_toric *)r->patch;
    const loft_spot a = corner_of(patch, side), b = corner_of(patch, next_side(side, r->sides)),
                    middle = mean_of_corners(patch);
    enum loft_status status = loft_toric_eval(patch, spot_of(middle, a, b, share, u), out);

    for (loft_unit less = LOFT_UNIT(0x1p-22); status == LOFT_ERR_RANGE && less < LOFT_UNIT(0x1p-8);
         less = 2 * less)
        if (u > less)
            status = loft_toric_eval(patch, spot_of(middle, a, b, share, u - less), out);
    return status;
}

static enum loft_status init_over_polygon(loft_disk *r, const loft_domain *d,
                                          loft_coordinates *coordinates, unsigned sides)
{
    if (d->sides != sides)
        return LOFT_ERR_ARG;
    r->domain = d;
    r->coordinates = coordinates;
    r->harmonic = NULL;
    loft_partition_init(&r->cut, d);
    r->sides = (uint8_t)sides;
    return LOFT_OK;
}

static void init_without_polygon(loft_disk *r, unsigned sides)
{
    r->domain = NULL;
    r->coordinates = NULL;
    r->harmonic = NULL;
    r->cut.count = 0;
    r->sides = (uint8_t)sides;
}

enum loft_status loft_disk_harmonic(loft_disk *r, const loft_harmonic *h)
{
    if (!r->domain || h->domain != r->domain)
        return LOFT_ERR_ARG;
    r->harmonic = h;
    return LOFT_OK;
}

enum loft_status loft_disk_from_spatch(loft_disk *r, const loft_spatch *s, const loft_domain *d,
                                       loft_coordinates *coordinates)
{
    const enum loft_status status = init_over_polygon(r, d, coordinates, s->sides);

    if (status == LOFT_OK) {
        r->at = spatch_at;
        r->of = LOFT_DISK_OF_SPATCH;
        r->patch = s;
    }
    return status;
}

enum loft_status loft_disk_from_gb(loft_disk *r, const loft_gb *g, const loft_domain *d,
                                   loft_coordinates *coordinates)
{
    const enum loft_status status = init_over_polygon(r, d, coordinates, g->sides);

    if (status == LOFT_OK) {
        r->at = gb_at;
        r->of = LOFT_DISK_OF_GB;
        r->patch = g;
    }
    return status;
}

void loft_disk_from_toric(loft_disk *r, const loft_toric *t)
{
    init_without_polygon(r, t->lattice->sides);
    r->at = toric_at;
    r->of = LOFT_DISK_OF_TORIC;
    r->patch = t;
}


/* Kites */

typedef struct {
    unsigned corner;
    loft_unit s, t;
} kite;

/* The place at u on the path from the middle to `share` of a side. */
static kite kite_of(const loft_disk *r, unsigned side, loft_unit share, loft_unit u)
{
    const bool first = share <= LOFT_UNIT(0.5);
    /* 1 - s or 1 - t on the side */
    const loft_unit far = one_minus(2 * (first ? share : one_minus(share)));
    const loft_unit on = one_minus(unit_product(u, far)), off = one_minus(u);
    const kite k = { first ? side : next_side(side, r->sides), first ? on : off, first ? off : on };

    return k;
}

/* Three kinds of corners: a side of a cut corner of the triangle begins or ends there, or the
 * corner is not cut. v is 1 minus the share of the corner itself. w and 1 - w are the parts of v
 * that belong to the next and the last corner of the triangle. The kite ends at the lines where two
 * of the three shares are equal,
 *
 *     begins: w = s/2, v = t / (2 - w)      ends: w = 1 - t/2, v = s / (1 + w)
 *     not cut: shares s/2 (1 - t/2) and t/2 (1 - s/2), over 1 - s t / 4 */
static enum loft_status basepoint_at(const loft_disk *r, unsigned side, loft_unit share,
                                     loft_unit u, loft_vec *out)
{
    const kite k = kite_of(r, side, share, u);
    const loft_basepoint *b = (const loft_basepoint *)r->patch;
    const loft_basepoint_side here = loft_basepoint_side_of(b, k.corner);
    const loft_acc one = loft_unit_to_acc(LOFT_UNIT(1)), s = loft_unit_to_acc(k.s),
                   t = loft_unit_to_acc(k.t);
    loft_unit w = 0, v = 0;

    if (here.cut) {
        w = loft_unit_ratio(s, 2 * one);
        v = loft_unit_ratio(t, 2 * one - loft_unit_to_acc(w));
    } else if (b->cut[here.corner]) {
        w = one_minus(loft_unit_ratio(t, 2 * one));
        v = loft_unit_ratio(s, one + loft_unit_to_acc(w));
    } else {
        const loft_acc both = loft_unit_to_acc(unit_product(k.s, k.t)), next = 2 * s - both,
                       last = 2 * t - both;
        v = loft_unit_ratio(next + last, 4 * one - both);
        w = next + last > 0 ? loft_unit_ratio(next, next + last) : 0;
    }
    return loft_basepoint_corner(b, here.corner, one_minus(w), v, out);
}

void loft_disk_from_basepoint(loft_disk *r, const loft_basepoint *b)
{
    init_without_polygon(r, loft_basepoint_sides(b));
    r->at = basepoint_at;
    r->of = LOFT_DISK_OF_BASEPOINT;
    r->patch = b;
}

/* The parameter a that sides i - 1 and i + 1 have in common when side i has b:
 *
 *     5 sides   b a^2 - 2 a + 1 = 0,  a = 1 / (1 + sqrt(1 - b))
 *     6 sides   2 b a^3 - 4 a^2 + b a + 1 = 0, by Newton's method from 1/2 + 0.29 b, which
 *               is within 0.02 */
static loft_sci balanced_param(unsigned sides, loft_sci b)
{
    const loft_sci one = loft_sci_one(), two = loft_sci_from_int(2), four = loft_sci_from_int(4);
    loft_sci a;

    if (sides == 5)
        return loft_sci_div(one, loft_sci_add(one, loft_sci_sqrt(loft_sci_sub(one, b))));
    a = loft_sci_add(loft_sci_from_unit(LOFT_UNIT(0.5)),
                     loft_sci_mul(b, loft_sci_from_unit(LOFT_UNIT(0.29))));
    for (int step = 0; step < 4; step++) {
        const loft_sci ab = loft_sci_mul(a, b), aab = loft_sci_mul(a, ab), aa = loft_sci_mul(a, a);
        const loft_sci f = loft_sci_add(
            loft_sci_sub(loft_sci_mul(two, loft_sci_mul(a, aab)), loft_sci_mul(four, aa)),
            loft_sci_add(ab, one));
        const loft_sci d = loft_sci_add(loft_sci_sub(loft_sci_mul(loft_sci_from_int(6), aab),
                                                     loft_sci_mul(loft_sci_from_int(8), a)),
                                        b);
        a = loft_sci_sub(a, loft_sci_div(f, d));
    }
    return a;
}

/* s balanced_param(c t). c is the value of all parameters in the middle: (sqrt 5 - 1) / 2 or
 * sqrt(1/2). */
static loft_unit zheng_ball_param(unsigned sides, loft_unit s, loft_unit t)
{
    const loft_sci middle = loft_sci_from_unit(sides == 5 ? LOFT_UNIT(0.6180339887498949)
                                                          : LOFT_UNIT(0.7071067811865476));
    const loft_sci a = loft_sci_mul(
        loft_sci_from_unit(s), balanced_param(sides, loft_sci_mul(middle, loft_sci_from_unit(t))));
    loft_acc wide = 0;

    return loft_sci_to_acc(a, &wide) ? loft_unit_round(wide) : 0;
}

/* Three sides: u_i belongs to corner i + 2, opposite side i. */
static enum loft_status triple_at(const loft_disk *r, unsigned side, loft_unit share, loft_unit u,
                                  loft_vec *out)
{
    loft_unit of[3] = { 0, 0, 0 };
    loft_sci parameter[3];

    of[next_side(side, 3)] = share;
    of[side] = one_minus(share);
    for (int i = 0; i < 3; i++)
        of[i] = loft_unit_round(
            loft_acc_lerp(loft_unit_to_acc(loft_unit_of(1, 3)), loft_unit_to_acc(of[i]), u));
    if (of[0] + of[2] > LOFT_UNIT(1))
        of[0] = one_minus(of[2]);
    const enum loft_status status = loft_zheng_ball_lift(of[2], of[0], parameter);
    return status ? status
                  : loft_zheng_ball_eval((const loft_zheng_ball *)r->patch, parameter, out);
}

static enum loft_status zheng_ball_at(const loft_disk *r, unsigned side, loft_unit share,
                                      loft_unit u, loft_vec *out)
{
    const unsigned n = r->sides;
    const kite k = kite_of(r, side, share, u);
    loft_sci turned[LOFT_ZHENG_BALL_SIDES], parameter[LOFT_ZHENG_BALL_SIDES];
    const enum loft_status status = loft_zheng_ball_params(n, zheng_ball_param(n, k.s, k.t),
                                                           zheng_ball_param(n, k.t, k.s), turned);

    if (status != LOFT_OK)
        return status;
    for (unsigned i = 0; i < n; i++)
        parameter[(k.corner + n - 1 + i) % n] = turned[i];
    return loft_zheng_ball_eval((const loft_zheng_ball *)r->patch, parameter, out);
}

void loft_disk_from_zheng_ball(loft_disk *r, const loft_zheng_ball *g)
{
    init_without_polygon(r, g->sides);
    r->at = g->sides == 3 ? triple_at : zheng_ball_at;
    r->of = LOFT_DISK_OF_ZHENG_BALL;
    r->patch = g;
}


/* The surface */

static enum loft_status disk_at(const void *surface, loft_unit u, loft_unit v, loft_vec *out)
{
    const loft_disk *r = (const loft_disk *)surface;
    loft_unit share = (loft_unit)(r->sides * v);
    unsigned side = 0;

    if (!(u >= 0 && u <= LOFT_UNIT(1) && v >= 0 && v <= LOFT_UNIT(1)))
        return LOFT_ERR_ARG;
    for (; share >= LOFT_UNIT(1) && side + 1 < r->sides; side++)
        share -= LOFT_UNIT(1);
    return r->at(r, side, share, u, out);
}

loft_surface loft_surface_from_disk(const loft_disk *r)
{
    const loft_surface s = { disk_at, r, LOFT_SURFACE_DISK, NULL };
    return s;
}
