/* lib/num/walk2.c -- the differences of a polynomial in two variables, from its control values
 * SPDX-License-Identifier: MIT
 *
 * Let b be the control values, and D and E the differences of the net from row to row and along the
 * rows. The polynomial at u = i / rows, v = j / columns is
 *
 *     square     sum  C(p,k) C(q,l) D^k E^l b  (i / rows)^k (j / columns)^l
 *     triangle   sum  p! / (k! l! (p-k-l)!) D^k E^l b  (i / n)^k (j / n)^l,      k + l <= p
 *
 * In the triangle E is taken from row l downwards, where it exists. With the shifts E1, E2, E3 to
 * the corners, row i and place j of it is the point ((n - i) E1 + (i - j) E2 + j E3)^p b / n^p. Its
 * operator is E1 + i/n (E2 - E1) + j/n (E3 - E2). The factor is C(q,l) C(p,k) in the square and
 * C(p,l) C(p-l,k) in the triangle.
 *
 * q16. The coefficients g are integers, |g| < 2^5 2^5 C C 2^31 < 2^48. g / (rows^k columns^l) is
 * truncated to 64 bits below the LSB by k + l truncating divisions: its error is less than 2^-63.
 * The differences are sums of these quotients times integers (num/walk.c). All these integers
 * together are below 541^2 < 2^18.2, so the error of a difference is less than 2^-44 before it is
 * rounded to 32 bits. A difference that is a multiple of 2^-32 is exact.
 *
 * The law of ranges. The value at (i, j) is sum C(i,k) C(j,l) d[l][k], so its error is at most S
 * (2^-33 + 2^-44), with
 *
 *     square     S = (1 + S_u) (1 + S_v) - 1,   S_u = C(rows,1) + .. + C(rows,p),  S_v likewise
 *     triangle   S = C(2n,1) + .. + C(2n,p)
 *
 * since C(2n,s) is the sum of C(n,k) C(n,l) over k + l = s. The walk is valid while this is below
 * 1/2, that is for S <= 2^32 - 2^22. It is also valid if nothing is rounded, for powers of two with
 *
 *     square     p log2 rows + q log2 columns <= 32
 *     triangle   p log2 n <= 32
 *     blend      p log2 rows + log2 columns <= 32 and log2 rows + q log2 columns <= 32
 *
 * Values then stay within the 32 bits of the net, and everything else may wrap.
 */
#include "num/walk2.h"

#define BINOMIAL_SUM_MAX (UINT32_MAX - 4194303)

static uint64_t binomial_sum(unsigned degree, uint64_t n)
{
    uint64_t choose = 1, sum = 0;

    for (unsigned k = 1; k <= degree && k <= n && sum <= BINOMIAL_SUM_MAX; k++) {
        choose = choose * (n - k + 1) / k;      /* both factors are below 2^32 once k > 1 */
        sum += choose;
    }
    return sum;
}

/* log2 n, or 33 if n is not a power of two */
static unsigned log2_exact(uint32_t n)
{
    unsigned m = 0;

    if (n & (n - 1))
        return 33;
    for (; n > 1; n >>= 1)
        m++;
    return m;
}

bool loft_walk2_steps_valid(const loft_walk2 *s)
{
    if (s->triangle)
        return s->p * log2_exact(s->rows) <= 32 ||
               binomial_sum(s->p, (uint64_t)s->rows * 2) <= BINOMIAL_SUM_MAX;
    const unsigned a = log2_exact(s->rows), b = log2_exact(s->columns);
    if (s->blend ? s->p * a + b <= 32 && a + s->q * b <= 32 : s->p * a + s->q * b <= 32)
        return true;
    const uint64_t u = 1 + binomial_sum(s->p, s->rows), v = 1 + binomial_sum(s->q, s->columns);
    return u - 1 <= BINOMIAL_SUM_MAX && v - 1 <= BINOMIAL_SUM_MAX && u * v - 1 <= BINOMIAL_SUM_MAX;
}

static unsigned binomial(unsigned n, unsigned k)
{
    unsigned c = 1;

    for (unsigned i = 1; i <= k; i++)
        c = c * (n - i + 1) / i;
    return c;
}

/* Copy the values of the net into the state. In the triangle, row r, place c goes to column c at r
 * - c. */
static void load_net(loft_state d[], const loft_walk2 *s, const loft_real net[], size_t stride)
{
    for (unsigned r = 0; r <= s->p; r++) {
        const unsigned last = s->triangle ? r : s->q;
        for (unsigned c = 0; c <= last; c++, net += stride)
            d[loft_walk2_column(s, c) + (s->triangle ? r - c : r)] = (loft_state)*net;
    }
}

/* Apply E^l, then D^k, then the factors. Wrapping integers also represent negative numbers. */
static void powers_from_net(loft_state d[], const loft_walk2 *s)
{
    const unsigned lean = s->triangle;

    for (unsigned order = 1; order <= s->q; order++)
        for (unsigned l = s->q; l >= order; l--) {
            loft_state *column = d + loft_walk2_column(s, l),
                       *before = d + loft_walk2_column(s, l - 1) + lean;
            for (unsigned k = 0; k <= loft_walk2_degree(s, l); k++)
                column[k] -= before[k];
        }
    for (unsigned l = 0; l <= s->q; l++) {
        loft_state *column = d + loft_walk2_column(s, l);
        const unsigned degree = loft_walk2_degree(s, l);

        for (unsigned order = 1; order <= degree; order++)
            for (unsigned k = degree; k >= order; k--)
                column[k] -= column[k - 1];
        for (unsigned k = 0; k <= degree; k++)
            column[k] *= (loft_state)(binomial(s->q, l) * binomial(degree, k));
    }
}

