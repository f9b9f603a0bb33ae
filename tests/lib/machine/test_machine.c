/* tests/lib/machine/test_machine.c -- properties of lib/machine/machine.h: whole jobs from a sender
 * to the pulses, over a bad line
 * SPDX-License-Identifier: MIT
 */
#include <string.h>

#include "support/rig.h"

#include "machine/machine.h"
#include "wire/sender.h"

#define PIPE 256            /* bytes in flight                          */
#define RATE 12             /* bytes per ms: 115200 baud                */
#define LONG 600000         /* ms until a test gives up                 */

/* One direction of the line. Of 65536 bytes: how many are changed, lost, doubled. */
typedef struct {
    uint8_t byte[PIPE];
    uint32_t in, out;
    uint32_t bend, lose, twice;
} pipe;

static struct {
    loft_machine machine;
    loft_machine_config config;
    loft_sender sender;
    loft_job job;
    pipe down, up;
    uint32_t ms, faults;
    bool cut;               /* the sender's end is not connected        */
    arb arb;
} w;

static uint32_t pipe_room(const pipe *p)            { return PIPE - (p->in - p->out); }
static void pipe_add(pipe *p, uint8_t byte)
{
    if (pipe_room(p))
        p->byte[p->in++ % PIPE] = byte;
}

static void pipe_send(pipe *p, const uint8_t *byte, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const uint32_t luck = arb_below(&w.arb, 65536);
        if (luck < p->bend)
            pipe_add(p, (uint8_t)(byte[i] ^ (1u << arb_below(&w.arb, 8))));
        else if (luck >= p->bend + p->lose)
            pipe_add(p, byte[i]);
        if (luck >= 65536 - p->twice)
            pipe_add(p, byte[i]);
    }
}

static void items_of(void *context, uint32_t index, loft_item *out)
{
    (void)context;
    *out = r.item[index];
}

static void greet(void)
{
    loft_sender_init(&w.sender, 1000 + w.ms, w.ms);
    w.cut = false;
}

static void world_start(arb *a, int32_t reach)
{
    const uint16_t slots = (uint16_t)(1 + arb_below(a, 40));
    const loft_drive_config c = rig_init(a, &w.machine.drive, slots,
                                         (uint16_t)(1 + arb_below(a, 60)), reach);

    w.machine.receiver.session = 0;
    w.config = (loft_machine_config){
        .info = { .boot = 77, .tick_hz = 1000, .slots = slots, .outputs = LOFT_MACHINE_OUTPUTS },
        .ramp = r.ramp,
        .cell = cells,
        .cells = r.cells,
        .senses = true
    };
    for (int i = 0; i < LOFT_AXES; i++) {
        w.config.info.axis[i].steps_per_mm = per_mm[i];
        w.config.position[i] = c.position[i];
    }
    CHECK(loft_machine_init(&w.machine, &w.config) == LOFT_OK);
    w.down = w.up = (pipe){ .in = 0 };
    w.ms = 0;
    w.arb = *a;
    w.job = (loft_job){ .id = 4711, .kind = (uint8_t)r.kind };
    for (int i = 0; i < LOFT_AXES; i++)
        w.job.start[i] = r.start[i];
    greet();
}

static void make_noise(arb *a)
{
    const uint32_t much = 1u << arb_below(a, 9);        /* up to 1 byte in 256 */
    w.down.bend  = arb_below(a, much);
    w.down.lose  = arb_below(a, much);
    w.down.twice = arb_below(a, much);
    w.up.bend    = arb_below(a, much);
    w.up.lose    = arb_below(a, much);
    w.up.twice   = arb_below(a, much);
}

/* The sender's end for one ms. */
static void sender_talks(void)
{
    uint8_t wire[LOFT_FRAME_MAX];
    size_t count;

    for (int i = 0; i < RATE && w.up.in != w.up.out; i++) {
        const uint8_t byte = w.up.byte[w.up.out++ % PIPE];
        if (!w.cut)
            loft_sender_push(&w.sender, byte, w.ms);
    }
    if (w.cut)
        return;
    if (pipe_room(&w.down) >= 2 * LOFT_FRAME_MAX - 1 &&
        (count = loft_sender_poll(&w.sender, w.ms, wire)) != 0)
        pipe_send(&w.down, wire, count);
}

static void sender_runs(void)
{
    if (!w.cut && w.sender.phase == LOFT_PHASE_READY)
        CHECK(loft_sender_begin(&w.sender, &w.job, r.items, items_of, NULL) == LOFT_OK);
    sender_talks();
}

