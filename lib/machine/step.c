/* lib/machine/step.c
 * SPDX-License-Identifier: MIT
 */
#include "machine/step.h"

#include "machine/queue.h"      /* LOFT_BARRIER */

/* Bresenham's line, per axis. After slot j = 0..n of a tick with c <= n steps in n slots
 *
 *     pulses = floor((j c + h) / n),    h = floor(n / 2)
 *
 * This is j c / n rounded to nearest: n * pulses lies in j c + h - n + 1 .. j c + h. So pulses - j
 * c / n lies within -(n - 1 - h) / n .. h / n, and both ends are at most 1/2 in absolute value.
 * After slot n it is c + floor(h / n) = c. Each slot does
 *
 *     phase += rate;   if (it has wrapped) { phase -= wrap; pulse }
 *
 * with W = UINT_MAX + 1, in one of two ways.
 *
 * Long ticks: phase is the remainder (j c + h) mod n, minus n, modulo W; rate = c; wrap = n. The
 * remainder is below n, and c <= n <= 32767, so a sum wraps at most once.
 *
 * Short ones: nothing is taken off, so a pulse is the carry of an addition and no more.
 * The true phase j c + h, times W / n, would pass a multiple of W at each pulse. It is rounded
 * down: with F = floor((2^32 - 1) / n) and share(m) = floor(m F W / 2^32),
 *
 *     rate = share(c)             lacks e of W c / n
 *     phase = share(h + 1)        is d above W h / n, at the beginning
 *
 * With r the remainder of slot j, 0 <= r < n, the phase is right as long as it stays within the
 * same multiple of W as the true one: 0 <= d - j e + r W / n < W. The right side holds for r = n -
 * 1, as d < W / n and e >= 0. The left one holds for j = n, r = 0 if n e <= d:
 *
 *     W = 2^32   e <= c <= n,  d >= W / n - (h + 1):   n^2 + h + 1 <= W / n, so n <= 1625
 *     W = 2^16   e <= 1,       d >= W / n - 1:         n + 1 <= W / n,       so n <= 255
 *
 * where W = 2^16: m F / 2^16 lies below W m / n by at most m / 2^16 < 1 / n, so rounding it down
 * differs from rounding W m / n down where that is an integer alone, and then by 1.
 *
 * Direction: the direction bits of a tick are set in its first slot. An axis that reverses must not
 * pulse in that slot, which it would do if h + c >= n. Then the tick gets one more slot in front
 * for the direction alone (`lead`). It is for all axes, so that they stay together on the line.
 */
#if UINT_MAX == 65535u
#  define SHARE_OF(share, count) ((unsigned)((share) * (count) >> 16))
#  define WHOLE 65536u        /* the share of which SHARE_OF is the count itself */
typedef uint32_t wide_phase;
#else
#  define SHARE_OF(share, count) ((unsigned)((share) * (count)))
#  define WHOLE 1u
typedef uint64_t wide_phase;
#endif
#if defined(__AVR__)
#  define APART __attribute__((noinline))   /* less stack under an interrupt */
#else
#  define APART
#endif
#if defined(__thumb__) && defined(__GNUC__) && !defined(__clang__)
#  define EACH_APART _Pragma("GCC unroll 8")    /* a tick in 174 instructions, not 201 (M4) */
#else
#  define EACH_APART
#endif
#define PHASE_BITS (4 * sizeof(wide_phase))

/* The running tick becomes one without slots that ends there. */
static APART void stand_at(loft_step *s, const int32_t position[LOFT_AXES])
{
    loft_step_tick *t = &s->tick[s->which];

    for (int i = 0; i < LOFT_AXES; i++) {
        t->axis[i].to = position[i];
        t->axis[i].count = 0;
        t->axis[i].rate = 0;
    }
    t->slots = t->left = 0;
    t->first = 0;
}

