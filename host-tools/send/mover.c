/* host-tools/send/mover.c
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/spool.h"          /* spool_grow */
#include "plan/table.h"          /* table_place */
#include "send/mover.h"
#include "send/stream_end.h"     /* stream_ended, stream_place */

#define SILENCE 10.0        /* s of silence until we give up */
#define OBEYS   5.0         /* s to take a place */
#define PORTION 0.005       /* s of planning in a step */
#define LOOK    0.005       /* s between two looks whether the move is to end */
#define ALL     ((1u << LOFT_AXES) - 1)
#define TABLE_MORE 0.1      /* mm: what tolerances may need beyond the table */

const option mover_rows[] = {
    OPTION_GROUP(mover_options, line, talk_rows),
    { "machine", OPTION_FILE(mover_options, machine), .value = "FILE",
      .help = "a machine as text, see host-tools/MACHINE.md: table, homing, limits" },
    { "log", OPTION_FILE(mover_options, line.log), .value = "FILE",
      .help = "write what passes on the line, in words" },
    OPTION_NEEDS("", "port", "name the machine's port"),
    { 0 }
};

static void read_place(mover *v, const int32_t steps[LOFT_AXES])
{
    stream_place(&v->t.sender, &v->p.machine.k, steps, v->at);
}

/* The machine was greeted: where is it, and may it move? */
static int look(mover *v)
{
    const loft_sender *s = &v->t.sender;
    int32_t steps[LOFT_AXES];

    if (loft_state_busy(s->ack.state))
        return host_error(
            v->host, EX_TEMPFAIL, "job.running", (host_place){ .file = v->o.line.port },
            HOST_REMEDY("wait for its end, or `loft stream --abort --port %s`", v->o.line.port),
            "a job is running");
    if (s->ack.state == LOFT_STATE_FAULT)
        return host_error(v->host, EX_TEMPFAIL, "job.fault", (host_place){ .file = v->o.line.port },
                          "restart it", "the machine has a fault");
    for (int i = 0; i < LOFT_AXES; i++)
        steps[i] = s->axis[i].position;
    read_place(v, steps);
    return 0;
}

/* The next step does this. */
static int go_on(mover *v, int (*stage)(mover *v, double now, task_wants *w))
{
    v->stage = stage;
    return 0;
}

static int look_where(mover *v, double now, task_wants *w)
{
    (void)now;
    (void)w;
    v->stage = v->then;
    return look(v);
}

static int greet(mover *v, double now, task_wants *w)
{
    const int code = talk_greet(&v->t, now, w);

    return code ? code : go_on(v, look_where);
}

static int adopt(mover *v, double now, task_wants *w)
{
    const int code = settings_step(&v->settings, now, w);

    return code ? code : go_on(v, look_where);
}

/* The first time the machine is greeted. */
static int greet_first(mover *v, double now, task_wants *w)
{
    const int code = talk_greet(&v->t, now, w);

    if (code != 0)
        return code;
    if (v->p.file != NULL)
        return go_on(v, look_where);
    settings_adopt(&v->settings, &v->p.machine, &v->t);
    return go_on(v, adopt);
}

int mover_open(mover *v, host *h, const mover_options *o, double now)
{
    *v = (mover){ .host = h, .o = *o, .stage = greet_first };
    const int code = planning_usual(h, &v->p, o->machine);

    return code ? code : talk_open(&v->t, h, &v->o.line, now);
}

void mover_close(mover *v)
{
    settings_leave(&v->settings);
    job_work_free(&v->w);
    if (v->t.port != NULL)
        talk_close(&v->t);
}

int mover_step(mover *v, double now, task_wants *w)
{
    int code = 0;

    while (code == 0 && v->stage != NULL)
        code = v->stage(v, now, w);
    if (code != TASK_GOES) {
        job_work_free(&v->w);
        v->stage = NULL;
    }
    return code;
}

static int step_mover(void *context, double now, task_wants *w)
{
    return mover_step(context, now, w);
}

task mover_task(mover *v) { return (task){ step_mover, v, &v->t.stop }; }

