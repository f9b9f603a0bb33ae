/* tests/lib/wire/test_frame.c -- properties of lib/wire/frame.h
 * SPDX-License-Identifier: MIT
 */
#include <string.h>

#include "check.h"          /* CHECK, PROPERTY */
#include "wire/frame.h"

typedef struct {
    uint8_t byte[LOFT_FRAME_CONTENT];
    size_t  size;
} content;

/* Content that is hard to frame: zeros, long runs without zeros, values next to both. */
static content arb_content(arb *a, size_t least, size_t most)
{
    const uint32_t taste = arb_below(a, 5);
    content c;
    c.size = least + arb_below(a, (uint32_t)(most - least) + 1);
    for (size_t i = 0; i < c.size; i++)
        c.byte[i] = taste == 0   ? 0
                    : taste == 1 ? 0xFF
                    : taste == 2 ? (uint8_t)arb_below(a, 3)
                    : taste == 3 ? (uint8_t)(1 + arb_below(a, 255))
                                 : (uint8_t)arb_next(a);
    return c;
}

static size_t encode(const content *c, uint8_t wire[LOFT_FRAME_MAX])
{
    memcpy(wire + 1, c->byte, c->size);
    return loft_frame_encode(wire, c->size);
}

/* The results of a decoder, in order. */
typedef struct {
    unsigned good, bad;
    content last[4];
} result;

static void decode(loft_frame *f, const uint8_t *byte, size_t count, result *r)
{
    for (size_t i = 0; i < count; i++) {
        const enum loft_status s = loft_frame_push(f, byte[i]);
        if (s == LOFT_ERR_DATA)
            r->bad++;
        if (s == LOFT_OK) {
            content *c = &r->last[r->good++ % 4];
            c->size = f->count;
            memcpy(c->byte, f->byte, f->count);
        }
    }
}

static bool same(const content *a, const content *b)
{
    return a->size == b->size && memcmp(a->byte, b->byte, a->size) == 0;
}

static void what_goes_in_comes_out(arb *a)
{
    const content c = arb_content(a, 2, LOFT_FRAME_CONTENT);
    uint8_t wire[LOFT_FRAME_MAX];
    const size_t size = encode(&c, wire);
    result r = { 0 };
    loft_frame f;

    loft_frame_init(&f);
    decode(&f, wire, size, &r);
    decode(&f, wire, size, &r);
    CHECK(size == c.size + LOFT_FRAME_EXTRA && size <= LOFT_FRAME_MAX);
    CHECK(memchr(wire, 0, size) == wire + size - 1);
    CHECK(r.good == 2 && r.bad == 0 && same(&r.last[0], &c) && same(&r.last[1], &c));
}

/* "123456789" gives the check value of the catalogue; the start value is the state after "loft". */
static void the_crc_is_crc32c(arb *a)
{
    uint32_t crc = 0xFFFFFFFFu;
    (void)a;
    for (const char *s = "123456789"; *s; s++)
        crc = loft_crc(crc, (uint8_t)*s);
    CHECK((crc ^ 0xFFFFFFFFu) == 0xE3069283u);

    uint8_t wire[LOFT_FRAME_MAX] = { 0, 0x71, 0x05 };
    crc = 0xFFFFFFFFu;
    for (const char *s = "loft\x71\x05"; *s; s++)
        crc = loft_crc(crc, (uint8_t)*s);
    crc ^= 0xFFFFFFFFu;
    CHECK(loft_frame_encode(wire, 2) == 8);
    for (int i = 0; i < 4; i++)
        CHECK(wire[3 + i] == (uint8_t)(crc >> (8 * i)));
}

static void sizes_out_of_range_are_refused(arb *a)
{
    uint8_t wire[LOFT_FRAME_MAX] = { 9 };
    (void)a;
    CHECK(loft_frame_encode(wire, 0) == 0 && loft_frame_encode(wire, 1) == 0);
    CHECK(loft_frame_encode(wire, LOFT_FRAME_CONTENT + 1) == 0 && wire[0] == 9);
    CHECK(loft_frame_encode(wire, LOFT_FRAME_CONTENT) == LOFT_FRAME_MAX);
}