enum loft_status loft_step_place(loft_step *s, const int32_t position[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++)
        if (position[i] < -LOFT_STEP_REACH || position[i] > LOFT_STEP_REACH)
            return LOFT_ERR_RANGE;
    stand_at(s, position);
    return LOFT_OK;
}

void loft_step_halt(loft_step *s, const int32_t position[LOFT_AXES])
{
    stand_at(s, position);
    s->changes++;
    s->full = s->busy = 0;
}

enum loft_status loft_step_init(loft_step *s, const int32_t position[LOFT_AXES])
{
    s->which = 0;
    if (loft_step_place(s, position) != LOFT_OK)
        return LOFT_ERR_RANGE;
    s->busy = 0;
    s->tick[0].dir = 0;
    s->changes = 0;
    s->full = 0;
    return LOFT_OK;
}

#define ALL_AXES (1u << LOFT_AXES)

/* The slots of a tick. The range of loft_step_load is that of an int of 16 bits, so the lowest 16
 * bits of a difference are enough. */
static uint16_t slots_needed(const loft_step_tick *last, const int32_t target[LOFT_AXES],
                             uint16_t slots)
{
    const loft_step_axis *begin = last->axis;
    unsigned need = slots;

    EACH_APART
    for (uint_fast8_t i = 0; i < LOFT_AXES; i++, begin++, target++) {
        const int way = (int)((unsigned)*target - (unsigned)begin->to);
        const unsigned count = way < 0 ? 0u - (unsigned)way : (unsigned)way;
        if (count > need)
            need = count;
    }
    return (uint16_t)need;
}

/* The share of a step and the first phase change with the number of slots. */
static void set_slots(loft_step *s, loft_step_tick *t)
{
    const unsigned half = t->slots / 2u;

    t->first = half - t->slots;
    s->share = WHOLE;
    if (loft_step_short(t)) {
        s->share = UINT32_MAX / t->slots;
        t->first = SHARE_OF(s->share, half + 1u);
    }
}

static void set_axes(loft_step_tick *t, const loft_step_tick *last, const int32_t target[LOFT_AXES],
                     uint32_t share)
{
    const unsigned slots = t->slots, first = t->first, rest = slots - slots / 2u;
    const loft_step_axis *begin = last->axis;
    loft_step_axis *axis = t->axis;
    uint_fast8_t dir = last->dir;
    unsigned lasts = slots;

    EACH_APART
    for (uint_fast8_t bit = 1; bit != ALL_AXES; bit = (uint_fast8_t)(bit << 1), axis++, begin++) {
        const int32_t to = *target++;
        const int way = (int)((unsigned)to - (unsigned)begin->to);
        unsigned count = (unsigned)way;
        uint_fast8_t turned = dir & bit;        /* if it goes up */

        if (way < 0) {
            count = 0u - count;
            turned ^= bit;
        }
        axis->phase = first;
        axis->rate = SHARE_OF(share, count);
        axis->count = (uint16_t)count;
        axis->to = to;
        if (turned && count) {
            dir ^= bit;
            if (count >= rest)
                lasts = slots + 1u;
        }
    }
    t->dir = (uint8_t)dir;
    t->left = (uint16_t)lasts;
}

uint16_t loft_step_load(loft_step *s, const int32_t target[LOFT_AXES], uint16_t slots)
{
    const bool second = s->which;
    loft_step_tick *t = second ? &s->tick[0] : &s->tick[1];         /* ignored until `full` */
    const loft_step_tick *last = second ? &s->tick[1] : &s->tick[0];        /* t begins there */

    t->slots = slots_needed(last, target, slots);
    t->first = last->first;
    if (t->slots != last->slots)
        set_slots(s, t);
    set_axes(t, last, target, s->share);
    LOFT_BARRIER();
    s->full = 1;
    return t->left;
}

static uint16_t wrap_of(const loft_step_tick *t) { return loft_step_short(t) ? 0 : t->slots; }

/* The tick that runs, begun if it must be. NULL: there is none, or this slot is for its direction
 * alone. */
