/* lib/curve/circle.h -- arcs of circles and ellipses, helices, and their Bezier spans
 * SPDX-License-Identifier: MIT
 *
 * An arc lies in a plane of two axes; all other axes move in proportion to the angle (a helix). It
 * is made from what G-code (centre or radius) or SVG (ends, radii, flags) say, and cut into cubics
 * within a tolerance, or into rational spans, which are circles exactly but for the rounding of
 * their numbers:
 *
 *     loft_circle c;
 *     loft_circle_spans s;
 *     loft_cubic span;
 *     if (loft_circle_from_centre(&c, from, to, LOFT_PLANE_XY, centre, -1) == LOFT_OK &&
 *         loft_circle_spans_init(&s, &c, LOFT_CIRCLE_CUBIC, LOFT_REAL(0.002)) == LOFT_OK)
 *         while (loft_circle_spans_next(&s, &span))
 *             draw(&span);
 *
 * The ends are met exactly. Where the numbers do not describe one circle (two ends at distances
 * from the centre that differ a little), the difference is spread over the arc in proportion to the
 * angle.
 */
#ifndef LOFT_CURVE_CIRCLE_H
#define LOFT_CURVE_CIRCLE_H

#include "curve/bezier.h"       /* loft_cubic */
#include "curve/rational.h"     /* loft_weighted */
#include "num/angle.h"          /* loft_fine: sines */

LOFT_BEGIN_C

#define LOFT_TURNS_MAX 4096

/* The plane of an arc: positive angles turn from `first` to `second`. */
typedef struct {
    uint8_t first, second;
} loft_plane;

#define LOFT_PLANE_XY ((loft_plane) { 0, 1 })       /* G17 */
#define LOFT_PLANE_ZX ((loft_plane) { 2, 0 })       /* G18 */
#define LOFT_PLANE_YZ ((loft_plane) { 1, 2 })       /* G19 */

/* An arc: centre + u cos a + v sin a in the plane, and in all axes drift a / sweep, a = 0 .. sweep.
 * Do not fill it yourself: one of the functions below does. */
typedef struct {
    loft_vec   from, to;
    loft_acc   centre[2], u[2], v[2];
    loft_acc   drift[LOFT_AXES];
    loft_acc   sweep;               /* radians, > 0      */
    loft_acc   radius;              /* the larger one    */
    loft_plane plane;
} loft_circle;


/* Arcs
 * ----
 * `turns` says the direction and how often the arc comes past its end: 1 is up to one turn from the
 * plane's first axis to the second (G3), -1 the other way (G2), -3 two whole turns more. Ends are
 * finite coordinates.
 *
 * Errors of the arc itself, e: q16: 2^-32 of the radius + 2^-30   f32, f64: 2^-48 of the largest
 *                                                                 coordinate or radius
 * and 2^-51 of the arc's length */

/* The arc from..to around a centre, of which only the two coordinates in the plane count. Ends in
 * the same direction from the centre (to 2^-48) are a whole turn.
 *
 *   range   the plane's axes differ and exist, `turns` is not 0 and within +-LOFT_TURNS_MAX, `from`
 *           is not the centre, and the distances of the ends from it differ by no more than 1/256
 *           of the first and 16 LSB, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE for coordinates of
 *           2^400 and above; *c is untouched then
 *   error   e
 *   cost    about 12 sines; 400 bytes of stack
 *   see     NIST RS274/NGC, 3.5.3: center format arc
 */
enum loft_status loft_circle_from_centre(loft_circle *c, loft_vec from, loft_vec to,
                                         loft_plane plane, loft_vec centre,
                                         int32_t turns) LOFT_CHECKED;

/* The arc from..to with a radius; a negative radius means the arc of more than half a turn.
 *
 *   range   as from_centre; `from` is not `to`, and twice the radius reaches from one to the other
 *           but for 1/256, otherwise LOFT_ERR_ARG
 *   error   e, and that of the centre, which is ill defined near half a turn, where it is h = 0
 *           away from the chord's middle: q16: the lesser of 2^-57 r^2 / h and 2^-28 r   f64: of
 *           2^-50 r^2 / h and 2^-25 r
 *   cost    two arc tangents, two sines and two cosines, a root and up to three quotients
 *   see     NIST RS274/NGC, 3.5.3: radius format arc
 */
enum loft_status loft_circle_from_radius(loft_circle *c, loft_vec from, loft_vec to,
                                         loft_plane plane, loft_real radius,
                                         int32_t turns) LOFT_CHECKED;

/* The ellipse of an SVG path: radii along axes that are turned by `degrees`, large arc or small,
 * direction as `turns`, one turn at most. Radii too small to reach are enlarged; signs of radii do
 * not count; a radius of 0 or `from` equal to `to` gives a straight line.
 *
 *   range   as from_centre; LOFT_ERR_RANGE when enlarged radii exceed a coordinate, or degrees
 *           +-16384
 *   error   as from_radius, with the larger radius; near a half turn multiplied by the radii's
 *           ratio
 *   cost    as from_radius, and a sine and a cosine more where the radii differ
 *   see     SVG 1.1, appendix F.6: elliptical arc implementation notes
 */
enum loft_status loft_circle_from_ellipse(loft_circle *c, loft_vec from, loft_vec to,
                                          loft_plane plane, const loft_real radii[2],
                                          loft_real degrees, bool large,
                                          int32_t turns) LOFT_CHECKED;

