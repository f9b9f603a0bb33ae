/* tests/lib/basis/test_basis_loops.c -- the loops that headers of lib/basis print, word for word,
 * over arbitrary pieces, knots and polynomials
 * SPDX-License-Identifier: MIT
 *
 * tests/house/loops.py compares them with the headers.
 */
#include "support/exact_sci.h"          /* exact_sci, exact_of; CHECK */
#include "support/exact_basis.h"        /* arb_knots, quad_basis */
#include "basis/dyadic.h"
#include "basis/knots.h"
#include "basis/whole_roots.h"

static uint32_t leaf_seed, leaves;
static uint64_t covered;                /* of 0..1, in units of 2^-24 */

/* Some pieces of each level, and all of the deepest. */
static bool is_good(loft_dyad n)
{
    return n.level >= 10 || (n.k * 2654435761u + leaf_seed * (n.level + 1u)) % 7 < 3;
}

static void take(loft_dyad n)
{
    CHECK(covered == (uint64_t)n.k << (LOFT_DYAD_LEVELS - n.level));
    covered += (uint64_t)1 << (LOFT_DYAD_LEVELS - n.level);
    leaves++;
}

static void leaves_follow_each_other_from_0_to_1(arb *a)
{
    leaf_seed = (uint32_t)arb_next(a);
    leaves = 0;
    covered = 0;
#define use take
    loft_dyad n = { 0, 0 };
    do {
        while (!is_good(n))
            n = loft_dyad_half(n, 0);
        use(n);
    } while (loft_dyad_next(&n));
#undef use
    CHECK(covered == (uint64_t)1 << LOFT_DYAD_LEVELS && leaves <= 1024);
}

static void a_spline_is_the_sum_of_its_basis(arb *a)
{
    const unsigned p = 1 + arb_below(a, 5), points = p + 1 + arb_below(a, 8);
    loft_real knot[20], coefficient[20], y;
    loft_knots knots;
    loft_acc c[LOFT_DEGREE_MAX + 1];
    long double want = 0;
    unsigned j;

    arb_knots(a, points, p, knot);
    for (unsigned k = 0; k < points; k++)
        coefficient[k] = arb_real(a, 1000);
    if (loft_knots_init(&knots, knot, points, p) != LOFT_OK)
        return;
    const loft_real at = knot[p + arb_below(a, points - p)],
                    u = at + (knot[points] - at) / (loft_real)(1 + arb_below(a, 9));
    const unsigned s = loft_knots_find(&knots, u);
    for (j = 0; j <= p; j++)
        c[j] = loft_to_acc(coefficient[s - p + j]);
    y = loft_acc_round(loft_knots_eval(&knots, s, u, c));
    for (unsigned k = s - p; k <= s; k++)
        want += exact_of(coefficient[k]) * (long double)quad_basis(knot, k, p, quad_of(u), 0, s);
    CHECK_NEAR(exact_of(y), want, BY_NUM(0x1.01p-17, 1e-4, 1e-11));
}

/* A product of b t - a, times itself up to three times. */
typedef struct {
    int64_t c[LOFT_RESIDUE_DEGREE + 1];
} whole;

static void resultant(const loft_whole_poly *w, const loft_residue *r, uint32_t c[])
{
    const whole *p = w->data;

    for (unsigned j = 0; j <= w->degree; j++) {
        const int64_t rest = p->c[j] % (int64_t)r->prime;
        c[j] = (uint32_t)(rest < 0 ? rest + (int64_t)r->prime : rest);
    }
}

static void roots_of_a_product_are_those_of_its_factors(arb *a)
{
    const unsigned degree = 1 + arb_below(a, 9);
    whole curves = { { 1 } };
    unsigned inside = 0, sum = 0;
    long double last = -1;

    for (unsigned k = 0; k < degree; k++) {
        const int64_t top = (int64_t)arb_below(a, 17) - 3, bottom = 1 + arb_below(a, 11);
        inside += top >= 0 && top <= bottom;
        for (unsigned j = k + 1; j > 0; j--)
            curves.c[j] = bottom * curves.c[j - 1] - top * curves.c[j];
        curves.c[0] *= -top;
    }
#define use(at, multiple)                                                                          \
    do {                                                                                           \
        const long double place = exact_sci(at);                                                   \
        CHECK(place > last && place >= 0 && place <= 1 + 1e-15L);                                  \
        last = place;                                                                              \
        sum += (multiple);                                                                         \
    } while (0)
    loft_whole_poly w = { .degree = degree, .bits = 63, .residues = resultant, .data = &curves };
    loft_whole_root root[LOFT_RESIDUE_DEGREE];
    unsigned count;
    if (loft_whole_roots(&w, root, &count) == LOFT_OK)
        for (unsigned k = 0; k < count; k++)
            use(loft_whole_root_at(&root[k]), root[k].multiplicity);
#undef use
    CHECK(sum == inside);
}

int main(void)
{
    PROPERTY(leaves_follow_each_other_from_0_to_1,         200);
    PROPERTY(a_spline_is_the_sum_of_its_basis,             500);
    PROPERTY(roots_of_a_product_are_those_of_its_factors,  100);
    return check_failures();
}
