/* lib/curve/knot_removal.c
 * SPDX-License-Identifier: MIT
 *
 * Let r be the last index of the knot u, s its multiplicity, p the degree. Inserting u once more
 * into the curve without it gives, for i = r - p .. r - s,
 *
 *     P_i = a_i Q_i + (1 - a_i) Q_(i-1)        a_i = (u - k_i) / (k_(i+p+1) - k_i)
 *
 * p - s + 1 equations for p - s points Q. They are solved from both ends, with Q_(r-p-1) and the
 * last one known, up to the middle. Where both ends give the same point it is the mean of both.
 *
 * The knot is then inserted again, in the same numbers. The two curves are on the same knots, and
 * their B-splines sum to 1: they are nowhere further apart than their control points.
 *
 * With weights w the equations are those of w P and w. Inserted again they give weights v and
 * points R. At each parameter, with the B-splines N and the point C of the given curve, the
 * difference is
 *
 *     sum N_i (v_i (R_i - P_i) + (v_i - w_i) (P_i - C))  /  sum N_i v_i
 *
 * As C is in the hull of the points of its spans, this is at most the largest of
 * |R_i - P_i| + |v_i - w_i| / v_i max |P_i - P_k|.
 */
#include "curve/knot_removal.h"

#include "num/sci.h"            /* loft_sci */

#define MOST (LOFT_DEGREE_MAX + 1)

#define HIGH (LOFT_AXES + 1)    /* coordinates times the weight, and the weight */

/* a[j] of P_(first + j), j = 0..count - 1; count - 1 points are sought. Points without weights, or
 * with. */
typedef struct {
    const loft_knots *n;
    const loft_vec *p;
    const loft_weighted *w;
    unsigned first, count;
    loft_sci a[MOST];
} gap;

static loft_sci difference(loft_real x, loft_real y)
{
    return loft_sci_of(loft_to_acc(x) - loft_to_acc(y));
}

static bool find_gap(const loft_knots *n, unsigned knot, gap *out)
{
    unsigned r = knot, times = 1;

    if (knot <= n->degree || knot >= n->points || !(n->k[knot] > n->k[n->degree]) ||
        !(n->k[knot] < n->k[n->points]))
        return false;
    while (!(n->k[r + 1] > n->k[r]))
        r++;
    while (!(n->k[r - times] < n->k[r]))
        times++;
    if (times > n->degree)
        return false;
    out->n = n;
    out->first = r - n->degree;
    out->count = n->degree - times + 1;
    for (unsigned j = 0; j < out->count; j++) {
        const unsigned i = out->first + j;
        out->a[j] = loft_sci_div(difference(n->k[r], n->k[i]),
                                 difference(n->k[i + n->degree + 1], n->k[i]));
    }
    return true;
}

static loft_sci coordinate_of(const gap *g, unsigned i, int axis)
{
    return loft_sci_from_real(g->w ? g->w[i].p.axis[axis] : g->p[i].axis[axis]);
}

/* Of P_i; `axis` LOFT_AXES is the weight. */
static loft_sci value_of(const gap *g, unsigned i, int axis)
{
    if (!g->w)
        return coordinate_of(g, i, axis);
    const loft_sci w = loft_sci_from_real(g->w[i].w);
    return axis == LOFT_AXES ? w : loft_sci_mul(w, coordinate_of(g, i, axis));
}

/* q[0] = P_(first - 1), q[1] .. q[count - 1] the new points, q[count] = P_(first + count). */
static void solve(const gap *g, int axis, loft_sci q[MOST + 1])
{
    const loft_sci one = loft_sci_one();
    unsigned i = 0, j = g->count - 1;
    loft_sci low = value_of(g, g->first - 1, axis), high = value_of(g, g->first + g->count, axis);

    q[0] = low;
    q[g->count] = high;
    for (; i < j; i++, j--) {
        const loft_sci left = loft_sci_sub(one, g->a[i]), right = loft_sci_sub(one, g->a[j]);
        low = loft_sci_div(loft_sci_sub_product(value_of(g, g->first + i, axis), left, low),
                           g->a[i]);
        high = loft_sci_div(loft_sci_sub_product(value_of(g, g->first + j, axis), g->a[j], high),
                            right);
        q[i + 1] = low;
        q[j] = i + 1 == j ? loft_sci_mul(loft_sci_power2(-1), loft_sci_add(low, high)) : high;
    }
}

static bool round_sci(loft_sci x, loft_real *out)
{
    loft_acc wide;

    if (!loft_sci_to_acc(x, &wide) || !loft_acc_valid(wide))
        return false;
    *out = loft_acc_round(wide);
    return true;
}

/* The new points, rounded, and those before and behind them; false if one does not fit. */
static bool round_points(const gap *g, loft_weighted out[MOST + 1])
{
    loft_sci q[HIGH][MOST + 1];
    bool fits = true;

    for (int axis = 0; axis < (g->w ? HIGH : LOFT_AXES); axis++)
        solve(g, axis, q[axis]);
    for (unsigned j = 0; j <= g->count; j++) {
        const bool kept = j == 0 || j == g->count;
        const unsigned i = j == 0 ? g->first - 1 : g->first + j;
        out[j].w = LOFT_REAL(1);
        if (kept && g->w)
            out[j] = g->w[i];
        else if (kept)
            out[j].p = g->p[i];
        else if (g->w)
            fits = fits && round_sci(q[LOFT_AXES][j], &out[j].w) && out[j].w >= LOFT_WEIGHT_MIN &&
                   out[j].w <= LOFT_WEIGHT_MAX;
        for (int axis = 0; axis < LOFT_AXES && fits && !kept; axis++)
            fits = round_sci(g->w ? loft_sci_div(q[axis][j], q[LOFT_AXES][j]) : q[axis][j],
                             &out[j].p.axis[axis]);
    }
    return fits;
}

