/* host-tools/send/talk.c -- a session with a machine over a transport
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <string.h>
#include <unistd.h>

#include "base/create.h"
#include "send/talk.h"
#include "send/unfinished.h"

static uint32_t now_ms(const talk *t) { return (uint32_t)(uint64_t)(1000 * t->now); }

/* Send frames until there are none, or until the line is full. */
static bool send_frames(talk *t)
{
    for (;;) {
        if (t->out_at == t->out_size) {
            t->out_at   = 0;
            t->out_size = loft_sender_poll(&t->sender, now_ms(t), t->out);
            if (t->out_size == 0)
                return true;
        }
        const long put = t->line.kind->write(&t->line, t->out + t->out_at, t->out_size - t->out_at);
        if (put < 0)
            return false;
        if (t->log != NULL)
            wire_text_push(&t->down, t->log, t->now - t->began, t->out + t->out_at, (size_t)put);
        t->out_at  += (size_t)put;
        t->written += (uint64_t)put;
        if (put == 0)
            return true;
    }
}

static unfinished_machine machine_of(const talk *t)
{
    return (unfinished_machine){ t->port, t->sender.machine.boot,
                                 loft_state_busy(t->sender.ack.state), t->host };
}

static void note_job(talk *t)
{
    const unfinished_machine m = machine_of(t);

    if (t->job == 0 || t->noted || t->sender.phase != LOFT_PHASE_STREAMING)
        return;
    unfinished_begin(&m, t->job, t->job_file);
    t->noted = true;
}

/* Read what has arrived before sending anything: if this program did not run for a while, the
 * answers that are waiting are not late. A full line is looked at again when it takes bytes. */
bool talk_step(talk *t, double now, task_wants *w)
{
    uint8_t bytes[512];

    t->now         = now;
    const long got = t->line.kind->read(&t->line, bytes, sizeof bytes);
    if (got < 0)
        return false;
    t->received += (uint64_t)got;
    if (t->log != NULL)
        wire_text_push(&t->up, t->log, now - t->began, bytes, (size_t)got);
    for (long i = 0; i < got; i++)
        (void)loft_sender_push(&t->sender, bytes[i], now_ms(t));
    note_job(t);
    if (!send_frames(t))
        return false;
    talk_wants(t, w);
    return true;
}

void talk_wants(const talk *t, task_wants *w)
{
    const bool full = t->out_at < t->out_size;

    w->in  = t->line.in;
    w->out = full ? t->line.out : -1;
    if (!full)
        task_wake(w, t->now + loft_sender_wait(&t->sender, now_ms(t)) / 1000.0);
}

int talk_vanished(const talk *t, const char *where)
{
    if (t->noted)
        return host_error(t->host, EX_IOERR, "port.gone", (host_place){ .file = t->port },
                          "if the machine stayed on, plug it in and run the same command again; if "
                          "it lost its power, the position may be lost: home it, or `loft zero`",
                          "the port has vanished %s(%s)", where, strerror(errno));
    return host_error(t->host, EX_IOERR, "port.gone", (host_place){ .file = t->port },
                      "plug it in and run the same command again", "the port has vanished %s(%s)",
                      where, strerror(errno));
}

const char *talk_inputs(uint16_t inputs, char text[256])
{
    size_t used = 0;

    text[0] = '\0';
    for (int i = 0; i < LOFT_AXES; i++) {
        const uint16_t ends = inputs & LOFT_INPUT_ENDS(i);
        if (ends && used < 200)
            used += (size_t)snprintf(text + used, 256 - used, "%sthe limit switch of %c%s",
                                     used ? ", " : "", "xyzabc"[i],
                                     ends == LOFT_INPUT_LOW(i)    ? " at its low end"
                                     : ends == LOFT_INPUT_HIGH(i) ? " at its high end"
                                                                  : "");
    }
    if (inputs & LOFT_INPUT_STOP && used < 230)
        snprintf(text + used, 256 - used, "%sthe emergency stop", used ? ", " : "");
    return text;
}

int talk_certain(const talk *t)
{
    const unfinished_machine m = machine_of(t);

    return t->sender.ack.flags & LOFT_FLAG_LOST
               ? host_error(t->host, EX_UNAVAILABLE, "job.place-in-doubt",
                            (host_place){ .file = t->port },
                            HOST_REMEDY("`loft home --port %s`, or `loft zero`", t->port),
                            "its position is in doubt, as after an emergency stop")
               : unfinished_check(&m);
}

void talk_begins(talk *t, uint32_t id, const char *file)
{
    t->job      = id;
    t->job_file = file;
    t->noted    = false;
}

/* After an emergency stop the place stays in doubt, and a restart would forget that. */
void talk_over(talk *t)
{
    const loft_sender *s = &t->sender;
    const bool reported  = s->phase == LOFT_PHASE_DONE ||
                          (s->phase == LOFT_PHASE_ABORTED && s->report.job != 0),
               ended_by_us = s->phase == LOFT_PHASE_READY && !loft_state_busy(s->ack.state);

    if ((reported || ended_by_us) && !(s->ack.flags & LOFT_FLAG_LOST))
        unfinished_end(t->host, t->port);
    t->job = 0;
    t->noted = false;
}

