/* host-tools/svg/svg_viewport.c -- viewports: their size and place, and what is cut at their edges
 * SPDX-License-Identifier: MIT
 */
#include "svg/svg.h"

#define UNCLIPPED 0.01          /* mm; a smaller excess over a viewport is not reported */

bool svg_enter_viewport(const svg_reader *r, svg_space *space, double width, double height)
{
    double box[4];
    const bool given = svg_view_box(r, box);

    if (given && (width < 0 || height < 0)) {
        width  = box[2];
        height = box[3];
    }
    if (width == 0 || height == 0 || (given && (box[2] == 0 || box[3] == 0)))
        return false;
    if (given) {
        space->to_mm = svg_multiply(space->to_mm, svg_fit(r, box, width, height));
        width  = box[2];
        height = box[3];
    }
    space->width  = width;
    space->height = height;
    return true;
}

void svg_sizes(const svg_reader *r, const svg_space *space, double *width, double *height)
{
    *width  = svg_size(r, space, "width", SVG_ACROSS, *width);
    *height = svg_size(r, space, "height", SVG_ALONG_Y, *height);
}

void svg_move_origin(const svg_reader *r, svg_space *space)
{
    const double x = svg_length(r, space, "x", SVG_ACROSS, 0),
                 y = svg_length(r, space, "y", SVG_ALONG_Y, 0);

    space->to_mm = svg_multiply(space->to_mm, (svg_matrix){ 1, 0, 0, 1, x, y });
}

/* Does a curve from the first'th on leave width x height? */
static bool leaves_frame(const svg_reader *r, const svg_matrix *frame, double width, double height,
                         size_t first)
{
    const double margin = UNCLIPPED / svg_stretch(*frame);

    for (size_t i = first; i < r->d->count; i++) {
        drawing_curve in = svg_within(&r->d->curve[i], frame);
        const drawing one = { .curve = &in, .count = 1 };
        double box[2][2];
        if (drawing_box(&one, box) && (box[0][0] < -margin || box[0][1] < -margin ||
                                       box[1][0] > width + margin || box[1][1] > height + margin))
            return true;
    }
    return false;
}

bool svg_cut_frame(svg_reader *r, const xmlNode *node, const svg_matrix *frame, double width,
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
