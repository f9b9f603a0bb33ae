/* host-tools/send/wire_text.c
 * SPDX-License-Identifier: MIT
 */
#include <inttypes.h>
#include <string.h>

#include "send/wire_text.h"

static const char *const names[16] = { [LOFT_HELLO] = "HELLO",      [LOFT_JOB] = "JOB",
                                       [LOFT_DATA_SPANS] = "SPANS", [LOFT_DATA_POINTS] = "POINTS",
                                       [LOFT_END] = "END",          [LOFT_CONTROL] = "CONTROL",
                                       [LOFT_POLL] = "POLL",        [LOFT_WELCOME] = "WELCOME",
                                       [LOFT_AXIS] = "AXIS",        [LOFT_ACK] = "ACK",
                                       [LOFT_STATUS] = "STATUS",    [LOFT_REPORT] = "REPORT",
                                       [LOFT_DATA_FINE] = "FINE",   [LOFT_DATA_CURVES] = "CURVES",
                                       [LOFT_SET] = "SET",          [LOFT_KEPT] = "KEPT" };

static const char *word_of(const char *const list[], size_t count, unsigned index)
{
    return index < count && list[index] != NULL ? list[index] : "?";
}

#define WORD(list, index) word_of(list, sizeof list / sizeof *list, index)

static const char *state_word(unsigned state)
{
    static const char *const words[] = { "idle",     "running", "holding", "held",
                                         "stopping", "done",    "aborted", "fault" };
    return WORD(words, state);
}

static const char *kind_word(unsigned kind)
{
    static const char *const words[] = {
        [LOFT_SPANS] = "spans", [LOFT_POINTS] = "points", [4] = "curves"
    };
    return WORD(words, kind);
}

static const char *verb_word(unsigned verb)
{
    static const char *const words[] = { [LOFT_HOLD] = "hold",
                                         [LOFT_RESUME] = "resume",
                                         [LOFT_ABORT] = "abort",
                                         [LOFT_CLOSE] = "close",
                                         [LOFT_OVERRIDE] = "override",
                                         [LOFT_PLACE] = "place",
                                         [LOFT_TABLE_LOW] = "table from",
                                         [LOFT_TABLE_HIGH] = "table to" };
    return WORD(words, verb);
}

static void print_places(FILE *out, const char *name, const int32_t place[LOFT_AXES])
{
    fprintf(out, " %s", name);
    for (int i = 0; i < LOFT_AXES; i++)
        fprintf(out, " %" PRId32, place[i]);
}

static void print_ack(FILE *out, const loft_ack *a)
{
    static const char *const refusals[] = {
        "",      "busy",       "wrong start",  "unknown kind",     "bad item",
        "fault", "bad limits", "closed input", "beyond the table", "cannot cut the patch"
    };

    fprintf(out, " next %" PRIu32 " limit %" PRIu32 " executed %" PRIu32 " %s", a->next, a->limit,
            a->executed, state_word(a->state));
    fprintf(out, "%s%s%s%s", a->flags & LOFT_FLAG_NAK ? " again" : "",
            a->flags & LOFT_FLAG_ENDED ? " all" : "",
            a->flags & LOFT_FLAG_STARVED ? " starved" : "",
            a->flags & LOFT_FLAG_LOST ? " position in doubt" : "");
    if (a->refusal != LOFT_REFUSAL_NONE)
        fprintf(out, " refused: %s", WORD(refusals, a->refusal));
}

// From the host
// -------------

/* A sum of LOFT_INPUT_ bits. */
static void print_inputs(FILE *out, const char *name, uint16_t inputs)
{
    if (inputs != 0)
        fprintf(out, " %s inputs %04x", name, inputs);
}

static bool print_hello(FILE *out, const loft_frame *f)
{
    loft_hello m;

    if (loft_hello_decode(f, &m) != LOFT_OK)
        return false;
    fprintf(out, " version %u..%u nonce %08" PRIx32, m.min_version, m.max_version, m.nonce);
    return true;
}

static bool print_job(FILE *out, const loft_frame *f)
{
    loft_job m;

    if (loft_job_decode(f, &m) != LOFT_OK)
        return false;
    fprintf(out, " job %08" PRIx32 " %s", m.id, kind_word(m.kind));
    print_inputs(out, "away", m.away);
    print_inputs(out, "guarded by", m.guard.inputs);
    print_places(out, "start", m.start);
    return true;
}

static bool print_data(FILE *out, const loft_frame *f)
{
    loft_unpacker u;
    uint16_t first;

    if (loft_data_first(f, &first) != LOFT_OK || loft_data_decode(f, &u) != LOFT_OK)
        return false;
    fprintf(out, " first %u (modulo 65536) count %u, %u bytes", first, u.count, f->count);
    return true;
}

static bool print_end(FILE *out, const loft_frame *f)
{
    uint32_t total;

    if (loft_end_decode(f, &total) != LOFT_OK)
        return false;
    fprintf(out, " total %" PRIu32, total);
    return true;
}

static bool print_control(FILE *out, const loft_frame *f)
{
    loft_control m;

    if (loft_control_decode(f, &m) != LOFT_OK)
        return false;
    fprintf(out, " number %u %s", m.number, verb_word(m.verb));
    if (m.verb >= LOFT_PLACE)
        print_places(out, "position", m.position);
    return true;
}

static bool print_poll(FILE *out, const loft_frame *f)
{
    (void)out;
    (void)f;
    return true;
}

