/* ports/host/host.c -- the machine behind a pseudo terminal or a serial port, in real or in
 * simulated time
 * SPDX-License-Identifier: MIT
 *
 * One loop does the work of three contexts on a board: bytes in and out, the slots that are due,
 * and a tick after each slot.
 *
 * Real time: the clock makes slots due, in batches of about a millisecond. Simulated time: a batch
 * is due whenever the machine can continue whatever the speed of this computer. That is so while
 * the queue is at least half full, when the machine needs no more items to do what is asked, and
 * when the sender is gone. Then the machine starves as it should. Otherwise time stops. A sender is
 * gone when it no longer has the lock of the line; one that takes none, when nothing has arrived
 * for GONE_MS of real time. A line of line_baud brings its bytes in simulated time. A board: slots
 * are made ahead, and the board gives them in its own time (board.h). In all cases the loop sleeps
 * in poll while nothing moves.
 */
#include "host/host.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <stdio.h>
#include <stdlib.h>
#include <sysexits.h>
#include <time.h>
#include <unistd.h>

#include "host/board.h"         /* struct loft_board    */
#include "host/duration.h"      /* host_duration        */
#include "host/line.h"          /* the pseudo terminal  */
#include "host/memory.h"        /* kept settings        */
#include "host/record.h"        /* the pulses           */
#include "host/world.h"         /* walls and switches   */
#include "machine/machine.h"    /* loft_machine         */
#include "switches.h"           /* loft_switches        */
#include "toolpath/patches.h"   /* loft_patches         */

#define QUIET_MS    300
/* a planning sender on a busy computer may not run for a second */
#define GONE_MS     1500
/* how long `once` waits for a sender that takes no lock to read the report of an ended job */
#define LEAVE_MS    5000
#define STOP_MS     1000        /* how long it waits until the last answer is read */
#define BATCH       20          /* ticks of simulated time between two checks of the line */
#define LINE_KEPT   64          /* bytes that a slow line brings at once after a pause */
#define KNOTS       400         /* of a plan: periods ahead, and 48 */
#define PLANS       16          /* calls of the planner between two looks at the line */
#define SAMPLES_MOST 100        /* ms without a look that count for a guard */
#define LATE_MS     100         /* largest delay in real time; more is dropped */

struct host {
    const struct loft_host_options *o;
    struct loft_board *board;               /* or NULL */
    loft_machine machine;
    loft_machine_config config;
    volatile loft_cell *cell;
    loft_planner planner;
    loft_planner_memory plan;
    loft_patches patches;
    loft_tip *row;                          /* of a line of a patch */
    struct host_line line;
    struct host_record record;
    struct host_world world;                /* without a board                     */
    loft_switches switches;
    uint64_t slot;                          /* the number of slots so far          */
    double credit;                          /* bytes that the line may bring       */
    unsigned halts;                         /* passed                              */
    bool halted;                            /* at the next one                     */
    unsigned jobs, halt_job;                /* begun so far; the one that was halted last */
    bool owned;                             /* the line, when it was last looked at */
    int64_t started;                        /* real time of slot 0, in ns          */
    int64_t heard;                          /* real time of the last bytes         */
    int64_t ended;                          /* end of the last job; 0: none        */
    uint8_t wire[LOFT_FRAME_MAX];
    size_t count, sent;
    uint8_t state;
    uint16_t raw;                           /* board: inputs since the last look, as they bounce */
    int64_t looked;                         /* and when that was, in ms */
    uint16_t gated;                         /* board: what it was told last */
    int64_t moved;                          /* board: when a slot of an ended job was left, in ns */
    bool unreported;                        /* slots went to the board since its last report */
    sigset_t during;                        /* the signal mask while the loop sleeps */
};

static volatile sig_atomic_t stop_wanted, stop_pressed, go_wanted;

static void want_stop(int signal)
{
    (void)signal;
    stop_wanted++;
}

/* Somebody presses the emergency stop, and turns it loose. */
static void press_stop(int signal)
{
    (void)signal;
    stop_pressed = !stop_pressed;
}

