/* host-tools/arrange/page.h -- where on which page a drawing is drawn, how large, and how often
 * SPDX-License-Identifier: MIT
 *
 * Scaling, mirroring, turning and moving are done to control points, so curves stay the curves that
 * they are. Only --crop cuts them. Heights do not change.
 */
#ifndef LOFT_PAGE_H
#define LOFT_PAGE_H

#include "base/tool.h"      /* tool_option, tool_list */
#include "arrange/fill.h"
#include "read/drawing.h"   /* drawing */

typedef struct {
    double size[2];         /* mm; 0: that of the file */
    double degrees;         /* counterclockwise */
    bool upright;           /* turned by 90 degrees if it fits better so */
    tool_list scale, at;
    const char *mirror;     /* "x", "y" or NULL */
    const char *layers, *only, *text;       /* drawing.h */
    bool fit, centre, crop;
    double margin, gap;     /* mm */
    unsigned copies[2];     /* across, up; 0: one */
    fill_options fill;
    const char *stroke;     /* "line" or "outline"; NULL: line */
} page_options;

/* Rows of a table of options. */
#define PAGE_OPTIONS(g)                                                                            \
    TOOL_TEXT("layer", "NAME,..", &(g)->layers,                                                    \
              "of SVG: draw only these layers of Inkscape, by name or first number (all)"),        \
        TOOL_TEXT("only", "COLOUR,..", &(g)->only,                                                 \
                  "of SVG: draw only these colours, of strokes or else of fills, as red,#00f "     \
                  "(all)"),                                                                        \
        TOOL_TEXT("text", "HOW", &(g)->text,                                                       \
              "of SVG: outline, line or line:FONT: letters of single lines, as line:rowmans; "     \
              "none (outline)"),                                                                   \
        TOOL_PARSED("page", "SIZE", g, page_parse_size,                                            \
                "the page: A4, A4-landscape, Letter .., 210x297 mm, 8.5x11in (the file's)"),       \
        TOOL_NUMBER("margin", "MM", &(g)->margin, 0, 8000,                                         \
                    "of the page that --fit and --crop leave free (0)"),                           \
        TOOL_LIST("scale", "F[,FY]", &(g)->scale, 1e-6, 1e6, "times as large; FY: along y"),       \
        TOOL_TEXT("mirror", "x|y", &(g)->mirror, "x: left becomes right; y: top becomes bottom"),  \
        TOOL_PARSED("rotate", "DEG", g, page_parse_turn,                                      \
                    "counterclockwise; auto: by 90 if the page has more room for it then"),        \
        TOOL_SWITCH("fit", &(g)->fit, "as large as the page allows, and in its middle"),           \
        TOOL_SWITCH("centre", &(g)->centre, "in the middle of the page"),                          \
        TOOL_LIST("at", "X,Y", &(g)->at, -16000, 16000,                                            \
                  "the lower left corner of what is drawn, mm from that of the page"),             \
        TOOL_PARSED("copies", "NXxNY", g, page_parse_copies, "NX side by side, in NY rows"),       \
        TOOL_NUMBER("gap", "MM", &(g)->gap, 0, 8000, "between copies (5)"),                        \
        TOOL_SWITCH("crop", &(g)->crop, "draw only what is on the page, without its margin"),     \
        FILL_OPTIONS(&(g)->fill),                                                                  \
        TOOL_TEXT("stroke", "HOW", &(g)->stroke,                                                   \
                  "of SVG: line: along its middle, outline: around all that it covers (line)")

#define PAGE_GAP 5          /* mm; the default of `gap` */

/* Of the table above; `out` is a page_options. They print their own error. */
bool page_parse_size(const char *text, void *out);
bool page_parse_turn(const char *text, void *out);
bool page_parse_copies(const char *text, void *out);

/* Do the options change the drawing, or look at all of it? */
bool page_is_asked(const page_options *g);

/* Scale, mirror, turn and place the drawing, in this order, make the copies, fill and cut them.
 * Returns 0, or an exit code after printing one line; then *d may be changed, but can be freed.
 *
 *   error   8 ulp of the largest coordinate; none for turns by 90 degrees, mirroring and scaling by
 *           powers of 2; --crop: PAGE_CUT */
int page_apply(const page_options *g, drawing *d, const char *file);

/* Cut a drawing at a box: box[0] smallest, box[1] largest. The pieces are exact pieces of the
 * curves; their ends lie on the edge exactly. *to must be zeroed. Returns 0, or an exit code after
 * printing one line.
 *
 *   error   no piece leaves the box by more than PAGE_CUT, and none that is left out enters it by
 *           more */
int page_crop(drawing *to, const drawing *from, const double box[2][2], const char *file);

#define PAGE_CUT 1e-4       /* mm */

/* The box of a drawing and its page in words: "120.000 x 80.000 mm at 10.000,20.000 on a page of
 * 210 x 297 mm". */
const char *page_words(const drawing *d, char text[160]);

#endif
