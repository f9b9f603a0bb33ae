/* host-tools/engine/surface.h -- any kind of surface, as a file gives it: points with their weights
 * or normals
 * SPDX-License-Identifier: MIT
 *
 *     surface.c       the kinds, the list
 *     surface_text.h  files of them, in the text format .loft (LOFT.md)
 *     engine.h        their representation in the library
 *     mesh.h          triangles of them, normals and curvatures; STL and PLY
 *     sided.h         surfaces with n sides: their polygons, nets and grids
 *     drawn_surface.h those of higher degrees, in pictures
 *     solid.h         tetrahedra: their faces
 *     surface_plot.h  pictures
 *
 * The parameters of a surface are u, v in 0..1. Over a triangle u + v <= 1 as well: u is the share
 * of the second corner, v that of the third. On a sphere u goes down from the pole, v around. A
 * surface with n sides (sided.h) has its own parameters.
 */
#ifndef LOFT_HOST_SURFACE_H
#define LOFT_HOST_SURFACE_H

#include <stdbool.h>
#include <stddef.h>

#define SURFACE_AXES       3
#define SURFACE_DEGREE_MAX 9        /* of the library */
#define SURFACE_DRAWN_MAX  32       /* of `tensor` and `triangle` in pictures: drawn_surface.h */
#define SURFACE_SIDES_MAX  8
#define SURFACE_PARTS_MAX  6        /* convex ones of a polygon */

enum surface_kind {
    SURFACE_TENSOR,
    SURFACE_TRIANGLE,
    SURFACE_COONS,
    SURFACE_BICUBIC,
    SURFACE_PN,
    SURFACE_SPHERE,
    SURFACE_OCTANT,
    SURFACE_GREGORY,
    SURFACE_NURBS,
    SURFACE_TETRA,              /* three parameters: solid.h */
    /* with n sides */
    SURFACE_SPATCH,
    SURFACE_TORIC,
    SURFACE_BASEPOINT,
    SURFACE_RING,
    SURFACE_GB,
    SURFACE_KINDS
};

/* Coordinates with respect to the vertices of a polygon. */
enum surface_coordinates { COORDINATES_WACHSPRESS, COORDINATES_MEANVALUE, COORDINATES_HARMONIC };

/* A point and its attributes. */
typedef struct {
    double p[SURFACE_AXES];
    double d[SURFACE_AXES];     /* pn: the normal                        */
    double w;                   /* the weight, if the kind has weights */
    double c;                   /* toric: the coefficient                */
} surface_point;

/* A convex part: some of the vertices of a polygon. */
typedef struct {
    unsigned sides, vertex[SURFACE_SIDES_MAX];
} surface_part;

typedef struct surface {
    enum surface_kind kind;
    unsigned m, n;              /* degrees along u and v; triangle and tetra have m; for n sides m
                                 * is the degree or depth */
    unsigned orders;            /* coons: 1 bilinear, 2 with slopes, 3 with curvatures */
    unsigned rows, columns;     /* nurbs: of its net                                        */
    double *knot[2];            /* nurbs: along u and v                                     */
    unsigned knots[2];
    bool split;                 /* gb: a second point at each inner corner                  */
    bool rational;              /* some weight was given */
    double radius;              /* sphere, octant: their only point is the centre */
    surface_point *point;
    unsigned count;
    double domain[SURFACE_SIDES_MAX][2];        /* with n sides: the vertices of its polygon    */
    unsigned corners;           /* how many were given */
    surface_part part[SURFACE_PARTS_MAX];       /* the parts that diagonals cut it into */
    unsigned parts;
    enum surface_coordinates coordinates;
    unsigned cut[3];            /* basepoint                                            */
    unsigned line;              /* its first line in the file */
} surface;

typedef struct surfaces {
    surface *surface;
    size_t count;
    bool solids;                /* asked for: tetrahedra stay what they are, else their faces */
    bool drawn;                 /* asked for: degrees up to SURFACE_DRAWN_MAX                  */
} surfaces;

const char *surface_name(enum surface_kind kind);

/* True if its domain is the triangle u + v <= 1. */
bool surface_is_triangle(const surface *s);

/* True if it has a degree above those of the library. */
bool surface_is_high(const surface *s);

/* True if it has n sides. */
bool surface_is_sided(const surface *s);

/* The number of kites of a grid over it (one for each side of each part of a patch with n sides,
 * otherwise 1), and the parameters in the middle of the first part. */
unsigned surface_kites(const surface *s);
void     surface_middle(const surface *s, double uv[2]);

/* The meaning of a status for this surface. */
const char *surface_status(const surface *s, int status);

/* The number of its points. */
unsigned surface_points(const surface *s);

/* Append a surface without points, or a point to the last one. */
surface *surfaces_add(surfaces *all, enum surface_kind kind, unsigned line);
void     surface_add_point(surface *s, const surface_point *p);
void     surface_add_knot(surface *s, unsigned along, double knot);
void     surfaces_free(surfaces *all);

#endif
