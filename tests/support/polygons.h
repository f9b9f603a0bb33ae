/* tests/support/polygons.h -- polygons of CSV files, and the coordinates that a letter names
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_POLYGONS_H
#define LOFT_TESTS_POLYGONS_H

#include "vectors/vectors_sheet.h"          /* sheet_of, decimal_real */
#include "polygon/domain.h"
#include "polygon/jet.h"
#include "support/solved.h"                 /* solved: harmonic coordinates */

typedef struct {
    loft_spot v[LOFT_SIDES_MAX];
    loft_domain d;
    unsigned n;
    const char *kind;
} polygon;

/* The polygon of polygons.csv with that name. Returns false, with a message, if there is none or if
 * it was refused. */
bool polygon_of(row *r, const char *id, polygon *p);

/* The point in columns x and y. */
loft_spot spot_of(row *r);

/* phi by Wachspress (W), mean values (M) or harmonic functions (H). Returns false if the library
 * has none of that name there. */
bool coordinates(row *r, char which, const polygon *p, loft_spot at, loft_sci phi[]);

/* The same with derivatives. Returns false, with a message, if there are none. */
bool coordinate_jets(row *r, char which, const polygon *p, loft_spot at, loft_jet phi[]);

/* Harmonic coordinates of a polygon, solved on the first request, with their error bound including
 * rounding. */
const solved *solution_of(const polygon *p);
long double   solution_error(const solved *s);

/* The place of the point agrees with the row's column `type`. */
void expect_place(row *r, const polygon *p, loft_spot at);

#endif
