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
 * Bits, with 2^L > n: a coefficient of p is below 2^R, a second difference below 2^(R + 2), C(n, j)
 * below 2^(n - 1) if n > 0: a coefficient of q has c = R + n + 1 bits, one of q' or g L more; an
 * entry of B is a sum of 2 n products, 2 c + 2 L + 1 bits; a minor is below (n^(1/2) entry)^n
 * (Hadamard). A coefficient of q_m o is below 2^n |q| (Mignotte; o has some of the roots of q, each
 * once, so its Mahler measure is at most that of q / q_m): n + (L + 1) / 2 bits more than q.
 */
#include "basis/positivity.h"
#include "basis/residue_poly.h" /* loft_residue_bezout, loft_residue_gcd */

/* The polynomial, and the minors of both forms as mixed radix digits. */
typedef struct {
    const loft_real *b;
    unsigned order;             /* coefficients: differences of b of this order, 0 or 2 */
    unsigned degree, low, high; /* q: the coefficients low .. high */
    uint32_t *prime, *digit;    /* digit[room] of form f, order k at (f degree + k - 1) room */
    unsigned room, primes, orders;
    uint32_t *matrix[2], *q, *spare[5];
} forms;

static void copy(uint32_t to[], const uint32_t from[], unsigned count)
{
    for (unsigned j = 0; j < count; j++)
        to[j] = from[j];
}

/* x q' - m q, whose coefficient of degree m is 0 */
static void lower(const loft_residue *r, const uint32_t q[], unsigned degree, uint32_t out[])
{
    for (unsigned j = 0; j <= degree; j++)
        out[j] = loft_residue_sub(r, 0, loft_residue_mul(r, q[j], degree - j));
}

/* The degree of the greatest common factor of q and q', which is left in out. The coefficient
 * q[degree] is not 0, degree > 0. */
static unsigned common_factor(const loft_residue *r, const uint32_t q[], unsigned degree,
                              uint32_t out[], uint32_t other[], uint32_t quotient[])
{
    unsigned common;

    copy(other, q, degree + 1);
    loft_residue_derive(r, q, degree, out);
    const uint32_t *factor = loft_residue_gcd(r, other, degree + 1, out, degree, quotient, &common);
    if (factor != out)
        copy(out, factor, common + 1);
    return common;
}

/* Replace q by the product of the x - root of odd multiplicity, times its leading coefficient.
 * Returns the degree. */
static unsigned odd_part(const loft_residue *r, forms *x)
{
    uint32_t *const odd = x->spare[0], *const simple = x->spare[1], *const factor = x->spare[2],
        *const one = x->spare[3], *const two = x->spare[4];
    const uint32_t lead = x->q[x->high - x->low];
    unsigned rest = x->high - x->low, degree = 0;

    odd[0] = 1;
    for (bool times = true; rest > 0; times = !times) {
        const unsigned common = common_factor(r, x->q, rest, factor, one, two),
                       count = rest - common;
        loft_residue_divide(r, x->q, rest, factor, common, simple);
        copy(x->q, factor, common + 1);
        rest = common;
        if (times) {
            for (unsigned j = 0; j <= degree + count; j++)
                one[j] = 0;
            for (unsigned i = 0; i <= degree; i++)
                for (unsigned j = 0; j <= count; j++)
                    one[i + j] = loft_residue_add(r, one[i + j],
                                                  loft_residue_mul(r, odd[i], simple[j]));
            degree += count;
        } else {
            loft_residue_divide(r, odd, degree, simple, count, one);
            degree -= count;
        }
        copy(odd, one, degree + 1);
    }
    const uint32_t scale = loft_residue_mul(r, lead, loft_residue_inverse(r, odd[degree]));
    for (unsigned j = 0; j <= degree; j++)
        x->q[j] = loft_residue_mul(r, odd[j], scale);
    return degree;
}

/* The determinant of the rows and columns from..end - 1 of matrix[0]. */
static uint32_t minor_of(const loft_residue *r, const forms *x, unsigned from, unsigned end)
{
    const unsigned n = end - from;

    for (unsigned i = 0; i < n; i++)
        copy(x->matrix[1] + i * n, x->matrix[0] + (from + i) * x->orders + from, n);
    return loft_residue_determinant(r, x->matrix[1], n);
}

