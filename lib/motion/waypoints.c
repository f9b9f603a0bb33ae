/* lib/motion/waypoints.c
 * SPDX-License-Identifier: MIT
 */
#include "motion/waypoints.h"

static enum loft_status segment(const loft_waypoints *w, uint32_t i, loft_move *move)
{
    move->feed = w->feed;
    return loft_cubic_from_natural(&w->spline, i, &move->curve);
}

/* Can the plan take it? */
static enum loft_status check(const loft_move *m)
{
    if (!(m->feed > 0))
        return LOFT_ERR_ARG;
    if (m->feed < LOFT_SPEED_MIN || m->feed > LOFT_SPEED_MAX)
        return LOFT_ERR_RANGE;
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            if (!(loft_real_abs(m->curve.p[k].axis[i]) <= LOFT_PLAN_REACH))
                return LOFT_ERR_RANGE;
    return LOFT_OK;
}

enum loft_status loft_waypoints_init(loft_waypoints *w, loft_plan *plan, const loft_vec p[],
                                     uint32_t count, loft_real feed, loft_natural_knot memory[])
{
    loft_move move;
    enum loft_status status = loft_natural_init(&w->spline, p, count, LOFT_CHORD, memory);

    w->plan = plan;
    w->feed = feed;
    w->next = 0;
    for (uint32_t i = 0; status == LOFT_OK && i + 1 < count; i++) {
        status = segment(w, i, &move);
        if (status == LOFT_OK)
            status = check(&move);
    }
    return status;
}

enum loft_plan_state loft_waypoints_next(loft_waypoints *w, loft_span *out)
{
    loft_move move;

    while (w->next + 1 < w->spline.count && loft_plan_room(w->plan) > 0 &&
           segment(w, w->next, &move) == LOFT_OK && loft_plan_push(w->plan, &move) == LOFT_OK)
        if (++w->next + 1 == w->spline.count)
            loft_plan_end(w->plan);
    return loft_plan_next(w->plan, out);
}
