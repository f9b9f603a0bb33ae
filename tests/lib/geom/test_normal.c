/* tests/lib/geom/test_normal.c -- properties of lib/geom/normal.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact.h"              /* exact_acc */
#include "geom/normal.h"

/* Any size from 2^-32 to 2^28. */
static void arb_wide(arb *a, loft_acc x[], long double exact[])
{
    const int shift = (int)arb_below(a, 56);

    for (int i = 0; i < LOFT_AXES; i++) {
        const int64_t raw = (int64_t)arb_next(a) >> (3 + shift);
        x[i] = (loft_acc)BY_NUM(raw, (double)raw / 4294967296.0, (double)raw / 4294967296.0);
        exact[i] = exact_acc(x[i]);
    }
}

static long double length(const long double x[], int n)
{
    long double sum = 0;
    for (int i = 0; i < n; i++)
        sum += x[i] * x[i];
    return sqrtl(sum);
}

static void a_unit_vector_is_within_its_bound(arb *a)
{
    loft_acc x[LOFT_AXES];
    long double y[LOFT_AXES];
    loft_vec v;

    arb_wide(a, x, y);
    const long double size = length(y, LOFT_AXES);
    if (!(size > 0)) {
        CHECK(loft_vec_unit(x, &v) == LOFT_SINGULAR);
        return;
    }
    CHECK(loft_vec_unit(x, &v) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(v.axis[i]), y[i] / size,
                    BY_NUM((0.5L + 0x1p-15L) * LSB, ulp(1) / 2, (LOFT_AXES + 4) * ulp(1)));
}

/* b is close to a: the angle goes down to 2^-18. */
static void a_normal_is_within_its_bound(arb *a)
{
    const long double shrink = ldexpl(1, -(int)arb_below(a, 18));
    loft_acc x[LOFT_AXES], y[LOFT_AXES];
    long double p[LOFT_AXES], q[LOFT_AXES], n[3], s;
    loft_vec v, w;

    arb_wide(a, x, p);
    arb_wide(a, y, q);
    for (int i = 0; i < LOFT_AXES && arb_below(a, 4); i++) {
        y[i] = (loft_acc)(BY_NUM((long double)x[i], x[i], x[i]) / 2 +
                          BY_NUM((long double)y[i], y[i], y[i]) * shrink / 2);
        q[i] = exact_acc(y[i]);
    }
    for (int i = 0; i < 3; i++)
        n[i] = p[(i + 1) % 3] * q[(i + 2) % 3] - p[(i + 2) % 3] * q[(i + 1) % 3];
    s = length(n, 3) / length(p, 3) / length(q, 3);
    const enum loft_status status = loft_vec_normal(x, y, &v);
    CHECK(status == (s > 0x1.001p-20L ? LOFT_OK : LOFT_SINGULAR) ||
          (s > 0x0.ffep-20L && s < 0x1.002p-20L));
    for (int i = 0; i < 3 && status == LOFT_OK; i++)
        CHECK_EXACT(
            exact_of(v.axis[i]), n[i] / length(n, 3),
            BY_NUM((0.5L + 0x1p-16L / s) * LSB, ulp(1) / 2 + 0x1p-52L / s, 0x1p-52L * (8 + 4 / s)));
    if (status == LOFT_OK) {
        CHECK(loft_vec_normal(y, x, &w) == LOFT_OK);
        for (int i = 0; i < 3; i++)
            CHECK_EXACT(exact_of(v.axis[i]), -exact_of(w.axis[i]), BY_NUM(LSB, ulp(1), ulp(1)));
    }
}

static void parallel_vectors_have_none(arb *a)
{
    loft_acc x[LOFT_AXES], y[LOFT_AXES];
    long double p[LOFT_AXES];
    const loft_vec before = { { 7 } };
    loft_vec v = before;

    arb_wide(a, x, p);
    for (int i = 0; i < LOFT_AXES; i++)
        y[i] = -x[i];
    CHECK(loft_vec_normal(x, y, &v) == LOFT_SINGULAR && loft_vec_normal(x, x, &v) == LOFT_SINGULAR);
    for (int i = 0; i < LOFT_AXES; i++)
        y[i] = 0;
    CHECK(loft_vec_normal(x, y, &v) == LOFT_SINGULAR &&
          loft_vec_normal(y, x, &v) == LOFT_SINGULAR && loft_vec_unit(y, &v) == LOFT_SINGULAR);
    CHECK(loft_vec_equal(v, before));
}

int main(void)
{
    PROPERTY(a_unit_vector_is_within_its_bound,     9000);
    PROPERTY(a_normal_is_within_its_bound,          9000);
    PROPERTY(parallel_vectors_have_none,             600);
    return check_failures();
}
