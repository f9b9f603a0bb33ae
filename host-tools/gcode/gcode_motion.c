/* host-tools/gcode/gcode_motion.c -- the motions of G-code: straight, arcs, cubics, NURBS
 * SPDX-License-Identifier: MIT
 *
 * Arcs: NIST RS274/NGC version 3, section 3.5.3. G5, G5.1, G5.2: the documentation of LinuxCNC.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gcode/gcode_state.h"

/* Limits of the difference between distances from the centre, as in LinuxCNC: */
#define SPIRAL_PART 0.001       /* of the radius, */
#define SPIRAL      (0.02 * 1.41421356237309505)        /* or mm, in G20 a tenth of it in inches, */
#define SPIRAL_MOST 100         /* and never more than so many times it */
#define CHORD_OVER  0.005       /* mm: the chord of an arc with R may be longer than 2 R */
#define RADIUS_LEAST 1e-6       /* mm */
#define ORDER_MOST  10          /* of a NURBS: degree 9 of the library */

/* From a place by @ and ^: what is not given stays; in G91 both are added. */
void gcode_polar_target(const gcode_program *g, const double from[3], double out[3])
{
    const gcode_block *b = &g->b;
    const double add = g->incremental ? 1 : 0;
    double radius = hypot(from[0], from[1]), angle = atan2(from[1], from[0]);

    if (gcode_has(b, GCODE_RADIUS))
        radius = add * radius + gcode_value(b, GCODE_RADIUS);
    if (gcode_has(b, GCODE_ANGLE))
        angle = add * angle + gcode_value(b, GCODE_ANGLE) * (acos(-1) / 180);
    out[0] = radius * cos(angle);
    out[1] = radius * sin(angle);
}

void gcode_target(const gcode_program *g, double out[3])
{
    for (int i = 0; i < 3; i++) {
        const bool given  = gcode_has(&g->b, (char)('X' + i));
        const double said = gcode_value(&g->b, (char)('X' + i));
        out[i] = !given ? g->at[i] : g->incremental ? g->at[i] + said : said;
    }
    if (gcode_has(&g->b, GCODE_RADIUS) || gcode_has(&g->b, GCODE_ANGLE))
        gcode_polar_target(g, g->at, out);
}

unsigned char gcode_loose_there(const gcode_program *g)
{
    unsigned char out = g->loose;

    for (int i = 0; i < 3; i++)
        if (gcode_has(&g->b, (char)('X' + i)) && !g->incremental)
            out = (unsigned char)((out & ~(1 << i)) | (g->tied & 1 << i));
    return out;
}

/* G53: the words are coordinates of the machine, whatever the tool's length. */
static int target_of_machine(const gcode_program *g, double out[3])
{
    double machine[3];

    if (g->incremental)
        return gcode_fails(g, "gcode.machine-place-incremental", "G53 with G91", "give G90 first");
    gcode_machine_place(g, g->at, machine);
    for (int i = 0; i < 3; i++)
        if (gcode_has(&g->b, (char)('X' + i)))
            machine[i] = gcode_value(&g->b, (char)('X' + i));
    gcode_program_place(g, machine, out);
    for (int i = 0; i < 3; i++) /* what does not move keeps its digits */
        if (!gcode_has(&g->b, (char)('X' + i)) && (i == 2 || !(fabs(g->frame.degrees) > 0)))
            out[i] = g->at[i];
    return 0;
}

static bool line_has(const gcode_program *g, int code)
{
    for (unsigned i = 0; i < g->b.gs; i++)
        if (g->b.g[i] == code)
            return true;
    return false;
}


// Arcs
// ----

/* The distance from the centre. */
static double radius_at(const gcode_program *g, const double centre[3], const double at[3])
{
    return hypot(at[gcode_first(g)] - centre[gcode_first(g)],
                 at[gcode_second(g)] - centre[gcode_second(g)]);
}

