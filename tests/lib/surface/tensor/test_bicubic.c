/* tests/lib/surface/tensor/test_bicubic.c -- properties of lib/surface/tensor/bicubic.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact.h"
#include "surface/tensor/bicubic.h"

static loft_bicubic arb_bicubic(arb *a, int32_t limit)
{
    loft_bicubic b;

    for (int k = 0; k < 16; k++)
        b.at[k / 4][k % 4] = arb_vec(a, limit);
    return b;
}

/* The k-th derivative of Hermite's polynomials, in the order value 0, value 1, slope 0, slope 1. */
static long double hermite(int which, unsigned k, long double t)
{
    static const int power[4][4] = {
        { 1, 0, -3, 2 }, { 0, 0, 3, -2 }, { 0, 1, -2, 1 }, { 0, 0, -1, 1 }
    };
    long double sum = 0;

    for (unsigned n = 3; n + 1 > k; n--) {
        long double factor = power[which][n];
        for (unsigned i = 0; i < k; i++)
            factor *= n - i;
        sum = sum * t + factor;
    }
    return sum;
}

static long double reference(const loft_bicubic *b, int axis, unsigned j, unsigned k, long double u,
                             long double v)
{
    long double sum = 0;

    for (int r = 0; r < 4; r++)
        for (int c = 0; c < 4; c++)
            sum += hermite(r, j, u) * hermite(c, k, v) * exact_of(b->at[r][c].axis[axis]);
    return sum;
}

/* Errors of a row and gains, as bicubic.c derives them: q16 in 2^-33, f64 in ulp. */
static long double promised(unsigned j, unsigned k)
{
    static const long double gain[4] = { 1.25L, 5, 20, 36 },
                             error[2][4] = { { 4, 2, 1, 0 }, { 22, 216, 432, 432 } };
    const long double *e = error[BY_NUM(0, 1, 1)];
    return gain[j] * e[k] + e[j] * BY_NUM(1, gain[k], gain[k]);
}

static void derivatives_keep_their_bound(arb *a)
{
    const int32_t limit = arb_below(a, 3) ? 100 : 32767;
    const loft_bicubic b = arb_bicubic(a, limit);
    const loft_unit u = arb_unit(a), v = arb_unit(a);

    for (unsigned j = 0; j < 5; j++)
        for (unsigned k = 0; k < 5; k++) {
            loft_vec p = { { 0 } };
            const enum loft_status status = loft_bicubic_deriv(&b, j, k, u, v, &p);
            bool fits = true;
            for (int i = 0; i < LOFT_AXES; i++) {
                const long double want = j > 3 || k > 3
                                             ? 0
                                             : reference(&b, i, j, k, exact_unit(u), exact_unit(v));
                fits = fits && want > BY_NUM(-32768 - LSB / 2, -INFINITY, -INFINITY) &&
                       want < BY_NUM(32768 - LSB / 2, INFINITY, INFINITY);
                if (status == LOFT_OK && j < 4 && k < 4)
                    CHECK_EXACT(exact_of(p.axis[i]), want,
                                BY_NUM(LSB / 2, ulp(want) / 2 + ulp(limit) / 2, 0) +
                                    promised(j, k) * BY_NUM(0x1p-33L, 0, ulp(limit)));
            }
            CHECK(status == (fits ? LOFT_OK : LOFT_ERR_RANGE));
        }
}

/* Corners, tangents and twists are interpolated: the data come back. */
static void corners_are_met(arb *a)
{
    const loft_bicubic b = arb_bicubic(a, 3000);

    for (unsigned r = 0; r < 4; r++)
        for (unsigned c = 0; c < 4; c++) {
            loft_vec p = { { 0 } };
            CHECK(loft_bicubic_deriv(&b, r / 2, c / 2, r % 2 ? LOFT_UNIT(1) : 0,
                                     c % 2 ? LOFT_UNIT(1) : 0, &p) == LOFT_OK);
            CHECK(loft_vec_equal(p, b.at[r][c]));
        }
}

/* The net of the tensor product has the corners, and gives the same point by de Casteljau. */
static void tensor_is_the_same_patch(arb *a)
{
    const loft_bicubic b = arb_bicubic(a, 9000);
    const loft_unit u = arb_unit(a), v = arb_unit(a);
    loft_vec net[16], p = { { 0 } };

    CHECK(loft_tensor_from_bicubic(&b, net) == LOFT_OK &&
          loft_bicubic_eval(&b, u, v, &p) == LOFT_OK);
    CHECK(loft_vec_equal(net[0], b.at[0][0]) && loft_vec_equal(net[3], b.at[0][1]));
    CHECK(loft_vec_equal(net[12], b.at[1][0]) && loft_vec_equal(net[15], b.at[1][1]));
    for (int i = 0; i < LOFT_AXES; i++) {
        long double rows[4], c[4];
        for (int r = 0; r < 4; r++) {
            for (int k = 0; k < 4; k++)
                c[k] = exact_of(net[4 * r + k].axis[i]);
            rows[r] = exact_eval(c, 3, exact_unit(v));
        }
        CHECK_EXACT(exact_of(p.axis[i]), exact_eval(rows, 3, exact_unit(u)),
                    BY_NUM(1.002L * LSB, 2 * ulp(16000), 80 * ulp(16000)));
    }
}

