/* lib/wire/codec.h -- items of a job in few bytes: each is sent as its difference from a prediction
 * SPDX-License-Identifier: MIT
 *
 * A job is a row of items of one kind, numbered from 0:
 *
 *   spans     a cubic in time per axis, in mm as raw Q16.16, for a whole number of ticks: its jerk,
 *             where velocity and acceleration go on; among them actions (action_code.h)
 *   points    a position in machine steps, one per tick: its second difference or, in fine units,
 *             its third
 *   curves    a cubic in mm as raw Q16.16 and a feed, for a machine that plans; after them the
 *             parts of a patch (patch_code.h)
 *
 * Both ends keep the same predictor: where the last item ended and how it was moving. All
 * arithmetic is integer, modulo 2^32. So any int32 coordinates are restored exactly, on every
 * machine and in every number type.
 */
#ifndef LOFT_WIRE_CODEC_H
#define LOFT_WIRE_CODEC_H

#include "motion/span.h"    /* loft_span, LOFT_SPAN_TICKS_MAX */
#include "wire/frame.h"     /* loft_crc */

LOFT_BEGIN_C

enum loft_kind {
    LOFT_SPANS  = 1,
    LOFT_POINTS = 2,
    LOFT_POINTS_FINE = 3,   /* points packed by third differences, in a job of kind LOFT_POINTS */
    LOFT_CURVES = 4
};

/* One item. It begins where the last one ended, so a span's p0 is not part of it. */
typedef struct {
    int32_t  p[3][LOFT_AXES];   /* spans, curves: p1 p2 p3, raw Q16.16 mm; points: p[2] in steps,
                                 * p[0] and p[1] are 0 */
    uint16_t ticks;             /* spans: 1..LOFT_SPAN_TICKS_MAX, 0: an action, of one tick; points:
                                 * 1; curves: the feed, 1..65535 mm/min, 0: a part of a patch */
} loft_item;

/* The ticks that a span or a point lasts. */
static inline uint16_t loft_item_lasts(const volatile loft_item *item)
{
    const uint16_t ticks = item->ticks;

    return LOFT_MACHINE_OUTPUTS > 0 && ticks == 0 ? 1 : ticks;
}

/* The largest size of a span or a point in bytes: ticks, form, residuals of five bytes (curves:
 * curve_code.h). A frame must have room for it. */
#define LOFT_ITEM_BYTES (2 + (3 * LOFT_AXES + 6) / 7 + 15 * LOFT_AXES)
#if LOFT_FRAME_MAX < 14 + 16 * LOFT_AXES
#  error "a frame must hold the largest item: LOFT_FRAME_MAX must be at least 14 + 16 * LOFT_AXES"
#endif

/* The predictor: the state that both ends know before an item. */
typedef struct {
    uint32_t position[LOFT_AXES];       /* the end of the last item */
    uint32_t change[LOFT_AXES];         /* spans, curves: its p3 - p2; points: its step; parts of a
                                         * patch: its p2 - p3 */
    uint32_t bend[LOFT_AXES];           /* spans: its p3 - 2 p2 + p1; points: the change of the
                                         * step; curves: 0 */
    uint16_t ticks;                     /* spans: its ticks; curves: its feed, after a part of a
                                         * patch 1; points: 0 */
} loft_predictor;

/* A packer: items become bytes. */
typedef struct {
    loft_predictor predictor;
    uint8_t *byte;
    uint8_t  kind, room, size, count;   /* size bytes hold count items */
    bool     run;                       /* the last byte is a run      */
} loft_packer;

/* An unpacker: bytes become items. */
typedef struct {
    const uint8_t *byte;
    uint8_t kind, count, run;           /* remaining items; remaining still points of a run */
} loft_unpacker;


// The predictor
// -------------

/* The state before item 0: at rest at `start`. */
void loft_predictor_init(loft_predictor *p, const int32_t start[LOFT_AXES]);

#define LOFT_PREDICTOR_BACK 3

/* The state after `item`. The state before item n depends only on the start and on items n - 1 .. n
 * - LOFT_PREDICTOR_BACK. */
void loft_predictor_next(loft_predictor *p, enum loft_kind kind, const loft_item *item);

/* The seal of a frame, from the state before its first item: a CRC-32C of all its numbers.
 *
 *   error   two different states agree with probability 2^-32
 *   cost    12 LOFT_AXES + 4 CRC steps
 */
uint32_t loft_predictor_seal(const loft_predictor *p);


// Packing
// -------

/* Prepare to pack items of one kind into `byte`, at most `room` bytes, 0..255. `predictor` is
 * copied. */
void loft_packer_init(loft_packer *p, enum loft_kind kind, const loft_predictor *predictor,
                      uint8_t *byte, uint8_t room);

/* Append one item.
 *
 *   shape   LOFT_OK: p->size and p->count have grown; LOFT_ERR_SPACE: no room, nothing has changed
 *   range   any coordinates; ticks as in loft_item, otherwise LOFT_ERR_RANGE
 *   error   none
 */
enum loft_status loft_packer_push(loft_packer *p, const loft_item *item) LOFT_CHECKED;


// Unpacking
// ---------

/* Prepare to unpack. It checks all bytes first, so that a bad row of items is refused before its
 * first item.
 *
 *   shape   LOFT_OK if `size` bytes are exactly `count` items within their ranges; otherwise
 *           LOFT_ERR_DATA
 *   cost    one pass over the bytes; `byte` is borrowed until the last item
 */
enum loft_status loft_unpacker_init(loft_unpacker *u, enum loft_kind kind, const uint8_t *byte,
                                    uint8_t size, uint8_t count) LOFT_CHECKED;

/* Give the next item and move the predictor past it. Returns false when there are no more.
 *
 *   cost    additions and shifts; for a span that lasts another time than the one before it also 3
 *           products and quotients of 32 bits per axis
 */
bool loft_unpacker_next(loft_unpacker *u, loft_predictor *predictor, loft_item *out);


// Numbers of the library
// ----------------------

/* The span of `item` that begins at `from` (raw Q16.16 mm: p[2] of the last item, or the start of
 * the job).
 *
 *   error   q16: none   f32: 1/2 ulp   f64: none
 */
void loft_item_span(const loft_item *item, const int32_t from[LOFT_AXES], loft_span *out);

/* The item of `span`, rounded to the nearest raw Q16.16. Its p[0] is not used.
 *
 *   range   |coordinates| < 32768, 1 <= ticks <= LOFT_SPAN_TICKS_MAX; otherwise LOFT_ERR_RANGE
 *   error   q16: none   f32, f64: 2^-17 mm
 */
enum loft_status loft_item_from_span(loft_item *item, const loft_span *span) LOFT_CHECKED;

LOFT_END_C

#endif
