/* tests/lib/wire/test_codec.c -- properties of lib/wire/codec.h
 * SPDX-License-Identifier: MIT
 */
#include <string.h>

#include "check.h"              /* CHECK, PROPERTY, BY_NUM */
#include "wire/action_code.h"   /* loft_action_item */
#include "wire/codec.h"
#include "wire/curve_code.h"    /* LOFT_CURVE_BYTES */
#include "wire/varint.h"        /* loft_varint_encode */

/* Any int32; extremes and small numbers are frequent. */
static int32_t arb_int32(arb *a)
{
    static const int32_t edge[8] = { 0,          1,          -1,
                                     INT32_MAX,  INT32_MIN,  INT32_MIN + 1,
                                     0x7fff8000, -0x40000000 };
    switch (arb_below(a, 4)) {
    case 0:  return edge[arb_below(a, 8)];
    case 1:  return (int32_t)arb_below(a, 600) - 300;
    case 2:  return (int32_t)arb_below(a, 200000) - 100000;
    default: return arb_raw(a, INT32_MAX);
    }
}

/* Any action, which moves by any way. */
static void arb_action(arb *a, const uint32_t from[LOFT_AXES], loft_item *out)
{
    const loft_action action = { (uint8_t)arb_below(a, LOFT_OUTPUTS_MOST + 1), arb_below(a, 2) != 0,
                                 (uint16_t)arb_next(a), (uint16_t)arb_next(a) };
    int32_t place[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        place[i] = (int32_t)(from[i] + (arb_below(a, 2) ? (uint32_t)arb_int32(a) : 0));
    loft_action_item(out, &action, place);
    const loft_action back = loft_item_action(out);
    CHECK(back.output == action.output && back.moving == action.moving &&
          back.level == action.level && back.feed == action.feed);
}

/* Spans of any kind, with actions among them: wild, or a smooth chain with a little noise. Modulo
 * 2^32, so that chains may wrap. */
static void arb_spans(arb *a, bool actions, loft_item item[], int count)
{
    const bool wild = arb_below(a, 3) == 0;
    const uint32_t noise = 1 + arb_below(a, 100);
    uint32_t x[LOFT_AXES], v[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++) {
        x[i] = (uint32_t)arb_int32(a);
        v[i] = (uint32_t)arb_int32(a) >> 12;
    }
    for (int n = 0; n < count; n++) {
        if (actions && arb_below(a, 5) == 0) {
            arb_action(a, x, &item[n]);
            for (int i = 0; i < LOFT_AXES; i++)
                x[i] = (uint32_t)item[n].p[2][i];
            continue;
        }
        item[n].ticks = (uint16_t)(1 + arb_below(a, LOFT_SPAN_TICKS_MAX));
        for (int k = 0; k < 3; k++)
            for (int i = 0; i < LOFT_AXES; i++) {
                v[i] += arb_below(a, noise);
                x[i] += v[i];
                item[n].p[k][i] = wild ? arb_int32(a) : (int32_t)x[i];
            }
    }
}

/* Points: wild, or motion whose second difference is small and often 0. */
static void arb_points(arb *a, loft_item item[], int count)
{
    const uint32_t taste = arb_below(a, 4), spread = taste == 0 ? 5 : taste == 1 ? 200 : 40000;
    uint32_t x[LOFT_AXES], v[LOFT_AXES] = { 0 };

    for (int i = 0; i < LOFT_AXES; i++)
        x[i] = (uint32_t)arb_int32(a);
    for (int n = 0; n < count; n++) {
        const bool still = arb_below(a, 3) > 0;
        memset(&item[n], 0, sizeof item[n]);
        item[n].ticks = 1;
        for (int i = 0; i < LOFT_AXES; i++) {
            if (!still)
                v[i] += arb_below(a, spread) - spread / 2;
            x[i] += v[i];
            item[n].p[2][i] = taste == 3 ? arb_int32(a) : (int32_t)x[i];
        }
    }
}

/* A line from x: its inner points are at the thirds, rounded to nearest. Modulo 2^32. */
static void make_line(loft_item *item, int i, uint32_t x, int32_t by)
{
    const int32_t third = (int32_t)(((int64_t)by * 2 + (by < 0 ? -3 : 3)) / 6);
    item->p[0][i] = (int32_t)(x + (uint32_t)third);
    item->p[1][i] = (int32_t)(x + (uint32_t)by - (uint32_t)third);
    item->p[2][i] = (int32_t)(x + (uint32_t)by);
}

/* Curves like the spans, but with any feed, which often stays. Among them are lines, points, and
 * axes that do not move. */
static void arb_curves(arb *a, loft_item item[], int count)
{
    arb_spans(a, false, item, count);
    for (int n = 0; n < count; n++) {
        const uint32_t taste = arb_below(a, 4);
        item[n].ticks = n > 0 && item[n - 1].ticks && arb_below(a, 4)
                            ? item[n - 1].ticks
                            : (uint16_t)(1 + arb_below(a, 65535));
        for (int i = 0; i < LOFT_AXES && n > 0; i++)
            if (taste == 0)
                make_line(&item[n], i, (uint32_t)item[n - 1].p[2][i], arb_int32(a));
            else if (taste == 1 && arb_below(a, 2))
                item[n].p[0][i] = item[n].p[1][i] = item[n].p[2][i] = item[n - 1].p[2][i];
        if (n > 0 && arb_below(a, 4) == 0) {            /* a part of a patch, of points that may be
                                                         * one */
            item[n].ticks = 0;
            memcpy(item[n].p[2], item[n - 1].p[2], sizeof item[n].p[2]);
            if (arb_below(a, 3) == 0)
                memcpy(item[n].p[1], item[n].p[0], sizeof item[n].p[1]);
        }
    }
}

static void arb_items(arb *a, enum loft_kind kind, loft_item item[], int count)
{
    if (kind == LOFT_SPANS)
        arb_spans(a, true, item, count);
    else if (kind == LOFT_CURVES)
        arb_curves(a, item, count);
    else
        arb_points(a, item, count);
}

/* Curves are data only of a machine that plans. */
static enum loft_kind arb_kind(arb *a)
{
    return (enum loft_kind)(LOFT_SPANS + arb_below(a, LOFT_MACHINE_PLANS ? 4 : 3));
}

static bool same_item(const loft_item *a, const loft_item *b)
{
    return a->ticks == b->ticks && memcmp(a->p, b->p, sizeof a->p) == 0;
}

static loft_predictor arb_predictor(arb *a)
{
    loft_predictor p;
    for (int i = 0; i < LOFT_AXES; i++) {
        p.position[i] = (uint32_t)arb_int32(a);
        p.change[i]   = (uint32_t)arb_int32(a);
        p.bend[i]     = (uint32_t)arb_int32(a);
    }
    p.ticks = (uint16_t)arb_below(a, 1 + LOFT_SPAN_TICKS_MAX);
    return p;
}

static bool same_predictor(const loft_predictor *a, const loft_predictor *b)
{
    return memcmp(a->position, b->position, sizeof a->position) == 0 &&
           memcmp(a->change, b->change, sizeof a->change) == 0 &&
           memcmp(a->bend, b->bend, sizeof a->bend) == 0 && a->ticks == b->ticks;
}

enum { MANY = 300 };

#define MOST_BYTES (LOFT_ITEM_BYTES > LOFT_CURVE_BYTES ? LOFT_ITEM_BYTES : LOFT_CURVE_BYTES)

static void any_items_come_out_as_they_went_in(arb *a)
{
    const enum loft_kind kind = arb_kind(a);
    const uint8_t room = (uint8_t)(MOST_BYTES + arb_below(a, 256 - MOST_BYTES));
    loft_predictor sending = arb_predictor(a), receiving = sending;
    loft_item item[MANY], got;
    uint8_t byte[255];
    int n = 0;

    arb_items(a, kind, item, MANY);
    while (n < MANY) {
        const int first = n;
        loft_packer p;
        loft_unpacker u;
        loft_packer_init(&p, kind, &sending, byte, room);
        while (n < MANY && loft_packer_push(&p, &item[n]) == LOFT_OK)
            n++;
        sending = p.predictor;
        CHECK(n > first && p.count == n - first && p.size <= room);

        CHECK(loft_unpacker_init(&u, kind, byte, p.size, p.count) == LOFT_OK);
        for (int k = first; k < n; k++) {
            CHECK(loft_unpacker_next(&u, &receiving, &got));
            CHECK(same_item(&got, &item[k]));
        }
        CHECK(!loft_unpacker_next(&u, &receiving, &got));
        CHECK(u.byte == byte + p.size);
        CHECK(same_predictor(&sending, &receiving));
    }
}

/* The state before item n depends only on the three items before it, so that a sender can begin
 * anywhere. */
static void three_items_are_memory_enough(arb *a)
{
    const enum loft_kind kind = arb_kind(a);
    loft_predictor whole, part;
    loft_item item[20];
    int32_t start[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        start[i] = arb_int32(a);
    arb_items(a, kind, item, 20);
    loft_predictor_init(&whole, start);
    for (int n = 0; n < 20; n++) {
        loft_predictor_init(&part, start);
        for (int k = n < LOFT_PREDICTOR_BACK ? 0 : n - LOFT_PREDICTOR_BACK; k < n; k++)
            loft_predictor_next(&part, kind, &item[k]);
        CHECK(same_predictor(&whole, &part));
        loft_predictor_next(&whole, kind, &item[n]);
    }
}

/* An item that does not fit leaves the packer unchanged. */
static void no_room_changes_nothing(arb *a)
{
    const enum loft_kind kind = arb_kind(a);
    const loft_predictor start = arb_predictor(a);
    uint8_t byte[255];
    loft_item item[60];
    loft_packer p;
    int n = 0;

    memset(byte, 0x5A, sizeof byte);
    arb_items(a, kind, item, 60);
    loft_packer_init(&p, kind, &start, byte, (uint8_t)arb_below(a, 80));
    while (n < 60 && loft_packer_push(&p, &item[n]) == LOFT_OK)
        n++;
    if (n < 60) {
        const loft_packer before = p;
        CHECK(loft_packer_push(&p, &item[n]) == LOFT_ERR_SPACE);
        CHECK(memcmp(&before, &p, sizeof p) == 0);
    }
    for (size_t i = p.room; i < sizeof byte; i++)
        CHECK(byte[i] == 0x5A);
}

static void no_frame_holds_more_than_255_items(arb *a)
{
    const loft_predictor start = arb_predictor(a);
    loft_item item = { 0 };
    uint8_t byte[255];
    loft_packer p;

    item.ticks = 1;
    loft_packer_init(&p, LOFT_POINTS, &start, byte, 255);
    for (int n = 0; n < 255; n++) {
        for (int i = 0; i < LOFT_AXES; i++)
            item.p[2][i] = (int32_t)(start.position[i] + start.change[i] * (uint32_t)(n + 1));
        CHECK(loft_packer_push(&p, &item) == LOFT_OK);
    }
    CHECK(p.size == 2 && byte[0] == 255 && byte[1] == 254);
    CHECK(loft_packer_push(&p, &item) == LOFT_ERR_SPACE);
}

static void ticks_out_of_range_are_refused(arb *a)
{
    const loft_predictor start = arb_predictor(a);
    loft_item item = { 0 };
    uint8_t byte[255];
    loft_packer p;

    loft_packer_init(&p, LOFT_SPANS, &start, byte, 255);
    item.ticks = LOFT_SPAN_TICKS_MAX + 1;
    CHECK(loft_packer_push(&p, &item) == LOFT_ERR_RANGE && p.size == 0 && p.count == 0);
    loft_packer_init(&p, LOFT_POINTS, &start, byte, 255);
    item.ticks = 0;
    CHECK(loft_packer_push(&p, &item) == LOFT_ERR_RANGE && p.size == 0);
    item.ticks = 2;
    CHECK(loft_packer_push(&p, &item) == LOFT_ERR_RANGE && p.size == 0);
    loft_packer_init(&p, LOFT_CURVES, &start, byte, 255);
    item.ticks = 0;
    CHECK(loft_packer_push(&p, &item) == LOFT_ERR_RANGE && p.size == 0);
}

/* The largest item: every residual needs five bytes (spans, curves) or four (points). */
static void the_largest_item_fits_its_bytes(arb *a)
{
    const int32_t zero[LOFT_AXES] = { 0 };
    loft_predictor start;
    loft_item item = { 0 };
    uint8_t byte[255];
    loft_packer p;
    (void)a;

    loft_predictor_init(&start, zero);
    for (int i = 0; i < LOFT_AXES; i++) {       /* e1 = 2^31, e2 = -2^30, e3 = 2^31, all modulo
                                                 * 2^32 */
        item.p[0][i] = INT32_MIN;
        item.p[1][i] = -0x40000000;
        item.p[2][i] = 0x40000000;
    }
    item.ticks = LOFT_SPAN_TICKS_MAX;
    loft_packer_init(&p, LOFT_SPANS, &start, byte, LOFT_ITEM_BYTES);
    CHECK(loft_packer_push(&p, &item) == LOFT_OK && p.size == LOFT_ITEM_BYTES);

    item.ticks = 65535;
    loft_packer_init(&p, LOFT_CURVES, &start, byte, LOFT_CURVE_BYTES);
    CHECK(loft_packer_push(&p, &item) == LOFT_OK && p.size == LOFT_CURVE_BYTES);

    item.ticks = 1;
    for (int i = 0; i < LOFT_AXES; i++)
        item.p[2][i] = INT32_MIN;
    loft_packer_init(&p, LOFT_POINTS, &start, byte, 255);
    CHECK(loft_packer_push(&p, &item) == LOFT_OK && p.size == (LOFT_AXES + 2) / 3 + 4 * LOFT_AXES);
}

/* The code in numbers: 62 + r0 + 5 r1 + 25 r2 in a second group, runs of 128, 1, 2 and 4 byte
 * escapes. */
static void points_take_the_bytes_of_the_table(arb *a)
{
    static const struct {
        int32_t r;
        uint8_t size[7];
    } row[] = { /* by LOFT_AXES */
                { -2, { 0, 1, 1, 1, 2, 2, 2 } },        { 2, { 0, 1, 1, 1, 2, 2, 2 } },
                { 3, { 0, 2, 3, 4, 6, 7, 8 } },         { -128, { 0, 2, 3, 4, 6, 7, 8 } },
                { 127, { 0, 2, 3, 4, 6, 7, 8 } },       { 128, { 0, 3, 5, 7, 10, 12, 14 } },
                { -32768, { 0, 3, 5, 7, 10, 12, 14 } }, { 32767, { 0, 3, 5, 7, 10, 12, 14 } },
                { 32768, { 0, 5, 9, 13, 18, 22, 26 } }, { -32769, { 0, 5, 9, 13, 18, 22, 26 } },
                { 0, { 0, 1, 1, 1, 1, 1, 1 } }
    };
    const loft_predictor start = arb_predictor(a);
    for (size_t k = 0; k < sizeof row / sizeof row[0]; k++) {
        loft_item item = { 0 };
        uint8_t byte[255];
        loft_packer p;
        item.ticks = 1;
        for (int i = 0; i < LOFT_AXES; i++)
            item.p[2][i] = (int32_t)(start.position[i] + start.change[i] + (uint32_t)row[k].r);
        loft_packer_init(&p, LOFT_POINTS, &start, byte, 255);
        CHECK(loft_packer_push(&p, &item) == LOFT_OK && p.size == row[k].size[LOFT_AXES]);
    }
}

/* A line takes one residual per moving axis, and no feed if it stays. */
static void lines_take_one_residual_for_each_axis(arb *a)
{
    const loft_predictor start = arb_predictor(a);
    loft_item item = { 0 };
    uint8_t byte[255], size = 1;
    loft_packer p;

    item.ticks = (uint16_t)(1 + arb_below(a, 65535));
    loft_packer_init(&p, LOFT_CURVES, &start, byte, 255);
    p.predictor.ticks = item.ticks;
    for (int i = 0; i < LOFT_AXES; i++) {
        const int32_t by = arb_below(a, 3)
                               ? (int32_t)(1 + arb_below(a, 1u << 27)) * (arb_below(a, 2) ? -1 : 1)
                               : 0;
        make_line(&item, i, start.position[i], by);
        const uint32_t z = by < 0 ? (uint32_t)by * 0xFFFFFFFEu - 1 : 2 * (uint32_t)by;
        size = (uint8_t)(size + (by == 0        ? 0
                                 : z < 1u << 7  ? 1
                                 : z < 1u << 14 ? 2
                                 : z < 1u << 21 ? 3
                                 : z < 1u << 28 ? 4
                                                : 5));
    }
    CHECK(loft_packer_push(&p, &item) == LOFT_OK && p.size == size);
}

/* Motion with even jerk: second differences grow, third ones stay: one byte per point. */
static void fine_points_take_one_byte_at_even_jerk(arb *a)
{
    const loft_predictor start = arb_predictor(a);
    loft_packer p, fine;
    uint8_t byte[255], again[255];
    loft_item item = { 0 };

    item.ticks = 1;
    loft_packer_init(&p, LOFT_POINTS, &start, byte, 255);
    loft_packer_init(&fine, LOFT_POINTS_FINE, &start, again, 255);
    for (int n = 0; n < 20; n++) {
        for (int i = 0; i < LOFT_AXES; i++) {
            const uint32_t bend = fine.predictor.bend[i] + (uint32_t)(arb_below(a, 2) ? 2 : -2);
            item.p[2][i] = (int32_t)(fine.predictor.position[i] + fine.predictor.change[i] + bend);
        }
        CHECK(loft_packer_push(&fine, &item) == LOFT_OK &&
              fine.size == (n + 1) * ((LOFT_AXES + 2) / 3));
        if (n < 5)
            CHECK(loft_packer_push(&p, &item) == LOFT_OK);
    }
    CHECK(p.size >= 5 * ((LOFT_AXES + 2) / 3));
}

/* Accepted bytes have exactly the announced count, and are the same when packed again. */
static void any_bytes_are_items_or_refused(arb *a)
{
    const enum loft_kind kind = arb_kind(a);
    const uint8_t size = (uint8_t)arb_below(a, 120);
    loft_predictor start = arb_predictor(a);
    uint8_t byte[120];
    int accepted = 0;

    if (kind == LOFT_CURVES)                /* the first curve of a job must say its feed, which the
                                             * machine sees to */
        start.ticks = (uint16_t)(1 + arb_below(a, 65535));
    for (int i = 0; i < size; i++)
        byte[i] = (uint8_t)(arb_below(a, 3) ? arb_below(a, 128) : arb_next(a));
    for (int count = 0; count < 256; count++) {
        loft_predictor there = start, again = start;
        loft_unpacker u, v;
        loft_item item, back;
        uint8_t packed[255];
        loft_packer p;

        if (loft_unpacker_init(&u, kind, byte, size, (uint8_t)count) != LOFT_OK)
            continue;
        accepted++;
        loft_packer_init(&p, kind, &start, packed, 255);
        while (loft_unpacker_next(&u, &there, &item))
            CHECK(loft_packer_push(&p, &item) == LOFT_OK);
        CHECK(p.count == count && u.byte == byte + size);
        CHECK(kind != LOFT_SPANS || (p.size == size && memcmp(byte, packed, size) == 0));
        CHECK(loft_unpacker_init(&v, kind, packed, p.size, p.count) == LOFT_OK);
        while (loft_unpacker_next(&v, &again, &back)) {
        }
        CHECK(same_predictor(&there, &again));
    }
    CHECK(accepted <= 1);
}

/* A good row of items is refused when it is cut, lengthened, or has another count. */
static void a_wrong_count_or_length_is_refused(arb *a)
{
    const enum loft_kind kind = arb_kind(a);
    const loft_predictor start = arb_predictor(a);
    uint8_t byte[200];
    loft_item item[40];
    loft_unpacker u;
    loft_packer p;

    arb_items(a, kind, item, 40);
    loft_packer_init(&p, kind, &start, byte, 190);
    for (int n = 0; n < 40 && loft_packer_push(&p, &item[n]) == LOFT_OK; n++) {
    }
    CHECK(loft_unpacker_init(&u, kind, byte, p.size, p.count) == LOFT_OK);
    for (int count = 0; count < 256; count++)
        CHECK(count == p.count ||
              loft_unpacker_init(&u, kind, byte, p.size, (uint8_t)count) == LOFT_ERR_DATA);
    for (uint8_t size = 0; size < p.size; size++)
        CHECK(loft_unpacker_init(&u, kind, byte, size, p.count) == LOFT_ERR_DATA);
    for (unsigned x = 0; x < 256; x++) {
        byte[p.size] = (uint8_t)x;
        CHECK(loft_unpacker_init(&u, kind, byte, (uint8_t)(p.size + 1), p.count) == LOFT_ERR_DATA);
    }
}

/* The encoding is unique: no longer varints, no ticks out of range. */
static void other_spellings_of_a_span_are_refused(arb *a)
{
    uint8_t byte[LOFT_ITEM_BYTES + 4] = { 0 };
    loft_unpacker u;
    (void)a;

    byte[0] = 1;                                        /* all goes on as it did */
    CHECK(loft_unpacker_init(&u, LOFT_SPANS, byte, 2, 1) == LOFT_OK);
    byte[0] = 0;                                        /* an action */
    CHECK(loft_unpacker_init(&u, LOFT_SPANS, byte, (uint8_t)(3 + LOFT_AXES), 1) == LOFT_OK);
    CHECK(loft_unpacker_init(&u, LOFT_SPANS, byte, (uint8_t)(2 + LOFT_AXES), 1) == LOFT_ERR_DATA);
    byte[1] = 0x10;                                     /* what there is not */
    CHECK(loft_unpacker_init(&u, LOFT_SPANS, byte, (uint8_t)(3 + LOFT_AXES), 1) == LOFT_ERR_DATA);
    byte[0] = 0x80, byte[1] = 0x08;                                     /* 1024 ticks */
    CHECK(loft_unpacker_init(&u, LOFT_SPANS, byte, 3, 1) == LOFT_ERR_DATA);
    byte[0] = 0xFF, byte[1] = 0x07;                                     /* 1023 ticks */
    CHECK(loft_unpacker_init(&u, LOFT_SPANS, byte, 3, 1) == LOFT_OK);
    byte[0] = 0x81, byte[1] = 0x00;                                     /* 1, in two bytes */
    CHECK(loft_unpacker_init(&u, LOFT_SPANS, byte, 3, 1) == LOFT_ERR_DATA);
    byte[0] = 1, byte[1] = 0x80, byte[2] = 0;           /* a form in two bytes for one */
    CHECK(loft_unpacker_init(&u, LOFT_SPANS, byte, 3, 1) == LOFT_ERR_DATA);
    byte[1] = 1;                                        /* a residual of 0 */
    CHECK(loft_unpacker_init(&u, LOFT_SPANS, byte, 3, 1) == LOFT_ERR_DATA);
    byte[2] = 1;
    CHECK(loft_unpacker_init(&u, LOFT_SPANS, byte, 3, 1) == LOFT_OK);
    byte[2] = byte[3] = byte[4] = byte[5] = 0xFF, byte[6] = 0x0F;       /* 2^32 - 1 */
    CHECK(loft_unpacker_init(&u, LOFT_SPANS, byte, 7, 1) == LOFT_OK);
    byte[6] = 0x1F;                                                     /* 2^33 - 1 */
    CHECK(loft_unpacker_init(&u, LOFT_SPANS, byte, 7, 1) == LOFT_ERR_DATA);

    const uint32_t beyond = (uint32_t)1 << 3 * LOFT_AXES;       /* of no axis */
    const uint8_t n = loft_varint_encode(byte + 1, beyond);
    byte[1 + n] = 1;
    CHECK(loft_unpacker_init(&u, LOFT_SPANS, byte, (uint8_t)(2 + n), 1) == LOFT_ERR_DATA);
}

/* Where velocity and acceleration go on, a span is its ticks, its form, and a number for each axis
 * that has jerk: also if it lasts some times as long. */
static void a_smooth_span_is_its_jerk(arb *a)
{
    loft_predictor at;
    uint32_t change[LOFT_AXES], bend[LOFT_AXES];
    uint8_t byte[255];

    loft_predictor_init(&at, (const int32_t[LOFT_AXES]){ 0 });
    at.ticks = (uint16_t)(1 + arb_below(a, 100));
    for (int i = 0; i < LOFT_AXES; i++) {
        at.position[i] = (uint32_t)arb_next(a);
        at.change[i] = change[i] = (uint32_t)((int32_t)arb_below(a, 20001) - 10000);
        at.bend[i] = bend[i] = (uint32_t)((int32_t)arb_below(a, 2001) - 1000);
    }
    for (int n = 0; n < 20; n++) {
        const uint16_t times = (uint16_t)(1 + (n == 5) * arb_below(a, 10));
        loft_item item = { .ticks = (uint16_t)(at.ticks * times) };
        uint8_t size = (uint8_t)((item.ticks < 128 ? 1 : 2) + 1), jerks = 0;
        loft_packer p;
        for (int i = 0; i < LOFT_AXES; i++) {
            const uint32_t e3 = (uint32_t)arb_below(a, 41) - 20u;
            change[i] *= times;
            bend[i] *= times * (uint32_t)times;
            uint32_t place = at.position[i];
            item.p[0][i] = (int32_t)(place += change[i]);
            item.p[1][i] = (int32_t)(place += change[i] += bend[i]);
            item.p[2][i] = (int32_t)(place + (change[i] += bend[i] += e3));
            jerks = (uint8_t)(jerks + (e3 != 0));
        }
        loft_packer_init(&p, LOFT_SPANS, &at, byte, 255);
        CHECK(loft_packer_push(&p, &item) == LOFT_OK && p.size == size + jerks);
        at = p.predictor;
    }
}

static void other_spellings_of_a_curve_are_refused(arb *a)
{
    uint8_t byte[LOFT_CURVE_BYTES] = { 0 };
    loft_unpacker u;
    (void)a;
    if (!LOFT_MACHINE_PLANS)                /* it takes no curves */
        return;

    /* a point, with the last feed */
    CHECK(loft_unpacker_init(&u, LOFT_CURVES, byte, 1, 1) == LOFT_OK);
    byte[0] = 0xC0, byte[1] = 0;                                        /* a straight part */
    CHECK(loft_unpacker_init(&u, LOFT_CURVES, byte, 2, 1) == LOFT_ERR_DATA);
    byte[0] = 0x80;                                                     /* a part */
    CHECK(loft_unpacker_init(&u, LOFT_CURVES, byte, 2, 1) == LOFT_OK);
    byte[1] = 0xFF, byte[2] = 0xFF, byte[3] = 0x03;                     /* 65535 */
    CHECK(loft_unpacker_init(&u, LOFT_CURVES, byte, 4, 1) == LOFT_OK);
    byte[1] = 0x80, byte[2] = 0x80, byte[3] = 0x04;                     /* 65536 */
    CHECK(loft_unpacker_init(&u, LOFT_CURVES, byte, 4, 1) == LOFT_ERR_DATA);
    byte[1] = 0x81, byte[2] = 0;                                        /* 1, in two bytes */
    CHECK(loft_unpacker_init(&u, LOFT_CURVES, byte, 3, 1) == LOFT_ERR_DATA);
    for (int i = 0; i < 6; i++) {                       /* an axis that there is not */
        byte[0] = (uint8_t)(0x40u | 1u << i), byte[1] = 2;
        CHECK(loft_unpacker_init(&u, LOFT_CURVES, byte, 2, 1) ==
              (i < LOFT_AXES ? LOFT_OK : LOFT_ERR_DATA));
    }
}

/* Exactly in q16 and f64; in f32 to half an ulp: 2^-9 of 32768. */
static void items_are_spans_of_the_library(arb *a)
{
    loft_item item, back;
    loft_span span;
    int32_t from[LOFT_AXES];

    arb_spans(a, false, &item, 1);
    for (int i = 0; i < LOFT_AXES; i++)
        from[i] = arb_int32(a);
    loft_item_span(&item, from, &span);
    for (int i = 0; i < LOFT_AXES; i++) {
        CHECK_NEAR(arb_value(span.p[0].axis[i]), from[i] / 65536.0,
                   BY_NUM(0, from[i] * (from[i] < 0 ? -1.0 : 1.0) / 65536 / 16777216, 0));
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(arb_value(span.p[k + 1].axis[i]), item.p[k][i] / 65536.0,
                       BY_NUM(0, 1.0 / 512, 0));
    }
    if (loft_item_from_span(&back, &span) == LOFT_OK) {
        CHECK(BY_NUM(true, false, true) ? same_item(&back, &item) : back.ticks == item.ticks);
        for (int k = 0; k < 3; k++)
            for (int i = 0; i < LOFT_AXES; i++)
                CHECK_NEAR(back.p[k][i], item.p[k][i], BY_NUM(0, 128, 0));
    } else {
        CHECK(BY_NUM(false, true, false));          /* f32 alone: INT32_MAX has become 32768 */
    }
}

static void spans_out_of_range_become_no_items(arb *a)
{
    loft_span span = { 0 };
    loft_item item;

    span.ticks = 0;
    CHECK(loft_item_from_span(&item, &span) == LOFT_ERR_RANGE);
    span.ticks = LOFT_SPAN_TICKS_MAX + 1;
    CHECK(loft_item_from_span(&item, &span) == LOFT_ERR_RANGE);
    span.ticks = 1;
    CHECK(loft_item_from_span(&item, &span) == LOFT_OK);
    if (BY_NUM(false, true, true)) {
        loft_real *x = &span.p[1 + arb_below(a, 3)].axis[arb_below(a, LOFT_AXES)];
        *x = loft_real_from_int(1 << 15);
        CHECK(loft_item_from_span(&item, &span) == LOFT_ERR_RANGE);
        *x = -loft_real_from_int(1 << 15);
        CHECK(loft_item_from_span(&item, &span) == LOFT_OK);
        *x = BY_NUM(*x, (*x - *x) / (*x - *x), (*x - *x) / (*x - *x)); /* not a number */
        CHECK(loft_item_from_span(&item, &span) == LOFT_ERR_RANGE);
    }
}

int main(void)
{
    EXTREMES(loft_packer_push, any_items_come_out_as_they_went_in, 3000);
    PROPERTY(three_items_are_memory_enough, 1000);
    PROPERTY(no_room_changes_nothing, 3000);
    PROPERTY(no_frame_holds_more_than_255_items, 10);
    PROPERTY(ticks_out_of_range_are_refused, 1);
    PROPERTY(the_largest_item_fits_its_bytes, 1);
    PROPERTY(lines_take_one_residual_for_each_axis, 1000);
    PROPERTY(other_spellings_of_a_curve_are_refused, 1);
    PROPERTY(fine_points_take_one_byte_at_even_jerk, 100);
    PROPERTY(points_take_the_bytes_of_the_table, 100);
    PROPERTY(any_bytes_are_items_or_refused, 3000);
    PROPERTY(a_wrong_count_or_length_is_refused, 500);
    PROPERTY(other_spellings_of_a_span_are_refused, 1);
    PROPERTY(a_smooth_span_is_its_jerk, 1000);
    PROPERTY(items_are_spans_of_the_library, 3000);
    PROPERTY(spans_out_of_range_become_no_items, 100);
    return check_failures();
}
