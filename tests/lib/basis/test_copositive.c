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

/* Place (i, j) of the upper triangle of order n. */
static unsigned place_of(unsigned n, unsigned i, unsigned j)
{
    const unsigned row = i < j ? i : j, column = i < j ? j : i;
    return row * n - row * (row + 1) / 2 + column;
}

/* Horn's matrix of order 5, scaled and permuted, in order 5 or 6: copositive, though neither
 * semidefinite nor the sum of such a matrix and a nonnegative one. One LSB less on its diagonal or
 * beside it, and it is not. */
static void horn_matrices_are_copositive_by_one_lsb(arb *a)
{
    const unsigned n = 5 + arb_below(a, 2);
    unsigned order[6] = { 0, 1, 2, 3, 4, 5 };
    const int32_t scale = 1 + (int32_t)arb_below(a, 1000);
    loft_real m[21] = { 0 };
    bool flag = false;

    for (unsigned i = n - 1; i > 0; i--) {
        const unsigned k = arb_below(a, i + 1), swap = order[i];
        order[i] = order[k];
        order[k] = swap;
    }
    for (unsigned i = 0; i < 5; i++)
        for (unsigned j = i; j < 5; j++) {
            const unsigned apart = (j - i) % 5;
            const int32_t sign = apart == 1 || apart == 4 ? -1 : 1;
            m[place_of(n, order[i], order[j])] = loft_real_from_raw(sign * scale);
        }
    CHECK(loft_matrix_copositive(m, n, &flag) == LOFT_OK && flag);
    const unsigned i = arb_below(a, 5), j = arb_below(a, 2) ? i : (i + 1) % 5;
    loft_real *one = &m[place_of(n, order[i], order[j])];
    *one = loft_real_from_raw(loft_raw_from_real(*one) - 1);
    CHECK(loft_matrix_copositive(m, n, &flag) == LOFT_OK && !flag);
}

/* Orders 5 and 6: a Gram matrix plus a nonnegative one is copositive; a nonnegative vector with a
 * negative form refutes. */
static void orders_five_and_six_agree_with_samples(arb *a)
{
    const unsigned n = 5 + arb_below(a, 2);
    int32_t g[6][6], m[6][6];
    loft_real upper[21];
    bool flag = false, refuted = false, gram = arb_below(a, 2);

    for (unsigned i = 0; i < n; i++)
        for (unsigned j = 0; j < n; j++)
            g[i][j] = (int32_t)arb_below(a, 7) - 3;
    for (unsigned i = 0; i < n; i++)
        for (unsigned j = i; j < n; j++) {
            int32_t sum = gram ? (int32_t)arb_below(a, 2) : g[i][j] + (i == j ? 4 : 0);
            for (unsigned k = 0; k < n && gram; k++)
                sum += g[k][i] * g[k][j];
            m[i][j] = m[j][i] = sum;
            upper[place_of(n, i, j)] = loft_real_from_raw(sum);
        }
    CHECK(loft_matrix_copositive(upper, n, &flag) == LOFT_OK);
    CHECK(flag || !gram);
    for (int tries = 0; tries < 300; tries++) {
        int32_t x[6], form = 0;
        for (unsigned i = 0; i < n; i++)
            x[i] = arb_below(a, 2) ? (int32_t)arb_below(a, 5) : 0;
        for (unsigned i = 0; i < n; i++)
            for (unsigned j = 0; j < n; j++)
                form += x[i] * x[j] * m[i][j];
        refuted = refuted || form < 0;
    }
    CHECK(!refuted || !flag);
}

static void refuses_other_orders_and_numbers(arb *a)
{
    loft_real m[28] = { 0 };
    bool flag = true;
    const loft_real odd = BY_NUM(0, 1e30f, 1e300);

    (void)a;
    CHECK(loft_matrix_copositive(m, 0, &flag) == LOFT_ERR_ARG);
    CHECK(loft_matrix_copositive(m, 7, &flag) == LOFT_ERR_ARG);
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
    PROPERTY(horn_matrices_are_copositive_by_one_lsb, 60);
    PROPERTY(orders_five_and_six_agree_with_samples, 60);
    PROPERTY(refuses_other_orders_and_numbers, 1);
    return check_failures();
}
