/* host-tools/make/engine_simplex.c -- questions about lines, planes, triangles and tetrahedra of
 * numbers; compiled once per number type
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>

#include "surface/barycentric.h"                    /* loft_bary_from_point */
#include "surface/plane.h"                          /* loft_facet_equation */
#include "surface/sphere.h"                         /* loft_sphere_value */
#include "surface/tetra.h"                          /* loft_tetra_eval */
#include "surface/triangle/triangle.h"              /* loft_triangle_polar */
#include "surface/triangle/triangle_integral.h"     /* loft_triangle_integral */
#include "surface/triangle/triangle_operator.h"     /* loft_triangle_iterate */

#include "engine/surface.h"
#include "make/engine_patch.h"
#include "make/engine_pieces.h"                    /* numbers_of, print_vec */

#define NUMBERS (LOFT_TETRA_MAX + 16)

static int take(const decide_input *in, loft_real out[NUMBERS])
{
    return numbers_of(in, out, NUMBERS);
}

/* Points of two or three numbers each. */
static void points_of(const loft_real x[], unsigned count, int axes, loft_vec out[])
{
    for (unsigned k = 0; k < count; k++) {
        out[k] = (loft_vec){ { 0 } };
        for (int i = 0; i < axes; i++)
            out[k].axis[i] = x[k * (unsigned)axes + (unsigned)i];
    }
}

static void print_wide(const char *name, const loft_acc x[], unsigned count)
{
    printf("%s", name);
    for (unsigned k = 0; k < count; k++)
        printf(" %s", text_of(double_of_acc(x[k])));
    putchar('\n');
}

static void print_reals(const decide_input *in, const char *name, const loft_real x[],
                        unsigned count)
{
    printf("%s", name);
    for (unsigned k = 0; k < count; k++) {
        putchar(' ');
        print_number(in->e, double_of(x[k]));
    }
    putchar('\n');
}

/* A degree by its number of coefficients in so many variables more than one. */
static bool degree_of(size_t count, bool solid, unsigned *degree)
{
    for (*degree = 0; *degree <= LOFT_DEGREE_MAX; ++*degree)
        if (count == (solid ? LOFT_TETRA_POINTS(*degree) : LOFT_TRIANGLE_POINTS(*degree)))
            return true;
    return false;
}

/* True if it is whole, 0 to most. */
static bool whole_of(double x, double most, unsigned *out)
{
    if (!(x >= 0 && x <= most) || x != floor(x))
        return false;
    *out = (unsigned)x;
    return true;
}


// Points and planes
// -----------------

/* Three corners and a point of two numbers, or four and a point of three. */
int ENGINE_OF(answer_shares)(const decide_input *in)
{
    const bool solid = in->of->count == 15;
    loft_real x[NUMBERS], area;
    loft_acc share[4];
    loft_vec p[5];
    int status = take(in, x);

    if (status != LOFT_OK)
        return status;
    if (!solid && in->of->count != 8)
        return decide_refuse(in, "give 3 corners and a point, 8 numbers, or 4 in space, 15");
    points_of(x, solid ? 5 : 4, solid ? 3 : 2, p);
    status = solid ? loft_volume_from_point(p, p[4], share) : loft_bary_from_point(p, p[3], share);
    if (status == LOFT_SINGULAR)
        return decide_refuse(in, "the corners are on a line or in a plane: give others");
    if (status != LOFT_OK)
        return status;
    print_wide("shares", share, solid ? 4 : 3);
    if (solid)
        return LOFT_OK;
    status = loft_bary_area(p, &area);
    if (status == LOFT_OK)
        print_reals(in, "area", &area, 1);
    if (status == LOFT_OK)
        status = loft_bary_from_vector(p, p[3], share);
    if (status == LOFT_OK)
        print_wide("as a vector", share, 3);
    return status;
}

