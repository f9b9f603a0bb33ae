/* lib/wire/window.c -- items in flight: go back n
 * SPDX-License-Identifier: MIT
 *
 * Frames are made again from the items. So the frame that starts at n depends only on items n - 3
 * .. n - 1 and n .., whether it is sent for the first time, again, or by another process.
 *
 * A frame of n bytes survives with probability (1 - e)^n. On a bad line short frames arrive where
 * long ones never do. So a loss shortens frames by a quarter, and each frame that arrives lengthens
 * them by a few bytes.
 */
#include "wire/window.h"

/* The size in bytes of the shortest frame that holds any curve. */
#define CURVE_LEAST (15 + 15 * LOFT_AXES)

void loft_window_init(loft_window *w, const loft_job *job, uint32_t count, loft_item_source *source,
                      void *context)
{
    *w = (loft_window){
        .source = source, .context = context, .count = count, .kind = (uint8_t)job->kind
    };
    w->known = count == LOFT_ITEMS_OPEN ? 0 : count;
    for (int i = 0; i < LOFT_AXES; i++)
        w->start[i] = job->start[i];
}

void loft_window_extend(loft_window *w, uint32_t known, uint32_t count)
{
    w->known = known;
    w->count = count;
}

void loft_window_open(loft_window *w, uint32_t next, uint8_t frame_most)
{
    w->base = w->send = w->high = next;
    w->frame_most = w->frame_size = frame_most;
    w->flights = 0;
    w->ended   = false;
}

void loft_window_back(loft_window *w)
{
    w->send    = w->base;
    w->flights = 0;
    w->ended   = false;
}

void loft_window_shrink(loft_window *w)
{
    const uint8_t size  = (uint8_t)(w->frame_size - w->frame_size / 4);
    const uint8_t least = w->kind == LOFT_CURVES ? CURVE_LEAST : LOFT_WINDOW_MIN;
    w->frame_size = size > least ? size : least;
}

static void grow_frame(loft_window *w)
{
    w->frame_size = w->frame_most - w->frame_size > 4 ? (uint8_t)(w->frame_size + 4)
                                                      : w->frame_most;
}

/* Only frames sent once give a round trip. The answer to a repeated frame may belong to either (P.
 * Karn, C. Partridge, 1987). */
bool loft_window_take(loft_window *w, uint32_t next, uint32_t now_ms, uint32_t *trip)
{
    bool timed = false;

    w->base = next;
    w->send = w->send < next ? next : w->send;
    while (w->flights > 0 && w->flight[w->first].end <= next) {
        timed = !w->flight[w->first].again;
        *trip = now_ms - w->flight[w->first].time;
        w->first = (uint8_t)((w->first + 1) % LOFT_WINDOW_FRAMES);
        w->flights--;
        grow_frame(w);
    }
    return timed;
}

/* One frame too many is cheaper than a frame of one item after each executed item. With little
 * room, wait until the machine has reported `step` of it, which it does unasked. Exceptions: these
 * are all known items, or they are sent again. */
bool loft_window_ready(const loft_window *w, uint32_t limit, uint32_t step)
{
    const uint32_t most = limit < w->known ? limit : w->known;

    return w->flights < LOFT_WINDOW_FRAMES && w->send < most &&
           (most == w->known || w->send < w->high || most - w->send >= step);
}

static void predict_next(const loft_window *w, loft_predictor *p)
{
    loft_item item;
    loft_predictor_init(p, w->start);
    for (uint32_t back = w->send < LOFT_PREDICTOR_BACK ? w->send : LOFT_PREDICTOR_BACK; back > 0;
         back--) {
        w->source(w->context, w->send - back, &item);
        loft_predictor_next(p, (enum loft_kind)w->kind, &item);
    }
}

/* Pack as many items as fit and may be sent. */
static void pack_items(const loft_window *w, uint32_t limit, enum loft_kind kind,
                       const loft_predictor *predictor, loft_packer *p, uint8_t wire[])
{
    const uint32_t most = limit < w->known ? limit : w->known;
    enum loft_status status = LOFT_OK;
    loft_item item;

    loft_data_init(p, kind, predictor, w->frame_size, wire);
    while (w->send + p->count < most && status == LOFT_OK) {
        w->source(w->context, w->send + p->count, &item);
        status = loft_packer_push(p, &item);
    }
}

/* Pack points by third differences if that is shorter for this frame. */
static void pack_shortest(const loft_window *w, uint32_t limit, const loft_predictor *predictor,
                          loft_packer *p, uint8_t wire[])
{
    const enum loft_kind kind = (enum loft_kind)w->kind;
    loft_packer fine;

    pack_items(w, limit, kind, predictor, p, wire);
    if (kind != LOFT_POINTS)
        return;
    pack_items(w, limit, LOFT_POINTS_FINE, predictor, &fine, wire);
    if (fine.count * p->size > p->count * fine.size)
        *p = fine;
    else
        pack_items(w, limit, kind, predictor, p, wire);
}

size_t loft_window_give(loft_window *w, uint32_t limit, uint8_t session, uint32_t now_ms,
                        uint8_t wire[LOFT_FRAME_MAX])
{
    const uint32_t first = w->send;
    loft_predictor predictor;
    loft_packer p;

    predict_next(w, &predictor);
    const uint32_t seal = loft_predictor_seal(&predictor);
    pack_shortest(w, limit, &predictor, &p, wire);
    if (p.count == 0)
        return 0;

    const uint8_t slot = (uint8_t)((w->first + w->flights++) % LOFT_WINDOW_FRAMES);
    w->send = w->flight[slot].end = first + p.count;
    w->flight[slot].time  = now_ms;
    w->flight[slot].again = first < w->high;
    w->high = w->high < w->send ? w->send : w->high;
    return loft_data_encode(&p, first, seal, session, wire);
}
