/* host-tools/svg/svg.c -- the SVG document: elements, viewports, <use>
 * SPDX-License-Identifier: MIT
 *
 * It draws path, rect, circle, ellipse, line, polyline, polygon and text, within g, a, svg, switch
 * and use. What it cannot draw (pictures, masks) is reported once. An error in the file ends
 * the reading, with its line.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/scan.h"       /* scan_number */
#include "svg/svg.h"

#define MM_PER_PX (25.4 / 96)
#define PEN_MOST  1000.0        /* longer than a disk; strokes of thinner pens are lines */
#define BOX_TOL   1e-6          /* mm */
#define PEN_LEAST 1e-9          /* an ellipse that is 1.6e-5 longer than a disk is one */

static const xmlChar xlink_namespace[] = "http://www.w3.org/1999/xlink";

/* The targets of the <use> elements that are currently drawn, innermost first. */
struct svg_uses {
    const xmlNode *target;
    const svg_uses *up;
};

static bool draw_node(svg_reader *r, const xmlNode *node, svg_space space, const svg_uses *chain);


// What is drawn at all
// --------------------

static bool is_one_of(const xmlNode *node, const char *const names[])
{
    for (; *names != NULL; names++)
        if (strcmp((const char *)node->name, *names) == 0)
            return true;
    return false;
}

/* Conditional processing: no extension is supported, and the language is English. */
static bool element_applies(const xmlNode *node)
{
    char *extensions = svg_attribute(node, "requiredExtensions"),
         *language = svg_attribute(node, "systemLanguage");
    const bool good = extensions == NULL &&
                      (language == NULL || strncmp(language, "en", 2) == 0 ||
                       strstr(language, ",en") != NULL || strstr(language, ", en") != NULL);

    xmlFree(extensions);
    xmlFree(language);
    return good;
}

/* Of a clip path, shapes and text count, and uses of them. */
static bool clips(const svg_reader *r, const xmlNode *node, const svg_uses *chain)
{
    static const char *const groups[] = { "g", "a", "svg", "switch", "symbol", NULL };

    return !r->clipping || r->masking || r->boxing ||
           !(is_one_of(node, groups) || (chain != NULL && svg_is(node, "use")));
}

static void warn_undrawn(svg_reader *r, const svg_space *space)
{
    static const char *const pictures[] = { "image", "foreignObject", NULL };

    if (space->visible && svg_is(r->node, "flowRoot"))
        svg_warn(r, SVG_WARN_TEXT, "<flowRoot> is not drawn: convert text to paths");
    if (space->visible && is_one_of(r->node, pictures))
        svg_warn(r, SVG_WARN_PICTURE, "<%s> is not drawn: trace pictures to paths",
                 (const char *)r->node->name);
}


// Viewports
// ---------

static bool draw_children(svg_reader *r, const xmlNode *node, svg_space space,
                          const svg_uses *chain)
{
    for (const xmlNode *child = node->children; child != NULL; child = child->next)
        if (!draw_node(r, child, space, chain))
            return false;
    return true;
}

/* An <svg> inside the drawing, or the target of a <use>, which gives the sizes. */
static bool draw_viewport(svg_reader *r, const xmlNode *node, svg_space space, double width,
                          double height, const svg_uses *chain)
{
    const svg_matrix frame = space.to_mm;
    const bool clipped = space.clipped && width > 0 && height > 0;
    const size_t first = r->d->count;

    r->node = node;
    if (svg_enter_viewport(r, &space, width, height) && !draw_children(r, node, space, chain))
        return false;
    return !clipped || svg_cut_frame(r, node, &frame, width, height, first);
}

bool svg_viewport(svg_reader *r, const xmlNode *node, svg_space space, double width, double height)
{
    return draw_viewport(r, node, space, width, height, NULL);
}

bool svg_children(svg_reader *r, const xmlNode *node, svg_space space)
{
    return draw_children(r, node, space, NULL);
}

static bool draw_svg(svg_reader *r, const xmlNode *node, svg_space space, const svg_uses *chain)
{
    double width = space.width, height = space.height;

    svg_move_origin(r, &space);
    svg_sizes(r, &space, &width, &height);
    return draw_viewport(r, node, space, width, height, chain);
}

