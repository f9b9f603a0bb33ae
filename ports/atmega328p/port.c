/* ports/atmega328p/port.c -- an ATmega328P at 16 MHz with the pins of the Arduino Uno CNC shield: three axes
 * SPDX-License-Identifier: MIT
 *
 *     step     D2 D3 D4 (PD2..4)         limits   D9 D10 D12 (PB1 PB2 PB4), closing to ground
 *     dir      D5 D6 D7 (PD5..7)         buttons  A0 abort, A1 hold, A2 resume (PC0..2), closing to ground
 *     enable   D8 (PB0), low             line     D0 D1 (USART0), 8N1
 *
 * The timer interrupt puts out the pins that it computed in the slot before, so the edges do not depend on how long
 * that takes; it computes the next ones and ends the pulses, which are as long as the computing. The tick follows in the same
 * interrupt, with interrupts enabled again, when there is room for it.
 */
#include <avr/interrupt.h>
#include <avr/io.h>

#include "machine/machine.h"    /* loft_machine */
#include "port.h"

#ifndef LOFT_BAUD
#  define LOFT_BAUD 115200          /* 115200 (that is 117647), 250000 or 1000000, exactly */
#endif
#ifndef LOFT_SLOTS
#  define LOFT_SLOTS 40             /* per tick of 1 ms: 40,000 steps per second and axis */
#endif
#ifndef LOFT_INVERT
#  define LOFT_INVERT 0             /* bits of PORTD to be inverted */
#endif
#define CELLS 10                    /* what RAM is left for */

/* The machine. steps/mm, mm/s, mm/s^2 */
#define AXIS { LOFT_RAW(250), LOFT_RAW(160), LOFT_RAW(500) }

static volatile loft_cell cells[CELLS];
static loft_machine machine;
static loft_machine_config config = {
    .traits = { .tick_hz = 1000, .slots = LOFT_SLOTS, .axis = { AXIS, AXIS, AXIS } },
    .ramp = 12, .cell = cells, .cells = CELLS
};


// Pins
// ----

#define STEPS   0x1C                /* of PORTD */
#define RX_PULL 0x01 
#define LIMITS  0x16                /* of PINB  */
#define BUTTONS 0x07                /* of PINC  */

static uint8_t next_pins = RX_PULL ^ LOFT_INVERT;
static volatile uint8_t in_tick;

inline void loft_port_pins(uint8_t step_bits, uint8_t dir_bits)
{
    next_pins = (uint8_t)((uint8_t)(step_bits << 2) | (uint8_t)(dir_bits << 5) | RX_PULL) ^ LOFT_INVERT;
}

inline void loft_port_slot(void)
{
    const loft_pins pins = loft_drive_pins(&machine.drive);
    loft_port_pins(pins.step, pins.dir);
}

/* Called by the stub below, which has saved the registers, with interrupts enabled. */
__attribute__((used)) void loft_port_tick(void);
void loft_port_tick(void)
{
    loft_machine_tick(&machine);
}

/* A function call inside an interrupt would make the compiler save all registers in every slot. */
__attribute__((used, naked)) void loft_port_tick_stub(void);
void loft_port_tick_stub(void)
{
    __asm__ volatile (
        "push r0\n push r1\n push r18\n push r19\n push r20\n push r21\n push r22\n push r23\n push r24\n push r25\n"
        "push r26\n push r27\n push r30\n push r31\n clr r1\n sei\n call loft_port_tick\n cli\n"
        "pop r31\n pop r30\n pop r27\n pop r26\n pop r25\n pop r24\n pop r23\n pop r22\n pop r21\n pop r20\n"
        "pop r19\n pop r18\n pop r1\n pop r0\n ret\n");
}

/* While the machine stands in a job, once per tick is enough to see whether it may go on. */
static inline bool tick_is_due(void)
{
    const loft_drive *d = &machine.drive;
    return d->active && loft_step_room(&d->step) && (d->step.busy || d->slot == 0);
}

ISR(TIMER1_COMPA_vect)
{
    PORTD = next_pins;
    loft_port_slot();
    PORTD = (uint8_t)((PORTD & ~STEPS) | (LOFT_INVERT & STEPS));
    if (tick_is_due() && !in_tick) {
        in_tick = 1;
        __asm__ volatile ("call loft_port_tick_stub" ::: "memory");
        in_tick = 0;
    }
}


// The line
// --------

#define RING 128u

