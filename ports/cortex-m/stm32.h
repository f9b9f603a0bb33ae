/* ports/cortex-m/stm32.h -- what STM32 chips share: USART 1 is the line, timer 1 gives the slots
 * SPDX-License-Identifier: MIT
 *
 * A port includes it after the addresses USART1, TIM1 and BSRR. These are the registers of F1, F2
 * and F4 (RM0008, RM0090); with USART_SPLIT those of F0 and G0 (RM0091, RM0444). If DMA gives the
 * slots, WORDS is its part for them.
 */
#ifndef LOFT_CORTEX_STM32_H
#define LOFT_CORTEX_STM32_H

#include "cortex-m/cortex.h"
#include "cortex-m/stream.h"
#include "port.h"

#ifdef USART_SPLIT
#  define USART_CR1   0x00
#  define USART_BRR   0x0C
#  define USART_SR    0x1C
#  define USART_READ  0x24
#  define USART_WRITE 0x28
#  define USART_ON    (1u << 0)
#else
#  define USART_CR1   0x0C
#  define USART_BRR   0x08
#  define USART_SR    0x00
#  define USART_READ  0x04
#  define USART_WRITE 0x04
#  define USART_ON    (1u << 13)
#endif
#define LISTENS (USART_ON | 1u << 5 | 1u << 3 | 1u << 2)    /* CR1: receive with interrupt */
#define FREE    (1u << 7)           /* of SR: it can send; of CR1: then it interrupts */

/* Wait for `bits` in a register, but not forever: an emulator may lack it. */
static inline bool came(uint32_t address, uint32_t bits)
{
    for (uint32_t left = 20000; left; left--)
        if (REG(address) & bits)
            return true;
    return false;
}

static inline void set_line(uint32_t bus_hz, uint32_t baud)
{
    REG(USART1 + USART_BRR) = (bus_hz + baud / 2) / baud;
    REG(USART1 + USART_CR1) = LISTENS;
}

void cortex_line(void)
{
    if (REG(USART1 + USART_SR) & 1u << 5)
        loft_port_byte((uint8_t)REG(USART1 + USART_READ));
#ifdef USART_SPLIT
    REG(USART1 + 0x20) = 1u << 3;           /* ICR: a byte was lost; it would ask for ever */
#endif
    REG(USART1 + USART_CR1) = LISTENS;
}

/* Otherwise wake up when it can send. */
size_t loft_port_write(const uint8_t *bytes, size_t count)
{
    if (count == 0)
        return 0;
    if (!(REG(USART1 + USART_SR) & FREE)) {
        REG(USART1 + USART_CR1) = LISTENS | FREE;
        return 0;
    }
    REG(USART1 + USART_WRITE) = *bytes;
    return 1;
}

/* A slot lasts `hz` / `slot_hz` cycles of the timer, a pulse 2 us, or half a slot. Its requests are
 * those of the update and of compare 1, once the transfers are enabled. */
static inline void set_timer(uint32_t hz, uint32_t slot_hz)
{
    const uint32_t period = hz / slot_hz, most = hz / 500000;

    REG(TIM1 + 0x2C) = period - 1;                              /* ARR */
    REG(TIM1 + 0x34) = period / 2 < most ? period / 2 : most;   /* CCR1 */
    REG(TIM1 + 0x14) = 1;                                       /* EGR: ARR is in force */
}

#ifdef WORDS
static inline void set_requests(void)   { REG(TIM1 + 0x0C) = 1u << 9 | 1u << 8; }   /* DIER */

/* Two transfers into BSRR: one word that ends each pulse, and the ring, whose words begin slots. */
static inline void set_transfers(uint32_t ends, uint32_t words, uint32_t transfer,
                                 uint32_t stepping)
{
    static uint32_t end = STREAM_STEPS << 16;
    const uint32_t at[2] = { ends, words }, count[2] = { 1, STREAM_WORDS },
                   from[2] = { (uint32_t)(uintptr_t)&end, (uint32_t)(uintptr_t)cortex_ring() };

    for (int k = 0; k < 2; k++) {
        REG(at[k] + 0x04) = count[k];
        REG(at[k] + 0x08) = BSRR;
        REG(at[k] + 0x0C) = from[k];
        REG(at[k] + 0x00) = transfer | (k ? stepping : 0);
    }
}

uint32_t cortex_given(void) { return (STREAM_WORDS - REG(WORDS + 0x04)) % STREAM_WORDS; }
#endif

void cortex_run(bool run) { REG(TIM1 + 0x00) = run; }

#endif