/* The centre on the left or on the right of the chord. */
static int centre_by_radius(const gcode_program *g, double turn, gcode_event *e)
{
    const int a = gcode_first(g), b = gcode_second(g);
    const double r = gcode_value(&g->b, 'R'), x = e->to[a] - g->at[a], y = e->to[b] - g->at[b],
                 half = hypot(x, y) / 2;
    const double over = half - fabs(r);
    char what[96];

    if (!(half > 0))
        return gcode_fails(g, "gcode.arc-no-way", "an arc with R that ends where it starts",
                           "give its centre by I, J, K for a full circle");
    if (over > SPIRAL_PART * fabs(r) && over * g->frame.unit > CHORD_OVER) {
        snprintf(what, sizeof what, "R%.9g is too small for ends %.9g apart", r, 2 * half);
        return gcode_fails(g, "gcode.arc-radius-short", what, "correct R");
    }
    const double off = over < 0 ? sqrt((fabs(r) - half) * (fabs(r) + half)) : 0,
                 side = turn * (r < 0 ? -1 : 1) * off / (2 * half);
    e->centre[a] = (g->at[a] + e->to[a]) / 2 - side * y;
    e->centre[b] = (g->at[b] + e->to[b]) / 2 + side * x;
    return 0;
}

static int centre_by_offset(const gcode_program *g, gcode_event *e)
{
    const int axis[2] = { gcode_first(g), gcode_second(g) };
    double r[2];
    char what[128];
    bool any = false;

    for (int i = 0; i < 2; i++) {
        const char letter = (char)('I' + axis[i]);
        const bool given  = gcode_has(&g->b, letter);
        any = any || given;
        if (!given && g->centre_absolute)
            return gcode_fails(g, "gcode.arc-centre-half",
                               "an arc without both numbers of its centre",
                               "in G90.1 give both, or G91.1 before");
        e->centre[axis[i]] = (given ? gcode_value(&g->b, letter) : 0) +
                             (g->centre_absolute ? 0 : g->at[axis[i]]);
    }
    if (!any)
        return gcode_fails(g, "gcode.arc-no-centre", "an arc without I, J, K in its plane or R",
                           "give its centre, or its radius");
    r[0] = radius_at(g, e->centre, g->at);
    r[1] = radius_at(g, e->centre, e->to);
    const double off = fabs(r[0] - r[1]), most = g->frame.unit > 2 ? SPIRAL / 10 : SPIRAL;
    if (off > SPIRAL_MOST * most || (off > most && off > SPIRAL_PART * fmax(r[0], r[1]))) {
        snprintf(what, sizeof what, "an arc that starts %.9g and ends %.9g from its centre", r[0],
                 r[1]);
        return gcode_fails(g, "gcode.arc-centre", what, "correct I, J, K, or write more digits");
    }
    if (!(r[0] * g->frame.unit > RADIUS_LEAST))
        return gcode_fails(g, "gcode.arc-no-radius", "an arc without a radius", "correct I, J, K");
    return 0;
}

static int move_arc(gcode_program *g)
{
    gcode_event e    = { .kind = GCODE_ARC };
    const int turn   = g->motion == 30 ? 1 : -1;
    const bool has_p = gcode_has(&g->b, 'P') && !g->printer;
    const double p   = has_p ? gcode_value(&g->b, 'P') : 1;

    if (!(p >= 1 && p <= 4096) || p > floor(p))
        return gcode_fails(g, "gcode.arc-turns", "P of an arc is its number of turns",
                           "give a whole number from 1 to 4096");
    e.turns = turn * (int)p;
    gcode_target(g, e.to);
    memcpy(e.centre, g->at, sizeof e.centre);
    const int code = gcode_has(&g->b, 'R') ? centre_by_radius(g, turn, &e)
                                           : centre_by_offset(g, &e);
    e.plane = g->plane;
    memcpy(e.from, g->at, sizeof e.from);
    return code == 0 ? gcode_give(g, &e, g->feed_mode == 930 ? gcode_arc_length(&e) : 0) : code;
}


// Cubics
// ------

static double length_of_legs(const gcode_program *g, const gcode_event *e)
{
    const double *a = g->at, (*m)[3] = e->inner, *z = e->to;

    return hypot(m[0][0] - a[0], m[0][1] - a[1]) + hypot(m[1][0] - m[0][0], m[1][1] - m[0][1]) +
           hypot(z[0] - m[1][0], z[1] - m[1][1]);
}

