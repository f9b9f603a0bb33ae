/* tests/lib/machine/test_override.c -- properties of lib/machine/drive.h: the limits of the axes at
 * any override, measured at the ticks
 * SPDX-License-Identifier: MIT
 */
#include "support/rig.h"

#define FASTEST 0.04                                /* mm per tick: 16 steps of axis 2 */

static loft_drive drive;
static double place[TICKS + 1][LOFT_AXES];          /* exact mm after each tick of the plan */
static double bent[ITEMS][LOFT_AXES];               /* the largest acceleration, mm per tick^2 */
static double limit_v[LOFT_AXES], limit_a[LOFT_AXES];

static double fraction(arb *a) { return (double)arb_below(a, 1000001) / 1000000; }

/* Position and velocity are continuous between items; at both ends the job is at rest. */
static void arb_smooth(arb *a)
{
    double v[LOFT_AXES] = { 0 };
    int32_t from[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        from[i] = r.start[i];
    r.items = r.ticks = 0;
    while (r.items < ITEMS && r.ticks < TICKS - 200) {
        loft_item *item = &r.item[r.items];
        const bool last = r.items == ITEMS - 1 || r.ticks > TICKS - 320;
        item->ticks = (uint16_t)(20 + arb_below(a, 100));
        const double n = item->ticks, calm = fraction(a);
        for (int i = 0; i < LOFT_AXES; i++) {
            const double next = last
                                    ? 0
                                    : v[i] + (FASTEST * (2 * fraction(a) - 1) - v[i]) * calm * calm,
                         middle = (v[i] + next) / 2;
            const double begin = from[i];
            item->p[0][i] = (int32_t)lround(begin + v[i] * n / 3 * 65536);
            item->p[2][i] = (int32_t)lround(
                begin + (middle + calm * FASTEST / 20 * (2 * fraction(a) - 1)) * n * 65536);
            item->p[1][i] = (int32_t)lround(item->p[2][i] - next * n / 3 * 65536);
            v[i] = next;
        }
        loft_forward w;
        loft_span span;
        loft_vec mm;
        loft_item_span(item, from, &span);
        CHECK(loft_span_walk(&w, &span) == LOFT_OK);
        for (int tick = 1; loft_forward_next(&w, &mm); tick++) {
            const double t = tick / n, u = 1 - t;
            r.item_of[r.ticks++] = r.items;
            steps_of(mm, r.path[r.ticks]);
            for (int i = 0; i < LOFT_AXES; i++)
                place[r.ticks][i] = (u * u * u * from[i] + 3 * u * u * t * item->p[0][i] +
                                     3 * u * t * t * item->p[1][i] + t * t * t * item->p[2][i]) /
                                    65536;
        }
        for (int i = 0; i < LOFT_AXES; i++) {
            const double p0 = from[i], p1 = item->p[0][i], p2 = item->p[1][i], p3 = item->p[2][i];
            bent[r.items][i] = 6 * fmax(fabs(p2 - 2 * p1 + p0), fabs(p3 - 2 * p2 + p1)) / 65536 /
                               n / n;
            from[i] = item->p[2][i];
        }
        r.items++;
        if (last)
            break;
    }
}

/* A job, and axes that can do at least `spare` times its maximum; *spare 0: at least half of it. */
static void begin(arb *a, uint16_t slots, uint16_t ramp, double spare)
{
    loft_drive_config c;

    do
        c = rig_init(a, &drive, slots, ramp, 20);
    while (r.kind != LOFT_SPANS);
    r.cells = c.cells = CELLS;
    arb_smooth(a);
    for (int i = 0; i < LOFT_AXES; i++) {
        double worst_v = 0, worst_a = 0;
        place[0][i] = r.start[i] / 65536.0;
        for (uint32_t k = 0; k < r.ticks; k++)
            worst_v = fmax(worst_v, fabs(place[k + 1][i] - place[k][i]));
        for (uint32_t k = 0; k < r.items; k++)
            worst_a = fmax(worst_a, bent[k][i]);
        const double v = worst_v * (spare > 0 ? spare : 0.5 + 1.5 * fraction(a)),
                     b = worst_a * (spare > 0 ? spare : 0.5 + 2.5 * fraction(a));
        axes[i].max_speed = (int32_t)(v * 1000 * 65536 + 1);
        axes[i].max_accel = (int32_t)fmin(b * 1e6 * 65536 + 1, INT32_MAX);
        limit_v[i] = axes[i].max_speed / 65536.0 / 1000;
        limit_a[i] = axes[i].max_accel / 65536.0 / 1e6;
    }
    CHECK(loft_drive_init(&drive, &c) == LOFT_OK);
    CHECK(loft_drive_begin(&drive, r.kind, r.start) == LOFT_OK);
    r.law = true;
}

/* One slot. Returns true when a tick has passed, which lasted *slots. */
static bool one_slot(double *slots)
{
    const uint32_t passed = r.passed, lasts = r.lasts + 1;

    loft_drive_tick(&drive);
    rig_slot();
    *slots = lasts;
    return r.passed != passed;
}

/* Check the last two ticks. A tick's length is rounded to slots, and errs by 0.3 % of the pace:
 * `noise`. While the pace changes, the speed of the plan over the ramp is added, see
 * machine/pace.h. */
static void check_limits(double lasted, double lasts)
{
    const uint32_t k = r.passed - 1;                /* this tick, behind k - 1 */
    const double r1 = r.slots / lasted, r2 = r.slots / lasts, middle = (1 / r1 + 1 / r2) / 2;
    const double noise1 = 1.3 / lasted + 0.003, noise2 = 1.3 / lasts + 0.003;

    for (int i = 0; i < LOFT_AXES; i++) {
        const double w1 = place[k][i] - place[k - 1][i], w2 = place[k + 1][i] - place[k][i],
                     w = fabs(w1 + w2) / 2;
        const double planned = fmax(bent[r.item_of[k - 1]][i], bent[r.item_of[k]][i]),
                     rounding = 8 / 65536.0 / 20 / 20;
        CHECK(fabs(r2 * w2) <= fmax(limit_v[i], fabs(w2)) * (1 + noise2));
        CHECK_NEAR((r2 * w2 - r1 * w1) / middle, 0,
                   4 * rounding + fmax(limit_a[i], planned) * 1.01 +
                       w / r.ramp * (1 + 1. / r.ramp) +
                       (r1 * fabs(w1) * noise1 + r2 * fabs(w2) * noise2) / middle);
    }
}

static unsigned hurried;        /* ticks that were shorter than planned */

static void each_axis_keeps_to_its_limits_at_any_override(arb *a)
{
    double lasted = 0, lasts;
    uint32_t change = 0;

    begin(a, (uint16_t)(1000 + arb_below(a, 1000)), (uint16_t)(20 + arb_below(a, 60)), 0);
    for (uint32_t slot = 0; loft_state_busy(drive.state) && slot < 40000000; slot++) {
        if (slot >= change) {
            change = slot + arb_below(a, 400000);
            loft_drive_override(&drive, arb_below(a, 4) ? 60 + arb_below(a, 160) : 200);
            loft_drive_hold(&drive, arb_below(a, 20) == 0);
        }
        if (r.pushed < r.items && loft_drive_push(&drive, &r.item[r.pushed]) == LOFT_OK)
            r.pushed++;
        if (r.pushed == r.items)
            loft_drive_end(&drive);
        if (!one_slot(&lasts))
            continue;
        if (r.passed > 1 && lasted > 0)
            check_limits(lasted, lasts);
        hurried += lasts < r.slots - 2;
        lasted = lasts;
    }
    CHECK(drive.state == LOFT_STATE_DONE && r.passed == r.ticks && drive.slowed == 0);
}

static void ticks_were_shorter_than_planned(arb *a)
{
    (void)a;
    CHECK(check_sampled() || hurried > 1000);
}

/* From 0 to 2 the pace takes twice the ramp. In that time as many ticks of the plan pass as at pace
 * 1. */
static void with_limits_far_away_200_percent_is_half_the_time(arb *a)
{
    double lasts, sum = 0;

    begin(a, (uint16_t)(400 + 2 * arb_below(a, 200)), (uint16_t)(20 + 2 * arb_below(a, 30)), 8);
    loft_drive_override(&drive, 1000);
    while (r.pushed < r.items && loft_drive_push(&drive, &r.item[r.pushed]) == LOFT_OK)
        r.pushed++;
    CHECK(r.pushed == r.items);
    loft_drive_end(&drive);
    for (uint32_t slot = 0; loft_state_busy(drive.state) && slot < 40000000; slot++)
        if (one_slot(&lasts))
            sum += lasts;
    const double want = r.ticks / 2. + r.ramp;
    CHECK(drive.state == LOFT_STATE_DONE && r.passed == r.ticks && drive.slowed == 0);
    CHECK_NEAR(sum / r.slots, want, 2 + want * 0.004);
    loft_drive_close(&drive);
}

int main(void)
{
    PROPERTY_LONG(each_axis_keeps_to_its_limits_at_any_override,    BY_NUM(8, 4, 4));
    PROPERTY(ticks_were_shorter_than_planned,                   1);
    PROPERTY(with_limits_far_away_200_percent_is_half_the_time, BY_NUM(5, 2, 2));
    return check_failures();
}
