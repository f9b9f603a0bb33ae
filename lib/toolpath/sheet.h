/* lib/toolpath/sheet.h -- a surface of which every piece is known to be nearly flat, and how nearly
 * SPDX-License-Identifier: MIT
 *
 * Over a square of parameters of side 2^-k the surface lies within bend / 4^k of the quadrilateral
 * of its corners; over a triangle, of the triangle. So a search can leave out whole pieces of a
 * surface, with certainty, by looking at their corners alone: loft_sheet_gap.
 *
 *     loft_sheet s;
 *     if (loft_sheet_from_tensor(&s, &patch) == LOFT_OK) ..
 */
#ifndef LOFT_TOOLPATH_SHEET_H
#define LOFT_TOOLPATH_SHEET_H

#include "surface/surface.h"    /* loft_surface */
#include "toolpath/region.h"    /* loft_region */

LOFT_BEGIN_C

#define LOFT_SHEET_REACH    4096    /* the largest coordinate */
#define LOFT_SHEET_LEVELS   4
#define LOFT_SHEET_FINEST   14      /* halvings of the parameters of a surface */
#define LOFT_SHEET_MEASURED 6       /* halvings of a sheet that may be measured */

/* A piece of a surface: a square of parameters of side 2^-level, so many sides from the start, or a
 * triangle, which is half of one. */
typedef struct {
    uint16_t i, j;
    uint8_t level;
    bool upper;                 /* of a triangle: the half that is farther from the start */
} loft_sheet_piece;

/* Corner k of 4, or of the 3 of a triangle, of which the first one has the right angle: in sides
 * from the start. */
static inline void loft_sheet_piece_corner(const loft_sheet_piece *p, unsigned k, uint32_t at[2])
{
    const uint32_t far = p->upper ? 1 : 0;

    at[0] = p->i + ((k & 1) ^ far);
    at[1] = p->j + ((k >> 1) ^ far);
}

/* Quarter k of 4. Those of a triangle are at its corners, and one in its middle is turned round. */
static inline loft_sheet_piece loft_sheet_piece_quarter(const loft_sheet_piece *p, bool triangle,
                                                        unsigned k)
{
    const bool turned = triangle && k == 3;
    loft_sheet_piece q = *p;
    uint32_t at[2];

    loft_sheet_piece_corner(p, turned ? 0 : k, at);
    q.i = (uint16_t)(p->i + at[0]);
    q.j = (uint16_t)(p->j + at[1]);
    q.level = (uint8_t)(p->level + 1);
    q.upper = p->upper != turned;
    return q;
}

/* Over a piece, corners of its quarters are a grid of 3 x 3: the place in it of corner k of quarter
 * q, and of corner k of the piece. */
static inline unsigned loft_sheet_piece_spot(const loft_sheet_piece *p, const loft_sheet_piece *q,
                                             unsigned k)
{
    uint32_t at[2];

    loft_sheet_piece_corner(q, k, at);
    return (unsigned)(at[0] - 2u * p->i + 3 * (at[1] - 2u * p->j));
}

static inline unsigned loft_sheet_piece_own(const loft_sheet_piece *p, unsigned k)
{
    uint32_t at[2];

    loft_sheet_piece_corner(p, k, at);
    return (unsigned)(2 * (at[0] - p->i) + 6 * (at[1] - p->j));
}

/* A sheet. It borrows the surface. Do not fill it yourself: call one of the functions below. */
typedef struct {
    loft_surface surface;
    loft_box box;               /* around its points, which err by `fuzz` */
    loft_acc bend;              /* of the part */
    loft_acc fuzz;              /* the error of its points, and of those of a part's net */
    loft_sheet_piece part;      /* of the surface */
    uint8_t measured;           /* so many levels of pieces have a gap of their own */
    loft_acc gap[LOFT_SHEET_MEASURED];      /* without `fuzz` */
    bool plane;                 /* the region is one of x and y, otherwise of u and v */
    const loft_region *trim;    /* NULL: all of it */
} loft_sheet;

