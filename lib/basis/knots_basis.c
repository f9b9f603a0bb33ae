/* lib/basis/knots_basis.c
 * SPDX-License-Identifier: MIT
 *
 * On the span s, N_(i,0) = 1 for i = s alone, and row by row with `low` = U_i and `high` =
 * U_(i+d+1)
 *
 *     N_(i,d)  = (u - U_i) / (U_(i+d) - U_i) N_(i,d-1) + (U_(i+d+1) - u) / (U_(i+d+1) - U_(i+1))
 *                N_(i+1,d-1)
 *     N'_(i,d) = d (N_(i,d-1) / (U_(i+d) - U_i) - N_(i+1,d-1) / (U_(i+d+1) - U_(i+1)))
 *
 * A B-spline of the row d - 1 that is not 0 has a support of positive length, so no divisor is 0.
 * The first degree - k rows are of the first kind, in which nothing cancels; the last k of the
 * second.
 *
 * A value is a quotient of integers. Its denominator divides the product of the differences
 * U_(i+d) - U_i that occur, d of them in row d: degree (degree + 1) / 2, below 2^(REAL + 1) each;
 * the numerator has the differences with u in place of at most `degree` of them, and the same size.
 */
#include "basis/knots_basis.h"

static loft_sci knot_gap(loft_real from, loft_real to)
{
    return loft_sci_sub(loft_sci_from_real(to), loft_sci_from_real(from));
}

/* One row in place: n[0..d-1] of degree d - 1 to n[0..d]; n[j] belongs to i = span - d + j. */
static void raise_row(const loft_real *knot, unsigned span, unsigned d, loft_real u, bool derive,
                      loft_sci n[])
{
    loft_sci carry = loft_sci_zero();

    for (unsigned j = 0; j < d; j++) {
        const loft_real low = knot[span - d + 1 + j], high = knot[span + 1 + j];
        const loft_sci part = loft_sci_div(n[j], knot_gap(low, high));
        if (derive) {
            const loft_sci by = loft_sci_mul(loft_sci_from_int((int32_t)d), part);
            n[j] = loft_sci_sub(carry, by);
            carry = by;
        } else {
            n[j] = loft_sci_add(carry, loft_sci_mul(part, knot_gap(u, high)));
            carry = loft_sci_mul(part, knot_gap(low, u));
        }
    }
    n[d] = carry;
}

void loft_knots_basis(const loft_knots *knots, unsigned span, loft_real u, unsigned k,
                      loft_sci out[])
{
    const unsigned degree = knots->degree;

    out[0] = loft_sci_one();
    for (unsigned d = 1; d <= degree; d++)
        raise_row(knots->k, span, d, u, d + k > degree, out);
    for (unsigned j = 0; k > degree && j <= degree; j++)
        out[j] = loft_sci_zero();
}

static uint32_t residue_gap(const loft_residue *r, loft_real from, loft_real to)
{
    return loft_residue_sub(r, loft_residue_real(r, to), loft_residue_real(r, from));
}

static bool raise_residues(const loft_residue *r, const loft_real *knot, unsigned span, unsigned d,
                           loft_real u, bool derive, uint32_t n[])
{
    uint32_t carry = 0;

    for (unsigned j = 0; j < d; j++) {
        const loft_real low = knot[span - d + 1 + j], high = knot[span + 1 + j];
        const uint32_t gap = residue_gap(r, low, high);
        if (gap == 0)
            return false;
        const uint32_t part = loft_residue_mul(r, n[j], loft_residue_inverse(r, gap));
        if (derive) {
            n[j] = loft_residue_sub(r, carry, part);
            carry = part;
        } else {
            n[j] = loft_residue_add(r, carry, loft_residue_mul(r, part, residue_gap(r, u, high)));
            carry = loft_residue_mul(r, part, residue_gap(r, low, u));
        }
    }
    n[d] = carry;
    return true;
}

bool loft_knots_basis_residue(const loft_knots *knots, unsigned span, loft_real u, unsigned k,
                              const loft_residue *r, uint32_t out[])
{
    out[0] = 1;
    for (unsigned d = 1; d <= knots->degree; d++)
        if (!raise_residues(r, knots->k, span, d, u, d + k > knots->degree, out))
            return false;
    return true;
}

unsigned loft_knots_basis_bits(const loft_knots *knots)
{
    const unsigned degree = knots->degree;
    return degree * (degree + 1) / 2 * (LOFT_RESIDUE_REAL + 1) + degree;
}
