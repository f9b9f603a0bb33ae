/* host-tools/draw/refine.h -- triangles of surfaces, halved until they keep a tolerance
 * SPDX-License-Identifier: MIT
 *
 *     refined r = { 0 };
 *     code = refine_surfaces(&r, all, file, e, 0.01);
 *     code = code ? code : refined_mesh(&r, all, file, &m);       // for mesh_write
 *     refined_body(&r, &body);                                    // closed or not; its volume
 *
 * A node is a point that triangles share, also those of different surfaces. So a patch that
 * continues another one along the same edge has the same corners there: no gap opens.
 */
#ifndef LOFT_HOST_REFINE_H
#define LOFT_HOST_REFINE_H

#include "draw/mesh.h"

struct host;                /* base/host.h */

/* A corner of a triangle: its node, and the parameters in the kite of its surface. On a side that
 * is one point a parameter means nothing: `open` has bit 0 for u, bit 1 for v. */
typedef struct {
    double u, v;
    size_t node;
    unsigned char open;
} refined_place;

/* Edge k runs from corner k to the next. */
typedef struct {
    size_t surface, edge[3];
    unsigned kite;
    bool looked;                /* its edges are known, and its middle is */
    refined_place at[3];
} refined_triangle;

/* The line on a surface between two nodes. Lines of two surfaces are one edge if their middles
 * agree. `next` is another one between nodes with the same hash. */
typedef struct {
    size_t node[2], middle_node, next, hash;
    double middle[ENGINE_AXES];
    bool split;
} refined_edge;

typedef struct {
    double (*node)[ENGINE_AXES];
    refined_triangle *triangle;
    refined_edge *edge;
    size_t *first;              /* edges by the hash of their nodes */
    size_t nodes, triangles, edges, room[3], slots;
} refined;

/* Triangles of all surfaces. Measured at three places of each edge and in the middle of each
 * triangle, the surface is within `tol` of them. Returns 0, or an exit code after printing one
 * line. `*r` must be zeroed. */
int refine_surfaces(struct host *h, refined *r, const surfaces *all, const char *file,
                    const engine *e, double tol);
void refined_free(refined *r);

/* The same as cells, with the normal of the surface at each corner. `*m` must be zeroed. */
int refined_mesh(struct host *h, refined *r, const surfaces *all, const char *file, mesh *m);

/* What the triangles are together. The volume is that of a closed body, and negative if it is
 * turned inside out. */
typedef struct {
    size_t triangles, corners, edges;
    size_t open, turned, many;  /* edges of one triangle; of two that run alike; of more than two */
    double area, volume, centroid[ENGINE_AXES];
} refined_sum;

void refined_body(const refined *r, refined_sum *out);

#endif
