/* host-tools/engine/harmonic.h -- the series of lib/polygon/harmonic.h for a polygon: Laplace's
 * equation, solved on the host
 * SPDX-License-Identifier: MIT
 *
 * The terms are harmonic, so only the boundary counts: coefficients are the least squares of the
 * error on points of all
 * edges, close together where the polygon is narrow and toward the vertices. What terms to take is
 * tried, small series first.
 * All in long double.
 *
 *     harmonic_series s;
 *     if (harmonic_solve(v, 5, HARMONIC_TARGET_F64, &s)) ..        s.bound is what was reached
 *     harmonic_free(&s);
 */
#ifndef LOFT_HARMONIC_H
#define LOFT_HARMONIC_H

#include <stdbool.h>
#include <stdio.h>

#define HARMONIC_SIDES 8
#define HARMONIC_POLES 200

typedef struct {
    long double error;      /* to be reached on the boundary                            */
    long double grain;      /* coefficients are multiples of it; 0: they are doubles    */
} harmonic_target;

#define HARMONIC_TARGET_Q16 ((harmonic_target){ 0x1p-22L, 0x1p-32L })
#define HARMONIC_TARGET_F32 ((harmonic_target){ 1e-9L, 0 })
#define HARMONIC_TARGET_F64 ((harmonic_target){ 2e-14L, 0 })

/* What loft_harmonic_eval errs by beside the bound, in any number type: this times `weight`. */
#define HARMONIC_ROUNDING 0x1p-48L

/* As loft_harmonic_table, which explains the members. */
typedef struct {
    double v[HARMONIC_SIDES][2];
    unsigned sides, terms, poles, degree, powers[HARMONIC_SIDES], straight;
    long double pole[HARMONIC_POLES][3];        /* x, y, size                                 */
    long double *coefficient;                   /* [terms * sides], rounded as the target says */
    long double bound;                          /* twice the largest error on a boundary sample */
    long double largest;                        /* the largest coefficient                    */
    long double weight;                         /* of one coordinate: the largest sum of
                                                 * absolute values of coefficients            */
    unsigned points, tried;                     /* of that sample; series that were solved    */
} harmonic_series;

/* Find a series for a simple polygon, counter-clockwise, whose bound is that of the target, or the
 * best one when there is
 * none; the result says whether it was reached.
 *
 *   cost    some 0.1 s for 1e-6, a few seconds for 1e-14 and for narrow polygons */
bool harmonic_solve(double v[][2], unsigned sides, harmonic_target target, harmonic_series *out);

/* The coordinates of a point inside or on the boundary, in long double. */
void harmonic_at(const harmonic_series *s, const double p[2], long double phi[]);

void harmonic_free(harmonic_series *s);

#endif
