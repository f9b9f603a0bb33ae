/* lib/curve/self_crossings.c
 * SPDX-License-Identifier: MIT
 *
 * The curve is halved until the legs of each piece's control polygon have a positive product with
 * its chord, or the piece is shorter than tol. Then the derivative has one too, and the piece does
 * not cross itself. Each pair of pieces is intersected, except neighbours whose legs have a
 * positive product with the chord of both. Neighbours share a point: a crossing that contains it is
 * dropped. A crossing at the end of pieces is found from up to four pairs: those that agree are
 * one.
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
#define LEAST 14                /* the deepest level: 2^-14 of the curve */

/* A piece of a curve, which is itself the stretch from..to of a longer one. */
typedef struct {
    loft_dyad at;
    loft_unit from, to;
    loft_vec p[MOST];
    loft_bezier b;
} piece;

typedef struct {
    const loft_bezier *b;
    loft_unit from, to;         /* the stretch that b is */
    loft_real tol;
    loft_crossing *out;
    size_t room, *count;
    bool full, overlap;
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

/* Do all legs of the polygon go along the way from `from` to `to`? */
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

static bool are_near(loft_unit a, loft_unit b)
{
    const loft_unit gap = LOFT_UNIT(1.0 / 262144);
    return a - b <= gap && b - a <= gap;
}

/* A parameter of a piece as one of the whole curve; exact where the stretch is all of it. */
static loft_unit place_in(const piece *x, loft_unit t)
{
    const loft_unit at = loft_dyad_at(x->at, t), width = x->to - x->from;

    return width < LOFT_UNIT(1)
               ? x->from + loft_unit_round(loft_acc_scale(loft_unit_to_acc(width), at))
               : at;
}

/* Insert, sorted by s; a crossing that is known is not inserted again. */
static void add_crossing(search *z, const piece *a, const piece *b, loft_crossing c)
{
    size_t k;

    loft_unit *const of_a[3] = { &c.s, &c.s_from, &c.s_to }, *const of_b[3] = { &c.t, &c.t_from,
                                                                                &c.t_to };
    for (int i = 0; i < 3; i++) {
        *of_a[i] = place_in(a, *of_a[i]);
        *of_b[i] = place_in(b, *of_b[i]);
    }
    for (k = 0; k < *z->count; k++)
        if (are_near(z->out[k].s, c.s) && are_near(z->out[k].t, c.t))
            return;
    if (*z->count == z->room) {
        z->full = true;
        return;
    }
    for (k = (*z->count)++; k > 0 && z->out[k - 1].s > c.s; k--)
        z->out[k] = z->out[k - 1];
    z->out[k] = c;
    z->overlap = z->overlap || c.overlap;
}

static enum loft_status cross_pair(search *z, const piece *a, const piece *b)
{
    const bool joined = place_in(a, LOFT_UNIT(1)) == place_in(b, 0);
    const loft_unit end = LOFT_UNIT(1 - 1.0 / 1048576), start = LOFT_UNIT(1.0 / 1048576);
    loft_crossing found[MOST * MOST];
    size_t count;

    if (joined && goes_along(a, &a->p[0], &b->p[b->b.degree]) &&
        goes_along(b, &a->p[0], &b->p[b->b.degree]))
        return LOFT_OK;
    if (joined && is_short(z, a) && is_short(z, b))
        return LOFT_OK;
    const enum loft_status status = loft_bezier_intersect(&a->b, &b->b, z->tol, found, MOST * MOST,
                                                          &count);
    if (status < 0)
        return status;
    for (size_t k = 0; k < count && !z->full; k++)
        if (!joined || found[k].s_to < end || found[k].t_from > start)
            add_crossing(z, a, b, found[k]);
    return LOFT_OK;
}

/* Of one curve, or stretch. */
static enum loft_status cross_itself(search *z)
{
    loft_dyad first = { 0, 0 };
    enum loft_status status = LOFT_OK;
    piece one, two;

    do {
        take_piece(z, first, &one);
        first = one.at;
        loft_dyad second = first;
        while (status == LOFT_OK && !z->full && loft_dyad_next(&second)) {
            take_piece(z, second, &two);
            second = two.at;
            status = cross_pair(z, &one, &two);
        }
    } while (status == LOFT_OK && !z->full && loft_dyad_next(&first));
    return status;
}

static enum loft_status finish(const search *z, enum loft_status status)
{
    if (status != LOFT_OK) {
        *z->count = 0;
        return status;
    }
    return z->full ? LOFT_MORE : z->overlap ? LOFT_SINGULAR : LOFT_OK;
}

enum loft_status loft_bezier_self_crossings(const loft_bezier *b, loft_real tol,
                                            loft_crossing out[], size_t room, size_t *count)
{
    search z = { b, 0, LOFT_UNIT(1), tol, out, room, count, false, false };

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
    search z = { NULL, 0, 0, tol / 2, out, room, count, false, false };
    enum loft_status status = loft_rational_to_cubics_init(&first, r, tol / 16);
    while (status == LOFT_OK && !z.full && take_cubic(&first, &one)) {
        z.b = &one.b;
        z.from = one.from;
        z.to = one.to;
        status = cross_itself(&z);
        for (loft_to_cubics second = first;
             status == LOFT_OK && !z.full && take_cubic(&second, &two); )
            status = cross_pair(&z, &one, &two);
    }
    return finish(&z, status);
}