/* Make a sheet of a surface, which must outlive it.
 *
 *   range   three axes, otherwise LOFT_ERR_ARG; coordinates within LOFT_SHEET_REACH and a bend
 *           below 2^20, otherwise LOFT_ERR_RANGE; *s is then untouched
 *   error   bend: never too small. Polynomials: it is that of the second differences of the net;
 *           rational surfaces: up to R^2 times as large, R the quotient of the largest weight and
 *           the smallest
 *   cost    one pass over the second differences of the net; rational: in numbers of num/sci.h
 *   see     Filip, Magedson, Markot, Surface algorithms using bounds on derivatives (1986)
 */
enum loft_status loft_sheet_from_tensor(loft_sheet *s, const loft_tensor *t) LOFT_CHECKED;
enum loft_status loft_sheet_from_tensor_rational(loft_sheet *s,
                                                 const loft_tensor_rational *t) LOFT_CHECKED;
enum loft_status loft_sheet_from_triangle(loft_sheet *s, const loft_triangle *t) LOFT_CHECKED;
enum loft_status loft_sheet_from_triangle_rational(loft_sheet *s,
                                                   const loft_triangle_rational *t) LOFT_CHECKED;

/* One of the 2^level x 2^level parts of a patch, with a box and a bend of its own: searches in many
 * parts are faster. Its points are those of the whole patch.
 *
 *   range   level 0..LOFT_SHEET_LEVELS, i, j below 2^level, otherwise LOFT_ERR_ARG; as above
 *   error   as above
 *   cost    as above, and the net of the part
 *   stack   Cortex-M4 3,860   Cortex-M0+ 3,896   ATmega328P 3,487
 */
enum loft_status loft_sheet_from_tensor_part(loft_sheet *s, const loft_tensor *t, unsigned level,
                                             unsigned i, unsigned j) LOFT_CHECKED;

/* Measure by points how far pieces are from the hulls of their corners, for bends are bounds and
 * may be many times as large. The box becomes nearer too. Pieces are divided until the bend says
 * `near` or less; where it says so at once, or a point has no value, nothing is done.
 *
 *   range   near > 0
 *   error   gaps: never too small; they approach 4/3 of what pieces need, and `near`
 *   cost    2 * 4^k points of a triangle, 5/3 * 4^k of a square, k the number of levels, at most
 *           LOFT_SHEET_MEASURED
 *   stack   Cortex-M4 1,876   Cortex-M0+ 1,884   ATmega328P 1,755   + callback
 */
void loft_sheet_measure(loft_sheet *s, loft_acc near);

/* No piece of side 2^-level, level >= s->part.level, is farther from the hull of its corners.
 *
 *   error   none
 *   cost    a quotient
 */
static inline loft_acc loft_sheet_gap(const loft_sheet *s, unsigned level)
{
    const unsigned k = level - s->part.level;

    return s->fuzz + (k < s->measured
                          ? s->gap[k]
                          : loft_acc_ratio(s->bend, (int32_t)1 << 2 * k) + loft_acc_ulp(s->bend));
}

/* Trim a sheet to a region of x and y (`plane`), or of the parameters u and v of the surface. What
 * is outside is no longer there. Returns false if nothing is left of it: leave it out then.
 *
 *   shape   the region must outlive *s
 *   range   a region that is valid
 *   error   what is beside the border by less than 2^-14 of the parameters, or in x and y than the
 *           bend of such a part, may count as inside
 *   cost    one loft_region_part_of
 */
bool loft_sheet_trim(loft_sheet *s, const loft_region *r, bool plane);

/* Where a piece of the parameters lies, or one within a box of x and y, of a sheet that may be
 * trimmed.
 *
 *   error   none
 *   cost    loft_region_part_of if it is trimmed
 */
enum loft_region_part loft_sheet_part_of(const loft_sheet *s, const loft_box *box,
                                         const loft_sheet_piece *piece);

LOFT_END_C

#endif
