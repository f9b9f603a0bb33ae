/* lib/basis/copositive.c
 * SPDX-License-Identifier: MIT
 *
 * Hadeler's theorem: let all principal submatrices of one order less be copositive. Then the matrix
 * is not copositive exactly if its determinant is negative and no entry of its adjugate is. Applied
 * from order 1 upwards (where the adjugate is 1): M is copositive if no principal submatrix is such
 * a witness.
 *
 * Range: entries have R bits (31, in floats 128). A determinant of order 4 is a sum of 24 products
 * of four factors, below 2^(4 R + 4.6): 129 and 517 bits, within LOFT_EXACT_BITS.
 */
#include "basis/copositive.h"
#include "num/exact.h"          /* loft_exact: the decisions */

/* A principal submatrix: rows and columns at[0..n-1] of the matrix. */
typedef struct {
    const loft_real *m;
    uint8_t whole, n;
    uint8_t at[LOFT_COPOSITIVE_MAX];
} minor;

/* Row and column i <= j of the upper triangle. Row i follows i rows of whole, whole - 1, ..
 * entries. */
static loft_exact entry(const minor *a, uint8_t row, uint8_t column)
{
    const uint8_t i = row < column ? row : column, j = row < column ? column : row;

    return loft_exact_from_real(a->m[i * a->whole - i * (i + 1) / 2 + j]);
}

static loft_exact det2(const minor *a, const uint8_t row[2], const uint8_t column[2])
{
    return loft_exact_det(entry(a, row[0], column[0]), entry(a, row[0], column[1]),
                          entry(a, row[1], column[0]), entry(a, row[1], column[1]));
}

/* Expansion by the first row. */
static loft_exact det3(const minor *a, const uint8_t row[3], const uint8_t column[3])
{
    loft_exact sum = loft_exact_from_int(0);

    for (int c = 0; c < 3; c++) {
        /* in cyclic order: no sign needed */
        const uint8_t others[2] = { column[(c + 1) % 3], column[(c + 2) % 3] };
        sum = loft_exact_add(sum,
                             loft_exact_mul(entry(a, row[0], column[c]), det2(a, row + 1, others)));
    }
    return sum;
}

/* All indices except the one at `without`. */
static void others(const minor *a, unsigned without, uint8_t out[])
{
    unsigned k = 0;

    for (unsigned i = 0; i < a->n; i++)
        if (i != without)
            out[k++] = a->at[i];
}

static loft_exact cofactor(const minor *a, unsigned i, unsigned j)
{
    uint8_t row[LOFT_COPOSITIVE_MAX] = { 0 }, column[LOFT_COPOSITIVE_MAX] = { 0 };

    others(a, i, row);
    others(a, j, column);
    const loft_exact d = a->n == 1   ? loft_exact_from_int(1)
                         : a->n == 2 ? entry(a, row[0], column[0])
                         : a->n == 3 ? det2(a, row, column)
                                     : det3(a, row, column);
    return (i + j) % 2 ? loft_exact_neg(d) : d;
}

static int determinant_sign(const minor *a)
{
    loft_exact sum = loft_exact_from_int(0);

    for (unsigned j = 0; j < a->n; j++)
        sum = loft_exact_add(sum, loft_exact_mul(entry(a, a->at[0], a->at[j]), cofactor(a, 0, j)));
    return loft_exact_sign(sum);
}

/* Does this submatrix show that the matrix is not copositive? */
static bool is_witness(const minor *a)
{
    if (determinant_sign(a) >= 0)
        return false;
    for (unsigned i = 0; i < a->n; i++)
        for (unsigned j = i; j < a->n; j++)
            if (loft_exact_sign(cofactor(a, i, j)) < 0)
                return false;
    return true;
}

enum loft_status loft_matrix_copositive(const loft_real m[], unsigned n, bool *copositive)
{
    bool witness = false;

    if (n < 1 || n > LOFT_COPOSITIVE_MAX)
        return LOFT_ERR_ARG;
    for (unsigned k = 0; k < n * (n + 1) / 2; k++)
        if (!loft_exact_valid(m[k]))
            return LOFT_ERR_RANGE;
    for (unsigned set = 1; set < 1u << n && !witness; set++) {
        minor a = { m, (uint8_t)n, 0, { 0 } };
        for (uint8_t i = 0; i < n; i++)
            if (set >> i & 1u)
                a.at[a.n++] = i;
        witness = is_witness(&a);
    }
    *copositive = !witness;
    return LOFT_OK;
}