/* Eliminate below the rows and columns from..end - 1 of matrix[0], whose determinant is not 0. */
static void eliminate_block(const loft_residue *r, const forms *x, unsigned from, unsigned end)
{
    const unsigned m = x->orders;
    uint32_t *const a = x->matrix[0];

    for (unsigned i = from; i < end; i++) {
        unsigned pivot = i;
        while (a[pivot * m + i] == 0)
            pivot++;
        for (unsigned j = i; j < m && pivot != i; j++) {
            const uint32_t swap = a[i * m + j];
            a[i * m + j] = a[pivot * m + j];
            a[pivot * m + j] = swap;
        }
        loft_residue_eliminate(r, a, m, i);
    }
}

/* Append the digits of the minors of matrix[0], which is overwritten. After elimination of rows
 * whose minor is not 0, the next minors are that one times those of what is left. */
static void add_minors(const loft_residue *r, const forms *x, unsigned form, uint32_t radix)
{
    uint32_t *digit = x->digit + (uint32_t)form * x->degree * x->room, last = 1;
    unsigned done = 0;

    for (unsigned k = 1; k <= x->orders; k++, digit += x->room) {
        const uint32_t minor = loft_residue_mul(r, last, minor_of(r, x, done, k));
        digit[x->primes] = loft_residue_digit(r, x->prime, digit, x->primes, radix, minor);
        if (minor == 0)
            continue;
        eliminate_block(r, x, done, k);
        last = minor;
        done = k;
    }
}

/* Append the digits of all minors of q, of this degree, for one more prime. */
static void add_prime(const loft_residue *r, forms *x, unsigned degree)
{
    const uint32_t radix = loft_residue_radix(r, x->prime, x->primes);

    x->orders = degree;
    for (unsigned f = 0; f < 2; f++) {
        if (f == 0)
            loft_residue_derive(r, x->q, degree, x->spare[0]);
        else
            lower(r, x->q, degree, x->spare[0]);
        loft_residue_bezout(r, x->q, x->spare[0], degree, x->matrix[0]);
        add_minors(r, x, f, radix);
    }
    x->prime[x->primes++] = r->prime;
}

static int minor_sign(const forms *x, unsigned form, unsigned order)
{
    return loft_residue_sign(
        x->prime, x->digit + ((uint32_t)form * x->degree + order - 1) * x->room, x->primes);
}

static unsigned rank_of(const forms *x)
{
    unsigned rank = x->orders;

    while (rank > 0 && minor_sign(x, 0, rank) == 0)
        rank--;
    return rank;
}

static int signature_of(const forms *x, unsigned form, unsigned rank)
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

static int positive_roots(const forms *x, unsigned rank)
{
    return (signature_of(x, 0, rank) + signature_of(x, 1, rank)) / 2;
}

static uint32_t coefficient_at(const loft_residue *r, const forms *x, unsigned j)
{
    const uint32_t first = loft_residue_real(r, x->b[j]);

    if (x->order == 0)
        return first;
    const uint32_t middle = loft_residue_real(r, x->b[j + 1]);
    return loft_residue_sub(r, loft_residue_add(r, first, loft_residue_real(r, x->b[j + 2])),
                            loft_residue_add(r, middle, middle));
}

static int coefficient_sign(const forms *x, unsigned j)
{
    if (x->order == 0)
        return (x->b[j] > 0) - (x->b[j] < 0);
    const loft_exact middle = loft_exact_from_real(x->b[j + 1]);
    return loft_exact_sign(loft_exact_sub(
        loft_exact_add(loft_exact_from_real(x->b[j]), loft_exact_from_real(x->b[j + 2])),
        loft_exact_add(middle, middle)));
}

static void load_poly(const loft_residue *r, forms *x)
{
    uint32_t *const binomial = x->spare[0];         /* by Pascal's triangle */

    for (unsigned n = 0; n <= x->degree; n++) {
        binomial[n] = 1;
        for (unsigned j = n; j-- > 1; )
            binomial[j] = loft_residue_add(r, binomial[j], binomial[j - 1]);
    }
    for (unsigned j = x->low; j <= x->high; j++)
        x->q[j - x->low] = loft_residue_mul(r, coefficient_at(r, x, j), binomial[j]);
}

