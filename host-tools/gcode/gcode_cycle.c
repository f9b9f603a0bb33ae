/* host-tools/gcode/gcode_cycle.c -- drilling: G73, G74, G81 to G89
 * SPDX-License-Identifier: MIT
 *
 * NIST RS274/NGC version 3, section 3.5.16. The tool goes to the hole at the height where it is,
 * down to R, does the work, and returns to R (G99) or to the height before the first hole (G98).
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "gcode/gcode_state.h"

#define CHIP 0.254              /* mm: the way back that breaks a chip, of LinuxCNC */
#define HOLES_MOST 100000       /* of a line, and their pecks */

/* Straight along the axis across the plane. */
static int plunge(gcode_program *g, enum gcode_kind kind, double height)
{
    double to[3];

    memcpy(to, g->at, sizeof to);
    to[g->plane] = height;
    return gcode_go(g, kind, to);
}

/* G83 returns to R each time, G73 a little. */
static int peck(gcode_program *g, double r, double bottom, double step, bool whole)
{
    const double chip = CHIP / g->frame.unit;
    int code = 0;

    for (double at = r - step; at > bottom && code == 0; at -= step) {
        code = plunge(g, GCODE_LINE, at);
        if (code == 0 && whole)
            code = plunge(g, GCODE_RAPID, r);
        if (code == 0)
            code = plunge(g, GCODE_RAPID, at + chip);
    }
    return code == 0 ? plunge(g, GCODE_LINE, bottom) : code;
}

/* The spindle turns this way now, 3, 4 or 0; where the program never started it, it stays off. */
static int spin(gcode_program *g, int way)
{
    gcode_event e = { .kind = GCODE_SPINDLE, .way = way, .speed = g->timed ? g->speed : NAN };

    return g->spindle != 0 ? gcode_give(g, &e, 0) : 0;
}

/* At the bottom: G74 and G84 turn a tap round, G86 and G88 stop the spindle. */
static int turn_at_bottom(gcode_program *g)
{
    switch (g->cycle.code) {
    case 740:
    case 840: return spin(g, g->spindle == 3 ? 4 : 3);
    case 860:
    case 880: return spin(g, 0);
    default: return 0;
    }
}

static int turn_at_top(gcode_program *g)
{
    const int c = g->cycle.code;

    return c == 740 || c == 840 || c == 860 || c == 880 ? spin(g, g->spindle) : 0;
}

static bool waits_at_bottom(int code)
{
    return code == 820 || code == 860 || code == 880 || code == 890 || code == 840 || code == 740;
}

/* One hole, from R down and up to `clear`. */
static int drill_hole(gcode_program *g, double r, double bottom, double clear)
{
    const int c     = g->cycle.code;
    const bool taps = c == 840 || c == 740, waits = waits_at_bottom(c);
    int code = c == 830 || c == 730 ? peck(g, r, bottom, g->cycle.q, c == 830)
                                    : plunge(g, GCODE_LINE, bottom);

    if (code == 0 && taps)
        code = turn_at_bottom(g);
    if (code == 0 && waits && (!taps || g->cycle.p > 0))
        code = gcode_wait(g, g->cycle.p);
    if (code == 0 && !taps)
        code = turn_at_bottom(g);
    if (code == 0 && c == 880)
        code = gcode_simple(g, GCODE_STOP);
    if (code == 0 && c == 850)
        code = plunge(g, GCODE_LINE, r);
    if (code == 0)
        code = plunge(g, taps || c == 890 ? GCODE_LINE : GCODE_RAPID, clear);
    return code == 0 ? turn_at_top(g) : code;
}

/* Straight in the plane, to where the tool is beside the hole (1), or in its middle (0). */
static int step_aside(gcode_program *g, const double hole[3], double by)
{
    double to[3];

    for (int i = 0; i < 3; i++)
        to[i] = i == g->plane ? g->at[i] : hole[i] + by * g->cycle.aside[i];
    return gcode_go(g, GCODE_RAPID, to);
}

/* No output turns the spindle to a known angle: somebody does it by hand. */
static int stop_to_turn(gcode_program *g)
{
    static const char text[] = "turn the spindle by hand: its edge away from the way aside";
    gcode_event say = { .kind = GCODE_SAY, .text = text, .length = sizeof text - 1 },
                stop = { .kind = GCODE_STOP };
    int code = spin(g, 0);

    if (code == 0)
        code = gcode_give(g, &say, 0);
    return code == 0 ? gcode_give(g, &stop, 0) : code;
}

/* G87, back boring: the tool goes down beside the middle, at I and J, bores up to K, and leaves as
 * it came. */
static int bore_back(gcode_program *g, const double hole[3], double bottom, double clear)
{
    const double end = (g->incremental ? bottom : 0) + g->cycle.aside[g->plane];
    int code = step_aside(g, hole, 1);

    if (code == 0)
        code = stop_to_turn(g);
    if (code == 0)
        code = plunge(g, GCODE_RAPID, bottom);
    if (code == 0)
        code = step_aside(g, hole, 0);
    if (code == 0)
        code = spin(g, g->spindle);
    if (code == 0)
        code = plunge(g, GCODE_LINE, end);
    if (code == 0)
        code = plunge(g, GCODE_LINE, bottom);
    if (code == 0)
        code = stop_to_turn(g);
    if (code == 0)
        code = step_aside(g, hole, 1);
    if (code == 0)
        code = plunge(g, GCODE_RAPID, clear);
    if (code == 0)
        code = step_aside(g, hole, 0);
    return code == 0 ? spin(g, g->spindle) : code;
}

