/* ports/nrf51/port.c -- an nRF51822 at 16 MHz as on the BBC micro:bit: three axes, LOFT_SLOTS steps
 * per millisecond each
 * SPDX-License-Identifier: MIT
 *
 *     step     P0.03 P0.02 P0.01 (edge 0 1 2)     stop     P0.11 (edge 9), closing to ground
 *     dir      P0.18 P0.20 P0.16 (edge 8 12 16)   buttons  P0.17 hold (A), P0.26 resume (B)
 *     line     P0.24 P0.25, through the board's USB, 8N1
 *
 * Registers: Nordic's nRF51 series reference manual. Its DMA does not reach the pins, and the core
 * has no SysTick: TIMER0 gives the slots, TIMER1 samples the inputs of a guard.
 */
#include "cortex-m/cortex.h"
#include "cortex-m/stream.h"
#include "port.h"
#include "switches.h"

#ifndef LOFT_BAUD
#  define LOFT_BAUD 115200          /* or 250000, 1000000 */
#endif
#define CORE    16000000u           /* Hz */

#define CLOCK   0x40000000
#define UART    0x40002000
#define TIMER   0x40008000
#define SAMPLER 0x40009000
#define RANDOM  0x4000D000
#define GPIO    0x50000000
#define OUT     (GPIO + 0x504)
#define IN      (GPIO + 0x510)
#define PIN_CNF (GPIO + 0x700)

#define GIVER_HZ        CORE
#define GIVER_SET(word) (REG(OUT) = (word) << 1)
#define GIVER_END(word) (REG(OUT) = ((word) & ~STREAM_STEPS) << 1)
#define GIVER_EVENT()   (REG(TIMER + 0x140) = 0)
#define GIVER_TIME()    (REG(TIMER + 0x044) = 1, REG(TIMER + 0x544))    /* capture it in CC[1] */
#include "cortex-m/giver.h"

#define CELLS   160

/* steps/mm, mm/s, mm/s^2, mm/s^3 */
#define AXIS { LOFT_RAW(250), LOFT_RAW(80), LOFT_RAW(500), 10000 }

static volatile loft_cell cells[CELLS];
static loft_machine_config config = {
    .info = { .tick_hz = 1000, .slots = LOFT_SLOTS, .axis = { AXIS, AXIS, AXIS } },
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

/* Let a timer interrupt `hz` times a second, from now on. */
static void set_timer(uint32_t timer, uint32_t hz)
{
    REG(timer + 0x510) = 0;                         /* 16 MHz */
    REG(timer + 0x508) = 0;                         /* 16 bits */
    REG(timer + 0x540) = CORE / hz;
    REG(timer + 0x200) = 1;                         /* begin again at CC[0] */
    REG(timer + 0x304) = 1 << 16;
}

uint32_t cortex_stream(uint32_t slot_hz)
{
    set_timer(TIMER, slot_hz);
    giver_begin();
    return CORE;
}

/* START, or STOP. */
void cortex_run(bool run) { REG(TIMER + (run ? 0x000 : 0x004)) = 1; }

void cortex_sampler(void)
{
    REG(SAMPLER + 0x140) = 0;
    cortex_sample();
}

void cortex_samples(uint32_t hz)
{
    if (hz)
        set_timer(SAMPLER, hz);
    REG(SAMPLER + (hz ? 0x000 : 0x004)) = 1;
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
