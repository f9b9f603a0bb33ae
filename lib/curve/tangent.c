/* lib/curve/tangent.c
 * SPDX-License-Identifier: MIT
 *
 * With X = sum N_i w_i (p_i - o) and w = sum N_i w_i for any o, P = o + X / w and
 *
 *     P'  = (X' - w' Y) / w        P'' = (X'' - 2 w' P' - w'' Y) / w        Y = X / w
 *     P''' = (X''' - 3 w' P'' - 3 w'' P' - w''' Y) / w
 *
 * o is the rounded point of the curve: Y is below one LSB, and what the weights do hardly shows.
 *
 * P' is 0 if and only if X' w = w' X, for any o: here o = 0. N is a B-spline, or a Bernstein
 * polynomial, which is a B-spline on the knots 0 and 1.
 */
#include "curve/tangent.h"
#include "basis/knots_basis.h"  /* loft_knots_basis */
#include "num/residue.h"        /* loft_residue */

#define MOST (LOFT_DEGREE_MAX + 1)

/* One piece of either kind: its points, and its knots with the place among them. */
typedef struct {
    const loft_weighted *p;
    loft_knots knots;
    unsigned span;
    loft_real u;
} piece;

/* sum basis_i w_i (p_i - o) of one axis; of the weights alone for axis -1 */
static loft_sci weighted_sum(const piece *s, const loft_sci basis[], int axis, loft_vec origin)
{
    loft_sci sum = loft_sci_zero();

    for (unsigned i = 0; i <= s->knots.degree; i++) {
        loft_sci term = loft_sci_mul(basis[i], loft_sci_from_real(s->p[i].w));
        if (axis >= 0)
            term = loft_sci_mul(term, loft_sci_sub(loft_sci_from_real(s->p[i].p.axis[axis]),
                                                   loft_sci_from_real(origin.axis[axis])));
        sum = loft_sci_add(sum, term);
    }
    return sum;
}

static uint32_t weighted_residue(const piece *s, const loft_residue *r, const uint32_t basis[],
                                 int axis)
{
    uint32_t sum = 0;

    for (unsigned i = 0; i <= s->knots.degree; i++) {
        uint32_t term = loft_residue_mul(r, basis[i], loft_residue_real(r, s->p[i].w));
        if (axis >= 0)
            term = loft_residue_mul(r, term, loft_residue_real(r, s->p[i].p.axis[axis]));
        sum = loft_residue_add(r, sum, term);
    }
    return sum;
}

/* True if X' w = w' X modulo this prime. */
static bool stops_modulo(const piece *s, const loft_residue *r, const uint32_t at[],
                         const uint32_t slope[])
{
    const uint32_t w = weighted_residue(s, r, at, -1), dw = weighted_residue(s, r, slope, -1);

    for (int axis = 0; axis < LOFT_AXES; axis++) {
        const uint32_t left = loft_residue_mul(r, weighted_residue(s, r, slope, axis), w);
        const uint32_t right = loft_residue_mul(r, weighted_residue(s, r, at, axis), dw);
        if (left != right)
            return false;
    }
    return true;
}

static bool curve_stops(const piece *s)
{
    uint32_t at[MOST], slope[MOST];
    loft_residue r;

    loft_residue_start(&r, 2 * (loft_knots_basis_bits(&s->knots) + 2 * LOFT_RESIDUE_REAL + 4) + 1);
    while (loft_residue_next(&r)) {
        if (!loft_knots_basis_residue(&s->knots, s->span, s->u, 0, &r, at) ||
            !loft_knots_basis_residue(&s->knots, s->span, s->u, 1, &r, slope))
            loft_residue_skip(&r);
        else if (!stops_modulo(s, &r, at, slope))
            return false;
    }
    return true;
}

