/* lib/surface/pn.c
 * SPDX-License-Identifier: MIT
 *
 * With the foot f_ij = <P_j - P_i, N_i> / <N_i, N_i>
 *
 *     b at P_i toward P_j   = (2 P_i + P_j - f_ij N_i) / 3
 *     b111                  = E + (E - V) / 2
 *     n between P_i and P_j = N_i + N_j - 2 g (P_j - P_i)
 *     g                     = <P_j - P_i, N_i + N_j> / |P_j - P_i|^2
 *
 * E is the mean of the six edge points, V the mean of the corners. The normals in the last two
 * lines have length 1. |f N| is at most |P_j - P_i|. So the six are below 2^18 and b111 below 2^19
 * for any input.
 */
#include "surface/pn.h"
#include "geom/normal.h"            /* loft_vec_unit */
#include "num/sci.h"                /* loft_sci: normals of any length */

typedef struct {
    loft_sci axis[LOFT_AXES];
} sci_vec;

static sci_vec edge_vec(loft_vec from, loft_vec to)
{
    sci_vec e;

    for (int i = 0; i < LOFT_AXES; i++)
        e.axis[i] = loft_sci_sub(loft_sci_from_real(to.axis[i]), loft_sci_from_real(from.axis[i]));
    return e;
}

static loft_sci sci_dot(const sci_vec *a, const sci_vec *b)
{
    loft_sci sum = loft_sci_zero();

    for (int i = 0; i < LOFT_AXES; i++)
        sum = loft_sci_add(sum, loft_sci_mul(a->axis[i], b->axis[i]));
    return sum;
}

/* Set the control point at p toward q. */
static bool set_edge_point(loft_pn *t, unsigned place, loft_vec p, loft_vec q, loft_vec normal)
{
    const loft_vec origin = { { 0 } };
    const sci_vec e = edge_vec(p, q), n = edge_vec(origin, normal);
    const loft_sci foot = loft_sci_div(sci_dot(&e, &n), sci_dot(&n, &n));

    for (int i = 0; i < LOFT_AXES; i++) {
        loft_acc lift = 0;
        if (!loft_sci_to_acc(loft_sci_mul(foot, n.axis[i]), &lift))
            return false;
        t->b[i][place] = loft_acc_ratio(2 * loft_to_acc(p.axis[i]) + loft_to_acc(q.axis[i]) - lift,
                                        3);
        if (!loft_acc_valid(t->b[i][place]))
            return false;
    }
    return true;
}

/* Set the middle control point from the others. */
static bool set_middle(loft_pn *t)
{
    for (int i = 0; i < LOFT_AXES; i++) {
        loft_acc *b = t->b[i];
        const loft_acc ring = b[1] + b[2] + b[3] + b[5] + b[7] + b[8], corners = b[0] + b[6] + b[9];
        b[4] = loft_acc_ratio(3 * ring - 2 * corners, 12);
        if (!loft_acc_valid(b[4]))
            return false;
    }
    return true;
}

/* The normal between two corners: the sum of their normals, mirrored in the plane at a right angle
 * to the edge. Two corners in one point give the sum, and opposite normals that cancel give 0.
 * Neither affects the rest of the field. */
static loft_vec edge_normal(const loft_vec corner[3], const loft_vec n[3], int i, int j)
{
    const sci_vec e = edge_vec(corner[i], corner[j]);
    const loft_sci square = sci_dot(&e, &e);
    loft_acc h[LOFT_AXES];
    loft_vec out = { { 0 } };
    sci_vec sum;

    for (int a = 0; a < LOFT_AXES; a++)
        sum.axis[a] = loft_sci_add(loft_sci_from_real(n[i].axis[a]),
                                   loft_sci_from_real(n[j].axis[a]));
    const loft_sci along = sci_dot(&e, &sum);
    const loft_sci g = loft_sci_sign(square) > 0 ? loft_sci_div(loft_sci_add(along, along), square)
                                                 : loft_sci_zero();
    for (int a = 0; a < LOFT_AXES; a++)
        if (!loft_sci_to_acc(loft_sci_sub(sum.axis[a], loft_sci_mul(g, e.axis[a])), &h[a]))
            return out;                 /* never: a reflection keeps the length */
    return loft_vec_unit(h, &out) == LOFT_OK ? out : (loft_vec) { { 0 } };
}

enum loft_status loft_pn_init(loft_pn *t, const loft_vec corner[3], const loft_vec normal[3])
{
    /* at corner i toward corner j */
    static const uint8_t place[3][3] = { { 0, 1, 2 }, { 3, 6, 7 }, { 5, 8, 9 } };
    loft_vec n[3];

    for (int i = 0; i < 3; i++) {
        loft_acc wide[LOFT_AXES];
        if (!loft_vec_valid(corner[i]) || !loft_vec_valid(normal[i]))
            return LOFT_ERR_RANGE;
        for (int a = 0; a < LOFT_AXES; a++)
            wide[a] = loft_to_acc(normal[i].axis[a]);
        if (loft_vec_unit(wide, &n[i]) != LOFT_OK)
            return LOFT_SINGULAR;
    }
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            if (i == j)
                for (int a = 0; a < LOFT_AXES; a++)
                    t->b[a][place[i][i]] = loft_to_acc(corner[i].axis[a]);
            else if (!set_edge_point(t, place[i][j], corner[i], corner[j], normal[i]))
                return LOFT_ERR_RANGE;
    if (!set_middle(t))
        return LOFT_ERR_RANGE;
    t->n[0] = n[0];
    t->n[1] = edge_normal(corner, n, 0, 1);
    t->n[2] = edge_normal(corner, n, 0, 2);
    t->n[3] = n[1];
    t->n[4] = edge_normal(corner, n, 1, 2);
    t->n[5] = n[2];
    return LOFT_OK;
}

static loft_acc axis_at(const loft_pn *t, int axis, loft_bary u)
{
    loft_acc c[10];

    for (int k = 0; k < 10; k++)
        c[k] = t->b[axis][k];
    return loft_bary_eval(c, 3, u);
}

loft_vec loft_pn_eval(const loft_pn *t, loft_bary u)
{
    loft_vec v;

    u = loft_bary_clamp(u);
    for (int i = 0; i < LOFT_AXES; i++)
        v.axis[i] = loft_acc_round(axis_at(t, i, u));
    return v;
}

/* Control points err by 2^-32, which three rows multiply by L^3. The rows err by
 * 2^-33 (1 + L + L^2). */
enum loft_status loft_pn_extrapolate(const loft_pn *t, loft_bary u, loft_vec *out)
{
    loft_acc product = loft_to_acc(LOFT_REAL(1)), x[LOFT_AXES];

    if (!loft_bary_grows(u, false, 3, &product))
        return LOFT_ERR_RANGE;
    for (int i = 0; i < LOFT_AXES; i++)
        x[i] = axis_at(t, i, u);
    return loft_vec_round(x, out) ? LOFT_OK : LOFT_ERR_RANGE;
}

enum loft_status loft_pn_normal(const loft_pn *t, loft_bary u, loft_vec *out)
{
    loft_acc c[6], h[LOFT_AXES];

    u = loft_bary_clamp(u);
    for (int i = 0; i < LOFT_AXES; i++) {
        for (int k = 0; k < 6; k++)
            c[k] = loft_to_acc(t->n[k].axis[i]);
        h[i] = loft_bary_eval(c, 2, u);
    }
    return loft_vec_unit(h, out);
}

void loft_pn_net(const loft_pn *t, loft_vec out[10])
{
    for (int k = 0; k < 10; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            out[k].axis[i] = loft_acc_round(t->b[i][k]);
}
