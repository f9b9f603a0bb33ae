/* lib/surface/triangle/triangle_integral.c
 * SPDX-License-Identifier: MIT
 *
 * Each of the (n + 1) (n + 2) / 2 Bernstein polynomials has the integral 2 A / ((n + 1) (n + 2)).
 * The sum of 55 coefficients is exact in q16 as a loft_acc, so the integral is rounded once.
 */
#include "surface/triangle/triangle_integral.h"
#include "geom/vec_exact.h"         /* loft_vec_exact_valid */
#include "num/sci.h"                /* loft_sci_cross */
#include "surface/barycentric.h"    /* LOFT_TRIANGLE_POINTS */

enum loft_status loft_triangle_integral(const loft_real b[], unsigned degree, const loft_vec t[3],
                                        loft_acc *area, loft_acc *integral)
{
    const unsigned count = LOFT_TRIANGLE_POINTS(degree);
    loft_real p[3][2];
    loft_acc sum = 0, own[2];

    if (degree > LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    if (!loft_vec_exact_valid(t, 3, LOFT_AXES < 2 ? LOFT_AXES : 2))
        return LOFT_ERR_RANGE;
    for (unsigned k = 0; k < count; k++) {
        if (!loft_real_valid(b[k]))
            return LOFT_ERR_RANGE;
        sum += loft_to_acc(b[k]);
    }
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 2; i++)
            p[k][i] = loft_vec_axis(&t[k], i);
    const loft_sci twice = loft_sci_cross(p[0], p[1], p[0], p[2]);
    const loft_sci x = loft_sci_div(loft_sci_mul(twice, loft_sci_of(sum)),
                                    loft_sci_from_int(2 * (int32_t)count));
    if (!loft_sci_to_acc(loft_sci_div(twice, loft_sci_from_int(2)), &own[0]) ||
        !loft_sci_to_acc(x, &own[1]))
        return LOFT_ERR_RANGE;
    *area = own[0];
    *integral = own[1];
    return LOFT_OK;
}