/* The machine for one ms = one tick: bytes and answers, then slots. */
static void machine_gets(void)
{
    uint8_t wire[LOFT_FRAME_MAX];
    size_t count;

    for (int i = 0; i < RATE && w.down.in != w.down.out; i++)
        loft_machine_push(&w.machine, &w.down.byte[w.down.out++ % PIPE], 1);
    if (pipe_room(&w.up) >= 2 * LOFT_FRAME_MAX - 1 &&
        (count = loft_machine_poll(&w.machine, wire)) != 0)
        pipe_send(&w.up, wire, count);
}

static void machine_runs(void)
{
    machine_gets();
    for (uint16_t slot = 0; slot < r.slots; slot++) {
        loft_machine_tick(&w.machine);
        rig_slot();
    }
    loft_machine_tick(&w.machine);
}

static bool world_runs(void)
{
    sender_runs();
    machine_runs();
    return ++w.ms < LONG && (w.cut || w.sender.phase < LOFT_PHASE_DONE);
}

static void check_drawn(void)
{
    CHECK(w.sender.phase == LOFT_PHASE_DONE);
    CHECK(w.sender.report.state == LOFT_STATE_DONE && w.sender.report.job == w.job.id);
    CHECK(w.sender.report.items == r.items && w.sender.report.ticks == r.ticks);
    CHECK(r.passed == r.ticks && here(r.path[r.ticks]));
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK(w.sender.report.position[i] == r.path[r.ticks][i]);
}

static void a_job_is_drawn_exactly_once_over_a_bad_line(arb *a)
{
    world_start(a, 20);
    make_noise(a);
    while (world_runs()) {
    }
    check_drawn();
    while (w.machine.drive.state != LOFT_STATE_IDLE && w.ms < LONG)
        world_runs();
    CHECK(w.machine.drive.state == LOFT_STATE_IDLE);
}

/* The sender dies repeatedly, and another one begins the same job. The job continues at the
 * machine's position. */
static void a_sender_that_dies_is_replaced_without_a_step_lost_or_doubled(arb *a)
{
    uint32_t deaths = 0;

    world_start(a, 20);
    if (arb_below(a, 2))
        make_noise(a);
    while (world_runs()) {
        /* a closing sender has its report: another one would begin the job again */
        if (!w.cut && w.sender.phase < LOFT_PHASE_CLOSING && deaths < 5 && arb_below(a, 150) == 0) {
            deaths++;
            w.cut = true;
        } else if (w.cut && arb_below(a, 400) == 0) {
            greet();
        }
    }
    check_drawn();
}


// Settings
// --------

#define ROOM 256u

static uint8_t kept[2 * ROOM];
static uint32_t power;                  /* bytes that can be written until it fails */

static uint8_t kept_get(uint16_t at) { return kept[at]; }
static void kept_put(uint16_t at, uint8_t byte)
{
    if (power > 0 && power-- > 0)
        kept[at] = byte;
}

/* A machine whose memory holds settings; it starts anew. */
static void machine_starts(void)
{
    w.machine.receiver.session = 0;
    w.config.settings.get      = kept_get;
    w.config.settings.put      = kept_put;
    w.config.settings.room     = ROOM;
    w.config.info.boot++;
    for (int i = 0; i < LOFT_AXES; i++)
        w.config.info.axis[i].steps_per_mm = per_mm[i];
    CHECK(loft_machine_init(&w.machine, &w.config) == LOFT_OK);
}

/* One ms without a job. */
static bool line_runs(void)
{
    sender_talks();
    machine_gets();
    return ++w.ms < LONG;
}

/* Ask or write, and wait for the answer. */
static bool settings_asked(uint16_t at, const uint8_t byte[], uint8_t count)
{
    while (w.sender.phase != LOFT_PHASE_READY)
        if (!line_runs())
            return false;
    CHECK(loft_sender_set(&w.sender, at, byte, count) == LOFT_OK);
    while (w.sender.asking)
        if (!line_runs())
            return false;
    return w.sender.kept.at == at;
}

