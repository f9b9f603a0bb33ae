/* host-tools/send/greeted.c
 * SPDX-License-Identifier: MIT
 */
#include <math.h>
#include <string.h>

#include "send/greeted.h"

#define LIMIT_FILTER 1      /* ms that a limit switch must stay closed: sparks are shorter */

void stream_place(const loft_sender *s, const kinematics *k, const int32_t steps[LOFT_AXES],
                  double out[LOFT_AXES])
{
    double at[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        at[i] = (double)steps[i] * 65536 / (double)s->axis[i].steps_per_mm;
    if (!kinematics_tool(k, at, out))
        memcpy(out, at, sizeof at);
}

void stream_machine(const loft_sender *s, engine_limits *l)
{
    for (int i = 0; i < ENGINE_AXES; i++) {
        l->max_speed[i] = (double)s->axis[i].max_speed / 65536;
        l->max_accel[i] = (double)s->axis[i].max_accel / 65536;
    }
    l->tick_hz = s->machine.tick_hz;
}

static double mm_of(const loft_axis *a, int32_t steps)
{
    return round((double)steps * 65536 * 65536 / (double)a->steps_per_mm) / 65536;
}

void stream_new_start(const loft_sender *s, double out[ENGINE_AXES])
{
    for (int i = 0; i < ENGINE_AXES; i++)
        out[i] = mm_of(&s->axis[i], s->axis[i].position);
}

void stream_old_start(const loft_sender *s, bool points, double out[ENGINE_AXES])
{
    for (int i = 0; i < ENGINE_AXES; i++)
        out[i] = points ? mm_of(&s->axis[i], s->axis[i].start) : (double)s->axis[i].start / 65536;
}

static const engine *engine_of(const loft_welcome *machine)
{
    return machine->num == LOFT_F32   ? &engine_f32
           : machine->num == LOFT_F64 ? &engine_f64
                                      : &engine_q16;
}

void stream_commanded(const loft_sender *s, const job *j, int32_t out[LOFT_AXES])
{
    const engine *e = engine_of(&s->machine);

    for (int i = 0; i < LOFT_AXES; i++)
        out[i] = j->head.kind == LOFT_POINTS ? j->last[i]
                                             : e->steps((double)j->last[i] / 65536,
                                                        (double)s->axis[i].steps_per_mm / 65536);
}

bool stream_guard(const loft_sender *s, loft_job *head)
{
    if (!(s->machine.kinds & LOFT_TAKES_GUARDS))
        return false;
    head->guard = (loft_guard){ LOFT_INPUT_ENDING & ~s->closed & ~head->away, LOFT_GUARD_HARD,
                                LIMIT_FILTER };
    return true;
}
