/* lib/polygon/disk.h -- a patch with n sides as one surface around its middle, for contours and
 * lines
 * SPDX-License-Identifier: MIT
 *
 * u runs from the middle to the boundary, v around it: from k / n to (k + 1) / n along side k,
 * linearly. So there is no seam: contours of surface/contour.h close around the middle. If rows and
 * columns are multiples of n, the grid contains all corners. The polygon may have any shape: the
 * disk covers each of its points once.
 *
 *     loft_disk r;
 *     if (loft_disk_from_spatch(&r, &patch, &domain, loft_wachspress_eval) == LOFT_OK &&
 *         loft_contour_init(&c, loft_surface_from_disk(&r), 2, height, tol, 32, 40, memory,
 *                           sizeof memory) == LOFT_OK) ..
 *
 * In q16 the points of a polygon have the step 2^-16, which limits the resolution on the patch. For
 * fine contours take a large polygon, not one in the unit circle. Coordinates do not depend on its
 * size.
 */
#ifndef LOFT_POLYGON_DISK_H
#define LOFT_POLYGON_DISK_H

#include "polygon/basepoint.h"      /* loft_basepoint */
#include "polygon/gb.h"             /* loft_gb */
#include "polygon/harmonic.h"       /* loft_harmonic */
#include "polygon/partition.h"      /* loft_partition */
#include "polygon/zheng_ball.h"     /* loft_zheng_ball */
#include "polygon/spatch.h"         /* loft_spatch */
#include "polygon/toric.h"          /* loft_toric */
#include "surface/surface.h"        /* loft_surface */

LOFT_BEGIN_C

/* loft_wachspress_eval, loft_meanvalue_eval; others have no derivatives. */
typedef enum loft_status loft_coordinates(const loft_domain *d, loft_spot p, loft_sci phi[]);

enum loft_disk_of {
    LOFT_DISK_OF_SPATCH,
    LOFT_DISK_OF_GB,
    LOFT_DISK_OF_TORIC,
    LOFT_DISK_OF_BASEPOINT,
    LOFT_DISK_OF_ZHENG_BALL
};

/* The point, or, unless `slopes` is NULL, the derivatives there in place of it. */
struct loft_disk;
typedef enum loft_status loft_disk_at(const struct loft_disk *r, unsigned side, loft_unit share,
                                      loft_unit u, loft_vec *out, loft_differential *slopes);

/* Everything is borrowed. Do not fill it yourself. */
typedef struct loft_disk {
    loft_disk_at *at;
    const void *patch;
    const loft_domain *domain;
    loft_coordinates *coordinates;
    const loft_harmonic *harmonic;
    loft_partition cut;         /* over a polygon: its convex pieces */
    uint8_t sides, of;          /* enum loft_disk_of */
} loft_disk;

/* Make a disk of a patch over a polygon, with its coordinates or, with NULL, harmonic ones (below);
 * of a toric patch; of a patch with base points; of a Zheng-Ball patch. The middle is the mean of
 * the vertices, or of those of the first piece when the polygon is not convex.
 *
 *   range   as many vertices as sides, otherwise LOFT_ERR_ARG; *r is then untouched
 *   error   none: everything is borrowed
 *   cost    that of loft_partition_init
 */
enum loft_status loft_disk_from_spatch(loft_disk *r, const loft_spatch *s, const loft_domain *d,
                                       loft_coordinates *coordinates) LOFT_CHECKED;
enum loft_status loft_disk_from_gb(loft_disk *r, const loft_gb *g, const loft_domain *d,
                                   loft_coordinates *coordinates) LOFT_CHECKED;
void loft_disk_from_toric(loft_disk *r, const loft_toric *t);
void loft_disk_from_basepoint(loft_disk *r, const loft_basepoint *b);
void loft_disk_from_zheng_ball(loft_disk *r, const loft_zheng_ball *g);

/* Use harmonic coordinates, which must outlive the disk.
 *
 *   range   a patch over the domain of h, otherwise LOFT_ERR_ARG
 *   error   none: everything is borrowed
 *   cost    two pointers copied
 */
enum loft_status loft_disk_harmonic(loft_disk *r, const loft_harmonic *h) LOFT_CHECKED;

/* Make a loft_surface of a disk: LOFT_SURFACE_DISK. Its derivatives, for isophotes and silhouettes,
 * are those by the coordinates of the domain or the parameters of the patch; on the boundary those
 * of a place 2^-16, or up to 2^-7, of the way nearer to the middle.
 *
 *   range   u, v in 0..1, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE when the point does not fit
 *   error   that of the patch's eval, at parameters rounded to 2^-24 of u and v, of a polygon to
 *           2^-23 and its step. At u = 1 of spatch and gb it is the point of the side. At v = 1,
 *           and at v = k / n where n is a power of two, it is the corner itself. It is the nearest
 *           point of the boundary where rounding leads outside
 *   cost    a point of the patch; over a polygon the coordinates, 6 small products for each side of
 *           each piece and six lerps; for a Zheng-Ball patch two roots (6 sides: two times 4 steps
 *           of Newton's method, 40 products)
 */
loft_surface loft_surface_from_disk(const loft_disk *r);

LOFT_END_C

#endif
