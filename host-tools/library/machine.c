/* host-tools/library/machine.c -- a machine, and what it is asked to do: send/desk.h, to be seen
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "library/inside.h"
#include "send/desk.h"

#define WAIT   5.0              /* s for the first answer */
#define BAUD   115200
#define FULL   20               /* ms until a full line of the program is looked at again */
#define LATEST 1000             /* ms between two steps */
#define OWN    INT_MAX           /* the descriptor of a line of the program */
#define ENDS   ((uint16_t)(LOFT_INPUT_ENDING & ~LOFT_INPUT_STOP))

struct loft_host_machine {
    loft_host *h;
    loft_host_line line;
    desk d;
    transport own;
    planning p;                 /* of the drawing */
    char *port, *file, *log;    /* of the line; the names stay */
    char *drawing, *lines;      /* of what is asked */
    char *settings;
    loft_host_facts facts;      /* that were told last */
    bool noted;
};

static char *copy_of(const char *text)
{
    if (text == NULL)
        return NULL;
    const size_t size = strlen(text) + 1;
    return memcpy(memory_grow(NULL, size), text, size);
}

/* Put a copy in the place of another one. */
static const char *keep(char **place, const char *text)
{
    char *fresh = copy_of(text);

    free(*place);
    return *place = fresh;
}


// The line
// --------

static const loft_host_port *port_of(const transport *t)
{
    return ((const loft_host_machine *)t->port)->line.own;
}

static long own_read(transport *t, void *bytes, size_t most)
{
    const loft_host_port *p = port_of(t);

    errno = EPIPE;
    return p->get(p->context, bytes, most);
}

static long own_write(transport *t, const void *bytes, size_t count)
{
    const loft_host_port *p = port_of(t);

    errno = EPIPE;
    return p->put(p->context, bytes, count);
}

static void own_close(transport *t) { (void)t; }

static void tell(void *context, enum send_line what, const char *line)
{
    const loft_host_machine *m = context;

    (void)what;
    if (m->line.told != NULL)
        m->line.told(m->line.context, line);
}

static void use_own_line(loft_host_machine *m)
{
    static const transport_kind kind = { own_read, own_write, own_close };

    m->own = (transport){ .kind = &kind, .in = OWN, .out = OWN, .port = m };
    snprintf(m->own.text, sizeof m->own.text, "%s", m->port);
    desk_line(&m->d, &m->own);
}

int loft_host_connect(loft_host *h, const loft_host_line *line, loft_host_machine **out)
{
    loft_host_machine *m = memory_grow(NULL, sizeof *m);
    const send_teller to = { .tell = tell, .context = m };

    *m = (loft_host_machine){ .h    = h,
                              .line = *line,
                              .port = copy_of(line->port != NULL ? line->port : "the machine"),
                              .file = copy_of(line->machine),
                              .log  = copy_of(line->log) };
    const talk_options at = { .port = m->port,
                              .baud = line->baud > 0 ? line->baud : BAUD,
                              .wait = line->wait > 0 ? line->wait : WAIT,
                              .log  = m->log };
    desk_begin(&m->d, &h->h, &at, m->file, &to);
    if (line->own != NULL)
        use_own_line(m);
    const int code = desk_connect(&m->d, 0);
    if (code != 0) {
        loft_host_machine_free(m);
        m = NULL;
    }
    *out = m;
    return code;
}

void loft_host_machine_free(loft_host_machine *m)
{
    if (m == NULL)
        return;
    desk_end(&m->d);
    free(m->port);
    free(m->file);
    free(m->log);
    free(m->drawing);
    free(m->lines);
    free(m->settings);
    free(m);
}


// Steps
// -----

static void note_changes(loft_host_machine *m)
{
    loft_host_facts now;

    if (m->line.changed == NULL)
        return;
    loft_host_state(m, &now);
    if (m->noted && memcmp(&now, &m->facts, sizeof now) == 0)
        return;
    m->noted = true;
    m->facts = now;
    m->line.changed(m->line.context, m);
}

int loft_host_step(loft_host_machine *m, double now, loft_host_wants *wants)
{
    task_wants w = { .in = -1, .out = -1, .until = HUGE_VAL };

    desk_step(&m->d, now, &w);
    const bool in = w.in == OWN, out = w.out == OWN;
    const double left = fmin(fmax(ceil(1000 * (w.until - now)), 0), out ? FULL : LATEST);
    *wants = (loft_host_wants){ in ? -1 : w.in, out ? -1 : w.out, in, out, (int)left };
    note_changes(m);
    return m->d.state == DESK_CONNECTS || m->d.state > DESK_RESTS || m->d.wished ? LOFT_HOST_GOES
                                                                                 : m->d.code;
}


// What it is asked to do
// ----------------------

