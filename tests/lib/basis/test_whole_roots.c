/* tests/lib/basis/test_whole_roots.c -- properties of lib/basis/whole_roots.h
 * SPDX-License-Identifier: MIT
 *
 * Polynomials are products of known factors with small whole coefficients.
 */
#include "basis/whole_roots.h"
#include "support/exact.h"          /* exact_acc; CHECK, PROPERTY */
#include "support/products.h"

#define MOST LOFT_RESIDUE_DEGREE

static void residues(const loft_whole_poly *w, const loft_residue *r, uint32_t c[])
{
    const product *p = w->data;

    for (unsigned j = 0; j <= w->degree; j++) {
        const int64_t rest = p->c[j] % (int64_t)r->prime;
        c[j] = (uint32_t)(rest < 0 ? rest + (int64_t)r->prime : rest);
    }
}

static enum loft_status find(const product *p, loft_whole_root out[], unsigned *count)
{
    const loft_whole_poly w = { p->degree, 64, residues, p };
    return loft_whole_roots(&w, out, count);
}

static long double place_of(const loft_whole_root *x)
{
    loft_acc t = 0;

    CHECK(loft_sci_to_acc(loft_whole_root_at(x), &t));
    return exact_acc(t);
}

/* Factors a - b t with the root a / b, q t^2 - p without a rational one, and pairs off the axis. */
static void every_root_is_found_with_its_multiplicity(arb *a)
{
    static const int64_t factor[10][3] = { { 0, 1 },     { -1, 1 },   { 1, -2 },    { 1, -3 },
                                           { 5, -7 },    { 3, -8 },   { -1, 0, 2 }, { -1, 0, 3 },
                                           { -1, 1, 1 }, { -3, 1, 3 } };
    static const int64_t none[3][3] = { { 1, 0, 1 }, { 13, -24, 12 }, { 5, -7, 3 } };
    const long double root[10] = { 0,
                                   1,
                                   0.5L,
                                   1 / 3.0L,
                                   5 / 7.0L,
                                   3 / 8.0L,
                                   sqrtl(0.5L),
                                   sqrtl(1 / 3.0L),
                                   (sqrtl(5) - 1) / 2,
                                   (sqrtl(37) - 1) / 6 };
    product p = { 0, { arb_below(a, 2) ? 1 : -3 } };
    unsigned times[10] = { 0 }, different = 0, count, found = 0;
    loft_whole_root out[MOST];

    for (unsigned tries = 1 + arb_below(a, 4); tries > 0; tries--) {
        const unsigned k = arb_below(a, 10), n = k < 6 ? 1 : 2;
        for (unsigned m = 1 + arb_below(a, 4); m > 0 && p.degree + n <= 10; m--, times[k]++)
            multiply(&p, factor[k], n);
    }
    if (arb_below(a, 2))
        multiply(&p, none[arb_below(a, 3)], 2);
    for (unsigned k = 0; k < 10; k++)
        different += times[k] > 0;
    CHECK(find(&p, out, &count) == LOFT_OK);
    CHECK(count == different);
    for (unsigned j = 0; j < count; j++) {
        CHECK(j == 0 || out[j - 1].at < out[j].at || (!out[j].exact && out[j - 1].at <= out[j].at));
        for (unsigned k = 0; k < 10; k++)
            if (fabsl(place_of(&out[j]) - root[k]) < 0x1p-31L) {
                CHECK(out[j].multiplicity == times[k]);
                found++;
            }
    }
    CHECK(found == count);
}

/* 4 (t - 1/2)^2 + c / 2^39 */
static void the_last_bit_decides_whether_it_touches(arb *a)
{
    loft_whole_root out[MOST];
    unsigned count;
    product p = { 2, { (int64_t)1 << 39, -((int64_t)1 << 41), (int64_t)1 << 41 } };

    (void)a;
    CHECK(find(&p, out, &count) == LOFT_OK && count == 1 && out[0].multiplicity == 2);
    CHECK(out[0].exact && out[0].at == (uint64_t)1 << (LOFT_ROOT_LEVELS - 1));
    p.c[0]++;
    CHECK(find(&p, out, &count) == LOFT_OK && count == 0);
    p.c[0] -= 2;
    CHECK(find(&p, out, &count) == LOFT_OK && count == 2 && out[0].at < out[1].at);
}

/* (2 t^2 - 1)^2 has the double root sqrt(1/2); one unit beside it are two roots or none. */
static void a_double_root_between_all_fractions_is_known(arb *a)
{
    const int64_t by = (int64_t)1 << 40;
    loft_whole_root out[MOST];
    unsigned count;
    product p = { 4, { by, 0, -4 * by, 0, 4 * by } };

    (void)a;
    CHECK(find(&p, out, &count) == LOFT_OK && count == 1 && out[0].multiplicity == 2);
    p.c[0]++;
    CHECK(find(&p, out, &count) == LOFT_OK && count == 0);
    p.c[0] -= 2;
    CHECK(find(&p, out, &count) == LOFT_OK && count == 2 && out[0].multiplicity == 1);
}

static void zero_and_constants_are_told(arb *a)
{
    loft_whole_root out[MOST];
    unsigned count = 9;
    product p = { 3, { 0 } };

    (void)a;
    CHECK(find(&p, out, &count) == LOFT_SINGULAR && count == 0);
    p.c[0] = -5;
    CHECK(find(&p, out, &count) == LOFT_OK && count == 0);
    p.degree = 0;
    CHECK(find(&p, out, &count) == LOFT_ERR_ARG);
}

static void roots_close_together_are_told_apart(arb *a)
{
    const int64_t f[2] = { -1, 3 }, g[2] = { -((int64_t)1 << 28) - 1, 3 * ((int64_t)1 << 28) };
    const int64_t h[2] = { -((int64_t)1 << 29) - 3, 3 * ((int64_t)1 << 29) };
    loft_whole_root out[MOST];
    unsigned count;
    product p = { 0, { 1 } };

    (void)a;
    multiply(&p, f, 1);
    multiply(&p, g, 1);
    CHECK(find(&p, out, &count) == LOFT_OK && count == 2);      /* 2^-30 apart */
    multiply(&p, h, 1);
    CHECK(find(&p, out, &count) == LOFT_OK && count == 3);
    const product near = { 2, { ((int64_t)1 << 61) - 1, -((int64_t)1 << 62), (int64_t)1 << 60 } };
    CHECK(find(&near, out, &count) == LOFT_OK && count == 1);   /* the other is beyond 1 */
}

int main(void)
{
    PROPERTY(every_root_is_found_with_its_multiplicity, 300);
    PROPERTY(the_last_bit_decides_whether_it_touches, 1);
    PROPERTY(a_double_root_between_all_fractions_is_known, 1);
    PROPERTY(zero_and_constants_are_told, 1);
    PROPERTY(roots_close_together_are_told_apart, 1);
    return check_failures();
}
