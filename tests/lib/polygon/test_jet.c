/* tests/lib/polygon/test_jet.c -- properties of lib/polygon/jet.h, and of coordinates with their
 * derivatives
 * SPDX-License-Identifier: MIT
 */
#include "support/exact_quad.h"             /* quad_differences */
#include "polygon/meanvalue.h"
#include "polygon/wachspress.h"

#define POWER 4

/* A polynomial with small whole coefficients, c[i][j] x^i y^j. */
typedef struct {
    int32_t c[POWER][POWER];
} form;

static form arb_form(arb *a)
{
    form f;

    for (int i = 0; i < POWER; i++)
        for (int j = 0; j < POWER; j++)
            f.c[i][j] = (int32_t)arb_below(a, 19) - 9;
    return f;
}

static int64_t whole_power(int64_t x, int k)
{
    int64_t r = 1;

    while (k-- > 0)
        r *= x;
    return r;
}

/* The value of d^k x^i / dx^k at x. */
static int64_t derived(int64_t x, int i, int k)
{
    int64_t factor = 1;

    for (int m = 0; m < k; m++)
        factor *= i - m;
    return factor ? factor * whole_power(x, i - k) : 0;
}

static long double form_at(const form *f, int32_t x, int32_t y, int kx, int ky)
{
    int64_t sum = 0;

    for (int i = 0; i < POWER; i++)
        for (int j = 0; j < POWER; j++)
            sum += f->c[i][j] * derived(x, i, kx) * derived(y, j, ky);
    return (long double)sum;
}

static loft_jet number(int32_t i) { return loft_jet_of(loft_sci_from_int(i)); }

static loft_jet power(const loft_jet *a, int k)
{
    loft_jet r = number(1);

    while (k-- > 0)
        r = loft_jet_mul(&r, a);
    return r;
}

static loft_jet form_jet(const form *f, int32_t x, int32_t y)
{
    loft_jet at[2] = { number(x), number(y) }, sum = number(0);

    at[0].x = at[1].y = loft_sci_one();
    for (int i = 0; i < POWER; i++)
        for (int j = 0; j < POWER; j++) {
            const loft_jet by_x = power(&at[0], i), by_y = power(&at[1], j),
                           both = loft_jet_mul(&by_x, &by_y);
            const int32_t c = f->c[i][j];
            const loft_jet term = loft_jet_scale(&both, loft_sci_from_int(c < 0 ? -c : c));
            sum = c < 0 ? loft_jet_sub(&sum, &term) : loft_jet_add(&sum, &term);
        }
    return sum;
}

static void check_jet(const loft_jet *got, const long double want[6], long double off)
{
    const loft_sci part[6] = { got->f, got->x, got->y, got->xx, got->xy, got->yy };

    for (int k = 0; k < 6; k++)
        CHECK_EXACT(exact_sci(part[k]), want[k], off);
}

static void want_form(const form *f, int32_t x, int32_t y, long double want[6])
{
    const int order[6][2] = { { 0, 0 }, { 1, 0 }, { 0, 1 }, { 2, 0 }, { 1, 1 }, { 0, 2 } };

    for (int k = 0; k < 6; k++)
        want[k] = form_at(f, x, y, order[k][0], order[k][1]);
}

static void polynomials_of_whole_numbers_have_exact_derivatives(arb *a)
{
    const form f = arb_form(a);
    const int32_t x = (int32_t)arb_below(a, 41) - 20, y = (int32_t)arb_below(a, 41) - 20;
    const loft_jet got = form_jet(&f, x, y);
    long double want[6];

    want_form(&f, x, y, want);
    check_jet(&got, want, 0);
}

/* Parts of both, relative to the value of one. */
static long double largest_part(const long double part[6], long double by)
{
    long double most = 1;

    for (int k = 0; k < 6; k++)
        most = fmaxl(most, fabsl(part[k]) / by);
    return most;
}

/* (f g) / g = f. */
static void a_quotient_undoes_a_product(arb *a)
{
    const form f = arb_form(a), g = arb_form(a);
    const int32_t x = (int32_t)arb_below(a, 9) - 4, y = (int32_t)arb_below(a, 9) - 4;
    const loft_jet jf = form_jet(&f, x, y), jg = form_jet(&g, x, y),
                   product = loft_jet_mul(&jf, &jg);
    long double want[6], by[6];

    want_form(&f, x, y, want);
    want_form(&g, x, y, by);
    if (fabsl(by[0]) < 1)
        return;
    const loft_jet got = loft_jet_div(&product, &jg);
    const long double large = largest_part(by, fabsl(by[0]));
    check_jet(&got, want,
              64 * largest_part(want, 1) * large * large * BY_NUM(0x1p-61L, 0x1p-53L, 0x1p-53L));
}

