/* lib/curve/clip.h -- pieces of two Bezier curves, cut to where they can be near each other
 * SPDX-License-Identifier: MIT
 *
 *     loft_piece a, b;
 *     bool       less;
 *     loft_piece_start(&a, &p);
 *     loft_piece_start(&b, &q);
 *     while (loft_piece_clip(&a, &b, gap, &less) && less)
 *         ;
 *
 * Where the curves cross at an angle the pieces shrink as the errors of Newton's method do. curve/
 * intersect.h finds all crossings with it.
 */
#ifndef LOFT_CURVE_CLIP_H
#define LOFT_CURVE_CLIP_H

#include "curve/bezier.h"   /* loft_bezier */
#include "geom/chord.h"     /* loft_chord */

LOFT_BEGIN_C

#define LOFT_PIECE_WHOLE ((uint32_t)1 << 24)

/* The piece from..to, in 2^-24, of a curve. */
typedef struct {
    const loft_bezier *b;
    uint32_t   from, to;
    loft_acc   whole[LOFT_AXES][LOFT_DEGREE_MAX + 1];   /* control points of the curve */
    loft_acc   p[LOFT_AXES][LOFT_DEGREE_MAX + 1];       /* and of the piece            */
    loft_chord chord;                                   /* of the piece                */
    loft_acc   reach;                                   /* its largest component       */
    bool       aimed;                                   /* it has length and direction */
} loft_piece;

/* The whole curve, which is borrowed.
 *
 *   error   none
 *   cost    as loft_piece_cut
 */
void loft_piece_start(loft_piece *x, const loft_bezier *b);

/* Another piece of the curve.
 *
 *   range   from < to <= LOFT_PIECE_WHOLE
 *   error   control points: as loft_bernstein_sub
 *   cost    loft_bernstein_sub per axis
 */
void loft_piece_cut(loft_piece *x, uint32_t from, uint32_t to);

/* loft_chord_aim, once.
 *
 *   error   that of loft_chord_aim
 *   cost    a root and a division per axis
 */
void loft_piece_aim(loft_piece *x);

static inline loft_unit loft_piece_from(const loft_piece *x)
{
    return loft_unit_of(x->from, LOFT_PIECE_WHOLE);
}
static inline loft_unit loft_piece_to(const loft_piece *x)
{
    return loft_unit_of(x->to, LOFT_PIECE_WHOLE);
}

/* The parameter at t of the piece.
 *
 *   error   q16: 2^-25 + 2^-33   f32: 1/2 ulp   f64: 2 ulp of 1
 *   cost    a wide product
 */
loft_unit loft_piece_at(const loft_piece *x, loft_unit t);

/* The smallest and the largest coordinate of the control points.
 *
 *   error   none
 *   cost    two comparisons for each
 */
void loft_piece_range(const loft_piece *x, int axis, loft_acc *low, loft_acc *high);

/* True if the boxes around the control points are further apart than `gap` along an axis.
 *
 *   error   none
 *   cost    two loft_piece_range per axis
 */
bool loft_piece_boxes_apart(const loft_piece *a, const loft_piece *b, loft_acc gap);

/* True if the hulls of the control points are further apart than `gap`, along an axis or the
 * direction between the nearest points of the chords.
 *
 *   error   never true by mistake, but for roundings of control points
 *   cost    3 loft_chord_foot, a root, and a product per control point and axis
 */
bool loft_piece_hulls_apart(loft_piece *a, loft_piece *b, loft_acc gap);

/* Cut off what is not within `gap` of the other piece. Returns false if nothing is left; *less
 * tells whether a quarter of one of them is gone, otherwise they are as before.
 *
 *   range   gap > 0, at least two axes
 *   error   no point of one piece that is within `gap` of the other is cut off, but for roundings
 *           of control points
 *   cost    2 projections of both pieces, at most 6 evaluations of 4 polynomials, 2 loft_piece_cut
 *   stack   Cortex-M4 856   Cortex-M0+ 1,068   ATmega328P 873
 *   see     Sederberg & Nishita, Curve intersection using Bezier clipping, CAD 22 (1990)
 */
bool loft_piece_clip(loft_piece *a, loft_piece *b, loft_acc gap, bool *less) LOFT_CHECKED;

LOFT_END_C

#endif
