/* lib/surface/tensor/nurbs_surface.c
 * SPDX-License-Identifier: MIT
 *
 * With X = sum M_i(u) N_j(v) w_ij (p_ij - o) and w likewise without p - o, P = o + X / w for any o.
 * The rounded point is o, so Y = X / w is below one LSB, and
 *
 *     P_u  = (X_u - w_u Y) / w          P_uu = (X_uu - 2 w_u P_u - w_uu Y) / w
 *     P_uv = (X_uv - w_u P_v - w_v P_u - w_uv Y) / w
 *
 * P_u and P_v are independent if and only if the three vectors (X, w), (X_u, w_u), (X_v, w_v) are,
 * for any o: here o = 0. That is decided by remainders.
 */
#include "surface/tensor/nurbs_surface.h"
#include "basis/knots_basis.h"  /* loft_knots_basis */
#include "num/residue.h"        /* loft_residue */

#define MOST (LOFT_DEGREE_MAX + 1)
#define ORDERS 3

static enum loft_status init_knots(loft_nurbs_surface *s, unsigned rows, unsigned columns,
                                   const loft_real u[], unsigned degree_u, const loft_real v[],
                                   unsigned degree_v)
{
    const enum loft_status status = loft_knots_init(&s->u, u, rows, degree_u);
    return status == LOFT_OK ? loft_knots_init(&s->v, v, columns, degree_v) : status;
}

enum loft_status loft_nurbs_surface_init(loft_nurbs_surface *s, const loft_weighted p[],
                                         unsigned rows, unsigned columns, const loft_real u[],
                                         unsigned degree_u, const loft_real v[], unsigned degree_v)
{
    loft_nurbs_surface own = { .p = NULL, .weighted = p };
    int32_t scale;
    const enum loft_status status = init_knots(&own, rows, columns, u, degree_u, v, degree_v);

    if (status != LOFT_OK)
        return status;
    for (unsigned i = 0; i < rows; i++)
        if (loft_weighted_scale(p + (size_t)i * columns, columns, &scale) != LOFT_OK)
            return LOFT_ERR_RANGE;
    *s = own;
    return LOFT_OK;
}

enum loft_status loft_bspline_surface_init(loft_nurbs_surface *s, const loft_vec p[], unsigned rows,
                                           unsigned columns, const loft_real u[], unsigned degree_u,
                                           const loft_real v[], unsigned degree_v)
{
    loft_nurbs_surface own = { .p = p, .weighted = NULL };
    const enum loft_status status = init_knots(&own, rows, columns, u, degree_u, v, degree_v);

    if (status != LOFT_OK)
        return status;
    for (size_t i = 0; i < (size_t)rows * columns; i++)
        if (!loft_vec_valid(p[i]))
            return LOFT_ERR_RANGE;
    *s = own;
    return LOFT_OK;
}

static loft_real knots_share(const loft_knots *knots, loft_unit t)
{
    const loft_unit at = t > 0 ? t < LOFT_UNIT(1) ? t : LOFT_UNIT(1) : 0;

    return loft_acc_round(loft_acc_lerp(loft_to_acc(knots->k[knots->degree]),
                                        loft_to_acc(knots->k[knots->points]), at));
}

void loft_nurbs_surface_at(const loft_nurbs_surface *f, loft_unit s, loft_unit t, loft_real out[2])
{
    out[0] = knots_share(&f->u, s);
    out[1] = knots_share(&f->v, t);
}

/* The place: clamped parameters, their spans, and the B-splines with two derivatives. */
typedef struct {
    loft_real u, v;
    unsigned span_u, span_v;
    loft_sci by_u[ORDERS][MOST], by_v[ORDERS][MOST];
} spot;

static void find_spot(const loft_nurbs_surface *s, loft_real u, loft_real v, spot *at)
{
    at->u = loft_knots_clamp(&s->u, u);
    at->v = loft_knots_clamp(&s->v, v);
    at->span_u = loft_knots_find(&s->u, at->u);
    at->span_v = loft_knots_find(&s->v, at->v);
}

static void set_basis(const loft_nurbs_surface *s, spot *at)
{
    for (unsigned k = 0; k < ORDERS; k++) {
        loft_knots_basis(&s->u, at->span_u, at->u, k, at->by_u[k]);
        loft_knots_basis(&s->v, at->span_v, at->v, k, at->by_v[k]);
    }
}

/* Where in the net the control point (i, j) of the span is. */
static size_t place_of(const loft_nurbs_surface *s, const spot *at, unsigned i, unsigned j)
{
    const size_t row = at->span_u - s->u.degree + i, column = at->span_v - s->v.degree + j;
    return row * s->v.points + column;
}