static int ask(loft_host_machine *m, const desk_wish *wish)
{
    return desk_ask(&m->d, wish, m->d.now);
}

static int refuse(loft_host_machine *m, const char *name, const char *remedy, const char *what)
{
    return host_error(&m->h->h, EX_USAGE, name, (host_place){ m->port, 0 }, remedy, "%s", what);
}

static int begin_drawing(loft_host_machine *m, const char *file, drawing *given,
                         const loft_host_plan_options *o)
{
    planning p;
    int code = host_planning(m->h, &p, o);

    if (code == 0)
        code = ask(m, &(desk_wish){ .verb = DESK_DRAW, .how = &m->p, .given = given });
    if (code != 0)
        return code;
    m->p           = p;
    m->d.wish.file = keep(&m->drawing, file);
    return 0;
}

/* A machine has its own file, or none. */
static int check_options(loft_host_machine *m, const loft_host_plan_options *o)
{
    return o == NULL || o->machine == NULL
               ? 0
               : refuse(m, "host.machine-connected", "give it to loft_host_connect",
                        "a job takes the machine that is connected, and the options name one");
}

int loft_host_stream(loft_host_machine *m, loft_host_drawing *d, const loft_host_plan_options *o)
{
    int code = check_options(m, o);

    if (code == 0 && m->d.v.p.machine.tools.count > 0 && !d->d.program)
        code = refuse(m, "host.tools", "let loft_host_stream_file read it",
                      "this machine has tools, and the drawing was read without them");
    return code == 0 ? begin_drawing(m, d->file, &d->d, o) : code;
}

int loft_host_stream_file(loft_host_machine *m, const char *file, const loft_host_plan_options *o)
{
    const int code = check_options(m, o);

    return code == 0 ? begin_drawing(m, file, NULL, o) : code;
}

int loft_host_go(loft_host_machine *m, const double to[3], bool by, double feed)
{
    return ask(
        m, &(desk_wish){ .verb = DESK_GO, .to = { to[0], to[1], to[2] }, .by = by, .feed = feed });
}

int loft_host_jog(loft_host_machine *m, int axis, double way, double feed)
{
    if (axis < 0 || axis >= ENGINE_AXES)
        return refuse(m, "host.axis", "give 0, 1 or 2", "not an axis");
    return ask(m, &(desk_wish){ .verb = DESK_JOG,
                                .way  = way < 0 ? -axis - 1 : axis + 1,
                                .size = isinf(way) ? 0 : fabs(way),
                                .feed = feed });
}

void loft_host_jog_on(loft_host_machine *m) { desk_jog_on(&m->d, m->d.now); }

int loft_host_pen(loft_host_machine *m, bool up, double feed)
{
    return ask(m, &(desk_wish){ .verb = DESK_PEN, .up = up, .feed = feed });
}

int loft_host_park(loft_host_machine *m, double feed)
{
    return ask(m, &(desk_wish){ .verb = DESK_PARK, .feed = feed });
}

int loft_host_home(loft_host_machine *m, const char *axes, unsigned touches)
{
    desk_wish wish = { .verb = DESK_HOME, .touches = touches > 20 ? 20 : touches };
    const int code = axes != NULL ? mover_axes(&m->h->h, axes, wish.axis) : 0;

    return code == 0 ? ask(m, &wish) : code;
}

/* "x+": its axis, and 1 or -1; NULL: none. */
static int take_way(loft_host_machine *m, const char *way, int *axis, int *sign)
{
    const char *known = way != NULL && way[0] != '\0' ? strchr("xyz", way[0]) : NULL;

    *axis = known != NULL ? (int)(way[0] - 'x') : -1;
    *sign = known != NULL && way[1] == '-' ? -1 : 1;
    if (way == NULL ||
        (known != NULL && strchr("+-", way[1]) != NULL && way[1] != '\0' && way[2] == '\0'))
        return 0;
    return refuse(m, "host.way", "give an axis and + or -, as z-", "not a way to move");
}

int loft_host_unlock(loft_host_machine *m, const char *way)
{
    desk_wish wish = { .verb = DESK_UNLOCK };
    int axis, sign;
    const int code = take_way(m, way, &axis, &sign);

    wish.way = sign * (axis + 1);
    return code == 0 ? ask(m, &wish) : code;
}

int loft_host_zero(loft_host_machine *m, const char *axes, double at, bool keep)
{
    desk_wish wish = { .verb = DESK_ZERO, .to = { at, at, at }, .keep = keep };
    const int code = mover_axes(&m->h->h, axes != NULL ? axes : "xyz", wish.axis);

    return code == 0 ? ask(m, &wish) : code;
}

