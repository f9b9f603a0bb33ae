/* host-tools/make/engine_parts.c -- pieces of curves: cut, joined, lowered, with their frames; and
 * polynomials; compiled once per number type
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>

#include "basis/bernstein.h"                    /* loft_bernstein_to_power */
#include "basis/bernstein_operator.h"           /* loft_bernstein_iterate */
#include "basis/integral.h"                     /* loft_bernstein_integral */
#include "curve/inflections.h"                  /* loft_bezier_inflections */
#include "curve/moving_frame.h"                 /* loft_moving_frame */
#include "curve/reduce.h"                       /* loft_bezier_reduce */
#include "curve/tangent.h"                      /* loft_rational_tangent */

#include "make/engine_parts.h"

// Pieces
// ------

static int give_piece(void *context, const arc_piece *a, size_t number)
{
    (void)number;
    ENGINE_OF(write_piece)(context, a);
    return LOFT_OK;
}

int ENGINE_OF(make_pieces)(const decide_input *in)
{
    return visit_pieces(in, give_piece, (void *)in);
}

typedef struct {
    const decide_input *in;
    const curve *c;
    double from, to;
    size_t pieces, parts;
} cutting;

/* What the piece has between from and to. The spans of an arc have equal ranges. */
static int cut_piece(void *context, const arc_piece *a, size_t number)
{
    cutting *x = context;
    const bool arc    = x->c->kind == CURVE_ARC;
    const unsigned i  = (unsigned)number;
    const double low  = arc ? (double)i / (double)x->pieces : curve_break(x->c, i),
                 high = arc ? (double)(i + 1) / (double)x->pieces : curve_break(x->c, i + 1),
                 from = fmax((x->from - low) / (high - low), 0),
                 to   = fmin((x->to - low) / (high - low), 1);

    if (!(from < to))
        return LOFT_OK;
    x->parts++;
    return ENGINE_OF(write_part)(x->in, a, (loft_unit)(from * (double)LOFT_UNIT(1)),
                                 (loft_unit)(to * (double)LOFT_UNIT(1)));
}

static int count_piece(void *context, const arc_piece *a, size_t number)
{
    cutting *x = context;

    (void)a;
    (void)number;
    x->pieces++;
    return LOFT_OK;
}

/* The part between two parameters of each curve. */
int ENGINE_OF(make_cut)(const decide_input *in)
{
    cutting x = { in, NULL, in->of->value[0], in->of->value[1], 0, 0 };
    int status = LOFT_OK;

    for (size_t c = 0; c < in->curves->count && status == LOFT_OK; c++) {
        size_t number = 0, again = 0;
        x.c      = &in->curves->curve[c];
        x.pieces = 0;
        status = visit_curve(in, c, count_piece, &x, &number);
        if (status == LOFT_OK)
            status = visit_curve(in, c, cut_piece, &x, &again);
    }
    return status == LOFT_OK && x.parts == 0
               ? decide_refuse(
                     in, "no curve has that part: give two of its parameters, the lower first")
               : status;
}

/* The piece with the lowest degree that stays within the tolerance; of degree 1 at least. */
static int lower_most(void *context, const arc_piece *a, size_t number)
{
    const decide_input *in = context;
    arc_piece low = *a;
    loft_acc bound = 0, best = 0;
    loft_vec p[MOST];

    (void)number;
    low.b.p = low.p;
    for (unsigned times = a->rational ? 0 : a->b.degree; times-- > 1; ) {
        if (loft_bezier_reduce(&a->b, times, p, &bound) != LOFT_OK ||
            !(double_of_acc(bound) <= in->of->value[0]))
            continue;
        for (unsigned k = 0; k + times <= a->b.degree; k++)
            low.p[k] = p[k];
        low.b.degree = (uint8_t)(a->b.degree - times);
        best = bound;
        break;
    }
    ENGINE_OF(write_piece)(in, &low);
    printf("# within %s\n", text_of(double_of_acc(best)));
    return LOFT_OK;
}

int ENGINE_OF(make_lowest)(const decide_input *in)
{
    return in->of->value[0] > 0 ? visit_pieces(in, lower_most, (void *)in)
                                : decide_refuse(in, "a tolerance of 0: give one above 0");
}


// Joining
// -------

static double length_of(loft_vec v)
{
    double p[ENGINE_AXES], sum = 0;

    point_of(v, p);
    for (int i = 0; i < ENGINE_AXES; i++)
        sum += p[i] * p[i];
    return sqrt(sum);
}

static double apart(loft_vec a, loft_vec b)
{
    double p[ENGINE_AXES], q[ENGINE_AXES], sum = 0;

    point_of(a, p);
    point_of(b, q);
    for (int i = 0; i < ENGINE_AXES; i++)
        sum += (p[i] - q[i]) * (p[i] - q[i]);
    return sqrt(sum);
}

