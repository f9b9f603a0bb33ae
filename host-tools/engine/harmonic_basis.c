/* host-tools/engine/harmonic_basis.c
 * SPDX-License-Identifier: MIT
 */
#include <math.h>

#include "engine/harmonic_basis.h"

#define TURN (2 * HARMONIC_PI)

static long double cross(harmonic_point a, harmonic_point b) { return cimagl(conjl(a) * b); }

static long double near_zero(long double angle) { return angle - TURN * roundl(angle / TURN); }

static void find_rooms(harmonic_shape *h);

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
    find_rooms(h);
}


// Terms
// -----

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

harmonic_point harmonic_log(const harmonic_shape *h, unsigned at, harmonic_point z, int edge)
{
    return logl(cabsl(z - h->v[at]) / h->far[at]) + I * angle_at(h, at, z, edge);
}

static long double *put_parts(harmonic_point f, long double *out)
{
    *out++ = creall(f);
    *out++ = cimagl(f);
    return out;
}

/* The powers of a corner, then its poles: at the corner itself l is minus infinity. */
static long double *put_corner(const harmonic_shape *h, const harmonic_series *s, unsigned i,
                               harmonic_point l, bool there, const long double (*pole)[3],
                               long double *out)
{
    const long double a = HARMONIC_PI / h->angle[i];
    const harmonic_point w = there ? cexpl(a * l) : 0, root = there ? cexpl(l / 2) : 0;
    harmonic_point power = w;

    for (unsigned k = 1; k <= s->powers[i]; k++, power *= w)
        *out++ = k > 1 || !(s->straight >> i & 1) ? cimagl(power)
                 : there                          ? cimagl(cexpl(l) * l * quotient((a - 1) * l))
                                                  : 0;
    for (unsigned k = 0; k < s->corner_poles[i]; k++)
        out = put_parts(pole[k][2] / (root - (pole[k][0] + I * pole[k][1])), out);
    return out;
}

void harmonic_terms(const harmonic_shape *h, const harmonic_series *s, harmonic_point z, int edge,
                    long double out[])
{
    const long double(*pole)[3] = s->pole;

    for (unsigned i = 0; i < h->sides; pole += s->corner_poles[i++]) {
        const bool there = cabsl(z - h->v[i]) > 0, used = s->powers[i] || s->corner_poles[i];
        out = put_corner(h, s, i, there && used ? harmonic_log(h, i, z, edge) : 0, there, pole,
                         out);
    }
    for (unsigned i = 0; i < s->poles; i++, pole++)
        out = put_parts((*pole)[2] / (z - ((*pole)[0] + I * (*pole)[1])), out);
    const harmonic_point t = (z - h->middle) / h->reach;
    harmonic_point power = t;
    *out++ = 1;
    for (unsigned k = 1; k <= s->degree; k++, power *= t)
        out = put_parts(power, out);
}


// Narrowness
// ----------

static long double distance_to(const harmonic_shape *h, harmonic_point z, unsigned e)
{
    const harmonic_point a = h->v[e], d = h->v[(e + 1) % h->sides] - a;
    const long double t = creall(conjl(d) * (z - a)) / creall(conjl(d) * d);

    return cabsl(z - a - fminl(fmaxl(t, 0), 1) * d);
}

int harmonic_edge_at(const harmonic_shape *h, harmonic_point z)
{
    for (unsigned e = 0; e < h->sides; e++)
        if (distance_to(h, z, e) <= 1e-15L * h->reach)
            return (int)e;
    return -1;
}

/* How near the nearest edge is that does not end at this corner; its own edges count with their
 * lengths. */
static long double corner_room(const harmonic_shape *h, unsigned i)
{
    const unsigned n = h->sides;
    long double least = fminl(cabsl(h->v[(i + 1) % n] - h->v[i]),
                              cabsl(h->v[(i + n - 1) % n] - h->v[i]));

    for (unsigned k = 1; k + 1 < n; k++)
        least = fminl(least, distance_to(h, h->v[i], (i + k) % n));
    return least;
}

/* Whether no edge lies between a vertex and a point of edge e. */
static bool is_seen(const harmonic_shape *h, unsigned at, harmonic_point p, unsigned e)
{
    const unsigned n = h->sides;

    for (unsigned k = 1; k + 1 < n; k++) {
        const unsigned other = (at + k) % n;
        if (other != e && meets(h, h->v[at], p - h->v[at], other) < 0.999L)
            return false;
    }
    return true;
}

static harmonic_point edge_of(const harmonic_shape *h, unsigned e)
{
    return h->v[(e + 1) % h->sides] - h->v[e];
}

/* Where the perpendicular from p meets the line of an edge: 0 at its start, 1 at its end. */
static long double share_of(const harmonic_shape *h, harmonic_point p, unsigned e)
{
    const harmonic_point d = edge_of(h, e);

    return creall(conjl(d) * (p - h->v[e])) / creall(conjl(d) * d);
}

static bool is_before(const harmonic_shape *h, harmonic_point p, unsigned e)
{
    return cross(edge_of(h, e), p - h->v[e]) > 0;
}

/* Add the image of p in an edge, `share` of the edge along. */
static void add_image(harmonic_shape *h, harmonic_point p, unsigned e, long double share)
{
    const harmonic_point a = h->v[e], d = edge_of(h, e), foot = a + share * d;

    h->foot[h->feet++] = (harmonic_foot){
        e, share * cabsl(d), cabsl(p - foot), foot, 2 * (a + share_of(h, p, e) * d) - p, false
    };
}

