/* host-tools/make/engine_loops.c -- where curves cross themselves; compiled once per number type
 * SPDX-License-Identifier: MIT
 *
 * Two pieces of which one has weights are compared as cubics within tol / 16 of them, with tol / 2
 * (lib/curve/self_crossings.c).
 */
#include <stdlib.h>

#include "curve/self_crossings.h"   /* loft_rational_self_crossings */
#include "curve/to_cubics.h"        /* loft_to_cubics */

#include "make/engine_parts.h"     /* answer_loops */
#include "make/engine_pieces.h"

#define ROOM 256

/* The stretch from..to of a piece. */
typedef struct {
    loft_vec p[MOST];
    loft_bezier b;
    loft_unit from, to;
} stretch;

/* A piece as one stretch, or its next cubic. */
typedef struct {
    const arc_piece *a;
    loft_to_cubics s;
    bool cubics, more;
} walk;

typedef struct {
    const decide_input *in;
    loft_real tol;
    loft_crossing found[ROOM];
    size_t count;
} loops;

static int start_walk(walk *w, const arc_piece *a, bool cubics, loft_real tol)
{
    loft_rational r;

    w->a = a;
    w->cubics = cubics;
    w->more = true;
    if (!cubics)
        return LOFT_OK;
    if (!a->rational)
        return loft_to_cubics_init(&w->s, &a->b, tol / 16);
    const int status = loft_rational_init(&r, a->w, a->b.degree);
    return status == LOFT_OK ? (int)loft_rational_to_cubics_init(&w->s, &r, tol / 16) : status;
}

static bool next_stretch(walk *w, stretch *out)
{
    loft_cubic c;

    if (!w->cubics) {
        out->b = w->a->b;
        out->from = 0;
        out->to = LOFT_UNIT(1);
        const bool more = w->more;
        w->more = false;
        return more;
    }
    out->from = loft_to_cubics_at(&w->s);
    if (!loft_to_cubics_next(&w->s, &c))
        return false;
    out->to = loft_to_cubics_at(&w->s);
    for (int k = 0; k < 4; k++)
        out->p[k] = c.p[k];
    return loft_bezier_init(&out->b, out->p, 3) == LOFT_OK;
}

static loft_unit place_in(const stretch *x, loft_unit t)
{
    const loft_unit width = x->to - x->from;
    return width < LOFT_UNIT(1)
               ? x->from + loft_unit_round(loft_acc_scale(loft_unit_to_acc(width), t))
               : t;
}

static bool touch(loft_unit from, loft_unit to, loft_unit from2, loft_unit to2)
{
    return double_of_unit(from) <= double_of_unit(to2) + 0x1p-18 &&
           double_of_unit(from2) <= double_of_unit(to) + 0x1p-18;
}

static void join_ends(loft_unit *from, loft_unit *to, loft_unit from2, loft_unit to2)
{
    *from = from2 < *from ? from2 : *from;
    *to   = to2 > *to ? to2 : *to;
}

/* Keep a crossing of two stretches. What touches is one (lib/curve/self_crossings.c). */
static void keep_crossing(loops *l, const stretch *a, const stretch *b, loft_crossing c)
{
    loft_unit *const of_a[3] = { &c.s, &c.s_from, &c.s_to }, *const of_b[3] = { &c.t, &c.t_from,
                                                                                &c.t_to };
    for (int i = 0; i < 3; i++) {
        *of_a[i] = place_in(a, *of_a[i]);
        *of_b[i] = place_in(b, *of_b[i]);
    }
    for (size_t k = 0; k < l->count; ) {
        loft_crossing *const d = &l->found[k];
        if (!touch(d->s_from, d->s_to, c.s_from, c.s_to) ||
            !touch(d->t_from, d->t_to, c.t_from, c.t_to)) {
            k++;
            continue;
        }
        loft_crossing one = d->distance < c.distance ? *d : c;
        const loft_crossing other = d->distance < c.distance ? c : *d;
        join_ends(&one.s_from, &one.s_to, other.s_from, other.s_to);
        join_ends(&one.t_from, &one.t_to, other.t_from, other.t_to);
        one.overlap = one.overlap || other.overlap;
        c = one;
        *d = l->found[--l->count];
        k = 0;
    }
    if (l->count < ROOM)
        l->found[l->count++] = c;
}

