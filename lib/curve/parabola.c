/* lib/curve/parabola.c
 * SPDX-License-Identifier: MIT
 */
#include "curve/parabola.h"
#include "basis/interp.h"       /* loft_parabola_bernstein */

enum loft_status loft_bezier_from_parabola(const loft_real t[3], const loft_vec p[3],
                                           loft_real from, loft_real to, loft_vec out[3])
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const loft_real f[3] = { p[0].axis[i], p[1].axis[i], p[2].axis[i] };
        loft_parabola own;
        loft_real c[3];

        enum loft_status status = loft_parabola_init(&own, t, f);
        if (status == LOFT_OK)
            status = loft_parabola_bernstein(&own, from, to, c);
        if (status != LOFT_OK)
            return status;
        for (int k = 0; k < 3; k++)
            out[k].axis[i] = c[k];
    }
    return LOFT_OK;
}
