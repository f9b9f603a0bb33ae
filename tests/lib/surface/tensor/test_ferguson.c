/* tests/lib/surface/tensor/test_ferguson.c -- properties of lib/surface/tensor/ferguson.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact.h"          /* exact_of; CHECK, PROPERTY, BY_NUM */
#include "surface/tensor/ferguson.h"

#define MOST 6

typedef struct {
    uint32_t rows, columns;
    loft_vec p[MOST * MOST];
} sample;

/* The coefficients of 1, u, u^2 times those of 1, v, v^2: with halves, so nothing is rounded. */
static sample *arb_polynomial(arb *a, int32_t c[3][3][LOFT_AXES], unsigned degree)
{
    static sample s;

    s.rows = 2 + arb_below(a, MOST - 1);
    s.columns = 2 + arb_below(a, MOST - 1);
    for (unsigned k = 0; k < 9u * LOFT_AXES; k++)
        c[k / 3 / LOFT_AXES][k / LOFT_AXES % 3][k % LOFT_AXES] =
            k / 3 / LOFT_AXES <= degree && k / LOFT_AXES % 3 <= degree
                ? (int32_t)arb_below(a, 41) - 20
                : 0;
    for (uint32_t i = 0; i < s.rows; i++)
        for (uint32_t j = 0; j < s.columns; j++)
            for (int axis = 0; axis < LOFT_AXES; axis++) {
                int32_t x = 0;
                for (int m = 0; m < 9; m++)
                    x += c[m / 3][m % 3][axis] * (m / 3 > 0 ? (int32_t)i : 1) *
                         (m / 3 > 1 ? (int32_t)i : 1) * (m % 3 > 0 ? (int32_t)j : 1) *
                         (m % 3 > 1 ? (int32_t)j : 1);
                s.p[i * s.columns + j].axis[axis] = loft_real_from_int(x);
            }
    return &s;
}

static int32_t power(uint32_t x, int n)
{
    return n == 0 ? 1 : n == 1 ? (int32_t)x : (int32_t)(x * x);
}

static long double slope_of(int32_t c[3][3][LOFT_AXES], int axis, int by_u, int by_v, uint32_t u,
                            uint32_t v)
{
    long double x = 0;

    for (int m = by_u; m < 3; m++)
        for (int n = by_v; n < 3; n++)
            x += (long double)c[m][n][axis] * (by_u ? m : 1) * (by_v ? n : 1) * power(u, m - by_u) *
                 power(v, n - by_v);
    return x;
}

static void check_corners(const sample *s, int32_t c[3][3][LOFT_AXES], enum loft_twist twist)
{
    for (uint32_t i = 0; i + 1 < s->rows; i++)
        for (uint32_t j = 0; j + 1 < s->columns; j++) {
            loft_bicubic b;
            CHECK(loft_bicubic_from_grid(s->p, s->rows, s->columns, i, j, twist, &b) == LOFT_OK);
            for (uint32_t k = 0; k < 16; k++)
                for (int axis = 0; axis < LOFT_AXES; axis++)
                    CHECK_NEAR(exact_of(b.at[k / 4][k % 4].axis[axis]),
                               slope_of(c, axis, k / 4 > 1, k % 4 > 1, i + k / 4 % 2, j + k % 2),
                               0);
        }
}

/* Of a biquadratic surface all data are right with Bessel's twist. */
static void bessel_is_right_for_biquadratics(arb *a)
{
    int32_t c[3][3][LOFT_AXES];
    sample *s = arb_polynomial(a, c, 2);

    if (s->rows > 2 && s->columns > 2)
        check_corners(s, c, LOFT_TWIST_BESSEL);
}

/* Of a surface of translation, and of a bilinear one, they are right with Adini's. */
static void adini_is_right_for_translations(arb *a)
{
    int32_t c[3][3][LOFT_AXES];
    sample *s = arb_polynomial(a, c, 2);

    if (s->rows < 3 || s->columns < 3)
        return;
    for (uint32_t i = 0; i < s->rows; i++)
        for (uint32_t j = 0; j < s->columns; j++)
            for (int axis = 0; axis < LOFT_AXES; axis++)
                s->p[i * s->columns + j].axis[axis] -= loft_real_from_int(
                    (c[1][2][axis] * (int32_t)j + c[2][1][axis] * (int32_t)i +
                     c[2][2][axis] * (int32_t)(i * j)) *
                    (int32_t)(i * j));
    for (int axis = 0; axis < LOFT_AXES; axis++)
        c[1][2][axis] = c[2][1][axis] = c[2][2][axis] = 0;
    check_corners(s, c, LOFT_TWIST_ADINI);
}

