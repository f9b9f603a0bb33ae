/* host-tools/svg/svg_marker.c -- markers at the vertices of paths, lines and polygons
 * SPDX-License-Identifier: MIT
 *
 * While a shape is drawn its vertices are noted, with the directions of the curves on both sides.
 * Then a marker is drawn at each: its viewport, scaled by the width of the stroke, turned to the
 * direction, cut at its edges. Its style is that of the place where it stands.
 *   see  SVG 2, 13.7: Markers
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/scan.h"       /* scan_number */
#include "base/memory.h"
#include "svg/svg.h"

#define PI 3.14159265358979323846

/* A vertex in mm, and the directions of the path before and behind it; 0, 0: there is none. */
typedef struct {
    double at[2], in[2], out[2];
} vertex;

struct svg_vertices {
    vertex *v;
    size_t count, room;
    size_t first;               /* of the part under way */
};


// Vertices
// --------

static bool is_way(const double way[2]) { return way[0] != 0 || way[1] != 0; }

static void add_vertex(svg_vertices *all, const double at[2])
{
    if (all->count == all->room) {
        all->room = all->room ? 2 * all->room : 16;
        all->v    = memory_grow(all->v, all->room * sizeof *all->v);
    }
    all->v[all->count] = (vertex){ .at = { at[0], at[1] } };
    all->count++;
}

static void way_between(const double a[2], const double b[2], double out[2])
{
    const double length = hypot(b[0] - a[0], b[1] - a[1]);

    for (int i = 0; i < 2; i++)
        out[i] = length > 0 ? (b[i] - a[i]) / length : 0;
}

/* The direction of a curve at its start, or at its end. */
static void way_of(const drawing_curve *c, bool end, double out[2])
{
    out[0] = out[1] = 0;
    for (int k = 1; k < 4 && !is_way(out); k++)
        way_between(c->p[end ? 3 - k : 0], c->p[end ? 3 : k], out);
}

void svg_vertex_move(const svg_pen *pen)
{
    svg_vertices *all = pen->r->vertices;

    if (all == NULL)
        return;
    all->first = all->count;
    add_vertex(all, pen->end);
}

void svg_vertex(const svg_pen *pen, size_t before, bool closes)
{
    svg_vertices *all = pen->r->vertices;
    const drawing *d  = pen->r->d;

    if (all == NULL)
        return;
    if (all->count == 0)
        add_vertex(all, pen->end);
    vertex *last = &all->v[all->count - 1];
    if (d->count > before)
        way_of(&d->curve[before], false, last->out);
    add_vertex(all, pen->end);
    vertex *now = &all->v[all->count - 1];
    if (d->count > before)
        way_of(&d->curve[d->count - 1], true, now->in);
    else if (closes)
        memcpy(now->in, now[-1].in, sizeof now->in);
    if (!closes)
        return;
    memcpy(now->out, all->v[all->first].out, sizeof now->out);
    memcpy(all->v[all->first].in, now->in, sizeof now->in);
    all->first = all->count - 1;
}

/* Half way between both directions, in radians of the user space. */
static double angle_of(const vertex *v, const svg_matrix *m)
{
    const double area = m->a * m->d - m->b * m->c;
    double sum[2], way[2];

    for (int i = 0; i < 2; i++)
        sum[i] = v->in[i] + v->out[i];
    if (hypot(sum[0], sum[1]) < 1e-9 && is_way(v->in)) {
        sum[0] = -v->in[1];
        sum[1] = v->in[0];
    }
    way[0] = (m->d * sum[0] - m->c * sum[1]) / area;
    way[1] = (m->a * sum[1] - m->b * sum[0]) / area;
    return is_way(way) ? atan2(way[1], way[0]) : 0;
}


// Markers
// -------

/* The marker that a value names, or NULL. */
static const xmlNode *marker_of(svg_reader *r, const char *value)
{
    const char *open = value != NULL ? strchr(value, '#') : NULL;
    char id[200];

    if (open == NULL || strncmp(value, "url(", 4) != 0)
        return NULL;
    snprintf(id, sizeof id, "%.*s", (int)strcspn(open + 1, ")\"'"), open + 1);
    const xmlNode *node = svg_find(r, id);
    return node != NULL && svg_is(node, "marker") ? node : NULL;
}

/* refX and refY: a length, or a word of its side. */
static void read_ref(const svg_reader *r, const svg_space *space, const char *name,
                     enum svg_side side, const double box[2], double *out)
{
    static const char *const words[2][3] = { { "left", "center", "right" },
                                             { "top", "center", "bottom" } };
    char *text = svg_attribute(r->node, name);
    bool word  = false;

    for (int k = 0; k < 3 && text != NULL; k++)
        if (strcmp(text, words[side == SVG_ALONG_Y][k]) == 0) {
            *out = box[0] + box[1] * k / 2;
            word = true;
        }
    xmlFree(text);
    if (!word)
        *out = svg_length(r, space, name, side, 0);
}

/* The angle of a marker at a vertex. */
static double read_angle(const svg_reader *r, double along, bool start)
{
    char *text     = svg_attribute(r->node, "orient");
    const char *at = text;
    double out     = 0;

    if (text != NULL && strcmp(text, "auto") == 0)
        out = along;
    else if (text != NULL && strcmp(text, "auto-start-reverse") == 0)
        out = start ? along + PI : along;
    else if (text != NULL && scan_number(&at, &out))
        out *= strcmp(at, "rad") == 0    ? 1
               : strcmp(at, "turn") == 0 ? 2 * PI
               : strcmp(at, "grad") == 0 ? PI / 200
                                         : PI / 180;
    xmlFree(text);
    return out;
}

