/* host-tools/arrange/region.c -- areas, by the library GEOS
 * SPDX-License-Identifier: MIT
 *
 * Outlines may cross themselves: they are cut where they meet, and of the faces between them those
 * are kept whose winding number the rule of filling asks for.
 *   see  libgeos.org: the C API; OverlayNG with a precision, which cannot fail by rounding
 */
#include <geos_c.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/source.h"        /* source_name */
#include "base/host.h"
#include "base/memory.h"
#include "arrange/pieces.h"
#include "arrange/region.h"

#define CHORDS_MAX 2000000u     /* of one shape */
#define PIECED_MOST 200000u     /* chords: the union of their pieces takes a minute and a half */

struct region {
    GEOSContextHandle_t h;
    GEOSGeometry *g;
    double pen[3];              /* of a stroke: what makes an ellipse of a circle; 1 0 1: nothing */
};

/* Closed chains of points, one after the other. */
typedef struct {
    double (*point)[2];
    size_t count, room;
    size_t *first;              /* of each chain; one more behind the last */
    size_t chains, chain_room;
} polylines;


// Chords
// ------

static bool add_point(polylines *p, const double at[2])
{
    const size_t begin = p->first[p->chains];

    if (p->count > begin &&
        hypot(p->point[p->count - 1][0] - at[0], p->point[p->count - 1][1] - at[1]) < PIECES_GRID)
        return true;
    if (p->count == p->room) {
        p->room  = p->room ? 2 * p->room : 1024;
        p->point = memory_grow(p->point, p->room * sizeof *p->point);
    }
    memcpy(p->point[p->count++], at, sizeof *p->point);
    return p->count < CHORDS_MAX;
}

static unsigned chords_of(const drawing_curve *c)
{
    double most = 0;

    for (int k = 0; k < 2; k++)
        most = fmax(most, hypot(c->p[k][0] - 2 * c->p[k + 1][0] + c->p[k + 2][0],
                                c->p[k][1] - 2 * c->p[k + 1][1] + c->p[k + 2][1]));
    return (unsigned)fmin(1 + sqrt(0.75 * most / REGION_TOL), 10000);
}

static void begin_chain(polylines *p)
{
    if (p->chains + 2 > p->chain_room) {
        p->chain_room = p->chain_room ? 2 * p->chain_room : 64;
        p->first      = memory_grow(p->first, p->chain_room * sizeof *p->first);
    }
    p->first[p->chains] = p->count;
}

/* The chords of the curves; `closed`: with a line back. */
static bool find_chords(polylines *p, const drawing *d, size_t first, size_t last, bool closed)
{
    bool good = true;

    *p = (polylines){ .count = 0 };
    begin_chain(p);
    for (size_t i = first; i < last && good; i++) {
        const drawing_curve *c = &d->curve[i];
        const unsigned n       = chords_of(c);
        if (i == first || c->path != c[-1].path)
            good = add_point(p, c->p[0]);
        for (unsigned k = 1; k <= n && good; k++) {
            double at[2];
            drawing_eval(c, (double)k / n, at);
            good = add_point(p, k == n ? c->p[3] : at);
        }
        if (i + 1 < last && c[1].path == c->path)
            continue;
        const size_t begin = p->first[p->chains];
        if (closed && good)
            good = add_point(p, p->point[begin]);
        if (p->count - begin >= 2)
            p->chains++;
        else
            p->count = begin;
        begin_chain(p);
    }
    return good;
}

static void free_chords(polylines *p)
{
    free(p->point);
    free(p->first);
}

