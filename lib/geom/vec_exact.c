/* lib/geom/vec_exact.c
 * SPDX-License-Identifier: MIT
 */
#include "geom/vec_exact.h"

bool loft_vec_exact_valid(const loft_vec p[], unsigned count, int axes)
{
    for (unsigned k = 0; k < count; k++)
        for (int i = 0; i < axes; i++)
            if (!loft_exact_valid(loft_vec_axis(&p[k], i)))
                return false;
    return true;
}

loft_exact loft_vec_exact_sub_axis(const loft_vec *a, const loft_vec *b, int axis)
{
    const loft_exact from = loft_exact_from_real(loft_vec_axis(b, axis));
    return loft_exact_sub(loft_exact_from_real(loft_vec_axis(a, axis)), from);
}

void loft_vec_exact_sub(const loft_vec *a, const loft_vec *b, int axes, loft_exact out[])
{
    for (int i = 0; i < axes; i++)
        out[i] = loft_vec_exact_sub_axis(a, b, i);
}

loft_exact loft_vec_exact_dot(const loft_exact a[], const loft_exact b[], int axes)
{
    loft_exact sum = loft_exact_from_int(0);

    for (int i = 0; i < axes; i++)
        sum = loft_exact_add(sum, loft_exact_mul(a[i], b[i]));
    return sum;
}

void loft_vec_exact_cross(const loft_exact a[3], const loft_exact b[3], loft_exact out[3])
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        out[i] = loft_exact_det(a[j], a[k], b[j], b[k]);
    }
}
