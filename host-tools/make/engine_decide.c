/* host-tools/make/engine_decide.c -- the questions of decide.h through the library; compiled once
 * per number type
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "basis/bernstein_operator.h"           /* loft_bernstein_operator */
#include "basis/copositive.h"                   /* loft_matrix_copositive */
#include "basis/integral.h"                     /* loft_bernstein_mean */
#include "basis/positivity.h"                   /* loft_bernstein_positivity_in, .._convex_in */
#include "basis/sign.h"                         /* loft_quadratic_sign */
#include "curve/conic.h"                        /* loft_conic_init */
#include "curve/crossings.h"                    /* loft_bezier_crossings */
#include "curve/enclosed.h"                     /* loft_chain_enclosed */
#include "curve/rational.h"                     /* loft_rational */
#include "curve/reduce.h"                       /* loft_bezier_exact_degree */
#include "curve/tangent.h"                      /* loft_rational_tangent */
#include "surface/triangle/triangle_shape.h"    /* loft_triangle_convex */

#include "base/progress.h"
#include "base/tool.h"                          /* tool_grow */
#include "make/decide.h"
#include "make/engine_parts.h"
#include "make/engine_patch.h"
#include "make/engine_pieces.h"                /* numbers_of, visit_pieces, piece_list */

static const char *yes_no(bool x) { return x ? "yes" : "no"; }

/* The degree of a triangular net of so many numbers, or the order of a symmetric matrix less 1. */
static bool triangular(size_t count, unsigned *degree)
{
    for (*degree = 0; (*degree + 1u) * (*degree + 2u) / 2 < count; )
        ++*degree;
    return (*degree + 1u) * (*degree + 2u) / 2 == count;
}


// Numbers
// -------

#define LONG_DEGREE 48          /* above this degree warn: slow */

/* A polynomial, and memory to decide about it. */
typedef struct {
    loft_real b[LOFT_POSITIVITY_DEGREE + 1];
    unsigned degree;
    uint32_t *work;
    progress bar;
} polynomial;

static int open_polynomial(const decide_input *in, polynomial *p)
{
    const size_t count = in->of->count;

    p->work = NULL;
    if (count >= 1 && count <= LOFT_POSITIVITY_DEGREE + 1) {
        p->degree = (unsigned)count - 1;
        p->work = tool_grow(NULL, LOFT_POSITIVITY_WORK(p->degree) * sizeof *p->work);
        progress_start(&p->bar, 1);
        if (p->degree >= LONG_DEGREE)
            progress_show(&p->bar, 0,
                          p->degree <= 64 ? "deciding: up to 5 seconds"
                                          : "deciding: up to 2 minutes");
        return numbers_of(in, p->b, LOFT_POSITIVITY_DEGREE + 1);
    }
    snprintf(in->why, DECIDE_WHY, "degree %zu: give 1 to %d coefficients, to degree %d", count - 1,
             LOFT_POSITIVITY_DEGREE + 1, LOFT_POSITIVITY_DEGREE);
    return LOFT_ERR_ARG;
}

static void close_polynomial(polynomial *p)
{
    if (p->work != NULL)
        progress_clear(&p->bar);
    free(p->work);
}

static int answer_positive(const decide_input *in)
{
    loft_positivity p;
    loft_sign s;
    polynomial of;
    int status = open_polynomial(in, &of);

    if (status == LOFT_OK)
        status = loft_bernstein_positivity_in(of.b, of.degree, of.work, &p);
    close_polynomial(&of);
    if (status != LOFT_OK)
        return status;
    printf("positive %s\nnonnegative %s\n", yes_no(p.positive), yes_no(p.nonnegative));
    if (p.roots < 0)
        printf("roots everywhere\n");
    else
        printf("roots %d\n", p.roots);
    if (in->of->count != 3)
        return status;
    status = loft_quadratic_sign(of.b, &s);
    if (status != LOFT_OK)
        return status;
    printf("minimum ");
    print_number(in->e, double_of(s.min));
    if (s.elevations < 0)
        printf("\nelevations more than 60\n");
    else
        printf("\nelevations %d\n", s.elevations);
    return status;
}

