/* lib/wire/codec.h -- items of a job as few bytes: each is sent as its difference from a prediction
 * SPDX-License-Identifier: MIT
 *
 * A job is a row of items, numbered from 0, of one kind:
 *
 *   spans     a cubic in time per axis, in mm as raw Q16.16, for a whole number of ticks
 *   points    a place in machine steps, one per tick: their second differences, or, in fine units,
 *             their third
 *   curves    a cubic in mm as raw Q16.16 and a feed, for a machine that plans
 *
 * Both ends keep the same predictor: where the item before ended and how it was moving. Everything
 * is integer arithmetic modulo 2^32, so any int32 coordinates come out as they went in, on every
 * machine and number type.
 */
#ifndef LOFT_WIRE_CODEC_H
#define LOFT_WIRE_CODEC_H

#include "motion/span.h"    /* loft_span, LOFT_SPAN_TICKS_MAX */
#include "wire/frame.h"     /* loft_crc */

LOFT_BEGIN_C

enum loft_kind {
    LOFT_SPANS  = 1,
    LOFT_POINTS = 2,
    LOFT_POINTS_FINE = 3,   /* how points may be packed: by third differences. A job of them is of
                             * kind LOFT_POINTS */
    LOFT_CURVES = 4
};

/* One item. Where it begins is where the one before ended, so a span's p0 is not in it. */
typedef struct {
    int32_t  p[3][LOFT_AXES];   /* spans, curves: p1 p2 p3, raw Q16.16 mm; points: p[2] is the place
                                 * in steps, p[0] and p[1] are 0 */
    uint16_t ticks;             /* spans: 1..LOFT_SPAN_TICKS_MAX; points: 1; curves: the feed,
                                 * 1..65535 mm/min */
} loft_item;

/* Bytes that a span or a point takes at the most (a curve: curve_code.h): residuals of five bytes;
 * and what a frame must have room for. */
#define LOFT_ITEM_BYTES (2 + 15 * LOFT_AXES)
#if LOFT_FRAME_MAX < 13 + 15 * LOFT_AXES
#  error "a frame must hold the largest item: LOFT_FRAME_MAX must be at least 13 + 15 * LOFT_AXES"
#endif

/* The predictor: what both ends know before an item. */
typedef struct {
    uint32_t position[LOFT_AXES];       /* where the item before ended */
    uint32_t change[LOFT_AXES];         /* spans, curves: its p3 - p2; points: its step from the one
                                         * before */
    uint32_t bend[LOFT_AXES];           /* points: by what the step has changed; curves: its feed in
                                         * bend[0]; else 0 */
} loft_predictor;

/* Items on their way into bytes. */
typedef struct {
    loft_predictor predictor;
    uint8_t *byte;
    uint8_t  kind, room, size, count;   /* size bytes hold count items */
    bool     run;                       /* the last byte is a run      */
} loft_packer;

/* Bytes on their way into items. */
typedef struct {
    const uint8_t *byte;
    uint8_t kind, count, run;           /* count items still to come; run of them are still */
} loft_unpacker;


// The predictor
// -------------

/* Before item 0: at rest at `start`. */
void loft_predictor_init(loft_predictor *p, const int32_t start[LOFT_AXES]);

#define LOFT_PREDICTOR_BACK 3

/* After `item`. The state before item n depends on items n - 1 .. n - LOFT_PREDICTOR_BACK alone
 * (and on the start). */
void loft_predictor_next(loft_predictor *p, enum loft_kind kind, const loft_item *item);

/* What seals a frame whose first item this predicts: a CRC-32C of all its numbers.
 *
 *   error   two states that differ agree with probability 2^-32
 *   cost    12 LOFT_AXES CRC steps
 */
uint32_t loft_predictor_seal(const loft_predictor *p);


// Packing
// -------

/* Prepare to pack items of one kind into `byte`, at most `room` bytes (to 255); `predictor` is
 * copied. */
void loft_packer_init(loft_packer *p, enum loft_kind kind, const loft_predictor *predictor,
                      uint8_t *byte, uint8_t room);

/* Append one item.
 *
 *   shape   LOFT_OK and p->size, p->count have grown; LOFT_ERR_SPACE: no room, nothing has changed
 *   range   any coordinates; ticks as in loft_item, otherwise LOFT_ERR_RANGE
 *   error   none
 */
enum loft_status loft_packer_push(loft_packer *p, const loft_item *item) LOFT_CHECKED;


// Unpacking
// ---------

/* Prepare to unpack; looks through all bytes first, so that a bad row of items is refused before
 * its first item.
 *
 *   shape   LOFT_OK if `size` bytes are exactly `count` items within their ranges; otherwise
 *           LOFT_ERR_DATA
 *   cost    one pass over the bytes; `byte` is borrowed until the last item
 */
enum loft_status loft_unpacker_init(loft_unpacker *u, enum loft_kind kind, const uint8_t *byte,
                                    uint8_t size, uint8_t count) LOFT_CHECKED;

/* Give the next item and move the predictor past it. Returns false when there are no more.
 *
 *   cost    additions and shifts only
 */
bool loft_unpacker_next(loft_unpacker *u, loft_predictor *predictor, loft_item *out);


// Numbers of the library
// ----------------------

/* The span of `item` that begins at `from` (raw Q16.16 mm: p[2] of the item before, or the job's
 * start).
 *
 *   error   q16: none   f32: 1/2 ulp   f64: none
 */
void loft_item_span(const loft_item *item, const int32_t from[LOFT_AXES], loft_span *out);

/* The item of `span`: the nearest raw Q16.16. Its p[0] is not looked at.
 *
 *   range   |coordinates| < 32768, 1 <= ticks <= LOFT_SPAN_TICKS_MAX; otherwise LOFT_ERR_RANGE
 *   error   q16: none   f32, f64: 2^-17 mm
 */
enum loft_status loft_item_from_span(loft_item *item, const loft_span *span) LOFT_CHECKED;

LOFT_END_C

#endif
