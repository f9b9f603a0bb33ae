/* lib/basis/whole_roots.c
 * SPDX-License-Identifier: MIT
 *
 * On the part from k / 2^l to (k + 1) / 2^l, with t = (k + x) / 2^l and x = 1 / (1 + y),
 *
 *     2^(l n) (1 + y)^n p(t) = sum e_j y^j
 *
 * is integer. Its positive roots are those of p inside the part. There are as many as changes of
 * sign in e_0, e_1, .., or fewer by an even number (Descartes). Zeros at its start count the
 * multiplicity of the end of the part, zeros at its end that of the start. Parts with 0 changes
 * have no root, those with 1 have a simple one, others are halved.
 *
 * Multiple roots. A part around a root of multiplicity v and no other has v changes. It is known to
 * have such a root as follows. If the derivative of the order v - 1 has 1 change there, it has
 * one root there, a simple one. If each derivative of a lower order, and p, has this root in common
 * with it, the root has the multiplicity v. Let B be that derivative and h the greatest common
 * factor of it and of one of the others, lead(h) = 1. lead(B) h is integer (Gauss), and it has a
 * root in the part, which is then the one of B, if its changes there are odd.
 *
 * Modulo a prime a common factor may have too high a degree, never too low, if no degree of the
 * two polynomials drops. The right degree is the lowest among primes whose product exceeds the
 * minors of Sylvester's matrix.
 *
 * Bits, with n the degree and b those of a coefficient of p: a derivative over the factorial of its
 * order has b + n. e_j has n (l + 2) more. A minor of Sylvester's matrix has 2 n rows of a length
 * below 2^(b + n + 3). A coefficient of lead(B) h is below 2^n |B| (Mignotte), b + 2 n + 3, and its
 * degree is below n; n (l + 2) at the deepest level is more than (n - 1) (l + 2) + 2 n + 3 - n. */
#include "basis/whole_roots.h"

#define MOST   LOFT_RESIDUE_DEGREE
#define PRIMES ((LOFT_WHOLE_BITS + MOST * (LOFT_ROOT_LEVELS + 3) + 64) / 30 + 2)

/* The coefficients of p modulo all primes. */
typedef struct {
    const loft_whole_poly *w;
    uint32_t prime[PRIMES], c[PRIMES][MOST + 1];
    unsigned primes, degree;
} bank;

/* Integers as mixed radix digits. */
typedef struct {
    uint32_t prime[PRIMES], digit[MOST + 1][PRIMES];
    unsigned primes, count;
} whole;

/* A part of 0..1. */
typedef struct {
    uint64_t k;
    unsigned level;
} part;

static void whole_add(whole *v, const loft_residue *r, const uint32_t x[])
{
    const unsigned at = v->primes;
    const uint32_t radix = loft_residue_radix(r, v->prime, at);

    for (unsigned j = 0; j < v->count; j++)
        v->digit[j][at] = loft_residue_digit(r, v->prime, v->digit[j], at, radix, x[j]);
    v->prime[v->primes++] = r->prime;
}

static int whole_sign(const whole *v, unsigned j)
{
    return loft_residue_sign(v->prime, v->digit[j], v->primes);
}

static unsigned bits_at(const bank *b, unsigned level)
{
    return b->w->bits + b->degree * (level + 3) + 8;
}

/* The derivative of this order over its factorial. */
static loft_residue_poly take_derivative(const loft_residue *r, const uint32_t c[], unsigned degree,
                                         unsigned order)
{
    loft_residue_poly q = { { 0 }, degree - order };
    uint32_t binomial = 1;                      /* C(j, order) <= C(16, 8) */

    for (unsigned j = order; j <= degree; j++) {
        q.c[j - order] = loft_residue_mul(r, c[j], binomial);
        binomial = binomial * (j + 1) / (j + 1 - order);
    }
    return q;
}

static void shift_poly(const loft_residue *r, loft_residue_poly *q, uint32_t by)
{
    for (unsigned i = 0; i < q->degree; i++)
        for (unsigned j = q->degree; j-- > i; )
            q->c[j] = loft_residue_add(r, q->c[j], loft_residue_mul(r, q->c[j + 1], by));
}

/* e_0, e_1, .. as above. */
static void turn_poly(const loft_residue *r, loft_residue_poly *q, part at)
{
    uint32_t scale = 1, unit = 1;

    for (unsigned l = 0; l < at.level; l++)
        unit = loft_residue_add(r, unit, unit);
    for (unsigned j = q->degree + 1; j-- > 0; scale = loft_residue_mul(r, scale, unit))
        q->c[j] = loft_residue_mul(r, q->c[j], scale);
    shift_poly(r, q, (uint32_t)(at.k % r->prime));
    for (unsigned i = 0, j = q->degree; i < j; i++, j--) {
        const uint32_t swap = q->c[i];
        q->c[i] = q->c[j];
        q->c[j] = swap;
    }
    shift_poly(r, q, 1);
}