/* The point after the part t of the sweep.
 *
 *   range   t is clamped to 0..1; LOFT_ERR_RANGE when the point does not fit; *out is untouched
 *           then
 *   error   e and 1/2 LSB (q16) or 1/2 ulp; the ends are exact
 *   cost    a sine and a cosine
 */
enum loft_status loft_circle_eval(const loft_circle *c, loft_unit t, loft_vec *out) LOFT_CHECKED;


/* Spans
 * ----- */

enum loft_circle_kind {
    LOFT_CIRCLE_CUBIC,              /* polynomial, by loft_circle_spans_next */
    LOFT_CIRCLE_CONIC,              /* rational of degree 2, by loft_circle_spans_rational */
    LOFT_CIRCLE_RATIONAL_CUBIC      /* the same curve as rational of degree 3 */
};

/* A point of the arc and its derivative with respect to the angle. */
typedef struct {
    loft_acc p[LOFT_AXES], slope[2];
} loft_circle_place;

/* State of the cutting. The arc is borrowed. Do not rely on the fields. */
typedef struct {
    const loft_circle *circle;
    loft_circle_place at;           /* where the last span ended */
    loft_fine arm, weight, share;   /* of the slope and of the drift that the inner points have, and
                                     * their weight */
    uint32_t  n, next;
    uint8_t   kind;
} loft_circle_spans;

/* Prepare to cut an arc into n equal spans of at most a quarter of a turn that stay within
 * `tolerance` of it, the rounding of their control points included.
 *
 *   shape   s->n spans, as few as the bound needs: with angle h and radius r a cubic errs by
 *           1.82e-5 r h^6, and a span that drifts by d by 2.1e-3 d h^2 (rational: 8.6e-3 d h^2)
 *           more
 *   range   LOFT_ERR_RANGE when a control point does not fit, or the tolerance is not above 3 LSB
 *           (q16: 3 * 2^-16,
 *           f32, f64: 3 ulp of the largest coordinate or radius), or needs more than 2^20 spans
 *   error   none of its own: the tolerance includes all
 *   cost    one pass over the spans, as loft_circle_spans_next
 *   see     Goldapp, Approximation of circular arcs by cubic polynomials, CAGD 8 (1991)
 */
enum loft_status loft_circle_spans_init(loft_circle_spans *s, const loft_circle *c,
                                        enum loft_circle_kind kind,
                                        loft_real tolerance) LOFT_CHECKED;

/* Give the next cubic of an arc that was cut into cubics. False, and *out untouched, when there is
 * none.
 *
 *   error   within the tolerance; the first and the last end are the arc's, neighbours meet exactly
 *   cost    a sine and a cosine, 8 wide products
 */
bool loft_circle_spans_next(loft_circle_spans *s, loft_cubic *out);

/* Give the next rational span, of 3 or 4 control points; the outer weights are 256.
 *
 *   error   as loft_circle_spans_next
 *   cost    as loft_circle_spans_next
 */
bool loft_circle_spans_rational(loft_circle_spans *s, loft_weighted out[]);


/* The unit circle
 * --------------- */

/* 4 (sqrt(2) - 1) / 3: the arm of the cubic (1, 0) (1, l) (l, 1) (0, 1) that touches the quarter
 * circle at its ends and its middle, and nowhere leaves it by more than 2.73e-4.
 *
 *   error   q16: 2^-33   f32, f64: 1 ulp of double
 *   cost    one square root
 */
loft_acc loft_circle_arm(void);

/* The point of that cubic with any arm, and x^2 + y^2 - 1 there.
 *
 *   range   t in 0..1, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE when a result does not fit; nothing
 *           is written then
 *   error   q16: 1/2 LSB + 2^-31 for the point, 1/2 LSB + 2^-28 (1 + |arm|) for the excess
 *           f32, f64: 1/2 ulp + 2^-49 (1 + |arm|), + 2^-48 (1 + arm^2)
 *   cost    about 12 products, of 64 bits in q16
 *   see     Goldapp; the excess is b^2 (2 (3 l - 2)^2 (t - 1/2)^2 + 8 (1 + 3 l / 4)^2 - 16), b = t
 *           (1 - t)
 */
enum loft_status loft_circle_quarter(loft_acc arm, loft_unit t, loft_real point[2],
                                     loft_real *excess) LOFT_CHECKED;

/* The arc from the angle theta over the top to pi - theta as one rational cubic of weights 1, w, w,
 * 1: the distance of the inner control points from the outer ones, and w.
 *
 *   range   -pi/6 < theta < pi/2, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE when the distance does not
 *           fit; nothing is written then
 *   error   q16: 1/2 LSB + 2^-56 distance^2   f32, f64: 1/2 ulp + 2^-50 (1 + distance^2)
 *   cost    a sine, a cosine and two quotients
 *   see     Farin, Curves and Surfaces for CAGD, ch. 12: conics, degree elevated
 */
enum loft_status loft_circle_over(loft_real theta, loft_real *distance,
                                  loft_real *weight) LOFT_CHECKED;

/* The point of that arc at t.
 *
 *   range   as loft_circle_over, and t in 0..1, otherwise LOFT_ERR_ARG
 *   error   q16: 1/2 LSB + 2^-32   f32, f64: 1/2 ulp + 2^-50
 *   cost    a sine, a cosine, 4 products and two quotients
 */
enum loft_status loft_circle_over_eval(loft_real theta, loft_unit t,
                                       loft_real point[2]) LOFT_CHECKED;

LOFT_END_C

#endif
