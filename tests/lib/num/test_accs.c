/* tests/lib/num/test_accs.c -- wide vectors: lib/num/accs.h against the operations on one number
 * SPDX-License-Identifier: MIT
 */
#include "num/accs.h"
#include "check.h"          /* CHECK, PROPERTY */

/* Of any size up to 2^29. */
static loft_acc some_acc(arb *a)
{
    return loft_acc_scale(loft_acc_mul(loft_to_acc(arb_real(a, 16383)), arb_real(a, 16383)),
                          arb_unit(a));
}

typedef struct {
    loft_acc x[LOFT_AXES + 2], y[LOFT_AXES + 2], z[LOFT_AXES + 2];
} pair;

static pair some_pair(arb *a)
{
    pair p;

    for (int i = 0; i < LOFT_AXES + 2; i++) {
        p.x[i] = p.z[i] = some_acc(a);
        p.y[i] = some_acc(a);
    }
    return p;
}

static bool same(loft_acc a, loft_acc b) { return !(a < b || b < a); }

/* The memory before and behind the vector is unchanged. */
static bool stays_beside(const pair *p)
{
    return same(p->z[0], p->x[0]) && same(p->z[LOFT_AXES + 1], p->x[LOFT_AXES + 1]);
}

#define CHECK_ALL(p, wanted)                                                                       \
    do {                                                                                           \
        for (int i = 1; i <= LOFT_AXES; i++)                                                       \
            CHECK(same((p).z[i], wanted));                                                         \
        CHECK(stays_beside(&(p))); \
    } while (0)

static void sums_are_those_of_the_axes(arb *a)
{
    pair p = some_pair(a), q = p, r = p, s = p;

    loft_accs_add(p.z + 1, p.y + 1);
    CHECK_ALL(p, p.x[i] + p.y[i]);
    loft_accs_sub(q.z + 1, q.y + 1);
    CHECK_ALL(q, q.x[i] - q.y[i]);
    loft_accs_copy(r.z + 1, r.y + 1);
    CHECK_ALL(r, r.y[i]);
    loft_accs_triple(s.z + 1);
    CHECK_ALL(s, 3 * s.x[i]);
}

static void products_are_those_of_the_axes(arb *a)
{
    const loft_unit t = arb_unit(a);
    const loft_vec v = arb_vec(a, 32767);
    pair p = some_pair(a), q = p, r = p;

    loft_accs_scale(p.z + 1, t);
    CHECK_ALL(p, loft_acc_scale(p.x[i], t));
    loft_accs_grow(q.z + 1, q.y + 1, t);
    CHECK_ALL(q, q.x[i] + loft_acc_scale(q.y[i], t));
    loft_accs_from(r.z + 1, v.axis);
    CHECK_ALL(r, loft_to_acc(v.axis[i - 1]));
}

static void size_and_order_are_those_of_numbers(arb *a)
{
    const loft_acc x = some_acc(a), y = arb_below(a, 4) ? some_acc(a) : x, size = loft_acc_abs(x),
                   less = loft_acc_min(x, y), more = loft_acc_max(x, y);

    CHECK(!(size < 0) && (same(size, x) || same(size, -x)));
    CHECK((same(less, x) && same(more, y)) || (same(less, y) && same(more, x)));
    CHECK(less <= more);
}

int main(void)
{
    PROPERTY(sums_are_those_of_the_axes,            20000);
    PROPERTY(products_are_those_of_the_axes,        20000);
    PROPERTY(size_and_order_are_those_of_numbers,   20000);
    return check_failures();
}
