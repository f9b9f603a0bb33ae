/* lib/geom/normal.c
 * SPDX-License-Identifier: MIT
 *
 * In numbers with their own exponent, vectors of any size behave alike, and the error of a
 * difference of two products is 2^-60 (q16) or 2^-52 (floats) of the larger one.
 */
#include "geom/normal.h"
#include "num/sci.h"    /* loft_sci: any size */

#define SPACE 3

static loft_sci square(const loft_sci x[], int n)
{
    loft_sci sum = loft_sci_zero();

    for (int i = 0; i < n; i++)
        sum = loft_sci_add(sum, loft_sci_mul(x[i], x[i]));
    return sum;
}

/* x / |x| in the first n axes, 0 in the others. */
static enum loft_status aim(const loft_sci x[], int n, loft_vec *out)
{
    const loft_sci length = loft_sci_sqrt(square(x, n));

    if (loft_sci_sign(length) <= 0)
        return LOFT_SINGULAR;
    for (int i = 0; i < LOFT_AXES; i++) {
        loft_acc y = 0;
        if (i < n && !loft_sci_to_acc(loft_sci_div(x[i], length), &y))
            y = 0;                              /* never: |y| <= 1 */
        out->axis[i] = loft_acc_round(y);
    }
    return LOFT_OK;
}

enum loft_status loft_vec_unit(const loft_acc x[LOFT_AXES], loft_vec *out)
{
    loft_sci y[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        y[i] = loft_sci_of(x[i]);
    return aim(y, LOFT_AXES, out);
}

static enum loft_status normal_in_space(const loft_acc a[], const loft_acc b[], loft_vec *out)
{
    loft_sci u[SPACE], v[SPACE], n[SPACE];

    for (int i = 0; i < SPACE; i++) {
        u[i] = loft_sci_of(a[i]);
        v[i] = loft_sci_of(b[i]);
    }
    for (int i = 0; i < SPACE; i++) {
        const int j = (i + 1) % SPACE, k = (i + 2) % SPACE;
        n[i] = loft_sci_sub(loft_sci_mul(u[j], v[k]), loft_sci_mul(u[k], v[j]));
    }
    const loft_sci all = loft_sci_mul(square(u, SPACE), square(v, SPACE));
    const loft_sci fine = loft_sci_mul(loft_sci_from_int(1048576), loft_sci_from_int(1048576));
    if (loft_sci_less(loft_sci_mul(fine, square(n, SPACE)), all))
        return LOFT_SINGULAR;
    return aim(n, SPACE, out);
}

enum loft_status loft_vec_normal(const loft_acc a[LOFT_AXES], const loft_acc b[LOFT_AXES],
                                 loft_vec *out)
{
    return LOFT_AXES < SPACE ? LOFT_SINGULAR : normal_in_space(a, b, out);
}
