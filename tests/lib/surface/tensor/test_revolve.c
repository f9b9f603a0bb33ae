/* tests/lib/surface/tensor/test_revolve.c -- properties of lib/surface/tensor/revolve.h
 * SPDX-License-Identifier: MIT
 */
#include "support/rationals.h"          /* arb_rational, sample; CHECK, PROPERTY, BY_NUM */
#include "surface/tensor/revolve.h"
#include "surface/tensor/tensor_rational.h"

#define NET (3 * (LOFT_DEGREE_MAX + 1))

#if LOFT_AXES < 2
#  error "these tests turn about the third axis"
#endif

/* A point keeps its distance from the axis and its height. */
static void points_stay_on_their_circle(arb *a)
{
    const sample *s = arb_rational(a, LOFT_DEGREE_MAX);
    const loft_unit u = arb_unit(a), v = arb_unit(a);
    const unsigned k = arb_below(a, 4);
    loft_vec p = { { 0 } };

    if (loft_revolve_eval(&s->r, k, u, v, &p) != LOFT_OK)
        return;
    const loft_vec q = loft_rational_eval(&s->r, u);
    const long double from = hypotl(exact_of(q.axis[0]), exact_of(q.axis[1])),
                      to = hypotl(exact_of(p.axis[0]), exact_of(p.axis[1]));
    CHECK_EXACT(to, from, BY_NUM(2 * LSB, 4 * ulp(s->largest), 512 * ulp(s->largest)));
    for (int i = 2; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(p.axis[i]), exact_of(q.axis[i]),
                    BY_NUM(LSB, 2 * ulp(s->largest), 128 * ulp(s->largest)));
}

/* The angle of the middle is 45 degrees, and quarters meet. */
static void quarters_meet_and_are_halved_by_their_middle(arb *a)
{
    const sample *s = arb_rational(a, LOFT_DEGREE_MAX);
    const loft_unit u = arb_unit(a);
    const unsigned k = arb_below(a, 3);
    loft_vec end = { { 0 } }, start = { { 0 } }, middle = { { 0 } };

    if (loft_revolve_eval(&s->r, k, u, LOFT_UNIT(1), &end) != LOFT_OK ||
        loft_revolve_eval(&s->r, k + 1, u, 0, &start) != LOFT_OK ||
        loft_revolve_eval(&s->r, 0, u, LOFT_UNIT(0.5), &middle) != LOFT_OK)
        return;
    const loft_vec p = loft_rational_eval(&s->r, u);
    const long double x = exact_of(p.axis[0]), y = exact_of(p.axis[1]), c = sqrtl(0.5L);
    const long double room = BY_NUM(1.5L * LSB, 4 * ulp(s->largest), 256 * ulp(s->largest));
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(end.axis[i]), exact_of(start.axis[i]), BY_NUM(0, room, room));
    CHECK_EXACT(exact_of(middle.axis[0]), c * (x - y), room);
    CHECK_EXACT(exact_of(middle.axis[1]), c * (x + y), room);
}

static void the_net_makes_the_same_surface(arb *a)
{
    static loft_weighted net[NET];
    const sample *s = arb_rational(a, LOFT_DEGREE_MAX);
    const loft_unit u = arb_unit(a), v = arb_unit(a);
    const unsigned k = arb_below(a, 4);
    loft_tensor_rational t;
    loft_vec p = { { 0 } };

    if (loft_tensor_rational_from_revolve(&s->r, k, net) != LOFT_OK ||
        loft_tensor_rational_init(&t, net, s->n, 2) != LOFT_OK ||
        loft_revolve_eval(&s->r, k, u, v, &p) != LOFT_OK)
        return;
    const loft_vec q = loft_tensor_rational_eval(&t, u, v);
    long double least = 256;
    for (unsigned i = 0; i <= s->n; i++)
        least = fminl(least, s->w[i]);
    /* a weight is off by 1/2 LSB of w / sqrt 2: that moves points by its part of the radius */
    const long double moved = LSB / least * 3 * s->largest;
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK_EXACT(exact_of(p.axis[i]), exact_of(q.axis[i]),
                    BY_NUM(1.1L * LSB, 64 * ulp(s->largest), 512 * ulp(s->largest)) +
                        BY_NUM(1, 0, 0) * moved);
}

static void mistakes_are_refused(arb *a)
{
    static loft_weighted net[NET];
    const sample *s = arb_rational(a, LOFT_DEGREE_MAX);
    loft_vec v;

    CHECK(loft_tensor_rational_from_revolve(&s->r, 4, net) == LOFT_ERR_ARG);
    CHECK(loft_revolve_eval(&s->r, 4, 0, 0, &v) == LOFT_ERR_ARG &&
          loft_revolve_eval(&s->r, 0, LOFT_UNIT(1.5), 0, &v) == LOFT_ERR_ARG &&
          loft_revolve_eval(&s->r, 0, 0, LOFT_UNIT(-0.5), &v) == LOFT_ERR_ARG);
}

int main(void)
{
    PROPERTY(points_stay_on_their_circle,                  1000);
    PROPERTY(quarters_meet_and_are_halved_by_their_middle, 1000);
    PROPERTY(the_net_makes_the_same_surface,               1000);
    PROPERTY(mistakes_are_refused,                           50);
    return check_failures();
}
