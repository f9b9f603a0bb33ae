/* ports/host/world.c
 * SPDX-License-Identifier: MIT
 */
#include "host/world.h"

#include <string.h>

#include "wire/message.h"   /* LOFT_INPUT_LOW */

#define BOUNCE_S 1e-4       /* a bouncing contact changes at most this often */

static bool set(double place) { return place > -HUGE_VAL && place < HUGE_VAL; }

bool host_world_limited(const struct host_world *w)
{
    bool any = false;

    for (int i = 0; i < LOFT_AXES; i++)
        for (int end = 0; end < 2; end++)
            any = any || set(w->o->limit[i][end].at) || set(w->o->wall[i][end].at) ||
                  set(w->o->probe[i][end].at);
    return any;
}

static void place_tool(const struct host_world *w, const int64_t motor[LOFT_AXES],
                       double at[LOFT_AXES])
{
    double mm[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        mm[i] = (double)motor[i] / w->o->steps_per_mm[i];
    if (w->o->tool)
        w->o->tool(w->o->kinematics, mm, at);
    else
        memcpy(at, mm, sizeof mm);
}

static bool beyond(const struct loft_host_end *e, int end, double at)
{
    return end ? at >= e->at : at <= e->at;
}

/* True if the way from `from` to `to` leads into a wall. Away from it the tool may always move. */
static bool blocked(const struct host_world *w, const double from[LOFT_AXES],
                    const double to[LOFT_AXES])
{
    for (int i = 0; i < LOFT_AXES; i++)
        if ((to[i] < from[i] && to[i] < w->o->wall[i][0].at) ||
            (to[i] > from[i] && to[i] > w->o->wall[i][1].at))
            return true;
    return false;
}

/* The first motor of a gantry stands, or the second one, which is ahead of it. Returns false if the
 * first one stands. */
static bool take_gantry(struct host_world *w, bool back, uint16_t gated)
{
    const bool first = gated & LOFT_INPUT_LOW(w->o->gantry),
               second = gated & LOFT_INPUT_HIGH(w->o->gantry);

    if (first != second)
        w->ahead += first == back ? -1 : 1;
    return !first;
}

static void take_steps(struct host_world *w, loft_pins pins, uint16_t gated)
{
    for (int i = 0; i < LOFT_AXES; i++) {
        int64_t motor[LOFT_AXES];
        double at[LOFT_AXES];
        if (!(pins.step & 1u << i))
            continue;
        if (i == w->o->gantry && !take_gantry(w, pins.dir & 1u << i, gated))
            continue;
        memcpy(motor, w->motor, sizeof motor);
        motor[i] += pins.dir & 1u << i ? -1 : 1;
        place_tool(w, motor, at);
        if (blocked(w, w->at, at)) {
            w->lost++;
            continue;
        }
        memcpy(w->motor, motor, sizeof motor);
        memcpy(w->at, at, sizeof at);
    }
}

static uint32_t random_32(struct host_world *w)         /* xorshift (Marsaglia 2003) */
{
    w->random ^= w->random << 13;
    w->random ^= w->random >> 17;
    w->random ^= w->random << 5;
    return w->random;
}

/* The first change shows at once; then the contact bounces. */
static void feel(struct host_world *w, struct host_contact *c, bool touched, uint64_t slot)
{
    const double slot_hz = (double)w->o->tick_hz * w->o->slots;

    if (touched != c->touched) {
        c->touched = c->closed = touched;
        c->settled = slot + (uint64_t)(w->o->bounce_ms * 1e-3 * slot_hz);
        if (c->settled > w->bounces)
            w->bounces = c->settled;
    } else if (slot >= c->settled) {
        c->closed = touched;
    } else if (slot % (uint64_t)(BOUNCE_S * slot_hz + 1) == 0) {
        c->closed = random_32(w) & 1;
    }
}

double host_world_skew(const struct host_world *w)
{
    return w->o->gantry < 0 ? 0 : (double)w->ahead / w->o->steps_per_mm[w->o->gantry];
}

/* True if the switch of this end is touched, or of a gantry that of its first or second motor. */
static bool touches(const struct host_world *w, int axis, int which)
{
    const struct loft_host_end *limit = w->o->limit[axis];
    const double at = w->at[axis] + (which ? host_world_skew(w) : 0);

    return axis == w->o->gantry ? beyond(&limit[0], 0, at) || beyond(&limit[1], 1, at)
                                : beyond(&limit[which], which, w->at[axis]);
}

static void feel_all(struct host_world *w, uint64_t slot)
{
    bool touched = false;

    w->inputs = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        for (int end = 0; end < 2; end++) {
            const struct loft_host_end *limit = &w->o->limit[i][end];
            struct host_contact *c = &w->contact[2 * i + end];
            feel(w, c, touches(w, i, end), slot);
            uint16_t input = LOFT_INPUT_LOW(i);
            if (end)
                input = LOFT_INPUT_HIGH(i);
            if (w->o->shared)
                input = LOFT_INPUT_ENDS(i);
            if (c->closed != limit->opens)
                w->inputs = (uint16_t)(w->inputs | input);
            touched = touched || beyond(&w->o->probe[i][end], end, w->at[i]);
        }
    feel(w, &w->contact[HOST_WORLD_PROBE], touched, slot);
    if (w->contact[HOST_WORLD_PROBE].closed)
        w->inputs |= LOFT_INPUT_PROBE;
}

void host_world_init(struct host_world *w, const struct loft_host_options *o)
{
    memset(w, 0, sizeof *w);
    w->o = o;
    w->random = 1;
    place_tool(w, w->motor, w->at);
    if (o->gantry >= 0)
        w->ahead = (int64_t)(o->skew * o->steps_per_mm[o->gantry]);
    feel_all(w, 0);
    host_world_settle(w);
}

void host_world_slot(struct host_world *w, uint64_t slot, loft_pins pins, uint16_t gated)
{
    if (pins.step == 0 && slot > w->bounces)
        return;
    take_steps(w, pins, gated);
    feel_all(w, slot);
}

void host_world_settle(struct host_world *w)
{
    for (int i = 0; i <= HOST_WORLD_PROBE; i++)
        w->contact[i].settled = 0;
    w->bounces = 0;
    feel_all(w, 0);
}
