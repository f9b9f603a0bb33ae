/* lib/wire/window.h -- items in flight: a few frames at a time, and back to the unacknowledged ones
 * SPDX-License-Identifier: MIT
 *
 *     base <= send <= high        first unacknowledged, next to send, first never sent
 *
 * The caller knows when to go back, and for how many items the machine has room (wire/sender.h).
 */
#ifndef LOFT_WIRE_WINDOW_H
#define LOFT_WIRE_WINDOW_H

#include "wire/job_id.h"    /* loft_item_source */
#include "wire/message.h"   /* loft_job, LOFT_FRAME_MAX */

LOFT_BEGIN_C

#define LOFT_WINDOW_FRAMES  8                   /* the largest number in flight */
/* The size in bytes of the shortest frame that holds any span or point. */
#define LOFT_WINDOW_MIN   (13 + 15 * LOFT_AXES)

typedef struct {
    loft_item_source *source;
    void    *context;
    uint32_t count;                             /* items of the job; LOFT_ITEMS_OPEN: not known */
    uint32_t known;                             /* the items that `source` can give by now */
    int32_t  start[LOFT_AXES];                  /* as in loft_job */
    uint8_t  kind;                              /* enum loft_kind */
    uint32_t base, send, high;
    struct {
        uint32_t end, time;
        bool again;
    } flight[LOFT_WINDOW_FRAMES];
    uint8_t  flights, first;                    /* frames in flight; the slot of the oldest */
    uint8_t  frame_most, frame_size;            /* the longest frame ever, and now: see window.c */
    bool     ended;                             /* END was sent after all items */
} loft_window;

/* Prepare for items 0 .. count - 1 of `job`, which `source` gives. The needed part of the job is
 * copied. `count` may be LOFT_ITEMS_OPEN: then no item is known yet. */
void loft_window_init(loft_window *w, const loft_job *job, uint32_t count, loft_item_source *source,
                      void *context);

/* Items 0 .. known - 1 can be requested now, no fewer than before. `count` is as in init. */
void loft_window_extend(loft_window *w, uint32_t known, uint32_t count);

/* Begin at item `next` with nothing in flight, in frames of at most `frame_most` bytes,
 * LOFT_WINDOW_MIN or more. */
void loft_window_open(loft_window *w, uint32_t next, uint8_t frame_most);

/* All items before `next` have arrived, base < next <= count. Returns true if that measured a round
 * trip: *trip, in ms. */
bool loft_window_take(loft_window *w, uint32_t next, uint32_t now_ms, uint32_t *trip);

/* Send again from `base` on. */
void loft_window_back(loft_window *w);

/* The line damages frames: make them shorter. */
void loft_window_shrink(loft_window *w);

/* True if a frame can be sent, where the machine takes items before `limit`, preferably `step` new
 * ones at a time. */
bool loft_window_ready(const loft_window *w, uint32_t limit, uint32_t step);

/* Give the next frame, ready to send. Returns its size, or 0 if its first item cannot be encoded.
 *
 *   range   send < limit, and fewer than LOFT_WINDOW_FRAMES in flight
 *   cost    packs the items; points two or three times, for the shorter of their two forms
 */
size_t loft_window_give(loft_window *w, uint32_t limit, uint8_t session, uint32_t now_ms,
                        uint8_t wire[LOFT_FRAME_MAX]);

LOFT_END_C

#endif
