/* tests/lib/geom/test_vec_exact.c -- properties of lib/geom/vec_exact.h
 * SPDX-License-Identifier: MIT
 *
 * Coordinates are multiples of 2^-16, hence integers here; the test computes with wide integers.
 */
#include "support/exact_whole.h"        /* whole_of */
#include "geom/vec_exact.h"

#define LIMIT (1000 * 65536)

static wide axis_of(loft_vec v, int i)  { return whole_of(loft_vec_axis(&v, i)); }

static void draw(arb *a, loft_vec p[], int count)
{
    for (int k = 0; k < count; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            p[k].axis[i] = loft_real_from_raw(arb_raw(a, LIMIT));
}

/* Is x = v * 2^(factors * LOFT_EXACT_REAL), with v in units of 2^(-16 factors)? */
static bool is_whole(loft_exact x, wide v, int factors)
{
    const int32_t part[3] = { (int32_t)(v >> 60), (int32_t)((v >> 30) & 0x3fffffff),
                              (int32_t)(v & 0x3fffffff) };
    loft_exact y = loft_exact_from_int(part[0]);

    for (int k = 1; k < 3; k++)
        y = loft_exact_add(loft_exact_shift(y, 30), loft_exact_from_int(part[k]));
    return loft_exact_compare(x, loft_exact_shift(y, factors * (LOFT_EXACT_REAL - 16))) == 0;
}

static void differences_and_products_are_exact(arb *a)
{
    loft_vec p[4];
    loft_exact x[6], y[6], n[3];
    wide u[6], v[6], dot = 0;

    draw(a, p, 4);
    loft_vec_exact_sub(&p[1], &p[0], 6, x);
    loft_vec_exact_sub(&p[3], &p[2], 6, y);
    for (int i = 0; i < 6; i++) {
        u[i] = axis_of(p[1], i) - axis_of(p[0], i);
        v[i] = axis_of(p[3], i) - axis_of(p[2], i);
        dot += u[i] * v[i];
        CHECK(is_whole(x[i], u[i], 1));
        CHECK(loft_exact_compare(loft_vec_exact_sub_axis(&p[1], &p[0], i), x[i]) == 0);
    }
    CHECK(is_whole(loft_vec_exact_dot(x, y, 6), dot, 2));
    loft_vec_exact_cross(x, y, n);
    CHECK(is_whole(n[0], u[1] * v[2] - u[2] * v[1], 2));
    CHECK(is_whole(n[1], u[2] * v[0] - u[0] * v[2], 2));
    CHECK(is_whole(n[2], u[0] * v[1] - u[1] * v[0], 2));
}

/* |a x b|^2 + (a b)^2 = |a|^2 |b|^2, for any coordinates. */
static void lagranges_identity_holds(arb *a)
{
    const loft_vec p[3] = { arb_vec(a, 32767), arb_vec(a, 32767), arb_vec(a, 32767) };
    loft_exact x[3], y[3], n[3];

    if (!loft_vec_exact_valid(p, 3, 3))
        return;
    loft_vec_exact_sub(&p[1], &p[0], 3, x);
    loft_vec_exact_sub(&p[2], &p[0], 3, y);
    loft_vec_exact_cross(x, y, n);
    const loft_exact dot = loft_vec_exact_dot(x, y, 3);
    const loft_exact sum = loft_exact_add(loft_vec_exact_dot(n, n, 3), loft_exact_mul(dot, dot));
    const loft_exact product = loft_exact_mul(loft_vec_exact_dot(x, x, 3),
                                              loft_vec_exact_dot(y, y, 3));
    CHECK(loft_exact_compare(sum, product) == 0);
    CHECK(loft_exact_sign(loft_vec_exact_dot(n, x, 3)) == 0);
}

/* One coordinate of one point is too large, within or beyond the tested axes. */
static void a_point_is_valid_if_its_axes_are(arb *a)
{
    const int k = (int)arb_below(a, 3), axis = (int)arb_below(a, LOFT_AXES);
    loft_vec p[3];

    draw(a, p, 3);
    CHECK(loft_vec_exact_valid(p, 3, 6));
#if LOFT_NUM != LOFT_Q16
    p[k].axis[axis] = LOFT_REAL_MAX;
    for (int axes = 0; axes <= 6; axes++)
        for (int count = 0; count <= 3; count++)
            CHECK(loft_vec_exact_valid(p, (unsigned)count, axes) == (axis >= axes || k >= count));
#else
    (void)k, (void)axis;
#endif
}

int main(void)
{
    PROPERTY(differences_and_products_are_exact, 3000);
    PROPERTY(lagranges_identity_holds,           3000);
    PROPERTY(a_point_is_valid_if_its_axes_are,    600);
    return check_failures();
}
