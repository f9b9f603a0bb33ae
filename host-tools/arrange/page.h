/* host-tools/arrange/page.h -- where on which page a drawing is drawn, how large, and how often
 * SPDX-License-Identifier: MIT
 *
 * Scaling, mirroring, turning and moving are done to control points, so curves stay the curves that
 * they are. Only --crop cuts them. Heights do not change.
 */
#ifndef LOFT_PAGE_H
#define LOFT_PAGE_H

#include "arrange/fill.h"
#include "base/option.h"    /* option, option_list */
#include "read/drawing.h"   /* drawing */

struct host;                /* base/host.h */

typedef struct {
    double size[2];         /* mm; 0: that of the file */
    double degrees;         /* counterclockwise */
    bool upright;           /* turned by 90 degrees if it fits better so */
    option_list scale, at;
    const char *mirror;     /* "x", "y" or NULL */
    const char *layers, *only, *text;       /* drawing.h */
    bool fit, centre, crop;
    double margin, gap;     /* mm */
    unsigned copies[2];     /* across, up; 0: one */
    fill_options fill;
    const char *stroke;     /* "line" or "outline"; NULL: line */
} page_options;

extern const option page_rows[];

/* Do the options change the drawing, or look at all of it? */
bool page_is_asked(const page_options *g);

/* Scale, mirror, turn and place the drawing, in this order, make the copies, fill and cut them.
 * Returns 0, or an exit code after printing one line; then *d may be changed, but can be freed.
 *
 *   error   8 ulp of the largest coordinate; none for turns by 90 degrees, mirroring and scaling by
 *           powers of 2; --crop: PAGE_CUT */
int page_apply(struct host *h, const page_options *g, drawing *d, const char *file);

/* Cut a drawing at a box: box[0] smallest, box[1] largest. The pieces are exact pieces of the
 * curves; their ends lie on the edge exactly. *to must be zeroed. Returns 0, or an exit code after
 * printing one line.
 *
 *   error   no piece leaves the box by more than PAGE_CUT, and none that is left out enters it by
 *           more */
int page_crop(struct host *h, drawing *to, const drawing *from, const double box[2][2],
              const char *file);

#define PAGE_CUT 1e-4       /* mm */

/* The box of a drawing and its page in words: "120.000 x 80.000 mm at 10.000,20.000 on a page of
 * 210 x 297 mm". */
const char *page_words(const drawing *d, char text[160]);

#endif
