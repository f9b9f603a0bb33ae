/* host-tools/send/transport.c -- chooses the kind of a line by its name
 * SPDX-License-Identifier: MIT
 */
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/file.h>

#include "base/host.h"
#include "send/transport.h"

/* A simulated machine looks whether byte 0 is locked: then its sender is there, maybe slow. */
bool transport_own(host *h, int fd, const char *name)
{
    struct flock first = { .l_type = F_WRLCK, .l_whence = SEEK_SET, .l_len = 1 };

    if (flock(fd, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) {
        (void)fcntl(fd, F_OFD_SETLK, &first);
        return true;
    }
    host_error(h, EX_UNAVAILABLE, "port.owned", (host_place){ .file = name }, "end that one first",
               "another program talks to it");
    return false;
}

int transport_refused(host *h, const char *name, int error)
{
    switch (error) {
    case EACCES:
    case EPERM:
        return host_error(h, EX_NOPERM, "port.no-permission", (host_place){ .file = name },
                          "join its group (often dialout) and log in again", "%s", strerror(error));
    case EBUSY:
        return host_error(h, EX_UNAVAILABLE, "port.owned", (host_place){ .file = name },
                          "end that one first", "another program talks to it");
    case ECONNREFUSED:
        return host_error(h, EX_UNAVAILABLE, "port.no-server", (host_place){ .file = name },
                          "start the machine's server first", "%s", strerror(error));
    default:
        if (error == ENOENT && strncasecmp(name, "COM", 3) == 0 && strpbrk(name, "0123456789"))
            return host_error(
                h, EX_UNAVAILABLE, "port.missing", (host_place){ .file = name },
                "here they are called /dev/ttyUSB0, /dev/ttyACM0: `loft ports` lists them",
                "no such port");
        return host_error(h, EX_UNAVAILABLE, "port.not-opened", (host_place){ .file = name },
                          "see `loft ports` for the ports there are", "%s", strerror(error));
    }
}

int transport_open(transport *t, host *h, const char *name, unsigned baud)
{
    char real[PATH_MAX];
    int used = 0;
    unsigned port;

    *t = (transport){ .in = -1, .out = -1 };
    if (strcmp(name, "-") == 0)
        return transport_open_standard(t, h);
    if (strncmp(name, "unix:", 5) == 0 || strncmp(name, "tcp:", 4) == 0)
        return transport_open_socket(t, h, name);

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
