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

/* Push the segments that there is room for; false: none was, nor did the plan learn that it stops
 * before the next one. */
static bool push_more(loft_waypoints *w)
{
    enum loft_status status = LOFT_OK;
    bool more = false;
    loft_move move;

    while (status == LOFT_OK && w->next + 1 < w->spline.count && loft_plan_room(w->plan) > 0) {
        status = segment(w, w->next, &move);
        if (status == LOFT_OK)
            status = loft_plan_push(w->plan, &move);
        if (status == LOFT_OK && ++w->next + 1 == w->spline.count)
            loft_plan_end(w->plan);
        more = more || status == LOFT_OK || status == LOFT_ERR_SPACE;
    }
    return more;
}

/* A plan that waits has dropped a segment at least, or has room; one that rests before the last
 * segment has room as well. */
enum loft_plan_state loft_waypoints_next(loft_waypoints *w, loft_span *out)
{
    enum loft_plan_state state;

    (void)push_more(w);
    do
        state = loft_plan_next(w->plan, out);
    while (state != LOFT_PLAN_SPAN && push_more(w));
    return state;
}