static loft_step_tick *running_tick(loft_step *s)
{
    if (!s->busy) {
        if (!s->full)
            return NULL;
        s->which ^= 1;
        s->busy = 1;
        s->changes++;
        LOFT_BARRIER();
        s->full = 0;
    }
    loft_step_tick *t = &s->tick[s->which];
    if (t->left <= t->slots)
        return t;
    t->left = t->slots;
    return NULL;
}

static void use_slots(loft_step *s, loft_step_tick *t, uint8_t count)
{
    const uint16_t left = (uint16_t)(t->left - count);

    t->left = left;
    s->changes++;
    if (left == 0) {
        LOFT_BARRIER();
        s->busy = 0;
    }
}

loft_pins loft_step_next(loft_step *s)
{
    loft_step_tick *t = running_tick(s);
    loft_pins pins = { 0, s->tick[s->which].dir };

    if (!t)
        return pins;
    const unsigned wrap = wrap_of(t);
    loft_step_axis *axis = t->axis;
    for (uint8_t bit = 1; bit != ALL_AXES; bit = (uint8_t)(bit << 1), axis++) {
        const unsigned rate = axis->rate, phase = axis->phase + rate;
        axis->phase = phase;
        if (phase >= rate)
            continue;
        axis->phase = phase - wrap;
        pins.step |= bit;
    }
    use_slots(s, t, 1);
    return pins;
}

loft_step_tick *loft_step_take(loft_step *s, uint8_t *count, uint8_t *dir)
{
    loft_step_tick *t = running_tick(s);

    *dir = s->tick[s->which].dir;
    if (!t) {
        if (s->busy)                                /* the slot for the direction */
            *count = 1;
        return NULL;
    }
    if (*count > t->left)
        *count = (uint8_t)t->left;
    use_slots(s, t, *count);
    return t;
}

/* Run one axis for `count` slots, all in registers. The bits go to `step`. */
static void run_axis(loft_step_axis *axis, unsigned wrap, uint8_t bit, uint8_t step[],
                     uint8_t count)
{
    const unsigned rate = axis->rate;
    unsigned phase = axis->phase;

    for (; count; count--, step++) {
        phase += rate;
        if (phase < rate) {
            phase -= wrap;
            *step |= bit;
        }
    }
    axis->phase = phase;
}

void loft_step_give(loft_step_tick *taken, uint8_t step[], uint8_t count)
{
    loft_step_axis *axis = taken->axis;

    for (uint8_t k = 0; k < count; k++)
        step[k] = 0;
    for (uint8_t bit = 1; bit != ALL_AXES; bit = (uint8_t)(bit << 1), axis++)
        if (axis->rate)
            run_axis(axis, wrap_of(taken), bit, step, count);
}

/* The pulses so far are the wraps of the phase or, in a long tick, those of Bresenham's line, where
 * j c + h < 2^30. */
static APART int32_t position_in(const loft_step_tick *t, const loft_step_axis *axis, bool back)
{
    const unsigned wrap = wrap_of(t), first = t->first + wrap;
    const wide_phase sum = (wide_phase)(uint16_t)(t->slots - t->left) * axis->rate + first;
    const int ahead = (int)(axis->count -
                            (unsigned)(wrap ? (uint32_t)sum / wrap : sum >> PHASE_BITS));

    return axis->to + (back ? ahead : -ahead);
}

/* A tick that was begun counts at its next slot at the latest: until then its position is that of
 * the end of the tick before. */
void loft_step_position(const loft_step *s, int32_t position[LOFT_AXES])
{
    uint8_t changes;

    do {
        changes = s->changes;
        LOFT_BARRIER();
        const loft_step_tick *t = &s->tick[s->which];
        uint8_t dir = t->dir;
        for (uint8_t i = 0; i < LOFT_AXES; i++, dir = (uint8_t)(dir >> 1))
            position[i] = position_in(t, &t->axis[i], dir & 1u);
        LOFT_BARRIER();
    } while (changes != s->changes);
}