/* An edge that the vertex is before. Its mirror image in the edge's line is there too when the
 * perpendicular misses the edge. */
static void find_foot(harmonic_shape *h, unsigned at, unsigned e)
{
    const long double share = fminl(fmaxl(share_of(h, h->v[at], e), 0), 1);

    if (is_before(h, h->v[at], e) && is_seen(h, at, h->v[e] + share * edge_of(h, e), e))
        add_image(h, h->v[at], e, share);
}

/* Whether the way from an image comes in by the edge of its own and then meets edge e alone. */
static bool is_seen_through(const harmonic_shape *h, const harmonic_foot *f, harmonic_point at,
                            unsigned e)
{
    for (unsigned k = 0; k < h->sides; k++)
        if (k != e && (k == f->edge) != (meets(h, f->image, at - f->image, k) < 0.999L))
            return false;
    return true;
}

/* The image, in another edge, of an image: what makes a channel narrow has one after the other. */
static void find_second_image(harmonic_shape *h, const harmonic_foot *f, unsigned e)
{
    const long double share = share_of(h, f->image, e);

    if (share >= 0 && share <= 1 && is_before(h, f->image, e) &&
        is_seen_through(h, f, h->v[e] + share * edge_of(h, e), e))
        add_image(h, f->image, e, share);
}

/* A corner behind an edge that other edges hide: terms of that corner go on through them, and what
 * cancels them along this edge is singular there too. */
static void find_hidden(harmonic_shape *h, unsigned at, unsigned e)
{
    const harmonic_point v = h->v[at], d = edge_of(h, e);
    const long double share = share_of(h, v, e);
    const harmonic_point foot = h->v[e] + share * d;

    if (share >= 0 && share <= 1 && cross(d, v - h->v[e]) < 0 && !is_seen(h, at, foot, e))
        h->foot[h->feet++] = (harmonic_foot){ e, share * cabsl(d), cabsl(v - foot), foot, v, true };
}

static void find_rooms(harmonic_shape *h)
{
    const unsigned n = h->sides;

    h->feet = 0;
    for (unsigned i = 0; i < n; i++)
        h->room[i] = corner_room(h, i);
    for (unsigned i = 0; i < n; i++)
        for (unsigned k = 1; k + 1 < n; k++)
            find_foot(h, i, (i + k) % n);
    const unsigned images = h->feet;
    for (unsigned i = 0; i < n; i++)
        for (unsigned k = 1; k + 1 < n; k++)
            find_hidden(h, i, (i + k) % n);
    for (unsigned i = 0; i < images; i++)
        for (unsigned k = 1; k < n; k++)
            find_second_image(h, &h->foot[i], (h->foot[i].edge + k) % n);
}

/* The scale of what happens at a place of an edge: the distance from the nearest vertex or foot, or
 * a share of the room there. */
static long double place_scale(const harmonic_shape *h, unsigned e, harmonic_point z)
{
    long double least = 4 * h->reach;

    for (unsigned i = 0; i < h->sides; i++)
        least = fminl(least, fmaxl(cabsl(z - h->v[i]), h->room[i] * 0x1p-9L));
    for (unsigned i = 0; i < h->feet; i++)
        if (h->foot[i].edge == e && !h->foot[i].hidden)
            least = fminl(least, fmaxl(cabsl(z - h->foot[i].at), h->foot[i].room / 2));
    return least;
}

/* The scale of what the poles of a series make there: twice the distance from the nearest one, that
 * of a corner's pole as the root of the offset sees it. */
static long double pole_scale(const harmonic_shape *h, const harmonic_series *s, unsigned e,
                              harmonic_point z)
{
    const long double(*pole)[3] = s->pole;
    long double least = INFINITY;

    for (unsigned i = 0; i < h->sides; pole += s->corner_poles[i++]) {
        const long double off = cabsl(z - h->v[i]);
        const harmonic_point root = off > 0 ? cexpl(harmonic_log(h, i, z, (int)e) / 2) : 0;
        for (unsigned k = 0; k < s->corner_poles[i]; k++) {
            const long double apart = cabsl(root - (pole[k][0] + I * pole[k][1])),
                              slope = off > 0 ? 2 * off / cabsl(root) : apart * h->far[i];
            least = fminl(least, slope * apart);
        }
    }
    for (unsigned k = 0; k < s->poles; k++)
        least = fminl(least, cabsl(z - (pole[k][0] + I * pole[k][1])));
    return 2 * least;
}

size_t harmonic_walk(const harmonic_shape *h, const harmonic_series *s, long double step,
                     unsigned least, harmonic_place out[], size_t most)
{
    size_t count = 0;

    for (unsigned e = 0; e < h->sides; e++) {
        const harmonic_point a = h->v[e], d = h->v[(e + 1) % h->sides] - a;
        const long double length = cabsl(d);
        if (count < most)
            out[count] = (harmonic_place){ e, 0, a };
        count++;
        for (long double along = 0; along < length; count++) {
            const harmonic_point z = a + d * (along / length);
            const long double scale = fminl(place_scale(h, e, z),
                                            s != NULL ? pole_scale(h, s, e, z) : INFINITY),
                              way = fminl(fminl(step * scale, length / least), length - along),
                              here = along + way / 2;
            if (count < most)
                out[count] = (harmonic_place){ e, here, a + d * (here / length) };
            along += fmaxl(way, length * 1e-12L);
        }
    }
    return count;
}
