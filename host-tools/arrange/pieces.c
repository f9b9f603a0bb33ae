/* host-tools/arrange/pieces.c
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "arrange/pieces.h"

#define LAP (20 * PIECES_GRID)

struct pieces {
    GEOSContextHandle_t h;
    double half;                /* of the width */
    const region_stroke *s;
    int quarter;                /* chords of a quarter turn */
    double (*at)[2];            /* of the piece under way, with room for a half turn */
    GEOSGeometry **piece;
    unsigned count, room;
};

/* What is bounded by the first n points. */
static void add_piece(pieces *to, unsigned n)
{
    memcpy(to->at[n], to->at[0], sizeof to->at[0]);
    GEOSCoordSequence *s = GEOSCoordSeq_copyFromBuffer_r(to->h, to->at[0], n + 1, 0, 0);
    GEOSGeometry *ring   = s ? GEOSGeom_createLinearRing_r(to->h, s) : NULL,
                 *one    = ring ? GEOSGeom_createPolygon_r(to->h, ring, NULL, 0) : NULL;

    if (one == NULL)
        return;
    if (to->count == to->room) {
        to->room  = to->room ? 2 * to->room : 256;
        to->piece = memory_grow(to->piece, to->room * sizeof(GEOSGeometry *));
    }
    to->piece[to->count++] = one;
}

static void put(double out[2], const double at[2], double along, const double way[2])
{
    out[0] = at[0] + along * way[0];
    out[1] = at[1] + along * way[1];
}

/* The direction of a chord. */
static void way_of(const double a[2], const double b[2], double out[2])
{
    const double length = hypot(b[0] - a[0], b[1] - a[1]);

    out[0] = (b[0] - a[0]) / length;
    out[1] = (b[1] - a[1]) / length;
}

/* A little longer than the chord: where pieces only touch, rounding to the grid leaves gaps. */
static void add_strip(pieces *to, const double a[2], const double b[2])
{
    double way[2], begin[2], end[2];
    way_of(a, b, way);
    const double left[2] = { -way[1], way[0] };

    put(begin, a, -LAP, way);
    put(end, b, LAP, way);
    put(to->at[0], begin, to->half, left);
    put(to->at[1], begin, -to->half, left);
    put(to->at[2], end, -to->half, left);
    put(to->at[3], end, to->half, left);
    add_piece(to, 4);
}

/* A part of a disk, from direction `from` by `angle`. */
static void add_fan(pieces *to, const double centre[2], const double from[2], double angle)
{
    const unsigned n = 1 + (unsigned)(fabs(angle) / 1.5707963267948966 * to->quarter);

    memcpy(to->at[0], centre, sizeof to->at[0]);
    for (unsigned k = 0; k <= n; k++) {
        const double c = cos(angle * k / n), s = sin(angle * k / n);
        const double way[2] = { c * from[0] - s * from[1], s * from[0] + c * from[1] };
        put(to->at[k + 1], centre, to->half, way);
    }
    add_piece(to, n + 2);
}

/* Between two directions that meet in a point: on the outside of the bend. */
static void add_join(pieces *to, const double at[2], const double in[2], const double out[2])
{
    const double cross = in[0] * out[1] - in[1] * out[0], dot = in[0] * out[0] + in[1] * out[1],
                 side    = cross > 0 ? -1 : 1;
    const double from[2] = { -side * in[1], side * in[0] },
                 end[2] = { -side * out[1], side * out[0] };

    if (to->s->join == REGION_JOIN_ROUND) {
        add_fan(to, at, from, -side * atan2(fabs(cross), dot));    /* ahead, if it turns back */
        return;
    }
    memcpy(to->at[0], at, sizeof to->at[0]);
    put(to->at[1], at, to->half, from);
    const bool mitre = to->s->join == REGION_MITRE && dot > -1 + 1e-12 &&
                       2 <= to->s->mitre * to->s->mitre * (1 + dot);
    if (mitre) {
        const double tip[2] = { (from[0] + end[0]) / (1 + dot), (from[1] + end[1]) / (1 + dot) };
        put(to->at[2], at, to->half, tip);
    }
    put(to->at[2 + mitre], at, to->half, end);
    add_piece(to, 3 + mitre);
}

/* Behind the end of a line that comes in this direction. */
static void add_cap(pieces *to, const double at[2], const double way[2])
{
    const double right[2] = { way[1], -way[0] };

    if (to->s->cap == REGION_CAP_ROUND)
        add_fan(to, at, right, 3.14159265358979323846);
    if (to->s->cap != REGION_SQUARE)
        return;
    memcpy(to->at[0], at, sizeof to->at[0]);
    put(to->at[1], at, to->half, right);
    put(to->at[2], to->at[1], to->half, way);
    put(to->at[4], at, -to->half, right);
    put(to->at[3], to->at[4], to->half, way);
    add_piece(to, 5);
}

static bool is_ring(const double (*p)[2], size_t n)
{
    return n > 3 && hypot(p[n - 1][0] - p[0][0], p[n - 1][1] - p[0][1]) < PIECES_GRID;
}

void pieces_add(pieces *to, const double (*p)[2], size_t n)
{
    const bool ring = is_ring(p, n);
    double in[2], out[2];

    for (size_t i = 0; i + 1 < n; i++) {
        add_strip(to, p[i], p[i + 1]);
        way_of(p[i], p[i + 1], out);
        if (i > 0)
            add_join(to, p[i], in, out);
        memcpy(in, out, sizeof in);
    }
    way_of(p[0], p[1], out);
    if (ring) {
        add_join(to, p[0], in, out);
        return;
    }
    const double back[2] = { -out[0], -out[1] };
    add_cap(to, p[n - 1], in);
    add_cap(to, p[0], back);
}

/* Do its inner sides cross behind the middle of a chord, or is its mitre too long? */
static bool is_hard_corner(const double a[2], const double b[2], const double c[2], double half,
                           const region_stroke *s)
{
    double in[2], out[2];
    way_of(a, b, in);
    way_of(b, c, out);
    const double dot = in[0] * out[0] + in[1] * out[1],
                 least = fmin(hypot(b[0] - a[0], b[1] - a[1]), hypot(c[0] - b[0], c[1] - b[1]));

    if (s->join == REGION_MITRE && 2 > s->mitre * s->mitre * (1 + dot))
        return true;
    return half * half * (1 - dot) > least * least / 4 * (1 + dot);
}

bool pieces_needed(const double (*p)[2], size_t n, const region_stroke *s)
{
    const double half = s->width / 2;

    for (size_t i = 1; i + 1 < n; i++)
        if (is_hard_corner(p[i - 1], p[i], p[i + 1], half, s))
            return true;
    return is_ring(p, n) && is_hard_corner(p[n - 2], p[0], p[1], half, s);
}

pieces *pieces_open(GEOSContextHandle_t h, const region_stroke *s, int quarter)
{
    pieces *to = memory_grow(NULL, sizeof *to);

    *to    = (pieces){ .h = h, .half = s->width / 2, .s = s, .quarter = quarter };
    to->at = memory_grow(NULL, (2 * (size_t)quarter + 8) * sizeof *to->at);
    return to;
}

GEOSGeometry *pieces_join(pieces *all)
{
    GEOSContextHandle_t h = all->h;
    GEOSGeometry *set = GEOSGeom_createCollection_r(h, GEOS_MULTIPOLYGON, all->piece, all->count),
                 *one = set ? GEOSUnaryUnionPrec_r(h, set, PIECES_GRID) : NULL;

    GEOSGeom_destroy_r(h, set);
    free(all->at);
    free(all->piece);
    free(all);
    return one;
}