static bool draw_switch(svg_reader *r, const xmlNode *node, svg_space space, const svg_uses *chain)
{
    for (const xmlNode *child = node->children; child != NULL; child = child->next)
        if (svg_is(child, NULL) && element_applies(child))
            return draw_node(r, child, space, chain);
    return true;
}


// Use
// ---

static int compare_ids(const void *a, const void *b)
{
    return strcmp(((const svg_named *)a)->id, ((const svg_named *)b)->id);
}

const xmlNode *svg_find(const svg_reader *r, const char *id)
{
    const svg_named key = { (char *)(size_t)id, NULL };
    const svg_named *found = r->named_count
                                 ? bsearch(&key, r->named, r->named_count, sizeof key, compare_ids)
                                 : NULL;

    return found ? found->node : NULL;
}

char *svg_reference(const xmlNode *node)
{
    char *href = svg_attribute(node, "href");

    if (href == NULL)
        href = (char *)xmlGetNsProp(node, (const xmlChar *)"href", xlink_namespace);
    return href ? href : svg_attribute(node, "xlink:href");
}

/* The target of the current <use>; NULL, after a warning, if there is none. */
static const xmlNode *use_target(svg_reader *r)
{
    char *href = svg_reference(r->node);
    const xmlNode *target = NULL;

    if (href == NULL)
        svg_warn(r, SVG_WARN_USE_NOTHING,
                 "<use> without href draws nothing: name an element, as href=\"#id\"");
    else if (href[0] != '#')
        svg_warn(r, SVG_WARN_USE_ELSEWHERE,
                 "<use> of \"%.60s\" is not drawn, it is not in this file: copy it in, "
                 "and name it as \"#id\"",
                 href);
    else if ((target = svg_find(r, href + 1)) == NULL)
        svg_warn(r, SVG_WARN_USE_MISSING, "<use> of \"%.60s\" is not drawn, no element has this id",
                 href);
    xmlFree(href);
    return target;
}

static bool is_in_chain(const svg_uses *chain, const xmlNode *target)
{
    while (chain != NULL && chain->target != target)
        chain = chain->up;
    return chain != NULL;
}

static void warn_circular_use(const svg_reader *r)
{
    char *href = svg_reference(r->node);

    svg_warn(r, SVG_WARN_USE_CYCLE, "<use> of \"%.60s\" is not drawn, it uses itself", href);
    xmlFree(href);
}

/* A <symbol> or <svg> that the <use> `node` draws. The sizes of the <use> override its own. */
static bool draw_use_viewport(svg_reader *r, const xmlNode *node, svg_space space,
                              const svg_uses *chain)
{
    double width = space.width, height = space.height;
    svg_scope scope;
    bool shown;

    r->node = chain->target;
    bool good = svg_enter(r, &space, &scope, &shown);
    if (good && shown) {
        svg_move_origin(r, &space);
        svg_sizes(r, &space, &width, &height);
        r->node = node;
        svg_sizes(r, &space, &width, &height);
        good = draw_viewport(r, chain->target, space, width, height, chain);
    }
    svg_scope_close(&scope);
    return good;
}

static bool draw_use(svg_reader *r, const xmlNode *node, svg_space space, const svg_uses *chain)
{
    const xmlNode *target = use_target(r);
    const svg_uses link = { target, chain };

    if (target == NULL)
        return true;
    svg_set_context(&space, &space);
    if (is_in_chain(chain, target)) {
        warn_circular_use(r);
        return true;
    }
    svg_move_origin(r, &space);
    if (!clips(r, target, NULL))
        return true;
    if (svg_is(target, "symbol") || svg_is(target, "svg"))
        return draw_use_viewport(r, node, space, &link);
    return draw_node(r, target, space, &link);
}


// Elements
// --------

/* A stroke is made in user units, around a disk, which a transform M makes an ellipse. Turns of
 * the disk change nothing: of S = M M' / |det M|, of determinant 1, all that matters is the root,
 * (S + 1) / sqrt(tr S + 2). */
