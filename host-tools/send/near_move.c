/* host-tools/send/near_move.c
 * SPDX-License-Identifier: MIT
 */
#include <math.h>

#include "send/near_move.h"

#define LOOKS 64

void near_point(const engine_move *m, double t, double out[ENGINE_AXES])
{
    const double a = 1 - t;

    for (int i = 0; i < ENGINE_AXES; i++)
        out[i] = a * a * a * m->p[0][i] + 3 * a * a * t * m->p[1][i] + 3 * a * t * t * m->p[2][i] +
                 t * t * t * m->p[3][i];
}

double near_move(const engine_move *m, const double at[ENGINE_AXES], double *t)
{
    double least = HUGE_VAL;

    for (int k = 0; k <= LOOKS; k++) {
        double p[ENGINE_AXES], far = 0;
        near_point(m, (double)k / LOOKS, p);
        for (int i = 0; i < ENGINE_AXES; i++)
            far += (p[i] - at[i]) * (p[i] - at[i]);
        if (far < least) {
            least = far;
            *t    = (double)k / LOOKS;
        }
    }
    return sqrt(least);
}
