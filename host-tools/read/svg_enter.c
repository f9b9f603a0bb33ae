/* host-tools/read/svg_enter.c -- what an element's style says: is it shown, and how is it painted
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/scan.h"       /* scan_number */
#include "read/svg.h"

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

/* url(#id) of a pattern, of something else that paints (gradients), or of nothing: then what
 * follows it paints, or nothing. */
static bool is_painting(const svg_reader *r, const char *value, const xmlNode **pattern)
{
    const char *open = strchr(value, '#'), *after = strchr(value, ')');
    char id[200];

    snprintf(id, sizeof id, "%.*s", open ? (int)strcspn(open + 1, ")\"'") : 0,
             open ? open + 1 : "");
    const xmlNode *node = svg_find(r, id);
    *pattern = node != NULL && svg_is(node, "pattern") ? node : NULL;
    if (node != NULL || after == NULL)
        return true;
    after++;
    scan_space(&after);
    return *after != '\0' && !is_clear(after);
}

/* Does the property paint, and with which colour? If it is not set, both stay. */
static void read_paint(svg_reader *r, const svg_style *style, enum svg_property which, bool *paints,
                       const char **ink, const xmlNode **pattern)
{
    char *value = svg_property(r, style, which, NULL);

    if (!is_inherited(value)) {
        *pattern = NULL;
        *paints  = strcmp(value, "initial") == 0       ? which == SVG_FILL
                  : strncmp(value, "url(", 4) == 0 ? is_painting(r, value, pattern)
                                                   : !is_clear(value);
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
    const bool good = (opaque || (r->clipping && (!r->masking || r->boxing))) &&
                      (display == NULL || strcmp(display, "none") != 0);
    space->clipped = overflow == NULL ||
                     (strcmp(overflow, "visible") != 0 && strcmp(overflow, "auto") != 0);
    xmlFree(display);
    xmlFree(overflow);

    read_visibility(r, style, &space->visible);
    const xmlNode *none;        /* strokes have no tiles */
    read_paint(r, style, SVG_FILL, &space->fill, &space->fill_ink, &space->pattern);
    read_paint(r, style, SVG_STROKE, &space->stroke, &space->stroke_ink, &none);
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

/* Apply the transform of the current element: that of its style, or else its attribute. */
static void enter_transform(svg_reader *r, const svg_style *style, svg_space *space)
{
    bool css;
    char *text = svg_property(r, style, SVG_TRANSFORM, &css);
    double at[2] = { 0, 0 };

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
    if (*shown || r->clipping)
        enter_transform(r, &style, space);
    svg_style_close(&style);
    if (r->effort > SVG_EFFORT_MAX)
        return svg_fail(r, "the style sheet takes too long: give shapes their styles by style=\"\" "
                           "or fewer classes");
    return true;
}
