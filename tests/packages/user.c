/* tests/packages/user.c -- a program of somebody else: walks a cubic, prints its end
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>

#include "loft.h"

int main(void)
{
    static const loft_vec p[4] = {
        { { LOFT_REAL(0), LOFT_REAL(0) } },
        { { LOFT_REAL(1), LOFT_REAL(2) } },
        { { LOFT_REAL(3), LOFT_REAL(2) } },
        { { LOFT_REAL(4), LOFT_REAL(-1) } },
    };
    loft_bezier curve;
    loft_forward walk;
    loft_vec at = p[0];
    unsigned points = 0;

    if (loft_bezier_init(&curve, p, 3) != LOFT_OK ||
        loft_forward_init(&walk, &curve, 64) != LOFT_OK)
        return 1;
    while (loft_forward_next(&walk, &at))
        points++;
    printf("%u points, %ld %ld, loft %s\n", points, (long)loft_raw_from_real(at.axis[0]),
           (long)loft_raw_from_real(at.axis[1]), LOFT_VERSION);
    return 0;
}
