/* lib/examples/patch.c -- a patch with five sides: an S-patch over a pentagon
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include "loft/surfaces.h"

#define V(x, y) { { LOFT_REAL(x), LOFT_REAL(y) } }
enum { SIDES = 5, DEPTH = 2 };
static const loft_spot pentagon[] = { V(0, -10), V(10, -3), V(6, 8), V(-6, 8), V(-10, -3) };

int main(void)
{
    loft_vec points[15], at;                    /* loft_multiindex_count(SIDES, DEPTH) */
    uint8_t l[LOFT_SIDES_MAX];
    loft_sci phi[SIDES];
    loft_domain domain;
    loft_spatch patch;

    loft_multiindex_first(l, SIDES, DEPTH);
    do {                                        /* corners stay on the floor, the rest is lifted */
        loft_vec *p = &points[loft_multiindex_rank(l, SIDES)];
        *p = (loft_vec) { { 0, 0, LOFT_REAL(20) } };
        for (int i = 0; i < SIDES; i++) {
            p->axis[0] += l[i] * pentagon[i].at[0] / DEPTH;
            p->axis[1] += l[i] * pentagon[i].at[1] / DEPTH;
            p->axis[2] -= l[i] == DEPTH ? LOFT_REAL(20) : 0;
        }
    } while (loft_multiindex_next(l, SIDES));
    if (loft_domain_init(&domain, pentagon, SIDES) != LOFT_OK ||
        loft_spatch_init(&patch, points, NULL, SIDES, DEPTH) != LOFT_OK)
        return 1;
    for (int y = -10; y <= 8; y += 2) {         /* from a corner to the edge across */
        const loft_spot here = { { 0, y * LOFT_REAL(1) } };
        if (loft_wachspress_eval(&domain, here, phi) != LOFT_OK ||
            loft_spatch_eval(&patch, phi, &at) != LOFT_OK)
            return 1;
        printf("y %3d: height %5.2f\n", y, loft_raw_from_real(at.axis[2]) / 65536.0);
    }
    return 0;
}

/* prints
 *
 *     y -10: height  0.00
 *     y  -8: height  8.23
 *     y  -6: height 12.42
 *     y  -4: height 14.59
 *     y  -2: height 15.67
 *     y   0: height 16.00
 *     y   2: height 15.67
 *     y   4: height 14.64
 *     y   6: height 12.79
 *     y   8: height 10.00
 */
