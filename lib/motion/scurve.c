/* lib/motion/scurve.c
 * SPDX-License-Identifier: MIT
 *
 * Averaging a step of size D over n1 ticks, the result over n2, and that over n3, makes an S-curve:
 * speed D / n1, acceleration D / (n1 n2), jerk D / (n1 n2 n3), if n1 >= n2 + n3 and n2 >= n3. With
 * speed, acceleration and jerk of the limits per tick this asks for
 *
 *     n1 >= K1 = D f / v,   n1 n2 >= K2 = D f^2 / a,   n1 n2 n3 >= K3 = D f^3 / j,
 *
 * f ticks a second. The time n1 + n2 + n3 is shortest in real numbers where
 *
 *     n3 = min(cbrt(K3 / 2), K3 / K2, sqrt(K3 / K1)),
 *     n2 = max(n3, min(K2 / K1, n with n (n + n3) = K2)),
 *     n1 = max(K1, n2 + n3, K2 / n2, K3 / (n2 n3)):
 *
 * the seven-piece profile, whichever limits it reaches. Here n3 and n2 are rounded up to whole
 * ticks, and n1 follows from them by the same line: integers hold each limit, whatever was rounded
 * before.
 *
 * The place after t ticks is D N / M with M = 6 n1 n2 n3 and
 *
 *     N = t^3 - (t - n2)^3 - (t - n3)^3 + (t - n2 - n3)^3     up to the middle,
 *
 * where negative cubes count as 0; behind it 1 minus the same, seen from the end. Up to 2^20 ticks
 * M < 2^63, since n2 n3 <= n1^2 / 4, and t^3 < 2^61. Only the quotient counts, so that a loft_acc
 * may hold both in any number type: in doubles within 1/2 ulp.
 *
 * A move is cut short by ending its step after k < n1 ticks: D becomes D k / n1. A second step with
 * the same n2 and n3 may begin there, of the same sign. Of r, the speed of the steps, the jerk is
 * (r(t) - r(t - n2) - r(t - n3) + r(t - n2 - n3)) / (n2 n3). Changes of r are n2 + n3 apart, so
 * that one of the two differences is 0, and the other is at most the larger r.
 */
#include "motion/scurve.h"
#include "num/muldiv.h"         /* loft_acc_muldiv */

#define MOST LOFT_SCURVE_TICKS

typedef struct {
    uint64_t k[3];              /* K1, K2, K3, rounded up */
} needs;

static uint64_t quotient_up(uint64_t x, uint64_t y) { return (x + y - 1) / y; }

/* raw Q16.16, rounded up, of 0 <= x < 32768 */
static uint64_t raw_up(loft_acc x)
{
    const uint64_t raw = (uint64_t)loft_raw_from_real(loft_acc_round(x));
    return loft_to_acc(loft_real_from_raw((int32_t)raw)) < x ? raw + 1 : raw;
}

static uint64_t raw_down(loft_real a)
{
    const int32_t raw = loft_raw_from_real(a);
    return (uint64_t)(loft_real_from_raw(raw) > a ? raw - 1 : raw);
}

/* Times f / y once more: *k and the remainder below y. */
static void times(uint64_t *k, uint64_t *rest, uint32_t f, uint64_t y)
{
    const uint64_t low = *rest * f;

    *k = *k * f + low / y;
    *rest = low % y;
}

/* x f^power / y, rounded up; above 2^58 any such number. x < 2^31, f < 2^16, 2^16 <= y < 2^48 */
static uint64_t scaled(uint64_t x, uint32_t f, uint64_t y, int power)
{
    uint64_t k = x * f / y, rest = x * f % y;

    for (int i = 1; i < power; i++) {
        if (k >> 44)
            return (uint64_t)1 << 60;
        times(&k, &rest, f, y);
    }
    return k + (rest > 0);
}

static bool needed(needs *n, loft_acc way, const loft_scurve_limits *l)
{
    const uint64_t x = raw_up(loft_acc_abs(way));

    n->k[0] = quotient_up(x * l->tick_hz, raw_down(l->max_speed));
    n->k[1] = scaled(x, l->tick_hz, raw_down(l->max_accel), 2);
    n->k[2] = l->max_jerk ? scaled(x, l->tick_hz, (uint64_t)l->max_jerk * 65536, 3) : 0;
    return n->k[0] <= MOST && n->k[1] <= (uint64_t)MOST * MOST &&
           n->k[2] <= (uint64_t)MOST * MOST * MOST / 4;
}

/* Is n as long as n3 has to be, or n2 where n3 is given? */
static bool enough(const needs *w, uint64_t n, uint64_t ease)
{
    const uint64_t *k = w->k;

    return ease ? n * (n + ease) >= k[1] || n * k[0] >= k[1]
                : 2 * n * n * n >= k[2] || n * k[1] >= k[2] || n * n * k[0] >= k[2];
}

/* The smallest n >= 1 that is, bit by bit. */
static uint32_t shortest(const needs *w, uint32_t ease)
{
    uint32_t n = 0;

    for (uint32_t bit = MOST / 2; bit; bit /= 2)
        if (!enough(w, n + bit, ease))
            n += bit;
    return n + 1;
}

/* n1, given the others. */
static bool cruise_of(loft_scurve_part *p, const needs *w)
{
    const uint64_t least[3] = { (uint64_t)p->ramp + p->ease, quotient_up(w->k[1], p->ramp),
                                quotient_up(w->k[2], (uint64_t)p->ramp * p->ease) };
    uint64_t n = w->k[0];

    for (int i = 0; i < 3; i++)
        n = least[i] > n ? least[i] : n;
    p->cruise = (uint32_t)n;
    return n < MOST;
}

