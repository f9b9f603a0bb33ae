/* tests/lib/toolpath/test_patches.c -- properties of lib/toolpath/patches.h and of
 * lib/wire/patch_code.h: a patch on the line becomes the path of a ball on the machine
 * SPDX-License-Identifier: MIT
 */
#include <string.h>

#define CURVES  400
#define LONG    900000      /* ms until a test gives up */
#include "support/motion_chains.h"  /* chain, limits */
#include "support/motion_oracle.h"  /* path, path_distance */
#include "support/planned.h"        /* w, turn_on, go_on, finish */
#include "toolpath/patches.h"

#if LOFT_AXES >= 3

#define RING    64          /* curves of the plan */
#define KNOTS   176
#define COLUMNS 32
#define ITEMS   20

static loft_move    moves[RING];
static loft_knot    knots[KNOTS];
static uint16_t     passed[CELLS + LOFT_PLANNER_AHEAD];
static loft_tip     row[COLUMNS + 1], again[COLUMNS + 1];
static loft_planner planner;
static loft_patches patches;
static loft_lines   lines;
static path         track;

/* A job: `before` curves, and a patch after them. */
static struct {
    loft_item item[ITEMS];
    uint32_t count, before;
    int32_t  place[LOFT_AXES];  /* where the patch begins */
    loft_patch_head head;
    int32_t  net[16][LOFT_AXES];
} j;

static int32_t raw(double x)        { return (int32_t)floor(x * 65536 + 0.5); }

static loft_vec vec_of(const int32_t x[LOFT_AXES])
{
    loft_vec v;

    for (int i = 0; i < LOFT_AXES; i++)
        v.axis[i] = loft_real_from_raw(x[i]);
    return v;
}

/* A patch over about 8 mm that is `high` mm high. */
static void arb_patch(arb *a, double high)
{
    const unsigned m = 1 + arb_below(a, 3), n = 1 + arb_below(a, 3);

    j.head = (loft_patch_head){ .radius = raw(1.5),
                                .tol = raw(0.02),
                                .safe = raw(high + 2),
                                .rows = (uint16_t)(1 + arb_below(a, 3)),
                                .columns = COLUMNS,
                                .feed = (uint16_t)(1200 + arb_below(a, 3000)),
                                .rapid = 5000,
                                .m = (uint8_t)m,
                                .n = (uint8_t)n,
                                .one_way = arb_below(a, 2) > 0 };
    memset(j.net, 0, sizeof j.net);
    for (unsigned k = 0; k < (m + 1) * (n + 1); k++) {
        j.net[k][0] = raw(8.0 * (k / (n + 1)) / m + arb_between(a, -0.2, 0.2));
        j.net[k][1] = raw(8.0 * (k % (n + 1)) / n + arb_between(a, -0.2, 0.2));
        j.net[k][2] = raw(arb_between(a, 0, high));
    }
}

static loft_vec points[16];

/* The patch and its way, as the library takes them. */
static loft_tensor tensor_of(loft_lines_way *way)
{
    loft_tensor s;

    for (unsigned k = 0; k < 16; k++)
        points[k] = vec_of(j.net[k]);
    *way = loft_patches_way(&j.head);
    CHECK(loft_tensor_init(&s, points, j.head.m, j.head.n) == LOFT_OK);
    return s;
}

static void add_patch(void)
{
    const unsigned count = (j.head.m + 1u) * (j.head.n + 1u);

    loft_patch_item(&j.item[j.count++], &j.head, j.place);
    for (unsigned k = 0; k < count; k += 2)
        loft_patch_points(&j.item[j.count++], j.net[k], j.net[k + 1 < count ? k + 1 : k], j.place);
    CHECK(j.count == j.before + loft_patch_parts(&j.head));
}

