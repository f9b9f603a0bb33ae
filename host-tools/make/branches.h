/* host-tools/make/branches.h -- lines in space that were found in parts: those that end at one
 * place are joined, those that were found twice are kept once
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_BRANCHES_H
#define LOFT_HOST_BRANCHES_H

#include <stdbool.h>
#include <stddef.h>

#include "engine/engine.h"      /* ENGINE_AXES */

/* A line, or one point. `touch`: a place where it is not decided. */
typedef struct {
    double (*p)[ENGINE_AXES];
    size_t count;
    bool touch;
} branch;

typedef struct {
    branch *line;
    size_t count, room;
    double tol;
} branches;

/* Add a line, unless all its points are within 2 tol of one that is there. */
void branches_add(branches *b, const double (*p)[ENGINE_AXES], size_t count, bool touch);

/* Join the lines whose ends are within tol / 4 of each other, as straight on as can be. Drop single
 * points within 2 tol of a line. */
void branches_join(branches *b);

void branches_free(branches *b);

#endif
