/* ports/stm32f405/port.c -- an STM32F405 or F407 at 168 MHz: three axes, LOFT_SLOTS steps per
 * millisecond each
 * SPDX-License-Identifier: MIT
 *
 *     step     PA0 PA1 PA2       limits   PC0 PC1 PC2, closing to ground
 *     dir      PA3 PA4 PA5       buttons  PC3 abort, PC4 hold, PC5 resume, closing to ground
 *     enable   PA6, low          probe    PC6, closing to ground
 *                                line     PA9 PA10 (USART1), 8N1
 *     outputs  PB8 power of output 1, PWM of 5.1 kHz; PB9 high while it is above 0; PB10 output 2
 *
 * Timer 1 requests two transfers of DMA2 in each slot (RM0090, table 43): its update, stream 5,
 * gives a word of the ring to PA; its compare 1, stream 1, ends the pulses.
 *
 * Settings are kept in flash: kept.h. Registers: ST's reference manual RM0090.
 */
#include "switches.h"

#ifndef LOFT_BAUD
#  define LOFT_BAUD 115200
#endif
#ifndef LOFT_CRYSTAL
/* MHz, a whole number; without a crystal the internal clock is used, 1 % */
#  define LOFT_CRYSTAL 8
#endif
#define CORE    168000000u          /* Hz */
#define RCC     0x40023800
#define GPIOA   0x40020000
#define GPIOB   0x40020400
#define GPIOC   0x40020800
#define USART1  0x40011000
#define FLASHES 0x40023C00
#define RANDOM  0x50060800
#define TIM1    0x40010000
#define TIM4    0x40000800
#define DMA2    0x40026400

#define BSRR    (GPIOA + 0x18)
#define WORDS   (DMA2 + 0x10 + 0x18 * 5)    /* stream 5: CR, NDTR, PAR, M0AR */
#define ENDS    (DMA2 + 0x10 + 0x18 * 1)    /* stream 1 */
#include "cortex-m/stm32.h"
#define PULLED_UP 0x1555u    /* 0..6 of GPIOC */
#define COUNTS  0x4000u     /* of TIM4, in a period of the power */
#define CELLS   1024
#include "plans.h"
#include "stm32f405/kept.h"

/* steps/mm, mm/s, mm/s^2, mm/s^3 */
#define AXIS { LOFT_RAW(250), LOFT_RAW(400), LOFT_RAW(2000), 40000 }

static const loft_axis_config usual_axis[LOFT_AXES] = { AXIS, AXIS, AXIS };
static volatile loft_cell cells[CELLS];
static loft_machine_config config = {
    .info = { .tick_hz = 1000, .slots = LOFT_SLOTS, .outputs = STREAM_OUTPUTS },
    .ramp = 200,
    .cell = cells,
    .cells = CELLS
};

static void usual_settings(loft_settings *s)
{
    for (int i = 0; i < LOFT_AXES; i++)
        config.info.axis[i] = usual_axis[i];
    for (int k = 0; k < LOFT_WIRING_OBEYED; k++)
        s->wiring[k] = 0;
    s->wiring[LOFT_WIRING_OBEYED] = 1 << LOFT_WIRING_OPENS;
}

/* Crystal (or the internal clock, 16 MHz) to 168 MHz; APB1 at a quarter, APB2 at half. */
static void set_clock(void)
{
    bool crystal;

    REG(RCC + 0x00) |= 1u << 16;                        /* CR: HSEON, until HSERDY */
    crystal = came(RCC + 0x00, 1u << 17);
    REG(FLASHES + 0x00) = 5 | 7u << 8;                                  /* 5 wait states, caches */
    /* 1 MHz * 336 / 2 */
    REG(RCC + 0x04) = (crystal ? LOFT_CRYSTAL | 1u << 22 : 16u) | 336u << 6 | 7u << 24;
    REG(RCC + 0x00) |= 1u << 24;                                        /* PLLON, until PLLRDY */
    if (came(RCC + 0x00, 1u << 25))
        REG(RCC + 0x08) = 2 | 5u << 10 | 4u << 13;      /* CFGR: the PLL is the clock */
}

