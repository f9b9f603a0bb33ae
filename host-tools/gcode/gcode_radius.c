/* host-tools/gcode/gcode_radius.c -- tool radius compensation of G-code: G40, G41, G42
 * SPDX-License-Identifier: MIT
 *
 * The tool's centre goes beside the programmed path at its radius r: lines are shifted, arcs keep
 * their centre, both exactly. A motion waits until the next one in the plane tells the corner:
 *
 *   outer   the tool turns around the corner, on an arc of radius r
 *   inner   both motions end where their shifted forms meet
 *   less than 0.05 rad   neither: the centre is then r / 800 too near at most
 *
 * The limit is that of LinuxCNC, so that each end is the same there. A motion that an inner corner
 * turns around does not fit, and is refused. The first motion leads from the programmed path to the
 * shifted one.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "gcode/gcode_state.h"

#define PI     3.14159265358979323846
#define CORNER 0.05             /* rad */
#define WRAP   0.1              /* rad: an arc that grows by more has turned around */
#define FAR    1e9              /* units */
#define TOUCH  1e-9             /* of the radius: circles that miss each other by less touch */

/* The path of the tool's centre along a motion: a line, or an arc around `centre`. */
typedef struct {
    double at[2], way[2];       /* where it meets the corner, if nothing is cut; its direction */
    double centre[2], radius;   /* 0: a line */
    int turn;
} trace;

static double dot(const double a[2], const double b[2]) { return a[0] * b[0] + a[1] * b[1]; }

static double cross(const double a[2], const double b[2]) { return a[0] * b[1] - a[1] * b[0]; }

static void in_plane(const gcode_program *g, const double at[3], double out[2])
{
    out[0] = at[gcode_first(g)];
    out[1] = at[gcode_second(g)];
}

static void put_in_plane(const gcode_program *g, const double at[2], double out[3])
{
    out[gcode_first(g)]  = at[0];
    out[gcode_second(g)] = at[1];
}

static void unit(const double from[2], const double to[2], double out[2])
{
    const double length = hypot(to[0] - from[0], to[1] - from[1]);

    for (int i = 0; i < 2; i++)
        out[i] = (to[i] - from[i]) / length;
}

/* Where the centre of the tool is beside `at`, a point of a path in direction `way`. */
static void beside(const gcode_program *g, const double at[2], const double way[2], double out[2])
{
    const double by = g->radius.side * g->radius.r;

    out[0] = at[0] - by * way[1];
    out[1] = at[1] + by * way[0];
}

/* The direction of a motion at one of its points. */
static void way_at(const gcode_program *g, const gcode_event *e, const double at[3], double out[2])
{
    double from[2], to[2], centre[2], arm[2];

    in_plane(g, e->from, from);
    in_plane(g, e->to, to);
    in_plane(g, e->centre, centre);
    if (e->kind != GCODE_ARC) {
        unit(from, to, out);
        return;
    }
    in_plane(g, at, to);
    unit(centre, to, arm);
    out[0] = e->turns > 0 ? -arm[1] : arm[1];
    out[1] = e->turns > 0 ? arm[0] : -arm[0];
}

static bool is_outside(const gcode_program *g, const gcode_event *arc)
{
    return arc->turns * g->radius.side < 0;
}

/* An arc has the radius of its end: that of its start may differ, by rounding. */
static trace trace_of(const gcode_program *g, const gcode_event *e, const double at[2],
                      const double way[2], const double end[2])
{
    trace out = { .turn = e->turns > 0 ? 1 : -1 };

    memcpy(out.at, at, sizeof out.at);
    memcpy(out.way, way, sizeof out.way);
    in_plane(g, e->centre, out.centre);
    if (e->kind == GCODE_ARC)
        out.radius = hypot(end[0] - out.centre[0], end[1] - out.centre[1]);
    return out;
}

/* The angle by which an arc around `centre` turns from one point to another, 0 .. 2 pi. */
static double angle_between(const double centre[2], const double from[2], const double to[2],
                            int turn)
{
    const double a[2] = { from[0] - centre[0], from[1] - centre[1] },
                 b[2] = { to[0] - centre[0], to[1] - centre[1] };
    const double angle = atan2(cross(a, b), dot(a, b)) * turn;

    return angle > 0 ? angle : angle + 2 * PI;
}

