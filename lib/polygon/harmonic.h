/* lib/polygon/harmonic.h -- harmonic coordinates of a point with respect to the vertices of any
 * simple polygon
 * SPDX-License-Identifier: MIT
 *
 * phi_i solves Laplace's equation inside and is linear on the edges, 1 at vertex i, 0 at the
 * others. So 0 < phi_i < 1 inside, in polygons that are not convex too, sum phi_i = 1 and
 * sum phi_i v_i = p. There is no formula: the host solves the equation once for a polygon (`loft
 * harmonic`, host-tools/engine/harmonic_solver.h), and what is evaluated is a series
 *
 *     phi_i = sum c_k Im w^k + sum Re, Im of c_k / (s - pole)
 *             + sum Re, Im of c_k / (z - pole) + sum Re, Im of c_k t^k
 *
 * with, at each corner, w = zeta^(pi / angle), the power of the offset from it that is real on both
 * its edges, and s = zeta^(1/2); poles outside; a polynomial. Each term is harmonic, so the error
 * inside is at most the one on the boundary. The host bounds that one between its samples too, and
 * prints it. Polygons without a narrow place have no poles.
 *
 *     static const loft_acc coefficient[] = { .. };
 *     static const loft_harmonic_table table = { .. };             written by the host
 *     loft_harmonic h;
 *     if (loft_harmonic_init(&h, &domain, &table) == LOFT_OK &&
 *         loft_harmonic_eval(&h, p, phi) == LOFT_OK) ..
 *
 *   see     Joshi, Meyer, DeRose, Green, Sanocki, Harmonic coordinates for character articulation
 *           (2007); Betcke, Trefethen, Reviving the method of particular solutions (2005): the
 *           powers; Gopal, Trefethen, Solving Laplace problems with corner singularities via
 *           rational functions (2019): the poles
 */
#ifndef LOFT_POLYGON_HARMONIC_H
#define LOFT_POLYGON_HARMONIC_H

#include "num/angle.h"          /* loft_fine */
#include "polygon/domain.h"     /* loft_domain, loft_spot */
#include "polygon/jet.h"        /* loft_jet */

LOFT_BEGIN_C

/* A pole outside the polygon, in the plane of s or of z, and the numerator of its term. */
typedef struct {
    loft_acc at[2], size;
} loft_harmonic_pole;

/* What the host found. Terms: at each corner its powers, then its poles; the poles in the plane;
 * the powers of the polynomial. Poles have a real and an imaginary part, and so has each power of
 * the polynomial but 1. For each term the coefficients of all coordinates. */
typedef struct {
    const loft_acc *coefficient;                /* terms * sides                        */
    const loft_harmonic_pole *pole;             /* those of s at each corner, then those of z;
                                                 * null when there are none             */
    uint16_t terms;
    uint8_t sides;
    uint16_t poles;                             /* of z                                 */
    uint8_t degree;
    uint8_t powers[LOFT_SIDES_MAX];             /* of w at each corner                  */
    uint8_t straight;                           /* bit i: at corner i the first one is
                                                 * (w - zeta) / (power - 1)             */
    uint16_t corner_poles[LOFT_SIDES_MAX];      /* poles of s at each corner            */
} loft_harmonic_table;

/* What the series has at a corner. */
typedef struct {
    loft_sci power;                     /* pi over the angle                                  */
    loft_sci log_reach;                 /* the logarithm of the distance to the farthest vertex */
    loft_fine start;                    /* the direction of the edge that leaves              */
    loft_acc half;                      /* half the angle                                     */
    loft_acc turn[LOFT_SIDES_MAX];      /* the direction to each vertex from that edge,
                                         * followed along the boundary                        */
} loft_harmonic_corner;

/* Domain and table are borrowed. Do not fill it yourself: call init. */
typedef struct {
    const loft_domain *domain;
    const loft_harmonic_table *table;
    loft_harmonic_corner corner[LOFT_SIDES_MAX];
    loft_sci middle[2], reach;  /* the mean of the vertices, the distance to the farthest       */
} loft_harmonic;

/* Prepare the series that was made for this domain. Both must outlive it.
 *
 *   range   the number of sides and of terms agree, otherwise LOFT_ERR_ARG; *h is untouched then
 *   error   of angles q16: 2^-55   f32, f64: 2^-49
 *   cost    sides^2 angles, sides logarithms; q16: 1.1 kB, f32, f64: 0.9 kB for *h
 */
enum loft_status loft_harmonic_init(loft_harmonic *h, const loft_domain *domain,
                                    const loft_harmonic_table *table) LOFT_CHECKED;

/* The coordinates of p.
 *
 *   shape   phi[sides]
 *   range   p inside, on an edge or at a vertex, otherwise LOFT_ERR_RANGE
 *   error   the table's bound, and for rounding 2^-48 of the sum of its coefficients for one
 *           coordinate: the host prints the sum of both. Bounds of polygons with 4 to 8 sides
 *           that are nowhere narrower than 1/10: q16: 2^-22 with 5..125 terms   f32: 2^-30
 *           f64: 6e-13 with 5..650, a star of 8 sides with 890 and a spiral with 1230.
 *           Narrow polygons, as channels of 1:1000 that turn by 10 degrees, slits of 1:5000,
 *           necks beside slits and corners of 1 degree, have at most 5e-7 with 150 to 1800 terms
 *           in q16. The host refuses what is above 1e-6, after some 30 s at most.
 *           On edges and at vertices as loft_domain_edge. Inside, none is below 2^-48 or above 1
 *   cost    per corner an angle, a sine, a cosine, a logarithm and an exponential, twice where it
 *           has poles; per term a product of complex numbers and one per coordinate, per pole an
 *           inverse; table: 8 bytes a term and coordinate, 24 a pole
 */
enum loft_status loft_harmonic_eval(const loft_harmonic *h, loft_spot p,
                                    loft_sci phi[]) LOFT_CHECKED;

/* The same with derivatives by x and y.
 *
 *   shape   phi[sides]
 *   range   as eval; LOFT_SINGULAR at vertices
 *   error   inside, at a distance r from the boundary and with E that of the table: values E, first
 *           derivatives 4/pi E / r,
 *           second ones 16/pi E / r^2: what a harmonic function of size E in a circle can have
 *   cost    three products of complex numbers and eight of numbers where eval has one
 */
enum loft_status loft_harmonic_jet(const loft_harmonic *h, loft_spot p,
                                   loft_jet phi[]) LOFT_CHECKED;

LOFT_END_C

#endif
