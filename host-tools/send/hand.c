/* host-tools/send/hand.c
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "plan/table.h"          /* table_ends */
#include "send/hand.h"

#define FAR 8000.0              /* mm: as far as a jog leads without a table */

static void begin(hand *m, mover *v, double feed)
{
    *m = (hand){ .v = v, .feed = feed };
    sequence_begin(&m->q, v, m);
}

/* Where is it? */
static int greet(void *context)
{
    mover *v = ((hand *)context)->v;

    if (v->stage == NULL && v->t.sender.phase != LOFT_PHASE_READY)
        mover_ready(v);
    return 0;
}


// To a place
// ----------

static int go(void *context)
{
    const hand *m = context;
    mover *v      = m->v;
    double to[ENGINE_AXES];

    for (int i = 0; i < ENGINE_AXES; i++)
        to[i] = isnan(m->to[i]) ? v->at[i] : m->to[i] + (m->by ? v->at[i] : 0);
    mover_to(v, to, m->feed);
    return 0;
}

void hand_go(hand *m, mover *v, const double to[ENGINE_AXES], bool by, double feed)
{
    begin(m, v, feed);
    memcpy(m->to, to, sizeof m->to);
    m->by = by;
    sequence_add(&m->q, greet, NULL);
    sequence_add(&m->q, go, NULL);
}

static int lift_to(const hand *m, double z)
{
    const double to[ENGINE_AXES] = { m->v->at[0], m->v->at[1], z };

    mover_to(m->v, to, m->feed);
    return 0;
}

static int lift(void *context)
{
    const hand *m               = context;
    const machine_file *machine = &m->v->p.machine;

    return lift_to(m, m->up ? machine->pen_up : machine->pen_down);
}

void hand_pen(hand *m, mover *v, bool up, double feed)
{
    begin(m, v, feed);
    m->up = up;
    sequence_add(&m->q, greet, NULL);
    sequence_add(&m->q, lift, NULL);
}

static int lift_for_park(void *context)
{
    hand *m = context;

    m->to[0] = m->v->p.machine.park[0];
    m->to[1] = m->v->p.machine.park[1];
    m->to[2] = fmax(m->v->at[2], m->v->p.machine.pen_up);
    return lift_to(m, m->to[2]);
}

void hand_park(hand *m, mover *v, double feed)
{
    begin(m, v, feed);
    sequence_add(&m->q, greet, NULL);
    sequence_add(&m->q, lift_for_park, NULL);
    sequence_add(&m->q, go, NULL);
}


// Along an axis
// -------------

static int jog(void *context)
{
    const hand *m  = context;
    mover *v       = m->v;
    mover_move to  = { .feed = m->feed, .ends = m->ends, .context = m->context };
    double *end    = &to.to[m->axis], least, most;

    table_ends(&v->p.machine, m->axis, &least, &most);
    memcpy(to.to, v->at, sizeof to.to);
    *end += fmax(fmin(m->way, FAR), -FAR);
    *end    = fmax(fmin(*end, fmax(most, v->at[m->axis])), fmin(least, v->at[m->axis]));
    to.away = mover_away(v, v->at, to.to);
    const int code = mover_free(v, to.to);
    if (code == 0)
        mover_go(v, &to);
    return code;
}

void hand_jog(hand *m, mover *v, int axis, double way, double feed, bool (*ends)(void *context),
              void *context)
{
    begin(m, v, feed);
    m->axis    = axis;
    m->way     = way;
    m->ends    = ends;
    m->context = context;
    sequence_add(&m->q, greet, NULL);
    sequence_add(&m->q, jog, NULL);
}


// Where it stands
// ---------------

/* The zero lies as much farther on the table as the tool's place changes. */
static int keep_zero(void *context)
{
    hand *m = context;
    double farther[ENGINE_AXES];

    for (int i = 0; i < ENGINE_AXES; i++)
        farther[i] = m->axes >> i & 1 ? m->v->at[i] - m->to[i] : 0;
    mover_keep_zero(m->v, farther);
    return 0;
}

static int note_place(void *context)
{
    hand *m = context;

    memcpy(m->was, m->v->at, sizeof m->was);
    return 0;
}

static int place(void *context)
{
    hand *m = context;

    for (int i = 0; i < ENGINE_AXES; i++)
        m->to[i] = m->axes >> i & 1 ? m->to[i] : m->was[i];
    mover_place(m->v, m->axes, m->to);
    return 0;
}

void hand_zero(hand *m, mover *v, unsigned axes, const double at[ENGINE_AXES], bool keep)
{
    begin(m, v, 0);
    m->axes = axes;
    memcpy(m->to, at, sizeof m->to);
    sequence_add(&m->q, greet, note_place);
    if (keep)
        sequence_add(&m->q, keep_zero, NULL);
    sequence_add(&m->q, place, NULL);
}

task hand_task(hand *m) { return sequence_task(&m->q); }
