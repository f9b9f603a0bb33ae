/* tests/lib/machine/test_flash_log.c -- properties of ports/flash_log.h, and of settings on it,
 * over a model of flash: the power may fail in any word and any erasure
 * SPDX-License-Identifier: MIT
 */
#include <string.h>

#include "check.h"
#include "flash_log.h"
#include "machine/settings.h"
#include "target/arm_flash.h"

#define ROOM     100u
#define WORDS    450u           /* of a sector: it is full after two or three writes of settings */
#define FOREVER  0xFFFFFFFFu

static struct {
    uint32_t word[2][WORDS];
    uint32_t power;             /* words and erasures until it fails */
    uint32_t worn;              /* one word of so many takes nothing; 0: all do */
    uint32_t erased;            /* times */
    arb     *a;
} flash;

static uint8_t bytes[2 * ROOM];
static loft_flash_log kept;

static uint32_t read_word(uint8_t sector, uint32_t word)
{
    CHECK(sector < 2 && word < WORDS);
    return flash.word[sector][word];
}

/* A word is written once after it was erased, and writing makes zeros. The word at which the power
 * fails has some of them. */
static void write_word(uint8_t sector, uint32_t word, uint32_t value)
{
    uint32_t *at = &flash.word[sector][word];

    CHECK(sector < 2 && word < WORDS && value != LOFT_FLASH_ERASED);
    if (flash.power == 0)
        return;
    CHECK(*at == LOFT_FLASH_ERASED);
    if (--flash.power == 0)
        *at &= value | (uint32_t)arb_next(flash.a);
    else if (flash.worn == 0 || arb_below(flash.a, flash.worn))
        *at &= value;
    else
        *at &= value | 1u << 3 | 1u << 25;
}

/* An erasure at which the power fails leaves some zeros in any words. */
static void erase_sector(uint8_t sector)
{
    const bool cut = flash.power == 1, few = arb_below(flash.a, 2);

    CHECK(sector < 2);
    if (flash.power == 0)
        return;
    flash.power--;
    flash.erased++;
    for (uint32_t k = 0; k < WORDS; k++)
        if (!cut)
            flash.word[sector][k] = LOFT_FLASH_ERASED;
        else if (!few || arb_below(flash.a, 4) == 0)
            flash.word[sector][k] |= (uint32_t)arb_next(flash.a);
}

static uint8_t get_byte(uint16_t at) { return kept.byte[at]; }
static void put_byte(uint16_t at, uint8_t byte) { loft_flash_put(&kept, at, byte); }

static void start_log(void)
{
    kept = (loft_flash_log){ .read = read_word,
                             .write = write_word,
                             .erase = erase_sector,
                             .words = WORDS,
                             .byte = bytes,
                             .bytes = sizeof bytes };
    memset(bytes, 0x55, sizeof bytes);
    loft_flash_init(&kept);
}

static void fresh_flash(arb *a)
{
    memset(&flash, 0xFF, sizeof flash);
    flash.power = FOREVER;
    flash.worn = flash.erased = 0;
    flash.a                   = a;
    start_log();
}

static void a_word_with_missing_zeros_is_found(arb *a)
{
    const uint32_t word = loft_flash_word((uint32_t)arb_next(a) & 0xFFFFFFu),
                   torn = word | ((uint32_t)arb_next(a) & (uint32_t)arb_next(a));

    CHECK(loft_flash_sound(word) && word != LOFT_FLASH_ERASED);
    CHECK(loft_flash_sound(torn) == (torn == word));
    for (uint32_t k = 0; k < 32; k++)
        CHECK(word >> k & 1u || !loft_flash_sound(word | 1u << k));
}