static unsigned sign_changes(const int8_t sign[], unsigned degree)
{
    unsigned changes = 0;
    int8_t last = 0;

    for (unsigned j = 0; j <= degree; j++) {
        if (sign[j] && last && sign[j] != last)
            changes++;
        if (sign[j])
            last = sign[j];
    }
    return changes;
}

static loft_residue prime_of(const bank *b, unsigned i)
{
    const loft_residue r = { b->prime[i], 0 };
    return r;
}

/* The signs of e_0 .. of the derivative of this order. */
static void turned_signs(const bank *b, unsigned order, part at, int8_t sign[])
{
    const unsigned needed = bits_at(b, at.level) / 30 + 1;
    whole v;

    v.primes = 0;
    v.count = b->degree - order + 1;
    for (unsigned i = 0; i < b->primes && i < needed; i++) {
        const loft_residue r = prime_of(b, i);
        loft_residue_poly q = take_derivative(&r, b->c[i], b->degree, order);
        turn_poly(&r, &q, at);
        whole_add(&v, &r, q.c);
    }
    for (unsigned j = 0; j < v.count; j++)
        sign[j] = (int8_t)whole_sign(&v, j);
}

/* The sign of the derivative of this order at k / 2^level. */
static int sign_at(const bank *b, unsigned order, part at)
{
    uint32_t prime[PRIMES], digit[PRIMES];
    const unsigned needed = bits_at(b, at.level) / 30 + 1;
    unsigned i = 0;

    for (; i < b->primes && i < needed; i++) {
        const loft_residue r = prime_of(b, i);
        const loft_residue_poly q = take_derivative(&r, b->c[i], b->degree, order);
        const uint32_t k = (uint32_t)(at.k % r.prime);
        uint32_t sum = 0, scale = 1, unit = 1;
        for (unsigned l = 0; l < at.level; l++)
            unit = loft_residue_add(&r, unit, unit);
        for (unsigned j = q.degree + 1; j-- > 0; scale = loft_residue_mul(&r, scale, unit))
            sum = loft_residue_add(&r, loft_residue_mul(&r, sum, k),
                                   loft_residue_mul(&r, q.c[j], scale));
        prime[i] = r.prime;
        digit[i] = loft_residue_digit(&r, prime, digit, i, loft_residue_radix(&r, prime, i), sum);
    }
    return loft_residue_sign(prime, digit, i);
}


/* Multiple roots */

/* The common factor of the derivatives of two orders modulo this prime, times the leading
 * coefficient of the second. False if a degree drops. */
static bool common_factor(const bank *b, const loft_residue *r, unsigned one, unsigned two,
                          loft_residue_poly *out)
{
    uint32_t c[MOST + 1];

    b->w->residues(b->w, r, c);
    if (c[b->degree] == 0)
        return false;
    const loft_residue_poly p = take_derivative(r, c, b->degree, one),
                            q = take_derivative(r, c, b->degree, two);
    *out = loft_residue_poly_gcd(r, p, q);
    const uint32_t by = loft_residue_mul(r, q.c[q.degree],
                                         loft_residue_inverse(r, out->c[out->degree]));
    for (unsigned j = 0; j <= out->degree; j++)
        out->c[j] = loft_residue_mul(r, out->c[j], by);
    return true;
}

static unsigned common_degree(const bank *b, unsigned one, unsigned two)
{
    unsigned degree = b->degree;
    loft_residue_poly h;
    loft_residue r;

    loft_residue_start(&r, 2 * b->degree * (b->w->bits + b->degree + 3));
    while (degree > 0 && loft_residue_next(&r))
        if (!common_factor(b, &r, one, two, &h))
            loft_residue_skip(&r);
        else if (h.degree < degree)
            degree = h.degree;
    return degree;
}

/* True if the derivatives of these orders have a root in common inside the part, where the second
 * one has a single, simple root. */
static bool is_root_common(const bank *b, unsigned one, unsigned two, part at)
{
    const unsigned degree = common_degree(b, one, two);
    int8_t sign[MOST + 1];
    loft_residue_poly h;
    loft_residue r;
    whole v;

    if (degree == 0)
        return false;
    v.primes = 0;
    v.count = degree + 1;
    loft_residue_start(&r, bits_at(b, at.level) + 32);
    while (loft_residue_next(&r)) {
        if (!common_factor(b, &r, one, two, &h) || h.degree != degree) {
            loft_residue_skip(&r);
            continue;
        }
        turn_poly(&r, &h, at);
        whole_add(&v, &r, h.c);
    }
    for (unsigned j = 0; j <= degree; j++)
        sign[j] = (int8_t)whole_sign(&v, j);
    return sign_changes(sign, degree) % 2 == 1;
}

