/* lib/surface/net_cell.c
 * SPDX-License-Identifier: MIT
 *
 * With N, W the numerator and the weight of a surface, seen from the middle of the first, the
 * surfaces meet where F = N_a W_b - N_b W_a = 0: three equations in four parameters. In the middle
 * of the cell F is F0, its derivative J_j. The free parameter f is the one that the curve of
 * solutions follows most: where the determinant of the other three columns is largest. With the
 * inverse M of these, h = M F has the derivatives 1 by the others, c = M J_f by the free one, and
 * a_ij bounds how far M dF_i differs from that anywhere in the cell, from the legs of the nets.
 *
 *     |h_i - M F0_i - (x_i - 1/2) - c_i (f - 1/2)| <= e_i = sum over j of a_ij / 2
 *
 * A place where they meet has therefore x_i = 1/2 - M F0_i - c_i (f - 1/2) -+ e_i, which limits f
 * or excludes the cell. If the a_ij of the three sum to less than 1 in each row, no two points with
 * the same f have the same h.
 *
 * The control points over their weights contain the parts. They are apart if boxes are, or their
 * extents along the normal of either in its middle.
 */
#include "surface/net_cell.h"

#if LOFT_AXES >= 3

typedef struct {
    loft_sci low, high;
} extent;

static extent extent_times(extent a, extent b)
{
    const loft_sci p = loft_sci_mul(a.low, b.low), q = loft_sci_mul(a.low, b.high),
                   r = loft_sci_mul(a.high, b.low), s = loft_sci_mul(a.high, b.high);
    const extent out = { loft_sci_smaller(loft_sci_smaller(p, q), loft_sci_smaller(r, s)),
                         loft_sci_larger(loft_sci_larger(p, q), loft_sci_larger(r, s)) };
    return out;
}

/* The largest magnitude in a b - c d - x. */
static loft_sci off_by(extent a, extent b, extent c, extent d, loft_sci x)
{
    const extent p = extent_times(a, b), q = extent_times(c, d);
    const loft_sci low = loft_sci_sub(loft_sci_sub(p.low, q.high), x),
                   high = loft_sci_sub(loft_sci_sub(p.high, q.low), x);
    return loft_sci_larger(loft_sci_abs(low), loft_sci_abs(high));
}

static extent extent_of(const loft_sci_net *x)
{
    extent out = { x->c[0][0], x->c[0][0] };

    for (unsigned i = 0; i <= x->m; i++)
        for (unsigned j = 0; j <= x->n; j++) {
            out.low = loft_sci_smaller(out.low, x->c[i][j]);
            out.high = loft_sci_larger(out.high, x->c[i][j]);
        }
    return out;
}

/* Of the derivative by u or v. */
static extent legs_of(const loft_sci_net *x, bool by_u)
{
    const unsigned degree = by_u ? x->m : x->n;
    const loft_sci factor = loft_sci_from_int((int32_t)degree);
    extent out = { loft_sci_zero(), loft_sci_zero() };

    for (unsigned i = by_u; i <= x->m && degree > 0; i++)
        for (unsigned j = !by_u; j <= x->n; j++) {
            const loft_sci before = by_u ? x->c[i - 1][j] : x->c[i][j - 1],
                           leg = loft_sci_mul(factor, loft_sci_sub(x->c[i][j], before));
            const bool first = i == by_u && j == !by_u;
            out.low = first ? leg : loft_sci_smaller(out.low, leg);
            out.high = first ? leg : loft_sci_larger(out.high, leg);
        }
    return out;
}

/* The sum of m[axis] times the coordinates. */
static void combine(const loft_net_form *f, const loft_sci m[3], loft_sci_net *out)
{
    out->m = f->axis[0].m;
    out->n = f->axis[0].n;
    for (unsigned i = 0; i <= out->m; i++)
        for (unsigned j = 0; j <= out->n; j++) {
            loft_sci sum = loft_sci_mul(m[0], f->axis[0].c[i][j]);
            for (int axis = 1; axis < 3; axis++)
                sum = loft_sci_add(sum, loft_sci_mul(m[axis], f->axis[axis].c[i][j]));
            out->c[i][j] = sum;
        }
}

/* True if the determinant of three columns is larger than 2^-30 of the product of their sizes. */
static bool is_regular(loft_sci column[3][3], loft_sci det)
{
    loft_sci size = loft_sci_power2(-30);

    for (int k = 0; k < 3; k++)
        size = loft_sci_mul(size, loft_sci_sqrt(loft_sci_dot3(column[k], column[k])));
    return loft_sci_less(size, loft_sci_abs(det));
}

