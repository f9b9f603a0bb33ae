/* tests/target/arm_pio.c
 * SPDX-License-Identifier: MIT
 */
#include "arm_pio.h"

static uint32_t field(uint32_t word, int from, int bits)
{
    return word >> from & (((uint32_t)1 << bits) - 1);
}

void arm_pio_init(struct arm_pio *p)
{
    *p = (struct arm_pio){ .clock = 1 << 16, .exec = 31u << 12, .pins = 5u << 26, .shifted = 32 };
}

/* `count` pins from `base` on. */
static void set_bits(uint32_t *of, uint32_t base, uint32_t count, uint32_t value)
{
    for (uint32_t k = 0; k < count; k++) {
        const uint32_t pin = (base + k) % 32;
        *of = (*of & ~((uint32_t)1 << pin)) | (value >> k & 1) << pin;
    }
}

/* Bits after which the register counts as empty. */
static uint32_t threshold(const struct arm_pio *p)
{
    const uint32_t bits = field(p->shift, 25, 5);

    return bits ? bits : 32;
}

static bool refill(struct arm_pio *p)
{
    if (p->level == 0)
        return false;
    p->osr = p->fifo[0];
    for (uint32_t k = 1; k < p->level; k++)
        p->fifo[k - 1] = p->fifo[k];
    p->level--;
    p->shifted = 0;
    p->began = true;
    return true;
}

/* Returns false if it must wait. */
static bool execute(struct arm_pio *p, uint16_t instruction, bool pulls)
{
    const uint32_t which = instruction >> 13, to = field(instruction, 5, 3),
                   data = field(instruction, 0, 5);

    if (which == 0 && to == 0) {                /* jmp */
        p->at = data;
        return true;
    }
    if (which == 3 && to == 0) {                /* out pins */
        if (pulls && p->shifted >= threshold(p)) {
            (void)refill(p);
            return false;
        }
        const uint32_t bits = data ? data : 32;
        set_bits(&p->out, field(p->pins, 0, 5), field(p->pins, 20, 6),
                 bits < 32 ? field(p->osr, 0, (int)bits) : p->osr);
        p->osr = bits < 32 ? p->osr >> bits : 0;
        p->shifted = p->shifted + bits < 32 ? p->shifted + bits : 32;
    } else if (which == 7 && (to == 0 || to == 4)) {    /* set pins, pindirs */
        set_bits(to ? &p->dirs : &p->out, field(p->pins, 5, 5), field(p->pins, 26, 3), data);
    } else {
        p->failed = true;
    }
    return true;
}

void arm_pio_run(struct arm_pio *p, uint16_t instruction)
{
    const uint32_t at = p->at;

    (void)execute(p, instruction, false);
    if (instruction >> 13)
        p->at = at;
}

/* A pull happens beside an instruction, unless that is an `out` which waits for it. */
void arm_pio_cycle(struct arm_pio *p)
{
    const bool pulls = p->shift >> 17 & 1;

    if (!p->runs)
        return;
    p->failed = p->failed || !(p->shift >> 19 & 1) || (p->shift & 1u << 16) || p->clock << 16;
    if (p->delay) {
        p->delay--;
    } else {
        const uint16_t instruction = p->program[p->at];
        const uint32_t at = p->at;
        const bool done = execute(p, instruction, pulls);
        p->stalled += !done && !p->stalls && p->level == 0 && p->began;
        p->stalls = !done;
        if (!done)
            return;
        p->delay = field(instruction, 8, 5);
        if (p->at == at)
            p->at = at == field(p->exec, 12, 5) ? field(p->exec, 7, 5) : (at + 1) % 32;
    }
    if (pulls && p->shifted >= threshold(p))
        (void)refill(p);
}
