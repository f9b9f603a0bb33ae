/* tests/vectors/vectors_sheet.h -- a whole CSV at hand: the nets and polygons that rows of other
 * CSVs refer to
 * SPDX-License-Identifier: MIT
 *
 * Numbers are exact decimals. Where a number type cannot hold one it is rounded, and the row's
 * `inexact` says by how much.
 */
#ifndef LOFT_TESTS_VECTORS_SHEET_H
#define LOFT_TESTS_VECTORS_SHEET_H

#include "vectors/vectors.h"                /* row */

#define SHEET_COLUMNS 20

typedef struct {
    char name[64], *(*field)[SHEET_COLUMNS];
    unsigned rows;
} sheet;

/* The CSV `name` beside the row's own, without its comments; the row complains when there is
 * none. */
const sheet *sheet_of(row *r, const char *name);

/* An exact decimal, as a coordinate and as a parameter. */
loft_real   decimal_real(row *r, const char *text);
loft_unit   decimal_unit(row *r, const char *text);
long double decimal(row *r, const char *text);

/* Whole numbers separated by blanks; how many. */
unsigned wholes(const char *text, int out[], unsigned most);

/* Compare a wide value, or a point, with columns of one number each. */
void expect_wide(row *r, const char *column, loft_acc x, law l);
void expect_point(row *r, enum loft_status status, loft_vec v, law l);        /* columns X, Y, Z */

#endif
