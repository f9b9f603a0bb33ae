/* host-tools/make/engine_make.c -- curves and surfaces made of the curves of a file, as .loft;
 * compiled once per number type
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>

#include "curve/reduce.h"                       /* loft_bezier_reduce */
#include "surface/tensor/revolve.h"             /* loft_tensor_rational_from_revolve */
#include "surface/tensor/ruled.h"               /* loft_tensor_from_ruled */
#include "surface/tensor/skin.h"                /* loft_skin */

#include "base/tool.h"                          /* tool_grow */
#include "make/decide.h"
#include "make/engine_parts.h"
#include "make/engine_patch.h"
#include "make/engine_pieces.h"                /* visit_pieces, piece_list */
#include "make/engine_weave.h"

// Curves
// ------

static void write_bezier(const decide_input *in, const loft_vec p[], unsigned degree)
{
    printf("bezier %u\n", degree);
    write_points(in, p, degree + 1);
}

static void write_weighted(const decide_input *in, const loft_weighted p[], unsigned count)
{
    const print_options o = { in->e, in->curves->solid };
    double point[ENGINE_AXES];

    for (unsigned k = 0; k < count; k++) {
        point_of(p[k].p, point);
        print_words(&o, point);
        printf(" : ");
        print_number(in->e, double_of(p[k].w));
        putchar('\n');
    }
}

static void write_rational(const decide_input *in, const loft_weighted p[], unsigned degree)
{
    printf("rational %u\n", degree);
    write_weighted(in, p, degree + 1);
}

void ENGINE_OF(write_piece)(const decide_input *in, const arc_piece *a)
{
    if (a->rational)
        write_rational(in, a->w, a->b.degree);
    else
        write_bezier(in, a->p, a->b.degree);
}

static int raise_piece(void *context, const arc_piece *a, size_t number)
{
    const decide_input *in = context;
    loft_vec p[LOFT_BEZIER_ELEVATE_MAX + 1];
    loft_weighted w[LOFT_ELEVATE_MAX + 1];
    loft_rational r;
    unsigned times;
    int status = LOFT_OK;

    if (!raise_by(in, "piece", number, a->b.degree, a->rational, &times))
        return LOFT_ERR_ARG;
    if (a->rational) {
        status = loft_rational_init(&r, a->w, a->b.degree);
        if (status == LOFT_OK)
            status = loft_rational_elevate(&r, times, w);
        if (status == LOFT_OK)
            write_rational(in, w, a->b.degree + times);
    } else {
        status = loft_bezier_elevate(&a->b, times, p);
        if (status == LOFT_OK)
            write_bezier(in, p, a->b.degree + times);
    }
    return status;
}

static int make_raise(const decide_input *in)
{
    return in->surfaces ? ENGINE_OF(make_raise_patch)(in)
                        : visit_pieces(in, raise_piece, (void *)in);
}

static int lower_piece(void *context, const arc_piece *a, size_t number)
{
    const decide_input *in = context;
    loft_vec p[MOST];
    loft_acc bound;
    unsigned times;

    (void)number;
    if (a->rational || !times_of(in, LOFT_DEGREE_MAX, &times))
        return LOFT_ERR_ARG;
    const int status = loft_bezier_reduce(&a->b, times, p, &bound);
    if (status != LOFT_OK)
        return status;
    write_bezier(in, p, a->b.degree - times);
    printf("# within %s\n", text_of(double_of_acc(bound)));
    return status;
}

static int make_lower(const decide_input *in) { return visit_pieces(in, lower_piece, (void *)in); }

int ENGINE_OF(write_part)(const decide_input *in, const arc_piece *a, loft_unit from, loft_unit to)
{
    loft_vec p[MOST];
    loft_weighted w[MOST];
    loft_rational r;
    int status;

    if (!a->rational) {
        status = loft_bezier_sub(&a->b, from, to, p);
        if (status == LOFT_OK)
            write_bezier(in, p, a->b.degree);
        return status;
    }
    status = loft_rational_init(&r, a->w, a->b.degree);
    if (status == LOFT_OK)
        status = loft_rational_sub(&r, from, to, w);
    if (status == LOFT_OK)
        write_rational(in, w, a->b.degree);
    return status;
}

