/* host-tools/make/engine_patch.h -- verbs of `loft make` and questions of `loft decide` about
 * patches
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_ENGINE_PATCH_H
#define LOFT_HOST_ENGINE_PATCH_H

#include <stdio.h>

#include "engine/engine_num.h"      /* ENGINE_OF */
#include "engine/surface.h"         /* surface_name */
#include "make/decide.h"

/* engine_patch.c: of tensor patches and triangles without weights */
int ENGINE_OF(make_raise_patch)(const decide_input *in);
int ENGINE_OF(make_split_patch)(const decide_input *in);
int ENGINE_OF(make_quarter)(const decide_input *in);
int ENGINE_OF(make_continue)(const decide_input *in);
int ENGINE_OF(answer_join)(const decide_input *in);

/* engine_simplex.c: of lines, planes, triangles, tetrahedra */
int ENGINE_OF(answer_shares)(const decide_input *in);
int ENGINE_OF(answer_plane)(const decide_input *in);
int ENGINE_OF(answer_sphere)(const decide_input *in);
int ENGINE_OF(answer_weights)(const decide_input *in);
int ENGINE_OF(answer_solid)(const decide_input *in);
int ENGINE_OF(answer_triangle_operator)(const decide_input *in);
int ENGINE_OF(answer_triangle_integral)(const decide_input *in);
int ENGINE_OF(answer_polar)(const decide_input *in);

/* engine_net.c: of each surface with a net */
int ENGINE_OF(answer_nearest)(const decide_input *in);
int ENGINE_OF(answer_ray)(const decide_input *in);
int ENGINE_OF(answer_area)(const decide_input *in);
int ENGINE_OF(answer_volume)(const decide_input *in);

/* engine_meet.c: surfaces with nets, and curves */
int ENGINE_OF(make_meet)(const decide_input *in);
int ENGINE_OF(answer_pierce)(const decide_input *in);

/* engine_weighted.c: any surface with nets as tensor patches and triangles; those with weights: the
 * surface of that number, raised or split */
int ENGINE_OF(make_patches)(const decide_input *in);
int ENGINE_OF(raise_weighted)(const decide_input *in, size_t number);
int ENGINE_OF(split_weighted)(const decide_input *in, size_t number, loft_unit u, loft_unit w);

/* It has no net: say why, and what has. */
static inline void decide_refuse_kind(const decide_input *in, size_t number, const surface *s)
{
    if (s->kind == SURFACE_SPATCH)
        snprintf(in->why, DECIDE_WHY,
                 "surface %zu: of a spatch give wachspress coordinates on a convex polygon, and "
                 "depth (sides - 2) up to 9: its degree as triangles",
                 number);
    else if (s->kind == SURFACE_TORIC || s->kind == SURFACE_BASEPOINT)
        snprintf(in->why, DECIDE_WHY,
                 "surface %zu: higher than 9 over a side, or with weights that differ by over "
                 "2^15, it has no nets: change that, or take `loft contour`",
                 number);
    else if (surface_is_sided(s))
        snprintf(in->why, DECIDE_WHY,
                 "surface %zu: a %s is not rational up to degree 9: give another "
                 "kind, or cut it by planes: `loft contour`",
                 number, surface_name(s->kind));
    else
        snprintf(in->why, DECIDE_WHY,
                 "surface %zu is of kind %s: give tensor, triangle, coons, bicubic, pn, "
                 "nurbs-surface, spatch, toric, basepoint, sphere or octant",
                 number, surface_name(s->kind));
}

#endif
