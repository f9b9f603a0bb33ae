/* host-tools/send/mover.c
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cmd/keys.h"           /* keys_start, keys_interrupted */
#include "base/spool.h"          /* spool_grow */
#include "base/tool.h"
#include "plan/job.h"            /* job */
#include "plan/table.h"          /* table_place */
#include "send/mover.h"
#include "send/settings.h"       /* settings_adopt */
#include "send/stream_end.h"     /* stream_ended, stream_place */

#define SILENCE 10.0        /* s of silence until we give up */
#define OBEYS   5.0         /* s to take a place */
#define PORTION 0.005       /* s of planning between two looks at the line */
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
        return tool_error(EX_TEMPFAIL,
                          "%s: a job is running: wait for its end, or `loft stream --abort --port "
                          "%s`",
                          v->o.line.port, v->o.line.port);
    if (s->ack.state == LOFT_STATE_FAULT)
        return tool_error(EX_TEMPFAIL, "%s: the machine has a fault: restart it", v->o.line.port);
    for (int i = 0; i < LOFT_AXES; i++)
        steps[i] = s->axis[i].position;
    read_place(v, steps);
    return 0;
}

int mover_open(mover *v, const mover_options *o, bool keys)
{
    *v       = (mover){ .o = *o };
    int code = planning_usual(&v->p, o->machine);

    if (code != 0)
        return code;
    keys_start(keys);
    code = talk_open(&v->t, &o->line);
    if (code == 0 && v->p.file == NULL)
        code = settings_adopt(&v->p.machine, &v->t);
    return code ? code : look(v);
}

void mover_close(mover *v)
{
    if (v->t.port != NULL)
        talk_close(&v->t);
}

int mover_ready(mover *v)
{
    const int code = talk_again(&v->t, v->o.line.wait);
    return code ? code : look(v);
}


// Planning
// --------

static void limits_of(const mover *v, engine_limits *l)
{
    stream_machine(&v->t.sender, l);
    planning_limit(&v->p, l);
}

static int plan_move(const mover *v, const mover_move *m, job_work *w)
{
    const drawing nothing = { 0 };
    planning p            = v->p;
    job_options as        = { .e = v->p.e, .kind = LOFT_SPANS };
    double start[ENGINE_AXES], from[ENGINE_AXES];

    stream_new_start(&v->t.sender, start);
    if (!kinematics_tool(&p.machine.k, start, from))
        return tool_error(EX_DATAERR,
                          "%s: its motors are where those of a %s machine like this "
                          "cannot be: give its --machine FILE",
                          v->o.line.port, kinematics_name(&p.machine.k));
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
    const int code = planning_joints(&p, v->o.line.port, &nothing, start, false, &as.limits,
                                     &w->path, &w->of);
    const int status = code == 0 ? job_open(&w->j, &w->of, &as) : LOFT_OK;
    w->j.k = w->of.k = &v->p.machine.k;     /* `p` ends here, and the job is drawn later */
    return status == LOFT_OK ? code : job_refuse(&w->j, v->o.line.port, status, "");
}


// Moving
// ------

/* A job with a guard is for this run alone: nobody may continue it. */
static int guard_job(const mover *v, const mover_move *m, job *j)
{
    j->head.away  = m->away;
    j->head.guard = m->guard;
    if (m->guard.inputs == 0)
        return stream_limits(&v->t, v->p.machine.hard_stop > 0, &j->head);
    j->head.id ^= v->t.sender.nonce;
    j->head.id += j->head.id == 0;
    return 0;
}

