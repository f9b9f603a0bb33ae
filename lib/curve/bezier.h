/* lib/curve/bezier.h -- Bezier curves of degree 0..9: points, derivatives, pieces
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_CURVE_BEZIER_H
#define LOFT_CURVE_BEZIER_H

#include "geom/vec.h"   /* loft_vec, loft_box */

#define LOFT_DEGREE_MAX 9

/* A cubic, by value: what motion is planned along and what flattening cuts. */
typedef struct {
    loft_vec p[4];
} loft_cubic;

/* A curve of any degree. The control points are borrowed. Do not fill it yourself: call init. */
typedef struct {
    const loft_vec *p;
    uint8_t degree;
} loft_bezier;

enum loft_status loft_bezier_init(loft_bezier *b, const loft_vec p[], unsigned degree) LOFT_CHECKED;
loft_vec         loft_bezier_eval(const loft_bezier *b, loft_unit t);
enum loft_status loft_bezier_extend(const loft_bezier *b, loft_unit t, loft_vec *out) LOFT_CHECKED;
enum loft_status loft_bezier_deriv(const loft_bezier *b, unsigned k, loft_unit t, loft_vec *out) LOFT_CHECKED;
enum loft_status loft_bezier_split(const loft_bezier *b, loft_unit t, loft_vec left[], loft_vec right[]) LOFT_CHECKED;
enum loft_status loft_bezier_part(const loft_bezier *b, loft_unit from, loft_unit to, loft_vec out[]) LOFT_CHECKED;
enum loft_status loft_bezier_raise(const loft_bezier *b, unsigned times, loft_vec out[]) LOFT_CHECKED;
loft_box         loft_bezier_box(const loft_bezier *b);

loft_vec   loft_cubic_eval(const loft_cubic *c, loft_unit t);
loft_cubic loft_cubic_part(const loft_cubic *c, loft_unit from, loft_unit to);
void       loft_cubic_split(const loft_cubic *c, loft_unit t, loft_cubic *left, loft_cubic *right);

#endif
