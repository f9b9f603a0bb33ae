/* tests/lib/wire/fuzz_wire.c -- arbitrary bytes for the receiver, the sender, the codec
 * SPDX-License-Identifier: MIT
 *
 * Parts of patches too, into the machine that cuts them.
 *
 * For libFuzzer (make fuzz), and for test_wire_fuzz.c, which feeds it from a seed. The first byte
 * chooses the target. The rest is raw bytes, or contents that get a right CRC, without which no
 * fuzzer passes the frame.
 */
#include <string.h>

#include "toolpath/patches.h"
#include "support/fuzz.h"
#include "wire/session.h"


// The codec: accepted bytes give the same bytes when packed again
// ---------------------------------------------------------------

static void fuzz_codec(const uint8_t *data, size_t size)
{
    const enum loft_kind kind = size > 0 ? (enum loft_kind)(LOFT_SPANS + data[0] % 4) : LOFT_POINTS;
    const int32_t start[LOFT_AXES] = { 0 };
    loft_predictor there, again;
    uint8_t packed[255];
    loft_unpacker u;
    loft_packer p;
    loft_item item;

    if (size < 2 || size > 250)
        return;
    if (loft_unpacker_init(&u, kind, data + 2, (uint8_t)(size - 2), data[1]) != LOFT_OK)
        return;
    loft_predictor_init(&there, start);
    there.ticks = kind == LOFT_CURVES ? 600 : 0;        /* a feed: the first curve of a job must say
                                                         * one */
    again = there;
    loft_packer_init(&p, kind, &there, packed, 255);
    unsigned count = 0;
    for (; loft_unpacker_next(&u, &there, &item); count++)
        MUST(loft_packer_push(&p, &item) == LOFT_OK);
    MUST(count == data[1] && u.byte == data + size);
    MUST(kind != LOFT_SPANS || (p.size == size - 2 && memcmp(packed, data + 2, p.size) == 0));

    MUST(loft_unpacker_init(&u, kind, packed, p.size, p.count) == LOFT_OK);
    while (loft_unpacker_next(&u, &again, &item)) {
    }
    MUST(memcmp(&there, &again, sizeof there) == 0);
}


// The receiver, in front of an obedient machine
// ---------------------------------------------

typedef struct {
    loft_receiver r;
    loft_snapshot now;
    uint32_t taken;
} machine;

static void obey(machine *m, enum loft_event e, const loft_event_data *data)
{
    switch (e) {
    case LOFT_EVENT_JOB:
        MUST(!loft_state_busy(m->now.state));
        loft_receiver_answer(&m->r, &data->job,
                             data->job.start[0] & 1 ? LOFT_REFUSAL_START : LOFT_REFUSAL_NONE);
        if (!(data->job.start[0] & 1)) {
            m->taken = m->now.executed = 0;
            m->now.state = LOFT_STATE_RUNNING;
        }
        break;
    case LOFT_EVENT_ITEM:
        MUST(m->taken < m->now.executed + 16 &&
             (data->item.ticks >= 1 || m->r.kind == LOFT_CURVES));
        m->taken++;
        break;
    case LOFT_EVENT_END:
        m->now.state = LOFT_STATE_DONE;
        m->now.executed = m->taken;
        break;
    case LOFT_EVENT_HOLD:
        if (m->now.state == LOFT_STATE_RUNNING)
            m->now.state = LOFT_STATE_HELD;
        break;
    case LOFT_EVENT_RESUME:
        if (m->now.state == LOFT_STATE_HELD)
            m->now.state = LOFT_STATE_RUNNING;
        break;
    case LOFT_EVENT_ABORT:
        if (loft_state_busy(m->now.state))
            m->now.state = LOFT_STATE_ABORTED;
        break;
    case LOFT_EVENT_CLOSE:  m->now.state = LOFT_STATE_IDLE; break;
    case LOFT_EVENT_SET:
        MUST(data->set.count <= LOFT_KEPT_MOST && data->set.byte >= m->r.frame.byte &&
             data->set.byte + data->set.count <= m->r.frame.byte + m->r.frame.count);
        break;
    default: break;
    }
}

static void machine_byte(machine *m, uint8_t byte)
{
    loft_event_data data;
    enum loft_event e;

    if (!loft_receiver_push(&m->r, byte))
        return;
    m->now.room = (uint16_t)(16 - (m->taken - m->now.executed));
    const loft_snapshot before = m->now;
    while ((e = loft_receiver_next(&m->r, &before, &data)) != LOFT_EVENT_NONE)
        obey(m, e, &data);
}

static void fuzz_answers(machine *m)
{
    uint8_t wire[LOFT_FRAME_MAX];
    size_t n;
    if (m->now.state == LOFT_STATE_RUNNING && m->taken > m->now.executed)
        m->now.executed++;
    m->now.room = (uint16_t)(16 - (m->taken - m->now.executed));
    for (int frames = 0; (n = loft_receiver_poll(&m->r, &m->now, wire)) > 0; frames++)
        MUST(frames < 20 && n <= 68 && wire[n - 1] == 0);
}

