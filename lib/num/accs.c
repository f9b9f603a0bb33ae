/* lib/num/accs.c
 * SPDX-License-Identifier: MIT
 */
#include "num/accs.h"

void loft_accs_from(loft_acc x[LOFT_AXES], const loft_real a[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++)
        x[i] = loft_to_acc(a[i]);
}

#if !defined(__AVR__)

void loft_accs_copy(loft_acc x[LOFT_AXES], const loft_acc y[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++)
        x[i] = y[i];
}

void loft_accs_add(loft_acc x[LOFT_AXES], const loft_acc y[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++)
        x[i] += y[i];
}

void loft_accs_sub(loft_acc x[LOFT_AXES], const loft_acc y[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++)
        x[i] -= y[i];
}

void loft_accs_triple(loft_acc x[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++)
        x[i] += 2 * x[i];
}

#endif

void loft_accs_scale(loft_acc x[LOFT_AXES], loft_unit t)
{
    for (int i = 0; i < LOFT_AXES; i++)
        x[i] = loft_acc_scale(x[i], t);
}

void loft_accs_grow(loft_acc x[LOFT_AXES], const loft_acc y[LOFT_AXES], loft_unit t)
{
    for (int i = 0; i < LOFT_AXES; i++)
        x[i] += loft_acc_scale(y[i], t);
}
