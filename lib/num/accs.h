/* lib/num/accs.h -- wide vectors: LOFT_AXES accs, changed in place
 * SPDX-License-Identifier: MIT
 *
 * Each function applies the operation of num.h of the same name to every axis, with the same range
 * and error.
 */
#ifndef LOFT_NUM_ACCS_H
#define LOFT_NUM_ACCS_H

#include "num/num.h"    /* loft_acc, loft_acc_scale */

LOFT_BEGIN_C

/* x = a, x = y */
void loft_accs_from(loft_acc x[LOFT_AXES], const loft_real a[LOFT_AXES]);
void loft_accs_copy(loft_acc x[LOFT_AXES], const loft_acc y[LOFT_AXES]);

/* x += y, x -= y, x *= 3 */
void loft_accs_add(loft_acc x[LOFT_AXES], const loft_acc y[LOFT_AXES]);
void loft_accs_sub(loft_acc x[LOFT_AXES], const loft_acc y[LOFT_AXES]);
void loft_accs_triple(loft_acc x[LOFT_AXES]);

/* x *= t, x += y t */
void loft_accs_scale(loft_acc x[LOFT_AXES], loft_unit t);
void loft_accs_grow(loft_acc x[LOFT_AXES], const loft_acc y[LOFT_AXES], loft_unit t);

LOFT_END_C

#endif
