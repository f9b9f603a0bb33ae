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

/* A machine that never plans takes no curves: 750 bytes of an AVR. */
static bool is_curve(enum loft_kind kind) { return LOFT_MACHINE_PLANS > 0 && kind == LOFT_CURVES; }

static bool is_point(enum loft_kind kind)
{
    return kind == LOFT_POINTS || kind == LOFT_POINTS_FINE;
}

/* A part of a patch among curves. */
static bool is_part(enum loft_kind kind, const loft_item *item)
{
    return is_curve(kind) && item->ticks == 0;
}

/* An action among spans. After it there is no change, for its points inside are none. */
static bool is_action(enum loft_kind kind, const loft_item *item)
{
    return LOFT_MACHINE_OUTPUTS > 0 && kind == LOFT_SPANS && item->ticks == 0;
}

static void add_to(uint32_t sum[LOFT_AXES], const uint32_t x[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++)
        sum[i] += x[i];
}

/* Move on by `change`. */
static void move_on(loft_predictor *p, int32_t out[LOFT_AXES])
{
    add_to(p->position, p->change);
    for (int i = 0; i < LOFT_AXES; i++)
        out[i] = loft_word_signed(p->position[i]);
}

void loft_predictor_init(loft_predictor *p, const int32_t start[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++) {
        p->position[i] = (uint32_t)start[i];
        p->change[i]   = p->bend[i] = 0;
    }
    p->ticks = 0;
}

void loft_predictor_next(loft_predictor *p, enum loft_kind kind, const loft_item *item)
{
    const bool point = is_point(kind), action = is_action(kind, item), part = is_part(kind, item);

    for (int i = 0; i < LOFT_AXES; i++) {
        const uint32_t p1 = (uint32_t)item->p[0][i], p2 = (uint32_t)item->p[1][i];
        const uint32_t p3 = (uint32_t)item->p[2][i], last = p->change[i];
        const uint32_t change = action ? 0 : part ? p2 - p3 : p3 - (point ? p->position[i] : p2);
        p->position[i] = p3;
        p->change[i]   = change;
        p->bend[i] = point ? change - last : kind == LOFT_SPANS && !action ? change - (p2 - p1) : 0;
    }
    if (!point)
        p->ticks = part ? 1 : item->ticks;
}

uint32_t loft_predictor_seal(const loft_predictor *p)
{
    uint32_t crc = 0xFFFFFFFFu;
    for (int i = 0; i < LOFT_AXES; i++) {
        crc = loft_crc32(crc, p->position[i]);
        crc = loft_crc32(crc, p->change[i]);
        crc = loft_crc32(crc, p->bend[i]);
    }
    return loft_crc32(crc, p->ticks);
}


// Spans: ticks, and which differences are not as expected; then these
// -------------------------------------------------------------------
//
// Where velocity and acceleration go on from one span to the next, p1 and p2 follow from the span
// before: in m times its ticks change becomes m times and bend m^2 times as large. So a span of a
// C2 spline is its jerk alone, one number for each axis, as a control point would be; and what is
// no such spline costs a few bytes more.
//
//     r1 = (p1 - p0) - change'            change': change * ticks / those of the last, rounded
//     r2 = (p2 - 2 p1 + p0) - bend'       bend': the same of bend, twice
//     e3 = p3 - 3 p2 + 3 p1 - p0
//
// each modulo 2^32, products too: so a prediction may be bad, and is still the same at both ends.
// In a plan r1 is not 0 in one of three axes, since coordinates are rounded to 2^-16 mm.

/* Bits of the form: for all axes e3, then r2, then r1. The frequent ones are low, so that a varint
 * has one byte. */
#define FORM_BITS (3 * LOFT_AXES)

/* Differences in another number of ticks, to nearest. */
static void stretch(uint32_t difference[LOFT_AXES], uint16_t ticks, uint16_t before)
{
    for (int i = 0; i < LOFT_AXES; i++) {
        const bool negative = difference[i] & 0x80000000u;
        uint32_t size = negative ? 0u - difference[i] : difference[i];

        size          = (size * ticks + before / 2u) / before;
        difference[i] = negative ? 0u - size : size;
    }
}

/* Expect a span of `ticks`. Before the first span and after an action all differences are 0, and so
 * are the ticks. */
static void expect_ticks(loft_predictor *p, uint16_t ticks)
{
    if (p->ticks != 0 && p->ticks != ticks) {
        stretch(p->change, ticks, p->ticks);
        stretch(p->bend, ticks, p->ticks);
        stretch(p->bend, ticks, p->ticks);
    }
    p->ticks = ticks;
}