/* Settings whose gearing is `steps`, numbered `number`. */
static uint16_t settings_block(uint8_t block[ROOM], uint8_t number, int32_t steps)
{
    uint32_t crc = 0xFFFFFFFFu;

    memset(block, 0x5A, ROOM);
    block[4] = number;
    block[5] = LOFT_SETTINGS_LAYOUT;
    block[6] = LOFT_SETTINGS_TEXT + 20;
    block[7] = 0;
    for (unsigned i = 0; i < LOFT_AXES; i++)
        for (unsigned k = 0; k < 4; k++)
            block[LOFT_SETTINGS_AXES + 16 * i + k] = (uint8_t)((uint32_t)steps >> 8 * k & 0xFF);
    for (uint16_t at = 4; at < block[6]; at++)
        crc = loft_crc(crc, block[at]);
    for (int i = 0; i < 4; i++)
        block[i] = (uint8_t)(~crc >> 8 * i & 0xFF);
    return block[6];
}

/* A sender that may die anywhere writes new settings; then the power may fail. The machine has the
 * old or the new ones, and tells them to the next sender. */
static void settings_are_written_whole_or_not_at_all(arb *a)
{
    uint8_t block[ROOM];
    int32_t now = per_mm[0];

    world_start(a, 20);
    memset(kept, 0xFF, sizeof kept);
    power = LONG;
    machine_starts();
    make_noise(a);
    for (uint8_t number = 1; number < 6; number++) {
        const int32_t steps = (number + 3) * 65536;
        const uint16_t size = settings_block(block, number, steps);
        const uint32_t dies = arb_below(a, 3) ? LONG : arb_below(a, 10);
        power               = arb_below(a, 3) ? LONG : arb_below(a, size);
        const bool fails    = power < LONG;
        bool written        = false;
        uint32_t frames     = 0;
        greet();
        for (uint16_t at = 4; at < size && frames < dies; at = (uint16_t)(at + 32), frames++)
            CHECK(settings_asked(at, block + at, (uint8_t)(size - at < 32 ? size - at : 32)));
        if (frames < dies) {
            CHECK(settings_asked(0, block, 4));
            written = memcmp(w.sender.kept.byte, block, 4) == 0;
            CHECK(written || fails);
        }
        if (arb_below(a, 2))
            machine_starts();
        power = LONG;
        greet();
        CHECK(settings_asked(LOFT_SETTINGS_AXES, NULL, 0));
        const uint8_t *told = w.sender.kept.byte;
        if (written)
            now = steps;
        CHECK((told[0] | told[1] << 8 | (int32_t)told[2] << 16 | (int32_t)told[3] << 24) == now);
        CHECK(w.sender.axis[0].steps_per_mm == now);
        CHECK(loft_drive_gear(&w.machine.drive, 0) == loft_real_from_raw(now));
    }
}

/* A job that was planned before the settings changed does not begin, and none are written while one
 * is under way. */
static void a_job_and_new_settings_exclude_each_other(arb *a)
{
    uint8_t block[ROOM];
    const uint16_t size = settings_block(block, 1, 7 * 65536);

    world_start(a, 20);
    memset(kept, 0xFF, sizeof kept);
    power = LONG;
    machine_starts();
    greet();
    for (uint16_t at = 4; at < size; at = (uint16_t)(at + 32))
        CHECK(settings_asked(at, block + at, (uint8_t)(size - at < 32 ? size - at : 32)));
    if (arb_below(a, 2)) {
        CHECK(settings_asked(0, block, 4) && w.sender.kept.origin == LOFT_SETTINGS_KEPT);
        while (world_runs()) {
        }
        CHECK(w.sender.phase == LOFT_PHASE_REFUSED && w.sender.refusal == LOFT_REFUSAL_LIMITS);
        return;
    }
    while (w.sender.phase < LOFT_PHASE_STREAMING && world_runs()) {
    }
    if (!w.machine.drive.active)
        return;
    uint8_t wire[LOFT_FRAME_MAX];
    const loft_set set = { .at = 0, .count = 4, .byte = block };
    const size_t n     = loft_set_encode(&set, w.machine.receiver.session, wire);
    loft_machine_push(&w.machine, (const uint8_t[]){ 0 }, 1);   /* ends the frame that is coming */
    loft_machine_push(&w.machine, wire, n);
    CHECK(w.machine.set.wrote > LOFT_KEPT_MOST && w.config.settings.which == 2);
    while (world_runs()) {
    }
    check_drawn();
}