static int split_piece(void *context, const arc_piece *a, size_t number)
{
    const decide_input *in = context;
    loft_unit from = 0;
    double before  = 0;
    int status     = LOFT_OK;

    (void)number;
    for (size_t k = 0; k <= in->of->count && status == LOFT_OK; k++) {
        const double t     = k < in->of->count ? in->of->value[k] : 1;
        const loft_unit to = (loft_unit)(t * (double)LOFT_UNIT(1));
        if (!(t > before && (t < 1 || k == in->of->count)))
            return LOFT_ERR_ARG;
        status = ENGINE_OF(write_part)(in, a, from, to);
        from   = to;
        before = t;
    }
    return status;
}

static int make_split(const decide_input *in)
{
    return in->surfaces ? ENGINE_OF(make_split_patch)(in)
                        : visit_pieces(in, split_piece, (void *)in);
}

/* The last piece first, each with its points in reverse order. */
static int make_reverse(const decide_input *in)
{
    static piece_list all;
    loft_weighted w[MOST];

    all.count = 0;
    const int status = visit_pieces(in, hold_piece, &all);
    for (size_t i = all.count; i-- > 0 && status == LOFT_OK; ) {
        const arc_piece *a = &all.piece[i];
        loft_vec p[MOST];
        for (unsigned k = 0; k <= a->b.degree; k++) {
            p[k] = a->p[a->b.degree - k];
            w[k] = a->w[a->b.degree - k];
        }
        if (a->rational)
            write_rational(in, w, a->b.degree);
        else
            write_bezier(in, p, a->b.degree);
    }
    return status;
}


// Surfaces
// --------

/* All pieces, polynomial and raised to one degree. */
static int sections_of(const decide_input *in, piece_list *all, unsigned *degree)
{
    all->count = 0;
    int status = visit_pieces(in, hold_piece, all);

    *degree = 1;
    for (size_t i = 0; i < all->count && status == LOFT_OK; i++) {
        if (all->piece[i].rational || all->piece[i].b.degree < 1)
            status = LOFT_ERR_ARG;
        if (all->piece[i].b.degree > *degree)
            *degree = all->piece[i].b.degree;
    }
    for (size_t i = 0; i < all->count && status == LOFT_OK; i++) {
        arc_piece *a = &all->piece[i];
        loft_vec p[LOFT_BEZIER_ELEVATE_MAX + 1];
        status = loft_bezier_elevate(&a->b, *degree - a->b.degree, p);
        for (unsigned k = 0; k <= *degree && status == LOFT_OK; k++)
            a->p[k] = p[k];
        if (status == LOFT_OK)
            status = loft_bezier_init(&a->b, a->p, *degree);
    }
    return status;
}

static int make_ruled(const decide_input *in)
{
    static piece_list all;
    loft_vec net[MOST * MOST];
    unsigned degree;
    int status = sections_of(in, &all, &degree);

    if (status == LOFT_OK && all.count != 2)
        return LOFT_ERR_ARG;
    if (status == LOFT_OK)
        status = loft_tensor_from_ruled(&all.piece[0].b, &all.piece[1].b, net);
    if (status == LOFT_OK)
        write_tensor(in, degree, 1, net);
    return status;
}

static int skin_through(const decide_input *in, enum loft_spline_ends ends)
{
    static piece_list all;
    static loft_vec p[HELD * MOST];
    static loft_real v[HELD];
    static loft_spline_knot memory[HELD * MOST];
    loft_vec net[MOST * MOST];
    loft_skin s;
    unsigned degree;
    int status = sections_of(in, &all, &degree);

    for (size_t i = 0; i < all.count && status == LOFT_OK; i++) {
        v[i] = loft_real_from_int((int32_t)i);
        for (unsigned k = 0; k <= degree; k++)
            p[i * (degree + 1) + k] = all.piece[i].p[k];
    }
    if (status == LOFT_OK)
        status = loft_skin_init(&s, p, degree, (uint32_t)all.count, v, ends, memory);
    for (uint32_t j = 0; j + 1 < all.count && status == LOFT_OK; j++) {
        status = loft_tensor_from_skin(&s, j, net);
        if (status == LOFT_OK)
            write_tensor(in, degree, 3, net);
    }
    return status;
}

