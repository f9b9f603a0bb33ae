/* lib/wire/codec.c -- prediction, and the encoding of residuals
 * SPDX-License-Identifier: MIT
 */
#include "wire/codec.h"

#include "wire/action_code.h"   /* loft_action_encode */
#include "wire/curve_code.h"    /* loft_curve_encode */
#include "wire/point_code.h"    /* loft_point_encode */
#include "wire/varint.h"        /* loft_varint_encode */

/* All differences are unsigned, modulo 2^32. So nothing overflows, and every int32 is restored
 * exactly. */

static bool is_point(enum loft_kind kind)
{
    return kind == LOFT_POINTS || kind == LOFT_POINTS_FINE;
}

/* An action among spans. After it there is no change, for its points inside are none. */
static bool is_action(enum loft_kind kind, const loft_item *item)
{
    return LOFT_MACHINE_OUTPUTS > 0 && kind == LOFT_SPANS && item->ticks == 0;
}

void loft_predictor_init(loft_predictor *p, const int32_t start[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++) {
        p->position[i] = (uint32_t)start[i];
        p->change[i]   = p->bend[i] = 0;
    }
}

void loft_predictor_next(loft_predictor *p, enum loft_kind kind, const loft_item *item)
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const uint32_t before = is_point(kind)     ? p->position[i]
                                : is_action(kind, item) ? (uint32_t)item->p[2][i]
                                                        : (uint32_t)item->p[1][i];
        const uint32_t change = p->change[i];
        p->position[i] = (uint32_t)item->p[2][i];
        p->change[i]   = p->position[i] - before;
        p->bend[i]     = is_point(kind) ? p->change[i] - change : 0;
    }
    if (kind == LOFT_CURVES)
        p->bend[0] = item->ticks;
}

uint32_t loft_predictor_seal(const loft_predictor *p)
{
    uint32_t crc = 0xFFFFFFFFu;
    for (int i = 0; i < LOFT_AXES; i++) {
        crc = loft_crc32(crc, p->position[i]);
        crc = loft_crc32(crc, p->change[i]);
        crc = loft_crc32(crc, p->bend[i]);
    }
    return crc;
}


// Spans: ticks, then three residuals per axis
// -------------------------------------------

/* e1 = (p1 - p0) - change     the jump of the velocity: 0 in a smooth chain of equal spans
 * e2 = p2 - 2 p1 + p0         acceleration
 * e3 = p3 - 3 p2 + 3 p1 - p0  jerk
 *
 * each modulo 2^32. The three equations have a unit diagonal, so p1, p2, p3 are restored
 * exactly. */
static uint8_t put_span(uint8_t *byte, const loft_predictor *p, const loft_item *item)
{
    if (is_action(LOFT_SPANS, item))
        return loft_action_encode(byte, p, item);
    uint8_t n = loft_varint_encode(byte, item->ticks);
    for (int i = 0; i < LOFT_AXES; i++) {
        const uint32_t p0 = p->position[i],          p1 = (uint32_t)item->p[0][i];
        const uint32_t p2 = (uint32_t)item->p[1][i], p3 = (uint32_t)item->p[2][i];
        n = (uint8_t)(n + loft_residual_encode(byte + n, p1 - p0 - p->change[i]));
        n = (uint8_t)(n + loft_residual_encode(byte + n, p2 - 2u*p1 + p0));
        n = (uint8_t)(n + loft_residual_encode(byte + n, p3 - 3u*p2 + 3u*p1 - p0));
    }
    return n;
}

static const uint8_t *get_span(const uint8_t *byte, const loft_predictor *p, loft_item *item)
{
    if (LOFT_MACHINE_OUTPUTS > 0 && *byte == 0)
        return loft_action_decode(byte, p, item);
    item->ticks = (uint16_t)loft_varint_decode(&byte);
    for (int i = 0; i < LOFT_AXES; i++) {
        const uint32_t p0 = p->position[i];
        const uint32_t p1 = loft_residual_decode(&byte) + p0 + p->change[i];
        const uint32_t p2 = loft_residual_decode(&byte) + 2u*p1 - p0;
        const uint32_t p3 = loft_residual_decode(&byte) + 3u*(p2 - p1) + p0;
        item->p[0][i] = loft_word_signed(p1);
        item->p[1][i] = loft_word_signed(p2);
        item->p[2][i] = loft_word_signed(p3);
    }
    return byte;
}

