/* ports/cortex-m/stream.c
 * SPDX-License-Identifier: MIT
 */
#include "cortex-m/stream.h"

#include "cortex-m/cortex.h"
#include "cortex-m/words.h"
#include "port.h"

#ifndef STREAM_SAMPLES
#  define STREAM_SAMPLES 100000u    /* per second, while a guard waits */
#endif

static uint32_t ring[STREAM_WORDS + STREAM_AHEAD];
static volatile uint8_t given, made = 2;    /* halves, modulo 256: the block's, the fill's */
static volatile bool waits;                 /* the timer stands: the next half is not made */

/* An input of a guard has changed: at this word of this half. */
static volatile bool changed;
static uint32_t changed_word;
static uint8_t changed_half;
static int32_t changed_ahead[LOFT_AXES];    /* steps of the words that waited then */
#if STREAM_LAG > 0
static uint32_t waiting[STREAM_LAG];        /* the last ones of the half before */
#endif

uint32_t *cortex_ring(void) { return ring; }


// Outputs
// -------

#if STREAM_OUTPUTS > 0

static uint16_t levels[STREAM_OUTPUTS], levels_at[2][STREAM_OUTPUTS];   /* of the halves */

void loft_port_output(int output, uint16_t level) { levels[output - 1] = level; }

/* The half of this number is made. */
static void keep_outputs(uint8_t half)
{
    for (int k = 0; k < STREAM_OUTPUTS; k++)
        levels_at[half & 1][k] = levels[k];
}

/* It begins; or the timer stands. */
static void give_outputs(uint8_t half, bool stands)
{
    for (int k = 0; k < STREAM_OUTPUTS; k++)
        cortex_output(k + 1, stands ? 0 : levels_at[half & 1][k]);
}

#else

static void keep_outputs(uint8_t half) { (void)half; }
static void give_outputs(uint8_t half, bool stands)
{
    (void)half;
    (void)stands;
}

#endif


// Slots
// -----

#ifdef CORTEX_SAMPLE_IRQ
static void set_samples(uint32_t hz)
{
    (void)hz;
    cortex_samples(STREAM_SAMPLES);
    cortex_enable(CORTEX_SAMPLE_IRQ, 0);
}
static void run_samples(bool run)       { cortex_samples(run ? STREAM_SAMPLES : 0); }
#else
static void set_samples(uint32_t hz)    { cortex_systick(hz / STREAM_SAMPLES); }
static void run_samples(bool run)       { cortex_systick_run(run); }
#endif

static void count_word(uint32_t word, int32_t steps[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++)
        if (word & 1u << STREAM_STEP(i))
            steps[i] += word & 1u << STREAM_DIR(i) ? -1 : 1;
}

/* The last words of a half, before it is made anew. */
static void keep_waiting(uint8_t half)
{
#if STREAM_LAG > 0
    for (uint32_t k = 0; k < STREAM_LAG; k++)
        waiting[k] = ring[(half & 1u) * STREAM_HALF + STREAM_HALF - STREAM_LAG + k];
#else
    (void)half;
#endif
}

void cortex_block(void)
{
    cortex_acknowledge();
    keep_waiting(given);
    given++;
    waits = given == made;
    cortex_run(!waits);
    give_outputs(given, waits);
    cortex_later();
}

/* The words that wait are the last ones before those that are not taken. The half before may be
 * made anew already, unless its interrupt waits. */
static void count_waiting(uint8_t half, uint32_t word, bool uncounted)
{
    for (int i = 0; i < LOFT_AXES; i++)
        changed_ahead[i] = 0;
#if STREAM_LAG > 0
    const uint32_t *const here = &ring[(half & 1u) * STREAM_HALF],
                          *const before = uncounted
                                              ? &ring[(~half & 1u) * STREAM_HALF + STREAM_HALF]
                                              : waiting + STREAM_LAG;

    for (uint32_t k = cortex_waiting(); k > 0; k--)
        count_word(k > word ? *(before - (k - word)) : here[word - k], changed_ahead);
#else
    (void)half;
    (void)word;
    (void)uncounted;
#endif
}

/* A half that has just been given may not be counted yet: its interrupt waits. */
void cortex_sample(void)
{
    if (changed || !loft_port_changed())
        return;
    uint32_t word;
    uint8_t half;

    do {
        half = given;
        word = cortex_given();
    } while (half != given);            /* an interrupt that gives slots comes in between */
    const bool uncounted = (word / STREAM_HALF ^ half) & 1u;

    changed_half = (uint8_t)(half + uncounted);
    changed_word = word % STREAM_HALF;
    count_waiting(changed_half, changed_word, uncounted);
    LOFT_BARRIER();
    changed = true;
}

/* The words from the change on are made and not given: they are in the ring, and their pulses are
 * counted. */
static void latch(void)
{
    const uint32_t left = (uint8_t)(made - changed_half) * STREAM_HALF + STREAM_AHEAD -
                          changed_word;
    uint32_t at = (changed_half & 1u) * STREAM_HALF + changed_word;

    for (uint32_t k = 0; k < left && k < STREAM_WORDS; k++) {
        count_word(ring[at], changed_ahead);
        at = at + 1 == STREAM_WORDS ? 0 : at + 1;
    }
    loft_port_latch(changed_ahead);
    LOFT_BARRIER();
    changed = false;
}

/* A half without a pulse after two others is already in the ring. */
static void make_half(uint32_t *word)
{
    static uint8_t rested, rests_at;        /* halves; the directions in them */
    bool rests = true;

    for (uint32_t left = STREAM_HALF; left > 0;) {
        uint8_t count = (uint8_t)(left < WORDS_MOST ? left : WORDS_MOST), dir;
        loft_step_tick *taken = loft_port_take(&count, &dir);
        rests = rests && !taken && dir == rests_at;
        if (!rests || rested < 2)
            give_words(taken, word, count, dir);
        rests_at = dir;
        word += count;
        left -= count;
        loft_port_tick();
    }
    rested = rests ? (uint8_t)(rested + (rested < 2)) : 0;
}

void cortex_fill(void)
{
    if (changed)
        latch();
    while ((uint8_t)(made - given) < 2) {
        const bool second = made & 1;
        make_half(&ring[(second ? STREAM_HALF : 0) + STREAM_AHEAD]);
        if (second && STREAM_AHEAD)
            ring[0] = ring[STREAM_WORDS];
        keep_outputs(made);
        LOFT_BARRIER();
        made++;
    }
    if (waits) {
        waits = false;
        LOFT_BARRIER();
        give_outputs(given, false);
        cortex_run(true);
    }
    run_samples(loft_port_waits());
}

void loft_port_start(uint32_t slot_hz)
{
    for (uint32_t k = 0; k < STREAM_WORDS; k++)
        ring[k] = stream_dir(0);
    cortex_enable(CORTEX_LINE_IRQ, 0);
    cortex_enable(CORTEX_STREAM_IRQ, 1);
    set_samples(cortex_stream(slot_hz));
    cortex_run(true);
    cortex_interrupts();
}
