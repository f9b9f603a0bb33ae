/* tests/lib/motion/test_across.c -- a limit of its own for acceleration across the path: both
 * limits hold, and the outline runs at its feed
 * SPDX-License-Identifier: MIT
 */
#include "support/motion_paths.h"   /* arb_smooth_chain, chain, limits */
#include "support/motion_spans.h"   /* plan_chain, spans               */
#include "support/motion_uses.h"    /* grain                           */

static const arrival whole = { CURVES, PIECES, NULL };

/* Acceleration at a place: its size across the path, that along it, and how much the path turns
 * there in a second. */
typedef struct {
    motion at;
    double along, across, turning;
} bend;

static bend bend_at(const loft_span *s, double z)
{
    bend b = { .at = span_at(s, z, limits.tick_hz) };
    double square = 0;

    for (int i = 0; i < LOFT_AXES && b.at.speed > 0; i++)
        b.along += b.at.a[i] * b.at.v[i] / b.at.speed;
    for (int i = 0; i < LOFT_AXES && b.at.speed > 0; i++)
        square += pow(b.at.a[i] - b.along * b.at.v[i] / b.at.speed, 2);
    b.across  = sqrt(square);
    b.turning = b.at.speed > 0 ? b.across / b.at.speed : 0;
    return b;
}

/* What the path turns by in a beat, in span k or near it: samples are as far apart. */
static double turn_near(unsigned k)
{
    double most = 0;
    loft_budget b;

    loft_budget_init(&b, &limits);
    for (unsigned n = k < 2 ? 0 : k - 2; n <= k + 2 && n < count; n++)
        for (int j = 0; j <= 4; j++)
            most = fmax(most, bend_at(&spans[n], j / 4.0).turning);
    return most * b.beat / limits.tick_hz;
}

static double strongest(void)
{
    double most = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        most = fmax(most, arb_value(limits.max_accel[i]));
    return most;
}

static void check_span(unsigned k)
{
    const loft_span *s = &spans[k];
    const double noise = sqrt(LOFT_AXES) * 12 * grain() / (duration(s) * duration(s)),
                 turn = turn_near(k);
    const double across = arb_value(limits.max_across), accel = strongest();

    for (int j = 0; j <= 4; j++) {
        const bend b = bend_at(s, j / 4.0);
        for (int i = 0; i < LOFT_AXES; i++) {
            const double most = arb_value(limits.max_accel[i]),
                         along = b.at.speed > 0 ? b.along * b.at.v[i] / b.at.speed : 0;
            CHECK(fabs(b.at.a[i]) <= (most + across) * 1.0005 + noise);
            CHECK(fabs(along) <=
                  most * 1.0005 + (accel + across) / 100 + across * turn / 2 + noise);
        }
        CHECK(b.across <= across * 1.0005 + (accel + across) / 100 + accel * turn / 2 + noise);
    }
}

static void both_limits_hold_on_smooth_chains(arb *a)
{
    arb_limits(a);
    limits.max_across = real_of(arb_decades(a, 100, 10000));
    arb_smooth_chain(a);
    if (plan_chain(&whole) != PLANNED)
        return;
    CHECK(spans_connect());
    for (unsigned k = 0; k < count; k++)
        check_span(k);
}

/* Twice around, r = 5 mm, in quarters whose curvature is even to 0.6 %. */
static void load_circles(double feed)
{
    const double d[LOFT_AXES] = { 1 }, e[LOFT_AXES] = { 0, 1 }, c = 0.5522847498;

    begin_chain();
    for (int q = 0; q < 8; q++) {
        const double x = 5 * (q % 4 == 0) - 5 * (q % 4 == 2),
                     y = 5 * (q % 4 == 1) - 5 * (q % 4 == 3);
        const double u[4] = { x, x - c * y, c * x - y, -y }, w[4] = { y, y + c * x, c * y + x, x };
        here[0] = here[1] = 0;
        add_curve(d, e, u, w, feed);
    }
}

/* 100 mm/s need 2000 mm/s^2 there: L / v + v / a with that, the speed of 1000 mm/s^2 with those;
 * with none that of the axes' 500, which add up on diagonals: it swings about 50 mm/s. */
static void a_bend_costs_what_its_own_limit_says(arb *a)
{
    static const double plans[][2] = { { 2100, 100 }, { 1000, 70.71 }, { 0, 52.6 } };
    (void)a;
    for (int k = 0; k < 3; k++) {
        double top = 0, length = 0;
        even_limits(1000, 500, 0);
        limits.max_across = real_of(plans[k][0]);
        load_circles(100);
        CHECK(plan_chain(&whole) == PLANNED);
        for (unsigned n = 0; n < count; n++) {
            const double speed = span_at(&spans[n], 0.5, limits.tick_hz).speed;
            top = fmax(top, speed);
            length += speed * duration(&spans[n]);
        }
        CHECK_NEAR(length, 20 * 3.14159265, 0.1);
        CHECK_NEAR(top, plans[k][1], 0.02 * plans[k][1]);
        CHECK(k > 0 || seconds() <= 1.03 * (length / 100 + 100 / 500.0));
    }
}

int main(void)
{
    PROPERTY(both_limits_hold_on_smooth_chains, 100);
    PROPERTY(a_bend_costs_what_its_own_limit_says, 1);
    return check_failures();
}