/* A frame one byte longer than the longest, with a right CRC, is refused; the next one is taken. */
static void too_long_is_refused(arb *a)
{
    uint8_t wire[LOFT_FRAME_MAX + 1], good[LOFT_FRAME_MAX];
    const content c = arb_content(a, 2, 20);
    const size_t size = encode(&c, good);
    const size_t n = LOFT_FRAME_CONTENT + 1;
    uint32_t crc = 0xFFFFFFFFu;
    result r = { 0 };
    loft_frame f;

    for (const char *s = "loft"; *s; s++)
        crc = loft_crc(crc, (uint8_t)*s);
    for (size_t i = 1; i <= n; i++)
        crc = loft_crc(crc, wire[i] = (uint8_t)(1 + arb_below(a, 255)));
    for (size_t i = 1, x = crc ^ 0xFFFFFFFFu; i <= 4; i++, x >>= 8)
        wire[n + i] = (uint8_t)((x & 0xFF) ? (x & 0xFF) : 1);
    wire[0] = (uint8_t)(n + 5);
    wire[n + 5] = 0;

    loft_frame_init(&f);
    decode(&f, wire, sizeof wire, &r);
    decode(&f, good, size, &r);
    CHECK(r.good == 1 && r.bad == 1 && same(&r.last[0], &c));
}

/* Without the four bytes "loft" in front, the CRC is that of another protocol. */
static void frames_of_another_schema_are_refused(arb *a)
{
    const content c = arb_content(a, 2, LOFT_FRAME_CONTENT);
    uint8_t wire[LOFT_FRAME_MAX + 4];
    uint32_t crc = 0xFFFFFFFFu;
    size_t code = 0;
    result r = { 0 };
    loft_frame f;

    for (size_t i = 0; i < c.size; i++)
        crc = loft_crc(crc, wire[i + 1] = c.byte[i]);
    for (size_t i = 1, x = crc ^ 0xFFFFFFFFu; i <= 4; i++, x >>= 8)
        wire[c.size + i] = (uint8_t)x;
    for (size_t i = 1; i <= c.size + 4; i++)
        if (wire[i] == 0) {
            wire[code] = (uint8_t)(i - code);
            code = i;
        }
    wire[code] = (uint8_t)(c.size + 5 - code);
    wire[c.size + 5] = 0;

    loft_frame_init(&f);
    decode(&f, wire, c.size + LOFT_FRAME_EXTRA, &r);
    CHECK(r.good == 0 && r.bad == 1);
}

static void after_any_bytes_the_next_but_one_frame_is_taken(arb *a)
{
    const content c = arb_content(a, 2, LOFT_FRAME_CONTENT);
    uint8_t noise[600], wire[LOFT_FRAME_MAX];
    const size_t size = encode(&c, wire), length = arb_below(a, sizeof noise);
    result r = { 0 };
    loft_frame f;

    for (size_t i = 0; i < length; i++)
        noise[i] = (uint8_t)(arb_below(a, 4) ? arb_next(a) : 0);
    loft_frame_init(&f);
    decode(&f, noise, length, &r);
    CHECK(r.good == 0);
    decode(&f, wire, size, &r);             /* lost, if the noise did not end with 0x00 */
    decode(&f, wire, size, &r);
    CHECK(r.good == 2 || (r.good == 1 && length > 0 && noise[length - 1] != 0));
    CHECK(same(&r.last[0], &c));
}

static void empty_frames_are_nothing(arb *a)
{
    uint8_t wire[LOFT_FRAME_MAX], zero[9] = { 0 };
    const content c = arb_content(a, 2, 30);
    const size_t size = encode(&c, wire);
    result r = { 0 };
    loft_frame f;

    loft_frame_init(&f);
    decode(&f, zero, sizeof zero, &r);
    decode(&f, wire, size, &r);
    decode(&f, zero, sizeof zero, &r);
    CHECK(r.good == 1 && r.bad == 0);
}


// Damage
// ------

/* Before, damaged, after, after: only sent frames may be taken, and the last one always is. */
typedef struct {
    content c[3];
    uint8_t wire[3][LOFT_FRAME_MAX];
    size_t  size[3];
    loft_frame start;           /* a decoder that has taken c[0] */
} scene;

static scene arb_scene(arb *a, size_t least)
{
    scene s;
    result r = { 0 };
    for (int k = 0; k < 3; k++) {
        s.c[k] = arb_content(a, least, LOFT_FRAME_CONTENT);
        s.c[k].byte[0] = (uint8_t)(k + 1);          /* three different frames */
        s.size[k] = encode(&s.c[k], s.wire[k]);
    }
    loft_frame_init(&s.start);
    decode(&s.start, s.wire[0], s.size[0], &r);
    return s;
}

/* `refused`: the damaged frame must not be taken even as itself. */
static bool survives(const scene *s, const uint8_t *damaged, size_t size, bool refused)
{
    loft_frame f = s->start;
    result r = { 0 };

    decode(&f, damaged, size, &r);
    for (unsigned i = 0; i < r.good; i++)
        if (refused || i > 0 || (!same(&r.last[i], &s->c[1]) && !same(&r.last[i], &s->c[0])))
            return false;
    r.good = 0;
    decode(&f, s->wire[2], s->size[2], &r);         /* may be lost with the delimiter before it */
    decode(&f, s->wire[2], s->size[2], &r);
    return r.good >= 1 && r.good <= 2 && same(&r.last[0], &s->c[2]) &&
           same(&r.last[r.good - 1], &s->c[2]);
}