static loft_real coordinate_of(const loft_nurbs_surface *s, size_t k, int axis)
{
    return s->p ? s->p[k].axis[axis] : s->weighted[k].p.axis[axis];
}

static loft_real weight_of(const loft_nurbs_surface *s, size_t k)
{
    return s->p ? LOFT_REAL(1) : s->weighted[k].w;
}

/* The derivative of the weighted coordinates relative to the origin, or of the weights, axis -1. */
static loft_sci net_sum(const loft_nurbs_surface *s, const spot *at, unsigned a, unsigned b,
                        int axis, loft_vec origin)
{
    loft_sci sum = loft_sci_zero();

    for (unsigned i = 0; i <= s->u.degree; i++) {
        loft_sci row = loft_sci_zero();
        for (unsigned j = 0; j <= s->v.degree; j++) {
            const size_t k = place_of(s, at, i, j);
            loft_sci term = at->by_v[b][j];
            if (s->weighted)
                term = loft_sci_mul(term, loft_sci_from_real(weight_of(s, k)));
            if (axis >= 0)
                term = loft_sci_mul(term,
                                    loft_sci_sub(loft_sci_from_real(coordinate_of(s, k, axis)),
                                                 loft_sci_from_real(origin.axis[axis])));
            row = loft_sci_add(row, term);
        }
        sum = loft_sci_add(sum, loft_sci_mul(at->by_u[a][i], row));
    }
    return sum;
}