static int answer_convex(const decide_input *in)
{
    bool net, whole;
    polynomial of;
    int status = open_polynomial(in, &of);

    if (status == LOFT_OK)
        status = loft_bernstein_convex_in(of.b, of.degree, of.work, &net, &whole);
    close_polynomial(&of);
    if (status == LOFT_OK)
        printf("polygon %s\npolynomial %s\n", yes_no(net), yes_no(whole));
    return status;
}

static int answer_copositive(const decide_input *in)
{
    loft_real m[LOFT_COPOSITIVE_MAX * (LOFT_COPOSITIVE_MAX + 1) / 2];
    unsigned order;
    bool copositive;
    int status = numbers_of(in, m, sizeof m / sizeof m[0]);

    if (status == LOFT_OK && !triangular(in->of->count, &order))
        return LOFT_ERR_ARG;
    if (status == LOFT_OK)
        status = loft_matrix_copositive(m, order + 1, &copositive);
    if (status == LOFT_OK)
        printf("order %u\ncopositive %s\n", order + 1, yes_no(copositive));
    return status;
}

static int answer_triangle(const decide_input *in)
{
    loft_real b[MOST * (MOST + 1) / 2], sums[3];
    loft_net_convexity c;
    loft_triangle_sign s;
    unsigned degree;
    bool nonnegative;
    int status = numbers_of(in, b, sizeof b / sizeof b[0]);

    if (status == LOFT_OK && !triangular(in->of->count, &degree))
        return LOFT_ERR_ARG;
    if (status == LOFT_OK)
        status = loft_triangle_convex(b, degree, &c);
    if (status == LOFT_OK)
        printf("degree %u\nnet convex %s\nweakly convex %s\n", degree, yes_no(c.net),
               yes_no(c.weak));
    if (status == LOFT_OK && degree == 2) {
        status = loft_triangle2_sign(b, &s);
        if (status == LOFT_OK)
            printf("nonnegative %s\n", yes_no(s.nonnegative));
    } else if (status == LOFT_OK && degree > 2) {
        status = loft_triangle_wang_liu(b, degree, &nonnegative, sums);
        if (status == LOFT_OK)
            printf("Wang and Liu %s\n", nonnegative ? "nonnegative" : "not decided");
    }
    return status;
}

/* The last number is x. */
static int answer_operator(const decide_input *in)
{
    loft_real f[LOFT_OPERATOR_MAX + 2], value, deriv;
    int status = numbers_of(in, f, LOFT_OPERATOR_MAX + 2);

    if (status == LOFT_OK && in->of->count < 3)
        return LOFT_ERR_ARG;
    const size_t n = in->of->count - 2;
    if (status == LOFT_OK)
        status = loft_bernstein_operator(f, (unsigned)n, loft_unit_from(f[n + 1]), &value, &deriv);
    if (status != LOFT_OK)
        return status;
    printf("value ");
    print_number(in->e, double_of(value));
    printf("\nderivative ");
    print_number(in->e, double_of(deriv));
    putchar('\n');
    return status;
}


// Curves
// ------

static int degree_of(void *context, const arc_piece *a, size_t number)
{
    const decide_input *in = context;
    loft_vec q[MOST];
    unsigned degree;

    if (a->rational)
        return LOFT_ERR_ARG;
    const int status = loft_bezier_exact_degree(&a->b, &degree, q);
    if (status != LOFT_OK)
        return status;
    printf("%sbezier %u\n", number ? "\n" : "", degree);
    for (unsigned k = 0; k <= degree; k++)
        print_vec(in, q[k]);
    return status;
}

static int answer_degree(const decide_input *in) { return visit_pieces(in, degree_of, (void *)in); }

/* How far a coordinate of w p, or w, is from what was meant: half the last bit of its factors. */
static double rounding_of(const decide_input *in, const loft_weighted *p, int axis)
{
    const double x = axis < LOFT_AXES ? double_of(p->p.axis[axis]) : 1, w = double_of(p->w);

    return in->e->lsb * (in->e->fixed ? fabs(x) + fabs(w) : fabs(x * w));
}

