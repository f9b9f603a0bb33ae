/* tests/lib/wire/test_wire_page.c -- the examples of lib/wire/WIRE.md agree with the code
 * SPDX-License-Identifier: MIT
 *
 * An example is between two lines of ```: text that names a message and its fields, then the bytes
 * of its frame in hexadecimal. Each frame is decoded and described in words, and the words are
 * compared with the page. Then the message is encoded again and compared with the bytes. SPANS and
 * POINTS follow their JOB. Items are those of 3 axes. WIRE_PAGE in the environment names another
 * page.
 */
#include <ctype.h>
#include <stdarg.h>
#include <string.h>

#include "check.h"          /* CHECK, PROPERTY */
#include "wire/action_code.h"   /* loft_item_action */
#include "wire/message.h"

typedef struct {
    char    text[2000];
    uint8_t byte[400];
    size_t  size;
} example;

static struct {
    char   text[2000];      /* of the frame decoded last */
    size_t size;
} said;

static void say(const char *format, ...) __attribute__((format(printf, 1, 2)));
static void say(const char *format, ...)
{
    va_list list;
    va_start(list, format);
    said.size += (size_t)vsnprintf(said.text + said.size, sizeof said.text - said.size, format,
                                   list);
    va_end(list);
}

static void say_axes(const char *name, const int32_t x[LOFT_AXES])
{
    say(" %s=", name);
    for (int i = 0; i < LOFT_AXES; i++)
        say(i ? ",%ld" : "%ld", (long)x[i]);
}

static void say_ack(const loft_ack *m)
{
    say(" next=%lu limit=%lu executed=%lu state=%u flags=%u refusal=%u control=%u",
        (unsigned long)m->next, (unsigned long)m->limit, (unsigned long)m->executed, m->state,
        m->flags, m->refusal, m->control);
}

static unsigned long ul(uint32_t x)     { return x; }


// One frame: into words, and back into bytes
// ------------------------------------------

static loft_predictor state;            /* after the JOB and the items before */

static void say_limits(const loft_frame *f, loft_job_limits *m)
{
    CHECK(loft_job_limits_decode(f, m) == LOFT_OK);
    say(" corner=%ld tol=%ld", (long)m->corner, (long)m->tol);
    for (int i = 0; i < LOFT_AXES; i++)
        say(" limits=%ld,%ld,%lu", (long)m->axis[i].max_speed, (long)m->axis[i].max_accel,
            ul(m->axis[i].max_jerk));
}

static void say_bytes(const uint8_t *byte, uint8_t count)
{
    say(" bytes=");
    for (uint8_t i = 0; i < count; i++)
        say("%02X", byte[i]);
}

static size_t say_host(const loft_frame *f, uint8_t wire[])
{
    const uint8_t session = loft_message_session(f);
    static loft_job_limits limits;
    loft_hello hello;
    loft_job job;
    loft_control control;
    loft_set set;
    uint32_t total;

    switch (loft_message_type(f)) {
    case LOFT_HELLO:
        CHECK(loft_hello_decode(f, &hello) == LOFT_OK);
        say("HELLO min_version=%u max_version=%u nonce=0x%08lX", hello.min_version,
            hello.max_version, ul(hello.nonce));
        return loft_hello_encode(&hello, wire);
    case LOFT_JOB:
        CHECK(loft_job_decode(f, &job) == LOFT_OK);
        say("JOB session=%u nonce=0x%08lX id=0x%08lX kind=%u away=%u", session, ul(job.nonce),
            ul(job.id), job.kind + (job.guard.inputs ? 128u : 0u), job.away);
        if (job.guard.inputs)
            say(" guard=%u,%u,%u", job.guard.inputs, job.guard.how, job.guard.filter);
        say_axes("start", job.start);
        if (job.kind == LOFT_CURVES)
            say_limits(f, &limits);
        job.limits = &limits;
        loft_predictor_init(&state, job.start);
        return loft_job_encode(&job, session, wire);
    case LOFT_END:
        CHECK(loft_end_decode(f, &total) == LOFT_OK);
        say("END session=%u total=%lu", session, ul(total));
        return loft_end_encode(total, session, wire);
    case LOFT_CONTROL:
        CHECK(loft_control_decode(f, &control) == LOFT_OK);
        say("CONTROL session=%u number=%u verb=%u value=%u", session, control.number, control.verb,
            control.value);
        if (control.verb >= LOFT_PLACE)
            say_axes("position", control.position);
        return loft_control_encode(&control, session, wire);
    case LOFT_POLL: say("POLL session=%u", session); return loft_poll_encode(session, wire);
    case LOFT_SET:
        CHECK(loft_set_decode(f, &set) == LOFT_OK);
        say("SET session=%u at=%u", session, set.at);
        say_bytes(set.byte, set.count);
        return loft_set_encode(&set, session, wire);
    default: return 0;
    }
}

