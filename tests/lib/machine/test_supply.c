/* tests/lib/machine/test_supply.c -- properties of lib/machine/drive.h: a machine on a line that is
 * too slow, uneven or cut
 * SPDX-License-Identifier: MIT
 */
#include <math.h>

#include "check.h"
#include "machine/drive.h"

#define CELLS 256
#define SLOTS 40

static loft_drive drive;
static volatile loft_cell cells[CELLS];

/* An even motion without an end, in spans of `ticks`. The line brings `portion` of them at once, at
 * `rate` times the need of pace 1. */
typedef struct {
    enum loft_kind kind;
    uint16_t cells, ticks, portion, ramp;
    double rate;
    bool cut;

    int32_t end[LOFT_AXES];         /* of the last span pushed */
    uint32_t waiting;               /* received spans that are not yet pushed */
    double due;                     /* ticks of time until the next portion */
    uint32_t slots;                 /* of the current tick */
    uint32_t passed, turns, stands; /* ticks; turns of the pace up or down; stops of the machine */
    double slowest, fastest;        /* of the pace */
    double extreme;                 /* the pace at the last turn */
    int sense;
} line;

static line l;

static void start(enum loft_kind kind, uint16_t count, uint16_t ticks, uint16_t portion,
                  uint16_t ramp, double rate)
{
    static loft_axis_config axis[LOFT_AXES];
    loft_drive_config c = {
        .axis = axis, .tick_hz = 1000, .slots = SLOTS, .ramp = ramp, .cell = cells, .cells = count
    };

    l = (line){ .kind = kind,
                .cells = count,
                .ticks = ticks,
                .portion = portion,
                .ramp = ramp,
                .rate = rate,
                .slowest = 9 };
    for (int i = 0; i < LOFT_AXES; i++) {
        axis[i] = (loft_axis_config){ .steps_per_mm = 100 * 65536 };
        c.position[i] = 0;
    }
    CHECK(loft_drive_init(&drive, &c) == LOFT_OK);
    CHECK(loft_drive_begin(&drive, kind, l.end) == LOFT_OK);
}

/* Always toward free space: 0.01 mm per tick. */
static void push(void)
{
    loft_item item = { .ticks = l.ticks };
    const int32_t third = 218 * l.ticks;

    for (int k = 0; k < 3; k++)
        for (int i = 0; i < LOFT_AXES; i++)
            item.p[k][i] = l.end[i] + (k + 1) * (i == 0 ? third : -third);
    if (loft_drive_push(&drive, &item) != LOFT_OK)
        return;
    for (int i = 0; i < LOFT_AXES; i++)
        l.end[i] = item.p[2][i];
    l.waiting--;
}

/* A change of less than a quarter does not count, because the slowest paces differ by as much. */
static void note(double pace)
{
    l.slowest = fmin(l.slowest, pace);
    l.fastest = fmax(l.fastest, pace);
    if (l.sense >= 0 ? pace > l.extreme : pace < l.extreme)
        l.extreme = pace;
    else if (l.sense >= 0 ? pace < l.extreme * 4 / 5 : pace > l.extreme * 5 / 4) {
        l.sense = l.sense >= 0 ? -1 : 1;
        l.extreme = pace;
        l.turns++;
    }
}

static void forget(void)
{
    l.passed = l.turns = l.stands = 0;
    l.slowest = 9;
    l.fastest = 0;
    l.sense = 0;
}

/* One tick of time. The machine stops only where the pace is 0: the queue is never empty while it
 * moves. */
static void live(void)
{
    for (l.due -= 1; l.due <= 0 && !l.cut; l.due += l.portion * l.ticks / l.rate)
        l.waiting = l.waiting + l.portion > 2u * CELLS ? l.waiting : l.waiting + l.portion;
    for (int slot = 0; slot < SLOTS; slot++) {
        if (l.waiting)
            push();
        loft_drive_prepare(&drive);
        loft_drive_tick(&drive);
        const bool stood = loft_step_done(&drive.step);
        CHECK(!stood || drive.pace.level == 0);
        (void)loft_drive_slot(&drive);
        l.slots++;
        if (!stood && !drive.step.busy) {
            note((double)SLOTS / l.slots);
            l.slots = 0;
            l.passed++;
        } else if (stood) {
            l.stands += l.slots == 1 && l.slowest < 9;
            if (l.slots == 1)
                note(0);
            l.slots = 2;
        }
    }
}

static void settle(double ticks)
{
    while (ticks-- > 0)
        live();
    forget();
}

/* The fill of pace 1, in ticks. */
static double horizon_of(enum loft_kind kind, uint16_t ramp)
{
    return (LOFT_MACHINE_PLANS && kind == LOFT_CURVES ? 8 : 16) * ceil(ramp / 2.);
}
static double horizon(void)         { return horizon_of(l.kind, l.ramp); }
static double portion_ticks(void)   { return (double)l.portion * l.ticks; }

