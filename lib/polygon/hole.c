/* lib/polygon/hole.c -- nets of generalized Bezier patches from tangent planes along the sides
 * SPDX-License-Identifier: MIT
 *
 * Along side i with the edge E and the neighbour's derivative N the patch has the derivative across
 *
 *     D(s) = a(s) N(s) + b(s) E'(s)
 *
 * with linear a and b. It lies in the tangent plane of the neighbour everywhere. At its ends it
 * must be the derivative of the edges before and after: a and b are there the coordinates of these
 * in N and E'. With the second row V_j1 = V_j0 + D_j / degree, D in the Bernstein form of that
 * degree, the patch has the tangent plane of E' and D (polygon/gb.h). At the corner (1, 1) both
 * sides have a point of their own. Deeper rows continue both as ruled ribbons, V_jk = V_j0 + k
 * (V_j1 - V_j0).
 */
#include "polygon/hole.h"
#include "num/sci.h"            /* loft_sci */

#define LEAST_PLANE (-24)       /* log2 of the square of the sine between N and E' */
#define POINTS (LOFT_DEGREE_MAX + 1)

static loft_sci hole_dot(const loft_sci a[3], const loft_sci b[3])
{
    return loft_sci_add(loft_sci_add(loft_sci_mul(a[0], b[0]), loft_sci_mul(a[1], b[1])),
                        loft_sci_mul(a[2], b[2]));
}

/* The derivative of a curve at its start or end: degree times a difference. */
static void hole_slope(const loft_bezier *b, bool end, loft_sci out[3])
{
    const unsigned k = end ? b->degree : 1u;

    for (int i = 0; i < 3; i++)
        out[i] = loft_sci_mul(loft_sci_from_int(b->degree),
                              loft_sci_sub(loft_sci_from_real(loft_vec_axis(&b->p[k], i)),
                                           loft_sci_from_real(loft_vec_axis(&b->p[k - 1], i))));
}

static void hole_across(const loft_bezier *b, bool end, loft_sci out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = loft_sci_from_real(loft_vec_axis(&b->p[end ? b->degree : 0], i));
}

/* Coordinates of the next edge in N and E' at one end of a side, and the square of the sine of its
 * angle with their plane. */
typedef struct {
    loft_sci a, b, off;
} corner_fit;

static bool fit_corner(const loft_sci n[3], const loft_sci e[3], const loft_sci t[3],
                       corner_fit *out)
{
    const loft_sci nn = hole_dot(n, n), ne = hole_dot(n, e), ee = hole_dot(e, e),
                   nt = hole_dot(n, t), et = hole_dot(e, t), tt = hole_dot(t, t),
                   both = loft_sci_mul(nn, ee), det = loft_sci_sub(both, loft_sci_mul(ne, ne));
    loft_sci rest = loft_sci_zero();

    if (!loft_sci_less(loft_sci_mul(both, loft_sci_power2(LEAST_PLANE)), det) ||
        loft_sci_sign(tt) == 0)
        return false;
    out->a = loft_sci_div(loft_sci_sub(loft_sci_mul(ee, nt), loft_sci_mul(ne, et)), det);
    out->b = loft_sci_div(loft_sci_sub(loft_sci_mul(nn, et), loft_sci_mul(ne, nt)), det);
    for (int i = 0; i < 3; i++) {
        const loft_sci x = loft_sci_sub(
            t[i], loft_sci_add(loft_sci_mul(out->a, n[i]), loft_sci_mul(out->b, e[i])));
        rest = loft_sci_add(rest, loft_sci_mul(x, x));
    }
    out->off = loft_sci_div(rest, tt);
    return loft_sci_sign(out->a) > 0;
}

/* The Bernstein coefficients of one degree more, in place. */
static void raise_once(loft_sci c[], unsigned degree)
{
    const loft_sci n = loft_sci_from_int((int32_t)degree + 1);

    c[degree + 1] = c[degree];
    for (unsigned k = degree; k > 0; k--)
        c[k] = loft_sci_lerp(c[k], c[k - 1], loft_sci_div(loft_sci_from_int((int32_t)k), n));
}

