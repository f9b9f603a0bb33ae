/* ports/linux-gpio/main.c -- loft-gpio: a machine on the GPIO lines of a Linux board
 * SPDX-License-Identifier: MIT
 *
 * ports/host has the machine; this file has its board and the command line.
 */
#include <errno.h>
#include <sched.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sysexits.h>

#include "host/board.h"             /* struct loft_board */
#include "linux-gpio/inputs.h"
#include "linux-gpio/machine_lines.h"
#include "linux-gpio/pulses.h"
#include "linux-gpio/config_file.h"
#include "wire/message.h"           /* LOFT_INPUT_ENDS */

#define SLOT_HZ_MAX 200000
#define ENABLES     (((1u << (1 + LOFT_AXES)) - 1) << LINE_ENABLE)

struct gpio_board {
    struct loft_board board;        /* the first member: a pointer to it is one to the whole */
    const struct settings *s;
    struct lines lines;
    struct inputs inputs;
    struct powers powers;
    struct pulses pulses;
    bool refused;                   /* an output, in this job */
};


// The board
// ---------

static struct gpio_board *gpio_board_of(struct loft_board *b) { return (struct gpio_board *)b; }

/* The thread has the higher priority; the main loop may use the rest of the time. All memory is
 * allocated by now, so later memory need not be locked; an account may be allowed too little. */
static void make_real_time(unsigned priority)
{
    const struct sched_param half = { .sched_priority = (int)(priority + 1) / 2 };

    if (mlockall(MCL_CURRENT) != 0)
        fprintf(stderr,
                "loft-gpio: memory cannot be locked (%s): pulses may come late; run as root, or "
                "with `ulimit -l unlimited`\n",
                strerror(errno));
    if (priority)
        sched_setscheduler(0, SCHED_FIFO, &half);       /* the thread reports a refusal */
}

static int board_begin(struct loft_board *b, uint32_t slot_hz, uint32_t most)
{
    struct gpio_board *g = gpio_board_of(b);

    inputs_init(&g->inputs, &g->lines, g->s->debounce_us);
    lines_set(&g->lines, ENABLES, UINT32_MAX);
    const int code = pulses_begin(&g->pulses, &g->lines, &g->powers, g->s, slot_hz, most);
    if (code == 0)
        make_real_time(g->s->priority);
    return code;
}

static void board_slot(struct loft_board *b, uint64_t number, loft_pins pins)
{
    pulses_put(&gpio_board_of(b)->pulses, number, pins);
}

/* What an output cannot do is refused by its name. */
static bool board_level(struct loft_board *b, int output, uint16_t level, bool moving)
{
    struct gpio_board *g = gpio_board_of(b);
    const bool can       = level == 0 || powers_can(&g->powers, output, moving);

    if (can)
        pulses_level(&g->pulses, output, level, moving);
    else if (!g->refused)
        fprintf(stderr, "loft-gpio: %s: the job is aborted: give pwm, see --help\n",
                g->powers.relay ? "relay: a line cannot give a laser a part of its power"
                                : "there is no output for a spindle or a laser");
    g->refused = !can;
    return can;
}

static void board_gate(struct loft_board *b, uint16_t gated)
{
    pulses_stand(&gpio_board_of(b)->pulses, gated);
}

static void board_give(struct loft_board *b) { pulses_give(&gpio_board_of(b)->pulses); }

static uint64_t board_left(struct loft_board *b) { return pulses_left(&gpio_board_of(b)->pulses); }

static uint16_t board_inputs(struct loft_board *b)
{
    return inputs_closed(&gpio_board_of(b)->inputs);
}

static uint16_t board_raw(struct loft_board *b) { return inputs_raw(&gpio_board_of(b)->inputs); }

static void board_ahead(struct loft_board *b, int32_t steps[LOFT_AXES])
{
    pulses_ahead(&gpio_board_of(b)->pulses, steps);
}

static unsigned board_watch(struct loft_board *b, struct pollfd fd[LOFT_BOARD_WATCHED], int *ms)
{
    return inputs_watch(&gpio_board_of(b)->inputs, fd, ms);
}

static bool board_works(struct loft_board *b)
{
    return pulses_work(&gpio_board_of(b)->pulses) && !gpio_board_of(b)->inputs.lost;
}

static void board_report(struct loft_board *b) { pulses_report(&gpio_board_of(b)->pulses); }

static void board_end(struct loft_board *b)
{
    pulses_end(&gpio_board_of(b)->pulses);
    if (!board_works(b))
        fprintf(stderr,
                "loft-gpio: a chip no longer obeys: is it still there? The position is lost\n");
    lines_set(&gpio_board_of(b)->lines, UINT32_MAX, 0);
}

static struct loft_board board_of(const struct settings *s)
{
    uint16_t squares = 0;

    for (int i = 0; i < LOFT_AXES; i++)
        if (s->output[LINE_STEP2 + i].key[0])
            squares |= LOFT_INPUT_ENDS(i);
    return (struct loft_board){ .lead_ms = s->lead_ms,
                                .settle_ms = s->debounce_us / 1000 + 2,
                                .squares = squares,
                                .gate = board_gate,
                                .outputs = powers_count(s),
                                .level = board_level,
                                .begin = board_begin,
                                .slot = board_slot,
                                .give = board_give,
                                .left = board_left,
                                .inputs = board_inputs,
                                .raw = board_raw,
                                .ahead = board_ahead,
                                .watch = board_watch,
                                .works = board_works,
                                .report = board_report,
                                .end = board_end };
}


