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
 */
#include "polygon/disk.h"
#include "polygon/disk_part.h"
#include "polygon/meanvalue.h"      /* loft_meanvalue_jet */
#include "polygon/wachspress.h"     /* loft_wachspress_jet */

/* Over polygons */

static void phi_of_side(unsigned n, unsigned side, loft_unit share, loft_sci phi[])
{
    for (unsigned i = 0; i < n; i++)
        phi[i] = loft_sci_zero();
    phi[loft_disk_next(side, n)] = loft_sci_from_unit(share);
    phi[side] = loft_sci_sub(loft_sci_one(), loft_sci_from_unit(share));
}

/* A point on the way from the middle to a point between a and b. What rounding leaves of 0 in
 * floats, below 2^-56, loft_spot_valid may refuse: it becomes 0. */
static loft_spot spot_of(loft_spot middle, loft_spot a, loft_spot b, loft_unit share, loft_unit u)
{
    loft_spot p;

    for (int i = 0; i < 2; i++) {
        const loft_acc on = loft_acc_lerp(loft_to_acc(a.at[i]), loft_to_acc(b.at[i]), share);
        p.at[i] = loft_acc_round(loft_acc_lerp(loft_to_acc(middle.at[i]), on, u));
        if (p.at[i] < LOFT_REAL(0x1p-56) && p.at[i] > -LOFT_REAL(0x1p-56))
            p.at[i] = 0;
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
    model_vertex(r->sides, loft_disk_next(side, r->sides), b);
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
                       r->cut.vertex[part][loft_disk_next(corner, r->cut.sides[part])],
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

/* The coordinates with their derivatives by the point. */
static enum loft_status jets_at(const loft_disk *r, unsigned side, loft_unit share, loft_unit u,
                                loft_jet phi[])
{
    const loft_spot p = spot_in(r, side, share, u);

    return r->harmonic                                 ? loft_harmonic_jet(r->harmonic, p, phi)
           : r->coordinates == loft_wachspress_eval    ? loft_wachspress_jet(r->domain, p, phi)
           : r->coordinates == loft_meanvalue_eval     ? loft_meanvalue_jet(r->domain, p, phi)
                                                    : LOFT_ERR_ARG;
}

static enum loft_status spatch_at(const loft_disk *r, unsigned side, loft_unit share, loft_unit u,
                                  loft_vec *out, loft_differential *slopes)
{
    const loft_spatch *s = (const loft_spatch *)r->patch;
    loft_sci phi[LOFT_SIDES_MAX];
    loft_jet jet[LOFT_SIDES_MAX];
    const enum loft_status status = slopes ? jets_at(r, side, share, u, jet)
                                           : coordinates_at(r, side, share, u, phi);

    return status   ? status
           : slopes ? loft_spatch_differential(s, jet, slopes)
                    : loft_spatch_eval(s, phi, out);
}

static enum loft_status gb_at(const loft_disk *r, unsigned side, loft_unit share, loft_unit u,
                              loft_vec *out, loft_differential *slopes)
{
    const loft_gb *g = (const loft_gb *)r->patch;
    loft_sci phi[LOFT_SIDES_MAX];
    loft_jet jet[LOFT_SIDES_MAX];
    const enum loft_status status = slopes ? jets_at(r, side, share, u, jet)
                                           : coordinates_at(r, side, share, u, phi);

    return status   ? status
           : slopes ? loft_gb_differential(g, jet, slopes)
                    : loft_gb_eval(g, phi, out);
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
                                 loft_vec *out, loft_differential *slopes)
{
    const loft_toric *patch = (const loft_toric *)r->patch;
    const loft_spot a = corner_of(patch, side),
                    b = corner_of(patch, loft_disk_next(side, r->sides)),
                    middle = mean_of_corners(patch);
    if (slopes)
        return loft_toric_differential(patch, spot_of(middle, a, b, share, u), slopes);
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
    loft_disk_begin(r, t->lattice->sides, toric_at, LOFT_DISK_OF_TORIC, t);
}


/* The surface */

static enum loft_status place_at(const loft_disk *r, loft_unit u, loft_unit v, loft_vec *out,
                                 loft_differential *slopes)
{
    loft_unit share = (loft_unit)(r->sides * v);
    unsigned side = 0;

    if (!(u >= 0 && u <= LOFT_UNIT(1) && v >= 0 && v <= LOFT_UNIT(1)))
        return LOFT_ERR_ARG;
    for (; share >= LOFT_UNIT(1) && side + 1 < r->sides; side++)
        share -= LOFT_UNIT(1);
    return r->at(r, side, share, u, out, slopes);
}

static enum loft_status disk_at(const void *surface, loft_unit u, loft_unit v, loft_vec *out)
{
    return place_at((const loft_disk *)surface, u, v, out, NULL);
}

/* At a vertex there may be none, or very large ones beside it, and a rounded point of a side may
 * lie outside: the boundary takes those of a place inside. */
static enum loft_status disk_slopes(const void *surface, loft_unit u, loft_unit v,
                                    loft_differential *out)
{
    const loft_disk *r = (const loft_disk *)surface;
    const loft_unit least = LOFT_UNIT(0x1p-16), inside = LOFT_UNIT(1) - least;
    enum loft_status status = place_at(r, u > inside ? inside : u, v, NULL, out);

    for (loft_unit less = 2 * least;
         (status == LOFT_SINGULAR || status == LOFT_ERR_RANGE) && less < LOFT_UNIT(0x1p-7);
         less = 2 * less)
        if (u > less)
            status = place_at(r, u - less, v, NULL, out);
    return status;
}

loft_surface loft_surface_from_disk(const loft_disk *r)
{
    const loft_surface s = { disk_at, r, LOFT_SURFACE_DISK, disk_slopes };
    return s;
}