/* The largest distance of control points of the part from..to from those of b: it bounds that of
 * the curves. */
static bool part_is_near(const loft_bezier *whole, loft_unit from, loft_unit to,
                         const loft_bezier *b, double tol)
{
    loft_vec p[MOST];
    bool near = loft_bezier_sub(whole, from, to, p) == LOFT_OK;

    for (unsigned k = 0; k <= b->degree && near; k++)
        near = apart(p[k], b->p[k]) <= tol;
    return near;
}

/* One curve for both, if they are parts of one within tol: the longer one goes on beyond its end.
 * In place of a. */
static bool join_pieces(arc_piece *a, const arc_piece *b, double tol)
{
    loft_vec first, second, p[MOST];
    loft_bezier whole;

    if (a->rational || b->rational || a->b.degree != b->b.degree || a->b.degree == 0 ||
        apart(a->p[a->b.degree], b->p[0]) > tol ||
        loft_bezier_deriv(&a->b, 1, LOFT_UNIT(1), &first) != LOFT_OK ||
        loft_bezier_deriv(&b->b, 1, LOFT_UNIT(0), &second) != LOFT_OK)
        return false;
    const double before = length_of(first), behind = length_of(second);
    if (!(before > 0 && behind > 0))
        return false;
    const loft_unit share = LOFT_UNIT(before / (before + behind));
    const int status = behind <= before
                           ? loft_bezier_sub(&a->b, 0, LOFT_UNIT(1 + behind / before), p)
                           : loft_bezier_sub(&b->b, LOFT_UNIT(-before / behind), LOFT_UNIT(1), p);
    if (status != LOFT_OK || loft_bezier_init(&whole, p, a->b.degree) != LOFT_OK ||
        !part_is_near(&whole, 0, share, &a->b, tol) ||
        !part_is_near(&whole, share, LOFT_UNIT(1), &b->b, tol))
        return false;
    for (unsigned k = 0; k <= a->b.degree; k++)
        a->w[k].p = a->p[k] = p[k];
    return true;
}

typedef struct {
    const decide_input *in;
    arc_piece held;             /* the joined one */
    bool any;
} joining;

static int join_next(void *context, const arc_piece *a, size_t number)
{
    joining *x = context;

    (void)number;
    if (x->any && join_pieces(&x->held, a, x->in->of->value[0]))
        return LOFT_OK;
    if (x->any)
        ENGINE_OF(write_piece)(x->in, &x->held);
    x->held = *a;
    x->held.b.p = x->held.p;
    x->any = true;
    return LOFT_OK;
}

/* Neighbours that are one polynomial. */
int ENGINE_OF(make_join)(const decide_input *in)
{
    static joining x;
    int status;

    x = (joining){ .in = in };
    status = in->of->value[0] > 0 ? visit_pieces(in, join_next, &x)
                                  : decide_refuse(in, "a tolerance of 0: give one above 0");
    if (status == LOFT_OK && x.any)
        ENGINE_OF(write_piece)(in, &x.held);
    return status;
}


// Frames
// ------

static void print_direction(const char *name, const loft_sci d[3])
{
    loft_acc x;

    printf(" %s", name);
    for (int i = 0; i < 3; i++)
        printf(" %s", text_of(loft_sci_to_acc(d[i], &x) ? double_of_acc(x) : 0.0));
}

typedef struct {
    const decide_input *in;
    loft_moving_frame moving;
    bool begun;
} framing;

/* A direction that is not along d: an axis. */
static loft_vec axis_across(loft_vec d)
{
    double p[ENGINE_AXES];
    loft_vec out = d;
    int least = 0;

    point_of(d, p);
    for (int i = 0; i < ENGINE_AXES; i++) {
        out.axis[i] = LOFT_REAL(0);
        least = fabs(p[i]) < fabs(p[least]) ? i : least;
    }
    out.axis[fabs(p[2]) < 0.9 * length_of(d) ? 2 : least] = LOFT_REAL(1);
    return out;
}

static int frame_at(framing *x, const loft_rational *r, double t, size_t number)
{
    const loft_unit at = loft_unit_from(LOFT_REAL(t));
    loft_moving_frame bent;
    loft_tangent here;
    loft_vec first, second, p = loft_rational_eval(r, at);
    int status = loft_rational_tangent(r, at, &here);

    if (status == LOFT_OK)
        status = loft_tangent_deriv(&here, 1, &first);
    if (status == LOFT_OK)
        status = loft_tangent_deriv(&here, 2, &second);
    if (status == LOFT_OK)
        status = x->begun ? loft_moving_frame_move(&x->moving, p, first)
                          : loft_moving_frame_start(&x->moving, p, first, axis_across(first));
    if (status == LOFT_SINGULAR) {
        printf("%zu t %s no frame\n", number, text_of(t));
        return LOFT_OK;
    }
    if (status != LOFT_OK)
        return status;
    x->begun = true;
    printf("%zu t %s", number, text_of(t));
    print_direction("along", x->moving.along);
    print_direction("across", x->moving.across);
    if (loft_moving_frame_start(&bent, p, first, second) == LOFT_OK)
        print_direction("normal", bent.across);
    putchar('\n');
    return LOFT_OK;
}