static uint32_t random_number(void)
{
    REG(RCC + 0x34) |= 1u << 6;
    REG(RANDOM + 0x00) = 1u << 2;
    return came(RANDOM + 0x04, 1) ? REG(RANDOM + 0x08) : 0;
}

/* Channel 3 of timer 4 is PB8. */
static void begin_outputs(void)
{
    REG(RCC + 0x30) |= 1u << 1;                         /* port B */
    REG(RCC + 0x40) |= 1u << 2;                         /* TIM4, at 84 MHz */
    REG(TIM4 + 0x1C) = 6u << 4 | 1u << 3;               /* CCMR2: PWM, from the next period on */
    REG(TIM4 + 0x2C) = COUNTS - 1;                      /* ARR */
    REG(TIM4 + 0x3C) = 0;                               /* CCR3 */
    REG(TIM4 + 0x20) = 1u << 8;                         /* CCER */
    REG(TIM4 + 0x14) = 1;                               /* EGR: they are in force */
    REG(TIM4 + 0x00) = 1u << 7 | 1u << 0;               /* CR1 */
    REG(GPIOB + 0x24) = (REG(GPIOB + 0x24) & ~0x0000000Fu) | 0x00000002u;   /* AFRH: TIM4 */
    /* MODER: 8 the timer's, 9 10 out */
    REG(GPIOB + 0x00) = (REG(GPIOB + 0x00) & ~0x003F0000u) | 0x00160000u;
}

void cortex_output(int output, uint16_t level)
{
    const uint32_t pin = output == 1 ? 1u << 9 : 1u << 10;

    if (output == 1)
        REG(TIM4 + 0x3C) = (level * COUNTS + 0x8000u) >> 16;
    REG(GPIOB + 0x18) = level ? pin : pin << 16;
}

loft_machine_config *loft_port_init(void)
{
    set_clock();
    config.info.boot = random_number() ^ cortex_starts();

    REG(RCC + 0x30) |= 1 << 0 | 1 << 2;                                 /* ports A and C */
    REG(RCC + 0x44) |= 1 << 4;                                          /* USART1 */
    /* MODER: 0..6 out, 9 10 line */
    REG(GPIOA + 0x00) = (REG(GPIOA + 0x00) & ~0x003C3FFFu) | 0x00281555u;
    REG(GPIOA + 0x24) = (REG(GPIOA + 0x24) & ~0x00000FF0u) | 0x00000770u;   /* AFRH: USART1 */
    REG(GPIOC + 0x0C) = (REG(GPIOC + 0x0C) & ~0x00003FFFu) | PULLED_UP;     /* PUPDR: 0..6 up */
    begin_outputs();
    set_line(CORE / 2, LOFT_BAUD);
    loft_port_plans(&config);
    usual_settings(&config.settings);
    begin_kept(&config.settings, usual_settings);
    return &config;
}

/* Memory to peripheral, words, circular, channel 6, very high priority, on. */
#define TRANSFER (6u << 25 | 3u << 16 | 2u << 13 | 2u << 11 | 1u << 8 | 1u << 6 | 1u << 0)
#define STEPPING (1u << 10 | 1u << 4 | 1u << 3)     /* memory goes on; interrupts at both halves */

/* The slot of a word begins at the update of the timer. */
uint32_t cortex_stream(uint32_t slot_hz)
{
    REG(RCC + 0x30) |= 1u << 22;                        /* DMA2 */
    REG(RCC + 0x44) |= 1u << 0;                         /* TIM1, at 168 MHz */
    set_timer(CORE, slot_hz);
    set_transfers(ENDS, WORDS, TRANSFER, STEPPING);
    set_requests();
    return CORE;
}

void cortex_acknowledge(void) { REG(DMA2 + 0x0C) = 0x0F40; }   /* HIFCR: stream 5 */

/* An emulator without this port does not keep pull-ups, and has no switches. */
uint16_t loft_port_inputs(void)
{
    const uint8_t *opens = config.settings.wiring + LOFT_WIRING_OPENS;

    if ((REG(GPIOC + 0x0C) & 0x3FFFu) != PULLED_UP)
        return 0;
    return (uint16_t)(loft_switches_of(~REG(GPIOC + 0x10)) ^
                      (loft_switches_of(0x7F) & (opens[0] | opens[1] << 8)));
}
