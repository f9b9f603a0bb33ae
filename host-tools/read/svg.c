/* host-tools/read/svg.c -- the SVG document: elements, viewports, <use>, hidden elements
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
#include "read/svg.h"

#define MM_PER_PX (25.4 / 96)
#define UNCLIPPED 0.01          /* mm; a smaller excess over a viewport is not reported */

static const xmlChar xlink_namespace[] = "http://www.w3.org/1999/xlink";

/* The targets of the <use> elements that are currently drawn, innermost first. */
typedef struct use_chain {
    const xmlNode *target;
    const struct use_chain *up;
} use_chain;

static bool draw_node(svg_reader *r, const xmlNode *node, svg_space space, const use_chain *chain);


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

/* Is the colour fully transparent? The opacity, if there is one, is the last part. */
static bool is_clear(const char *colour)
{
    const size_t length = strlen(colour);
    const char *last = strrchr(colour, '/') ? strrchr(colour, '/') : strrchr(colour, ',');
    double x;

    if (colour[0] == '#')
        return (length == 5 && colour[4] == '0') || (length == 9 && strcmp(colour + 7, "00") == 0);
    if (last != NULL &&
        (strncmp(colour, "rgba(", 5) == 0 || strncmp(colour, "hsla(", 5) == 0 || *last == '/')) {
        last++;
        scan_space(&last);
        return scan_number(&last, &x) && x <= 0;
    }
    return strcmp(colour, "none") == 0 || strcmp(colour, "transparent") == 0;
}

static bool is_inherited(const char *value)
{
    return value == NULL || strcmp(value, "inherit") == 0 || strcmp(value, "unset") == 0;
}

/* Does the property paint, and with which colour? If it is not set, both stay. */
static void read_paint(svg_reader *r, const svg_style *style, enum svg_property which, bool *paints,
                       const char **ink)
{
    char *value = svg_property(r, style, which, NULL);

    if (!is_inherited(value)) {
        *paints = strcmp(value, "initial") == 0 ? which == SVG_FILL : !is_clear(value);
        if (r->d->only != NULL || r->d->tools != NULL || r->masking)
            *ink = svg_ink(r, value);
    }
    xmlFree(value);
}

/* Is the number above 0? If it is not set, or not a number, the value stays. */
static void read_positive(svg_reader *r, const svg_style *style, enum svg_property which,
                          bool *positive)
{
    char *value = svg_property(r, style, which, NULL);
    const char *at = value;
    double x;

    if (value != NULL && strcmp(value, "initial") == 0)
        *positive = true;
    else if (value != NULL && scan_number(&at, &x) && (x >= 0 || which != SVG_STROKE_WIDTH))
        *positive = x > 0;
    xmlFree(value);
}

static void read_rule(svg_reader *r, const svg_style *style, enum svg_property which, bool *evenodd)
{
    char *value = svg_property(r, style, which, NULL);

    if (value != NULL && strcmp(value, "evenodd") == 0)
        *evenodd = true;
    else if (value != NULL && (strcmp(value, "nonzero") == 0 || strcmp(value, "initial") == 0))
        *evenodd = false;
    xmlFree(value);
}

/* The text of an inherited property; `none` and `initial` give NULL. */
static void read_words(svg_reader *r, const svg_style *style, enum svg_property which,
                       const char **out)
{
    char *value = svg_property(r, style, which, NULL);

    if (!is_inherited(value))
        *out = strcmp(value, "none") == 0 || strcmp(value, "initial") == 0
                   ? NULL
                   : (const char *)xmlDictLookup(r->words, (const xmlChar *)value, -1);
    xmlFree(value);
}

/* One of three words; the first one if it is not set. */
static void read_choice(svg_reader *r, const svg_style *style, enum svg_property which,
                        const char *const words[3], int *choice)
{
    char *value = svg_property(r, style, which, NULL);

    for (int i = 0; !is_inherited(value) && i < 3; i++)
        if (i == 0 || strcmp(value, words[i]) == 0)
            *choice = i;
    xmlFree(value);
}