/* Loop until the job is over. *ended: we asked for its end. */
static int run_job(mover *v, const mover_move *m, job *j, bool *ended)
{
    loft_sender *s = &v->t.sender;
    int planned    = LOFT_OK;

    if (m->guard.inputs == 0 && m->ends == NULL)    /* the user sees to the others */
        talk_begins(&v->t, j->head.id, "");
    if (loft_sender_begin(s, &j->head, job_items(j), job_source, j) != LOFT_OK)
        return tool_error(EX_SOFTWARE, "the move could not begin: please report this");
    while (s->phase < LOFT_PHASE_DONE) {
        const bool more = s->phase == LOFT_PHASE_STREAMING && planned == LOFT_OK && job_waits(j, 0);
        if (more)
            planned = job_plan(j, 0, PORTION);
        loft_sender_extend(s, (uint32_t)job_ready(j), job_items(j));
        if (!talk_pump(&v->t, more ? 0 : 5))
            return talk_vanished(&v->t, "in the middle of a move ");
        if (talk_silence(&v->t) > SILENCE)
            return tool_error(
                EX_IOERR,
                "%s: the machine has been silent for %g s: it stops on the path; look "
                "at cable and power",
                v->o.line.port, SILENCE);
        if (!*ended && s->phase == LOFT_PHASE_STREAMING &&
            (planned != LOFT_OK || keys_interrupted() || (m->ends && m->ends(m->context)))) {
            loft_sender_control(s, LOFT_ABORT);
            *ended = true;
        }
    }
    talk_over(&v->t);
    return planned == LOFT_OK ? 0 : job_refuse(j, v->o.line.port, planned, "");
}

/* What the report says. Other ends than those of mover_end are errors, in the words of a stream. */
static int take_report(mover *v, const mover_move *m, job *j, bool ended, mover_outcome *out)
{
    const loft_sender *s       = &v->t.sender;
    const stream_subject about = { .file = v->o.line.port, .k = &v->p.machine.k };
    const bool done = s->phase == LOFT_PHASE_DONE, over = s->phase == LOFT_PHASE_ABORTED;
    char text[96];

    if (done || (over && s->report.job != 0))
        read_place(v, s->report.position);
    if (over && s->report.guarded && s->report.ended_by & m->guard.inputs) {
        out->how = MOVER_GUARDED;
        out->by  = s->report.ended_by;
        memcpy(out->steps, s->report.latched, sizeof out->steps);
        stream_place(s, &v->p.machine.k, s->report.latched, out->latched);
        return 0;
    }
    if (keys_interrupted())
        return tool_error(EX_TEMPFAIL, "stopped: the tool is at %s", mover_text(v->at, text));
    out->how = done ? MOVER_ARRIVED : MOVER_ENDED;
    return done || (over && ended && s->refusal == LOFT_REFUSAL_NONE)
               ? 0
               : stream_ended(&v->t, j, &about);
}

int mover_go(mover *v, const mover_move *m, mover_outcome *out)
{
    job_work w = { .path = { 0 } };
    bool ended = false;
    int code   = 0;

    *out = (mover_outcome){ .how = MOVER_ARRIVED };
    if (v->t.sender.phase != LOFT_PHASE_READY)
        code = mover_ready(v);
    if (code == 0 && memcmp(m->to, v->at, sizeof v->at) == 0)
        return 0;
    if (code == 0)
        code = plan_move(v, m, &w);
    if (code == 0)
        code = guard_job(v, m, &w.j);
    if (code == 0)
        code = run_job(v, m, &w.j, &ended);
    if (code == 0)
        code = take_report(v, m, &w.j, ended, out);
    job_work_free(&w);
    return code;
}


// Places and switches
// -------------------

static int steps_there(const mover *v, const double at[ENGINE_AXES], int32_t steps[LOFT_AXES])
{
    const loft_sender *s = &v->t.sender;
    double near[ENGINE_AXES], motors[ENGINE_AXES];
    char why[160], text[96];

    if (kinematics_beyond(&v->p.machine.k, at, why))
        return tool_error(EX_DATAERR, "%s: %s: give another place", mover_text(at, text), why);
    stream_new_start(&v->t.sender, near);
    kinematics_motors(&v->p.machine.k, at, near, motors);
    for (int i = 0; i < LOFT_AXES; i++)
        steps[i] = (int32_t)lround(motors[i] * (double)s->axis[i].steps_per_mm / 65536);
    return 0;
}