static void flip(uint8_t *wire, size_t bit)
{
    wire[bit / 8] = (uint8_t)(wire[bit / 8] ^ 1u << bit % 8);
}

/* All kinds of damage on a frame of full length; only q16, because no number type is involved. */
static void no_one_or_two_flipped_bits_pass(arb *a)
{
    scene s = arb_scene(a, LOFT_FRAME_CONTENT);
    const size_t bits = 8 * s.size[1];

    for (size_t i = 0; i < bits; i += CHECK_STEP) {
        flip(s.wire[1], i);
        CHECK(survives(&s, s.wire[1], s.size[1], true));
        for (size_t j = i + 1; j < bits; j++) {
            loft_frame f = s.start;
            result r = { 0 };
            flip(s.wire[1], j);
            decode(&f, s.wire[1], s.size[1], &r);
            CHECK(r.good == 0);
            flip(s.wire[1], j);
        }
        flip(s.wire[1], i);
    }
}

static void no_byte_lost_doubled_or_put_in_passes(arb *a)
{
    const scene s = arb_scene(a, LOFT_FRAME_CONTENT);
    const size_t n = s.size[1];
    uint8_t wire[LOFT_FRAME_MAX + 1];

    for (size_t at = 0; at <= n; at++) {
        memcpy(wire, s.wire[1], at);
        for (unsigned x = 0; x < 256; x++) {            /* put in; a 0x00 at either end is no
                                                         * damage */
            wire[at] = (uint8_t)x;
            memcpy(wire + at + 1, s.wire[1] + at, n - at);
            CHECK(survives(&s, wire, n + 1, false));
        }
        if (at == n)
            break;
        memcpy(wire + at, s.wire[1] + at + 1, n - at - 1);      /* lost */
        CHECK(survives(&s, wire, n - 1, at != n - 1));
        memcpy(wire + at, s.wire[1] + at, n - at);              /* doubled */
        memmove(wire + at + 1, wire + at, n - at);
        CHECK(survives(&s, wire, n + 1, at != n - 1));
    }
}

/* 3 to 6 bits, bursts, several bytes lost or doubled, both at once, the tail of one frame joined to
 * another. */
static void no_worse_damage_passes(arb *a)
{
    const scene s = arb_scene(a, 2);
    uint8_t wire[2 * LOFT_FRAME_MAX + 8];

    for (int round = 0; round < 200; round++) {
        size_t n = s.size[1], at = arb_below(a, (uint32_t)n), k;
        memcpy(wire, s.wire[1], n);
        switch (arb_below(a, 5)) {
        case 0:
            for (k = 3 + arb_below(a, 4); k > 0; k--)
                flip(wire, arb_below(a, (uint32_t)(8 * n)));
            break;
        case 1:
            for (k = 8 * at + arb_below(a, 8); k < 8 * at + 40 && k < 8 * n; k++)
                if (arb_below(a, 2))
                    flip(wire, k);
            break;
        case 2:
            k = 1 + arb_below(a, 8);
            k = k < n - at ? k : n - at;
            memmove(wire + at, wire + at + k, n - at - k);
            n -= k;
            break;
        case 3:
            memmove(wire + at + 1, wire + at, n - at);
            n++;
            flip(wire, arb_below(a, (uint32_t)(8 * n)));
            break;
        default:
            at = at ? at : 1;
            k = arb_below(a, (uint32_t)s.size[0]);              /* the delimiter lost, and more */
            memcpy(wire + at, s.wire[0] + k, s.size[0] - k);
            n = at + s.size[0] - k;
            break;
        }
        CHECK(survives(&s, wire, n, false));
    }
}

int main(void)
{
    PROPERTY(what_goes_in_comes_out, 3000);
    PROPERTY(the_crc_is_crc32c, 1);
    PROPERTY(sizes_out_of_range_are_refused, 1);
    PROPERTY(too_long_is_refused, 200);
    PROPERTY(frames_of_another_schema_are_refused, 1000);
    PROPERTY(after_any_bytes_the_next_but_one_frame_is_taken, 2000);
    PROPERTY(empty_frames_are_nothing, 100);
    if (BY_NUM(true, false, false))
        PROPERTY(no_one_or_two_flipped_bits_pass, 1);
    PROPERTY(no_byte_lost_doubled_or_put_in_passes, BY_NUM(5, 1, 1));
    PROPERTY(no_worse_damage_passes, BY_NUM(1000, 50, 50));
    return check_failures();
}
