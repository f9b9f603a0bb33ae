/* tests/lib/polygon/test_disk.c -- properties of lib/polygon/disk.h: patches with n sides as one
 * surface around their middle, and their contours
 * SPDX-License-Identifier: MIT
 */
#include "support/arb_polygon.h"    /* arb_winding */
#include "curve/rational.h"         /* loft_rational_eval */
#include "polygon/weighted_sum.h"   /* loft_weighted_sum_curve */
#include "support/sided.h"          /* arb_kind */
#include "surface/contour.h"

#define ROWS    16
#define COLUMNS 48              /* not always a multiple of the sides */

static uint8_t memory[LOFT_CONTOUR_BYTES(ROWS, COLUMNS)];

/* The surface is continuous: points at parameters 2^-20 apart are no further apart than the
 * steepest of these patches allows. v = 1 is v = 0, and u = 0 is one point. */
static void there_is_no_seam(arb *a)
{
    const scene *x = arb_kind(a, arb_below(a, KINDS), 5);
    const loft_unit u = arb_unit(a), step = LOFT_UNIT(0x1p-20),
                    half = loft_unit_of(1 + 2 * arb_below(a, x->sides), 2 * x->sides);
    const long double steep = 50.0L * 8 * 9 * 8 * 0x1p-19L + BY_NUM(4 * 0x1p-16L, 0x1p-12L, 1e-10L);
    const loft_unit v = arb_below(a, 2) ? half : loft_unit_of(arb_below(a, x->sides), x->sides);
    const loft_vec middle = point_at(x, 0, 0);
    loft_vec p, q;

    p = point_at(x, u, v);
    q = point_at(x, u, v + step);
    CHECK(apart(&p, &q) <= steep);
    if (v > step) {
        q = point_at(x, u, v - step);
        CHECK(apart(&p, &q) <= steep);
    }
    p = point_at(x, u, 0);
    q = point_at(x, u, LOFT_UNIT(1));
    CHECK(apart(&p, &q) <= 0);
    p = point_at(x, 0, v);
    CHECK(apart(&p, &middle) <= BY_NUM(2 * 0x1p-16L, 0x1p-14L, 1e-11L));
}

/* u = 1 follows the sides, side k from k / n on. */
static void the_border_is_the_sides(arb *a)
{
    const scene *x = arb_kind(a, arb_below(a, KINDS), 5);
    const unsigned side = arb_below(a, x->sides), along = arb_below(a, 65);
    const loft_unit share = loft_unit_of(along, 64);
    const long double within = BY_NUM(3 * 0x1p-16L, 0x1p-13L, 1e-11L) +
                               8 * 9 * 100 * BY_NUM(8 * 0x1p-24L, 8 * 0x1p-24L, 8 * 0x1p-53L);
    const loft_vec p = point_at(x, LOFT_UNIT(1), loft_unit_of(64 * side + along, 64 * x->sides));
    loft_weighted w[LOFT_DEGREE_MAX + 1];
    loft_sci phi[LOFT_SIDES_MAX];
    loft_rational r;
    loft_unit t;
    loft_vec on;

    for (unsigned i = 0; i < x->sides; i++)
        phi[i] = loft_sci_zero();
    phi[(side + 1) % x->sides] = loft_sci_from_unit(share);
    phi[side] = loft_sci_sub(loft_sci_one(), loft_sci_from_unit(share));
    if (x->kind < 2) {
        CHECK(loft_spatch_eval(&x->spatch, phi, &on) == LOFT_OK);
    } else if (x->kind < 4) {
        CHECK(loft_gb_eval(&x->gb, phi, &on) == LOFT_OK);
    } else if (x->kind == 4) {
        const loft_whole from = x->lattice.edge[side].from,
                         to = x->lattice.edge[(side + 1) % x->sides].from;
        loft_spot s;
        for (int i = 0; i < 2; i++)
            s.at[i] = LOFT_REAL(from.at[i] + (to.at[i] - from.at[i]) * (along / 64.0));
        CHECK(loft_toric_edge(&x->toric, side, w) == LOFT_OK);
        CHECK(loft_rational_init(&r, w, x->lattice.edge[side].length) == LOFT_OK);
        CHECK(loft_toric_parameter(&x->toric, side, s, &t) == LOFT_OK);
        on = loft_rational_eval(&r, t);
    } else if (x->kind == 5) {
        CHECK(along % 64 != 0 ||
              loft_basepoint_boundary(&x->basepoint, side, share, &on) == LOFT_OK);
        if (along % 64 != 0)
            return;                                     /* between the ends sides differ */
    } else {
        loft_vec edge[LOFT_DEGREE_MAX + 1];
        for (unsigned k = 0; k <= x->degree; k++) {
            uint8_t l[LOFT_ZHENG_BALL_SIDES];
            for (unsigned i = 0; i < loft_zheng_ball_count(x->sides, x->degree); i++) {
                loft_zheng_ball_index(x->sides, x->degree, i, l);
                if (l[side] == 0 && l[(side + x->sides - 1) % x->sides] == k)
                    edge[k] = x->p[i];
            }
        }
        const loft_sci both[2] = { loft_sci_sub(loft_sci_one(), loft_sci_from_unit(share)),
                                   loft_sci_from_unit(share) };
        CHECK(loft_weighted_sum_curve(edge, NULL, x->degree, both, &on) == LOFT_OK);
    }
    CHECK(apart(&p, &on) <= within);
}

