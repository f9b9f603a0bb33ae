/* host-tools/gcode/gcode_arc.c -- an arc of G-code as cubics
 * SPDX-License-Identifier: MIT
 *
 * The ends of an arc may differ in their distance from its centre, by rounding: the distance then
 * changes in proportion to the angle, as in LinuxCNC, and so does the place across the plane. A
 * cubic with the tangents of such a spiral, and arms of 4/3 tan(h/4) for the angle h, leaves it by
 * at most
 *
 *     1.82e-5 r h^6 + 0.01 d h^2 + 0.0021 z h^2
 *
 * with r the larger distance, d the change of distance in the cubic, and z that across the plane.
 * The first part is Goldapp's, CAGD 8 (1991). The factor of d is 0.0072 at a spiral from its centre
 * by a quarter turn, and less elsewhere; that of z is the unevenness of the angle in the cubic.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "gcode/gcode_state.h"

#define PI    3.14159265358979323846
#define FUZZ  1e-6          /* rad: ends in directions so near are a whole turn, as in LinuxCNC */

typedef struct {
    int first, second, across;
    double radius[2], angle, sweep;     /* sweep below 0: clockwise */
} spiral;

static double distance(const spiral *s, const double centre[3], const double at[3])
{
    return hypot(at[s->first] - centre[s->first], at[s->second] - centre[s->second]);
}

static double direction(const spiral *s, const double centre[3], const double at[3])
{
    return atan2(at[s->second] - centre[s->second], at[s->first] - centre[s->first]);
}

static spiral spiral_of(const gcode_event *e)
{
    spiral s = { .first = (e->plane + 1) % 3, .second = (e->plane + 2) % 3, .across = e->plane };
    const int way = e->turns > 0 ? 1 : -1;

    s.radius[0] = distance(&s, e->centre, e->from);
    s.radius[1] = distance(&s, e->centre, e->to);
    s.angle     = direction(&s, e->centre, e->from);
    double turn = way * (direction(&s, e->centre, e->to) - s.angle);
    turn += turn < -FUZZ ? 2 * PI : 0;
    turn += turn < FUZZ ? 2 * PI : 0;
    s.sweep = way * (turn + 2 * PI * (abs(e->turns) - 1));
    return s;
}

double gcode_arc_length(const gcode_event *e)
{
    const spiral s = spiral_of(e);

    return hypot(s.sweep * s.radius[0], e->to[s.across] - e->from[s.across]);
}

static double cubics_for(const spiral *s, const gcode_event *e, double tol)
{
    const double r = fmax(s->radius[0], s->radius[1]), sweep = fabs(s->sweep),
                 drift = 0.01 * fabs(s->radius[1] - s->radius[0]) +
                         0.0021 * fabs(e->to[s->across] - e->from[s->across]);
    double n = fmax(ceil(2 * sweep / PI - FUZZ), ceil(sweep / pow(tol / (1.82e-5 * r), 1.0 / 6)));

    n = fmax(n, ceil(cbrt(drift * sweep * sweep / tol)));
    while (1.82e-5 * r * pow(sweep / n, 6) + drift / n * pow(sweep / n, 2) > tol)
        n = ceil(1.02 * n);
    return n;
}

/* The place and its derivative by the angle at the fraction t of the turn. */
static void eval_spiral(const spiral *s, const gcode_event *e, double t, double at[3],
                        double slope[3])
{
    const double turn = s->sweep * t, grows = (s->radius[1] - s->radius[0]) / s->sweep;
    const double r = s->radius[0] + grows * turn, c = cos(s->angle + turn),
                 sine = sin(s->angle + turn), rise = e->to[s->across] - e->from[s->across];

    at[s->first]     = e->centre[s->first] + r * c;
    at[s->second]    = e->centre[s->second] + r * sine;
    at[s->across]    = e->from[s->across] + rise * t;
    slope[s->first]  = grows * c - r * sine;
    slope[s->second] = grows * sine + r * c;
    slope[s->across] = rise / s->sweep;
}

int gcode_arc_cubics(const gcode_event *e, double tol, gcode_cubic_sink *sink, void *context)
{
    const spiral s   = spiral_of(e);
    const double n   = cubics_for(&s, e, tol), h = s.sweep / n, arm = 4.0 / 3 * tan(h / 4);
    double at[3], slope[2][3];
    int code = 0;

    eval_spiral(&s, e, 0, at, slope[0]);
    memcpy(at, e->from, sizeof at);
    for (double k = 1; k <= n && code == 0; k++) {
        double p[4][3];
        memcpy(p[0], at, sizeof at);
        eval_spiral(&s, e, k / n, at, slope[1]);
        if (k >= n)
            memcpy(at, e->to, sizeof at);
        memcpy(p[3], at, sizeof at);
        for (int i = 0; i < 3; i++) {
            const double l = i == s.across ? h / 3 : arm;
            p[1][i] = p[0][i] + l * slope[0][i];
            p[2][i] = p[3][i] - l * slope[1][i];
        }
        memcpy(slope[0], slope[1], sizeof slope[0]);
        code = sink(context, p);
    }
    return code;
}
