/* host-tools/send/gcode_write.h -- converts moves to G-code: straight lines, arcs near the curve,
 * or the cubics themselves (G5)
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_GCODE_H
#define LOFT_GCODE_H

#include <stdbool.h>
#include <stddef.h>

#include "plan/toolpath.h"   /* toolpath */

typedef struct {
    char *text;         /* of all lines, each with a 0 in place of its newline */
    size_t used, held;
    struct gcode_line {
        size_t at;      /* in the text                */
        size_t move;    /* the move that it draws */
    } * line;
    size_t count, room;
} gcode;

/* Line n. */
static inline const char *gcode_text(const gcode *g, size_t n) { return g->text + g->line[n].at; }

enum gcode_curves { GCODE_ARCS, GCODE_G5, GCODE_CHORDS };

typedef struct {
    double tol;                 /* mm */
    enum gcode_curves curves;   /* as what they are written; G5 where z does not change */
    bool rapids;                /* travels are G0, without a feed */
} gcode_options;

/* The lines that draw `t`: in mm, absolute, arcs in the plane of x and y, with z as a helix. Events
 * of a program are M3 M4 M5 with S, M8 M9, G4 and M0.
 *
 *   error   arcs and lines leave the curve by at most `tol` mm, and 0.0001 for their decimals
 *   see     NIST RS274/NGC 3 (G1 G2 G3); LinuxCNC's G5, which grblHAL and Marlin have too */
void gcode_make(gcode *g, const toolpath *t, const gcode_options *o);
void gcode_free(gcode *g);

#endif
