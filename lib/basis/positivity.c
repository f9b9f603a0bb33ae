/* lib/basis/positivity.c
 * SPDX-License-Identifier: MIT
 *
 * With x = t / (1 - t), (1 + x)^n p(t) = sum C(n, j) b_j x^j: roots inside 0..1 become positive
 * ones. Roots at 0 and 1 show as zero coefficients at the ends, which are cut off. Let q be the
 * rest, of degree m, q_0 and q_m not 0.
 *
 * Let s_k be the sum of the k-th powers of all roots of q. The Hankel form s_(i+j) has the rank r,
 * the number of different roots, and its signature is the number of different real roots; that of
 * s_(i+j+1) is the number of positive ones less that of negative ones. So there are half the sum of
 * both signatures of positive ones. A signature follows from the signs of the leading minors D_1 ..
 * D_r, D_r not 0: r minus twice the number of changes in 1, D_1, .., where p minors in a row that
 * are 0 get the signs (-1)^(j (j - 1) / 2) sign D_h, j = 1..p, of the last one D_h before them
 * (Frobenius).
 *
 * Bezout's matrix of q and g, (q(x) g(y) - q(y) g(x)) / (x - y) = sum B_ij x^i y^j, has integer
 * entries, and its trailing minor of order k is q_m^(2k) D_k of the Hankel form of g / q: of
 * s_(i+j) for g = q', of s_(i+j+1) for g = x q' - m q.
 *
 * p changes its sign at roots of odd multiplicity alone. Their product o has as many positive roots
 * as p has changes. With w_1 = q / gcd(q, q'), the product of all x - root, w_2 that of gcd(q, q'),
 * and so on, o = w_1 / w_2 * w_3 / w_4 ..: computed modulo each prime. q_m o is an integer
 * polynomial (Gauss). A prime that makes two roots equal is left out: it shows by r.
 *
 * Bits: a coefficient of q has R + 7, R those of a number; one of q' or g 4 more; an entry of B 5
 * more than their product; a minor of order k is below k! entry^k: 9 (2 R + 23) + 19. A coefficient
 * of q_m o is at most q_m 2^m |q| (Mignotte), 2 R + 25 bits: a minor has 9 (4 R + 60) + 19.
 */
#include "basis/positivity.h"
#include "basis/residue_poly.h" /* loft_residue_poly, loft_residue_bezout */

#define MOST      LOFT_DEGREE_MAX
#define FIRST     (MOST * (2 * LOFT_RESIDUE_REAL + 23) + 20)
#define SECOND    (MOST * (4 * LOFT_RESIDUE_REAL + 60) + 20)
#define PRIMES    (SECOND / 30 + 2)

/* The minors of two forms, as mixed radix digits: minor[f][k - 1] of order k */
typedef struct {
    uint32_t prime[PRIMES], digit[2][MOST][PRIMES];
    unsigned primes, orders;
} minors;

/* The product of the x - root of odd multiplicity, times the leading coefficient. */
static loft_residue_poly odd_part(const loft_residue *r, const loft_residue_poly *q)
{
    const uint32_t lead = q->c[q->degree];
    loft_residue_poly odd = { { 1 }, 0 }, rest = *q;

    for (bool times = true; rest.degree > 0; times = !times) {
        const loft_residue_poly gcd = loft_residue_poly_gcd(r, rest,
                                                            loft_residue_poly_derivative(r, &rest));
        const loft_residue_poly simple = loft_residue_poly_divide(r, &rest, &gcd);
        odd = times ? loft_residue_poly_product(r, &odd, &simple)
                    : loft_residue_poly_divide(r, &odd, &simple);
        rest = gcd;
    }
    const uint32_t scale = loft_residue_mul(r, lead, loft_residue_inverse(r, odd.c[odd.degree]));
    for (unsigned j = 0; j <= odd.degree; j++)
        odd.c[j] = loft_residue_mul(r, odd.c[j], scale);
    return odd;
}

/* x q' - m q, whose coefficient of degree m is 0 */
static loft_residue_poly lowered(const loft_residue *r, const loft_residue_poly *q)
{
    loft_residue_poly g = { { 0 }, q->degree };

    for (unsigned j = 0; j < q->degree; j++)
        g.c[j] = loft_residue_sub(r, 0, loft_residue_mul(r, q->c[j], q->degree - j));
    return g;
}

