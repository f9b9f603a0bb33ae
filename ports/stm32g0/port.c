/* ports/stm32g0/port.c -- an STM32G070, G071 or G0B1 at 64 MHz: three axes, LOFT_SLOTS steps per
 * millisecond each
 * SPDX-License-Identifier: MIT
 *
 *     step     PA0 PA1 PA2       limits   PB0 PB1 PB2, closing to ground
 *     dir      PA3 PA4 PA5       buttons  PB3 abort, PB4 hold, PB5 resume, closing to ground
 *     enable   PA6, low          probe    PB8, closing to ground
 *                                line     PB6 PB7 (USART1), 8N1
 *
 * The pins of this family are on the bus of the core alone: a transfer by DMA to them ends with an
 * error (RM0444, 2.1). So the interrupt of timer 1 gives the slots. The internal clock is used,
 * 1 %.
 *
 * Registers: ST's reference manual RM0444.
 */
#include "switches.h"

#ifndef LOFT_BAUD
#  define LOFT_BAUD 115200
#endif
#define CORE    64000000u           /* Hz */
#define RCC     0x40021000
#define FLASHES 0x40022000
#define GPIOA   0x50000000
#define GPIOB   0x50000400
#define USART1  0x40013800
#define TIM1    0x40012C00

#define BSRR    (GPIOA + 0x18)
#define USART_SPLIT
#include "cortex-m/stm32.h"

#define GIVER_HZ        CORE
#define GIVER_SET(word) (REG(BSRR) = (word))
#define GIVER_END(word) ((void)(word), REG(BSRR) = STREAM_STEPS << 16)
#define GIVER_EVENT()   (REG(TIM1 + 0x10) = 0)      /* SR */
#define GIVER_TIME()    REG(TIM1 + 0x24)            /* CNT */
#include "cortex-m/giver.h"

#define CELLS   512

/* steps/mm, mm/s, mm/s^2, mm/s^3 */
#define AXIS { LOFT_RAW(250), LOFT_RAW(200), LOFT_RAW(1000), 20000 }

static volatile loft_cell cells[CELLS];
static loft_machine_config config = {
    .info = { .tick_hz = 1000, .slots = LOFT_SLOTS, .axis = { AXIS, AXIS, AXIS } },
    .ramp = 200,
    .cell = cells,
    .cells = CELLS
};

/* The internal 16 MHz, times 8, by 2. */
static void set_clock(void)
{
    REG(FLASHES + 0x00) = 1u << 9 | 1u << 8 | 2;        /* cache, prefetch, 2 wait states */
    (void)came(FLASHES + 0x00, 2);
    REG(RCC + 0x0C) = 1u << 29 | 1u << 28 | 8u << 8 | 2;    /* PLLCFGR: HSI16 * 8 / 2 */
    REG(RCC + 0x00) |= 1u << 24;                        /* PLLON, until PLLRDY */
    if (came(RCC + 0x00, 1u << 25))
        REG(RCC + 0x08) = 2;                            /* CFGR: the PLL is the clock */
}

loft_machine_config *loft_port_init(void)
{
    set_clock();
    config.info.boot = cortex_starts();

    REG(RCC + 0x34) |= 1u << 1 | 1u << 0;               /* ports A, B */
    REG(RCC + 0x40) |= 1u << 14 | 1u << 11;             /* USART1, TIM1 */
    REG(BSRR) = 0x7Fu << 16;
    /* MODER: 0..6 of A out; 0..5 and 8 of B in, 6 and 7 the line's (AF0) */
    REG(GPIOA + 0x00) = (REG(GPIOA + 0x00) & ~0x00003FFFu) | 0x00001555u;
    REG(GPIOB + 0x0C) = (REG(GPIOB + 0x0C) & ~0x0003FFFFu) | 0x00014555u;   /* PUPDR: up */
    REG(GPIOB + 0x00) = (REG(GPIOB + 0x00) & ~0x0003FFFFu) | 0x0000A000u;
    set_line(CORE, LOFT_BAUD);
    return &config;
}

uint32_t cortex_stream(uint32_t slot_hz)
{
    set_timer(CORE, slot_hz);
    REG(TIM1 + 0x10) = 0;                               /* SR: EGR has set it */
    REG(TIM1 + 0x0C) = 1u << 0;                         /* DIER: the update interrupts */
    giver_begin();
    return CORE;
}

uint16_t loft_port_inputs(void)
{
    const uint32_t closed = ~REG(GPIOB + 0x10);

    return loft_switches_of((closed & 0x3F) | (closed >> 8 & 1) << 6);
}