static void greet_before(mover *v, int (*then)(mover *v, double now, task_wants *w))
{
    v->then  = then;
    v->stage = greet;
    talk_again(&v->t, v->o.line.wait);
}

void mover_ready(mover *v) { greet_before(v, NULL); }

/* Do this, with a machine that is greeted. */
static void begin(mover *v, int (*stage)(mover *v, double now, task_wants *w))
{
    if (v->t.sender.phase == LOFT_PHASE_READY)
        v->stage = stage;
    else
        greet_before(v, stage);
}


// Planning
// --------

static void limits_of(const mover *v, engine_limits *l)
{
    stream_machine(&v->t.sender, l);
    planning_limit(&v->p, l);
}

static int plan_move(mover *v)
{
    const drawing nothing = { 0 };
    const mover_move *m   = &v->m;
    job_work *w           = &v->w;
    planning p            = v->p;
    job_options as        = { .e = v->p.e, .kind = LOFT_SPANS };
    double start[ENGINE_AXES], from[ENGINE_AXES];

    stream_new_start(&v->t.sender, start);
    if (!kinematics_tool(&p.machine.k, start, from))
        return host_error(v->host, EX_DATAERR, "job.motors", (host_place){ .file = v->o.line.port },
                          "give its --machine FILE",
                          "its motors are where those of a %s machine like this cannot be",
                          kinematics_name(&p.machine.k));
    /* a move past the pole of a polar machine becomes several: the path must be able to grow */
    w->path = (toolpath){ .move  = spool_grow(NULL, sizeof *w->path.move),
                          .curve = spool_grow(NULL, sizeof *w->path.curve),
                          .count = 1 };
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < ENGINE_AXES; i++)
            w->path.move[0].p[k][i] = from[i] + (m->to[i] - from[i]) * k / 3;
    w->path.move[0].feed = m->feed;
    w->path.curve[0]     = TOOLPATH_TRAVEL;
    for (int i = 0; i < ENGINE_AXES; i++) {
        p.machine.travel[i]  = 0;           /* who moves has checked the table */
        as.steps_per_mm[i] = v->t.sender.axis[i].steps_per_mm;
    }
    limits_of(v, &as.limits);
    const int code = planning_joints(v->host, &p, v->o.line.port, &nothing, start, false,
                                     &as.limits, &w->path, &w->of);
    const int status = code == 0 ? job_open(&w->j, &w->of, &as) : LOFT_OK;
    w->j.k = w->of.k = &v->p.machine.k;     /* `p` ends here, and the job is drawn later */
    return status == LOFT_OK ? code : job_refuse(v->host, &w->j, v->o.line.port, status, "");
}


// Moving
// ------

/* A job with a guard is for this run alone: nobody may continue it. */
static int guard_job(mover *v)
{
    const mover_move *m = &v->m;
    job *j              = &v->w.j;

    j->head.away  = m->away;
    j->head.guard = m->guard;
    if (m->guard.inputs == 0)
        return stream_limits(&v->t, v->p.machine.hard_stop > 0, &j->head);
    j->head.id ^= v->t.sender.nonce;
    j->head.id += j->head.id == 0;
    return 0;
}

/* What the report says. Other ends than those of mover_end are errors, in the words of a stream. */
static int take_report(mover *v)
{
    const loft_sender *s = &v->t.sender;
    const bool done = s->phase == LOFT_PHASE_DONE, over = s->phase == LOFT_PHASE_ABORTED;
    mover_outcome *out = &v->out;
    char text[96];

    if (done || (over && s->report.job != 0))
        read_place(v, s->report.position);
    if (over && s->report.guarded && s->report.ended_by & v->m.guard.inputs) {
        out->how = MOVER_GUARDED;
        out->by  = s->report.ended_by;
        memcpy(out->steps, s->report.latched, sizeof out->steps);
        stream_place(s, &v->p.machine.k, s->report.latched, out->latched);
        return 0;
    }
    if (v->t.stop)
        return host_error(v->host, EX_TEMPFAIL, "job.stopped", (host_place){ .file = NULL }, NULL,
                          "stopped: the tool is at %s", mover_text(v->at, text));
    out->how = done ? MOVER_ARRIVED : MOVER_ENDED;
    return done || (over && v->ended && s->refusal == LOFT_REFUSAL_NONE)
               ? 0
               : stream_ended(&v->t, &v->w.j);
}

