/* tests/tools/gcode_moves.h -- runs lines of G-code, and tells their motions as letters and numbers
 * SPDX-License-Identifier: MIT
 *
 * Expected motions are those that LinuxCNC's rs274 prints (make check-gcode compares many more), as
 * R x y z for a rapid, L for a line, A with first and second axis of the plane, centre, turns and
 * the end across it, C for a cubic, N for a NURBS, W for a wait, S for a stop, T for a tool,
 * P for a spindle, O for a coolant.
 */
#ifndef LOFT_TESTS_GCODE_MOVES_H
#define LOFT_TESTS_GCODE_MOVES_H

#include <math.h>
#include <string.h>

#include "tools/drawn.h"
#include "gcode/gcode.h"
#include "read/machine_tools.h"

typedef struct {
    char text[8192];
    double feed;                /* of the last motion, mm/min */
    double mm[3];               /* and its end on the machine */
} seen;

static void put(seen *s, const double *numbers, int count)
{
    for (int i = 0; i < count; i++)
        put_number(s->text, sizeof s->text, numbers[i]);
}

/* The tools that a program finds. */
static const machine_tools bench = { .tool = { { .name = "1", .diameter = 6, .length = 12.5 },
                                               { .name = "2", .diameter = 2, .length = NAN },
                                               { .name = "3", .length = 7 } },
                                     .count = 3 };

static int see(void *context, const gcode_event *e)
{
    seen *s     = context;
    const int a = (e->plane + 1) % 3, b = (e->plane + 2) % 3;
    const double arc[] = {
        e->to[a], e->to[b], e->centre[a], e->centre[b], e->turns, e->to[e->plane]
    };

    snprintf(s->text + strlen(s->text), sizeof s->text - strlen(s->text), "%s%c",
             s->text[0] != '\0' ? " " : "", "RLACQNWSPO!T"[e->kind]);
    switch (e->kind) {
    case GCODE_ARC: put(s, arc, 6); break;
    case GCODE_CUBIC:
    case GCODE_QUADRATIC:
        put(s, e->inner[0], 2);
        put(s, e->inner[1], 2);
        put(s, e->to, 2);
        break;
    case GCODE_NURBS:
        for (unsigned i = 0; i < e->count; i++)
            put(s, e->points[i], 3);
        break;
    case GCODE_WAIT: put(s, &e->seconds, 1); break;
    case GCODE_STOP:
    case GCODE_SAY: break;
    case GCODE_SPINDLE: {
        const double way[2] = { e->way, isnan(e->speed) ? -1 : e->speed };
        put(s, way, 2);
        break;
    }
    case GCODE_COOLANT: put(s, &(double){ e->way }, 1); break;
    case GCODE_TOOL: put(s, &(double){ (double)e->tool }, 1); break;
    default: put(s, e->to, 3);
    }
    s->feed = 60 * e->feed;
    gcode_place(e->frame, e->to, s->mm);
    return 0;
}

static inline int run(seen *s, enum gcode_dialect d, const char *text)
{
    gcode_program *g = gcode_open(&heard, "part.nc", d, see, s);

    gcode_set_tools(g, &bench);

    *s = (seen){ .feed = 0 };
    hear();
    const int code = gcode_read(g, text, strlen(text));
    gcode_close(g);
    return code;
}

static inline void check_moves(const char *text, const char *want, int line)
{
    seen s;
    const int code = run(&s, GCODE_ANY, text);

    if (code != 0 || strcmp(s.text, want) != 0) {
        printf("line %d: code %d %s\n  program %s\n  moves  %s\n  wanted %s\n", line, code, caught,
               text, s.text, want);
        check_bad = true;
    }
}
#define MOVES(text, want) check_moves(text, want, __LINE__)

/* It is refused with one message of this name, at a line; its words have those of the program. */
static inline void check_fails(const char *text, const char *name, unsigned at, const char *words,
                               int line)
{
    seen s;
    const int code = run(&s, GCODE_ANY, text);

    if (code != EX_DATAERR || caught_lines != 1 || !heard_it(name, at) ||
        strstr(caught, words) == NULL) {
        printf("line %d: code %d, %u messages: %s at %u: %s\n  wanted: %s at %u: %s\n", line, code,
               caught_lines, caught_as[0].name, caught_as[0].line, caught, name, at, words);
        check_bad = true;
    }
}
#define FAILS(text, name, at)           check_fails(text, name, at, "", __LINE__)
#define FAILS_OF(text, name, at, words) check_fails(text, name, at, words, __LINE__)

static inline void check_place(const char *text, double x, double y, double z, double feed,
                               int line)
{
    seen s;
    const int code = run(&s, GCODE_ANY, text);

    if (code != 0 || fabs(s.mm[0] - x) + fabs(s.mm[1] - y) + fabs(s.mm[2] - z) > 1e-9 ||
        fabs(s.feed - feed) > 1e-9 * feed) {
        printf("line %d: code %d %s\n  at %g %g %g, feed %g\n", line, code, caught, s.mm[0],
               s.mm[1], s.mm[2], s.feed);
        check_bad = true;
    }
}
#define ENDS_AT(text, x, y, z, feed) check_place(text, x, y, z, feed, __LINE__)

#endif
