/* ports/linux-gpio/config_file.c
 * SPDX-License-Identifier: MIT
 */
#include "linux-gpio/config_file.h"

#include <ctype.h>
#include <errno.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sysexits.h>

static const char axes[] = "xyzabc";

// The keys
// --------

enum kind { OUTPUT, INPUT, REAL, WHOLE, TEXT };

/* A key. With `axes` it is written x.KEY, y.KEY ..; a number may also be KEY, for all axes. */
struct row {
    const char *key;
    enum kind   kind;
    bool        axes;
    size_t      at;             /* number of the line, or offset in struct settings */
    double      least, most;    /* TEXT: least is the room                         */
    const char *what;
};

#define AT(field)   offsetof(struct settings, field)
#define ROOM(field) sizeof ((struct settings *)0)->field

static const struct row rows[] = {
    { "step", OUTPUT, true, LINE_STEP, 0, 0, "pulses, low between them" },
    { "step2", OUTPUT, true, LINE_STEP2, 0, 0,
      "those of a second motor of the axis, which has the same dir; needs limit, limit2" },
    { "dir", OUTPUT, true, LINE_DIR, 0, 0, "high towards minus; `low` turns the axis" },
    { "enable", OUTPUT, false, LINE_ENABLE, 0, 0, "on while the program runs" },
    { "enable", OUTPUT, true, LINE_ENABLE + 1, 0, 0, "the same for drivers that have one each" },
    { "pwm", TEXT, false, AT(pwm), ROOM(pwm), 0,
      "folder of a PWM channel, as /sys/class/pwm/pwmchip0/pwm0: laser, speed of the spindle" },
    { "pwm_hz", WHOLE, false, AT(pwm_hz), 50, 100000, "of it" },
    { "spindle", OUTPUT, false, LINE_SPINDLE, 0, 0, "on while the pwm is above 0" },
    { "relay", OUTPUT, false, LINE_RELAY, 0, 0,
      "in place of a pwm: on at any S; a laser is refused, a line cannot give a part of it" },
    { "coolant", OUTPUT, false, LINE_COOLANT, 0, 0, "on from M7 or M8 to M9" },
    { "limit", INPUT, true, LINE_LIMIT, 0, 0,
      "at both ends of the axis: ends the job, on its path; closed, it lets none begin" },
    { "limit2", INPUT, true, LINE_LIMIT2, 0, 0,
      "that of the second motor, as limit is of the first: `square = yes` of `loft home`" },
    { "estop", INPUT, false, LINE_ESTOP, 0, 0,
      "ends the job, on its path; closed, it lets none begin" },
    { "probe", INPUT, false, LINE_PROBE, 0, 0, "ends a `loft probe`" },
    { "hold", INPUT, false, LINE_HOLD, 0, 0, "slows down on the path and stops" },
    { "resume", INPUT, false, LINE_RESUME, 0, 0, "goes on" },
    { "chip", TEXT, false, AT(chip), ROOM(chip), 0,
      "where numbers of lines count, unless CHIP: precedes them" },
    { "port", TEXT, false, AT(port), ROOM(port), 0,
      "serial port of the sender; without one there is a pseudo terminal" },
    { "baud", WHOLE, false, AT(host.baud), 9600, 2000000, "of the port" },
    { "link", TEXT, false, AT(link), ROOM(link), 0, "symbolic link to the pseudo terminal" },
    { "keep", TEXT, false, AT(keep), ROOM(keep), 0,
      "file that keeps what `loft set` sets; it overrules the numbers here" },
    { "pulse_us", WHOLE, false, AT(pulse_us), 1, 1000,
      "length of a step pulse, and between two, at least" },
    { "setup_us", WHOLE, false, AT(setup_us), 0, 10000,
      "from dir to step and from step to dir, at least" },
    { "debounce_us", WHOLE, false, AT(debounce_us), 0, 1000000, "that a switch must be closed" },
    { "lead_ms", WHOLE, false, AT(lead_ms), 4, 1000,
      "computed ahead; a hold begins as much later" },
    { "priority", WHOLE, false, AT(priority), 0, 99, "of SCHED_FIFO; 0: none" },
    { "steps_per_mm", REAL, true, AT(host.steps_per_mm), 0.01, 30000, "gearing" },
    { "max_speed", REAL, true, AT(host.max_speed), 1 / 64.0, 16383, "mm/s" },
    { "max_accel", REAL, true, AT(host.max_accel), 1, 16383, "mm/s^2" },
    { "max_jerk", REAL, true, AT(host.max_jerk), 0, 1e7, "mm/s^3; 0: not limited" },
    { "tick_hz", WHOLE, false, AT(host.tick_hz), 50, 50000, "ticks per second" },
    { "slots", WHOLE, false, AT(host.slots), 1, 1000, "chances to step per tick" },
    { "ramp", WHOLE, false, AT(host.ramp), 1, 32767, "ticks from full pace to standing" },
    { "queue", WHOLE, false, AT(host.queue), 2, 32768, "items that the machine can hold" },
    { "curves", WHOLE, false, AT(host.curves), 0, 4096,
      "that its plan can hold; 0: it does not plan" },
    { "columns", WHOLE, false, AT(host.columns), 0, 1024,
      "curves of a line of a patch; 0: it takes no patches" },
};
#define ROWS (sizeof rows / sizeof rows[0])

