/* host-tools/svg.c -- the SVG document: elements, viewports, <use>, what is hidden
 * SPDX-License-Identifier: MIT
 *
 * What is drawn: path, rect, circle, ellipse, line, polyline, polygon, in g, a, svg, switch and use. What cannot be
 * drawn (text, pictures, clipping) is said once. What is wrong in the file ends the reading, with its line.
 */
#include <stdlib.h>
#include <string.h>

#include "svg.h"

#define MM_PER_PX    (25.4 / 96)
#define USE_DEPTH    24             /* <use> of <use> of ..; libxml2 allows 256 elements in each other */
#define VISITED_MAX  2000000u       /* elements, counting those of a <use> each time */

static const xmlChar xlink_namespace[] = "http://www.w3.org/1999/xlink";

/* The targets of the <use> elements that are being drawn, innermost first. */
typedef struct use_chain {
    const xmlNode *target;
    const struct use_chain *up;
    int depth;
} use_chain;

static bool draw(svg_reader *r, const xmlNode *node, svg_space space, const use_chain *chain);


// What is drawn at all
// --------------------

static bool one_of(const xmlNode *node, const char *const names[])
{
    for (; *names != NULL; names++)
        if (strcmp((const char *)node->name, *names) == 0)
            return true;
    return false;
}

/* Conditional processing: no extension is known here, and the language is English. */
static bool applies(const xmlNode *node)
{
    char *extensions = svg_attribute(node, "requiredExtensions"), *language = svg_attribute(node, "systemLanguage");
    const bool good = extensions == NULL && (language == NULL || strncmp(language, "en", 2) == 0 ||
                                             strstr(language, ",en") != NULL || strstr(language, ", en") != NULL);

    xmlFree(extensions);
    xmlFree(language);
    return good;
}

/* Does the property paint? If it is not said: as before. */
static void read_paint(const svg_reader *r, const char *name, bool *paints)
{
    char *value = svg_property(r, name);

    if (value != NULL && strcmp(value, "inherit") != 0)
        *paints = strcmp(value, "none") != 0 && strcmp(value, "transparent") != 0;
    xmlFree(value);
}

/* Read display, visibility and paint of the current element; false if nothing of it is drawn. */
static bool is_displayed(const svg_reader *r, svg_space *space)
{
    char *display = svg_property(r, "display"), *visibility = svg_property(r, "visibility");
    const bool good = display == NULL || strcmp(display, "none") != 0;

    if (visibility != NULL && (strcmp(visibility, "hidden") == 0 || strcmp(visibility, "collapse") == 0))
        space->visible = false;
    else if (visibility != NULL && (strcmp(visibility, "visible") == 0 || strcmp(visibility, "initial") == 0))
        space->visible = true;
    xmlFree(display);
    xmlFree(visibility);
    read_paint(r, "fill", &space->filled);
    read_paint(r, "stroke", &space->stroked);
    return good;
}

/* Apply the transform of the current element: of its style, or else its attribute. */
static bool enter_transform(const svg_reader *r, svg_space *space)
{
    char *attribute = svg_attribute(r->node, "transform"), *text = svg_property(r, "transform");
    const bool css = text != NULL && (attribute == NULL || strcmp(attribute, text) != 0);
    const bool good = text == NULL || svg_transform(r, text, css, &space->to_mm);

    xmlFree(attribute);
    xmlFree(text);
    return good;
}

/* Say what the drawing will lack. */
static void warn_of(svg_reader *r)
{
    static const char *const left_out[][2] = {
        { "clip-path", "the whole outline is drawn: cut the paths in the editor" }, { "mask", "the whole outline is drawn: cut the paths in the editor" },
        { "stroke-dasharray", "whole lines are drawn: make paths of the dashes in the editor" }
    };

    for (unsigned i = 0; i < 3; i++) {
        char *value = svg_property(r, left_out[i][0]);
        if (value != NULL && strcmp(value, "none") != 0 && strcmp(value, "inherit") != 0 && strcmp(value, "0") != 0)
            svg_warn(r, 5 + i, "%s is not applied, %s", left_out[i][0], left_out[i][1]);
        xmlFree(value);
    }
}

static void warn_undrawn(svg_reader *r, const svg_space *space)
{
    static const char *const texts[]    = { "text", "flowRoot", NULL };
    static const char *const pictures[] = { "image", "foreignObject", NULL };

    if (space->visible && one_of(r->node, texts))
        svg_warn(r, 3, "<%s> is not drawn: convert text to paths", (const char *)r->node->name);
    if (space->visible && one_of(r->node, pictures))
        svg_warn(r, 4, "<%s> is not drawn: trace pictures to paths", (const char *)r->node->name);
}


