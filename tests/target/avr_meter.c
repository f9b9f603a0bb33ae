/* tests/target/avr_meter.c
 * SPDX-License-Identifier: MIT
 */
#include "avr_meter.h"

#include <simavr/avr_ioport.h>

#define RET         0x9508
#define RETI        0x9518
/* cycles until the first instruction of an interrupt; simavr does not count them */
#define RESPONSE    4
/* a slot may begin this much earlier relative to the first one, which itself was late */
#define EARLY       8
#define VECTORS     26
#define SLOT_VECTOR 11              /* timer 1 compare A */
#define RX_VECTOR   18
/* registers as addresses of data */
#define DDRB        0x24
#define DDRC        0x27
#define PORTC       0x28
#define TCCR2A      0xB0
#define OCR2A       0xB3
#define RING        128             /* slots in the firmware's ring */
#define RING_FILLED 0x4B            /* GPIOR2 has their number: ports/atmega328p/slots.h */

static uint16_t stack(const avr_t *avr)
{
    return (uint16_t)(avr->data[R_SPL] | avr->data[R_SPH] << 8);
}

static void least(uint64_t *is, uint64_t x)
{
    if (x < *is)
        *is = x;
}
static void most(uint64_t *is, uint64_t x)
{
    if (x > *is)
        *is = x;
}


// Pins
// ----

void meter_flush(struct meter *m)
{
    if (m->step)
        host_record_slot(&m->record, m->when, (loft_pins){ .step = m->step, .dir = m->dir });
    m->step = 0;
}

/* Pins 2..4 step, 5..7 are directions; the pins of one write change one by one, in the same
 * cycle. */
static void pin_changed(struct avr_irq_t *irq, uint32_t value, void *param)
{
    struct meter *m = param;
    const unsigned axis = irq->irq < 5 ? irq->irq - 2 : irq->irq - 5;
    const uint64_t now = m->avr->cycle;

    if (irq->irq >= 5) {
        if (m->pulses[axis])
            least(&m->hold_least, now - m->last[axis]);
        m->turned[axis] = now;
    } else if (value) {
        if (m->step && m->when != now)
            meter_flush(m);
        m->when = now;
        m->step |= (uint8_t)(1u << axis);
        m->dir = (uint8_t)((m->dir & ~(1u << axis)) | (m->avr->data[0x2B] >> (5 + axis) & 1u)
                                                          << axis);
        if (m->turned[axis])
            least(&m->setup_least, now - m->turned[axis]);
        if (m->pulses[axis]++)
            least(&m->between_least, now - m->last[axis]);
        m->rose[axis] = m->last[axis] = now;
        /* as FNV-1a does */
        m->path[axis] = (m->path[axis] ^ (m->dir >> axis & 1u)) * 0x100000001b3u + 1;
        if (m->armed && m->begun) {
            m->starved += m->empty;
            least(&m->left_least, m->low);
        }
        m->empty = 0;
        m->low = RING;
        m->begun = true;
    } else {
        least(&m->pulse_least, now - m->rose[axis]);
        most(&m->pulse_most, now - m->rose[axis]);
    }
}

/* The outputs: D11 in 1/256, as the timer gives it, and A3. A pin that is no output is off. */
static void watch_outputs(struct meter *m)
{
    const uint8_t *data = m->avr->data;
    const uint16_t power = data[DDRB] & data[TCCR2A] >> 4 & 1 << 3 ? data[OCR2A] + 1u : 0;
    const uint8_t coolant = data[DDRC] & data[PORTC] & 1 << 3;

    if (power != m->power)
        host_record_output(&m->record, m->avr->cycle, 1, (uint16_t)(power ? power * 256u - 1 : 0));
    if (coolant != m->coolant)
        host_record_output(&m->record, m->avr->cycle, 2, coolant ? 65535 : 0);
    m->power   = power;
    m->coolant = coolant;
}

void meter_init(struct meter *m, avr_t *avr, uint32_t tick_pc)
{
    m->avr = avr;
    m->tick_pc = tick_pc;
    m->deepest = UINT16_MAX;
    m->low = RING;
    m->left_least = m->pulse_least = m->setup_least = m->hold_least = m->between_least = UINT64_MAX;
    for (int pin = 2; pin < 8; pin++)
        avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('D'), pin), pin_changed,
                                m);
    avr_servo_init(&m->servo, avr);
    avr->run_cycle_limit = 1;
}


// Contexts
// --------

static void enter(struct meter *m, uint8_t kind)
{
    m->depth++;
    m->nest[m->depth].kind = kind;
    m->nest[m->depth].sp = stack(m->avr);
    m->nest[m->depth].own = 0;
}

static void leave(struct meter *m)
{
    struct meter_context *c = &m->context[m->nest[m->depth].kind];
    const uint32_t own = m->nest[m->depth].own;

    c->calls++;
    c->cycles += own;
    if (own > c->most)
        c->most = own;
    m->depth--;
}

static void count_slot(struct meter *m)
{
    const uint64_t now = m->avr->cycle;

    if (!m->armed) {
        m->armed = true;
        m->slot_first = now;
        m->period = 1u + (m->avr->data[0x88] | (uint32_t)m->avr->data[0x89] << 8);
    }
    m->slot_last = now;
    const uint8_t left = m->avr->data[RING_FILLED];
    m->empty += left == 0;
    if (left < m->low)
        m->low = left;
    most(&m->slot_late,
         (now - m->slot_first + EARLY) % m->period > EARLY ? (now - m->slot_first) % m->period : 0);
}

uint64_t meter_missed(const struct meter *m)
{
    if (!m->armed)
        return 0;
    const uint64_t due = (m->slot_last - m->slot_first) / m->period + 1,
                   were = m->context[SLOT].calls + (m->depth > 0);
    return due > were ? due - were : 0;
}

void meter_run(struct meter *m)
{
    avr_t *avr = m->avr;
    const uint32_t pc = avr->pc;
    const uint64_t cycle = avr->cycle;
    const unsigned instruction = (unsigned)(avr->flash[pc] | avr->flash[pc + 1] << 8);

    avr_run(avr);
    uint32_t took = (uint32_t)(avr->cycle - cycle);
    m->nest[m->depth].own += took;
    if (m->profile)
        m->profile[pc / 2] += took;
    if (stack(avr) < m->deepest && instruction >> 9 != 0xBF >> 1) {
        /* not between the two `out` writes of its bytes */
        m->deepest = stack(avr);
        m->deepest_pc = pc;
    }
    watch_outputs(m);
    avr_servo_run(&m->servo, m->record.file);

    if (m->depth && (instruction == RETI || (instruction == RET && m->nest[m->depth].kind == TICK &&
                                             stack(avr) > m->nest[m->depth].sp)))
        leave(m);
    if (avr->pc == m->tick_pc && pc != avr->pc) {
        enter(m, TICK);
    } else if (avr->pc && avr->pc < VECTORS * 4 && avr->pc % 4 == 0 && pc >= VECTORS * 4) {
        const uint32_t vector = avr->pc / 4;
        avr->cycle += RESPONSE;
        enter(m, vector == SLOT_VECTOR ? SLOT : vector == RX_VECTOR ? RECEIVE : MAIN);
        m->nest[m->depth].own = RESPONSE;
        if (vector == SLOT_VECTOR)
            count_slot(m);
    }
}
