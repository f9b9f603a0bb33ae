/* lib/curve/circle.h -- arcs of circles and ellipses, helices, and their Bezier spans
 * SPDX-License-Identifier: MIT
 *
 * An arc lies in a plane of two axes; all other axes move in proportion to the angle (a helix). It
 * is made from the data of G-code (centre or radius) or SVG (ends, radii, flags). It is then cut
 * into cubics within a tolerance, or into rational spans, which are exact circles except for the
 * rounding of their numbers:
 *
 *     loft_circle c;
 *     loft_circle_spans s;
 *     loft_cubic span;
 *     if (loft_circle_from_centre(&c, from, to, LOFT_PLANE_XY, centre, -1) == LOFT_OK &&
 *         loft_circle_spans_init(&s, &c, LOFT_CIRCLE_CUBIC, LOFT_REAL(0.002)) == LOFT_OK)
 *         while (loft_circle_spans_next(&s, &span))
 *             draw(&span);
 *
 * The ends are exact. If the numbers do not describe one circle (the ends have slightly different
 * distances from the centre), the difference is spread over the arc in proportion to the angle.
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
 * Do not fill it yourself: call one of the functions below. */
typedef struct {
    loft_vec   from, to;
    loft_acc   centre[2], u[2], v[2];
    loft_acc   drift[LOFT_AXES];
    loft_acc   sweep;               /* radians, > 0      */
    loft_acc   radius;              /* the larger one    */
    loft_plane plane;
} loft_circle;


/* Arcs ---- `turns` gives the direction and the number of turns: 1 is up to one turn from the
 * plane's first axis to the second (G3), -1 the other way (G2), -3 two more whole turns. Ends are
 * finite coordinates.
 *
 * The error e of the arc itself is 2^-51 of its length plus
 *
 *     q16: 2^-32 of the radius + 2^-30   f32, f64: 2^-48 of the largest coordinate or radius */

/* The arc from..to around a centre; only the two coordinates of the centre in the plane are used.
 * Ends in the same direction from the centre (to 2^-48) give a whole turn.
 *
 *   range   the plane's axes differ and exist, `turns` is not 0 and within +-LOFT_TURNS_MAX, `from`
 *           is not the centre, and the distances of the ends from it differ by at most 1/256 of the
 *           first + 16 LSB, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE for coordinates of 2^400 and
 *           above. *c is untouched after an error
 *   error   e
 *   cost    about 12 sines
 *   stack   Cortex-M4 320   Cortex-M0+ 444   ATmega328P 398
 *   see     NIST RS274/NGC, 3.5.3: center format arc
 */
enum loft_status loft_circle_from_centre(loft_circle *c, loft_vec from, loft_vec to,
                                         loft_plane plane, loft_vec centre,
                                         int32_t turns) LOFT_CHECKED;

/* The arc from..to with a radius; a negative radius selects the arc of more than half a turn.
 *
 *   range   as from_centre; `from` is not `to`, and twice the radius is at least their distance (to
 *           1/256), otherwise LOFT_ERR_ARG
 *   error   e, and that of the centre, which is ill defined near half a turn. With h its distance
 *           from the middle of the chord:
 *           q16: the smaller of 2^-57 r^2 / h and 2^-28 r   f64: of 2^-50 r^2 / h and 2^-25 r
 *   cost    two arc tangents, two sines and two cosines, a root and up to three quotients
 *   see     NIST RS274/NGC, 3.5.3: radius format arc
 */
enum loft_status loft_circle_from_radius(loft_circle *c, loft_vec from, loft_vec to,
                                         loft_plane plane, loft_real radius,
                                         int32_t turns) LOFT_CHECKED;

/* The ellipse of an SVG path: radii along axes rotated by `degrees`, large or small arc, direction
 * as `turns`, at most one turn. Radii that are too small are enlarged, and their signs are ignored.
 * A radius of 0 or `from` equal to `to` gives a straight line.
 *
 *   range   as from_centre; LOFT_ERR_RANGE if enlarged radii exceed a coordinate, or degrees
 *           +-16384
 *   error   as from_radius, with the larger radius; near a half turn multiplied by the radii's
 *           ratio
 *   cost    as from_radius, and one more sine and cosine if the radii differ
 *   see     SVG 1.1, appendix F.6: elliptical arc implementation notes
 */
enum loft_status loft_circle_from_ellipse(loft_circle *c, loft_vec from, loft_vec to,
                                          loft_plane plane, const loft_real radii[2],
                                          loft_real degrees, bool large,
                                          int32_t turns) LOFT_CHECKED;

/* The point at the fraction t of the sweep.
 *
 *   range   t is clamped to 0..1; LOFT_ERR_RANGE if the point does not fit. *out is untouched then
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

/* State of the subdivision. The arc is borrowed. Do not rely on the fields. */
typedef struct {
    const loft_circle *circle;
    loft_circle_place at;           /* where the last span ended */
    loft_fine arm, weight, share;   /* the fractions of the slope and of the drift that the inner
                                     * points add, and their weight */
    uint32_t  n, next;
    uint8_t   kind;
} loft_circle_spans;

/* Prepare to cut an arc into n equal spans of at most a quarter turn that stay within `tolerance`
 * of it, including the rounding of their control points.
 *
 *   shape   s->n spans, the smallest number that the bound permits. With angle h and radius r the
 *           error of a cubic is 1.82e-5 r h^6; a span with drift d adds 2.1e-3 d h^2 (rational:
 *           8.6e-3 d h^2)
 *   range   LOFT_ERR_RANGE if a control point does not fit, if the tolerance is not above 3 LSB (3
 *           * 2^-16 in q16, 3 ulp of the largest coordinate or radius in f32 and f64), or if it
 *           needs more than 2^20 spans
 *   error   none of its own: the tolerance includes all
 *   cost    one pass over the spans, as loft_circle_spans_next
 *   see     Goldapp, Approximation of circular arcs by cubic polynomials, CAGD 8 (1991)
 */
enum loft_status loft_circle_spans_init(loft_circle_spans *s, const loft_circle *c,
                                        enum loft_circle_kind kind,
                                        loft_real tolerance) LOFT_CHECKED;

/* Get the next cubic of an arc that was cut into cubics. Returns false, and leaves *out untouched,
 * if there is none.
 *
 *   error   within the tolerance; the first and the last end are those of the arc, and neighbours
 *           meet exactly
 *   cost    a sine and a cosine, 8 wide products
 */
bool loft_circle_spans_next(loft_circle_spans *s, loft_cubic *out);

/* Get the next rational span, of 3 or 4 control points; the outer weights are 256.
 *
 *   error   as loft_circle_spans_next
 *   cost    as loft_circle_spans_next
 */
bool loft_circle_spans_rational(loft_circle_spans *s, loft_weighted out[]);


/* The unit circle
 * --------------- */

/* 4 (sqrt(2) - 1) / 3: the arm l of the cubic (1, 0) (1, l) (l, 1) (0, 1) that touches the quarter
 * circle at its ends and its middle. It deviates from it by at most 2.73e-4.
 *
 *   error   q16: 2^-33   f32, f64: 1 ulp of double
 *   cost    one square root
 */
loft_acc loft_circle_arm(void);

/* The point of that cubic with any arm, and x^2 + y^2 - 1 there.
 *
 *   range   t in 0..1, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if a result does not fit. Nothing is
 *           written after an error
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
 *   range   -pi/6 < theta < pi/2, otherwise LOFT_ERR_ARG; LOFT_ERR_RANGE if the distance does not
 *           fit. Nothing is written after an error
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
