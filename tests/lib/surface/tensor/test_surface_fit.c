/* tests/lib/surface/tensor/test_surface_fit.c -- properties of lib/surface/tensor/surface_fit.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact.h"          /* exact_of; CHECK, PROPERTY */
#include "surface/tensor/nurbs_surface.h"
#include "surface/tensor/surface_fit.h"

#define ROWS    12
#define COLUMNS 15
#define MOST    8

static loft_vec points[ROWS * COLUMNS], net[MOST * MOST], found[MOST * MOST],
    middle[LOFT_SURFACE_FIT_POINTS(ROWS, MOST, MOST)];
static loft_sci memory[LOFT_FIT_MEMORY(MOST, 3)];
static loft_real u[ROWS], v[COLUMNS], ku[MOST + 4], kv[MOST + 4];

/* Knots 0 .. 0 1 2 .. n .. n for points of this degree, parameters that fill them evenly. */
static void spread(loft_real k[], unsigned count, unsigned degree, loft_real at[], unsigned places)
{
    const int32_t spans = (int32_t)(count - degree);

    for (unsigned i = 0; i < count + degree + 1; i++) {
        const int32_t x = (int32_t)i - (int32_t)degree;
        k[i] = loft_real_from_int(x < 0 ? 0 : x > spans ? spans : x);
    }
    for (unsigned i = 0; i < places; i++)
        at[i] = loft_lerp(0, loft_real_from_int(spans), loft_unit_of(i, places - 1));
}

static loft_fit_net arb_net(arb *a)
{
    const unsigned p = 1 + arb_below(a, 3), q = 1 + arb_below(a, 3),
                   m = p + 1 + arb_below(a, 7 - p), n = q + 1 + arb_below(a, 7 - q);
    const loft_fit_net out = { ku, kv, (uint16_t)m, (uint16_t)n, (uint8_t)p, (uint8_t)q };

    spread(ku, m, p, u, ROWS);
    spread(kv, n, q, v, COLUMNS);
    return out;
}

static const loft_fit_grid grid = { points, u, v, ROWS, COLUMNS };

/* Points of a surface on the same knots give it back, but for their rounding. */
static void a_surface_is_found_from_its_points(arb *a)
{
    const loft_fit_net f = arb_net(a);
    loft_nurbs_surface s;

    for (unsigned k = 0; k < f.points_u * (unsigned)f.points_v; k++)
        net[k] = arb_vec(a, 100);
    CHECK(loft_bspline_surface_init(&s, net, f.points_u, f.points_v, ku, f.degree_u, kv,
                                    f.degree_v) == LOFT_OK);
    for (unsigned i = 0; i < ROWS; i++)
        for (unsigned j = 0; j < COLUMNS; j++)
            CHECK(loft_nurbs_surface_eval(&s, u[i], v[j], &points[i * COLUMNS + j]) == LOFT_OK);
    CHECK(loft_surface_fit(&grid, &f, found, middle, memory) == LOFT_OK);
    for (unsigned k = 0; k < f.points_u * (unsigned)f.points_v; k++)
        for (int axis = 0; axis < LOFT_AXES; axis++)
            CHECK_NEAR(exact_of(found[k].axis[axis]), exact_of(net[k].axis[axis]),
                       BY_NUM(400 * LSB, 0x1p-9L, 0x1p-36L));
}

static long double squares(const loft_fit_net *f)
{
    long double sum = 0;
    loft_nurbs_surface s;

    CHECK(loft_bspline_surface_init(&s, found, f->points_u, f->points_v, ku, f->degree_u, kv,
                                    f->degree_v) == LOFT_OK);
    for (unsigned i = 0; i < ROWS; i++)
        for (unsigned j = 0; j < COLUMNS; j++) {
            loft_vec p;
            CHECK(loft_nurbs_surface_eval(&s, u[i], v[j], &p) == LOFT_OK);
            for (int axis = 0; axis < LOFT_AXES; axis++)
                sum += powl(exact_of(p.axis[axis]) - exact_of(points[i * COLUMNS + j].axis[axis]),
                            2);
        }
    return sum;
}

/* Of any points: an inner control point that is moved makes the sum of squares larger. */
static void no_inner_point_can_be_moved_to_gain(arb *a)
{
    const loft_fit_net f = arb_net(a);
    const loft_real by = LOFT_REAL(0.25);

    for (unsigned k = 0; k < ROWS * COLUMNS; k++)
        points[k] = arb_vec(a, 20);
    CHECK(loft_surface_fit(&grid, &f, found, middle, memory) == LOFT_OK);
    const long double least = squares(&f);
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        CHECK(loft_vec_equal(found[0], points[0]) &&
              loft_vec_equal(found[f.points_v - 1], points[COLUMNS - 1]));
        if (f.points_u < 3 || f.points_v < 3)
            continue;
        const unsigned i = 1 + arb_below(a, f.points_u - 2u), j = 1 + arb_below(a, f.points_v - 2u);
        loft_real *x = &found[i * f.points_v + j].axis[axis];
        const loft_real kept = *x;
        *x = kept + by;
        const long double above = squares(&f);
        *x = kept - by;
        CHECK(above > least && squares(&f) > least);
        /* a parabola whose vertex is at the fit */
        CHECK_NEAR(above, squares(&f), BY_NUM(0x1p-5L, 0x1p-8L, 0x1p-30L));
        *x = kept;
    }
}

static void what_cannot_be_told_is_refused(arb *a)
{
    loft_fit_net f = arb_net(a);

    for (unsigned k = 0; k < ROWS * COLUMNS; k++)
        points[k] = arb_vec(a, 20);
    spread(ku, 7, 1, u, ROWS);
    f.points_u = 7;
    f.degree_u = 1;
    for (unsigned i = 1; i + 1 < ROWS; i++)         /* none within the last spans */
        u[i] = LOFT_REAL(0.5);
    CHECK(loft_surface_fit(&grid, &f, found, middle, memory) == LOFT_SINGULAR);
    u[ROWS - 1] = LOFT_REAL(5);
    CHECK(loft_surface_fit(&grid, &f, found, middle, memory) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(a_surface_is_found_from_its_points, 60);
    PROPERTY(no_inner_point_can_be_moved_to_gain, 60);
    PROPERTY(what_cannot_be_told_is_refused, 10);
    return check_failures();
}
