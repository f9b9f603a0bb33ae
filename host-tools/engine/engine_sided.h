/* host-tools/engine/engine_sided.h -- surfaces with n sides as the library holds them; part of
 * engine_surface.c
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_ENGINE_SIDED_H
#define LOFT_HOST_ENGINE_SIDED_H

#include "engine/engine.h"
#include "engine/sided.h"

typedef struct engine_sided engine_sided;
struct loft_disk;          /* of the library */

/* As with engine_surfaces. */
typedef struct {
    int (*open)(const surface *s, engine_sided **out);
    void (*close)(engine_sided *e);
    int (*eval)(const engine_sided *e, sided_place at, double out[ENGINE_AXES]);
    /* Normal and curvatures, where the patch has them. */
    int (*look)(const engine_sided *e, sided_place at, engine_look *out);
    /* Give a GB patch of which the points around it are known, or all but the last, the others;
     * with any other number nothing. */
    int (*complete)(surface *s);
    /* Cut the polygon of a patch into its parts; those without one are one part. LOFT_SINGULAR:
     * sides at[0] and at[1] cross or touch. LOFT_ERR_ARG: it runs clockwise. LOFT_ERR_RANGE: vertex
     * at[0] cannot be taken. at[0] is otherwise a vertex that does not turn left, s->n when there
     * is none. */
    int (*cut)(surface *s, unsigned at[2]);
    /* The whole as a sheet around its middle; it borrows from `e`. */
    int (*disk)(const engine_sided *e, struct loft_disk *out);
} engine_sides;

extern const engine_sides engine_sides_q16, engine_sides_f32, engine_sides_f64;

#endif