static int winding(const polylines *p, const double at[2])
{
    int sum = 0;

    for (size_t k = 0; k < p->chains; k++)
        for (size_t i = p->first[k]; i + 1 < p->first[k + 1]; i++) {
            const double *a = p->point[i], *b = p->point[i + 1];
            if ((a[1] <= at[1]) == (b[1] <= at[1]))
                continue;
            const double x = a[0] + (at[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
            sum += x < at[0] ? (b[1] > a[1] ? 1 : -1) : 0;
        }
    return sum;
}


// GEOS
// ----

static region *new_region(void)
{
    region *r = memory_grow(NULL, sizeof *r);

    *r = (region){ .h = GEOS_init_r(), .pen = { 1, 0, 1 } };
    return r;
}

static region *failed(host *h, region *r, const drawing *d, size_t first, const char *file)
{
    (void)host_error(h, EX_DATAERR, "region.not-found",
                     (host_place){ source_name(file), d->curve[first].line },
                     "split the shape, or leave out what fills it", "its area cannot be found");
    region_free(r);
    return NULL;
}

int region_error(void) { return EX_DATAERR; }

static GEOSGeometry *lines_of(GEOSContextHandle_t h, const polylines *p)
{
    GEOSGeometry **line = memory_grow(NULL, (p->chains + 1) * sizeof *line);
    unsigned count      = 0;

    for (size_t k = 0; k < p->chains; k++) {
        const size_t n = p->first[k + 1] - p->first[k];
        GEOSCoordSequence *s = GEOSCoordSeq_copyFromBuffer_r(h, p->point[p->first[k]], (unsigned)n,
                                                             0, 0);
        line[count] = s ? GEOSGeom_createLineString_r(h, s) : NULL;
        count += line[count] != NULL;
    }
    GEOSGeometry *all = GEOSGeom_createCollection_r(h, GEOS_MULTILINESTRING, line, count);
    free(line);
    return all;
}

/* Of the faces, those that are inside. */
static GEOSGeometry *join_faces(GEOSContextHandle_t h, const GEOSGeometry *faces,
                                const polylines *p, bool evenodd)
{
    const int all        = GEOSGetNumGeometries_r(h, faces);
    GEOSGeometry **inner = memory_grow(NULL, ((size_t)(all > 0 ? all : 0) + 1) * sizeof *inner);
    unsigned count       = 0;

    for (int i = 0; i < all; i++) {
        const GEOSGeometry *face = GEOSGetGeometryN_r(h, faces, i);
        GEOSGeometry *point      = GEOSPointOnSurface_r(h, face);
        double at[2];
        const bool good = point != NULL && GEOSGeomGetX_r(h, point, &at[0]) == 1 &&
                          GEOSGeomGetY_r(h, point, &at[1]) == 1;
        GEOSGeom_destroy_r(h, point);
        const int turns = good ? winding(p, at) : 0;
        if (evenodd ? turns & 1 : turns)
            inner[count++] = GEOSGeom_clone_r(h, face);
    }
    GEOSGeometry *set = GEOSGeom_createCollection_r(h, GEOS_MULTIPOLYGON, inner, count);
    free(inner);
    GEOSGeometry *one = set ? GEOSUnaryUnionPrec_r(h, set, PIECES_GRID) : NULL;
    GEOSGeom_destroy_r(h, set);
    return one;
}

region *region_inside(host *h, const drawing *d, size_t first, size_t last, bool evenodd,
                      const char *file)
{
    region *r = new_region();
    polylines p;
    const bool good     = find_chords(&p, d, first, last, true);
    GEOSGeometry *lines = good ? lines_of(r->h, &p) : NULL,
                 *cut = lines ? GEOSUnaryUnionPrec_r(r->h, lines, PIECES_GRID) : NULL,
                 *faces = NULL;

    if (cut != NULL)
        faces = GEOSPolygonize_r(r->h, (const GEOSGeometry *const[]){ cut }, 1);
    if (faces != NULL)
        r->g = join_faces(r->h, faces, &p, evenodd);
    GEOSGeom_destroy_r(r->h, lines);
    GEOSGeom_destroy_r(r->h, cut);
    GEOSGeom_destroy_r(r->h, faces);
    free_chords(&p);
    return r->g ? r : failed(h, r, d, first, file);
}

static region *cut_shape(host *h, region *shape, const drawing *outline, unsigned clip,
                         const char *file)
{
    for (; clip > 0; clip = outline->clip[clip - 1].up)
        if (!region_cut(h, shape, &outline->clip[clip - 1].outline, file)) {
            region_free(shape);
            return NULL;
        }
    return shape;
}

/* All shapes of an outline together. */
static region *shapes_of(host *h, const drawing *outline, const char *file)
{
    region *all = NULL;

    for (size_t first = 0, last; first < outline->count; first = last) {
        const unsigned fill = outline->curve[first].fill;
        for (last = first; last < outline->count && outline->curve[last].fill == fill; last++)
            ;
        region *one = region_inside(h, outline, first, last, fill & DRAWING_EVENODD, file);
        if (one != NULL)
            one = cut_shape(h, one, outline, outline->curve[first].clip, file);
        if (one == NULL || all == NULL) {
            if (one == NULL) {
                region_free(all);
                return NULL;
            }
            all = one;
            continue;
        }
        GEOSGeometry *both = GEOSUnionPrec_r(all->h, all->g, one->g, PIECES_GRID);
        region_free(one);
        GEOSGeom_destroy_r(all->h, all->g);
        all->g = both;
        if (both == NULL)
            return failed(h, all, outline, first, file);
    }
    return all;
}

bool region_cut(host *h, region *r, const drawing *outline, const char *file)
{
    region *by = outline->count > 0 ? shapes_of(h, outline, file) : NULL;

    if (outline->count > 0 && by == NULL)
        return false;
    GEOSGeometry *cut = by ? GEOSIntersectionPrec_r(r->h, r->g, by->g, PIECES_GRID)
                           : GEOSGeom_createEmptyPolygon_r(r->h);
    region_free(by);
    if (cut == NULL) {
        (void)host_error(h, EX_DATAERR, "region.clip", (host_place){ source_name(file), 0 },
                         "simplify it", "a clip path cannot be applied");
        return false;
    }
    GEOSGeom_destroy_r(r->h, r->g);
    r->g = cut;
    return true;
}

/* The symmetric matrix `pen` times a point. */
static void shape_point(const double pen[3], double at[2])
{
    const double x = at[0], y = at[1];

    at[0] = pen[0] * x + pen[1] * y;
    at[1] = pen[1] * x + pen[2] * y;
}

/* How much `pen` lengthens: its larger value, as the other one is the inverse. */
static double stretch_of(const double pen[3])
{
    const double half = (pen[0] + pen[2]) / 2;

    return half + sqrt(fmax(half * half - 1, 0));
}

/* Chords of a quarter turn with this radius. GEOS rounds their number in each turn: one may be half
 * as long again. */
static int quarter_chords(double radius)
{
    const double half = acos(1 - fmin(REGION_TOL / fmax(radius, REGION_TOL), 0.3));

    return (int)fmin(fmax(ceil(1.5 * 0.7853981633974483 / half), 2), 2000);
}


/* Is one of its chains such a stroke? */
static bool is_hard(const polylines *p, const region_stroke *s)
{
    for (size_t k = 0; k < p->chains; k++)
        if (pieces_needed((const double(*)[2])p->point + p->first[k], p->first[k + 1] - p->first[k],
                          s))
            return true;
    return false;
}

static GEOSGeometry *put_together(GEOSContextHandle_t h, const polylines *p, const region_stroke *s,
                                  int quarter)
{
    pieces *all = pieces_open(h, s, quarter);

    for (size_t k = 0; k < p->chains; k++)
        pieces_add(all, (const double(*)[2])p->point + p->first[k], p->first[k + 1] - p->first[k]);
    return pieces_join(all);
}

region *region_of_stroke(host *h, const drawing *d, size_t first, size_t last,
                         const region_stroke *s, const char *file)
{
    static const int caps[]  = { GEOSBUF_CAP_FLAT, GEOSBUF_CAP_ROUND, GEOSBUF_CAP_SQUARE },
                     joins[] = { GEOSBUF_JOIN_MITRE, GEOSBUF_JOIN_ROUND, GEOSBUF_JOIN_BEVEL };
    region *r = new_region();
    polylines p;

    if (s->pen[0] > 0)
        memcpy(r->pen, s->pen, sizeof r->pen);
    if (find_chords(&p, d, first, last, false)) {
        const double back[3] = { r->pen[2], -r->pen[1], r->pen[0] };
        for (size_t i = 0; i < p.count && s->pen[0] > 0; i++)
            shape_point(back, p.point[i]);
        const int quarter   = quarter_chords(s->width / 2 * stretch_of(r->pen));
        const bool hard = is_hard(&p, s), pieced = hard && p.count <= PIECED_MOST;
        GEOSGeometry *lines = pieced ? NULL : lines_of(r->h, &p);
        if (hard && !pieced)
            host_warn(h, "region.stroke-chords",
                      (host_place){ source_name(file), d->curve[first].line }, "split the path",
                      "a stroke of more than %u chords: where it bends more tightly than it is "
                      "wide it may have false holes",
                      PIECED_MOST);
        if (pieced)
            r->g = put_together(r->h, &p, s, quarter);
        else if (lines != NULL)
            r->g = GEOSBufferWithStyle_r(r->h, lines, s->width / 2, quarter, caps[s->cap],
                                         joins[s->join], s->mitre);
        GEOSGeom_destroy_r(r->h, lines);
    }
    free_chords(&p);
    return r->g ? r : failed(h, r, d, first, file);
}

bool region_shrink(host *h, region *r, double by, const char *file)
{
    GEOSGeometry *less = GEOSBufferWithStyle_r(r->h, r->g, -by, quarter_chords(by),
                                               GEOSBUF_CAP_ROUND, GEOSBUF_JOIN_ROUND, 5);

    if (less == NULL) {
        (void)host_error(h, EX_DATAERR, "region.not-smaller", (host_place){ source_name(file), 0 },
                         "give another distance", "--fill: a shape cannot be made smaller by %g mm",
                         by);
        return false;
    }
    GEOSGeom_destroy_r(r->h, r->g);
    r->g = less;
    return true;
}

static void add_ring(const region *r, const GEOSGeometry *line, bool hole, region_rings *out)
{
    GEOSContextHandle_t h      = r->h;
    const GEOSCoordSequence *s = line ? GEOSGeom_getCoordSeq_r(h, line) : NULL;
    unsigned n                 = 0;

    if (s == NULL || GEOSCoordSeq_getSize_r(h, s, &n) != 1 || n < 4)
        return;
    double(*point)[2] = memory_grow(NULL, n * sizeof *point);
    if (GEOSCoordSeq_copyToBuffer_r(h, s, point[0], 0, 0) != 1) {
        free(point);
        return;
    }
    for (unsigned k = 0; k < n; k++)
        shape_point(r->pen, point[k]);
    out->ring = memory_grow(out->ring, (out->count + 1) * sizeof *out->ring);
    out->ring[out->count++] = (region_ring){ .point = point, .count = n - 1, .hole = hole };
}

void region_outlines(const region *r, region_rings *out)
{
    const double most       = REGION_TOL / 4 / stretch_of(r->pen);
    GEOSGeometry *plain     = GEOSTopologyPreserveSimplify_r(r->h, r->g, most);
    const GEOSGeometry *all = plain ? plain : r->g;
    const int parts         = GEOSGetNumGeometries_r(r->h, all);

    *out = (region_rings){ .count = 0 };
    for (int i = 0; i < parts; i++) {
        const GEOSGeometry *one = GEOSGetGeometryN_r(r->h, all, i);
        if (GEOSGeomTypeId_r(r->h, one) != GEOS_POLYGON || GEOSisEmpty_r(r->h, one) == 1)
            continue;
        add_ring(r, GEOSGetExteriorRing_r(r->h, one), false, out);
        for (int k = 0; k < GEOSGetNumInteriorRings_r(r->h, one); k++)
            add_ring(r, GEOSGetInteriorRingN_r(r->h, one, k), true, out);
    }
    GEOSGeom_destroy_r(r->h, plain);
}

void region_rings_free(region_rings *rings)
{
    for (size_t i = 0; i < rings->count; i++)
        free(rings->ring[i].point);
    free(rings->ring);
    *rings = (region_rings){ .count = 0 };
}

void region_free(region *r)
{
    if (r == NULL)
        return;
    GEOSGeom_destroy_r(r->h, r->g);
    GEOS_finish_r(r->h);
    free(r);
}
