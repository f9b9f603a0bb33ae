/* tests/tools/test_print.c -- printed numbers carry their number type
 * SPDX-License-Identifier: MIT
 */
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "geometry/print.h"
#include "check.h"

#define COUNT 3

/* What print.c asks of an engine. */
static const engine types[COUNT] = { { .fixed = true, .lsb = 0x1p-16 },
                                     { .lsb = (double)FLT_EPSILON },
                                     { .lsb = DBL_EPSILON } };
static const engine *const q16 = &types[0], *const f32 = &types[1], *const f64 = &types[2];

/* A number of the type, of any size that it has. */
static double number_of(arb *a, const engine *e)
{
    const double raw = (double)(int32_t)(uint32_t)arb_next(a);

    if (e->fixed)
        return raw * e->lsb * ldexp(1, -(int)arb_below(a, 16));
    const double x = ldexp(raw + (double)(uint32_t)arb_next(a) * 0x1p-32,
                           (int)arb_below(a, 80) - 60);
    return e == f32 ? (double)(float)x : x;
}

static void a_number_is_told_from_its_neighbours(arb *a)
{
    for (int i = 0; i < COUNT; i++) {
        const engine *e = &types[i];
        const double x = number_of(a, e), read = strtod(number_text(e, x), NULL),
                     off = fabs(read - x);
        CHECK(e->fixed ? off <= e->lsb / 4 : off <= fabs(x) * e->lsb / 4);
        CHECK(off <= fabs(x) * 5.1e-9);
        CHECK(e != f32 || (float)read == (float)x);
    }
}

static void a_parameter_has_24_bits_behind_its_point(arb *a)
{
    const double t = (double)arb_below(a, UINT32_C(1) << 31) * 0x1p-24;

    CHECK(lround(ldexp(strtod(parameter_text(q16, t), NULL), 24)) == lround(ldexp(t, 24)));
    CHECK(fabs(strtod(parameter_text(f64, t), NULL) - t) <= t * 0x1p-54);
}

static void a_bound_is_never_told_smaller(arb *a)
{
    const double x = fabs(number_of(a, f64)), told = strtod(bound_text(x), NULL);

    CHECK(told >= x && told <= x * 1.0101);
}

static void eight_texts_stand_in_one_line(arb *a)
{
    const char *text[8];
    double x[8];

    for (int i = 0; i < 8; i++) {
        x[i]    = number_of(a, f64);
        text[i] = i % 2 ? number_text(f64, x[i]) : parameter_text(f64, x[i]);
    }
    for (int i = 0; i < 8; i++)
        CHECK(fabs(strtod(text[i], NULL) - x[i]) <= fabs(x[i]) * 0x1p-54);
}

int main(void)
{
    PROPERTY(a_number_is_told_from_its_neighbours, 20000);
    PROPERTY(a_parameter_has_24_bits_behind_its_point, 20000);
    PROPERTY(a_bound_is_never_told_smaller, 20000);
    PROPERTY(eight_texts_stand_in_one_line, 1000);
    return check_failures();
}
