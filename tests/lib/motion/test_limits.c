/* tests/lib/motion/test_limits.c -- properties of lib/motion/limits.h and lib/motion/profile.h
 * SPDX-License-Identifier: MIT
 */
#include <math.h>               /* sqrt, exp, log: the reference */

#include "check.h"              /* CHECK, PROPERTY */
#include "motion/profile.h"     /* loft_budget, loft_plan_piece */

static double value_of(loft_acc x)
{
    return BY_NUM((double)x / 4294967296.0, (double)x, (double)x);
}

static loft_real real_of(double x)
{
    return BY_NUM((loft_real)floor(x * 65536 + 0.5), (loft_real)x, (loft_real)x);
}

static double arb_between(arb *a, double low, double high)
{
    return low + (high - low) * (double)(arb_next(a) >> 11) / 9007199254740992.0;
}

static double arb_decades(arb *a, double low, double high)
{
    return exp(arb_between(a, log(low), log(high)));
}

static loft_limits arb_limits(arb *a)
{
    loft_limits l;
    for (int i = 0; i < LOFT_AXES; i++) {
        l.max_speed[i] = real_of(arb_decades(a, 0.016, 16000));
        l.max_accel[i] = real_of(arb_decades(a, 1.001, 16000));
    }
    const bool jerk = arb_below(a, 2);
    for (int i = 0; i < LOFT_AXES; i++)
        l.max_jerk[i] = jerk ? (uint32_t)arb_decades(a, 10, 1e6) : 0;
    l.corner  = arb_below(a, 3) ? real_of(arb_decades(a, 0.0005, 0.9)) : 0;
    l.tol     = real_of(arb_decades(a, 0.001, 0.999));
    l.tick_hz = (uint16_t)arb_decades(a, 50, 50000);
    l.max_across = arb_below(a, 3) ? 0 : real_of(arb_decades(a, 1.001, 16000));
    return l;
}

static double accel_size(const loft_budget *b)
{
    double sum = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        sum += arb_value(b->accel[i]) * arb_value(b->accel[i]);
    return sqrt(sum) + arb_value(b->across);
}

/* What rounding to beats costs stays within half the tolerance, and no shorter beat than needed is
 * taken. */
static void a_beat_is_as_long_as_the_tolerance_allows(arb *a)
{
    const loft_limits l = arb_limits(a);
    loft_budget b;

    CHECK(loft_limits_check(&l) == LOFT_OK);
    loft_budget_init(&b, &l);
    const double t = (double)b.beat / l.tick_hz, longer = (b.beat + 1.0) / l.tick_hz,
                 tol = arb_value(l.tol);
    const double most = b.jerk ? 0.008 : 0.002, share = b.jerk ? 0.5 : 5 / 12.0,
                 whole = b.jerk ? 1 : 64 / 63.0;
    CHECK(b.beat >= 1 && (b.beat == 1 || t <= most));
    CHECK(accel_size(&b) * t * t / 6 <= tol * share * 1.0001 + BY_NUM(1e-4 * t * t, 0, 0));
    CHECK(longer > most || accel_size(&b) * whole * longer * longer / 6 > tol * share * 0.999);
    for (int i = 0; i < LOFT_AXES; i++) {
        const double gain = l.max_jerk[i] > 0 ? l.max_jerk[i] * t : 1e9;
        CHECK(b.accel[i] > 0 && b.accel[i] <= l.max_accel[i] && b.spare[i] >= 0);
        CHECK_NEAR(arb_value(b.gain[i]), fmin(gain, arb_value(b.accel[i])),
                   1e-5 * gain * (gain < 1e5) + 2e-5);
    }
}

static void arb_direction(arb *a, double d[])
{
    double len = 0;
    for (int i = 0; i < LOFT_AXES; i++) {
        d[i] = arb_below(a, 4) ? arb_between(a, -1, 1) : 0;
        len += d[i] * d[i];
    }
    for (int i = 0; i < LOFT_AXES; i++)
        d[i] = len > 0 ? d[i] / sqrt(len) : i == 0;
}

/* min over the axes of limit / |d|, infinite where d is 0 */
static double least(const loft_real limit[], const double d[])
{
    double most = 1e300;
    for (int i = 0; i < LOFT_AXES; i++)
        most = fabs(d[i]) > 0 ? fmin(most, arb_value(limit[i]) / fabs(d[i])) : most;
    return most;
}

/* The formulas of limits.c in double: the reserve or the junction deviation, whichever allows
 * more. */
