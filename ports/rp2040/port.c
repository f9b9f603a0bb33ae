/* ports/rp2040/port.c -- an RP2040 at 125 MHz, as on the Raspberry Pi Pico, or an RP2350 at 150
 * MHz, as on the Pico 2: three axes, LOFT_SLOTS steps per millisecond each
 * SPDX-License-Identifier: MIT
 *
 *     step     GP0 GP1 GP2       limits   GP6 GP7 GP8, closing to ground
 *     dir      GP3 GP4 GP5       buttons  GP9 abort, GP10 hold, GP11 resume, closing to ground
 *     enable   GP14, low         probe    GP15, closing to ground
 *                                line     GP12 GP13 (UART0), 8N1
 *
 * A state machine of PIO0 gives a word in each slot. Channel 0 of the DMA feeds it from the ring.
 * At the end of each half its interrupt starts the next one, while four words wait in the FIFO. If
 * a half is not made, the state machine waits with all steps low.
 *
 * Registers: RP2040 datasheet, RP2350 datasheet.
 */
#include "cortex-m/cortex.h"
#include "cortex-m/stream.h"
#include "port.h"
#include "rp2040/registers.h"
#include "switches.h"

#ifndef LOFT_BAUD
#  define LOFT_BAUD 115200
#endif
#define LEFT    REG(DMA + 0x08)     /* TRANS_COUNT */

#define FIRST_INPUT 6
#define SENDS   12
#define ENABLE  14
#define PROBE   15
#define CELLS   1024
#include "plans.h"

/* steps/mm, mm/s, mm/s^2, mm/s^3 */
#define AXIS { LOFT_RAW(250), LOFT_RAW(400), LOFT_RAW(2000), 40000 }

static volatile loft_cell cells[CELLS];
static loft_machine_config config = {
    .info = { .tick_hz = 1000, .slots = LOFT_SLOTS, .axis = { AXIS, AXIS, AXIS } },
    .ramp = 200,
    .cell = cells,
    .cells = CELLS
};

/* Wait for all `bits` of a register, but not forever. */
static bool came(uint32_t address, uint32_t bits)
{
    for (uint32_t left = 100000; left; left--)
        if ((REG(address) & bits) == bits)
            return true;
    return false;
}

/* Without a crystal the ring oscillator stays the clock, and the line is mute. */
static void set_clock(void)
{
    REG(XOSC + 0x0C) = 47;                              /* STARTUP: 1 ms */
    REG(XOSC + 0x00) = 0xFAB000 | 0xAA0;                /* CTRL: on, 1..15 MHz */
    if (!came(XOSC + 0x04, 1u << 31))
        return;
    REG(CLOCKS + 0x30) = 2;                             /* CLK_REF: the crystal */
    (void)came(CLOCKS + 0x38, 1u << 2);
    REG(PLL + 0x00) = 1;                                /* CS: no division before */
    REG(PLL + 0x08) = 125;
    REG(PLL + 0x04) = 1u << 3 | 1u << 2;                /* PWR: on, without its divider */
    if (!came(PLL + 0x00, 1u << 31))
        return;
    REG(PLL + 0x0C) = PLL_AFTER << 16 | 2u << 12;
    REG(PLL + 0x04) = 1u << 2;
    REG(CLOCKS + 0x3C) = 0;
    REG(CLOCKS + 0x3C) = 1;                             /* CLK_SYS: the PLL */
    (void)came(CLOCKS + 0x44, 1u << 1);
    REG(CLOCKS + 0x48) = 1u << 11;                      /* CLK_PERI: on, that of the core */
}

/* DMA, pins, pads, PIO0, UART0, and the PLL, which stays as it is if it runs. */
static void begin_parts(void)
{
    REG(RESETS + 0x00) &= ~PARTS;
    (void)came(RESETS + 0x08, PARTS);
}

static uint32_t random_number(void)
{
    uint32_t number = 0;

    for (int i = 0; i < 32; i++)
        number = number << 1 | (REG(RANDOM) & 1u);
    return number;
}

/* Give a pin to a part: 2 UART, 5 SIO, 6 PIO0. The pad is 4 mA, can be read, is pulled up or not,
 * and, on an RP2350, no more apart from its part. */
static void give_pin(uint32_t pin, uint32_t part, uint32_t pull)
{
    REG(PINS + 8 * pin + 4) = part;
    REG(PADS + 4 + 4 * pin) = 1u << 6 | 1u << 4 | pull << 3 | 1u << 1;
}