static volatile uint8_t ring[RING], ring_head;
static uint8_t ring_tail;

/* A byte that finds the ring full is lost: the frame is then damaged, and sent again. */
ISR(USART_RX_vect)
{
    const uint8_t byte = UDR0, head = ring_head, after = (uint8_t)(head + 1u) % RING;

    if (after != ring_tail) {
        ring[head] = byte;
        ring_head = after;
    }
}

size_t loft_port_read(uint8_t *bytes, size_t max)
{
    const uint8_t head = ring_head;
    uint8_t tail = ring_tail;
    size_t count = 0;

    for (; tail != head && count < max; tail = (uint8_t)(tail + 1u) % RING)
        bytes[count++] = ring[tail];
    LOFT_BARRIER();
    ring_tail = tail;
    return count;
}

size_t loft_port_write(const uint8_t *bytes, size_t count)
{
    if (count == 0 || !(UCSR0A & 1 << UDRE0))
        return 0;
    UDR0 = *bytes;
    return 1;
}


// Start
// -----

/* A number of four bytes in EEPROM counts the starts. */
static uint32_t count_start(void)
{
    uint32_t boot = 0;

    for (uint8_t i = 0; i < 4; i++) {
        EEAR = i;
        EECR |= 1 << EERE;
        boot |= (uint32_t)EEDR << 8 * i;
    }
    boot++;
    for (uint8_t i = 0; i < 4; i++) {
        EEAR = i;
        EECR |= 1 << EERE;
        const uint8_t byte = (uint8_t)(boot >> 8 * i);
        if (EEDR == byte)
            continue;
        EEDR = byte;
        EECR |= 1 << EEMPE;
        EECR |= 1 << EEPE;
        while (EECR & 1 << EEPE) {}
    }
    return boot;
}

void loft_port_init(void)
{
    config.traits.boot = count_start();

    PORTD = next_pins;
    DDRD = 0xFC;
    PORTB = LIMITS;                             /* pulled up; the drivers are enabled */
    DDRB = 1 << 0;
    PORTC = BUTTONS;

    UCSR0A = 1 << U2X0;
    UCSR0C = 1 << UCSZ01 | 1 << UCSZ00;
    UBRR0 = (F_CPU / 4 / LOFT_BAUD - 1) / 2;
    UCSR0B = 1 << RXEN0 | 1 << TXEN0 | 1 << RXCIE0;

    TCCR0B = 1 << CS02 | 1 << CS00;             /* free running, 64 us: the clock of the switches */
}

void loft_port_start(uint32_t slot_hz)
{
    OCR1A = (uint16_t)(F_CPU / slot_hz - 1);
    TCCR1B = 1 << WGM12 | 1 << CS10;
    TIMSK1 = 1 << OCIE1A;
    sei();
}


// Switches
// --------

/* What counts is a switch that closes and stays so for four samples, 4 ms; standing on one hinders no job. */
static void watch_switches(void)
{
    static uint8_t sampled, last, steady, same;

    if ((uint8_t)(TCNT0 - sampled) < 16)
        return;
    sampled = TCNT0;
    const uint8_t now = (uint8_t)((~PINB & LIMITS) << 2 | (~PINC & BUTTONS));
    same = now == last ? (uint8_t)(same + (same < 4)) : 0;
    last = now;
    if (same < 3 || now == steady)
        return;

    const uint8_t closed = (uint8_t)(now & ~steady);
    steady = now;
    if (closed & (LIMITS << 2 | 1 << 0))
        loft_machine_control(&machine, LOFT_ABORT);
    else if (closed & 1 << 1)
        loft_machine_control(&machine, LOFT_HOLD);
    else if (closed & 1 << 2)
        loft_machine_control(&machine, LOFT_RESUME);
}

int main(void)
{
    static uint8_t wire[LOFT_FRAME_MAX];
    uint8_t byte[16];
    uint8_t count = 0, sent = 0;

    loft_port_init();
    if (loft_machine_init(&machine, &config) != LOFT_OK)
        return 1;
    loft_port_start((uint32_t)config.traits.tick_hz * config.traits.slots);
    for (;;) {
        loft_machine_push(&machine, byte, loft_port_read(byte, sizeof byte));
        if (sent == count) {
            sent = 0;
            count = (uint8_t)loft_machine_poll(&machine, wire);
        }
        sent = (uint8_t)(sent + loft_port_write(wire + sent, (size_t)(count - sent)));
        watch_switches();
    }
}
