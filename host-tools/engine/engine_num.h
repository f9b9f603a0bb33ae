/* host-tools/engine/engine_num.h -- converts between double and the number type that is compiled
 * SPDX-License-Identifier: MIT
 *
 * For the files that are compiled once per number type. Conversions use LOFT_REAL(1), the raw value
 * of 1, so those files do not depend on the type.
 */
#ifndef LOFT_ENGINE_NUM_H
#define LOFT_ENGINE_NUM_H

#include <math.h>

#include "geom/vec.h"               /* loft_vec */
#include "surface/differential.h"   /* loft_differential_curvatures */

#include "engine/engine.h"

#define ENGINE_ONE ((double)LOFT_REAL(1.0))

#define ENGINE_OF_(name, tag) name ## _ ## tag
#define ENGINE_OF__(name, tag) ENGINE_OF_(name, tag)
#define ENGINE_OF(name)       ENGINE_OF__(name, LOFT_TAG)

typedef char engine_axes_agree[LOFT_AXES == ENGINE_AXES ? 1 : -1];

static inline bool real_of(double x, loft_real *out)
{
    if (!(fabs(x) * ENGINE_ONE <= (double)LOFT_REAL_MAX))
        return false;
    *out = LOFT_REAL(x);
    return true;
}

/* Convert a tolerance, never to a larger one. */
static inline bool tol_of(double x, loft_real *out)
{
    if (!real_of(x, out))
        return false;
    *out -= (double)*out / ENGINE_ONE > x ? LOFT_REAL_LSB : 0;
    return true;
}

static inline bool vec_of(const double point[ENGINE_AXES], loft_vec *out)
{
    for (int i = 0; i < ENGINE_AXES; i++)
        if (!real_of(point[i], &out->axis[i]))
            return false;
    return true;
}

static inline bool vecs_of(const double p[][ENGINE_AXES], unsigned count, loft_vec out[])
{
    for (unsigned i = 0; i < count; i++)
        if (!vec_of(p[i], &out[i]))
            return false;
    return true;
}

static inline double double_of(loft_real x) { return (double)x / ENGINE_ONE; }

static inline double double_of_acc(loft_acc x)
{
    return (double)x / (double)loft_to_acc(LOFT_REAL(1.0));
}

static inline void point_of(loft_vec v, double out[ENGINE_AXES])
{
    for (int i = 0; i < ENGINE_AXES; i++)
        out[i] = double_of(v.axis[i]);
}

/* Normal and curvatures from the library's derivatives at a place. */
static inline int look_of(const loft_differential *here, engine_look *out)
{
    loft_curvatures k;
    loft_vec normal, direction[2];
    int status = loft_differential_normal(here, &normal);

    if (status == LOFT_OK)
        status = loft_differential_curvatures(here, &k);
    if (status != LOFT_OK)
        return status;
    point_of(normal, out->normal);
    out->gauss = double_of_acc(k.gauss);
    out->mean  = double_of_acc(k.mean);
    out->least = double_of_acc(k.min);
    out->most  = double_of_acc(k.max);
    out->directed = loft_differential_directions(here, direction) == LOFT_OK;
    for (int i = 0; i < 2 && out->directed; i++)
        point_of(direction[i], out->direction[i]);
    const loft_sci *const d[5] = { here->u, here->v, here->uu, here->uv, here->vv };
    out->derived = true;
    for (int i = 0; i < 5; i++)
        for (int axis = 0; axis < ENGINE_AXES; axis++) {
            loft_acc x = 0;
            out->derived = loft_sci_to_acc(d[i][axis], &x) && out->derived;
            out->d[i][axis] = double_of_acc(x);
        }
    return LOFT_OK;
}

#endif