// Viewports
// ---------

/* Enter the viewport of the current element: a box of width x height (below 0: unknown) in `space` becomes its
 * viewBox. *empty: it has no size, nothing of it is drawn. */
static bool enter_viewport(const svg_reader *r, svg_space *space, double width, double height, bool *empty)
{
    double box[4];
    bool given;
    svg_matrix fit;

    if (!svg_view_box(r, box, &given))
        return false;
    if (given && (width < 0 || height < 0)) {
        width  = box[2];
        height = box[3];
    }
    *empty = width == 0 || height == 0 || (given && (box[2] == 0 || box[3] == 0));
    if (*empty)
        return true;
    if (given) {
        if (!svg_fit(r, box, width, height, &fit))
            return false;
        space->to_mm = svg_multiply(space->to_mm, fit);
        width  = box[2];
        height = box[3];
    }
    space->width  = width;
    space->height = height;
    return true;
}

/* The sizes that an element gives itself, `width` and `height` if it does not. */
static bool sizes(const svg_reader *r, const svg_space *space, double *width, double *height)
{
    const double across = *width, along = *height;

    if (!svg_length(r, space, "width", SVG_ACROSS, across, width) || !svg_length(r, space, "height", SVG_ALONG_Y, along, height))
        return false;
    if ((*width < 0 && *width != across) || (*height < 0 && *height != along))
        return svg_fail(r, "width and height cannot be negative");
    return true;
}

static bool moved(const svg_reader *r, svg_space *space)
{
    double x, y;

    if (!svg_length(r, space, "x", SVG_ACROSS, 0, &x) || !svg_length(r, space, "y", SVG_ALONG_Y, 0, &y))
        return false;
    space->to_mm = svg_multiply(space->to_mm, (svg_matrix){ 1, 0, 0, 1, x, y });
    return true;
}

static bool draw_children(svg_reader *r, const xmlNode *node, svg_space space, const use_chain *chain)
{
    for (const xmlNode *child = node->children; child != NULL; child = child->next)
        if (!draw(r, child, space, chain))
            return false;
    return true;
}

/* An <svg> within the drawing; or the target of a <use>, which gives the sizes. */
static bool draw_viewport(svg_reader *r, const xmlNode *node, svg_space space, double width, double height, const use_chain *chain)
{
    bool empty;

    r->node = node;
    if (!enter_viewport(r, &space, width, height, &empty))
        return false;
    return empty || draw_children(r, node, space, chain);
}

static bool draw_svg(svg_reader *r, const xmlNode *node, svg_space space, const use_chain *chain)
{
    double width = space.width, height = space.height;

    return moved(r, &space) && sizes(r, &space, &width, &height) && draw_viewport(r, node, space, width, height, chain);
}

static bool draw_switch(svg_reader *r, const xmlNode *node, svg_space space, const use_chain *chain)
{
    for (const xmlNode *child = node->children; child != NULL; child = child->next)
        if (svg_is(child, NULL) && applies(child))
            return draw(r, child, space, chain);
    return true;
}


// Use
// ---

static int by_id(const void *a, const void *b)
{
    return strcmp(((const svg_named *)a)->id, ((const svg_named *)b)->id);
}

static const xmlNode *find(const svg_reader *r, const char *id)
{
    const svg_named key = { (char *)(size_t)id, NULL };
    const svg_named *found = r->named_count ? bsearch(&key, r->named, r->named_count, sizeof key, by_id) : NULL;

    while (found != NULL && found > r->named && strcmp(found[-1].id, id) == 0)
        found--;
    return found ? found->node : NULL;
}

static char *reference(const xmlNode *node)
{
    char *href = svg_attribute(node, "href");

    if (href == NULL)
        href = (char *)xmlGetNsProp(node, (const xmlChar *)"href", xlink_namespace);
    return href ? href : svg_attribute(node, "xlink:href");
}

/* The element that the current <use> means; NULL after a message. */
static const xmlNode *use_target(const svg_reader *r, const use_chain *chain)
{
    char *href = reference(r->node);
    const xmlNode *target = NULL;

    if (href == NULL)
        svg_fail(r, "href is missing: name an element, as href=\"#id\"");
    else if (href[0] != '#')
        svg_fail(r, "href=\"%.60s\" is not in this file: copy it in, and name it as \"#id\"", href);
    else if ((target = find(r, href + 1)) == NULL)
        svg_fail(r, "no element has the id \"%.60s\"", href + 1);

    for (const use_chain *c = chain; target != NULL && c != NULL; c = c->up)
        if (c->target == target) {
            svg_fail(r, "\"%.60s\" uses itself: break the circle", href);
            target = NULL;
        }
    if (target != NULL && chain != NULL && chain->depth >= USE_DEPTH) {
        svg_fail(r, "more than %d uses in each other: draw with fewer", USE_DEPTH);
        target = NULL;
    }
    xmlFree(href);
    return target;
}