static double homogeneous(const loft_weighted *p, int axis)
{
    return double_of(p->w) * (axis < LOFT_AXES ? double_of(p->p.axis[axis]) : 1);
}

/* A cubic is a conic if the third difference of its homogeneous points is 0. Written with weights
 * that are rounded, such as 1/3, it is one within the sum of these roundings: then p[] is the conic
 * of the first two points and the last, of its first half if the middle weight is near 0. */
static bool conic_within_rounding(const decide_input *in, const loft_weighted w[4],
                                  loft_weighted p[3])
{
    static const double times[4] = { -1, 3, -3, 1 };
    double h[3][LOFT_AXES + 1];

    for (int axis = 0; axis <= LOFT_AXES; axis++) {
        double third = 0, within = 0, q[4];
        for (int k = 0; k < 4; k++) {
            q[k] = homogeneous(&w[k], axis);
            third += times[k] * q[k];
            within += fabs(times[k]) * rounding_of(in, &w[k], axis);
        }
        if (!(fabs(third) <= within))
            return false;
        h[0][axis] = q[0];
        h[1][axis] = (3 * q[1] - q[0]) / 2;
        h[2][axis] = q[3];
    }
    if (fabs(h[1][LOFT_AXES]) < 0.25 * fmax(fabs(h[0][LOFT_AXES]), fabs(h[2][LOFT_AXES])))
        for (int axis = 0; axis <= LOFT_AXES; axis++) {     /* the half */
            const double middle = h[1][axis];
            h[1][axis] = (h[0][axis] + middle) / 2;
            h[2][axis] = (h[0][axis] + 2 * middle + h[2][axis]) / 4;
        }
    for (int k = 0; k < 3; k++) {
        p[k] = (loft_weighted){ { { 0 } }, 0 };
        bool fits = real_of(h[k][LOFT_AXES], &p[k].w);
        for (int axis = 0; axis < LOFT_AXES; axis++)
            fits = fits && real_of(h[k][axis] / h[k][LOFT_AXES], &p[k].p.axis[axis]);
        if (!fits)
            return false;
    }
    return true;
}

static double distance_of(const loft_weighted *a, const loft_weighted *b)
{
    return hypot(double_of(a->p.axis[0]) - double_of(b->p.axis[0]),
                 double_of(a->p.axis[1]) - double_of(b->p.axis[1]));
}

/* A conic is a circle if its legs a, b from the middle point are as long as each other, and
 * 2 |w1| |a| = sqrt(w0 w2) |c|, c its chord. Is it one within the rounding of its numbers, 2 last
 * bits of each? The middle point of a cubic's conic, (3 q1 - q0) / 2 over w1, has up to 4 of them
 * over w1, and a rounded weight moves it along its legs. */
static bool is_round(const decide_input *in, const loft_weighted p[3], bool of_cubic,
                     const loft_conic *c)
{
    const double w1 = fabs(double_of(p[1].w)), lsb = (of_cubic ? 4 : 2) * in->e->lsb,
                 ends = sqrt(fmax(double_of(p[0].w) * double_of(p[2].w), 0)),
                 a = distance_of(&p[0], &p[1]), b = distance_of(&p[2], &p[1]),
                 chord = distance_of(&p[0], &p[2]);
    double largest = 0;

    if (c->kind != LOFT_CONIC_ELLIPSE || !(ends > 0))
        return false;
    for (int k = 0; k < 3; k++)
        for (int axis = 0; axis < 2; axis++)
            largest = fmax(largest, fabs(double_of(p[k].p.axis[axis])));
    const double more = of_cubic ? 1 / fmin(w1, 1) : 1, along = of_cubic ? (a + b) / 4 : 0,
                 off = lsb * more * (in->e->fixed ? 1 + along : largest),
                 heavy = lsb * (in->e->fixed ? 1 : w1 + ends);
    return fabs(a - b) <= 2 * off &&
           fabs(w1 * (a + b) - ends * chord) <= 2 * off * (w1 + ends) + heavy * (a + b + chord);
}

