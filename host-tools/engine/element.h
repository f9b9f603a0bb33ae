/* host-tools/engine/element.h -- the curves of files as a list of polynomial pieces, for what
 * measures them
 * SPDX-License-Identifier: MIT
 *
 * A piece with weights becomes cubics within a hundredth of the tolerance, or, where the number
 * type cannot, within half of it; all others are what the library makes of them in the number type
 * of the engine. An element knows the curve it is of, and which parameter of that curve a place on
 * it is.
 */
#ifndef LOFT_ELEMENT_H
#define LOFT_ELEMENT_H

#include "engine/curve.h"
#include "engine/engine.h"
#include "engine/piece.h"
#include "engine/reference.h"

typedef struct {
    const char *file;
    const curve *of;
    size_t number;          /* of the curve, over all files                          */
    double from, to;        /* its parameters, if it is polynomial; of the whole piece if not */
    bool exact;             /* polynomial, not a cubic near a piece with weights     */
    piece p;                /* polynomial                                            */
    piece whole;            /* the piece it is of                                    */
    double box[2][CURVE_AXES];  /* of its control points */
} element;

typedef struct {
    element *element;
    size_t count, curves;
    bool solid;
} elements;

/* Append the curves of a file. Gives 0 or an exit code after printing one line. `all` must outlive
 * the list. */
int  elements_add(elements *list, const engine *e, const curves *all, const char *file, double tol);
void elements_free(elements *list);

/* The parameter of the curve at t in 0..1 of the element, whose point there is `point`. */
double element_parameter(const element *x, double t, const double point[CURVE_AXES]);

/* Move what the engine found nearest to `from` along the curve by its definition, to the foot:
 * where the distance is least near there. t becomes the parameter of the curve, `range` that of all
 * of it; point and distance follow. */
void element_settle(const element *x, const reference *r, const double range[2],
                    const double from[CURVE_AXES], engine_near *n);

/* Print `what: remedy` about the curve of x, as an error of data. */
int element_error(const element *x, const char *words);

#endif
