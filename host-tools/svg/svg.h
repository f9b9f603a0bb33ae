/* host-tools/svg/svg.h -- the shared part of the SVG reader
 * SPDX-License-Identifier: MIT
 *
 *     svg_file.c   the XML: read safely, ids, lines for messages
 *     svg.c        the document: elements, viewports, use
 *     svg_viewport.c  viewports: size, place, edges
 *     svg_enter.c  what the style of an element says: is it shown, how is it painted
 *     svg_shape.c  path data and basic shapes          -> pen
 *     svg_pen.c    lines, cubics, arcs in user units   -> curves in mm
 *     svg_space.c  transforms, lengths with units, viewBox
 *     svg_style.c  properties from attributes, style="" and style sheets; var()
 *     svg_sheet.c  the rules of style sheets
 *     svg_selector.c  which elements they are for
 *     svg_layer.c  layers of Inkscape
 *     svg_mask.c   clip paths and masks of elements    -> outlines
 *     svg_clip.c   cuts curves at an outline
 *     svg_dash.c   dashes
 *     svg_marker.c markers
 *     svg_pattern.c shapes filled with patterns          -> tiles, cut at the shape
 *     svg_ink.c    colours, and which of them are drawn
 *     svg_text.c   text: letters, their places, runs     -> shaped glyphs -> pen
 *     svg_rail.c   paths that carry text
 *     svg_font.c   properties of fonts
 *     svg_glyphs.c outlines of any installed font (pango, cairo)
 *     svg_lines.c  letters of single lines (Hershey's fonts)
 *
 * What cannot be read in an attribute is as if it were not given, as browsers do, and one line of
 * each kind says where. Functions that return bool print one line with file and line, and return
 * false, if the file is beyond a limit. Then the reading ends.
 */
#ifndef LOFT_SVG_H
#define LOFT_SVG_H

#include <libxml/hash.h>
#include <libxml/tree.h>
#include <stdbool.h>

#include <libxml/dict.h>        /* needs tree.h */

#include "read/drawing.h"

/* x' = a x + c y + e,  y' = b x + d y + f */
typedef struct {
    double a, b, c, d, e, f;
} svg_matrix;

typedef struct svg_sheet svg_sheet;     /* the rules of <style>, see svg_sheet.c */

/* An element with an id. */
typedef struct {
    char *id;
    const xmlNode *node;
} svg_named;

/* in a file; and drawn elements, counting those of each <use> */
#define SVG_ELEMENTS_MAX 2000000u
/* nested elements; and nested drawn elements, counting those of each <use> */
#define SVG_DEPTH_MAX    500

#define SVG_INKS 10
#define SVG_MARKINGS 8          /* markers and patterns in each other */

#define SVG_EFFORT_MAX   100000000u /* rules tried on elements: a few seconds */

typedef struct svg_vertices svg_vertices;       /* of a shape with markers, see svg_marker.c */
typedef struct svg_fonts svg_fonts;     /* the fonts that were opened, see svg_glyphs.c */
typedef struct svg_lines svg_lines;     /* and see svg_lines.c */

/* What a reading has said, and found. */
typedef struct {
    unsigned long long warned;  /* bits, see svg_warn */
    bool lost;                  /* a part of the current shape cannot be drawn: none of it is */
    const xmlNode *page;        /* the first white page that was left out */
    double elements;            /* in the file, about */
    bool stopped;               /* by the host */
} svg_notes;

/* The number of an element among its siblings. */
typedef struct {
    const xmlNode *node;
    unsigned place;
} svg_place;

