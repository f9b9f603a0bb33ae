/* tests/lib/surface/test_net_nearest.c -- properties of
 * lib/surface/net_nearest.h
 * SPDX-License-Identifier: MIT
 *
 * The reference samples the patch densely in long double.
 */
#include "support/exact.h"          /* exact_of, exact_acc, exact_eval; CHECK, PROPERTY */
#include "surface/net_nearest.h"

#if LOFT_AXES < 3
#  error "patches need space"
#endif

#define MOST (LOFT_DEGREE_MAX + 1)
#define GRID 48

static loft_vec net[MOST * MOST];

static loft_tensor arb_patch(arb *a, unsigned most)
{
    const unsigned m = 1 + arb_below(a, most), n = 1 + arb_below(a, most);
    loft_tensor s = { net, 0, 0 };

    for (unsigned k = 0; k < (m + 1) * (n + 1); k++)
        for (int axis = 0; axis < LOFT_AXES; axis++)
            net[k].axis[axis] = axis < 3 ? arb_real(a, 20) : 0;
    CHECK(loft_tensor_init(&s, net, m, n) == LOFT_OK);
    return s;
}

static long double distance_at(const loft_tensor *s, long double u, long double v, loft_vec p)
{
    long double sum = 0, row[MOST], column[MOST];

    for (int axis = 0; axis < 3; axis++) {
        for (unsigned i = 0; i <= s->m; i++) {
            for (unsigned j = 0; j <= s->n; j++)
                row[j] = exact_of(s->p[i * (s->n + 1u) + j].axis[axis]);
            column[i] = exact_eval(row, s->n, v);
        }
        sum += powl(exact_eval(column, s->m, u) - exact_of(p.axis[axis]), 2);
    }
    return sqrtl(sum);
}

static loft_vec arb_point(arb *a, int32_t limit)
{
    loft_vec p = { { 0 } };

    for (int axis = 0; axis < 3; axis++)
        p.axis[axis] = arb_real(a, limit);
    return p;
}

static void no_sample_is_nearer(arb *a)
{
    const loft_tensor s = arb_patch(a, 3);
    const loft_vec p = arb_point(a, arb_below(a, 2) ? 20 : 60);
    const loft_real tol = LOFT_REAL(0.0001);
    loft_net_near near;

    CHECK(loft_net_nearest(loft_net_from_tensor(&s), p, tol, &near) == LOFT_OK);
    const long double found = exact_acc(near.distance);
    CHECK_NEAR(distance_at(&s, exact_unit(near.u), exact_unit(near.v), p), found,
               BY_NUM(120 * 0x1p-24L, 120 * 0x1p-23L, 1e-12L));
    for (unsigned i = 0; i <= GRID; i++)
        for (unsigned j = 0; j <= GRID; j++)
            CHECK(found <= distance_at(&s, i / (long double)GRID, j / (long double)GRID, p) +
                               0.0001L + 1e-9L);
}

/* The foot of a point above a place of the patch, along the normal, near by, is that place. */
static void a_place_of_the_patch_is_its_own_foot(arb *a)
{
    const loft_tensor s = arb_patch(a, 4);
    const loft_unit u = loft_unit_of(arb_below(a, 257), 256),
                    v = loft_unit_of(arb_below(a, 257), 256);
    const loft_vec p = loft_tensor_eval(&s, u, v);
    loft_net_near near;

    CHECK(loft_net_nearest(loft_net_from_tensor(&s), p, LOFT_REAL(0.0001), &near) == LOFT_OK);
    CHECK(exact_acc(near.distance) <= BY_NUM(2 * 0x1p-16L, 20 * 0x1p-22L, 1e-12L));
}

static void far_beyond_a_corner_the_corner_is_exact(arb *a)
{
    loft_tensor s = { net, 0, 0 };
    loft_net_near near;

    for (unsigned i = 0; i <= 2; i++)
        for (unsigned j = 0; j <= 2; j++) {
            loft_vec *p = &net[3 * i + j];
            *p = (loft_vec) { { 0 } };
            p->axis[0] = loft_real_from_int(10 * (int32_t)i) + arb_real(a, 1);
            p->axis[1] = loft_real_from_int(10 * (int32_t)j) + arb_real(a, 1);
            p->axis[2] = arb_real(a, 1);
        }
    CHECK(loft_tensor_init(&s, net, 2, 2) == LOFT_OK);
    for (unsigned corner = 0; corner < 4; corner++) {
        loft_vec p = { { 0 } };
        p.axis[0] = corner & 1 ? LOFT_REAL(50) : LOFT_REAL(-30);
        p.axis[1] = corner & 2 ? LOFT_REAL(50) : LOFT_REAL(-30);
        CHECK(loft_net_nearest(loft_net_from_tensor(&s), p, LOFT_REAL(0.001), &near) == LOFT_OK);
        CHECK(corner & 1 ? !(near.u < LOFT_UNIT(1)) : !(near.u > 0));
        CHECK(corner & 2 ? !(near.v < LOFT_UNIT(1)) : !(near.v > 0));
        CHECK(loft_vec_equal(near.point, net[(corner & 1 ? 6 : 0) + (corner & 2 ? 2 : 0)]));
    }
}

