/* tests/lib/surface/tensor/test_tensor_join.c -- properties of lib/surface/tensor/tensor_join.h
 * SPDX-License-Identifier: MIT
 */
#include "check.h"                  /* CHECK, PROPERTY, BY_NUM */
#include "support/tensor_joins.h"   /* tj_flags */
#include "support/tensors.h"        /* TENSOR_POINTS */

typedef struct {
    loft_vec p[TENSOR_POINTS], q[TENSOR_POINTS];
    loft_tensor first, second;
    unsigned n;
} pair;

static loft_real real_of(int64_t raw)
{
    return (loft_real)BY_NUM(raw, (double)raw / 65536, (double)raw / 65536);
}

/* The second patch begins where the first ends and with a P_u + b(v) P_v, b = b0 (1 - v) + b1 v:
 * whole numbers of LSB that a float holds. `wild` makes control points far apart, so that normals
 * turn. */
static pair *arb_pair(arb *a, int64_t alpha, int64_t b0, int64_t b1, bool wild)
{
    static pair x;
    const unsigned m = 1 + arb_below(a, 3), n = 1 + arb_below(a, LOFT_DEGREE_MAX), w = n + 1;

    x.n = n;
    for (unsigned i = 0; i <= m; i++)
        for (unsigned j = 0; j <= n; j++)
            for (int k = 0; k < LOFT_AXES; k++) {
                const int64_t place = wild ? 0
                                           : (k == 0   ? (int64_t)i
                                              : k == 1 ? (int64_t)j
                                                       : 0) *
                                                 65536;
                x.p[i * w + j].axis[k] = real_of(place + arb_raw(a, wild ? 65536 : 6000));
            }
    for (unsigned j = 0; j <= n; j++)
        for (int k = 0; k < LOFT_AXES; k++) {
            const loft_vec *last = x.p + m * w;
            const int64_t c = tj_raw(last[j].axis[k]),
                          u = c - tj_raw(last[(int)j - (int)w].axis[k]);
            const int64_t after = j < n ? tj_raw(last[j + 1].axis[k]) - c : 0,
                          before = j > 0 ? c - tj_raw(last[j - 1].axis[k]) : 0;
            x.q[j].axis[k] = last[j].axis[k];
            x.q[w + j].axis[k] = real_of(c + alpha * u + b0 * (int64_t)(n - j) * after +
                                         b1 * (int64_t)j * before);
            for (unsigned i = 2; i <= 3; i++)
                x.q[i * w + j].axis[k] = arb_real(a, 100);
        }
    CHECK(loft_tensor_init(&x.first, x.p, m, n) == LOFT_OK);
    CHECK(loft_tensor_init(&x.second, x.q, 1 + arb_below(a, 3), n) == LOFT_OK);
    return &x;
}

static void check_flags(const pair *x)
{
    loft_tensor_join j = { false, false, false };
    bool c0, c1;
    int g1;

    CHECK(loft_tensor_join_init(&j, &x->first, &x->second) == LOFT_OK);
    tj_flags(&x->first, &x->second, &c0, &c1, &g1);
    CHECK(j.c0 == c0 && j.c1 == c1);
    CHECK(g1 < 0 || j.g1 == g1);
}

/* b may be up to 1 / n of the edge. */
static void a_patch_made_to_go_on_smoothly_is_g1(arb *a)
{
    const int64_t alpha = 1 + arb_below(a, 4);
    pair *x = arb_pair(a, alpha, (int64_t)arb_below(a, 3) - 1, (int64_t)arb_below(a, 3) - 1, false);
    loft_tensor_join j;

    CHECK(loft_tensor_join_init(&j, &x->first, &x->second) == LOFT_OK);
    CHECK(j.c0 && j.g1);
    check_flags(x);
}

static void folded_back_it_is_not(arb *a)
{
    pair *x = arb_pair(a, -1 - (int64_t)arb_below(a, 4), 0, 1, false);
    loft_tensor_join j;

    CHECK(loft_tensor_join_init(&j, &x->first, &x->second) == LOFT_OK);
    CHECK(j.c0 && !j.c1 && !j.g1);
}

