/* lib/num/flash.h -- constant tables that stay in flash
 * SPDX-License-Identifier: MIT
 *
 * An AVR copies constants to RAM unless they are marked, and reads marked ones by an instruction of
 * its own. Elsewhere this is a plain array.
 *
 *     static const int16_t table[] LOFT_FLASH = { 1, 2, 3 };
 *     sum += loft_flash_word(&table[i]);
 */
#ifndef LOFT_NUM_FLASH_H
#define LOFT_NUM_FLASH_H

#include <stdint.h>

#if defined(__AVR__)
#  define LOFT_FLASH __attribute__((__progmem__))
#else
#  define LOFT_FLASH
#endif

/* *p, which is marked LOFT_FLASH; on an AVR in the first 64 kB. */
static inline int16_t loft_flash_word(const int16_t *p)
{
#if defined(__AVR__)
    int16_t word;
    __asm__("lpm %A0, Z+\n\tlpm %B0, Z" : "=r"(word), "=z"(p) : "1"(p));
    return word;
#else
    return *p;
#endif
}

#endif
