/* lib/curve/self_crossings.c
 * SPDX-License-Identifier: MIT
 *
 * The curve is halved until the legs of each piece's control polygon have a positive product with
 * its chord, or the piece is shorter than tol. Then the derivative has one too, and the piece does
 * not cross itself. Each pair of pieces is intersected, except neighbours whose legs have a
 * positive product with the chord of both.
 *
 * In the square of all (s, t) the places where C(s) and C(t) are within tol form regions. The
 * diagonal s = t lies in one of them. A cusp, or a bend as narrow as tol, widens it: neighbours
 * share a point, and the stretch that contains it is part of the region of the diagonal, a `near`
 * box. So are neighbours that are short. The other regions are crossings. Cuts of the curve part a
 * region: stretches that touch are one. What touches a near box belongs to it and is no crossing.
 * Neighbours are intersected first, so that most near boxes are known before.
 *
 * Weights: cubics within tol / 16 of the curve take its place, with tol / 2. Where the curve meets
 * itself they are within tol / 8, their chords within tol / 8 + tol / 8 (curve/intersect.c), the
 * half of tol / 2: none is missed. Where they are within tol / 2 the curve is within 5/8 tol.
 */
#include "curve/self_crossings.h"

#include "basis/dyadic.h"       /* loft_dyad, loft_bernstein_sub */
#include "curve/to_cubics.h"    /* loft_to_cubics */
#include "num/sci.h"            /* loft_sci */

#define MOST  (LOFT_DEGREE_MAX + 1)
#define NEAR  (2 * LOFT_DEGREE_MAX)
#define LEAST 14                /* the deepest level: 2^-14 of the curve */

/* A piece of a curve, which is itself the stretch from..to of a longer one. */
typedef struct {
    loft_dyad at;
    loft_unit from, to;
    loft_vec p[MOST];
    loft_bezier b;
} piece;

typedef struct {
    loft_unit s_from, s_to, t_from, t_to;
} box;

typedef struct {
    const loft_bezier *b;
    loft_unit from, to;         /* the stretch that b is */
    loft_real tol;
    loft_crossing *out;
    size_t room, *count, boxes;
    box near[NEAR];
    bool full;
} search;

static void cut(const search *z, loft_dyad at, piece *out)
{
    loft_acc x[MOST], part[MOST];

    out->at = at;
    out->from = z->from;
    out->to = z->to;
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        for (unsigned k = 0; k <= z->b->degree; k++)
            x[k] = loft_to_acc(z->b->p[k].axis[axis]);
        loft_bernstein_sub(x, z->b->degree, loft_dyad_from(at), loft_dyad_to(at), part);
        for (unsigned k = 0; k <= z->b->degree; k++)
            out->p[k].axis[axis] = loft_acc_round(part[k]);
    }
    out->b.p = out->p;
    out->b.degree = z->b->degree;
}

/* True if all legs of the polygon go along the way from `from` to `to`. */
static bool goes_along(const piece *x, const loft_vec *from, const loft_vec *to)
{
    for (unsigned k = 1; k <= x->b.degree; k++) {
        loft_sci along = loft_sci_zero();
        for (int axis = 0; axis < LOFT_AXES; axis++) {
            const loft_acc leg = loft_to_acc(x->p[k].axis[axis]) -
                                 loft_to_acc(x->p[k - 1].axis[axis]),
                           way = loft_to_acc(to->axis[axis]) - loft_to_acc(from->axis[axis]);
            along = loft_sci_add(along, loft_sci_mul(loft_sci_of(leg), loft_sci_of(way)));
        }
        if (loft_sci_sign(along) <= 0)
            return false;
    }
    return true;
}

static bool is_short(const search *z, const piece *x)
{
    loft_acc sum = 0;

    for (unsigned k = 1; k <= x->b.degree; k++) {
        loft_acc leg[LOFT_AXES];
        for (int axis = 0; axis < LOFT_AXES; axis++)
            leg[axis] = loft_to_acc(x->p[k].axis[axis]) - loft_to_acc(x->p[k - 1].axis[axis]);
        sum += loft_acc_hypot(leg, LOFT_AXES);
    }
    return sum <= loft_to_acc(z->tol);
}

/* The piece from the start of `at` that does not cross itself. */
static void take_piece(const search *z, loft_dyad at, piece *out)
{
    for (;; at = loft_dyad_half(at, 0)) {
        cut(z, at, out);
        if (at.level >= LEAST || goes_along(out, &out->p[0], &out->p[out->b.degree]) ||
            is_short(z, out))
            return;
    }
}

