/* lib/surface/triangle/triangle_shape.c
 * SPDX-License-Identifier: MIT
 *
 * Coefficients have R bits (31, in floats 128). The longest decision is of degree 6 in them:
 * roots_sign.
 */
#include "surface/triangle/triangle_shape.h"
#include "num/exact.h"          /* loft_exact: the decisions */

static bool coefficients_valid(const loft_real b[], unsigned count)
{
    for (unsigned k = 0; k < count; k++)
        if (!loft_exact_valid(b[k]))
            return false;
    return true;
}

/* The index of b_ijk, for every degree: 1 + 2 + .. + (j + k) before its row, and k in its row. */
static unsigned place_of(unsigned j, unsigned k)   { return (j + k) * (j + k + 1) / 2 + k; }
static unsigned count_of(unsigned degree)       { return (degree + 1) * (degree + 2) / 2; }

static loft_exact product3(loft_exact x, loft_exact y, loft_exact z)
{
    return loft_exact_mul(x, loft_exact_mul(y, z));
}

/* Positive quadratics */

typedef struct {
    loft_exact square[3], mixed[3];     /* A B C, a b c */
} form;

/* x + y sqrt(z), given s, the sign of x^2 - y^2 z */
static int surd_sign(int x, int y, int s) { return x == y ? x : x == 0 ? y : y == 0 ? x : x * s; }

/* a + sqrt(B C) */
static int edge_sign(loft_exact a, loft_exact b, loft_exact c)
{
    const loft_exact bc = loft_exact_mul(b, c);
    return surd_sign(loft_exact_sign(a), loft_exact_sign(bc),
                     loft_exact_compare(loft_exact_mul(a, a), bc));
}

/* The sign of sqrt(A B C) + a sqrt A + b sqrt B + c sqrt C for A, B, C >= 0. With
 *
 *     p = sqrt A (sqrt(B C) + a)      q = b sqrt B + c sqrt C      p^2 - q^2 = m + n sqrt(B C)
 *     m = A (B C + a^2) - b^2 B - c^2 C      n = 2 (a A - b c)
 *
 * every sign is that of some x + y sqrt z. Range: m is below 2^(3 R + 2), m^2 and n^2 B C below
 * 2^(6 R + 4): 190 bits in q16, 772 in floats. */
static int roots_sign(const form *f)
{
    const loft_exact *s = f->square, *x = f->mixed;
    const loft_exact bc = loft_exact_mul(s[1], s[2]), aa = loft_exact_mul(x[0], x[0]);
    const loft_exact bbb = product3(x[1], x[1], s[1]), ccc = product3(x[2], x[2], s[2]);
    const int p = loft_exact_sign(s[0]) * edge_sign(x[0], s[1], s[2]);
    const int q = surd_sign(loft_exact_sign(x[1]) * loft_exact_sign(s[1]),
                            loft_exact_sign(x[2]) * loft_exact_sign(s[2]),
                            loft_exact_compare(bbb, ccc));

    if (p == q || p == 0 || q == 0)
        return p ? p : q;
    const loft_exact half = loft_exact_sub(loft_exact_mul(x[0], s[0]), loft_exact_mul(x[1], x[2]));
    const loft_exact n = loft_exact_add(half, half);
    const loft_exact m = loft_exact_sub(loft_exact_mul(s[0], loft_exact_add(bc, aa)),
                                        loft_exact_add(bbb, ccc));
    const int squares = loft_exact_compare(loft_exact_mul(m, m), product3(n, n, bc));

    return p * surd_sign(loft_exact_sign(m), loft_exact_sign(n) * loft_exact_sign(bc), squares);
}

static int determinant_sign(const form *f)
{
    const loft_exact *s = f->square, *x = f->mixed;
    const loft_exact abc = product3(x[0], x[1], x[2]);
    loft_exact sum = loft_exact_add(product3(s[0], s[1], s[2]), loft_exact_add(abc, abc));

    for (int i = 0; i < 3; i++)
        sum = loft_exact_sub(sum, product3(s[i], x[i], x[i]));
    return loft_exact_sign(sum);
}

enum loft_status loft_triangle2_sign(const loft_real b[6], loft_triangle_sign *out)
{
    static const uint8_t square[3] = { 0, 3, 5 }, mixed[3] = { 4, 2, 1 };
    bool diagonal = true;
    form f;

    if (!coefficients_valid(b, 6))
        return LOFT_ERR_RANGE;
    for (int i = 0; i < 3; i++) {
        f.square[i] = loft_exact_from_real(b[square[i]]);
        f.mixed[i]  = loft_exact_from_real(b[mixed[i]]);
        diagonal = diagonal && loft_exact_sign(f.square[i]) >= 0;
    }
    out->edges = diagonal;
    for (int i = 0; i < 3 && out->edges; i++)
        out->edges = edge_sign(f.mixed[i], f.square[(i + 1) % 3], f.square[(i + 2) % 3]) >= 0;
    out->roots       = diagonal && roots_sign(&f) >= 0;
    out->determinant = determinant_sign(&f) >= 0;
    out->nonnegative = out->edges && (out->roots || out->determinant);
    return LOFT_OK;
}


/* Wang and Liu. (n-1)! i / (i! j! k!) = (n-1)! / ((i-1)! j! k!) = C(n-1, k) C(n-1-k, j): at most
 * 560 for n = 9. All factors of one corner sum to 3^(n-1) <= 6561 < 2^12.7. With the corner itself
 * a sum is below 2^(R + 13). */