static bool print_set(FILE *out, const loft_frame *f)
{
    loft_set m;

    if (loft_set_decode(f, &m) != LOFT_OK)
        return false;
    fprintf(out, " at %u, %u bytes", m.at, m.count);
    return true;
}

// From the machine
// ----------------

static bool print_welcome(FILE *out, const loft_frame *f)
{
    loft_welcome m;

    if (loft_welcome_decode(f, &m) != LOFT_OK)
        return false;
    fprintf(out,
            " version %u boot %08" PRIx32 " job %08" PRIx32
            " axes %u queue %u points %u ticks/s %u slots %u frame %u",
            m.version, m.boot, m.job, m.axes, m.queue, m.points, m.tick_hz, m.slots, m.frame_max);
    print_inputs(out, "closed", m.closed);
    print_ack(out, &m.ack);
    return true;
}

static bool print_axis(FILE *out, const loft_frame *f)
{
    loft_axis m;

    if (loft_axis_decode(f, &m) != LOFT_OK)
        return false;
    fprintf(out, " %u steps/mm %.6g speed %.6g accel %.6g position %" PRId32, m.number,
            m.steps_per_mm / 65536.0, m.max_speed / 65536.0, m.max_accel / 65536.0, m.position);
    return true;
}

static bool print_acknowledgement(FILE *out, const loft_frame *f)
{
    loft_ack m;

    if (loft_ack_decode(f, &m) != LOFT_OK)
        return false;
    print_ack(out, &m);
    return true;
}

static bool print_status(FILE *out, const loft_frame *f)
{
    loft_machine_status m;

    if (loft_machine_status_decode(f, &m) != LOFT_OK)
        return false;
    print_ack(out, &m.ack);
    fprintf(out,
            " ticks %" PRIu32 " elapsed %" PRIu32 " slowed %" PRIu32 " damaged %" PRIu32
            " dropped %" PRIu32,
            m.ticks, m.elapsed, m.slowed, m.damaged, m.dropped);
    print_inputs(out, "closed", m.closed);
    print_places(out, "position", m.position);
    return true;
}

static bool print_report(FILE *out, const loft_frame *f)
{
    loft_report m;

    if (loft_report_decode(f, &m) != LOFT_OK)
        return false;
    fprintf(out, " job %08" PRIx32 " items %" PRIu32 " ticks %" PRIu32 " elapsed %" PRIu32 " %s",
            m.job, m.items, m.ticks, m.elapsed, state_word(m.state));
    print_inputs(out, "ended by", m.ended_by);
    print_places(out, "position", m.position);
    if (m.guarded)
        print_places(out, "latched", m.latched);
    return true;
}

static bool print_kept(FILE *out, const loft_frame *f)
{
    static const char *const origins[] = { "kept", "usual", "damaged" };
    loft_kept m;

    if (loft_kept_decode(f, &m) != LOFT_OK)
        return false;
    fprintf(out, " at %u, %u bytes of %u, %s%s", m.at, m.count, m.room, WORD(origins, m.origin),
            m.busy ? " busy" : "");
    return true;
}

// Frames
// ------

static bool (*const printers[16])(FILE *out, const loft_frame *f) = {
    [LOFT_HELLO] = print_hello,     [LOFT_JOB] = print_job,
    [LOFT_DATA_SPANS] = print_data, [LOFT_DATA_POINTS] = print_data,
    [LOFT_END] = print_end,         [LOFT_CONTROL] = print_control,
    [LOFT_POLL] = print_poll,       [LOFT_WELCOME] = print_welcome,
    [LOFT_AXIS] = print_axis,       [LOFT_ACK] = print_acknowledgement,
    [LOFT_STATUS] = print_status,   [LOFT_REPORT] = print_report,
    [LOFT_DATA_FINE] = print_data,  [LOFT_DATA_CURVES] = print_data,
    [LOFT_SET] = print_set,         [LOFT_KEPT] = print_kept
};

/* Frames of items are sealed with data that only the two ends know. Their check cannot be made
 * here, and loft_frame_push reports a bad frame. The readable part is printed. */
static void print_frame(wire_text *w, FILE *out, double seconds, bool good)
{
    const loft_frame *f = &w->frame;
    const enum loft_message type = loft_message_type(f);

    fprintf(out, "%10.3f %c ", seconds, w->arrow);
    if (!good && !loft_data_carried(f)) {
        w->damaged++;
        fprintf(out, "damaged, %u bytes\n", f->count);
        return;
    }
    w->frames++;
    fprintf(out, "%-7s session %u", names[type] != NULL ? names[type] : "unknown",
            loft_message_session(f));
    if (printers[type] == NULL || !printers[type](out, f))
        fprintf(out, " not readable, %u bytes", f->count);
    putc('\n', out);
}

void wire_text_init(wire_text *w, char arrow)
{
    *w = (wire_text){ .arrow = arrow };
    loft_frame_init(&w->frame);
    (void)!loft_frame_push(&w->frame, 0);
}

void wire_text_push(wire_text *w, FILE *out, double seconds, const uint8_t byte[], size_t count)
{
    w->bytes += count;
    for (size_t i = 0; i < count; i++) {
        const enum loft_status status = loft_frame_push(&w->frame, byte[i]);
        if (status != LOFT_MORE && (status == LOFT_OK || w->frame.count > 0))
            print_frame(w, out, seconds, status == LOFT_OK);
        else if (status != LOFT_MORE) {
            w->damaged++;
            fprintf(out, "%10.3f %c damaged\n", seconds, w->arrow);
        }
    }
    fflush(out);
}