static loft_sci size_of(const loft_sci x[LOFT_AXES])
{
    loft_sci sum = loft_sci_zero();

    for (int axis = 0; axis < LOFT_AXES; axis++)
        sum = loft_sci_add(sum, loft_sci_mul(x[axis], x[axis]));
    return loft_sci_sqrt(sum);
}

/* The largest distance of P_i from the points of the spans that change. */
static loft_sci reach_of(const gap *g, unsigned i)
{
    const unsigned degree = g->n->degree, from = g->first > degree ? g->first - degree : 0,
                   last = g->first + g->count + degree;
    loft_sci most = loft_sci_zero();

    for (unsigned k = from; k < last && k < g->n->points; k++) {
        loft_sci off[LOFT_AXES];
        for (int axis = 0; axis < LOFT_AXES; axis++)
            off[axis] = loft_sci_sub(coordinate_of(g, i, axis), coordinate_of(g, k, axis));
        most = loft_sci_larger(most, size_of(off));
    }
    return most;
}

/* The largest distance of P_i from what the new points give, and what the weights add. */
static bool distance_of(const gap *g, const loft_weighted q[MOST + 1], loft_acc *out)
{
    loft_sci most = loft_sci_zero();

    for (unsigned j = 0; j < g->count; j++) {
        const loft_sci v[2] = { loft_sci_from_real(q[j].w), loft_sci_from_real(q[j + 1].w) };
        const loft_sci weight = loft_sci_lerp(v[0], v[1], g->a[j]);
        loft_sci off[LOFT_AXES];
        for (int axis = 0; axis < LOFT_AXES; axis++) {
            loft_sci x[2] = { loft_sci_from_real(q[j].p.axis[axis]),
                              loft_sci_from_real(q[j + 1].p.axis[axis]) };
            for (int k = 0; k < 2 && g->w; k++)
                x[k] = loft_sci_mul(x[k], v[k]);
            const loft_sci at = loft_sci_lerp(x[0], x[1], g->a[j]);
            off[axis] = loft_sci_sub(g->w ? loft_sci_div(at, weight) : at,
                                     coordinate_of(g, g->first + j, axis));
        }
        loft_sci far = size_of(off);
        if (g->w) {
            const loft_sci more = loft_sci_sub(weight, loft_sci_from_real(g->w[g->first + j].w));
            far = loft_sci_add(far, loft_sci_mul(loft_sci_div(loft_sci_abs(more), weight),
                                                 reach_of(g, g->first + j)));
        }
        most = loft_sci_larger(most, far);
    }
    return loft_sci_to_acc(most, out);
}

/* Which new point stands at i; those that do not change come from i or, behind the gap, i + 1. */
static bool is_new(const gap *g, unsigned i)
{
    return i >= g->first && i + 1 < g->first + g->count;
}

static void write_knots(const loft_knots *n, unsigned knot, loft_real out[])
{
    const unsigned all = n->points + n->degree + 1u;

    for (unsigned i = 0; i + 1 < all; i++)
        out[i] = n->k[i < knot ? i : i + 1];
}

static enum loft_status remove_knot(gap *g, unsigned knot, const loft_knots *n,
                                    loft_weighted q[MOST + 1], loft_acc *far)
{
    loft_acc distance;

    if (!find_gap(n, knot, g))
        return LOFT_ERR_ARG;
    if (!round_points(g, q) || !distance_of(g, q, &distance))
        return LOFT_ERR_RANGE;
    *far = distance;
    return LOFT_OK;
}

enum loft_status loft_bspline_remove(const loft_bspline *b, unsigned knot, loft_vec p[],
                                     loft_real knots[], loft_acc *far)
{
    gap g = { .p = b->p };
    loft_weighted q[MOST + 1];
    const enum loft_status status = remove_knot(&g, knot, &b->knots, q, far);

    if (status != LOFT_OK)
        return status;
    for (unsigned i = 0; i + 1 < b->knots.points; i++)
        p[i] = is_new(&g, i) ? q[i - g.first + 1].p : b->p[i < g.first ? i : i + 1];
    write_knots(&b->knots, knot, knots);
    return LOFT_OK;
}

enum loft_status loft_nurbs_remove(const loft_nurbs *n, unsigned knot, loft_weighted p[],
                                   loft_real knots[], loft_acc *far)
{
    gap g = { .w = n->p };
    loft_weighted q[MOST + 1];
    const enum loft_status status = remove_knot(&g, knot, &n->knots, q, far);

    if (status != LOFT_OK)
        return status;
    for (unsigned i = 0; i + 1 < n->knots.points; i++)
        p[i] = is_new(&g, i) ? q[i - g.first + 1] : n->p[i < g.first ? i : i + 1];
    write_knots(&n->knots, knot, knots);
    return LOFT_OK;
}