/* How wide a stroke is, in user units, and its ends and corners. */
static void read_stroke(svg_reader *r, const svg_style *style, svg_space *space)
{
    static const char *const caps[] = { "butt", "round", "square" }, *const joins[] = { "miter",
                                                                                        "round",
                                                                                        "bevel" };
    const double across = fmax(space->width, 0), along = fmax(space->height, 0);
    char *width = svg_property(r, style, SVG_STROKE_WIDTH, NULL),
         *mitre = svg_property(r, style, SVG_MITRE, NULL);
    const char *at = mitre;
    double x;

    if (width != NULL && strcmp(width, "initial") == 0)
        space->stroke_width = 1;
    else if (!is_inherited(width) &&
             svg_css_length(space, width, sqrt((across * across + along * along) / 2), &x) &&
             x >= 0)
        space->stroke_width = x;
    if (!is_inherited(mitre) && scan_number(&at, &x) && x >= 1)
        space->mitre = x;
    read_choice(r, style, SVG_LINECAP, caps, &space->cap);
    read_choice(r, style, SVG_LINEJOIN, joins, &space->join);
    xmlFree(width);
    xmlFree(mitre);
}

static void read_visibility(svg_reader *r, const svg_style *style, bool *visible)
{
    char *value = svg_property(r, style, SVG_VISIBILITY, NULL);

    if (value != NULL && (strcmp(value, "hidden") == 0 || strcmp(value, "collapse") == 0))
        *visible = false;
    else if (value != NULL && (strcmp(value, "visible") == 0 || strcmp(value, "initial") == 0))
        *visible = true;
    xmlFree(value);
}

/* Read whether the current element is visible. Returns false if it is not displayed. */
static bool is_displayed(svg_reader *r, const svg_style *style, svg_space *space)
{
    char *display = svg_property(r, style, SVG_DISPLAY, NULL),
         *overflow = svg_property(r, style, SVG_OVERFLOW, NULL);
    bool opaque = true;

    read_positive(r, style, SVG_OPACITY, &opaque);
    const bool good = opaque && (display == NULL || strcmp(display, "none") != 0);
    space->clipped = overflow == NULL ||
                     (strcmp(overflow, "visible") != 0 && strcmp(overflow, "auto") != 0);
    xmlFree(display);
    xmlFree(overflow);

    read_visibility(r, style, &space->visible);
    read_paint(r, style, SVG_FILL, &space->fill, &space->fill_ink);
    read_paint(r, style, SVG_STROKE, &space->stroke, &space->stroke_ink);
    read_rule(r, style, SVG_FILL_RULE, &space->evenodd);
    read_rule(r, style, SVG_CLIP_RULE, &space->clip_evenodd);
    space->clip = space->mask = NULL;   /* not inherited */
    read_words(r, style, SVG_CLIP_PATH, &space->clip);
    read_words(r, style, SVG_MASK, &space->mask);
    read_words(r, style, SVG_DASHES, &space->dashes);
    read_words(r, style, SVG_DASH_OFFSET, &space->dash_offset);
    read_stroke(r, style, space);
    read_positive(r, style, SVG_FILL_OPACITY, &space->fill_opaque);
    read_positive(r, style, SVG_STROKE_OPACITY, &space->stroke_opaque);
    read_positive(r, style, SVG_STROKE_WIDTH, &space->stroke_wide);
    return good;
}

/* The point about which the current element is transformed. */
static bool read_origin(svg_reader *r, const svg_style *style, const svg_space *space,
                        double out[2])
{
    bool css;
    char *box = svg_property(r, style, SVG_BOX, &css);
    char *text = svg_property(r, style, SVG_ORIGIN, &css);

    if (box != NULL && strcmp(box, "view-box") != 0 && strcmp(box, "unset") != 0)
        svg_warn(r, SVG_WARN_BOX,
                 "transform-box: %.20s is read as view-box: apply the transform in the editor",
                 box);
    const bool good = text == NULL || (css && strcmp(text, "unset") == 0) ||
                      svg_origin(r, space, text, out);
    xmlFree(box);
    xmlFree(text);
    return good;
}

/* Apply the transform of the current element: that of its style, or else its attribute. */
static bool enter_transform(svg_reader *r, const svg_style *style, svg_space *space)
{
    bool css;
    char *text = svg_property(r, style, SVG_TRANSFORM, &css);
    double at[2] = { 0, 0 };
    bool good = true;

    if (text != NULL && !(css && strcmp(text, "unset") == 0)) {
        good = read_origin(r, style, space, at);
        space->to_mm = svg_multiply(space->to_mm, (svg_matrix){ 1, 0, 0, 1, at[0], at[1] });
        good = good && svg_transform(r, text, css, &space->to_mm);
        space->to_mm = svg_multiply(space->to_mm, (svg_matrix){ 1, 0, 0, 1, -at[0], -at[1] });
    }
    xmlFree(text);
    return good;
}

