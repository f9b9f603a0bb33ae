/* host-tools/engine/harmonic_basis.c
 * SPDX-License-Identifier: MIT
 */
#include <math.h>

#include "engine/harmonic_basis.h"

#define TURN (2 * HARMONIC_PI)

static long double cross(harmonic_point a, harmonic_point b) { return cimagl(conjl(a) * b); }

static long double near_zero(long double angle) { return angle - TURN * roundl(angle / TURN); }

void harmonic_shape_of(double v[][2], unsigned sides, harmonic_shape *h)
{
    h->sides = sides;
    h->middle = 0;
    h->reach = 0;
    for (unsigned i = 0; i < sides; i++) {
        h->v[i] = (long double)v[i][0] + I * (long double)v[i][1];
        h->middle += h->v[i];
    }
    h->middle /= (long double)sides;
    for (unsigned i = 0; i < sides; i++) {
        const harmonic_point after = h->v[(i + 1) % sides] - h->v[i],
                             before = h->v[(i + sides - 1) % sides] - h->v[i];
        h->reach = fmaxl(h->reach, cabsl(h->v[i] - h->middle));
        h->start[i] = cargl(after);
        h->angle[i] = cargl(before / after);
        if (h->angle[i] < 0)
            h->angle[i] += TURN;
        h->far[i] = 0;
        for (unsigned k = 0; k < sides; k++)
            h->far[i] = fmaxl(h->far[i], cabsl(h->v[k] - h->v[i]));

        h->turn[i][i] = h->turn[i][(i + 1) % sides] = 0;
        for (unsigned k = 1; k + 1 < sides; k++) {
            const unsigned e = (i + k) % sides, f = (e + 1) % sides;
            h->turn[i][f] = h->turn[i][e] + cargl((h->v[f] - h->v[i]) / (h->v[e] - h->v[i]));
        }
    }
}


/* Terms
 * ----- */

/* Where the segment from p along d meets edge e: how far along it, or 2. */
static long double meets(const harmonic_shape *h, harmonic_point p, harmonic_point d, unsigned e)
{
    const harmonic_point a = h->v[e], b = h->v[(e + 1) % h->sides];
    const long double here = cross(b - a, p - a), there = cross(b - a, p + d - a);
    const bool opposite = !((here > 0 && there > 0) || (here < 0 && there < 0)) &&
                          (here < 0 || here > 0 || there < 0 || there > 0);

    return opposite && cross(d, a - p) * cross(d, b - p) <= 0 ? here / (here - there) : 2;
}

/* The angle of z seen from a corner, as lib/polygon/harmonic.c explains it. */
static long double angle_at(const harmonic_shape *h, unsigned at, harmonic_point z, int edge)
{
    const unsigned n = h->sides;
    const harmonic_point d = h->v[at] - z;
    long double near = h->angle[at] / 2, first = 2;

    if (edge == (int)at)
        return 0;
    if (edge == (int)((at + n - 1) % n))
        return h->angle[at];
    for (unsigned k = 1; k + 1 < n && edge < 0; k++) {
        const long double way = meets(h, z, d, (at + k) % n);
        if (way < first) {
            first = way;
            near = h->turn[at][(at + k) % n];
        }
    }
    if (edge >= 0)
        near = h->turn[at][edge];
    return near + near_zero(cargl(-d) - h->start[at] - near);
}

/* (e^x - 1) / x */
static harmonic_point quotient(harmonic_point x)
{
    harmonic_point sum = 1;

    if (cabsl(x) > 0.5L)
        return (cexpl(x) - 1) / x;
    for (int k = 20; k > 1; k--)
        sum = 1 + x / (long double)k * sum;
    return sum;
}

