/* host-tools/study/engine_loops.c -- where curves cross themselves; compiled once per number type
 * SPDX-License-Identifier: MIT
 *
 * Two pieces of which one has weights are compared as cubics within tol / 16 of them, with tol / 2
 * (lib/curve/self_crossings.c).
 */
#include "curve/self_crossings.h"   /* loft_rational_self_crossings */
#include "curve/to_cubics.h"        /* loft_to_cubics */

#include "study/engine_parts.h"     /* answer_loops */
#include "study/engine_pieces.h"

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

static bool are_near(loft_unit a, loft_unit b)
{
    return fabs(double_of_unit(a) - double_of_unit(b)) < 0x1p-18;
}

/* Keep a crossing of two pieces: not the place where neighbours are joined, and each one once. */
static void keep_crossing(loops *l, const stretch *a, const stretch *b, bool joined,
                          loft_crossing c)
{
    c.s_to = place_in(a, c.s_to);
    c.t_from = place_in(b, c.t_from);
    c.s = place_in(a, c.s);
    c.t = place_in(b, c.t);
    if (joined && double_of_unit(c.s_to) >= 1 - 0x1p-20 && double_of_unit(c.t_from) <= 0x1p-20)
        return;
    for (size_t k = 0; k < l->count; k++)
        if (are_near(l->found[k].s, c.s) && are_near(l->found[k].t, c.t))
            return;
    if (l->count < ROOM)
        l->found[l->count++] = c;
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
                keep_crossing(l, &x, &y, joined, found[k]);
        }
    }
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
        printf("%zu %zu %.9g %.9g%s at ", i, j, double_of_unit(c->s), double_of_unit(c->t),
               c->overlap ? " overlap" : "");
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