static bool piece_valid(const piece *s)
{
    const unsigned degree = s->knots.degree;

    for (unsigned i = 0; i <= degree; i++) {
        if (!loft_exact_valid(s->p[i].w))
            return false;
        for (int axis = 0; axis < LOFT_AXES; axis++)
            if (!loft_exact_valid(s->p[i].p.axis[axis]))
                return false;
    }
    for (unsigned i = s->span + 1 - degree; i <= s->span + degree; i++)
        if (!loft_exact_valid(s->knots.k[i]))
            return false;
    return loft_exact_valid(s->u);
}

static enum loft_status piece_tangent(const piece *s, loft_vec origin, loft_tangent *out)
{
    const loft_sci two = loft_sci_from_int(2), three = loft_sci_from_int(3);
    loft_sci basis[4][MOST], w[4], d[4];

    if (!piece_valid(s))
        return LOFT_ERR_RANGE;
    for (unsigned k = 0; k < 4; k++) {
        loft_knots_basis(&s->knots, s->span, s->u, k, basis[k]);
        w[k] = weighted_sum(s, basis[k], -1, origin);
    }
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        const loft_sci y = loft_sci_div(weighted_sum(s, basis[0], axis, origin), w[0]);
        for (unsigned k = 1; k < 4; k++)
            d[k] = loft_sci_sub_product(weighted_sum(s, basis[k], axis, origin), w[k], y);
        d[1] = loft_sci_div(d[1], w[0]);
        d[2] = loft_sci_div(loft_sci_sub_product(d[2], loft_sci_mul(two, w[1]), d[1]), w[0]);
        d[3] = loft_sci_sub_product(d[3], loft_sci_mul(three, w[1]), d[2]);
        d[3] = loft_sci_div(loft_sci_sub_product(d[3], loft_sci_mul(three, w[2]), d[1]), w[0]);
        out->first[axis] = d[1];
        out->second[axis] = d[2];
        out->third[axis] = d[3];
    }
    out->stops = curve_stops(s);
    for (int axis = 0; axis < LOFT_AXES && out->stops; axis++)
        out->first[axis] = loft_sci_zero();
    return LOFT_OK;
}

enum loft_status loft_nurbs_tangent(const loft_nurbs *n, loft_real u, loft_tangent *out)
{
    const loft_real at = loft_knots_clamp(&n->knots, u);
    const unsigned span = loft_knots_find(&n->knots, at);
    const piece s = { n->p + span - n->knots.degree, n->knots, span, at };

    return piece_tangent(&s, loft_nurbs_eval(n, at), out);
}

/* A parameter as a coordinate: 256 times as large, which no number type rounds. */
static loft_real scaled_parameter(loft_unit t) { return loft_acc_round(loft_unit_to_acc(t) * 256); }

enum loft_status loft_rational_tangent(const loft_rational *r, loft_unit t, loft_tangent *out)
{
    loft_real k[2 * MOST];
    const loft_sci scale = loft_sci_from_int(256), square = loft_sci_mul(scale, scale);
    const piece s = { r->p,
                      { k, (uint16_t)(r->degree + 1), r->degree },
                      r->degree,
                      scaled_parameter(loft_unit_clamp(t)) };

    if (!(t >= 0 && t <= LOFT_UNIT(1)))
        return LOFT_ERR_ARG;
    for (unsigned i = 0; i <= r->degree; i++) {
        k[i] = LOFT_REAL(0);
        k[r->degree + 1u + i] = LOFT_REAL(256);
    }
    const enum loft_status status = piece_tangent(&s, loft_rational_eval(r, t), out);
    if (status != LOFT_OK)
        return status;
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        out->first[axis] = loft_sci_mul(out->first[axis], scale);
        out->second[axis] = loft_sci_mul(out->second[axis], square);
        out->third[axis] = loft_sci_mul(out->third[axis], loft_sci_mul(square, scale));
    }
    return LOFT_OK;
}

enum loft_status loft_tangent_deriv(const loft_tangent *at, unsigned k, loft_vec *out)
{
    const loft_sci *d = k == 1 ? at->first : k == 2 ? at->second : at->third;
    loft_acc x[LOFT_AXES];

