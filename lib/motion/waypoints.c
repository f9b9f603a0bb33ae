/* lib/motion/waypoints.c
 * SPDX-License-Identifier: MIT
 */
#include "motion/waypoints.h"

static enum loft_status segment(const loft_waypoints *w, uint32_t i, loft_move *move)
{
    move->feed = w->feed;
    return loft_cubic_from_natural(&w->spline, i, &move->curve);
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
            status = loft_chain_accepts(&move);
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