/* How far a point of the path is from the corner: back, or on; the wrong way is far. */
static double distance_along(const trace *t, const double to[2], bool back)
{
    const double go[2] = { to[0] - t->at[0], to[1] - t->at[1] };
    const double on    = dot(go, t->way) * (back ? -1 : 1);

    if (t->radius > 0)
        return t->radius * angle_between(t->centre, t->at, to, back ? -t->turn : t->turn);
    return on >= 0 ? on : FAR - on;
}


// Where shifted motions meet
// --------------------------

/* Half of the chord at this distance from the centre; below 0: there is none. */
static double half_chord(double radius, double away)
{
    const double square = radius * radius - away * away;

    return square >= 0 ? sqrt(square) : square >= -TOUCH * radius * radius ? 0 : -1;
}

/* The point of base +- half * way that is nearer, back along a and on along b. */
static bool nearer(const trace *a, const trace *b, const double base[2], const double way[2],
                   double half, double out[2])
{
    double distance[2], p[2][2];

    if (!(half >= 0))
        return false;
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < 2; i++)
            p[k][i] = base[i] + (k ? -half : half) * way[i];
        distance[k] = distance_along(a, p[k], true) + distance_along(b, p[k], false);
    }
    memcpy(out, p[distance[1] < distance[0]], sizeof p[0]);
    return true;
}

static bool meet_lines(const trace *a, const trace *b, double out[2])
{
    const double by[2] = { b->at[0] - a->at[0], b->at[1] - a->at[1] };
    const double t     = cross(by, b->way) / cross(a->way, b->way);

    for (int i = 0; i < 2; i++)
        out[i] = a->at[i] + t * a->way[i];
    return isfinite(t);
}

static bool meet_circle(const trace *a, const trace *b, double out[2])
{
    const trace *line = a->radius > 0 ? b : a, *circle = a->radius > 0 ? a : b;
    const double by[2] = { circle->centre[0] - line->at[0], circle->centre[1] - line->at[1] };
    const double along = dot(by, line->way), away = cross(line->way, by);
    double base[2];

    for (int i = 0; i < 2; i++)
        base[i] = line->at[i] + along * line->way[i];
    return nearer(a, b, base, line->way, half_chord(circle->radius, away), out);
}

static bool meet_circles(const trace *a, const trace *b, double out[2])
{
    const double apart = hypot(b->centre[0] - a->centre[0], b->centre[1] - a->centre[1]);
    double way[2], base[2];

    if (!(apart > 0))
        return false;
    const double along = (a->radius * a->radius - b->radius * b->radius + apart * apart) /
                         (2 * apart);
    unit(a->centre, b->centre, way);
    for (int i = 0; i < 2; i++)
        base[i] = a->centre[i] + along * way[i];
    const double over[2] = { -way[1], way[0] };
    return nearer(a, b, base, over, half_chord(a->radius, along), out);
}

static bool meet(const trace *a, const trace *b, double out[2])
{
    if (a->radius > 0 && b->radius > 0)
        return meet_circles(a, b, out);
    return a->radius > 0 || b->radius > 0 ? meet_circle(a, b, out) : meet_lines(a, b, out);
}


// The motion that waits, and those behind it across the plane
// -----------------------------------------------------------

static int hold(gcode_program *g, const gcode_event *e)
{
    if (g->radius.count == GCODE_HELD)
        return gcode_fails(g, "gcode.compensation-waits",
                           "64 lines without a way in the plane, in G41 or G42",
                           "give G40 before them");
    g->radius.held[g->radius.count++] = *e;
    return 0;
}

static int does_not_fit(const gcode_program *g, unsigned line)
{
    char what[128];

    snprintf(what, sizeof what, "the tool of radius %.6g does not fit into the corner at line %u",
             g->radius.r, line);
    return gcode_fails(g, "gcode.compensation-corner", what,
                       "take a smaller tool, or round the corner");
}

