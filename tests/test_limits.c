/* tests/test_limits.c -- properties of lib/motion/limits.h and lib/motion/profile.h
 * SPDX-License-Identifier: MIT
 */
#include <math.h>               /* sqrt, exp, log: the reference */

#include "check.h"              /* CHECK, PROPERTY */
#include "motion/profile.h"     /* loft_budget, loft_piece, loft_phase */

static double value_of(loft_acc x)  { return BY_NUM((double)x / 4294967296.0, (double)x, (double)x); }

static loft_real real_of(double x)
{
    return BY_NUM((loft_real)floor(x * 65536 + 0.5), (loft_real)x, (loft_real)x);
}

static double arb_between(arb *a, double low, double high)
{
    return low + (high - low) * (double)(arb_next(a) >> 11) / 9007199254740992.0;
}

static double arb_decades(arb *a, double low, double high) { return exp(arb_between(a, log(low), log(high))); }

static loft_limits arb_limits(arb *a)
{
    loft_limits l;
    for (int i = 0; i < LOFT_AXES; i++) {
        l.max_speed[i] = real_of(arb_decades(a, 0.016, 16000));
        l.max_accel[i] = real_of(arb_decades(a, 1.001, 16000));
    }
    l.corner  = arb_below(a, 3) ? real_of(arb_decades(a, 0.0005, 0.9)) : 0;
    l.tol     = real_of(arb_decades(a, 0.001, 0.999));
    l.tick_hz = (uint16_t)arb_decades(a, 50, 50000);
    return l;
}

static double accel_size(const loft_budget *b)
{
    double sum = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        sum += arb_value(b->accel[i]) * arb_value(b->accel[i]);
    return sqrt(sum);
}

/* What rounding to beats costs stays within half the tolerance, and no shorter beat than needed is taken. */
static void a_beat_is_as_long_as_the_tolerance_allows(arb *a)
{
    const loft_limits l = arb_limits(a);
    loft_budget b;

    CHECK(loft_limits_check(&l) == LOFT_OK);
    loft_budget_init(&b, &l);
    const double t = (double)b.beat / l.tick_hz, longer = (b.beat + 1.0) / l.tick_hz, tol = arb_value(l.tol);
    CHECK(b.beat >= 1 && (b.beat == 1 || t <= 0.002));
    CHECK(accel_size(&b) * t * t / 8 <= tol / 2 * 1.0001);
    CHECK(longer > 0.002 || accel_size(&b) * 32 / 31 * longer * longer / 8 > tol / 2 * 0.999);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK(b.accel[i] > 0 && b.accel[i] < l.max_accel[i] && b.spare[i] >= 0);
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

/* The formulas of limits.c in double: the reserve or the junction deviation, whichever allows more. */
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
    const double spare = least(b.spare, d), accel = least(b.accel, d), along = fmin(16383, accel * turn);
    const double smooth = fmin(fmin(16383, spare) * fmin(16383, spare), accel * near / 32);
    const double s = sqrt(fmax(0, 1 - turn * turn / 4)), q2 = turn * turn / 4;
    const double c = fmin(16383, fmin(sqrt(along * arb_value(l.corner) * s * (1 + s) / q2), arb_value(b.swing) / turn));
    const double most = fmax(smooth, fmin(c * c, accel * near));
    const double got  = value_of(loft_budget_joint(&b, before, after, BY_NUM((loft_acc)(spacing * 4294967296.0), spacing, spacing)));
    CHECK(got >= 0 && got <= 16383.0 * 16383.0);
    CHECK_NEAR(sqrt(got), sqrt(most), 0.02 * sqrt(most) + BY_NUM(0.003, 1e-4, 1e-9));
}

/* Where a piece is passed, its phases hold the limits, meet, and end at the speeds they should. */
static void phases_hold_the_limits_and_meet(arb *a)
{
    loft_limits l = arb_limits(a);
    const double length = arb_decades(a, 0.0001, 250);
    loft_phase phase[LOFT_PHASES_MAX];
    loft_piece p;
    loft_budget b;

    for (int i = 0; i < LOFT_AXES; i++)
        l.max_accel[i] = real_of(arb_decades(a, 10, 16000));
    loft_budget_init(&b, &l);
    double u[LOFT_AXES], k[LOFT_AXES];
    arb_direction(a, u);
    arb_direction(a, k);
    p.length = BY_NUM((loft_acc)(length * 4294967296.0), length, length);
    const double turn = arb_below(a, 3) ? arb_decades(a, 1e-5, 0.1) : 0, v = arb_decades(a, 0.1, 1000);
    p.most[0] = p.most[1] = p.top = BY_NUM((loft_acc)(v * v * 4294967296.0), v * v, v * v);
    for (int i = 0; i < LOFT_AXES; i++) {
        const double bend = fmin(16000, turn / length) * k[i];
        for (int n = 0; n < 3; n++) {
            p.along[n].axis[i] = real_of(u[i]);
            p.bend[n].axis[i]  = real_of(bend);
        }
        if (fabs(arb_value(real_of(bend))) > 0) {
            const double most = arb_value(b.accel[i]) / fabs(arb_value(real_of(bend)));
            const loft_acc cap = BY_NUM((loft_acc)(fmin(most, 2e8) * 4294967296.0), fmin(most, 2e8), fmin(most, 2e8));
            p.top = cap < p.top ? cap : p.top;
        }
    }
    p.most[0] = p.most[1] = p.top;
    p.start = loft_acc_scale(p.top, loft_unit_of(arb_below(a, 5), 4));
    const loft_acc reach = loft_piece_reach(&p, &b, p.start, false);
    const loft_acc end   = loft_acc_scale(reach, loft_unit_of(arb_below(a, 5), 4));
    const loft_acc back  = loft_piece_reach(&p, &b, end, true);
    CHECK(reach >= p.start || !(reach < p.top));
    p.start = p.start < back ? p.start : back;

    const unsigned n = loft_piece_phases(&p, &b, end, phase);
    loft_acc sum = 0;
    CHECK(n >= 1 && n <= LOFT_PHASES_MAX);
    for (unsigned j = 0; j < n; j++) {
        const double top = fmax(value_of(phase[j].from), value_of(phase[j].to)), accel = arb_value(phase[j].accel);
        sum += phase[j].length;
        CHECK(phase[j].length >= 0 && phase[j].from <= p.top && phase[j].to <= p.top);
        CHECK(j == 0 ? phase[j].from == p.start : !(phase[j].from < phase[j - 1].to) && !(phase[j].from > phase[j - 1].to));
        for (int i = 0; i < LOFT_AXES && length > 0.01; i++)
            for (int sign = -1; sign <= 1; sign += 2) {     /* at both ends of the phase */
                const double x = sign < 0 ? value_of(phase[j].from) : value_of(phase[j].to), kk = arb_value(p.bend[0].axis[i]);
                CHECK(fabs(accel * arb_value(p.along[0].axis[i]) + x * kk) <= arb_value(b.accel[i]) * 1.001 + BY_NUM(0.001, 0, 0) * (1 + fabs(kk) * top));
            }
    }
    CHECK_NEAR(value_of(sum - p.length), 0, BY_NUM(0, 1e-12, 1e-12));
    CHECK_NEAR(value_of(phase[n - 1].to - end), 0, 0);
}

int main(void)
{
    PROPERTY(a_beat_is_as_long_as_the_tolerance_allows, 20000);
    PROPERTY(a_joint_allows_what_its_formulas_say,      20000);
    PROPERTY(phases_hold_the_limits_and_meet,           20000);
    return check_failures();
}