/* Moving the corners moves the patch; exchanging u and v gives the same point. */
static void moves_and_turns_with_its_data(arb *a)
{
    loft_bicubic b = arb_bicubic(a, 500), turned;
    const loft_unit u = arb_unit(a), v = arb_unit(a);
    loft_vec p = { { 0 } }, q = { { 0 } }, d;

    for (int i = 0; i < LOFT_AXES; i++)
        d.axis[i] = loft_real_from_int((int32_t)arb_below(a, 2000) - 1000);
    CHECK(loft_bicubic_eval(&b, u, v, &p) == LOFT_OK);
    for (int k = 0; k < 16; k++)
        turned.at[k % 4][k / 4] = b.at[k / 4][k % 4];
    CHECK(loft_bicubic_eval(&turned, v, u, &q) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(p.axis[i]), exact_of(q.axis[i]),
                    BY_NUM(LSB, ulp(1000), 112 * ulp(1000)));
    for (int k = 0; k < 4; k++)
        b.at[k / 2][k % 2] = loft_vec_add(b.at[k / 2][k % 2], d);
    CHECK(loft_bicubic_eval(&b, u, v, &q) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(q.axis[i]), exact_of(p.axis[i]) + exact_of(d.axis[i]),
                    BY_NUM(LSB, 2 * ulp(2500), 112 * ulp(2500)));
}

static void refuses_what_is_outside(arb *a)
{
    const loft_bicubic b = arb_bicubic(a, 1000);
    loft_vec p = { { 0 } };

    CHECK(loft_bicubic_eval(&b, LOFT_UNIT(-0.001), 0, &p) == LOFT_ERR_ARG &&
          loft_bicubic_eval(&b, 0, LOFT_UNIT(1.001), &p) == LOFT_ERR_ARG);
}

/* C0, C1 and G1 of joins that are constructed so, and after a change by one LSB. */
static void joins_are_what_they_were_made(arb *a)
{
    loft_bicubic c = arb_bicubic(a, 3000), g = arb_bicubic(a, 3000);
    const int32_t factor = 1 + (int32_t)arb_below(a, 9);
    const int row = (int)arb_below(a, 4), axis = (int)arb_below(a, LOFT_AXES);
    loft_bicubic_join j;

    for (int r = 0; r < 4; r++) {
        g.at[r][0] = c.at[r][1];
        for (int i = 0; i < LOFT_AXES; i++) {
            const int32_t x = (int32_t)arb_below(a, 2001) - 1000;
            c.at[r][3].axis[i] = loft_real_from_int(x);
            g.at[r][2].axis[i] = loft_real_from_int(factor * x);
        }
    }
    c.at[0][3].axis[0] = LOFT_REAL(1);
    g.at[0][2].axis[0] = loft_real_from_int(factor);
    CHECK(loft_bicubic_join_init(&j, &c, &g) == LOFT_OK && j.c0 && j.g1 && j.c1 == (factor == 1));
    CHECK_EXACT(exact_of(j.lambda), factor, 0);
    CHECK(loft_bicubic_join_init(&j, &g, &c) == LOFT_OK &&
          j.c0 == loft_vec_equal(g.at[0][1], c.at[0][0]));

    loft_bicubic bent = g;
    for (int r = 0; r < 4; r++)
        for (int i = 0; i < LOFT_AXES; i++)
            bent.at[r][2].axis[i] = -g.at[r][2].axis[i];
    CHECK(loft_bicubic_join_init(&j, &c, &bent) == LOFT_OK && j.c0 && !j.c1 && !j.g1);
    bent = g;
    bent.at[row][2].axis[axis] += loft_real_from_raw(1);
    if (exact_of(bent.at[row][2].axis[axis]) > exact_of(g.at[row][2].axis[axis]))
        CHECK(loft_bicubic_join_init(&j, &c, &bent) == LOFT_OK && j.c0 && !j.c1 && !j.g1);
    bent = g;
    bent.at[row][0].axis[axis] += loft_real_from_raw(1);
    if (exact_of(bent.at[row][0].axis[axis]) > exact_of(g.at[row][0].axis[axis]))
        CHECK(loft_bicubic_join_init(&j, &c, &bent) == LOFT_OK && !j.c0 && !j.c1 && !j.g1);
}

/* A factor that no coordinate holds is reported, and the flags are right. A derivative of 0 gives
 * no direction. */
static void extreme_joins_are_answers(arb *a)
{
    loft_bicubic c = arb_bicubic(a, 3000), g = c;
    const loft_vec nothing = { { 0 } };
    loft_bicubic_join j;

    for (int r = 0; r < 4; r++) {
        g.at[r][0] = c.at[r][1];
        c.at[r][3] = g.at[r][2] = nothing;
    }
    CHECK(loft_bicubic_join_init(&j, &c, &g) == LOFT_OK && j.c0 && j.c1 && !j.g1);
    c.at[2][3].axis[0] = loft_real_from_raw(1);
    g.at[2][2].axis[0] = LOFT_REAL(2);
    CHECK(loft_bicubic_join_init(&j, &c, &g) == BY_NUM(LOFT_ERR_RANGE, LOFT_OK, LOFT_OK) && j.c0 &&
          !j.c1 && j.g1);
}

int main(void)
{
    PROPERTY(derivatives_keep_their_bound, 600);
    PROPERTY(corners_are_met, 200);
    PROPERTY(tensor_is_the_same_patch, 400);
    PROPERTY(moves_and_turns_with_its_data, 300);
    PROPERTY(refuses_what_is_outside, 3);
    PROPERTY(joins_are_what_they_were_made, 200);
    PROPERTY(extreme_joins_are_answers, 20);
    return check_failures();
}
