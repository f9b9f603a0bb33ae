/* lib/geom/normal.c
 * SPDX-License-Identifier: MIT
 */
#include "geom/normal.h"

#define SPACE 3

/* In q16 |x| errs by 2^-28 of itself and 2^-32, the quotient by 2^-30 and the rounding. */
enum loft_status loft_vec_unit(const loft_acc x[LOFT_AXES], loft_vec *out)
{
    const loft_acc length = loft_acc_hypot(x, LOFT_AXES);

    if (!(length > 0))
        return LOFT_SINGULAR;
    for (int i = 0; i < LOFT_AXES; i++)
        out->axis[i] = loft_acc_quot(x[i], length);
    return LOFT_OK;
}

static bool aim(const loft_acc x[], loft_unit toward[SPACE])
{
    const loft_acc length = loft_acc_hypot(x, SPACE);

    for (int i = 0; i < SPACE && length > 0; i++)
        toward[i] = loft_unit_ratio(x[i], length);
    return length > 0;
}

static loft_acc product(loft_unit a, loft_unit b)
{
    return loft_acc_scale(loft_acc_scale(loft_wide(LOFT_REAL(1)), a), b);
}

/* Each of the two directions errs by 2^-25 in each of three components and by 2^-28 of its length, so their product,
 * of length s, by less than 2^-23. */
static enum loft_status normal_in_space(const loft_acc a[], const loft_acc b[], loft_acc n[SPACE])
{
    loft_unit u[SPACE], v[SPACE];

    if (!aim(a, u) || !aim(b, v))
        return LOFT_SINGULAR;
    for (int i = 0; i < SPACE; i++) {
        const int j = (i + 1) % SPACE, k = (i + 2) % SPACE;
        n[i] = product(u[j], v[k]) - product(u[k], v[j]);
    }
    return loft_acc_hypot(n, SPACE) >= loft_acc_scale(loft_wide(LOFT_REAL(1)), LOFT_UNIT(1.0 / 1048576)) ? LOFT_OK : LOFT_SINGULAR;
}

enum loft_status loft_vec_normal(const loft_acc a[LOFT_AXES], const loft_acc b[LOFT_AXES], loft_vec *out)
{
    loft_acc n[LOFT_AXES < SPACE ? SPACE : LOFT_AXES] = { 0 };

    if (LOFT_AXES < SPACE || normal_in_space(a, b, n) != LOFT_OK)
        return LOFT_SINGULAR;
    return loft_vec_unit(n, out);
}
