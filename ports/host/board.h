/* ports/host/board.h -- the lines of a real board behind the machine as a program
 * SPDX-License-Identifier: MIT
 *
 * With a board the program makes slots some ms before they are due, and the board gives them in its
 * own time, in a thread of its own. All functions are called from one thread, in the order begin,
 * any others, end.
 */
#ifndef LOFT_HOST_BOARD_H
#define LOFT_HOST_BOARD_H

#include <poll.h>
#include <stdbool.h>
#include <stdint.h>

#include "machine/step.h"        /* loft_pins */

#define LOFT_BOARD_WATCHED 8

struct loft_board {
    unsigned lead_ms;           /* slots are made so long before they are due */

    /* `slot_hz` slots per second will follow, at most `most` of them ahead. Signals are blocked by
     * now; threads keep it so. Gives 0 or an exit code after one line on standard error. */
    int      (*begin)(struct loft_board *b, uint32_t slot_hz, uint32_t most);

    /* What the pins do in slot number `slot`, the one behind the slot before. */
    void     (*slot)(struct loft_board *b, uint64_t slot, loft_pins pins);

    /* What was put down may be given from now on. */
    void     (*give)(struct loft_board *b);

    /* How many of these slots still are to be given. */
    uint64_t (*left)(struct loft_board *b);

    /* The inputs that are closed for good: a sum of LOFT_INPUT_. */
    uint16_t (*inputs)(struct loft_board *b);

    /* What is to be watched while the program sleeps, and in *ms for how long, if it is less: gives
     * the count. */
    unsigned (*watch)(struct loft_board *b, struct pollfd fd[LOFT_BOARD_WATCHED], int *ms);

    /* Do the lines still obey? After a false the program ends. */
    bool     (*works)(struct loft_board *b);

    /* A job is over and its last slot given: print how it went on standard output, and count
     * anew. */
    void     (*report)(struct loft_board *b);

    /* The program ends, also in mid-job. */
    void     (*end)(struct loft_board *b);
};

#endif
