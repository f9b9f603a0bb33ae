/* tests/support/signs.h -- polynomials whose roots are known, and the signs of values
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_SIGNS_H
#define LOFT_TESTS_SIGNS_H

#include "support/exact.h"          /* exact_eval; CHECK, PROPERTY, BY_NUM */
#include "basis/positivity.h"
#include "support/products.h"

typedef struct {
    bool changes, ends;
    int roots;
} known;

/* Roots a / b in 0..1, each once, twice or three times, and a factor without real roots. */
static inline known arb_product(arb *a, product *p)
{
    static const int64_t none[2][3] = { { 1, 1, 1 }, { 2, 2, 1 } };
    known k = { false, false, 0 };
    bool used[7] = { false };

    *p = (product) { 0, { arb_below(a, 2) ? 1 : -1 } };
    for (unsigned tries = arb_below(a, 4); tries > 0; tries--) {
        const unsigned at = arb_below(a, 7), times = 1 + arb_below(a, 3);
        const int64_t root[2] = { -(int64_t)at, 6 - (int64_t)at };     /* 6 t - at */
        if (used[at] || p->degree + times > 7)
            continue;
        used[at] = true;
        for (unsigned i = 0; i < times; i++)
            multiply(p, root, 1);
        k.roots++;
        k.ends = k.ends || at == 0 || at == 6;
        k.changes = k.changes || (at > 0 && at < 6 && times % 2);
    }
    if (arb_below(a, 2))
        multiply(p, none[arb_below(a, 2)], 2);
    return k;
}

static inline long double value_at(const loft_real b[], unsigned n, long double t)
{
    long double c[LOFT_POSITIVITY_DEGREE + 1];
    for (unsigned i = 0; i <= n; i++)
        c[i] = exact_of(b[i]);
    return exact_eval(c, n, t);
}

/* How often values at even places change their sign. The answer must not contradict any. */
static inline int changes_of_values(const loft_real b[], unsigned n, int steps,
                                    const loft_positivity *got)
{
    int changes = 0, before = 0;

    for (int i = 0; i <= steps; i++) {
        const long double y = value_at(b, n, (long double)i / steps);
        const int sign = fabsl(y) < 1e-12L ? 0 : y > 0 ? 1 : -1;
        changes += sign && before && sign != before;
        before = sign ? sign : before;
        CHECK(sign >= 0 || (!got->nonnegative && !got->positive));
    }
    return changes;
}

#endif