static void a_joint_allows_what_its_formulas_say(arb *a)
{
    const loft_limits l = arb_limits(a);
    const double spacing = arb_decades(a, 0.001, 10), near = fmin(1, spacing);
    double u[LOFT_AXES], w[LOFT_AXES], d[LOFT_AXES], turn = 0;
    loft_vec before, after;
    loft_budget b;

    loft_budget_init(&b, &l);
    arb_direction(a, u);
    arb_direction(a, w);
    const double toward = arb_decades(a, 0.01, 10);
    double len = 0;
    for (int i = 0; i < LOFT_AXES; i++) {
        w[i] = u[i] + toward * w[i];
        len += w[i] * w[i];
    }
    for (int i = 0; i < LOFT_AXES; i++) {
        before.axis[i] = real_of(u[i]);
        after.axis[i]  = real_of(len > 1e-6 ? w[i] / sqrt(len) : -u[i]);
        d[i] = arb_value(after.axis[i]) - arb_value(before.axis[i]);
        turn += d[i] * d[i];
    }
    turn = fmin(2, sqrt(turn));
    if (turn < 0.002)
        return;
    const double spare = least(b.spare, d), accel = least(b.accel, d),
                 along = fmin(16383, accel * turn);
    const double smooth = fmin(fmin(16383, spare) * fmin(16383, spare), least(b.share, d) * near);
    const double s = sqrt(fmax(0, 1 - turn * turn / 4)), q2 = turn * turn / 4;
    const double c = fmin(16383, fmin(sqrt(along * arb_value(l.corner) * s * (1 + s) / q2),
                                      arb_value(b.swing) / turn));
    const double bent = b.across > 0 ? arb_value(b.across) / turn : accel;
    const double most = b.jerk ? smooth : fmax(smooth, fmin(c * c, bent * near));
    const double got = value_of(loft_budget_joint(
        &b, &before, &after, BY_NUM((loft_acc)(spacing * 4294967296.0), spacing, spacing), true));
    CHECK(got >= 0 && got <= 16383.0 * 16383.0);
    CHECK_NEAR(sqrt(got), sqrt(most), 0.02 * sqrt(most) + BY_NUM(0.003, 1e-4, 1e-9));
}

static double bend_size(const loft_arc_shape *s)
{
    double sum = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        sum += arb_value(s->bend[0].axis[i]) * arb_value(s->bend[0].axis[i]);
    return sqrt(sum);
}

/* A straight piece or an even bend: within its lines velocity, acceleration and jerk, with the
 * means of the filter, hold the limits. */
static void the_lines_of_a_piece_hold_the_limits(arb *a)
{
    const loft_limits l = arb_limits(a);
    const double length = arb_decades(a, 0.01, 50), feed = arb_decades(a, 0.1, 1000);
    double u[LOFT_AXES], k[LOFT_AXES];
    loft_arc_shape s;
    loft_arc arc;
    loft_plan_piece p;
    loft_budget b;

    loft_budget_init(&b, &l);
    arb_direction(a, u);
    arb_direction(a, k);
    const double bend = arb_below(a, 3) ? arb_decades(a, 1e-3, 10) : 0;
    s.tight = false;
    for (int n = 0; n < 3; n++)
        for (int i = 0; i < LOFT_AXES; i++) {
            s.along[n].axis[i] = real_of(u[i]);
            s.bend[n].axis[i]  = real_of(bend * k[i]);
        }
    arc.length = BY_NUM((loft_acc)(length * 4294967296.0), length, length);
    (void)loft_profile_init(&p, &b, &arc, &s, real_of(feed));
    const double cap = arb_value(p.cap), h = (double)b.beat / l.tick_hz;
    CHECK(cap > 0 && cap <= arb_value(real_of(feed)) * 1.00001 && p.rest > 0);
    for (int n = 0; n <= 8; n++)
        for (int sign = -1; sign <= 1; sign += 2) {
            const double v = cap * n / 8, x = v * v;
            const loft_acc x2 = BY_NUM((loft_acc)(x * 4294967296.0), x, x);
            const double g = arb_value(loft_profile_grip(&p, x2, sign > 0));
            CHECK(b.across <= 0 ||
                  x * bend_size(&s) <= arb_value(b.across) * 1.0005 +
                                           BY_NUM(0.001 * (1 + bend * (1 + v)), 1e-4, 1e-9));
            for (int i = 0; i < LOFT_AXES; i++) {
                const double ui = arb_value(s.along[0].axis[i]), ki = arb_value(s.bend[0].axis[i]),
                             accel = arb_value(b.accel[i]);
                const double noise = BY_NUM(0.001 * (1 + fabs(ki) * (1 + v)), 1e-4, 1e-9);
                CHECK(fabs(ui) * v <= arb_value(l.max_speed[i]) * 1.0001 + noise);
                CHECK(fabs(sign * g * ui + (b.across > 0 ? 0 : x * ki)) <= accel * 1.0005 + noise);
                CHECK_NEAR(
                    fmax(1, b.jerk && arb_value(p.rest) > 0.26
                                ? g * (fabs(ui) / b.filter + 3 * fabs(ki) * v * h) /
                                      (arb_value(b.gain[i]) + noise + BY_NUM(g * 0x1p-15, 0, 0))
                                : 0),
                    1, 0.02);
            }
        }
}

static loft_vec near_vec(arb *a, const loft_vec *v, double by)
{
    loft_vec out;
    for (int i = 0; i < LOFT_AXES; i++)
        out.axis[i] = real_of(arb_value(v->axis[i]) + by * arb_between(a, -1, 1));
    return out;
}

