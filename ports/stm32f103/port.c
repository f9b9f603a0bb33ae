/* ports/stm32f103/port.c -- an STM32F103 at 72 MHz, as on the "blue pill": three axes, LOFT_SLOTS
 * steps per millisecond each
 * SPDX-License-Identifier: MIT
 *
 *     step     PA0 PA1 PA2       limits   PB10 PB11 PB12, closing to ground
 *     dir      PA3 PA4 PA5       buttons  PB13 abort, PB14 hold, PB15 resume, closing to ground
 *     enable   PA6, low          probe    PB8, closing to ground
 *                                line     PA9 PA10 (USART1), 8N1
 *
 * Timer 1 requests two transfers of DMA1 in each slot (RM0008, table 78): its update, channel 5,
 * gives a word of the ring to PA; its compare 1, channel 2, ends the pulses.
 *
 * Registers: ST's reference manual RM0008.
 */
#include "switches.h"

#ifndef LOFT_BAUD
#  define LOFT_BAUD 115200
#endif
#define CRYSTAL 72000000u           /* Hz: 8 MHz, times 9 */
#define INTERNAL 64000000u          /* without a crystal, 1 % */

#define RCC     0x40021000
#define FLASHES 0x40022000
#define GPIOA   0x40010800
#define GPIOB   0x40010C00
#define USART1  0x40013800
#define TIM1    0x40012C00
#define DMA1    0x40020000

#define BSRR    (GPIOA + 0x10)
#define WORDS   (DMA1 + 8 + 20 * 4)         /* channel 5: CCR, CNDTR, CPAR, CMAR */
#define ENDS    (DMA1 + 8 + 20 * 1)         /* channel 2 */
#include "cortex-m/stm32.h"
#define INPUTS  10                          /* the first one, of GPIOB */
#define PROBE   8                           /* of GPIOB */
#define CELLS   256

/* steps/mm, mm/s, mm/s^2, mm/s^3 */
#define AXIS { LOFT_RAW(250), LOFT_RAW(200), LOFT_RAW(1000), 20000 }

static volatile loft_cell cells[CELLS];
static uint32_t core = INTERNAL;            /* Hz */
static loft_machine_config config = {
    .info = { .tick_hz = 1000, .slots = LOFT_SLOTS, .axis = { AXIS, AXIS, AXIS } },
    .ramp = 200,
    .cell = cells,
    .cells = CELLS
};

/* Crystal (or half the internal clock of 8 MHz, times 16); APB1 at half. */
static void set_clock(void)
{
    REG(RCC + 0x00) |= 1u << 16;                        /* CR: HSEON, until HSERDY */
    const bool crystal = came(RCC + 0x00, 1u << 17);
    REG(FLASHES + 0x00) = 1u << 4 | 2;                  /* prefetch, 2 wait states */
    REG(RCC + 0x04) = 4u << 8 | (crystal ? 1u << 16 | 7u << 18 : 14u << 18);    /* CFGR */
    REG(RCC + 0x00) |= 1u << 24;                        /* PLLON, until PLLRDY */
    if (came(RCC + 0x00, 1u << 25))
        REG(RCC + 0x04) |= 2;                           /* the PLL is the clock */
    if (crystal)
        core = CRYSTAL;
}

loft_machine_config *loft_port_init(void)
{
    set_clock();
    config.info.boot = cortex_starts();

    REG(RCC + 0x18) |= 1u << 14 | 1u << 11 | 1u << 3 | 1u << 2; /* USART1, TIM1, ports B, A */
    REG(GPIOA + 0x00) = 0x43333333;                             /* CRL: 0..6 out, 50 MHz */
    REG(GPIOA + 0x0C) = 1u << 10;                               /* ODR: PA10 pulled up */
    REG(GPIOA + 0x04) = 0x444448B4;                             /* CRH: 9 sends, 10 receives */
    REG(GPIOB + 0x0C) = 0x3Fu << INPUTS | 1u << PROBE;
    REG(GPIOB + 0x04) = 0x88888848;                             /* 8, 10..15 pulled up */
    set_line(core, LOFT_BAUD);
    return &config;
}

/* Memory to peripheral, words, circular, very high priority, on. */
#define TRANSFER (3u << 12 | 2u << 10 | 2u << 8 | 1u << 5 | 1u << 4 | 1u << 0)
#define STEPPING (1u << 7 | 1u << 2 | 1u << 1)      /* memory goes on; interrupts at both halves */

uint32_t cortex_stream(uint32_t slot_hz)
{
    REG(RCC + 0x14) |= 1u << 0;                         /* DMA1 */
    set_timer(core, slot_hz);
    set_transfers(ENDS, WORDS, TRANSFER, STEPPING);
    set_requests();
    return core;
}

void cortex_acknowledge(void) { REG(DMA1 + 0x04) = 0xFu << 16; }     /* IFCR: channel 5 */

uint16_t loft_port_inputs(void)
{
    const uint32_t closed = ~REG(GPIOB + 0x08);

    return loft_switches_of((closed >> INPUTS & 0x3F) | (closed >> PROBE & 1) << 6);
}
