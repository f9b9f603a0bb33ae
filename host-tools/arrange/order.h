/* host-tools/arrange/order.h -- the order of a drawing with the least travel
 * SPDX-License-Identifier: MIT
 *
 * Curves that the drawing has twice are drawn once; paths whose ends touch become one path; then
 * paths are drawn in the order, in the direction and, if they are closed, from the point for which
 * the way between them is short (tour.h).
 */
#ifndef LOFT_ORDER_H
#define LOFT_ORDER_H

#include "base/tool.h"      /* tool_option */
#include "read/drawing.h"   /* drawing */

typedef struct {
    const char *how;            /* "file", "layer" or "best"; NULL: file */
    double effort;              /* seconds, as in tour.h */
    double join;                /* mm */
    const char *seam;           /* "any", "corner" or "X,Y"; NULL: any */
    bool doubles;
} order_options;

#define ORDER_EFFORT 2          /* defaults */
#define ORDER_JOIN   0.005

/* Rows of a table of options. */
#define ORDER_OPTIONS(o)                                                                           \
    TOOL_TEXT("order", "file|layer|best", &(o)->how,                                               \
              "of the paths: as in the file, or with the least travel: within each layer of "      \
              "Inkscape, or in all. What follows is for these two (file)"),                        \
        TOOL_NUMBER("order-time", "S", &(o)->effort, 0, 3600,                                      \
                    "work of about S seconds. It is counted, so that the same command gives the "  \
                    "same order (2)"),                                                             \
        TOOL_NUMBER("join", "MM", &(o)->join, 0, 10,                                               \
                    "ends this close are joined by a line (0.005)"),                               \
        TOOL_TEXT("seam", "WHERE", &(o)->seam,                                                     \
                  "where closed paths begin: any, corner, or X,Y: near to it (any)"),              \
        TOOL_SWITCH("doubles", &(o)->doubles, "draw twice what the drawing has twice")

/* Put the drawing in order, all of it also with "layer" (tools.h), for a tool that begins at `from`
 * and, if it `returns`, ends there. Returns 0, or an exit code after printing one line. */
int order_apply(const order_options *o, drawing *d, const double from[2], bool returns,
                const char *file);

#endif