/* A patch that is a dome over its polygon: seen from above, the cells of the grid are adjacent,
 * none is turned over, and they fill the polygon. */
static void the_sheet_covers_the_patch_once(arb *a)
{
    const scene *x = arb_kind(a, arb_below(a, KINDS), 0);
    const unsigned columns = 8 * x->sides;
    long double area = 0, whole = 0;

    for (unsigned j = 0; j < columns; j++) {
        const loft_unit v0 = loft_unit_of(j, columns), v1 = loft_unit_of(j + 1, columns);
        for (unsigned i = 0; i < ROWS; i++) {
            const loft_unit u0 = loft_unit_of(i, ROWS), u1 = loft_unit_of(i + 1, ROWS);
            const loft_vec c[4] = { point_at(x, u0, v0), point_at(x, u1, v0), point_at(x, u1, v1),
                                    point_at(x, u0, v1) };
            long double cell = 0;
            for (int k = 0; k < 4; k++)
                cell += (exact_of(c[k].axis[0]) * exact_of(c[(k + 1) % 4].axis[1]) -
                         exact_of(c[k].axis[1]) * exact_of(c[(k + 1) % 4].axis[0])) /
                        2;
            CHECK(cell > -1e-3L);
            area += cell;
        }
        const loft_vec p = point_at(x, LOFT_UNIT(1), v0), q = point_at(x, LOFT_UNIT(1), v1);
        whole += (exact_of(p.axis[0]) * exact_of(q.axis[1]) -
                  exact_of(p.axis[1]) * exact_of(q.axis[0])) /
                 2;
    }
    CHECK(whole > 1000 && fabsl(area - whole) < 0.05L);
}

static long double product_of(const loft_vec *n, const long double m[3])
{
    long double sum = 0, size = 0;

    for (int i = 0; i < 3; i++) {
        sum += exact_of(n->axis[i]) * m[i];
        size += m[i] * m[i];
    }
    return sum / sqrtl(size);
}

/* The derivatives give the normal that differences of points give, to the outside of a hill. On the
 * boundary and at vertices there is one too. */
static void normals_are_those_of_the_surface(arb *a)
{
    const scene *x = arb_kind(a, arb_below(a, KINDS), 2);
    const loft_surface s = loft_surface_from_disk(&x->round);
    const loft_unit h = LOFT_UNIT(0x1p-7), u = LOFT_UNIT(0.25) + arb_unit(a) / 2,
                    v = loft_unit_of(16 * arb_below(a, x->sides) + 2 + arb_below(a, 13),
                                     16 * x->sides);
    const loft_vec c[4] = { point_at(x, u - h, v), point_at(x, u + h, v), point_at(x, u, v - h),
                            point_at(x, u, v + h) };
    long double e[2][3], n[3];
    loft_differential d;
    loft_vec normal = { { 0 } };

    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 3; i++)
            e[k][i] = exact_of(c[2 * k + 1].axis[i]) - exact_of(c[2 * k].axis[i]);
    for (int i = 0; i < 3; i++)
        n[i] = e[0][(i + 1) % 3] * e[1][(i + 2) % 3] - e[0][(i + 2) % 3] * e[1][(i + 1) % 3];
    CHECK(s.differential(s.surface, u, v, &d) == LOFT_OK);
    CHECK(loft_differential_normal(&d, &normal) == LOFT_OK);
    CHECK(product_of(&normal, n) > 0.98L);
    CHECK(normal.axis[2] > 0);
    CHECK(s.differential(s.surface, LOFT_UNIT(1), v, &d) == LOFT_OK);
    CHECK(s.differential(s.surface, LOFT_UNIT(1), loft_unit_of(arb_below(a, x->sides), x->sides),
                         &d) == LOFT_OK);
    CHECK(s.differential(s.surface, 0, 0, &d) == LOFT_OK);
}

