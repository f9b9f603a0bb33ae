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
 *
 * The sign of an integer v, |v| < M / 2, M the product of the primes: v or M + v is d_0 + d_1 p_0 +
 * d_2 p_0 p_1 + .. with digits d_i < p_i. (M - 1) / 2 has the digits (p_i - 1) / 2, and v is
 * negative if its digits, compared from the last, are larger.
 */
#include "basis/positivity.h"
#include "num/residue.h"        /* loft_residue */

#define MOST      LOFT_DEGREE_MAX
#define FIRST     (MOST * (2 * LOFT_RESIDUE_REAL + 23) + 20)
#define SECOND    (MOST * (4 * LOFT_RESIDUE_REAL + 60) + 20)
#define PRIMES    (SECOND / 30 + 2)

/* A polynomial modulo a prime. */
typedef struct {
    uint32_t c[MOST + 2];
    unsigned degree;
} poly;

/* The minors of two forms, as mixed radix digits: minor[f][k - 1] of order k */
typedef struct {
    uint32_t prime[PRIMES], digit[2][MOST][PRIMES];
    unsigned primes, orders;
} minors;

static poly poly_derivative(const loft_residue *r, const poly *q)
{
    poly d = { { 0 }, q->degree > 0 ? q->degree - 1 : 0 };

    for (unsigned j = 1; j <= q->degree; j++)
        d.c[j - 1] = loft_residue_mul(r, q->c[j], j);
    return d;
}

static bool poly_is_zero(const poly *q) { return q->degree == 0 && q->c[0] == 0; }

static void poly_trim(poly *q)
{
    while (q->degree > 0 && q->c[q->degree] == 0)
        q->degree--;
}

/* a / b; what remains is left in a. */
static poly poly_divide(const loft_residue *r, poly *a, const poly *b)
{
    poly quotient = { { 0 }, 0 };
    const uint32_t inverse = loft_residue_inverse(r, b->c[b->degree]);

    if (a->degree < b->degree)
        return quotient;
    quotient.degree = a->degree - b->degree;
    for (unsigned k = quotient.degree + 1; k-- > 0; ) {
        const uint32_t f = loft_residue_mul(r, a->c[k + b->degree], inverse);
        quotient.c[k] = f;
        for (unsigned j = 0; j <= b->degree; j++)
            a->c[k + j] = loft_residue_sub(r, a->c[k + j], loft_residue_mul(r, f, b->c[j]));
    }
    poly_trim(a);
    return quotient;
}

static poly poly_gcd(const loft_residue *r, poly a, poly b)
{
    while (!poly_is_zero(&b)) {
        (void)poly_divide(r, &a, &b);
        const poly swap = a;
        a = b;
        b = swap;
    }
    return a;
}

static poly poly_product(const loft_residue *r, const poly *a, const poly *b)
{
    poly c = { { 0 }, a->degree + b->degree };

    for (unsigned i = 0; i <= a->degree; i++)
        for (unsigned j = 0; j <= b->degree; j++)
            c.c[i + j] = loft_residue_add(r, c.c[i + j], loft_residue_mul(r, a->c[i], b->c[j]));
    return c;
}

/* The product of the x - root of odd multiplicity, times the leading coefficient. */
static poly odd_part(const loft_residue *r, const poly *q)
{
    const uint32_t lead = q->c[q->degree];
    poly odd = { { 1 }, 0 }, rest = *q;

    for (bool times = true; rest.degree > 0; times = !times) {
        const poly gcd = poly_gcd(r, rest, poly_derivative(r, &rest));
        const poly simple = poly_divide(r, &rest, &gcd);
        odd = times ? poly_product(r, &odd, &simple) : poly_divide(r, &odd, &simple);
        rest = gcd;
    }
    const uint32_t scale = loft_residue_mul(r, lead, loft_residue_inverse(r, odd.c[odd.degree]));
    for (unsigned j = 0; j <= odd.degree; j++)
        odd.c[j] = loft_residue_mul(r, odd.c[j], scale);
    return odd;
}

/* Bezout's matrix with rows and columns reversed: leading minors. */
static void bezout(const loft_residue *r, const poly *q, const poly *g, uint32_t out[MOST][MOST])
{
    const unsigned m = q->degree;

    for (unsigned i = 0; i < m; i++)
        for (unsigned j = 0; j < m; j++) {
            uint32_t sum = 0;
            for (unsigned k = 0; k <= i && j + k + 1 <= m; k++) {
                const uint32_t one = loft_residue_mul(r, q->c[j + k + 1], g->c[i - k]);
                const uint32_t two = loft_residue_mul(r, q->c[i - k], g->c[j + k + 1]);
                sum = loft_residue_add(r, sum, loft_residue_sub(r, one, two));
            }
            out[m - 1 - i][m - 1 - j] = sum;
        }
}