static int check_curve(const gcode_program *g)
{
    if (g->plane != 2)
        return gcode_fails(g, "gcode.cubic-plane", "G5 outside of the plane of x and y",
                           "give G17 before");
    if (gcode_has(&g->b, 'Z'))
        return gcode_fails(g, "gcode.cubic-height", "G5 with Z",
                           "it lies in the plane of x and y: leave Z out");
    return 0;
}

/* G5: I J from the start, P Q from the end. Without I J it goes on as the cubic before ended. */
static int move_cubic(gcode_program *g)
{
    const gcode_block *b = &g->b;
    const bool i = gcode_has(b, 'I'), j = gcode_has(b, 'J');
    gcode_event e = { .kind = GCODE_CUBIC };

    if (i != j || (!i && !g->after_cubic))
        return gcode_fails(g, "gcode.cubic-first-control", "G5 without I and J",
                           "give both; only behind a G5 none are needed");
    if (!gcode_has(b, 'P') || !gcode_has(b, 'Q'))
        return gcode_fails(g, "gcode.cubic-last-control", "G5 without P and Q", "give both");
    gcode_target(g, e.to);
    memcpy(e.inner[0], g->at, sizeof e.inner[0]);
    memcpy(e.inner[1], e.to, sizeof e.inner[1]);
    e.inner[0][0] += i ? gcode_value(b, 'I') : -g->last_pq[0];
    e.inner[0][1] += i ? gcode_value(b, 'J') : -g->last_pq[1];
    e.inner[1][0] += g->last_pq[0] = gcode_value(b, 'P');
    e.inner[1][1] += g->last_pq[1] = gcode_value(b, 'Q');
    g->after_cubic = true;
    return gcode_give(g, &e, g->feed_mode == 930 ? length_of_legs(g, &e) : 0);
}

/* G5.1: I J from the start to the one control point. */
static int move_quadratic(gcode_program *g)
{
    gcode_event e = { .kind = GCODE_QUADRATIC };

    if (!gcode_has(&g->b, 'I') && !gcode_has(&g->b, 'J'))
        return gcode_fails(g, "gcode.quadratic-control", "G5.1 without I and J",
                           "give the control point from the start");
    gcode_target(g, e.to);
    for (int i = 0; i < 3; i++)
        e.inner[0][i] = g->at[i] + (i < 2 && gcode_has(&g->b, (char)('I' + i))
                                        ? gcode_value(&g->b, (char)('I' + i))
                                        : 0);
    memcpy(e.inner[1], e.inner[0], sizeof e.inner[1]);
    return gcode_give(g, &e, g->feed_mode == 930 ? length_of_legs(g, &e) : 0);
}

static int add_pole(gcode_program *g, double x, double y)
{
    double *pole = g->pole[g->poles];

    if (g->poles == GCODE_POLES)
        return gcode_fails(g, "gcode.nurbs-points", "a NURBS of more than 1024 control points",
                           "split it");
    if (!(g->pole_weight > 0))
        return gcode_fails(g, "gcode.nurbs-weight", "a weight that is not above 0",
                           "give P above 0");
    pole[0] = x;
    pole[1] = y;
    pole[2] = g->pole_weight;
    g->poles++;
    return 0;
}

/* G5.2 X Y P L: a control point, its weight and the order. The first one is where the tool is; a
 * first line without X Y gives its weight. */
static int move_nurbs(gcode_program *g)
{
    const gcode_block *b = &g->b;
    const bool point = gcode_has(b, 'X') || gcode_has(b, 'Y');
    const double order = gcode_has(b, 'L') ? gcode_value(b, 'L') : 3;
    int code = 0;

    g->pole_weight = gcode_has(b, 'P') && (point || g->poles > 0) ? gcode_value(b, 'P') : 1;
    if (g->poles == 0) {
        const double said = g->pole_weight;
        if (!(order >= 2 && order <= ORDER_MOST) || order > floor(order))
            return gcode_fails(g, "gcode.nurbs-order", "L of G5.2 is the order",
                               "give 2 to 10; 3 if it is left out");
        g->degree      = (unsigned)order - 1;
        g->pole_line   = b->line;
        g->pole_weight = !point && gcode_has(b, 'P') ? gcode_value(b, 'P') : 1;
        code = add_pole(g, g->at[0], g->at[1]);
        g->pole_weight = said;
    }
    if (code != 0 || !point)
        return code;
    const double *last = g->pole[g->poles - 1];
    const double x = gcode_has(b, 'X') ? gcode_value(b, 'X') + (g->incremental ? last[0] : 0)
                                       : last[0],
                 y = gcode_has(b, 'Y') ? gcode_value(b, 'Y') + (g->incremental ? last[1] : 0)
                                       : last[1];
    return add_pole(g, x, y);
}

