/* tests/lib/motion/test_scurve.c -- properties of lib/motion/scurve.h
 * SPDX-License-Identifier: MIT
 */
#include "support/exact.h"      /* exact_of, exact_acc; CHECK, PROPERTY, BY_NUM */
#include "motion/scurve.h"

#define SAMPLES 40

static loft_real real_of(long double x) { return loft_real_from_raw((int32_t)floorl(x * 65536)); }

static long double arb_decades(arb *a, long double low, long double high)
{
    return low * powl(high / low, (long double)arb_below(a, 1u << 30) / (1u << 30));
}

static loft_scurve_limits arb_limits(arb *a)
{
    return (loft_scurve_limits) {
        .max_speed = real_of(arb_decades(a, 0.1L, 2000)),
        .max_accel = real_of(arb_decades(a, 1.01L, 20000)),
        .max_jerk  = arb_below(a, 8) ? (uint32_t)arb_decades(a, 1, 1e7L) : 0,
        .tick_hz   = (uint16_t)arb_decades(a, 1, 50000),
    };
}

static loft_real arb_place(arb *a) { return real_of(arb_decades(a, 0.0001L, 16000)); }

/* The shortest time in seconds from rest to rest, case by case: which limits are reached? */
static long double shortest(long double way, const loft_scurve_limits *l)
{
    const long double v = exact_of(l->max_speed), a = exact_of(l->max_accel);
    const long double j = l->max_jerk ? l->max_jerk : 1e30L;

    if (v * j >= a * a) {
        if (way >= v * (v / a + a / j))
            return way / v + v / a + a / j;
        if (way >= 2 * a * a * a / (j * j))
            return a / j + sqrtl(a * a / (j * j) + 4 * way / a);
    } else if (way >= 2 * v * sqrtl(v / j))
        return way / v + 2 * sqrtl(v / j);
    return 4 * powl(way / (2 * j), 1 / 3.0L);
}

/* The axis at one tick: place, speed, acceleration, and jerk from there on, per tick. */
typedef struct {
    long double x, v, a, j;
} state;

/* Integrate the jerk of a part from its beginning, piece by piece. */
static state part_at(const loft_scurve_part *p, uint32_t tick)
{
    const uint32_t c = p->cruise, r = p->ramp, e = p->ease;
    const uint32_t corner[8] = { 0, e, r, r + e, c, c + e, c + r, c + r + e };
    static const int sign[8] = { 1, -1, -1, 1, -1, 1, 1, -1 };
    state s = { 0 };

    for (int i = 0; i < 8 && tick >= p->start + corner[i]; i++) {
        const uint32_t until = i < 7 ? corner[i + 1] : UINT32_MAX - p->start;
        const uint32_t now = tick - p->start < until ? tick - p->start : until;
        const long double t = (long double)(now - corner[i]);
        s.j += sign[i] * exact_acc(p->way) / ((long double)c * r * e);
        if (i == 7)
            return (state) { exact_acc(p->way), 0, 0, 0 };
        s.x += t * (s.v + t * (s.a / 2 + t * s.j / 6));
        s.v += t * (s.a + t * s.j / 2);
        s.a += t * s.j;
    }
    return s;
}

static state state_at(const loft_scurve *s, uint32_t tick)
{
    state sum = { exact_acc(s->from), 0, 0, 0 };

    for (int i = 0; i < s->count; i++) {
        const state p = part_at(&s->part[i], tick);
        sum.x += p.x;
        sum.v += p.v;
        sum.a += p.a;
        sum.j += p.j;
    }
    return sum;
}

/* Way, acceleration and speed change sign together with jerk at corners alone. */
static void check_limits(const loft_scurve *s, uint32_t tick)
{
    const loft_scurve_limits *l = &s->limits;
    const long double hz = l->tick_hz, slack = 1 + 1e-6L;
    const state at = state_at(s, tick);

    CHECK(fabsl(at.v) * hz <= exact_of(l->max_speed) * slack);
    CHECK(fabsl(at.a) * hz * hz <= exact_of(l->max_accel) * slack + 1e-9L * hz * hz);
    CHECK(!l->max_jerk || fabsl(at.j) * hz * hz * hz <= l->max_jerk * slack + 1e-9L * hz * hz * hz);
}

/* At each corner of each part, one before, and at some ticks between. */
static void check_move(const loft_scurve *s, uint32_t from, arb *a)
{
    for (int i = 0; i < s->count; i++) {
        const loft_scurve_part *p = &s->part[i];
        for (unsigned k = 0; k < 8; k++) {
            const uint32_t tick = p->start + (k & 1 ? p->ease : 0) + (k & 2 ? p->ramp : 0) +
                                  (k & 4 ? p->cruise : 0);
            if (tick > from) {
                check_limits(s, tick);
                check_limits(s, tick - 1);
            }
        }
    }
    for (int i = 0; i < SAMPLES; i++)
        check_limits(s, from + arb_below(a, s->ticks - from + 1));
}

