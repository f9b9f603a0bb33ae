/* host-tools/engine/surface.h -- any kind of surface, as it stands in a file: points with what
 * belongs to them
 * SPDX-License-Identifier: MIT
 *
 *     surface.c       the kinds, the list, telling their files apart
 *     surface_text.c  surfaces in the text format .loft (LOFT.md)
 *     engine.h        what the library makes of them
 *     mesh.h          triangles of them, normals and curvatures; STL and PLY
 *     sided.h         those with n sides: their polygons, nets, and grids over them
 *     surface_plot.h  pictures
 *
 * A surface runs over u, v in 0..1; one over a triangle where u + v <= 1 as well: u is the share of
 * the second corner, v that of the third. On a sphere u goes from the pole down, v around. One with
 * n sides (sided.h) has parameters of its own.
 */
#ifndef LOFT_HOST_SURFACE_H
#define LOFT_HOST_SURFACE_H

#include <stdbool.h>
#include <stddef.h>

#define SURFACE_AXES       3
#define SURFACE_DEGREE_MAX 9        /* of the library */
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
    /* with n sides */
    SURFACE_SPATCH,
    SURFACE_TORIC,
    SURFACE_BASEPOINT,
    SURFACE_RING,
    SURFACE_GB,
    SURFACE_KINDS
};

/* With respect to the vertices of a polygon. */
enum surface_coordinates { COORDINATES_WACHSPRESS, COORDINATES_MEANVALUE, COORDINATES_HARMONIC };

/* A point and what stands behind it. */
typedef struct {
    double p[SURFACE_AXES];
    double d[SURFACE_AXES];     /* pn: the normal                        */
    double w;                   /* where the kind has weights: it        */
    double c;                   /* toric: the coefficient                */
} surface_point;

/* Some of the vertices of a polygon, which are those of a convex one. */
typedef struct {
    unsigned sides, vertex[SURFACE_SIDES_MAX];
} surface_part;

typedef struct surface {
    enum surface_kind kind;
    unsigned m, n;              /* degrees along u and v; a triangle has m alone; of n sides m is
                                 * the degree or depth */
    unsigned orders;            /* coons: 1 bilinear, 2 with slopes, 3 with curvatures */
    bool rational;              /* some weight was given */
    double radius;              /* sphere, octant: their only point is the centre */
    surface_point *point;
    unsigned count;
    double domain[SURFACE_SIDES_MAX][2];        /* with n sides: the vertices of its polygon    */
    unsigned corners;           /* how many of them were given                          */
    surface_part part[SURFACE_PARTS_MAX];       /* what diagonals cut it into           */
    unsigned parts;
    enum surface_coordinates coordinates;
    unsigned cut[3];            /* basepoint                                            */
    unsigned line;              /* where it starts in the file                          */
} surface;

typedef struct surfaces {
    surface *surface;
    size_t count;
} surfaces;

const char *surface_name(enum surface_kind kind);

/* Is its domain the triangle u + v <= 1? */
bool surface_is_triangle(const surface *s);

/* Has it n sides? */
bool surface_is_sided(const surface *s);

/* How many kites a grid over it has: one for each side of each part of n sides, otherwise 1; and
 * the parameters in the middle of the first part. */
unsigned surface_kites(const surface *s);
void     surface_middle(const surface *s, double uv[2]);

/* What a status means when it is about this surface. */
const char *surface_status(const surface *s, int status);

/* How many points it has. */
unsigned surface_points(const surface *s);

/* Append a surface without points, or a point to the last one. */
surface *surfaces_add(surfaces *all, enum surface_kind kind, unsigned line);
void     surface_add_point(surface *s, const surface_point *p);
void     surfaces_free(surfaces *all);

/* Read `file` ("-" is standard input) if it holds surfaces; otherwise *all stays empty and the file
 * may be read as something else. Gives 0 or an exit code after printing one line. `*all` must be
 * zeroed. */
int surfaces_read(surfaces *all, const char *file);

/* The same, and a file without surfaces is an error. */
int surfaces_read_only(surfaces *all, const char *file);

/* The text format: does a surface begin with this word, and what a text holds. */
bool surface_begins(const char *word);
int  surfaces_read_text(surfaces *all, const char *file, const char *text);

#endif