static void a_job_may_be_held_and_resumed_from_the_host(arb *a)
{
    world_start(a, 20);
    if (arb_below(a, 2))
        make_noise(a);
    uint32_t calm = 2000;
    while (world_runs())
        if (arb_below(a, 300) == 0 && calm) {
            calm--;
            loft_sender_control(&w.sender, arb_below(a, 2) ? LOFT_HOLD : LOFT_RESUME);
        } else if (w.sender.status.ack.state == LOFT_STATE_HELD && arb_below(a, 100) == 0) {
            loft_sender_control(&w.sender, LOFT_RESUME);
        }
    check_drawn();
}

static void a_hold_from_the_host_stands_until_it_is_lifted(arb *a)
{
    do
        world_start(a, 20);
    while (r.ticks < 500);

    for (uint32_t ms = 0; ms < 250; ms++)
        world_runs();
    loft_sender_control(&w.sender, LOFT_HOLD);
    while (w.machine.drive.state != LOFT_STATE_HELD && world_runs()) {
    }
    const uint32_t passed = r.passed;
    for (uint32_t ms = 0; ms < 500; ms++)
        world_runs();
    CHECK(w.machine.drive.state == LOFT_STATE_HELD && r.passed == passed && here(r.path[passed]) &&
          passed < r.ticks);
    CHECK(w.sender.status.ack.state == LOFT_STATE_HELD);
    loft_sender_control(&w.sender, LOFT_RESUME);
    while (world_runs()) {
    }
    check_drawn();
}

/* The machine is stopped and the last job is over. Begin another job of one item here, which moves
 * away from the inputs `away`. */
static void another_job(uint16_t away)
{
    w.job.id++;
    w.job.kind = LOFT_POINTS;
    w.job.away = away;
    r.items = r.ticks = r.passed = 0;
    for (int i = 0; i < LOFT_AXES; i++)
        w.job.start[i] = r.path[0][i] = r.at[i];
    greet();
}

static void an_aborted_job_reports_where_it_stands_and_another_begins_there(arb *a)
{
    const uint32_t when = 20 + arb_below(a, 1500);

    world_start(a, 20);
    if (arb_below(a, 2))
        make_noise(a);
    while (world_runs())
        if (w.ms == when)
            loft_sender_control(&w.sender, LOFT_ABORT);
    if (w.sender.phase == LOFT_PHASE_DONE) {
        check_drawn();                                  /* the job was faster */
        return;
    }
    CHECK(w.sender.phase == LOFT_PHASE_ABORTED);
    CHECK(here(r.path[r.passed]));
    if (w.sender.report.job) {
        CHECK(w.sender.report.state == LOFT_STATE_ABORTED && w.sender.report.ticks == r.passed);
        for (int i = 0; i < LOFT_AXES; i++)
            CHECK(w.sender.report.position[i] == r.path[r.passed][i]);
    }
    another_job(0);
    while (world_runs()) {
    }
    check_drawn();
}

/* A hold ends with its job, also if the machine was held when the job was aborted, or if the hold
 * came without a job. */
static void a_job_begins_free_of_the_holds_before_it(arb *a)
{
    world_start(a, 20);
    const bool held = arb_below(a, 2);
    while (w.sender.phase < LOFT_PHASE_STREAMING && world_runs()) {
    }
    loft_sender_control(&w.sender, LOFT_HOLD);
    while (held && w.machine.drive.state != LOFT_STATE_HELD && world_runs()) {
    }
    for (uint32_t ms = arb_below(a, 100); ms > 0; ms--)
        world_runs();
    loft_sender_control(&w.sender, LOFT_ABORT);
    while (world_runs()) {
    }
    CHECK(!loft_state_busy(w.machine.drive.state));
    if (arb_below(a, 2))
        loft_machine_control(&w.machine, LOFT_HOLD);

    another_job(0);
    while (world_runs())
        CHECK(w.machine.drive.state != LOFT_STATE_HELD &&
              w.machine.drive.state != LOFT_STATE_HOLDING);
    check_drawn();
}

/* A machine without a job is told where it stands, or where its table ends. */
static void machine_is_told(enum loft_verb verb, uint8_t bits, const int32_t position[LOFT_AXES])
{
    while (w.sender.phase != LOFT_PHASE_READY && line_runs()) {
    }
    CHECK((verb == LOFT_PLACE
               ? loft_sender_place(&w.sender, bits, position)
               : loft_sender_table(&w.sender, verb == LOFT_TABLE_HIGH, bits, position)) == LOFT_OK);
    while (w.sender.verb && line_runs()) {
    }
    CHECK(w.sender.ack.refusal == LOFT_REFUSAL_NONE);
}

