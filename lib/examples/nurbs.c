/* lib/examples/nurbs.c -- a NURBS: the circle in nine weighted points
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include "loft.h"

#define ON(x, y) { { { LOFT_REAL(x), LOFT_REAL(y), 0 } }, LOFT_REAL(1) }
#define OFF(x, y) { { { LOFT_REAL(x), LOFT_REAL(y), 0 } }, LOFT_REAL(0.70710678118654752) }
static const loft_weighted nine[] = {
    ON(10, 0),  OFF(10, 10),   ON(0, 10),  OFF(-10, 10), ON(-10, 0),
                OFF(-10, -10), ON(0, -10), OFF(10, -10), ON(10, 0),
};
#define K(u) LOFT_REAL(u)
static const loft_real knots[] = {
    K(0), K(0), K(0), K(1), K(1), K(2), K(2), K(3), K(3), K(4), K(4), K(4),
};

int main(void)
{
    loft_nurbs circle;

    if (loft_nurbs_init(&circle, nine, 9, knots, 2) != LOFT_OK)
        return 1;
    for (int i = 0; i <= 8; i++) {
        const loft_vec at = loft_nurbs_eval(&circle, i * LOFT_REAL(0.5));
        const loft_vec centre = { { 0, 0, 0 } };
        const loft_acc radius = loft_vec_distance(at, centre);

        char x[LOFT_TEXT_MAX], y[LOFT_TEXT_MAX], far[LOFT_TEXT_MAX];

        loft_to_text(at.axis[0], 3, x);
        loft_to_text(at.axis[1], 3, y);
        loft_to_text(loft_acc_round(radius), 3, far);
        printf("(%s, %s), %s from the centre\n", x, y, far);
    }
    return 0;
}

/* prints
 *
 *     (10.000, 0.000), 10.000 from the centre
 *     (7.071, 7.071), 10.000 from the centre
 *     (0.000, 10.000), 10.000 from the centre
 *     (-7.071, 7.071), 10.000 from the centre
 *     (-10.000, 0.000), 10.000 from the centre
 *     (-7.071, -7.071), 10.000 from the centre
 *     (0.000, -10.000), 10.000 from the centre
 *     (7.071, -7.071), 10.000 from the centre
 *     (10.000, 0.000), 10.000 from the centre
 */