struct settings settings_usual(void)
{
    struct settings s = { .host = loft_host_defaults(),
                          .pulse_us = 5,
                          .setup_us = 5,
                          .debounce_us = 5000,
                          .lead_ms = 20,
                          .pwm_hz = 1000,
                          .priority = 80 };

    for (int i = 0; i < LOFT_AXES; i++) {
        s.host.max_speed[i] = 100;
        s.host.max_accel[i] = 500;
    }
    s.host.fast = false;
    s.host.slots = 20;
    s.host.queue = 1024;
    return s;
}

void settings_print(const struct settings *usual)
{
    static const char *const value[] = { "LINE [low]", "LINE [low] [up|down]", "NUMBER", "NUMBER",
                                         "TEXT" };

    for (size_t i = 0; i < ROWS; i++) {
        const struct row *k = &rows[i];
        const char *before = !k->axes ? "" : k->kind == REAL ? "[x.]" : "x.";
        const char *at = (const char *)usual + k->at;
        char key[40];

        snprintf(key, sizeof key, "%s%s = %s", before, k->key, value[k->kind]);
        printf("  %-32s %s", key, k->what);
        if (k->kind == REAL)
            printf(" (%g)", *(const double *)at);
        if (k->kind == WHOLE)
            printf(" (%u)", *(const unsigned *)at);
        printf("\n");
    }
}


// Reading
// -------

static int wrong_value(const char *where, const char *key, const char *value, const char *remedy)
{
    fprintf(stderr, "loft-gpio: %s: %s = %s: %s\n", where, key, value, remedy);
    return EX_DATAERR;
}

/* `LINE` or `CHIP:LINE`. The last colon counts, because labels may contain colons. Then low, up,
 * down in any order. */
static int take_line(struct line_wanted *to, const struct row *k, const char *where,
                     const char *key, const char *value)
{
    char text[2 * GPIO_TEXT], *rest, *word;

    if (!*value)
        return wrong_value(where, key, value, "give LINE or CHIP:LINE");
    memset(to, 0, sizeof *to);
    if (strlen(value) >= sizeof text)
        return wrong_value(where, key, value, "is too long");
    strcpy(text, value);
    word = strtok_r(text, " \t", &rest);
    char *colon = strrchr(word, ':'), *line = colon ? colon + 1 : word;
    if (colon)
        *colon = 0;
    if (!*line || strlen(line) >= GPIO_TEXT || (colon && (!*word || strlen(word) >= GPIO_TEXT)))
        return wrong_value(where, key, value, "give LINE or CHIP:LINE, each at most 63 characters");
    strcpy(to->line, line);
    strcpy(to->chip, colon ? word : "");
    while ((word = strtok_r(NULL, " \t", &rest)) != NULL) {
        if (strcmp(word, "low") == 0)
            to->low = true;
        else if (k->kind == INPUT && strcmp(word, "up") == 0)
            to->bias = GPIO_BIAS_UP;
        else if (k->kind == INPUT && strcmp(word, "down") == 0)
            to->bias = GPIO_BIAS_DOWN;
        else
            return wrong_value(where, key, value,
                               k->kind == INPUT ? "low, and up or down, may follow the line"
                                                : "low may follow the line");
    }
    snprintf(to->key, sizeof to->key, "%s", key);
    return 0;
}