static long double bound(long double largest, long double parts)
{
    (void)parts;
    return BY_NUM(0.5L * LSB + parts * LSB / 65536, 0.5001L * ulp(largest), 4 * ulp(largest)) +
           largest * 1e-17L;
}

static void places_are_those_of_even_jerk(arb *a)
{
    const loft_scurve_limits limits = arb_limits(a);
    const loft_real from = arb_place(a), to = arb_place(a);
    const long double largest = fmaxl(exact_of(from), exact_of(to));
    loft_scurve s;

    if (loft_scurve_init(&s, from, to, &limits) != LOFT_OK)
        return;
    for (int i = 0; i < SAMPLES; i++) {
        const uint32_t tick = arb_below(a, s.ticks + 2);
        CHECK_EXACT(exact_of(loft_scurve_eval(&s, tick)), state_at(&s, tick).x, bound(largest, 1));
    }
    check_move(&s, 0, a);
}

static void it_goes_one_way_and_arrives(arb *a)
{
    const loft_scurve_limits limits = arb_limits(a);
    const loft_real from = arb_place(a), to = arb_place(a);
    loft_scurve s;
    loft_real before = from;

    if (loft_scurve_init(&s, from, to, &limits) != LOFT_OK)
        return;
    CHECK(loft_scurve_eval(&s, 0) == from);
    CHECK(loft_scurve_eval(&s, s.ticks) == to && loft_scurve_eval(&s, UINT32_MAX) == to);
    const uint32_t step = 1 + s.ticks / 200;
    for (uint32_t tick = 1; tick < s.ticks; tick += step) {
        const loft_real at = loft_scurve_eval(&s, tick);
        CHECK(from < to ? before <= at && at <= to : before >= at && at >= to);
        before = at;
    }
}

static void no_move_is_much_longer_than_the_shortest(arb *a)
{
    const loft_scurve_limits limits = arb_limits(a);
    const loft_real from = arb_place(a), to = arb_place(a);
    const long double way = fabsl(exact_of(to) - exact_of(from));
    const long double least = shortest(way, &limits) * limits.tick_hz;
    loft_scurve s;

    if (loft_scurve_init(&s, from, to, &limits) != LOFT_OK) {
        CHECK(least >= LOFT_SCURVE_TICKS - 4);
        return;
    }
    CHECK((long double)s.ticks >= least * (1 - 1e-12L));
    CHECK((long double)s.ticks < least * (1 + 1e-12L) + 4 + (way > 0 ? 0 : 1));
}

/* Again and again, the target changes at any tick: nothing jumps, no limit breaks. */
static void a_new_target_keeps_all_limits(arb *a)
{
    const loft_scurve_limits limits = arb_limits(a);
    const loft_real origin = arb_place(a);
    long double largest = exact_of(origin);
    uint32_t tick = 0;
    loft_scurve s;

    if (loft_scurve_init(&s, origin, arb_place(a), &limits) != LOFT_OK)
        return;
    for (int i = 0; i < 6; i++) {
        const loft_scurve old = s;
        const loft_real to = arb_place(a);
        const uint32_t left = old.ticks > tick ? old.ticks - tick : 0;
        largest = fmaxl(largest, fmaxl(exact_of(to), exact_of(old.to)));
        tick += arb_below(a, left + left / 8 + 2);
        if (loft_scurve_retarget(&s, tick, to) != LOFT_OK) {
            CHECK(s.to == old.to && s.ticks == old.ticks && s.count == old.count);
            continue;
        }
        const state was = state_at(&old, tick), is = state_at(&s, tick);
        CHECK_EXACT(is.x, was.x, bound(largest, 8));
        CHECK_NEAR(is.v, was.v, 1e-9 + 1e-12 * fabs((double)was.v));
        CHECK_NEAR(is.a, was.a, 1e-9 + 1e-12 * fabs((double)was.a));
        check_move(&s, tick, a);
        for (int k = 0; k < 5; k++) {
            const uint32_t t = tick + arb_below(a, s.ticks - tick + 1);
            CHECK_EXACT(exact_of(loft_scurve_eval(&s, t)), state_at(&s, t).x, bound(largest, 16));
        }
        CHECK(loft_scurve_eval(&s, s.ticks) == to);
        CHECK_EXACT(state_at(&s, s.ticks).x, exact_of(to), bound(largest, 16));
    }
}