static void set_pen(svg_reader *r, const svg_matrix *m)
{
    const double area = fabs(m->a * m->d - m->b * m->c), xx = (m->a * m->a + m->c * m->c) / area,
                 yy = (m->b * m->b + m->d * m->d) / area, xy = (m->a * m->b + m->c * m->d) / area;
    const double root = sqrt(xx + yy + 2);

    memset(r->pen, 0, sizeof r->pen);
    if (!(area > 0 && root < PEN_MOST) || xx + yy - 2 < PEN_LEAST)
        return;
    r->pen[0] = (float)((xx + 1) / root);
    r->pen[1] = (float)(xy / root);
    r->pen[2] = (float)((yy + 1) / root);
}

bool svg_begin(svg_reader *r, const svg_space *space)
{
    const bool painted = space->fill && space->fill_opaque,
               filled  = painted || (r->clipping && !r->masking),
               stroked = !r->clipping && space->stroke && space->stroke_opaque &&
                         space->stroke_wide,
               evenodd = r->clipping && !r->masking ? space->clip_evenodd : space->evenodd;

    r->fill = (r->fill / DRAWING_SHAPE + 1) * DRAWING_SHAPE + (filled ? DRAWING_FILLED : 0) +
              (stroked ? DRAWING_STROKED : 0) + (evenodd ? DRAWING_EVENODD : 0);
    if (r->masking && painted)
        r->plain = r->plain && space->fill_ink && strcmp(space->fill_ink, "#ffffff") == 0;
    if (r->masking)
        r->plain = r->plain && !(space->stroke && space->stroke_opaque && space->stroke_wide);
    const svg_matrix *m = &space->to_mm;
    r->width = (float)(space->stroke_width * sqrt(fabs(m->a * m->d - m->b * m->c)));
    r->mitre = (float)space->mitre;
    set_pen(r, m);
    r->cap   = (unsigned char)space->cap;
    r->join  = (unsigned char)space->join;
    r->tool = r->layer_tool ? r->layer_tool : svg_ink_tool(r, space, stroked);
    return r->boxing || (space->visible && (filled || stroked));
}

/* Is it a box along the axes? */
static bool is_box(const drawing *d, size_t first)
{
    for (size_t i = first; i < d->count; i++)
        for (int k = 1; k < 4; k++) {
            const drawing_curve *c = &d->curve[i];
            if (fabs(c->p[k][0] - c->p[0][0]) > BOX_TOL && fabs(c->p[k][1] - c->p[0][1]) > BOX_TOL)
                return false;
        }
    return d->count - first <= 5;
}

/* Are the curves around the whole page? */
static bool is_around_page(const drawing *d, size_t first)
{
    const drawing one = { .curve = d->curve + first, .count = d->count - first };
    double box[2][2];

    return d->width > 0 && drawing_box(&one, box) && box[0][0] <= BOX_TOL && box[0][1] <= BOX_TOL &&
           box[1][0] >= d->width - BOX_TOL && box[1][1] >= d->height - BOX_TOL;
}

/* White boxes below everything else, or as large as the page, are paper, as programs for plots and
 * icons draw it: on paper they are not seen. A tool for white, and --only white, draw them. */
static bool is_page(const svg_reader *r, const svg_space *space, size_t first)
{
    return !r->d->white && !r->clipping && r->d->only == NULL && !(r->fill & DRAWING_STROKED) &&
           space->fill_ink != NULL && strcmp(space->fill_ink, "#ffffff") == 0 &&
           svg_ink_tool(r, space, false) == 0 && is_box(r->d, first) &&
           (first == 0 || is_around_page(r->d, first));
}

/* A shape, if it is seen, and its markers: they are also where the shape is not. */
static bool draw_shape(svg_reader *r, const svg_space *space, bool seen, bool marked)
{
    svg_vertices *const outer = r->vertices, *all = marked ? svg_vertices_open() : NULL;
    const size_t first        = r->d->count;
    bool known;

    r->vertices    = all;
    r->notes->lost = false;
    bool good      = svg_shape(r, space, &known);
    r->vertices    = NULL;
    if (!seen || r->notes->lost)
        r->d->count = first;
    if (r->d->count > first && is_page(r, space, first)) {
        r->d->count    = first;
        r->notes->page = r->notes->page ? r->notes->page : r->node;
    }
    marked = marked && !r->notes->lost;
    good = good && svg_dash(r, space, first);
    if (good && marked)
        good = svg_markers(r, space, all);
    r->vertices = outer;
    svg_vertices_close(all);
    return good;
}

