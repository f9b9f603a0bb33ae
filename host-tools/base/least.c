/* host-tools/base/least.c
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/least.h"
#include "base/memory.h"    /* memory_grow */

typedef struct {
    long double *at, scale, square;     /* its entries; its scale factor; the squared length of what
                                         * is left of it */
    size_t place;
} column;

static long double dot(const long double a[], const long double b[], size_t from, size_t to)
{
    long double sum = 0;

    for (size_t r = from; r < to; r++)
        sum += a[r] * b[r];
    return sum;
}

static void scale_columns(column c[], size_t columns, size_t rows)
{
    for (size_t k = 0; k < columns; k++) {
        long double most = 0;
        for (size_t r = 0; r < rows; r++)
            most = fmaxl(most, fabsl(c[k].at[r]));
        c[k].scale = most > 0 ? 1 / most : 1;
        for (size_t r = 0; r < rows; r++)
            c[k].at[r] *= c[k].scale;
        c[k].square = dot(c[k].at, c[k].at, 0, rows);
    }
}

/* Move the longest column to place k. */
static void choose(column c[], size_t k, size_t columns)
{
    size_t best = k;

    for (size_t q = k + 1; q < columns; q++)
        if (c[q].square > c[best].square)
            best = q;
    const column chosen = c[best];
    c[best] = c[k];
    c[k] = chosen;
}

/* Apply the reflection that leaves column k with one entry to all later columns. Returns that
 * entry. */
static long double reflect(column c[], size_t k, size_t columns, size_t all, size_t rows)
{
    const long double length = sqrtl(dot(c[k].at, c[k].at, k, rows)),
                      entry = c[k].at[k] > 0 ? -length : length;
    /* of the square of the reflection's vector */
    const long double half = length * length - c[k].at[k] * entry;

    c[k].at[k] -= entry;
    for (size_t q = k + 1; q < all; q++) {
        const long double share = dot(c[k].at, c[q].at, k, rows) / half;
        for (size_t r = k; r < rows; r++)
            c[q].at[r] -= share * c[k].at[r];
        if (q < columns)
            c[q].square = dot(c[q].at, c[q].at, k + 1, rows);
    }
    return entry;
}

size_t least_squares(long double a[], size_t rows, size_t columns, size_t rights, long double share,
                     long double x[])
{
    const size_t all = columns + rights;
    column *c = memory_grow(NULL, all * sizeof *c);
    long double *diagonal = memory_grow(NULL, columns * sizeof *diagonal),
                *y = memory_grow(NULL, columns * sizeof *y);
    size_t rank = 0;

    for (size_t k = 0; k < all; k++)
        c[k] = (column){ a + k * rows, 1, 0, k };
    scale_columns(c, columns, rows);
    for (; rank < columns && rank < rows; rank++) {
        choose(c, rank, columns);
        if (!(sqrtl(c[rank].square) > (rank > 0 ? share * fabsl(diagonal[0]) : 0)))
            break;
        diagonal[rank] = reflect(c, rank, columns, all, rows);
    }

    memset(x, 0, rights * columns * sizeof *x);
    for (size_t i = 0; i < rights; i++) {
        for (size_t k = rank; k-- > 0;) {
            long double sum = c[columns + i].at[k];
            for (size_t m = k + 1; m < rank; m++)
                sum -= c[m].at[k] * y[m];
            y[k] = sum / diagonal[k];
        }
        for (size_t k = 0; k < rank; k++)
            x[i * columns + c[k].place] = y[k] * c[k].scale;
    }
    free(c);
    free(diagonal);
    free(y);
    return rank;
}
