/* host-tools/send/settings.c
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "machine/settings.h"   /* LOFT_SETTINGS_AXES */
#include "cmd/keys.h"          /* keys_interrupted */
#include "base/tool.h"
#include "send/settings.h"

#define SILENCE  10.0           /* s of silence until we give up */
#define ANSWERS  60.0           /* s without this answer; a line may damage many in a row */
#define MOST     65535u
#define CHECK_BYTES 4
#define JERK_MAX 1e7            /* mm/s^3, of lib/path/limits.h */
#define JERK_PER 20             /* 1/s times the acceleration, as in plan/planning.c */

/* Send one SET and wait for its answer, in t->sender.kept. */
static int ask(talk *t, unsigned at, const uint8_t byte[], unsigned count)
{
    const double until = tool_clock() + ANSWERS;

    if (loft_sender_set(&t->sender, (uint16_t)at, byte, (uint8_t)count) != LOFT_OK)
        return tool_error(EX_CONFIG,
                          "%s: this machine keeps no settings: give a newer firmware, or --machine "
                          "FILE to each command",
                          t->port);
    while (t->sender.asking) {
        if (keys_interrupted())
            return tool_error(EX_TEMPFAIL, "stopped: the machine has its old settings");
        if (!talk_pump(t, 20))
            return talk_vanished(t, "before the machine answered ");
        if (talk_silence(t) > SILENCE || tool_clock() > until ||
            t->sender.phase == LOFT_PHASE_UNFIT)
            return tool_error(
                EX_IOERR,
                "%s: the machine did not answer: look at cable and power, and run the "
                "same command again",
                t->port);
    }
    return 0;
}


// Reading
// -------

/* All bytes, in *block, which the caller frees. */
static int read_block(settings *s, talk *t, uint8_t **block)
{
    unsigned have = 0;

    s->size = LOFT_KEPT_MOST;
    do {
        const int code = ask(t, have, NULL, 0);
        if (code != 0)
            return code;
        const loft_kept *k = &t->sender.kept;
        if (have == 0) {
            s->origin = k->origin;
            s->room   = k->room;
            s->size   = (unsigned)(k->byte[6] | k->byte[7] << 8);
            if (s->size < LOFT_SETTINGS_TEXT)       /* the firmware's: see WIRE.md */
                s->size = LOFT_SETTINGS_TEXT;
            *block    = tool_grow(NULL, MOST + LOFT_KEPT_MOST);
        }
        if (k->count == 0)
            return tool_error(EX_PROTOCOL, "%s: its settings end early: please report this",
                              t->port);
        memcpy(*block + have, k->byte, k->count);
        have += k->count;
    } while (have < s->size);
    return 0;
}

static uint32_t word_at(const uint8_t *byte)
{
    return byte[0] | (uint32_t)byte[1] << 8 | (uint32_t)byte[2] << 16 | (uint32_t)byte[3] << 24;
}

/* The shortest decimal that is this raw Q16.16. */
static double plain(uint32_t raw)
{
    const double exact = (double)(int32_t)raw / 65536;
    char text[40];

    for (int digits = 1; digits < 17; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, exact);
        if (lround(strtod(text, NULL) * 65536) == (int32_t)raw)
            return strtod(text, NULL);
    }
    return exact;
}

static void read_axes(settings *s, const uint8_t *block)
{
    machine_file *m = &s->m;

    for (int i = 0; i < ENGINE_AXES && i < LOFT_AXES; i++) {
        const uint8_t *axis = block + LOFT_SETTINGS_AXES + 16 * i;
        m->steps_per_mm[i]  = plain(word_at(axis));
        m->max_speed[i]     = plain(word_at(axis + 4));
        m->max_accel[i]     = plain(word_at(axis + 8));
        m->max_jerk[i]      = word_at(axis + 12);
        /* a firmware that says none has not been asked yet */
        if (s->origin != LOFT_SETTINGS_KEPT && m->max_jerk[i] <= 0)
            m->max_jerk[i] = fmin(JERK_PER * m->max_accel[i], JERK_MAX);
    }
}

static bool obeys(const settings *s, enum loft_wiring what) { return s->obeyed & 1u << what; }