/* The length of the span at byte[0]; 0 if it is not valid. */
static uint8_t span_size(const uint8_t *byte, uint8_t left)
{
    const uint8_t *at = byte;
    if (LOFT_MACHINE_OUTPUTS > 0 && left > 0 && *byte == 0)
        return loft_action_size(byte, left);
    uint8_t size = loft_varint_size(byte, left);
    if (size == 0 || size > 2)
        return 0;
    const uint32_t ticks = loft_varint_decode(&at);
    if (ticks < 1 || ticks > LOFT_SPAN_TICKS_MAX)
        return 0;
    for (uint8_t i = 0; i < 3 * LOFT_AXES; i++) {
        const uint8_t n = loft_varint_size(byte + size, (uint8_t)(left - size));
        if (n == 0)
            return 0;
        size = (uint8_t)(size + n);
    }
    return size;
}


// Points: the second or third difference of each axis, typically -2..2
// --------------------------------------------------------------------
//
// Rounding to steps makes noise that grows with each difference (its variance is C(2k, k) / 12).
// Where the motion is smooth in steps, the second difference is the shortest. In fine units or with
// coarse sampling it is the third.

/* The predicted position. */
static uint32_t predicted_position(enum loft_kind kind, const loft_predictor *p, int i)
{
    return p->position[i] + p->change[i] + (kind == LOFT_POINTS_FINE ? p->bend[i] : 0);
}

static uint8_t put_point(uint8_t *byte, enum loft_kind kind, const loft_predictor *p,
                         const loft_item *item)
{
    uint32_t r[LOFT_AXES];
    for (int i = 0; i < LOFT_AXES; i++)
        r[i] = (uint32_t)item->p[2][i] - predicted_position(kind, p, i);
    return loft_point_encode(byte, r);
}

/* vel += r; pos += vel */
static const uint8_t *get_point(const uint8_t *byte, bool still, enum loft_kind kind,
                                const loft_predictor *p, loft_item *item)
{
    uint32_t r[LOFT_AXES] = { 0 };

    item->ticks = 1;
    if (!still)
        byte = loft_point_decode(byte, r);
    for (int i = 0; i < LOFT_AXES; i++) {
        item->p[0][i] = item->p[1][i] = 0;
        item->p[2][i] = loft_word_signed(predicted_position(kind, p, i) + r[i]);
    }
    return byte;
}


// Packing
// -------

void loft_packer_init(loft_packer *p, enum loft_kind kind, const loft_predictor *predictor,
                      uint8_t *byte, uint8_t room)
{
    p->predictor = *predictor;
    p->byte  = byte;
    p->kind  = (uint8_t)kind;
    p->room  = room;
    p->size  = 0;
    p->count = 0;
    p->run   = false;
}

static bool point_is_still(enum loft_kind kind, const loft_predictor *p, const loft_item *item)
{
    for (int i = 0; i < LOFT_AXES; i++)
        if ((uint32_t)item->p[2][i] != predicted_position(kind, p, i))
            return false;
    return true;
}

/* Extend the run at the end by one point, or begin a run. */
static uint8_t put_run(loft_packer *p, uint8_t *byte)
{
    if (p->run && p->byte[p->size - 1] < 255u) {
        p->byte[p->size - 1]++;
        return 0;
    }
    byte[0] = LOFT_POINT_RUN;
    return 1;
}

static uint16_t max_ticks(enum loft_kind kind)
{
    return kind == LOFT_CURVES ? 0xFFFFu : kind == LOFT_SPANS ? LOFT_SPAN_TICKS_MAX : 1;
}

static uint8_t put_item(uint8_t *byte, enum loft_kind kind, const loft_predictor *p,
                        const loft_item *item)
{
    return kind == LOFT_CURVES ? loft_curve_encode(byte, p, item)
           : kind == LOFT_SPANS ? put_span(byte, p, item)
                                : put_point(byte, kind, p, item);
}