// The command line
// ----------------

static void print_help(void)
{
    const struct settings usual = settings_usual();

    printf("usage: loft-gpio [OPTION..] [FILE | KEY=VALUE]..\n"
           "A machine for `loft stream` on the GPIO lines of a Linux board (libgpiod %s).\n\n"
           "  --look          say which lines are meant and who has them, and end\n"
           "  --once          end after one job\n"
           "  --quiet         print only the port, errors and lateness\n"
           "  --record FILE   write every pulse with its slot to FILE (CSV)\n"
           "  --help          this\n\n"
           "FILEs hold lines KEY = VALUE, # begins a comment; what comes later counts. x stands "
           "for x, y or z; LINE is a number or the\n"
           "name of a line, or CHIP:LINE, where CHIP is the label, name (gpiochip0) or path of a "
           "chip.\n\n",
           gpio_library());
    settings_print(&usual);
    printf("\nWhen it ends, by a signal too, it stops on the path, then steps are low, enable is "
           "off, and the lines are given back. What they are\n"
           "from then on, and after a crash, the board decides: give enable a resistor to its off "
           "side.\n");
}

static int usage_error(const char *trouble, const char *what)
{
    fprintf(stderr, "loft-gpio: %s%s: see --help\n", trouble, what);
    return EX_USAGE;
}

/* Returns -1 to continue, or an exit code. */
static int take_arguments(struct settings *s, int argc, char **argv, bool *look)
{
    for (int i = 1; i < argc; i++) {
        const char *a = argv[i];
        int code = 0;

        if (strcmp(a, "--help") == 0) {
            print_help();
            return 0;
        } else if (strcmp(a, "--look") == 0)
            *look = true;
        else if (strcmp(a, "--once") == 0)
            s->host.once = true;
        else if (strcmp(a, "--quiet") == 0)
            s->host.quiet = true;
        else if (strcmp(a, "--record") == 0 && i + 1 < argc)
            s->host.record = argv[++i];
        else if (a[0] == '-')
            return usage_error("what is ", a);
        else
            code = strchr(a, '=') ? settings_take(s, "argument", a) : settings_read(s, a);
        if (code)
            return code;
    }
    return -1;
}

/* A second motor has a switch of its own, and so has the first. */
static int check_second(const struct settings *s, int axis)
{
    const char *step2 = s->output[LINE_STEP2 + axis].key,
               *limit2 = s->input[LINE_LIMIT2 + axis].key;
    const bool limit = s->input[LINE_LIMIT + axis].key[0],
               step = s->output[LINE_STEP + axis].key[0];

    if (step2[0] ? step && limit && limit2[0] : !limit2[0])
        return 0;
    fprintf(stderr,
            "loft-gpio: %s: two motors of an axis are squared by a switch each: give step2, limit "
            "and limit2 of it\n",
            step2[0] ? step2 : limit2);
    return EX_CONFIG;
}

/* Each axis has both lines or none, and there is one axis at least. The slot rate is limited. */
static int check_settings(const struct settings *s)
{
    const bool relay = s->output[LINE_RELAY].key[0], spindle = s->output[LINE_SPINDLE].key[0];

    if ((relay && s->pwm[0]) || (spindle && !s->pwm[0])) {
        fprintf(stderr, relay ? "loft-gpio: relay: it is in place of a pwm: give one of them\n"
                              : "loft-gpio: spindle: it belongs to a pwm: give one, or relay\n");
        return EX_CONFIG;
    }
    const double slot_hz = (double)s->host.tick_hz * s->host.slots;
    bool any = false;

    if (slot_hz > SLOT_HZ_MAX) {
        fprintf(stderr,
                "loft-gpio: tick_hz * slots is %.0f: lines take at most %d slots per second\n",
                slot_hz, SLOT_HZ_MAX);
        return EX_DATAERR;
    }
    for (int i = 0; i < LOFT_AXES; i++) {
        const bool step = s->output[LINE_STEP + i].key[0] != 0,
                   dir = s->output[LINE_DIR + i].key[0] != 0;
        if (step != dir) {
            fprintf(stderr, "loft-gpio: %s has no %s\n",
                    s->output[(step ? LINE_STEP : LINE_DIR) + i].key, step ? "dir" : "step");
            return EX_CONFIG;
        }
        if (check_second(s, i) != 0)
            return EX_CONFIG;
        any |= step;
    }
    return any ? 0 : usage_error("no axis: give a file, or x.step=LINE x.dir=LINE", "");
}

int main(int argc, char **argv)
{
    static struct settings s;
    static struct gpio_board g;
    bool look = false;

    s = settings_usual();
    int code = take_arguments(&s, argc, argv, &look);
    if (code < 0)
        code = check_settings(&s);
    else
        return code;
    if (code == 0)
        code = lines_open(&g.lines, &s, look);
    g.powers.duty = -1;
    if (code == 0 && !look)
        code = powers_open(&g.powers, &s);
    if (code == 0 && !look) {
        g.board = board_of(&s);
        g.s = &s;
        s.host.board = &g.board;
        s.host.port = s.port[0] ? s.port : NULL;
        s.host.link = s.link[0] ? s.link : NULL;
        s.host.kept = s.keep[0] ? s.keep : NULL;
        code = loft_host_simulate(&s.host);
    }
    powers_close(&g.powers);
    lines_close(&g.lines);
    return code;
}