static bool draw_element(svg_reader *r, const xmlNode *node, svg_space space, const svg_uses *chain)
{
    static const char *const groups[] = { "g", "a", NULL };

    if (is_one_of(node, groups))
        return draw_children(r, node, space, chain);
    if (svg_is(node, "svg"))
        return draw_svg(r, node, space, chain);
    if (svg_is(node, "use"))
        return draw_use(r, node, space, chain);
    if (svg_is(node, "switch"))
        return draw_switch(r, node, space, chain);
    if (r->d->layers != NULL && r->chosen == 0)
        return true;
    if (svg_is(node, "text"))
        return svg_text(r, &space);
    warn_undrawn(r, &space);
    if (!space.visible && !r->boxing)
        return true;
    const bool tiled = space.pattern != NULL && !r->clipping;
    if (tiled && space.fill_opaque && !svg_pattern(r, &space))
        return false;
    space.fill = space.fill && !tiled;
    const bool seen = svg_begin(r, &space), marked = svg_has_markers(r, &space),
               chosen = seen && svg_ink_chosen(r, &space, r->fill & DRAWING_STROKED);
    if (chosen || marked)
        return draw_shape(r, &space, chosen, marked);
    if (seen || tiled || r->clipping)
        return true;
    svg_warn(r, SVG_WARN_UNSEEN,
             "<%s> without fill and stroke is invisible and not drawn: give it a stroke to draw it",
             (const char *)node->name);
    return true;
}

/* Elements that are drawn only through others, or never. */
static bool is_never_drawn(const xmlNode *node)
{
    static const char *const names[] = { "defs",           "symbol",         "clipPath",
                                         "mask",           "pattern",        "marker",
                                         "linearGradient", "radialGradient", "filter",
                                         "style",          "script",         "title",
                                         "desc",           "metadata",       NULL };
    return is_one_of(node, names);
}

bool svg_geometry(svg_reader *r, const svg_element *e, drawing *out)
{
    drawing *const d    = r->d;
    const xmlNode *was  = r->node;
    const unsigned fill = r->fill;
    const bool clipping = r->clipping, masking = r->masking, boxing = r->boxing;

    r->d        = out;
    r->node     = e->node;
    r->clipping = r->boxing = true;
    r->masking  = false;
    const bool good = draw_element(r, e->node, *e->space, e->uses);
    r->clipping     = clipping;
    r->masking      = masking;
    r->boxing       = boxing;
    r->fill         = fill;
    r->node         = was;
    r->d            = d;
    return good;
}

static bool draw_in_space(svg_reader *r, const xmlNode *node, svg_space space,
                          const svg_uses *chain)
{
    svg_scope scope;
    bool shown, good = svg_enter(r, &space, &scope, &shown);
    const double area = space.to_mm.a * space.to_mm.d - space.to_mm.b * space.to_mm.c;
    const svg_element self = { node, &space, chain };
    const size_t first     = r->d->count;

    if (good && shown && area != 0)     /* flattened to a line or a point: SVG draws nothing */
        good = draw_element(r, node, space, chain);
    r->node = node;
    if (good && shown && area != 0)
        good = svg_clip_element(r, &self, first) && svg_mask_element(r, &self, first);
    svg_scope_close(&scope);
    return good;
}

static bool draw_node(svg_reader *r, const xmlNode *node, svg_space space, const svg_uses *chain)
{
    if (!svg_is(node, NULL) || is_never_drawn(node) || !element_applies(node) ||
        !clips(r, node, chain))
        return true;
    r->node = node;
    if (!svg_goes_on(r, "drawing"))
        return false;
    if (++r->visited > SVG_ELEMENTS_MAX)
        return svg_fail(r, "svg.too-many-elements",
                        "more than %u elements, counting each use: split the drawing",
                        SVG_ELEMENTS_MAX);
    if (r->depth >= SVG_DEPTH_MAX)
        return svg_fail(r, "svg.nested-too-deep",
                        "more than %d nested elements, counting each use: draw with fewer groups",
                        SVG_DEPTH_MAX);
    const bool chosen = svg_layer_chosen(r, node);
    if (!svg_layer_drawn(r, node))
        return true;
    const unsigned tool = r->layer_tool, layer = r->layer;
    r->layer_tool = svg_layer_tool(r, node);
    r->layer      = svg_layer_number(r, node);
    r->depth++;
    r->chosen += chosen;
    const bool good = draw_in_space(r, node, space, chain);
    r->layer_tool = tool;
    r->layer      = layer;
    r->chosen -= chosen;
    r->depth--;
    return good;
}