static void bilinear_grids_of_any_size_are_right(arb *a)
{
    int32_t c[3][3][LOFT_AXES];
    const sample *s = arb_polynomial(a, c, 1);

    check_corners(s, c, LOFT_TWIST_ADINI);
    check_corners(s, c, LOFT_TWIST_BESSEL);
}

/* Over four cells Adini's twist in the middle is that of the Coons patch between the parabolas. */
static void adini_is_the_twist_of_a_coons_patch(arb *a)
{
    loft_vec p[9];
    loft_bicubic b;

    for (int k = 0; k < 9; k++)
        p[k] = arb_vec(a, 500);
    CHECK(loft_bicubic_from_grid(p, 3, 3, 0, 0, LOFT_TWIST_ADINI, &b) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++) {
        long double x[9];
        for (int k = 0; k < 9; k++)
            x[k] = exact_of(p[k].axis[i]);
        const long double by_v = (x[8] - x[6]) / 2 - (x[2] - x[0]) / 2,
                          by_u = (x[8] - x[2]) / 2 - (x[6] - x[0]) / 2,
                          turn = x[8] - x[2] - x[6] + x[0];
        CHECK_EXACT(exact_of(b.at[3][3].axis[i]), by_v / 2 + by_u / 2 - turn / 4,
                    BY_NUM(LSB / 2, ulp(512), 16 * ulp(512)));
    }
}

/* Neighbours agree about their corners. */
static void cells_have_common_data(arb *a)
{
    loft_vec p[25];
    loft_bicubic b, right, below;

    for (int k = 0; k < 25; k++)
        p[k] = arb_vec(a, 500);
    for (int twist = 0; twist < 3; twist++) {
        const uint32_t i = arb_below(a, 3), j = arb_below(a, 3);
        CHECK(loft_bicubic_from_grid(p, 5, 5, i, j, (enum loft_twist)twist, &b) == LOFT_OK &&
              loft_bicubic_from_grid(p, 5, 5, i, j + 1, (enum loft_twist)twist, &right) ==
                  LOFT_OK &&
              loft_bicubic_from_grid(p, 5, 5, i + 1, j, (enum loft_twist)twist, &below) == LOFT_OK);
        for (int k = 0; k < 4; k++) {
            CHECK(loft_vec_equal(b.at[k][1], right.at[k][0]) &&
                  loft_vec_equal(b.at[k][3], right.at[k][2]));
            CHECK(loft_vec_equal(b.at[1][k], below.at[0][k]) &&
                  loft_vec_equal(b.at[3][k], below.at[2][k]));
        }
        CHECK(loft_vec_equal(b.at[0][0], p[5 * i + j]));
    }
}

static void mistakes_are_refused(arb *a)
{
    loft_vec p[9];
    loft_bicubic b;

    for (int k = 0; k < 9; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            p[k].axis[i] = k % 2 ? LOFT_REAL_MAX : -LOFT_REAL_MAX;
    (void)a;
    CHECK(loft_bicubic_from_grid(p, 1, 9, 0, 0, LOFT_TWIST_ZERO, &b) == LOFT_ERR_ARG &&
          loft_bicubic_from_grid(p, 3, 3, 2, 0, LOFT_TWIST_ZERO, &b) == LOFT_ERR_ARG &&
          loft_bicubic_from_grid(p, 3, 3, 0, 2, LOFT_TWIST_ZERO, &b) == LOFT_ERR_ARG &&
          loft_bicubic_from_grid(p, 3, 3, 0, 0, (enum loft_twist)3, &b) == LOFT_ERR_ARG &&
          loft_bicubic_from_grid(p, 3, 3, 0, 0, LOFT_TWIST_ZERO, &b) == LOFT_ERR_RANGE);
}

int main(void)
{
    PROPERTY(bessel_is_right_for_biquadratics,     300);
    PROPERTY(adini_is_right_for_translations,      300);
    PROPERTY(bilinear_grids_of_any_size_are_right, 300);
    PROPERTY(adini_is_the_twist_of_a_coons_patch,  300);
    PROPERTY(cells_have_common_data,               300);
    PROPERTY(mistakes_are_refused,                   1);
    return check_failures();
}