static void bytes_are_kept(arb *a)
{
    uint8_t want[sizeof bytes];

    fresh_flash(a);
    flash.worn = arb_below(a, 2) ? 20 : 0;
    memset(want, 0xFF, sizeof want);
    for (uint32_t n = 1 + (uint32_t)arb_below(a, 2000); n > 0; n--) {
        const uint16_t at = (uint16_t)arb_below(a, sizeof bytes);
        want[at]          = (uint8_t)arb_next(a);
        put_byte(at, want[at]);
        CHECK(flash.worn || bytes[at] == want[at]);
        want[at] = bytes[at];           /* a worn sector may take no header */
        if (arb_below(a, 50) == 0)
            start_log();
    }
    CHECK(memcmp(want, bytes, sizeof want) == 0);
    start_log();
    CHECK(memcmp(want, bytes, sizeof want) == 0);
}

/* A byte that flash no longer takes reads as what is kept. */
static void worn_flash_keeps_what_it_says(arb *a)
{
    uint8_t said[sizeof bytes];

    fresh_flash(a);
    put_byte(3, 7);
    flash.worn = 1;                     /* no word takes anything */
    put_byte((uint16_t)(4 + arb_below(a, 100)), 9);
    memcpy(said, bytes, sizeof said);
    CHECK(said[3] == 7);
    start_log();
    CHECK(memcmp(said, bytes, sizeof said) == 0);
}

static loft_axis_config axis[LOFT_AXES];

static loft_settings start_settings(void)
{
    loft_settings s = { .get = get_byte, .put = put_byte, .room = ROOM };

    start_log();
    for (int i = 0; i < LOFT_AXES; i++)
        axis[i] = (loft_axis_config){ 80 * 65536, 100 * 65536, 500 * 65536, 10000 };
    loft_settings_init(&s, axis);
    return s;
}

/* Settings whose every number is `number`. */
static void write_settings(loft_settings *s, uint8_t number)
{
    uint8_t b[LOFT_SETTINGS_TEXT];
    uint32_t crc = 0xFFFFFFFFu;

    memset(b, number & 0x7F, sizeof b);
    b[4] = number;
    b[5] = LOFT_SETTINGS_LAYOUT;
    b[6] = sizeof b;
    b[7] = 0;
    for (uint16_t at = 4; at < sizeof b; at++)
        crc = loft_crc(crc, b[at]);
    for (int i = 0; i < 4; i++)
        b[i] = (uint8_t)(~crc >> 8 * i & 0xFF);
    for (uint16_t at = 4; at < sizeof b; at = (uint16_t)(at + 16))
        (void)loft_settings_put(s, at, b + at, (uint8_t)(sizeof b - at < 16 ? sizeof b - at : 16));
    (void)loft_settings_put(s, 0, b, 4);
}

static bool in_force(const loft_settings *s, uint8_t number)
{
    const uint32_t word = 0x01010101u * (number & 0x7Fu);

    for (int i = 0; i < LOFT_AXES; i++)
        if ((uint32_t)axis[i].steps_per_mm != word || axis[i].max_jerk != word)
            return false;
    return s->wiring[LOFT_WIRING_REVERSED] == (number & 0x7F) &&
           loft_settings_origin_of(s) == LOFT_SETTINGS_KEPT;
}

/* Each word and each erasure of a write, one after the other; then another cut soon after it; then
 * the write goes through. */
static void a_cut_leaves_the_old_or_the_new(arb *a)
{
    static uint32_t before[2][WORDS];
    const uint8_t number = (uint8_t)(1 + arb_below(a, 100));
    uint32_t olds = 0;
    bool whole = false;

    fresh_flash(a);
    loft_settings s = start_settings();
    for (uint8_t k = 0; k <= arb_below(a, 12); k++)
        write_settings(&s, (uint8_t)(number - 1 + k / 100));
    write_settings(&s, number);
    memcpy(before, flash.word, sizeof before);
    for (uint32_t cut = 1; !whole; cut++) {
        memcpy(flash.word, before, sizeof before);
        flash.power = cut;
        s           = start_settings();
        write_settings(&s, (uint8_t)(number + 1));
        whole       = flash.power > 0;
        flash.power = FOREVER;
        s           = start_settings();
        CHECK(in_force(&s, (uint8_t)(number + 1)) || (!whole && in_force(&s, number)));
        olds += in_force(&s, number);
        flash.power = (uint32_t)arb_below(a, 90);
        write_settings(&s, (uint8_t)(number + 1));
        flash.power = FOREVER;
        s           = start_settings();
        CHECK(in_force(&s, (uint8_t)(number + 1)) || in_force(&s, number));
        write_settings(&s, (uint8_t)(number + 2));
        s = start_settings();
        CHECK(in_force(&s, (uint8_t)(number + 2)));
    }
    CHECK(olds >= 50);
}

