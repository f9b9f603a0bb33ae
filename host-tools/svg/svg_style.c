/* host-tools/svg/svg_style.c -- the properties of an element: from attributes, style="" and the
 * style sheets of the file
 * SPDX-License-Identifier: MIT
 *
 * A plotter needs these parts of CSS: hidden elements, elements without paint, transforms, and what
 * the drawing will lack. The declaration with the highest rank sets a property: !important, then
 * style="" before sheets, then selectors, then order.
 */
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "svg/svg.h"

#define VARIABLE_DEPTH  8           /* nested var() */
#define VARIABLE_LENGTH 10000       /* bytes of a value with all var() substituted */

static const char blank[] = " \t\r\n\f";

static const char *const property_names[SVG_PROPERTIES] = {
    [SVG_DISPLAY] = "display",
                                                            [SVG_VISIBILITY] = "visibility",
                                                            [SVG_OPACITY] = "opacity",
                                                            [SVG_FILL] = "fill",
                                                            [SVG_FILL_OPACITY] = "fill-opacity",
                                                            [SVG_FILL_RULE] = "fill-rule",
                                                            [SVG_CLIP_RULE] = "clip-rule",
                                                            [SVG_STROKE] = "stroke",
                                                            [SVG_STROKE_OPACITY] = "stroke-opacity",
                                                            [SVG_STROKE_WIDTH] = "stroke-width",
                                                            [SVG_TRANSFORM] = "transform",
                                                            [SVG_ORIGIN] = "transform-origin",
                                                            [SVG_BOX] = "transform-box",
                                                            [SVG_OVERFLOW] = "overflow",
                                                            [SVG_CLIP_PATH] = "clip-path",
                                                            [SVG_MASK] = "mask",
                                                            [SVG_DASHES] = "stroke-dasharray",
    [SVG_DASH_OFFSET] = "stroke-dashoffset",
                                                            [SVG_LINECAP] = "stroke-linecap",
                                                            [SVG_LINEJOIN] = "stroke-linejoin",
                                                            [SVG_MITRE] = "stroke-miterlimit",
                                                            [SVG_MARKER] = "marker",
                                                            [SVG_MARKER_START] = "marker-start",
                                                            [SVG_MARKER_MID] = "marker-mid",
                                                            [SVG_MARKER_END] = "marker-end",
                                                            [SVG_FILTER] = "filter",
    [SVG_BLEND] = "mix-blend-mode",
    [SVG_BACKGROUND] = "background",
    [SVG_BACKGROUND_COLOUR] = "background-color",
    [SVG_GEOMETRY] = "x",
    [SVG_MOTION] = "rotate",
    [SVG_FONT] = "font",
                                                            [SVG_FONT_FAMILY] = "font-family",
                                                            [SVG_FONT_SIZE] = "font-size",
                                                            [SVG_FONT_STYLE] = "font-style",
                                                            [SVG_FONT_WEIGHT] = "font-weight",
                                                            [SVG_FONT_STRETCH] = "font-stretch",
                                                            [SVG_FONT_VARIANT] = "font-variant",
    [SVG_FONT_KERNING] = "font-kerning",
                                                            [SVG_LETTER_SPACING] = "letter-spacing",
                                                            [SVG_WORD_SPACING] = "word-spacing",
                                                            [SVG_TEXT_ANCHOR] = "text-anchor",
    [SVG_TEXT_DECORATION] = "text-decoration",
                                                            [SVG_BASELINE] = "dominant-baseline",
    [SVG_BASELINE_OWN] = "alignment-baseline",
                                                            [SVG_BASELINE_SHIFT] = "baseline-shift",
                                                            [SVG_DIRECTION] = "direction",
                                                            [SVG_WHITE_SPACE] = "white-space",
    [SVG_WRITING_MODE] = "writing-mode",
    [SVG_FONT_CAPS] = "font-variant-caps",
    [SVG_DECORATION_LINE] = "text-decoration-line",
    [SVG_DECORATION_STYLE] = "text-decoration-style",
    [SVG_TEXT_TRANSFORM] = "text-transform",
    [SVG_FONT_VARIATION] = "font-variation-settings",
    [SVG_FONT_FEATURES] = "font-feature-settings",
    [SVG_FONT_ADJUST] = "font-size-adjust",
    [SVG_FONT_LIGATURES] = "font-variant-ligatures",
    [SVG_FONT_NUMERIC] = "font-variant-numeric",
    [SVG_FONT_POSITION] = "font-variant-position"
};

const char *svg_property_name(enum svg_property which) { return property_names[which]; }

char *svg_attribute(const xmlNode *node, const char *name)
{
    return (char *)xmlGetNoNsProp(node, (const xmlChar *)name);
}


// Declarations
// ------------

