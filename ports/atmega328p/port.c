/* ports/atmega328p/port.c -- an ATmega328P at 16 MHz with the pins of the Arduino Uno CNC shield:
 * three axes
 * SPDX-License-Identifier: MIT
 *
 *     step     D2 D3 D4 (PD2..4)         limits   D9 D10 D12 (PB1 PB2 PB4), closing to ground
 *     dir      D5 D6 D7 (PD5..7)         buttons  A0 abort, A1 hold, A2 resume (PC0..2), closing to
 *              ground
 *     enable   D8 (PB0), low             line     D0 D1 (USART0), 8N1
 *     probe    A5 (PC5), closing to ground    outputs  D11, D13, A3: outputs.h
 *
 * The timer interrupt takes the pins of a slot from a ring, so the edges do not depend on computing
 * time. When the ring runs low, the interrupt continues with interrupts enabled and makes the next
 * slots: those of a tick, just before they are due. Slots interrupt that and the tick. Pulses are
 * counted when they are made, at most 1.6 ms before they are given.
 */
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/pgmspace.h>

#define LOFT_RING_BYTES 128u
#include "outputs.h"
#include "port.h"
#include "ring.h"
#include "slots.h"
#include "switches.h"

#ifndef LOFT_BAUD
#  define LOFT_BAUD 115200          /* 115200 (that is 117647), 250000 or 1000000, exactly */
#endif
#ifndef LOFT_TICK_HZ
#  define LOFT_TICK_HZ 1000
#endif
#ifndef LOFT_SLOTS
#  define LOFT_SLOTS 80             /* per tick of 1 ms: 80,000 steps per second and axis */
#endif
#define ANSWER_MOST (47 + 4 * LOFT_AXES)    /* bytes of STATUS, the longest answer: WIRE.md */
#define CELLS (12 - (LOFT_MACHINE_OUTPUTS > 0) - LOFT_SERVO)   /* as many as fit in RAM */

/* The machine. steps/mm, mm/s, mm/s^2, mm/s^3 */
#define AXIS { LOFT_RAW(250), LOFT_RAW(320), LOFT_RAW(500), 10000 }

/* The EEPROM: four bytes count the starts, then come the settings. */
#define BOOT_AT     0
#define SETTINGS_AT 4
#define ROOM        508

static uint8_t eeprom_get(uint16_t at)
{
    EEAR = SETTINGS_AT + at;
    EECR |= 1 << EERE;
    return EEDR;
}

/* 3.3 ms. */
static void eeprom_put(uint16_t at, uint8_t byte)
{
    EEAR = SETTINGS_AT + at;
    EEDR = byte;
    const uint8_t status = SREG;
    cli();                                  /* the two must follow each other */
    EECR |= 1 << EEMPE;
    EECR |= 1 << EEPE;
    SREG = status;
    while (EECR & 1 << EEPE) {
    }
}

#define IN_FORCE(k) config.settings.wiring[k]
#define OBEYED                                                                                     \
    (1 << LOFT_WIRING_REVERSED | 1 << LOFT_WIRING_IDLE | 1 << LOFT_WIRING_OPENS |                  \
     LOFT_SERVO << LOFT_WIRING_SERVO)

static volatile loft_cell cells[CELLS];
static loft_machine machine;
static const loft_axis_config usual_axis[LOFT_AXES] PROGMEM = { AXIS, AXIS, AXIS };
static const uint8_t usual_wiring[LOFT_WIRING_BYTES] PROGMEM = { 0, 0, 2, 0, 0, 0, OBEYED };

static void usual_settings(loft_settings *s);

static loft_machine_config config = {
    .info = { .tick_hz = LOFT_TICK_HZ, .slots = LOFT_SLOTS, .outputs = LOFT_MACHINE_OUTPUTS },
    .ramp = 40,
    .cell = cells,
    .cells = CELLS,
    .senses = true,
    .settings = { .get = eeprom_get, .put = eeprom_put, .usual = usual_settings, .room = ROOM }
};

/* Those the chip starts with, too. */
__attribute__((cold)) static void usual_settings(loft_settings *s)
{
    memcpy_P(config.info.axis, usual_axis, sizeof usual_axis);
    memcpy_P(s->wiring, usual_wiring, sizeof usual_wiring);
}


// Pins
// ----

#define LIMITS  0x16                /* of PINB  */
#define BUTTONS 0x07                /* of PINC  */
#define PROBE   0x20

static uint8_t ring_head;                   /* where the next slot is put */

/* An input of a guard has changed before this slot of the ring; UNCHANGED: none has. */
#define UNCHANGED 255
static volatile uint8_t changed_at = UNCHANGED;
static volatile uint8_t sampled;            /* when the inputs were sampled for it, in 64 us */
#define MS 16u                              /* of these */

/* Inputs that are closed now, as they bounce. */
static uint16_t closed_inputs(void)
{
    const uint8_t limits = (uint8_t)~PINB, others = (uint8_t)~PINC;
    const uint16_t closed = loft_switches_of((limits >> 1 & 3u) | (limits >> 2 & 4u) |
                                             (others & BUTTONS) * 8u | (others & PROBE) * 2u);
    const uint16_t opens = (uint16_t)(IN_FORCE(LOFT_WIRING_OPENS) | IN_FORCE(LOFT_WIRING_OPENS + 1)
                                                                        << 8);

    return closed ^ opens;
}