static size_t say_machine(const loft_frame *f, uint8_t wire[])
{
    const uint8_t session = loft_message_session(f);
    loft_welcome welcome;
    loft_axis axis;
    loft_ack ack;
    loft_machine_status status;
    loft_report report;
    loft_kept kept;

    switch (loft_message_type(f)) {
    case LOFT_WELCOME:
        CHECK(loft_welcome_decode(f, &welcome) == LOFT_OK);
        say("WELCOME session=%u version=%u nonce=0x%08lX boot=0x%08lX job=0x%08lX", session,
            welcome.version, ul(welcome.nonce), ul(welcome.boot), ul(welcome.job));
        say_ack(&welcome.ack);
        say(" axes=%u num=%u frame_max=%u queue=%u tick_hz=%u slots=%u kinds=%u curves=%u "
            "points=%u closed=%u outputs=%u columns=%u",
            welcome.axes, welcome.num, welcome.frame_max, welcome.queue, welcome.tick_hz,
            welcome.slots, welcome.kinds, welcome.curves, welcome.points, welcome.closed,
            welcome.outputs, welcome.columns);
        return loft_welcome_encode(&welcome, session, wire);
    case LOFT_KEPT:
        CHECK(loft_kept_decode(f, &kept) == LOFT_OK);
        say("KEPT session=%u at=%u room=%u origin=%u", session, kept.at, kept.room,
            kept.origin + (kept.busy ? 128u : 0u));
        say_bytes(kept.byte, kept.count);
        return loft_kept_encode(&kept, session, wire);
    case LOFT_AXIS:
        CHECK(loft_axis_decode(f, &axis) == LOFT_OK);
        say("AXIS session=%u number=%u steps_per_mm=%ld max_speed=%ld max_accel=%ld position=%ld "
            "start=%ld",
            session, axis.number, (long)axis.steps_per_mm, (long)axis.max_speed,
            (long)axis.max_accel, (long)axis.position, (long)axis.start);
        return loft_axis_encode(&axis, session, wire);
    case LOFT_ACK:
        CHECK(loft_ack_decode(f, &ack) == LOFT_OK);
        say("ACK session=%u", session);
        say_ack(&ack);
        return loft_ack_encode(&ack, session, wire);
    case LOFT_STATUS:
        CHECK(loft_machine_status_decode(f, &status) == LOFT_OK);
        say("STATUS session=%u", session);
        say_ack(&status.ack);
        say(" ticks=%lu elapsed=%lu slowed=%lu damaged=%lu dropped=%lu override=%u closed=%u",
            ul(status.ticks), ul(status.elapsed), ul(status.slowed), ul(status.damaged),
            ul(status.dropped), status.override, status.closed);
        say_axes("position", status.position);
        return loft_machine_status_encode(&status, session, wire);
    case LOFT_REPORT:
        CHECK(loft_report_decode(f, &report) == LOFT_OK);
        say("REPORT session=%u job=0x%08lX items=%lu ticks=%lu elapsed=%lu slowed=%lu state=%u "
            "ended_by=%u",
            session, ul(report.job), ul(report.items), ul(report.ticks), ul(report.elapsed),
            ul(report.slowed), report.state, report.ended_by);
        say_axes("position", report.position);
        if (report.guarded)
            say_axes("latched", report.latched);
        return loft_report_encode(&report, session, wire);
    default: return 0;
    }
}

/* The name of each data message, and the kind of its items. */
static const struct {
    const char *name;
    enum loft_kind kind;
} data_of[] = { [LOFT_DATA_SPANS] = { "SPANS", LOFT_SPANS },
                [LOFT_DATA_POINTS] = { "POINTS", LOFT_POINTS },
                [LOFT_DATA_FINE] = { "FINE", LOFT_POINTS_FINE },
                [LOFT_DATA_CURVES] = { "CURVES", LOFT_CURVES } };

static void say_action(const loft_item *item)
{
    const loft_action a = loft_item_action(item);

    say(" what=%u level=%u feed=%u", a.output + (a.moving ? 128u : 0u), a.level, a.feed);
}

