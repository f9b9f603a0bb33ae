/* host-tools/svg/svg_pattern.c -- shapes that are filled with a pattern
 * SPDX-License-Identifier: MIT
 *
 * The tiles that meet the box of the shape are drawn, each cut at its own edges, and all of them at
 * the outline of the shape. Their style is that of the place where the pattern stands. What a
 * pattern does not say itself, the one that its href names says.
 *   see  SVG 2, 14.3: Patterns
 */
#include <math.h>
#include <string.h>

#include "svg/svg.h"

#define TILES_MAX    10000u     /* of a drawing */
#define ELEMENTS_MAX 200000.0   /* drawn for one shape */
#define PAIRS_MAX    5e6        /* of curves, which are compared to cut the tiles of one shape */
#define WORK_MAX     30000000ull    /* boxes compared for the patterns of a drawing: 0.7 s */
#define LINKS        8

/* A pattern, and those that it refers to. */
typedef struct {
    const xmlNode *link[LINKS];
    size_t count;
} chain;

/* A tile in user units, and the matrix from its corner to mm. */
typedef struct {
    double at[2], size[2], box[2][2];   /* box: of the shape */
    svg_matrix to_mm;
    int first[2], last[2];
    const xmlNode *content, *view;      /* where the children are, and the viewBox, or NULL */
    bool boxed;                         /* 1 is the size of the shape in its content */
} tiling;

static chain follow_links(const svg_reader *r, const xmlNode *node)
{
    chain c = { .count = 0 };

    while (node != NULL && svg_is(node, "pattern") && c.count < LINKS) {
        c.link[c.count++] = node;
        char *href = svg_reference(node);
        node       = href != NULL && href[0] == '#' ? svg_find(r, href + 1) : NULL;
        xmlFree(href);
    }
    return c;
}

/* The first pattern with this attribute, or NULL. */
static const xmlNode *with_attribute(const chain *c, const char *name)
{
    for (size_t i = 0; i < c->count; i++)
        if (xmlHasProp((xmlNode *)(size_t)c->link[i], (const xmlChar *)name) != NULL)
            return c->link[i];
    return NULL;
}

static bool says(const chain *c, const char *name, const char *value)
{
    const xmlNode *node = with_attribute(c, name);
    char *text          = node ? svg_attribute(node, name) : NULL;
    const bool is       = text != NULL && strcmp(text, value) == 0;

    xmlFree(text);
    return is;
}

static const xmlNode *with_children(const chain *c)
{
    for (size_t i = 0; i < c->count; i++)
        for (const xmlNode *child = c->link[i]->children; child != NULL; child = child->next)
            if (svg_is(child, NULL))
                return c->link[i];
    return NULL;
}

/* x, y, width, height, in user units or parts of the box. */
static void read_tile(svg_reader *r, const chain *c, const svg_space *of, tiling *t)
{
    static const char *const names[] = { "x", "y", "width", "height" };
    const bool parts                 = !says(c, "patternUnits", "userSpaceOnUse");
    svg_space space                  = *of;

    if (parts)
        space.width = space.height = 1;
    for (int i = 0; i < 4; i++) {
        const int side      = i % 2;
        const double across = t->box[1][side] - t->box[0][side];
        double *to          = i < 2 ? &t->at[side] : &t->size[side];
        const xmlNode *node = with_attribute(c, names[i]);
        r->node             = node ? node : r->node;
        *to = node ? svg_length(r, &space, names[i], side ? SVG_ALONG_Y : SVG_ACROSS, 0) : 0;
        if (parts)
            *to = *to * across + (i < 2 ? t->box[0][side] : 0);
    }
}

/* Apply the transform of a pattern, about its origin. */
static void turn_tiles(svg_reader *r, const chain *c, const svg_space *of, svg_matrix *to_mm)
{
    const xmlNode *const was = r->node;
    const xmlNode *turned    = with_attribute(c, "patternTransform");
    double at[2]             = { 0, 0 };
    svg_style style;
    svg_scope scope;

    if (turned == NULL)
        return;
    r->node = turned;
    svg_style_open(r, &style, &scope, NULL);
    char *text = svg_attribute(turned, "patternTransform");
    char *origin = svg_property(r, &style, SVG_ORIGIN, NULL);
    if (origin != NULL)
        svg_origin(r, of, origin, at);
    *to_mm = svg_multiply(*to_mm, (svg_matrix){ 1, 0, 0, 1, at[0], at[1] });
    svg_transform(r, text, false, to_mm);
    *to_mm = svg_multiply(*to_mm, (svg_matrix){ 1, 0, 0, 1, -at[0], -at[1] });
    xmlFree(origin);
    xmlFree(text);
    svg_style_close(&style);
    svg_scope_close(&scope);
    r->node = was;
}

/* Where the tiles are that meet the outline. Without any, last < first. */
static void place_tiles(svg_reader *r, const chain *c, const svg_space *of, const drawing *outline,
                        tiling *t)
{
    double box[2][2];

    t->to_mm = of->pattern_placed ? of->pattern_to_mm : of->to_mm;
    svg_box(outline, 0, &t->to_mm, t->box);
    t->content  = with_children(c);
    t->view     = with_attribute(c, "viewBox");
    t->boxed    = t->view == NULL && says(c, "patternContentUnits", "objectBoundingBox");
    t->last[0]  = t->last[1] = -1;
    t->first[0] = t->first[1] = 0;
    read_tile(r, c, of, t);
    if (of->pattern_placed && (t->boxed || !says(c, "patternUnits", "userSpaceOnUse")))
        svg_warn(r, SVG_WARN_PATTERN,
                 "a pattern of context-fill in parts of a box takes the box of each shape: give it "
                 "patternUnits=\"userSpaceOnUse\"");
    turn_tiles(r, c, of, &t->to_mm);
    t->to_mm = svg_multiply(t->to_mm, (svg_matrix){ 1, 0, 0, 1, t->at[0], t->at[1] });
    const double area = t->to_mm.a * t->to_mm.d - t->to_mm.b * t->to_mm.c;
    if (t->content == NULL || !(t->size[0] > 0 && t->size[1] > 0 && fabs(area) > 0))
        return;
    svg_box(outline, 0, &t->to_mm, box);
    for (int i = 0; i < 2; i++) {
        t->first[i] = (int)fmin(fmax(floor(box[0][i] / t->size[i] + 1e-9), -1e9), 1e9);
        t->last[i]  = (int)fmin(fmax(ceil(box[1][i] / t->size[i] - 1e-9) - 1, -1e9), 1e9);
    }
}

