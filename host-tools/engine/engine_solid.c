/* host-tools/engine/engine_solid.c -- compiled once per number type
 * SPDX-License-Identifier: MIT
 */
#include "engine/engine_solid.h"

int ENGINE_OF(engine_solid_open)(const surface *s, loft_vec p[LOFT_TETRA_MAX], loft_tetra *out)
{
    for (unsigned k = 0; k < s->count; k++)
        if (!vec_of(s->point[k].p, &p[k]))
            return LOFT_ERR_RANGE;
    return loft_tetra_init(out, p, s->m);
}

int ENGINE_OF(engine_solid_eval)(const surface *s, const double at[3], double out[ENGINE_AXES])
{
    const loft_volume u = { LOFT_UNIT(at[0]), LOFT_UNIT(at[1]), LOFT_UNIT(at[2]) };
    loft_vec p[LOFT_TETRA_MAX];
    loft_tetra t;
    const int status = ENGINE_OF(engine_solid_open)(s, p, &t);

    if (status == LOFT_OK)
        point_of(loft_tetra_eval(&t, u), out);
    return status;
}