static void read_wiring(settings *s, const uint8_t *wiring)
{
    const unsigned opens = wiring[LOFT_WIRING_OPENS] + 256u * wiring[LOFT_WIRING_OPENS + 1];
    machine_file *m      = &s->m;

    s->obeyed = wiring[LOFT_WIRING_OBEYED];
    for (int i = 0; i < ENGINE_AXES; i++) {
        m->reversed[i]    = wiring[LOFT_WIRING_REVERSED] >> i & 1;
        m->limit_opens[i] = (opens & LOFT_INPUT_ENDS(i)) != 0;
    }
    m->probe_opens  = (opens & LOFT_INPUT_PROBE) != 0;
    m->buttons_open = (opens & LOFT_INPUT_STOP) != 0;
    m->drive[2]     = obeys(s, LOFT_WIRING_SERVO) ? wiring[LOFT_WIRING_SERVO] > 0 : -1;
    m->servo_zero   = wiring[LOFT_WIRING_SERVO] > 0 ? 10 * wiring[LOFT_WIRING_SERVO] : -1;
    m->idle         = obeys(s, LOFT_WIRING_IDLE) ? wiring[LOFT_WIRING_IDLE] : -1;
    m->pulse        = obeys(s, LOFT_WIRING_PULSE) ? wiring[LOFT_WIRING_PULSE] : -1;
}

int settings_read(settings *s, talk *t)
{
    uint8_t *block = NULL;
    char name[200];

    *s = (settings){ .m = machine_usual() };
    int code = read_block(s, t, &block);
    if (code == 0) {
        s->number = block[4];
        read_axes(s, block);
        read_wiring(s, block + LOFT_SETTINGS_WIRING);
        block[s->size] = '\0';
        snprintf(name, sizeof name, "the settings of %s", t->port);
        if (s->size > LOFT_SETTINGS_TEXT)
            code = machine_text(&s->m, name, (const char *)block + LOFT_SETTINGS_TEXT);
    }
    free(block);
    return code;
}

int settings_adopt(machine_file *m, talk *t)
{
    settings s;

    if (!settings_kept(t))
        return 0;
    const int code = settings_read(&s, t);
    if (code != 0)
        return code;
    if (s.origin == LOFT_SETTINGS_KEPT)
        *m = s.m;
    if (s.origin == LOFT_SETTINGS_DAMAGED)
        (void)tool_error(EX_OK,
                         "%s: its settings are damaged: it runs with those of its firmware, until "
                         "`loft set` gives it new ones",
                         t->port);
    return 0;
}


// Writing
// -------

static void put_word(uint8_t *byte, uint32_t word)
{
    for (int i = 0; i < 4; i++, word >>= 8)
        byte[i] = (uint8_t)(word & 0xFF);
}

static uint32_t raw_of(double x) { return (uint32_t)(int32_t)lround(x * 65536); }

static void write_axes(const machine_file *m, uint8_t *block)
{
    for (int i = 0; i < ENGINE_AXES && i < LOFT_AXES; i++) {
        uint8_t *axis = block + LOFT_SETTINGS_AXES + 16 * i;
        put_word(axis, raw_of(m->steps_per_mm[i]));
        put_word(axis + 4, raw_of(m->max_speed[i]));
        put_word(axis + 8, raw_of(m->max_accel[i]));
        put_word(axis + 12, (uint32_t)lround(m->max_jerk[i]));
    }
}

/* us; the middle of a servo without a word. */
static double servo_zero(const machine_file *m) { return m->servo_zero > 0 ? m->servo_zero : 1500; }

static void write_wiring(const machine_file *m, uint8_t *wiring)
{
    unsigned reversed = 0, opens = 0;

    for (int i = 0; i < ENGINE_AXES; i++) {
        reversed |= m->reversed[i] > 0 ? 1u << i : 0;
        opens    |= m->limit_opens[i] > 0 ? LOFT_INPUT_ENDS(i) : 0u;
    }
    opens |= m->probe_opens > 0 ? LOFT_INPUT_PROBE : 0;
    opens |= m->buttons_open > 0 ? LOFT_INPUT_STOP | LOFT_INPUT_HOLD | LOFT_INPUT_RESUME : 0;
    wiring[LOFT_WIRING_REVERSED]  = (uint8_t)reversed;
    wiring[LOFT_WIRING_SERVO]     = (uint8_t)(m->drive[2] > 0 ? lround(servo_zero(m) / 10) : 0);
    wiring[LOFT_WIRING_PULSE]     = (uint8_t)fmax(m->pulse, 0);
    wiring[LOFT_WIRING_IDLE]      = (uint8_t)fmax(m->idle, 0);
    wiring[LOFT_WIRING_OPENS]     = (uint8_t)(opens & 0xFF);
    wiring[LOFT_WIRING_OPENS + 1] = (uint8_t)(opens >> 8);
}

