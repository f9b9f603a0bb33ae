/* ports/nrf51/port.c -- an nRF51822 at 16 MHz as on the BBC micro:bit: three axes, 20,000 steps per
 * second each
 * SPDX-License-Identifier: MIT
 *
 *     step     P0.03 P0.02 P0.01 (edge 0 1 2)     stop     P0.11 (edge 9), closing to ground
 *     dir      P0.18 P0.20 P0.16 (edge 8 12 16)   buttons  P0.17 hold (A), P0.26 resume (B)
 *     line     P0.24 P0.25, through the board's USB, 8N1
 *
 * Registers: Nordic's nRF51 series reference manual. The core has no SysTick: TIMER0 gives the
 * slots.
 */
#include "cortex-m/cortex.h"
#include "port.h"
#include "switches.h"

#ifndef LOFT_BAUD
#  define LOFT_BAUD 115200          /* or 250000, 1000000 */
#endif
#define CORE    16000000u           /* Hz */
#define PULSE   (CORE / 500000)     /* 2 us */

#define CLOCK   0x40000000
#define UART    0x40002000
#define TIMER   0x40008000
#define RANDOM  0x4000D000
#define GPIO    0x50000000
#define OUTSET  (GPIO + 0x508)
#define OUTCLR  (GPIO + 0x50C)
#define IN      (GPIO + 0x510)
#define PIN_CNF (GPIO + 0x700)

#define CELLS   160

/* steps/mm, mm/s, mm/s^2, mm/s^3 */
#define AXIS { LOFT_RAW(250), LOFT_RAW(80), LOFT_RAW(500), 10000 }

static volatile loft_cell cells[CELLS];
static loft_machine_config config = {
    .info = { .tick_hz = 1000, .slots = 20, .axis = { AXIS, AXIS, AXIS } },
    .ramp = 80,
    .cell = cells,
    .cells = CELLS
};

static const uint8_t step_pin[3] = { 3, 2, 1 }, dir_pin[3] = { 18, 20, 16 },
                     in_pin[3] = { 11, 17, 26 };

/* Wait for an event, but not forever. */
static bool came(uint32_t address)
{
    for (uint32_t left = 20000; left; left--)
        if (REG(address))
            return true;
    return false;
}

static uint32_t random_number(void)
{
    uint32_t number = 0;

    REG(RANDOM + 0x000) = 1;
    for (int i = 0; i < 4; i++) {
        REG(RANDOM + 0x100) = 0;
        if (!came(RANDOM + 0x100))
            break;
        number = number << 8 | (REG(RANDOM + 0x508) & 0xFF);
    }
    REG(RANDOM + 0x004) = 1;
    return number;
}

loft_machine_config *loft_port_init(void)
{
    REG(CLOCK + 0x000) = 1;                         /* the crystal */
    (void)came(CLOCK + 0x100);
    config.info.boot = random_number() ^ cortex_starts();

    for (int i = 0; i < 3; i++) {
        REG(GPIO + 0x518) = 1u << step_pin[i] | 1u << dir_pin[i];
        REG(PIN_CNF + 4u * in_pin[i]) = 3u << 2;    /* in, pulled up */
    }
    REG(UART + 0x50C) = 24;
    REG(UART + 0x514) = 25;
    REG(UART + 0x524) = (uint32_t)(((uint64_t)LOFT_BAUD << 32) / CORE + 0x800) & 0xFFFFF000;
    REG(UART + 0x500) = 4;
    REG(UART + 0x304) = 1 << 2;                     /* RXDRDY interrupts */
    REG(UART + 0x000) = 1;
    REG(UART + 0x008) = 1;
    REG(UART + 0x11C) = 0;
    return &config;
}

void loft_port_start(uint32_t slot_hz)
{
    REG(TIMER + 0x510) = 0;
    REG(TIMER + 0x508) = 0;                         /* 16 bits */
    REG(TIMER + 0x540) = CORE / slot_hz;
    REG(TIMER + 0x200) = 1;                         /* begin again at CC[0] */
    REG(TIMER + 0x304) = 1 << 16;
    cortex_enable(CORTEX_SLOT_IRQ, 1);
    cortex_enable(CORTEX_LINE_IRQ, 0);
    REG(TIMER + 0x000) = 1;
    cortex_interrupts();
}

void cortex_slot(void)
{
    REG(TIMER + 0x140) = 0;
    loft_port_slot();
    cortex_later();
}

static uint32_t spread(uint8_t bits, const uint8_t pin[3])
{
    return (uint32_t)(bits & 1) << pin[0] | (uint32_t)(bits >> 1 & 1) << pin[1] |
           (uint32_t)(bits >> 2 & 1) << pin[2];
}

void loft_port_pins(uint8_t step_bits, uint8_t dir_bits)
{
    static uint8_t dir_last;

    if (dir_bits != dir_last) {
        REG(OUTSET) = spread(dir_bits, dir_pin);
        REG(OUTCLR) = spread((uint8_t)(~dir_bits & 7), dir_pin);
        dir_last = dir_bits;
    }
    if (step_bits) {
        const uint32_t pins = spread(step_bits, step_pin);
        REG(OUTSET) = pins;
        cortex_delay(PULSE);
        REG(OUTCLR) = pins;
    }
}

/* The event is cleared before the byte is read. RXD then shows the next of six bytes, and the event
 * occurs again for it. */
void cortex_line(void)
{
    REG(UART + 0x108) = 0;
    loft_port_byte((uint8_t)REG(UART + 0x518));
}

/* TXDRDY is set when the last byte is sent. Before the first byte there is none. */
size_t loft_port_write(const uint8_t *bytes, size_t count)
{
    static bool busy;

    if (count == 0 || (busy && !REG(UART + 0x11C)))
        return 0;
    REG(UART + 0x11C) = 0;
    REG(UART + 0x51C) = *bytes;
    busy = true;
    return 1;
}

uint16_t loft_port_inputs(void)
{
    const uint32_t closed = ~REG(IN);

    return loft_switches_of((closed >> in_pin[0] & 1) << 3 | (closed >> in_pin[1] & 1) << 4 |
                            (closed >> in_pin[2] & 1) << 5);
}
