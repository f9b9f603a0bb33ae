/* tests/target/arm_pio.h -- a state machine of an RP2040's PIO, cycle by cycle
 * SPDX-License-Identifier: MIT
 *
 * The instructions of a program of pulses: out pins, set pins, set pindirs, jmp, with delays
 * (RP2040 datasheet, 3.4), automatic pull (3.5.4) and wrapping (3.5.2). Any other one ends the run
 * with an error. Words come from a FIFO of four. Shifting is to the right.
 */
#ifndef TARGET_ARM_PIO_H
#define TARGET_ARM_PIO_H

#include <stdbool.h>
#include <stdint.h>

#define ARM_PIO_FIFO 4

struct arm_pio {
    uint16_t program[32];
    uint32_t clock, exec, shift, pins;  /* CLKDIV, EXECCTRL, SHIFTCTRL, PINCTRL */
    bool runs, failed;
    uint32_t fifo[ARM_PIO_FIFO], level;
    uint32_t osr, shifted;              /* shifted: bits taken of osr; 32: it is empty */
    uint32_t at, delay;
    bool began, stalls;                 /* it had a word; it waits for one */
    uint64_t stalled;                   /* how often it began to, after its first word */
    uint32_t out, dirs;                 /* its pins, and which of them it drives */
};

void arm_pio_init(struct arm_pio *p);

/* Run an instruction at once, as a write to SMx_INSTR does. */
void arm_pio_run(struct arm_pio *p, uint16_t instruction);

/* A cycle of its clock. */
void arm_pio_cycle(struct arm_pio *p);

/* Cycles of the core in one of its own. */
static inline uint32_t arm_pio_divider(const struct arm_pio *p) { return p->clock >> 16; }

static inline bool arm_pio_put(struct arm_pio *p, uint32_t word)
{
    if (p->level == ARM_PIO_FIFO)
        return false;
    p->fifo[p->level++] = word;
    return true;
}

#endif
