/* lib/curve/inflections.c
 * SPDX-License-Identifier: MIT
 *
 * With X = x w, Y = y w, W = w the curvature has the sign of the determinant of (X, Y, W), (X', Y',
 * W'), (X'', Y'', W''). Without weights that is x'y'' - x''y'. It is a polynomial with whole
 * coefficients, whose roots are exact (basis/whole_roots.h). The terms of the highest degrees
 * cancel: 2 n - 4 are left without weights, 3 n - 6 with them.
 *
 * Bits, with R those of a number, 2 R of a product with a weight: the power form of degree n has a
 * sum of coefficients below 2^(2 R) 3^n, its derivatives n and n^2 times that. The determinant has
 * 6 products of three: 6 (2^(2 R) 3^n)^2 2^R 3^n n^3 < 2^(5 R + 5 n + 3 log2 n + 3), n <= 7;
 * without weights 2 (2^R 3^n)^2 n^3 < 2^(2 R + 4 n + 3 log2 n + 1), n <= 9.
 */
#include "curve/inflections.h"

#include "basis/whole_roots.h"  /* loft_whole_roots */

#define MOST (LOFT_DEGREE_MAX + 1)

/* Without weights p alone, with them w alone. */
typedef struct {
    const loft_vec *p;
    const loft_weighted *w;
    unsigned n;
} curve;

/* The power form of X, Y or W. */
static loft_residue_poly power_form(const loft_residue *r, const curve *c, int axis)
{
    loft_residue_poly out = { { 0 }, c->n };
    uint32_t d[MOST];

    for (unsigned k = 0; k <= c->n; k++) {
        const loft_vec *p = c->w ? &c->w[k].p : &c->p[k];
        d[k] = axis == 2 ? loft_residue_real(r, c->w[k].w)
                         : loft_residue_real(r, loft_vec_axis(p, axis));
        if (c->w && axis < 2)
            d[k] = loft_residue_mul(r, d[k], loft_residue_real(r, c->w[k].w));
    }
    for (unsigned k = 0; k <= c->n; k++) {
        out.c[k] = loft_residue_mul(r, d[0], (uint32_t)loft_binomial(c->n, k));
        for (unsigned j = 0; j + k < c->n; j++)
            d[j] = loft_residue_sub(r, d[j + 1], d[j]);
    }
    return out;
}

/* Add the coefficients of a b c to sum, or subtract them. Terms above the last one cancel. */
static void add_product(const loft_residue *r, const loft_residue_poly *a,
                        const loft_residue_poly *b, const loft_residue_poly *c, bool minus,
                        unsigned last, uint32_t sum[])
{
    for (unsigned i = 0; i <= a->degree; i++)
        for (unsigned j = 0; j <= b->degree && i + j <= last; j++) {
            const uint32_t ab = loft_residue_mul(r, a->c[i], b->c[j]);
            for (unsigned k = 0; k <= c->degree && i + j + k <= last; k++) {
                const uint32_t term = loft_residue_mul(r, ab, c->c[k]);
                uint32_t *to = &sum[i + j + k];
                *to = minus ? loft_residue_sub(r, *to, term) : loft_residue_add(r, *to, term);
            }
        }
}

static void wronskian(const loft_whole_poly *w, const loft_residue *r, uint32_t out[])
{
    const curve *c = (const curve *)w->data;
    const unsigned rows = c->w ? 3 : 2;
    loft_residue_poly d[3][3];

    for (unsigned axis = 0; axis < rows; axis++) {
        d[axis][0] = power_form(r, c, (int)axis);
        d[axis][1] = loft_residue_poly_derivative(r, &d[axis][0]);
        d[axis][2] = loft_residue_poly_derivative(r, &d[axis][1]);
    }
    if (!c->w) {
        const loft_residue_poly one = { { 1 }, 0 }, zero = { { 0 }, 0 };
        d[2][0] = one;
        d[2][1] = d[2][2] = zero;
    }
    for (unsigned k = 0; k <= w->degree; k++)
        out[k] = 0;
    for (unsigned i = 0; i < 3; i++) {
        const unsigned j = (i + 1) % 3, k = (i + 2) % 3;
        add_product(r, &d[i][0], &d[j][1], &d[k][2], false, w->degree, out);
        add_product(r, &d[i][0], &d[k][1], &d[j][2], true, w->degree, out);
    }
}

static bool curve_valid(const curve *c)
{
    for (unsigned k = 0; k <= c->n; k++) {
        const loft_vec *p = c->w ? &c->w[k].p : &c->p[k];
        if ((c->w && !loft_exact_valid(c->w[k].w)) || !loft_exact_valid(loft_vec_axis(p, 0)) ||
            !loft_exact_valid(loft_vec_axis(p, 1)))
            return false;
    }
    return true;
}

static enum loft_status find_flats(const curve *c, loft_flat out[], unsigned *count)
{
    const unsigned degree = c->w ? 3 * c->n - 6 : 2 * c->n - 4;
    const loft_whole_poly w = { .degree = c->n < 3 ? 1 : degree,
                                .bits = c->w ? 5 * LOFT_RESIDUE_REAL + 5 * c->n + 12
                                             : 2 * LOFT_RESIDUE_REAL + 4 * c->n + 12,
                                .residues = wronskian,
                                .data = c };
    loft_whole_root root[LOFT_RESIDUE_DEGREE];
    unsigned roots = 0;

    *count = 0;
    if (LOFT_AXES < 2 || (c->w && c->n > LOFT_FLATS_RATIONAL))
        return LOFT_ERR_ARG;
    if (!curve_valid(c))
        return LOFT_ERR_RANGE;
    if (c->n < 2)
        return LOFT_SINGULAR;
    const enum loft_status status = loft_whole_roots(&w, root, &roots);
    if (status != LOFT_OK)
        return status;
    for (unsigned k = 0; k < roots; k++) {
        out[k].t = loft_sci_to_unit(loft_whole_root_at(&root[k]));
        out[k].multiplicity = root[k].multiplicity;
    }
    *count = roots;
    return LOFT_OK;
}

enum loft_status loft_bezier_inflections(const loft_bezier *b, loft_flat out[], unsigned *count)
{
    const curve c = { b->p, NULL, b->degree };

    return find_flats(&c, out, count);
}

enum loft_status loft_rational_inflections(const loft_rational *r, loft_flat out[], unsigned *count)
{
    const curve c = { NULL, r->p, r->degree };

    return find_flats(&c, out, count);
}
