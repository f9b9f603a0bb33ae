/* host-tools/cmd/compare.h -- what `loft compare` measures curves and surfaces against
 * SPDX-License-Identifier: MIT
 *
 *     cmd_compare.c       the command; curves
 *     compare_surface.c   surfaces
 */
#ifndef LOFT_HOST_COMPARE_H
#define LOFT_HOST_COMPARE_H

#include "base/option.h"        /* option_list */
#include "engine/engine.h"
#include "engine/surface.h"

#define COMPARE_QUADRIC 10

typedef struct {
    const engine *than;         /* NULL: the definition, in long double                     */
    const char *other;          /* a file: each one of it, or the first one's part; or NULL */
    option_list part;             /* of the first one: from, to; corners of a surface         */
    option_list quadric;          /* xx yy zz xy yz zx x y z 1, or nothing                    */
    unsigned n;                 /* parameters of a piece, j/n                               */
} compare_to;

/* The distance of a point from F = 0, to first order: |F| / |grad F|; at a place without a gradient
 * infinite, or 0 if F is. */
double compare_quadric(const option_list *q, const double p[ENGINE_AXES]);

/* x rounded to the number type; false: it does not fit. */
bool compare_round(const engine *e, double x[], int count);

/* Print the rows of all surfaces in a number type. Returns 0, or an exit code after one line. */
int compare_surfaces(const engine *e, const compare_to *to, const surfaces *all,
                     const surfaces *other, const char *file);

#endif
