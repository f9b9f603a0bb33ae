/* host-tools/base/least_damped.c
 * SPDX-License-Identifier: MIT
 *
 * Reflections are applied to some columns at a time, which stay in the cache. Column k's damping
 * stands below the matrix in row rows + k, so that reflection k is about rows k to rows + k.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/least.h"
#include "base/memory.h"    /* memory_grow */

#define BLOCK 8     /* columns */

typedef struct {
    double *a, *half;       /* columns; half the squares of the reflections' vectors */
    size_t height, reach;   /* of a column, of a vector                              */
} matrix;

/* Four sums at a time: each waits for its own last addition only. */
static double dot(const double *a, const double *b, size_t count)
{
    double sum[4] = { 0 };
    size_t r = 0;

    for (; r + 4 <= count; r += 4)
        for (size_t k = 0; k < 4; k++)
            sum[k] += a[r + k] * b[r + k];
    for (; r < count; r++)
        sum[0] += a[r] * b[r];
    return sum[0] + sum[1] + (sum[2] + sum[3]);
}

static void subtract(double *a, double share, const double *b, size_t count)
{
    size_t r = 0;

    for (; r + 4 <= count; r += 4)
        for (size_t k = 0; k < 4; k++)
            a[r + k] -= share * b[r + k];
    for (; r < count; r++)
        a[r] -= share * b[r];
}

static void reflect(const matrix *m, size_t k, size_t q)
{
    const double *v = m->a + k * m->height + k;
    double *c = m->a + q * m->height + k;

    subtract(c, dot(v, c, m->reach) / m->half[k], v, m->reach);
}

/* Make the reflection that leaves column k with one entry. Returns that entry. */
static double reflection(const matrix *m, size_t k)
{
    double *v = m->a + k * m->height + k;
    const double square = dot(v, v, m->reach), entry = v[0] > 0 ? -sqrt(square) : sqrt(square);

    m->half[k] = square - v[0] * entry;
    v[0] -= entry;
    return entry;
}

/* Scale a column to a largest entry of 1. Gives the factor. */
static double scale_column(double *a, size_t rows)
{
    double most = 0;

    for (size_t r = 0; r < rows; r++)
        most = fmax(most, fabs(a[r]));
    if (!(most > 0))
        return 1;
    for (size_t r = 0; r < rows; r++)
        a[r] /= most;
    return 1 / most;
}

void least_damped(double a[], size_t rows, size_t columns, size_t rights, double damping,
                  double x[])
{
    const size_t all = columns + rights;
    double *scale = memory_grow(NULL, 3 * columns * sizeof *scale), *diagonal = scale + columns;
    const matrix m = { a, diagonal + columns, rows + columns, rows + 1 };

    for (size_t k = 0; k < columns; k++) {
        scale[k] = scale_column(a + k * m.height, rows);
        a[k * m.height + rows + k] = damping * scale[k];
    }
    for (size_t first = 0; first < all; first += BLOCK) {
        const size_t end = first + BLOCK < all ? first + BLOCK : all;
        for (size_t k = 0; k < first && k < columns; k++)
            for (size_t q = first; q < end; q++)
                reflect(&m, k, q);
        for (size_t k = first; k < end && k < columns; k++) {
            diagonal[k] = reflection(&m, k);
            for (size_t q = k + 1; q < end; q++)
                reflect(&m, k, q);
        }
    }
    for (size_t i = 0; i < rights; i++) {
        double *y = a + (columns + i) * m.height;
        for (size_t k = columns; k-- > 0;) {
            y[k] /= diagonal[k];
            subtract(y, y[k], a + k * m.height, k);
            x[i * columns + k] = y[k] * scale[k];
        }
    }
    free(scale);
}