/* What a browser clips to: the shape of the current element, closed. */
static bool draw_outline(svg_reader *r, const svg_space *of, drawing *outline)
{
    svg_space space  = *of;
    drawing *const d = r->d;
    const bool was   = r->clipping;
    bool known;

    space.clip_evenodd = of->evenodd;
    r->clipping        = true;
    r->d               = outline;
    (void)svg_begin(r, &space);
    r->notes->lost  = false;
    const bool good = svg_shape(r, &space, &known);
    r->d            = d;
    r->clipping     = was;
    svg_close_outline(outline);
    return good;
}

static bool draw_tile(svg_reader *r, const tiling *t, const svg_space *style, int across, int along)
{
    const size_t first    = r->d->count;
    svg_space space       = *style;
    const double shift[2] = { across * t->size[0], along * t->size[1] };
    const svg_matrix corner = svg_multiply(t->to_mm,
                                           (svg_matrix){ 1, 0, 0, 1, shift[0], shift[1] });
    double box[4];
    svg_matrix fit = svg_identity;

    r->node = t->view ? t->view : t->content;
    if (t->view != NULL && svg_view_box(r, box)) {
        if (!(box[2] > 0 && box[3] > 0))
            return true;
        fit = svg_fit(r, box, t->size[0], t->size[1]);
    } else if (t->boxed) {
        fit.a = t->box[1][0] - t->box[0][0];
        fit.d = t->box[1][1] - t->box[0][1];
    }
    space.to_mm  = svg_multiply(corner, fit);
    space.width  = t->size[0] / fit.a;
    space.height = t->size[1] / fit.d;
    return svg_children(r, t->content, space) &&
           (!space.clipped || svg_cut_frame(r, t->content, &corner, t->size[0], t->size[1], first));
}

/* May so many tiles be drawn? The first one tells what each takes. */
static bool is_bearable(svg_reader *r, double tiles, double elements, double curves, double edges)
{
    if (r->tiling + r->compared - r->since <= WORK_MAX && r->tiles + tiles <= TILES_MAX &&
        tiles * elements <= ELEMENTS_MAX && tiles * curves * edges <= PAIRS_MAX)
        return true;
    svg_warn(r, SVG_WARN_PATTERN,
             "a pattern of %.0f tiles is left out: make its tiles larger, or fewer (%u in a "
             "drawing)",
             tiles, TILES_MAX);
    return false;
}

static bool draw_tiles(svg_reader *r, const tiling *t, const svg_space *style,
                       const drawing *outline)
{
    const xmlNode *const shape = r->node;
    const size_t first     = r->d->count;
    const unsigned visited = r->visited;
    const double tiles     = ((double)t->last[0] - t->first[0] + 1) *
                         ((double)t->last[1] - t->first[1] + 1);
    bool good = true, whole = is_bearable(r, tiles, 1, 1, 1);

    for (int j = t->first[1]; j <= t->last[1] && good && whole; j++)
        for (int i = t->first[0]; i <= t->last[0] && good && whole; i++) {
            good    = draw_tile(r, t, style, i, j);
            r->node = shape;
            if (i == t->first[0] && j == t->first[1])
                whole = is_bearable(r, tiles, r->visited - visited, (double)(r->d->count - first),
                                    (double)outline->count);
            else
                whole = is_bearable(r, tiles, 1, 1, 1);
        }
    if (!whole)
        r->d->count = first;
    else
        r->tiles += (unsigned)tiles;
    return good && (r->d->count == first || svg_cut(r, outline, first));
}

bool svg_pattern(svg_reader *r, const svg_space *of)
{
    const xmlNode *const was = r->node;
    const chain c            = follow_links(r, of->pattern);
    drawing outline          = { .count = 0 };
    svg_scope scope[SVG_DEPTH_MAX];
    svg_space style = svg_space_usual();
    tiling t;
    size_t scopes = 0;
    bool shown    = false;

    if (svg_is_marking(r, of->pattern))
        return true;
    bool good = draw_outline(r, of, &outline);
    const bool seen = good && outline.count > 0 && !r->notes->lost;
    if (seen)
        place_tiles(r, &c, of, &outline, &t);
    if (good && seen && t.last[0] >= t.first[0] && t.last[1] >= t.first[1]) {
        style.width  = of->width;
        style.height = of->height;
        if (r->markings == 0)
            r->since = r->compared;
        r->marking[r->markings++] = of->pattern;
        good = svg_enter_from_root(r, t.content, &style, scope, SVG_DEPTH_MAX, &scopes, &shown);
        r->node = was;
        good    = good && (!shown || draw_tiles(r, &t, &style, &outline));
        r->markings--;
        if (r->markings == 0)
            r->tiling += r->compared - r->since;
    }
    while (scopes > 0)
        svg_scope_close(&scope[--scopes]);
    r->node = was;
    drawing_free(&outline);
    return good;
}