void talk_placed(const talk *t, unsigned axes)
{
    const unfinished_machine m = machine_of(t);

    unfinished_placed(&m, axes);
}

double talk_silence(const talk *t, double began)
{
    return fmin((double)loft_sender_silence(&t->sender, now_ms(t)) / 1000, t->now - began);
}

static int report_silent(const talk *t)
{
    if (t->received > 0)
        return host_error(t->host, EX_PROTOCOL, "port.no-frame",
                          (host_place){ .file = t->line.text },
                          HOST_REMEDY("is it a loft machine, and is --baud %u right?",
                                      t->line.baud ? t->line.baud : 115200),
                          "%llu bytes came, but no good frame", (unsigned long long)t->received);
    return host_error(
        t->host, EX_UNAVAILABLE, "port.no-answer", (host_place){ .file = t->line.text },
        "look at its power, cable and baud rate", "no machine answered in %g s", t->wait);
}

static void begin_greeting(talk *t, double now)
{
    t->greeting = true;
    t->now      = now;
    t->until    = now + t->wait;
    t->out_at = t->out_size = 0;
    loft_sender_init(&t->sender, (uint32_t)(uint64_t)(1e9 * now) ^ (uint32_t)getpid() << 16,
                     now_ms(t));
}

int talk_greet(talk *t, double now, task_wants *w)
{
    const int code = t->stop ? 0 : transport_step(&t->line, now, w);

    if (code != 0)
        return code;
    if (!t->greeting)
        begin_greeting(t, now);
    if (t->sender.phase == LOFT_PHASE_HELLO) {
        if (t->stop)
            return host_error(t->host, EX_TEMPFAIL, "port.stopped", (host_place){ .file = NULL },
                              NULL, "stopped before the machine answered: nothing was sent");
        if (!talk_step(t, now, w))
            return talk_vanished(t, "before the machine answered ");
    }
    if (t->sender.phase == LOFT_PHASE_HELLO) {
        snprintf(w->awaits, sizeof w->awaits,
                 "no machine has answered at %s yet: it is asked for %g s", t->line.text, t->wait);
        task_wake(w, t->until);
        return now < t->until ? TASK_GOES : report_silent(t);
    }
    if (t->sender.phase == LOFT_PHASE_UNFIT)
        return host_error(t->host, EX_CONFIG, "port.unfit", (host_place){ .file = t->line.text },
                          "give both the same release",
                          "the machine has %u axes and wire version %u, this program %d and %d",
                          t->sender.machine.axes, t->sender.machine.version, LOFT_AXES,
                          LOFT_WIRE_VERSION);
    return 0;
}

static int step_greeting(void *context, double now, task_wants *w)
{
    return talk_greet(context, now, w);
}

task talk_greets(talk *t) { return (task){ step_greeting, t, &t->stop }; }

static int open_log(talk *t, const char *file)
{
    if (file == NULL)
        return 0;
    wire_text_init(&t->down, '>');
    wire_text_init(&t->up, '<');
    t->log = create_file(file);
    return t->log != NULL ? 0 : create_refused(t->host, file, errno);
}

const option talk_rows[] = {
    { "port", OPTION_FILE(talk_options, port), .value = "PORT",
      .help = "/dev/ttyUSB0, a pty, unix:PATH, tcp:HOST:PORT or - (`loft ports` lists)" },
    { "baud", OPTION_INTEGER(talk_options, baud), .least = 300, .most = 4000000, .value = "RATE",
      .standard = "115200", .help = "of a serial port" },
    { "wait", OPTION_NUMBER(talk_options, wait), .least = 0.1, .most = 600, .unit = "s",
      .standard = "5", .help = "for the machine's first answer" },
    { 0 }
};

int talk_take(talk *t, host *h, const talk_options *o, const transport *line, double now)
{
    *t = (talk){
        .host = h, .port = o->port, .line = *line, .began = now, .now = now, .wait = o->wait
    };
    return open_log(t, o->log);
}

int talk_open(talk *t, host *h, const talk_options *o, double now)
{
    *t = (talk){ .host = h, .port = o->port, .began = now, .now = now, .wait = o->wait };
    const int code = open_log(t, o->log);

    return code ? code : transport_open(&t->line, h, o->port, o->baud);
}

void talk_again(talk *t, double seconds)
{
    t->greeting = false;
    t->wait     = seconds;
}

void talk_close(talk *t)
{
    if (t->line.kind)
        t->line.kind->close(&t->line);
    t->line.kind = NULL;
    if (t->log && (ferror(t->log) | fclose(t->log)) != 0)
        host_error(t->host, EX_IOERR, "port.log", (host_place){ .file = NULL },
                   "is the disk full? log elsewhere", "the log is not complete: %s",
                   strerror(errno));
    t->log = NULL;
}