static int conic_of(void *context, const arc_piece *a, size_t number)
{
    static const char *const word[] = { "ellipse", "parabola", "hyperbola",
                                        "line",    "point",    "no curve" };
    const decide_input *in = context;
    loft_weighted p[3];
    loft_conic c;
    loft_vec centre, focus[2];
    loft_real axes[2];
    unsigned foci = 0;
    bool rounded = false;
    int status = LOFT_OK;

    if (a->b.degree == 3) {
        status = loft_conic_from_cubic(a->w, p);
        if (status == LOFT_SINGULAR)        /* its middle weight may be 0 */
            status = loft_conic_from_half_cubic(a->w, p);
        if (status == LOFT_SINGULAR && conic_within_rounding(in, a->w, p)) {
            rounded = true;
            status = LOFT_OK;
        }
    } else if (a->b.degree != 2)
        return LOFT_ERR_ARG;
    for (unsigned k = 0; k < 3 && a->b.degree == 2; k++)
        p[k] = a->w[k];
    if (status == LOFT_SINGULAR) {
        printf("%zu no conic within the rounding of its numbers\n", number);
        return LOFT_OK;
    }
    if (status == LOFT_OK)
        status = loft_conic_init(&c, p);
    if (status != LOFT_OK)
        return status;
    const bool round = !c.circle && is_round(in, p, a->b.degree == 3, &c);
    printf("%zu %s%s%s%s\n", number, c.circle || round ? "circle, " : "", word[c.kind],
           c.kind < LOFT_CONIC_POINT && !c.finite ? ", through infinity" : "",
           rounded || round ? ", within the rounding of its numbers" : "");
    if (c.kind > LOFT_CONIC_HYPERBOLA)
        return LOFT_OK;
    status = loft_conic_foci(p, focus, &foci);
    if (status == LOFT_OK && round) {
        status = loft_conic_axes(p, &centre, axes);
        focus[0] = focus[1] = centre;
    }
    for (unsigned k = 0; k < foci && status == LOFT_OK; k++) {
        printf("focus ");
        print_vec(in, focus[k]);
    }
    if (status != LOFT_OK || c.kind == LOFT_CONIC_PARABOLA)
        return status;
    status = loft_conic_axes(p, &centre, axes);
    if (status != LOFT_OK)
        return status;
    printf("centre ");
    print_vec(in, centre);
    printf("axes ");
    print_number(in->e, double_of(axes[0]));
    putchar(' ');
    print_number(in->e, double_of(axes[1]));
    putchar('\n');
    return LOFT_OK;
}

static int bend_of(void *context, const arc_piece *a, size_t number)
{
    const decide_input *in = context;
    loft_rational r;
    loft_tangent here;
    loft_vec d;
    loft_acc curvature;
    int status = a->b.degree > 0 ? loft_rational_init(&r, a->w, a->b.degree) : LOFT_ERR_ARG;

    for (size_t j = 0; j < in->of->count && status == LOFT_OK; j++) {
        status = in->of->value[j] >= 0 && in->of->value[j] <= 1
                     ? loft_rational_tangent(&r, loft_unit_from(LOFT_REAL(in->of->value[j])), &here)
                     : LOFT_ERR_ARG;
        for (unsigned k = 1; k <= 2 && status == LOFT_OK; k++) {
            status = loft_tangent_deriv(&here, k, &d);
            if (status == LOFT_OK) {
                printf("%zu t %s %s ", number, text_of(in->of->value[j]),
                       k == 1 ? "first" : "second");
                print_vec(in, d);
            }
        }
        if (status == LOFT_OK)
            status = loft_tangent_curvature(&here, !in->curves->solid, &curvature);
        if (status == LOFT_OK)
            printf("%zu t %s curvature %s\n", number, text_of(in->of->value[j]),
                   text_of(double_of_acc(curvature)));
        if (status == LOFT_SINGULAR) {
            printf("%zu t %s stops\n", number, text_of(in->of->value[j]));
            status = LOFT_OK;
        }
    }
    return status;
}

static int answer_bend(const decide_input *in) { return visit_pieces(in, bend_of, (void *)in); }