bool loft_sci_solve3(loft_sci column[3][3], const loft_sci d[3], loft_sci out[3])
{
    loft_sci n[3][3];

    for (int k = 0; k < 3; k++)
        loft_sci_cross3(column[(k + 1) % 3], column[(k + 2) % 3], n[k]);
    const loft_sci det = loft_sci_dot3(column[0], n[0]);
    if (!is_regular(column, det))
        return false;
    for (int k = 0; k < 3; k++)
        out[k] = loft_sci_div(loft_sci_dot3(d, n[k]), det);
    return true;
}


// Apart
// -----

static bool are_apart(extent a, extent b)
{
    const loft_sci size = loft_sci_larger(
        loft_sci_larger(loft_sci_abs(a.low), loft_sci_abs(a.high)),
        loft_sci_larger(loft_sci_abs(b.low), loft_sci_abs(b.high)));
    const loft_sci noise = loft_sci_mul(size, loft_sci_power2(-44));
    return loft_sci_less(loft_sci_add(a.high, noise), b.low) ||
           loft_sci_less(loft_sci_add(b.high, noise), a.low);
}

/* The nets of the parts as points, without weights: along the axes, then along the normals. */
static bool hulls_are_apart(const loft_net_form points[2], loft_sci normal[2][3])
{
    loft_sci_net a, b;

    for (int axis = 0; axis < 3; axis++)
        if (are_apart(extent_of(&points[0].axis[axis]), extent_of(&points[1].axis[axis])))
            return true;
    for (int k = 0; k < 2; k++) {
        combine(&points[0], normal[k], &a);
        combine(&points[1], normal[k], &b);
        if (are_apart(extent_of(&a), extent_of(&b)))
            return true;
    }
    return false;
}

/* The longest leg along each parameter, times the degree. */
static void measure_legs(const loft_net_form points[2], loft_net_cell *out)
{
    loft_sci most = loft_sci_neg(loft_sci_one());

    out->size = loft_sci_zero();
    for (unsigned k = 0; k < 4; k++) {
        loft_sci leg = loft_sci_zero();
        for (int axis = 0; axis < 3; axis++) {
            const extent e = legs_of(&points[k / 2].axis[axis], k % 2 == 0);
            leg = loft_sci_larger(leg, loft_sci_larger(loft_sci_abs(e.low), loft_sci_abs(e.high)));
        }
        if (loft_sci_less(most, leg)) {
            most = leg;
            out->longest = k;
        }
        out->size = loft_sci_larger(out->size, leg);
    }
}


// Once
// ----

/* Both parts seen from the middle of the first; F and its derivatives in the middle. */
typedef struct {
    const loft_net_form *part;          /* two */
    loft_sci f[3], column[4][3];
    extent weight[2], by[4];            /* of the weights, and of their derivatives */
} system;

static void see_from(loft_net_form *x, const loft_sci origin[3])
{
    for (int axis = 0; axis < 3; axis++)
        for (unsigned i = 0; i <= x->axis[axis].m; i++)
            for (unsigned j = 0; j <= x->axis[axis].n; j++) {
                const loft_sci by = x->weighted ? loft_sci_mul(origin[axis], x->w.c[i][j])
                                                : origin[axis];
                x->axis[axis].c[i][j] = loft_sci_sub(x->axis[axis].c[i][j], by);
            }
}

static void load_system(const loft_net_form part[2], system *z)
{
    const loft_sci half = loft_sci_power2(-1), zero = loft_sci_zero(), one = loft_sci_one();
    loft_sci n[2][3][3], w[2][3];                       /* value, by u, by v */

    z->part = part;
    for (int k = 0; k < 2; k++) {
        for (unsigned d = 0; d < 3; d++) {
            for (int axis = 0; axis < 3; axis++)
                n[k][d][axis] = loft_sci_net_deriv(&part[k].axis[axis], d == 1, d == 2, half, half);
            w[k][d] = part[k].weighted ? loft_sci_net_deriv(&part[k].w, d == 1, d == 2, half, half)
                      : d == 0         ? one
                                       : zero;
        }
        z->weight[k].low = z->weight[k].high = one;
        for (int d = 0; d < 2; d++)
            z->by[2 * k + d].low = z->by[2 * k + d].high = zero;
        if (part[k].weighted) {
            z->weight[k] = extent_of(&part[k].w);
            z->by[2 * k] = legs_of(&part[k].w, true);
            z->by[2 * k + 1] = legs_of(&part[k].w, false);
        }
    }
    for (int axis = 0; axis < 3; axis++) {
        z->f[axis] = loft_sci_sub(loft_sci_mul(n[0][0][axis], w[1][0]),
                                  loft_sci_mul(n[1][0][axis], w[0][0]));
        for (int d = 1; d < 3; d++) {
            z->column[d - 1][axis] = loft_sci_sub(loft_sci_mul(n[0][d][axis], w[1][0]),
                                                  loft_sci_mul(n[1][0][axis], w[0][d]));
            z->column[1 + d][axis] = loft_sci_sub(loft_sci_mul(n[0][0][axis], w[1][d]),
                                                  loft_sci_mul(n[1][d][axis], w[0][0]));
        }
    }
}

