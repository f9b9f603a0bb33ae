/* host-tools/send/transport.c -- chooses the kind of a line by its name
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/host.h"
#include "send/transport.h"

int transport_open(transport *t, host *h, const char *name, unsigned baud)
{
    char real[PATH_MAX];
    int used = 0;
    unsigned port;

    *t = (transport){ .in = -1, .out = -1 };
    if (strcmp(name, "-") == 0)
        return transport_open_standard(t, h);
    if (strncmp(name, "unix:", 5) == 0)
        return transport_open_unix(t, h, name);
    if (strncmp(name, "tcp:", 4) == 0)
        return transport_open_tcp(t, h, name);

    const size_t length = strcspn(name, ":/");
    if (name[length] == ':' && sscanf(name + length, ":%5u%n", &port, &used) == 1 &&
        name[length + (size_t)used] == '\0')
        return host_error(h, EX_UNAVAILABLE, "port.missing", (host_place){ .file = name },
                          HOST_REMEDY("a socket is written tcp:%s", name), "no such port");

    /* libserialport refuses symbolic links; a name without a slash is one of its own names, such as
     * COM3 */
    if (strchr(name, '/') == NULL)
        strncat(strcpy(real, ""), name, sizeof real - 1);
    else if (realpath(name, real) == NULL)
        return transport_refused(h, name, errno);
    const int code = transport_open_serial(t, h, real, baud);
    return code == TRANSPORT_OTHER ? transport_open_terminal(t, h, real, baud) : code;
}

int transport_step(transport *t, double now, task_wants *w)
{
    return t->opening != NULL ? transport_step_tcp(t, now, w) : 0;
}