/* Of all kinds: normals that turn, vanish, or are one LSB off. */
static void flags_are_those_of_whole_numbers(arb *a)
{
    pair *x = arb_pair(a, (int64_t)arb_below(a, 4) - 1, (int64_t)arb_below(a, 3) - 1,
                       (int64_t)arb_below(a, 3) - 1, arb_below(a, 2));
    const uint32_t kind = arb_below(a, 4), w = x->n + 1;
    loft_real *one = &x->q[(kind == 3 ? 0 : w) + arb_below(a, w)].axis[arb_below(a, LOFT_AXES)];

    check_flags(x);
    if (kind > 1) {
        *one += real_of(1);
        check_flags(x);
    }
}

/* A cusp of the edge at 1/4, a point of the bisection, and at 1/3, which is none. */
static void an_edge_with_a_cusp_is_not_g1(arb *a)
{
    static const int64_t cusp[2][3] = { { 0, -1, 2 }, { 0, -1, 1 } };
    static loft_vec p[6], q[6];
    const int64_t *at = cusp[arb_below(a, 2)], size = 1 + arb_below(a, 1000000);
    loft_tensor first, second;
    loft_tensor_join j;

    for (unsigned i = 0; i < 2; i++)
        for (unsigned k = 0; k < 3; k++) {
            const loft_vec v = { { real_of(at[k] * size) } };
            p[i * 3 + k] = q[i * 3 + k] = v;
            p[i * 3 + k].axis[1] = real_of((int64_t)i * 65536);
            q[i * 3 + k].axis[1] = real_of((int64_t)i * 65536 + 65536);
        }
    CHECK(loft_tensor_init(&first, p, 1, 2) == LOFT_OK &&
          loft_tensor_init(&second, q, 1, 2) == LOFT_OK);
    CHECK(loft_tensor_join_init(&j, &first, &second) == LOFT_OK);
    CHECK(j.c0 && j.c1 && !j.g1);
}

/* The normal of the second patch is (1 - 3 v)^2 times that of the first, plus a little: 0 at 1/3,
 * or not. */
static void normals_that_nearly_vanish_are_told_from_null(arb *a)
{
    static loft_vec p[8], q[8];
    const int64_t size = (int64_t)arb_below(a, 400000) + 3, little = (int64_t)arb_below(a, 3);
    const int64_t factor[4] = { 9, -9, 0, 36 };     /* 9 (1 - 3 v)^2 of degree 3 */
    loft_tensor first, second;
    loft_tensor_join j;

    for (unsigned k = 0; k < 4; k++) {
        p[k] = p[4 + k] = q[4 + k] = (loft_vec){ { real_of((int64_t)k * 65536) } };
        p[k].axis[1] = real_of(-65536);
        p[4 + k].axis[1] = 0;
        q[k] = p[4 + k];
        q[4 + k].axis[1] = real_of(factor[k] * size + little);
    }
    CHECK(loft_tensor_init(&first, p, 1, 3) == LOFT_OK &&
          loft_tensor_init(&second, q, 1, 3) == LOFT_OK);
    CHECK(loft_tensor_join_init(&j, &first, &second) == LOFT_OK);
    CHECK(j.c0 && j.g1 == (little > 0));
}

static void arguments_out_of_range_are_refused(arb *a)
{
    const pair *x = arb_pair(a, 1, 0, 0, false);
    loft_tensor other = x->second;
    loft_tensor_join j = { true, true, true };

    other.m = 0;
    CHECK(loft_tensor_join_init(&j, &x->first, &other) == LOFT_ERR_ARG && !j.c0 && !j.c1 && !j.g1);
    CHECK(loft_tensor_join_init(&j, &other, &x->second) == LOFT_ERR_ARG);
    other = x->second;
    other.n--;
    CHECK(loft_tensor_join_init(&j, &x->first, &other) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(a_patch_made_to_go_on_smoothly_is_g1, 25);
    PROPERTY(folded_back_it_is_not, 25);
    PROPERTY(flags_are_those_of_whole_numbers, 60);
    PROPERTY(an_edge_with_a_cusp_is_not_g1, 50);
    PROPERTY(normals_that_nearly_vanish_are_told_from_null, 50);
    PROPERTY(arguments_out_of_range_are_refused, 20);
    return check_failures();
}