loft_machine_config *loft_port_init(void)
{
    begin_parts();
    config.info.boot = random_number() ^ cortex_starts();
    set_clock();
    for (uint32_t pin = FIRST_INPUT; pin < FIRST_INPUT + 6; pin++)
        give_pin(pin, 5, 1);
    give_pin(PROBE, 5, 1);
    REG(SIO_DRIVES) = 1u << ENABLE;                     /* an output, low */
    give_pin(ENABLE, 5, 0);
    give_pin(SENDS, 2, 0);
    give_pin(SENDS + 1, 2, 1);
    const uint32_t divider = (4 * CORE + LOFT_BAUD / 2) / LOFT_BAUD;        /* in 1/64 */
    REG(UART + 0x24) = divider / 64;
    REG(UART + 0x28) = divider % 64;
    REG(UART + 0x2C) = 3u << 5;                         /* LCR_H: 8 bits, no FIFO */
    REG(UART + 0x30) = 1u << 9 | 1u << 8 | 1u << 0;     /* CR */
    REG(UART + 0x38) = 1u << 4;                         /* IMSC: a byte came */
    loft_port_plans(&config);
    return &config;
}


// The line
// --------

void cortex_line(void)
{
    REG(UART + 0x38) = 1u << 4;
    REG(UART + 0x44) = 1u << 5;                         /* it can send: enough for waking up */
    if (!(REG(UART + 0x18) & 1u << 4))
        loft_port_byte((uint8_t)REG(UART + 0x00));
}

size_t loft_port_write(const uint8_t *bytes, size_t count)
{
    if (count == 0)
        return 0;
    if (REG(UART + 0x18) & 1u << 5) {                   /* FR: full */
        REG(UART + 0x38) = 1u << 5 | 1u << 4;
        return 0;
    }
    REG(UART + 0x00) = *bytes;
    return 1;
}

uint16_t loft_port_inputs(void)
{
    const uint32_t closed = ~REG(SIO_INPUTS);

    return loft_switches_of((closed >> FIRST_INPUT & 0x3F) | (closed >> PROBE & 1) << 6);
}


// Slots
// -----

#define CYCLES  25u                 /* of the state machine in a slot */
#define HIGH    13u                 /* of these, steps are high */
#define GIVE    (0x6000 | (HIGH - 1) << 8 | 6)              /* out pins, 6: steps and directions */
#define LOWER   (0xE000 | (CYCLES - HIGH - 1) << 8 | 0)     /* set pins, 0: of the steps */
#define THREE_PINS(first) (3u << 26 | 6u << 20 | (first) << 5)  /* set: 3; out: 6 from GP0 */

static uint32_t at, next;           /* the half that the DMA gives or gave; and that after it */

static void set_machine(uint32_t slot_hz)
{
    REG(PIO + 0x48) = GIVE;
    REG(PIO + 0x4C) = LOWER;
    REG(SM + 0x00) = CORE / (CYCLES * slot_hz) << 16;               /* CLKDIV */
    REG(SM + 0x04) = 1u << 12;                                      /* EXECCTRL: 1, then 0 */
    REG(SM + 0x08) = 6u << 25 | 1u << 19 | 1u << 17;    /* SHIFTCTRL: 6 bits of each word, lowest */
    for (uint32_t first = 0; first < 6; first += 3) {
        REG(SM + 0x14) = THREE_PINS(first);
        REG(SM + 0x10) = 0xE087;                                    /* set pindirs, 7 */
        REG(SM + 0x10) = 0xE000;                                    /* set pins, 0 */
    }
    REG(SM + 0x14) = THREE_PINS(0u);
    for (uint32_t pin = 0; pin < 6; pin++)
        give_pin(pin, 6, 0);
    REG(PIO + 0x00) = 1;                                            /* CTRL: it runs */
}

/* Words, from memory that goes on, as often as the FIFO of the state machine asks, of high
 * priority; no channel after it. */
uint32_t cortex_stream(uint32_t slot_hz)
{
    set_machine(slot_hz);
    REG(DMA + 0x04) = PIO + 0x10;
    LEFT = STREAM_HALF;
    REG(DMA + 0x10) = 1u << 4 | 2u << 2 | 1u << 1 | 1u << 0;
    REG(DMA + 0x404) = 1;                                           /* INTE0 */
    return CORE;
}

void cortex_acknowledge(void)
{
    REG(DMA + 0x40C) = 1;                                           /* INTS0 */
    next ^= 1u;
}

void cortex_run(bool run)
{
    if (!run)
        return;                     /* it stands when it has given all */
    at = next;
    REG(DMA + 0x3C) = (uint32_t)(uintptr_t)(cortex_ring() + at * STREAM_HALF);
}

uint32_t cortex_given(void) { return (at + 1) * STREAM_HALF - LEFT; }

/* One word is in the shift register. */
uint32_t cortex_waiting(void)
{
    const uint32_t level = REG(PIO + 0x0C) & 15u;

    return level ? level + 1 : 0;
}