/* Refuse, by name, what the board cannot do. */
static int check_obeyed(const settings *s, const talk *t)
{
    const machine_file *m = &s->m;
    bool reversed = false, opens = m->probe_opens > 0 || m->buttons_open > 0;

    for (int i = 0; i < ENGINE_AXES; i++) {
        reversed = reversed || m->reversed[i] > 0;
        opens    = opens || m->limit_opens[i] > 0;
    }
    const char *key = reversed && !obeys(s, LOFT_WIRING_REVERSED) ? "reversed"
                      : opens && !obeys(s, LOFT_WIRING_OPENS)     ? "contacts that open"
                      : m->drive[2] > 0 && !obeys(s, LOFT_WIRING_SERVO) ? "z.drive = step"
                      : m->idle >= 0 && !obeys(s, LOFT_WIRING_IDLE) ? "idle"
                      : m->pulse >= 0 && !obeys(s, LOFT_WIRING_PULSE) ? "pulse"
                                                                        : NULL;

    return key == NULL
               ? 0
               : tool_error(EX_CONFIG, "%s: this board cannot do it: %s is fixed in its firmware",
                            t->port, key);
}

static int too_long(const settings *s, const talk *t, unsigned size)
{
    return tool_error(
        EX_CONFIG,
        "%s: these settings are %u bytes, and the machine has room for %u: leave some "
        "to a --machine FILE",
        t->port, size, s->room);
}

static int write_piece(talk *t, const uint8_t *block, unsigned at, unsigned count)
{
    const loft_kept *k = &t->sender.kept;
    const int code     = ask(t, at, block + at, count);

    if (code != 0)
        return code;
    if (k->busy)
        return tool_error(EX_TEMPFAIL, "%s: a job is running: wait for its end", t->port);
    if (k->count == count && memcmp(k->byte, block + at, count) == 0)
        return 0;
    return tool_error(EX_IOERR,
                      "%s: the machine's memory does not keep what is written: it has its old "
                      "settings",
                      t->port);
}

/* All but the check; then the check, which puts the block in force. */
static int write_block(talk *t, const uint8_t *block, unsigned size)
{
    int code = 0;

    for (unsigned at = CHECK_BYTES; at < size && code == 0; at += LOFT_KEPT_MOST)
        code = write_piece(t, block, at, size - at < LOFT_KEPT_MOST ? size - at : LOFT_KEPT_MOST);
    return code ? code : write_piece(t, block, 0, CHECK_BYTES);
}

static void seal(uint8_t *block, unsigned size)
{
    uint32_t crc = 0xFFFFFFFFu;

    for (unsigned at = 4; at < size; at++)
        crc = loft_crc(crc, block[at]);
    put_word(block, ~crc);
}

static void begin_block(const settings *s, uint8_t *block, unsigned size)
{
    block[4] = (uint8_t)(s->number + 1);
    block[5] = LOFT_SETTINGS_LAYOUT;
    block[6] = (uint8_t)(size & 0xFF);
    block[7] = (uint8_t)(size >> 8);
}

int settings_reset(settings *s, talk *t, double wait)
{
    uint8_t block[LOFT_SETTINGS_AXES];

    begin_block(s, block, sizeof block);
    seal(block, sizeof block);
    int code = write_block(t, block, sizeof block);
    if (code == 0)
        code = talk_again(t, wait);
    if (code == 0)
        code = settings_read(s, t);
    if (code == 0 && s->origin == LOFT_SETTINGS_KEPT)
        code = tool_error(EX_CONFIG,
                          "%s: its firmware cannot go back to its own settings: give a newer one, "
                          "or set each of them",
                          t->port);
    return code;
}

int settings_write(const settings *s, talk *t, double wait)
{
    char *text = NULL;
    size_t length;
    FILE *out = open_memstream(&text, &length);
    int code  = check_obeyed(s, t);

    if (out == NULL)
        return tool_error(EX_OSERR, "out of memory");
    machine_print(&s->m, MACHINE_TEXT, out);
    fclose(out);
    const unsigned size = LOFT_SETTINGS_TEXT + (unsigned)length;
    uint8_t *block      = tool_grow(NULL, size);
    memset(block, 0, size);
    begin_block(s, block, size);
    write_axes(&s->m, block);
    write_wiring(&s->m, block + LOFT_SETTINGS_WIRING);
    memcpy(block + LOFT_SETTINGS_TEXT, text, length);
    seal(block, size);
    if (code == 0 && size > s->room)
        code = too_long(s, t, size);
    if (code == 0)
        code = write_block(t, block, size);
    if (code == 0)
        code = talk_again(t, wait);
    free(block);
    free(text);
    return code;
}