static void want_go(int signal)
{
    (void)signal;
    go_wanted = 1;
}

static int64_t now_ns(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (int64_t)t.tv_sec * 1000000000 + t.tv_nsec;
}

/* A positive number as raw Q16.16; 0 if it does not fit, which the machine refuses. */
static int32_t raw_of(double x) { return x > 0 && x < 32768 ? (int32_t)(x * 65536 + 0.5) : 0; }

static uint32_t boot_number(void)
{
    uint32_t number = 0;
    const int fd = open("/dev/urandom", O_RDONLY | O_CLOEXEC);
    if (fd < 0 || read(fd, &number, sizeof number) != (ssize_t)sizeof number)
        number = (uint32_t)now_ns();
    if (fd >= 0)
        close(fd);
    return number;
}


// Start and end
// -------------

static bool give_memory(struct host *h, loft_machine_config *c)
{
    const unsigned moves = h->o->curves;

    c->cell = h->cell = calloc(c->cells + 1u, sizeof *c->cell);
    if (moves == 0)
        return h->cell != NULL;
    h->plan.moves  = calloc(moves, sizeof *h->plan.moves);
    h->plan.knots  = calloc(KNOTS, sizeof *h->plan.knots);
    h->plan.passed = calloc(c->cells + LOFT_PLANNER_AHEAD, sizeof *h->plan.passed);
    h->plan.move_room  = (uint16_t)(moves <= 4096 ? moves : 0);
    h->plan.knot_room = KNOTS;
    if (h->o->columns > 0) {
        h->row = calloc(h->o->columns + 1u, sizeof *h->row);
        h->plan.patches = loft_patches_init(&h->patches, h->row, (uint16_t)h->o->columns);
    }
    c->planner = &h->planner;
    c->plan    = h->plan;
    return h->cell && h->plan.moves && h->plan.knots && h->plan.passed &&
           (h->o->columns == 0 || h->row);
}

static struct host *only;       /* the one whose settings go back to the options */

static void usual_settings(loft_settings *s)
{
    const struct loft_host_options *o = only->o;
    loft_axis_config *axis = only->config.info.axis;

    for (int i = 0; i < LOFT_AXES; i++) {
        axis[i].steps_per_mm = raw_of(o->steps_per_mm[i]);
        axis[i].max_speed    = raw_of(o->max_speed[i]);
        axis[i].max_accel    = raw_of(o->max_accel[i]);
        axis[i].max_jerk     = o->max_jerk[i] > 0 && o->max_jerk[i] < 1e9 ? (uint32_t)o->max_jerk[i]
                                                                      : 0;
    }
    memset(s->wiring, 0, sizeof s->wiring);
    s->wiring[LOFT_WIRING_OBEYED] = 1 << LOFT_WIRING_REVERSED | 1 << LOFT_WIRING_OPENS |
                                    (only->board ? 0
                                                 : 1 << LOFT_WIRING_IDLE | 1 << LOFT_WIRING_SERVO);
}

static int start_machine(struct host *h)
{
    const struct loft_host_options *o = h->o;
    loft_machine_config *c = &h->config;

    only = h;
    c->info.boot = boot_number();
    c->info.tick_hz = (uint16_t)(o->tick_hz <= UINT16_MAX ? o->tick_hz : 0);
    c->info.slots = (uint16_t)(o->slots <= UINT16_MAX ? o->slots : 0);
    usual_settings(&c->settings);
    c->info.outputs = (uint8_t)(h->board ? h->board->outputs : LOFT_MACHINE_OUTPUTS);
    c->settings.get = host_memory_get;
    c->settings.put = host_memory_put;
    c->settings.room = HOST_MEMORY_ROOM;
    c->settings.usual = usual_settings;
    c->senses = true;
    c->squares = (uint16_t)(h->board         ? h->board->squares
                            : o->gantry >= 0 ? LOFT_INPUT_ENDS(o->gantry)
                                             : 0);
    c->ramp = (uint16_t)(o->ramp <= UINT16_MAX ? o->ramp : 0);
    c->cells = (uint16_t)(o->queue <= LOFT_QUEUE_MAX ? o->queue : 0);
    if (!give_memory(h, c) || loft_machine_init(&h->machine, c) != LOFT_OK) {
        fprintf(stderr, "loft: a machine cannot be like this: see the ranges of steps per mm, tick "
                        "rate, slots, ramp, queue and curves\n");
        return EX_USAGE;
    }
    return 0;
}