static bool draw_use(svg_reader *r, const xmlNode *node, svg_space space, const use_chain *chain)
{
    const xmlNode *target = use_target(r, chain);
    const use_chain link = { target, chain, chain ? chain->depth + 1 : 1 };
    double width = space.width, height = space.height;

    if (target == NULL || !moved(r, &space))
        return false;
    if (!svg_is(target, "symbol") && !svg_is(target, "svg"))
        return draw(r, target, space, &link);

    r->node = target;           /* its own sizes, which those of <use> override */
    if (!is_displayed(r, &space))
        return true;
    if (!enter_transform(r, &space) || !moved(r, &space) || !sizes(r, &space, &width, &height))
        return false;
    r->node = node;
    return sizes(r, &space, &width, &height) && draw_viewport(r, target, space, width, height, &link);
}


// Elements
// --------

static bool draw_element(svg_reader *r, const xmlNode *node, svg_space space, const use_chain *chain)
{
    static const char *const groups[] = { "g", "a", NULL };
    bool shape;

    if (one_of(node, groups))
        return draw_children(r, node, space, chain);
    if (svg_is(node, "svg"))
        return draw_svg(r, node, space, chain);
    if (svg_is(node, "use"))
        return draw_use(r, node, space, chain);
    if (svg_is(node, "switch"))
        return draw_switch(r, node, space, chain);
    warn_undrawn(r, &space);
    if (!space.visible)
        return true;
    if (space.filled || space.stroked)
        return svg_shape(r, &space, &shape);
    svg_warn(r, 8, "<%s> without fill and stroke is not seen and not drawn: give it a stroke to draw it", (const char *)node->name);
    return true;
}

/* Elements that only others draw, or nobody. */
static bool is_never_drawn(const xmlNode *node)
{
    static const char *const names[] = {
        "defs", "symbol", "clipPath", "mask", "pattern", "marker", "linearGradient", "radialGradient", "filter",
        "style", "script", "title", "desc", "metadata", NULL
    };
    return one_of(node, names);
}

static bool draw(svg_reader *r, const xmlNode *node, svg_space space, const use_chain *chain)
{
    if (!svg_is(node, NULL) || is_never_drawn(node) || !applies(node))
        return true;
    r->node = node;
    if (++r->visited > VISITED_MAX)
        return svg_fail(r, "more than %u elements, counting each use: split the drawing", VISITED_MAX);
    if (!is_displayed(r, &space))
        return true;
    if (!enter_transform(r, &space))
        return false;
    warn_of(r);
    if (space.to_mm.a * space.to_mm.d - space.to_mm.b * space.to_mm.c == 0)
        return true;            /* flattened to a line or point: SVG draws nothing */
    return draw_element(r, node, space, chain);
}


// The page
// --------

/* Turn the page into mm, y up. Sizes that are not given are those of the viewBox in px, or unknown. */
static bool enter_page(svg_reader *r, const xmlNode *root, svg_space *space, bool *empty)
{
    double box[4], width = -1, height = -1;
    bool given;

    *space = (svg_space){ svg_identity, -1, -1, true, true, false };
    r->node = root;
    if (!svg_view_box(r, box, &given))
        return false;
    if (given) {
        space->width  = box[2];
        space->height = box[3];
    }
    if (!sizes(r, space, &width, &height))
        return false;
    if (given && width < 0)
        width = height < 0 ? box[2] : height * box[2] / box[3];
    if (given && height < 0)
        height = width * box[3] / box[2];

    const bool known = width > 0 && height > 0;
    r->d->width  = known ? width  * MM_PER_PX : 0;
    r->d->height = known ? height * MM_PER_PX : 0;
    space->to_mm = (svg_matrix){ MM_PER_PX, 0, 0, -MM_PER_PX, 0, r->d->height };
    space->width = space->height = -1;
    if (!is_displayed(r, space)) {
        *empty = true;
        return true;
    }
    return enter_transform(r, space) && enter_viewport(r, space, width, height, empty);
}

/* Without a page the drawing itself is one: its lower left corner is the origin. */
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

bool svg_draw(svg_reader *r, const xmlNode *root)
{
    svg_space space;
    bool empty;

    if (!enter_page(r, root, &space, &empty) || (!empty && !draw_children(r, root, space, NULL)))
        return false;
    shift_to_origin(r->d);
    return true;
}

