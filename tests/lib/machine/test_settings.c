/* tests/lib/machine/test_settings.c -- properties of lib/machine/settings.h: the power may fail at
 * any byte
 * SPDX-License-Identifier: MIT
 */
#include <string.h>

#include "check.h"
#include "machine/settings.h"

#define ROOM     200u
#define TEXT     40u            /* bytes of text at most */
#define FOREVER  0xFFFFFFFFu

static struct {
    uint8_t  byte[2 * ROOM];
    uint32_t power;             /* writes until it fails */
    arb     *a;
} memory;

static uint8_t read_byte(uint16_t at)
{
    CHECK(at < 2 * ROOM);
    return memory.byte[at];
}

/* The byte at which the power fails may hold anything, and those after it stay as they were. */
static void write_byte(uint16_t at, uint8_t byte)
{
    CHECK(at < 2 * ROOM);
    if (memory.power == 0)
        return;
    memory.byte[at] = --memory.power ? byte : (uint8_t)arb_next(memory.a);
}

static loft_axis_config axis[LOFT_AXES];

static void usual(loft_settings *s)
{
    for (int i = 0; i < LOFT_AXES; i++)
        axis[i] = (loft_axis_config){ 80 * 65536, 100 * 65536, 500 * 65536, 10000 };
    memset(s->wiring, 0, sizeof s->wiring);
    s->wiring[LOFT_WIRING_PULSE]  = 2;
    s->wiring[LOFT_WIRING_OBEYED] = 0x15;
}

/* A machine starts: its firmware has these values. */
static loft_settings start(void)
{
    loft_settings s = { .get = read_byte, .put = write_byte, .usual = usual, .room = ROOM };

    usual(&s);
    loft_settings_init(&s, axis);
    return s;
}

typedef struct {
    uint8_t byte[ROOM];
    uint16_t size;
} block;

static block read_all(const loft_settings *s)
{
    block b = { .size = (uint16_t)(loft_settings_get(s, 6) | loft_settings_get(s, 7) << 8) };

    for (uint16_t at = 0; at < ROOM; at++)
        b.byte[at] = loft_settings_get(s, at);
    return b;
}

static void put_word(block *b, uint16_t at, uint32_t word)
{
    for (int i = 0; i < 4; i++, word >>= 8)
        b->byte[at + i] = (uint8_t)(word & 0xFF);
}

static void seal(block *b)
{
    uint32_t crc = 0xFFFFFFFFu;

    b->byte[6] = (uint8_t)(b->size & 0xFF);
    b->byte[7] = (uint8_t)(b->size >> 8);
    for (uint16_t at = 4; at < b->size; at++)
        crc = loft_crc(crc, b->byte[at]);
    put_word(b, 0, ~crc);
}

/* Other settings than `old`, with the next number. */
static block next_block(arb *a, const block *old)
{
    block b = *old;

    b.byte[4]++;
    b.byte[5] = LOFT_SETTINGS_LAYOUT;
    b.size    = (uint16_t)(LOFT_SETTINGS_TEXT + arb_below(a, TEXT));
    for (uint16_t i = 0; i < LOFT_AXES; i++)
        put_word(&b, (uint16_t)(LOFT_SETTINGS_AXES + 16 * i), 1 + arb_below(a, 0x7FFFFFFF));
    for (uint16_t at = LOFT_SETTINGS_AXES; at < b.size; at++)
        if (arb_below(a, 2) && (at >= LOFT_SETTINGS_WIRING || (at - LOFT_SETTINGS_AXES) % 16 > 3) &&
            at != LOFT_SETTINGS_WIRING + LOFT_WIRING_OBEYED)
            b.byte[at] = (uint8_t)arb_next(a);
    for (uint16_t at = b.size; at < ROOM; at++)
        b.byte[at] = 0;
    seal(&b);
    return b;
}

