/* tests/lib/surface/triangle/test_triangle_integral.c -- properties of
 * lib/surface/triangle/triangle_integral.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_spline.h"       /* bound_by_num; CHECK, PROPERTY, BY_NUM */
#include "surface/barycentric.h"
#include "surface/triangle/triangle_integral.h"

#if LOFT_AXES < 2
#  error "triangles need a plane"
#endif

/* A constant, and a coordinate: the area, and the area times its value at the centroid. */
static void linear_functions_have_their_value_at_the_centroid(arb *a)
{
    const unsigned n = arb_below(a, LOFT_DEGREE_MAX + 1);
    const int32_t corner[3] = { (int32_t)arb_below(a, 100) - 50, (int32_t)arb_below(a, 100) - 50,
                                (int32_t)arb_below(a, 100) - 50 };
    const loft_vec t[3] = { arb_vec(a, 100), arb_vec(a, 100), arb_vec(a, 100) };
    loft_real b[LOFT_TRIANGLE_MAX];
    loft_acc area = 0, integral = 0;
    long double x[3][2];

    for (unsigned m = 0, p = 0; m <= n; m++)        /* times 2520: whole for any degree to 9 */
        for (unsigned k = 0; k <= m; k++, p++)
            b[p] = n == 0 ? loft_real_from_raw(840 * (corner[0] + corner[1] + corner[2]))
                          : loft_real_from_raw(((int32_t)(n - m) * corner[0] +
                                                (int32_t)(m - k) * corner[1] +
                                                (int32_t)k * corner[2]) *
                                               (2520 / (int32_t)n));
    CHECK(loft_triangle_integral(b, n, t, &area, &integral) == LOFT_OK);
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 2; i++)
            x[k][i] = exact_of(t[k].axis[i]);
    const long double want =
        ((x[1][0] - x[0][0]) * (x[2][1] - x[0][1]) - (x[2][0] - x[0][0]) * (x[1][1] - x[0][1])) / 2;
    const long double mean = 840 * (corner[0] + corner[1] + corner[2]) / 65536.0L;
    CHECK_EXACT(exact_acc(area), want, bound_by_num(0x1p-32L, 1e-10L, 1e-10L));
    CHECK_EXACT(exact_acc(integral), want * mean, bound_by_num(0x1p-31L, 1e-8L, 1e-8L));
}

static void flat_triangles_have_none(arb *a)
{
    const loft_vec p = arb_vec(a, 1000), step = arb_vec(a, 1000);
    const loft_vec t[3] = { p, p, step };
    const loft_real b[3] = { LOFT_REAL(1), LOFT_REAL(2), LOFT_REAL(3) };
    loft_acc area = 1, integral = 1;

    CHECK(loft_triangle_integral(b, 1, t, &area, &integral) == LOFT_OK);
    CHECK(!(area < 0) && !(area > 0) && !(integral < 0) && !(integral > 0));
    CHECK(loft_triangle_integral(b, 10, t, &area, &integral) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(linear_functions_have_their_value_at_the_centroid, 1000);
    PROPERTY(flat_triangles_have_none,                           100);
    return check_failures();
}
