/* ports/packages/esp-idf/examples/walk/main/walk.c -- walk a curve by additions alone
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>

#include "loft.h"

static const loft_vec points[4] = {
    { { LOFT_REAL(0), LOFT_REAL(0) } },
    { { LOFT_REAL(10), LOFT_REAL(40) } },
    { { LOFT_REAL(30), LOFT_REAL(40) } },
    { { LOFT_REAL(40), LOFT_REAL(0) } },
};

void app_main(void);
void app_main(void)
{
    loft_bezier curve;
    loft_forward walk;
    loft_vec at;

    if (loft_bezier_init(&curve, points, 3) != LOFT_OK ||
        loft_forward_init(&walk, &curve, 256) != LOFT_OK)
        return;
    while (loft_forward_next(&walk, &at))
        printf("%ld %ld\n", (long)loft_raw_from_real(at.axis[0]),
               (long)loft_raw_from_real(at.axis[1]));
}