/* As a host does: all but the check, in pieces, some of them twice; then the check. */
static bool write_block(arb *a, loft_settings *s, const block *b)
{
    for (uint16_t at = 4; at < b->size;) {
        uint16_t count = (uint16_t)(1 + arb_below(a, LOFT_KEPT_MOST));
        if (count > b->size - at)
            count = (uint16_t)(b->size - at);
        for (int again = 0; again <= (arb_below(a, 4) == 0); again++)
            CHECK(!loft_settings_put(s, at, b->byte + at, (uint8_t)count));
        for (uint16_t i = 0; i < count && memory.power > 0; i++)
            CHECK(loft_settings_spare(s, (uint16_t)(at + i)) == b->byte[at + i]);
        at = (uint16_t)(at + count);
    }
    return loft_settings_put(s, 0, b->byte, 4);
}

static bool same(const block *a, const block *b)
{
    return a->size == b->size && memcmp(a->byte, b->byte, ROOM) == 0;
}

static bool in_force(const block *b)
{
    uint8_t word[4 * 4 * LOFT_AXES];

    for (unsigned i = 0; i < 4 * LOFT_AXES; i++) {
        const loft_axis_config *x = &axis[i / 4];
        const uint32_t value[4] = { (uint32_t)x->steps_per_mm, (uint32_t)x->max_speed,
                                    (uint32_t)x->max_accel, x->max_jerk };
        for (int k = 0; k < 4; k++)
            word[4 * i + (unsigned)k] = (uint8_t)(value[i % 4] >> 8 * k & 0xFF);
    }
    return memcmp(word, b->byte + LOFT_SETTINGS_AXES, sizeof word) == 0;
}

static void fresh_memory(arb *a, uint8_t byte)
{
    memset(memory.byte, byte, sizeof memory.byte);
    memory.power = FOREVER;
    memory.a     = a;
}

static void a_fresh_machine_has_its_usual_settings(arb *a)
{
    fresh_memory(a, arb_below(a, 2) ? 0xFF : 0);
    const loft_settings s = start();
    const block b         = read_all(&s);

    CHECK(loft_settings_origin_of(&s) == LOFT_SETTINGS_USUAL);
    CHECK(b.size == LOFT_SETTINGS_TEXT && b.byte[5] == LOFT_SETTINGS_LAYOUT);
    CHECK(in_force(&b) && axis[0].steps_per_mm == 80 * 65536);
    CHECK(b.byte[LOFT_SETTINGS_WIRING + LOFT_WIRING_PULSE] == 2);
}

static void what_is_written_is_kept(arb *a)
{
    fresh_memory(a, 0xFF);
    loft_settings s = start();
    const int times = 1 + (int)arb_below(a, 300);       /* numbers wrap at 256 */

    for (int i = 0; i < times; i++) {
        const block was = read_all(&s), b = next_block(a, &was);
        CHECK(write_block(a, &s, &b));
        const block now = read_all(&s);
        CHECK(same(&now, &b) && in_force(&b) && loft_settings_origin_of(&s) == LOFT_SETTINGS_KEPT);
    }
    const block last = read_all(&s);
    s                = start();
    const block now  = read_all(&s);
    CHECK(same(&now, &last) && in_force(&last) &&
          loft_settings_origin_of(&s) == LOFT_SETTINGS_KEPT);
    CHECK(s.wiring[LOFT_WIRING_OBEYED] == 0x15);
}