/* Where the marker is: its reference point on the vertex. *size: of its viewport. */
static void place_marker(const svg_reader *r, const svg_space *of, const vertex *v, double angle,
                         svg_space *space, double size[2])
{
    const double c = cos(angle), s = sin(angle);
    double box[4], ref[2], by = of->stroke_width;
    svg_matrix fit = svg_identity, m = of->to_mm;

    char *units = svg_attribute(r->node, "markerUnits");
    by = units != NULL && strcmp(units, "userSpaceOnUse") == 0 ? 1 : by;
    xmlFree(units);
    size[0] = svg_length(r, of, "markerWidth", SVG_ACROSS, 3);
    size[1] = svg_length(r, of, "markerHeight", SVG_ALONG_Y, 3);
    const bool given = svg_view_box(r, box);
    if (!(size[0] > 0 && size[1] > 0 && by > 0) || (given && !(box[2] > 0 && box[3] > 0))) {
        size[0] = 0;
        return;
    }
    if (!given) {
        box[0] = box[1] = 0;
        box[2] = size[0];
        box[3] = size[1];
    } else {
        fit = svg_fit(r, box, size[0], size[1]);
    }
    const double across[2] = { box[0], box[2] }, along[2] = { box[1], box[3] };
    read_ref(r, of, "refX", SVG_ACROSS, across, &ref[0]);
    read_ref(r, of, "refY", SVG_ALONG_Y, along, &ref[1]);
    m.e = v->at[0];
    m.f = v->at[1];
    m = svg_multiply(m, (svg_matrix){ by * c, by * s, -by * s, by * c, 0, 0 });
    space->to_mm = svg_multiply(m, (svg_matrix){ 1, 0, 0, 1,
                                                 -(fit.a * ref[0] + fit.c * ref[1] + fit.e),
                                                 -(fit.b * ref[0] + fit.d * ref[1] + fit.f) });
}

bool svg_enter_from_root(svg_reader *r, const xmlNode *node, svg_space *space, svg_scope *scope,
                         size_t room, size_t *count, bool *shown)
{
    const xmlNode *way[SVG_DEPTH_MAX];
    size_t n = 0;

    *count = 0;
    for (; node != NULL && node->type == XML_ELEMENT_NODE && n < room; node = node->parent)
        way[n++] = node;
    while (n > 0) {
        const svg_matrix to_mm = space->to_mm;
        r->node = way[--n];
        if (!svg_enter(r, space, &scope[(*count)++], shown))
            return false;
        space->to_mm = to_mm;
    }
    return true;
}

static bool draw_marker(svg_reader *r, const xmlNode *node, const svg_space *of, const vertex *v,
                        bool start)
{
    svg_scope scope[SVG_DEPTH_MAX];
    svg_space space = svg_space_usual();
    double size[2];
    size_t scopes;
    bool shown = false;

    r->node = node;
    svg_set_context(&space, of);
    space.width  = of->width;
    space.height = of->height;
    place_marker(r, of, v, read_angle(r, angle_of(v, &of->to_mm), start), &space, size);
    if (!(size[0] > 0))
        return true;
    bool good = svg_enter_from_root(r, node, &space, scope, SVG_DEPTH_MAX, &scopes, &shown);
    r->node   = node;
    if (good && shown)
        good = svg_viewport(r, node, space, size[0], size[1]);
    while (scopes > 0)
        svg_scope_close(&scope[--scopes]);
    return good;
}

bool svg_is_marking(const svg_reader *r, const xmlNode *node)
{
    for (unsigned i = 0; i < r->markings; i++)
        if (r->marking[i] == node)
            return true;
    return r->markings == SVG_MARKINGS;
}

bool svg_has_markers(const svg_reader *r, const svg_space *space)
{
    static const char *const names[] = { "path", "line", "polyline", "polygon" };

    for (int i = 0; i < 4; i++)
        if (svg_is(r->node, names[i]))
            return !r->clipping && (space->marker[0] || space->marker[1] || space->marker[2]);
    return false;
}

svg_vertices *svg_vertices_open(void)
{
    svg_vertices *all = memory_grow(NULL, sizeof *all);

    *all = (svg_vertices){ .count = 0 };
    return all;
}

void svg_vertices_close(svg_vertices *all)
{
    if (all != NULL)
        free(all->v);
    free(all);
}

bool svg_markers(svg_reader *r, const svg_space *space, const svg_vertices *all)
{
    const xmlNode *const was = r->node;
    const xmlNode *node[3];
    bool good = true;

    for (int k = 0; k < 3; k++)
        node[k] = marker_of(r, space->marker[k]);
    for (size_t i = 0; i < all->count && good; i++) {
        const bool first = i == 0, last = i + 1 == all->count;
        for (int k = 0; k < 3 && good; k++) {
            if (node[k] == NULL || svg_is_marking(r, node[k]) ||
                (k == 0   ? !first
                 : k == 2 ? !last
                          : first || last))
                continue;
            r->marking[r->markings++] = node[k];
            if (++r->visited > SVG_ELEMENTS_MAX)
                good = svg_fail(r, "svg.too-many-elements",
                                "more than %u elements, counting each use: split the drawing",
                                SVG_ELEMENTS_MAX);
            good = good && draw_marker(r, node[k], space, &all->v[i], first);
            r->markings--;
        }
    }
    r->node = was;
    return good;
}