/* The sender has ended. */
static int end_move(mover *v, double now, task_wants *w)
{
    (void)now;
    (void)w;
    talk_over(&v->t);
    v->stage = NULL;
    return v->planned == LOFT_OK ? take_report(v)
                                 : job_refuse(v->host, &v->w.j, v->o.line.port, v->planned, "");
}

/* Returns whether another portion of the plan is wanted. */
static bool plan_on(mover *v)
{
    loft_sender *s = &v->t.sender;
    job *j         = &v->w.j;
    const bool more = s->phase == LOFT_PHASE_STREAMING && v->planned == LOFT_OK && job_waits(j, 0);

    if (more)
        v->planned = job_plan(j, 0, PORTION);
    loft_sender_extend(s, (uint32_t)job_ready(j), job_items(j));
    return more;
}

static int run_move(mover *v, double now, task_wants *w)
{
    loft_sender *s = &v->t.sender;

    v->began = v->began > 0 ? v->began : now;
    if (!talk_step(&v->t, now, w))
        return talk_vanished(&v->t, "in the middle of a move ");
    if (talk_silence(&v->t, v->began) > SILENCE)
        return host_error(v->host, EX_IOERR, "job.silent", (host_place){ .file = v->o.line.port },
                          "it stops on the path; look at cable and power",
                          "the machine has been silent for %g s", SILENCE);
    task_wake(w, plan_on(v) ? now : now + LOOK);
    if (!v->ended && s->phase == LOFT_PHASE_STREAMING &&
        (v->planned != LOFT_OK || v->t.stop || (v->m.ends && v->m.ends(v->m.context)))) {
        loft_sender_control(s, LOFT_ABORT);
        v->ended = true;
    }
    talk_wants(&v->t, w);
    return s->phase < LOFT_PHASE_DONE ? TASK_GOES : go_on(v, end_move);
}

static int begin_move(mover *v, double now, task_wants *w)
{
    const loft_sender *s = &v->t.sender;
    job *j               = &v->w.j;
    int code             = 0;

    v->out = (mover_outcome){ .how = MOVER_ARRIVED };
    if (memcmp(v->m.to, v->at, sizeof v->at) == 0)
        return go_on(v, NULL);
    v->w       = (job_work){ .path = { 0 } };
    v->planned = LOFT_OK;
    v->ended   = false;
    code       = plan_move(v);
    if (code == 0)
        code = guard_job(v);
    if (code != 0)
        return code;
    if (v->m.guard.inputs == 0 && v->m.ends == NULL)    /* the user sees to the others */
        talk_begins(&v->t, j->head.id, "");
    if (loft_sender_begin(&v->t.sender, &j->head, job_items(j), job_source, j) != LOFT_OK)
        return host_error(v->host, EX_SOFTWARE, "job.not-begun", (host_place){ .file = NULL },
                          "please report this", "the move could not begin");
    (void)plan_on(v);
    v->began = 0;
    v->stage = s->phase < LOFT_PHASE_DONE ? run_move : end_move;
    task_wake(w, now);                  /* planning took its time */
    return TASK_GOES;
}

void mover_go(mover *v, const mover_move *m)
{
    v->m = *m;
    begin(v, begin_move);
}


// Places and switches
// -------------------

static int steps_there(const mover *v, const double at[ENGINE_AXES], int32_t steps[LOFT_AXES])
{
    const loft_sender *s = &v->t.sender;
    double near[ENGINE_AXES], motors[ENGINE_AXES];
    char why[160], text[96];

    if (kinematics_beyond(&v->p.machine.k, at, why))
        return host_error(v->host, EX_DATAERR, "job.place", (host_place){ .file = NULL },
                          "give another place", "%s: %s", mover_text(at, text), why);
    stream_new_start(&v->t.sender, near);
    kinematics_motors(&v->p.machine.k, at, near, motors);
    for (int i = 0; i < LOFT_AXES; i++)
        steps[i] = (int32_t)lround(motors[i] * (double)s->axis[i].steps_per_mm / 65536);
    return 0;
}

