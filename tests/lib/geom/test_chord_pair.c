/* tests/lib/geom/test_chord_pair.c -- properties of lib/geom/chord_pair.h
 * SPDX-License-Identifier: MIT
 */
#include "geom/chord_pair.h"
#include "support/exact.h"          /* exact_acc, CHECK_EXACT */

typedef struct {
    loft_chord a, b;
    loft_chord_pair pair;
    long double size;
} scene;

/* Chords of 1 LSB to the whole range that cross, pass, touch or run along each other. */
static void arb_scene(arb *a, scene *s)
{
    const int32_t limits[3] = { 1, 100, 16000 }, limit = limits[arb_below(a, 3)];
    const bool along = arb_below(a, 4) == 0;

    s->size = 0;
    for (int i = 0; i < LOFT_AXES; i++) {
        s->a.u[i] = loft_to_acc(arb_real(a, limit));
        s->b.u[i] = along ? s->a.u[i] + loft_acc_ratio(loft_to_acc(arb_real(a, limit)), 4096)
                          : loft_to_acc(arb_real(a, limit));
        s->pair.apart[i] = loft_acc_ratio(loft_to_acc(arb_real(a, limit)), 2);
        s->size = fmaxl(s->size, fabsl(exact_acc(s->a.u[i])));
        s->size = fmaxl(s->size, fabsl(exact_acc(s->b.u[i])));
        s->size = fmaxl(s->size, fabsl(exact_acc(s->pair.apart[i])));
    }
    loft_chord_aim(&s->a);
    loft_chord_aim(&s->b);
    s->pair.a = &s->a;
    s->pair.b = &s->b;
}

/* The distance of a point of the first chord from the second. */
static long double gap_at(const scene *s, long double at)
{
    long double uu = 0, uw = 0, rr = 0;

    for (int i = 0; i < LOFT_AXES; i++) {
        const long double u = exact_acc(s->b.u[i]),
                          w = exact_acc(s->pair.apart[i]) + at * exact_acc(s->a.u[i]);
        uu += u * u;
        uw += u * w;
    }
    const long double t = uu > 0 ? fminl(fmaxl(uw / uu, 0), 1) : 0;
    for (int i = 0; i < LOFT_AXES; i++) {
        const long double w = exact_acc(s->pair.apart[i]) + at * exact_acc(s->a.u[i]);
        rr += powl(w - t * exact_acc(s->b.u[i]), 2);
    }
    return sqrtl(rr);
}

/* By ternary search: the gap is convex. */
static long double least_gap(const scene *s)
{
    long double low = 0, high = 1;

    for (int round = 0; round < 200; round++) {
        const long double one = low + (high - low) / 3, two = high - (high - low) / 3;
        if (gap_at(s, one) < gap_at(s, two))
            high = two;
        else
            low = one;
    }
    return gap_at(s, low);
}

/* What a foot may err by. */
static long double foot_error(const scene *s)
{
    const long double size = s->size * 2 * sqrtl(LOFT_AXES);
    return BY_NUM(0x1p-30L + size * 0x1p-27L, size * 0x1p-42L, size * 0x1p-48L);
}

static void a_foot_is_where_it_says(arb *a)
{
    scene s;

    arb_scene(a, &s);
    const loft_unit at = loft_unit_of(arb_below(a, 1001), 1000);
    const loft_foot f = loft_chord_foot_at(&s.pair, at);
    CHECK(f.at <= at && f.at >= at && f.other >= 0 && exact_unit(f.other) <= 1);
    CHECK_EXACT(exact_acc(f.gap), gap_at(&s, exact_unit(at)), foot_error(&s));
    long double gap = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        gap += powl(exact_acc(s.pair.apart[i]) + exact_unit(at) * exact_acc(s.a.u[i]) -
                        exact_unit(f.other) * exact_acc(s.b.u[i]),
                    2);
    CHECK(sqrtl(gap) <= exact_acc(f.gap) + foot_error(&s) + s.size * 0x1p-21L);
}

static void the_closest_foot_is_the_closest(arb *a)
{
    scene s;
    loft_foot end[2];

    arb_scene(a, &s);
    loft_chord_ends(&s.pair, end);
    const loft_acc fine = arb_below(a, 2) ? 0 : loft_acc_ratio(loft_to_acc(LOFT_REAL(1)), 1024);
    const loft_foot f = loft_chord_closest(&s.pair, end, fine);
    const long double error = foot_error(&s), length = exact_acc(s.a.length);
    const long double least = least_gap(&s), here = gap_at(&s, exact_unit(f.at));

    CHECK_EXACT(exact_acc(f.gap), here, error);
    CHECK(here <=
          least + exact_acc(fine) + 2 * error + sqrtl(4 * error * length) + length * 0x1p-23L);
}

/* Everything that is near is before the end of the range, and nothing that is far. */
static void a_range_ends_between_near_and_most(arb *a)
{
    scene s;
    loft_foot end[2];

    arb_scene(a, &s);
    loft_chord_ends(&s.pair, end);
    const loft_foot in = loft_chord_closest(&s.pair, end, 0);
    const loft_acc near = in.gap + loft_acc_ratio(loft_to_acc(LOFT_REAL(1)),
                                                  (int32_t)(1 + arb_below(a, 1000))),
                   most = near + loft_acc_ratio(near, 4);
    const long double error = foot_error(&s) + exact_acc(s.a.length) * 0x1p-22L;

    for (int side = 0; side < 2; side++) {
        const loft_unit at = loft_chord_near_end(&s.pair, in, end[side], near, most);
        const long double gap = gap_at(&s, exact_unit(at));
        CHECK(side ? at >= in.at && exact_unit(at) <= 1 : at <= in.at && at >= 0);
        CHECK(gap <= exact_acc(most) + error);
        CHECK(gap >= exact_acc(near) - error || (side ? exact_unit(at) >= 1 : at <= 0));
    }
}

int main(void)
{
    PROPERTY(a_foot_is_where_it_says,            20000);
    PROPERTY(the_closest_foot_is_the_closest,     5000);
    PROPERTY(a_range_ends_between_near_and_most, 20000);
    return check_failures();
}