void harmonic_terms(const harmonic_shape *h, const harmonic_series *s, harmonic_point z, int edge,
                    long double out[])
{
    for (unsigned i = 0; i < h->sides; i++) {
        const long double a = HARMONIC_PI / h->angle[i], r = cabsl(z - h->v[i]) / h->far[i];
        const bool there = r > 0 && s->powers[i] > 0;
        const harmonic_point l = there ? logl(r) + I * angle_at(h, i, z, edge) : 0,
                             w = there ? cexpl(a * l) : 0;
        harmonic_point power = w;
        for (unsigned k = 1; k <= s->powers[i]; k++, power *= w)
            *out++ = k > 1 || !(s->straight >> i & 1) ? cimagl(power)
                     : there                          ? cimagl(cexpl(l) * l * quotient((a - 1) * l))
                                                      : 0;
    }
    for (unsigned i = 0; i < s->poles; i++) {
        const harmonic_point q = s->pole[i][2] / (z - (s->pole[i][0] + I * s->pole[i][1]));
        *out++ = creall(q);
        *out++ = cimagl(q);
    }
    const harmonic_point t = (z - h->middle) / h->reach;
    harmonic_point power = t;
    *out++ = 1;
    for (unsigned k = 1; k <= s->degree; k++, power *= t) {
        *out++ = creall(power);
        *out++ = cimagl(power);
    }
}


/* Narrowness
 * ---------- */

static long double distance_to(const harmonic_shape *h, harmonic_point z, unsigned e)
{
    const harmonic_point a = h->v[e], d = h->v[(e + 1) % h->sides] - a;
    const long double t = creall(conjl(d) * (z - a)) / creall(conjl(d) * d);

    return cabsl(z - a - fminl(fmaxl(t, 0), 1) * d);
}

long double harmonic_distance(const harmonic_shape *h, harmonic_point z)
{
    long double least = distance_to(h, z, 0);

    for (unsigned e = 1; e < h->sides; e++)
        least = fminl(least, distance_to(h, z, e));
    return least;
}

bool harmonic_outside(const harmonic_shape *h, harmonic_point z)
{
    bool outside = true;

    for (unsigned e = 0; e < h->sides; e++) {
        const harmonic_point a = h->v[e], b = h->v[(e + 1) % h->sides];
        const bool above = cimagl(a) > cimagl(z), rises = cimagl(b) > cimagl(z);
        if (above != rises && (cross(b - a, z - a) > 0) == rises)
            outside = !outside;
    }
    return outside;
}

long double harmonic_clearance(const harmonic_shape *h, const harmonic_place *from,
                               long double most)
{
    const harmonic_point d = h->v[(from->edge + 1) % h->sides] - h->v[from->edge],
                         out = -I * d / cabsl(d) * most;
    long double first = 1;

    for (unsigned k = 1; k < h->sides; k++)
        first = fminl(first, meets(h, from->at, out, (from->edge + k) % h->sides));
    return first * most;
}

/* Distances to edges that do not touch this one, and to its ends. */
static long double narrowness(const harmonic_shape *h, unsigned e, long double along, int depth)
{
    const harmonic_point a = h->v[e], d = h->v[(e + 1) % h->sides] - a;
    const long double length = cabsl(d),
                      end = fmaxl(fminl(along, length - along), ldexpl(length, -depth));
    long double least = end;

    for (unsigned k = 2; k + 1 < h->sides; k++)
        least = fminl(least, distance_to(h, a + d * (along / length), (e + k) % h->sides));
    return fmaxl(least, ldexpl(length, -depth));
}

size_t harmonic_walk(const harmonic_shape *h, long double step, unsigned least, int depth,
                     harmonic_place out[], size_t most)
{
    size_t count = 0;

    for (unsigned e = 0; e < h->sides; e++) {
        const harmonic_point a = h->v[e], d = h->v[(e + 1) % h->sides] - a;
        const long double length = cabsl(d);
        for (long double along = 0; along < length; count++) {
            const long double way = fminl(
                                  fminl(step * narrowness(h, e, along, depth), length / least),
                                  length - along),
                              here = along + way / 2;
            if (count < most)
                out[count] = (harmonic_place){ e, here, narrowness(h, e, here, depth),
                                               a + d * (here / length) };
            along += fmaxl(way, length * 1e-9L);
        }
    }
    return count;
}