/* TASK_GOES until the machine has obeyed a place. */
static int obey(mover *v, double now, task_wants *w)
{
    loft_sender *s = &v->t.sender;

    if (s->verb != 0 && !talk_step(&v->t, now, w))
        return talk_vanished(&v->t, "before the machine obeyed ");
    task_wake(w, v->until);
    if (s->verb != 0)
        return now <= v->until ? TASK_GOES
                               : host_error(v->host, EX_IOERR, "job.not-obeyed",
                                            (host_place){ .file = v->o.line.port },
                                            "run the same command again",
                                            "the machine did not obey in %g s", OBEYS);
    return s->ack.refusal == LOFT_REFUSAL_NONE
               ? 0
               : host_error(v->host, EX_TEMPFAIL, "job.refused",
                            (host_place){ .file = v->o.line.port }, NULL,
                            "the machine refused: a job has begun meanwhile");
}

static int obey_place(mover *v, double now, task_wants *w)
{
    const int code = obey(v, now, w);

    if (code != 0)
        return code;
    talk_placed(&v->t, v->axes);
    read_place(v, v->steps);
    return go_on(v, NULL);
}

static int send_place(mover *v, double now, task_wants *w)
{
    loft_sender *s = &v->t.sender;
    int code       = 0;

    (void)w;
    if (!(s->machine.kinds & LOFT_TAKES_PLACES))
        code = host_error(v->host, EX_CONFIG, "job.no-places",
                          (host_place){ .file = v->o.line.port }, "give it a newer firmware",
                          "this machine cannot be told where it stands");
    if (code == 0)
        code = steps_there(v, v->place, v->steps);
    if (code != 0)
        return code;
    if (!v->p.machine.k.kind->direct)
        v->axes = ALL;
    v->until = now + OBEYS;
    return loft_sender_place(s, (uint8_t)v->axes, v->steps) == LOFT_OK
               ? go_on(v, obey_place)
               : host_error(v->host, EX_SOFTWARE, "job.place-not-sent",
                            (host_place){ .file = NULL }, "please report this",
                            "the place could not be sent");
}

void mover_place(mover *v, unsigned axes, const double at[ENGINE_AXES])
{
    v->axes = axes;
    memcpy(v->place, at, sizeof v->place);
    begin(v, send_place);
}

static int send_table(mover *v, double now, task_wants *w);

static int obey_table(mover *v, double now, task_wants *w)
{
    const int code  = obey(v, now, w);
    const bool over = v->high == v->counts;

    if (code != 0)
        return code;
    v->high = true;
    return go_on(v, over ? NULL : send_table);
}

static int send_table(mover *v, double now, task_wants *w)
{
    loft_sender *s = &v->t.sender;
    int32_t steps[LOFT_AXES] = { 0 };
    double ends[2];

    (void)w;
    table_ends(&v->p.machine, v->axis, &ends[0], &ends[1]);
    const double at = ends[v->high] + (v->high ? TABLE_MORE : -TABLE_MORE);
    if (v->counts)
        steps[v->axis] = (int32_t)lround(at * (double)s->axis[v->axis].steps_per_mm / 65536);
    v->until = now + OBEYS;
    return loft_sender_table(s, v->high, (uint8_t)(1u << v->axis), steps) == LOFT_OK
               ? go_on(v, obey_table)
               : host_error(v->host, EX_SOFTWARE, "job.table-not-sent",
                            (host_place){ .file = NULL }, "please report this",
                            "the table could not be sent");
}

void mover_table(mover *v, int axis, bool counts)
{
    const machine_file *m = &v->p.machine;
    double low, high;

    table_ends(m, axis, &low, &high);
    v->axis   = axis;
    v->counts = counts;
    v->high   = false;
    v->stage  = m->k.kind->direct && v->t.sender.machine.kinds & LOFT_TAKES_TABLE &&
                       (!counts || high < HUGE_VAL)
                   ? send_table
                   : NULL;
}