/* A rational curve, whose weights the library may not take otherwise. */
static int weighted_of(const curve *c, arc_piece *out)
{
    out->b.degree = (uint8_t)c->degree;
    out->b.p = out->p;
    out->rational = true;
    for (unsigned k = 0; k <= c->degree; k++) {
        if (!vec_of(c->point[k].p, &out->p[k]) || !real_of(c->point[k].w, &out->w[k].w))
            return LOFT_ERR_RANGE;
        out->w[k].p = out->p[k];
    }
    return LOFT_OK;
}

static int answer_conic(const decide_input *in)
{
    size_t number = 0;
    int status = LOFT_OK;
    arc_piece a;

    for (size_t i = 0; i < in->curves->count && status == LOFT_OK; i++) {
        const curve *c = &in->curves->curve[i];
        if (c->kind != CURVE_RATIONAL) {
            status = visit_curve(in, i, conic_of, (void *)in, &number);
            continue;
        }
        status = weighted_of(c, &a);
        if (status == LOFT_OK)
            status = conic_of((void *)in, &a, number++);
    }
    return status;
}

static int hold_polynomial(void *context, const arc_piece *a, size_t number)
{
    return a->rational ? LOFT_ERR_ARG : hold_piece(context, a, number);
}

/* Every pair of pieces. */
static int answer_meet(const decide_input *in)
{
    static piece_list all;
    loft_meeting m[LOFT_MEETINGS_MAX];
    unsigned count;

    all.count = 0;
    int status = visit_pieces(in, hold_polynomial, &all);
    for (size_t i = 0; i < all.count && status >= 0; i++)
        for (size_t j = i + 1; j < all.count && status >= 0; j++) {
            status = loft_bezier_crossings(&all.piece[i].b, &all.piece[j].b, m, &count);
            if (status == LOFT_SINGULAR)
                printf("%zu %zu overlap\n", i, j);
            for (unsigned k = 0; k < count && status == LOFT_OK; k++)
                printf("%zu %zu %s %s multiplicity %u\n", i, j, text_of(double_of_unit(m[k].s)),
                       text_of(double_of_unit(m[k].t)), m[k].multiplicity);
        }
    return status < 0 ? status : LOFT_OK;
}

static int answer_enclosed(const decide_input *in)
{
    static piece_list all;
    static loft_bezier chain[HELD];
    loft_enclosed e = { 0 };

    all.count = 0;
    int status = visit_pieces(in, hold_polynomial, &all);
    for (size_t i = 0; i < all.count; i++)
        chain[i] = all.piece[i].b;
    if (status == LOFT_OK)
        status = loft_chain_enclosed(chain, (unsigned)all.count, &e);
    if (status == LOFT_SINGULAR)
        printf("area 0\n");
    if (status != LOFT_OK)
        return status == LOFT_SINGULAR ? LOFT_OK : status;
    printf("area %s\ncentroid %s %s\nmoments %s %s %s\n", text_of(double_of_acc(e.area)),
           text_of(double_of_acc(e.centroid[0])), text_of(double_of_acc(e.centroid[1])),
           text_of(double_of_acc(e.xx)), text_of(double_of_acc(e.xy)),
           text_of(double_of_acc(e.yy)));
    return status;
}

static int under_of(void *context, const arc_piece *a, size_t number)
{
    const decide_input *in = context;
    loft_acc area = 0;
    loft_real end[2];
    int status = a->rational ? LOFT_ERR_ARG : numbers_of(in, end, 2);

    if (a->rational)
        return decide_refuse(in, "a piece has weights: give curves without");
    if (status == LOFT_OK)
        status = loft_bezier_area_under(&a->b, loft_unit_from(end[0]), loft_unit_from(end[1]),
                                        &area);
    if (status == LOFT_ERR_ARG)
        return decide_refuse(in, "a parameter is not in 0..1: give others");
    if (status == LOFT_OK)
        printf("%zu %s\n", number, text_of(double_of_acc(area)));
    return status;
}

static int answer_under(const decide_input *in) { return visit_pieces(in, under_of, (void *)in); }

