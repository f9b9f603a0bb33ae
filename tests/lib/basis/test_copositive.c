/* tests/lib/basis/test_copositive.c -- properties of lib/basis/copositive.h
 * SPDX-License-Identifier: MIT
 */
#include "check.h"
#include "basis/copositive.h"

#define DEPTH 40

typedef struct {
    int64_t v[4][4];        /* corner k is v[k], any positive multiple of it */
    int depth;
} simplex;

static int64_t form(int32_t m[4][4], int n, const int64_t x[4], const int64_t y[4])
{
    int64_t sum = 0;

    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            sum += x[i] * m[i][j] * y[j];
    return sum;
}

/* 1: copositive, -1: not, 0: undecided after this many cuts. Nonnegative products of all corners
 * prove the first, a corner with a negative value the second; a cut goes through the edge with the
 * most negative product. */
static int cut_the_simplex(int32_t m[4][4], int n)
{
    static simplex stack[DEPTH + 2];
    int top = 1, cuts = 0;

    stack[0] = (simplex) { { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 }, { 0, 0, 0, 1 } }, 0 };
    while (top > 0) {
        simplex s = stack[--top];
        int64_t least = 0;
        int a = 0, b = 0;
        for (int i = 0; i < n; i++)
            for (int j = i; j < n; j++) {
                const int64_t f = form(m, n, s.v[i], s.v[j]);
                if (f < 0 && i == j)
                    return -1;
                if (f < least) {
                    least = f;
                    a = i;
                    b = j;
                }
            }
        if (least == 0)
            continue;
        if (s.depth == DEPTH / 2 || ++cuts > 3000)
            return 0;
        s.depth++;
        stack[top] = stack[top + 1] = s;
        for (int i = 0; i < n; i++)
            stack[top].v[a][i] = stack[top + 1].v[b][i] = s.v[a][i] + s.v[b][i];
        top += 2;
    }
    return 1;
}

static bool decide(int32_t m[4][4], int n)
{
    loft_real upper[10];
    bool flag = false;
    int k = 0;

    for (int i = 0; i < n; i++)
        for (int j = i; j < n; j++)
            upper[k++] = loft_real_from_raw(m[i][j]);
    CHECK(loft_matrix_copositive(upper, (unsigned)n, &flag) == LOFT_OK);
    return flag;
}

static int arb_matrix(arb *a, int32_t m[4][4], int32_t diagonal, int32_t limit)
{
    const int n = 1 + (int)arb_below(a, 4);

    for (int i = 0; i < n; i++) {
        for (int j = 0; j < i; j++)
            m[i][j] = m[j][i] = (int32_t)arb_below(a, (uint32_t)(2 * limit + 1)) - limit;
        m[i][i] = (int32_t)arb_below(a, (uint32_t)diagonal + 1) - (arb_below(a, 16) == 0);
    }
    return n;
}

static void agrees_with_cutting_the_simplex(arb *a)
{
    int32_t m[4][4];
    const int n = arb_matrix(a, m, 9, 5), sure = cut_the_simplex(m, n);

    if (sure)
        CHECK(decide(m, n) == (sure > 0));
}

/* The test above is not empty: few cases are undecided, and many of order 3 and above are of either
 * kind. */
static void cutting_decides_most(arb *a)
{
    int undecided = 0, of_a_kind[2] = { 0, 0 };

    for (int k = 0; k < 400; k++) {
        int32_t m[4][4];
        const int n = arb_matrix(a, m, 9, 5), sure = cut_the_simplex(m, n);
        undecided += sure == 0;
        of_a_kind[sure > 0] += n >= 3 && sure != 0;
    }
    CHECK(undecided < 20 && of_a_kind[0] > 40 && of_a_kind[1] > 40);
}

/* The order of the variables and their units do not matter. */
static void permuted_and_scaled_is_the_same(arb *a)
{
    int32_t m[4][4], q[4][4];
    const int n = arb_matrix(a, m, 900, 500);
    int at[4] = { 0, 1, 2, 3 };

    for (int i = n - 1; i > 0; i--) {
        const int j = (int)arb_below(a, (uint32_t)i + 1), old = at[i];
        at[i] = at[j];
        at[j] = old;
    }
    const int32_t unit[4] = { 1, 3, 8, 21 };
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            q[i][j] = m[at[i]][at[j]] * unit[i] * unit[j];
    CHECK(decide(m, n) == decide(q, n));
}

/* A matrix of the products of n vectors that sum to 0 is 0 at (1 .. 1) and nowhere negative. With
 * one LSB less it is negative there. */
static void one_lsb_decides(arb *a)
{
    const int n = 2 + (int)arb_below(a, 3), d = 1 + (int)arb_below(a, 3);
    int32_t v[4][3] = { { 0 } }, m[4][4];

    for (int i = 0; i + 1 < n; i++)
        for (int k = 0; k < d; k++) {
            v[i][k] = (int32_t)arb_below(a, 1601) - 800;
            v[n - 1][k] -= v[i][k];
        }
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            m[i][j] = v[i][0] * v[j][0] + v[i][1] * v[j][1] + v[i][2] * v[j][2];
    CHECK(decide(m, n));
    const int i = (int)arb_below(a, (uint32_t)n);
    m[i][i]--;
    CHECK(!decide(m, n));
    m[i][i] += 2;
    CHECK(decide(m, n));
}

/* The extremes of a coordinate: four factors of 31 bits. */
static void takes_the_largest_numbers(arb *a)
{
    loft_real m[10];
    bool flag = true;

    for (int k = 0; k < 10; k++)
        m[k] = arb_below(a, 2) ? LOFT_REAL(32767) : LOFT_REAL(-32767);
    m[0] = m[4] = m[7] = m[9] = LOFT_REAL(32767);
    CHECK(loft_matrix_copositive(m, 4, &flag) == LOFT_OK);
    for (int set = 0; set < 16; set++) {                /* a negative sum over a set of variables
                                                         * refutes it */
        int sum = 0, k = 0;
        for (int i = 0; i < 4; i++)
            for (int j = i; j < 4; j++, k++)
                if (set >> i & 1 && set >> j & 1)
                    sum += (m[k] > 0 ? 1 : -1) * (i == j ? 1 : 2);
        CHECK(sum >= 0 || !flag);
    }
}

static void refuses_other_orders_and_numbers(arb *a)
{
    loft_real m[15] = { 0 };
    bool flag = true;
    const loft_real odd = BY_NUM(0, 1e30f, 1e300);

    (void)a;
    CHECK(loft_matrix_copositive(m, 0, &flag) == LOFT_ERR_ARG);
    CHECK(loft_matrix_copositive(m, 5, &flag) == LOFT_ERR_ARG);
    m[9] = odd;
    CHECK(loft_matrix_copositive(m, 4, &flag) == BY_NUM(LOFT_OK, LOFT_ERR_RANGE, LOFT_ERR_RANGE));
    CHECK(flag);
}

int main(void)
{
    PROPERTY(agrees_with_cutting_the_simplex, 1000);
    PROPERTY(cutting_decides_most, 1);
    PROPERTY(permuted_and_scaled_is_the_same, 300);
    PROPERTY(one_lsb_decides, 400);
    PROPERTY(takes_the_largest_numbers, 50);
    PROPERTY(refuses_other_orders_and_numbers, 1);
    return check_failures();
}