/* Portions below 1/8 of the fill that belongs to the rate: the law of supply ignores them. */
static void a_line_of_any_rate_makes_an_even_pace(arb *a)
{
    const enum loft_kind kind = arb_below(a, 2) ? LOFT_SPANS : LOFT_CURVES;
    const uint16_t ramp = (uint16_t)(20 + arb_below(a, 100));
    const double rate = 0.15 + arb_below(a, 81) / 100.0, most = horizon_of(kind, ramp) * rate / 8,
                 worth = 32. * (ramp + 1) / CELLS;

    start(kind, CELLS, (uint16_t)(1 + arb_below(a, (uint32_t)fmax(1, fmin(most, 80)))), 1, ramp,
          rate);
    while (fmax(l.ticks, worth) * (l.portion + 1) < most && arb_below(a, 3))
        l.portion++;
    settle(8 * horizon() / rate);
    const double fill = drive.ahead, time = 12000;
    for (int tick = 0; tick < time; tick++)
        live();
    CHECK(l.stands == 0);
    const double grain = 0.5 / sqrt(loft_pace_full(&drive.pace));       /* half the slowest pace */
    CHECK(l.slowest > rate * 0.75 - grain && l.fastest < rate * 1.25 + grain);
    CHECK(l.turns <= 6);
    CHECK_NEAR(l.passed, rate * time, 2 * portion_ticks() + fabs(fill - drive.ahead) + 2);
}

/* Any portions: the pace may rise and fall with each, but no more often. */
static void portions_of_any_size_make_no_oscillation_of_their_own(arb *a)
{
    start(arb_below(a, 2) ? LOFT_SPANS : LOFT_CURVES, (uint16_t)(8 + arb_below(a, CELLS - 7)),
          (uint16_t)(1 + arb_below(a, 60)), (uint16_t)(1 + arb_below(a, 30)),
          (uint16_t)(20 + arb_below(a, 80)), 0.1 + arb_below(a, 86) / 100.0);
    settle(8 * horizon() / l.rate);
    const uint32_t fill = drive.ahead + l.waiting * l.ticks;
    const double time = 20000, portions = time * l.rate / portion_ticks();
    for (int tick = 0; tick < time; tick++)
        live();
    CHECK(l.turns <= 2 * portions + 6);
    CHECK_NEAR(l.passed, l.rate * time,
               2 * portion_ticks() + fabs((double)fill - drive.ahead - l.waiting * l.ticks) + 2);
}

/* After a cut of the line the machine stops on the path, with hardly anything left. It continues
 * when the line is back. */
static void a_cut_line_lets_the_machine_come_to_a_stand(arb *a)
{
    start(arb_below(a, 2) ? LOFT_SPANS : LOFT_CURVES, (uint16_t)(16 + arb_below(a, CELLS - 15)),
          (uint16_t)(1 + arb_below(a, 60)), 1, (uint16_t)(20 + arb_below(a, 80)), 4);
    settle(6000);
    CHECK(drive.pace.level == loft_pace_full(&drive.pace) || l.cells * l.ticks < 3 * l.ramp);
    l.cut = true;
    l.waiting = 0;
    uint32_t ticks = 0;
    for (; ticks < 200000 && !(loft_step_done(&drive.step) && drive.pace.level == 0); ticks++)
        live();
    CHECK(ticks < 200000 && l.turns <= 1);
    CHECK(drive.ahead <= fmax(horizon() / sqrt(loft_pace_full(&drive.pace)) + 3, 4 * l.ticks));
    l.cut = false;
    settle(6000);
    CHECK(drive.pace.level == loft_pace_full(&drive.pace) || l.cells * l.ticks < 3 * l.ramp);
}

/* An empty queue becomes full, and until then the law loses that time: an eighth more, as the pace
 * follows so much later, and the time until the fill is a sixteenth. */
static void a_fast_line_loses_little_at_the_start(arb *a)
{
    const double rate = 1.3 + arb_below(a, 300) / 100.0, part = log(rate / (rate - 1));

    start(arb_below(a, 2) ? LOFT_SPANS : LOFT_CURVES, CELLS, 30, 1,
          (uint16_t)(80 + arb_below(a, 120)), rate);
    uint32_t ticks = 0;
    for (; ticks < 20000 && drive.pace.level < loft_pace_full(&drive.pace); ticks++)
        live();
    const double lost = (double)ticks - l.passed, law = horizon() * (1 - (rate - 1) * part);
    CHECK(lost > law);
    CHECK(lost < law * 9 / 8 + horizon() / 16 / rate + 2 * l.ticks);
}

static void print_a_table(arb *a)
{
    (void)a;
    printf("     a line too slow, ramp 100 ticks, spans of 20 ticks; 20,000 ticks of time\n"
           "     rate portion   pace        turns stands goodput\n");
    for (int k = 0; k < 15; k++) {
        static const double rate[5] = { 0.1, 0.3, 0.5, 0.8, 0.95 };
        static const uint16_t portion[3] = { 1, 5, 25 };
        start(LOFT_SPANS, CELLS, 20, portion[k % 3], 100, rate[k / 3]);
        settle(8 * horizon() / l.rate);
        for (int tick = 0; tick < 20000; tick++)
            live();
        printf("     %4.2f %4u t  %5.3f..%5.3f %5u %5u   %5.3f\n", l.rate, l.portion * 20u,
               l.slowest, l.fastest, (unsigned)l.turns, (unsigned)l.stands,
               l.passed / (20000 * l.rate));
    }
}

int main(void)
{
    PROPERTY_LONG(print_a_table,                                       1);
    PROPERTY(a_line_of_any_rate_makes_an_even_pace,                   BY_NUM(15, 2, 2));
    PROPERTY(portions_of_any_size_make_no_oscillation_of_their_own,   BY_NUM(15, 2, 2));
    PROPERTY(a_cut_line_lets_the_machine_come_to_a_stand,             BY_NUM(20, 2, 2));
    PROPERTY(a_fast_line_loses_little_at_the_start,                   BY_NUM(40, 10, 10));
    return check_failures();
}