static enum loft_status round_vec(const loft_sci x[], loft_vec *out)
{
    loft_acc wide[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        if (!loft_sci_to_acc(x[i], &wide[i]))
            return LOFT_ERR_RANGE;
    return loft_vec_round(wide, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

static enum loft_status point_at(const loft_nurbs_surface *s, const spot *at, loft_vec *out)
{
    const loft_vec zero = { { 0 } };
    const loft_sci w = net_sum(s, at, 0, 0, -1, zero);
    loft_sci x[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        x[i] = loft_sci_div(net_sum(s, at, 0, 0, i, zero), w);
    return round_vec(x, out);
}

enum loft_status loft_nurbs_surface_eval(const loft_nurbs_surface *s, loft_real u, loft_real v,
                                         loft_vec *out)
{
    spot at;

    find_spot(s, u, v, &at);
    set_basis(s, &at);
    return point_at(s, &at, out);
}

static enum loft_status nurbs_surface_at(const void *surface, loft_unit u, loft_unit v,
                                         loft_vec *out)
{
    const loft_nurbs_surface *s = (const loft_nurbs_surface *)surface;
    loft_real at[2];

    loft_nurbs_surface_at(s, u, v, at);
    return loft_nurbs_surface_eval(s, at[0], at[1], out);
}

static enum loft_status nurbs_slopes(const void *surface, loft_unit u, loft_unit v,
                                     loft_differential *out)
{
    const loft_nurbs_surface *s = (const loft_nurbs_surface *)surface;
    loft_real at[2];

    loft_nurbs_surface_at(s, u, v, at);
    return loft_nurbs_surface_differential(s, at[0], at[1], out);
}

loft_surface loft_surface_from_nurbs(const loft_nurbs_surface *s)
{
    const loft_surface made = { nurbs_surface_at, s, LOFT_SURFACE_SQUARE, nurbs_slopes };
    return made;
}

/* x = { value, u, v, uu, uv, vv } of X, in place to those of X / w. */
static void divide_by_weight(loft_sci x[6], const loft_sci w[6])
{
    const loft_sci two = loft_sci_from_int(2);

    x[0] = loft_sci_div(x[0], w[0]);
    x[1] = loft_sci_div(loft_sci_sub_product(x[1], w[1], x[0]), w[0]);
    x[2] = loft_sci_div(loft_sci_sub_product(x[2], w[2], x[0]), w[0]);
    x[3] = loft_sci_sub_product(loft_sci_sub_product(x[3], loft_sci_mul(two, w[1]), x[1]), w[3],
                                x[0]);
    x[4] = loft_sci_sub_product(
        loft_sci_sub_product(loft_sci_sub_product(x[4], w[1], x[2]), w[2], x[1]), w[4], x[0]);
    x[5] = loft_sci_sub_product(loft_sci_sub_product(x[5], loft_sci_mul(two, w[2]), x[2]), w[5],
                                x[0]);
    for (int i = 3; i < 6; i++)
        x[i] = loft_sci_div(x[i], w[0]);
}

static const uint8_t order_of[6][2] = {
    { 0, 0 }, { 1, 0 }, { 0, 1 }, { 2, 0 }, { 1, 1 }, { 0, 2 }
};

static enum loft_status fill_differential(const loft_nurbs_surface *s, const spot *at,
                                          loft_differential *out)
{
    loft_sci w[6], x[6];
    loft_vec origin;

    if (point_at(s, at, &origin) != LOFT_OK)
        return LOFT_ERR_RANGE;
    for (int o = 0; o < 6; o++)
        w[o] = net_sum(s, at, order_of[o][0], order_of[o][1], -1, origin);
    for (int i = 0; i < LOFT_AXES; i++) {
        for (int o = 0; o < 6; o++)
            x[o] = net_sum(s, at, order_of[o][0], order_of[o][1], i, origin);
        divide_by_weight(x, w);
        out->u[i] = x[1];
        out->v[i] = x[2];
        out->uu[i] = x[3];
        out->uv[i] = x[4];
        out->vv[i] = x[5];
    }
    out->width_u = out->width_v = loft_sci_zero();
    return LOFT_OK;
}

enum loft_status loft_nurbs_surface_deriv(const loft_nurbs_surface *s, unsigned j, unsigned k,
                                          loft_real u, loft_real v, loft_vec *out)
{
    loft_differential d;
    spot at;

    if (j > 2 || k > 2 || j + k > 2)
        return LOFT_ERR_ARG;
    find_spot(s, u, v, &at);
    set_basis(s, &at);
    if (j + k == 0)
        return point_at(s, &at, out);
    if (fill_differential(s, &at, &d) != LOFT_OK)
        return LOFT_ERR_RANGE;
    return round_vec(j == 2 ? d.uu : k == 2 ? d.vv : j == k ? d.uv : j == 1 ? d.u : d.v, out);
}


/* Tangent planes */

typedef struct {
    uint32_t u[2][MOST], v[2][MOST];
} residues;

static uint32_t residue_sum(const loft_nurbs_surface *s, const spot *at, const loft_residue *r,
                            const residues *n, unsigned order, int axis)
{
    const uint32_t *by_u = n->u[order_of[order][0]], *by_v = n->v[order_of[order][1]];
    uint32_t sum = 0;

    for (unsigned i = 0; i <= s->u.degree; i++)
        for (unsigned j = 0; j <= s->v.degree; j++) {
            const size_t k = place_of(s, at, i, j);
            uint32_t term = loft_residue_mul(r, by_u[i], by_v[j]);
            term = loft_residue_mul(r, term, loft_residue_real(r, weight_of(s, k)));
            if (axis >= 0)
                term = loft_residue_mul(r, term, loft_residue_real(r, coordinate_of(s, k, axis)));
            sum = loft_residue_add(r, sum, term);
        }
    return sum;
}

static bool numbers_exact(const loft_nurbs_surface *s, const spot *at)
{
    for (unsigned i = 0; i <= s->u.degree; i++)
        for (unsigned j = 0; j <= s->v.degree; j++) {
            const size_t k = place_of(s, at, i, j);
            if (!loft_exact_valid(weight_of(s, k)))
                return false;
            for (int axis = 0; axis < LOFT_AXES; axis++)
                if (!loft_exact_valid(coordinate_of(s, k, axis)))
                    return false;
        }
    for (unsigned i = 1; i <= 2u * s->u.degree; i++)
        if (!loft_exact_valid(s->u.k[at->span_u - s->u.degree + i]))
            return false;
    for (unsigned j = 1; j <= 2u * s->v.degree; j++)
        if (!loft_exact_valid(s->v.k[at->span_v - s->v.degree + j]))
            return false;
    return loft_exact_valid(at->u) && loft_exact_valid(at->v);
}

static bool residue_basis(const loft_nurbs_surface *s, const spot *at, const loft_residue *r,
                          residues *n)
{
    for (unsigned k = 0; k < 2; k++)
        if (!loft_knots_basis_residue(&s->u, at->span_u, at->u, k, r, n->u[k]) ||
            !loft_knots_basis_residue(&s->v, at->span_v, at->v, k, r, n->v[k]))
            return false;
    return true;
}

static bool plane_modulo(const loft_nurbs_surface *s, const spot *at, const loft_residue *r,
                         const residues *n)
{
    uint32_t rows[1 + LOFT_AXES][3];

    for (int axis = -1; axis < LOFT_AXES; axis++)
        for (unsigned order = 0; order < 3; order++)
            rows[axis + 1][order] = residue_sum(s, at, r, n, order, axis);
    return !loft_residue_dependent(r, rows, 1 + LOFT_AXES);
}

static bool regular_at(const loft_nurbs_surface *s, const spot *at)
{
    const unsigned one = loft_knots_basis_bits(&s->u) + loft_knots_basis_bits(&s->v) +
                         2 * LOFT_RESIDUE_REAL + 8;
    loft_residue r;
    residues n;

    if (!numbers_exact(s, at))
        return false;
    loft_residue_start(&r, 3 * one + 3);
    while (loft_residue_next(&r)) {
        if (!residue_basis(s, at, &r, &n))
            loft_residue_skip(&r);
        else if (plane_modulo(s, at, &r, &n))
            return true;
    }
    return false;
}

bool loft_nurbs_surface_regular(const loft_nurbs_surface *s, loft_real u, loft_real v)
{
    spot at;

    find_spot(s, u, v, &at);
    return regular_at(s, &at);
}

enum loft_status loft_nurbs_surface_differential(const loft_nurbs_surface *s, loft_real u,
                                                 loft_real v, loft_differential *out)
{
    spot at;

    find_spot(s, u, v, &at);
    if (!regular_at(s, &at))
        return LOFT_SINGULAR;
    set_basis(s, &at);
    return fill_differential(s, &at, out);
}


/* Spans */

/* The blossom of a span's polynomial at `from`, all but `ends` times, and `ends` times at `to`. c[]
 * is overwritten. */
static loft_sci blossom(const loft_knots *knots, unsigned span, unsigned ends, loft_sci c[])
{
    const unsigned degree = knots->degree;

    for (unsigned row = 1; row <= degree; row++)
        for (unsigned i = 0; i + row <= degree; i++) {
            const loft_sci low = loft_sci_from_real(knots->k[span - degree + row + i]),
                           high = loft_sci_from_real(knots->k[span + 1 + i]),
                           u = loft_sci_from_real(knots->k[row <= ends ? span + 1 : span]);
            c[i] = loft_sci_lerp(c[i], c[i + 1],
                                 loft_sci_div(loft_sci_sub(u, low), loft_sci_sub(high, low)));
        }
    return c[0];
}

/* From the coefficients of B-splines to those of Bernstein polynomials, every `stride`-th, in
 * place. */
static void make_bernstein(const loft_knots *knots, unsigned span, unsigned stride, loft_sci c[])
{
    loft_sci all[MOST], copy[MOST];

    for (unsigned k = 0; k <= knots->degree; k++)
        all[k] = c[k * stride];
    for (unsigned k = 0; k <= knots->degree; k++) {
        for (unsigned i = 0; i <= knots->degree; i++)
            copy[i] = all[i];
        c[k * stride] = blossom(knots, span, k, copy);
    }
}

/* A coordinate times the weight, of the patch on a span; axis LOFT_AXES: the weight. */
static void span_form(const loft_nurbs_surface *s, const unsigned span[2], int axis,
                      loft_sci c[MOST * MOST])
{
    const unsigned m = s->u.degree, n = s->v.degree;

    for (unsigned i = 0; i <= m; i++)
        for (unsigned j = 0; j <= n; j++) {
            const size_t k = (size_t)(span[0] - m + i) * s->v.points + span[1] - n + j;
            const loft_vec *p = s->weighted ? &s->weighted[k].p : &s->p[k];
            const loft_sci w = s->weighted ? loft_sci_from_real(s->weighted[k].w) : loft_sci_one();
            c[i * (n + 1) + j] = axis == LOFT_AXES
                                     ? w
                                     : loft_sci_mul(w, loft_sci_from_real(p->axis[axis]));
        }
    for (unsigned i = 0; i <= m; i++)
        make_bernstein(&s->v, span[1], 1, c + i * (n + 1));
    for (unsigned j = 0; j <= n; j++)
        make_bernstein(&s->u, span[0], n + 1, c + j);
}

static loft_real real_of(loft_sci x)
{
    loft_acc out = 0;
    /* in the hull of the points, or of the weights: it fits */
    return loft_sci_to_acc(x, &out) ? loft_acc_round(out) : 0;
}

static void span_patch(const loft_nurbs_surface *s, const unsigned span[2], loft_weighted out[])
{
    const unsigned count = (s->u.degree + 1u) * (s->v.degree + 1u);
    loft_sci c[MOST * MOST], w[MOST * MOST];

    span_form(s, span, LOFT_AXES, w);
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        span_form(s, span, axis, c);
        for (unsigned k = 0; k < count; k++)
            out[k].p.axis[axis] = real_of(s->weighted ? loft_sci_div(c[k], w[k]) : c[k]);
    }
    for (unsigned k = 0; k < count; k++)
        out[k].w = s->weighted ? loft_weight_clamp(real_of(w[k])) : LOFT_REAL(1);
}

bool loft_nurbs_surface_next(const loft_nurbs_surface *s, unsigned span[2], loft_weighted out[])
{
    const bool first = span[0] == 0;

    span[1] = loft_knots_next(&s->v, first ? 0 : span[1]);
    if (first || span[1] == 0)
        span[0] = loft_knots_next(&s->u, span[0]);
    if (span[0] != 0 && span[1] == 0)
        span[1] = loft_knots_next(&s->v, 0);
    if (span[0] != 0)
        span_patch(s, span, out);
    return span[0] != 0;
}