/* Two points of the plane or three of space, and one more. */
int ENGINE_OF(answer_plane)(const decide_input *in)
{
    const bool solid = in->of->count == 12;
    loft_real x[NUMBERS], equation[4], distance, value;
    loft_facet f;
    loft_line l;
    loft_vec p[4], normal;
    int status = take(in, x);

    if (status != LOFT_OK)
        return status;
    if (!solid && in->of->count != 6)
        return decide_refuse(
            in, "give 2 points of a line and one more, 6 numbers, or 3 of a plane, 12");
    points_of(x, solid ? 4 : 3, solid ? 3 : 2, p);
    l = (loft_line){ { p[0], p[1] } };
    f = (loft_facet){ { p[0], p[1], p[2] } };
    status = solid ? loft_facet_equation(&f, equation) : loft_line_equation(&l, equation);
    if (status == LOFT_OK)
        print_reals(in, "equation", equation, solid ? 4 : 3);
    if (status == LOFT_OK)
        status = solid ? loft_facet_value(&f, p[3], &value) : loft_line_value(&l, p[2], &value);
    if (status == LOFT_OK)
        print_reals(in, "value", &value, 1);
    if (status == LOFT_OK)
        status = solid ? loft_facet_normal(&f, &normal) : loft_line_normal(&l, &normal);
    if (status == LOFT_SINGULAR)
        return decide_refuse(in, "the points are on a line, or one: give others");
    if (status == LOFT_OK)
        print_reals(in, "normal", normal.axis, solid ? 3 : 2);
    if (status == LOFT_OK)
        status = solid ? loft_facet_distance(&f, p[3], &distance)
                       : loft_line_distance(&l, p[2], &distance);
    if (status == LOFT_OK)
        print_reals(in, "distance", &distance, 1);
    return status;
}

/* A sphere, and a point. */
int ENGINE_OF(answer_sphere)(const decide_input *in)
{
    loft_real x[NUMBERS], value, distance;
    loft_vec p[2], direction;
    int status = take(in, x);

    if (status != LOFT_OK)
        return status;
    points_of(x, 1, 3, p);
    points_of(x + 4, 1, 3, p + 1);
    const loft_sphere s = { p[0], x[3] };
    status = loft_sphere_value(&s, p[1], &value);
    if (status == LOFT_ERR_ARG)
        return decide_refuse(in, "a radius below 0: give one of 0 or more");
    if (status == LOFT_OK)
        print_reals(in, "value", &value, 1);
    if (status == LOFT_OK)
        status = loft_sphere_distance(&s, p[1], &distance);
    if (status == LOFT_OK)
        print_reals(in, "distance", &distance, 1);
    if (status == LOFT_OK)
        status = loft_sphere_direction(&s, p[1], &direction);
    if (status == LOFT_OK)
        print_reals(in, "normal", direction.axis, 3);
    return status == LOFT_SINGULAR ? LOFT_OK : status;      /* the centre has none */
}


// Polynomials
// -----------

static int print_weights(const decide_input *in)
{
    const double t = in->of->value[1];
    loft_acc w[MOST];
    unsigned n;

    if (!whole_of(in->of->value[0], LOFT_DEGREE_MAX, &n) || !(t >= 0 && t <= 1))
        return decide_refuse(in, "give a degree 0 to 9, and a parameter of 0 to 1");
    loft_bernstein_weights(n, LOFT_UNIT(t), w);
    for (unsigned k = 0; k <= n; k++)
        printf("%u %u %s\n", n - k, k, text_of(double_of_acc(w[k])));
    return LOFT_OK;
}

/* The Bernstein polynomials of a degree at t, at v, w, or at v, w, x. */
int ENGINE_OF(answer_weights)(const decide_input *in)
{
    if (in->of->count == 2)
        return print_weights(in);
    const double *of = in->of->value;
    const bool solid = in->of->count == 4;
    loft_acc w[LOFT_TETRA_MAX];
    unsigned n;

    if (!whole_of(of[0], LOFT_DEGREE_MAX, &n) || !(of[1] >= 0) || !(of[2] >= 0) ||
        (solid && !(of[3] >= 0)) || !(of[1] + of[2] + (solid ? of[3] : 0) <= 1))
        return decide_refuse(
            in, "give a degree 0 to 9, and shares that are not below 0 or, summed, above 1");
    const loft_bary u = { LOFT_UNIT(of[1]), LOFT_UNIT(of[2]) };
    if (solid) {
        const loft_volume v = { u.v, u.w, LOFT_UNIT(of[3]) };
        loft_volume_weights(n, loft_volume_clamp(v), w);
    } else
        loft_bary_weights(n, loft_bary_clamp(u), w);
    for (unsigned m = 0; m <= n; m++)
        for (unsigned k = 0; k <= m; k++)
            for (unsigned l = 0; l <= (solid ? k : 0); l++) {
                if (solid)
                    printf("%u %u %u %u %s\n", n - m, m - k, k - l, l,
                           text_of(double_of_acc(w[loft_tetra_place(m - k, k - l, l)])));
                else
                    printf("%u %u %u %s\n", n - m, m - k, k,
                           text_of(double_of_acc(w[loft_triangle_place(m - k, k)])));
            }
    return LOFT_OK;
}

