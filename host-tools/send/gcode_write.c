/* host-tools/send/gcode_write.c
 * SPDX-License-Identifier: MIT
 *
 * A curve is halved until each half is close to the arc through its ends and its middle. If the
 * curvature changes evenly, the error of an arc is proportional to the fourth power of its length,
 * that of a chord to the square. So arcs need far fewer lines.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "send/gcode_write.h"
#include "base/spool.h"          /* spool_grow */

#define DEPTH   16          /* halvings at most                                  */
#define LOOKS   16          /* checked places per piece */
#define WIDE    2000.0      /* mm: the largest radius; beyond it a line is as good */

typedef struct {
    gcode *g;
    const gcode_options *o;
    double feed;            /* the active one, mm/min */
    size_t move;
} writer;

typedef struct {
    double p[4][3];
} cubic;

static void put_line(writer *w, const char *words)
{
    gcode *g = w->g;

    const size_t size = strlen(words) + 1;

    if (g->count == g->room) {
        g->room = g->room ? 2 * g->room : 256;
        g->line = spool_grow(g->line, g->room * sizeof *g->line);
    }
    if (g->held - g->used < size) {
        g->held = 2 * (g->held + size);
        g->text = spool_grow(g->text, g->held);
    }
    spool_passed(g->count);
    g->line[g->count++] = (struct gcode_line){ g->used, w->move };
    memcpy(g->text + g->used, words, size);
    g->used += size;
}

/* Append a word with at most four decimals. */
static void append_word(char *text, char letter, double value)
{
    char *at = text + strlen(text);

    snprintf(at, 24, "%c%.4f", letter, value);
    for (size_t n = strlen(at); at[n - 1] == '0' || at[n - 1] == '.'; n--) {
        const bool point = at[n - 1] == '.';
        at[n - 1] = '\0';
        if (point)
            break;
    }
    if (strcmp(at + 1, "-0") == 0)
        strcpy(at + 1, "0");
}

static void finish_line(writer *w, char *text, double feed)
{
    if (feed > 0 && fabs(60 * feed - w->feed) > 1e-9) {
        w->feed = 60 * feed;
        append_word(text, 'F', w->feed);
    }
    put_line(w, text);
}

static void point_at(const cubic *c, double t, double out[3])
{
    const double u = 1 - t;

    for (int i = 0; i < 3; i++)
        out[i] = u * u * u * c->p[0][i] + 3 * u * t * (u * c->p[1][i] + t * c->p[2][i]) +
                 t * t * t * c->p[3][i];
}

/* `feed` 0: a rapid. */
static void write_line(writer *w, const cubic *c, double feed)
{
    char text[96] = "G1";

    text[1] = feed > 0 ? '1' : '0';

    for (int i = 0; i < 3; i++)
        if (fabs(c->p[3][i] - c->p[0][i]) > 0)
            append_word(text, "XYZ"[i], c->p[3][i]);
    if (text[2] != '\0')
        finish_line(w, text, feed);
}

/* Is the piece near its chord, without turning back on it? */
static bool is_near_line(const cubic *c, double tol)
{
    double v[3], q = 0, last = 0;

    for (int i = 0; i < 3; i++) {
        v[i] = c->p[3][i] - c->p[0][i];
        q += v[i] * v[i];
    }
    for (int k = 1; k < LOOKS; k++) {
        double p[3], along = 0, off = 0;
        point_at(c, (double)k / LOOKS, p);
        for (int i = 0; i < 3; i++)
            along += (p[i] - c->p[0][i]) * v[i];
        along = q > 0 ? along / q : 0;
        for (int i = 0; i < 3; i++)
            off += pow(p[i] - c->p[0][i] - along * v[i], 2);
        if (sqrt(off) > tol || along < last || along > 1)
            return false;
        last = along;
    }
    return true;
}

/* The circle through both ends and the middle, if the whole piece is near it and follows it in one
 * direction. */
static bool is_near_arc(const cubic *c, double tol, double centre[2], bool *left)
{
    double m[3];

    point_at(c, 0.5, m);
    const double ax = m[0] - c->p[0][0], ay = m[1] - c->p[0][1], bx = c->p[3][0] - c->p[0][0],
                 by = c->p[3][1] - c->p[0][1];
    const double cross = ax * by - ay * bx, a = ax * ax + ay * ay, b = bx * bx + by * by;
    if (cross == 0)
        return false;
    const double x = (by * a - ay * b) / (2 * cross), y = (ax * b - bx * a) / (2 * cross),
                 r = hypot(x, y);
    double last[2] = { -x, -y }, angle[LOOKS + 1] = { 0 }, height[LOOKS + 1];

    if (r > WIDE)
        return false;
    height[0] = c->p[0][2];
    centre[0] = c->p[0][0] + x;
    centre[1] = c->p[0][1] + y;
    *left = cross > 0;
    for (int k = 1; k <= LOOKS; k++) {
        double p[3];
        point_at(c, (double)k / LOOKS, p);
        const double now[2] = { p[0] - centre[0], p[1] - centre[1] },
                     turn = last[0] * now[1] - last[1] * now[0];
        if (fabs(hypot(now[0], now[1]) - r) > tol || (turn > 0) != *left ||
            last[0] * now[0] + last[1] * now[1] < 0)
            return false;
        angle[k]  = angle[k - 1] + fabs(atan2(turn, last[0] * now[0] + last[1] * now[1]));
        height[k] = p[2];
        memcpy(last, now, sizeof last);
    }
    /* a helix rises in proportion to the angle */
    for (int k = 1; k < LOOKS; k++)
        if (fabs(height[k] - height[0] - (height[LOOKS] - height[0]) * angle[k] / angle[LOOKS]) >
            tol)
            return false;
    return (-x * last[1] + y * last[0] > 0) == *left;       /* less than half a turn */
}

