/* lib/geom/vec.h -- points of LOFT_AXES coordinates, and boxes of points
 * SPDX-License-Identifier: MIT
 *
 * Small structs, passed and returned by value. Sums and differences are plain C: they must fit a
 * loft_real, which holds for coordinates within half its range (q16: +-16384).
 */
#ifndef LOFT_GEOM_VEC_H
#define LOFT_GEOM_VEC_H

#include "num/accs.h"   /* loft_accs_from */
#include "num/num.h"    /* loft_real, loft_lerp */

typedef struct {
    loft_real axis[LOFT_AXES];
} loft_vec;

typedef struct {
    loft_vec min, max;
} loft_box;

/* The coordinate of an axis, 0 for axes beyond LOFT_AXES: every build has a plane. */
static inline loft_real loft_vec_axis(const loft_vec *a, int axis)
{
    return axis < LOFT_AXES ? a->axis[axis < LOFT_AXES ? axis : 0] : 0;
}

static inline loft_vec loft_vec_add(loft_vec a, loft_vec b)
{
    for (int i = 0; i < LOFT_AXES; i++)
        a.axis[i] += b.axis[i];
    return a;
}

static inline loft_vec loft_vec_sub(loft_vec a, loft_vec b)
{
    for (int i = 0; i < LOFT_AXES; i++)
        a.axis[i] -= b.axis[i];
    return a;
}

/*   range   t in 0..1, any points
 *   error   q16: 1/2 LSB   f32, f64: 2 ulp of the larger coordinate; none at t = 0 and 1 */
static inline loft_vec loft_vec_lerp(loft_vec a, loft_vec b, loft_unit t)
{
    for (int i = 0; i < LOFT_AXES; i++)
        a.axis[i] = loft_lerp(a.axis[i], b.axis[i], t);
    return a;
}

static inline bool loft_vec_equal(loft_vec a, loft_vec b)
{
    for (int i = 0; i < LOFT_AXES; i++)
        if (a.axis[i] < b.axis[i] || b.axis[i] < a.axis[i])
            return false;
    return true;
}

/* Round wide coordinates to a point if all fit; *out is untouched otherwise. */
static inline bool loft_vec_round(const loft_acc x[LOFT_AXES], loft_vec *out)
{
    for (int i = 0; i < LOFT_AXES; i++)
        if (!loft_acc_valid(x[i]))
            return false;
    for (int i = 0; i < LOFT_AXES; i++)
        out->axis[i] = loft_acc_round(x[i]);
    return true;
}

/* Round one axis of `count` points if all fit; undefined otherwise. */
static inline bool loft_vec_round_axis(const loft_acc x[], unsigned count, int axis, loft_vec out[])
{
    for (unsigned k = 0; k < count; k++) {
        if (!loft_acc_valid(x[k]))
            return false;
        out[k].axis[axis] = loft_acc_round(x[k]);
    }
    return true;
}

/* True if every coordinate is within -limit .. limit. */
static inline bool loft_vec_within(loft_vec a, loft_real limit)
{
    for (int i = 0; i < LOFT_AXES; i++)
        if (!(a.axis[i] >= -limit && a.axis[i] <= limit))
            return false;
    return true;
}

/* The scalar product.
 *
 *   range   q16: the sum of the products must stay within +-2^30 (vectors to 13000 in three axes)
 *   error   q16: none   f32, f64: LOFT_AXES 2^-53 of the sum of the products' magnitudes */
static inline loft_acc loft_vec_dot(loft_vec a, loft_vec b)
{
    loft_acc sum = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        sum += loft_prod(a.axis[i], b.axis[i]);
    return sum;
}

/* True if all coordinates are valid numbers: always in q16. */
static inline bool loft_vec_valid(loft_vec p)
{
    for (int i = 0; i < LOFT_AXES; i++)
        if (!loft_real_valid(p.axis[i]))
            return false;
    return true;
}

/* The distance between any two points.
 *
 *   error   that of loft_acc_hypot */
static inline loft_acc loft_vec_distance(loft_vec a, loft_vec b)
{
    loft_acc d[LOFT_AXES], from[LOFT_AXES];
    loft_accs_from(d, b.axis);
    loft_accs_from(from, a.axis);
    loft_accs_sub(d, from);
    return loft_acc_hypot(d, LOFT_AXES);
}

/* The smallest box that contains `box` and `p`. Start with { p, p }. */
static inline loft_box loft_box_join(loft_box box, loft_vec p)
{
    for (int i = 0; i < LOFT_AXES; i++) {
        if (p.axis[i] < box.min.axis[i])
            box.min.axis[i] = p.axis[i];
        if (p.axis[i] > box.max.axis[i])
            box.max.axis[i] = p.axis[i];
    }
    return box;
}

#endif
