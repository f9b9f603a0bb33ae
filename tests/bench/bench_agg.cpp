// tests/bench/bench_agg.cpp -- Anti-Grain Geometry's cubics, callable from C, for bench.c and
// bench_peers.c
// SPDX-License-Identifier: MIT
#include "bench_peers.h"
#include <agg_curves.h>
#include <cmath>

// AGG makes 0.25 * scale * (length of the control polygon) steps; the scale is chosen so that they
// are n.
extern "C" unsigned bench_agg_curve4_inc(const double p[4][2], unsigned n, double (*points)[2])
{
    double length = 0;
    for (int k = 0; k < 3; k++)
        length += std::hypot(p[k + 1][0] - p[k][0], p[k + 1][1] - p[k][1]);

    agg::curve4_inc curve;
    curve.approximation_scale((n + 0.01) / (0.25 * length));
    curve.init(p[0][0], p[0][1], p[1][0], p[1][1], p[2][0], p[2][1], p[3][0], p[3][1]);

    unsigned count = 0;
    double x, y;
    curve.vertex(&x, &y);           // the start
    while (!agg::is_stop(curve.vertex(&x, &y)) && count < n) {
        points[count][0] = x;
        points[count++][1] = y;
    }
    return count;
}

// Its tolerance is half a pixel of the scale.
extern "C" unsigned bench_agg_curve4_div(double p[4][2], double tol, double (*out)[4])
{
    agg::curve4_div curve;
    curve.approximation_scale(0.5 / tol);
    curve.init(p[0][0], p[0][1], p[1][0], p[1][1], p[2][0], p[2][1], p[3][0], p[3][1]);

    unsigned count = 0;
    double x, y;
    curve.vertex(&x, &y);           // the start
    while (!agg::is_stop(curve.vertex(&x, &y)) && count < MOST) {
        out[count][0] = x;
        out[count++][1] = y;
    }
    return count;
}