/* Append the digits of all minors of q for one more prime. */
static void add_prime(const loft_residue *r, const loft_residue_poly *q, minors *x)
{
    const loft_residue_poly g[2] = { loft_residue_poly_derivative(r, q), lowered(r, q) };
    uint32_t matrix[LOFT_RESIDUE_ORDER][LOFT_RESIDUE_ORDER];
    const unsigned at = x->primes++;

    x->prime[at] = r->prime;
    x->orders = q->degree;
    const uint32_t radix = loft_residue_radix(r, x->prime, at);
    for (int f = 0; f < 2; f++) {
        loft_residue_bezout(r, q, &g[f], q->degree, matrix);
        for (unsigned k = 0; k < q->degree; k++)
            x->digit[f][k][at] = loft_residue_digit(r, x->prime, x->digit[f][k], at, radix,
                                                    loft_residue_minor(r, matrix, k + 1));
    }
}

static int minor_sign(const minors *x, int form, unsigned order)
{
    return loft_residue_sign(x->prime, x->digit[form][order - 1], x->primes);
}

static unsigned rank_of(const minors *x)
{
    unsigned rank = x->orders;

    while (rank > 0 && minor_sign(x, 0, rank) == 0)
        rank--;
    return rank;
}

static int signature_of(const minors *x, int form, unsigned rank)
{
    int before = 1, changes = 0, last = 1;
    unsigned zeros = 0;

    for (unsigned k = 1; k <= rank; k++) {
        int sign = minor_sign(x, form, k);
        zeros = sign == 0 ? zeros + 1 : 0;
        if (sign == 0)
            sign = zeros * (zeros - 1) / 2 % 2 ? -last : last;
        else
            last = sign;
        changes += sign != before;
        before = sign;
    }
    return (int)rank - 2 * changes;
}

/* q of the coefficients low .. high. */
static loft_residue_poly load_poly(const loft_residue *r, const loft_real b[], unsigned n,
                                   unsigned low, unsigned high)
{
    loft_residue_poly q = { { 0 }, high - low };

    for (unsigned j = low; j <= high; j++)
        q.c[j - low] = loft_residue_mul(r, loft_residue_real(r, b[j]),
                                        (uint32_t)loft_binomial(n, j));
    return q;
}

static int positive_roots(const minors *x, unsigned rank)
{
    return (signature_of(x, 0, rank) + signature_of(x, 1, rank)) / 2;
}

/* The number of different positive roots of q, and the number of changes of sign. */
static void count_roots(const loft_real b[], unsigned n, unsigned low, unsigned high, int *roots,
                        int *changes)
{
    loft_residue r;
    minors x = { .primes = 0 };

    loft_residue_start(&r, FIRST);
    while (loft_residue_next(&r)) {
        const loft_residue_poly q = load_poly(&r, b, n, low, high);
        add_prime(&r, &q, &x);
    }
    const unsigned rank = rank_of(&x);
    *changes = *roots = positive_roots(&x, rank);
    if (rank == high - low || *roots == 0)
        return;

    x.primes = 0;
    loft_residue_start(&r, SECOND);
    while (loft_residue_next(&r)) {
        const loft_residue_poly q = load_poly(&r, b, n, low, high);
        const loft_residue_poly gcd = loft_residue_poly_gcd(&r, q,
                                                            loft_residue_poly_derivative(&r, &q));
        if (q.c[q.degree] == 0 || gcd.degree != q.degree - rank) {
            loft_residue_skip(&r);
            continue;
        }
        const loft_residue_poly odd = odd_part(&r, &q);
        add_prime(&r, &odd, &x);
    }
    *changes = x.orders > 0 ? positive_roots(&x, x.orders) : 0;
}

static int real_sign(loft_real a) { return (a > 0) - (a < 0); }

enum loft_status loft_bernstein_positivity(const loft_real b[], unsigned degree,
                                           loft_positivity *out)
{
    unsigned low = 0, high = degree;
    int roots = 0, changes = 0;

    if (degree > LOFT_DEGREE_MAX)
        return LOFT_ERR_ARG;
    for (unsigned j = 0; j <= degree; j++)
        if (!loft_exact_valid(b[j]))
            return LOFT_ERR_RANGE;
    while (low <= degree && real_sign(b[low]) == 0)
        low++;
    if (low > degree) {
        *out = (loft_positivity) { true, false, -1 };
        return LOFT_OK;
    }
    while (real_sign(b[high]) == 0)
        high--;
    if (high > low)
        count_roots(b, degree, low, high, &roots, &changes);
    const bool ends = low == 0 && high == degree;
    out->nonnegative = changes == 0 && b[high] > 0;
    out->positive = out->nonnegative && roots == 0 && ends;
    out->roots = (int8_t)(roots + (low > 0) + (high < degree));
    return LOFT_OK;
}