static int refuse(mover *v, double now, task_wants *w)
{
    (void)now;
    (void)w;
    return v->code;
}

static int greet_after(mover *v, double now, task_wants *w)
{
    const int code = settings_step(&v->settings, now, w);

    if (code == 0)
        mover_ready(v);
    return code;
}

static int change_zero(mover *v, double now, task_wants *w)
{
    const int code = settings_step(&v->settings, now, w);

    if (code != 0)
        return code;
    for (int i = 0; i < ENGINE_AXES; i++)
        v->kept.m.zero[i] += v->farther[i];
    settings_write(&v->settings, &v->kept, &v->t, v->o.line.wait);
    return go_on(v, greet_after);
}

void mover_keep_zero(mover *v, const double farther[ENGINE_AXES])
{
    v->stage = refuse;
    if (v->p.file != NULL) {
        v->code = host_error(v->host, EX_CONFIG, "zero.of-a-file",
                             (host_place){ .file = v->p.file }, "give x.zero in this file",
                             "--keep changes the settings of the machine");
    } else if (!settings_kept(&v->t)) {
        v->code = host_error(v->host, EX_CONFIG, "zero.none-kept",
                             (host_place){ .file = v->o.line.port },
                             "give x.zero in a --machine FILE", "this machine keeps no settings");
    } else {
        memcpy(v->farther, farther, sizeof v->farther);
        settings_read(&v->settings, &v->kept, &v->t);
        v->stage = change_zero;
    }
}

uint16_t mover_away(const mover *v, const double from[ENGINE_AXES], const double to[ENGINE_AXES])
{
    uint16_t away = 0;

    for (int i = 0; i < ENGINE_AXES; i++) {
        const uint16_t ends = v->t.sender.closed & LOFT_INPUT_ENDS(i);
        if (v->p.machine.square[i] > 0)
            continue;                       /* those of its two motors */
        if ((ends == LOFT_INPUT_LOW(i) && to[i] > from[i]) ||
            (ends == LOFT_INPUT_HIGH(i) && to[i] < from[i]))
            away |= ends;
    }
    return away;
}

int mover_free(const mover *v, const double to[ENGINE_AXES])
{
    const uint16_t held = (uint16_t)(v->t.sender.closed & LOFT_INPUT_ENDING &
                                     ~mover_away(v, v->at, to));
    char text[256];

    return held == 0 ? 0
                     : host_error(v->host, EX_UNAVAILABLE, "job.switch-closed",
                                  (host_place){ .file = v->o.line.port },
                                  HOST_REMEDY("`loft unlock --port %s` does", v->o.line.port),
                                  "%s is closed, and this does not lead away from it",
                                  talk_inputs(held, text));
}

void mover_to(mover *v, const double to[ENGINE_AXES], double feed)
{
    mover_move m = { .feed = feed, .away = mover_away(v, v->at, to) };

    memcpy(m.to, to, sizeof m.to);
    v->code = talk_certain(&v->t);
    if (v->code == 0)
        v->code = table_place(v->host, &v->p.machine, v->at, to, v->p.tol);
    if (v->code == 0)
        v->code = mover_free(v, to);
    if (v->code == 0)
        mover_go(v, &m);
    else
        v->stage = refuse;
}

const char *mover_text(const double at[ENGINE_AXES], char text[96])
{
    snprintf(text, 96, "%.3f %.3f %.3f", at[0], at[1], at[2]);
    return text;
}

int mover_axes(host *h, const char *text, bool axis[ENGINE_AXES])
{
    for (const char *s = text; *s; s++) {
        const char *known = strchr("xyz", *s);
        if (known == NULL || axis[known - "xyz"])
            return host_error(h, EX_USAGE, "job.axes", (host_place){ .file = NULL },
                              "give each axis once, as xy or z", "%s", text);
        axis[known - "xyz"] = true;
    }
    return 0;
}