/* A piece beside a joint, whose direction and curvature are nearly those of the way. */
static void arb_piece(arb *a, const loft_budget *b, const loft_way *way, double change, double feed,
                      loft_plan_piece *p, loft_arc_shape *s)
{
    const double length = arb_decades(a, 0.01, 1);
    loft_arc arc;

    s->tight = false;
    for (int k = 0; k < 3; k++) {
        s->along[k] = near_vec(a, &way->along, 0.05);
        s->bend[k]  = near_vec(a, &way->bend, change);
    }
    arc.length = BY_NUM((loft_acc)(length * 4294967296.0), length, length);
    (void)loft_profile_init(p, b, &arc, s, real_of(feed));
}

/* What easing adds to the curvature is -0.1757 to 0.5 of the jump; to the direction, a ninth of it
 * times the width. */
static void holds_where_it_is_eased(const loft_plan_piece *p, const loft_budget *b,
                                    const loft_limits *l, const loft_arc_shape *s, bool behind)
{
    for (int n = 0; n <= 8; n++)
        for (int sign = -1; sign <= 1; sign += 2) {
            const double v = arb_value(p->cap) * n / 8, x = v * v,
                         g = sign * arb_value(loft_profile_grip(
                                        p, BY_NUM((loft_acc)(x * 4294967296.0), x, x), sign > 0));
            for (int k = 0; k < 3; k++)
                for (int i = 0; i < LOFT_AXES; i++) {
                    const double u = arb_value(s->along[k].axis[i]),
                                 jump = arb_value(p->ease.jump[i]),
                                 most = fabs(u) + fabs(jump) *
                                                      BY_NUM((double)p->ease.width / 16777216.0,
                                                             (double)p->ease.width,
                                                             (double)p->ease.width) /
                                                      9;
                    for (int end = 0; end < 2; end++) {
                        const double bend = arb_value(s->bend[k].axis[i]) +
                                            (behind ? -1 : 1) * (end ? 0.5 : -0.1757) * jump;
                        const double noise = BY_NUM(0.002 * (1 + fabs(bend) * (1 + v)), 1e-4, 1e-9);
                        CHECK(most * v <= arb_value(l->max_speed[i]) * 1.0001 + noise);
                        const double used = b->across > 0 ? 0 : x * bend,
                                     accel = arb_value(b->accel[i]) * 1.0005 + noise;
                        CHECK(fabs((u < 0 ? -most : most) * g + used) <= accel &&
                              fabs(u * g + used) <= accel && fabs(used) <= accel);
                    }
                }
        }
}

static unsigned eased;

/* Some pieces on both sides, whose curvature may be another one than at the joint. */
static void an_eased_joint_holds_the_limits_wherever_it_is_eased(arb *a)
{
    const loft_limits l = arb_limits(a);
    const double feed = arb_decades(a, 1, 1000), size = arb_decades(a, 1e-3, 3),
                 change = size * arb_decades(a, 0.01, 2);
    loft_way way[2];
    loft_flank side[2];
    loft_plan_piece joint, piece[2][3];
    loft_arc_shape s[2][3];
    loft_budget b;
    double u[LOFT_AXES];

    loft_budget_init(&b, &l);
    if (!b.jerk)
        return;
    arb_direction(a, u);
    for (int i = 0; i < LOFT_AXES; i++)
        way[0].along.axis[i] = real_of(u[i]);
    way[1].along = way[0].along;
    for (int at = 0; at < 2; at++) {
        way[at].bend  = near_vec(a, &(loft_vec){ { 0 } }, size);
        way[at].cap   = real_of(feed);
        way[at].twist = 0;
        loft_flank_init(&side[at], &way[at]);
        for (int n = 0; n < 3; n++) {
            arb_piece(a, &b, &way[at], change, feed, &piece[at][n], &s[at][n]);
            loft_flank_add(&side[at], &piece[at][n], &b, &s[at][n]);
        }
    }
    const double room = arb_decades(a, 0.01, 2);
    if (!loft_profile_join(&joint, &b, &side[0], &side[1], BY_NUM((loft_acc)16 << 32, 16, 16),
                           BY_NUM((loft_acc)(room * 4294967296.0), room, room), real_of(feed)) ||
        !(joint.ease.width > 0))
        return;
    eased++;
    for (int at = 0; at < 2; at++)
        for (int n = 0; n < 3; n++)
            holds_where_it_is_eased(&joint, &b, &l, &s[at][n], at == 1);
}

static void joints_were_eased(arb *a)
{
    (void)a;
    CHECK(check_sampled() || eased > 100);
}

int main(void)
{
    PROPERTY(a_beat_is_as_long_as_the_tolerance_allows, 20000);
    PROPERTY(a_joint_allows_what_its_formulas_say,      20000);
    PROPERTY(the_lines_of_a_piece_hold_the_limits,      20000);
    PROPERTY(an_eased_joint_holds_the_limits_wherever_it_is_eased, 20000);
    PROPERTY(joints_were_eased, 1);
    return check_failures();
}
