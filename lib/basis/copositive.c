/* lib/basis/copositive.c
 * SPDX-License-Identifier: MIT
 *
 * Hadeler's theorem: let all principal submatrices of one order less be copositive. Then the matrix
 * is not copositive exactly if its determinant is negative and no entry of its adjugate is. Applied
 * from order 1 upwards (where the adjugate is 1): M is copositive if no principal submatrix is such
 * a witness.
 *
 * Range: entries have R bits (31, in floats 128). A determinant of order 6 is a sum of 720 products
 * of six factors, below 2^(6 R + 9.5): 196 and 778 bits, within LOFT_EXACT_BITS.
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

/* The determinant of `n` rows and columns: those of the first rows with each set of columns, from
 * the empty set up, expanded by their last row. */
static loft_exact determinant(const minor *a, unsigned n, const uint8_t row[],
                              const uint8_t column[])
{
    loft_exact part[1 << LOFT_COPOSITIVE_MAX];

    part[0] = loft_exact_from_int(1);
    for (unsigned set = 1; set < 1u << n; set++) {
        unsigned size = 0, behind = 0;
        for (unsigned c = 0; c < n; c++)
            size += set >> c & 1u;
        part[set] = loft_exact_from_int(0);
        for (unsigned c = n; c-- > 0; ) {
            if (!(set >> c & 1u))
                continue;
            const loft_exact term = loft_exact_mul(part[set ^ 1u << c],
                                                   entry(a, row[size - 1], column[c]));
            part[set] = behind++ % 2 ? loft_exact_sub(part[set], term)
                                     : loft_exact_add(part[set], term);
        }
    }
    return part[(1u << n) - 1];
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
    const loft_exact d = determinant(a, a->n - 1u, row, column);
    return (i + j) % 2 ? loft_exact_neg(d) : d;
}

/* True if this submatrix shows that the matrix is not copositive. */
static bool is_witness(const minor *a)
{
    if (loft_exact_sign(determinant(a, a->n, a->at, a->at)) >= 0)
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