/* G87 in the plane of x and y: I and J lead aside, K is where the bore ends; so in each plane. */
static int take_sides(gcode_program *g, bool first)
{
    for (int i = 0; i < 3; i++) {
        const char letter = (char)('I' + i);
        if (gcode_has(&g->b, letter))
            g->cycle.aside[i] = gcode_value(&g->b, letter);
        else if (first)
            return gcode_fails(g, "gcode.bore-offset", "G87 without I, J and K",
                               "give I and J, the way aside, and K, the end of the bore");
    }
    return 0;
}

/* The words of the line; those that it does not give stay from the hole before. */
static int take_words(gcode_program *g)
{
    const gcode_block *b = &g->b;
    const char up = (char)('X' + g->plane);
    const bool first = g->cycle.code != g->motion;

    if (g->feed_mode == 930)
        return gcode_fails(g, "gcode.drilling-inverse-time", "drilling in G93", "give G94 before");
    if (first && (!gcode_has(b, 'R') || !gcode_has(b, up)))
        return gcode_fails(g, "gcode.drilling-no-depth", "drilling without R and its depth",
                           "give R, and Z in the plane of x "
                           "and y");
    if (first && !gcode_has(b, 'P') &&
        (g->motion == 820 || g->motion == 860 || g->motion == 880 || g->motion == 890))
        return gcode_fails(g, "gcode.drilling-no-wait", "G82, G86, G88 or G89 without P",
                           "give the seconds at the bottom, as P0.5");
    if (gcode_has(b, 'P') && waits_at_bottom(g->motion) && gcode_value(b, 'P') < 0)
        return gcode_fails(g, "gcode.drilling-wait", "P below 0",
                           "give the seconds at the bottom, as P0.5");
    if (first)
        g->cycle.p = g->cycle.q = 0;
    if (gcode_has(b, 'R'))
        g->cycle.r = gcode_value(b, 'R');
    if (gcode_has(b, up))
        g->cycle.z = gcode_value(b, up);
    if (gcode_has(b, 'P') && waits_at_bottom(g->motion))
        g->cycle.p = gcode_value(b, 'P');
    if (gcode_has(b, 'Q') && (g->motion == 830 || g->motion == 730))
        g->cycle.q = gcode_value(b, 'Q');
    g->cycle.code = g->motion;
    return g->motion == 870 ? take_sides(g, first) : 0;
}

/* The height before the first hole. */
static double first_height(gcode_program *g)
{
    if (!g->cycle.leveled)
        g->cycle.initial = g->at[g->plane];
    g->cycle.leveled = true;
    return g->cycle.initial;
}

static int drill_at(gcode_program *g, const double over[3], double r, double bottom, double clear)
{
    int code = gcode_go(g, GCODE_RAPID, over);

    if (code == 0 && fabs(g->at[g->plane] - r) > 0)
        code = plunge(g, GCODE_RAPID, r);
    if (code != 0)
        return code;
    return g->cycle.code == 870 ? bore_back(g, over, bottom, clear)
                                : drill_hole(g, r, bottom, clear);
}

int gcode_drill(gcode_program *g)
{
    const double times = gcode_has(&g->b, 'L') ? gcode_value(&g->b, 'L') : 1;
    const int up = g->plane;
    double at[3], step[3] = { 0 };
    int code = take_words(g);

    if (code != 0)
        return code;
    if (!(times >= 1 && times <= HOLES_MOST) || times > floor(times))
        return gcode_fails(g, "gcode.drilling-count", "L of drilling is its number of holes",
                           "give a whole number from 1 to 100000");
    const double top = first_height(g), r = g->incremental ? top + g->cycle.r : g->cycle.r,
                 bottom = g->incremental ? r + g->cycle.z : g->cycle.z,
                 clear = g->retract_to_r ? r : fmax(top, r);
    const int c = g->cycle.code;
    if (bottom > r)
        return gcode_fails(g, "gcode.drilling-upwards", "drilling from R upwards",
                           "give a depth below R");
    if ((c == 830 || c == 730) &&
        (!(g->cycle.q > 0) || times * ((r - bottom) / g->cycle.q) > HOLES_MOST))
        return gcode_fails(g, "gcode.drilling-peck", "Q: the step of the pecks",
                           "give Q above 0, and not too small");
    memcpy(at, g->at, sizeof at);
    at[up] = fmax(g->retract_to_r ? g->at[up] : top, r);
    for (int i = 0; i < 3; i++)
        if (i != up && gcode_has(&g->b, (char)('X' + i)))
            step[i] = gcode_value(&g->b, (char)('X' + i));
    if (top < r)
        code = plunge(g, GCODE_RAPID, r);
    for (int n = 0; n < (int)times && code == 0; n++) {
        for (int i = 0; i < 3; i++)
            if (i != up && gcode_has(&g->b, (char)('X' + i)))
                at[i] = g->incremental ? at[i] + step[i] : step[i];
        if (gcode_has(&g->b, GCODE_RADIUS) || gcode_has(&g->b, GCODE_ANGLE))
            gcode_polar_target(g, at, at);
        code   = drill_at(g, at, r, bottom, clear);
        at[up] = clear;
    }
    return code;
}