/* Values that no fuzzer guesses: the session and its nonce; and a machine that the sender can
 * use. */
static void make_plausible(uint8_t content[], size_t n, uint8_t session, uint32_t nonce)
{
    const unsigned type = content[0] >> 4;
    content[1] = session;
    if (type != LOFT_HELLO && type != LOFT_WELCOME)
        content[0] = (uint8_t)(type << 4 | LOFT_WIRE_VERSION);
    if (type == LOFT_JOB && n > 6)
        for (int i = 0; i < 4; i++)
            content[2 + i] = (uint8_t)(nonce >> (8 * i));
    if (type == LOFT_WELCOME && n >= 40) {
        content[2] = LOFT_WIRE_VERSION;
        for (int i = 0; i < 4; i++)
            content[3 + i] = (uint8_t)(nonce >> (8 * i));
        content[31]  = LOFT_AXES;
        content[33] |= 0x80;
        content[34] |= 1, content[36] |= 1, content[38] |= 1;
        content[1]  |= 1;
    }
}

/* Contents: a length, then as many bytes, which become a frame; made plausible unless bit 7 is
 * set. */
static size_t fuzz_frame(const uint8_t **data, size_t *size, uint8_t session, uint32_t nonce,
                         uint32_t seal, uint8_t wire[LOFT_FRAME_MAX])
{
    size_t n = **data & 0x7F;
    const bool plausible = !(**data & 0x80);
    (*data)++, (*size)--;
    n = n < *size ? n : *size;
    n = n < LOFT_FRAME_CONTENT ? n : LOFT_FRAME_CONTENT;
    memcpy(wire + 1, *data, n);
    *data += n, *size -= n;
    if (plausible && n >= 2)
        make_plausible(wire + 1, n, session, nonce);
    const unsigned type = n > 0 ? wire[1] >> 4 : 0;
    return loft_frame_seal(wire, n,
                           type == LOFT_DATA_SPANS || type == LOFT_DATA_POINTS ||
                                   type == LOFT_DATA_FINE || type == LOFT_DATA_CURVES
                               ? seal
                               : 0);
}

static void fuzz_receiver(const uint8_t *data, size_t size, bool raw)
{
    static const loft_machine_info info = { .boot = 7,
                                        .tick_hz = 1000,
                                        .slots = 40,
                                        .queue = 16,
                                        .points = 80,
                                        .curves = 16,
                                        .kinds = 1u << LOFT_SPANS | 1u << LOFT_POINTS |
                                                 1u << LOFT_CURVES | LOFT_TAKES_SETTINGS };
    uint8_t wire[LOFT_FRAME_MAX];
    machine m;

    memset(&m, 0, sizeof m);
    MUST(loft_receiver_init(&m.r, &info) == LOFT_OK);
    while (size > 0) {
        if (raw) {
            machine_byte(&m, *data++), size--;
        } else {
            const size_t n = fuzz_frame(&data, &size, m.r.session, m.r.nonce,
                                        loft_predictor_seal(&m.r.predictor), wire);
            for (size_t i = 0; i < n; i++)
                machine_byte(&m, wire[i]);
        }
        fuzz_answers(&m);
    }
}


// The sender
// ----------

static void fuzz_source(void *context, uint32_t index, loft_item *out)
{
    const uint32_t *count = context;
    MUST(index < *count);
    memset(out, 0, sizeof *out);
    out->ticks = (uint16_t)(1 + index % 50);
    for (int i = 0; i < LOFT_AXES; i++)
        for (int k = 0; k < 3; k++)
            out->p[k][i] = (int32_t)(index * 1000003u + (uint32_t)(i * 7919 + k));
}

static void fuzz_sender_poll(loft_sender *s, uint32_t now)
{
    uint8_t wire[LOFT_FRAME_MAX];
    for (int frames = 0; frames < 10; frames++) {
        const size_t n = loft_sender_poll(s, now, wire);
        if (n == 0)
            return;
        MUST(n <= LOFT_FRAME_MAX && wire[n - 1] == 0);
        MUST(s->phase != LOFT_PHASE_STREAMING ||
             (s->window.base <= s->window.send && s->window.send <= s->window.high &&
              s->window.high <= s->window.count));
    }
}

