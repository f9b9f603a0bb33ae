/* tests/support/motion_spans.h -- plans a chain into spans, with any arrival of its curves
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TESTS_MOTION_SPANS_H
#define LOFT_TESTS_MOTION_SPANS_H

#include "support/motion_chains.h"  /* chain, curves, limits */
#include "support/motion_oracle.h"  /* motion, span_at       */

#ifndef SPANS
#  define SPANS 200000
#endif
#define KNOTS 400           /* of a plan that sees far ahead */

static loft_span spans[SPANS];
static unsigned  count;

/* How curves arrive: room for this many curves and knots. `piecemeal` draws how many are pushed
 * and taken at a time, and when the plan is told that no curve comes in time. NULL: push all that
 * fit, then take all spans. */
typedef struct {
    uint16_t moves, knots;
    arb     *piecemeal;
} arrival;

enum outcome { PLANNED, REFUSED, STUCK, ENDLESS };

static const char *const outcome_name[] = { "planned", "refused", "stuck", "endless" };

/* Plan the chain. STUCK: it neither accepts a curve nor gives a span, or it is at rest before the
 * end. */
static inline enum outcome plan_chain(const arrival *how)
{
    static loft_move  ring[CURVES];
    static loft_knot  knots[KNOTS];
    static loft_plan  plan;
    unsigned next = 0, idle = 0;

    count = 0;
    if (loft_plan_init(&plan, &limits, ring, how->moves, knots, how->knots) != LOFT_OK)
        return REFUSED;
    while (idle < 100) {
        enum loft_plan_state state = LOFT_PLAN_SPAN;
        const unsigned before = next + count;
        bool full = false;
        for (unsigned n = how->piecemeal ? arb_below(how->piecemeal, 3) : CURVES;
             next < curves && n > 0 && !full; n--) {
            const enum loft_status status = loft_plan_push(&plan, &chain[next]);
            full = status == LOFT_ERR_SPACE;
            next += status == LOFT_OK;
            if (status != LOFT_OK && !full)
                return REFUSED;
        }
        if (next == curves || (how->piecemeal && arb_below(how->piecemeal, 4) == 0))
            loft_plan_end(&plan);
        for (unsigned n = how->piecemeal ? arb_below(how->piecemeal, 9) : SPANS;
             n > 0 && state == LOFT_PLAN_SPAN; n--) {
            if (count == SPANS)
                return ENDLESS;
            state = loft_plan_next(&plan, &spans[count]);
            count += state == LOFT_PLAN_SPAN;
        }
        if (next == curves && state == LOFT_PLAN_REST)
            return PLANNED;
        idle = next + count > before ? 0 : idle + 1;
    }
    return STUCK;
}

static inline double duration(const loft_span *s) { return s->ticks / (double)limits.tick_hz; }

static inline double seconds(void)
{
    double ticks = 0;
    for (unsigned k = 0; k < count; k++)
        ticks += spans[k].ticks;
    return ticks / limits.tick_hz;
}

/* Do the spans lead from rest on the first control point to rest on the last, without a gap? */
static inline bool spans_connect(void)
{
    bool good = count > 0 && loft_vec_equal(spans[0].p[0], chain[0].curve.p[0]) &&
                loft_vec_equal(spans[0].p[1], spans[0].p[0]) &&
                loft_vec_equal(spans[count - 1].p[3], chain[curves - 1].curve.p[3]) &&
                loft_vec_equal(spans[count - 1].p[2], spans[count - 1].p[3]);

    for (unsigned k = 0; k < count && good; k++)
        good = spans[k].ticks >= 1 && spans[k].ticks <= LOFT_SPAN_TICKS_MAX &&
               (k == 0 || loft_vec_equal(spans[k].p[0], spans[k - 1].p[3]));
    return good;
}

#endif