static uint16_t arb_ending(arb *a)
{
    const int axis = (int)arb_below(a, LOFT_AXES);

    switch (arb_below(a, 4)) {
    case 0:  return LOFT_INPUT_LOW(axis);
    case 1:  return LOFT_INPUT_HIGH(axis);
    case 2:  return LOFT_INPUT_ENDS(axis);
    default: return LOFT_INPUT_STOP;
    }
}

/* A limit that closes ends the job on its path, the emergency stop at once, and the report names
 * it. While closed, it lets no job begin except one that moves away. Of an emergency stop the
 * machine says that its position is in doubt, until it is told where it stands. */
static void a_closed_limit_ends_jobs_and_lets_none_begin(arb *a)
{
    const uint16_t closed = arb_ending(a);
    const uint32_t when = arb_below(a, 400);

    do
        world_start(a, 20);
    while (r.ticks < 500);
    if (arb_below(a, 2))
        make_noise(a);
    for (bool running = true; running;) {
        running = world_runs();
        loft_machine_inputs(&w.machine, w.ms > when ? closed : 0);
    }
    if (when > 0 && w.sender.report.job)
        CHECK(w.sender.phase == LOFT_PHASE_ABORTED && w.sender.refusal == LOFT_REFUSAL_INPUT &&
              w.sender.report.ended_by == closed);
    else
        CHECK(w.sender.phase == LOFT_PHASE_REFUSED && w.sender.refusal == LOFT_REFUSAL_INPUT &&
              w.sender.closed == closed);
    const bool stop = w.sender.report.ended_by == LOFT_INPUT_STOP;
    CHECK(here(stop ? r.at : r.path[r.passed]) && r.passed < r.ticks);
    CHECK(w.machine.lost == (stop ? (1u << LOFT_AXES) - 1 : 0));       /* each axis, or none */

    for (int turn = 0; turn < 2; turn++) {              /* refused each time, in its own session */
        another_job(turn ? (uint16_t)(LOFT_INPUT_ENDING & ~closed) : 0);
        while (world_runs()) {
        }
        CHECK(w.sender.phase == LOFT_PHASE_REFUSED && w.sender.refusal == LOFT_REFUSAL_INPUT &&
              w.sender.closed == closed);
        CHECK(here(r.path[0]) && !w.machine.drive.active);
        CHECK(!(w.sender.ack.flags & LOFT_FLAG_LOST) == !stop);
    }
    another_job(closed);
    while (world_runs()) {
    }
    check_drawn();
    CHECK(w.sender.report.ended_by == 0);
    if (!stop)
        return;
    greet();
    for (int i = 0; i < LOFT_AXES; i++) {
        CHECK(w.machine.lost);
        machine_is_told(LOFT_PLACE, (uint8_t)(1u << i), r.at);
        CHECK(!(w.sender.ack.flags & LOFT_FLAG_LOST) == (i == LOFT_AXES - 1));
    }
}

/* A machine with a table refuses the first item that ends beyond it, from inside or from farther
 * in, and stops on the path. The table keeps its place when the machine is told another one. The
 * first end of another table lifts it. */
static void what_leaves_the_table_is_refused(arb *a)
{
    const bool lifted = arb_below(a, 4) == 0;
    const int axis    = (int)arb_below(a, LOFT_AXES);
    int32_t low[LOFT_AXES] = { 0 }, high[LOFT_AXES] = { 0 }, before, to;
    uint32_t bad = 0;

    world_start(a, 20);
    low[axis]  = r.at[axis] - (int32_t)arb_below(a, 2000);
    high[axis] = r.at[axis] + (int32_t)arb_below(a, 2000);
    machine_is_told(LOFT_TABLE_LOW, (uint8_t)(1u << axis), low);
    machine_is_told(LOFT_TABLE_HIGH, (uint8_t)(1u << axis), high);
    if (arb_below(a, 2)) {                              /* elsewhere and back */
        int32_t there[LOFT_AXES];
        for (int i = 0; i < LOFT_AXES; i++)
            there[i] = r.at[i] + arb_raw(a, 100000);
        machine_is_told(LOFT_PLACE, (1u << LOFT_AXES) - 1, there);
        machine_is_told(LOFT_PLACE, (1u << LOFT_AXES) - 1, r.at);
    }
    for (before = r.at[axis]; bad < r.items; bad++, before = to) {
        to = r.item[bad].p[2][axis];
        to = r.kind == LOFT_SPANS ? loft_steps_of(loft_real_from_raw(to), scale_of(axis)) : to;
        if ((to < low[axis] && to < before) || (to > high[axis] && to > before))
            break;
    }
    if (lifted)
        machine_is_told(LOFT_TABLE_LOW, (uint8_t)(1u << axis), low);
    greet();
    while (world_runs()) {
    }
    if (lifted || bad == r.items) {
        check_drawn();
        return;
    }
    CHECK((w.sender.phase == LOFT_PHASE_ABORTED || w.sender.phase == LOFT_PHASE_REFUSED) &&
          w.sender.refusal == LOFT_REFUSAL_TABLE);
    CHECK(here(r.path[r.passed]) && (r.passed == 0 || r.item_of[r.passed - 1] < bad));
}