// The page
// --------

svg_space svg_space_usual(void)
{
    return (svg_space){ .to_mm = svg_identity,
                        .width = -1,
                        .height = -1,
                        .visible = true,
                        .fill = true,
                        .fill_opaque = true,
                        .stroke_opaque = true,
                        .stroke_wide = true,
                        .stroke_width = 1,
                        .mitre = 4,
                        .rem = SVG_FONT_SIZE_USUAL,
                        .font = svg_font_usual() };
}

/* Map the page to mm, y up. Sizes that are not given come from the viewBox, in px, or are
 * unknown. */
static bool enter_page(svg_reader *r, const xmlNode *root, svg_space *space, svg_scope *scope,
                       bool *empty)
{
    double box[4], width = -1, height = -1;

    *space = svg_space_usual();
    r->node = root;
    const bool given = svg_view_box(r, box);
    if (given) {
        space->width  = box[2];
        space->height = box[3];
    }
    svg_sizes(r, space, &width, &height);
    if (given && width < 0)
        width = height < 0 ? box[2] : height * box[2] / box[3];
    if (given && height < 0)
        height = width * box[3] / box[2];

    const bool known = width > 0 && height > 0;
    r->d->width  = known ? width  * MM_PER_PX : 0;
    r->d->height = known ? height * MM_PER_PX : 0;
    space->to_mm = (svg_matrix){ MM_PER_PX, 0, 0, -MM_PER_PX, 0, r->d->height };
    space->width = space->height = -1;
    bool shown;
    const bool good = svg_enter(r, space, scope, &shown);
    *empty = !shown || (good && !svg_enter_viewport(r, space, width, height));
    return good;
}

/* Without a page, the drawing is the page: its lower left corner is the origin. */
static void shift_to_origin(drawing *d)
{
    double box[2][2];

    if (d->height > 0 || !drawing_box(d, box))
        return;
    for (size_t i = 0; i < d->count; i++)
        for (int k = 0; k < 4; k++) {
            d->curve[i].p[k][0] -= box[0][0];
            d->curve[i].p[k][1] -= box[0][1];
        }
}

/* Is --text one of its words? */
static bool check_text(const svg_reader *r)
{
    const char *text = r->d->text;

    if (text == NULL || strcmp(text, "outline") == 0 || strcmp(text, "line") == 0 ||
        strncmp(text, "line:", 5) == 0 || strcmp(text, "none") == 0)
        return true;
    return svg_fail(r, "svg.text-option", "--text %.40s: give outline, line, line:FONT or none",
                    text);
}

static bool draw_page(svg_reader *r, const xmlNode *root)
{
    svg_scope scope = { .up = NULL };
    svg_space space;
    const svg_element self = { root, &space, NULL };
    bool empty;
    r->node = root;
    const bool good = enter_page(r, root, &space, &scope, &empty) &&
                      (empty || draw_children(r, root, space, NULL)) &&
                      svg_clip_element(r, &self, 0) && svg_mask_element(r, &self, 0);
    r->node = root;

    svg_scope_close(&scope);
    return good;
}

/* Is the white page all that there is? Then it is drawn. */
static bool draw_white(svg_reader *r, const xmlNode *root)
{
    r->d->white = true;
    r->layers   = 0;
    if (r->d->named != NULL)
        drawing_names_free(r->d->named);
    return draw_page(r, root);
}

bool svg_draw(svg_reader *r, const xmlNode *root)
{
    r->node   = root;
    bool good = svg_layers_check(r, root) && check_text(r) && draw_page(r, root);

    if (good && r->notes->page != NULL && r->d->count == 0) {
        good = draw_white(r, root);
    } else if (good && r->notes->page != NULL) {
        r->node = r->notes->page;
        svg_warn(
            r, SVG_WARN_PAGE,
            "<%s> is a white page and not drawn, as paper is white: give it a stroke to draw it",
            (const char *)r->node->name);
        r->node = root;
    }
    if (!good || !svg_ink_check(r))
        return false;
    shift_to_origin(r->d);
    return true;
}