/* One reading of one file. */
typedef struct {
    host *host;
    drawing *d;
    const char *file;
    const xmlNode *node;        /* the current element: its attributes, and for messages */
    svg_sheet *sheet;
    unsigned long long effort;  /* rules tried on elements, and custom properties looked up */
    svg_place place[4];         /* the last that were asked, see svg_selector.c */
    svg_named *named;           /* sorted; of equal ids, only the first in the file */
    size_t named_count;
    unsigned visited, depth;    /* drawn elements, to stop a flood of <use>; nesting */
    svg_notes *notes;
    unsigned chosen;            /* layers around the current element that are to be drawn */
    xmlDictPtr words;           /* names of fonts */
    svg_fonts *fonts;
    svg_lines *lines;
    unsigned fill, tool;        /* of the current shape, see drawing.h */
    float width, mitre, pen[3];
    unsigned char cap, join;
    unsigned layer_tool;        /* of the layers around the current element; 0: none */
    unsigned layer, layers;     /* the innermost of them, see drawing.h; those that were entered */
    bool clipping;              /* what is drawn now is a clip path */
    bool masking, plain;        /* or a mask; it is white, as a clip path would do */
    bool boxing;                /* or what an element consists of, for its box */
    unsigned long long compared;/* boxes of pairs of curves, to stop a flood of them; */
    unsigned long long tiling, since;   /* for patterns; before the outermost pattern under way */
    svg_vertices *vertices;     /* of the current shape; NULL: it has no markers */
    const xmlNode *marking[SVG_MARKINGS];   /* what is drawn now is in these markers, patterns */
    unsigned markings;
    unsigned tiles;             /* of patterns, that were drawn */
    double dashes;              /* that were drawn, about */
    const char *inks[SVG_INKS]; /* the first colours that were seen, if only some are drawn */
    bool inked;                 /* one of those that are drawn was seen */
    unsigned letters;           /* that were drawn, to stop a flood of them */
} svg_reader;

/* Where the custom properties --name of an element are found: on the element, or on its
 * ancestors. */
typedef struct svg_scope {
    const struct svg_scope *up;
    struct {
        xmlHashTablePtr names;
        unsigned long long rank;
    } *list;                    /* one for each rule that sets some, and for style="" */
    size_t count;
    xmlHashTablePtr own;        /* of style="" */
} svg_scope;

enum svg_anchor { SVG_ANCHOR_START, SVG_ANCHOR_MIDDLE, SVG_ANCHOR_END };
enum svg_baseline {
    SVG_USUAL,                  /* what the element around it has */
    SVG_ALPHABETIC,
    SVG_MIDDLE,                 /* half of the height of an x */
    SVG_MATHEMATICAL,           /* half of the ascent */
    SVG_CENTRAL,                /* between ascent and descent */
    SVG_HANGING,
    SVG_TOP,
    SVG_BOTTOM
};

/* How text looks. Lengths are in user units. */
typedef struct {
    const char *family;         /* a list with commas; NULL: any */
    double size;
    int weight;                 /* 1 .. 1000 */
    int slant;                  /* 0: upright, 1: oblique, 2: italic */
    int stretch;                /* -4 .. 4 */
    bool small_caps, underlined, overlined, struck;
    bool plain;                 /* font-kerning: none */
    double letter, word;        /* spacing */
    double shift;               /* of the baseline, upwards */
    enum svg_anchor anchor;
    enum svg_baseline baseline, own_baseline;   /* the second one is not inherited */
    bool leftwards;             /* direction: rtl */
    bool keeps_space;           /* xml:space="preserve", white-space: pre */
} svg_font;

/* What paints: a colour, see svg_ink, or a pattern. */
typedef struct {
    bool paints;
    const char *ink;
    const xmlNode *pattern;
    svg_matrix to_mm;           /* of a pattern's user units, if it is that of another element */
} svg_paint;

/* The space in which an element is drawn. */
typedef struct {
    svg_matrix to_mm;
    double width, height;       /* of the viewport in user units, for %; below 0: unknown */
    bool visible;
    const xmlNode *pattern;     /* that fills; NULL: none; */
    bool pattern_placed;        /* in the user units that this maps to mm */
    svg_matrix pattern_to_mm;
    bool fill, fill_opaque;                 /* an element with neither fill nor stroke is */
    bool stroke, stroke_opaque, stroke_wide;/* invisible and not drawn */
    bool evenodd, clip_evenodd; /* fill-rule, clip-rule */
    const char *clip, *mask;    /* clip-path and mask of this element; NULL: none */
    const char *marker[3];      /* at the start, between, at the end, as written; NULL: none */
    const char *dashes, *dash_offset;       /* as written; NULL: none */
    double stroke_width, mitre; /* user units; stroke-miterlimit */
    int cap, join;              /* of strokes, see drawing.h */
    const char *fill_ink, *stroke_ink;      /* colours, of svg_ink; NULL: black */
    svg_paint context[2];       /* fill and stroke of what has this marker, or uses this */
    bool clipped;               /* overflow: the element is clipped by its viewport */
    double rem;                 /* the font size of the outermost element */
    svg_font font;
    const svg_scope *scope;
} svg_space;

