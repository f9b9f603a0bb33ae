/* host-tools/engine/engine_sided.h -- surfaces with n sides in the representation of the library;
 * part of engine_surface.c
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_ENGINE_SIDED_H
#define LOFT_HOST_ENGINE_SIDED_H

#include "engine/engine.h"
#include "engine/sided.h"

typedef struct engine_sided engine_sided;
struct loft_disk;          /* of the library */
struct engine_sheet_list;  /* engine_sheet.h */

/* As in engine_surfaces. */
typedef struct {
    int (*open)(const surface *s, engine_sided **out);
    void (*close)(engine_sided *e);
    int (*eval)(const engine_sided *e, sided_place at, double out[ENGINE_AXES]);
    /* Normal and curvatures, if the patch has them. */
    int (*look)(const engine_sided *e, sided_place at, engine_look *out);
    /* Complete a GB patch whose outer points are known, or all but the last: compute the others.
     * With any other number of points, do nothing. */
    int (*complete)(surface *s);
    /* Cut the polygon of a patch into its parts; a patch without a polygon is one part.
     * LOFT_SINGULAR: sides at[0] and at[1] cross or touch. LOFT_ERR_ARG: the polygon is clockwise.
     * LOFT_ERR_RANGE: vertex at[0] is out of range. Otherwise at[0] is a vertex that does not turn
     * left, or s->n if there is none. */
    int (*cut)(surface *s, unsigned at[2]);
    /* The whole patch as a surface around its middle; it borrows from `e`. */
    int (*disk)(const engine_sided *e, struct loft_disk *out);
    /* As engine_sheets. */
    int (*sheets)(engine_sided *e, unsigned level, struct engine_sheet_list *out);
} engine_sides;

extern const engine_sides engine_sides_q16, engine_sides_f32, engine_sides_f64;

#endif
