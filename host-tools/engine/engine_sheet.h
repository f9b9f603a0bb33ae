/* host-tools/engine/engine_sheet.h -- surfaces as the sheets of lib/toolpath and as the nets of
 * lib/surface/net.h; part of engine_surface.c
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_ENGINE_SHEET_H
#define LOFT_HOST_ENGINE_SHEET_H

#include <math.h>

#include "engine/engine_num.h"      /* ENGINE_OF */
#include "engine/engine_sided.h"    /* engine_sided */
#include "engine/surface.h"         /* engine_surface */
#include "surface/net.h"            /* loft_net */
#include "surface/sphere.h"         /* loft_sphere */
#include "toolpath/sector.h"        /* loft_sheet, loft_sector */

typedef struct engine_sheet_list {
    loft_sheet *sheet;
    size_t count, room;
} engine_sheet_list;

/* Room for one more, which is counted. */
loft_sheet *ENGINE_OF(engine_sheet_add)(engine_sheet_list *l);

/* Add 4^level sheets of a tensor patch, or one of another surface, which is kept open; of patches
 * with n sides so many for each sector, and more where they have no bounds. Returns enum
 * loft_status: LOFT_ERR_ARG for kinds that have none. */
int ENGINE_OF(engine_sheets)(engine_surface *e, unsigned level, engine_sheet_list *out);

/* Add the sheets of all sectors; sector[loft_sector_count(disk)] must outlive them. */
int ENGINE_OF(engine_sectors)(const loft_disk *disk, loft_sector sector[], unsigned level,
                              engine_sheet_list *out);

/* A net as a part of its surface: parameter k of the surface is from[k] + share[k] . those of
 * the net. On a sphere it is a share of an angle: `round`. On a toric patch it is the
 * point of the polygon. */
typedef struct {
    double from[2], share[2][2];
    bool round;
    const surface *toric;           /* or NULL; or with base points: its quarter at `vertex`,   */
    const loft_lattice_polygon *lattice;        /* the parameters balanced by these             */
    double balance[2];
    unsigned vertex;
} engine_net_part;

static inline void engine_net_place(const engine_net_part *p, double u, double v, double out[2])
{
    const double turn = 4 / acos(-1),
                 at[2] = { p->round ? turn * atan(u) : u, p->round ? turn * atan(v) : v };

    if (p->toric != NULL) {
        sided_quarter(p->toric, p->lattice, p->vertex, u / (u + p->balance[0] * (1 - u)),
                      v / (v + p->balance[1] * (1 - v)), out);
        return;
    }
    for (int k = 0; k < 2; k++)
        out[k] = p->from[k] + p->share[k][0] * at[0] + p->share[k][1] * at[1];
}

/* Visit the nets of a surface: the spans of a NURBS surface, the octants of a sphere, the triangles
 * of an S-patch, the quarters of a toric patch or of one with base points, or one. A visit that
 * returns other than 0 ends it. Returns 0, what the visit returned, or a negative enum loft_status:
 * LOFT_ERR_ARG for kinds without nets. */
typedef int engine_net_visit(void *context, loft_net net, const engine_net_part *part);
int ENGINE_OF(engine_nets)(engine_surface *e, engine_net_visit *visit, void *context);
int ENGINE_OF(engine_ball_nets)(const loft_sphere *s, engine_net_visit *visit, void *context);
int ENGINE_OF(engine_sided_nets)(const engine_sided *e, engine_net_visit *visit, void *context);

#endif
