/* lib/wire/frame.c -- COBS and CRC-32C, a byte at a time
 * SPDX-License-Identifier: MIT
 */
#include "wire/frame.h"
#if defined(__AVR__)
#  include "num/avr.h"      /* loft_avr_flash */
#endif

/* CRC-32C: polynomial 0x1EDC6F41, here with its bits reversed (0x82F63B78), least significant bit
 * first. Hamming distance 6 up to 655 bytes (Koopman, Cyclic redundancy code polynomial selection
 * for embedded networks, 2004). The table holds the remainders of the 16 nibbles:
 *
 *     crc(byte) = two times   crc' = crc >> 4  xor  table[(crc xor nibble) mod 16]
 *
 * The initial value and the final inversion are FFFFFFFF. Without an inversion, a 0x00 inserted in
 * front of the delimiter or after the CRC would pass. The register starts with the value of
 * FFFFFFFF after the four bytes "loft". So a frame of another protocol with the same CRC is
 * refused, at no cost on the wire. After content and its CRC the register holds a constant,
 * whatever the content is: one comparison is enough, and no second copy of the CRC. A CRC is
 * linear, so a seal on the CRC changes the register as the seal alone changes a register of
 * zeros. */
#define CRC_START   0x73AC3B06u         /* of "loft"                */
#define CRC_PASSED  0xB798B438u         /* after any good frame     */

#if defined(__AVR__)
#  define TABLE LOFT_AVR_FLASH
#  define ENTRY(x) loft_avr_flash(&table[(x) & 15u])
#else
#  define TABLE
#  define ENTRY(x) table[(x) & 15u]
#endif

uint32_t loft_crc(uint32_t crc, uint8_t byte)
{
    static const uint32_t table[16] TABLE = { 0x00000000u, 0x105EC76Fu, 0x20BD8EDEu, 0x30E349B1u,
                                              0x417B1DBCu, 0x5125DAD3u, 0x61C69362u, 0x7198540Du,
                                              0x82F63B78u, 0x92A8FC17u, 0xA24BB5A6u, 0xB21572C9u,
                                              0xC38D26C4u, 0xD3D3E1ABu, 0xE330A81Au, 0xF36E6F75u };
    crc = (crc >> 4) ^ ENTRY(crc ^ byte);
    return (crc >> 4) ^ ENTRY(crc ^ (uint32_t)(byte >> 4));
}

uint32_t loft_crc32(uint32_t crc, uint32_t x)
{
    for (int i = 0; i < 4; i++, x >>= 8)
        crc = loft_crc(crc, (uint8_t)(x & 0xFFu));
    return crc;
}

/* COBS: the content is divided at its zeros. Each piece is sent after a code byte, its length + 1,
 * so the zeros themselves are not sent. A frame is shorter than 254 bytes. So no piece needs to be
 * split, and the overhead is exactly one byte. The code FF, which means a split, makes the frame
 * too long, so it is refused.
 *
 * flags: */
#define STARTED 1u      /* a byte has come since the last delimiter             */
#define ZERO    2u      /* a removed zero belongs before the next piece         */
#define REFUSED 4u      /* too long: ignore everything up to the next delimiter */

static void restart_frame(loft_frame *f)
{
    f->crc   = CRC_START;
    f->size  = 0;
    f->left  = 0;
    f->flags = 0;
}

void loft_frame_init(loft_frame *f)
{
    restart_frame(f);
    f->count = 0;
    f->odd   = 0;
}

static void take_byte(loft_frame *f, uint8_t byte)
{
    if (f->size == sizeof f->byte) {
        f->flags |= REFUSED;
        return;
    }
    f->byte[f->size++] = byte;
    f->crc = loft_crc(f->crc, byte);
}

static enum loft_status finish_frame(loft_frame *f)
{
    const bool empty = !(f->flags & STARTED);
    const bool whole = !(f->flags & REFUSED) && f->left == 0 && f->size >= 2 + 4;

    f->count = whole ? (uint8_t)(f->size - 4) : 0;
    f->odd   = f->crc ^ CRC_PASSED;
    restart_frame(f);
    return whole && f->odd == 0 ? LOFT_OK : empty ? LOFT_MORE : LOFT_ERR_DATA;
}

bool loft_frame_sealed(const loft_frame *f, uint32_t seal) { return f->odd == loft_crc32(0, seal); }

enum loft_status loft_frame_push(loft_frame *f, uint8_t byte)
{
    if (byte == 0)
        return finish_frame(f);

    f->flags |= STARTED;
    if (f->left == 0) {
        if (f->flags & ZERO)
            take_byte(f, 0);
        f->flags |= ZERO;
        f->left = (uint8_t)(byte - 1);
    } else {
        take_byte(f, byte);
        f->left--;
    }
    return LOFT_MORE;
}

/* In place, because content starts at wire[1]. The code of a piece replaces the zero before it. */
static void stuff_zeros(uint8_t wire[], size_t size)
{
    size_t code = 0;
    for (size_t i = 1; i <= size; i++)
        if (wire[i] == 0) {
            wire[code] = (uint8_t)(i - code);
            code = i;
        }
    wire[code]     = (uint8_t)(size + 1 - code);
    wire[size + 1] = 0;
}

size_t loft_frame_encode(uint8_t wire[LOFT_FRAME_MAX], size_t count)
{
    return loft_frame_seal(wire, count, 0);
}

size_t loft_frame_seal(uint8_t wire[LOFT_FRAME_MAX], size_t count, uint32_t seal)
{
    if (count < 2 || count > LOFT_FRAME_CONTENT)
        return 0;

    uint32_t crc = CRC_START;
    for (size_t i = 1; i <= count; i++)
        crc = loft_crc(crc, wire[i]);

    crc ^= 0xFFFFFFFFu ^ seal;
    for (size_t i = 1; i <= 4; i++, crc >>= 8)
        wire[count + i] = (uint8_t)(crc & 0xFFu);
    stuff_zeros(wire, count + 4);
    return count + LOFT_FRAME_EXTRA;
}