/* These signals are blocked except in poll, so none comes between the check of what it sets and the
 * sleep. */
static void catch_signals(struct host *h)
{
    struct sigaction act;
    sigset_t block;

    memset(&act, 0, sizeof act);
    act.sa_handler = want_stop;
    sigemptyset(&block);
    sigaddset(&block, SIGINT);
    sigaddset(&block, SIGTERM);
    sigaddset(&block, SIGUSR2);
    sigprocmask(SIG_BLOCK, &block, &h->during);
    sigaction(SIGINT, &act, NULL);
    sigaction(SIGTERM, &act, NULL);
    act.sa_handler = press_stop;
    sigaction(SIGUSR1, &act, NULL);
    act.sa_handler = want_go;
    sigaction(SIGUSR2, &act, NULL);
    act.sa_handler = SIG_IGN;
    sigaction(SIGPIPE, &act, NULL);
    stop_wanted = stop_pressed = go_wanted = 0;
}

static void print_position(struct host *h)
{
    const loft_drive_report r = loft_drive_poll(&h->machine.drive);

    printf("position");
    for (int i = 0; i < LOFT_AXES; i++)
        printf(" %d", (int)r.position[i]);
    printf("\n");
    fflush(stdout);
}

/* `table: the tool is at 12.500 3.000 0.000, 37 steps lost`: what no machine knows by itself. */
static void print_table(const struct host *h)
{
    printf("table: the tool is at");
    for (int i = 0; i < LOFT_AXES; i++)
        printf(" %.4f", h->world.at[i]);
    printf(", %llu steps lost", (unsigned long long)h->world.lost);
    if (h->o->gantry >= 0)
        printf(", skewed by %.4f", host_world_skew(&h->world));
    printf("\n");
    fflush(stdout);
}

/* `output 1: 12.500 s of full power`, since the machine was switched on. */
static void print_outputs(const struct host *h)
{
    char time[HOST_DURATION];

    for (int k = 1; k <= h->config.info.outputs; k++)
        if (h->record.energy[k - 1] > 0)
            printf("output %d: %s of full power\n", k,
                   host_duration(
                       time,
                       h->record.energy[k - 1] / 65535 / ((double)h->o->tick_hz * h->o->slots), 3));
    fflush(stdout);
}

/* `job 0badcafe done: 1234 items, 61234 ticks in 61.301 s, 0 slowed, position 100 -200 0` */
static void print_job(struct host *h, const char *what)
{
    const loft_drive_report r = loft_drive_poll(&h->machine.drive);
    char time[HOST_DURATION];

    printf("job %08lx %s: %lu items, %lu ticks in %s, %lu slowed, ",
           (unsigned long)h->machine.job.id, what, (unsigned long)r.executed,
           (unsigned long)r.ticks, host_duration(time, r.elapsed / (double)h->o->tick_hz, 3),
           (unsigned long)r.slowed);
    print_position(h);
    if (!h->board && host_world_limited(&h->world))
        print_table(h);
    print_outputs(h);
}

/* `job 0badcafe halted at tick 1200`, `job 0badcafe asked to hold at tick 1200` */
static void note_halt(const struct host *h, const char *what)
{
    printf("job %08lx %s at tick %.0f\n", (unsigned long)h->machine.job.id, what,
           h->o->halt[h->halts]);
    fflush(stdout);
}