static bool is_root_multiple(const bank *b, unsigned times, part at)
{
    int8_t sign[MOST + 1];

    turned_signs(b, times - 1, at, sign);
    if (sign_changes(sign, b->degree - times + 1) != 1)
        return false;
    for (unsigned order = 0; order + 1 < times; order++)
        if (!is_root_common(b, order, times - 1, at))
            return false;
    return true;
}


/* The search */

static void add_root(loft_whole_root out[], unsigned *count, uint64_t at, bool exact,
                     unsigned multiplicity)
{
    out[(*count)++] = (loft_whole_root) { at, exact, (uint8_t)multiplicity };
}

/* The only root of the part, of a known multiplicity, to the last level. */
static void locate_root(const bank *b, part at, unsigned times, loft_whole_root out[],
                        unsigned *count)
{
    int8_t sign[MOST + 1];
    int before = 0;
    bool exact = false;

    turned_signs(b, times - 1, at, sign);
    for (unsigned j = 0; j <= b->degree - times + 1; j++)
        if (sign[j])
            before = sign[j];                   /* just after the start of the part */
    while (at.level < LOFT_ROOT_LEVELS && !exact) {
        const part middle = { 2 * at.k + 1, at.level + 1 };
        const int here = sign_at(b, times - 1, middle);
        at.k = here == 0 || here == before ? middle.k : 2 * at.k;
        at.level++;
        exact = here == 0;
    }
    add_root(out, count, at.k << (LOFT_ROOT_LEVELS - at.level), exact, times);
}

static void fill_bank(bank *b, const loft_whole_poly *w)
{
    loft_residue r;

    b->w = w;
    b->primes = 0;
    b->degree = 0;
    loft_residue_start(&r, w->bits + w->degree * (LOFT_ROOT_LEVELS + 3) + 8);
    for (; b->primes < PRIMES && loft_residue_next(&r); b->primes++) {
        b->prime[b->primes] = r.prime;
        w->residues(w, &r, b->c[b->primes]);
        for (unsigned j = w->degree; j > b->degree; j--)
            if (b->c[b->primes][j] != 0)
                b->degree = j;
    }
}

static bool is_bank_constant_zero(const bank *b)
{
    for (unsigned i = 0; i < b->primes; i++)
        if (b->c[i][0] != 0)
            return false;
    return true;
}

/* To the next part after this one and its halves; false if there is none. */
static bool next_part(part *at)
{
    while (at->level > 0 && at->k % 2 == 1) {
        at->k /= 2;
        at->level--;
    }
    at->k++;
    return at->level > 0;
}

enum loft_status loft_whole_roots(const loft_whole_poly *w, loft_whole_root out[], unsigned *count)
{
    int8_t sign[MOST + 1];
    part at = { 0, 0 };
    unsigned zeros = 0;
    bank b;

    *count = 0;
    if (w->degree < 1 || w->degree > MOST || w->bits < 1 || w->bits > LOFT_WHOLE_BITS)
        return LOFT_ERR_ARG;
    fill_bank(&b, w);
    if (b.degree == 0)
        return is_bank_constant_zero(&b) ? LOFT_SINGULAR : LOFT_OK;

    turned_signs(&b, 0, at, sign);
    while (sign[b.degree - zeros] == 0)
        zeros++;
    if (zeros)
        add_root(out, count, 0, true, zeros);
    do {
        unsigned times;
        for (;;) {
            turned_signs(&b, 0, at, sign);
            times = sign_changes(sign, b.degree);
            if (times < 2 || is_root_multiple(&b, times, at))
                break;
            if (at.level == LOFT_ROOT_LEVELS)
                return LOFT_ERR_RANGE;
            at.k *= 2;
            at.level++;
        }
        if (times)
            locate_root(&b, at, times, out, count);
        for (zeros = 0; sign[zeros] == 0; )
            zeros++;
        if (zeros)
            add_root(out, count, (at.k + 1) << (LOFT_ROOT_LEVELS - at.level), true, zeros);
    } while (next_part(&at));
    return LOFT_OK;
}

loft_sci loft_whole_root_at(const loft_whole_root *x)
{
    const uint64_t half = 2 * x->at + !x->exact;        /* in units of 2^-53: 54 bits at most */
    const loft_sci high = loft_sci_from_int((int32_t)(half >> 27)),
                   low = loft_sci_from_int((int32_t)(half & 0x7ffffff));
    const loft_sci step = loft_sci_from_int((int32_t)1 << 27),
                   fine = loft_sci_from_int((int32_t)1 << 26);

    return loft_sci_div(loft_sci_add(high, loft_sci_div(low, step)), fine);
}