static loft_exact wang_liu_sum(const loft_real b[], unsigned degree, int corner)
{
    const unsigned corners[3] = { place_of(0, 0), place_of(degree, 0), place_of(0, degree) };
    loft_exact sum = loft_exact_from_real(b[corners[corner]]);

    for (unsigned rest = 0; rest <= degree; rest++)
        for (unsigned k = 0; k <= rest; k++) {
            unsigned index[3] = { degree - rest, rest - k, k };
            const loft_real value = b[place_of(index[1], index[2])];
            if (!(value < 0) || index[corner] == 0)
                continue;
            index[corner]--;
            const int32_t factor = loft_binomial(degree - 1, index[2]) *
                                   loft_binomial(degree - 1 - index[2], index[1]);
            sum = loft_exact_add(
                sum, loft_exact_mul(loft_exact_from_int(factor), loft_exact_from_real(value)));
        }
    return sum;
}

enum loft_status loft_triangle_wang_liu(const loft_real b[], unsigned degree, bool *nonnegative,
                                        loft_real sums[3])
{
    enum loft_status status = LOFT_OK;
    bool all = true;

    if (degree < 1 || degree > LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    if (!coefficients_valid(b, count_of(degree)))
        return LOFT_ERR_RANGE;
    for (int corner = 0; corner < 3; corner++) {
        const loft_exact sum = wang_liu_sum(b, degree, corner);
        loft_acc x;

        all = all && loft_exact_sign(sum) >= 0;
        sums[corner] = 0;
        if (loft_exact_quot(sum, loft_exact_from_int(1), -LOFT_EXACT_REAL, &x) && loft_acc_valid(x))
            sums[corner] = loft_acc_round(x);
        else
            status = LOFT_ERR_RANGE;
    }
    *nonnegative = all;
    return status;
}


/* Convex nets. b_xy is the coefficient at (i j k) plus unit steps x and y. D1 = b_11 - b_12 - b_13
 * + b_23, D2 and D3 in cyclic order. D is below 2^(R + 2). A sum of three products of two D is
 * below 2^(2 R + 5.6). */

/* b at (j, k) with the steps x and y, each 0, 1 or 2 for i, j or k */
static loft_exact stepped_coefficient(const loft_real b[], unsigned j, unsigned k, int x, int y)
{
    return loft_exact_from_real(b[place_of(j + (x == 1) + (y == 1), k + (x == 2) + (y == 2))]);
}

static void second_differences(const loft_real b[], unsigned j, unsigned k, loft_exact d[3])
{
    for (int x = 0; x < 3; x++) {
        const int y = (x + 1) % 3, z = (x + 2) % 3;
        const loft_exact plus = loft_exact_add(stepped_coefficient(b, j, k, x, x),
                                               stepped_coefficient(b, j, k, y, z));
        d[x] = loft_exact_sub(plus, loft_exact_add(stepped_coefficient(b, j, k, x, y),
                                                   stepped_coefficient(b, j, k, x, z)));
    }
}

/* Test one index of degree n - 2. (E2 - E3)^2 b = D2 + D3, so the sum of two is the convexity along
 * a mesh line. */
static void test_index(const loft_real b[], unsigned j, unsigned k, loft_net_convexity *out)
{
    loft_exact d[3], sum = loft_exact_from_int(0);
    bool pairs = true;

    second_differences(b, j, k, d);
    for (int x = 0; x < 3; x++) {
        const loft_exact y = d[(x + 1) % 3], z = d[(x + 2) % 3];
        const bool along = loft_exact_sign(loft_exact_add(y, z)) >= 0;

        out->net = out->net && loft_exact_sign(d[x]) >= 0;
        out->line[x] = out->line[x] && along;
        pairs = pairs && along;
        sum = loft_exact_add(sum, loft_exact_mul(y, z));
    }
    out->weak = out->weak && pairs && loft_exact_sign(sum) >= 0;
}

/* Whether steps in direction x, from E(x+1) to E(x+2), all go up, all down, or differ. */
static int8_t trend_of(const loft_real b[], unsigned degree, int x)
{
    bool up = false, down = false;

    for (unsigned rest = 0; rest < degree; rest++)
        for (unsigned k = 0; k <= rest; k++) {
            const unsigned j = rest - k;
            const int from = (x + 1) % 3, to = (x + 2) % 3;
            const loft_real a = b[place_of(j + (from == 1), k + (from == 2))],
                            z = b[place_of(j + (to == 1), k + (to == 2))];
            up   = up || a < z;
            down = down || a > z;
        }
    return up && down ? LOFT_TREND_NONE : (int8_t)(up - down);
}

enum loft_status loft_triangle_convex(const loft_real b[], unsigned degree, loft_net_convexity *out)
{
    loft_net_convexity c = { true, true, { true, true, true }, { 0, 0, 0 } };

    if (degree > LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    if (!coefficients_valid(b, count_of(degree)))
        return LOFT_ERR_RANGE;
    for (unsigned rest = 0; rest + 2 <= degree; rest++)
        for (unsigned k = 0; k <= rest; k++)
            test_index(b, rest - k, k, &c);
    for (int x = 0; x < 3; x++)
        c.trend[x] = trend_of(b, degree, x);
    *out = c;
    return LOFT_OK;
}
