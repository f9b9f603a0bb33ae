/* tests/bench/bench_peers.h -- other libraries, callable from C, for bench_peers.c
 * SPDX-License-Identifier: MIT
 *
 * Each fills out[][0..1] with points, or with parameters of the first and of the second curve, and
 * returns how many.
 */
#ifndef BENCH_PEERS_H
#define BENCH_PEERS_H

#define MOST 4096

#ifdef __cplusplus
extern "C" {
#endif

unsigned bench_agg_curve4_div(double p[4][2], double tol, double (*out)[4]);

unsigned bench_occt_flat(double p[4][2], double tol, double (*out)[4]);
unsigned bench_occt_near(double p[4][2], const double from[2], double (*out)[4]);
unsigned bench_occt_cross(double a[4][2], double b[4][2], double tol, double (*out)[4]);
unsigned bench_occt_spline(double p[][2], int points, const double knots[], int degree,
                           const double u[], int count, double (*out)[4]);

unsigned bench_lyon_flat(double p[4][2], double tol, double (*out)[4]);
unsigned bench_lyon_cross(double a[4][2], double b[4][2], double (*out)[4]);
unsigned bench_kurbo_flat(double p[4][2], double tol, double (*out)[4]);
unsigned bench_kurbo_near(double p[4][2], const double from[2], double tol, double (*out)[4]);

#ifdef __cplusplus
}
#endif

#endif