/* The determinant of the first k rows and columns. */
static uint32_t leading_minor(const loft_residue *r, uint32_t from[MOST][MOST], unsigned k)
{
    uint32_t a[MOST][MOST], det = 1;

    for (unsigned i = 0; i < k; i++)
        for (unsigned j = 0; j < k; j++)
            a[i][j] = from[i][j];
    for (unsigned i = 0; i < k; i++) {
        unsigned pivot = i;
        while (pivot < k && a[pivot][i] == 0)
            pivot++;
        if (pivot == k)
            return 0;
        for (unsigned j = i; j < k && pivot != i; j++) {
            const uint32_t swap = a[i][j];
            a[i][j] = a[pivot][j];
            a[pivot][j] = swap;
        }
        det = loft_residue_mul(r, pivot == i ? det : loft_residue_sub(r, 0, det), a[i][i]);
        const uint32_t inverse = loft_residue_inverse(r, a[i][i]);
        for (unsigned l = i + 1; l < k; l++) {
            const uint32_t f = loft_residue_mul(r, a[l][i], inverse);
            for (unsigned j = i; j < k; j++)
                a[l][j] = loft_residue_sub(r, a[l][j], loft_residue_mul(r, f, a[i][j]));
        }
    }
    return det;
}

/* x q' - m q, whose coefficient of degree m is 0 */
static poly lowered(const loft_residue *r, const poly *q)
{
    poly g = { { 0 }, q->degree };

    for (unsigned j = 0; j < q->degree; j++)
        g.c[j] = loft_residue_sub(r, 0, loft_residue_mul(r, q->c[j], q->degree - j));
    return g;
}

/* Append the digits of all minors of q for one more prime. */
static void add_prime(const loft_residue *r, const poly *q, minors *x)
{
    const poly g[2] = { poly_derivative(r, q), lowered(r, q) };
    uint32_t matrix[MOST][MOST], inverse[PRIMES];
    const unsigned at = x->primes++;

    x->prime[at] = r->prime;
    x->orders = q->degree;
    for (unsigned i = 0; i < at; i++)
        inverse[i] = loft_residue_inverse(r, x->prime[i] % r->prime);
    for (int f = 0; f < 2; f++) {
        bezout(r, q, &g[f], matrix);
        for (unsigned k = 0; k < q->degree; k++) {
            uint32_t *digit = x->digit[f][k], rest = leading_minor(r, matrix, k + 1);
            for (unsigned i = 0; i < at; i++)
                rest = loft_residue_mul(r, loft_residue_sub(r, rest, digit[i] % r->prime),
                                        inverse[i]);
            digit[at] = rest;
        }
    }
}

static int minor_sign(const minors *x, int form, unsigned order)
{
    const uint32_t *digit = x->digit[form][order - 1];
    bool any = false;

    for (unsigned i = x->primes; i-- > 0; ) {
        const uint32_t half = (x->prime[i] - 1) / 2;
        if (digit[i] > half)
            return -1;
        any = any || digit[i] != 0;
        if (digit[i] < half)
            break;
    }
    for (unsigned i = 0; i < x->primes && !any; i++)
        any = digit[i] != 0;
    return any;
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
static poly load_poly(const loft_residue *r, const loft_real b[], unsigned n, unsigned low,
                      unsigned high)
{
    poly q = { { 0 }, high - low };

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
        const poly q = load_poly(&r, b, n, low, high);
        add_prime(&r, &q, &x);
    }
    const unsigned rank = rank_of(&x);
    *changes = *roots = positive_roots(&x, rank);
    if (rank == high - low || *roots == 0)
        return;

    x.primes = 0;
    loft_residue_start(&r, SECOND);
    while (loft_residue_next(&r)) {
        const poly q = load_poly(&r, b, n, low, high);
        const poly gcd = poly_gcd(&r, q, poly_derivative(&r, &q));
        if (q.c[q.degree] == 0 || gcd.degree != q.degree - rank) {
            loft_residue_skip(&r);
            continue;
        }
        const poly odd = odd_part(&r, &q);
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
