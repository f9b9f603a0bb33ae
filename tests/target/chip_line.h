/* tests/target/chip_line.h -- the line of an emulated chip to the host, and whose turn it is
 * SPDX-License-Identifier: MIT
 *
 * The chip's time stops while it is the host's turn (avr_gate.h). On a Unix socket it never stops:
 * there the line may be bad, and the gate would not understand it.
 */
#ifndef TARGET_CHIP_LINE_H
#define TARGET_CHIP_LINE_H

#include "avr_gate.h"
#include "host/line.h"          /* the pseudo terminal  */

struct chip_line {
    struct gate gate;
    struct host_line line;
    bool free;                          /* time never stops */
    uint8_t out[65536];                 /* to the host; indices wrap                           */
    uint16_t out_head, out_tail;
    uint32_t given_up;                  /* the limit up to which the host did not send in time */
    uint32_t waits;                     /* how often that happened */
    uint64_t taken;                     /* bytes */
    void (*put)(void *context, uint8_t byte);   /* CALLBACK: a byte for the chip */
    void *context;
};

/* A pseudo terminal, with a symbolic link to it, or a Unix socket on which one host is awaited.
 * Set `put` and `context` before. Returns 0 or an exit code after one line on standard error. */
int  chip_line_open(struct chip_line *l, const char *link, const char *socket);
void chip_line_close(struct chip_line *l);

/* The chip sends a byte. */
void chip_line_out(struct chip_line *l, uint8_t byte);

/* Pass on bytes both ways, and wait while it is the host's turn. `pending`: the chip has something
 * to do before. Call it each millisecond of the chip's time. */
void chip_line_turn(struct chip_line *l, bool pending);

/* The job is over: time for the host to read the last answer. */
void chip_line_leave(struct chip_line *l);

/* A signal has asked the program to end. */
bool chip_line_stopped(void);

#endif
