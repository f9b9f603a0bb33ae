/* lib/wire/varint.h -- whole numbers in as few bytes as they need
 * SPDX-License-Identifier: MIT
 *
 * A varint has seven bits per byte, low bits first. The top bit says that more bytes follow. Only
 * the shortest form is valid. A residual is a signed number modulo 2^32 as a zigzag varint: 0 -1 1
 * -2 2 .. become 0 1 2 3 4 ..
 */
#ifndef LOFT_WIRE_VARINT_H
#define LOFT_WIRE_VARINT_H

#include "num/num.h"    /* the integer types */

/* The signed value of a word: each compiler takes it modulo 2^32. */
static inline int32_t loft_word_signed(uint32_t x) { return (int32_t)x; }

/* Write x. Returns the number of bytes, 1..5. */
static inline uint8_t loft_varint_encode(uint8_t *byte, uint32_t x)
{
    uint8_t n = 0;
    for (; x >= 0x80u; x >>= 7)
        byte[n++] = (uint8_t)(x | 0x80u);
    byte[n++] = (uint8_t)x;
    return n;
}

static inline uint8_t loft_residual_encode(uint8_t *byte, uint32_t r)
{
    return loft_varint_encode(byte, (r << 1) ^ (r & 0x80000000u ? 0xFFFFFFFFu : 0u));
}

/* Read a varint that loft_varint_size has accepted, and advance past it. */
static inline uint32_t loft_varint_decode(const uint8_t **byte)
{
    uint32_t x = 0;
    for (uint8_t shift = 0;; shift = (uint8_t)(shift + 7)) {
        const uint8_t b = *(*byte)++;
        x |= (uint32_t)(b & 0x7Fu) << shift;
        if (b < 0x80u)
            return x;
    }
}

static inline uint32_t loft_residual_decode(const uint8_t **byte)
{
    const uint32_t z = loft_varint_decode(byte);
    return (z >> 1) ^ (z & 1u ? 0xFFFFFFFFu : 0u);
}

/* The length of the varint at byte[0]; 0 if it is cut off, longer than 32 bits, or not the shortest
 * form. */
static inline uint8_t loft_varint_size(const uint8_t *byte, uint8_t left)
{
    for (uint8_t n = 0; n < left && n < 5; n++)
        if (byte[n] < 0x80u)
            return (n > 0 && byte[n] == 0) || (n == 4 && byte[n] > 0x0Fu) ? 0 : (uint8_t)(n + 1);
    return 0;
}

#endif
