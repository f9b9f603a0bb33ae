/* tests/support/weighted.h -- patches with weights and their derivatives; Gauss's rule
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_WEIGHTED_H
#define LOFT_TESTS_WEIGHTED_H

#include "support/exact.h"                      /* exact_of, exact_deriv */
#include "surface/tensor/tensor_rational.h"     /* loft_tensor_rational */

/* The reference: Gauss's rule with 8 x 8 nodes on each of parts x parts pieces. */
typedef long double density_at(const void *s, long double u, long double v);

static inline long double gauss(density_at *density_of, const void *s, unsigned parts)
{
    static const long double place[4] = { 0.1834346424956498049394761L,
                                          0.5255324099163289858177390L,
                                          0.7966664774136267395915539L,
                                          0.9602898564975362316835609L };
    static const long double weight[4] = { 0.3626837833783619829651504L,
                                           0.3137066458778872873379622L,
                                           0.2223810344533744705443560L,
                                           0.1012285362903762591525314L };
    long double sum = 0;

    for (unsigned p = 0; p < parts; p++)
        for (unsigned q = 0; q < parts; q++)
            for (int i = 0; i < 8; i++)
                for (int j = 0; j < 8; j++) {
                    const long double x = i < 4 ? place[i] : -place[i - 4],
                                      y = j < 4 ? place[j] : -place[j - 4];
                    sum += weight[i % 4] * weight[j % 4] *
                           density_of(s, (p + (1 + x) / 2) / parts, (q + (1 + y) / 2) / parts);
                }
    return sum / 4 / parts / parts;
}

#define WEIGHTED_POINTS 16

/* A patch with weights between 1/3 and 3, of degrees 1 to 3. */
typedef struct {
    loft_weighted p[WEIGHTED_POINTS];
    loft_tensor_rational s;
    loft_vec apex;
} weighted;

static inline weighted *arb_weighted(arb *a)
{
    static weighted x;
    const unsigned m = 1 + arb_below(a, 3), n = 1 + arb_below(a, 3);

    for (unsigned i = 0; i <= m; i++)
        for (unsigned j = 0; j <= n; j++) {
            loft_weighted *at = &x.p[i * (n + 1) + j];
            for (int axis = 0; axis < LOFT_AXES; axis++)
                at->p.axis[axis] = (loft_real)(arb_real(a, 1) +
                                               loft_real_from_int(axis == 0   ? 6 * (int32_t)i
                                                                  : axis == 1 ? 6 * (int32_t)j
                                                                              : 0));
            at->w = (loft_real)(LOFT_REAL(0.3333) +
                                loft_acc_round(loft_acc_mul(
                                    loft_acc_abs(loft_to_acc(arb_real(a, 1))), LOFT_REAL(2.6))));
        }
    for (int axis = 0; axis < LOFT_AXES; axis++)
        x.apex.axis[axis] = arb_real(a, 8);
    CHECK(loft_tensor_rational_init(&x.s, x.p, m, n) == LOFT_OK);
    return &x;
}

/* X, seen from the apex, and w with their first derivatives: [0] values, [1] by u, [2] by v. */
static inline void weighted_jet(const weighted *x, long double u, long double v,
                                long double out[3][4])
{
    const unsigned m = x->s.m, n = x->s.n;

    for (int axis = 0; axis < 4; axis++)
        for (unsigned d = 0; d < 3; d++) {
            long double row[LOFT_DEGREE_MAX + 1], column[LOFT_DEGREE_MAX + 1];
            for (unsigned i = 0; i <= m; i++) {
                for (unsigned j = 0; j <= n; j++) {
                    const loft_weighted *at = &x->p[i * (n + 1) + j];
                    row[j] = exact_of(at->w);
                    if (axis < 3)
                        row[j] *= axis < LOFT_AXES
                                      ? exact_of(at->p.axis[axis]) - exact_of(x->apex.axis[axis])
                                      : 0;
                }
                column[i] = exact_deriv(row, n, d == 2, v);
            }
            out[d][axis] = exact_deriv(column, m, d == 1, u);
        }
}

#endif