/* Print a change of the job's state. */
static void note_state(struct host *h)
{
    const uint8_t before = h->state, now = h->machine.drive.state;

    if (now == before)
        return;
    h->state = now;
    if (loft_state_busy(now) && !loft_state_busy(before)) {
        h->jobs++;
        host_record_job(&h->record, h->machine.job.id);
    }
    if (now == LOFT_STATE_DONE || now == LOFT_STATE_ABORTED) {
        h->ended = now_ns();
        if (h->record.file)
            fflush(h->record.file);
        if (h->o->once || !h->o->quiet)
            print_job(h, now == LOFT_STATE_DONE ? "done" : "aborted");
    } else if (!h->o->quiet) {
        if (now == LOFT_STATE_RUNNING && !loft_state_busy(before))
            printf("job %08lx begun\n", (unsigned long)h->machine.job.id);
        if (now == LOFT_STATE_HELD)
            print_job(h, "held");
    }
    fflush(stdout);
}


/* True if all slots of the job have been given. */
static bool slots_given(const struct host *h) { return !h->board || h->board->left(h->board) == 0; }

/* Let the board report after the last slot of a job. */
static void note_end(struct host *h)
{
    if (h->unreported && slots_given(h)) {
        h->unreported = false;
        h->board->report(h->board);
    }
}


// Bytes
// -----

/* A board gives the last slots of a job after it has been told that the job is over. A new sender
 * is heard when the switches at the place of rest are known. */
static bool board_rests(struct host *h)
{
    const int64_t now = now_ns();

    if (!h->board || loft_state_busy(h->machine.drive.state))
        return true;
    if (!slots_given(h))
        h->moved = now;
    return slots_given(h) && now - h->moved >= h->board->settle_ms * 1000000LL;
}

static bool is_limited(const struct host *h)
{
    return h->o->fast && h->o->line_baud > 0 && loft_state_busy(h->machine.drive.state);
}

static size_t bytes_due(const struct host *h, size_t most)
{
    return !is_limited(h)        ? most
           : h->credit < 1           ? 0
           : h->credit < (double)most ? (size_t)h->credit
                                      : most;
}

static void take_bytes(struct host *h)
{
    uint8_t byte[256];

    if (!board_rests(h))
        return;
    const size_t count = host_line_read(&h->line, byte, bytes_due(h, sizeof byte));

    if (count)
        h->heard = now_ns();
    h->credit -= (double)count;
    loft_machine_push(&h->machine, byte, count);
}

/* Returns true while bytes wait for room on the line. */
static bool give_bytes(struct host *h)
{
    for (;;) {
        if (h->sent == h->count) {
            h->sent = 0;
            h->count = loft_machine_poll(&h->machine, h->wire);
            if (h->count == 0)
                return false;
        }
        const size_t written = host_line_write(&h->line, h->wire + h->sent, h->count - h->sent);
        if (written == 0)
            return true;
        h->sent += written;
    }
}


// Time
// ----

static bool machine_moves(const struct host *h) { return !loft_step_done(&h->machine.drive.step); }

/* The closed inputs, as they are wired. */
static uint16_t closed_of(const struct host *h, uint16_t inputs)
{
    const uint8_t *opens = h->config.settings.wiring + LOFT_WIRING_OPENS;

    const unsigned stop = stop_pressed ? LOFT_INPUT_STOP : 0;

    return (uint16_t)((inputs ^ (unsigned)(opens[0] | opens[1] << 8)) | stop);
}

/* A motor that stands does so until the last slot of its job is given; no slot of another job is
 * made before that. Returns false until then. */
static bool gate_board(struct host *h)
{
    const uint16_t gated = loft_machine_gated(&h->machine);
    const bool may       = gated || !h->gated || slots_given(h);

    if (may && gated != h->gated)
        h->board->gate(h->board, gated);
    h->gated = may ? gated : h->gated;
    return may;
}

/* A board wakes the loop when an input changes, so between two looks none has. What is made and not
 * given yet does not count. */
