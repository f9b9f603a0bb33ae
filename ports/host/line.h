/* ports/host/line.h -- the machine's end of the line: the master of a pseudo terminal, or a serial
 * port
 * SPDX-License-Identifier: MIT
 *
 * The slave is kept open here as well, so the line outlives every sender. A serial port that
 * vanishes is opened again when it is back.
 */
#ifndef LOFT_HOST_LINE_H
#define LOFT_HOST_LINE_H

#include <poll.h>
#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "config.h"     /* LOFT_NAME */

#define host_line_open      LOFT_NAME(host_line_open)
#define host_line_serial    LOFT_NAME(host_line_serial)
#define host_line_poll      LOFT_NAME(host_line_poll)
#define host_line_close     LOFT_NAME(host_line_close)
#define host_line_read      LOFT_NAME(host_line_read)
#define host_line_write     LOFT_NAME(host_line_write)
#define host_line_drained   LOFT_NAME(host_line_drained)
#define host_line_waits     LOFT_NAME(host_line_waits)
#define host_line_owned     LOFT_NAME(host_line_owned)

struct host_line {
    int master, slave;          /* -1: none; a serial port is a master, -1 while it is away */
    const char *port;           /* a serial port, or NULL */
    unsigned baud;
    const char *link;           /* symbolic link to the slave, or NULL            */
    char name[64];              /* of the slave                                   */
    uint32_t flip;              /* probability that a bit is flipped, times 2^32  */
    uint64_t random;
};

/* Open a raw pseudo terminal. Returns 0 or an exit code after one line on standard error. `noise`:
 * see host.h. */
int  host_line_open(struct host_line *l, const char *link, double noise);
void host_line_close(struct host_line *l);

/* Open a serial port, raw, 8N1, without touching its modem lines. Results as above. The port is
 * locked against a second machine. */
int  host_line_serial(struct host_line *l, const char *port, unsigned baud);

/* Read the waiting bytes, or write as many as fit; never wait. */
size_t host_line_read(struct host_line *l, uint8_t *byte, size_t max);
size_t host_line_write(struct host_line *l, const uint8_t *byte, size_t count);

/* Wait until bytes can be read (or written, if `write`), `ms` have passed (negative: no limit), a
 * signal that `during` allows has come, or one of the `count` others is ready. */
#define HOST_LINE_OTHERS 16
void host_line_poll(struct host_line *l, bool write, int ms, const sigset_t *during,
                    struct pollfd *other, unsigned count);

static inline void host_line_wait(struct host_line *l, bool write, int ms, const sigset_t *during)
{
    host_line_poll(l, write, ms, during, NULL, 0);
}

/* True if the other end has read everything. */
bool host_line_drained(const struct host_line *l);

/* True if there are bytes to read. */
bool host_line_waits(const struct host_line *l);

/* True if a program at the other end has locked the line, as `loft` does. */
bool host_line_owned(const struct host_line *l);

#endif
