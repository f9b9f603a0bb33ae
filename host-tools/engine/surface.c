/* host-tools/engine/surface.c -- the kinds of surfaces, and lists of them
 * SPDX-License-Identifier: MIT
 */
#include <stdlib.h>

#include "num/status.h" /* enum loft_status */

#include "engine/engine.h"  /* engine_status */
#include "engine/sided.h"   /* sided_points */
#include "engine/surface.h"
#include "base/tool.h"      /* tool_grow */

const char *surface_name(enum surface_kind kind)
{
    static const char *const names[SURFACE_KINDS] = { [SURFACE_TENSOR] = "tensor",
                                                      [SURFACE_TRIANGLE] = "triangle",
                                                      [SURFACE_COONS] = "coons",
                                                      [SURFACE_BICUBIC] = "bicubic",
                                                      [SURFACE_PN] = "pn",
                                                      [SURFACE_SPHERE] = "sphere",
                                                      [SURFACE_OCTANT] = "octant",
                                                      [SURFACE_GREGORY] = "gregory",
                                                      [SURFACE_NURBS] = "nurbs-surface",
                                                      [SURFACE_TETRA] = "tetra",
                                                      [SURFACE_SPATCH] = "spatch",
                                                      [SURFACE_TORIC] = "toric",
                                                      [SURFACE_BASEPOINT] = "basepoint",
                                                      [SURFACE_RING] = "ring",
                                                      [SURFACE_GB] = "gb" };
    return names[kind];
}

bool surface_is_triangle(const surface *s)
{
    return s->kind == SURFACE_TRIANGLE || s->kind == SURFACE_PN || s->kind == SURFACE_OCTANT;
}

bool surface_is_high(const surface *s)
{
    return (s->kind == SURFACE_TRIANGLE && s->m > SURFACE_DEGREE_MAX) ||
           (s->kind == SURFACE_TENSOR && (s->m > SURFACE_DEGREE_MAX || s->n > SURFACE_DEGREE_MAX));
}

bool surface_is_sided(const surface *s) { return s->kind >= SURFACE_SPATCH; }

unsigned surface_kites(const surface *s)
{
    unsigned kites = 0;

    for (unsigned k = 0; k < s->parts; k++)
        kites += s->part[k].sides;
    return surface_is_sided(s) ? kites : 1;
}

/* The domain is known to be a polygon (LOFT.md), but it may not be one after rounding. */
const char *surface_status(const surface *s, int status)
{
    const bool polygon = s->kind == SURFACE_SPATCH || s->kind == SURFACE_GB;

    if (polygon && (status == LOFT_SINGULAR || status == LOFT_ERR_ARG))
        return "its domain, rounded, is not a simple polygon any more: make the domain larger, or "
               "take --num f64";
    if (polygon && status == LOFT_ERR_RANGE && s->coordinates == COORDINATES_HARMONIC)
        return "the points do not fit, or the domain is too narrow for harmonic coordinates: make "
               "it wider, or take meanvalue";
    return engine_status(status,
                         "its numbers are out of bounds: give degrees 1 to 9, at least one step, "
                         "and places inside of its domain");
}

void surface_middle(const surface *s, double uv[2])
{
    const sided_place at = surface_is_sided(s)
                               ? sided_middle(s)
                               : (sided_place){ .u = surface_is_triangle(s) ? 1 / 3.0 : 0.5 };

    uv[0] = at.u;
    uv[1] = surface_is_sided(s) ? at.v : at.u;
}

unsigned surface_points(const surface *s)
{
    if (surface_is_sided(s))
        return sided_points(s);
    switch (s->kind) {
    case SURFACE_TENSOR:   return (s->m + 1) * (s->n + 1);
    case SURFACE_TRIANGLE: return (s->m + 1) * (s->m + 2) / 2;
    case SURFACE_TETRA:    return (s->m + 1) * (s->m + 2) * (s->m + 3) / 6;
    case SURFACE_COONS:    return 2 * s->orders * (s->m + s->n + 2);
    case SURFACE_BICUBIC:  return 16;
    case SURFACE_GREGORY:  return 20;
    case SURFACE_NURBS:    return s->rows * s->columns;
    case SURFACE_PN:       return 3;
    default:               return 1;
    }
}

surface *surfaces_add(surfaces *all, enum surface_kind kind, unsigned line)
{
    all->surface = tool_grow(all->surface, (all->count + 1) * sizeof *all->surface);
    surface *s = &all->surface[all->count++];
    *s = (surface){ .kind = kind, .orders = 1, .line = line };
    return s;
}

void surface_add_point(surface *s, const surface_point *p)
{
    if ((s->count & (s->count - 1)) == 0)       /* at powers of two the room doubles */
        s->point = tool_grow(s->point, (s->count ? 2 * s->count : 1) * sizeof *s->point);
    s->point[s->count++] = *p;
}

void surface_add_knot(surface *s, unsigned along, double knot)
{
    unsigned *count = &s->knots[along];

    if ((*count & (*count - 1)) == 0)
        s->knot[along] = tool_grow(s->knot[along], (*count ? 2 * *count : 1) * sizeof knot);
    s->knot[along][(*count)++] = knot;
}

void surfaces_free(surfaces *all)
{
    for (size_t i = 0; i < all->count; i++) {
        free(all->surface[i].point);
        free(all->surface[i].knot[0]);
        free(all->surface[i].knot[1]);
    }
    free(all->surface);
    *all = (surfaces){ 0 };
}