    if (k < 1 || k > 3)
        return LOFT_ERR_ARG;
    for (int i = 0; i < LOFT_AXES; i++)
        if (!loft_sci_to_acc(d[i], &x[i]))
            return LOFT_ERR_RANGE;
    return loft_vec_round(x, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

/* x'y'' - x''y' of two axes */
static loft_sci turn_of(const loft_tangent *at, int i, int j)
{
    return loft_sci_sub_product(loft_sci_mul(at->first[i], at->second[j]), at->second[i],
                                at->first[j]);
}

enum loft_status loft_tangent_curvature(const loft_tangent *at, bool plane, loft_acc *out)
{
    const int axes = plane && LOFT_AXES > 2 ? 2 : LOFT_AXES;
    loft_sci square = loft_sci_zero(), turns = loft_sci_zero(), turn = loft_sci_zero();

    for (int i = 0; i < axes; i++) {
        square = loft_sci_add(square, loft_sci_mul(at->first[i], at->first[i]));
        for (int j = i + 1; j < axes; j++) {
            turn = turn_of(at, i, j);
            turns = loft_sci_add(turns, loft_sci_mul(turn, turn));
        }
    }
    if (at->stops || loft_sci_sign(square) <= 0)
        return LOFT_SINGULAR;
    if (!plane)
        turn = loft_sci_sqrt(turns);
    return loft_sci_to_acc(loft_sci_div(turn, loft_sci_mul(square, loft_sci_sqrt(square))), out)
               ? LOFT_OK
               : LOFT_ERR_RANGE;
}

#if LOFT_AXES >= 3

/* P' x P''; false where it vanishes. */
static bool binormal_of(const loft_tangent *at, loft_sci out[3], loft_sci *square)
{
    const loft_sci size = loft_sci_mul(loft_sci_dot3(at->first, at->first),
                                       loft_sci_dot3(at->second, at->second));

    loft_sci_cross3(at->first, at->second, out);
    *square = loft_sci_dot3(out, out);
    return !at->stops && loft_sci_sign(*square) > 0 &&
           !loft_sci_less(*square, loft_sci_mul(size, loft_sci_power2(-80)));
}

enum loft_status loft_tangent_torsion(const loft_tangent *at, loft_acc *out)
{
    loft_sci across[3], square;

    if (!binormal_of(at, across, &square))
        return LOFT_SINGULAR;
    return loft_sci_to_acc(loft_sci_div(loft_sci_dot3(across, at->third), square), out)
               ? LOFT_OK
               : LOFT_ERR_RANGE;
}

enum loft_status loft_tangent_frenet(const loft_tangent *at, loft_vec frame[3])
{
    loft_sci across[3], along[3], inward[3], square;
    loft_acc x[3][LOFT_AXES] = { { 0 } };
    loft_vec unit[3];
    bool fits = true;

    if (!binormal_of(at, across, &square))
        return LOFT_SINGULAR;
    const loft_sci length = loft_sci_sqrt(square),
                   speed = loft_sci_sqrt(loft_sci_dot3(at->first, at->first));
    for (int i = 0; i < 3; i++) {
        across[i] = loft_sci_div(across[i], length);
        along[i] = loft_sci_div(at->first[i], speed);
    }
    loft_sci_cross3(across, along, inward);
    for (int i = 0; i < 3; i++)
        fits = loft_sci_to_acc(along[i], &x[0][i]) && loft_sci_to_acc(inward[i], &x[1][i]) &&
               loft_sci_to_acc(across[i], &x[2][i]) && fits;
    for (int k = 0; k < 3; k++)
        fits = loft_vec_round(x[k], &unit[k]) && fits;
    for (int k = 0; k < 3 && fits; k++)
        frame[k] = unit[k];
    return fits ? LOFT_OK : LOFT_ERR_RANGE;
}

#else

enum loft_status loft_tangent_torsion(const loft_tangent *at, loft_acc *out)
{
    (void)at;
    (void)out;
    return LOFT_ERR_ARG;
}

enum loft_status loft_tangent_frenet(const loft_tangent *at, loft_vec frame[3])
{
    (void)at;
    (void)frame;
    return LOFT_ERR_ARG;
}

#endif
