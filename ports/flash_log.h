/* ports/flash_log.h -- the memory of settings in two sectors of flash: a log of changed bytes
 * SPDX-License-Identifier: MIT
 *
 * Flash is erased by whole sectors, to ones, and each of its words is written once. So a change
 * becomes a word at the end of a log, and RAM holds the bytes as they are. When the sector is full,
 * all bytes that are not 0xFF go to the other one, and its header, the first word, comes last: then
 * that sector is the log. A copy of settings (lib/machine/settings.h) is completed by its check, so
 * the bytes need no order but that of writing.
 *
 * The power may fail while a word is written or a sector is erased: some of the zeros are missing.
 * A word holds 24 bits and the number of zeros among them (Berger, 1961). Missing zeros lower that
 * number and raise what is written of it, so such a word is found and skipped, whichever failed.
 */
#ifndef LOFT_FLASH_LOG_H
#define LOFT_FLASH_LOG_H

#include <stdbool.h>
#include <stdint.h>

#define LOFT_FLASH_ERASED 0xFFFFFFFFu
#define LOFT_FLASH_NONE   2u

/* The first fields are the caller's; a sector has more words than there are bytes. */
typedef struct {
    uint32_t (*read)(uint8_t sector, uint32_t word);
    void (*write)(uint8_t sector, uint32_t word, uint32_t value);   /* of an erased word */
    void (*erase)(uint8_t sector);
    uint32_t words;             /* of a sector */
    uint8_t *byte;              /* as they are */
    uint16_t bytes;

    uint8_t  sector;            /* that is the log; LOFT_FLASH_NONE: there is none yet */
    uint32_t end, number;       /* of the log: its next word, its header */
} loft_flash_log;

/* 24 bits with their check. */
static inline uint32_t loft_flash_word(uint32_t bits)
{
    uint32_t zeros = 24;

    for (uint32_t k = 0; k < 24; k++)
        zeros -= bits >> k & 1u;
    return zeros << 24 | bits;
}

static inline bool loft_flash_sound(uint32_t word)
{
    return word == loft_flash_word(word & 0xFFFFFFu);
}

static inline void loft_flash_replay(loft_flash_log *l)
{
    for (l->end = 1; l->end < l->words; l->end++) {
        const uint32_t word = l->read(l->sector, l->end), at = word >> 8 & 0xFFFFu;
        if (word == LOFT_FLASH_ERASED)
            return;
        if (loft_flash_sound(word) && at < l->bytes)
            l->byte[at] = (uint8_t)(word & 0xFFu);
    }
}

/* Read the log. Without one every byte is 0xFF. */
static inline void loft_flash_init(loft_flash_log *l)
{
    l->sector = LOFT_FLASH_NONE;
    l->number = 0;
    for (uint16_t at = 0; at < l->bytes; at++)
        l->byte[at] = 0xFF;
    for (uint8_t sector = 0; sector < 2; sector++) {
        const uint32_t header = l->read(sector, 0), number = header & 0xFFFFFFu;
        if (!loft_flash_sound(header) ||
            (l->sector != LOFT_FLASH_NONE && ((number - l->number) & 0xFFFFFFu) > 0x7FFFFFu))
            continue;
        l->sector = sector;
        l->number = number;
    }
    if (l->sector != LOFT_FLASH_NONE)
        loft_flash_replay(l);
}

/* A word that does not hold what is written is passed by. False: the sector is full. */
static inline bool loft_flash_append(loft_flash_log *l, uint8_t sector, uint16_t at)
{
    const uint32_t word = loft_flash_word((uint32_t)at << 8 | l->byte[at]);

    while (l->end < l->words) {
        const uint32_t to = l->end++;
        l->write(sector, to, word);
        if (l->read(sector, to) == word)
            return true;
    }
    return false;
}

/* All bytes go to the other sector. */
static inline bool loft_flash_move(loft_flash_log *l)
{
    const uint8_t to      = l->sector == 0;
    const uint32_t number = (l->number + 1) & 0xFFFFFFu, header = loft_flash_word(number);

    l->erase(to);
    l->end = 1;
    for (uint16_t at = 0; at < l->bytes; at++)
        if (l->byte[at] != 0xFF && !loft_flash_append(l, to, at))
            return false;
    l->write(to, 0, header);
    if (l->read(to, 0) != header)
        return false;
    l->sector = to;
    l->number = number;
    return true;
}

/* Change a byte; it lasts when this returns. A byte that flash does not take stays as it was. */
static inline void loft_flash_put(loft_flash_log *l, uint16_t at, uint8_t byte)
{
    const uint8_t was = l->byte[at];

    l->byte[at] = byte;
    if (l->sector != LOFT_FLASH_NONE && loft_flash_append(l, l->sector, at))
        return;
    if (loft_flash_move(l))
        return;
    l->byte[at] = was;
    l->end      = l->words;         /* the old log is full, the next change tries to move again */
}

#endif