/* Every cut of a write, one after the other; then the same write goes through. */
static void a_cut_leaves_the_old_or_the_new(arb *a)
{
    fresh_memory(a, 0xFF);
    loft_settings s = start();
    block b         = read_all(&s);

    for (int i = (int)arb_below(a, 4); i > 0; i--) {
        b = next_block(a, &b);
        CHECK(write_block(a, &s, &b));
    }
    const block was = read_all(&s), will = next_block(a, &was);
    uint8_t before[sizeof memory.byte];
    bool whole = false;

    memcpy(before, memory.byte, sizeof before);
    for (uint32_t cut = 1; !whole; cut++) {
        memcpy(memory.byte, before, sizeof before);
        memory.power = cut;
        s            = start();
        (void)write_block(a, &s, &will);
        whole        = memory.power > 0;
        memory.power = FOREVER;
        s            = start();
        const block now = read_all(&s);
        CHECK(same(&now, &was) || same(&now, &will));
        CHECK(in_force(&now) && (!whole || same(&now, &will)));
        CHECK(was.byte[0] == 0 || loft_settings_origin_of(&s) == LOFT_SETTINGS_KEPT);
        CHECK(write_block(a, &s, &will) || same(&now, &will));
    }
}

static bool has_usual(const loft_settings *s)
{
    for (int i = 0; i < LOFT_AXES; i++)
        if (axis[i].steps_per_mm != 80 * 65536 || axis[i].max_jerk != 10000)
            return false;
    return s->wiring[LOFT_WIRING_PULSE] == 2 && s->wiring[LOFT_WIRING_REVERSED] == 0;
}

/* The order to go back to the firmware's values, cut at each of its bytes. */
static void a_head_alone_brings_the_usual_settings(arb *a)
{
    fresh_memory(a, 0xFF);
    loft_settings s = start();
    block b         = read_all(&s);

    for (int i = 1 + (int)arb_below(a, 3); i > 0; i--) {
        b = next_block(a, &b);
        CHECK(write_block(a, &s, &b));
    }
    block head = b;
    uint8_t before[sizeof memory.byte];
    bool whole = false;

    head.byte[4]++;
    head.size = LOFT_SETTINGS_AXES;
    seal(&head);
    memcpy(before, memory.byte, sizeof before);
    for (uint32_t cut = 1; !whole; cut++) {
        memcpy(memory.byte, before, sizeof before);
        memory.power   = cut;
        s              = start();
        const bool now = write_block(a, &s, &head);
        whole          = memory.power > 0;
        CHECK(!whole || (now && has_usual(&s)));
        memory.power     = FOREVER;
        s                = start();
        const block kept = read_all(&s);
        CHECK(loft_settings_origin_of(&s) == LOFT_SETTINGS_USUAL
                  ? has_usual(&s)
                  : same(&kept, &b) && in_force(&b) && !whole);
    }
    b = next_block(a, &head);
    CHECK(write_block(a, &s, &b) && in_force(&b));
    s       = start();
    s.usual = NULL;
    head.byte[4] = (uint8_t)(b.byte[4] + 1);
    seal(&head);
    CHECK(!write_block(a, &s, &head) && loft_settings_origin_of(&s) == LOFT_SETTINGS_KEPT);
}

/* One damaged copy: the other one; both: the firmware's values, and it says so. */
static void damage_is_found(arb *a)
{
    fresh_memory(a, 0xFF);
    loft_settings s = start();
    block b[2];

    b[0] = read_all(&s);
    b[0] = next_block(a, &b[0]);
    CHECK(write_block(a, &s, &b[0]));
    b[1] = next_block(a, &b[0]);
    CHECK(write_block(a, &s, &b[1]));

    memory.byte[ROOM + 4 + arb_below(a, b[1].size - 4u)] ^= (uint8_t)(1u << arb_below(a, 8));
    s         = start();
    block now = read_all(&s);
    CHECK(same(&now, &b[0]) && in_force(&b[0]) &&
          loft_settings_origin_of(&s) == LOFT_SETTINGS_KEPT);

    memory.byte[8 + arb_below(a, b[0].size - 8u)] ^= (uint8_t)(1u << arb_below(a, 8));
    s = start();
    CHECK(loft_settings_origin_of(&s) == LOFT_SETTINGS_DAMAGED &&
          axis[0].steps_per_mm == 80 * 65536);

    now = read_all(&s);
    now = next_block(a, &now);
    CHECK(write_block(a, &s, &now) && loft_settings_origin_of(&s) == LOFT_SETTINGS_KEPT);
}