static void fuzz_sender(const uint8_t *data, size_t size, bool raw)
{
    static const loft_job job = { .id = 5, .kind = LOFT_SPANS };
    uint32_t now = 0xFFFFFF00u, count = 100;
    uint8_t wire[LOFT_FRAME_MAX];
    loft_sender s;

    loft_sender_init(&s, 1, now);
    while (size > 0) {
        size_t n = 1;
        if (raw)
            wire[0] = *data++, size--;
        else
            n = fuzz_frame(&data, &size, s.session, s.nonce, 0, wire);
        for (size_t i = 0; i < n; i++)
            loft_sender_push(&s, wire[i], now);
        const bool asking = s.asking;
        MUST(s.kept.count <= LOFT_KEPT_MOST);
        if (s.phase == LOFT_PHASE_READY && n % 2 && s.machine.kinds & LOFT_TAKES_SETTINGS)
            MUST((loft_sender_set(&s, (uint16_t)(size % 64), wire, (uint8_t)(n % 33)) == LOFT_OK) ==
                 !asking);
        else if (s.phase == LOFT_PHASE_READY)
            MUST(loft_sender_begin(&s, &job, count, fuzz_source, &count) == LOFT_OK);
        if (n == 0 && size > 0)
            loft_sender_control(&s, (enum loft_verb)(1 + *data % 3));
        fuzz_sender_poll(&s, now);
        MUST(loft_sender_wait(&s, now) <= 2000);
        now += size % 64;
    }
}


// A patch: it is refused, or cut from its place and back to it
// ------------------------------------------------------------

static uint8_t fuzz_byte(const uint8_t **data, size_t *size)
{
    if (*size == 0)
        return 0;
    (*size)--;
    return *(*data)++;
}

/* Any number, small or large. */
static int32_t fuzz_number(const uint8_t **data, size_t *size)
{
    uint32_t x = 0;
    const unsigned shift = fuzz_byte(data, size) % 32;

    for (int i = 0; i < 4; i++)
        x = x << 8 | fuzz_byte(data, size);
    return (int32_t)x / (int32_t)(1u << (shift < 31 ? shift : 30));
}

/* A head as a host may make one, or any part. */
static void fuzz_part(const uint8_t **data, size_t *size, bool head, loft_item *out)
{
    const uint8_t kind = fuzz_byte(data, size);

    memset(out, 0, sizeof *out);
    for (int k = 0; k < (kind % 16 ? 2 : 3); k++)
        for (int i = 0; i < LOFT_AXES; i++)
            out->p[k][i] = fuzz_number(data, size);
    if (!head || kind % 8 == 0)
        return;
    const loft_patch_head h = { .radius = 65536 + 4096 * kind,
                                .tol = 2048 + 64 * kind,
                                .safe = 65536 * (1 + kind % 32),
                                .rows = (uint16_t)(1 + kind % 7),
                                .columns = (uint16_t)(1 + kind % 36),
                                .feed = 1200,
                                .rapid = 3000,
                                .m = (uint8_t)(1 + kind % 3),
                                .n = (uint8_t)(1 + kind / 3 % 3),
                                .one_way = kind % 2 > 0 };
    loft_patch_item(out, &h, out->p[2]);
}

static void fuzz_patch(const uint8_t *data, size_t size)
{
    static const loft_vec place = { { 0 } };
    static loft_tip row[33];
    static loft_patches p;
    loft_vec at = place;
    loft_cubic curve;
    loft_item part;
    uint16_t feed;
    unsigned given = 0;

    loft_patch_source *source = loft_patches_init(&p, row, 32);
    for (unsigned n = 0; n < 1 + LOFT_PATCH_PARTS; n++) {
        fuzz_part(&data, &size, n == 0, &part);
        const uint8_t before             = source->state;
        const enum loft_refusal refusal = source->take(source, &part, &place);
        MUST(refusal == LOFT_REFUSAL_NONE || refusal == LOFT_REFUSAL_ITEM ||
             refusal == LOFT_REFUSAL_PATCH);
        MUST(refusal != LOFT_REFUSAL_ITEM || source->state == before);
        MUST(refusal != LOFT_REFUSAL_NONE || source->state == LOFT_PATCH_GATHERED ||
             source->state == LOFT_PATCH_CUT);
        if (source->state >= LOFT_PATCH_CUT)
            break;
    }
    for (; source->next(source, &curve, &feed) && given < 8 * 40; given++) {
        MUST(loft_vec_equal(curve.p[0], at) && feed > 0);
        MUST(loft_vec_within(curve.p[3], LOFT_REAL(LOFT_LINES_REACH + LOFT_LINES_RADIUS)));
        at = curve.p[3];
    }
    MUST(given < 8 * 40 && loft_vec_equal(at, place));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size == 0)
        return 0;
    switch (data[0] % 6) {
    case 0: fuzz_codec(data + 1, size - 1);             break;
    case 1: fuzz_receiver(data + 1, size - 1, true);    break;
    case 2: fuzz_receiver(data + 1, size - 1, false);   break;
    case 3: fuzz_sender(data + 1, size - 1, true);      break;
    case 4: fuzz_sender(data + 1, size - 1, false);     break;
    case 5: fuzz_patch(data + 1, size - 1);             break;
    }
    return 0;
}
