/* tests/target/arm_flash.h -- the flash controller of an STM32F405: its last two sectors
 * SPDX-License-Identifier: MIT
 *
 * RM0090, chapter 3: two keys, in order, open CR until LOCK is set; any other write to KEYR closes
 * it until reset. Programming makes zeros, in words of PSIZE; STRT erases sector SNB to ones. An
 * order that does not fit sets a flag of SR, and flash stays as it is.
 *
 * The core stands while flash is busy, because its instructions come from there; so BSY is never
 * read. The caller adds `takes` microseconds to its clock.
 */
#ifndef TARGET_ARM_FLASH_H
#define TARGET_ARM_FLASH_H

#include <stdbool.h>
#include <stdint.h>

#define ARM_FLASH_AT     0x080C0000u
#define ARM_FLASH_FIRST  10u                /* the number of the first sector */
#define ARM_FLASH_WORDS  0x8000u            /* of a sector */
#define ARM_FLASH_LOCK   (1u << 31)
#define ARM_FLASH_ERRORS 0xF2u              /* OPERR, WRPERR, PGAERR, PGPERR, PGSERR */

enum { ARM_FLASH_KEYR = 0x04, ARM_FLASH_SR = 0x0C, ARM_FLASH_CR = 0x10 };

struct arm_flash {
    uint32_t word[2][ARM_FLASH_WORDS];
    uint32_t control, status;
    int keys;                               /* that came in order; -1: a wrong one did */
    uint32_t takes;                         /* microseconds of the last order */
    uint32_t written, erased, refused;      /* words, sectors, orders */
    uint32_t again;                         /* words that were not erased before */
    uint32_t power;                         /* orders until the power fails in the last; 0: never */
    bool cut;
};

static inline void arm_flash_reset(struct arm_flash *f)
{
    f->control = ARM_FLASH_LOCK;
    f->status  = 0;
    f->keys    = 0;
}

static inline void arm_flash_erase_all(struct arm_flash *f)
{
    for (uint32_t k = 0; k < 2 * ARM_FLASH_WORDS; k++)
        f->word[k / ARM_FLASH_WORDS][k % ARM_FLASH_WORDS] = 0xFFFFFFFFu;
}

static inline void arm_flash_refuse(struct arm_flash *f, uint32_t flag)
{
    f->status |= flag;
    f->refused++;
}

/* An order is carried out; the one at which the power fails, by half. */
static inline bool arm_flash_fails(struct arm_flash *f)
{
    f->cut = f->cut || (f->power && --f->power == 0);
    return f->cut;
}

static inline void arm_flash_key(struct arm_flash *f, uint32_t key)
{
    static const uint32_t keys[2] = { 0x45670123u, 0xCDEF89ABu };

    if (f->keys < 0 || f->keys > 1 || key != keys[f->keys]) {
        f->keys = -1;
        f->refused++;
        f->control |= ARM_FLASH_LOCK;
    } else if (++f->keys == 2) {
        f->control &= ~ARM_FLASH_LOCK;
    }
}

/* At 32 bits a sector of 128 KB takes 1 s (DS8626, table 40). */
static inline void arm_flash_erase(struct arm_flash *f)
{
    const uint32_t sector = (f->control >> 3 & 31) - ARM_FLASH_FIRST;

    if (!(f->control & 2) || f->control & 1 || sector > 1) {
        arm_flash_refuse(f, 1u << 7);
        return;
    }
    const bool fails = arm_flash_fails(f);
    for (uint32_t k = 0; k < ARM_FLASH_WORDS; k++)
        f->word[sector][k] |= fails ? 0x5A5A5A5Au * (k + 1) : 0xFFFFFFFFu;
    f->erased++;
    f->takes = 1000000;
}

static inline void arm_flash_order(struct arm_flash *f, uint32_t value)
{
    if (f->control & ARM_FLASH_LOCK) {
        f->refused++;
        return;
    }
    f->control = value & ~(1u << 16);
    if (value & ARM_FLASH_LOCK)
        f->keys = 0;
    else if (value >> 16 & 1)
        arm_flash_erase(f);
}

/* A write to a register, by its offset. */
static inline void arm_flash_write(struct arm_flash *f, uint32_t offset, uint32_t value)
{
    f->takes = 0;
    switch (offset) {
    case ARM_FLASH_KEYR: arm_flash_key(f, value); break;
    case ARM_FLASH_SR: f->status &= ~(value & (ARM_FLASH_ERRORS | 1)); break;
    case ARM_FLASH_CR: arm_flash_order(f, value); break;
    default: break;
    }
}

static inline uint32_t arm_flash_read(const struct arm_flash *f, uint32_t offset)
{
    return offset == ARM_FLASH_SR ? f->status : offset == ARM_FLASH_CR ? f->control : 0;
}

static inline uint32_t *arm_flash_word(struct arm_flash *f, uint32_t address)
{
    const uint32_t k = (address - ARM_FLASH_AT) / 4;

    return &f->word[k / ARM_FLASH_WORDS & 1][k % ARM_FLASH_WORDS];
}

/* A store to flash itself, of `size` bytes. */
static inline void arm_flash_store(struct arm_flash *f, uint32_t address, uint32_t value,
                                   unsigned size)
{
    uint32_t *at = arm_flash_word(f, address);

    f->takes = 0;
    if (f->control & ARM_FLASH_LOCK || (f->control & 3) != 1) {
        arm_flash_refuse(f, 1u << 7);
    } else if (1u << (f->control >> 8 & 3) != size || size != 4) {
        arm_flash_refuse(f, 1u << 6);
    } else {
        f->again += *at != 0xFFFFFFFFu;
        *at &= arm_flash_fails(f) ? value | 0x00F0F0F0u : value;
        f->written++;
        f->takes = 16;
    }
}

#endif
