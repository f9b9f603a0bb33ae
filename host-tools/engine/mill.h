/* host-tools/engine/mill.h -- surfaces milled by lines: the order, the path, what is known of it
 * SPDX-License-Identifier: MIT
 *
 *     engine_mill.c     lib/toolpath over the surfaces of a file; compiled once per number type
 *     engine_levels.c   waterlines, level by level; likewise
 */
#ifndef LOFT_HOST_MILL_H
#define LOFT_HOST_MILL_H

#include "engine/engine.h"      /* engine_point_sink */
#include "engine/surface.h"     /* surfaces */

/* What is asked. Lengths in mm. */
typedef struct {
    double radius, corner;      /* of the cutter: equal for a ball, corner 0 for a flat end */
    double cusp, step;          /* one of them is 0 */
    bool levels;                /* waterlines, not lines from border to border */
    double tol;
    unsigned axis;              /* along which lines run: 0, x; 1, y */
    bool bounded, floored;      /* area, lowest are given; otherwise those of the surfaces */
    double area[2][2];          /* the smallest x and y, the largest */
    double lowest;              /* height of the tip */
} mill_order;

/* What came of it. */
typedef struct {
    size_t lines;
    double cusp;                /* the largest one, 0 if only a step was asked */
    double top;                 /* of the surfaces' control points */
    size_t failed;              /* after an error: the surface, or all->count */
} mill_report;

/* Give the points of the path. `o` is completed. Returns enum loft_status. */
typedef int engine_mill(const surfaces *all, mill_order *o, engine_point_sink *sink, void *context,
                        mill_report *out);

extern engine_mill engine_mill_q16, engine_mill_f32, engine_mill_f64;

#endif
