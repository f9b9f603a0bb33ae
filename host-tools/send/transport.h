/* host-tools/send/transport.h -- bytes to and from a machine: serial ports, ptys, sockets, standard
 * input and output
 * SPDX-License-Identifier: MIT
 *
 *     /dev/ttyUSB0  COM3  ..      a serial port, through libserialport; a pty or another terminal
 *                                 through termios
 *     unix:PATH   tcp:HOST:PORT   a socket
 *     -                           standard input and output
 *
 * The next read or write notices that a port has vanished. After that only transport_close may be
 * called.
 */
#ifndef LOFT_TRANSPORT_H
#define LOFT_TRANSPORT_H

#include "send/task.h"
#include "send/transport_kind.h"  /* transport */

/* Open by name. Returns 0, or an exit code after one message. A socket to another computer is being
 * connected then: transport_step gives TASK_GOES, 0 when it is open, or an exit code after one
 * message. Close it in any case but the first. */
int transport_open(transport *t, host *h, const char *name, unsigned baud);
int transport_step(transport *t, double now, task_wants *w);

#endif
