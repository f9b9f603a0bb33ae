/* host-tools/geometry/element.h -- the curves of files as a list of polynomial pieces, for
 * measuring
 * SPDX-License-Identifier: MIT
 *
 * A piece with weights becomes cubics within a hundredth of the tolerance, or, if the number type
 * cannot do that, within half of it. The library converts all other pieces in the number type of
 * the engine. An element knows its curve, and maps its own parameter to that of the curve.
 */
#ifndef LOFT_ELEMENT_H
#define LOFT_ELEMENT_H

#include "engine/curve.h"
#include "engine/engine.h"
#include "engine/piece.h"
#include "geometry/reference.h"

struct host;                /* base/host.h */

typedef struct {
    const char *file;
    const curve *of;
    size_t number;          /* of the curve, over all files                          */
    double from, to;        /* its parameters, if it is polynomial; otherwise those of the whole
                             * piece */
    bool exact;             /* polynomial, not a cubic that approximates a piece with weights */
    piece p;                /* polynomial                                            */
    piece whole;            /* the piece that it belongs to */
    double box[2][CURVE_AXES];  /* of its control points */
} element;

typedef struct {
    element *element;
    size_t count, curves;
    bool solid;
} elements;

/* Append the curves of a file. Returns 0, or an exit code after printing one line. `all` must
 * outlive the list. */
int elements_add(struct host *h, elements *list, const engine *e, const curves *all,
                 const char *file, double tol);
void elements_free(elements *list);

/* The parameter of the curve at t in 0..1 of the element; `point` is the point there. */
double element_parameter(const element *x, double t, const double point[CURVE_AXES]);

/* Move the nearest point that the engine found to the true foot of `from`: the place of smallest
 * distance nearby, on the curve by its definition. t becomes the parameter of the curve, and
 * `range` is the whole range of that parameter; point and distance are updated. */
void element_settle(const element *x, const reference *r, const double range[2],
                    const double from[CURVE_AXES], engine_near *n);

/* Print `what: remedy` about the curve of x, as a data error. */
int element_error(struct host *h, const element *x, const char *words);

#endif