/* The height of the highest border point. */
static long double brim(const scene *x)
{
    long double most = -1e9L;

    for (unsigned j = 0; j < 8 * COLUMNS; j++) {
        const loft_vec p = point_at(x, LOFT_UNIT(1), loft_unit_of(j, 8 * COLUMNS));
        most = fmaxl(most, exact_of(p.axis[2]));
    }
    return most;
}

/* A contour below the top of a dome whose border is lower: one closed curve around the middle.
 * Every point of it is on the surface and within the tolerance, up to the step of the polygon's
 * points. */
static void waterlines_close_around_the_middle(arb *a)
{
    const loft_real tol = LOFT_REAL(0.005);
    const scene *x = arb_kind(a, arb_below(a, KINDS), 0);
    enum loft_contour_step step;
    loft_vec p, first = { { 0 } }, last = { { 0 } };
    unsigned starts = 0, points = 0;
    long double around = 0;
    loft_contour c;

    if (LOFT_AXES < 3)
        return;
    while (brim(x) + 2 > exact_of(point_at(x, 0, 0).axis[2]))   /* depth 1 may be plane */
        x = arb_kind(a, arb_below(a, KINDS), 0);
    const long double low = brim(x), top = exact_of(point_at(x, 0, 0).axis[2]);
    const loft_real height = LOFT_REAL(
        (double)(low + (top - low) * (0.2L + arb_below(a, 600) / 1000.0L)));
    CHECK(loft_contour_init(&c, loft_surface_from_disk(&x->round), 2, height, tol, ROWS, COLUMNS,
                            memory, sizeof memory) == LOFT_OK);
    while ((step = loft_contour_next(&c, &p)) != LOFT_CONTOUR_OVER) {
        const loft_vec on = point_at(x, c.u, c.v);
        CHECK(apart(&p, &on) <= 0);
        CHECK(fabsl(exact_of(p.axis[2]) - exact_of(height)) <=
              exact_of(tol) + BY_NUM(0.01L, 1e-3L, 1e-9L));
        starts += step == LOFT_CONTOUR_START;
        if (points++ > 0)
            around += atan2l(exact_of(last.axis[0]) * exact_of(p.axis[1]) -
                                 exact_of(last.axis[1]) * exact_of(p.axis[0]),
                             exact_of(last.axis[0]) * exact_of(p.axis[0]) +
                                 exact_of(last.axis[1]) * exact_of(p.axis[1]));
        else
            first = p;
        last = p;
    }
    CHECK(starts == 1 && points > COLUMNS && apart(&first, &last) <= 0);
    CHECK(fabsl(fabsl(around) - 2 * acosl(-1)) < 1e-3L);
}

/* A flat patch that is its own polygon. */
typedef struct {
    arb_domain p;
    loft_vec net[LOFT_SIDES_MAX];
    loft_spatch patch;
    loft_disk round;
} plain;

static void make_plain(plain *x)
{
    CHECK(loft_domain_init(&x->p.d, x->p.v, x->p.n) == LOFT_OK);
    for (unsigned i = 0; i < x->p.n; i++)
        for (int k = 0; k < LOFT_AXES; k++)
            x->net[i].axis[k] = k < 2 ? x->p.v[i].at[k] : 0;
    CHECK(loft_spatch_init(&x->patch, x->net, NULL, x->p.n, 1) == LOFT_OK);
    CHECK(loft_disk_from_spatch(&x->round, &x->patch, &x->p.d,
                                x->p.d.convex ? loft_wachspress_eval : loft_meanvalue_eval) ==
          LOFT_OK);
}

static const plain *arb_plain(arb *a)
{
    static plain x;

    x.p = arb_below(a, 3) ? arb_winding(a) : arb_simple(a);
    make_plain(&x);
    return &x;
}

/* The length of the line inside the polygon, where axis `axis` is `at`, and the number of its
 * pieces; 0 when it passes too close to a vertex. */
