/* host-tools/engine/harmonic_poles.c -- where the poles of a harmonic series lie
 * SPDX-License-Identifier: MIT
 *
 * The poles of a corner are poles of the root of z - v, in the plane where that root is one. There
 * a slit is as wide as any other outside. Their distances from the corner are a geometric series,
 * from a part of the corner's room to some multiple of the polygon's size.
 */
#include <math.h>

#include "engine/harmonic_basis.h"

#define DIRECTIONS 32
#define CLEAR      0.3L /* of a pole from the polygon, in its distance from the corner */

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

static void put_pole(harmonic_point at, long double size, harmonic_series *s)
{
    const unsigned k = s->pole_count++;

    s->pole[k][0] = (double)creall(at);
    s->pole[k][1] = (double)cimagl(at);
    s->pole[k][2] = (double)size;
}

/* The direction with the most room around the pole. */
static bool place_corner_pole(const harmonic_root root[], size_t count, long double radius,
                              harmonic_series *s)
{
    long double best = 0;
    harmonic_point at = 0;

    for (int k = 0; k < DIRECTIONS; k++) {
        const harmonic_point p = radius * cexpl(I * (2 * HARMONIC_PI * k / DIRECTIONS));
        const long double room = root_clearance(root, count, (double)creall(p), (double)cimagl(p));
        if (room > best * 1.001L) {
            best = room;
            at = p;
        }
    }
    if (best < CLEAR * radius || s->pole_count == HARMONIC_POLES)
        return false;
    put_pole(at, best, s);
    return true;
}

void harmonic_corner_poles(const harmonic_shape *h, unsigned i, const harmonic_place place[],
                           size_t count, long double ratio, harmonic_root root[],
                           harmonic_series *s)
{
    const long double first = h->room[i] / 30, last = 4 * h->far[i];

    for (size_t k = 0; k < count; k++) {
        const harmonic_point l = harmonic_log(h, i, place[k].at, (int)place[k].edge),
                             at = cexpl(l / 2);
        root[k] = (harmonic_root){ (double)creall(at), (double)cimagl(at) };
    }
    s->corner_poles[i] = 0;
    for (long double r = last; r > first; r /= ratio)
        s->corner_poles[i] += place_corner_pole(root, count, sqrtl(r / h->far[i]), s);
}

/* The mirror image of the vertex in the edge is where the solution, continued, is singular: poles
 * go from there straight away from the edge. */
void harmonic_foot_poles(const harmonic_shape *h, const harmonic_foot *foot, long double ratio,
                         harmonic_series *s)
{
    const harmonic_point d = h->v[(foot->edge + 1) % h->sides] - h->v[foot->edge];
    const harmonic_place from = { foot->edge, foot->along, foot->at };
    const long double most = harmonic_clearance(h, &from, 8 * h->reach);

    for (long double behind = foot->room * 0.1L, off = foot->room + behind;
         off < most / 2 && off < 4 * h->reach; behind *= ratio, off = foot->room + behind) {
        const harmonic_point at = foot->at - I * d / cabsl(d) * off;
        const long double size = harmonic_distance(h, at);
        if (!harmonic_outside(h, at) || size < CLEAR * off || s->pole_count == HARMONIC_POLES)
            continue;
        put_pole(at, size, s);
        s->poles++;
    }
}