static int take_number(struct settings *s, const struct row *k, int axis, const char *where,
                       const char *key, const char *value)
{
    char *end, remedy[80];
    const double x = strtod(value, &end);

    if (end == value || *end || !(x >= k->least && x <= k->most) ||
        (k->kind == WHOLE && x != (unsigned)x)) {
        snprintf(remedy, sizeof remedy, "give a %snumber from %.10g to %.10g",
                 k->kind == WHOLE ? "whole " : "", k->least, k->most);
        return wrong_value(where, key, value, remedy);
    }
    if (k->kind == WHOLE)
        *(unsigned *)((char *)s + k->at) = (unsigned)x;
    else
        for (int i = 0; i < LOFT_AXES; i++)
            if (axis < 0 || i == axis)
                ((double *)((char *)s + k->at))[i] = x;
    return 0;
}

static int take_value(struct settings *s, const struct row *k, int axis, const char *where,
                      const char *key, const char *value)
{
    switch (k->kind) {
    case OUTPUT:
        return take_line(&s->output[k->at + (axis < 0 ? 0 : (size_t)axis)], k, where, key, value);
    case INPUT:
        return take_line(&s->input[k->at + (axis < 0 ? 0 : (size_t)axis)], k, where, key, value);
    case TEXT:
        if (strlen(value) >= (size_t)k->least)
            return wrong_value(where, key, value, "is too long");
        strcpy((char *)s + k->at, value);
        return 0;
    default: return take_number(s, k, axis, where, key, value);
    }
}

/* The axis in front of the key tells the two kinds of `enable` apart. */
static const struct row *find_key(const char *key, bool axis)
{
    for (size_t i = 0; i < ROWS; i++)
        if (strcmp(rows[i].key, key) == 0 &&
            (rows[i].axes == axis || (rows[i].kind == REAL && !axis)))
            return &rows[i];
    return NULL;
}

/* Copy without the spaces at both ends. Returns false if it is too long. */
static bool trim_text(char *to, size_t room, const char *from, size_t length)
{
    while (length && isspace((unsigned char)*from))
        from++, length--;
    while (length && isspace((unsigned char)from[length - 1]))
        length--;
    if (length >= room)
        return false;
    memcpy(to, from, length);
    to[length] = 0;
    return true;
}

int settings_take(struct settings *s, const char *where, const char *text)
{
    const char *equal = strchr(text, '=');
    char key[40], value[256];
    int axis = -1;

    if (!equal || !trim_text(key, sizeof key, text, (size_t)(equal - text)) ||
        !trim_text(value, sizeof value, equal + 1, strlen(equal + 1))) {
        fprintf(stderr, "loft-gpio: %s: %.60s: give key = value\n", where, text);
        return EX_DATAERR;
    }
    for (int i = 0; i < LOFT_AXES; i++)
        if (key[0] == axes[i] && key[1] == '.')
            axis = i;
    const struct row *k = find_key(axis < 0 ? key : key + 2, axis >= 0);
    if (!k)
        return wrong_value(where, key, value, "unknown key: see --help");
    return take_value(s, k, axis, where, key, value);
}

int settings_read(struct settings *s, const char *path)
{
    FILE *file = fopen(path, "re");
    char text[512], where[300];
    int code = 0;

    if (!file) {
        fprintf(stderr, "loft-gpio: %s: cannot read: %s\n", path, strerror(errno));
        return EX_NOINPUT;
    }
    for (unsigned line = 1; code == 0 && fgets(text, sizeof text, file); line++) {
        snprintf(where, sizeof where, "%.280s:%u", path, line);
        text[strcspn(text, "#\n")] = 0;
        if (text[strspn(text, " \t\r")])
            code = settings_take(s, where, text);
    }
    fclose(file);
    return code;
}