/* An input that a job moves away from may stay closed, but ends the job when it opens and closes
 * again. Other inputs end it at once. */
static void a_limit_that_was_left_ends_the_job_when_it_closes_again(arb *a)
{
    const uint16_t first = LOFT_INPUT_LOW(0), other = LOFT_INPUT_STOP;
    const bool again = arb_below(a, 2);

    do
        world_start(a, 20);
    while (r.ticks < 1500);
    w.job.away = first;
    loft_machine_inputs(&w.machine, first);
    while (world_runs()) {
        const uint16_t left = w.ms < 400 ? first : w.ms < 600 || !again ? 0 : first;
        loft_machine_inputs(&w.machine, w.ms < 700 || again ? left : other);
        CHECK(w.ms >= 600 || w.machine.drive.abort == 0);
    }
    CHECK(w.sender.phase == LOFT_PHASE_ABORTED &&
          w.sender.report.ended_by == (again ? first : other));
}

/* A guard ends the job on its path. It latches the place of the first slot in which its input has
 * changed, though the contact bounces for 5 ms, and a shorter disturbance before is forgotten. The
 * machine is then told where it stands, and the next job begins there. */
static void a_guard_ends_the_job_and_tells_the_place_of_the_edge(arb *a)
{
    const bool opens = arb_below(a, 2), hard = arb_below(a, 2);
    const uint16_t input = arb_below(a, 3) ? arb_ending(a) : 0x8000u;
    const uint32_t when = 100 + arb_below(a, 300), early = 20 + arb_below(a, when - 60);
    int32_t place[LOFT_AXES], edge[LOFT_AXES] = { 0 };
    uint32_t begun = 0, ended = 0;
    bool noted = false;

    do
        world_start(a, 20);
    while (r.ticks < 1000);
    if (arb_below(a, 2))
        make_noise(a);
    w.job.guard = (loft_guard){ .inputs = input,
                                .how = (uint8_t)((opens ? LOFT_GUARD_OPENS : 0) |
                                                 (hard ? LOFT_GUARD_HARD : 0) |
                                                 (arb_below(a, 2) ? LOFT_GUARD_EDGE : 0)),
                                .filter = 8 };
    if (opens)
        loft_machine_inputs(&w.machine, input);         /* it lets the job begin */
    do {
        sender_runs();
        machine_gets();
        if (begun == 0 && w.machine.drive.active)
            begun = w.ms + 1;
        const uint32_t t = begun ? w.ms + 1 - begun : 0;
        const uint16_t first = (uint16_t)arb_below(a, r.slots);
        for (uint16_t slot = 0; slot < r.slots; slot++) {
            const bool edge_now = t == when && slot == first;
            const bool bounces = (t >= when && t < when + 5) || t == early;
            const bool on = t == when && slot < first
                                ? false
                                : edge_now || t >= when + 5 || (bounces && arb_below(a, 2));
            const uint16_t closed = on != opens ? input : 0;
            loft_machine_tick(&w.machine);
            rig_slot();
            if (edge_now) {
                noted = true;
                for (int i = 0; i < LOFT_AXES; i++)
                    edge[i] = r.at[i];
            }
            if (loft_machine_senses(&w.machine))
                loft_machine_sense(&w.machine, closed);
            if (slot == 0)
                loft_machine_sample(&w.machine, closed);
        }
        loft_machine_tick(&w.machine);
        CHECK(w.machine.drive.abort == 0 || t >= when + 8);
        ended = ended || w.machine.drive.abort == 0 ? ended : r.passed;
    } while (++w.ms < LONG && w.sender.phase < LOFT_PHASE_DONE);

    CHECK(noted && w.sender.phase == LOFT_PHASE_ABORTED && w.sender.report.guarded);
    CHECK(!hard || r.passed <= ended);
    CHECK(w.sender.report.ended_by == input && r.passed < r.ticks);
    CHECK(here(hard ? r.at : r.path[r.passed]));
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK(w.sender.report.latched[i] == edge[i] && w.sender.report.position[i] == r.at[i]);

    while (w.machine.drive.state != LOFT_STATE_IDLE && w.ms < LONG)
        world_runs();
    greet();
    while (w.sender.phase != LOFT_PHASE_READY && w.ms < LONG) {
        sender_talks();
        machine_runs();
        w.ms++;
    }
    for (int i = 0; i < LOFT_AXES; i++)
        place[i] = arb_raw(a, 100000);
    CHECK(loft_sender_place(&w.sender, 1u << LOFT_AXES, place) == LOFT_ERR_ARG);
    CHECK(loft_sender_place(&w.sender, (1u << LOFT_AXES) - 1, place) == LOFT_OK);
    for (int i = 0; i < LOFT_AXES; i++)
        r.at[i] = place[i];
    while (w.sender.verb && w.ms < LONG) {
        sender_talks();
        machine_runs();
        w.ms++;
    }
    int32_t at[LOFT_AXES];
    loft_step_position(&w.machine.drive.step, at);
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK(w.sender.axis[i].position == place[i] && at[i] == place[i]);
    w.job.guard.inputs = 0;
    loft_machine_inputs(&w.machine, 0);
    another_job(0);
    while (world_runs()) {
    }
    check_drawn();
    CHECK(!w.sender.report.guarded);
}