/* Report what the drawing will lack. */
static void warn_of(svg_reader *r, const svg_style *style)
{
    static const struct {
        enum svg_property property;
        enum svg_warning kind;
        const char *text;
    } left_out[] = { { SVG_MARKER, SVG_WARN_MARKER,
                       "markers are not drawn: make paths of them in the editor" },
        { SVG_MARKER_START, SVG_WARN_MARKER,
          "markers are not drawn: make paths of them in the editor" },
        { SVG_MARKER_MID, SVG_WARN_MARKER,
          "markers are not drawn: make paths of them in the editor" },
        { SVG_MARKER_END, SVG_WARN_MARKER,
                       "markers are not drawn: make paths of them in the editor" } };

    for (size_t i = 0; i < sizeof left_out / sizeof left_out[0]; i++) {
        char *value = svg_property(r, style, left_out[i].property, NULL);
        if (!is_inherited(value) && strcmp(value, "none") != 0 && strcmp(value, "0") != 0 &&
            strcmp(value, "initial") != 0)
            svg_warn(r, left_out[i].kind, "%s", left_out[i].text);
        xmlFree(value);
    }
}

bool svg_enter(svg_reader *r, svg_space *space, svg_scope *scope, bool *shown)
{
    svg_style style;

    svg_style_open(r, &style, scope, space->scope);
    space->scope = style.scope;
    *shown = is_displayed(r, &style, space);
    svg_font_enter(r, &style, space);
    const bool good = !*shown || enter_transform(r, &style, space);
    if (good && *shown)
        warn_of(r, &style);
    svg_style_close(&style);
    if (good && r->effort > SVG_EFFORT_MAX)
        return svg_fail(r, "the style sheet takes too long: give shapes their styles by style=\"\" "
                           "or fewer classes");
    return good;
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

/* Enter the viewport of the current element: a box of width x height (below 0: unknown) in `space`
 * shows its viewBox. *empty: its size is 0, and nothing of it is drawn. */
static bool enter_viewport(const svg_reader *r, svg_space *space, double width, double height,
                           bool *empty)
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

/* The sizes that an element gives itself, or `width` and `height`. */
static bool read_sizes(const svg_reader *r, const svg_space *space, double *width, double *height)
{
    const double across = *width, along = *height;

    if (!svg_length(r, space, "width", SVG_ACROSS, across, width) ||
        !svg_length(r, space, "height", SVG_ALONG_Y, along, height))
        return false;
    if ((*width < 0 && *width != across) || (*height < 0 && *height != along))
        return svg_fail(r, "width and height cannot be negative");
    return true;
}

static bool move_origin(const svg_reader *r, svg_space *space)
{
    double x, y;

    if (!svg_length(r, space, "x", SVG_ACROSS, 0, &x) ||
        !svg_length(r, space, "y", SVG_ALONG_Y, 0, &y))
        return false;
    space->to_mm = svg_multiply(space->to_mm, (svg_matrix){ 1, 0, 0, 1, x, y });
    return true;
}

static bool draw_children(svg_reader *r, const xmlNode *node, svg_space space,
                          const use_chain *chain)
{
    for (const xmlNode *child = node->children; child != NULL; child = child->next)
        if (!draw_node(r, child, space, chain))
            return false;
    return true;
}

/* The curve in the space that `m` maps to mm. */
static drawing_curve curve_within(const drawing_curve *c, const svg_matrix *m)
{
    const double area = m->a * m->d - m->b * m->c;
    drawing_curve in = *c;

    for (int k = 0; k < 4; k++) {
        const double x = c->p[k][0] - m->e, y = c->p[k][1] - m->f;
        in.p[k][0] = (m->d * x - m->c * y) / area;
        in.p[k][1] = (m->a * y - m->b * x) / area;
    }
    return in;
}

/* Does a curve from the first'th on leave width x height? */
static bool leaves_frame(const svg_reader *r, const svg_matrix *frame, double width, double height,
                         size_t first)
{
    const double margin = UNCLIPPED / svg_stretch(*frame);

    for (size_t i = first; i < r->d->count; i++) {
        drawing_curve in = curve_within(&r->d->curve[i], frame);
        const drawing one = { .curve = &in, .count = 1 };
        double box[2][2];
        if (drawing_box(&one, box) && (box[0][0] < -margin || box[0][1] < -margin ||
                                       box[1][0] > width + margin || box[1][1] > height + margin))
            return true;
    }
    return false;
}

/* Cut the curves from the first'th on at the edges of a viewport. */
static bool cut_frame(svg_reader *r, const xmlNode *node, const svg_matrix *frame, double width,
                      double height, size_t first)
{
    drawing edges   = { .count = 0 };
    drawing *const d = r->d;

    r->node = node;
    if (!leaves_frame(r, frame, width, height, first))
        return true;
    r->d        = &edges;
    svg_pen pen = svg_pen_at(r, *frame);
    bool good   = svg_line(&pen, width, 0) && svg_line(&pen, width, height) &&
                svg_line(&pen, 0, height) && svg_close(&pen);
    r->d = d;
    good = good && svg_cut(r, &edges, first);
    drawing_free(&edges);
    return good;
}

/* An <svg> inside the drawing, or the target of a <use>, which gives the sizes. */
static bool draw_viewport(svg_reader *r, const xmlNode *node, svg_space space, double width,
                          double height, const use_chain *chain)
{
    const svg_matrix frame = space.to_mm;
    const bool clipped = space.clipped && width > 0 && height > 0;
    const size_t first = r->d->count;
    bool empty;

    r->node = node;
    if (!enter_viewport(r, &space, width, height, &empty))
        return false;
    if (!empty && !draw_children(r, node, space, chain))
        return false;
    return !clipped || cut_frame(r, node, &frame, width, height, first);
}

static bool draw_svg(svg_reader *r, const xmlNode *node, svg_space space, const use_chain *chain)
{
    double width = space.width, height = space.height;

    return move_origin(r, &space) && read_sizes(r, &space, &width, &height) &&
           draw_viewport(r, node, space, width, height, chain);
}

static bool draw_switch(svg_reader *r, const xmlNode *node, svg_space space, const use_chain *chain)
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

static bool is_in_chain(const use_chain *chain, const xmlNode *target)
{
    while (chain != NULL && chain->target != target)
        chain = chain->up;
    return chain != NULL;
}

static bool fail_circular_use(const svg_reader *r)
{
    char *href = svg_reference(r->node);

    svg_fail(r, "\"%.60s\" uses itself: break the cycle", href);
    xmlFree(href);
    return false;
}

/* A <symbol> or <svg> that the <use> `node` draws. The sizes of the <use> override its own. */
static bool draw_use_viewport(svg_reader *r, const xmlNode *node, svg_space space,
                              const use_chain *chain)
{
    double width = space.width, height = space.height;
    svg_scope scope;
    bool shown;

    r->node = chain->target;
    bool good = svg_enter(r, &space, &scope, &shown);
    if (good && shown) {
        good = move_origin(r, &space) && read_sizes(r, &space, &width, &height);
        r->node = node;
        good = good && read_sizes(r, &space, &width, &height) &&
               draw_viewport(r, chain->target, space, width, height, chain);
    }
    svg_scope_close(&scope);
    return good;
}

static bool draw_use(svg_reader *r, const xmlNode *node, svg_space space, const use_chain *chain)
{
    const xmlNode *target = use_target(r);
    const use_chain link = { target, chain };

    if (target == NULL)
        return true;
    if (is_in_chain(chain, target))
        return fail_circular_use(r);
    if (!move_origin(r, &space))
        return false;
    if (svg_is(target, "symbol") || svg_is(target, "svg"))
        return draw_use_viewport(r, node, space, &link);
    return draw_node(r, target, space, &link);
}


// Elements
// --------

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
    r->cap   = (unsigned char)space->cap;
    r->join  = (unsigned char)space->join;
    r->tool = r->layer_tool ? r->layer_tool : svg_ink_tool(r, space, stroked);
    return space->visible && (filled || stroked);
}

