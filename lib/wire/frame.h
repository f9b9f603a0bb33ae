/* lib/wire/frame.h -- frames: a few checked and delimited bytes, on a line that may lose, double or
 * change any of them
 * SPDX-License-Identifier: MIT
 *
 * A frame is its content and a CRC-32C, both stuffed by COBS so that 0x00 occurs only at the end.
 * Whatever happened before, a receiver is synchronized again after the next 0x00. WIRE.md describes
 * every byte.
 *
 *     uint8_t wire[LOFT_FRAME_MAX];
 *     wire[1] = 0x71; wire[2] = session;                   // the content starts at wire[1]
 *     write(wire, loft_frame_encode(wire, 2));
 *
 *     if (loft_frame_push(&f, byte) == LOFT_OK)            // f.byte[0..f.count-1] is the content
 *         take(f.byte, f.count);
 */
#ifndef LOFT_WIRE_FRAME_H
#define LOFT_WIRE_FRAME_H

#include "num/num.h"    /* enum loft_status, the integer types */

LOFT_BEGIN_C

#define LOFT_FRAME_EXTRA    6                                   /* CRC 4, COBS 1, delimiter 1 */
#define LOFT_FRAME_CONTENT  (LOFT_FRAME_MAX - LOFT_FRAME_EXTRA) /* the largest content of a frame */

/* A frame being received. `byte` and `count` are the content after LOFT_OK, until the next push.
 * They are valid after LOFT_ERR_DATA as well if count > 0: the frame is then complete, but its CRC
 * is wrong or sealed. */
typedef struct {
    uint32_t crc, odd;                      /* odd: error of the last frame's CRC; 0: LOFT_OK */
    uint8_t  count;                         /* bytes of content */
    uint8_t  size;                          /* bytes received so far, CRC included */
    uint8_t  left;                          /* bytes until the next COBS code; 0: a code is next */
    uint8_t  flags;
    uint8_t  byte[LOFT_FRAME_CONTENT + 4];
} loft_frame;


// Receiving
// ---------

/* Prepare to receive. Bytes up to the first 0x00 may be the tail of a frame. They are refused, not
 * misread. */
void loft_frame_init(loft_frame *f);

/* Take one byte from the line.
 *
 *   shape   LOFT_MORE inside a frame; LOFT_OK at the end of a good one; LOFT_ERR_DATA at the end of
 *           a bad one (damaged, cut, too long). A delimiter after no byte is LOFT_MORE: any number
 *           of 0x00 may separate frames
 *   error   a damaged frame passes with probability 2^-32. A frame damaged only by one or two
 *           flipped bits, or by one byte lost, doubled or inserted, never passed in an exhaustive
 *           test of full frames
 *   cost    one CRC step: 2 table look-ups of 64 bytes in all; no loop over the frame; safe in an
 *           ISR
 *   see     S. Cheshire, M. Baker: Consistent Overhead Byte Stuffing, 1999
 */
enum loft_status loft_frame_push(loft_frame *f, uint8_t byte) LOFT_CHECKED;


// Sending
// -------

/* Finish the frame whose content is wire[1] .. wire[count], in place. Returns its length, count +
 * LOFT_FRAME_EXTRA.
 *
 *   range   2 <= count <= LOFT_FRAME_CONTENT; otherwise it returns 0 and writes nothing
 *   cost    one CRC step per byte
 */
size_t loft_frame_encode(uint8_t wire[LOFT_FRAME_MAX], size_t count);

/* The same with a seal: only a receiver that knows the seal can accept the frame. The seal is not
 * sent; it is combined with the CRC by exclusive or. Seal 0 is loft_frame_encode. */
size_t loft_frame_seal(uint8_t wire[LOFT_FRAME_MAX], size_t count, uint32_t seal);

/* True if the last frame that loft_frame_push ended (count > 0) is good, with this seal.
 *
 *   error   a damaged or otherwise sealed frame passes with probability 2^-32
 *   cost    4 CRC steps
 */
bool loft_frame_sealed(const loft_frame *f, uint32_t seal);

/* Add one byte to a CRC-32C (Castagnoli, reflected 0x82F63B78), without initial or final
 * inversion. */
uint32_t loft_crc(uint32_t crc, uint8_t byte);

/* Add the four bytes of x, low byte first. */
uint32_t loft_crc32(uint32_t crc, uint32_t x);

LOFT_END_C

#endif