/* How far an arc turns from the place of the tool to `end`. */
static double sweep_to(const gcode_program *g, const gcode_event *e, const double end[2])
{
    double centre[2], from[2];

    in_plane(g, e->centre, centre);
    in_plane(g, e->from, from);
    return angle_between(centre, from, end, e->turns > 0 ? 1 : -1);
}

/* Give all that waits; in the plane they end at `end`. */
static int release(gcode_program *g, const double end[2], bool cut)
{
    const bool judged = cut || g->radius.cut;
    int code = 0;

    for (unsigned i = 0; i < g->radius.count && code == 0; i++) {
        gcode_event *e = &g->radius.held[i];
        double from[2];
        if (e->kind <= GCODE_NURBS)
            put_in_plane(g, end, e->to);
        memcpy(e->from, g->place, sizeof e->from);
        in_plane(g, e->from, from);
        const double go[2] = { end[0] - from[0], end[1] - from[1] };
        if (i == 0 && judged &&
            (e->kind == GCODE_ARC ? sweep_to(g, e, end) > g->radius.sweep + WRAP
                                  : dot(go, g->radius.way) < 0))
            code = does_not_fit(g, e->line);
        else
            code = gcode_send(g, e);
    }
    g->radius.count = 0;
    g->radius.cut   = cut;
    return code;
}


// Corners
// -------

/* Around the outside of a corner; a rapid goes straight, for there are no rapid arcs. */
static int round_corner(gcode_program *g, const gcode_event *e, const double corner[2],
                        const double start[2])
{
    gcode_event arc = *e;

    arc.kind  = e->kind == GCODE_RAPID ? GCODE_RAPID : GCODE_ARC;
    arc.turns = g->radius.side > 0 ? -1 : 1;
    memcpy(arc.to, g->place, sizeof arc.to);
    memcpy(arc.centre, g->place, sizeof arc.centre);
    put_in_plane(g, start, arc.to);
    put_in_plane(g, corner, arc.centre);
    arc.loose[1] = arc.loose[0];
    return gcode_send(g, &arc);
}

/* Where the outsides of two motions touch, as between the parts of an m, there is no way around. */
static bool hugs(const gcode_program *g, const gcode_event *e)
{
    const gcode_event *arc = e->kind == GCODE_ARC ? e : &g->radius.held[0];

    return arc->kind == GCODE_ARC && is_outside(g, arc);
}

/* Give what waits, up to the corner where e begins in direction `way`. */
static int turn_corner(gcode_program *g, const gcode_event *e, const double way[2],
                       const double end[2])
{
    double corner[2], start[2], at[2];
    double out = -g->radius.side * atan2(cross(g->radius.way, way), dot(g->radius.way, way));

    in_plane(g, e->from, corner);
    beside(g, corner, way, start);
    out += out < -(PI - CORNER) ? 2 * PI : 0;
    if (out < -CORNER || (out > PI - CORNER && hugs(g, e))) {
        const gcode_event *before = &g->radius.held[0];
        const double *last = g->radius.end;
        const trace a = trace_of(g, before, last, g->radius.way, last),
                    b = trace_of(g, e, start, way, end);
        return meet(&a, &b, at) ? release(g, at, true) : does_not_fit(g, before->line);
    }
    const int code = release(g, g->radius.end, false);
    return code == 0 && out > CORNER ? round_corner(g, e, corner, start) : code;
}

/* The first motion is an arc: it ends beside the programmed one, with the same direction. */
static int bend_entry(const gcode_program *g, gcode_event *e, const double end[2])
{
    double centre[2], from[2], arm[2];

    in_plane(g, e->centre, centre);
    in_plane(g, e->from, from);
    unit(end, centre, arm);
    const double by[2] = { from[0] - end[0], from[1] - end[1] };
    const double r     = dot(by, by) / (2 * dot(by, arm));
    if (!isfinite(r))
        return does_not_fit(g, e->line);
    for (int i = 0; i < 2; i++)
        centre[i] = end[i] + r * arm[i];
    put_in_plane(g, centre, e->centre);
    return 0;
}

