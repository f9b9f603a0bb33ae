/* host-tools/engine/patch_lines.h -- a patch as a machine cuts it by itself: the same curves, of
 * the same numbers
 * SPDX-License-Identifier: MIT
 *
 * engine_lines.c is compiled once per number type: that of the machine.
 */
#ifndef LOFT_HOST_LINES_H
#define LOFT_HOST_LINES_H

#include "wire/patch_code.h"    /* loft_patch_head */

#include "engine/engine.h"      /* engine_move */

#define LINES_POINTS ((LOFT_PATCH_DEGREE + 1) * (LOFT_PATCH_DEGREE + 1))

/* A patch, as it is sent: raw Q16.16 mm. */
typedef struct {
    loft_patch_head head;
    int32_t net[LINES_POINTS][ENGINE_AXES];
    int32_t place[ENGINE_AXES];             /* where it begins and ends */
} lines_patch;

/* A move, and whether it cuts. */
typedef void lines_sink(void *context, const engine_move *m, bool cuts);

/* Check a patch, and give its moves to `sink` if that is not NULL. Returns enum loft_lines_fault of
 * toolpath/lines.h. */
typedef int engine_lines(const lines_patch *p, lines_sink *sink, void *context);

extern engine_lines engine_lines_q16, engine_lines_f32, engine_lines_f64;

#endif
