/* ports/linux-gpio/config_file.h -- the machine's settings and lines: `key = value`, in files and
 * as arguments
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_CONFIG_FILE_H
#define LOFT_CONFIG_FILE_H

#include "host/host.h"          /* struct loft_host_options */
#include "linux-gpio/gpio.h"    /* enum gpio_bias           */

/* The outputs, in the order of their bits. */
#define LINE_STEP       0
#define LINE_DIR        (LINE_STEP + LOFT_AXES)
#define LINE_ENABLE     (LINE_DIR + LOFT_AXES)          /* one for all, then one for each axis */
#define LINE_SPINDLE    (LINE_ENABLE + 1 + LOFT_AXES)   /* high while output 1 is above 0 */
#define LINE_RELAY      (LINE_SPINDLE + 1)              /* the same, without a pwm */
#define LINE_COOLANT    (LINE_RELAY + 1)                /* output 2 */
#define LINE_STEP2      (LINE_COOLANT + 1)              /* of a second motor, with the same dir */
#define LINE_OUTPUTS    (LINE_STEP2 + LOFT_AXES)

/* The inputs. */
#define LINE_ESTOP      0
#define LINE_HOLD       1
#define LINE_RESUME     2
#define LINE_PROBE      3
#define LINE_LIMIT      4
#define LINE_LIMIT2     (LINE_LIMIT + LOFT_AXES)        /* of a second motor */
#define LINE_INPUTS     (LINE_LIMIT2 + LOFT_AXES)

/* A line as specified. */
struct line_wanted {
    char key[24];               /* "x.step"; "": not wanted                */
    char chip[GPIO_TEXT];       /* label, name or path; "": see `chip`     */
    char line[GPIO_TEXT];       /* name or number                          */
    bool low;                   /* active low                              */
    enum gpio_bias bias;        /* inputs                                  */
};

struct settings {
    struct loft_host_options host;
    char chip[GPIO_TEXT];       /* where numbers count if no chip is named */
    char port[256], link[256];  /* one of them                             */
    char keep[256];             /* the file of `loft set`                  */
    char pwm[256];              /* the folder of a channel of the kernel   */
    struct line_wanted output[LINE_OUTPUTS], input[LINE_INPUTS];
    unsigned pulse_us, setup_us, debounce_us, lead_ms, priority, pwm_hz;
};

struct settings settings_usual(void);

/* Read `key = value`. Returns 0, or EX_DATAERR after one line on standard error that begins with
 * `where`. */
int settings_take(struct settings *s, const char *where, const char *text);

/* Read a file of such lines. `#` begins a comment. */
int settings_read(struct settings *s, const char *path);

/* Print all keys for --help, with these defaults. */
void settings_print(const struct settings *usual);

#endif