static void impossible_settings_are_refused(arb *a)
{
    fresh_memory(a, 0xFF);
    loft_settings s = start();
    block b         = read_all(&s);

    b = next_block(a, &b);
    CHECK(write_block(a, &s, &b));
    const block was = b;
    b               = next_block(a, &b);
    switch (arb_below(a, 4)) {
    case 0:
        put_word(&b, (uint16_t)(LOFT_SETTINGS_AXES + 16 * arb_below(a, LOFT_AXES)),
                 arb_below(a, 2) ? 0 : 0x80000000u + arb_below(a, 1000));
        break;
    case 1: b.byte[5]++; break;
    case 2: b.size = (uint16_t)(LOFT_SETTINGS_TEXT - 1 - arb_below(a, 8)); break;
    default: b.byte[4] = (uint8_t)(b.byte[4] - 1 - (1 + arb_below(a, 127))); break; /* older */
    }
    seal(&b);
    CHECK(!write_block(a, &s, &b));
    const block now = read_all(&s);
    CHECK(same(&now, &was) && in_force(&was));
}

/* Any bytes anywhere: nothing beyond the memory is touched. */
static void any_write_stays_within_the_spare_copy(arb *a)
{
    uint8_t byte[LOFT_KEPT_MOST], before[2 * ROOM];

    fresh_memory(a, 0xFF);
    loft_settings s = start();
    block b         = read_all(&s);
    b               = next_block(a, &b);
    CHECK(write_block(a, &s, &b));
    for (int i = 0; i < 50; i++) {
        const uint16_t at = (uint16_t)(arb_below(a, 3) ? arb_below(a, 2 * ROOM) : arb_next(a));
        for (unsigned k = 0; k < sizeof byte; k++)
            byte[k] = (uint8_t)arb_next(a);
        memcpy(before, memory.byte, sizeof before);
        CHECK(!loft_settings_put(&s, at, byte, (uint8_t)arb_below(a, sizeof byte + 1)));
        const unsigned held = s.which == 1 ? ROOM : 0;
        CHECK(memcmp(before + held, memory.byte + held, ROOM) == 0);
        (void)loft_settings_get(&s, at);
        (void)loft_settings_spare(&s, at);
    }
    const block now = read_all(&s);
    CHECK(same(&now, &b));
}

/* Any bytes in the memory, also with right heads: one of the copies, or the firmware's values. */
static void any_memory_gives_settings(arb *a)
{
    fresh_memory(a, 0xFF);
    loft_settings s = start();
    block b = read_all(&s);

    b = next_block(a, &b);
    CHECK(write_block(a, &s, &b));
    const unsigned from = arb_below(a, 2) ? 0 : arb_below(a, 2 * ROOM);
    for (unsigned at = from; at < 2 * ROOM; at++)
        memory.byte[at] = (uint8_t)(arb_below(a, 4) ? arb_next(a) : arb_below(a, 2) ? 0 : 0xFF);
    s = start();
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK(axis[i].steps_per_mm > 0);
    const block now = read_all(&s);
    CHECK(loft_settings_origin_of(&s) == LOFT_SETTINGS_KEPT ? same(&now, &b) : has_usual(&s));
}

int main(void)
{
    PROPERTY(a_fresh_machine_has_its_usual_settings, 4);
    PROPERTY(what_is_written_is_kept, 100);
    PROPERTY(a_cut_leaves_the_old_or_the_new, 200);
    PROPERTY(a_head_alone_brings_the_usual_settings, 200);
    PROPERTY(damage_is_found, 2000);
    PROPERTY(impossible_settings_are_refused, 2000);
    EXTREMES(loft_settings_init, any_memory_gives_settings, 2000);
    PROPERTY(any_write_stays_within_the_spare_copy, 500);
    return check_failures();
}
