/* host-tools/send/settings.c
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "machine/settings.h"   /* LOFT_SETTINGS_AXES */
#include "base/memory.h"
#include "send/settings.h"

#define SILENCE  10.0           /* s of silence until we give up */
#define ANSWERS  60.0           /* s without this answer; a line may damage many in a row */
#define MOST     65535u
#define CHECK_BYTES 4
#define JERK_MAX 1e7            /* mm/s^3, of lib/path/limits.h */
#define JERK_PER 20             /* 1/s times the acceleration, as in plan/planning.c */

/* Send one SET. Its answer comes into t->sender.kept. */
static int ask(settings_work *k, const uint8_t byte[], unsigned count, double now)
{
    talk *t = k->t;

    k->until = now + ANSWERS;
    return loft_sender_set(&t->sender, (uint16_t)k->at, byte, (uint8_t)count) == LOFT_OK
               ? 0
               : host_error(t->host, EX_CONFIG, "settings.none-kept",
                            (host_place){ .file = t->port },
                            "give a newer firmware, or --machine FILE to each command",
                            "this machine keeps no settings");
}

/* TASK_GOES until the answer is here. */
static int hear(settings_work *k, double now, task_wants *w)
{
    talk *t = k->t;

    if (t->sender.asking && t->stop)
        return host_error(t->host, EX_TEMPFAIL, "settings.stopped", (host_place){ .file = NULL },
                          NULL, "stopped: the machine has its old settings");
    if (t->sender.asking && !talk_step(t, now, w))
        return talk_vanished(t, "before the machine answered ");
    if (!t->sender.asking)
        return 0;
    task_wake(w, k->until);
    return talk_silence(t, k->until - ANSWERS) <= SILENCE && now <= k->until &&
                   t->sender.phase != LOFT_PHASE_UNFIT
               ? TASK_GOES
               : host_error(t->host, EX_IOERR, "settings.no-answer",
                            (host_place){ .file = t->port },
                            "look at cable and power, and run the same command again",
                            "the machine did not answer");
}

static void begin(settings_work *k, settings *s, talk *t,
                  int (*stage)(settings_work *k, double now, task_wants *w))
{
    *k = (settings_work){ .s = s, .t = t, .stage = stage };
}


// Reading
// -------

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

static int take_block(settings_work *k)
{
    settings *s = k->s;
    char name[200];

    s->number = k->block[4];
    read_axes(s, k->block);
    read_wiring(s, k->block + LOFT_SETTINGS_WIRING);
    k->block[s->size] = '\0';
    snprintf(name, sizeof name, "the settings of %s", k->t->port);
    return s->size > LOFT_SETTINGS_TEXT
               ? machine_text(k->t->host, &s->m, name, (const char *)k->block + LOFT_SETTINGS_TEXT)
               : 0;
}

/* The first answer tells of all of them. */
static void take_head(settings_work *k, const loft_kept *kept)
{
    settings *s = k->s;

    s->origin = kept->origin;
    s->room   = kept->room;
    s->size   = (unsigned)(kept->byte[6] | kept->byte[7] << 8);
    if (s->size < LOFT_SETTINGS_TEXT)       /* the firmware's: see WIRE.md */
        s->size = LOFT_SETTINGS_TEXT;
    k->block = memory_grow(k->block, MOST + LOFT_KEPT_MOST);
}

static int ask_piece(settings_work *k, double now, task_wants *w);
static int end_reading(settings_work *k, double now, task_wants *w);

static int hear_piece(settings_work *k, double now, task_wants *w)
{
    const loft_kept *kept = &k->t->sender.kept;
    const int code        = hear(k, now, w);

    if (code != 0)
        return code;
    if (k->at == 0)
        take_head(k, kept);
    if (kept->count == 0)
        return host_error(k->t->host, EX_PROTOCOL, "settings.end-early",
                          (host_place){ .file = k->t->port }, "please report this",
                          "its settings end early");
    memcpy(k->block + k->at, kept->byte, kept->count);
    k->at += kept->count;
    k->stage = k->at < k->s->size ? ask_piece : end_reading;
    return 0;
}

static int ask_piece(settings_work *k, double now, task_wants *w)
{
    (void)w;
    k->stage = hear_piece;
    return ask(k, NULL, 0, now);
}

static int begin_reading(settings_work *k, double now, task_wants *w)
{
    *k->s = (settings){ .m = machine_usual() };
    k->at = 0;
    return ask_piece(k, now, w);
}

/* Damaged settings are not adopted. */
static int adopt(settings_work *k)
{
    const unsigned warned = k->t->host->warnings;

    if (k->s->origin == LOFT_SETTINGS_KEPT)
        *k->adopts = k->s->m;
    if (k->s->origin == LOFT_SETTINGS_DAMAGED)
        host_warn(k->t->host, "settings.damaged", (host_place){ .file = k->t->port },
                  "it runs with those of its firmware, until `loft set` gives it new ones",
                  "its settings are damaged");
    return host_code(k->t->host, warned, 0);
}

static int end_reading(settings_work *k, double now, task_wants *w)
{
    const int code = take_block(k);

    (void)now;
    (void)w;
    k->stage = NULL;
    if (code == 0 && k->adopts != NULL)
        return adopt(k);
    if (code == 0 && k->resets && k->s->origin == LOFT_SETTINGS_KEPT)
        return host_error(k->t->host, EX_CONFIG, "settings.no-reset",
                          (host_place){ .file = k->t->port },
                          "give a newer one, or set each of them",
                          "its firmware cannot go back to its own settings");
    return code;
}