/* Drop the place where neighbours are joined. */
static void drop_joint(loops *l)
{
    for (size_t k = 0; k < l->count; )
        if (double_of_unit(l->found[k].s_to) >= 1 - 0x1p-20 &&
            double_of_unit(l->found[k].t_from) <= 0x1p-20)
            l->found[k] = l->found[--l->count];
        else
            k++;
}

static int in_order(const void *a, const void *b)
{
    const loft_crossing *const x = a, *const y = b;
    return (x->s > y->s) - (x->s < y->s);
}

static int cross_pieces(loops *l, const arc_piece *a, const arc_piece *b, bool joined)
{
    static loft_crossing found[ROOM];
    const bool cubics = a->rational || b->rational;
    const loft_real tol = cubics ? l->tol / 2 : l->tol;
    walk first, second;
    stretch x, y;
    size_t count;

    l->count = 0;
    int status = start_walk(&first, a, cubics, l->tol);
    while (status >= 0 && next_stretch(&first, &x)) {
        status = start_walk(&second, b, cubics, l->tol);
        while (status >= 0 && next_stretch(&second, &y)) {
            status = loft_bezier_intersect(&x.b, &y.b, tol, found, ROOM, &count);
            for (size_t k = 0; k < count && status >= 0; k++)
                keep_crossing(l, &x, &y, found[k]);
        }
    }
    if (joined)
        drop_joint(l);
    qsort(l->found, l->count, sizeof *l->found, in_order);
    return status;
}

static int cross_itself(loops *l, const arc_piece *a)
{
    loft_rational r;

    if (!a->rational)
        return loft_bezier_self_crossings(&a->b, l->tol, l->found, ROOM, &l->count);
    l->count = 0;
    const int status = loft_rational_init(&r, a->w, a->b.degree);
    return status == LOFT_OK
               ? (int)loft_rational_self_crossings(&r, l->tol, l->found, ROOM, &l->count)
               : status;
}

static void print_crossings(const loops *l, size_t i, size_t j)
{
    for (size_t k = 0; k < l->count; k++) {
        const loft_crossing *c = &l->found[k];
        /* the distance is exact to tol / 4 (lib/curve/intersect.h) */
        const bool near = double_of_acc(c->distance) > double_of(l->tol) / 4;
        printf("%zu %zu ", i, j);
        fputs(text_of(double_of_unit(c->s)), stdout);
        putchar(' ');
        fputs(text_of(double_of_unit(c->t)), stdout);
        printf("%s at ", c->overlap ? " overlap" : near ? " near" : "");
        print_vec(l->in, c->point);
    }
}

/* Each piece with itself; with the other pieces of its curve, but where neighbours are joined. */
int ENGINE_OF(answer_loops)(const decide_input *in)
{
    static piece_list all;
    static loops l;
    size_t number = 0;
    int status = real_of(in->of->value[0], &l.tol) && l.tol > 0 ? LOFT_OK : LOFT_ERR_ARG;

    l.in = in;
    if (status != LOFT_OK)
        return decide_refuse(in, "a tolerance of 0: give one above 0");
    for (size_t c = 0; c < in->curves->count && status >= 0; c++) {
        const size_t first = number;
        all.count = 0;
        status = visit_curve(in, c, hold_piece, &all, &number);
        for (size_t i = 0; i < all.count && status >= 0; i++) {
            status = cross_itself(&l, &all.piece[i]);
            print_crossings(&l, first + i, first + i);
            for (size_t j = i + 1; j < all.count && status >= 0; j++) {
                status = cross_pieces(&l, &all.piece[i], &all.piece[j], j == i + 1);
                print_crossings(&l, first + i, first + j);
            }
        }
    }
    return status == LOFT_ERR_RANGE
               ? decide_refuse(in, "the tolerance is too fine: give a larger --of")
           : status < 0             ? status
                        : LOFT_OK;
}