const decide_question ENGINE_OF(decide)[DECIDE_QUESTIONS] = {
    { "positive", DECIDE_NUMBERS, 1, DECIDE_ANY, "Bernstein coefficients", answer_positive },
    { "convex", DECIDE_NUMBERS, 1, DECIDE_ANY, "Bernstein coefficients", answer_convex },
    { "copositive", DECIDE_NUMBERS, 1, DECIDE_ANY,
      "a symmetric matrix, a11 a12 .. a22 ..: 1, 3, 6, 10, 15 or 21 numbers", answer_copositive },
    { "triangle", DECIDE_NUMBERS, 1, DECIDE_ANY, "a triangular net, row by row", answer_triangle },
    { "shares", DECIDE_NUMBERS, 8, 15, "corners and a point", ENGINE_OF(answer_shares) },
    { "plane", DECIDE_NUMBERS, 6, 12, "points of a line or a plane and one more",
      ENGINE_OF(answer_plane) },
    { "sphere", DECIDE_NUMBERS, 7, 7, "a centre x,y,z, a radius, a point x,y,z",
      ENGINE_OF(answer_sphere) },
    { "weights", DECIDE_NUMBERS, 2, 4, "a degree, t, v,w or v,w,x", ENGINE_OF(answer_weights) },
    { "solid", DECIDE_NUMBERS, 4, DECIDE_ANY, "v,w,x, then coefficients", ENGINE_OF(answer_solid) },
    { "iterate", DECIDE_NUMBERS, 6, DECIDE_ANY, "times, v,w, then samples",
      ENGINE_OF(answer_triangle_operator) },
    { "over", DECIDE_NUMBERS, 7, DECIDE_ANY, "3 corners x,y, then coefficients",
      ENGINE_OF(answer_triangle_integral) },
    { "polar", DECIDE_SURFACES, 5, 5, "times, then v,w of both places", ENGINE_OF(answer_polar) },
    { "operator", DECIDE_NUMBERS, 3, DECIDE_ANY, "two or more samples, then x", answer_operator },
    { "smooth", DECIDE_NUMBERS, 4, DECIDE_ANY,
      "2 to 10 samples, how many times, 1 to 32767, and x in 0..1", ENGINE_OF(answer_smooth) },
    { "power", DECIDE_NUMBERS, 1, DECIDE_ANY, "Bernstein coefficients", ENGINE_OF(answer_power) },
    { "integral", DECIDE_NUMBERS, 3, DECIDE_ANY, "Bernstein coefficients, then the ends in 0..1",
      ENGINE_OF(answer_integral) },
    { "frame", DECIDE_CURVES, 1, DECIDE_ANY, "parameters t in 0..1", ENGINE_OF(answer_frame) },
    { "degree", DECIDE_CURVES, 0, 0, "nothing", answer_degree },
    { "bend", DECIDE_CURVES, 1, DECIDE_ANY, "parameters t in 0..1", answer_bend },
    { "inflections", DECIDE_CURVES, 0, 0, "nothing", ENGINE_OF(answer_inflections) },
    { "loops", DECIDE_CURVES, 1, 1, "a tolerance above 0", ENGINE_OF(answer_loops) },
    { "conic", DECIDE_CONICS, 0, 0, "nothing", answer_conic },
    { "meet", DECIDE_CURVES, 0, 0, "nothing", answer_meet },
    { "enclosed", DECIDE_CURVES, 0, 0, "nothing", answer_enclosed },
    { "under", DECIDE_CURVES, 2, 2, "two parameters in 0..1", answer_under },
    { "nearest", DECIDE_SURFACES, 3, 3, "a point x,y,z", ENGINE_OF(answer_nearest) },
    { "ray", DECIDE_SURFACES, 6, 6, "a point and a direction x,y,z,dx,dy,dz",
      ENGINE_OF(answer_ray) },
    { "pierce", DECIDE_BOTH, 1, 1, "a tolerance above 0", ENGINE_OF(answer_pierce) },
    { "area", DECIDE_SURFACES, 0, 1, "a tolerance, or nothing", ENGINE_OF(answer_area) },
    { "volume", DECIDE_SURFACES, 0, 1, "a tolerance, or nothing", ENGINE_OF(answer_volume) },
    { "join", DECIDE_SURFACES, 0, 2, "nothing, or shares of T2 and T3", ENGINE_OF(answer_join) },
};
