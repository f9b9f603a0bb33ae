/* ports/host/board.h -- the lines of a real board, for the machine as a program
 * SPDX-License-Identifier: MIT
 *
 * With a board the program makes slots some ms before they are due. The board gives them in its own
 * time, in a thread of its own. All functions are called from one thread, in the order begin, any
 * others, end.
 */
#ifndef LOFT_HOST_BOARD_H
#define LOFT_HOST_BOARD_H

#include <poll.h>
#include <stdbool.h>
#include <stdint.h>

#include "machine/step.h"        /* loft_pins */

#define LOFT_BOARD_WATCHED 16

struct loft_board {
    unsigned lead_ms;           /* slots are made this long before they are due */
    unsigned settle_ms;         /* after the last one the inputs are known */

    /* `slot_hz` slots per second will follow, at most `most` of them ahead. Signals are already
     * blocked; threads must keep it so. Returns 0 or an exit code after one line on standard
     * error. */
    int      (*begin)(struct loft_board *b, uint32_t slot_hz, uint32_t most);

    /* Outputs that it drives, 0..LOFT_MACHINE_OUTPUTS. */
    int outputs;

    /* The ends of axes with two motors: see loft_machine_config. */
    uint16_t squares;

    /* Motors that stand from now on, in the slots that are made as well: loft_machine_gated. */
    void     (*gate)(struct loft_board *b, uint16_t gated);

    /* From the next slot on output number `output`, from 1, has this level, at most 65535.
     * `moving`: it is off while the machine stands. Returns false if the board cannot do that: then
     * it has printed one line, and the job must end. */
    bool     (*level)(struct loft_board *b, int output, uint16_t level, bool moving);

    /* The pins of slot number `slot`, which follows the last one. */
    void     (*slot)(struct loft_board *b, uint64_t slot, loft_pins pins);

    /* All slots so far may be given from now on. */
    void     (*give)(struct loft_board *b);

    /* The number of slots still to give. */
    uint64_t (*left)(struct loft_board *b);

    /* The closed inputs, debounced: a sum of LOFT_INPUT_. */
    uint16_t (*inputs)(struct loft_board *b);

    /* The closed inputs as they are in this moment, while they bounce. */
    uint16_t (*raw)(struct loft_board *b);

    /* The steps of each axis that are made and not given yet. */
    void     (*ahead)(struct loft_board *b, int32_t steps[LOFT_AXES]);

    /* The files to watch while the program sleeps, and in *ms the time to sleep, if it is less.
     * Returns their number. */
    unsigned (*watch)(struct loft_board *b, struct pollfd fd[LOFT_BOARD_WATCHED], int *ms);

    /* False if the lines do not obey any more: the program ends. */
    bool     (*works)(struct loft_board *b);

    /* A job is over and its last slot is given: print its statistics on standard output, and reset
     * them. */
    void     (*report)(struct loft_board *b);

    /* The program ends, maybe in mid-job. */
    void     (*end)(struct loft_board *b);
};

#endif
