/* host-tools/send/desk.c
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "wire/action_code.h"   /* LOFT_OUTPUTS_MOST */

#include "plan/missing.h"       /* missing_tell */
#include "send/greeted.h"       /* stream_machine */
#include "send/desk.h"

#define LOOK  1.0               /* s between two greetings of a machine at rest */
#define HELD  0.6               /* s until a jog ends that nobody holds */
#define TOUCHES 2               /* of each switch */

static int rest(desk *d, int code);

static int refuse(const desk *d, int code, const char *name, const char *remedy, const char *what)
{
    return host_error(d->host, code, name, (host_place){ d->line.port, 0 }, remedy, "%s", what);
}

/* This is done next; then `then` judges how it ended, and may begin something else. */
static int begin(desk *d, task doing, int (*then)(desk *d, int code))
{
    *doing.stop = d->ends;
    d->doing    = doing;
    d->then     = then;
    d->busy     = true;
    return 0;
}

static int greet(desk *d, int (*then)(desk *d, int code))
{
    talk_again(&d->v.t, d->line.wait);
    return begin(d, talk_greets(&d->v.t), then);
}


// The machine
// -----------

void desk_begin(desk *d, host *h, const talk_options *line, const char *machine,
                const send_teller *to)
{
    *d = (desk){ .host = h, .line = *line, .machine = machine, .to = *to };
    d->w = (job_work){ .path = { 0 } };
    (void)planning_usual(h, &d->v.p, machine);
}

static void free_job(desk *d)
{
    job_work_free(&d->w);
    drawing_free(&d->smooth);
    drawing_free(&d->d);
    d->smooth = d->d = (drawing){ 0 };
}

void desk_disconnect(desk *d)
{
    settings_leave(&d->settings);
    free_job(d);
    if (d->state != DESK_ALONE)
        mover_close(&d->v);
    d->state = DESK_ALONE;
    d->busy = d->looking = d->wished = d->others = false;
}

void desk_end(desk *d) { desk_disconnect(d); }

void desk_line(desk *d, const transport *line) { d->given = line; }