void settings_read(settings_work *k, settings *s, talk *t) { begin(k, s, t, begin_reading); }

void settings_adopt(settings_work *k, machine_file *m, talk *t)
{
    begin(k, NULL, t, settings_kept(t) ? begin_reading : NULL);
    k->adopts = m;
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
               : host_error(t->host, EX_CONFIG, "settings.fixed", (host_place){ .file = t->port },
                            NULL, "this board cannot do it: %s is fixed in its firmware", key);
}

static int too_long(const settings *s, const talk *t, unsigned size)
{
    return host_error(t->host, EX_CONFIG, "settings.too-long", (host_place){ .file = t->port },
                      "leave some to a --machine FILE",
                      "these settings are %u bytes, and the machine has room for %u", size,
                      s->room);
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

static unsigned piece_of(const settings_work *k)
{
    return k->at < CHECK_BYTES                  ? CHECK_BYTES
           : k->size - k->at < LOFT_KEPT_MOST ? k->size - k->at
                                              : LOFT_KEPT_MOST;
}

static int send_piece(settings_work *k, double now, task_wants *w);

static int greet_again(settings_work *k, double now, task_wants *w)
{
    const int code = talk_greet(k->t, now, w);

    if (code == 0)
        k->stage = k->resets ? begin_reading : NULL;
    return code;
}

/* All but the check; then the check, which puts the block in force. */
static int hear_written(settings_work *k, double now, task_wants *w)
{
    const loft_kept *kept = &k->t->sender.kept;
    const unsigned count  = piece_of(k);
    const int code        = hear(k, now, w);

    if (code != 0)
        return code;
    if (kept->busy)
        return host_error(k->t->host, EX_TEMPFAIL, "settings.busy",
                          (host_place){ .file = k->t->port }, "wait for its end",
                          "a job is running");
    if (kept->count != count || memcmp(kept->byte, k->block + k->at, count) != 0)
        return host_error(
            k->t->host, EX_IOERR, "settings.not-kept", (host_place){ .file = k->t->port }, NULL,
            "the machine's memory does not keep what is written: it has its old settings");
    if (k->at == 0) {
        talk_again(k->t, k->wait);
        k->stage = greet_again;
        return 0;
    }
    k->at += count;
    if (k->at == k->size)
        k->at = 0;
    k->stage = send_piece;
    return 0;
}

static int send_piece(settings_work *k, double now, task_wants *w)
{
    (void)w;
    k->stage = hear_written;
    return ask(k, k->block + k->at, piece_of(k), now);
}

void settings_reset(settings_work *k, settings *s, talk *t, double wait)
{
    begin(k, s, t, send_piece);
    k->wait   = wait;
    k->resets = true;
    k->size   = LOFT_SETTINGS_AXES;
    k->at     = CHECK_BYTES;
    k->block  = memory_grow(NULL, k->size);
    memset(k->block, 0, k->size);
    begin_block(s, k->block, k->size);
    seal(k->block, k->size);
}

static void fill_block(settings_work *k, const char *text, size_t length)
{
    k->size  = LOFT_SETTINGS_TEXT + (unsigned)length;
    k->block = memory_grow(NULL, k->size);
    memset(k->block, 0, k->size);
    begin_block(k->s, k->block, k->size);
    write_axes(&k->s->m, k->block);
    write_wiring(&k->s->m, k->block + LOFT_SETTINGS_WIRING);
    memcpy(k->block + LOFT_SETTINGS_TEXT, text, length);
    seal(k->block, k->size);
}

static int begin_writing(settings_work *k, double now, task_wants *w)
{
    char *text = NULL;
    size_t length;
    const int code = check_obeyed(k->s, k->t);
    FILE *out      = code == 0 ? open_memstream(&text, &length) : NULL;

    if (code != 0)
        return code;
    if (out == NULL)
        return host_error(k->t->host, EX_OSERR, "settings.no-memory", (host_place){ .file = NULL },
                          NULL, "out of memory");
    machine_print(&k->s->m, MACHINE_TEXT, out);
    fclose(out);
    fill_block(k, text, length);
    free(text);
    k->at = CHECK_BYTES;
    return k->size > k->s->room ? too_long(k->s, k->t, k->size) : send_piece(k, now, w);
}

void settings_write(settings_work *k, settings *s, talk *t, double wait)
{
    begin(k, s, t, begin_writing);
    k->wait = wait;
}


// Steps
// -----

int settings_step(settings_work *k, double now, task_wants *w)
{
    int code = 0;

    if (k->s == NULL)
        k->s = &k->own;
    while (code == 0 && k->stage != NULL)
        code = k->stage(k, now, w);
    if (code != TASK_GOES)
        settings_leave(k);
    return code;
}

static int step_settings(void *context, double now, task_wants *w)
{
    return settings_step(context, now, w);
}

task settings_task(settings_work *k) { return (task){ step_settings, k, &k->t->stop }; }

void settings_leave(settings_work *k)
{
    free(k->block);
    k->block = NULL;
    k->stage = NULL;
}