static void sense_board(struct host *h)
{
    const int64_t now = now_ns() / 1000000, passed = now - h->looked;
    int32_t at[LOFT_AXES], ahead[LOFT_AXES];

    for (int64_t ms = passed < SAMPLES_MOST ? passed : SAMPLES_MOST; ms > 0; ms--)
        loft_machine_sample(&h->machine, h->raw);
    h->looked = now;
    h->raw    = closed_of(h, h->board->raw(h->board));
    const bool senses     = loft_machine_senses(&h->machine);
    const uint16_t inputs = senses ? loft_machine_squared(&h->machine, h->raw) : 0;
    (void)gate_board(h);
    if (!senses || !loft_latch_wanted(&h->machine.latch, inputs))
        return;
    loft_step_position(&h->machine.drive.step, at);
    h->board->ahead(h->board, ahead);
    for (int i = 0; i < LOFT_AXES; i++)
        at[i] -= h->config.settings.wiring[LOFT_WIRING_REVERSED] & 1u << i ? -ahead[i] : ahead[i];
    loft_latch_keep(&h->machine.latch, at);
}

/* Between slots. The contacts of a machine that rests have settled. */
static void take_inputs(struct host *h)
{
    if (h->board) {
        sense_board(h);
        loft_machine_inputs(&h->machine, closed_of(h, h->board->inputs(h->board)));
    } else if (!loft_state_busy(h->machine.drive.state)) {
        host_world_settle(&h->world);
        loft_machine_inputs(&h->machine, closed_of(h, h->world.inputs));
    }
}

/* Each ms of slots. */
static void sample_inputs(struct host *h)
{
    const uint16_t closed = closed_of(h, h->world.inputs);

    loft_machine_sample(&h->machine, closed);
    if (loft_switches_steady(&h->switches, closed))
        loft_machine_inputs(&h->machine, closed);
}

static void give_output(struct host *h, int output)
{
    const loft_drive *d  = &h->machine.drive;
    const uint16_t level = loft_drive_output(d, output);

    if (h->board && level != h->record.level[output - 1] &&
        !h->board->level(h->board, output, level, loft_outputs_moving(&d->outputs, output)))
        loft_machine_control(&h->machine, LOFT_ABORT);
    host_record_output(&h->record, h->slot, output, level);
}

static void give_slots(struct host *h, uint64_t count)
{
    const uint32_t slot_hz = (uint32_t)h->o->tick_hz * h->o->slots;
    const uint32_t every   = slot_hz > 1000 ? slot_hz / 1000 : 1;

    for (uint64_t i = 0; i < count; i++) {
        if (!h->board && h->slot % every == 0)
            sample_inputs(h);
        loft_machine_tick(&h->machine);
        for (int k = 1; k <= h->config.info.outputs; k++)
            give_output(h, k);
        loft_pins pins = loft_machine_slot(&h->machine);
        pins.dir ^= h->config.settings.wiring[LOFT_WIRING_REVERSED];
        if (h->board)
            h->board->slot(h->board, h->slot, pins);
        else
            host_world_slot(&h->world, h->slot, pins, loft_machine_gated(&h->machine));
        host_record_slot(&h->record, h->slot++, pins);
        if (!h->board && loft_machine_senses(&h->machine))
            loft_machine_sense(&h->machine, closed_of(h, h->world.inputs));
    }
}

/* The next tick is prepared at the end, as by a board that waits for its slot. */
static void run_slots(struct host *h, uint64_t count)
{
    give_slots(h, count);
    loft_machine_tick(&h->machine);
}

/* Ends a halt if that was asked. True if the machine stands at one: never without a
 * sender. */
static bool is_halted(struct host *h)
{
    const double *at = &h->o->halt[h->halts];
    const bool now = h->halts < h->o->halts && loft_state_busy(h->machine.drive.state) &&
                     h->machine.drive.ticks >= at[0] &&
                     (h->jobs != h->halt_job || at[0] > at[-1]) &&
                     (h->halted || host_line_owned(&h->line));

    if (now && !h->halted)
        note_halt(h, "halted");
    h->halted = now && !(h->halted && go_wanted);
    if (now && !h->halted) {
        h->halt_job = h->jobs;
        h->halts++;
    }
    go_wanted = 0;
    return h->halted;
}