static uint8_t put_span(uint8_t *byte, const loft_predictor *p, const loft_item *item)
{
    uint32_t rest[FORM_BITS], form = 0;
    loft_predictor to = *p;

    expect_ticks(&to, item->ticks);
    for (int i = 0; i < LOFT_AXES; i++) {
        const uint32_t p0 = p->position[i],          p1 = (uint32_t)item->p[0][i];
        const uint32_t p2 = (uint32_t)item->p[1][i], p3 = (uint32_t)item->p[2][i];
        rest[i]                 = p3 - 3u*p2 + 3u*p1 - p0;
        rest[LOFT_AXES + i]     = p2 - 2u*p1 + p0 - to.bend[i];
        rest[2 * LOFT_AXES + i] = p1 - p0 - to.change[i];
    }
    for (int k = 0; k < FORM_BITS; k++)
        form |= (uint32_t)(rest[k] != 0) << k;

    uint8_t n = loft_varint_encode(byte, item->ticks);
    n = (uint8_t)(n + loft_varint_encode(byte + n, form));
    for (int k = 0; k < FORM_BITS; k++)
        if (rest[k] != 0)
            n = (uint8_t)(n + loft_residual_encode(byte + n, rest[k]));
    return n;
}

/* The second difference is bend at p0, and bend + e3 at p3: adding them up gives the points, and
 * what the next prediction needs. */
static const uint8_t *get_span(const uint8_t *byte, loft_predictor *p, loft_item *item)
{
    uint32_t e3[LOFT_AXES] = { 0 }, *const to[3] = { e3, p->bend, p->change };

    item->ticks = (uint16_t)loft_varint_decode(&byte);
    expect_ticks(p, item->ticks);
    uint32_t form = loft_varint_decode(&byte);
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < LOFT_AXES; i++, form >>= 1)
            if (form & 1u)
                to[k][i] += loft_residual_decode(&byte);

    for (int k = 0; k < 3; k++) {
        if (k == 2)
            add_to(p->bend, e3);
        if (k > 0)
            add_to(p->change, p->bend);
        move_on(p, item->p[k]);
    }
    return byte;
}

/* The length of the span at byte[0]; 0 if it is not valid, or not the shortest form. */
static uint8_t span_size(const uint8_t *byte, uint8_t left)
{
    const uint8_t *at = byte;
    if (LOFT_MACHINE_OUTPUTS > 0 && left > 0 && *byte == 0)
        return loft_action_size(byte, left);
    uint8_t size = loft_varint_size(byte, left);
    if (size == 0 || size > 2)
        return 0;
    const uint32_t ticks = loft_varint_decode(&at);
    const uint8_t n = loft_varint_size(at, (uint8_t)(left - size));
    if (ticks < 1 || ticks > LOFT_SPAN_TICKS_MAX || n == 0)
        return 0;
    const uint32_t form = loft_varint_decode(&at);
    size = (uint8_t)(size + n);
    if (form >> FORM_BITS != 0)
        return 0;
    for (uint32_t bits = form; bits != 0; bits >>= 1) {
        if (!(bits & 1u))
            continue;
        const uint8_t more = loft_varint_size(byte + size, (uint8_t)(left - size));
        if (more == 0 || byte[size] == 0)
            return 0;
        size = (uint8_t)(size + more);
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
                                loft_predictor *p, loft_item *item)
{
    uint32_t r[LOFT_AXES] = { 0 };

    if (!still)
        byte = loft_point_decode(byte, r);
    for (int i = 0; i < LOFT_AXES; i++) {
        item->p[0][i] = item->p[1][i] = 0;
        p->bend[i] = r[i] + (kind == LOFT_POINTS_FINE ? p->bend[i] : 0);
    }
    add_to(p->change, p->bend);
    move_on(p, item->p[2]);
    item->ticks = 1;
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
    return kind == LOFT_CURVES     ? loft_curve_encode(byte, p, item)
           : is_action(kind, item) ? loft_action_encode(byte, p, item)
           : kind == LOFT_SPANS    ? put_span(byte, p, item)
                                   : put_point(byte, kind, p, item);
}

#define MOST_BYTES (LOFT_ITEM_BYTES > LOFT_CURVE_BYTES ? LOFT_ITEM_BYTES : LOFT_CURVE_BYTES)

enum loft_status loft_packer_push(loft_packer *p, const loft_item *item)
{
    const enum loft_kind kind = (enum loft_kind)p->kind;
    const bool still = is_point(kind) && point_is_still(kind, &p->predictor, item);
    uint8_t byte[MOST_BYTES], n;

    if ((item->ticks < 1 && !is_action(kind, item) &&
         !(is_curve(kind) && loft_curve_is_part(&p->predictor, item))) ||
        item->ticks > max_ticks(kind))
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
    return is_curve(kind)       ? loft_curve_size(byte, left)
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
        const bool action = LOFT_MACHINE_OUTPUTS > 0 && *u->byte == 0;
        u->byte = action ? loft_action_decode(u->byte, predictor, out)
                         : get_span(u->byte, predictor, out);
    } else if (is_curve((enum loft_kind)u->kind)) {
        u->byte = loft_curve_decode(u->byte, predictor, out);
    } else {
        if (u->run == 0 && *u->byte >= LOFT_POINT_RUN)
            u->run = (uint8_t)(*u->byte++ - 127);
        u->byte = get_point(u->byte, u->run > 0, (enum loft_kind)u->kind, predictor, out);
        if (u->run > 0)
            u->run--;
    }
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
