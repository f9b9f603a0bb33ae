/* host-tools/engine/harmonic_solver.h -- the series of lib/polygon/harmonic.h for a polygon:
 * Laplace's equation, solved on the host
 * SPDX-License-Identifier: MIT
 *
 * The terms are harmonic, so only the boundary counts. The coefficients are the damped least
 * squares of the error at points of all edges, which are dense near vertices and narrow places.
 * The solver tries small series first, then larger ones. All in long double.
 *
 *     harmonic_series s;
 *     if (harmonic_solve(v, 5, HARMONIC_TARGET_F64, &s)) ..        s.bound is what was reached
 *     harmonic_free(&s);
 */
#ifndef LOFT_HARMONIC_SOLVER_H
#define LOFT_HARMONIC_SOLVER_H

#include <stdbool.h>
#include <stdio.h>

#define HARMONIC_SIDES 8
#define HARMONIC_POLES 800

typedef struct {
    long double error;      /* to be reached on the boundary                            */
    long double rounding;   /* to be reached by what the library's rounding adds        */
    long double grain;      /* coefficients are multiples of it; 0: they are doubles    */
    long double damping;    /* what a coefficient of 1 counts, as an error              */
} harmonic_target;

#define HARMONIC_TARGET_Q16 ((harmonic_target){ 0x1p-22L, 5e-7L, 0x1p-32L, 3e-13L })
#define HARMONIC_TARGET_F32 ((harmonic_target){ 1e-9L, 5e-7L, 0, 3e-13L })
#define HARMONIC_TARGET_F64 ((harmonic_target){ 2e-14L, 7e-13L, 0, 3e-14L })

/* What loft_harmonic_eval errs by beside the bound, in any number type: this times `weight`. */
#define HARMONIC_ROUNDING 0x1p-48L

/* As loft_harmonic_table, which explains the members. */
typedef struct {
    double v[HARMONIC_SIDES][2];
    unsigned sides, terms, poles, degree, powers[HARMONIC_SIDES], straight;
    unsigned corner_poles[HARMONIC_SIDES];      /* they come before the `poles` in the plane  */
    unsigned pole_count;                        /* of both kinds                              */
    long double pole[HARMONIC_POLES][3];        /* x, y, size                                 */
    long double *coefficient;                   /* [terms * sides], rounded as the target says */
    long double bound;                          /* of the error on the whole boundary */
    long double largest;                        /* the largest coefficient                    */
    long double weight;                         /* of one coordinate: the largest sum of
                                                 * absolute values of coefficients            */
    unsigned points, tried;                     /* that the bound took; series that were solved */
} harmonic_series;

/* Find a series for a simple polygon, counter-clockwise, that reaches the target, or the best one
 * that was tried. The result says whether it was reached.
 *
 *   cost    some 0.1 s for 1e-6, a few seconds for 1e-14 and for narrow polygons */
bool harmonic_solve(double v[][2], unsigned sides, harmonic_target target, harmonic_series *out);

/* The coordinates of a point inside or on the boundary, in long double. */
void harmonic_at(const harmonic_series *s, const double p[2], long double phi[]);

void harmonic_free(harmonic_series *s);

#endif
