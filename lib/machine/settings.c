/* lib/machine/settings.c
 * SPDX-License-Identifier: MIT
 *
 * A copy is sound if its CRC is right, so a cut leaves an unsound one, but for 2^-32. The copy in
 * force is never written to. Of two sound copies the newer one counts: the host numbers them,
 * modulo 256.
 */
#include "machine/settings.h"

#include "wire/frame.h"     /* loft_crc */

#define NUMBER_AT 4u
#define LAYOUT_AT 5u
#define SIZE_AT   6u
#define WORDS     (4u * LOFT_AXES)      /* an axis is four words */

static uint8_t byte_of(const loft_settings *s, uint8_t which, uint16_t at)
{
    return s->get(which ? (uint16_t)(s->room + at) : at);
}

static uint32_t word_of(const loft_settings *s, uint8_t which, uint16_t at)
{
    uint32_t word = 0;

    for (uint8_t i = 4; i > 0; i--)
        word = word << 8 | byte_of(s, which, (uint16_t)(at + i - 1u));
    return word;
}

#define NONE 2u

/* What a copy says of its size. */
static uint16_t size_of(const loft_settings *s, uint8_t which)
{
    return (uint16_t)(word_of(s, which, SIZE_AT) & 0xFFFFu);
}

/* True if a copy of this size orders the firmware's values back. */
static bool says_usual(uint16_t size) { return size == LOFT_SETTINGS_AXES; }

/* The copy to write to. */
static uint8_t spare_of(const loft_settings *s) { return s->which == 0; }

/* The words of the axes, in the order of their fields. */
static uint32_t *words_of(const loft_settings *s) { return (uint32_t *)(void *)s->axis; }

static bool copy_sound(const loft_settings *s, uint8_t which)
{
    const uint16_t size = size_of(s, which);
    uint32_t crc        = 0xFFFFFFFFu;

    if (byte_of(s, which, LAYOUT_AT) != LOFT_SETTINGS_LAYOUT || size > s->room ||
        (size < LOFT_SETTINGS_TEXT && !(says_usual(size) && s->usual)))
        return false;
    for (uint16_t at = NUMBER_AT; at < size; at++)
        crc = loft_crc(crc, byte_of(s, which, at));
    if (~crc != word_of(s, which, 0))
        return false;
    for (uint16_t at = LOFT_SETTINGS_AXES; at < LOFT_SETTINGS_WIRING && at < size;
         at          = (uint16_t)(at + 16u))
        if (word_of(s, which, at) == 0 || word_of(s, which, at) >> 31)   /* steps per mm */
            return false;
    return true;
}

static void load_copy(loft_settings *s)
{
    for (uint8_t i = 0; i < WORDS; i++)
        words_of(s)[i] = word_of(s, s->which, (uint16_t)(LOFT_SETTINGS_AXES + 4u * i));
    for (uint8_t i = 0; i < LOFT_WIRING_OBEYED; i++)
        s->wiring[i] = byte_of(s, s->which, (uint16_t)(LOFT_SETTINGS_WIRING + i));
}

static void choose_copy(loft_settings *s)
{
    uint8_t number = 0;

    s->which = NONE;
    for (uint8_t which = 0; which < 2; which++) {
        const uint8_t mine = byte_of(s, which, NUMBER_AT);
        if (copy_sound(s, which) && (s->which == NONE || (uint8_t)(mine - number) < 128)) {
            s->which = which;
            number   = mine;
        }
    }
    if (s->which == NONE)
        return;
    if (says_usual(size_of(s, s->which)))
        s->usual(s);
    else
        load_copy(s);
}

void loft_settings_init(loft_settings *s, loft_axis_config axis[LOFT_AXES])
{
    s->axis = axis;
    choose_copy(s);
}

/* A byte that is right shows what was meant to be settings. */
enum loft_settings_origin loft_settings_origin_of(const loft_settings *s)
{
    if (s->which != NONE)
        return says_usual(size_of(s, s->which)) ? LOFT_SETTINGS_USUAL : LOFT_SETTINGS_KEPT;
    return byte_of(s, 0, LAYOUT_AT) == LOFT_SETTINGS_LAYOUT ||
                   byte_of(s, 1, LAYOUT_AT) == LOFT_SETTINGS_LAYOUT
               ? LOFT_SETTINGS_DAMAGED
               : LOFT_SETTINGS_USUAL;
}

/* The head comes from what is in force, because a board may obey more than when it was written. */
uint8_t loft_settings_get(const loft_settings *s, uint16_t at)
{
    const uint16_t in = (uint16_t)(at - LOFT_SETTINGS_AXES);

    if (in < 4u * WORDS)
        return (uint8_t)(words_of(s)[in / 4u] >> 8u * (in % 4u) & 0xFFu);
    if (in < 4u * WORDS + LOFT_WIRING_BYTES)
        return s->wiring[in - 4u * WORDS];
    if (s->which != NONE)
        return at < size_of(s, s->which) ? byte_of(s, s->which, at) : 0;
    return at == LAYOUT_AT ? LOFT_SETTINGS_LAYOUT : at == SIZE_AT ? LOFT_SETTINGS_TEXT : 0;
}

uint8_t loft_settings_spare(const loft_settings *s, uint16_t at)
{
    return at < s->room ? byte_of(s, spare_of(s), at) : 0;
}

bool loft_settings_put(loft_settings *s, uint16_t at, const uint8_t byte[], uint8_t count)
{
    const uint8_t spare = spare_of(s);
    const uint16_t from  = spare ? s->room : 0;

    for (uint8_t i = 0; i < count; i++) {
        const uint16_t to = (uint16_t)(at + i);
        if (to < s->room && byte_of(s, spare, to) != byte[i])
            s->put((uint16_t)(from + to), byte[i]);
    }
    if (at != 0 || count == 0)
        return false;
    choose_copy(s);
    return s->which == spare;
}