/* True if something is asked that the state does not show yet, or if it needs no more items. */
static bool obeys(const loft_drive *d)
{
    return (d->abort && d->state != LOFT_STATE_STOPPING) ||
           (d->hold ? d->state == LOFT_STATE_RUNNING
                    : d->state == LOFT_STATE_HOLDING || d->state == LOFT_STATE_HELD);
}

static bool sender_is_gone(struct host *h)
{
    const bool owned = host_line_owned(&h->line);

    if (h->owned && !owned)
        h->heard = 0;
    h->owned = owned;
    return !owned && now_ns() - h->heard > GONE_MS * 1000000LL;
}

/* Simulated time: the machine can continue without the line, or the line brings bytes. */
static bool queue_supplied(struct host *h)
{
    const loft_drive *d = &h->machine.drive;
    const unsigned most = d->kind == LOFT_POINTS ? h->config.info.points : h->config.info.queue;

    return d->ended || d->abort || d->hold || obeys(d) ||
           2u * loft_drive_poll(&h->machine.drive).room <= most ||
           (is_limited(h) && host_line_waits(&h->line)) || sender_is_gone(h);
}

static void run_tick(struct host *h)
{
    const double each = h->o->line_baud / 10.0 / h->o->tick_hz;

    give_slots(h, h->o->slots);
    h->credit = fmin(h->credit + each, LINE_KEPT);
}

/* Advance time if that is allowed. Returns the ms that the loop may then sleep; negative: until
 * something arrives. */
static int run_simulated(struct host *h)
{
    const int batch = is_limited(h) ? 1 : BATCH;

    if (!loft_state_busy(h->machine.drive.state))
        return -1;
    if (is_halted(h)) {
        if (!obeys(&h->machine.drive))
            return -1;
        run_tick(h);
        loft_machine_tick(&h->machine);
        if (!obeys(&h->machine.drive))
            note_halt(h, h->machine.drive.abort  ? "asked to stop"
                         : h->machine.drive.hold ? "asked to hold"
                                                 : "asked to go on");
        return 0;
    }
    if (!queue_supplied(h))
        return QUIET_MS / 10;
    for (int n = 0; n < batch && !is_halted(h); n++)
        run_tick(h);
    loft_machine_tick(&h->machine);
    return h->halted || machine_moves(h)                 ? 0
           : loft_state_busy(h->machine.drive.state) ? QUIET_MS
                                                     : -1;
}

/* Stops count as time while a job is under way, so the clock runs on. Otherwise it is reset. */
static int run_real(struct host *h)
{
    const double slot_hz = (double)h->o->tick_hz * h->o->slots;
    const int64_t now = now_ns();

    if (!loft_state_busy(h->machine.drive.state)) {
        h->started = 0;
        return -1;
    }
    if (h->started == 0 ||
        (double)(now - h->started) * 1e-9 * slot_hz > (double)h->slot + LATE_MS * 1e-3 * slot_hz)
        h->started = now - (int64_t)((double)h->slot / slot_hz * 1e9);
    const uint64_t due = (uint64_t)((double)(now - h->started) * 1e-9 * slot_hz);
    if (due > h->slot)
        run_slots(h, due - h->slot);
    return 1;
}

/* A board: keep it supplied for lead_ms. It may be stopped, waiting for the line. Time counts while
 * a job is under way. */
static int run_board(struct host *h)
{
    const uint64_t lead = (uint64_t)h->o->tick_hz * h->o->slots * h->board->lead_ms / 1000;

    if (!loft_state_busy(h->machine.drive.state)) {
        note_end(h);
        return board_rests(h) ? -1 : 1;
    }
    h->unreported = true;
    if (!gate_board(h))
        return 1;
    while (h->board->left(h->board) < lead)
        run_slots(h, h->o->slots);
    h->board->give(h->board);
    return (int)h->board->lead_ms / 4;
}

