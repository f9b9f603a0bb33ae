/* lib/wire/window.h -- items on their way: a few frames at a time, and back to what was not
 * acknowledged
 * SPDX-License-Identifier: MIT
 *
 *     base <= send <= high        acknowledged, next to be sent, never sent yet
 *
 * What calls for going back, and how many items the machine has room for, is the caller's to know
 * (wire/sender.h).
 */
#ifndef LOFT_WIRE_WINDOW_H
#define LOFT_WIRE_WINDOW_H

#include "wire/job_id.h"    /* loft_item_source */
#include "wire/message.h"   /* loft_job, LOFT_FRAME_MAX */

LOFT_BEGIN_C

#define LOFT_WINDOW_FRAMES  8                   /* on their way at most */
/* bytes of the shortest frame that holds any span or point */
#define LOFT_WINDOW_LEAST   (13 + 15 * LOFT_AXES)

typedef struct {
    loft_item_source *source;
    void    *context;
    uint32_t count;                             /* items of the job, LOFT_ITEMS_OPEN until that is
                                                 * known */
    uint32_t known;                             /* of them, those that `source` can give by now */
    int32_t  start[LOFT_AXES];                  /* where it starts, as in loft_job */
    uint8_t  kind;                              /* enum loft_kind */
    uint32_t base, send, high;
    struct {
        uint32_t end, time;
        bool again;
    } flight[LOFT_WINDOW_FRAMES];
    uint8_t  flights, first;                    /* frames on their way; the slot of the oldest */
    uint8_t  frame_most, frame_size;            /* the longest frame at all, and for now: shorter
                                                 * ones survive more damage */
    bool     ended;                             /* END was sent behind all items */
} loft_window;

/* Items 0 .. count - 1 of `job` come from `source`; what is needed of the job is copied. `count`
 * may be LOFT_ITEMS_OPEN: then none is known yet. */
void loft_window_init(loft_window *w, const loft_job *job, uint32_t count, loft_item_source *source,
                      void *context);

/* Items 0 .. known - 1 can be asked for now, no fewer than before; `count` is as in init. */
void loft_window_extend(loft_window *w, uint32_t known, uint32_t count);

/* Begin at item `next` with nothing on its way, in frames of `frame_most` bytes at most,
 * LOFT_WINDOW_LEAST or more. */
void loft_window_open(loft_window *w, uint32_t next, uint8_t frame_most);

/* Everything before `next` has arrived, base < next <= count. True if that measured a round trip:
 * *trip, in ms. */
bool loft_window_take(loft_window *w, uint32_t next, uint32_t now_ms, uint32_t *trip);

/* Send again from base on. */
void loft_window_back(loft_window *w);

/* The line damages frames: make shorter ones. */
void loft_window_shrink(loft_window *w);

/* Is there a frame to be sent, if the machine takes items before `limit`, and new ones rather
 * `step` at a time? */
bool loft_window_ready(const loft_window *w, uint32_t limit, uint32_t step);

/* Give the next frame, ready to be sent; its size, 0 if its first item cannot be said on the wire.
 *
 *   range   send < limit, and less than LOFT_WINDOW_FRAMES on their way
 *   cost    packs the items; points twice or three times, for the shorter of their two forms
 */
size_t loft_window_give(loft_window *w, uint32_t limit, uint8_t session, uint32_t now_ms,
                        uint8_t wire[LOFT_FRAME_MAX]);

LOFT_END_C

#endif
