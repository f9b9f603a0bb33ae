/* host-tools/engine/harmonic_poles.c -- where the poles of a harmonic series lie
 * SPDX-License-Identifier: MIT
 *
 * The poles of a corner are poles of the root of z - v, in the plane where that root is one. There
 * a slit is as wide as any other outside. On circles around the corner, each arc outside has a
 * place with the most room. These places make chains between the parts of the polygon that the
 * circles cross, as the two channels that meet at the corner: the solution is another polynomial
 * in each. The poles of a chain are as dense as its room is narrow. Their distances from the
 * corner go from a part of its room to some multiple of the polygon's size.
 */
#include <math.h>

#include "engine/harmonic_basis.h"

#define DIRECTIONS 96
#define CIRCLES    1.1L  /* from one to the next, in distances from the corner             */
#define CLEAR      0.05L /* of a pole from the polygon, in its distance from the corner    */
#define CLEAR_FOOT 0.1L  /* the same, in its distance from the edge                        */
#define DENSITY    0.3L  /* of poles behind an edge: they are in the plane, not in a root's */

/* How far p is from the curve of roots of the boundary, which is closed; 0 when p is within. */
static double root_clearance(const harmonic_root root[], size_t count, double x, double y)
{
    double least = x * x + y * y;
    bool within = false;

    for (size_t k = 0; k < count; k++) {
        const harmonic_root a = root[k], b = root[k + 1 < count ? k + 1 : 0];
        const double dx = a.x - x, dy = a.y - y, square = dx * dx + dy * dy;
        const bool above = a.y > y;
        least = square < least ? square : least;
        if (above != (b.y > y) && (dx * (b.y - y) - dy * (b.x - x) > 0) != above)
            within = !within;
    }
    return within ? 0 : sqrt(least);
}

/* How far a place is from the nearest pole that was put since the first one. */
static long double pole_distance(const harmonic_series *s, unsigned first, harmonic_point at)
{
    long double least = INFINITY;

    for (unsigned k = first; k < s->pole_count; k++)
        least = fminl(least, cabsl(at - (s->pole[k][0] + I * s->pole[k][1])));
    return least;
}

/* Put a pole where there is none nearer than `step`; its size is its room. */
static void put_pole(harmonic_point at, long double room, long double step, unsigned first,
                     harmonic_series *s)
{
    if (s->pole_count == HARMONIC_POLES || pole_distance(s, first, at) < step)
        return;
    long double *pole = s->pole[s->pole_count++];

    pole[0] = (double)creall(at);
    pole[1] = (double)cimagl(at);
    pole[2] = (double)room;
}

/* A pole in each arc of a circle that is outside, where it has the most room. `density` is of the
 * poles, in their rooms. */
static void put_on_circle(const harmonic_root root[], size_t count, long double radius,
                          long double density, unsigned first, harmonic_series *s)
{
    harmonic_point at[DIRECTIONS], chosen = 0;
    double room[DIRECTIONS], best = 0;
    unsigned start = 0;

    for (unsigned k = 0; k < DIRECTIONS; k++) {
        at[k] = radius * cexpl(I * (2 * HARMONIC_PI * k / DIRECTIONS));
        room[k] = root_clearance(root, count, (double)creall(at[k]), (double)cimagl(at[k]));
        if (!(room[k] > 0))
            start = k;
    }
    for (unsigned m = 1; m <= DIRECTIONS; m++) {
        const unsigned k = (start + m) % DIRECTIONS;
        if (room[k] > best * 1.001) {
            best = room[k];
            chosen = at[k];
        }
        if (m < DIRECTIONS && room[k] > 0)
            continue;
        if (best > CLEAR * radius)
            put_pole(chosen, best, density * best, first, s);
        best = 0;
    }
}

void harmonic_corner_poles(const harmonic_shape *h, unsigned i, const harmonic_place place[],
                           size_t count, long double ratio, harmonic_root root[],
                           harmonic_series *s)
{
    const long double nearest = h->room[i] / 30, last = 4 * h->far[i];
    const unsigned first = s->pole_count;

    for (size_t k = 0; k < count; k++) {
        const harmonic_point l = harmonic_log(h, i, place[k].at, (int)place[k].edge),
                             at = cexpl(l / 2);
        root[k] = (harmonic_root){ (double)creall(at), (double)cimagl(at) };
    }
    for (long double r = last; r > nearest; r /= CIRCLES)
        put_on_circle(root, count, sqrtl(r / h->far[i]), sqrtl(ratio) - 1, first, s);
    s->corner_poles[i] = s->pole_count - first;
}

/* The mirror image of the vertex in the edge is where the solution, continued, is singular: poles
 * go from there straight away from the edge, until the polygon is met again. */
void harmonic_foot_poles(const harmonic_shape *h, const harmonic_foot *foot, long double ratio,
                         harmonic_series *s)
{
    const unsigned first = s->pole_count - s->poles;
    const harmonic_point way = (foot->image - foot->at) / foot->room;

    for (long double behind = foot->room * 0.1L, off = foot->room + behind; off < 4 * h->reach;
         behind *= ratio, off = foot->room + behind) {
        const harmonic_point at = foot->at + way * off;
        const long double room = harmonic_distance(h, at);
        if (!harmonic_outside(h, at) || room < CLEAR_FOOT * off)
            break;
        put_pole(at, room, DENSITY * (ratio - 1) * room, first, s);
        s->poles = s->pole_count - first;
    }
}