typedef struct svg_uses svg_uses;       /* the <use> elements around an element, see svg.c */

/* An element where it is drawn; `space` is what is in it. */
typedef struct {
    const xmlNode *node;
    const svg_space *space;
    const svg_uses *uses;
} svg_element;

enum svg_side { SVG_ACROSS, SVG_ALONG_Y, SVG_DIAGONAL };       /* the length that a % refers to */


// Document
// --------

/* Is it an SVG element of this name (NULL: of any name)? */
bool svg_is(const xmlNode *node, const char *name);

/* Draw everything in the outermost <svg>. */
bool svg_draw(svg_reader *r, const xmlNode *root);

/* Read the style of the current element into `space`; *shown: some of it is visible. `scope` must
 * outlive `space`, and must be closed. */
bool svg_enter(svg_reader *r, svg_space *space, svg_scope *scope, bool *shown);

/* Note what context-fill and context-stroke mean within an element. */
void svg_set_context(svg_space *space, const svg_space *of);

/* What the outermost element inherits. */
svg_space svg_space_usual(void);

/* Enter the viewport of the current element: a box of width x height (below 0: unknown) in `space`
 * shows its viewBox. Returns false if its size is 0: nothing of it is drawn. */
bool svg_enter_viewport(const svg_reader *r, svg_space *space, double width, double height);

/* The sizes that an element gives itself, or `width` and `height`. */
void svg_sizes(const svg_reader *r, const svg_space *space, double *width, double *height);

/* Go to the x and y of the current element. */
void svg_move_origin(const svg_reader *r, svg_space *space);

/* Cut the curves from the first'th on at the edges of a viewport. */
bool svg_cut_frame(svg_reader *r, const xmlNode *node, const svg_matrix *frame, double width,
                   double height, size_t first);

/* Draw what the viewport of an element shows, of this size at 0, 0. */
bool svg_viewport(svg_reader *r, const xmlNode *node, svg_space space, double width, double height);

/* Draw the elements in an element. */
bool svg_children(svg_reader *r, const xmlNode *node, svg_space space);

/* Draw the geometry of an element, seen or not, without clip paths, markers and patterns. */
bool svg_geometry(svg_reader *r, const svg_element *e, drawing *out);

/* Begin a shape: the curves that follow are painted together. Returns false if it is invisible. */
bool svg_begin(svg_reader *r, const svg_space *space);

/* What the current element refers to by href, or NULL; free with xmlFree. And the element with an
 * id, or NULL. */
char *svg_reference(const xmlNode *node);
const xmlNode *svg_find(const svg_reader *r, const char *id);


// Messages
// --------

/* The line where the tag of the current element starts. */
unsigned svg_at_line(const svg_reader *r);