/* sqrt(f f) = |f|. */
static void a_root_undoes_a_square(arb *a)
{
    const form f = arb_form(a);
    const int32_t x = (int32_t)arb_below(a, 9) - 4, y = (int32_t)arb_below(a, 9) - 4;
    const loft_jet jf = form_jet(&f, x, y), square = loft_jet_mul(&jf, &jf);
    long double want[6];

    want_form(&f, x, y, want);
    const long double size = fabsl(want[0]), large = largest_part(want, size);
    if (size < 1)
        return;
    for (int k = 5; k >= 0; k--)
        want[k] = want[0] < 0 ? -want[k] : want[k];
    const loft_jet got = loft_jet_sqrt(&square);
    check_jet(&got, want, 64 * size * large * large * BY_NUM(0x1p-61L, 0x1p-53L, 0x1p-53L));
}


/* Coordinates */

typedef struct {
    const arb_domain *p;
    bool mean;
} coordinates;

static void coordinates_at(const void *of, quad_spot at, quad out[])
{
    const coordinates *c = (const coordinates *)of;

    if (c->mean)
        quad_meanvalue(c->p, at, out);
    else
        quad_wachspress(c->p, at, out);
}

static enum loft_status both_of(const coordinates *c, loft_spot q, loft_sci phi[], loft_jet jet[])
{
    const enum loft_status status = c->mean ? loft_meanvalue_eval(&c->p->d, q, phi)
                                            : loft_wachspress_eval(&c->p->d, q, phi);
    const enum loft_status other = c->mean ? loft_meanvalue_jet(&c->p->d, q, jet)
                                           : loft_wachspress_jet(&c->p->d, q, jet);
    loft_sci area[LOFT_SIDES_MAX];
    unsigned index;

    CHECK(other == (c->mean && loft_domain_place(&c->p->d, q, area, &index) == LOFT_AT_VERTEX
                        ? LOFT_SINGULAR
                        : status));
    return other;
}

/* K of polygon/meanvalue.h inside simple polygons and beside them. */
static long double loss_of(const coordinates *c, loft_spot q)
{
    loft_sci area[LOFT_SIDES_MAX];
    long double own[LOFT_SIDES_MAX];
    unsigned index;

    return c->mean && loft_domain_place(&c->p->d, q, area, &index) != LOFT_ON_EDGE
               ? exact_meanvalue(c->p->v, c->p->n, q, own)
               : 1;
}

/* `rough`, over a longer step, gives the error of the differences. */
static void derivatives_of_coordinates_are_limits_of_differences(arb *a)
{
    const bool mean = arb_below(a, 2);
    arb_domain p = mean ? arb_simple(a) : arb_convex(a);
    const loft_spot q = (settle(&p), arb_near(a, &p));
    const coordinates c = { &p, mean };
    loft_sci phi[LOFT_SIDES_MAX];
    loft_jet jet[LOFT_SIDES_MAX];
    quad want[LOFT_SIDES_MAX][5], rough[LOFT_SIDES_MAX][5];
    long double first = 0, second = 0;

    if (both_of(&c, q, phi, jet) != LOFT_OK || !(quad_scale(&p, quad_of(q), mean) > 0))
        return;
    for (unsigned k = 0; k < p.n; k++) {
        first = fmaxl(first, fmaxl(fabsl(exact_sci(jet[k].x)), fabsl(exact_sci(jet[k].y))));
        second = fmaxl(second,
                       fmaxl(fabsl(exact_sci(jet[k].xx)),
                             fmaxl(fabsl(exact_sci(jet[k].xy)), fabsl(exact_sci(jet[k].yy)))));
    }
    const quad step = quad_less(quad_scale(&p, quad_of(q), mean), 1 / first) * 1e-7L;
    quad_differences(coordinates_at, &c, p.n, quad_of(q), 4 * step, rough);
    quad_differences(coordinates_at, &c, p.n, quad_of(q), step, want);
    const long double reach = 1 / (long double)quad_scale(&p, quad_of(q), true);
    const long double k2 = loss_of(&c, q) * loss_of(&c, q),
                      off = k2 * BY_NUM(0x1p-48L, 0x1p-40L, 0x1p-40L);
    for (unsigned i = 0; i < p.n; i++) {
        const loft_sci got[5] = { jet[i].x, jet[i].y, jet[i].xx, jet[i].xy, jet[i].yy };
        CHECK_EXACT(exact_sci(jet[i].f), exact_sci(phi[i]),
                    off * fmaxl(1, fabsl(exact_sci(phi[i]))));
        CHECK(loft_sci_sign(jet[i].f) == loft_sci_sign(phi[i]));
        for (int k = 0; k < 5; k++) {
            const long double own = 16 * (long double)quad_size(want[i][k] - rough[i][k]);
            const long double size = k < 2 ? first
                                           : first * first + second + (mean ? first * reach : 0);
            CHECK_EXACT(exact_sci(got[k]), (long double)want[i][k], own + size * off);
        }
    }
}

int main(void)
{
    PROPERTY(polynomials_of_whole_numbers_have_exact_derivatives, 2000);
    PROPERTY(a_quotient_undoes_a_product, 2000);
    PROPERTY(a_root_undoes_a_square, 2000);
    PROPERTY(derivatives_of_coordinates_are_limits_of_differences, 500);
    return check_failures();
}