/* The bilinear blend of the edges has the same polynomials at u = 0, v = 0, u = 1 and v = 1. The
 * polynomials at u = 0 and v = 0 are the coefficients with k = 0 or l = 0. At u = 1 the coefficient
 * of v^l is the sum over k; at v = 1 that of u^k is the sum over l. Coefficients with both k and l
 * above 1 are 0. */
static void blend_powers(loft_state g[], const loft_walk2 *s)
{
    const unsigned p = s->p, stride = p + 1;

    for (unsigned l = 2; l <= s->q; l++) {
        loft_state *column = g + l * stride, sum = column[1];
        for (unsigned k = 2; k <= p; k++) {
            sum += column[k];
            g[stride + k] += column[k];
            column[k] = 0;
        }
        g[stride + 1] += column[1] - sum;
        column[1] = sum;
    }
}

void loft_walk2_step(loft_state d[], const loft_walk2 *s)
{
    for (unsigned l = 0; l <= s->q; l++) {
        const unsigned degree = loft_walk2_degree(s, l);
        for (unsigned k = 0; k < degree; k++, d++)
            loft_state_add(d);
        d++;
    }
}

/* Turn power coefficients into differences, first by k, then by l. */
static void columns_to_differences(loft_state a[], const loft_walk2 *s)
{
    for (unsigned l = 0; l <= s->q; l++)
        loft_walk_differences(a + loft_walk2_column(s, l), loft_walk2_degree(s, l));
}

static void rows_to_differences(loft_state a[], const loft_walk2 *s)
{
    loft_state row[LOFT_WALK_DEGREE_MAX + 1];

    for (unsigned k = 0; k <= s->p; k++) {
        const unsigned degree = s->triangle ? s->p - k : s->q;
        for (unsigned l = 0; l <= degree; l++)
            row[l] = a[loft_walk2_column(s, l) + k];
        loft_walk_differences(row, degree);
        for (unsigned l = 0; l <= degree; l++)
            a[loft_walk2_column(s, l) + k] = row[l];
    }
}

#if LOFT_NUM == LOFT_Q16

bool loft_walk2_valid(loft_real a)
{
    (void)a;
    return true;
}

#define STATES ((LOFT_WALK_DEGREE_MAX + 1) * (LOFT_WALK_DEGREE_MAX + 1))

/* g / (rows^k columns^l): *d gets the part with 32 bits below the LSB, *below the next 32 bits. */
static void scale_coefficient(loft_state *d, loft_state *below, const loft_walk2 *s, unsigned k,
                              unsigned l)
{
    const bool minus = *d >> 63 != 0;
    const uint64_t size = minus ? 0 - *d : *d;
    uint32_t x[4] = { 0, 0, (uint32_t)(size & 0xffffffffu), (uint32_t)(size >> 32) };

    for (; k > 0; k--)
        loft_limbs_divide(x, 4, s->rows);
    for (; l > 0; l--)
        loft_limbs_divide(x, 4, s->columns);
    *below = x[0];
    *d = (uint64_t)x[2] << 32 | x[1];
    if (minus) {
        *below = (0 - *below) & 0xffffffffu;
        *d = 0 - *d - (*below != 0);
    }
}

/* `below` may exceed its 32 bits: it is at most 2^32 541 after one direction. */
static void carry_below(loft_state d[], loft_state below[], size_t count)
{
    for (size_t k = 0; k < count; k++) {
        d[k] += below[k] >> 32;
        below[k] &= 0xffffffffu;
    }
}

void loft_walk2_init(loft_state d[], const loft_walk2 *s, const loft_real net[], size_t stride)
{
    const size_t count = loft_walk2_column(s, s->q) + loft_walk2_degree(s, s->q) + 1;
    loft_state below[STATES];

    load_net(d, s, net, stride);
    powers_from_net(d, s);
    if (s->blend)
        blend_powers(d, s);
    for (unsigned l = 0; l <= s->q; l++)
        for (unsigned k = 0; k <= loft_walk2_degree(s, l); k++)
            scale_coefficient(&d[loft_walk2_column(s, l) + k], &below[loft_walk2_column(s, l) + k],
                              s, k, l);
    columns_to_differences(d, s);
    columns_to_differences(below, s);
    carry_below(d, below, count);
    rows_to_differences(d, s);
    rows_to_differences(below, s);
    for (size_t k = 0; k < count; k++)
        d[k] += (below[k] + 2147483648u) >> 32;
    d[0] += 2147483648u;
}

#else

/* Sums of |g| c(k) are below 2^30 times the largest value. */
bool loft_walk2_valid(loft_real a)
{
    const loft_real most = LOFT_REAL_MAX / 65536 / 65536;
    return a >= -most && a <= most;
}

void loft_walk2_init(loft_state d[], const loft_walk2 *s, const loft_real net[], size_t stride)
{
    load_net(d, s, net, stride);
    powers_from_net(d, s);
    if (s->blend)
        blend_powers(d, s);
    for (unsigned l = 0; l <= s->q; l++)
        for (unsigned k = 0; k <= loft_walk2_degree(s, l); k++) {
            loft_state *x = &d[loft_walk2_column(s, l) + k];
            for (unsigned j = 0; j < k; j++)
                *x /= s->rows;
            for (unsigned j = 0; j < l; j++)
                *x /= s->columns;
        }
    columns_to_differences(d, s);
    rows_to_differences(d, s);
}

#endif
