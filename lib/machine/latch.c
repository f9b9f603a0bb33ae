/* lib/machine/latch.c
 * SPDX-License-Identifier: MIT
 *
 * `waits` says who may write: while it is set, the slot, which clears it last; otherwise the main
 * loop, which sets it last. So nothing is read half written.
 */
#include "machine/latch.h"
#include "machine/queue.h"      /* LOFT_BARRIER */

enum { UNSEEN = 0, FRESH = 1, KNOWN = 2 };

void loft_latch_init(loft_latch *l)
{
    loft_latch_rest(l);
    l->guard.inputs = 0;
}

void loft_latch_arm(loft_latch *l, const loft_guard *guard)
{
    loft_latch_rest(l);
    l->guard = *guard;
    l->like = l->unlike = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        l->place[i] = 0;
    LOFT_BARRIER();
    l->armed = guard->inputs != 0;
    LOFT_BARRIER();
    l->waits = l->armed && !(guard->how & LOFT_GUARD_EDGE);
}

void loft_latch_rest(loft_latch *l) { l->waits = l->seen = l->armed = 0; }


static uint8_t count_up(uint8_t count) { return count < UINT8_MAX ? (uint8_t)(count + 1) : count; }

uint16_t loft_latch_sample(loft_latch *l, uint16_t inputs)
{
    const uint16_t wanted = loft_latch_wanted(l, inputs);
    const uint8_t waited  = l->waits;   /* read first: the slot clears it last, maybe below */

    if (!l->armed)
        return 0;

    if (l->seen == FRESH) {             /* count from the change on */
        l->seen = KNOWN;
        l->like = l->unlike = 0;
    }
    const bool lasts = l->like >= l->guard.filter, back = l->unlike >= l->guard.filter;
    l->like = wanted ? count_up(l->like) : 0;
    l->unlike = wanted ? 0 : count_up(l->unlike);
    if (waited)                         /* a change that came meanwhile is newer than `inputs` */
        return 0;
    if (l->seen && wanted && lasts) {
        l->armed = 0;
        return wanted;
    }
    if (!wanted && back) {
        l->seen = UNSEEN;
        LOFT_BARRIER();
        l->waits = 1;
    }
    return 0;
}

void loft_latch_keep(loft_latch *l, const int32_t position[LOFT_AXES])
{
    if (!l->waits)
        return;
    for (int i = 0; i < LOFT_AXES; i++)
        l->place[i] = position[i];
    l->seen = FRESH;
    LOFT_BARRIER();
    l->waits = 0;
}