/* The number of different positive roots of q, and the number of changes of sign. */
static void count_roots(forms *x, int *roots, int *changes)
{
    const unsigned m = x->high - x->low;
    loft_residue r;

    x->primes = 0;
    loft_residue_start(&r, LOFT_POSITIVITY_BITS(x->degree, LOFT_POSITIVITY_FIRST(x->degree)));
    while (loft_residue_next(&r)) {
        load_poly(&r, x);
        add_prime(&r, x, m);
    }
    const unsigned rank = rank_of(x);
    *changes = *roots = positive_roots(x, rank);
    if (rank == m || *roots == 0)
        return;

    x->primes = 0;
    loft_residue_start(&r, LOFT_POSITIVITY_BITS(x->degree, LOFT_POSITIVITY_SECOND(x->degree)));
    while (loft_residue_next(&r)) {
        load_poly(&r, x);
        if (x->q[m] == 0 ||
            common_factor(&r, x->q, m, x->spare[0], x->spare[1], x->spare[2]) != m - rank) {
            loft_residue_skip(&r);
            continue;
        }
        add_prime(&r, x, odd_part(&r, x));
    }
    *changes = x->orders > 0 ? positive_roots(x, x->orders) : 0;
}

/* Cut the memory into pieces: LOFT_POSITIVITY_WORK adds them up. */
static void share_memory(forms *x, uint32_t work[])
{
    const unsigned n = x->degree;

    x->room = (unsigned)LOFT_POSITIVITY_ROOM(n);
    x->prime = work;
    x->digit = x->prime + x->room;
    x->matrix[0] = x->digit + 2 * (uint32_t)n * x->room;
    x->matrix[1] = x->matrix[0] + n * n;
    x->q = x->matrix[1] + n * n;
    for (unsigned k = 0; k < 5; k++)
        x->spare[k] = x->q + (k + 1) * (n + 1);
}

static void decide(forms *x, uint32_t work[], loft_positivity *out)
{
    int roots = 0, changes = 0;

    x->low = 0;
    x->high = x->degree;
    while (x->low <= x->degree && coefficient_sign(x, x->low) == 0)
        x->low++;
    if (x->low > x->degree) {
        *out = (loft_positivity) { true, false, -1 };
        return;
    }
    while (coefficient_sign(x, x->high) == 0)
        x->high--;
    share_memory(x, work);
    if (x->high > x->low)
        count_roots(x, &roots, &changes);
    const bool ends = x->low == 0 && x->high == x->degree;
    out->nonnegative = changes == 0 && coefficient_sign(x, x->high) > 0;
    out->positive = out->nonnegative && roots == 0 && ends;
    out->roots = (int16_t)(roots + (x->low > 0) + (x->high < x->degree));
}

static bool all_valid(const loft_real b[], unsigned degree)
{
    bool valid = true;

    for (unsigned j = 0; j <= degree; j++)
        valid = valid && loft_exact_valid(b[j]);
    return valid;
}

enum loft_status loft_bernstein_positivity_in(const loft_real b[], unsigned degree, uint32_t work[],
                                              loft_positivity *out)
{
    forms x = { .b = b, .order = 0, .degree = degree };

    if (degree > LOFT_POSITIVITY_DEGREE)
        return LOFT_ERR_ARG;
    if (!all_valid(b, degree))
        return LOFT_ERR_RANGE;
    decide(&x, work, out);
    return LOFT_OK;
}

enum loft_status loft_bernstein_positivity(const loft_real b[], unsigned degree,
                                           loft_positivity *out)
{
    uint32_t work[LOFT_POSITIVITY_WORK(LOFT_DEGREE_MAX)];

    return degree <= LOFT_DEGREE_MAX ? loft_bernstein_positivity_in(b, degree, work, out)
                                     : LOFT_ERR_ARG;
}

/* The second derivative is n (n - 1) times the polynomial of degree n - 2 whose coefficients are
 * the second differences. */
enum loft_status loft_bernstein_convex_in(const loft_real b[], unsigned degree, uint32_t work[],
                                          bool *net, bool *polynomial)
{
    forms x = { .b = b, .order = 2, .degree = degree >= 2 ? degree - 2 : 0 };
    loft_positivity second = { .nonnegative = true };

    if (degree > LOFT_POSITIVITY_DEGREE)
        return LOFT_ERR_ARG;
    if (!all_valid(b, degree))
        return LOFT_ERR_RANGE;
    *net = true;
    for (unsigned j = 0; j + 2 <= degree; j++)
        *net = *net && coefficient_sign(&x, j) >= 0;
    if (!*net)
        decide(&x, work, &second);
    *polynomial = second.nonnegative;
    return LOFT_OK;
}
