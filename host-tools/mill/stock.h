/* host-tools/mill/stock.h -- the block out of which a mill cuts surfaces
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_HOST_STOCK_H
#define LOFT_HOST_STOCK_H

#include "engine/mill.h"        /* mill_cut, mill_trim */
#include "engine/surface.h"

struct host;                /* base/host.h */

/* mm; width, depth and height are along x, y and z. */
typedef struct {
    bool given, placed;
    double low[3], size[3];     /* its lowest corner, once it is placed */
} stock;

#define STOCK_MOST 4096

/* WxDxH or WxDxH@X,Y,Z. */
bool stock_parse(const char *text, void *out);

/* Place the block, if its place is not given: its middle below that of the surfaces, its top at
 * their highest point, each rounded up to 0.001 mm. Of trimmed surfaces only what is inside of the
 * loops counts. Returns 0, or an exit code after printing one line: the surfaces leave the block.
 *
 *   error   the surfaces are known by at least 16 x 16 points each, those of few by 96 x 96 */
int stock_place(struct host *h, stock *s, const surfaces *all, const mill_trim *trim,
                const char *file);

/* Refuse a path with places beside the block or below its bottom. Returns as stock_place. */
int stock_holds(struct host *h, const stock *s, const mill_cut *path, const char *file);

#endif