static uint32_t end_of(const loft_scurve_part *p)
{
    return p->start + p->cruise + p->ramp + p->ease;
}

/* A part from rest to rest, by `way`. */
static enum loft_status part_init(loft_scurve_part *p, uint32_t start, loft_acc way,
                                  const loft_scurve_limits *l)
{
    needs w;

    if (!loft_acc_valid(loft_acc_abs(way)) || !loft_raw_valid(loft_acc_round(loft_acc_abs(way))) ||
        !needed(&w, way, l))
        return LOFT_ERR_RANGE;
    p->way = way;
    p->start = start;
    p->ease = shortest(&w, 0);
    p->ramp = shortest(&w, p->ease);
    if (p->ramp < p->ease)
        p->ramp = p->ease;
    return cruise_of(p, &w) ? LOFT_OK : LOFT_ERR_RANGE;
}

static bool valid(const loft_scurve_limits *l)
{
    return loft_raw_valid(l->max_speed) && loft_raw_valid(l->max_accel) &&
           l->max_speed >= loft_real_from_raw(1) && l->max_accel >= LOFT_REAL(1) &&
           l->tick_hz >= 1 && l->tick_hz <= 50000;
}

enum loft_status loft_scurve_init(loft_scurve *s, loft_real from, loft_real to,
                                  const loft_scurve_limits *limits)
{
    loft_scurve_part first;

    if (!valid(limits))
        return LOFT_ERR_ARG;
    if (!loft_raw_valid(from) || !loft_raw_valid(to))
        return LOFT_ERR_RANGE;
    const enum loft_status status = part_init(&first, 0, loft_to_acc(to) - loft_to_acc(from),
                                              limits);
    if (status != LOFT_OK)
        return status;
    s->to = to;
    s->ticks = end_of(&first);
    s->limits = *limits;
    s->from = loft_to_acc(from);
    s->count = 1;
    s->part[0] = first;
    return LOFT_OK;
}

static uint64_t cube(uint32_t t, uint32_t from)
{
    const uint64_t d = t > from ? t - from : 0;
    return d * d * d;
}

/* How far the part has gone after t ticks, in its first half. */
static loft_acc half(const loft_scurve_part *p, uint32_t t)
{
    const uint64_t n = cube(t, 0) - cube(t, p->ramp) - cube(t, p->ease) +
                       cube(t, p->ramp + p->ease);
    return loft_acc_muldiv(p->way, (loft_acc)n,
                           (loft_acc)((uint64_t)6 * p->cruise * p->ramp * p->ease));
}

static loft_acc way_at(const loft_scurve_part *p, uint32_t tick)
{
    if (tick <= p->start)
        return 0;
    const uint32_t end = end_of(p), t = tick - p->start;
    if (tick >= end)
        return p->way;
    return t <= end - tick ? half(p, t) : p->way - half(p, end - tick);
}

loft_real loft_scurve_eval(const loft_scurve *s, uint32_t tick)
{
    loft_acc at = s->from;

    if (tick >= s->ticks)
        return s->to;
    for (int i = 0; i < s->count; i++)
        at += way_at(&s->part[i], tick);
    return loft_acc_round(at);
}

/* What has ended becomes part of the beginning; what has not begun is forgotten. */
static void forget(loft_scurve *s, uint32_t tick)
{
    while (s->count && end_of(&s->part[0]) <= tick) {
        s->from += s->part[0].way;
        s->count--;
        for (int i = 0; i < s->count; i++)
            s->part[i] = s->part[i + 1];
    }
    if (s->count && s->part[s->count - 1].start >= tick)
        s->count--;
}

/* End the step as soon as it may. */
static void cut(loft_scurve_part *p, uint32_t tick)
{
    const uint32_t least = p->ramp + p->ease, gone = tick - p->start;
    const uint32_t n = gone > least ? gone : least;

    if (n < p->cruise) {
        p->way = loft_acc_muldiv(p->way, (loft_acc)n, (loft_acc)p->cruise);
        p->cruise = n;
    }
}

/* Go on from where the step of `last` ends, if that is not over; `way` is of the same sign. */
static bool onward(loft_scurve_part *p, const loft_scurve_part *last, uint32_t tick, loft_acc way,
                   const loft_scurve_limits *l)
{
    needs w;

    *p = *last;
    p->way = way;
    p->start = last->start + last->cruise;
    return (way < 0) == (last->way < 0) && p->start >= tick && needed(&w, way, l) &&
           cruise_of(p, &w);
}

enum loft_status loft_scurve_retarget(loft_scurve *s, uint32_t tick, loft_real to)
{
    loft_scurve next = *s;
    loft_scurve_part after, ahead;
    uint32_t start = tick;

    if (to == s->to)
        return LOFT_OK;
    if (!loft_raw_valid(to))
        return LOFT_ERR_RANGE;
    forget(&next, tick);
    loft_scurve_part *const last = next.count ? &next.part[next.count - 1] : NULL;
    if (last) {
        cut(last, tick);
        start = end_of(last);
    }
    loft_acc way = loft_to_acc(to) - next.from;
    for (int i = 0; i < next.count; i++)
        way -= next.part[i].way;
    const enum loft_status status = part_init(&after, start, way, &s->limits);
    if (status != LOFT_OK)
        return status;
    if (last && onward(&ahead, last, tick, way, &s->limits) && end_of(&ahead) < end_of(&after))
        after = ahead;
    next.part[next.count++] = after;
    next.to = to;
    next.ticks = end_of(&after);
    *s = next;
    return LOFT_OK;
}