/* The text before and after the colon of a declaration. */
typedef struct {
    const char *name, *value;
    size_t name_length, length;
    bool important;
} declaration;

size_t svg_css_span(const char *text, const char *stops)
{
    char quote = '\0';
    int depth  = 0;
    size_t n   = 0;

    for (; text[n] != '\0'; n++) {
        const char c = text[n];
        if (c == '\\' && text[n + 1] != '\0') {
            n++;
        } else if (quote != '\0') {
            quote = c == quote || c == '\n' ? '\0' : quote;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (depth == 0 && strchr(stops, c) != NULL) {
            break;
        } else if (c == '(' || c == '[') {
            depth++;
        } else if (depth > 0 && (c == ')' || c == ']')) {
            depth--;
        }
    }
    return n;
}

void svg_blank_comments(char *text)
{
    for (char *start = strstr(text, "/*"); start != NULL; start = strstr(start, "/*")) {
        const char *end = strstr(start + 2, "*/");
        const size_t size = end ? (size_t)(end + 2 - start) : strlen(start);
        memset(start, ' ', size);
    }
}

/* The next declaration of `a: b; c: d`. Returns false at the end. */
static bool next_declaration(const char **at, declaration *out)
{
    for (;;) {
        *at += strspn(*at, " \t\r\n\f;");
        const char *text = *at;
        const size_t all = svg_css_span(text, ";"), colon = strcspn(text, ":;");

        if (*text == '\0')
            return false;
        *at += all;
        if (text[colon] != ':')
            continue;
        *out = (declaration){ .name = text, .name_length = strcspn(text, " \t\r\n\f:") };
        out->value = text + colon + 1;
        out->value += strspn(out->value, blank);
        out->length = out->value < text + all ? (size_t)(text + all - out->value) : 0;
        const char *bang = memchr(out->value, '!', out->length);
        out->important = bang != NULL;
        out->length = bang ? (size_t)(bang - out->value) : out->length;
        while (out->length > 0 && strchr(blank, out->value[out->length - 1]))
            out->length--;
        return true;
    }
}

void svg_value_put(svg_value *to, svg_value from)
{
    if (to->text == NULL || from.rank >= to->rank)
        *to = from;
}

static void free_name(void *value, const xmlChar *name)
{
    (void)name;
    xmlFree(value);
}

void svg_names_free(xmlHashTablePtr names)
{
    if (names != NULL)
        xmlHashFree(names, free_name);
}

/* Names beside that of the table. */
static const struct {
    enum svg_property which;
    const char *name;
} more_names[] = { { SVG_GEOMETRY, "y" },       { SVG_GEOMETRY, "width" },
                   { SVG_GEOMETRY, "height" },  { SVG_GEOMETRY, "cx" },
                   { SVG_GEOMETRY, "cy" },      { SVG_GEOMETRY, "r" },
                   { SVG_GEOMETRY, "rx" },      { SVG_GEOMETRY, "ry" },
                   { SVG_GEOMETRY, "d" },       { SVG_MOTION, "scale" },
                   { SVG_MOTION, "translate" }, { SVG_MOTION, "offset-path" } };

/* SVG_PROPERTIES if the name is unknown. */
static enum svg_property property_of(const char *name, size_t length)
{
    int i = 0;

    for (size_t k = 0; k < sizeof more_names / sizeof *more_names; k++)
        if (strlen(more_names[k].name) == length &&
            strncasecmp(name, more_names[k].name, length) == 0)
            return more_names[k].which;

    while (i < SVG_PROPERTIES && !(strncasecmp(name, property_names[i], length) == 0 &&
                                   property_names[i][length] == '\0'))
        i++;
    return (enum svg_property)i;
}

void svg_block_read(svg_block *block, const char *text, unsigned long long rank)
{
    declaration d;

    *block = (svg_block){ .names = NULL };
    while (next_declaration(&text, &d)) {
        const svg_value value = { d.value, d.length,
                                  rank + (d.important ? SVG_RANK_IMPORTANT : 0) };
        const enum svg_property property = property_of(d.name, d.name_length);
        if (property < SVG_PROPERTIES)
            svg_value_put(&block->value[property], value);
        if (strncmp(d.name, "--", 2) != 0)
            continue;
        xmlChar *name = xmlStrndup((const xmlChar *)d.name, (int)d.name_length);
        if (block->names == NULL)
            block->names = xmlHashCreate(0);
        xmlHashUpdateEntry(block->names, name, xmlStrndup((const xmlChar *)d.value, (int)d.length),
                           free_name);
        xmlFree(name);
    }
}


// Custom properties: --name and var(--name)
// -----------------------------------------

static const char *variable_value(svg_reader *r, const svg_scope *scope, const char *name,
                                  size_t length)
{
    xmlChar *key = xmlStrndup((const xmlChar *)name, (int)length);
    const char *found = NULL;

    for (; scope != NULL && found == NULL; scope = scope->up) {
        unsigned long long rank = 0;
        for (size_t i = 0; i < scope->count; i++) {
            const char *value = xmlHashLookup(scope->list[i].names, key);
            if (value != NULL && (found == NULL || scope->list[i].rank >= rank)) {
                found = value;
                rank = scope->list[i].rank;
            }
        }
        r->effort += scope->count + 1;
    }
    xmlFree(key);
    return found;
}

/* The length up to the closing parenthesis, or to the end. */
static size_t length_to_parenthesis(const char *text, size_t size)
{
    int depth = 1;
    size_t n = 0;

    for (; n < size; n++) {
        depth += (text[n] == '(') - (text[n] == ')');
        if (depth == 0)
            break;
    }
    return n;
}

/* Append `text` with every var(--name, fallback) substituted. Returns false if one is not set, or
 * if there are too many. */
static bool put_variables(svg_reader *r, const svg_scope *scope, const char *text, size_t size,
                          int depth, xmlBufferPtr out)
{
    while (size > 0) {
        const char *call = memmem(text, size, "var(", 4);
        const size_t before = call ? (size_t)(call - text) : size;
        xmlBufferAdd(out, (const xmlChar *)text, (int)before);
        if (xmlBufferLength(out) > VARIABLE_LENGTH || depth > VARIABLE_DEPTH ||
            r->effort > SVG_EFFORT_MAX)
            return false;
        if (call == NULL)
            return true;

        const char *inner = call + 4;
        const size_t length = length_to_parenthesis(inner, size - before - 4);
        const char *comma = memchr(inner, ',', length), *name = inner + strspn(inner, blank);
        const char *value = variable_value(r, scope, name, strcspn(name, " \t\r\n\f,)"));
        const char *taken = value ? value : comma ? comma + 1 : NULL;
        if (taken == NULL ||
            !put_variables(r, scope, taken,
                           value ? strlen(value) : (size_t)(inner + length - taken), depth + 1,
                           out))
            return false;
        const size_t done = before + 4 + length;
        text += done < size ? done + 1 : size;
        size -= done < size ? done + 1 : size;
    }
    return true;
}

static char *with_variables(svg_reader *r, const svg_scope *scope, const char *text)
{
    xmlBufferPtr out = xmlBufferCreate();
    const bool good = put_variables(r, scope, text, strlen(text), 0, out);
    const char *value = (const char *)xmlBufferContent(out);
    char *copy = (char *)xmlStrdup(
        (const xmlChar *)(good ? value + strspn(value, blank) : "unset"));

    xmlBufferFree(out);
    for (size_t n = strlen(copy); n > 0 && strchr(blank, copy[n - 1]); n--)
        copy[n - 1] = '\0';
    return copy;
}


// The element
// -----------

void svg_style_open(svg_reader *r, svg_style *style, svg_scope *scope, const svg_scope *up)
{
    *style = (svg_style){ .text = svg_attribute(r->node, "style") };
    *scope = (svg_scope){ .up = up };
    for (const xmlAttr *a = r->node->properties; a != NULL; a = a->next)
        style->attributes |= 1ull << property_of((const char *)a->name,
                                                 strlen((const char *)a->name));
    svg_sheet_apply(r, style, scope);
    if (style->text != NULL) {
        svg_block block;
        svg_blank_comments(style->text);
        svg_block_read(&block, style->text, SVG_RANK_OWN);
        for (int i = 0; i < SVG_PROPERTIES; i++)
            if (block.value[i].text != NULL)
                svg_value_put(&style->value[i], block.value[i]);
        if (block.names != NULL)
            svg_scope_add(scope, block.names, SVG_RANK_OWN);
        scope->own = block.names;
    }
    style->scope = scope->count > 0 ? scope : up;
}

void svg_style_close(svg_style *style) { xmlFree(style->text); }

void svg_scope_close(svg_scope *scope)
{
    svg_names_free(scope->own);
    free(scope->list);
}

char *svg_property(svg_reader *r, const svg_style *style, enum svg_property which, bool *css)
{
    const svg_value *value = &style->value[which];
    char *text = NULL;

    if (value->text != NULL)
        text = (char *)xmlStrndup((const xmlChar *)value->text, (int)value->length);
    else if (style->attributes & 1ull << which && which != SVG_MARKER)  /* it is no attribute */
        text = svg_attribute(r->node, property_names[which]);
    if (css != NULL)
        *css = value->text != NULL;
    if (text == NULL || strstr(text, "var(") == NULL)
        return text;
    char *whole = with_variables(r, style->scope, text);
    xmlFree(text);
    return whole;
}