/* A job of 0 to 3 curves and a patch, and the curves that the machine should make of it. */
static bool arb_job(arb *a)
{
    loft_lines_way way;
    bool near, cuts;

    usual_limits();
    begin_chain();
    j.count = 0;
    for (unsigned n = arb_below(a, 4); n > 0; n--)
        arb_curve(a, LINE, arb_between(a, 0.5, 4), 50, false);
    for (unsigned n = 0; n < curves; n++) {
        chain[n].feed = loft_acc_round(loft_acc_ratio(loft_to_acc(LOFT_REAL(1)) * 3000, 60));
        j.item[j.count].ticks = 3000;
        for (int k = 0; k < 3; k++)
            for (int i = 0; i < LOFT_AXES; i++)
                j.item[j.count].p[k][i] = loft_raw_from_real(chain[n].curve.p[k + 1].axis[i]);
        j.count++;
    }
    j.before = j.count;
    for (int i = 0; i < LOFT_AXES; i++)
        j.place[i] = j.count > 0 ? j.item[j.count - 1].p[2][i] : 0;
    arb_patch(a, 1.5);
    add_patch();
    const loft_tensor s  = tensor_of(&way);
    const loft_vec place = vec_of(j.place);
    for (way.columns = 1; way.columns < COLUMNS; way.columns++)
        if (loft_lines_check(&s, &way, &near) != LOFT_LINES_COARSE)
            break;
    j.head.columns = way.columns;
    j.count = j.before;
    add_patch();
    if (loft_lines_init(&lines, &s, &way, &place, again, COLUMNS + 1) != LOFT_OK)
        return false;
    for (; curves < CURVES && loft_lines_next(&lines, &chain[curves].curve, &cuts); curves++)
        chain[curves].feed = real_of((cuts ? j.head.feed : j.head.rapid) / 60.0);
    CHECK(curves < CURVES);
    path_trace(&track, chain, curves, 0.2);
    return true;
}

static void switch_on(arb *a, uint16_t columns)
{
    loft_patch_source *source = loft_patches_init(&patches, row, columns);
    const loft_planner_memory plan = { .moves = moves,
                                       .knots = knots,
                                       .passed = passed,
                                       .patches = columns > 0 ? source : NULL,
                                       .move_room = (uint16_t)(8 + arb_below(a, RING - 7)),
                                       .knot_room = KNOTS };

    w.limits = (loft_job_limits){ .corner = raw(0.005), .tol = raw(0.005) };
    for (int i = 0; i < LOFT_AXES; i++) {
        w.limits.axis[i].max_speed = 100 * 65536;
        w.limits.axis[i].max_accel = 1500 * 65536;
        w.limits.axis[i].max_jerk = arb_below(a, 2) ? 30000 : 0;
    }
    turn_on(a, &planner, &plan, j.item, j.count);
}

/* The place is on the path, not far behind or before the last one. */
static void follow(unsigned *chord)
{
    const double s = track.end[*chord].s;
    double at[LOFT_AXES];

    for (int i = 0; i < LOFT_AXES; i++)
        at[i] = w.at[i] / 80.0;
    CHECK_NEAR(path_distance(&track, chord, at, fmax(0, s - 1), s + 6), 0,
               0.005 + sqrt(LOFT_AXES) / 80);
}

static void check_cut(void)
{
    CHECK(w.sender.phase == LOFT_PHASE_DONE && w.sender.report.state == LOFT_STATE_DONE);
    CHECK(w.sender.report.items == j.count && w.sender.report.job == w.job.id);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK(w.at[i] == loft_steps_of(loft_real_from_raw(j.place[i]), LOFT_REAL(80)));
}

/* The tool follows the lines from the first to the last, and comes back. Damage, holds, overrides,
 * and senders that die change its time. */
static void a_patch_is_cut_whatever_happens(arb *a)
{
    unsigned chord = 0;
    uint32_t executed = 0;

    while (!arb_job(a)) {
    }
    switch_on(a, COLUMNS);
    w.bend = arb_below(a, 2) ? arb_below(a, 200) : 0;
    while (w.sender.phase < LOFT_PHASE_DONE && w.ms < LONG && !check_bad) {
        const bool streams = w.sender.phase == LOFT_PHASE_STREAMING;
        go_on();
        if (w.ms % 20 == 0)
            follow(&chord);
        CHECK(!streams || w.sender.phase != LOFT_PHASE_STREAMING ||
              w.sender.ack.executed >= executed);
        executed = w.sender.phase == LOFT_PHASE_STREAMING ? w.sender.ack.executed : 0;
        CHECK(executed <= j.before || executed == j.count);
        if (streams && arb_below(a, 700) == 0)
            loft_sender_control(&w.sender, LOFT_HOLD);
        if (w.machine.drive.state == LOFT_STATE_HELD && streams && arb_below(a, 100) == 0)
            loft_sender_control(&w.sender, LOFT_RESUME);
        if (streams && arb_below(a, 1000) == 0)
            loft_sender_override(&w.sender, 20 + arb_below(a, 100));
        if (streams && arb_below(a, 3000) == 0)
            dial();
    }
    CHECK(track.length - track.end[chord].s < 6);
    check_cut();
}