/* Wait until the machine has obeyed a place. */
static int wait_place(mover *v)
{
    const double until = tool_clock() + OBEYS;
    loft_sender *s     = &v->t.sender;

    while (s->verb != 0) {
        if (!talk_pump(&v->t, 20))
            return talk_vanished(&v->t, "before the machine obeyed ");
        if (tool_clock() > until)
            return tool_error(EX_IOERR,
                              "%s: the machine did not obey in %g s: run the same command again",
                              v->o.line.port, OBEYS);
    }
    return s->ack.refusal == LOFT_REFUSAL_NONE
               ? 0
               : tool_error(EX_TEMPFAIL, "%s: the machine refused: a job has begun meanwhile",
                            v->o.line.port);
}

int mover_place(mover *v, unsigned axes, const double at[ENGINE_AXES])
{
    loft_sender *s = &v->t.sender;
    int32_t steps[LOFT_AXES];
    int code = s->phase == LOFT_PHASE_READY ? 0 : mover_ready(v);

    if (code == 0 && !(s->machine.kinds & LOFT_TAKES_PLACES))
        code = tool_error(EX_CONFIG,
                          "%s: this machine cannot be told where it stands: give it a newer "
                          "firmware",
                          v->o.line.port);
    if (code == 0)
        code = steps_there(v, at, steps);
    if (code != 0)
        return code;
    if (!v->p.machine.k.kind->direct)
        axes = ALL;
    if (loft_sender_place(s, (uint8_t)axes, steps) != LOFT_OK)
        return tool_error(EX_SOFTWARE, "the place could not be sent: please report this");
    code = wait_place(v);
    if (code == 0) {
        talk_placed(&v->t, axes);
        read_place(v, steps);
    }
    return code;
}

int mover_table(mover *v, int axis, bool counts)
{
    const machine_file *m = &v->p.machine;
    loft_sender *s        = &v->t.sender;
    int32_t steps[LOFT_AXES] = { 0 };
    double ends[2];
    int code = 0;

    table_ends(m, axis, &ends[0], &ends[1]);
    if (!m->k.kind->direct || !(s->machine.kinds & LOFT_TAKES_TABLE) ||
        (counts && !(ends[1] < HUGE_VAL)))
        return 0;
    for (int high = 0; high <= counts && code == 0; high++) {
        const double at = ends[high] + (high ? TABLE_MORE : -TABLE_MORE);
        if (counts)
            steps[axis] = (int32_t)lround(at * (double)s->axis[axis].steps_per_mm / 65536);
        code            = loft_sender_table(s, high, (uint8_t)(1u << axis), steps) == LOFT_OK
                   ? wait_place(v)
                   : tool_error(EX_SOFTWARE, "the table could not be sent: please report this");
    }
    return code;
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
                     : tool_error(EX_UNAVAILABLE,
                                  "%s: %s is closed, and this does not lead away from it: `loft "
                                  "unlock --port %s` does",
                                  v->o.line.port, talk_inputs(held, text), v->o.line.port);
}

int mover_to(mover *v, const double to[ENGINE_AXES], double feed)
{
    mover_move m = { .feed = feed, .away = mover_away(v, v->at, to) };
    mover_outcome out;
    int code = talk_certain(&v->t);

    memcpy(m.to, to, sizeof m.to);
    if (code == 0)
        code = table_place(&v->p.machine, v->at, to, v->p.tol);
    if (code == 0)
        code = mover_free(v, to);
    return code ? code : mover_go(v, &m, &out);
}

int mover_told(const mover *v, int code)
{
    char text[96];

    if (code == 0)
        printf("the tool is at %s\n", mover_text(v->at, text));
    fflush(stdout);
    return code;
}

const char *mover_text(const double at[ENGINE_AXES], char text[96])
{
    snprintf(text, 96, "%.3f %.3f %.3f", at[0], at[1], at[2]);
    return text;
}

int mover_axes(const char *text, bool axis[ENGINE_AXES])
{
    for (const char *s = text; *s; s++) {
        const char *known = strchr("xyz", *s);
        if (known == NULL || axis[known - "xyz"])
            return tool_error(EX_USAGE, "%s: give each axis once, as xy or z", text);
        axis[known - "xyz"] = true;
    }
    return 0;
}
