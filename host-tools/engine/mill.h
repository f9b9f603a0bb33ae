/* host-tools/engine/mill.h -- surfaces milled by lines: the order, the path, what is known of it
 * SPDX-License-Identifier: MIT
 *
 *     engine_mill.c     lib/toolpath over the surfaces of a file; compiled once per number type
 *     engine_levels.c   waterlines, level by level; likewise
 *     engine_isolines.c lines of constant parameters; likewise
 *     engine_pencils.c  valleys; likewise
 *     engine_touch.c    where a tool must be to touch all of the surfaces; likewise
 *     engine_left.c     what the path leaves, at most; likewise
 *     engine_links.c    the ways between lines, and into the material; likewise
 *     mill_cuts.c       lines, and the order in which they are cut
 *     mill_trim.h       reads loops to which surfaces are trimmed
 */
#ifndef LOFT_HOST_MILL_H
#define LOFT_HOST_MILL_H

#include "engine/engine.h"      /* engine_point_sink */
#include "engine/surface.h"     /* surfaces */

enum mill_pattern { MILL_RASTER, MILL_SPIRAL, MILL_WATERLINE, MILL_PENCIL };

/* How the tool goes down to a line: straight, along the line, or around. */
enum mill_entry { MILL_STRAIGHT, MILL_RAMP, MILL_HELIX, MILL_ENTRIES };

/* Closed loops, in chords within `tol`: of x and y (`plane`), or of u and v. */
typedef struct {
    double (*edge)[2][2];
    size_t count;
    double tol;
    bool plane;
} mill_trim;

/* What is asked. Lengths in mm. */
typedef struct {
    enum mill_pattern pattern;
    double radius, corner;      /* of the cutter: equal for a ball, corner 0 for a flat end */
    double cusp, step;          /* one of them is 0 */
    double tol;
    unsigned axis;              /* along which lines run: 0, x; 1, y */
    bool one_way;               /* all lines in one direction, with ways back above */
    bool parametric;            /* 0, u; 1, v: then step is one of the other parameter */
    bool bounded, floored;      /* area, lowest are given; otherwise of the surfaces */
    double area[2][2];          /* the smallest x and y, the largest */
    double lowest;              /* height of the tip */
    bool stocked;               /* the surfaces are cut out of a block */
    double stock[2];            /* the heights of its bottom and top */
    enum mill_entry entry;
    double slope, around;       /* of ramps and helices: the tangent; the radius of a helix */
    mill_trim trim;             /* no edge: the whole surfaces */
    double safe;                /* above all of it, where the path begins and ends; with a block
                                 * ways between lines are there too */
    void (*tell)(void *context, double share);      /* of the work that is done */
    void *context;
} mill_order;

/* What came of it. */
typedef struct {
    size_t lines;
    size_t entries[MILL_ENTRIES];
    double ways;                /* length of what is between lines */
    double cusp;                /* the largest one, 0 if only a step was asked */
    double left;                /* of material on the surfaces by the path, at most: within tol / 4
                                 * if a cusp was asked, otherwise within 1/64 of it */
    double hollow, reached;     /* by a tool that may be anywhere, at most; if that is no more than
                                 * `reached` it was not looked at more closely */
    double top;                 /* of the surfaces' control points */
    double clear;               /* above the surfaces and the block */
    double depth;               /* of what a line cuts, at most: from there down ramps begin */
    size_t failed;              /* after an error: the surface, or all->count */
} mill_report;

/* A line that is cut without a way between: at a closed one the last point is the first. */
typedef struct {
    double (*point)[ENGINE_AXES];
    size_t count;
    unsigned level;             /* 0 is the highest */
    bool closed, done;
} mill_cut;

typedef struct {
    mill_cut *cut;
    size_t count, room;
} mill_cuts;

/* Begin a cut, and add a point to the last one. */
mill_cut *mill_cuts_begin(mill_cuts *all, unsigned level);
void mill_cuts_add(mill_cuts *all, const double point[ENGINE_AXES]);
void mill_cuts_free(mill_cuts *all);

/* Turn cuts about that run down along this axis. */
void mill_cuts_one_way(mill_cuts *all, unsigned axis);

/* Let a closed cut begin at one of its points. */
void mill_cut_turn(mill_cut *c, size_t first);

/* Put the cuts into order, and turn the closed ones to where the tool comes from. What is above is
 * cut before what is below it: of two nested lines, or such that come nearer than `apart`, one
 * level apart, the higher one is the first. Of all that may be next the nearest one is taken. */
void mill_cuts_order(mill_cuts *all, double apart);

/* Find the path: one cut, or none after an error. `o` is completed; mill_cuts_free(path). Returns
 * enum loft_status. */
typedef int engine_mill(const surfaces *all, mill_order *o, mill_cuts *path, mill_report *out);

extern engine_mill engine_mill_q16, engine_mill_f32, engine_mill_f64;

#endif