enum loft_status loft_packer_push(loft_packer *p, const loft_item *item)
{
    const enum loft_kind kind = (enum loft_kind)p->kind;
    const bool still = is_point(kind) && point_is_still(kind, &p->predictor, item);
    uint8_t byte[LOFT_CURVE_BYTES], n;

    if ((item->ticks < 1 && !is_action(kind, item)) || item->ticks > max_ticks(kind))
        return LOFT_ERR_RANGE;
    if (p->count == 255)
        return LOFT_ERR_SPACE;

    n = still ? put_run(p, byte) : put_item(byte, kind, &p->predictor, item);
    if (n > p->room - p->size)
        return LOFT_ERR_SPACE;
    for (uint8_t i = 0; i < n; i++)
        p->byte[p->size++] = byte[i];

    p->run = still;
    p->count++;
    loft_predictor_next(&p->predictor, kind, item);
    return LOFT_OK;
}


// Unpacking
// ---------

static uint8_t item_size(enum loft_kind kind, const uint8_t *byte, uint8_t left)
{
    return kind == LOFT_CURVES  ? loft_curve_size(byte, left)
           : kind == LOFT_SPANS ? span_size(byte, left)
                                : loft_point_size(byte, left);
}

enum loft_status loft_unpacker_init(loft_unpacker *u, enum loft_kind kind, const uint8_t *byte,
                                    uint8_t size, uint8_t count)
{
    uint16_t found = 0;
    for (uint8_t at = 0, n; at < size; at = (uint8_t)(at + n)) {
        const bool run = is_point(kind) && byte[at] >= LOFT_POINT_RUN;
        n = run ? 1 : item_size(kind, byte + at, (uint8_t)(size - at));
        if (n == 0)
            return LOFT_ERR_DATA;
        found = (uint16_t)(found + (run ? byte[at] - 127u : 1u));
    }
    if (found != count || count == 0)
        return LOFT_ERR_DATA;

    u->byte  = byte;
    u->kind  = (uint8_t)kind;
    u->count = count;
    u->run   = 0;
    return LOFT_OK;
}

bool loft_unpacker_next(loft_unpacker *u, loft_predictor *predictor, loft_item *out)
{
    if (u->count == 0)
        return false;
    u->count--;

    if (u->kind == LOFT_SPANS) {
        u->byte = get_span(u->byte, predictor, out);
    } else if (u->kind == LOFT_CURVES) {
        u->byte = loft_curve_decode(u->byte, predictor, out);
    } else {
        if (u->run == 0 && *u->byte >= LOFT_POINT_RUN)
            u->run = (uint8_t)(*u->byte++ - 127);
        u->byte = get_point(u->byte, u->run > 0, (enum loft_kind)u->kind, predictor, out);
        if (u->run > 0)
            u->run--;
    }
    loft_predictor_next(predictor, (enum loft_kind)u->kind, out);
    return true;
}


// Numbers of the library
// ----------------------

void loft_item_span(const loft_item *item, const int32_t from[LOFT_AXES], loft_span *out)
{
    for (int i = 0; i < LOFT_AXES; i++) {
        out->p[0].axis[i] = loft_real_from_raw(from[i]);
        for (int k = 0; k < 3; k++)
            out->p[k + 1].axis[i] = loft_real_from_raw(item->p[k][i]);
    }
    out->ticks = item->ticks;
}

enum loft_status loft_item_from_span(loft_item *item, const loft_span *span)
{
    if (span->ticks < 1 || span->ticks > LOFT_SPAN_TICKS_MAX)
        return LOFT_ERR_RANGE;
    for (int i = 0; i < LOFT_AXES; i++)
        for (int k = 0; k < 3; k++) {
            if (!loft_raw_valid(span->p[k + 1].axis[i]))
                return LOFT_ERR_RANGE;
            item->p[k][i] = loft_raw_from_real(span->p[k + 1].axis[i]);
        }
    item->ticks = span->ticks;
    return LOFT_OK;
}
