/* ports/linux-gpio/inputs.c
 * SPDX-License-Identifier: MIT
 */
#include "linux-gpio/inputs.h"

#include <string.h>
#include <time.h>

#include "wire/message.h"       /* LOFT_INPUT_STOP */

static int64_t now_ns(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (int64_t)t.tv_sec * 1000000000 + t.tv_nsec;
}

/* A line that cannot be read counts as closed: a vanished chip must stop the machine. */
static bool is_closed(const struct inputs *in, unsigned i)
{
    const int value = gpio_get(in->lines->input[i]);
    return value < 0 || (value != 0) != in->lines->input_low[i];
}

void inputs_init(struct inputs *in, struct lines *lines, unsigned debounce_us)
{
    memset(in, 0, sizeof *in);
    in->lines = lines;
    in->quiet_us = gpio_debounces() ? 0 : debounce_us;
    for (unsigned i = 0; i < LINE_INPUTS; i++)
        if (lines->input[i])
            in->input[i].closed = is_closed(in, i);
}

/* Edges that the kernel had no room for do no harm, because the line itself is read in the end. */
static void take_edges(struct inputs *in, int64_t now)
{
    for (unsigned i = 0; i < LINE_INPUTS; i++) {
        gpio_request *r = in->lines->input[i];
        if (!r)
            continue;
        struct pollfd fd = { .fd = gpio_fd(r), .events = POLLIN };
        while (poll(&fd, 1, 0) == 1) {
            in->input[i].edge = now;
            if (!gpio_forget_edges(r)) {
                in->lost = true;
                break;
            }
        }
    }
}

/* What input number `i` is to the machine. Of two motors the first has the switch of the low end.
 * */
static uint16_t bits_of(const struct inputs *in, unsigned i)
{
    static const uint16_t button[LINE_LIMIT] = { LOFT_INPUT_STOP, LOFT_INPUT_HOLD,
                                                 LOFT_INPUT_RESUME, LOFT_INPUT_PROBE };

    if (i < LINE_LIMIT)
        return button[i];
    if (i >= LINE_LIMIT2)
        return LOFT_INPUT_HIGH(i - LINE_LIMIT2);
    if (in->lines->input[i - LINE_LIMIT + LINE_LIMIT2])
        return LOFT_INPUT_LOW(i - LINE_LIMIT);
    return LOFT_INPUT_ENDS(i - LINE_LIMIT);
}

uint16_t inputs_raw(struct inputs *in)
{
    uint16_t sum = 0;

    for (unsigned i = 0; i < LINE_INPUTS; i++)
        if (in->lines->input[i] && is_closed(in, i))
            sum = (uint16_t)(sum | bits_of(in, i));
    return sum;
}

uint16_t inputs_closed(struct inputs *in)
{
    const int64_t now = now_ns();
    uint16_t sum = 0;

    take_edges(in, now);
    for (unsigned i = 0; i < LINE_INPUTS; i++) {
        struct input *is = &in->input[i];
        if (is->edge != 0 && now - is->edge >= in->quiet_us * INT64_C(1000)) {
            is->edge = 0;
            is->closed = is_closed(in, i);
        }
        if (is->closed)
            sum = (uint16_t)(sum | bits_of(in, i));
    }
    return sum;
}

unsigned inputs_watch(struct inputs *in, struct pollfd fd[LINE_INPUTS], int *ms)
{
    const int quiet_ms = (int)(in->quiet_us / 1000) + 1;
    unsigned count = 0;

    for (unsigned i = 0; i < LINE_INPUTS; i++)
        if (in->lines->input[i]) {
            fd[count++] = (struct pollfd){ .fd = gpio_fd(in->lines->input[i]), .events = POLLIN };
            if (in->input[i].edge && (*ms < 0 || *ms > quiet_ms))
                *ms = quiet_ms;
        }
    return count;
}
