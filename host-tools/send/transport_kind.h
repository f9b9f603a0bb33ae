/* host-tools/send/transport_kind.h -- what a kind of line is made of
 * SPDX-License-Identifier: MIT
 */
#ifndef LOFT_TRANSPORT_KIND_H
#define LOFT_TRANSPORT_KIND_H

#include <stdbool.h>
#include <stddef.h>

#include "base/host.h"
#include "send/task.h"

typedef struct transport transport;

/* The functions of a kind of line. Reads and writes do not wait, and return the count: 0 if there
 * is nothing to do now, -1 if the line is gone (errno says why). */
typedef struct {
    long (*read)(transport *t, void *bytes, size_t max);
    long (*write)(transport *t, const void *bytes, size_t count);
    void (*close)(transport *t);
} transport_kind;

struct transport {
    const transport_kind *kind;
    int in, out;                /* file descriptors           */
    void *port;                 /* of libserialport           */
    unsigned baud;              /* 0: not applicable */
    char text[128];             /* "/dev/ttyUSB0 at 115200 baud" */
    struct transport_opening *opening;      /* it is being connected; NULL: it is open */
};

/* The kinds. `serial` returns TRANSPORT_OTHER and tells nothing if libserialport does not know the
 * device. */
#define TRANSPORT_OTHER (-1)
int transport_open_serial(transport *t, host *h, const char *name, unsigned baud);
int transport_open_terminal(transport *t, host *h, const char *name, unsigned baud);
int transport_open_unix(transport *t, host *h, const char *name);
int transport_open_tcp(transport *t, host *h, const char *name);
int transport_step_tcp(transport *t, double now, task_wants *w);    /* until it is open */
int transport_open_standard(transport *t, host *h);

/* The serial ports of this computer, one by one; ports that are not USB have an empty `usb`.
 * Returns 0, or an exit code after one message. */
typedef struct {
    const char *name, *description;
    const char *usb;            /* "2341:0043 SERIAL" */
} transport_port;
int transport_ports(host *h, void (*each)(void *context, const transport_port *port),
                    void *context);

/* Take descriptors that are open. Returns 0. */
int transport_take(transport *t, int in, int out, const char *name);

/* Refuse a second owner: returns false after one message. */
bool transport_own(host *h, int fd, const char *name);

/* Tell why `name` cannot be opened, with the remedy for this errno. Returns the exit code. */
int transport_refused(host *h, const char *name, int error);

#endif