/* The machine and the host make the same curves of the same numbers. */
static void the_curves_are_those_of_the_lines(arb *a)
{
    loft_cubic c;
    uint16_t feed;
    unsigned n;

    if (!arb_job(a))
        return;
    const loft_vec place = vec_of(j.place);
    loft_patch_source *source = loft_patches_init(&patches, row, COLUMNS);
    for (uint32_t k = j.before; k < j.count; k++) {
        CHECK(source->state == (k > j.before ? LOFT_PATCH_GATHERED : LOFT_PATCH_NONE));
        CHECK(!source->next(source, &c, &feed));
        CHECK(source->take(source, &j.item[k], &place) == LOFT_REFUSAL_NONE);
    }
    for (n = j.before; source->next(source, &c, &feed) && n < curves; n++) {
        CHECK(feed == j.head.feed || feed == j.head.rapid);
        for (int k = 0; k < 4; k++)
            CHECK(loft_vec_equal(c.p[k], chain[n].curve.p[k]));
    }
    CHECK(n == curves && source->state == LOFT_PATCH_OVER);
    CHECK(source->take(source, &j.item[j.before], &place) == LOFT_REFUSAL_ITEM);
}

static void heads_come_back(arb *a)
{
    loft_patch_head got;
    loft_item item;

    arb_patch(a, 1);
    loft_patch_item(&item, &j.head, j.place);
    CHECK(loft_item_patch(&item, &got) == LOFT_OK);
    CHECK(got.radius == j.head.radius && got.tol == j.head.tol && got.safe == j.head.safe &&
          got.rows == j.head.rows && got.columns == j.head.columns && got.feed == j.head.feed &&
          got.rapid == j.head.rapid && got.m == j.head.m && got.n == j.head.n &&
          got.one_way == j.head.one_way);
    loft_item bad = item;
    bad.ticks = 1;
    CHECK(loft_item_patch(&bad, &got) == LOFT_ERR_DATA);
    bad = item;
    bad.p[0][1] &= ~0xFFFF;                             /* no feed */
    CHECK(loft_item_patch(&bad, &got) == LOFT_ERR_DATA);
    bad = item;
    bad.p[0][2] = (int32_t)(arb_below(a, 2) ? 0x204u + 0x10u * (1 + arb_below(a, 3))
                                            : 0x11u * arb_below(a, 2) * 4);   /* no degrees */
    CHECK(loft_item_patch(&bad, &got) == LOFT_ERR_DATA);
}

/* A patch is a few hundred bytes, whatever it is cut into. */
static void a_patch_is_few_bytes(arb *a)
{
    do
        while (!arb_job(a)) {
        }
    while (j.before > 0);
    switch_on(a, COLUMNS);
    while (w.sender.phase < LOFT_PHASE_STREAMING)
        go_on();
    const uint32_t began = w.sent;
    while (!(w.sender.ack.flags & LOFT_FLAG_ENDED) && w.ms < LONG && !check_bad)
        go_on();
    CHECK(w.sent - began < 400);
    CHECK(j.count <= LOFT_PATCH_PARTS);
}


// What is refused
// ---------------

/* The job ends on its path, for that reason. */
static void ends_for(enum loft_refusal why)
{
    finish();
    CHECK(w.sender.phase == LOFT_PHASE_ABORTED && w.sender.refusal == why);
    CHECK(w.sender.report.items <= j.before);
}