static unsigned pieces_of(const arb_domain *p, int axis, long double at, long double size,
                          long double *length)
{
    long double cross[LOFT_SIDES_MAX];
    unsigned count = 0;

    for (unsigned i = 0; i < p->n; i++) {
        const loft_spot *s = &p->v[i], *t = &p->v[(i + 1) % p->n];
        const long double from = exact_of(s->at[axis]) - at, to = exact_of(t->at[axis]) - at;
        if (fabsl(from) < size / 20)
            return 0;
        if ((from < 0) != (to < 0)) {
            unsigned k = count++;
            const long double x = exact_of(s->at[1 - axis]) +
                                  (exact_of(t->at[1 - axis]) - exact_of(s->at[1 - axis])) * from /
                                      (from - to);
            for (; k > 0 && cross[k - 1] > x; k--)
                cross[k] = cross[k - 1];
            cross[k] = x;
        }
    }
    *length = 0;
    for (unsigned k = 0; k + 1 < count; k += 2) {
        if (cross[k + 1] - cross[k] < size / 20)
            return 0;
        *length += cross[k + 1] - cross[k];
    }
    return count / 2;
}

/* A contour of x or y is the straight line through the polygon. Each of its pieces is followed once
 * and forward, so the surface covers every point of the polygon once. */
static void lines_through_any_polygon_are_whole(arb *a)
{
    const plain *x = arb_plain(a);
    const int axis = (int)arb_below(a, 2);
    static uint8_t bits[LOFT_CONTOUR_BYTES(64, 96)];
    long double size = 0, want, length = 0, forward = 0;
    enum loft_contour_step step;
    loft_vec q, last = { { 0 } };
    unsigned starts = 0;
    loft_contour c;

    for (unsigned i = 0; i < x->p.n; i++)
        size = fmaxl(size, fabsl(exact_of(x->p.v[i].at[axis])));
    const long double at = size * (arb_below(a, 2000) / 1000.0L - 1);
    const loft_real height = LOFT_REAL((double)at);
    const unsigned pieces = pieces_of(&x->p, axis, exact_of(height), size, &want);
    if (pieces == 0 || size < BY_NUM(10.0L, 0, 0))
        return;
    CHECK(loft_contour_init(&c, loft_surface_from_disk(&x->round), (unsigned)axis, height, 0, 64,
                            12 * x->p.n, bits, sizeof bits) == LOFT_OK);
    while ((step = loft_contour_next(&c, &q)) != LOFT_CONTOUR_OVER) {
        const long double along = exact_of(q.axis[1 - axis]) - exact_of(last.axis[1 - axis]);
        starts += step == LOFT_CONTOUR_START;
        if (step != LOFT_CONTOUR_START) {
            length += fabsl(along);
            forward += along;
        }
        last = q;
    }
    CHECK(starts == pieces);
    CHECK(fabsl(length - want) < size * BY_NUM(0x1p-8L, 0x1p-12L, 0x1p-40L));
    CHECK(fabsl(fabsl(forward) - want) < size * BY_NUM(0x1p-8L, 0x1p-12L, 0x1p-40L));
}

/* Neighbours on the surface are neighbours in the polygon, on both sides of every diagonal, and
 * none is outside. */
static void no_polygon_makes_the_sheet_jump(arb *a)
{
    const plain *x = arb_plain(a);
    const loft_surface s = loft_surface_from_disk(&x->round);
    const loft_unit u = arb_unit(a), v = arb_unit(a), step = LOFT_UNIT(0x1p-16);
    long double size = 0;
    loft_vec p, q;

    for (unsigned i = 0; i < x->p.n; i++)
        for (int k = 0; k < 2; k++)
            size = fmaxl(size, fabsl(exact_of(x->p.v[i].at[k])));
    if (u < step || v < step)
        return;
    CHECK(s.eval(s.surface, u, v, &p) == LOFT_OK);
    for (int k = 0; k < 2; k++) {
        CHECK(s.eval(s.surface, k ? u - step : u, k ? v : v - step, &q) == LOFT_OK);
        CHECK(apart(&p, &q) <= size * 0x1p-9L + BY_NUM(4 * 0x1p-16L, 0, 0));
    }
}

/* Two thin arms, or one strip, so thin that rounding moves points in them outside: the surface is
 * that of the same polygon made larger, up to the rounding. */
