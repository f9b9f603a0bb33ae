/* host-tools/svg/svg_enter.c -- what an element's style says: is it shown, and how is it painted
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/scan.h"       /* scan_number */
#include "svg/svg.h"

#define LINKS 8         /* from gradient to gradient */

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

/* Has a gradient, or one that it refers to, a colour? */
static bool has_stops(const svg_reader *r, const xmlNode *node)
{
    for (int links = 0; node != NULL && links < LINKS; links++) {
        for (const xmlNode *child = node->children; child != NULL; child = child->next)
            if (svg_is(child, "stop"))
                return true;
        char *href = svg_reference(node);
        node       = href != NULL && href[0] == '#' ? svg_find(r, href + 1) : NULL;
        xmlFree(href);
        if (node != NULL && !svg_is(node, "linearGradient") && !svg_is(node, "radialGradient"))
            return false;
    }
    return false;
}

/* What url(#id) paints: a pattern, a gradient, or what follows it. */
static svg_paint paint_of_url(svg_reader *r, const char *value)
{
    const char *open = strchr(value, '#'), *after = strchr(value, ')');
    char id[200];

    snprintf(id, sizeof id, "%.*s", open ? (int)strcspn(open + 1, ")\"'") : 0,
             open ? open + 1 : "");
    const xmlNode *node = svg_find(r, id);
    if (node != NULL && svg_is(node, "pattern"))
        return (svg_paint){ .paints = true, .pattern = node };
    if (node != NULL && (svg_is(node, "linearGradient") || svg_is(node, "radialGradient")))
        return (svg_paint){ .paints = has_stops(r, node) };
    after = after != NULL ? after + 1 : "";
    scan_space(&after);
    return (svg_paint){ .paints = *after != '\0' && !is_clear(after) };
}

/* What a property paints; if it is not set, all stays. */
static void read_paint(svg_reader *r, const svg_style *style, enum svg_property which,
                       svg_space *space, bool *paints, const char **ink, const xmlNode **pattern)
{
    char *value   = svg_property(r, style, which, NULL);
    svg_paint own = { .paints = false };

    if (!is_inherited(value)) {
        const bool context = strncmp(value, "context-", 8) == 0;
        if (context)
            own = space->context[strcmp(value, "context-stroke") == 0];
        else if (strcmp(value, "initial") == 0)
            own.paints = which == SVG_FILL;
        else if (strncmp(value, "url(", 4) == 0)
            own = paint_of_url(r, value);
        else
            own.paints = !is_clear(value);
        if (!context)
            own.ink = svg_ink(r, value);
        *paints  = own.paints;
        *ink     = own.ink;
        *pattern = own.pattern;
        if (which == SVG_STROKE && own.pattern != NULL)
            svg_warn(
                r, SVG_WARN_PATTERN,
                "a stroke of a pattern is drawn as a line without it: make its outline a path");
        if (which == SVG_FILL) {
            space->pattern_placed = context;
            space->pattern_to_mm  = own.to_mm;
        }
    }
    xmlFree(value);
}

