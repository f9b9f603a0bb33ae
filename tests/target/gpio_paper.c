/* tests/target/gpio_paper.c -- a mock of gpio.h: chips named /dev/0 and /dev/1, whose output
 * changes go to the file $LOFT_PAPER
 * SPDX-License-Identifier: MIT
 *
 * With $LOFT_PAPER_SWITCH = N the inputs 5 of /dev/0 (a limit switch of x) and 6 (a probe) close
 * where x has gone N steps towards minus: it counts pulses of line 0, whose direction is line 1.
 * Input 7 is the switch of a second motor, whose steps are line 2; $LOFT_PAPER_SKEW: so many steps
 * it has gone more at the start.
 *
 * It writes lines `us line value`, like `changes` of gpio_guest.c; line 3 of /dev/1 is 103. Main
 * loop and thread call this file without a lock here. So ThreadSanitizer sees the synchronization
 * of the program itself.
 */
#include <fcntl.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "linux-gpio/gpio.h"

struct gpiod_chip {
    unsigned number;
};

struct gpio_request {
    unsigned count, line[GPIO_LINES];
    bool high[GPIO_LINES];
    int fd;
};

static FILE *paper;
static atomic_int x[2];                 /* steps of each motor */
static int woken[3][2];                 /* pipes: an input has changed; 0: it is not there */

static void note(unsigned line, bool high)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    fprintf(paper, "%llu %u %d\n",
            (unsigned long long)t.tv_sec * 1000000 + (unsigned long long)t.tv_nsec / 1000, line,
            high);
}

const char *gpio_library(void) { return "on paper"; }

gpio_chip *gpio_chip_open(const char *path)
{
    gpio_chip *chip = calloc(1, sizeof *chip);

    if (!paper)
        paper = fopen(getenv("LOFT_PAPER"), "w");
    if (!chip || !paper)
        abort();
    chip->number = path[strlen(path) - 1] == '1';
    return chip;
}

void gpio_chip_close(gpio_chip *chip)
{
    free(chip);
    fflush(paper);
}

bool gpio_chip_label(gpio_chip *chip, char label[GPIO_TEXT])
{
    snprintf(label, GPIO_TEXT, "%u", chip->number);
    return true;
}

unsigned gpio_chip_lines(gpio_chip *chip)
{
    (void)chip;
    return 8;
}

int gpio_chip_find(gpio_chip *chip, const char *name)
{
    (void)chip;
    (void)name;
    return -1;
}

bool gpio_chip_owner(gpio_chip *chip, unsigned offset, char owner[GPIO_TEXT])
{
    (void)chip;
    (void)offset;
    owner[0] = 0;
    return false;
}

gpio_request *gpio_outputs(gpio_chip *chip, const unsigned offset[], unsigned count, uint32_t high)
{
    gpio_request *r = calloc(1, sizeof *r);

    if (!r)
        abort();
    r->count = count;
    r->fd = -1;
    for (unsigned i = 0; i < count; i++) {
        r->line[i] = 100 * chip->number + offset[i];
        r->high[i] = high >> i & 1;
        note(r->line[i], r->high[i]);
    }
    return r;
}

static int number_of(const char *name, int usual)
{
    const char *is = getenv(name);
    return is ? atoi(is) : usual;
}

/* That of the first or second motor. */
static bool switch_closed(int motor)
{
    return (motor ? number_of("LOFT_PAPER_SKEW", 0) : 0) - atomic_load(&x[motor]) >=
           number_of("LOFT_PAPER_SWITCH", 1 << 30);
}

static bool line_high(const gpio_request *r, unsigned line)
{
    bool high = false;

    for (unsigned i = 0; i < r->count; i++)
        high = high || (r->line[i] == line && r->high[i]);
    return high;
}

/* The step line of a motor has risen; `minus`: line 1 is high. */
static void count_step(int motor, bool minus)
{
    const bool before = switch_closed(motor);

    atomic_fetch_add(&x[motor], minus ? -1 : 1);
    if (switch_closed(motor) == before)
        return;
    for (int k = motor ? 2 : 0; k < (motor ? 3 : 2); k++)
        if (woken[k][1] && write(woken[k][1], "", 1) != 1)
            abort();
}

bool gpio_set(gpio_request *r, uint32_t which, uint32_t high)
{
    for (unsigned i = 0; i < r->count; i++)
        if (which >> i & 1 && r->high[i] != (high >> i & 1)) {
            r->high[i] = high >> i & 1;
            note(r->line[i], r->high[i]);
            if ((r->line[i] == 0 || r->line[i] == 2) && r->high[i])
                count_step(r->line[i] == 2, line_high(r, 1));
        }
    return true;
}

/* A switch that nobody touches, or one of x. */
gpio_request *gpio_input(gpio_chip *chip, unsigned offset, enum gpio_bias bias,
                         unsigned debounce_us)
{
    gpio_request *r = calloc(1, sizeof *r);

    (void)bias;
    (void)debounce_us;
    if (!r)
        abort();
    r->fd = -1;
    r->line[0] = 100 * chip->number + offset;
    if (r->line[0] >= 5 && r->line[0] <= 7) {
        int *pair = woken[r->line[0] - 5];
        if (pipe2(pair, O_NONBLOCK | O_CLOEXEC) != 0)
            abort();
        r->fd = pair[0];
    }
    return r;
}

bool gpio_debounces(void) { return true; }

int gpio_fd(const gpio_request *r) { return r->fd; }

bool gpio_forget_edges(gpio_request *r)
{
    char edge[16];

    while (r->fd >= 0 && read(r->fd, edge, sizeof edge) > 0) {
    }
    return true;
}

int gpio_get(gpio_request *r) { return r->fd >= 0 && switch_closed(r->line[0] == 7); }

void gpio_release(gpio_request *r) { free(r); }