static size_t say_items(const loft_frame *f, uint8_t wire[])
{
    const enum loft_message type = loft_message_type(f);
    const enum loft_kind kind = data_of[type].kind;
    const bool cubics = kind == LOFT_SPANS || kind == LOFT_CURVES;
    const uint32_t seal = loft_predictor_seal(&state);
    loft_predictor sending = state;
    loft_unpacker u = { 0 };
    loft_packer p;
    loft_item item;
    uint16_t first = 0;

    CHECK(loft_data_first(f, &first) == LOFT_OK && loft_data_decode(f, &u) == LOFT_OK);
    say("%s session=%u first=%u count=%u", data_of[type].name, loft_message_session(f), first,
        u.count);
    loft_data_init(&p, kind, &sending, LOFT_FRAME_MAX, wire);
    while (loft_unpacker_next(&u, &state, &item)) {
        if (kind == LOFT_SPANS && item.ticks == 0) {
            say_action(&item);
        } else if (cubics) {
            say(kind == LOFT_SPANS ? " ticks=%u" : " feed=%u", item.ticks);
            say_axes("p1", item.p[0]);
            say_axes("p2", item.p[1]);
        }
        say_axes(cubics ? "p3" : "point", item.p[2]);
        CHECK(loft_packer_push(&p, &item) == LOFT_OK);
    }
    return loft_data_encode(&p, first, seal, loft_message_session(f), wire);
}

static uint16_t shown;                  /* bit t: there is an example of type t */

static void check_example(const example *e)
{
    uint8_t wire[LOFT_FRAME_MAX];
    loft_frame f;
    size_t n = 0;

    loft_frame_init(&f);
    for (size_t i = 0; i + 1 < e->size; i++)
        CHECK(loft_frame_push(&f, e->byte[i]) == LOFT_MORE);
    const enum loft_status ended = e->size > 0 ? loft_frame_push(&f, e->byte[e->size - 1])
                                               : LOFT_MORE;

    said.size = 0;
    const enum loft_message type = loft_message_type(&f);
    const bool items = loft_data_carried(&f);
    CHECK(items ? ended == LOFT_ERR_DATA && f.count > 0 &&
                      loft_frame_sealed(&f, loft_predictor_seal(&state))
                : ended == LOFT_OK);
    n = items ? say_items(&f, wire)
        : type == LOFT_KEPT || (type >= LOFT_WELCOME && type <= LOFT_REPORT) ? say_machine(&f, wire)
                                                                             : say_host(&f, wire);
    shown = (uint16_t)(shown | 1u << type);
    CHECK(strcmp(said.text, e->text) == 0);
    CHECK(n == e->size && memcmp(wire, e->byte, n) == 0);
    if (check_bad)
        printf("page: %s\ncode: %s\n", e->text, said.text);
}


// The page
// --------

/* "   0a FF 00": only pairs of hexadecimal digits. */
static bool take_hex(example *e, const char *line)
{
    const size_t before = e->size;
    for (const char *s = line; ; s += 2) {
        while (*s == ' ' || *s == '\n')
            s++;
        if (*s == 0)
            return e->size > before;
        if (!isxdigit((unsigned char)s[0]) || !isxdigit((unsigned char)s[1]) ||
            isxdigit((unsigned char)s[2])) {
            e->size = before;
            return false;
        }
        const char pair[3] = { s[0], s[1], 0 };
        if (e->size < sizeof e->byte)
            e->byte[e->size++] = (uint8_t)strtoul(pair, NULL, 16);
    }
}

static void take_text(example *e, const char *line)
{
    for (; *line; line++) {
        const size_t n = strlen(e->text);
        const bool blank = isspace((unsigned char)*line);
        if (n + 2 < sizeof e->text && !(blank && (n == 0 || e->text[n - 1] == ' ')))
            e->text[n] = blank ? ' ' : *line, e->text[n + 1] = 0;
    }
}

static void finish_example(example *e)
{
    size_t n = strlen(e->text);
    while (n > 0 && e->text[n - 1] == ' ')
        e->text[--n] = 0;
    if (e->size > 0)
        check_example(e);
    memset(e, 0, sizeof *e);
}

static void every_example_is_true(arb *a)
{
    const char *name = getenv("WIRE_PAGE");
    FILE *page = fopen(name ? name : "lib/wire/WIRE.md", "r");
    static example e;
    char line[400];
    bool inside = false;
    (void)a;

    CHECK(page != NULL);
    while (page && fgets(line, sizeof line, page)) {
        if (strncmp(line, "```", 3) == 0) {
            finish_example(&e);
            inside = !inside;
        } else if (inside && (e.text[0] ? !take_hex(&e, line) : true)) {
            if (e.size > 0)
                finish_example(&e);
            take_text(&e, line);
        }
    }
    if (page)
        fclose(page);
    for (unsigned type = LOFT_KEPT; type <= LOFT_SET; type++)
        CHECK(shown & 1u << type);
}

int main(void)
{
    if (LOFT_AXES == 3)
        PROPERTY(every_example_is_true, 1);
    return check_failures();
}