/* (linear from x to y) times c, of one degree more, in place. */
static void times_line(loft_sci c[], unsigned degree, loft_sci x, loft_sci y)
{
    const loft_sci n = loft_sci_from_int((int32_t)degree + 1);

    c[degree + 1] = loft_sci_zero();
    for (unsigned k = degree + 2; k-- > 0; ) {
        const loft_sci share = loft_sci_div(loft_sci_from_int((int32_t)k), n);
        const loft_sci from = loft_sci_mul(loft_sci_sub(loft_sci_one(), share),
                                           loft_sci_mul(x, c[k]));
        c[k] = k == 0 ? from : loft_sci_add(from, loft_sci_mul(share, loft_sci_mul(y, c[k - 1])));
    }
}

/* One axis of D in the Bernstein form of `degree`. */
static void across_axis(const loft_hole_side *s, const corner_fit fit[2], unsigned degree, int axis,
                        loft_sci out[POINTS])
{
    loft_sci slope[POINTS + 1];
    unsigned n = s->across.degree, m = s->edge.degree;

    for (unsigned k = 0; k <= n; k++)
        out[k] = loft_sci_from_real(loft_vec_axis(&s->across.p[k], axis));
    for (unsigned k = 0; k < m; k++)
        slope[k] = loft_sci_mul(
            loft_sci_from_int((int32_t)m),
            loft_sci_sub(loft_sci_from_real(loft_vec_axis(&s->edge.p[k + 1], axis)),
                         loft_sci_from_real(loft_vec_axis(&s->edge.p[k], axis))));
    times_line(out, n, fit[0].a, fit[1].a);
    times_line(slope, m - 1, fit[0].b, fit[1].b);
    for (n++; n < degree; n++)
        raise_once(out, n);
    for (; m < degree; m++)
        raise_once(slope, m);
    for (unsigned k = 0; k <= degree; k++)
        out[k] = loft_sci_add(out[k], slope[k]);
}

/* The place of the second row: that of the net, or of the split corner at its end. */
static loft_vec *second_row(unsigned sides, unsigned degree, unsigned i, unsigned j, loft_vec out[],
                            loft_vec split[])
{
    return j + 1 == degree ? &split[(i + 1) % sides] : &out[loft_gb_place(sides, degree, i, j, 1)];
}

static bool hole_valid(const loft_hole_side side[], unsigned sides, unsigned degree)
{
    if (LOFT_AXES < 3 || sides < 3 || sides > LOFT_SIDES_MAX || degree < 3 ||
        degree > LOFT_DEGREE_MAX)
        return false;
    for (unsigned i = 0; i < sides; i++) {
        const loft_bezier *e = &side[i].edge, *next = &side[(i + 1) % sides].edge;
        if (e->degree < 1 || e->degree > degree || side[i].across.degree >= degree ||
            !loft_vec_equal(e->p[e->degree], next->p[0]))
            return false;
    }
    return true;
}