int loft_host_probe(loft_host_machine *m, const char *way, double within, double feed, double back,
                    double at)
{
    desk_wish wish = { .verb  = DESK_PROBE,
                       .probe = { .within = within, .feed = feed, .back = back, .at = at } };
    int axis, sign;
    const int code = take_way(m, way != NULL ? way : "z-", &axis, &sign);

    wish.probe.axis = axis;
    wish.probe.sign = sign;
    return code == 0 ? ask(m, &wish) : code;
}

int loft_host_settings_read(loft_host_machine *m)
{
    return ask(m, &(desk_wish){ .verb = DESK_SETTINGS });
}

int loft_host_settings_set(loft_host_machine *m, const char *lines)
{
    desk_wish wish = { .verb = DESK_SETTINGS };
    const int code = ask(m, &wish);

    if (code == 0)
        m->d.wish.lines = keep(&m->lines, lines);
    return code;
}

const char *loft_host_settings(loft_host_machine *m)
{
    size_t size;

    free(m->settings);
    m->settings = NULL;
    FILE *out   = m->d.kept.size > 0 ? open_memstream(&m->settings, &size) : NULL;
    if (out == NULL)
        return "";
    machine_print(&m->d.kept.m, MACHINE_OBEYS, out);
    machine_print(&m->d.kept.m, MACHINE_TEXT, out);
    fclose(out);
    return m->settings;
}


// Meanwhile
// ---------

void loft_host_hold(loft_host_machine *m)   { desk_hold(&m->d); }
void loft_host_resume(loft_host_machine *m) { desk_resume(&m->d); }
void loft_host_abort(loft_host_machine *m)  { desk_abort(&m->d); }

void loft_host_override(loft_host_machine *m, unsigned percent)
{
    desk_override(&m->d, percent < 10 ? 10 : percent > 200 ? 200 : percent);
}

bool loft_host_stop(loft_host_machine *m) { return desk_stop(&m->d); }


// State
// -----

static const char *state_of(const desk *d)
{
    switch (d->state) {
    case DESK_ALONE:    return "closed";
    case DESK_CONNECTS: return "connects";
    case DESK_RESTS:    return d->others ? "other-job" : "rests";
    case DESK_MOVES:    return "moves";
    case DESK_DRAWS:    return "prepares";
    case DESK_CHANGES:  return d->c.state == CHANGE_ASKS ? "tool" : "prepares";
    }
    return "";
}

/* The steps of the motors, as the machine told them last. */
static void take_steps(const loft_sender *s, int32_t out[LOFT_AXES])
{
    const bool over = s->phase == LOFT_PHASE_DONE ||
                      (s->phase == LOFT_PHASE_ABORTED && s->report.job != 0);

    for (int i = 0; i < LOFT_AXES; i++)
        out[i] = over                              ? s->report.position[i]
                 : s->phase == LOFT_PHASE_STREAMING ? s->status.position[i]
                                                    : s->axis[i].position;
}

static void take_job(loft_host_machine *m, loft_host_facts *out)
{
    const double hz = m->d.v.t.sender.machine.tick_hz > 0 ? m->d.v.t.sender.machine.tick_hz : 1;
    char words[160];
    send_facts f;

    if (!stream_facts(&m->d.r, &f, words))
        return;
    out->state    = f.state;
    out->done     = strcmp(f.state, "plans") == 0 ? 0 : f.done / hz;
    out->total    = job_ticks(&m->d.w.j) / hz;
    out->item     = f.item;
    out->items    = f.items;
    out->queued   = f.queued;
    out->feed     = f.feed;
    out->override = f.override;
    out->pause    = m->d.r.pause;
}

void loft_host_state(loft_host_machine *m, loft_host_facts *out)
{
    desk *d              = &m->d;
    const loft_sender *s = &d->v.t.sender;

    memset(out, 0, sizeof *out);
    out->state = state_of(d);
    if (d->state == DESK_ALONE || s->phase < LOFT_PHASE_READY)
        return;
    take_steps(s, out->steps);
    if (s->phase == LOFT_PHASE_READY)
        memcpy(out->at, d->v.at, sizeof out->at);       /* also where it was told to be */
    else
        stream_place(s, &d->v.p.machine.k, out->steps, out->at);
    out->job    = s->machine.job;
    out->closed = s->closed & ENDS;
    out->stop   = (s->closed & LOFT_INPUT_STOP) != 0;
    out->doubt  = (s->ack.flags & LOFT_FLAG_LOST) != 0;
    if (d->state == DESK_CHANGES)
        out->tool = d->c.tool->name;
    else if (d->state == DESK_DRAWS && d->about.tool != NULL)
        out->tool = d->about.tool;
    if (desk_draws(d)) {
        out->job = d->w.j.head.id;
        take_job(m, out);
    }
}