static void collapsed_patches_have_a_nearest_point(arb *a)
{
    loft_tensor s = arb_patch(a, 3);
    const loft_vec p = arb_point(a, 30);
    loft_net_near near;

    if (arb_below(a, 2))                                /* an edge, or all, in one point */
        for (unsigned j = 0; j <= s.n; j++)
            net[j] = net[0];
    else
        for (unsigned k = 0; k < (s.m + 1u) * (s.n + 1u); k++)
            net[k] = net[0];
    CHECK(loft_net_nearest(loft_net_from_tensor(&s), p, LOFT_REAL(0.001), &near) == LOFT_OK);
    for (unsigned i = 0; i <= 8; i++)
        for (unsigned j = 0; j <= 8; j++)
            CHECK(exact_acc(near.distance) <= distance_at(&s, i / 8.0L, j / 8.0L, p) + 0.0011L);
}

/* In the middle of one border the patch is nearer to 0 than elsewhere, and near again in that of
 * the opposite one, to which it falls from its middle: the bound of a part counts every row and
 * every column of its net. */
static void the_nearest_border_is_found(arb *a)
{
    const unsigned m = 3 + arb_below(a, 2), n = 3 + arb_below(a, 2), border = arb_below(a, 4);
    const loft_vec zero = { { 0 } };
    loft_tensor s;
    loft_net_near near;

    for (unsigned i = 0; i <= m; i++)
        for (unsigned j = 0; j <= n; j++) {
            const unsigned end = border / 2 ? n : m, k = border / 2 ? j : i,
                           from = border % 2 ? end - k : k, across = border / 2 ? i : j,
                           last = border / 2 ? m : n;
            const bool corner = across == 0 || across == last;
            loft_vec *const p = &net[i * (n + 1) + j];
            for (int axis = 0; axis < LOFT_AXES; axis++)
                p->axis[axis] = axis < 2 ? arb_real(a, 1) / 4 : 0;
            p->axis[2] = loft_real_from_int(from + 1 == end            ? 10
                                            : from > 0 && from < end ? 20
                                            : corner               ? 6
                                            : from == 0            ? 1
                                                                     : 4) +
                         arb_real(a, 1) / 4;
        }
    CHECK(loft_tensor_init(&s, net, m, n) == LOFT_OK);
    CHECK(loft_net_nearest(loft_net_from_tensor(&s), zero, LOFT_REAL(0.001), &near) == LOFT_OK);
    for (unsigned k = 0; k <= 8; k++)
        CHECK(exact_acc(near.distance) <= distance_at(&s, border / 2 ? k / 8.0L : border % 2,
                                                      border / 2 ? border % 2 : k / 8.0L, zero) +
                                              0.0011L);
}

/* Only one border comes near, at 29/32 of it, and of the places where the search starts its other
 * corner is the nearest: what the row or the column of that border alone tells is not left out. */
static void one_row_is_enough(arb *a)
{
    static const int32_t dip[9] = { 6, 70, 80, 45, 30, 80, 10, -20, 12 };
    const unsigned deep = 2 + arb_below(a, 2), border = arb_below(a, 4), m = border / 2 ? 8 : deep,
                   n = border / 2 ? deep : 8;
    const loft_vec zero = { { 0 } };
    loft_tensor s;
    loft_net_near near;

    for (unsigned i = 0; i <= m; i++)
        for (unsigned j = 0; j <= n; j++) {
            const unsigned k = border / 2 ? j : i, from = border % 2 ? deep - k : k;
            loft_vec *const p = &net[i * (n + 1) + j];
            for (int axis = 0; axis < LOFT_AXES; axis++)
                p->axis[axis] = axis < 2 ? arb_real(a, 1) / 4 : 0;
            p->axis[2] = loft_real_from_int(from == 0      ? dip[border / 2 ? i : j]
                                            : from == deep ? 20
                                                           : 30) +
                         arb_real(a, 1) / 4;
        }
    CHECK(loft_tensor_init(&s, net, m, n) == LOFT_OK);
    CHECK(loft_net_nearest(loft_net_from_tensor(&s), zero, LOFT_REAL(0.001), &near) == LOFT_OK);
    CHECK(exact_acc(near.distance) <= distance_at(&s, border / 2 ? 29 / 32.0L : border % 2,
                                                  border / 2 ? border % 2 : 29 / 32.0L, zero) +
                                          0.0011L);
}

static void bad_arguments_are_refused(arb *a)
{
    const loft_tensor s = arb_patch(a, 2);
    loft_net_near near = { .u = LOFT_UNIT(0.5) };

    CHECK(loft_net_nearest(loft_net_from_tensor(&s), net[0], 0, &near) == LOFT_ERR_ARG);
    CHECK(!(near.u < LOFT_UNIT(0.5)) && !(near.u > LOFT_UNIT(0.5)));
}

int main(void)
{
    PROPERTY(no_sample_is_nearer, 60);
    PROPERTY(a_place_of_the_patch_is_its_own_foot, 60);
    PROPERTY(far_beyond_a_corner_the_corner_is_exact, 10);
    PROPERTY(collapsed_patches_have_a_nearest_point, 30);
    PROPERTY(the_nearest_border_is_found, 30);
    PROPERTY(one_row_is_enough, 30);
    PROPERTY(bad_arguments_are_refused, 1);
    return check_failures();
}