/* The position at the pins is the one that is counted, without the pulses from `from` on, which are
 * still in the ring. Its variables stay off the stack of its caller. 20 cycles a slot. */
__attribute__((noinline, cold)) static void position_at(uint8_t from, int32_t at[LOFT_AXES])
{
    const uint8_t turn = (uint8_t)(LOFT_INVERT ^ IN_FORCE(LOFT_WIRING_REVERSED) << 5);
    const uint8_t head = ring_head;
    int8_t x = 0, y = 0, z = 0;

    for (uint8_t k = from; k != head; k = (uint8_t)(k + 1) % RING) {
        const uint8_t pins = ring[k] ^ turn;
        if (pins & 4)
            x = (int8_t)(pins & 32 ? x + 1 : x - 1);
        if (pins & 8)
            y = (int8_t)(pins & 64 ? y + 1 : y - 1);
        if (pins & 16)
            z = (int8_t)(pins & 128 ? z + 1 : z - 1);
    }
    loft_step_position(&machine.drive.step, at);
    at[0] += x;
    at[1] += y;
    at[2] += z;
}

__attribute__((noinline, cold)) static void keep_place(void)
{
    int32_t at[LOFT_AXES];

    position_at(changed_at, at);
    changed_at = UNCHANGED;
    loft_latch_keep(&machine.latch, at);
}

/* An input of a guard has changed: the first sample that counts. */
__attribute__((noinline)) static void sense_inputs(void)
{
    keep_place();
    loft_machine_sample(&machine, closed_inputs());
}

/* A hard stop: what is in the ring is not given. */
__attribute__((noinline, cold)) static void drop_ring(void)
{
    int32_t at[LOFT_AXES];

    cli();
    RING_FILLED = 0;
    const uint8_t from = RING_TAIL;
    sei();
    position_at(from, at);
    ring_head = from;
    loft_step_halt(&machine.drive.step, at);
}

/* Called with interrupts disabled. */
static inline void note_change(void)
{
    if (!loft_latch_waits(&machine.latch) || changed_at != UNCHANGED ||
        !loft_latch_wanted(&machine.latch, closed_inputs()))
        return;
    changed_at = RING_TAIL;
    sampled    = TCNT0;
}

ISR(PCINT0_vect) { note_change(); }
ISR(PCINT1_vect) { note_change(); }

/* Make a portion of slots, as far as there is room, up to the end of the ring or of a tick. Its
 * variables stay off the stack of the tick. A change of an input that came before the room was read
 * needs slots which would be overwritten. */
static __attribute__((noinline)) void make_slots(void)
{
    const uint8_t head = ring_head, room = (uint8_t)(RING - 1 - RING_FILLED),
                  end = (uint8_t)(RING - head);
    uint8_t count = room < end ? room : end, dir;

    if (changed_at != UNCHANGED)
        sense_inputs();
    if (count > PORTION)
        count = PORTION;
    if (count == 0)
        return;
    loft_step_tick *taken = loft_drive_take(&machine.drive, &count, &dir);
    give_slots(taken, (uint8_t *)&ring[head], count, dir ^ IN_FORCE(LOFT_WIRING_REVERSED));
    ring_head = (uint8_t)(head + count) % RING;
    LOFT_BARRIER();
    cli();
    RING_FILLED = (uint8_t)(RING_FILLED + count);
    sei();
}

/* Further samples for a guard, 1.0 to 1.6 ms apart. */
static void watch_guard(void)
{
    if (changed_at != UNCHANGED) {
        sense_inputs();
    } else if ((uint8_t)(TCNT0 - sampled) >= MS) {
        sampled = TCNT0;
        cli();
        note_change();                      /* one that is like that from the start */
        sei();
        loft_machine_sample(&machine, closed_inputs());
    }
    if (machine.drive.halt)
        drop_ring();
}

/* Work begins when this many slots are left. While the machine rests there is none. */
static uint8_t work_wanted(void) { return machine.drive.active ? LOW : 0; }

/* Called by the stub below, which has saved the registers, with interrupts enabled. Returns
 * work_wanted. While the machine is stopped in a job, one pass is enough to check whether it may
 * continue. */
__attribute__((used)) uint8_t loft_port_work(void);
uint8_t loft_port_work(void)
{
    do {
        watch_guard();
        if (loft_step_done(&machine.drive.step))
            loft_machine_tick(&machine);
        make_slots();
        follow_outputs(&machine.drive);
    } while (RING_FILLED < LOW && !loft_step_done(&machine.drive.step));
    return work_wanted();
}

/* The interrupt has saved the other registers. A function call in C would make the compiler save
 * all of them in every slot. */
