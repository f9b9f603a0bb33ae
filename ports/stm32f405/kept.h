/* ports/stm32f405/kept.h -- settings in the last two sectors of the flash of an STM32F405 or F407
 * SPDX-License-Identifier: MIT
 *
 * Sectors 10 and 11 have 128 KB each: flash_log.h. The core stands while it writes a word, 16 us,
 * or erases, 1 to 2 s; that is between jobs, and once in 32,000 changed bytes. A chip of less than
 * 1 MB has no such sectors, and an emulator without this controller is not locked: these keep
 * nothing.
 *
 * Registers: RM0090, chapter 3. A port includes it after the address FLASHES.
 */
#ifndef LOFT_STM32F405_KEPT_H
#define LOFT_STM32F405_KEPT_H

#include "cortex-m/cortex.h"
#include "flash_log.h"
#include "machine/settings.h"

#define KEPT_ROOM    508u
#define KEPT_AT      0x080C0000u
#define KEPT_SECTOR  0x20000u
#define KEPT_FIRST   10u
#define KILOBYTES    REG(0x1FFF7A20)        /* the upper half */
#define FLASH_ACR    (FLASHES + 0x00)
#define FLASH_KEYR   (FLASHES + 0x04)
#define FLASH_SR     (FLASHES + 0x0C)
#define FLASH_CR     (FLASHES + 0x10)
#define FLASH_LOCK   (1u << 31)
#define FLASH_BUSY   (1u << 16)
#define FLASH_WORDS  (2u << 8)              /* 32 bits at once */
#define DATA_CACHE   (1u << 10)
#define FORGET_DATA  (1u << 12)

static uint32_t *kept_word(uint8_t sector, uint32_t word)
{
    return (uint32_t *)(uintptr_t)(KEPT_AT + sector * KEPT_SECTOR + 4u * word);
}

static uint32_t kept_read(uint8_t sector, uint32_t word)
{
    return *(volatile uint32_t *)kept_word(sector, word);
}

/* Order it; the flag of an error is cleared, because what is written is read back. */
static void kept_begin(uint32_t order)
{
    REG(FLASH_KEYR) = 0x45670123u;
    REG(FLASH_KEYR) = 0xCDEF89ABu;
    REG(FLASH_SR)   = 0xF3;
    REG(FLASH_CR)   = FLASH_WORDS | order;
}

static void kept_end(void)
{
    while (REG(FLASH_SR) & FLASH_BUSY) {
    }
    REG(FLASH_CR) = FLASH_LOCK;
}

static void kept_write(uint8_t sector, uint32_t word, uint32_t value)
{
    kept_begin(1u << 0);
    *(volatile uint32_t *)kept_word(sector, word) = value;
    kept_end();
}

static void kept_erase(uint8_t sector)
{
    const uint32_t erase = 1u << 1 | (KEPT_FIRST + sector) << 3;

    kept_begin(erase);
    REG(FLASH_CR) |= 1u << 16;
    kept_end();
    REG(FLASH_ACR) &= ~DATA_CACHE;          /* it knows the old bytes */
    REG(FLASH_ACR) |= FORGET_DATA;
    REG(FLASH_ACR) &= ~FORGET_DATA;
    REG(FLASH_ACR) |= DATA_CACHE;
}

static uint8_t kept_bytes[2 * KEPT_ROOM];
static loft_flash_log kept = { .read = kept_read,
    .write = kept_write,
    .erase = kept_erase,
    .words = KEPT_SECTOR / 4,
    .byte = kept_bytes,
    .bytes = sizeof kept_bytes };

static uint8_t kept_get(uint16_t at) { return kept.byte[at]; }
static void kept_put(uint16_t at, uint8_t byte) { loft_flash_put(&kept, at, byte); }

/* Settings are kept, if the chip can; `usual` as in loft_settings. */
static inline void begin_kept(loft_settings *s, void (*usual)(loft_settings *s))
{
    if (!(REG(FLASH_CR) & FLASH_LOCK) || KILOBYTES >> 16 < 1024)
        return;
    loft_flash_init(&kept);
    s->get   = kept_get;
    s->put   = kept_put;
    s->usual = usual;
    s->room  = KEPT_ROOM;
}

#endif
