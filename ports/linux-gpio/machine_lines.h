/* ports/linux-gpio/machine_lines.h -- the machine's lines, found and taken; outputs as bits
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_MACHINE_LINES_H
#define LOFT_MACHINE_LINES_H

#include "linux-gpio/config_file.h"

#define LINES_CHIPS 4           /* the largest number of chips */

/* The outputs of one chip: one request, so that they change with one system call. */
struct lines_part {
    gpio_request *request;
    unsigned count, offset[LINE_OUTPUTS];
    uint8_t bit[LINE_OUTPUTS];              /* line i of the request is this output */
    uint32_t all;                           /* the sum of these bits                */
};

struct lines {
    gpio_chip *chip[LINES_CHIPS];
    char path[LINES_CHIPS][40];
    unsigned chips;
    struct lines_part part[LINES_CHIPS];    /* part[i] is on chip[i]                */
    uint32_t low;                           /* outputs that are active low          */
    gpio_request *input[LINE_INPUTS];
    bool input_low[LINE_INPUTS];
};

/* Find all wanted lines and take them: outputs inactive, inputs with edges. `look` only prints what
 * they are and who has them. Returns 0, or an exit code after one line on standard error. In either
 * case lines_close releases everything. */
int  lines_open(struct lines *l, const struct settings *s, bool look);

/* Set outputs `which` active (bit set in `on`) or inactive. Returns false if a chip did not
 * obey. */
bool lines_set(struct lines *l, uint32_t which, uint32_t on);

/* Set all outputs inactive and release all lines. The chip decides their state from then on. */
void lines_close(struct lines *l);

#endif