/* How far an arc turns, as programmed: a motion that ends where it starts is a whole turn. */
static double sweep_of(const gcode_program *g, const gcode_event *e)
{
    double to[2];

    in_plane(g, e->to, to);
    return e->kind == GCODE_ARC ? sweep_to(g, e, to) : 0;
}

static int check_motion(const gcode_program *g, const gcode_event *e, const double from[2],
                        const double to[2])
{
    const unsigned plane = 1u << gcode_first(g) | 1u << gcode_second(g);
    double centre[2];

    in_plane(g, e->centre, centre);
    if (e->kind > GCODE_ARC)
        return gcode_fails(g, "gcode.compensation-cubic", "G5 in G41 or G42", "give G40 before");
    if (e->loose[0] & plane)
        return gcode_fails(g, "gcode.compensation-unplaced",
                           "G41 or G42 from a place that is not named",
                           "give a motion to X and Y before");
    if (!g->radius.entered && !(hypot(to[0] - from[0], to[1] - from[1]) > g->radius.r))
        return gcode_fails(g, "gcode.compensation-first",
                           "the first motion in G41 or G42 is not longer than the tool's radius",
                           "begin farther away");
    if (e->kind == GCODE_ARC && !is_outside(g, e) &&
        !(hypot(to[0] - centre[0], to[1] - centre[1]) > g->radius.r))
        return gcode_fails(g, "gcode.compensation-arc",
                           "an arc whose radius is not above that of the tool",
                           "take a smaller tool, or a larger arc");
    return 0;
}

/* A motion in the plane. */
static int take_motion(gcode_program *g, gcode_event *e)
{
    double from[2], to[2], start_way[2], end_way[2], end[2];

    in_plane(g, e->from, from);
    in_plane(g, e->to, to);
    int code = check_motion(g, e, from, to);
    if (code != 0)
        return code;
    way_at(g, e, e->from, start_way);
    way_at(g, e, e->to, end_way);
    beside(g, to, end_way, end);
    const double sweep = sweep_of(g, e);
    if (g->radius.entered)
        code = turn_corner(g, e, start_way, end);
    else if (e->kind == GCODE_ARC)
        code = bend_entry(g, e, end);
    if (code != 0)
        return code;
    put_in_plane(g, end, e->to);
    memcpy(g->radius.way, end_way, sizeof end_way);
    memcpy(g->radius.end, end, sizeof end);
    g->radius.sweep   = sweep;
    g->radius.entered = true;
    return hold(g, e);
}

int gcode_radius_take(gcode_program *g, gcode_event *e)
{
    double from[2], to[2];

    in_plane(g, e->from, from);
    in_plane(g, e->to, to);
    const bool moves = fabs(to[0] - from[0]) > 0 || fabs(to[1] - from[1]) > 0;
    if (e->kind <= GCODE_NURBS && (e->kind > GCODE_LINE || moves))
        return take_motion(g, e);
    if (e->kind == GCODE_SAY || g->radius.count == 0)
        return gcode_send(g, e);
    return hold(g, e);
}

int gcode_radius_off(gcode_program *g)
{
    const int code = g->radius.count > 0 ? release(g, g->radius.end, false) : 0;

    g->radius.side = 0;
    return code;
}

int gcode_radius_on(gcode_program *g, int side, double diameter)
{
    if (g->radius.side != 0)
        return gcode_fails(g, "gcode.compensation-twice",
                           "G41 or G42 while one of them is in force", "give G40 before");
    if (g->plane == 0)
        return gcode_fails(g, "gcode.compensation-plane", "G41 or G42 in the plane of y and z",
                           "give G17 or G18 before");
    if (g->apart)
        return gcode_fails(g, "gcode.compensation-again", "G41 or G42 right behind G40",
                           "give a straight motion between them");
    memcpy(g->place, g->at, sizeof g->place);
    g->radius.r       = diameter / 2 / g->frame.unit;
    g->radius.side    = g->radius.r > 0 ? side : 0;
    g->radius.entered = g->radius.cut = false;
    g->radius.count   = 0;
    g->apart = g->radius.side != 0;
    return 0;
}
