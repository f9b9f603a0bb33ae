/* ports/linux-gpio/lines.h -- the machine's lines, found and taken; outputs by bits, whatever chips
 * they are on
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_LINES_H
#define LOFT_LINES_H

#include "linux-gpio/settings.h"

#define LINES_CHIPS 4           /* different ones */

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

/* Find all lines that are wanted and take them: outputs inactive, inputs with edges. `look` only
 * says what they are, and who has them. Gives 0, or an exit code after one line on standard error;
 * either way lines_close gives everything back. */
int  lines_open(struct lines *l, const struct settings *s, bool look);

/* Outputs `which` become active (bit set in `on`) or inactive. Gives false if a chip did not
 * obey. */
bool lines_set(struct lines *l, uint32_t which, uint32_t on);

/* All outputs inactive, all lines given back. What a line is from then on its chip decides. */
void lines_close(struct lines *l);

#endif