static struct arm_flash chip;

static void unlock_chip(uint32_t first, uint32_t second)
{
    arm_flash_write(&chip, ARM_FLASH_KEYR, first);
    arm_flash_write(&chip, ARM_FLASH_KEYR, second);
}

static void order_chip(uint32_t order) { arm_flash_write(&chip, ARM_FLASH_CR, order); }

static bool store_in_chip(uint32_t at, uint32_t value)
{
    arm_flash_store(&chip, ARM_FLASH_AT + 4 * at, value, 4);
    return *arm_flash_word(&chip, ARM_FLASH_AT + 4 * at) == value;
}

/* The model of the emulated chip, RM0090, chapter 3: PSIZE 2 is a word; PG, SER, STRT. */
static void the_controller_refuses_wrong_orders(arb *a)
{
    const uint32_t pg = 2u << 8 | 1, ser = 2u << 8 | 2, strt = 1u << 16,
                   at = (uint32_t)arb_below(a, 2 * ARM_FLASH_WORDS),
                   sector = ARM_FLASH_FIRST + at / ARM_FLASH_WORDS;
    const uint32_t key = 0x45670123u ^ 1u << arb_below(a, 32);

    arm_flash_erase_all(&chip);
    arm_flash_reset(&chip);
    CHECK(!store_in_chip(at, 0x1234u));                     /* locked */
    unlock_chip(key, 0xCDEF89ABu);
    unlock_chip(0x45670123u, 0xCDEF89ABu);                  /* too late, until reset */
    order_chip(pg);
    CHECK(!store_in_chip(at, 0x1234u) && chip.control == ARM_FLASH_LOCK);
    arm_flash_reset(&chip);
    unlock_chip(0x45670123u, 0xCDEF89ABu);
    CHECK(!store_in_chip(at, 0x1234u) && chip.status >> 7 & 1);     /* without PG */
    order_chip(1);
    CHECK(!store_in_chip(at, 0x1234u) && chip.status >> 6 & 1);     /* PSIZE is a byte */
    order_chip(pg);
    CHECK(store_in_chip(at, 0x1234u));
    CHECK(!store_in_chip(at, 0x4321u) && store_in_chip(at, 0x0220u));   /* zeros stay */
    order_chip(ser | (sector ^ 1) << 3 | strt);
    CHECK(*arm_flash_word(&chip, ARM_FLASH_AT + 4 * at) == 0x0220u);
    order_chip(ser | 9u << 3 | strt);
    order_chip(strt);
    CHECK(*arm_flash_word(&chip, ARM_FLASH_AT + 4 * at) == 0x0220u);
    order_chip(ser | sector << 3 | strt);
    order_chip(pg);
    CHECK(store_in_chip(at, 0x4321u));
    order_chip(ARM_FLASH_LOCK);
    CHECK(!store_in_chip(at, 0x4321u ^ 1) && chip.control >> 31);
    arm_flash_write(&chip, ARM_FLASH_SR, 0xF3);
    CHECK(chip.status == 0);
}

int main(void)
{
    PROPERTY(a_word_with_missing_zeros_is_found, 2000);
    PROPERTY(bytes_are_kept, 100);
    PROPERTY(worn_flash_keeps_what_it_says, 100);
    PROPERTY(a_cut_leaves_the_old_or_the_new, 60);
    PROPERTY(the_controller_refuses_wrong_orders, 200);
    return check_failures();
}