static int frames_of(void *context, const arc_piece *a, size_t number)
{
    framing *x = context;
    loft_rational r;
    int status = a->b.degree > 0 ? loft_rational_init(&r, a->w, a->b.degree) : LOFT_ERR_ARG;

    for (size_t j = 0; j < x->in->of->count && status == LOFT_OK; j++) {
        const double t = x->in->of->value[j];
        status = t >= 0 && t <= 1 ? frame_at(x, &r, t, number) : LOFT_ERR_ARG;
    }
    return status;
}

/* The frame that does not twist, moved from place to place, and the normal of Frenet's. */
int ENGINE_OF(answer_frame)(const decide_input *in)
{
    framing x = { .in = in };

    return visit_pieces(in, frames_of, &x);
}


// Polynomials
// -----------

/* The coefficients of 1, t, t^2 .. */
int ENGINE_OF(answer_power)(const decide_input *in)
{
    loft_real b[MOST];
    loft_acc c[MOST];
    const int status = numbers_of(in, b, MOST);
    const unsigned degree = (unsigned)in->of->count - 1;

    if (status != LOFT_OK)
        return status;
    for (unsigned k = 0; k <= degree; k++)
        c[k] = loft_to_acc(b[k]);
    loft_bernstein_to_power(c, degree);
    for (unsigned k = 0; k <= degree; k++)
        printf("%s%s", k ? " " : "power ", text_of(double_of_acc(c[k])));
    putchar('\n');
    return LOFT_OK;
}

/* The last two numbers are the ends. */
int ENGINE_OF(answer_integral)(const decide_input *in)
{
    loft_real b[MOST + 2];
    loft_acc whole, part;
    int status = numbers_of(in, b, MOST + 2);
    const unsigned count = (unsigned)in->of->count - 2;

    if (status == LOFT_OK)
        status = loft_bernstein_mean(b, count, &whole);
    if (status == LOFT_OK)
        status = loft_bernstein_integral(b, count - 1, loft_unit_from(b[count]),
                                         loft_unit_from(b[count + 1]), &part);
    if (status != LOFT_OK)
        return status;
    printf("over 0..1 %s\npart %s\n", text_of(double_of_acc(whole)), text_of(double_of_acc(part)));
    return LOFT_OK;
}

/* Bernstein's operator, applied so many times to samples; the last two numbers are times and x. */
int ENGINE_OF(answer_smooth)(const decide_input *in)
{
    loft_real f[MOST + 2], value;
    int status = numbers_of(in, f, MOST + 2);
    const unsigned n = (unsigned)in->of->count - 3;
    const double times = status == LOFT_OK ? in->of->value[n + 1] : 0;

    if (status == LOFT_OK && !(times >= 1 && times <= 32767))
        status = LOFT_ERR_ARG;
    if (status == LOFT_OK)
        status = loft_bernstein_iterate(f, n, (uint32_t)times, loft_unit_from(f[n + 2]), &value);
    if (status != LOFT_OK)
        return status;
    printf("value ");
    print_number(in->e, double_of(value));
    putchar('\n');
    return LOFT_OK;
}


// Shape
// -----

static int inflections_of(void *context, const arc_piece *a, size_t number)
{
    loft_rational r = { .p = a->w, .degree = a->b.degree };
    loft_flat flat[LOFT_FLATS_MAX];
    unsigned count;
    const int status = a->rational ? loft_rational_inflections(&r, flat, &count)
                                   : loft_bezier_inflections(&a->b, flat, &count);

    if (status == LOFT_ERR_ARG)
        return decide_refuse(context, "a piece with weights has a degree above 7: give lower ones");
    if (status == LOFT_SINGULAR)
        printf("%zu straight\n", number);
    for (unsigned k = 0; k < count && status == LOFT_OK; k++)
        printf("%zu t %s %s, multiplicity %u\n", number, text_of(double_of_unit(flat[k].t)),
               flat[k].multiplicity % 2 ? "inflection" : "flat", flat[k].multiplicity);
    return status < 0 ? status : LOFT_OK;
}

int ENGINE_OF(answer_inflections)(const decide_input *in)
{
    return visit_pieces(in, inflections_of, (void *)in);
}
