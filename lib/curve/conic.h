/* lib/curve/conic.h -- what conic a rational quadratic Bezier curve is part of, and its axes
 * SPDX-License-Identifier: MIT
 *
 * Weights may be any numbers here, also 0 and negative: p[0] to p[2] with the weights 1, -1/2, 1 is
 * the other part of an ellipse, and a weight of 0 makes a line. Decisions are exact.
 *
 *     loft_conic c;
 *     if (loft_conic_init(&c, p) == LOFT_OK && c.kind == LOFT_CONIC_ELLIPSE)
 *         status = loft_conic_axes(p, &centre, axes);
 *
 * Coordinates are the first two; others do not count.
 */
#ifndef LOFT_CURVE_CONIC_H
#define LOFT_CURVE_CONIC_H

#include "curve/rational.h"     /* loft_weighted */

LOFT_BEGIN_C

enum loft_conic_kind {
    LOFT_CONIC_ELLIPSE,
    LOFT_CONIC_PARABOLA,
    LOFT_CONIC_HYPERBOLA,
    LOFT_CONIC_LINE,            /* the three weighted points are dependent                  */
    LOFT_CONIC_POINT,           /* those whose weight is not 0 coincide                     */
    LOFT_CONIC_NULL             /* all weights are 0: there is no curve                     */
};

typedef struct {
    enum loft_conic_kind kind;
    bool finite;                /* the denominator has no zero in 0..1                      */
    bool circle;
} loft_conic;

/* Decide.
 *
 *   range   f32, f64: numbers that pass loft_exact_valid, otherwise LOFT_ERR_RANGE; *out is then
 *           untouched
 *   error   none
 *   cost    about 30 exact products
 *   see     Chang, Mathematics of Surfaces, 4.4: w1^2 against w0 w2; Lee, The rational Bezier
 *           representation for conics (1987)
 */
enum loft_status loft_conic_init(loft_conic *out, const loft_weighted p[3]) LOFT_CHECKED;

/* The centre and the semi-axes of an ellipse (the larger first) or a hyperbola (the transverse one
 * first).
 *
 *   range   an ellipse or a hyperbola, otherwise LOFT_SINGULAR; LOFT_ERR_RANGE as above and if a
 *           result does not fit; the results are then untouched
 *   error   with e = 2^-52 (q16), 2^-44 (f32, f64), s = |w0 w2| / |w0 w2 - w1^2| and L the largest
 *           coordinate: centre q16: 1/2 LSB + 2^-17 LSB   f32: 1/2 ulp   f64: 1 ulp; and e s L
 *           axes: as the centre, with s L^2 (1 + s) over the smaller axis in place of s L
 *   cost    as loft_conic_init, and in numbers of num/sci.h 40 products, 8 quotients and 3 roots
 *   see     Lee (1987): conjugate diameters; eigenvalues of order 2
 */
enum loft_status loft_conic_axes(const loft_weighted p[3], loft_vec *centre,
                                 loft_real axes[2]) LOFT_CHECKED;

/* The foci: two of an ellipse or a hyperbola, the centre twice of a circle, one of a parabola.
 *
 *   range   as loft_conic_axes, and a parabola; LOFT_ERR_ARG with fewer than two axes; the results
 *           are untouched after an error. Further axes are 0
 *   error   with s and e as there, c half the distance of the foci, L the largest coordinate: q16:
 *           1/2 LSB + 2^-17 LSB   f32: 1/2 ulp   f64: 1 ulp; and 8 e s L (1 + s L / c), at most 4
 *           sqrt(e) s L. A parabola: 8 e |a| |b| (|a| + |b|) / |a + b|^2, a and b the legs from its
 *           middle point
 *   cost    as loft_conic_init, and in numbers of num/sci.h 25 products, 3 quotients and 3 roots
 *   see     Salmon, Conic Sections: foci are where two tangents of slope i and -i meet
 */
enum loft_status loft_conic_foci(const loft_weighted p[3], loft_vec focus[2],
                                 unsigned *count) LOFT_CHECKED;

/* Decide exactly whether this rational cubic is a conic. Then out[3] is the rational quadratic,
 * with the weights of both ends.
 *
 *   range   LOFT_SINGULAR if it is not, and where the middle weight is 0; LOFT_ERR_RANGE as
 *           loft_conic_init and if the middle point does not fit; *out is then untouched
 *   error   decision: none   middle point: q16: 1/2 LSB + 2^-17 LSB   f32: 1/2 ulp   f64: 8 ulp of
 *           the largest control value, times (|w0| + 3 |w1|) / |3 w1 - w0|
 *           its weight: q16: 1/2 LSB   f32, f64: 2 ulp
 *   cost    per axis 4 exact products, and a quotient of num/sci.h
 *   see     Chang, 4.3 and 4.4
 */
enum loft_status loft_conic_from_cubic(const loft_weighted p[4], loft_weighted out[3]) LOFT_CHECKED;

/* The same for the first half of the cubic, t = 0..1/2: for a curve whose middle weight is 0, such
 * as a half circle with the weights 3 1 1 3. The conic is the same one.
 *
 *   range   as above; LOFT_SINGULAR where w0 + 3 w1 or 3 w1 + w3 is 0
 *   error   as above, for both points, times (|w0| + 3 |w1|) / |w0 + 3 w1| and (3 |w1| + |w3|) /
 *           |3 w1 + w3|
 *   cost    as above, with two quotients
 *   see     as above
 */
enum loft_status loft_conic_from_half_cubic(const loft_weighted p[4],
                                            loft_weighted out[3]) LOFT_CHECKED;

LOFT_END_C

#endif
