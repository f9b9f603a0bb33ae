/* host-tools/arrange/tools.h -- which tool of the machine draws which part of a drawing
 * SPDX-License-Identifier: MIT
 *
 * Colours and layers have tools (read/machine_tools.h). A drawing is sorted by them, in the order
 * of the machine file, and each part has the feed and the heights of its tool.
 */
#ifndef LOFT_TOOLS_H
#define LOFT_TOOLS_H

#include "arrange/order.h"             /* order_options */
#include "read/drawing.h"
#include "read/machine_tools.h"

struct host;                /* base/host.h */

/* Sort a drawing by tools, and set its feeds and heights. What belongs to no tool is drawn first,
 * and a line tells so. Programs stay as they are. Returns 0, or an exit code after printing one
 * line. */
int tools_apply(struct host *h, const machine_tools *t, drawing *d, const char *file);

/* Put the part of each tool in order (order.h), or of each layer of each tool. Results as above. */
int tools_order(struct host *h, const order_options *o, drawing *d, const double from[2],
                bool returns, const char *file);

/* What one tool draws: parts of the drawings that it was made from, which own the curves. */
typedef struct {
    const machine_tool *tool;       /* NULL: none */
    drawing d, smooth;
} tools_part;

#define TOOLS_PARTS 256

/* Split a sorted drawing or a program, and its smoothed form, where the tool changes. Returns how
 * many parts there are: one, with all of it, of a drawing without tools; 0 if there is no room for
 * all of them. */
size_t tools_split(const machine_tools *t, const drawing *d, const drawing *smooth,
                   tools_part part[TOOLS_PARTS]);

/* What the loose axes of a program have moved before this part of it. */
void tools_counted(const drawing *part, double out[3]);

/* How far this tool is lifted from where it draws, mm; `usual` if it does not say. */
double tools_lift(const machine_tool *tool, double usual);

/* The most that any tool of the table is lifted. */
double tools_most_lift(const machine_tools *t, double usual);

#endif