/* v, w, x, then the coefficients: the value, and the net of a degree more. */
int ENGINE_OF(answer_solid)(const decide_input *in)
{
    static loft_vec net[LOFT_TETRA_MAX], high[LOFT_TETRA_POINTS(LOFT_DEGREE_MAX + 1)];
    loft_real x[NUMBERS];
    loft_tetra t;
    unsigned n;
    int status = take(in, x);

    if (status != LOFT_OK || !degree_of(in->of->count - 3, true, &n))
        return status ? status
                      : decide_refuse(
                            in, "give shares v,w,x, then 1, 4, 10, 20 .. coefficients, of a degree "
                                "up to 9");
    points_of(x + 3, LOFT_TETRA_POINTS(n), 1, net);
    status = loft_tetra_init(&t, net, n);
    if (status != LOFT_OK)
        return status;
    const loft_volume at = { loft_unit_from(x[0]), loft_unit_from(x[1]), loft_unit_from(x[2]) };
    const loft_vec value = loft_tetra_eval(&t, loft_volume_clamp(at));
    print_reals(in, "value", value.axis, 1);
    status = loft_tetra_elevate(&t, 1, high);
    printf("raised");
    for (unsigned k = 0; k < LOFT_TETRA_POINTS(n + 1) && status == LOFT_OK; k++) {
        putchar(' ');
        print_number(in->e, double_of(high[k].axis[0]));
    }
    putchar('\n');
    return status;
}

/* Times, v, w, then samples: Bernstein's operator on a triangle; 0 times: forever. */
int ENGINE_OF(answer_triangle_operator)(const decide_input *in)
{
    loft_real x[NUMBERS], value;
    unsigned n, times;
    int status = take(in, x);

    if (status != LOFT_OK || !degree_of(in->of->count - 3, false, &n) || n == 0 ||
        !whole_of(in->of->value[0], 1e6, &times))
        return status ? status
                      : decide_refuse(
                            in, "give how many times (0: forever), v,w, then 3, 6, 10 .. samples, "
                                "of a degree up to 9");
    const loft_bary at = { loft_unit_from(x[1]), loft_unit_from(x[2]) };
    const uint32_t rounds = times ? times : LOFT_FOREVER;
    status = loft_bary_inside(at) ? loft_triangle_iterate(x + 3, n, rounds, at, &value)
                                  : loft_triangle_iterate_extrapolate(x + 3, n, rounds, at, &value);
    if (status == LOFT_OK)
        print_reals(in, "value", &value, 1);
    return status;
}

/* Three corners, then coefficients: the integral over the triangle. */
int ENGINE_OF(answer_triangle_integral)(const decide_input *in)
{
    loft_real x[NUMBERS];
    loft_acc area, integral;
    loft_vec p[3];
    unsigned n;
    int status = take(in, x);

    if (status != LOFT_OK || !degree_of(in->of->count - 6, false, &n))
        return status ? status
                      : decide_refuse(
                            in, "give 3 corners x,y, then 1, 3, 6, 10 .. coefficients, of a degree "
                                "up to 9");
    points_of(x, 3, 2, p);
    status = loft_triangle_integral(x + 6, n, p, &area, &integral);
    if (status == LOFT_OK)
        printf("area %s\nintegral %s\n", text_of(double_of_acc(area)),
               text_of(double_of_acc(integral)));
    return status;
}

/* Of each triangle: the polar form with `times` arguments a, the others u. */
int ENGINE_OF(answer_polar)(const decide_input *in)
{
    const double *of = in->of->value;
    const loft_bary a = { LOFT_UNIT(of[1]), LOFT_UNIT(of[2]) },
                    u = { LOFT_UNIT(of[3]), LOFT_UNIT(of[4]) };
    loft_vec net[LOFT_TRIANGLE_MAX], p;
    unsigned times;
    int status = LOFT_OK;

    for (size_t k = 0; k < in->surfaces->count && status == LOFT_OK; k++) {
        const surface *s = &in->surfaces->surface[k];
        loft_triangle t;
        if (s->kind != SURFACE_TRIANGLE || s->rational || !whole_of(of[0], s->m, &times))
            return decide_refuse(
                in, "give triangles without weights, and at most as many times as their "
                    "degree");
        for (unsigned i = 0; i < s->count; i++)
            if (!vec_of(s->point[i].p, &net[i]))
                return LOFT_ERR_RANGE;
        status = loft_triangle_init(&t, net, s->m);
        if (status == LOFT_OK)
            status = loft_triangle_polar(&t, times, a, u, &p);
        if (status == LOFT_OK)
            print_vec(in, p);
    }
    return status;
}