/* The free parameter, and the inverse of the other columns by rows; false if they have none. A
 * curve leaves its second parameter free. */
static bool invert(const system *z, unsigned *loose, loft_sci inverse[3][3])
{
    loft_sci column[3][3], best = loft_sci_zero();
    const bool curve = z->part[0].axis[0].n == 0;

    *loose = 1;
    for (unsigned k = 0; k < 4 && !curve; k++) {
        loft_sci n[3];
        loft_sci_cross3(z->column[(k + 1) % 4], z->column[(k + 2) % 4], n);
        const loft_sci det = loft_sci_abs(loft_sci_dot3(n, z->column[(k + 3) % 4]));
        if (loft_sci_less(best, det)) {
            best = det;
            *loose = k;
        }
    }
    for (unsigned k = 0, i = 0; k < 4; k++)
        for (int axis = 0; axis < 3 && k != *loose; axis++) {
            column[i][axis] = z->column[k][axis];
            i += axis == 2;
        }
    for (int k = 0; k < 3; k++)
        loft_sci_cross3(column[(k + 1) % 3], column[(k + 2) % 3], inverse[k]);
    const loft_sci det = loft_sci_dot3(column[0], inverse[0]);
    if (!is_regular(column, det))
        return false;
    for (int k = 0; k < 3; k++)
        for (int axis = 0; axis < 3; axis++)
            inverse[k][axis] = loft_sci_div(inverse[k][axis], det);
    return true;
}

/* e_i of a row of h, and whether its a_ij of the three leave it a root at most. */
static loft_sci row_error(const system *z, unsigned loose, const loft_sci row[3], bool *once)
{
    const loft_sci half = loft_sci_power2(-1);
    loft_sci three = loft_sci_zero(), all = three;
    loft_sci_net net[2];
    extent value[2];

    for (int k = 0; k < 2; k++) {
        combine(&z->part[k], row, &net[k]);
        value[k] = extent_of(&net[k]);
    }
    for (unsigned j = 0; j < 4; j++) {
        const unsigned k = j / 2;
        const extent legs = legs_of(&net[k], j % 2 == 0);
        const loft_sci x = loft_sci_dot3(row, z->column[j]);
        const loft_sci a = k == 0 ? off_by(legs, z->weight[1], value[1], z->by[j], x)
                                  : off_by(value[0], z->by[j], legs, z->weight[0], x);
        all = loft_sci_add(all, a);
        if (j != loose)
            three = loft_sci_add(three, a);
    }
    *once = *once && loft_sci_less(three, loft_sci_sub(loft_sci_one(), loft_sci_power2(-10)));
    const loft_sci size = loft_sci_larger(
        loft_sci_larger(loft_sci_abs(value[0].low), loft_sci_abs(value[0].high)),
        loft_sci_larger(loft_sci_abs(value[1].low), loft_sci_abs(value[1].high)));
    return loft_sci_add(loft_sci_mul(all, half), loft_sci_mul(size, loft_sci_power2(-30)));
}

/* Limit f by low <= start + slope f <= high; to an empty interval if there is none. */
static void limit(loft_sci start, loft_sci slope, loft_sci low, loft_sci high, loft_sci *from,
                  loft_sci *to)
{
    const loft_sci a = loft_sci_sub(low, start), b = loft_sci_sub(high, start);
    const loft_sci flat = loft_sci_power2(-40);

    if (loft_sci_less(loft_sci_abs(slope), flat)) {
        if (loft_sci_less(flat, a) || loft_sci_less(b, loft_sci_neg(flat)))
            *to = loft_sci_sub(*from, loft_sci_one());
        return;
    }
    const loft_sci x = loft_sci_div(a, slope), y = loft_sci_div(b, slope);
    *from = loft_sci_larger(*from, loft_sci_smaller(x, y));
    *to = loft_sci_smaller(*to, loft_sci_larger(x, y));
}