/* A parameter of a piece as one of the whole curve; exact where the stretch is all of it. */
static loft_unit place_in(const piece *x, loft_unit t)
{
    const loft_unit at = loft_dyad_at(x->at, t), width = x->to - x->from;

    return width < LOFT_UNIT(1)
               ? x->from + loft_unit_round(loft_acc_scale(loft_unit_to_acc(width), at))
               : at;
}

/* True if stretches of one parameter touch. Cuts are exact, places in pieces are rounded. */
static bool touch(loft_unit from, loft_unit to, loft_unit from2, loft_unit to2)
{
    const loft_unit gap = LOFT_UNIT(1.0 / 262144);
    return from - to2 <= gap && from2 - to <= gap;
}

static box box_of(const loft_crossing *c)
{
    return (box){ c->s_from, c->s_to, c->t_from, c->t_to };
}

static bool boxes_touch(const box *a, const box *b)
{
    return touch(a->s_from, a->s_to, b->s_from, b->s_to) &&
           touch(a->t_from, a->t_to, b->t_from, b->t_to);
}

static void join_ends(loft_unit *from, loft_unit *to, loft_unit from2, loft_unit to2)
{
    *from = from2 < *from ? from2 : *from;
    *to   = to2 > *to ? to2 : *to;
}

static void join_boxes(box *a, const box *b)
{
    join_ends(&a->s_from, &a->s_to, b->s_from, b->s_to);
    join_ends(&a->t_from, &a->t_to, b->t_from, b->t_to);
}

static void remove_crossing(search *z, size_t k)
{
    for (--*z->count; k < *z->count; k++)
        z->out[k] = z->out[k + 1];
}

/* Add a part of the region of the diagonal. More boxes than NEAR leave a cusp a crossing. */
static void add_near(search *z, box b)
{
    for (size_t k = 0; k < z->boxes; )
        if (boxes_touch(&z->near[k], &b)) {
            join_boxes(&b, &z->near[k]);
            z->near[k] = z->near[--z->boxes];
            k = 0;
        } else {
            k++;
        }
    if (z->boxes < NEAR)
        z->near[z->boxes++] = b;
}

/* Take crossings that touch a near box for parts of it. */
static void drop_near(search *z)
{
    for (size_t k = 0; k < *z->count; ) {
        const box b = box_of(&z->out[k]);
        size_t n = 0;
        while (n < z->boxes && !boxes_touch(&z->near[n], &b))
            n++;
        if (n == z->boxes) {
            k++;
            continue;
        }
        add_near(z, b);
        remove_crossing(z, k);
        k = 0;
    }
}

/* Put the stretches of c into one with those of d, at the closer place. */
static void join_crossings(loft_crossing *c, const loft_crossing *d)
{
    const loft_crossing other = *c;
    const bool closer = d->distance < c->distance;

    if (closer)
        *c = *d;
    join_ends(&c->s_from, &c->s_to, closer ? other.s_from : d->s_from,
              closer ? other.s_to : d->s_to);
    join_ends(&c->t_from, &c->t_to, closer ? other.t_from : d->t_from,
              closer ? other.t_to : d->t_to);
    c->overlap = other.overlap || d->overlap;
}

/* Insert, sorted by s; what touches is one. */
static void add_crossing(search *z, loft_crossing c)
{
    size_t k;

    for (k = 0; k < *z->count; ) {
        const box b = box_of(&c), other = box_of(&z->out[k]);
        if (boxes_touch(&b, &other)) {
            join_crossings(&c, &z->out[k]);
            remove_crossing(z, k);
            k = 0;
        } else {
            k++;
        }
    }
    if (*z->count == z->room)
        drop_near(z);
    if (*z->count == z->room) {
        z->full = true;
        return;
    }
    for (k = (*z->count)++; k > 0 && z->out[k - 1].s > c.s; k--)
        z->out[k] = z->out[k - 1];
    z->out[k] = c;
}

static void place_crossing(const piece *a, const piece *b, loft_crossing *c)
{
    loft_unit *const of_a[3] = { &c->s, &c->s_from, &c->s_to }, *const of_b[3] = { &c->t,
                                                                                   &c->t_from,
                                                                                   &c->t_to };

    for (int i = 0; i < 3; i++) {
        *of_a[i] = place_in(a, *of_a[i]);
        *of_b[i] = place_in(b, *of_b[i]);
    }
}

/* Find crossings of two pieces. `joined`: the second goes on where the first ends. */
static enum loft_status cross_pair(search *z, const piece *a, const piece *b, bool joined)
{
    const loft_unit end = LOFT_UNIT(1 - 1.0 / 1048576), start = LOFT_UNIT(1.0 / 1048576);
    loft_crossing found[MOST * MOST];
    size_t count;