/* An axis with two motors, whose switches close after different ways and bounce: each motor stops
 * at the first touch of its own, and the guard comes true with the last one, in whose slot the
 * place is latched. A machine without such an axis refuses the job. */
static void two_motors_stop_at_their_own_switches(arb *a)
{
    const int axis     = (int)arb_below(a, LOFT_AXES);
    const uint16_t own[2] = { LOFT_INPUT_LOW(axis), LOFT_INPUT_HIGH(axis) };
    const bool can     = arb_below(a, 4) != 0;
    uint32_t when[2], slot = 0;
    int32_t edge[LOFT_AXES] = { 0 };
    uint16_t touched = 0;

    do
        world_start(a, 20);
    while (r.ticks < 1000);
    for (int i = 0; i < 2; i++)
        when[i] = (50 + arb_below(a, 200)) * r.slots + arb_below(a, r.slots);
    w.config.squares = (uint16_t)(can ? LOFT_INPUT_ENDS(axis) : 0);
    w.job.guard = (loft_guard){ LOFT_INPUT_ENDS(axis), LOFT_GUARD_SQUARE | LOFT_GUARD_HARD, 8 };
    do {
        sender_runs();
        machine_gets();
        for (uint16_t k = 0; k < r.slots; k++) {
            uint16_t closed = 0;
            loft_machine_tick(&w.machine);
            rig_slot();
            slot += w.machine.drive.active;
            for (int i = 0; i < 2; i++)
                if (slot == when[i] ||
                    (slot > when[i] && (slot > when[i] + 5u * r.slots || arb_below(a, 2))))
                    closed |= own[i];
            if (closed & ~touched && w.machine.drive.active)
                memcpy(edge, r.at, sizeof edge);
            touched |= w.machine.drive.active ? closed : 0;
            if (loft_machine_senses(&w.machine))
                loft_machine_sense(&w.machine, closed);
            CHECK(!w.machine.drive.active || loft_machine_gated(&w.machine) == touched);
            if (k == 0)
                loft_machine_sample(&w.machine, closed);
        }
        loft_machine_tick(&w.machine);
    } while (++w.ms < LONG && w.sender.phase < LOFT_PHASE_DONE);
    if (!can) {
        CHECK(w.sender.phase == LOFT_PHASE_REFUSED && w.sender.refusal == LOFT_REFUSAL_KIND);
        return;
    }
    CHECK(w.sender.phase == LOFT_PHASE_ABORTED &&
          w.sender.report.ended_by == LOFT_INPUT_ENDS(axis));
    for (int i = 0; i < LOFT_AXES; i++)
        CHECK(w.sender.report.latched[i] == edge[i]);
    CHECK(w.machine.lost == 1u << axis && loft_machine_gated(&w.machine) == 0);
}