void svg_set_context(svg_space *space, const svg_space *of)
{
    const svg_matrix placed = of->pattern_placed ? of->pattern_to_mm : of->to_mm;

    space->context[0] = (svg_paint){ of->fill, of->fill_ink, of->pattern, placed };
    space->context[1] = (svg_paint){ of->stroke, of->stroke_ink, NULL, placed };
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

static void read_markers(svg_reader *r, const svg_style *style, svg_space *space)
{
    static const enum svg_property each[] = { SVG_MARKER_START, SVG_MARKER_MID, SVG_MARKER_END };

    for (int k = 0; k < 3; k++) {
        read_words(r, style, SVG_MARKER, &space->marker[k]);
        read_words(r, style, each[k], &space->marker[k]);
    }
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
    else if (!is_inherited(width))
        svg_warn(r, SVG_WARN_LENGTH,
                 "stroke-width: %.40s is not used: give a number that is not negative", width);
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

/* Viewports that are not the outermost one cut, unless they say otherwise. */
static void read_overflow(svg_reader *r, const svg_style *style, bool *clipped)
{
    static const char *const viewports[] = { "svg", "symbol", "marker", "pattern" };
    char *value                          = svg_property(r, style, SVG_OVERFLOW, NULL);
    bool usual                           = false;

    for (int i = 0; i < 4; i++)
        usual = usual || svg_is(r->node, viewports[i]);
    if (r->node->parent == NULL || r->node->parent->type != XML_ELEMENT_NODE)
        usual = false;
    if (value == NULL || strcmp(value, "inherit") != 0)
        *clipped = value == NULL || strcmp(value, "unset") == 0
                       ? usual
                       : strcmp(value, "visible") != 0 && strcmp(value, "auto") != 0 &&
                             strcmp(value, "initial") != 0;
    xmlFree(value);
}

/* What is drawn as if it were not there. */
static void warn_effects(svg_reader *r, const svg_style *style)
{
    char *filter = svg_property(r, style, SVG_FILTER, NULL),
         *blend  = svg_property(r, style, SVG_BLEND, NULL);

    if (!is_inherited(filter) && strcmp(filter, "none") != 0 && strcmp(filter, "initial") != 0)
        svg_warn(r, SVG_WARN_FILTER, "filter: %.40s is not applied: outlines are drawn without it",
                 filter);
    if (!is_inherited(blend) && strcmp(blend, "normal") != 0 && strcmp(blend, "initial") != 0)
        svg_warn(r, SVG_WARN_BLEND,
                 "mix-blend-mode: %.20s is not applied: outlines are drawn without it", blend);
    xmlFree(filter);
    xmlFree(blend);
}

/* What is behind the drawing is paper. */
static void warn_background(svg_reader *r, const svg_style *style)
{
    static const enum svg_property both[] = { SVG_BACKGROUND, SVG_BACKGROUND_COLOUR };

    if (r->node->parent != NULL && r->node->parent->type == XML_ELEMENT_NODE)
        return;
    for (int k = 0; k < 2; k++) {
        char *text = style->value[both[k]].text ? svg_property(r, style, both[k], NULL) : NULL;
        if (!is_inherited(text) && !is_clear(text) && strcmp(text, "initial") != 0 &&
            strcmp(svg_ink(r, text), svg_ink(r, "white")) != 0)
            svg_warn(r, SVG_WARN_BACKGROUND,
                     "the background %.40s is paper and not drawn: draw a box of this colour",
                     text);
        xmlFree(text);
    }
}

/* Read whether the current element is visible. Returns false if it is not displayed. */
static bool is_displayed(svg_reader *r, const svg_style *style, svg_space *space)
{
    char *display = svg_property(r, style, SVG_DISPLAY, NULL);
    bool opaque = true;

    read_positive(r, style, SVG_OPACITY, &opaque);
    const bool good = (opaque || (r->clipping && (!r->masking || r->boxing))) &&
                      (display == NULL || strcmp(display, "none") != 0);
    xmlFree(display);
    read_overflow(r, style, &space->clipped);
    if (good)
        warn_effects(r, style);
    warn_background(r, style);
    read_visibility(r, style, &space->visible);
    const xmlNode *none;        /* strokes have no tiles */
    read_paint(r, style, SVG_FILL, space, &space->fill, &space->fill_ink, &space->pattern);
    read_paint(r, style, SVG_STROKE, space, &space->stroke, &space->stroke_ink, &none);
    read_rule(r, style, SVG_FILL_RULE, &space->evenodd);
    read_rule(r, style, SVG_CLIP_RULE, &space->clip_evenodd);
    space->clip = space->mask = NULL;   /* not inherited */
    read_words(r, style, SVG_CLIP_PATH, &space->clip);
    read_words(r, style, SVG_MASK, &space->mask);
    read_markers(r, style, space);
    read_words(r, style, SVG_DASHES, &space->dashes);
    read_words(r, style, SVG_DASH_OFFSET, &space->dash_offset);
    read_stroke(r, style, space);
    read_positive(r, style, SVG_FILL_OPACITY, &space->fill_opaque);
    read_positive(r, style, SVG_STROKE_OPACITY, &space->stroke_opaque);
    read_positive(r, style, SVG_STROKE_WIDTH, &space->stroke_wide);
    return good;
}

/* The point about which the current element is transformed. */
static void read_origin(svg_reader *r, const svg_style *style, const svg_space *space,
                        double out[2])
{
    bool css;
    char *box = svg_property(r, style, SVG_BOX, &css);
    char *text = svg_property(r, style, SVG_ORIGIN, &css);

    if (box != NULL && strcmp(box, "view-box") != 0 && strcmp(box, "unset") != 0)
        svg_warn(r, SVG_WARN_BOX,
                 "transform-box: %.20s is read as view-box: apply the transform in the editor",
                 box);
    if (text != NULL && !(css && strcmp(text, "unset") == 0))
        svg_origin(r, space, text, out);
    xmlFree(box);
    xmlFree(text);
}

/* What a style sets of places, and is not applied. */
static void tell_places(svg_reader *r, const svg_style *style)
{
    const svg_value *size = &style->value[SVG_GEOMETRY], *moved = &style->value[SVG_MOTION];
    const bool shape = svg_is(r->node, "rect") || svg_is(r->node, "circle") ||
                       svg_is(r->node, "ellipse") || svg_is(r->node, "path");

    if (shape && size->text != NULL && strncasecmp(size->text, "auto", 4) != 0)
        svg_warn(r, SVG_WARN_GEOMETRY,
                 "a style's x, width, r or d of a shape is not used: write it as an attribute");
    if (moved->text != NULL && strncasecmp(moved->text, "none", 4) != 0)
        svg_warn(r, SVG_WARN_MOTION,
                 "a style's rotate, scale, translate or offset-path is not used: write transform");
}

/* Apply the transform of the current element: that of its style, or else its attribute. */
static void enter_transform(svg_reader *r, const svg_style *style, svg_space *space)
{
    bool css;
    char *text = svg_property(r, style, SVG_TRANSFORM, &css);
    double at[2] = { 0, 0 };

    tell_places(r, style);
    if (text != NULL && !(css && strcmp(text, "unset") == 0)) {
        read_origin(r, style, space, at);
        space->to_mm = svg_multiply(space->to_mm, (svg_matrix){ 1, 0, 0, 1, at[0], at[1] });
        svg_transform(r, text, css, &space->to_mm);
        space->to_mm = svg_multiply(space->to_mm, (svg_matrix){ 1, 0, 0, 1, -at[0], -at[1] });
    }
    xmlFree(text);
}

bool svg_enter(svg_reader *r, svg_space *space, svg_scope *scope, bool *shown)
{
    svg_style style;

    svg_style_open(r, &style, scope, space->scope);
    space->scope = style.scope;
    *shown = is_displayed(r, &style, space);
    svg_font_enter(r, &style, space);
    if (r->node->parent == NULL || r->node->parent->type != XML_ELEMENT_NODE)
        space->rem = space->font.size;
    if (*shown || r->clipping)
        enter_transform(r, &style, space);
    svg_style_close(&style);
    if (r->effort > SVG_EFFORT_MAX)
        return svg_fail(r, "svg.style-too-long",
                        "the style sheet takes too long: give shapes their styles by style=\"\" "
                        "or fewer classes");
    return true;
}