/* Print `loft: file:line: <message>` and return false. */
bool svg_fail(const svg_reader *r, const char *name, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Tell the host how far the reading is; false: it has stopped it. */
bool svg_goes_on(svg_reader *r, const char *doing);

enum svg_warning {
    SVG_WARN_SELECTOR,
    SVG_WARN_DATA,
    SVG_WARN_TEXT,
    SVG_WARN_LETTER,
    SVG_WARN_LAYER,
    SVG_WARN_LAYER_NUMBERS,
    SVG_WARN_LINE,
    SVG_WARN_UPRIGHT,
    SVG_WARN_TEXT_STYLE,
    SVG_WARN_GEOMETRY,
    SVG_WARN_MOTION,
    SVG_WARN_PICTURE,
    SVG_WARN_CLIP_PATH,
    SVG_WARN_MASK,
    SVG_WARN_PATTERN,
    SVG_WARN_DASHES,
    SVG_WARN_BOX,
    SVG_WARN_UNSEEN,
    SVG_WARN_USE_NOTHING,
    SVG_WARN_USE_ELSEWHERE,
    SVG_WARN_USE_MISSING,
    SVG_WARN_USE_CYCLE,
    SVG_WARN_LENGTH,
    SVG_WARN_SIZE,
    SVG_WARN_TRANSFORM,
    SVG_WARN_VIEW,
    SVG_WARN_FAR,
    SVG_WARN_MEDIA,
    SVG_WARN_FILTER,
    SVG_WARN_BLEND,
    SVG_WARN_PAGE,
    SVG_WARN_BACKGROUND
};

/* The same, but the reading continues; only the first warning of each kind is printed. */
void svg_warn(const svg_reader *r, enum svg_warning kind, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* The same, and the current shape is left out. */
void svg_lose(const svg_reader *r, enum svg_warning kind, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

// Attributes and style
// --------------------

/* The attribute without a namespace, or NULL; free with xmlFree. */
char *svg_attribute(const xmlNode *node, const char *name);

enum svg_property {
    SVG_DISPLAY,
    SVG_VISIBILITY,
    SVG_OPACITY,
    SVG_FILL,
    SVG_FILL_OPACITY,
    SVG_FILL_RULE,
    SVG_CLIP_RULE,
    SVG_STROKE,
    SVG_STROKE_OPACITY,
    SVG_STROKE_WIDTH,
    SVG_TRANSFORM,
    SVG_ORIGIN,
    SVG_BOX,
    SVG_OVERFLOW,
    SVG_CLIP_PATH,
    SVG_MASK,
    SVG_DASHES,
    SVG_DASH_OFFSET,
    SVG_LINECAP,
    SVG_LINEJOIN,
    SVG_MITRE,
    SVG_MARKER,
    SVG_MARKER_START,
    SVG_MARKER_MID,
    SVG_MARKER_END,
    SVG_FILTER,
    SVG_BLEND,
    SVG_BACKGROUND,
    SVG_BACKGROUND_COLOUR,
    SVG_GEOMETRY,               /* of a style: x, width, d and others of shapes */
    SVG_MOTION,                 /* of a style: rotate, scale and others */
    SVG_FONT,
    SVG_FONT_FAMILY,
    SVG_FONT_SIZE,
    SVG_FONT_STYLE,
    SVG_FONT_WEIGHT,
    SVG_FONT_STRETCH,
    SVG_FONT_VARIANT,
    SVG_FONT_KERNING,
    SVG_LETTER_SPACING,
    SVG_WORD_SPACING,
    SVG_TEXT_ANCHOR,
    SVG_TEXT_DECORATION,
    SVG_BASELINE,
    SVG_BASELINE_OWN,
    SVG_BASELINE_SHIFT,
    SVG_DIRECTION,
    SVG_WHITE_SPACE,
    SVG_WRITING_MODE,
    SVG_FONT_CAPS,
    SVG_DECORATION_LINE,
    SVG_DECORATION_STYLE,       /* from here on: not drawn, but told */
    SVG_TEXT_TRANSFORM,
    SVG_FONT_VARIATION,
    SVG_FONT_FEATURES,
    SVG_FONT_ADJUST,
    SVG_FONT_LIGATURES,
    SVG_FONT_NUMERIC,
    SVG_FONT_POSITION,
    SVG_PROPERTIES
};

/* A value in the text of a style, and its rank among other values. */
typedef struct {
    const char *text;           /* NULL: not set */
    size_t length;
    unsigned long long rank;
} svg_value;

#define SVG_RANK_IMPORTANT (1ull << 60)
#define SVG_RANK_OWN       (1ull << 59)     /* of style=""; ranks of sheets are lower */

/* Replace the value if the other one has the same or a higher rank. */
void svg_value_put(svg_value *to, svg_value from);

/* `a: b; --c: d` */
typedef struct {
    svg_value value[SVG_PROPERTIES];
    xmlHashTablePtr names;      /* custom properties to values; NULL: none. Free with
                                 * svg_names_free */
} svg_block;

void svg_block_read(svg_block *block, const char *text, unsigned long long rank);
void svg_names_free(xmlHashTablePtr names);

/* Everything that style sheets and style="" set for the current element. */
typedef struct {
    svg_value value[SVG_PROPERTIES];
    unsigned long long attributes;  /* bits: the element has the attribute */
    char *text;                 /* of style="" */
    const svg_scope *scope;
} svg_style;

/* Read the style of the current element; `*scope` becomes its scope, within `up`. Close each of the
 * two separately. */
void svg_style_open(svg_reader *r, svg_style *style, svg_scope *scope, const svg_scope *up);
void svg_style_close(svg_style *style);
void svg_scope_add(svg_scope *scope, xmlHashTablePtr names, unsigned long long rank);
void svg_scope_close(svg_scope *scope);

/* The value of a property with all var() substituted, or "unset" if one of them is not set;
 * otherwise the attribute; or NULL. *css tells whether it comes from a style. Free with xmlFree. */
char *svg_property(svg_reader *r, const svg_style *style, enum svg_property which, bool *css);

/* Its name in a style sheet. */
const char *svg_property_name(enum svg_property which);

typedef struct svg_selector svg_selector;

/* Read one selector; NULL if it is not understood. Its rank, see svg_value, is below 2^24. */
svg_selector *svg_selector_read(const char *text, size_t length);
void svg_selector_free(svg_selector *s);
unsigned svg_selector_rank(const svg_selector *s);
bool svg_selector_matches(svg_reader *r, const svg_selector *s, const xmlNode *node);

/* A name that an element needs to match, and its kind: "." "#" ":" ""; NULL: there are no more. */
const char *svg_selector_name(const svg_selector *s, unsigned which, const char **kind);

/* The length up to one of the characters `stops`, or to the end; those in strings and parentheses
 * do not count. And what is in comments becomes blank. */
size_t svg_css_span(const char *text, const char *stops);
void svg_blank_comments(char *text);

void svg_sheet_apply(svg_reader *r, svg_style *style, svg_scope *scope);
void svg_sheet_read(svg_reader *r, const xmlNode *style);
void svg_sheet_free(svg_sheet *sheet);


// Space
// -----

extern const svg_matrix svg_identity;

/* Apply `inner` first, then `outer`. */
svg_matrix svg_multiply(svg_matrix outer, svg_matrix inner);

/* The largest factor by which it stretches a length. */
double svg_stretch(svg_matrix m);

/* Multiply *m by the list of transforms in `text`. `css`: by the functions and units of CSS. What
 * cannot be computed with becomes all 0, of which nothing is drawn. */
void svg_transform(const svg_reader *r, const char *text, bool css, svg_matrix *m);

/* Read a value of transform-origin: the point about which a transform turns and scales; 0, 0 if it
 * cannot be read. */
void svg_origin(const svg_reader *r, const svg_space *space, const char *text, double out[2]);

/* A length attribute of the current element in user units; `absent` if it is missing, or `auto`, or
 * cannot be read. And a size, which is a length that is not negative. */
double svg_length(const svg_reader *r, const svg_space *space, const char *name, enum svg_side side,
                  double absent);
double svg_size(const svg_reader *r, const svg_space *space, const char *name, enum svg_side side,
                double absent);

/* Read a list of them, at most `room`. Returns how many; 0 if one cannot be read. */
size_t svg_lengths(const svg_reader *r, const svg_space *space, const char *name,
                   enum svg_side side, double out[], size_t room);

/* A length of CSS. `hundred` is what 100 % are. Returns false, and leaves *out alone, for anything
 * else. */
bool svg_css_length(const svg_space *space, const char *text, double hundred, double *out);

/* Read the numbers of the attribute `viewBox`. Returns false if there is none that can be read. */
bool svg_view_box(const svg_reader *r, double box[4]);

/* The matrix that fits `box` into width x height, by preserveAspectRatio of the current element. */
svg_matrix svg_fit(const svg_reader *r, const double box[4], double width, double height);

// Pen
// ---

typedef struct {
    const svg_reader *r;
    svg_matrix to_mm;
    double start[2], at[2];     /* user units                                    */
    double end[2];              /* mm; the end of the drawn path */
    bool fresh;                 /* nothing was drawn since the last move */
    bool still;                 /* but a curve without length was to be */
    bool dots;                  /* that is a dot: a stroke with round or square ends */
    unsigned line;              /* of the file                                   */
} svg_pen;

/* mm: what has no length, and ends that are drawn, has this one: less than what else is lost of a
 * stroke, and enough for a pen to go down there */
#define SVG_DOT 0.002

svg_pen svg_pen_at(const svg_reader *r, svg_matrix to_mm);
void svg_move(svg_pen *pen, double x, double y);
bool svg_line(svg_pen *pen, double x, double y);
bool svg_quad(svg_pen *pen, double x1, double y1, double x, double y);
bool svg_cubic(svg_pen *pen, double x1, double y1, double x2, double y2, double x, double y);
bool svg_arc(svg_pen *pen, double rx, double ry, double degrees, bool large, bool sweep, double x,
             double y);
bool svg_close(svg_pen *pen);

/* Behind the last curve of a shape. */
void svg_end(svg_pen *pen);


// Colours
// -------

/* A colour as #rrggbb, or as it is written; it lives as long as the reader. */
const char *svg_ink(svg_reader *r, const char *text);

/* Is a shape with this paint to be drawn? A stroke counts more than a fill. And at the end: was
 * there any? */
bool svg_ink_chosen(svg_reader *r, const svg_space *space, bool stroked);
bool svg_ink_check(const svg_reader *r);

/* The number of the tool that draws this paint; 0: none. */
unsigned svg_ink_tool(const svg_reader *r, const svg_space *space, bool stroked);


// Fonts
// -----

#define SVG_FONT_SIZE_USUAL 16.0

/* Set the font of the outermost element; and apply the properties of the current one. */
svg_font svg_font_usual(void);
void svg_font_enter(svg_reader *r, const svg_style *style, svg_space *space);

/* A part of an outline in em, y down: M and L have one point, C three, Z none. */
typedef struct {
    char kind;
    double p[3][2];
} svg_part;

/* A glyph, or some that belong together. */
typedef struct {
    size_t from;                /* the byte at which its letters begin */
    double advance;             /* em */
    size_t first, count;        /* of its parts */
    bool lines;                 /* they are single lines, not outlines */
    bool cursive;               /* its letters join: nothing is put between them */
} svg_cluster;

/* Text as glyphs, from left to right. Free with svg_shaped_free. */
typedef struct {
    svg_cluster *cluster;
    svg_part *part;
    size_t clusters, cluster_room, parts, part_room;
    bool missing, outlined;     /* a letter is in no font; one has no single lines; */
    bool pictured;              /* one is a picture in its font */
} svg_shaped;

/* What a font says of itself, in em: all positive but `underline`, the middle of a line below. */
typedef struct {
    double ascent, descent, x_height, underline, thickness;
} svg_metrics;

/* Bytes of a text, up to `end`, that have one font. */
typedef struct {
    const svg_font *font;
    size_t end;
} svg_span;

void svg_shaped_add(svg_shaped *s, size_t from, double advance);
void svg_shaped_part(svg_shaped *s, char kind, const double p[], int points);
void svg_shaped_free(svg_shaped *s);

/* Shape the UTF-8 of these spans as one text, or a single span from byte `from` on: outlines of
 * installed fonts, or single lines; letters that have none are outlines. Return false without any.
 */
bool svg_glyphs_shape(svg_reader *r, const svg_span spans[], size_t count, const char *text,
                      bool leftwards, svg_shaped *out);
bool svg_lines_shape(svg_reader *r, const svg_span *span, size_t from, const char *text,
                     svg_shaped *out);

/* Of the font itself, not of those that stand in for letters which it does not have. */
svg_metrics svg_glyphs_metrics(svg_reader *r, const svg_font *font);
svg_metrics svg_lines_metrics(void);
void svg_glyphs_close(svg_fonts *fonts);
void svg_lines_close(svg_lines *lines);


// Shapes
// ------

/* Draw the current element if it is a shape; *known tells whether it is one. */
bool svg_shape(svg_reader *r, const svg_space *space, bool *known);

/* Draw the current element, a <text>. */
bool svg_text(svg_reader *r, const svg_space *space);

/* A path that carries text, in its user units. */
typedef struct {
    drawing d;                  /* user units times `scale` */
    double scale;
    double *until;              /* the length at each sample */
    double length;
} svg_rail;

/* Lay what a shape draws; free with svg_free_rail. */
bool svg_lay_rail(svg_reader *r, const xmlNode *node, const svg_space *space, svg_rail *out);
void svg_free_rail(svg_rail *l);

/* The place and the direction at a distance. Returns false beyond the ends. */
bool svg_rail_at(const svg_rail *l, double distance, double at[2], double way[2]);

/* The curve in the space that `m` maps to mm. */
drawing_curve svg_within(const drawing_curve *c, const svg_matrix *m);

/* Leave out what is outside of an outline, whose parts are closed, from curve `first` on. Curves
 * that are an outline themselves stay, and belong to an area. */
bool svg_cut(svg_reader *r, const drawing *outline, size_t first);

/* Cut the curves from the first'th on, which the current element has drawn, at its clip path; at
 * its mask, which is a clip path if it is of white shapes: what another one lets through is not
 * known. */
bool svg_clip_element(svg_reader *r, const svg_element *e, size_t first);
bool svg_mask_element(svg_reader *r, const svg_element *e, size_t first);

/* Fill the current element, a shape, with its pattern. */
bool svg_pattern(svg_reader *r, const svg_space *of);

/* Close each part of an outline by a line. */
void svg_close_outline(drawing *d);

/* The box of the curves from `first` on in the space that `m` maps to mm; 0 without any. */
void svg_box(const drawing *d, size_t first, const svg_matrix *m, double box[2][2]);

/* Apply the style of the elements around a node and of itself, not their transforms: `room` scopes,
 * of which *count are to be closed. */
bool svg_enter_from_root(svg_reader *r, const xmlNode *node, svg_space *space, svg_scope *scope,
                         size_t room, size_t *count, bool *shown);

/* Is this marker or pattern being drawn, or too many of them? */
bool svg_is_marking(const svg_reader *r, const xmlNode *node);

/* Does the current element have markers? Note its vertices: where a part begins; where a segment
 * ends, whose curves are those from `before` on. Draw the markers. */
bool svg_has_markers(const svg_reader *r, const svg_space *space);
svg_vertices *svg_vertices_open(void);
void svg_vertices_close(svg_vertices *all);
void svg_vertex_move(const svg_pen *pen);
void svg_vertex(const svg_pen *pen, size_t before, bool closes);
bool svg_markers(svg_reader *r, const svg_space *space, const svg_vertices *all);

/* Cut the curves from `first` on into the dashes of the current element. */
bool svg_dash(svg_reader *r, const svg_space *space, size_t first);

/* Draw path data, up to what cannot be read in it. */
bool svg_path(svg_reader *r, const char *data, svg_pen *pen);

/* Is there a layer for each word of --layer? */
bool svg_layers_check(const svg_reader *r, const xmlNode *root);

/* Is it a layer that --layer names? */
bool svg_layer_chosen(const svg_reader *r, const xmlNode *node);

/* The number of the tool that draws this layer, or what is in it; that of the layers around it
 * otherwise. */
unsigned svg_layer_tool(const svg_reader *r, const xmlNode *node);

/* The number of the layer that draws what is in the element, 0: none; a layer gets the next one. */
unsigned svg_layer_number(svg_reader *r, const xmlNode *node);

/* AxiDraw leaves out layers whose names begin with %, and reads numbers in others. */
bool svg_layer_drawn(svg_reader *r, const xmlNode *node);

#endif
