/* tests/lib/basis/test_knots_basis.c -- properties of lib/basis/knots_basis.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_basis.h"        /* quad_basis, arb_knots; CHECK, PROPERTY, BY_NUM */
#include "basis/knots_basis.h"

#define MOST 40

typedef struct {
    unsigned points, degree, span;
    loft_real knot[MOST], u;
    loft_knots knots;
    bool valid;
} sample;

static sample *arb_sample(arb *a)
{
    static sample s;

    s.degree = 1 + arb_below(a, 7);
    s.points = s.degree + 1 + arb_below(a, 8);
    arb_knots(a, s.points, s.degree, s.knot);
    s.valid = loft_knots_init(&s.knots, s.knot, s.points, s.degree) == LOFT_OK;
    if (!s.valid)
        return &s;
    s.u = arb_below(a, 3) ? loft_lerp(s.knot[s.degree], s.knot[s.points], arb_unit(a))
                          : s.knot[s.degree + arb_below(a, s.points - s.degree + 1)];
    s.span = loft_knots_find(&s.knots, s.u);
    return &s;
}

static void values_and_derivatives_are_those_of_the_definition(arb *a)
{
    const sample *s = arb_sample(a);
    loft_sci n[10];

    for (unsigned k = 0; k < 4 && s->valid; k++) {
        quad terms[10], most = 0;
        loft_knots_basis(&s->knots, s->span, s->u, k, n);
        for (unsigned j = 0; j <= s->degree; j++) {
            terms[j] = quad_basis(s->knot, s->span - s->degree + j, s->degree, quad_of(s->u), k,
                                  s->span);
            most = terms[j] > most ? terms[j] : -terms[j] > most ? -terms[j] : most;
        }
        for (unsigned j = 0; j <= s->degree; j++)
            CHECK_EXACT((long double)(quad_sci(n[j]) - terms[j]), 0,
                        bound_by_num(0x1p-54L, 0x1p-46L, 0x1p-46L) * (long double)most);
    }
}

static void remainders_sum_to_one_and_to_zero(arb *a)
{
    const sample *s = arb_sample(a);
    loft_residue r;
    uint32_t n[2][10];

    loft_residue_start(&r, 90);
    while (s->valid && loft_residue_next(&r)) {
        uint32_t sum[2] = { 0, 0 };
        CHECK(loft_knots_basis_residue(&s->knots, s->span, s->u, 0, &r, n[0]) &&
              loft_knots_basis_residue(&s->knots, s->span, s->u, 1, &r, n[1]));
        for (unsigned k = 0; k < 2; k++)
            for (unsigned j = 0; j <= s->degree; j++)
                sum[k] = loft_residue_add(&r, sum[k], n[k][j]);
        CHECK(sum[0] == 1 && sum[1] == 0);
    }
}

/* A B-spline is 0 modulo every prime where it is 0, and nowhere else. */
static void a_remainder_is_zero_where_the_spline_is(arb *a)
{
    const sample *s = arb_sample(a);
    loft_sci wide[10];
    uint32_t n[10];
    loft_residue r;

    if (!s->valid)
        return;
    loft_knots_basis(&s->knots, s->span, s->u, 0, wide);
    loft_residue_start(&r, 1);
    CHECK(loft_residue_next(&r) && loft_knots_basis_residue(&s->knots, s->span, s->u, 0, &r, n));
    for (unsigned j = 0; j <= s->degree; j++)
        CHECK((n[j] == 0) == (loft_sci_sign(wide[j]) == 0));
    CHECK(loft_knots_basis_bits(&s->knots) >= s->degree * LOFT_RESIDUE_REAL);
}

int main(void)
{
    PROPERTY(values_and_derivatives_are_those_of_the_definition, 300);
    PROPERTY(remainders_sum_to_one_and_to_zero,                  500);
    PROPERTY(a_remainder_is_zero_where_the_spline_is,            500);
    return check_failures();
}