static int make_skin(const decide_input *in) { return skin_through(in, LOFT_ENDS_NATURAL); }

static int make_skin_smooth(const decide_input *in)
{
    return skin_through(in, LOFT_ENDS_NOT_A_KNOT);
}

static int revolve_piece(void *context, const arc_piece *a, size_t number)
{
    decide_input in = *(const decide_input *)context;
    loft_weighted net[3 * MOST];
    curves solid = { .solid = true };
    loft_rational r;
    int status = a->b.degree > 0 ? loft_rational_init(&r, a->w, a->b.degree) : LOFT_ERR_ARG;

    (void)number;
    in.curves = &solid;
    for (unsigned k = 0; k < 4 && status == LOFT_OK; k++) {
        status = loft_tensor_rational_from_revolve(&r, k, net);
        if (status != LOFT_OK)
            break;
        printf("tensor %u 2\n", a->b.degree);
        write_weighted(&in, net, 3 * (a->b.degree + 1u));
    }
    return status;
}

static int make_revolve(const decide_input *in)
{
    return visit_pieces(in, revolve_piece, (void *)in);
}

const decide_question ENGINE_OF(make)[MAKE_VERBS] = {
    { "raise", DECIDE_SOLIDS, 1, 1, "a number of degrees", make_raise },
    { "lower", DECIDE_CURVES, 1, 1, "a number of degrees", make_lower },
    { "split", DECIDE_EITHER, 1, DECIDE_ANY, "t,.. between 0 and 1; of a surface u,v", make_split },
    { "lowest", DECIDE_CURVES, 1, 1, "a tolerance above 0", ENGINE_OF(make_lowest) },
    { "join", DECIDE_CURVES, 1, 1, "a tolerance above 0", ENGINE_OF(make_join) },
    { "thin", DECIDE_CURVES, 1, 1, "a tolerance", ENGINE_OF(make_thin) },
    { "insert", DECIDE_CURVES, 1, DECIDE_ANY, "knots u,..", ENGINE_OF(make_insert) },
    { "cut", DECIDE_CURVES, 2, 2, "two parameters of the curve, the lower one first",
      ENGINE_OF(make_cut) },
    { "pieces", DECIDE_CURVES, 0, 0, "nothing", ENGINE_OF(make_pieces) },
    { "reverse", DECIDE_CURVES, 0, 0, "nothing", make_reverse },
    { "ruled", DECIDE_CURVES, 0, 0, "nothing", make_ruled },
    { "skin", DECIDE_CURVES, 0, 0, "nothing", make_skin },
    { "hull", DECIDE_CURVES, 0, 0, "nothing", make_skin_smooth },
    { "revolve", DECIDE_CURVES, 0, 0, "nothing", make_revolve },
    { "sweep", DECIDE_CURVES, 1, 4, "a number of stations, and a direction",
      ENGINE_OF(make_sweep) },
    { "coons", DECIDE_CURVES, 0, 0, "nothing", ENGINE_OF(make_coons) },
    { "gordon", DECIDE_CURVES, 1, 1, "the number of curves along u", ENGINE_OF(make_gordon) },
    { "ferguson", DECIDE_CURVES, 0, 0, "nothing", ENGINE_OF(make_ferguson) },
    { "adini", DECIDE_CURVES, 0, 0, "nothing", ENGINE_OF(make_adini) },
    { "bessel", DECIDE_CURVES, 0, 0, "nothing", ENGINE_OF(make_bessel) },
    { "quarter", DECIDE_SURFACES, 0, 0, "nothing", ENGINE_OF(make_quarter) },
    { "patches", DECIDE_SURFACES, 0, 0, "nothing", ENGINE_OF(make_patches) },
    { "meet", DECIDE_SURFACES, 1, 1, "a tolerance above 0", ENGINE_OF(make_meet) },
    { "continue", DECIDE_SURFACES, 2, 2, "shares of T2 and T3", ENGINE_OF(make_continue) },
    { "gregory", DECIDE_SURFACES, 0, 0, "nothing", ENGINE_OF(make_gregory) },
    { "fill", DECIDE_SURFACES, 0, 1, "a degree, or nothing", ENGINE_OF(make_fill) },
};