static bool draw_element(svg_reader *r, const xmlNode *node, svg_space space,
                         const use_chain *chain)
{
    static const char *const groups[] = { "g", "a", NULL };
    bool shape;

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
    if (!space.visible)
        return true;
    const bool seen = svg_begin(r, &space);
    if (seen && !svg_ink_chosen(r, &space, r->fill & DRAWING_STROKED))
        return true;
    const size_t first = r->d->count;
    if (seen)
        return svg_shape(r, &space, &shape) && svg_dash(r, &space, first);
    if (r->clipping)
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

/* The element that url(#id) names, or NULL. */
static const xmlNode *target_of(svg_reader *r, const char *value, const char *name)
{
    const char *open = strchr(value, '#');
    char id[200];

    if (strncmp(value, "url(", 4) != 0 || open == NULL) {
        svg_warn(r, SVG_WARN_CLIP_PATH, "%s: %.30s is not applied: cut the paths in the editor",
                 strcmp(name, "mask") == 0 ? "mask" : "clip-path", value);
        return NULL;
    }
    snprintf(id, sizeof id, "%.*s", (int)strcspn(open + 1, ")\"'"), open + 1);
    const xmlNode *node = svg_find(r, id);
    return node != NULL && svg_is(node, name) ? node : NULL;
}

/* Close each part of an outline by a line. */
static void close_outline(drawing *d)
{
    drawing out = { .count = 0 };

    for (size_t i = 0, begin = 0; i < d->count; i++) {
        drawing_curve c = d->curve[i];
        const bool last = i + 1 == d->count || d->curve[i + 1].path != c.path;
        drawing_add_like(&out, &c, i == begin);
        if (!last)
            continue;
        const double *from = d->curve[i].p[3], *to = d->curve[begin].p[0];
        for (int k = 0; k < 4; k++)
            for (int j = 0; j < 2; j++)
                c.p[k][j] = k == 3 ? to[j] : from[j] + (to[j] - from[j]) * k / 3;
        if (memcmp(from, to, sizeof c.p[0]) != 0)
            drawing_add_like(&out, &c, false);
        begin = i + 1;
    }
    drawing_free(d);
    *d = out;
}

/* With clipPathUnits="objectBoundingBox", 0..1 is the box of what is clipped. */
static void enter_box(const svg_reader *r, svg_space *space, size_t first)
{
    double all[2][2] = { { 0, 0 }, { 0, 0 } };

    for (size_t i = first; i < r->d->count; i++) {
        drawing_curve in  = curve_within(&r->d->curve[i], &space->to_mm);
        const drawing one = { .curve = &in, .count = 1 };
        double box[2][2];
        (void)drawing_box(&one, box);
        for (int k = 0; k < 2; k++) {
            all[0][k] = i == first || box[0][k] < all[0][k] ? box[0][k] : all[0][k];
            all[1][k] = i == first || box[1][k] > all[1][k] ? box[1][k] : all[1][k];
        }
    }
    space->to_mm = svg_multiply(
        space->to_mm,
        (svg_matrix){ all[1][0] - all[0][0], 0, 0, all[1][1] - all[0][1], all[0][0], all[0][1] });
}

/* What a clip path or a mask lets through, as closed outlines. */
static bool draw_outline(svg_reader *r, const xmlNode *node, svg_space space, const char *units,
                         size_t first, drawing *outline)
{
    const xmlNode *was  = r->node;
    drawing *const d    = r->d;
    const unsigned fill = r->fill;
    svg_scope scope;
    bool shown;

    r->node    = node;
    char *text = svg_attribute(node, units);
    if (text != NULL && strcmp(text, "objectBoundingBox") == 0)
        enter_box(r, &space, first);
    xmlFree(text);
    space.visible = true;
    space.clip_evenodd = false;
    bool good   = svg_enter(r, &space, &scope, &shown);
    r->clipping = true;
    r->d        = outline;
    good = good && (!shown || draw_children(r, node, space, NULL));
    r->d        = d;
    r->clipping = false;
    r->fill     = fill;
    r->node     = was;
    svg_scope_close(&scope);
    close_outline(outline);
    return good;
}

/* Cut the curves from the first'th on, which the current element has drawn, at its clip path. */
static bool clip_element(svg_reader *r, const svg_space *of, size_t first)
{
    const xmlNode *node = r->clipping ? NULL : target_of(r, of->clip, "clipPath");
    drawing outline     = { .count = 0 };

    if (node == NULL || r->d->count == first)
        return true;
    const bool good = draw_outline(r, node, *of, "clipPathUnits", first, &outline) &&
                      svg_cut(r, &outline, first);
    drawing_free(&outline);
    return good;
}

/* A mask of white shapes is a clip path; what another one lets through is not known. */
static bool mask_element(svg_reader *r, const svg_space *of, size_t first)
{
    const xmlNode *node = r->clipping ? NULL : target_of(r, of->mask, "mask");
    drawing outline     = { .count = 0 };
    svg_space space     = *of;

    if (node == NULL || r->d->count == first)
        return true;
    space.fill = space.fill_opaque = true;      /* of the mask, which stands elsewhere */
    space.stroke = space.evenodd = false;
    space.fill_ink = space.stroke_ink = NULL;
    r->masking = r->plain = true;
    bool good  = draw_outline(r, node, space, "maskContentUnits", first, &outline);
    r->masking = false;
    if (good && r->plain)
        good = svg_cut(r, &outline, first);
    else if (good)
        svg_warn(r, SVG_WARN_MASK,
                 "mask is not applied, as it is not of white shapes: the whole outline is drawn: "
                 "cut the paths in the editor");
    drawing_free(&outline);
    return good;
}

static bool draw_in_space(svg_reader *r, const xmlNode *node, svg_space space,
                          const use_chain *chain)
{
    svg_scope scope;
    bool shown, good = svg_enter(r, &space, &scope, &shown);
    const double area = space.to_mm.a * space.to_mm.d - space.to_mm.b * space.to_mm.c;
    const size_t first = r->d->count;

    if (good && shown && area != 0)     /* flattened to a line or a point: SVG draws nothing */
        good = draw_element(r, node, space, chain);
    r->node = node;
    if (good && shown && area != 0 && space.clip != NULL)
        good = clip_element(r, &space, first);
    if (good && shown && area != 0 && space.mask != NULL)
        good = mask_element(r, &space, first);
    svg_scope_close(&scope);
    return good;
}

static bool draw_node(svg_reader *r, const xmlNode *node, svg_space space, const use_chain *chain)
{
    if (!svg_is(node, NULL) || is_never_drawn(node) || !element_applies(node))
        return true;
    r->node = node;
    if (++r->visited > SVG_ELEMENTS_MAX)
        return svg_fail(r, "more than %u elements, counting each use: split the drawing",
                        SVG_ELEMENTS_MAX);
    if (r->depth >= SVG_DEPTH_MAX)
        return svg_fail(r,
                        "more than %d nested elements, counting each use: draw with fewer groups",
                        SVG_DEPTH_MAX);
    const bool chosen = svg_layer_chosen(r, node);
    if (!svg_layer_drawn(r, node))
        return true;
    const unsigned tool = r->layer_tool;
    r->layer_tool = svg_layer_tool(r, node);
    r->depth++;
    r->chosen += chosen;
    const bool good = draw_in_space(r, node, space, chain);
    r->layer_tool = tool;
    r->chosen -= chosen;
    r->depth--;
    return good;
}


// The page
// --------

/* Map the page to mm, y up. Sizes that are not given come from the viewBox, in px, or are
 * unknown. */
static bool enter_page(svg_reader *r, const xmlNode *root, svg_space *space, svg_scope *scope,
                       bool *empty)
{
    double box[4], width = -1, height = -1;
    bool given;

    *space = (svg_space){ .to_mm = svg_identity,
                          .width = -1,
                          .height = -1,
                          .visible = true,
                          .fill = true,
                          .fill_opaque = true,
                          .stroke_opaque = true,
                          .stroke_wide = true,
                          .stroke_width = 1,
                          .mitre = 4,
                          .font = svg_font_usual() };
    r->node = root;
    if (!svg_view_box(r, box, &given))
        return false;
    if (given) {
        space->width  = box[2];
        space->height = box[3];
    }
    if (!read_sizes(r, space, &width, &height))
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
    bool shown;
    const bool good = svg_enter(r, space, scope, &shown);
    *empty = !shown;
    return good && (*empty || enter_viewport(r, space, width, height, empty));
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
    return svg_fail(r, "--text %.40s: give outline, line, line:FONT or none", text);
}

bool svg_draw(svg_reader *r, const xmlNode *root)
{
    svg_scope scope = { .up = NULL };
    svg_space space;
    bool empty;
    r->node = root;
    const bool good = svg_layers_check(r, root) && check_text(r) &&
                      enter_page(r, root, &space, &scope, &empty) &&
                      (empty || draw_children(r, root, space, NULL));
    r->node = root;

    svg_scope_close(&scope);
    if (!good || !svg_ink_check(r))
        return false;
    shift_to_origin(r->d);
    return true;
}