static void slivers_are_as_large_ones(arb *a)
{
    const int32_t width = 2 + (int32_t)arb_below(a, 40), times = 4096 >> arb_below(a, 3);
    const int32_t v[2][4][2] = {
        { { 0, 0 }, { 3000, -1000 }, { width, 0 }, { 3000, 1000 } },
        { { 0, 0 }, { 1500, -501 }, { 3000, -1000 }, { 1500, width - 500 } }
    };
    const unsigned start = arb_below(a, 4), strip = arb_below(a, 2);
    static plain x, y;
    loft_vec p, q;

    x.p.n = y.p.n = 4;
    for (unsigned i = 0; i < 4; i++) {
        const int32_t *at = v[strip][(i + start) % 4];
        x.p.v[i] = spot_raw(at[0], at[1]);
        y.p.v[i] = spot_raw(at[0] * times, at[1] * times);
    }
    make_plain(&x);
    make_plain(&y);
    const loft_surface small = loft_surface_from_disk(&x.round),
                       large = loft_surface_from_disk(&y.round);
    const loft_unit u = arb_unit(a), w = arb_unit(a);
    CHECK(small.eval(small.surface, u, w, &p) == LOFT_OK &&
          large.eval(large.surface, u, w, &q) == LOFT_OK);
    for (int k = 0; k < 2; k++)
        CHECK(fabsl(exact_of(p.axis[k]) - exact_of(q.axis[k]) / times) <=
              BY_NUM(3 * 0x1p-16L, 1e-8L, 1e-15L));
}

static loft_acc acc_of(long double x)
{
    return BY_NUM((loft_acc)llroundl(x * 4294967296.0L), (loft_acc)x, (loft_acc)x);
}

/* Over a triangle harmonic coordinates are the barycentric ones, as Wachspress's are: 1/3 + 2/3 of
 * the cosine between p and the vertex, the series 1, Re t, Im t. */
static void harmonic_coordinates_can_be_taken(arb *a)
{
    scene *x = arb_kind(a, 0, 5);
    loft_acc coefficient[9];
    loft_disk r;
    loft_harmonic h;

    while (x->sides != 3)
        x = arb_kind(a, 0, 5);
    for (unsigned i = 0; i < 3; i++) {
        long double v[2];
        vertex_of(3, i, 2 / 3.0L, v);
        coefficient[i] = acc_of(1 / 3.0L);
        coefficient[3 + i] = acc_of(v[0]);
        coefficient[6 + i] = acc_of(v[1]);
    }
    const loft_harmonic_table table = {
        .coefficient = coefficient, .terms = 3, .sides = 3, .degree = 1
    };
    CHECK(loft_harmonic_init(&h, &x->domain, &table) == LOFT_OK);
    const loft_unit u = arb_unit(a), v = arb_unit(a);
    const loft_vec want = point_at(x, u, v);
    CHECK(loft_disk_from_spatch(&r, &x->spatch, &x->domain, NULL) == LOFT_OK);
    loft_surface s = loft_surface_from_disk(&r);
    loft_vec p;
    CHECK(u >= LOFT_UNIT(1) || s.eval(s.surface, u, v, &p) == LOFT_ERR_ARG);
    CHECK(loft_disk_harmonic(&r, &h) == LOFT_OK);
    CHECK(s.eval(s.surface, u, v, &p) == LOFT_OK);
    CHECK(apart(&p, &want) <= BY_NUM(1e-2L, 1e-3L, 1e-3L));
    loft_disk_from_basepoint(&r, &x->basepoint);
    CHECK(loft_disk_harmonic(&r, &h) == LOFT_ERR_ARG);
}

static void what_does_not_fit_is_refused(arb *a)
{
    scene *x = arb_kind(a, arb_below(a, 4), 0);
    const loft_surface s = loft_surface_from_disk(&x->round);
    loft_disk r;
    loft_vec p;

    x->domain.sides--;
    if (x->kind < 2)
        CHECK(loft_disk_from_spatch(&r, &x->spatch, &x->domain, loft_wachspress_eval) ==
              LOFT_ERR_ARG);
    else
        CHECK(loft_disk_from_gb(&r, &x->gb, &x->domain, loft_wachspress_eval) == LOFT_ERR_ARG);
    x->domain.sides++;
    CHECK(s.eval(s.surface, LOFT_UNIT(-0.25), 0, &p) == LOFT_ERR_ARG);
    CHECK(s.eval(s.surface, 0, LOFT_UNIT(1.25), &p) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(there_is_no_seam, 150);
    PROPERTY(the_border_is_the_sides, 150);
    PROPERTY(the_sheet_covers_the_patch_once, 15);
    PROPERTY(normals_are_those_of_the_surface, 200);
    PROPERTY(waterlines_close_around_the_middle, 15);
    PROPERTY(lines_through_any_polygon_are_whole, 60);
    PROPERTY(no_polygon_makes_the_sheet_jump, 400);
    PROPERTY(slivers_are_as_large_ones, 400);
    PROPERTY(harmonic_coordinates_can_be_taken, 60);
    PROPERTY(what_does_not_fit_is_refused, 20);
    return check_failures();
}