/* A stop takes n2 + n3 ticks after the step's end; then a move from rest. */
static void a_new_target_takes_a_stop_and_a_move_at_most(arb *a)
{
    const loft_scurve_limits limits = arb_limits(a);
    const loft_real from = arb_place(a), to = arb_place(a), other = arb_place(a);
    loft_scurve s, fresh;

    if (loft_scurve_init(&s, from, to, &limits) != LOFT_OK)
        return;
    const uint32_t ease = s.part[0].ramp + s.part[0].ease, tick = arb_below(a, s.ticks);
    if (to == other || loft_scurve_retarget(&s, tick, other) != LOFT_OK)
        return;
    const uint32_t stop = (tick > ease ? tick : ease) + ease;
    long double rest = exact_of(from);
    if (tick > 0) {             /* rounded away from the target */
        rest += exact_acc(s.part[0].way);
        rest += (exact_of(other) < rest ? 2 : -2) * (ulp(16000) + LSB);
    }
    if (loft_scurve_init(&fresh, real_of(rest), other, &limits) == LOFT_OK)
        CHECK(s.ticks <= (tick == 0 ? 0 : stop) + fresh.ticks + 2);
    if (tick == 0)
        CHECK(s.ticks == fresh.ticks);
}

/* Ahead, far enough, the speed does not fall. */
static void a_target_further_ahead_is_met_without_a_stop(arb *a)
{
    const loft_scurve_limits limits = {
        .max_speed = LOFT_REAL(100), .max_accel = LOFT_REAL(500), .max_jerk = 10000, .tick_hz = 1000
    };
    const uint32_t tick = 300 + arb_below(a, 700);      /* it moves at 100 */
    loft_scurve s, whole;

    CHECK(loft_scurve_init(&s, 0, LOFT_REAL(100), &limits) == LOFT_OK);
    CHECK(loft_scurve_init(&whole, 0, LOFT_REAL(1000), &limits) == LOFT_OK);
    CHECK(s.ticks == 1250 && whole.ticks == 10250);
    CHECK(loft_scurve_retarget(&s, tick, LOFT_REAL(1000)) == LOFT_OK);
    CHECK(s.ticks == whole.ticks || s.ticks == whole.ticks + 1);
    for (uint32_t t = tick; t + 260 < s.ticks; t += 97)
        CHECK(state_at(&s, t).v > 0.0999L);
    CHECK(loft_scurve_retarget(&s, 5000, LOFT_REAL(0)) == LOFT_OK);
    CHECK(s.ticks >= 5250 + 5000 && s.ticks <= 5250 + 5000 + 260);
}

static void what_cannot_be_is_refused(arb *a)
{
    const loft_scurve_limits good = {
        .max_speed = LOFT_REAL(1), .max_accel = LOFT_REAL(10), .max_jerk = 100, .tick_hz = 1000
    };
    loft_scurve_limits bad = good;
    loft_scurve s;

    bad.max_speed = -arb_place(a);
    CHECK(loft_scurve_init(&s, 0, LOFT_REAL(1), &bad) == LOFT_ERR_ARG);
    bad = good;
    bad.max_accel = LOFT_REAL(0.5);
    CHECK(loft_scurve_init(&s, 0, LOFT_REAL(1), &bad) == LOFT_ERR_ARG);
    bad = good;
    bad.tick_hz = (uint16_t)(arb_below(a, 2) ? 0 : 50001 + arb_below(a, 10000));
    CHECK(loft_scurve_init(&s, 0, LOFT_REAL(1), &bad) == LOFT_ERR_ARG);
    CHECK(loft_scurve_init(&s, LOFT_REAL(-20000), LOFT_REAL(20000), &good) == LOFT_ERR_RANGE);
    CHECK(loft_scurve_init(&s, 0, LOFT_REAL(1049), &good) == LOFT_ERR_RANGE);
    CHECK(loft_scurve_init(&s, 0, LOFT_REAL(1048), &good) == LOFT_OK);
    CHECK(loft_scurve_retarget(&s, 2000, LOFT_REAL(30000)) == LOFT_ERR_RANGE && s.count == 1);
}

/* The loop of the header, with these limits: every tick is given, the last one is the end. */
static void the_loop_of_its_header_comes_to_the_end(arb *a)
{
    const loft_real from = arb_real(a, 100), to = arb_real(a, 100);
    loft_real place = from;

    static const loft_scurve_limits limits = {
        .max_speed = LOFT_REAL(100), .max_accel = LOFT_REAL(500), .max_jerk = 10000, .tick_hz = 1000
    };
    loft_scurve move;
    if (loft_scurve_init(&move, from, to, &limits) == LOFT_OK)
        for (uint32_t tick = 1; tick <= move.ticks; tick++)
            place = loft_scurve_eval(&move, tick);
    CHECK(place >= to && place <= to);
}

int main(void)
{
    PROPERTY(places_are_those_of_even_jerk, 2000);
    PROPERTY(it_goes_one_way_and_arrives, 1000);
    PROPERTY(no_move_is_much_longer_than_the_shortest, 20000);
    PROPERTY(a_new_target_keeps_all_limits, 3000);
    PROPERTY(a_new_target_takes_a_stop_and_a_move_at_most, 5000);
    PROPERTY(a_target_further_ahead_is_met_without_a_stop, 500);
    PROPERTY(what_cannot_be_is_refused, 200);
    PROPERTY(the_loop_of_its_header_comes_to_the_end, 30);
    return check_failures();
}