int gcode_nurbs_end(gcode_program *g)
{
    gcode_event e = { .kind = GCODE_NURBS,
                      .points = (const double(*)[3])g->pole,
                      .count = g->poles,
                      .degree = g->degree };
    double length = 0;

    if (g->poles == 0)
        return gcode_fails(g, "gcode.nurbs-not-begun", "G5.3 without G5.2",
                           "begin the NURBS with G5.2");
    if (g->poles <= g->degree)
        return gcode_fails(g, "gcode.nurbs-few-points",
                           "a NURBS with fewer control points than its order",
                           "give more, or a smaller L");
    e.to[0] = g->pole[g->poles - 1][0];
    e.to[1] = g->pole[g->poles - 1][1];
    e.to[2] = g->at[2];
    for (unsigned i = 1; i < g->poles; i++)
        length += hypot(g->pole[i][0] - g->pole[i - 1][0], g->pole[i][1] - g->pole[i - 1][1]);
    g->poles  = 0;
    g->motion = GCODE_CANCEL;
    return gcode_give(g, &e, length);
}


// All motions
// -----------

static int move_straight(gcode_program *g)
{
    double to[3];
    int code = 0;

    g->homing = line_has(g, 530);
    g->homed  = g->loose;
    for (int i = 0; i < 3; i++)
        if (gcode_has(&g->b, (char)('X' + i)))
            g->homed &= (unsigned char)~(1 << i);
    if (g->homing)
        code = target_of_machine(g, to);
    else
        gcode_target(g, to);
    if (code == 0)
        code = gcode_go(g, g->motion == 0 ? GCODE_RAPID : GCODE_LINE, to);
    g->homing = false;
    return code;
}

/* While the tool is beside the path, and on its way back. */
static int check_beside(const gcode_program *g)
{
    const bool arc = g->motion == 20 || g->motion == 30;

    if (arc && g->radius.side != 0)
        return 0;
    if (g->radius.side == 0)
        return gcode_fails(g, "gcode.compensation-leave",
                           "a motion behind G40 that is not straight",
                           "give G0 or G1 first, which leads back to the path");
    return gcode_fails(g, "gcode.compensation-motion",
                       "a motion that is neither straight nor an arc, in G41 or G42",
                       "give G40 before");
}

int gcode_move(gcode_program *g)
{
    const bool after_cubic = g->after_cubic;
    int code = 0;

    if (g->poles > 0 && g->motion != 52 && g->motion != 53)
        return gcode_fails(g, "gcode.nurbs-motion", "a motion between G5.2 and G5.3",
                           "end the NURBS with G5.3");
    g->after_cubic = false;
    if (g->motion < 730 || g->motion == GCODE_CANCEL)
        g->cycle.code = 0, g->cycle.leveled = false;
    if (g->apart && g->motion != 0 && g->motion != 10 && g->motion != GCODE_CANCEL)
        code = check_beside(g);
    if (code == 0 && (g->motion == 50 || g->motion == 51 || g->motion == 52))
        code = check_curve(g);
    if (code != 0)
        return code;
    switch (g->motion) {
    case 0:
    case 10: return move_straight(g);
    case 20:
    case 30: return move_arc(g);
    case 50: g->after_cubic = after_cubic; return move_cubic(g);
    case 51: return move_quadratic(g);
    case 52: return move_nurbs(g);
    case 53: return gcode_nurbs_end(g);
    case GCODE_CANCEL:
        return line_has(g, 800) ? 0
                                : gcode_fails(g, "gcode.no-motion", "X, Y or Z without a motion",
                                              "give G0, G1, G2 or G3 with it");
    default: return gcode_drill(g);
    }
}