static void patches_that_cannot_be_cut_are_refused(arb *a)
{
    while (!arb_job(a)) {
    }
    const uint16_t columns = j.head.columns;
    switch_on(a, (uint16_t)(columns - (columns > 1)));      /* too few places */
    if (columns > 1)
        ends_for(LOFT_REFUSAL_PATCH);
    for (int k = 0; k < 4; k++) {
        const loft_patch_head head = j.head;
        switch (k) {
        case 0: j.head.safe = raw(-1);      break;          /* below the patch */
        case 1: j.head.tol = 1;             break;          /* no tolerance */
        case 2: j.head.radius = raw(100);   break;          /* too large a ball */
        default:
            memcpy(j.net[1], j.net[0], sizeof j.net[1]);
            memcpy(j.net[j.head.n + 1], j.net[0], sizeof j.net[1]);   /* no normal */
        }
        j.count = j.before;
        add_patch();
        j.head = head;
        switch_on(a, COLUMNS);
        ends_for(LOFT_REFUSAL_PATCH);
    }
}

static void a_machine_without_memory_takes_no_patch(arb *a)
{
    while (!arb_job(a)) {
    }
    switch_on(a, 0);
    while (w.sender.phase < LOFT_PHASE_READY)
        go_on();
    CHECK(w.sender.machine.columns == 0);
    ends_for(LOFT_REFUSAL_KIND);
    switch_on(a, COLUMNS);
    while (w.sender.phase < LOFT_PHASE_READY)
        go_on();
    CHECK(w.sender.machine.columns == COLUMNS);
}

/* A patch is the last of its job, and whole. */
static void other_orders_are_refused(arb *a)
{
    while (!arb_job(a)) {
    }
    const uint32_t whole = j.count;

    j.item[j.count] = (loft_item){ .ticks = 600 };          /* a curve after it */
    for (int k = 0; k < 3; k++)
        memcpy(j.item[j.count].p[k], j.place, sizeof j.place);
    j.item[j.count++].p[2][0] += 65536;
    switch_on(a, COLUMNS);
    ends_for(LOFT_REFUSAL_ITEM);
    j.count = whole - 1;                                    /* the last part is missing */
    switch_on(a, COLUMNS);
    ends_for(LOFT_REFUSAL_ITEM);
    j.count = whole;
    memmove(&j.item[j.before], &j.item[j.before + 1], sizeof j.item[0]);    /* no head */
    switch_on(a, COLUMNS);
    ends_for(LOFT_REFUSAL_ITEM);
}

/* An abort ends on the path. The same job begins again with its first line. */
static void an_aborted_patch_begins_again(arb *a)
{
    unsigned chord = 0;

    do
        while (!arb_job(a)) {
        }
    while (j.before > 0);
    switch_on(a, COLUMNS);
    for (uint32_t ms = 300 + arb_below(a, 3000); ms > 0 && w.sender.phase <= LOFT_PHASE_STREAMING;
         ms--) {
        go_on();
        if (w.ms % 20 == 0)
            follow(&chord);
    }
    if (w.sender.phase > LOFT_PHASE_STREAMING)
        return;
    loft_sender_control(&w.sender, LOFT_ABORT);
    finish();
    if (w.sender.phase == LOFT_PHASE_DONE)                  /* it came too late */
        return;
    CHECK(w.sender.phase == LOFT_PHASE_ABORTED && w.sender.report.items == 0);
    follow(&chord);
    switch_on(a, COLUMNS);                                  /* and placed at its start */
    finish();
    check_cut();
}

int main(void)
{
    PROPERTY(heads_come_back, 100);
    PROPERTY(the_curves_are_those_of_the_lines, 40);
    PROPERTY(a_patch_is_few_bytes, 2);
    PROPERTY(patches_that_cannot_be_cut_are_refused, 2);
    PROPERTY(a_machine_without_memory_takes_no_patch, 1);
    PROPERTY(other_orders_are_refused, 2);
    PROPERTY(an_aborted_patch_begins_again, 2);
    PROPERTY_LONG(a_patch_is_cut_whatever_happens, 3);
    return check_failures();
}

#else

int main(void) { return 0; }

#endif