    if (joined && goes_along(a, &a->p[0], &b->p[b->b.degree]) &&
        goes_along(b, &a->p[0], &b->p[b->b.degree]))
        return LOFT_OK;
    if (joined && is_short(z, a) && is_short(z, b)) {
        add_near(z, (box){ place_in(a, 0), place_in(a, LOFT_UNIT(1)), place_in(b, 0),
                           place_in(b, LOFT_UNIT(1)) });
        return LOFT_OK;
    }
    const enum loft_status status = loft_bezier_intersect(&a->b, &b->b, z->tol, found, MOST * MOST,
                                                          &count);
    if (status < 0)
        return status;
    for (size_t k = 0; k < count && !z->full; k++) {
        const bool near = joined && found[k].s_to >= end && found[k].t_from <= start;
        place_crossing(a, b, &found[k]);
        if (near)
            add_near(z, box_of(&found[k]));
        else
            add_crossing(z, found[k]);
    }
    return LOFT_OK;
}

static bool are_joined(const piece *a, const piece *b)
{
    return place_in(a, LOFT_UNIT(1)) == place_in(b, 0);
}

/* Of one curve, or stretch: neighbours. */
static enum loft_status cross_neighbours(search *z)
{
    loft_dyad at = { 0, 0 };
    enum loft_status status = LOFT_OK;
    piece one, two;

    take_piece(z, at, &one);
    at = one.at;
    while (status == LOFT_OK && !z->full && loft_dyad_next(&at)) {
        take_piece(z, at, &two);
        at = two.at;
        status = cross_pair(z, &one, &two, true);
        cut(z, at, &one);
    }
    return status;
}

/* Of one curve, or stretch. */
static enum loft_status cross_itself(search *z)
{
    loft_dyad first = { 0, 0 };
    enum loft_status status = cross_neighbours(z);
    piece one, two;

    do {
        take_piece(z, first, &one);
        first = one.at;
        loft_dyad second = first;
        while (status == LOFT_OK && !z->full && loft_dyad_next(&second)) {
            take_piece(z, second, &two);
            second = two.at;
            if (!are_joined(&one, &two))
                status = cross_pair(z, &one, &two, false);
        }
    } while (status == LOFT_OK && !z->full && loft_dyad_next(&first));
    return status;
}

static enum loft_status finish(search *z, enum loft_status status)
{
    bool overlap = false;

    if (status != LOFT_OK) {
        *z->count = 0;
        return status;
    }
    drop_near(z);
    for (size_t k = 0; k < *z->count; k++)
        overlap = overlap || z->out[k].overlap;
    return z->full ? LOFT_MORE : overlap ? LOFT_SINGULAR : LOFT_OK;
}

enum loft_status loft_bezier_self_crossings(const loft_bezier *b, loft_real tol,
                                            loft_crossing out[], size_t room, size_t *count)
{
    search z = { .b = b, .to = LOFT_UNIT(1), .tol = tol, .out = out, .room = room, .count = count };

    *count = 0;
    if (!(tol > 0) || LOFT_AXES < 2)
        return LOFT_ERR_ARG;
    return finish(&z, cross_itself(&z));
}

/* The next cubic of a chain, as a piece. */
static bool take_cubic(loft_to_cubics *s, piece *out)
{
    loft_cubic c;

    out->at = (loft_dyad){ 0, 0 };
    out->from = loft_to_cubics_at(s);
    if (!loft_to_cubics_next(s, &c))
        return false;
    out->to = loft_to_cubics_at(s);
    for (int k = 0; k < 4; k++)
        out->p[k] = c.p[k];
    out->b.p = out->p;
    out->b.degree = 3;
    return true;
}

enum loft_status loft_rational_self_crossings(const loft_rational *r, loft_real tol,
                                              loft_crossing out[], size_t room, size_t *count)
{
    loft_to_cubics first;
    piece one, two;

    *count = 0;
    if (!(tol > 0) || LOFT_AXES < 2)
        return LOFT_ERR_ARG;
    if (!(tol / 16 > 0))
        return LOFT_ERR_RANGE;
    search z = { .tol = tol / 2, .out = out, .room = room, .count = count };
    enum loft_status status = loft_rational_to_cubics_init(&first, r, tol / 16);
    while (status == LOFT_OK && !z.full && take_cubic(&first, &one)) {
        z.b = &one.b;
        z.from = one.from;
        z.to = one.to;
        status = cross_itself(&z);
        for (loft_to_cubics second = first;
             status == LOFT_OK && !z.full && take_cubic(&second, &two); )
            status = cross_pair(&z, &one, &two, are_joined(&one, &two));
    }
    return finish(&z, status);
}
