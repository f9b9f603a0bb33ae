/* tests/lib/machine/test_latch.c -- properties of lib/machine/latch.h, beside a record of samples
 * SPDX-License-Identifier: MIT
 */
#include "check.h"
#include "machine/latch.h"

#define SLOTS   8               /* between two samples */
#define SAMPLES 400

static loft_latch l;
static int32_t at[LOFT_AXES];

/* A contact that changes now and then, and bounces. */
typedef struct {
    uint32_t settled, bounces;  /* slots to go */
    bool on, now;
} contact;

static void contact_moves(arb *a, contact *c)
{
    if (c->settled-- == 0) {
        c->on = !c->on;
        c->settled = 1 + arb_below(a, arb_below(a, 2) ? 6 * SLOTS : 60 * SLOTS);
        c->bounces = arb_below(a, 4 * SLOTS);
        c->now = c->on;
        return;
    }
    c->now = c->on;
    if (c->bounces > 0) {
        c->bounces--;
        c->now = arb_below(a, 2);
    }
}

/* By its definition, from the samples alone: the guard comes true at a sample that ends filter + 1
 * equal ones since the candidate was seen. The candidate is the first slot that the guard wants,
 * after a rest: filter + 1 samples that it does not want, or the beginning. */
static void the_first_change_of_what_lasts_is_kept(arb *a)
{
    const loft_guard g = { .inputs = (uint16_t)(1u << arb_below(a, 16)),
                           .how = (uint8_t)arb_below(a, 4),
                           .filter = (uint8_t)arb_below(a, 7) };
    const bool opens = g.how & LOFT_GUARD_OPENS;
    uint32_t like = 0, unlike = 0, first = 0;
    bool ready = !(g.how & LOFT_GUARD_EDGE), candidate = false, came = false;
    contact c = { .settled = arb_below(a, 30 * SLOTS), .on = arb_below(a, 2) };

    loft_latch_init(&l);
    CHECK(loft_latch_place(&l) == NULL && !loft_latch_waits(&l));
    loft_latch_arm(&l, &g);
    for (uint32_t slot = 0; slot < SLOTS * SAMPLES; slot++) {
        contact_moves(a, &c);
        const bool wanted = c.now != opens;
        const uint16_t closed = (uint16_t)((c.now ? g.inputs : 0) | (arb_next(a) & ~g.inputs));
        for (int i = 0; i < LOFT_AXES; i++)
            at[i] = (int32_t)(slot * 7 + (uint32_t)i);
        if (ready && wanted && !candidate && !came) {
            candidate = true;
            first = slot;
            like = unlike = 0;
        }
        CHECK(loft_latch_waits(&l) == (ready && (!candidate || first == slot) && !came));
        if (loft_latch_wanted(&l, closed))
            loft_latch_keep(&l, at);
        if (slot % SLOTS)
            continue;
        like = wanted ? like + 1 : 0;
        unlike = wanted ? 0 : unlike + 1;
        const bool comes = candidate && !came && like > g.filter;
        CHECK(loft_latch_sample(&l, closed) == (comes ? g.inputs : 0));
        if (comes) {
            came = true;
            for (int i = 0; i < LOFT_AXES; i++)
                CHECK(loft_latch_place(&l)[i] == (int32_t)(first * 7 + (uint32_t)i));
        } else if (unlike > g.filter && !came) {
            ready = true;
            candidate = false;
        }
    }
    for (int i = 0; i < LOFT_AXES && came; i++)
        CHECK(loft_latch_place(&l)[i] == (int32_t)(first * 7 + (uint32_t)i));
}

static void without_a_guard_and_after_the_job_nothing_is_awaited(arb *a)
{
    const loft_guard none = { 0, 0, 0 }, some = { (uint16_t)(1 + arb_below(a, 65535)), 0, 0 };

    loft_latch_arm(&l, &none);
    CHECK(!loft_latch_waits(&l) && loft_latch_place(&l) == NULL);
    CHECK(loft_latch_sample(&l, (uint16_t)(arb_next(a) >> 48)) == 0);
    loft_latch_arm(&l, &some);
    CHECK(loft_latch_waits(&l) && loft_latch_place(&l) != NULL);
    at[0] = (int32_t)arb_below(a, 1000);
    loft_latch_keep(&l, at);
    loft_latch_rest(&l);
    CHECK(!loft_latch_waits(&l) && loft_latch_sample(&l, some.inputs) == 0);
    CHECK(loft_latch_place(&l)[0] == at[0]);
}

int main(void)
{
    PROPERTY(the_first_change_of_what_lasts_is_kept,                    2000);
    PROPERTY(without_a_guard_and_after_the_job_nothing_is_awaited,       200);
    return check_failures();
}