/* Buttons act when they close. */
static void a_button_that_stays_closed_counts_once(arb *a)
{
    do
        world_start(a, 20);
    while (r.ticks < 500);
    while (world_runs())
        loft_machine_inputs(&w.machine, w.ms > 300 && w.ms < 500 ? LOFT_INPUT_HOLD
                                        : w.ms > 900             ? LOFT_INPUT_RESUME
                                                                 : 0);
    check_drawn();
    CHECK(w.sender.report.elapsed > r.ticks + 200);
}

static void a_job_that_starts_elsewhere_is_refused(arb *a)
{
    world_start(a, 20);
    w.job.start[arb_below(a, LOFT_AXES)] += 65536;
    while (world_runs()) {
    }
    CHECK(w.sender.phase == LOFT_PHASE_REFUSED && w.sender.ack.refusal == LOFT_REFUSAL_START);
    CHECK(here(r.path[0]));
}

/* An item beyond the machine's ability ends the job on the path, and the host learns why. */
static void an_item_that_is_too_fast_ends_the_job_on_the_path(arb *a)
{
    world_start(a, 20);
    const uint32_t bad = arb_below(a, r.items);
    const int axis = (int)arb_below(a, LOFT_AXES);
    r.item[bad].p[2][axis] = r.item[bad].p[2][axis] < 0 ? INT32_MAX : INT32_MIN;
    r.item[bad].ticks = 1;
    if (r.kind == LOFT_SPANS)
        for (r.ticks = 0; r.item_of[r.ticks] < bad; r.ticks++) {
        }
    while (world_runs()) {
    }
    CHECK(w.sender.phase == LOFT_PHASE_REFUSED || w.sender.phase == LOFT_PHASE_ABORTED);
    CHECK(w.sender.ack.refusal == LOFT_REFUSAL_ITEM);
    for (int ms = 0; ms < 5000; ms++)
        machine_runs();
    CHECK(!loft_state_busy(w.machine.drive.state));
    CHECK(here(r.path[r.passed]) && r.passed <= r.ticks);
}

/* Any bytes: the machine does not move. */
static void nonsense_on_the_line_moves_nothing(arb *a)
{
    uint8_t byte[64], wire[LOFT_FRAME_MAX];

    world_start(a, 20);
    for (int turn = 0; turn < 200; turn++) {
        for (size_t i = 0; i < sizeof byte; i++)
            byte[i] = (uint8_t)(arb_below(a, 4) ? arb_next(a) >> 50 : 0);
        loft_machine_push(&w.machine, byte, sizeof byte);
        CHECK(loft_machine_poll(&w.machine, wire) == 0);
        loft_machine_tick(&w.machine);
        CHECK(loft_machine_slot(&w.machine).step == 0);
    }
    CHECK(w.machine.drive.state == LOFT_STATE_IDLE && here(r.path[0]));
}

int main(void)
{
    PROPERTY(a_job_is_drawn_exactly_once_over_a_bad_line,                        30);
    PROPERTY(a_sender_that_dies_is_replaced_without_a_step_lost_or_doubled,      30);
    PROPERTY(settings_are_written_whole_or_not_at_all,                           60);
    PROPERTY(a_job_and_new_settings_exclude_each_other,                          40);
    PROPERTY(a_job_may_be_held_and_resumed_from_the_host,                        20);
    PROPERTY(a_hold_from_the_host_stands_until_it_is_lifted,                     10);
    PROPERTY(an_aborted_job_reports_where_it_stands_and_another_begins_there,    30);
    PROPERTY(a_job_begins_free_of_the_holds_before_it,                           20);
    PROPERTY(a_closed_limit_ends_jobs_and_lets_none_begin,                       30);
    PROPERTY(what_leaves_the_table_is_refused,                                   40);
    PROPERTY(a_limit_that_was_left_ends_the_job_when_it_closes_again,            10);
    PROPERTY(a_guard_ends_the_job_and_tells_the_place_of_the_edge,               20);
    PROPERTY(two_motors_stop_at_their_own_switches,                              20);
    PROPERTY(a_button_that_stays_closed_counts_once,                              5);
    PROPERTY(a_job_that_starts_elsewhere_is_refused,                             10);
    PROPERTY(an_item_that_is_too_fast_ends_the_job_on_the_path,                  20);
    EXTREMES(loft_machine_push, nonsense_on_the_line_moves_nothing,              50);
    return check_failures();
}