static int advance_time(struct host *h)
{
    return h->board ? run_board(h) : h->o->fast ? run_simulated(h) : run_real(h);
}

/* True if the program may end: when the host has closed the job and read the last answer, which
 * would be lost with the line, or when the host does not come for it. */
static bool may_finish(struct host *h)
{
    const bool told = h->sent == h->count && host_line_drained(&h->line);
    const int64_t since = (now_ns() - h->ended) / 1000000;

    if (stop_wanted > 1)
        return true;
    if (h->board && !h->board->works(h->board))
        return true;
    if (loft_state_busy(h->machine.drive.state) || !slots_given(h))
        return false;
    if (h->ended == 0 || !(h->o->once || stop_wanted))
        return stop_wanted;
    if (!stop_wanted && host_line_owned(&h->line))
        return h->machine.drive.state == LOFT_STATE_IDLE && told;
    if (h->machine.drive.state == LOFT_STATE_IDLE)
        return told || since > STOP_MS;
    return since > (stop_wanted ? STOP_MS : LEAVE_MS);
}

static void sleep_in_poll(struct host *h, bool waiting, int ms)
{
    struct pollfd other[LOFT_BOARD_WATCHED];
    const unsigned count = h->board ? h->board->watch(h->board, other, &ms) : 0;

    host_line_poll(&h->line, waiting, ms, &h->during, other, count);
}

static void run_loop(struct host *h)
{
    while (!may_finish(h)) {
        take_bytes(h);
        note_state(h);                  /* print a new job before its first pulse */
        if (stop_wanted)
            loft_machine_control(&h->machine, LOFT_ABORT);
        take_inputs(h);
        bool more = loft_machine_plan(&h->machine);
        for (int n = 1; more && !h->board && n < PLANS; n++)
            more = loft_machine_plan(&h->machine);
        /* planning takes no simulated time, but the line is heard; a board must be supplied */
        int ms = more && !h->board ? 0 : advance_time(h);
        if (more)
            ms = 0;
        note_state(h);
        const bool waiting = give_bytes(h);
        if ((stop_wanted || (h->o->once && h->ended)) && (ms < 0 || ms > 20))
            ms = 20;
        sleep_in_poll(h, waiting, ms);
    }
}

static int begin_board(struct host *h)
{
    const uint32_t slot_hz = (uint32_t)h->o->tick_hz * h->o->slots;
    const uint64_t most = (uint64_t)slot_hz * h->board->lead_ms / 1000 + 2 * h->o->slots;

    return h->board->begin(h->board, slot_hz, (uint32_t)most);
}

int loft_host_simulate(const struct loft_host_options *o)
{
    static struct host h;
    int code, end;

    memset(&h, 0, sizeof h);
    h.o = o;
    h.board = o->board;
    h.line.master = h.line.slave = -1;
    host_world_init(&h.world, o);
    code = host_memory_open(o->kept);
    if (code == 0)
        code = start_machine(&h);
    if (code == 0)
        code = host_record_open(&h.record, o);
    if (code == 0)
        code = o->port ? host_line_serial(&h.line, o->port, o->baud)
                       : host_line_open(&h.line, o->link, o->noise);
    if (code == 0) {
        catch_signals(&h);
        code = h.board ? begin_board(&h) : 0;
    }
    if (code == 0) {
        printf("machine: %s\n", h.line.name);
        fflush(stdout);
        run_loop(&h);
        if (h.board) {
            code = h.board->works(h.board) ? 0 : EX_IOERR;
            h.board->end(h.board);
            if (h.unreported)
                h.board->report(h.board);
        }
    }
    if (stop_wanted) {
        printf("stopped at ");
        print_position(&h);
    }
    host_line_close(&h.line);
    host_memory_close();
    end = host_record_close(&h.record, o);
    free((void *)(uintptr_t)h.cell);
    free(h.plan.moves);
    free(h.plan.knots);
    free(h.plan.passed);
    free(h.row);
    return code ? code : end;
}