static void write_arc(writer *w, const cubic *c, const double centre[2], bool left, double feed)
{
    char text[128];

    strcpy(text, left ? "G3" : "G2");
    for (int i = 0; i < 3; i++)
        if (i < 2 || fabs(c->p[3][2] - c->p[0][2]) > 0)
            append_word(text, "XYZ"[i], c->p[3][i]);
    for (int i = 0; i < 2; i++)
        append_word(text, "IJ"[i], centre[i] - c->p[0][i]);
    finish_line(w, text, feed);
}

static void halve_cubic(const cubic *c, cubic half[2])
{
    for (int i = 0; i < 3; i++) {
        const double a = (c->p[0][i] + c->p[1][i]) / 2, m = (c->p[1][i] + c->p[2][i]) / 2,
                     z = (c->p[2][i] + c->p[3][i]) / 2;
        const double b = (a + m) / 2, y = (m + z) / 2, x = (b + y) / 2;
        const double left[4] = { c->p[0][i], a, b, x }, right[4] = { x, y, z, c->p[3][i] };
        for (int k = 0; k < 4; k++) {
            half[0].p[k][i] = left[k];
            half[1].p[k][i] = right[k];
        }
    }
}

static bool is_flat(const cubic *c)
{
    return !(fabs(c->p[1][2] - c->p[0][2]) + fabs(c->p[2][2] - c->p[0][2]) +
                 fabs(c->p[3][2] - c->p[0][2]) >
             0);
}

static void write_arcs(writer *w, const cubic *c, double feed, int depth)
{
    double centre[2];
    cubic half[2];
    bool left;

    /* off the arc and off its height add up */
    if (is_near_line(c, w->o->tol) || depth == DEPTH) {
        write_line(w, c, feed);
    } else if (w->o->curves != GCODE_CHORDS &&
               is_near_arc(c, w->o->tol * (is_flat(c) ? 1 : 0.7), centre, &left)) {
        write_arc(w, c, centre, left, feed);
    } else {
        halve_cubic(c, half);
        write_arcs(w, &half[0], feed, depth + 1);
        write_arcs(w, &half[1], feed, depth + 1);
    }
}

/* I J: the first control point relative to the start; P Q: the second one relative to the end. */
static void write_cubic(writer *w, const cubic *c, double feed)
{
    char text[128] = "G5";

    for (int i = 0; i < 2; i++)
        append_word(text, "IJ"[i], c->p[1][i] - c->p[0][i]);
    for (int i = 0; i < 2; i++)
        append_word(text, "PQ"[i], c->p[2][i] - c->p[3][i]);
    for (int i = 0; i < 2; i++)
        append_word(text, "XY"[i], c->p[3][i]);
    finish_line(w, text, feed);
}

static void write_event(writer *w, const drawing_event *e)
{
    char text[128];

    switch (e->doing) {
    case DRAWING_WAITS:  snprintf(text, sizeof text, "G4P%.3f", e->amount); break;
    case DRAWING_COOLS:  snprintf(text, sizeof text, "M%d", e->way ? 8 : 9); break;
    case DRAWING_PAUSES: snprintf(text, sizeof text, "M0"); break;
    case DRAWING_SPINS:
        if (e->way == 0)
            snprintf(text, sizeof text, "M5");
        else if (isnan(e->amount))
            snprintf(text, sizeof text, "M%d", e->way);
        else
            snprintf(text, sizeof text, "M%dS%.10g", e->way, e->amount);
    }
    put_line(w, text);
}

void gcode_make(gcode *g, const toolpath *t, const gcode_options *o)
{
    size_t events = 0;
    writer w = { .g = g, .o = o };

    *g = (gcode){ .count = 0 };
    put_line(&w, "G21G90G94G17");
    for (size_t i = 0; i < t->count; i++) {
        cubic c;
        memcpy(c.p, t->move[i].p, sizeof c.p);
        w.move = i;
        while (events < t->events && t->event[events].move <= i)
            write_event(&w, &t->event[events++].e);
        const bool cubics = o->curves == GCODE_G5 && is_flat(&c);
        if (t->curve[i] == TOOLPATH_TRAVEL && o->rapids)
            write_line(&w, &c, 0);
        else if (is_near_line(&c, cubics ? 1e-6 : o->tol))
            write_line(&w, &c, t->move[i].feed);
        else if (cubics)
            write_cubic(&w, &c, t->move[i].feed);
        else
            write_arcs(&w, &c, t->move[i].feed, 0);
    }
    while (events < t->events)
        write_event(&w, &t->event[events++].e);
}

void gcode_free(gcode *g)
{
    spool_free(g->line);
    spool_free(g->text);
    *g = (gcode){ .count = 0 };
}
