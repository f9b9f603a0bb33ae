/* ports/linux-gpio/gpio_v1.c -- gpio.h over libgpiod 1.x (tested with 1.6.3)
 * SPDX-License-Identifier: MIT
 *
 * A request of several lines always writes all of them: gpiod_line_set_value on one line of it
 * drives the others low, and reports success. So each request keeps the values of its lines, and
 * always writes all of them.
 */
#include "linux-gpio/gpio.h"

#include <gpiod.h>
#include <stdio.h>
#include <stdlib.h>

#define CONSUMER "loft"

struct gpio_request {
    struct gpiod_line_bulk bulk;
    int value[GPIO_LINES];      /* the current values of the outputs */
};

const char *gpio_library(void) { return gpiod_version_string(); }

gpio_chip *gpio_chip_open(const char *path) { return gpiod_chip_open(path); }

void gpio_chip_close(gpio_chip *chip) { gpiod_chip_close(chip); }

bool gpio_chip_label(gpio_chip *chip, char label[GPIO_TEXT])
{
    snprintf(label, GPIO_TEXT, "%s", gpiod_chip_label(chip));
    return true;
}

unsigned gpio_chip_lines(gpio_chip *chip) { return gpiod_chip_num_lines(chip); }

int gpio_chip_find(gpio_chip *chip, const char *name)
{
    struct gpiod_line *line = gpiod_chip_find_line(chip, name);
    return line ? (int)gpiod_line_offset(line) : -1;
}

bool gpio_chip_owner(gpio_chip *chip, unsigned offset, char owner[GPIO_TEXT])
{
    struct gpiod_line *line = gpiod_chip_get_line(chip, offset);

    if (!line || gpiod_line_update(line) != 0 || !gpiod_line_is_used(line))
        return false;
    const char *name = gpiod_line_consumer(line);
    snprintf(owner, GPIO_TEXT, "%s", name ? name : "?");
    return true;
}

gpio_request *gpio_outputs(gpio_chip *chip, const unsigned offset[], unsigned count, uint32_t high)
{
    gpio_request *r = calloc(1, sizeof *r);
    unsigned number[GPIO_LINES];

    if (!r)
        return NULL;
    for (unsigned i = 0; i < count; i++) {
        number[i] = offset[i];
        r->value[i] = high >> i & 1;
    }
    gpiod_line_bulk_init(&r->bulk);
    if (gpiod_chip_get_lines(chip, number, count, &r->bulk) != 0 ||
        gpiod_line_request_bulk_output(&r->bulk, CONSUMER, r->value) != 0) {
        free(r);
        return NULL;
    }
    return r;
}

bool gpio_set(gpio_request *r, uint32_t which, uint32_t high)
{
    for (unsigned i = 0; i < gpiod_line_bulk_num_lines(&r->bulk); i++)
        if (which >> i & 1)
            r->value[i] = high >> i & 1;
    return gpiod_line_set_value_bulk(&r->bulk, r->value) == 0;
}

gpio_request *gpio_input(gpio_chip *chip, unsigned offset, enum gpio_bias bias,
                         unsigned debounce_us)
{
    const int flags = bias == GPIO_BIAS_UP     ? GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP
                      : bias == GPIO_BIAS_DOWN ? GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN
                                               : 0;
    struct gpiod_line *line = gpiod_chip_get_line(chip, offset);
    gpio_request *r = line ? calloc(1, sizeof *r) : NULL;

    (void)debounce_us;
    if (!r)
        return NULL;
    gpiod_line_bulk_init(&r->bulk);
    gpiod_line_bulk_add(&r->bulk, line);
    if (gpiod_line_request_both_edges_events_flags(line, CONSUMER, flags) != 0) {
        free(r);
        return NULL;
    }
    return r;
}

bool gpio_debounces(void) { return false; }

int gpio_fd(const gpio_request *r) { return gpiod_line_event_get_fd(r->bulk.lines[0]); }

bool gpio_forget_edges(gpio_request *r)
{
    struct gpiod_line_event event[16];
    return gpiod_line_event_read_multiple(r->bulk.lines[0], event,
                                          sizeof event / sizeof event[0]) >= 0;
}

int gpio_get(gpio_request *r) { return gpiod_line_get_value(r->bulk.lines[0]); }

void gpio_release(gpio_request *r)
{
    gpiod_line_release_bulk(&r->bulk);
    free(r);
}
