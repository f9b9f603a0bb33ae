/* ports/linux-gpio/gpio_v2.c -- gpio.h over libgpiod 2.x (tested with 2.2.1)
 * SPDX-License-Identifier: MIT
 */
#include "linux-gpio/gpio.h"

#include <errno.h>
#include <gpiod.h>
#include <stdio.h>
#include <stdlib.h>

#define CONSUMER "loft"
#define EDGES    16             /* the number read at once */

struct gpio_request {
    struct gpiod_line_request *request;
    struct gpiod_edge_event_buffer *edges;
    unsigned count, offset[GPIO_LINES];
};

static enum gpiod_line_value value_of(uint32_t bit)
{
    return bit & 1 ? GPIOD_LINE_VALUE_ACTIVE : GPIOD_LINE_VALUE_INACTIVE;
}

const char *gpio_library(void) { return gpiod_api_version(); }

gpio_chip *gpio_chip_open(const char *path) { return gpiod_chip_open(path); }

void gpio_chip_close(gpio_chip *chip) { gpiod_chip_close(chip); }

bool gpio_chip_label(gpio_chip *chip, char label[GPIO_TEXT])
{
    struct gpiod_chip_info *info = gpiod_chip_get_info(chip);

    if (!info)
        return false;
    snprintf(label, GPIO_TEXT, "%s", gpiod_chip_info_get_label(info));
    gpiod_chip_info_free(info);
    return true;
}

unsigned gpio_chip_lines(gpio_chip *chip)
{
    struct gpiod_chip_info *info = gpiod_chip_get_info(chip);
    unsigned count = 0;

    if (info)
        count = (unsigned)gpiod_chip_info_get_num_lines(info);
    gpiod_chip_info_free(info);
    return count;
}

int gpio_chip_find(gpio_chip *chip, const char *name)
{
    return gpiod_chip_get_line_offset_from_name(chip, name);
}

bool gpio_chip_owner(gpio_chip *chip, unsigned offset, char owner[GPIO_TEXT])
{
    struct gpiod_line_info *info = gpiod_chip_get_line_info(chip, offset);

    if (!info)
        return false;
    const bool used = gpiod_line_info_is_used(info);
    const char *name = gpiod_line_info_get_consumer(info);
    snprintf(owner, GPIO_TEXT, "%s", name ? name : "?");
    gpiod_line_info_free(info);
    return used;
}

/* Take the lines with the same settings and, for outputs, these values. */
static struct gpiod_line_request *request(gpio_chip *chip, struct gpiod_line_settings *settings,
                                          const unsigned offset[], unsigned count,
                                          const enum gpiod_line_value value[])
{
    struct gpiod_line_config *lines = gpiod_line_config_new();
    struct gpiod_request_config *named = gpiod_request_config_new();
    struct gpiod_line_request *got = NULL;

    if (lines && named && settings &&
        gpiod_line_config_add_line_settings(lines, offset, count, settings) == 0 &&
        (!value || gpiod_line_config_set_output_values(lines, value, count) == 0)) {
        gpiod_request_config_set_consumer(named, CONSUMER);
        got = gpiod_chip_request_lines(chip, named, lines);
    }
    const int error = errno;
    gpiod_request_config_free(named);
    gpiod_line_config_free(lines);
    gpiod_line_settings_free(settings);
    errno = error;
    return got;
}

static gpio_request *keep(struct gpiod_line_request *got, const unsigned offset[], unsigned count)
{
    gpio_request *r = got ? calloc(1, sizeof *r) : NULL;

    if (!r) {
        if (got)
            gpiod_line_request_release(got);
        return NULL;
    }
    r->request = got;
    r->count = count;
    for (unsigned i = 0; i < count; i++)
        r->offset[i] = offset[i];
    return r;
}

gpio_request *gpio_outputs(gpio_chip *chip, const unsigned offset[], unsigned count, uint32_t high)
{
    struct gpiod_line_settings *settings = gpiod_line_settings_new();
    enum gpiod_line_value value[GPIO_LINES];

    for (unsigned i = 0; i < count; i++)
        value[i] = value_of(high >> i);
    if (settings)
        gpiod_line_settings_set_direction(settings, GPIOD_LINE_DIRECTION_OUTPUT);
    return keep(request(chip, settings, offset, count, value), offset, count);
}

bool gpio_set(gpio_request *r, uint32_t which, uint32_t high)
{
    unsigned offset[GPIO_LINES], count = 0;
    enum gpiod_line_value value[GPIO_LINES];

    for (unsigned i = 0; i < r->count; i++)
        if (which >> i & 1) {
            offset[count] = r->offset[i];
            value[count++] = value_of(high >> i);
        }
    return count == 0 ||
           gpiod_line_request_set_values_subset(r->request, count, offset, value) == 0;
}

gpio_request *gpio_input(gpio_chip *chip, unsigned offset, enum gpio_bias bias,
                         unsigned debounce_us)
{
    struct gpiod_line_settings *settings = gpiod_line_settings_new();

    if (settings) {
        gpiod_line_settings_set_direction(settings, GPIOD_LINE_DIRECTION_INPUT);
        gpiod_line_settings_set_edge_detection(settings, GPIOD_LINE_EDGE_BOTH);
        gpiod_line_settings_set_debounce_period_us(settings, debounce_us);
        if (bias != GPIO_BIAS_KEEP)
            gpiod_line_settings_set_bias(settings, bias == GPIO_BIAS_UP
                                                       ? GPIOD_LINE_BIAS_PULL_UP
                                                       : GPIOD_LINE_BIAS_PULL_DOWN);
    }
    gpio_request *r = keep(request(chip, settings, &offset, 1, NULL), &offset, 1);
    if (r && !(r->edges = gpiod_edge_event_buffer_new(EDGES))) {
        gpio_release(r);
        return NULL;
    }
    return r;
}

bool gpio_debounces(void) { return true; }

int gpio_fd(const gpio_request *r) { return gpiod_line_request_get_fd(r->request); }

bool gpio_forget_edges(gpio_request *r)
{
    return gpiod_line_request_read_edge_events(r->request, r->edges, EDGES) >= 0;
}

int gpio_get(gpio_request *r)
{
    const enum gpiod_line_value value = gpiod_line_request_get_value(r->request, r->offset[0]);
    return value == GPIOD_LINE_VALUE_ERROR ? -1 : value == GPIOD_LINE_VALUE_ACTIVE;
}

void gpio_release(gpio_request *r)
{
    gpiod_edge_event_buffer_free(r->edges);
    gpiod_line_request_release(r->request);
    free(r);
}
