/* lib/polygon/gb_net.c -- control points of generalized Bezier patches from the curves around them
 * SPDX-License-Identifier: MIT
 *
 * Let S_i be the side after corner i, d the degree, and a, b the steps from the corner along S_i
 * and S_(i-1). The bilinearly blended Coons net is
 *
 *     d^2 V = (d - b) d S_i(a) + b d T(a) + (d - a) d S_(i-1)(d - b) + a d U(b)
 *           - (d - a) (d - b) v_i - a (d - b) v_(i+1) - (d - a) b v_(i-1) - a b o
 *
 * between S_i, S_(i-1) and two curves T, U from v_(i-1), v_(i+1) to a fourth corner o. T and U are
 * S_(i-2), reversed, and S_(i+1), with o - v_(i-2), o - v_(i+2) added in proportion, where o is the
 * mean of both. Then o drops out:
 *
 *     2 d^2 V = 2 d ((d - b) S_i(a) + b S_(i-2)(d - a) + (d - a) S_(i-1)(d - b) + a S_(i+1)(b))
 *             - 2 ((d - a) (d - b) v_i + a (d - b) v_(i+1) + (d - a) b v_(i-1))
 *             - a b (v_(i+2) + v_(i-2))
 *
 * With four sides v_(i+2) is v_(i-2), so the curves are the given ones. The weights are whole
 * numbers below 2^10 that sum to 2 d^2.
 */
#include "polygon/gb.h"
#include "polygon/weighted_sum.h"      /* loft_weighted_sum */

typedef struct {
    const loft_vec *p;
    unsigned sides, degree;
} outline;

static void add_weighted(loft_weighted_sum *sum, const loft_vec *p, int32_t weight)
{
    loft_weighted_sum_add(sum, p, loft_sci_from_int(weight));
}

/* Point k of side i + ahead. */
static const loft_vec *side_point(const outline *o, unsigned i, unsigned ahead, unsigned k)
{
    return &o->p[((i + ahead) % o->sides * o->degree + k) % (o->sides * o->degree)];
}

static void add_point(loft_weighted_sum *sum, const outline *o, unsigned i, unsigned a, unsigned b)
{
    const unsigned d = o->degree, back = o->sides - 1;
    const int32_t m = (int32_t)d, u = (int32_t)a, v = (int32_t)b;

    add_weighted(sum, side_point(o, i, 0, a), 2 * m * (m - v));
    add_weighted(sum, side_point(o, i, back, d - b), 2 * m * (m - u));
    add_weighted(sum, side_point(o, i, 1, b), 2 * m * u);
    add_weighted(sum, side_point(o, i, back - 1, d - a), 2 * m * v);
    add_weighted(sum, side_point(o, i, 0, 0), -2 * (m - u) * (m - v));
    add_weighted(sum, side_point(o, i, 1, 0), -2 * u * (m - v));
    add_weighted(sum, side_point(o, i, back, 0), -2 * (m - u) * v);
    add_weighted(sum, side_point(o, i, 2, 0), -u * v);
    add_weighted(sum, side_point(o, i, back - 1, 0), -u * v);
}

/* The point in the middle of a side belongs to both its ends. */
static enum loft_status inner_point(const outline *o, unsigned i, unsigned a, unsigned b,
                                    loft_vec *out)
{
    loft_weighted_sum sum;

    loft_weighted_sum_start(&sum);
    add_point(&sum, o, i, a, b);
    if (2 * a == o->degree)
        add_point(&sum, o, (i + 1) % o->sides, b, a);
    return loft_weighted_sum_project(&sum, out);
}

enum loft_status loft_gb_middle(const loft_vec p[], unsigned sides, unsigned degree, loft_vec *out)
{
    const unsigned layers = (degree + 1) / 2;
    loft_weighted_sum sum;

    if (sides < 3 || sides > LOFT_SIDES_MAX || degree < 3 || degree > LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    loft_weighted_sum_start(&sum);
    for (unsigned i = 0; i < sides; i++)
        add_weighted(&sum, &p[loft_gb_place(sides, degree, i, layers, layers - 1)], 1);
    return loft_weighted_sum_project(&sum, out);
}

enum loft_status loft_gb_from_boundary(const loft_vec boundary[], unsigned sides, unsigned degree,
                                       loft_vec out[])
{
    const unsigned layers = (degree + 1) / 2;
    const outline o = { boundary, sides, degree };

    if (sides < 3 || sides > LOFT_SIDES_MAX || degree < 3 || degree > LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    for (unsigned i = 0; i < sides; i++) {
        for (unsigned j = 0; j < degree; j++)
            out[loft_gb_place(sides, degree, i, j, 0)] = boundary[i * degree + j];
        for (unsigned a = 1; a <= degree / 2; a++)
            for (unsigned b = 1; b < layers; b++)
                if (inner_point(&o, i, a, b, &out[loft_gb_place(sides, degree, i, a, b)]) !=
                    LOFT_OK)
                    return LOFT_ERR_RANGE;
    }
    return loft_gb_middle(out, sides, degree, &out[loft_gb_count(sides, degree) - 1]);
}
