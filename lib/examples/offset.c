/* lib/examples/offset.c -- the path of a tool with a radius beside a path of curves and lines
 * SPDX-License-Identifier: MIT
 */
#include <stdio.h>
#include "loft.h"

#define XY(x, y) { { LOFT_REAL(x), LOFT_REAL(y), 0 } }

int main(void)
{
    const loft_vec a = XY(0, 0), b = XY(30, 0), c = XY(0, 40);
    const loft_cubic path[] = {
        /* without corners, but where it closes */
        loft_cubic_line(a, b),
        { { b, XY(50, 0), XY(50, 40), XY(30, 40) } },
        loft_cubic_line((loft_vec)XY(30, 40), c),
    };
    loft_offset side;
    loft_offset_span s;

    for (int i = 0; i < 3; i++) {
        if (loft_offset_init(&side, &path[i], LOFT_REAL(3), LOFT_REAL(0.01)) != LOFT_OK)
            return 1;
        for (int n = 1; loft_offset_next(&side, &s); n++)
            if (!s.behind)                      /* where the tool would not cut into the path */
                printf("curve %d, part %d: to %ld %ld steps\n", i, n,
                       (long)loft_steps_of(s.curve.p[3].axis[0], LOFT_REAL(10)),
                       (long)loft_steps_of(s.curve.p[3].axis[1], LOFT_REAL(10)));
    }
    return 0;
}

/* prints
 *
 *     curve 0, part 1: to 300 30 steps
 *     curve 1, part 1: to 351 43 steps
 *     curve 1, part 2: to 388 79 steps
 *     curve 1, part 3: to 412 134 steps
 *     curve 1, part 4: to 420 200 steps
 *     curve 1, part 5: to 412 266 steps
 *     curve 1, part 6: to 388 321 steps
 *     curve 1, part 7: to 351 357 steps
 *     curve 1, part 8: to 300 370 steps
 *     curve 2, part 1: to 0 370 steps
 */