__attribute__((used, naked)) void loft_port_work_stub(void);
void loft_port_work_stub(void)
{
    __asm__ volatile(
        "push r0\n push r1\n push r18\n push r19\n push r20\n push r21\n push r22\n push r23\n "
        "push r25\n push r26\n push r27\n clr r1\n out %[work], r1\n sei\n call loft_port_work\n "
        "cli\n out %[work], r24\n"
        "pop r27\n pop r26\n pop r25\n pop r23\n pop r22\n pop r21\n pop r20\n pop r19\n "
        "pop r18\n pop r1\n pop r0\n ret\n"
        :
        : [work] "I"(_SFR_IO_ADDR(RING_WORK)));
}

ISR(TIMER1_COMPA_vect, ISR_NAKED) { give_a_slot(); }


// The line
// --------

static loft_ring line;

ISR(USART_RX_vect) { loft_ring_put(&line, UDR0); }

size_t loft_port_write(const uint8_t *bytes, size_t count)
{
    if (count == 0 || !(UCSR0A & 1 << UDRE0))
        return 0;
    UDR0 = *bytes;
    return 1;
}


// Start
// -----

__attribute__((cold)) static uint32_t count_start(void)
{
    uint32_t boot = 0;

    for (uint8_t i = 4; i > 0; i--)
        boot = boot << 8 | eeprom_get((uint16_t)(BOOT_AT - SETTINGS_AT + i - 1));
    boot++;
    for (uint8_t i = 0; i < 4; i++) {
        const uint16_t at = (uint16_t)(BOOT_AT - SETTINGS_AT + i);
        const uint8_t byte = (uint8_t)(boot >> 8 * i);
        if (eeprom_get(at) != byte)
            eeprom_put(at, byte);
    }
    return boot;
}

__attribute__((cold)) loft_machine_config *loft_port_init(void)
{
    config.info.boot = count_start();
    usual_settings(&config.settings);

    PORTD = RX_PULL ^ LOFT_INVERT;
    DDRD = 0xFC;
    PORTB = LIMITS;                             /* pulled up; the drivers are enabled */
    DDRB = 1 << 0;
    PORTC = BUTTONS | PROBE;

    UCSR0A = 1 << U2X0;
    UCSR0C = 1 << UCSZ01 | 1 << UCSZ00;
    UBRR0 = (F_CPU / 4 / LOFT_BAUD - 1) / 2;
    UCSR0B = 1 << RXEN0 | 1 << TXEN0 | 1 << RXCIE0;

    begin_outputs();

    PCMSK0 = LIMITS;
    PCMSK1 = BUTTONS | PROBE;
    PCICR = 1 << PCIE1 | 1 << PCIE0;

    TCCR0B = 1 << CS02 | 1 << CS00;             /* free running, 64 us: the clock of the switches */
    return &config;
}

void loft_port_start(uint32_t slot_hz)
{
    OCR1A = (uint16_t)(F_CPU / slot_hz - 1);
    TCCR1B = 1 << WGM12 | 1 << CS10;
    TIMSK1 = 1 << OCIE1A;
    sei();
}


// Motors at rest
// --------------

/* Switch the drivers off after as long as the settings say. `now`, in 64 us, begins again each
 * 16 ms. */
__attribute__((cold)) static void watch_motors(uint8_t now)
{
    static uint16_t rested;

    if (machine.drive.active)
        rested = 0;
    else if (now < 16 && IN_FORCE(LOFT_WIRING_IDLE) && ++rested == 61u * IN_FORCE(LOFT_WIRING_IDLE))
        PORTB |= 1 << 0;
}


// Switches
// --------

/* Every 1.0 ms. */
__attribute__((cold)) static void watch_switches(void)
{
    static loft_switches switches;
    static uint8_t watched;

    if ((uint8_t)(TCNT0 - watched) < 16)
        return;
    watched = TCNT0;
    watch_motors(watched);
    watch_servo(&machine.drive, IN_FORCE(LOFT_WIRING_SERVO),
                IN_FORCE(LOFT_WIRING_REVERSED) & 1 << 2);
    const uint16_t closed = closed_inputs();

    if (!machine.drive.active) {
        changed_at = UNCHANGED;
        loft_machine_sample(&machine, closed);
    }
    if (loft_switches_steady(&switches, closed))
        loft_machine_inputs(&machine, closed);
}

__attribute__((cold)) int main(void)
{
    static uint8_t wire[ANSWER_MOST];
    uint8_t byte[4];
    uint8_t count = 0, sent = 0;

    if (loft_machine_init(&machine, loft_port_init()) != LOFT_OK)
        return 1;
    loft_port_start((uint32_t)config.info.tick_hz * config.info.slots);
    for (;;) {
        loft_machine_push(&machine, byte, loft_ring_take(&line, byte, sizeof byte));
        RING_WORK = work_wanted();
        if (!machine.drive.active)
            end_outputs();
        else if (PORTB & 1 << 0)
            PORTB &= (uint8_t)~(1 << 0);
        if (sent == count) {
            sent = 0;
            count = (uint8_t)loft_machine_poll(&machine, wire);
        }
        sent = (uint8_t)(sent + loft_port_write(wire + sent, (size_t)(count - sent)));
        watch_switches();
    }
}