static enum loft_net_known limit_cell(const system *z, loft_sci inverse[3][3], loft_net_cell *out)
{
    const loft_sci half = loft_sci_power2(-1), one = loft_sci_one(), slack = loft_sci_power2(-30);
    loft_sci errors = loft_sci_zero();
    bool once = true;

    out->from = out->sure_from = loft_sci_zero();
    out->to = out->sure_to = one;
    for (unsigned k = 0, i = 0; k < 4; k++) {
        if (k == out->loose)
            continue;
        const loft_sci error = row_error(z, out->loose, inverse[i], &once);
        errors = loft_sci_add(errors, error);
        const loft_sci slope = loft_sci_neg(loft_sci_dot3(inverse[i], z->column[out->loose]));
        const loft_sci middle = loft_sci_sub(half, loft_sci_dot3(inverse[i], z->f));
        const loft_sci start = loft_sci_sub(middle, loft_sci_mul(slope, half));
        const loft_sci wide = loft_sci_add(error, slack), high = loft_sci_add(one, wide);
        out->start[k] = start;
        out->slope[k] = slope;
        limit(start, slope, loft_sci_neg(wide), high, &out->from, &out->to);
        limit(start, slope, error, loft_sci_sub(one, error), &out->sure_from, &out->sure_to);
        if (!loft_sci_less(error, half))
            out->sure_to = loft_sci_neg(one);
        i++;
    }
    out->start[out->loose] = loft_sci_zero();
    out->slope[out->loose] = one;
    out->spread = loft_sci_mul(loft_sci_mul(errors, out->size), loft_sci_from_int(2));
    return loft_sci_less(out->to, out->from) ? LOFT_NET_APART
           : once                            ? LOFT_NET_ONCE
                                             : LOFT_NET_OPEN;
}

/* How fast the place moves on the first surface. */
static loft_sci speed_of(loft_sci jet[LOFT_NET_JET][LOFT_AXES], const loft_net_cell *cell)
{
    loft_sci sum[3];

    for (int axis = 0; axis < 3; axis++)
        sum[axis] = loft_sci_add(loft_sci_mul(cell->slope[0], jet[LOFT_NET_BY_X][axis]),
                                 loft_sci_mul(cell->slope[1], jet[LOFT_NET_BY_Y][axis]));
    return loft_sci_sqrt(loft_sci_dot3(sum, sum));
}

/* True if the hulls of the control points over their weights are apart. If not, their legs are
 * measured. Four nets are too much for one frame: 32 kB with six axes on an AVR. */
#if defined(__GNUC__)
__attribute__((noinline))
#endif
static bool
points_are_apart(const loft_net_form part[2], loft_sci normal[2][3], loft_net_cell *out)
{
    loft_net_form points[2];

    for (int k = 0; k < 2; k++) {
        points[k] = part[k];
        loft_net_form_points(&points[k]);
    }
    if (hulls_are_apart(points, normal))
        return true;
    measure_legs(points, out);
    return false;
}

enum loft_net_known loft_net_cell_decide(const loft_net_form *a, const loft_net_form *b,
                                         const loft_dyad_box *pair, loft_net_cell *out)
{
    const loft_sci half = loft_sci_power2(-1);
    loft_sci jet[2][LOFT_NET_JET][LOFT_AXES], normal[2][3], inverse[3][3];
    loft_net_form part[2];
    system z;

    for (int k = 0; k < 2; k++) {
        loft_net_form_sub(k ? b : a, &pair->n[2 * k], &part[k]);
        loft_net_form_jet(&part[k], 1, half, half, jet[k]);
        loft_sci_cross3(jet[k][LOFT_NET_BY_X], jet[k][LOFT_NET_BY_Y], normal[k]);
    }
    if (points_are_apart(part, normal, out))
        return LOFT_NET_APART;
    for (int k = 0; k < 2; k++)
        see_from(&part[k], jet[0][LOFT_NET_POINT]);
    load_system(part, &z);
    if (!invert(&z, &out->loose, inverse))
        return LOFT_NET_OPEN;
    const enum loft_net_known known = limit_cell(&z, inverse, out);
    out->speed = speed_of(jet[0], out);
    return known;
}

#endif
