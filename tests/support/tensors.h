/* tests/support/tensors.h -- arbitrary tensor patches and their reference in long double
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_TENSORS_H
#define LOFT_TESTS_TENSORS_H

#include "support/exact.h"              /* exact_eval, exact_deriv, ulp */
#include "surface/tensor/tensor.h"

#define TENSOR_POINTS ((LOFT_DEGREE_MAX + 1) * (LOFT_DEGREE_MAX + 1))

typedef struct {
    loft_vec p[TENSOR_POINTS];
    unsigned m, n;
    loft_tensor s;
    long double largest;
} tensor;

/* A net of the given degrees; one in four consists of extremes of the number type, one in eight in
 * the worst order. */
static inline void tensor_fill(tensor *x, arb *a, unsigned m, unsigned n)
{
    const loft_real top = BY_NUM(INT32_MAX, 32767, 32767),
                    bottom = BY_NUM(INT32_MIN, -32767, -32767);
    const uint32_t kind = arb_below(a, 8), limit = (uint32_t)1 << arb_below(a, 15);

    x->m = m;
    x->n = n;
    x->largest = 0;
    for (unsigned k = 0; k < (m + 1) * (n + 1); k++)
        for (int i = 0; i < LOFT_AXES; i++) {
            const unsigned parity = k / (n + 1) + k % (n + 1);
            x->p[k].axis[i] = kind == 0   ? (parity & 1 ? top : bottom)
                              : kind == 1 ? (arb_below(a, 2) ? top : bottom)
                                          : arb_real(a, (int32_t)limit);
            x->largest = fmaxl(x->largest, fabsl(exact_of(x->p[k].axis[i])));
        }
    CHECK(loft_tensor_init(&x->s, x->p, m, n) == LOFT_OK);
}

static inline tensor *arb_tensor(arb *a)
{
    static tensor x;
    const unsigned m = arb_below(a, LOFT_DEGREE_MAX + 1), n = arb_below(a, LOFT_DEGREE_MAX + 1);
    tensor_fill(&x, a, m, n);
    return &x;
}

/* The derivative of order a by u and b by v, along v first: the library uses the other order.
 * Coordinates are relative to the first control point, so a far origin costs no digits. */
static inline long double tensor_exact(const loft_tensor *s, int axis, unsigned a, unsigned b,
                                       long double u, long double v)
{
    long double row[LOFT_DEGREE_MAX + 1], column[LOFT_DEGREE_MAX + 1];
    const long double origin = exact_of(s->p[0].axis[axis]);

    for (unsigned i = 0; i <= s->m; i++) {
        for (unsigned j = 0; j <= s->n; j++)
            row[j] = exact_of(s->p[i * (s->n + 1u) + j].axis[axis]) - origin;
        column[i] = exact_deriv(row, s->n, b, v);
    }
    return exact_deriv(column, s->m, a, u) + (a + b ? 0 : origin);
}

#endif