/* The first row of side i, and its second one, from the edges before and after. */
static enum loft_status fill_side(const loft_hole_side side[], unsigned sides, unsigned degree,
                                  unsigned i, loft_vec out[], loft_vec split[], loft_sci *worst)
{
    const loft_bezier *next = &side[(i + 1) % sides].edge,
                      *last = &side[(i + sides - 1) % sides].edge;
    loft_sci d[POINTS], n[3], e[3], t[3];
    loft_vec edge[LOFT_BEZIER_ELEVATE_MAX + 1];
    corner_fit fit[2];
    loft_acc x;

    for (unsigned end = 0; end < 2; end++) {
        hole_across(&side[i].across, end, n);
        hole_slope(&side[i].edge, end, e);
        hole_slope(end ? next : last, !end, t);
        for (int k = 0; k < 3 && !end; k++)
            t[k] = loft_sci_neg(t[k]);
        if (!fit_corner(n, e, t, &fit[end]))
            return LOFT_SINGULAR;
        if (loft_sci_less(*worst, fit[end].off))
            *worst = fit[end].off;
    }
    const enum loft_status status = loft_bezier_elevate(&side[i].edge, degree - side[i].edge.degree,
                                                        edge);
    if (status != LOFT_OK)
        return status;
    for (unsigned j = 0; j < degree; j++)
        out[loft_gb_place(sides, degree, i, j, 0)] = edge[j];
    for (int axis = 0; axis < LOFT_AXES; axis++) {
        across_axis(&side[i], fit, degree, axis, d);
        for (unsigned j = 1; j < degree; j++) {
            const loft_sci moved = loft_sci_add(
                loft_sci_from_real(edge[j].axis[axis]),
                loft_sci_div(d[j], loft_sci_from_int((int32_t)degree)));
            if (!loft_sci_to_acc(moved, &x) || !loft_acc_valid(x))
                return LOFT_ERR_RANGE;
            second_row(sides, degree, i, j, out, split)->axis[axis] = loft_acc_round(x);
        }
    }
    return LOFT_OK;
}

/* V_j0 + k (V_j1 - V_j0) of side i. */
static void ruled_point(unsigned sides, unsigned degree, unsigned i, unsigned j, unsigned k,
                        loft_vec out[], loft_vec split[], loft_acc x[LOFT_AXES])
{
    const loft_vec *from = &out[loft_gb_place(sides, degree, i, j, 0)],
                   *to = second_row(sides, degree, i, j, out, split);

    for (int axis = 0; axis < LOFT_AXES; axis++)
        x[axis] = loft_to_acc(from->axis[axis]) +
                  (int32_t)k * (loft_to_acc(to->axis[axis]) - loft_to_acc(from->axis[axis]));
}

/* Point (a, b) of a corner, a and b from 2 on, belongs to the ribbon to which it is closer; with
 * a = b to both, halfway. */
static enum loft_status deeper_point(unsigned sides, unsigned degree, unsigned corner, unsigned a,
                                     unsigned b, loft_vec out[], loft_vec split[])
{
    const unsigned before = (corner + sides - 1) % sides;
    loft_acc x[LOFT_AXES], y[LOFT_AXES];

    ruled_point(sides, degree, corner, a, b, out, split, x);
    ruled_point(sides, degree, before, degree - b, a, out, split, y);
    for (int axis = 0; axis < LOFT_AXES; axis++)
        x[axis] = a > b ? x[axis] : a < b ? y[axis] : loft_acc_ratio(x[axis] + y[axis], 2);
    return loft_vec_round(x, &out[loft_gb_place(sides, degree, corner, a, b)]) ? LOFT_OK
                                                                               : LOFT_ERR_RANGE;
}

enum loft_status loft_gb_from_hole(const loft_hole_side side[], unsigned sides, unsigned degree,
                                   loft_vec out[], loft_vec split[], loft_acc *gap)
{
    loft_sci worst = loft_sci_zero();
    enum loft_status status = hole_valid(side, sides, degree) ? LOFT_OK : LOFT_ERR_ARG;

    for (unsigned i = 0; i < sides && status == LOFT_OK; i++)
        status = fill_side(side, sides, degree, i, out, split, &worst);
    for (unsigned i = 0; i < sides && status == LOFT_OK; i++)
        for (unsigned a = 2; a <= degree / 2; a++)
            for (unsigned b = 2; b < (degree + 1) / 2 && status == LOFT_OK; b++)
                status = deeper_point(sides, degree, i, a, b, out, split);
    if (status == LOFT_OK)
        status = loft_gb_middle(out, sides, degree, &out[loft_gb_count(sides, degree) - 1]);
    return status != LOFT_OK                                   ? status
           : loft_sci_to_acc(loft_sci_sqrt(worst), gap) ? LOFT_OK
                                                        : LOFT_ERR_RANGE;
}