/* The machine was greeted: where is it? */
static void look(desk *d)
{
    const loft_sender *s = &d->v.t.sender;
    int32_t steps[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        steps[i] = s->axis[i].position;
    stream_place(s, &d->v.p.machine.k, steps, d->v.at);
    d->others = loft_state_busy(s->ack.state);
}

/* It does nothing: after an error of the line, without it. */
static int rest(desk *d, int code)
{
    free_job(d);
    d->code    = code;
    d->looking = d->busy = d->held = false;
    if (code == EX_IOERR || d->state == DESK_CONNECTS) {
        desk_disconnect(d);
        return code;
    }
    d->state   = DESK_RESTS;
    d->look_at = 0;
    return code;
}

static int looked(desk *d, int code)
{
    if (code != 0) {
        d->code = code;
        desk_disconnect(d);
        return code;
    }
    look(d);
    d->busy = d->looking = false;
    d->state   = DESK_RESTS;
    d->look_at = d->now + LOOK;
    return 0;
}

static int adopted(desk *d, int code)
{
    d->greeted++;
    return code == 0 ? looked(d, 0) : rest(d, code);
}

static int connected(desk *d, int code)
{
    if (code != 0)
        return rest(d, code);
    if (d->machine != NULL)
        return adopted(d, 0);
    settings_adopt(&d->settings, &d->v.p.machine, &d->v.t);
    return begin(d, settings_task(&d->settings), adopted);
}

int desk_connect(desk *d, double now)
{
    int code;

    if (d->state != DESK_ALONE)
        return 0;
    if (d->line.port == NULL)
        return refuse(d, EX_USAGE, "desk.no-port", "begin it with --port PORT",
                      "this server has no machine");
    d->v = (mover){ .host = d->host, .o = { .line = d->line, .machine = d->machine } };
    code = planning_usual(d->host, &d->v.p, d->machine);
    if (code != 0)
        return code;
    d->state = DESK_CONNECTS;
    code     = d->given != NULL ? talk_take(&d->v.t, d->host, &d->line, d->given, now)
                            : talk_open(&d->v.t, d->host, &d->line, now);
    return code == 0 ? begin(d, talk_greets(&d->v.t), connected) : rest(d, code);
}


// Moves
// -----

static int by_hand(desk *d) { return begin(d, hand_task(&d->m), rest); }

static int go(desk *d)
{
    hand_go(&d->m, &d->v, d->wish.to, d->wish.by, d->wish.feed);
    return by_hand(d);
}

static int lift(desk *d)
{
    hand_pen(&d->m, &d->v, d->wish.up, d->wish.feed);
    return by_hand(d);
}

static int park(desk *d)
{
    hand_park(&d->m, &d->v, d->wish.feed);
    return by_hand(d);
}

static bool is_let_go(void *context)
{
    const desk *d = context;

    return !(d->wish.size > 0) && (!d->held || d->now > d->until);
}

static int jog(desk *d)
{
    const int way   = d->wish.way;
    const double by = d->wish.size > 0 ? d->wish.size : HUGE_VAL;

    if (is_let_go(d))
        return rest(d, 0);
    hand_jog(&d->m, &d->v, (way < 0 ? -way : way) - 1, way < 0 ? -by : by, d->wish.feed, is_let_go,
             d);
    return by_hand(d);
}

static int zero(desk *d)
{
    unsigned axes = 0;

    for (int i = 0; i < ENGINE_AXES; i++)
        axes |= (unsigned)d->wish.axis[i] << i;
    hand_zero(&d->m, &d->v, axes, d->wish.to, d->wish.keep);
    return by_hand(d);
}

static int touches(desk *d)
{
    probe_begin(&d->touch, &d->v, &d->wish.probe, &d->to);
    return begin(d, probe_task(&d->touch), rest);
}

static int homes(desk *d)
{
    const bool *axis = d->wish.axis;

    home_begin(&d->h, &d->v, axis[0] || axis[1] || axis[2] ? axis : NULL,
               d->wish.touches > 0 ? d->wish.touches : TOUCHES, &d->to);
    return begin(d, home_task(&d->h), rest);
}

static int unlock(desk *d)
{
    const int way = d->wish.way;

    home_unlock(&d->h, &d->v, (way < 0 ? -way : way) - 1, way < 0 ? -1 : 1, &d->to);
    return begin(d, home_task(&d->h), rest);
}


// Jobs
// ----

void desk_given(const desk *d, planning *p, double start[ENGINE_AXES], job_options *as)
{
    const loft_sender *s = &d->v.t.sender;
    const bool known     = d->state > DESK_CONNECTS;

    *as = (job_options){ .kind = LOFT_SPANS, .e = p->e };
    p->machine = d->v.p.machine;
    for (int i = 0; i < ENGINE_AXES; i++) {
        start[i]            = 0;
        as->steps_per_mm[i] = known ? s->axis[i].steps_per_mm
                                    : (int32_t)lround(p->machine.steps_per_mm[i] * 65536);
    }
    if (known) {
        stream_machine(s, &as->limits);
        stream_new_start(s, start);
    } else {
        planning_machine(p, &as->limits);
    }
    planning_limit(p, &as->limits);
    as->does = (struct job_does){ .s_max = p->machine.s_max, .spin_up = p->machine.spin_up };
    as->does.actions = !known || s->machine.kinds & LOFT_TAKES_ACTIONS;
    as->does.outputs = known ? s->machine.outputs : LOFT_OUTPUTS_MOST;
}

static int plan_part(desk *d, size_t k, const double start[ENGINE_AXES])
{
    double now[ENGINE_AXES];
    planning p = d->p;
    job_options as;

    job_work_free(&d->w);
    desk_given(d, &p, now, &as);
    d->part = k;
    return parts_plan(d->host, &d->p, &d->parts, k, d->line.port, start, false, &as, &d->w);
}

/* If the machine has a job, it may be one of these, planned from the same start: job_open gives it
 * the same id then. */
static int find_old(desk *d)
{
    const loft_sender *s = &d->v.t.sender;
    double start[ENGINE_AXES];

    d->old = d->parts.count;
    stream_old_start(s, false, start);
    for (size_t k = 0; k < d->parts.count && s->machine.job != 0; k++) {
        const int code = plan_part(d, k, start);
        if (code != 0)
            return code;
        if (d->w.j.count > 0 && d->w.j.head.id == s->machine.job) {
            d->old = k;
            break;
        }
    }
    return 0;
}

static int draw_next(desk *d, int code);
static int draw_part(desk *d, int code);

static int drawn(desk *d, int code)
{
    if (code != 0 || ++d->part == d->parts.count)
        return rest(d, code);
    return greet(d, draw_next);
}

static int stream_part(desk *d)
{
    const machine_tool *tool = d->parts.part[d->part].tool;
    const int code           = stream_limits(&d->v.t, d->p.machine.hard_stop > 0, &d->w.j.head);

    if (code != 0)
        return rest(d, code);
    d->about = (stream_subject){ .file = d->wish.file,
                                 .curves = d->w.path.curves,
                                 .drawn = d->w.path.drawn,
                                 .tol = d->p.tol,
                                 .d = &d->parts.part[d->part].d,
                                 .k = &d->p.machine.k,
                                 .port = d->line.port,
                                 .tool = tool ? tool->name : NULL,
                                 .path = &d->w.path };
    d->state = DESK_DRAWS;
    stream_begin(&d->r, &d->v.t, &d->w.j, &d->about, &d->to);
    return begin(d, stream_task(&d->r), drawn);
}

static int plan_new(desk *d, int code)
{
    double start[ENGINE_AXES];

    if (code != 0)
        return rest(d, code);
    stream_new_start(&d->v.t.sender, start);
    code = plan_part(d, d->part, start);
    return code == 0 ? stream_part(d) : rest(d, code);
}

static int draw_part(desk *d, int code) { return code == 0 ? greet(d, plan_new) : rest(d, code); }

static int step_change(void *context, double now, task_wants *w)
{
    desk *d = context;

    return change_step(&d->c, now, w);
}

/* The tool of this part, and then it is planned from where the machine is. */
static int draw_next(desk *d, int code)
{
    const machine_tool *tool = d->parts.part[d->part].tool;

    if (code != 0)
        return rest(d, code);
    if (tool == NULL || loft_state_busy(d->v.t.sender.ack.state))
        return plan_new(d, 0);
    d->state = DESK_CHANGES;
    change_begin(&d->c, d->host, tool, true);
    return begin(d, (task){ step_change, d, &d->c.stop }, draw_part);
}

static int read_drawing(desk *d)
{
    double start[ENGINE_AXES];
    job_options as;

    free_job(d);
    d->p        = *d->wish.how;
    desk_given(d, &d->p, start, &as);
    d->p.levels = true;
    d->p.passes = true;
    drawing *of = d->wish.given != NULL ? d->wish.given : &d->d;
    int code = (d->wish.given != NULL ? planning_smooth : planning_read)(d->host, &d->p, of,
                                                                         &d->smooth, d->wish.file);
    if (code == 0)
        code = parts_find(d->host, &d->p, d->wish.file, of, &d->smooth, &d->parts);
    if (code == 0) {
        const missing_job asked = { .file  = d->wish.file,
                                    .part  = d->parts.part,
                                    .count = d->parts.count };
        code = d->p.machine.laser > 0 ? missing_laser(d->host, &asked, &as.does) : 0;
        code = code == 0 ? missing_tell(d->host, &asked, &as.does) : code;
    }
    return code;
}

static int draw(desk *d)
{
    d->state = DESK_DRAWS;
    int code = talk_certain(&d->v.t);
    if (code == 0)
        code = read_drawing(d);
    if (code == 0)
        code = find_old(d);
    if (code != 0)
        return rest(d, code);
    if (d->old < d->parts.count)
        return stream_part(d);
    d->part = 0;
    return draw_next(d, 0);
}


// Settings
// --------

static int read_them(desk *d, int (*then)(desk *d, int code))
{
    settings_read(&d->settings, &d->kept, &d->v.t);
    return begin(d, settings_task(&d->settings), then);
}

/* What the machine keeps is what holds from now on, unless it has a file. */
static int read_again(desk *d, int code)
{
    if (code == 0 && d->machine == NULL && d->kept.origin == LOFT_SETTINGS_KEPT)
        d->v.p.machine = d->kept.m;
    d->greeted++;
    return rest(d, code);
}

static int written(desk *d, int code)
{
    return code == 0 ? read_them(d, read_again) : rest(d, code);
}

static int change_settings(desk *d, int code)
{
    const machine_file before = d->kept.m;
    const char *key           = NULL;

    if (code == 0)
        code = machine_text(d->host, &d->kept.m, "settings", d->wish.lines);
    if (code != 0)
        return rest(d, code);
    if ((key = machine_differs(&before, &d->kept.m, MACHINE_FIRMWARE)) != NULL ||
        (key = machine_differs(&before, &d->kept.m, MACHINE_PLAN)) != NULL)
        return rest(d, host_error(d->host, EX_CONFIG, "desk.not-kept",
                                  (host_place){ d->line.port, 0 }, "leave it out",
                                  "%s is of the firmware or of a plan: no machine keeps it", key));
    settings_write(&d->settings, &d->kept, &d->v.t, d->line.wait);
    return begin(d, settings_task(&d->settings), written);
}

static int read_settings(desk *d)
{
    return read_them(d, d->wish.lines != NULL ? change_settings : read_again);
}


// What is asked
// -------------

static int begin_wish(desk *d)
{
    const desk_wish *w = &d->wish;

    d->state = DESK_MOVES;
    switch (w->verb) {
    case DESK_GO:     return go(d);
    case DESK_PEN:    return lift(d);
    case DESK_PARK:   return park(d);
    case DESK_JOG:    return jog(d);
    case DESK_ZERO:   return zero(d);
    case DESK_HOME:   return homes(d);
    case DESK_UNLOCK: return unlock(d);
    case DESK_DRAW:   return draw(d);
    case DESK_PROBE:  return touches(d);
    case DESK_SETTINGS: return read_settings(d);
    }
    return rest(d, EX_SOFTWARE);
}

/* It was greeted for that. */
static int obey_wish(desk *d, int code)
{
    d->wished = false;
    if (code != 0)
        return looked(d, code);
    look(d);
    if (d->others && d->wish.verb != DESK_DRAW)
        return rest(d, refuse(d, EX_TEMPFAIL, "desk.other-job", "abort it, or start its drawing",
                              "the machine has a job"));
    return begin_wish(d);
}

int desk_ask(desk *d, const desk_wish *wish, double now)
{
    if (d->state == DESK_ALONE)
        return refuse(d, EX_UNAVAILABLE, "desk.no-machine", "connect it",
                      "no machine is connected");
    if (d->state > DESK_RESTS || d->wished)
        return refuse(d, EX_TEMPFAIL, "desk.busy", "wait, or abort what it does",
                      "the machine is doing something else");
    d->wish   = *wish;
    d->wished = true;
    d->code   = TASK_GOES;
    if (wish->verb == DESK_JOG) {
        d->held = true;
        desk_jog_on(d, now);
    }
    return 0;
}

/* The machine was greeted, and has a job that somebody else began. */
static int control_others(desk *d, int code)
{
    const enum loft_verb verb = d->verb;

    d->verb = 0;
    if (code == 0)
        look(d);
    if (code != 0 || !d->others)
        return looked(d, code);
    d->state = DESK_MOVES;
    stream_control_begin(&d->control, &d->v.t, verb, &d->v.p.machine.k, &d->to);
    return begin(d, stream_control_task(&d->control), rest);
}

bool desk_draws(const desk *d) { return d->busy && d->then == drawn; }

/* What is not a job yet, or not any more, ends. */
static void control(desk *d, enum loft_verb verb, int key)
{
    if (desk_draws(d))
        stream_key(&d->r, key);
    else if (d->state == DESK_RESTS && d->others)
        d->verb = verb;
    else if (d->state >= DESK_MOVES && verb != LOFT_RESUME)
        d->v.t.stop = true;
}

void desk_hold(desk *d)
{
    desk_jog_off(d);
    control(d, LOFT_HOLD, 'h');
}

void desk_resume(desk *d)
{
    if (d->state == DESK_CHANGES)
        change_answer(&d->c, true);
    else
        control(d, LOFT_RESUME, 'r');
}

void desk_abort(desk *d)
{
    desk_jog_off(d);
    if (d->state == DESK_CHANGES)
        change_answer(&d->c, false);
    else
        control(d, LOFT_ABORT, 'a');
}

void desk_override(desk *d, unsigned percent)
{
    if (desk_draws(d)) {
        d->r.percent = (int)percent;
        loft_sender_override(&d->v.t.sender, percent);
    }
}

void desk_jog_on(desk *d, double now) { d->until = now + HELD; }

void desk_jog_off(desk *d) { d->held = false; }

bool desk_stop(desk *d)
{
    if (!d->ends)
        d->v.t.stop = d->c.stop = true;
    d->ends = true;
    return d->state == DESK_ALONE || (d->state == DESK_RESTS && !d->busy);
}

static bool wants_greeting(const desk *d)
{
    return d->state == DESK_RESTS && !d->busy && !d->ends &&
           (d->wished || d->verb != 0 || d->now >= d->look_at);
}

void desk_step(desk *d, double now, task_wants *w)
{
    d->now = now;
    if (wants_greeting(d)) {
        d->looking = !d->wished && d->verb == 0;
        (void)greet(d, d->wished ? obey_wish : d->verb != 0 ? control_others : looked);
    }
    const int code = d->busy ? task_step(&d->doing, now, w) : TASK_GOES;
    if (code != TASK_GOES) {
        d->busy = false;
        (void)d->then(d, code);
        task_wake(w, now);
    } else if (d->state == DESK_RESTS && !d->busy && !d->ends) {
        task_wake(w, d->look_at);
    }
}
